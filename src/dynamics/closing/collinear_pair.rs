//! When a pair closes next whose faces stand square to the one axis that its bodies move along: all of its nodes have one
//! gap, the difference of two coordinates, and one search finds them all.
//!
//! `g = g₀ ± (q_a − q_b)`. What bounds it is what bounds the two coordinates; how it is searched is as for any gap
//! ([`search`], [`subdivision`](crate::dynamics::locate::subdivision)). Pairs of which a side turns or moves across, or of which some contacts are
//! closed or behind the face, are for [`predict`](crate::dynamics::closing).

use crate::dynamics::closing::flight_view::horizon;
use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::free_flight::relative_bounds;
use crate::dynamics::free_flight::uncoupled_axis::UncoupledAxis;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::locate::advancement::{BoundedGap, FirstZero, first_crossing_from};
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::subdivision::{GapSample, Subdivision};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::world::World;
use crate::dynamics::world::axial_gap::AxialGap;
use crate::dynamics::world::tracks::Trajectory;

/// How one side moves along the axis.
enum Mover<'a> {
    /// An abutment.
    Stands,
    /// By one oscillator of its own; `part` is its free motion at `start`.
    Flies { dof: &'a UncoupledAxis, part: [f64; 2], start: f64, push: f64 },
    /// As place and rate of an island's planned step, from `from` to `until`, the place counted from `base`.
    Steps { island: usize, dense: &'a DenseOutput, components: [usize; 2], base: f64, from: f64, until: f64 },
}

/// Both sides of a pair.
struct Gauge<'a> {
    world: &'a World,
    pair: AxialGap,
    movers: [Mover<'a>; 2],
    drive: f64,
}

/// Searches a pair from `t` on and enters when its contacts close; when the pair is due, infinite when it is not \[s\].
/// Nothing where the pair is not in line, or its contacts are not all open.
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64) -> Option<NextClosing> {
    let whole = world.pairs[pair].axial?;
    let contacts = world.pairs[pair].contacts.clone();
    if !contacts.clone().all(|contact| world.contacts[contact].state == Contact::Open { armed: true }) {
        return None;
    }
    let gauge = Gauge::of(world, pair, whole)?;
    let resolution = RESOLUTION * (whole.size + gauge.moved(t));
    let (due, closing, looks) = match gauge.planned() {
        Some(until) => {
            let closing = gauge.in_step(t, until, resolution);
            (closing.unwrap_or(f64::INFINITY), closing, 0)
        }
        None => gauge.in_flight(t, resolution),
    };
    for contact in contacts {
        (world.contacts[contact].closing, world.contacts[contact].out) = (closing, None);
    }
    Some(NextClosing { due, looks, work: 0 })
}

impl<'a> Gauge<'a> {
    fn of(world: &'a World, pair: usize, whole: AxialGap) -> Option<Self> {
        let [first, second] = world.pairs[pair].slots.map(|slot| Mover::of(world, slot, whole.axis));
        let gauge = Self { world, pair: whole, movers: [first?, second?], drive: world.model.ground.drive() };
        gauge.is_bounded().then_some(gauge)
    }

    /// Whether [`relative`] bounds the difference by the two motions: like girders of other masses it knows better.
    fn is_bounded(&self) -> bool {
        match &self.movers {
            [Mover::Flies { dof: a, .. }, Mover::Flies { dof: b, .. }] => {
                a.oscillator == b.oscillator || !relative_bounds::alike([a, b])
            }
            _ => true,
        }
    }

    /// Where the first planned step of the sides ends; nothing when both fly or stand \[s\].
    fn planned(&self) -> Option<f64> {
        let ends = self.movers.iter().filter_map(|mover| match mover {
            Mover::Steps { until, .. } => Some(*until),
            _ => None,
        });
        ends.min_by(f64::total_cmp)
    }

    /// Displacement and speed of both sides.
    fn sides(&self, t: f64) -> [[f64; 2]; 2] {
        let phase = self.world.model.ground.phase(t);
        [&self.movers[0], &self.movers[1]].map(|mover| mover.state(t, phase, self.drive))
    }

    fn moved(&self, t: f64) -> f64 {
        self.sides(t).iter().map(|side| side[0].abs()).sum()
    }

    fn gap(&self, [a, b]: [[f64; 2]; 2]) -> [f64; 2] {
        let AxialGap { rest, towards, .. } = self.pair;
        [rest + towards * (a[0] - b[0]), towards * (a[1] - b[1])]
    }

    /// In planned steps, the first of which ends at `until`: when the gap closes.
    fn in_step(&self, t: f64, until: f64, resolution: f64) -> Option<f64> {
        if until <= t {
            return None;
        }
        let seen = |t: f64| {
            let [gap, rate] = self.gap(self.sides(t));
            GapSample { t, gap, rate }
        };
        let before = seen(t);
        let far: f64 = self.movers.iter().map(|mover| mover.excursion(t, until, self)).sum();
        if before.gap > far {
            return None;
        }
        if before.gap <= resolution && before.rate < 0.0 {
            return Some(t);
        }
        let bend = self.bend(t, until);
        let looks = [before, seen(until)];
        // What moves along one axis neither sticks nor slips: how it goes in makes no difference.
        Subdivision::new((seen, |_: &GapSample, _| bend, |_| 0.0), true, resolution, 0.0).first_closing(&looks)
    }

    /// Bound on `|g̈|` from `t` to `until`.
    fn bend(&self, t: f64, until: f64) -> f64 {
        if let [
            Mover::Steps { island: a, dense, components: [at, _], .. },
            Mover::Steps { island: b, components: [other, _], .. },
        ] = self.movers
            && a == b
        {
            return dense.difference_derivative_bounds(at..at + 1, other)[1];
        }
        let bend = |mover: &Mover<'_>| match mover {
            Mover::Stands => 0.0,
            Mover::Flies { .. } => mover.limits(t, until - t, self)[2],
            Mover::Steps { dense, components: [at, _], .. } => dense.derivative_bounds(*at..at + 1)[1],
        };
        self.movers.iter().map(bend).sum()
    }

    /// In flight: when the pair is due, when it closes if that is why, and how many looks it took.
    fn in_flight(&self, t: f64, resolution: f64) -> (f64, Option<f64>, u64) {
        let model = &self.world.model;
        let until = horizon(&model.ground, t, model.duration);
        let here = self.bounded_gap(t, model.duration);
        if here.out_of_reach {
            return (f64::INFINITY, None, 1);
        }
        let mut looks = 1;
        let ask = |at: f64| {
            looks += 1;
            self.bounded_gap(at, until)
        };
        match first_crossing_from(here, ask, [t, until], true, resolution) {
            FirstZero::Crossing(at) => (at, Some(at), looks),
            FirstZero::NoneUntil(at) if at >= model.duration => (f64::INFINITY, None, looks),
            FirstZero::NoneUntil(at) => (at, None, looks),
        }
    }

    fn bounded_gap(&self, t: f64, until: f64) -> BoundedGap {
        let horizon = (until - t).max(f64::MIN_POSITIVE);
        let phase = self.world.model.ground.phase(t);
        let [a, b] = [&self.movers[0], &self.movers[1]].map(|mover| (mover.state(t, phase, self.drive), mover));
        let [gap, rate] = self.gap([a.0, b.0]);
        let free = |(state, mover): ([f64; 2], &Mover<'_>)| mover.free(state, phase, self.drive);
        let [reach, _, curvature] = match (a.1, b.1) {
            (Mover::Flies { dof: first, push: p, .. }, Mover::Flies { dof: second, push: q, .. }) => {
                relative_bounds::limits([first, second], [free(a), free(b)], [*p, *q], self.drive, horizon)
            }
            (Mover::Flies { dof, push, .. }, _) => dof.limits(free(a), self.drive, *push, horizon),
            (_, Mover::Flies { dof, push, .. }) => dof.limits(free(b), self.drive, *push, horizon),
            _ => [0.0; 3],
        };
        BoundedGap { gap, rate, curvature, window: horizon, out_of_reach: self.pair.rest > reach }
    }
}

impl<'a> Mover<'a> {
    /// Nothing for one that is not in line with the axis, or has no such simple motion.
    fn of(world: &'a World, slot: Option<usize>, axis: usize) -> Option<Self> {
        let Some(slot) = slot else { return Some(Self::Stands) };
        let track = &world.bodies[slot];
        match (&track.now, &track.system) {
            (Trajectory::Flight(flight), Some(system)) => {
                let straight = world.model.bodies[track.body].along(axis).is_some();
                let (dof, part, push) = straight.then(|| system.along(flight, axis)).flatten()?;
                Some(Self::Flies { dof, part, start: flight.start(), push })
            }
            (&Trajectory::Island { island: number, index }, _) => {
                let island = world.islands[number].as_ref()?;
                let (dense, components, base) = island.along(index, axis)?;
                Some(Self::Steps { island: number, dense, components, base, from: island.from, until: island.until })
            }
            (Trajectory::Placed, _) | (Trajectory::Flight(_), None) => None,
        }
    }

    /// Displacement and speed at `t`.
    fn state(&self, t: f64, phase: [f64; 2], drive: f64) -> [f64; 2] {
        match self {
            Self::Stands => [0.0; 2],
            Self::Flies { dof, part, start, push } => {
                let [q, v] = dof.advance(*part, [*push, 0.0], t - start);
                let [steady, rate] = dof.steady(phase, drive);
                [q + steady, v + rate]
            }
            Self::Steps { dense, components: [at, rate], base, .. } => {
                [base + dense.component(*at, t), dense.component(*rate, t)]
            }
        }
    }

    /// The free part of a state.
    fn free(&self, [q, v]: [f64; 2], phase: [f64; 2], drive: f64) -> [f64; 2] {
        let Self::Flies { dof, .. } = self else { return [q, v] };
        let [steady, rate] = dof.steady(phase, drive);
        [q - steady, v - rate]
    }

    /// Displacement, speed and acceleration that one in flight does not exceed for so long from `t` on.
    fn limits(&self, t: f64, horizon: f64, gauge: &Gauge<'_>) -> [f64; 3] {
        let Self::Flies { dof, push, .. } = self else { return [0.0; 3] };
        let phase = gauge.world.model.ground.phase(t);
        dof.limits(self.free(self.state(t, phase, gauge.drive), phase, gauge.drive), gauge.drive, *push, horizon)
    }

    /// How far it goes at most from where it is at `t` \[m\].
    fn excursion(&self, t: f64, until: f64, gauge: &Gauge<'_>) -> f64 {
        match self {
            Self::Stands => 0.0,
            Self::Flies { .. } => self.limits(t, until - t, gauge)[1] * (until - t),
            Self::Steps { dense, components: [at, _], from, .. } => {
                dense.displacement_bound(*at..at + 1) * if t > *from { 2.0 } else { 1.0 }
            }
        }
    }
}
