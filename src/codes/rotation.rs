//! Whether a skewed deck can turn out between its abutments, and the rotation at which a corner comes off its seat.

use crate::geometry::{End, Prism};
use crate::language::said;

/// The condition (6) of the paper, `a₀ sin 2β/(2 b₀) ≥ 1`; JRA part V (2002), (16.5.1), `(sin 2θ)/2 > b/L`, is the same with > for ≥.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotationCondition {
    /// Its left side.
    pub number: f64,
}

impl RotationCondition {
    /// Of a girder.
    pub fn of(prism: &Prism) -> Self {
        // A straight girder's is 0 but for the rounding of sin π.
        Self { number: if prism.shear() == 0.0 { 0.0 } else { prism.rotation_number().abs() } }
    }

    /// Whether the deck can turn out.
    pub fn can_turn(self) -> bool {
        self.number >= 1.0
    }

    /// The condition with its sources, its number and what follows.
    pub fn words(self) -> String {
        let number = format!("{:.3}", self.number);
        if self.can_turn() {
            said!("condition-can-turn", "number" => number)
        } else {
            said!("condition-cannot-turn", "number" => number)
        }
    }
}

/// The least rotation about G, either way, at which nothing remains of a seat of `placed` \[m\] square to the edge: at the two
/// corners of an end, in the order of [`Prism::end_corners`], and in its middle \[rad\]. `None` where no rotation takes as much.
///
/// `(R(α) − 1)p · ν = −placed` for the point p of the deck: with ψ the angle from ν to p, `cos(ψ + α) = cos ψ − placed/|p|`.
pub fn rotation_to_zero(prism: &Prism, end: End, placed: f64) -> [Option<f64>; 3] {
    let [one, other] = Prism::end_corners(end).map(|corner| prism.plan_corners()[corner]);
    let normal = ((other - one) / prism.end_length()).perp() * -end.sign();
    [one, other, 0.5 * (one + other)].map(|point| {
        let psi = normal.angle_to(point);
        let cosine = psi.cos() - placed / point.length();
        (cosine >= -1.0).then(|| cosine.acos()).map(|to| (to - psi).abs().min((to + psi).abs()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn deck(skew_deg: f64) -> Prism {
        Prism { length: 30.0, width: 10.0, thickness: 1.5, skew: skew_deg.to_radians() }
    }

    #[test]
    fn the_condition_is_the_worked_example_s() {
        for (skew, number, turns) in [(60.0, 1.299, true), (75.0, 0.750, false), (120.0, 1.299, true)] {
            let condition = RotationCondition::of(&deck(skew));
            assert!((condition.number - number).abs() < 5e-4, "{skew}°: {condition:?}");
            assert_eq!(condition.can_turn(), turns, "{skew}°");
        }
        assert_eq!(
            RotationCondition::of(&Prism { skew: std::f64::consts::FRAC_PI_2, ..deck(60.0) }).number,
            0.0,
            "straight"
        );
    }

    #[test]
    fn corners_and_middle_come_off_at_the_worked_example_s_rotations() {
        let placed = 0.85 * 60f64.to_radians().sin();
        for (end, [acute, obtuse]) in [(End::Plus, [1, 0]), (End::Minus, [0, 1])] {
            let at = rotation_to_zero(&deck(60.0), end, placed).map(|angle| angle.expect("it comes off").to_degrees());
            for (got, wanted) in [(at[acute], 3.097), (at[2], 5.219), (at[obtuse], 13.183)] {
                assert!((got - wanted).abs() < 5e-4, "{end:?}: {got}°, not {wanted}°");
            }
        }
        assert_eq!(rotation_to_zero(&deck(60.0), End::Plus, 40.0), [None; 3], "longer than the deck can lose");
    }
}
