//! Work against error: every method on every problem, each error against an answer that another method computed.
//!
//! A [`Problem`] names a scene and where its [`mod@reference`] answer comes from; a [`method::Method`] answers a scene at a
//! setting (a tolerance or a step). [`study`] measures the time of each answer and, apart from that, its error; a
//! [`Study`] then writes itself as a table, as plots and as a page.

pub mod answer;
mod line;
pub mod method;
mod others;
mod page;
mod picture;
pub mod problem;
mod record;
pub mod reference;
mod scenes;
mod study;
mod table;

pub use answer::{Answer, Errors, Instants};
pub use problem::Problem;
pub use study::{Options, Row, Study, study};
