//! The next impact of a pair: gaps with derivatives and bounds, advancement to their first zero.

pub(in crate::dynamics::impact2d) mod gap_derivatives;
pub(in crate::dynamics::impact2d) mod motion_limits;
pub(in crate::dynamics::impact2d) mod next_impact;
pub(in crate::dynamics::impact2d) mod planar_gap;
