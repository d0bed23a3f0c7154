//! Gaps of a pair at an instant with `ġ` and `g̈`, and bounds on `g̈` and `g⃛` from there on.
//!
//! In flight without a record the acceleration is known and the bounds of [`MotionLimits`] hold for all later times. Under a
//! record, where bearings couple the directions, and in a planned step of lasting contact the bounds of [`MotionBounds`] hold
//! for a window, and the third derivative has none.

use crate::dynamics::free_flight::relative_bounds::{BodyInFlight, GirderInFlight, RelativeBounds};
use crate::dynamics::impact2d::closing::motion_limits::{FlyingBody, MotionLimits, relative_limits};
use crate::dynamics::impact2d::closing::planar_gap::{PlanarPose, PlanarSite, RelativeNode};
use crate::dynamics::impact2d::constants::SHARED_BOUNDS;
use crate::dynamics::impact2d::world::World;
use crate::dynamics::locate::advancement::BoundedGap;
use crate::dynamics::locate::cubic_bound::CubicBound;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::world::site_geometry::SiteGeometry;

/// Poses of the sides of a pair at `t`.
pub(in crate::dynamics::impact2d) fn poses(world: &World, slots: [Option<usize>; 2], t: f64) -> [PlanarPose; 2] {
    slots.map(|slot| slot.map_or(PlanarPose::STILL, |slot| PlanarPose::of(&world.state(slot, t))))
}

/// Bounds on the motions of both sides, each and relative to the other.
#[derive(Clone, Copy, Debug)]
struct PairLimits {
    sides: [MotionLimits; 2],
    /// Of the difference of both G.
    relative: [f64; 4],
    /// Further instants for which these bounds are used.
    uses: u32,
}

impl PairLimits {
    /// Of sides in closed form.
    fn of(flying: &[Option<FlyingBody<'_>>; 2]) -> Self {
        let sides = [0, 1].map(|side| flying[side].as_ref().and_then(FlyingBody::limits).unwrap_or_default());
        let relative = match flying {
            [Some(a), Some(b)] => relative_limits(a, b).unwrap_or_default(),
            _ => std::array::from_fn(|k| sides[0].translation[k] + sides[1].translation[k]),
        };
        let lasts = flying.iter().flatten().all(FlyingBody::is_bound);
        Self { sides, relative, uses: if lasts { SHARED_BOUNDS } else { 0 } }
    }
}

/// Both sides of a pair at an instant, with bounds on their motions.
pub(in crate::dynamics::impact2d) struct PairMotion {
    pub poses: [PlanarPose; 2],
    limits: PairLimits,
    accelerations: Option<[[f64; 3]; 2]>,
    /// Time for which the bounds hold \[s\].
    pub window: f64,
}

impl PairMotion {
    /// Both sides at `t`, with bounds up to `until`, which is not behind the end of a planned step.
    pub(in crate::dynamics::impact2d) fn of(world: &World, slots: [Option<usize>; 2], t: f64, until: f64) -> Self {
        Self::with(world, slots, [t, until], None)
    }

    /// A later instant of the same flights.
    pub(in crate::dynamics::impact2d) fn next(
        &self,
        world: &World,
        slots: [Option<usize>; 2],
        t: f64,
        until: f64,
    ) -> Self {
        let limits = PairLimits { uses: self.limits.uses.saturating_sub(1), ..self.limits };
        Self::with(world, slots, [t, until], (limits.uses > 0).then_some(limits))
    }

    fn with(world: &World, slots: [Option<usize>; 2], [t, until]: [f64; 2], known: Option<PairLimits>) -> Self {
        let horizon = (until - t).max(f64::MIN_POSITIVE);
        let flying = slots.map(|slot| slot.and_then(|slot| FlyingBody::of(world, slot, t, horizon)));
        let pose = |side: usize| match (&flying[side], slots[side]) {
            (Some(flying), _) => PlanarPose::of(&flying.state),
            (None, Some(slot)) => PlanarPose::of(&world.state(slot, t)),
            (None, None) => PlanarPose::STILL,
        };
        let poses = [pose(0), pose(1)];
        let stepping = slots.map(|slot| slot.and_then(|slot| world.planned_bounds(slot)));
        if stepping != [None; 2] || !flying.iter().flatten().all(|side| side.uncoupled().is_some()) {
            return Self::without_jerk(poses, &flying, stepping, t, horizon);
        }
        let limits = known.unwrap_or_else(|| PairLimits::of(&flying));
        let acceleration = |side: usize| flying[side].as_ref().and_then(FlyingBody::acceleration).unwrap_or_default();
        Self { poses, limits, accelerations: Some([acceleration(0), acceleration(1)]), window: horizon }
    }

    /// Sides whose jerk has no bound; `stepping` bounds those in planned steps.
    fn without_jerk(
        poses: [PlanarPose; 2],
        flying: &[Option<FlyingBody<'_>>; 2],
        stepping: [Option<MotionBounds>; 2],
        t: f64,
        horizon: f64,
    ) -> Self {
        let moving = [0, 1].map(|side| match (&flying[side], stepping[side]) {
            (Some(s), _) => {
                let girder = GirderInFlight { free_motion: s.free_motion, state: s.state, free: s.free };
                Some(BodyInFlight { bound: s.bound(t), girder: Some(girder) })
            }
            (None, stepping) => stepping.map(|bound| BodyInFlight { bound, girder: None }),
        });
        let apart = RelativeBounds::of(&moving, horizon);
        let sides = [0, 1]
            .map(|side| moving[side].as_ref().map_or(MotionLimits::default(), |body| MotionLimits::of(&body.bound)));
        let relative = [apart.reach, apart.speed, apart.acceleration, f64::INFINITY];
        let window = apart.window.min(horizon);
        Self { poses, limits: PairLimits { sides, relative, uses: 0 }, accelerations: None, window }
    }

    /// Displacement of both sides, by which their places round \[m\].
    pub(in crate::dynamics::impact2d) fn displacement(&self) -> f64 {
        self.poses[0].shift.length() + self.poses[1].shift.length()
    }

    /// Whether neither side turns while the bounds hold: points of one face keep their distances.
    pub(in crate::dynamics::impact2d) fn is_translation(&self) -> bool {
        self.accelerations.is_some() && self.poses.iter().all(|pose| pose.spin == 0.0) && {
            let turns = |side: &MotionLimits| side.rotation[1] != 0.0 || side.rotation[2] != 0.0;
            !self.limits.sides.iter().any(turns)
        }
    }

    /// Gap of a contact plus `depth` \[m\], its rate and the bound on `g̈`; with a known `g̈` also the bound by `|g⃛|`.
    pub(in crate::dynamics::impact2d) fn bounded_gap(
        &self,
        site: &PlanarSite,
        spot: &SiteGeometry,
        sides: [Option<usize>; 2],
        depth: f64,
    ) -> (BoundedGap, Option<CubicBound>) {
        let node_now = RelativeNode::of(site, sides, &self.poses);
        let [gap, rate] = node_now.gap(site);
        let rotation = |which: usize| sides[which].map_or([0.0; 4], |side| self.limits.sides[side].rotation);
        let (node, face, relative) = (rotation(0), rotation(1), &self.limits.relative);
        // r from the face's G to the node: its length, and bounds on its derivatives.
        let r = spot.lever + relative[0] + node[0] * spot.arm;
        let r1 = relative[1] + node[1] * spot.arm;
        let r2 = relative[2] + (node[2] + node[1] * node[1]) * spot.arm;
        // g = n·r, and n turns with the face.
        let bend2 = face[2] + face[1] * face[1];
        let curvature = r2 + bend2 * r + 2.0 * face[1] * r1;
        let moved = relative[0] + node[0] * spot.arm + face[0] * r;
        let bounded_gap = BoundedGap {
            gap: gap + depth,
            rate,
            curvature,
            window: self.window,
            out_of_reach: spot.placed_gap > moved,
        };
        let Some(accelerations) = self.accelerations else { return (bounded_gap, None) };
        let third = |turn: [f64; 4]| turn[3] + turn[1] * (3.0 * turn[2] + turn[1] * turn[1]);
        let jerk = relative[3] + third(node) * spot.arm + third(face) * r + 3.0 * (bend2 * r1 + face[1] * r2);
        let of = |which: usize| sides[which].map_or([0.0; 3], |side| accelerations[side]);
        let bend = node_now.second_derivative([of(0), of(1)]);
        (bounded_gap, Some(CubicBound { gap: gap + depth, rate, bend, jerk }))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::dynamics::impact2d::closing::planar_gap::gap;
    use crate::dynamics::impact2d::example;
    use crate::dynamics::impact2d::run::ImpactRun;

    fn world(preset: &str) -> World {
        example::world(example::preset(preset, |scene| {
            scene.girders[0].initial.velocity = [0.1, -0.1, 0.0];
            scene.girders[0].initial.spin_deg_s = 60.0;
        }))
    }

    #[test]
    fn the_gap_stays_above_its_bounds() {
        for preset in ["straight-abutment", "skew60-abutment"] {
            let world = world(preset);
            let slots = world.pairs[0].slots;
            for start in [0.0, 0.05, 0.21] {
                let motion = PairMotion::of(&world, slots, start, start + 1.0);
                for site in &world.sites {
                    let (bounded_gap, cubic) = motion.bounded_gap(&site.geometry, &site.spot, site.sides, 0.0);
                    let cubic = cubic.expect("uncoupled bearings");
                    for k in 1..200 {
                        let tau = 2e-3 * f64::from(k);
                        let [now, _] = gap(&site.geometry, site.sides, &poses(&world, slots, start + tau));
                        let parabola = bounded_gap.gap + tau * (bounded_gap.rate - 0.5 * tau * bounded_gap.curvature);
                        let third = cubic.gap + tau * (cubic.rate + tau * (0.5 * cubic.bend - tau * cubic.jerk / 6.0));
                        assert!(now >= parabola - 1e-14, "{preset}: {now} below {parabola} after {tau} s");
                        assert!(now >= third - 1e-14, "{preset}: {now} below {third} after {tau} s");
                    }
                }
            }
        }
    }

    #[test]
    fn the_gap_stays_above_its_bounds_in_a_planned_step() {
        // A face that slides along its wall and one that turns about a corner: the closed form and the integrator.
        for spin in [0.0, -40.0] {
            let model = example::at_wall(|scene| {
                scene.impact.restitution_normal = 0.0;
                scene.girders[0].initial.velocity = [0.0, 0.2, 0.0];
                scene.girders[0].initial.spin_deg_s = spin;
                scene.girders[0].push.force = [60.0, 0.0, 0.0];
            });
            let run = ImpactRun::new(&Arc::new(model), 0);
            let world = &run.world;
            let slots = world.pairs[0].slots;
            let end = world.planned_end(0).expect("a planned step");
            let motion = PairMotion::of(world, slots, 0.0, end);
            let mut moved: f64 = 0.0;
            for site in &world.sites {
                let (bounded_gap, cubic) = motion.bounded_gap(&site.geometry, &site.spot, site.sides, 0.0);
                assert_eq!(cubic, None, "no bound on the third derivative");
                for k in 1..=200 {
                    let tau = end * f64::from(k) / 200.0;
                    let poses = poses(world, slots, tau);
                    let [now, _] = gap(&site.geometry, site.sides, &poses);
                    let parabola = bounded_gap.gap + tau * (bounded_gap.rate - 0.5 * tau * bounded_gap.curvature);
                    assert!(now >= parabola - 1e-12, "spin {spin}°/s: {now} below {parabola} after {tau} s");
                    moved = moved.max(poses[0].shift.length() + poses[1].shift.length());
                }
            }
            assert!(moved > 1e-5, "spin {spin}°/s: it moves, by {moved} m in {end} s");
        }
    }

    #[test]
    fn the_bounds_of_later_instants_are_shared_a_few_times_and_stay_valid() {
        let world = world("straight-abutment");
        let slots = world.pairs[0].slots;
        let mut motion = PairMotion::of(&world, slots, 0.0, 1.0);
        assert_eq!(motion.limits.uses, SHARED_BOUNDS, "bearings in every direction");
        let first = motion.limits.relative;
        for k in 1..SHARED_BOUNDS {
            motion = motion.next(&world, slots, 0.01 * f64::from(k), 1.0);
            assert_eq!(motion.limits.relative, first, "shared");
        }
        motion = motion.next(&world, slots, 0.1, 1.0);
        assert_ne!(motion.limits.relative, first, "computed anew");
    }
}
