//! Every key of the scene file: what may stand under it and what it is when nothing does.
//!
//! [`validate`](super::validate) checks by these rules and the window shows them, so that the two cannot differ; a test
//! holds them against the keys that the reader knows and against `docs/scene-format.md`.

mod index;
mod key;
mod range;
mod slot;
mod table;
mod told;

pub use super::abutment::ABUTMENT;
pub use super::backfill::BACKFILL;
pub use super::bearing::{BEARING, BEARINGS};
pub use super::codes::CODES;
pub use super::contact::{CONTACT, PAIR};
pub use super::deck_bearings::DECK_BEARINGS;
pub use super::device::{BUMPER, DAMPER, ENDS, RESTRAINER, STOPPER};
pub use super::elastic::{ELASTIC, RAYLEIGH};
pub use super::girder::{GIRDER, INITIAL, PUSH, SEAT};
pub use super::ground::GROUND;
pub use super::limits::LIMITS;
pub use super::model::{IMPACT, MODEL};
pub use super::motion::{MOTION, SINE};
pub use super::pier::PIER;
pub use super::processing::PROCESSING;
pub use super::record::{COMPONENT, RECORD};
pub use super::settings::{OVERLAYS, PLOT, SOLVER, VIEW};
pub use super::sweep::SWEEP;
pub use super::synthetic::SYNTHETIC;
pub use super::top::TOP;
pub use super::wave::WAVE;
pub(in crate::scene) use index::as_of_motion;
pub use index::{TABLES, Table, find, of_place};
pub use key::{Fallback, Key};
pub use range::Range;
pub use slot::{Editable, Slot, Word};
pub(in crate::scene) use table::{Keyed, Stands, Stated, table, words};
pub use told::word_told;
