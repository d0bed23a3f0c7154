//! Numbers in force of what a scene gives by a few keys and the program fills in: in words, for `girderbench check` and the report.

mod bearings;
mod motion;
mod pier;
mod soil;

pub use bearings::deck_bearings;
pub use motion::motion;
pub use pier::piers;
pub use soil::soil;
