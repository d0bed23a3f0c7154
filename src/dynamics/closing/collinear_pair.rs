//! The next closing of a pair on one axis: the bodies move along the axis, the faces are square to it, and all nodes
//! of the pair have one gap, the difference of two coordinates.
//!
//! `g = g₀ ± (q_a − q_b)`, with bounds on `g̈` from those of the two coordinates, searched as any gap: conservative
//! advancement in flight, [`subdivision`](crate::dynamics::locate::subdivision) in planned steps. Pairs with a body
//! that turns or moves across the axis, and pairs with contacts that are closed or disarmed, take the general search
//! of [`closing`](crate::dynamics::closing).

use crate::dynamics::closing::flight_view::horizon;
use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::free_flight::body_flight::FlightAlong;
use crate::dynamics::free_flight::relative_bounds;
use crate::dynamics::free_flight::uncoupled_axis::UncoupledAxis;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::locate::advancement::{BoundedGap, FirstZero, first_crossing_from};
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::subdivision::{GapClosing, GapSample, Subdivision};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::island_poses::StepAlong;
use crate::dynamics::world::World;
use crate::dynamics::world::axial_gap::AxialGap;
use crate::dynamics::world::tracks::Trajectory;

/// Motion of one side along the axis.
enum Side<'a> {
    /// An abutment.
    Fixed,
    /// Flight as one oscillator; `part` is its free motion at `start`, `push` its constant acceleration.
    Flight { dof: &'a UncoupledAxis, part: [f64; 2], start: f64, push: f64 },
    /// Components (position, velocity) of an island's planned step from `from` to `until`, the position relative to
    /// `base`.
    Step { island: usize, dense: &'a DenseOutput, components: [usize; 2], base: f64, from: f64, until: f64 },
}

/// Motion of both sides of a pair.
struct CollinearPair<'a> {
    world: &'a World,
    pair: AxialGap,
    sides: [Side<'a>; 2],
    drive: f64,
}

/// Searches a pair from `t` on and enters the closing of its contacts; the time of its closing or of the end of the
/// search, infinite without either \[s\]. `None` for a pair that is not on one axis or has a contact that is not open
/// and armed.
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64) -> Option<NextClosing> {
    let axial = world.pairs[pair].axial?;
    let contacts = world.pairs[pair].contacts.clone();
    if !contacts.clone().all(|contact| world.contacts[contact].state == Contact::Open { armed: true }) {
        return None;
    }
    let collinear = CollinearPair::of(world, pair, axial)?;
    let resolution = RESOLUTION * (axial.size + collinear.moved(t));
    let (next, closing) = if let Some(until) = collinear.first_step_end() {
        let closing = collinear.in_step(t, until, resolution);
        (NextClosing::at(closing.unwrap_or(f64::INFINITY)), closing)
    } else {
        let until = horizon(world, world.pairs[pair].slots, t);
        let (found, evaluations) = collinear.in_flight([t, until], resolution);
        let closing = if let FirstZero::Crossing(at) = found { Some(at) } else { None };
        (NextClosing::of(found, world.model.duration, evaluations), closing)
    };
    for contact in contacts {
        world.contacts[contact].found = GapClosing { closing, rearmed_at: None };
    }
    Some(next)
}

impl<'a> CollinearPair<'a> {
    fn of(world: &'a World, pair: usize, axial: AxialGap) -> Option<Self> {
        let [first, second] = world.pairs[pair].slots.map(|slot| Side::of(world, slot, axial.axis));
        let collinear = Self { world, pair: axial, sides: [first?, second?], drive: world.model.ground.drive() };
        collinear.is_bounded().then_some(collinear)
    }

    /// Whether the bound from the two separate motions is as sharp as that of [`relative_bounds`]: not for girders of
    /// equal dynamics and different mass, whose relative motion is bounded by one oscillator.
    fn is_bounded(&self) -> bool {
        match &self.sides {
            [Side::Flight { dof: a, .. }, Side::Flight { dof: b, .. }] => {
                a.oscillator == b.oscillator || !relative_bounds::alike([a, b])
            }
            _ => true,
        }
    }

    /// End of the first planned step of the sides; `None` where neither is in a step \[s\].
    fn first_step_end(&self) -> Option<f64> {
        let ends = self.sides.iter().filter_map(|side| match side {
            Side::Step { until, .. } => Some(*until),
            _ => None,
        });
        ends.min_by(f64::total_cmp)
    }

    /// Displacement and velocity of both sides \[m, m/s\].
    fn states(&self, t: f64) -> [[f64; 2]; 2] {
        let phase = self.world.model.ground.phase(t);
        [&self.sides[0], &self.sides[1]].map(|side| side.state(t, phase, self.drive))
    }

    fn moved(&self, t: f64) -> f64 {
        self.states(t).iter().map(|side| side[0].abs()).sum()
    }

    fn gap(&self, [a, b]: [[f64; 2]; 2]) -> [f64; 2] {
        let AxialGap { placed_gap, towards, .. } = self.pair;
        [placed_gap + towards * (a[0] - b[0]), towards * (a[1] - b[1])]
    }

    /// Closing from `t` to `until` where at least one side is in a planned step \[s\].
    fn in_step(&self, t: f64, until: f64, resolution: f64) -> Option<f64> {
        if until <= t {
            return None;
        }
        let sample = |t: f64| {
            let [gap, rate] = self.gap(self.states(t));
            GapSample { t, gap, rate }
        };
        let before = sample(t);
        let excursion: f64 = self.sides.iter().map(|side| side.excursion(t, until, self)).sum();
        if before.gap > excursion {
            return None;
        }
        if before.gap <= resolution && before.rate < 0.0 {
            return Some(t);
        }
        let curvature = self.curvature(t, until);
        let samples = [before, sample(until)];
        // Motion along one axis has neither stick nor slip, so that the time within a touch at which it is decided is
        // arbitrary.
        Subdivision::new((sample, |_: &GapSample, _| curvature, |_| 0.0), true, resolution, 0.0)
            .search(&samples)
            .closing
    }

    /// Bound on `|g̈|` from `t` to `until`.
    fn curvature(&self, t: f64, until: f64) -> f64 {
        if let [
            Side::Step { island: a, dense, components: [at, _], .. },
            Side::Step { island: b, components: [other, _], .. },
        ] = self.sides
            && a == b
        {
            return dense.difference_derivative_bounds(at..at + 1, other)[1];
        }
        let curvature = |side: &Side<'_>| match side {
            Side::Fixed => 0.0,
            Side::Flight { .. } => side.limits(t, until - t, self)[2],
            Side::Step { dense, components: [at, _], .. } => dense.derivative_bounds(*at..at + 1)[1],
        };
        self.sides.iter().map(curvature).sum()
    }

    /// Conservative advancement in flight from `t` to `until`, and the number of evaluations.
    fn in_flight(&self, [t, until]: [f64; 2], resolution: f64) -> (FirstZero, u64) {
        let duration = self.world.model.duration;
        let here = self.bounded_gap(t, duration);
        if here.out_of_reach {
            return (FirstZero::NoneUntil(duration), 1);
        }
        let mut evaluations = 1;
        let bounded_gap_at = |at: f64| {
            evaluations += 1;
            self.bounded_gap(at, until)
        };
        let found = first_crossing_from(here, bounded_gap_at, [t, until], true, resolution);
        (found, evaluations)
    }

    fn bounded_gap(&self, t: f64, until: f64) -> BoundedGap {
        let horizon = (until - t).max(f64::MIN_POSITIVE);
        let phase = self.world.model.ground.phase(t);
        let [a, b] = [&self.sides[0], &self.sides[1]].map(|side| (side.state(t, phase, self.drive), side));
        let [gap, rate] = self.gap([a.0, b.0]);
        let free = |(state, side): ([f64; 2], &Side<'_>)| side.free(state, phase, self.drive);
        let [reach, _, curvature] = match (a.1, b.1) {
            (Side::Flight { dof: first, push: p, .. }, Side::Flight { dof: second, push: q, .. }) => {
                relative_bounds::limits([first, second], [free(a), free(b)], [*p, *q], self.drive, horizon)
            }
            (Side::Flight { dof, push, .. }, _) => dof.limits(free(a), self.drive, *push, horizon),
            (_, Side::Flight { dof, push, .. }) => dof.limits(free(b), self.drive, *push, horizon),
            _ => [0.0; 3],
        };
        BoundedGap { gap, rate, curvature, window: horizon, out_of_reach: self.pair.placed_gap > reach }
    }
}

impl<'a> Side<'a> {
    /// Motion along the axis of the body in a slot; `None` where the body turns, moves across the axis, or has no
    /// uncoupled motion.
    fn of(world: &'a World, slot: Option<usize>, axis: usize) -> Option<Self> {
        let Some(slot) = slot else { return Some(Self::Fixed) };
        let track = &world.bodies[slot];
        match &track.now {
            Trajectory::Placed => None,
            Trajectory::Flight(flight) => {
                let straight = world.model.bodies[track.body].along(axis).is_some();
                let FlightAlong { dof, part, push } = straight.then(|| flight.along(axis)).flatten()?;
                Some(Self::Flight { dof, part, start: flight.start(), push })
            }
            &Trajectory::Island { island: number, index } => {
                let island = world.islands[number].as_ref()?;
                let StepAlong { dense, components, base } = island.along(index, axis)?;
                Some(Self::Step {
                    island: number,
                    dense,
                    components,
                    base,
                    from: island.step.from,
                    until: island.step.until,
                })
            }
        }
    }

    /// Displacement and velocity at `t` \[m, m/s\].
    fn state(&self, t: f64, phase: [f64; 2], drive: f64) -> [f64; 2] {
        match self {
            Self::Fixed => [0.0; 2],
            Self::Flight { dof, part, start, push } => {
                let [q, v] = dof.advance(*part, [*push, 0.0], t - start);
                let [steady, rate] = dof.steady(phase, drive);
                [q + steady, v + rate]
            }
            Self::Step { dense, components: [at, rate], base, .. } => {
                [base + dense.component(*at, t), dense.component(*rate, t)]
            }
        }
    }

    /// Free part of a state: the state less the steady response to the ground.
    fn free(&self, [q, v]: [f64; 2], phase: [f64; 2], drive: f64) -> [f64; 2] {
        let Self::Flight { dof, .. } = self else { return [q, v] };
        let [steady, rate] = dof.steady(phase, drive);
        [q - steady, v - rate]
    }

    /// Bounds on displacement, speed and acceleration of a side in flight from `t` to `t + horizon`.
    fn limits(&self, t: f64, horizon: f64, collinear: &CollinearPair<'_>) -> [f64; 3] {
        let Self::Flight { dof, push, .. } = self else { return [0.0; 3] };
        let phase = collinear.world.model.ground.phase(t);
        dof.limits(
            self.free(self.state(t, phase, collinear.drive), phase, collinear.drive),
            collinear.drive,
            *push,
            horizon,
        )
    }

    /// Bound on the displacement from `t` to `until` \[m\].
    fn excursion(&self, t: f64, until: f64, collinear: &CollinearPair<'_>) -> f64 {
        match self {
            Self::Fixed => 0.0,
            Self::Flight { .. } => self.limits(t, until - t, collinear)[1] * (until - t),
            Self::Step { dense, components: [at, _], from, .. } => {
                dense.displacement_bound(*at..at + 1) * if t > *from { 2.0 } else { 1.0 }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::model::coordinates::planar::PlanarState;
    use crate::dynamics::penalty3d::example::{free_to_turn, row, wall};
    use crate::dynamics::world::example::{in_flight, planned};

    const GAP: f64 = 1e-3;

    fn along(x: f64, speed: f64) -> PlanarState {
        [x, 0.0, 0.0, speed, 0.0, 0.0]
    }

    fn near(got: f64, expected: f64) {
        assert!((got - expected).abs() <= 1e-12 * expected.abs(), "{got} s is not {expected} s");
    }

    #[test]
    fn girders_in_flight_meet_after_their_gap_over_their_relative_speed() {
        for speeds in [[0.5, 0.0], [0.5, 0.2], [0.1, -0.4], [-0.1, -0.3]] {
            let mut world = in_flight(&row(), &[along(0.0, speeds[0]), along(GAP, speeds[1])]);
            let next = search(&mut world, 0, 0.0).expect("a pair on one axis");
            near(next.due, GAP / (speeds[0] - speeds[1]));
            for contact in world.pairs[0].contacts.clone() {
                assert_eq!(world.contacts[contact].found.closing, Some(next.due), "all nodes have one gap");
            }
        }
    }

    #[test]
    fn girders_that_part_or_are_too_slow_for_the_run_do_not_meet() {
        for speeds in [[0.0, 0.0], [-0.1, 0.1], [0.9 * GAP, 0.0]] {
            let mut world = in_flight(&row(), &[along(0.0, speeds[0]), along(GAP, speeds[1])]);
            let next = search(&mut world, 0, 0.0).expect("a pair on one axis");
            assert_eq!(next.due, f64::INFINITY, "within 1 s at {speeds:?} m/s");
            assert_eq!(world.contacts[0].found, GapClosing { closing: None, rearmed_at: None });
        }
    }

    #[test]
    fn a_girder_at_its_wall_closes_at_once_where_it_moves_in() {
        let mut world = in_flight(&wall(), &[along(0.0, 0.5)]);
        assert_eq!(search(&mut world, 0, 0.0).map(|next| next.due), Some(0.0));
        let mut world = in_flight(&wall(), &[along(0.0, -0.5)]);
        assert_eq!(search(&mut world, 0, 0.0).map(|next| next.due), Some(f64::INFINITY));
    }

    #[test]
    fn contacts_that_are_not_open_and_armed_and_motions_across_are_left_to_the_general_search() {
        let mut world = in_flight(&wall(), &[along(-GAP, 0.5)]);
        world.contacts[1].state = Contact::Open { armed: false };
        assert!(search(&mut world, 0, 0.0).is_none(), "a disarmed node");
        let mut closed = planned(&wall(), &[along(0.0, 0.5)]);
        assert!(search(&mut closed, 0, 0.0).is_none(), "closed nodes");
        for state in [[-GAP, 0.0, 0.1, 0.5, 0.0, 0.0], [-GAP, 0.0, 0.0, 0.5, 0.0, 0.2]] {
            let mut turning = in_flight(&free_to_turn(wall()), &[state]);
            assert!(search(&mut turning, 0, 0.0).is_none(), "a girder that is turned or turns: {state:?}");
        }
        let mut across = in_flight(&wall(), &[[-GAP, 0.0, 0.0, 0.5, 0.1, 0.0]]);
        assert!(search(&mut across, 0, 0.0).is_none(), "a girder that moves along its wall as well");
    }
}
