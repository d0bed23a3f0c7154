//! Time of the answer: the answer played back, the playing clock, the row of buttons, the timeline and its axis.

pub(in crate::app) mod clock;
pub(in crate::app) mod playback;
pub(in crate::app) mod replay;
pub(in crate::app) mod time_axis;
pub(in crate::app) mod timeline;
pub(in crate::app) mod transport;
