//! How the window looks: colours, drawn signs, sizes.

pub(in crate::app) mod icons;
pub(in crate::app) mod letters;
pub(in crate::app) mod size;
pub(in crate::app) mod theme;
