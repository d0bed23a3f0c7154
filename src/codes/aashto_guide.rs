//! AASHTO Guide Specifications for LRFD Seismic Bridge Design, support length in seismic design category D.

use super::demand::{Case, Code, Demand, Input};
use crate::language::Text;

/// The code.
pub(super) struct AashtoGuide;

/// An inch \[m\].
pub(super) const INCH: f64 = 0.0254;

/// N \[in\] of the opening `Δ_eq` \[in\] and the skew S \[degrees\], without its minimum.
pub(super) fn support_length_in(opening_in: f64, skew_deg: f64) -> f64 {
    (4.0 + 1.65 * opening_in) * (1.0 + 0.000_25 * skew_deg.powi(2))
}

/// The least N \[in\].
const LEAST_IN: f64 = 24.0;

impl Code for AashtoGuide {
    fn demands(&self, case: &Case<'_>) -> Vec<Demand> {
        let opening = Input::of_run("Δ_eq", "m", case.seat.used().max(0.0));
        let skew = Input::of_scene("S", "°", case.skew_deg());
        vec![Demand {
            rule: Text::new("code-aashto-guide"),
            edition: Text::new("code-edition-aashto-guide"),
            formula: "N = (4 + 1.65 Δ_eq)(1 + 0.00025 S²) ≥ 24 in",
            confirmed: false,
            note: Text::new("code-note-aashto-guide"),
            inputs: vec![opening, skew],
            required: INCH * support_length_in(opening.value / INCH, skew.value).max(LEAST_IN),
            provided: case.seat.ledge.placed(),
            used: case.seat.used(),
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn openings_of_150_and_250_mm_need_the_minimum_and_630_mm() {
        for (opening, needed) in [(0.15, 427.6), (0.25, 629.8)] {
            let millimetres = 1e3 * INCH * support_length_in(opening / INCH, 30.0);
            assert!((millimetres - needed).abs() < 0.05, "{opening} m: {millimetres} mm, not {needed}");
        }
        assert!((1e3 * INCH * LEAST_IN - 609.6).abs() < 1e-9, "the minimum");
    }
}
