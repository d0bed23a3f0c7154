//! How the window looks: colours and drawn signs.

pub(in crate::app) mod icons;
pub(in crate::app) mod theme;
