//! AASHTO LRFD Bridge Design Specifications, 4.7.4.4: empirical support length.

use super::demand::{Case, Code, Demand, Input};
use crate::language::Text;

/// The code.
pub(super) struct AashtoLrfd;

/// Percentage of N of seismic zones 2, 3 and 4.
pub(super) const PERCENT: f64 = 150.0;

/// N \[mm\] of L and H \[mm\] and the skew S \[degrees\], before the percentage of the seismic zone.
pub(super) fn support_length_mm(length_mm: f64, height_mm: f64, skew_deg: f64) -> f64 {
    (200.0 + 0.0017 * length_mm + 0.0067 * height_mm) * (1.0 + 0.000_125 * skew_deg.powi(2))
}

impl Code for AashtoLrfd {
    fn demands(&self, case: &Case<'_>) -> Vec<Demand> {
        let length = case.deck_length("L");
        let height = case.column_height("H");
        let percent = Input::given_or("zone", "%", case.codes.zone_percent, PERCENT);
        let skew = Input::of_scene("S", "°", case.skew_deg());
        let base = 1e-3 * support_length_mm(1e3 * length.value, 1e3 * height.value, skew.value);
        vec![Demand {
            rule: Text::new("code-aashto-lrfd"),
            edition: Text::new("code-edition-aashto-lrfd"),
            formula: "N = (200 + 0.0017 L + 0.0067 H)(1 + 0.000125 S²) mm, times the percentage of the zone",
            confirmed: false,
            note: Text::new("code-note-aashto-lrfd"),
            inputs: vec![length, height, skew, percent],
            required: base * percent.value / 100.0,
            provided: case.seat.ledge.placed(),
            used: case.seat.used(),
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_metric_form_is_the_worked_example_s() {
        // 30 m, skew 30°: without columns, and with columns of 10 m.
        for (height, n, of_zone) in [(0.0, 279.24, 418.86), (1e4, 353.78, 530.66)] {
            let length = support_length_mm(3e4, height, 30.0);
            assert!((length - n).abs() < 0.005 && (1.5 * length - of_zone).abs() < 0.005, "{length} mm, not {n}");
        }
    }

    #[test]
    fn the_inch_form_differs_by_its_rounded_numbers() {
        let feet: f64 = 30.0 / 0.3048;
        let inches = (8.0 + 0.02 * feet) * (1.0 + 0.000_125 * 900.0);
        assert!((25.4 * inches - 281.69).abs() < 0.005, "{} mm", 25.4 * inches);
    }
}
