//! Motion of a support whose ground moves otherwise than the ground of reference: by a motion of its own, later, stronger or
//! weaker (`docs/physics.md#supports-that-move`).

use std::sync::Arc;

use glam::DVec3;

use super::responses::responses;
use super::{Ground, LinearPiece};

/// Velocity and displacement of a ground that was at rest until t = 0, in closed form.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundPath {
    ground: Ground,
    /// Velocity \[m/s\] and displacement \[m\] at the samples of a record.
    at_samples: Vec<[DVec3; 2]>,
}

impl GroundPath {
    /// Of this ground.
    pub fn of(ground: Ground) -> Self {
        let (mut at_samples, mut now, mut number) = (Vec::new(), [DVec3::ZERO; 2], 0);
        if let Ground::Record { .. } = ground {
            loop {
                at_samples.push(now);
                let piece = ground.piece(number);
                if piece.until.is_infinite() {
                    break;
                }
                now = piece.carried(now, piece.from, piece.until - piece.from);
                number += 1;
            }
        }
        Self { ground, at_samples }
    }

    /// Velocity \[m/s\] and displacement \[m\] at `t`; none before 0.
    pub fn at(&self, t: f64) -> [DVec3; 2] {
        if t <= 0.0 {
            return [DVec3::ZERO; 2];
        }
        match &self.ground {
            Ground::Still => [DVec3::ZERO; 2],
            Ground::Sine { amplitude, quadrature, omega, phase } => {
                // sin(ω t + φ) = sin φ cos ω t + cos φ sin ω t, of which the integrals are the responses.
                let ((sin, cos), [_, s0, s1, s2]) = (phase.sin_cos(), responses(omega * omega, t));
                let (a, b) = (*amplitude * sin + *quadrature * cos, (*amplitude * cos - *quadrature * sin) * *omega);
                [a * s0 + b * s1, a * s1 + b * s2]
            }
            Ground::Record { .. } => {
                let number = self.ground.piece_number(t);
                let piece = self.ground.piece(number);
                piece.carried(self.at_samples[number], piece.from, t - piece.from)
            }
        }
    }
}

impl GroundPath {
    /// The acceleration that it is the path of.
    pub const fn ground(&self) -> &Ground {
        &self.ground
    }

    /// Velocity at which it goes on once its record has ended \[m/s\]; of a sine, which has no end, the mean: `∫(A sin(ωt + φ) + B cos(ωt + φ))`
    /// from rest has that of `(A cos φ − B sin φ)/ω`.
    pub fn last_velocity(&self) -> Option<DVec3> {
        match self.ground {
            Ground::Still => Some(DVec3::ZERO),
            Ground::Sine { omega: 0.0, .. } => None,
            Ground::Sine { amplitude, quadrature, omega, phase } => {
                Some((amplitude * phase.cos() - quadrature * phase.sin()) / omega)
            }
            Ground::Record { .. } => self.at_samples.last().map(|[velocity, _]| *velocity),
        }
    }
}

/// Motion of the ground of a support: `factor · a(t − delay)` of the ground motion of this number, at rest before.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct SupportMotion {
    #[serde(skip)]
    /// Number of the ground motion: 0 that of the ground of reference, from 1 on those with names.
    pub ground: usize,
    /// By how much later it begins; not negative \[s\].
    pub delay: f64,
    /// Factor of its acceleration \[–\].
    pub factor: f64,
}

impl SupportMotion {
    /// That of the ground of reference.
    pub const REFERENCE: Self = Self { ground: 0, delay: 0.0, factor: 1.0 };
}

/// Motion of a support against the ground of reference: `factor · x_s(t − delay) − x(t)`, and its derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct RelativeMotion {
    /// Of the support's own ground motion, neither late nor multiplied.
    path: Arc<GroundPath>,
    own: SupportMotion,
    reference: Arc<GroundPath>,
}

impl RelativeMotion {
    /// Of a support over grounds whose paths are known, by their numbers.
    pub fn of(paths: &[Arc<GroundPath>], own: SupportMotion) -> Self {
        Self { path: Arc::clone(&paths[own.ground]), own, reference: Arc::clone(&paths[0]) }
    }

    /// Velocity \[m/s\] and displacement \[m\] at `t`.
    pub fn at(&self, t: f64) -> [DVec3; 2] {
        let (own, reference) = (self.path.at(t - self.own.delay), self.reference.at(t));
        [0, 1].map(|i| own[i] * self.own.factor - reference[i])
    }

    /// Velocity at which it goes on once both grounds' records have ended, of sines the mean \[m/s\]; none of a record without samples.
    pub fn last_velocity(&self) -> Option<DVec3> {
        Some(self.path.last_velocity()? * self.own.factor - self.reference.last_velocity()?)
    }

    /// Velocity of the support's own ground at `t` \[m/s\].
    pub fn own_velocity(&self, t: f64) -> DVec3 {
        self.path.at(t - self.own.delay)[0] * self.own.factor
    }

    /// Velocity at which the support's own ground goes on once its record has ended, of a sine the mean \[m/s\]; none of a record without
    /// samples.
    pub fn own_last_velocity(&self) -> Option<DVec3> {
        Some(self.path.last_velocity()? * self.own.factor)
    }

    /// Acceleration at `t` of a stretch without a kink that begins at `since` \[m/s²\].
    pub fn acceleration(&self, since: f64, t: f64) -> DVec3 {
        let reference = &self.reference.ground;
        let of = |ground: &Ground, piece: &LinearPiece, t: f64| match ground {
            Ground::Record { .. } => piece.acceleration(t),
            other => other.acceleration(t),
        };
        let own = self.own_piece(since);
        let own = own.map_or(DVec3::ZERO, |piece| of(&self.path.ground, &piece, t - self.own.delay));
        own * self.own.factor - of(reference, &reference.piece(reference.piece_number(since)), t)
    }

    /// The next time after `t` at which the acceleration has a kink or a jump; infinite when there is none \[s\].
    pub fn next_kink(&self, t: f64) -> f64 {
        let own = match self.own_piece(t) {
            None => self.own.delay,
            Some(piece) => piece.until + self.own.delay,
        };
        own.min(self.reference.ground.next_kink(t))
    }

    /// Bound of its acceleration at any time \[m/s²\].
    pub fn peak(&self) -> f64 {
        self.own.factor.abs() * self.path.ground.peak() + self.reference.ground.peak()
    }

    /// Time within which either ground's acceleration changes by about itself: some samples of a record, a radian of a sine \[s\].
    pub fn pace(&self) -> f64 {
        let of = |ground: &Ground| match ground {
            Ground::Still => f64::INFINITY,
            Ground::Sine { omega, .. } => omega.recip(),
            Ground::Record { dt, .. } => *dt,
        };
        of(&self.path.ground).min(of(&self.reference.ground))
    }

    /// The piece of the support's own record at `t`, in its own time; `None` before it begins. A kink belongs to the piece that it
    /// begins, where it was computed as `k Δt + delay`.
    fn own_piece(&self, t: f64) -> Option<LinearPiece> {
        let (ground, delay) = (&self.path.ground, self.own.delay);
        if t < delay {
            return None;
        }
        let mut number = ground.piece_number(t - delay);
        while ground.piece(number).until + delay <= t {
            number += 1;
        }
        while number > 0 && ground.piece(number).from + delay > t {
            number -= 1;
        }
        Some(ground.piece(number))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grounds() -> [Ground; 3] {
        let samples = [0.3, 1.0, -2.0, 0.5, 0.0, 1.5, -0.7];
        let sine =
            Ground::Sine { amplitude: DVec3::new(2.0, 1.0, 0.0), quadrature: DVec3::Z * 0.5, omega: 9.0, phase: 0.4 };
        let constant = Ground::Sine { amplitude: DVec3::X, quadrature: DVec3::Z, omega: 0.0, phase: 1.0 };
        [Ground::record(DVec3::new(0.6, 0.8, 0.0), 0.1, samples), sine, constant]
    }

    #[test]
    fn velocity_and_displacement_are_the_integrals_of_the_acceleration() {
        for ground in grounds() {
            let path = GroundPath::of(ground.clone());
            // Simpson's rule over cells within pieces is exact for a record, and of fourth order for a sine.
            let (mut v, mut x) = (DVec3::ZERO, DVec3::ZERO);
            let (count, until) = (1600, 0.8);
            let h = until / f64::from(count);
            for i in 0..count {
                let t = f64::from(i) * h;
                let cell = |part: f64| {
                    let piece = ground.piece(ground.piece_number(t + 0.5 * h));
                    if matches!(ground, Ground::Record { .. }) {
                        piece.acceleration(t + part * h)
                    } else {
                        ground.acceleration(t + part * h)
                    }
                };
                let [a, b, c] = [0.0, 0.5, 1.0].map(cell);
                x += v * h + (a + 2.0 * b) * (h * h / 6.0);
                v += (a + 4.0 * b + c) * (h / 6.0);
            }
            let [velocity, displacement] = path.at(until);
            assert!((velocity - v).length() < 1e-12, "{velocity} for {v} m/s");
            assert!((displacement - x).length() < 1e-11, "{displacement} for {x} m");
        }
    }

    /// Holds the acceleration of a support against that of its own ground, late and multiplied, less that of reference.
    fn holds(relative: &RelativeMotion, support: SupportMotion, own: &Ground, reference: &Ground) {
        let mut since = 0.0;
        while since < 1.0 {
            let kink = relative.next_kink(since).min(since + 0.05);
            assert!(kink > since, "{kink} after {since}");
            let t = 0.5 * (since + kink);
            let late = if t < support.delay { DVec3::ZERO } else { own.acceleration(t - support.delay) };
            let wanted = late * support.factor - reference.acceleration(t);
            // Rounding of times near 1 s and of accelerations to 4 m/s², by slopes to 30 m/s³: below 1e-14.
            assert!((relative.acceleration(since, t) - wanted).length() < 1e-12, "at {t}");
            assert!(wanted.length() <= relative.peak(), "a bound");
            since = kink;
        }
    }

    #[test]
    fn a_support_moves_later_and_by_its_factor() {
        for ground in grounds() {
            let paths = [Arc::new(GroundPath::of(ground.clone()))];
            let support = SupportMotion { ground: 0, delay: 0.137, factor: 0.8 };
            let relative = RelativeMotion::of(&paths, support);
            holds(&relative, support, &ground, &ground);
            let [_, before] = relative.at(0.1);
            assert_eq!(before, -paths[0].at(0.1)[1], "at rest before it begins");
            let still = RelativeMotion::of(&paths, SupportMotion::REFERENCE);
            assert_eq!(still.at(0.5), [DVec3::ZERO; 2], "no motion against itself");
        }
    }

    #[test]
    fn a_support_on_a_ground_of_its_own_moves_by_the_difference() {
        let [record, sine, constant] = grounds();
        for (reference, own) in [(&record, &sine), (&sine, &record), (&Ground::Still, &record), (&constant, &sine)] {
            let paths = [reference, own].map(|ground| Arc::new(GroundPath::of(ground.clone())));
            let support = SupportMotion { ground: 1, delay: 0.23, factor: -1.7 };
            let relative = RelativeMotion::of(&paths, support);
            holds(&relative, support, own, reference);
            let wanted = -1.7 * paths[1].at(0.5)[1] - paths[0].at(0.73)[1];
            assert!((relative.at(0.73)[1] - wanted).length() < 1e-12, "displacement");
        }
    }
}
