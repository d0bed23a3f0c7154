//! Japan Road Association, Specifications for highway bridges, part V: seat length, and that of a skewed deck which turns.

use super::demand::{Case, Code, Demand, Input};
use crate::language::Text;
use crate::scene::JapaneseGround;

/// The code.
pub(super) struct Jra;

/// `α_E` \[degrees\].
pub(super) const ROTATION_DEG: f64 = 5.0;

/// The least seat length `S_EM` of a span \[m\].
pub(super) fn least(span: f64) -> f64 {
    0.7 + 0.005 * span
}

/// `S_Eθ` of a deck of length `L_θ` \[m\] and angle θ between axis and support line that turns by `α_E` \[rad\].
pub(super) fn of_rotation(length: f64, angle: f64, rotation: f64) -> f64 {
    0.5 * length * (angle.sin() - (angle - rotation).sin())
}

/// Seismic ground strain `ε_G`.
pub(super) const fn ground_strain(ground: JapaneseGround) -> f64 {
    match ground {
        JapaneseGround::First => 0.0025,
        JapaneseGround::Second => 0.003_75,
        JapaneseGround::Third => 0.005,
    }
}

impl Code for Jra {
    fn demands(&self, case: &Case<'_>) -> Vec<Demand> {
        let codes = case.codes;
        let span = case.deck_length("l");
        let distance = Input::given_or("L", "m", codes.support_distance, case.prism.length);
        let strain = ground_strain(codes.japanese_ground.unwrap_or_default());
        let strain = Input::given_or("ε_G", "", codes.japanese_ground.map(|_| strain), strain);
        let relative = Input::of_run("u_R", "m", case.seat.used().max(0.0));
        let [provided, used] = [case.seat.ledge.placed(), case.seat.used()];
        let mut all = vec![Demand {
            rule: Text::new("code-jra"),
            edition: Text::new("code-edition-jra"),
            formula: "S_E = u_R + ε_G L ≥ S_EM = 0.7 + 0.005 l",
            confirmed: true,
            note: Text::new("code-note-jra"),
            inputs: vec![span, distance, strain, relative],
            required: (relative.value + strain.value * distance.value).max(least(span.value)),
            provided,
            used,
        }];
        if case.prism.shear() != 0.0 {
            let length = case.deck_length("L_θ");
            let angle = Input::of_scene("θ", "°", 90.0 - case.skew_deg());
            let rotation = Input::given_or("α_E", "°", codes.rotation_deg, ROTATION_DEG);
            all.push(Demand {
                rule: Text::new("code-jra-rotation"),
                edition: Text::new("code-edition-jra-rotation"),
                formula: "S_Eθ = (L_θ/2)[sin θ − sin(θ − α_E)]",
                confirmed: true,
                note: Text::new("code-note-jra-rotation"),
                inputs: vec![length, angle, rotation],
                required: of_rotation(length.value, angle.value.to_radians(), rotation.value.to_radians()),
                provided,
                used,
            });
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_metres_at_sixty_degrees_are_the_worked_example_s() {
        assert!((least(30.0) - 0.85).abs() < 1e-15, "S_EM");
        for (rotation, needed) in [(5f64, 0.7031), (2.5, 0.3395)] {
            let got = of_rotation(30.0, 60f64.to_radians(), rotation.to_radians());
            assert!((got - needed).abs() < 5e-5, "α_E = {rotation}°: {got}, not {needed}");
        }
    }
}
