//! Numbers in force of what a scene gives by a few keys and the program fills in: in words, for `girderbench check` and the report.

mod pier;
mod soil;

pub use pier::piers;
pub use soil::soil;
