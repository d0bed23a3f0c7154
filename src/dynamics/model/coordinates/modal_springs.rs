//! Springs and dashpots of the elastic modes of a girder, in plan and in space.

use crate::dynamics::model::rate_bounds::ModalRates;

/// Damping of the elastic modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ModalDamping {
    /// One ratio ζ for every mode.
    Ratio(f64),
    /// `α + β ω²` on the rates: ratio `α/2ω + β ω/2`.
    Rayleigh {
        /// α \[1/s\].
        mass: f64,
        /// β \[s\].
        stiffness: f64,
    },
}

impl ModalDamping {
    /// Dashpot of a mode per unit modal mass, `2 ζ ω` \[1/s\].
    pub fn dashpot(self, omega: f64) -> f64 {
        match self {
            Self::Ratio(ratio) => 2.0 * ratio * omega,
            Self::Rayleigh { mass, stiffness } => mass + stiffness * omega * omega,
        }
    }
}

/// Spring and dashpot of every mode, each of unit modal mass.
#[derive(Clone, Debug)]
pub(in crate::dynamics) struct ModalSprings(
    /// `ω_j²` \[1/s²\], and the dashpot `2 ζ ω_j` \[1/s\].
    Vec<[f64; 2]>,
);

impl ModalSprings {
    /// Of modes of these circular frequencies \[rad/s\].
    pub(super) fn of(frequencies: impl Iterator<Item = f64>, damping: ModalDamping) -> Self {
        Self(frequencies.map(|omega| [omega * omega, damping.dashpot(omega)]).collect())
    }

    /// Number of modes.
    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// Stiffness \[1/s²\] and dashpot \[1/s\] of each.
    pub(super) fn iter(&self) -> std::slice::Iter<'_, [f64; 2]> {
        self.0.iter()
    }

    /// The largest rates among them.
    pub(in crate::dynamics) fn rates(&self) -> ModalRates {
        let of = |&[k, c]: &[f64; 2]| ModalRates { change: k.sqrt().max(c), decay: c };
        self.iter().map(of).fold(ModalRates::default(), ModalRates::max)
    }

    /// Strain energy by the modal coordinates \[J\].
    pub(super) fn strain(&self, q: &[f64]) -> f64 {
        self.iter().zip(q).map(|([k, _], q)| 0.5 * k * q * q).sum()
    }

    /// Power lost by their rates \[W\].
    pub(super) fn loss(&self, rates: &[f64]) -> f64 {
        self.iter().zip(rates).map(|([_, c], v)| c * v * v).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_rates_are_those_of_the_highest_mode_or_of_the_most_damped() {
        let of = |damping| ModalSprings::of([10.0, 1000.0].into_iter(), damping).rates();
        assert_eq!(of(ModalDamping::Ratio(0.02)), ModalRates { change: 1000.0, decay: 40.0 }, "swings");
        let heavy = of(ModalDamping::Rayleigh { mass: 0.0, stiffness: 0.5 });
        assert_eq!(heavy, ModalRates { change: 5e5, decay: 5e5 }, "overdamped: c = β ω² is above ω");
    }
}
