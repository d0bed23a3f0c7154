//! Caltrans Seismic Design Criteria: seat width at abutments and hinges.

use super::aashto_guide::INCH;
use super::demand::{Case, Code, Demand, Input};
use crate::language::Text;
use crate::scene::Support;
use crate::sim::seats::seat_on::SeatOn;

/// The code.
pub(super) struct Caltrans;

/// Allowance added to the movements \[in\].
const ADDED_IN: f64 = 4.0;

/// The least seat width \[in\].
pub(super) const fn least_in(support: Support) -> f64 {
    match support {
        Support::Abutment => 30.0,
        Support::Hinge => 24.0,
    }
}

/// N of the sum of all movements \[m\].
pub(super) fn seat_width(movements: f64, support: Support) -> f64 {
    (movements + ADDED_IN * INCH).max(least_in(support) * INCH)
}

impl Code for Caltrans {
    fn demands(&self, case: &Case<'_>) -> Vec<Demand> {
        let long_term = Input::given_or("Δ_p/s + Δ_cr+sh", "m", case.codes.long_term, 0.0);
        let temperature = Input::given_or("Δ_temp", "m", case.codes.temperature, 0.0);
        let opening = Input::of_run("Δ_eq", "m", case.seat.used().max(0.0));
        let support = case.codes.caltrans_support.unwrap_or_default();
        let given = case.codes.caltrans_support.map(|support| least_in(support) * INCH);
        let least = Input::given_or("least N", "m", given, least_in(support) * INCH);
        vec![Demand {
            rule: Text::new("code-caltrans"),
            edition: Text::new("code-edition-caltrans"),
            formula: "N = Δ_p/s + Δ_cr+sh + Δ_temp + Δ_eq + 4 in, ≥ 30 in at abutments, ≥ 24 in at hinges",
            confirmed: false,
            note: match case.seat.ledge.on {
                SeatOn::Ground => Text::new("code-note-caltrans"),
                SeatOn::Pier(_) | SeatOn::Moved(_) => Text::new("code-note-caltrans-moves"),
            },
            inputs: vec![long_term, temperature, opening, least],
            required: seat_width(long_term.value + temperature.value + opening.value, support),
            provided: case.seat.ledge.placed(),
            used: case.seat.used(),
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_movements_need_the_minimum_and_large_ones_four_inches_more() {
        for (support, least) in [(Support::Abutment, 0.762), (Support::Hinge, 0.6096)] {
            assert!((seat_width(0.25, support) - least).abs() < 1e-12, "{support:?}");
            assert!((seat_width(0.8, support) - 0.9016).abs() < 1e-12, "{support:?}: 800 + 101.6 mm");
        }
    }
}
