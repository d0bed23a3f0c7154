//! Size of everything in the window, as a share of the usual one.

/// Sizes to choose from.
pub(in crate::app) const SCALES: [(&str, f32); 5] =
    [("80 %", 0.8), ("100 %", 1.0), ("125 %", 1.25), ("150 %", 1.5), ("200 %", 2.0)];

/// Size of everything in a lecture hall.
pub(in crate::app) const LECTURE: f32 = 1.5;
