//! The motion of a body of one coordinate on springs to the ground, under a record, in closed form.
//!
//! `ü + ω² u = load − a_g(t)`: between two samples of the record a free oscillation about a straight line. The impulse response
//! `S0 = sin(ω τ)/ω` and its integrals `S1 = ∫S0`, `S2 = ∫S1` carry a state across an interval:
//! `u(τ) = u C + v S0 + c0 S1 + c1 S2` with `C = 1 − ω² S1` and the force `c0 + c1 τ`.

use glam::DVec3;

use crate::dynamics::linear::FlightParameters;
use crate::dynamics::model::closed_form::{ClosedForm, GroundSpring};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::motion::responses::responses;
use crate::motion::{Ground, LinearPiece};

/// Longest stretch of a flight \[rad of its oscillation\]. Tuned: that of explicit steps, whose samples show every sign change.
const STRETCH_PHASE: f64 = 1.25;
/// Most samples of the record that bounds look ahead.
const AHEAD: usize = 8;
/// Numbers of a flight: stiffness, load, displacement and rate at the start, then displacement and rate at each sample of the
/// record since.
const HEAD: usize = 4;

/// The motion along one direction.
#[derive(Debug)]
pub(super) struct GuidedFlight {
    ground: Ground,
    along: DVec3,
}

impl GuidedFlight {
    /// `None` under a sine, whose steady response has a resonance.
    pub(super) fn under(ground: &Ground, along: DVec3) -> Option<Self> {
        (!matches!(ground, Ground::Sine { .. })).then(|| Self { ground: ground.clone(), along })
    }

    /// Force per unit mass at `t` within a piece, and its rate.
    fn force(&self, spring: GroundSpring, piece: &LinearPiece, t: f64) -> [f64; 2] {
        [spring.load - piece.acceleration(t).dot(self.along), -piece.rate().dot(self.along)]
    }

    fn advance(&self, spring: GroundSpring, piece: &LinearPiece, at: f64, [u, v]: [f64; 2], tau: f64) -> [f64; 2] {
        let [c0, c1] = self.force(spring, piece, at);
        let [c, s0, s1, s2] = responses(spring.stiffness, tau);
        [u * c + v * s0 + c0 * s1 + c1 * s2, v * c - spring.stiffness * s0 * u + c0 * s0 + c1 * s1]
    }

    /// `u, u̇` at `t`.
    fn at(&self, flight: FlightParameters<'_>, t: f64) -> [f64; 2] {
        FlightNumbers::of(flight.numbers).map_or([f64::NAN; 2], |numbers| self.within(flight.start, &numbers, t).state)
    }

    /// State at `t`, with the piece of the ground's motion that holds it.
    fn within(&self, start: f64, numbers: &FlightNumbers<'_>, t: f64) -> StateInPiece {
        let &FlightNumbers { spring, own, states_at_samples } = numbers;
        let first = self.ground.piece_number(start);
        let target = if t == start { first } else { self.ground.piece_number(t) };
        let known = target.saturating_sub(first).min(states_at_samples.len());
        let (mut number, mut at, mut state) = match known.checked_sub(1) {
            Some(last) => (first + known, self.ground.piece_start(first + known), states_at_samples[last]),
            None => (first, start, own),
        };
        while number < target {
            let piece = self.ground.piece(number);
            state = self.advance(spring, &piece, at, state, piece.until - at);
            (number, at) = (number + 1, piece.until);
        }
        let piece = self.ground.piece(number);
        if t != at {
            state = self.advance(spring, &piece, at, state, t - at);
        }
        StateInPiece { number, piece, state }
    }
}

/// A state of a flight, and the piece of the ground's motion, of this number, in which it is.
struct StateInPiece {
    number: usize,
    piece: LinearPiece,
    /// `u, u̇`.
    state: [f64; 2],
}

/// A flight's parameters, by name.
struct FlightNumbers<'a> {
    spring: GroundSpring,
    /// `u, u̇` at the start.
    own: [f64; 2],
    /// `u, u̇` at the samples of the record since.
    states_at_samples: &'a [[f64; 2]],
}

impl<'a> FlightNumbers<'a> {
    fn of(numbers: &'a [f64]) -> Option<Self> {
        let (&[stiffness, load, u, v], states_at_samples) = numbers.split_first_chunk::<HEAD>()?;
        Some(Self {
            spring: GroundSpring { stiffness, load },
            own: [u, v],
            states_at_samples: states_at_samples.as_chunks().0,
        })
    }
}

/// Extremes of a motion: least and greatest displacement \[m\], greatest speed \[m/s\] and acceleration \[m/s²\].
struct Extremes {
    range: [f64; 2],
    speed: f64,
    acceleration: f64,
}

impl Extremes {
    /// Over τ from a state under `c0 + c1 τ`: the smaller of two bounds. An oscillation about a straight line keeps its amplitude, which
    /// is far from the motion where the spring is soft. `√(u̇² + ω² u²)` grows no faster than the force.
    fn of(omega2: f64, [u, v]: [f64; 2], [c0, c1]: [f64; 2], tau: f64) -> Self {
        let omega = omega2.sqrt();
        let force = c0.abs().max((c0 + c1 * tau).abs());
        let speed = v.hypot(omega * u) + force * tau;
        let pushed = Self { range: [u - speed * tau, u + speed * tau], speed, acceleration: force + omega * speed };
        if omega2 == 0.0 {
            return pushed;
        }
        let (rest, drift) = (c0 / omega2, c1 / omega2);
        let speed = ((u - rest) * (u - rest) * omega2 + (v - drift) * (v - drift)).sqrt();
        let last = rest + drift * tau;
        let range = [rest.min(last) - speed / omega, rest.max(last) + speed / omega];
        Self {
            range: [range[0].max(pushed.range[0]), range[1].min(pushed.range[1])],
            speed: pushed.speed.min(speed + drift.abs()),
            acceleration: pushed.acceleration.min(speed * omega),
        }
    }
}

impl ClosedForm for GuidedFlight {
    fn begin(&self, _: f64, states: &[&[f64]]) -> Vec<f64> {
        states.first().and_then(|state| self.begin_on(state, GroundSpring::default())).unwrap_or_default()
    }

    fn begin_on(&self, state: &[f64], spring: GroundSpring) -> Option<Vec<f64>> {
        let &[u, v] = state else { return None };
        (spring.stiffness >= 0.0).then(|| vec![spring.stiffness, spring.load, u, v])
    }

    fn remember(&self, start: f64, numbers: &mut Vec<f64>, t: f64) {
        let Some(FlightNumbers { spring, own, states_at_samples }) = FlightNumbers::of(numbers) else { return };
        let mut number = self.ground.piece_number(start) + states_at_samples.len();
        let (mut state, mut piece) = (states_at_samples.last().copied().unwrap_or(own), self.ground.piece(number));
        let mut at = piece.from.max(start);
        while piece.until <= t {
            state = self.advance(spring, &piece, at, state, piece.until - at);
            numbers.extend(state);
            (number, at) = (number + 1, piece.until);
            piece = self.ground.piece(number);
        }
    }

    fn window_end(&self, FlightParameters { numbers, .. }: FlightParameters<'_>, t: f64) -> f64 {
        let omega = numbers.first().map_or(0.0, |stiffness| stiffness.sqrt());
        let kink = self.ground.next_kink(t);
        let phase = omega * (kink - t);
        if phase <= STRETCH_PHASE {
            kink
        } else if kink.is_finite() {
            t + (kink - t) / (phase / STRETCH_PHASE).ceil()
        } else if omega > 0.0 {
            t + STRETCH_PHASE / omega
        } else {
            kink
        }
    }

    fn range(&self, flight: FlightParameters<'_>, [from, until]: [f64; 2]) -> Option<[f64; 2]> {
        let numbers = FlightNumbers::of(flight.numbers)?;
        let StateInPiece { piece, state, .. } = self.within(flight.start, &numbers, from);
        let spring = numbers.spring;
        Some(Extremes::of(spring.stiffness, state, self.force(spring, &piece, from), until - from).range)
    }

    /// By the growth of `√(u̇² + ω² u²)`, which is at most the greatest force per unit mass.
    fn displacement_bound(&self, flight: FlightParameters<'_>, until: f64) -> Option<f64> {
        let FlightNumbers { spring, own: [u, v], .. } = FlightNumbers::of(flight.numbers)?;
        let (force, tau) = (spring.load.abs() + self.ground.peak(), until - flight.start);
        let speed = (v * v + spring.stiffness * u * u).sqrt() + force * tau;
        Some(u.abs() + speed * tau)
    }

    fn resume(&self, flight: FlightParameters<'_>, state: &[f64]) -> Vec<f64> {
        flight.numbers.iter().take(HEAD - 2).chain(state).copied().collect()
    }

    fn state(&self, flight: FlightParameters<'_>, t: f64, out: &mut [f64]) {
        out.copy_from_slice(&self.at(flight, t));
    }

    fn bounds(&self, flight: FlightParameters<'_>, t: f64, horizon: f64) -> MotionBounds {
        let (mut bounds, end) = (MotionBounds::still(horizon), t + horizon);
        let Some(numbers) = FlightNumbers::of(flight.numbers) else {
            return MotionBounds { window: 0.0, ..bounds };
        };
        let StateInPiece { mut number, mut piece, mut state } = self.within(flight.start, &numbers, t);
        let (spring, mut at) = (numbers.spring, t);
        for _ in 0..AHEAD {
            let tau = piece.until.min(end) - at;
            let extremes = Extremes::of(spring.stiffness, state, self.force(spring, &piece, at), tau);
            bounds.reach = extremes.range.into_iter().fold(bounds.reach, |reach, u| reach.max(u.abs()));
            bounds.speed = bounds.speed.max(extremes.speed);
            bounds.acceleration = bounds.acceleration.max(extremes.acceleration);
            if piece.until >= end {
                return bounds;
            }
            state = self.advance(spring, &piece, at, state, tau);
            (number, at) = (number + 1, piece.until);
            piece = self.ground.piece(number);
        }
        MotionBounds { window: at - t, ..bounds }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A flight on a spring of ω² under a record, from 0.3 of an interval on.
    fn flight(omega2: f64) -> (GuidedFlight, f64, Vec<f64>) {
        let ground = Ground::record(DVec3::X, 0.01, [0.0, 1.3, -0.8, 0.4, 2.0, -1.0, 0.3, 0.0]);
        let form = GuidedFlight::under(&ground, DVec3::new(0.6, 0.8, 0.0)).expect("a record");
        let spring = GroundSpring { stiffness: omega2, load: 0.7 };
        let numbers = form.begin_on(&[1e-4, -0.02], spring).expect("a spring that pulls");
        (form, 0.003, numbers)
    }

    #[test]
    fn the_closed_form_solves_the_equation_of_motion() {
        for omega2 in [0.0, 9.0, 900.0, 6e4] {
            let (form, start, numbers) = flight(omega2);
            let flight = FlightParameters { start, numbers: &numbers };
            for t in [0.0045, 0.0137, 0.0255, 0.0612, 0.093] {
                let step = 1e-4 / omega2.sqrt().max(10.0);
                let rate = |k: f64| form.at(flight, t + k * step)[1];
                let gained = (rate(-2.0) - 8.0 * rate(-1.0) + 8.0 * rate(1.0) - rate(2.0)) / (12.0 * step);
                let ground = form.ground.acceleration(t).dot(form.along);
                let force = 0.7 - omega2 * form.at(flight, t)[0] - ground;
                assert!(
                    (gained - force).abs() < 1e-8 * omega2.sqrt().max(10.0),
                    "{omega2}, {t} s: {gained} for {force}"
                );
            }
        }
    }

    #[test]
    fn states_kept_at_samples_change_nothing_and_a_flight_can_be_resumed() {
        let (form, start, numbers) = flight(6e4);
        let mut kept = numbers.clone();
        form.remember(start, &mut kept, 0.055);
        assert_eq!(kept.len(), numbers.len() + 2 * 5, "samples at 10 to 50 ms");
        let own = FlightParameters { start, numbers: &kept };
        let rest = form.resume(own, &form.at(own, 0.0231));
        for t in [0.0231, 0.041, 0.0599, 0.2] {
            let [a, b, c] = [(start, &numbers), (start, &kept), (0.0231, &rest)]
                .map(|(start, numbers)| form.at(FlightParameters { start, numbers }, t));
            assert_eq!(a, b, "{t} s");
            assert!((a[0] - c[0]).abs() < 1e-16 && (a[1] - c[1]).abs() < 1e-14, "{t} s: {a:?} against {c:?}");
        }
    }

    #[test]
    fn bounds_hold_and_stretches_end_at_samples() {
        for omega2 in [0.0, 1e-16, 900.0, 6e4] {
            let (form, start, numbers) = flight(omega2);
            let flight = FlightParameters { start, numbers: &numbers };
            let bounds = form.bounds(flight, 0.004, 0.04);
            assert!(bounds.window >= 0.04, "{bounds:?}");
            let fastest = (0..=400).map(|i| form.at(flight, 0.004 + 1e-4 * f64::from(i))[1].abs());
            let fastest = fastest.fold(0.0, f64::max);
            assert!(bounds.speed < 5.0 * fastest, "{omega2} 1/s²: {bounds:?} for {fastest} m/s");
            for i in 0..=400 {
                let [u, v] = form.at(flight, 0.004 + 1e-4 * f64::from(i));
                assert!(u.abs() <= bounds.reach && v.abs() <= bounds.speed, "{u} m, {v} m/s: {bounds:?}");
            }
            let farthest = form.displacement_bound(flight, 0.012).expect("one coordinate");
            let ways = (0..=90).map(|i| form.at(flight, 0.003 + 1e-4 * f64::from(i))[0].abs());
            let most = ways.fold(0.0, f64::max);
            assert!(most <= farthest && farthest < 6.0 * most, "{omega2} 1/s²: {farthest} for {most} m");
            let (mut t, mut kinks) = (start, 0);
            while t < 0.0399 {
                let end = form.window_end(flight, t);
                let [least, greatest] = form.range(flight, [t, end]).expect("one coordinate");
                let ways = (0..=50).map(|i| form.at(flight, t + (end - t) * f64::from(i) / 50.0)[0]);
                assert!(ways.into_iter().all(|u| (least..=greatest).contains(&u)), "{least} to {greatest} m");
                assert!(end > t && omega2.sqrt() * (end - t) <= STRETCH_PHASE * (1.0 + 1e-12), "{t} to {end}");
                kinks += u32::from(end == form.ground.next_kink(t));
                t = end;
            }
            assert_eq!((t, kinks), (0.04, 4), "at every sample");
        }
    }
}
