//! A body whose ends move on their own through the real solver: two masses on one axis, joined by a spring, between girders.

use std::ops::Range;
use std::sync::Arc;

use crate::support::{scene, within};
use girderbench::contact::Frame;
use girderbench::dynamics::Model;
use girderbench::dynamics::linear::FlightParameters;
use girderbench::dynamics::model::body::{
    Body, BodyCoordinates, BodyEnergies, BodyPowers, Coordinates, Counted, Point,
};
use girderbench::dynamics::model::closed_form::ClosedForm;
use girderbench::dynamics::model::ground_now::GroundNow;
use girderbench::dynamics::model::motion_bounds::MotionBounds;
use girderbench::dynamics::model::reference_pose::ReferencePose;
use girderbench::dynamics::model::wrench::Wrench;
use girderbench::geometry::End;
use girderbench::motion::Ground;
use girderbench::scene::Scene;
use girderbench::sim::{History, Session, readings};
use glam::{DMat3, DQuat, DVec2, DVec3};

const MASS: f64 = 2.0;
/// Mass of an end \[kg\].
const HALF: f64 = 0.5 * MASS;
const SPEED: f64 = 0.5;
const GAP: f64 = 0.005;

/// Displacements of the minus and the plus end along x, and their rates; sections: both together, minus end, plus end.
#[derive(Clone, Copy, Debug)]
struct TwoEnds {
    /// Circular frequency of the ends against each other \[rad/s\].
    omega: f64,
}

const POSITIONS: Range<usize> = 0..2;
const RATES: Range<usize> = 2..4;

/// A value of a section by those of the ends.
fn of_section(section: usize, ends: DVec2) -> f64 {
    match section {
        0 => 0.5 * (ends.x + ends.y),
        end => ends[end - 1],
    }
}

/// How a force on a section falls upon the ends.
fn shares(section: usize) -> DVec2 {
    [DVec2::splat(0.5), DVec2::X, DVec2::Y][section]
}

impl TwoEnds {
    /// k of the spring, by the reduced mass of the ends \[N/m\].
    fn stiffness(self) -> f64 {
        0.5 * HALF * self.omega * self.omega
    }

    fn level(body: &Body, x: f64) -> ReferencePose {
        ReferencePose::level(DVec3::new(x, 0.0, body.start[2]), 0.0, DMat3::ZERO)
    }
}

impl Coordinates for TwoEnds {
    fn width(&self) -> usize {
        4
    }

    fn positions(&self) -> usize {
        POSITIONS.len()
    }

    fn sections(&self) -> usize {
        3
    }

    fn section(&self, end: End) -> usize {
        match end {
            End::Minus => 1,
            End::Plus => 2,
        }
    }

    fn displacements(&self) -> Option<Range<usize>> {
        None
    }

    fn initial(&self, _: &Body) -> Vec<f64> {
        vec![0.0; 4]
    }

    fn frame(&self, body: &Body, section: usize, state: &[f64]) -> Frame {
        let [place, rate] = [POSITIONS, RATES].map(|part| of_section(section, DVec2::from_slice(&state[part])));
        let shift = DVec3::new(place, 0.0, body.start[2]);
        Frame { shift, velocity: DVec3::X * rate, ..Frame::fixed(body.home) }
    }

    fn frame_since(&self, body: &Body, section: usize, state: &[f64]) -> Frame {
        let frame = self.frame(body, section, state);
        Frame { shift: frame.shift.with_z(0.0), ..frame }
    }

    fn attitude(&self, _: &Body, _: &[f64]) -> (f64, DQuat) {
        (0.0, DQuat::IDENTITY)
    }

    fn reference(&self, body: &Body, numbers: &[f64]) -> ReferencePose {
        Self::level(body, numbers.first().copied().unwrap_or(0.0))
    }

    fn rebase(&self, body: &Body, state: &mut [f64]) -> ReferencePose {
        let x = of_section(0, DVec2::from_slice(state));
        state[POSITIONS].iter_mut().for_each(|place| *place -= x);
        Self::level(body, x)
    }

    fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        let x = numbers.first().copied().unwrap_or(0.0);
        state[POSITIONS].iter_mut().for_each(|place| *place += x);
    }

    fn slope(&self, _: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        let pull = self.stiffness() * (now.state[1] - now.state[0]);
        let on_ends = contact.iter().enumerate().map(|(section, wrench)| shares(section) * wrench.force.x);
        let force = on_ends.sum::<DVec2>() + DVec2::new(pull, -pull);
        out[POSITIONS].copy_from_slice(&now.state[RATES]);
        out[RATES].copy_from_slice(&(force / HALF - DVec2::splat(ground.acceleration.x)).to_array());
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        state[POSITIONS].iter_mut().zip(&slope[RATES]).for_each(|(place, gain)| *place += 0.5 * dt * dt * gain);
    }

    fn size2(&self, _: &Body, difference: &[f64]) -> [f64; 2] {
        [POSITIONS, RATES].map(|part| DVec2::from_slice(&difference[part]).length_squared())
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        if POSITIONS.contains(&i) { place } else { omega * place }
    }

    fn excursion(&self, _: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        way(0..1).max(way(1..2))
    }

    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let [[u, a], [v, b]] = [rates(0..1), rates(1..2)];
        MotionBounds { speed: u.max(v), acceleration: a.max(b), ..MotionBounds::still(f64::INFINITY) }
    }

    fn acceleration(&self, _: &Body, point: Point<'_>, force: DVec3) -> DVec3 {
        let gains = shares(point.section) * (force.x / HALF);
        DVec3::X * of_section(point.section, gains)
    }

    fn port(&self, _: &Body, point: Point<'_>, force: DVec3, [response, load]: [&mut [f64]; 2]) {
        let on_ends = shares(point.section) * force.x;
        response[RATES].copy_from_slice(&(on_ends / HALF).to_array());
        load[RATES].copy_from_slice(&on_ends.to_array());
    }

    fn free_motion(&self, ground: &Ground, _: f64) -> Option<Arc<dyn ClosedForm>> {
        matches!(ground, Ground::Still).then(|| Arc::new(*self) as Arc<dyn ClosedForm>)
    }

    fn fastest(&self, _: &Body) -> f64 {
        self.omega
    }

    fn energies(&self, _: &Body, state: &[f64], _: f64) -> BodyEnergies {
        let stretch = state[1] - state[0];
        let speed2 = DVec2::from_slice(&state[RATES]).length_squared();
        BodyEnergies {
            kinetic: 0.5 * HALF * speed2,
            bearings: 0.5 * self.stiffness() * stretch * stretch,
            ..BodyEnergies::default()
        }
    }

    fn powers(&self, _: &Body, state: &[f64], ground: GroundNow) -> BodyPowers {
        BodyPowers { ground: -HALF * ground.acceleration.x * (state[2] + state[3]), ..BodyPowers::default() }
    }
}

impl ClosedForm for TwoEnds {
    fn state(&self, flight: FlightParameters<'_>, t: f64, out: &mut [f64]) {
        let FlightParameters { start, numbers: from } = flight;
        let (w, tau) = (self.omega, t - start);
        let [place, rate] = [POSITIONS, RATES].map(|part| of_section(0, DVec2::from_slice(&from[part])));
        let [r, v] = [0.5 * (from[1] - from[0]), 0.5 * (from[3] - from[2])];
        let (s, c) = (w * tau).sin_cos();
        let swung = [r * c + if w > 0.0 { v * s / w } else { v * tau }, v * c - r * w * s];
        for (i, sign) in [-1.0, 1.0].into_iter().enumerate() {
            (out[i], out[2 + i]) = (place + rate * tau + sign * swung[0], rate + sign * swung[1]);
        }
    }

    fn bounds(&self, flight: FlightParameters<'_>, t: f64, horizon: f64) -> MotionBounds {
        let mut state = [0.0; 4];
        self.state(flight, t, &mut state);
        let rate = of_section(0, DVec2::from_slice(&state[RATES])).abs();
        let swing = (0.5 * (state[3] - state[2])).hypot(self.omega * 0.5 * (state[1] - state[0]));
        let (speed, far) = (rate + swing, state[0].abs().max(state[1].abs()));
        let reach = far + speed * horizon;
        MotionBounds { reach, speed, acceleration: self.omega * swing, ..MotionBounds::still(horizon) }
    }
}

/// A girder under way to such a body, another behind it; elastic contacts.
fn run(omega: f64, duration: f64) -> History {
    let girder = |(i, name): (u32, &str)| {
        let (x, speed) = (f64::from(i) * (0.19 + GAP), if i == 0 { SPEED } else { 0.0 });
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = {MASS:?}\n\
             position_m = [{x}, 0.0, 0.0]\ninitial = {{ velocity_m_s = [{speed}, 0.0] }}\n"
        )
    };
    let girders: String = (0..).zip(["one", "ends", "two"]).map(girder).collect();
    let scene: Scene = scene(&format!(
        "name = \"ends\"\nduration_s = {duration:?}\n{girders}[contact]\nstiffness_n_per_m = 1.55e5\n\
         restitution_normal = 1.0\nrestitution_tangential = 1.0\nlaw = \"paper\"\n[solver]\ntolerance = 1e-12\n"
    ));
    let mut model = Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    let body = &mut model.bodies[1];
    body.coordinates = BodyCoordinates::Custom(Arc::new(TwoEnds { omega }));
    (body.rate_bounds.mobility, body.rate_bounds.stiffest) = (1.0 / HALF, omega * omega);
    let mut session = Session::of_model(&scene, model);
    session.advance(duration, &mut |_| true);
    let history = session.finish();
    assert!(history.stop().is_none(), "{:?}", history.stop());
    history
}

/// Displacements of the ends, as the gaps before the girders tell them \[m\].
fn ends(history: &History, t: f64) -> [f64; 2] {
    let gap = |pair: usize| readings::before_face(history, history.model().pairs[pair].sites.start, t)[0] - GAP;
    let [first, last] = [0, 2].map(|girder| history.motion(girder, t).displacement.x);
    [first + gap(0), last - gap(1)]
}

#[test]
fn without_a_spring_the_end_that_is_hit_moves_alone() {
    let history = run(0.0, 0.03);
    let ended = history.hits().touches().iter().map(|touch| touch.end).fold(0.0, f64::max);
    assert!(
        ended > 0.0 && history.hits().touches().iter().all(|touch| touch.pair == 0),
        "one hit: {:?}",
        history.hits().touches()
    );
    let speed = |body: usize| history.motion(body, ended + 1e-4).velocity.x / SPEED;
    // A mass against half of it, elastic.
    within("the girder", speed(0) - 1.0 / 3.0, 1e-12);
    within("both ends together", speed(1) - 2.0 / 3.0, 1e-12);
    for t in [0.0, 0.5 * ended, ended, 0.03] {
        within("the other end stays", ends(&history, t)[1], 1e-16);
    }
    let travelled = 4.0 / 3.0 * SPEED * 1e-3;
    let [before, after] = [1e-3, 2e-3].map(|dt| ends(&history, ended + dt)[0]);
    within("the end that was hit", after - before - travelled, 1e-14);
}

#[test]
fn with_a_spring_the_ends_swing_and_momentum_and_energy_are_kept() {
    let omega = 260.0;
    let history = run(omega, 0.1);
    let mut borders: Vec<f64> = history.hits().touches().iter().flat_map(|touch| [touch.start, touch.end]).collect();
    borders.sort_by(f64::total_cmp);
    let both = [0, 1].map(|pair| history.hits().touches().iter().any(|touch| touch.pair == pair));
    assert_eq!(both, [true; 2], "both girders are touched");
    for i in 0..=100 {
        let t = 1e-3 * f64::from(i);
        let sum: f64 = (0..3).map(|body| history.motion(body, t).velocity.x).sum();
        within("momentum", sum / SPEED - 1.0, 1e-12);
        let books = history.energy().ledger(t);
        within("ledger", books.residual / books.scale, 1e-11);
    }
    // Where nothing touches: the ends' distance is a harmonic function of time, their mean a straight line.
    let free = borders.windows(2).filter(|w| w[1] - w[0] > 2e-3).map(|w| 0.5 * (w[0] + w[1]));
    let free: Vec<f64> =
        free.filter(|&t| history.hits().touches().iter().all(|touch| t < touch.start || t > touch.end)).collect();
    assert!(!free.is_empty(), "a flight between {borders:?}");
    for t in free {
        let h = 5e-4;
        let [before, now, after] = [t - h, t, t + h].map(|t| ends(&history, t));
        let bend = |of: fn([f64; 2]) -> f64, factor: f64| of(before) + of(after) - factor * of(now);
        within("distance", bend(|[a, b]| b - a, 2.0 * (omega * h).cos()), 1e-14);
        within("mean", bend(|[a, b]| a + b, 2.0), 1e-14);
        assert!((ends(&history, t)[1] - ends(&history, t)[0]).abs() > 1e-6, "it is stretched");
    }
}
