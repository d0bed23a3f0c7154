//! Poses of a pair's bodies at the sample times of a planned step, and the errors and excursions of their contacts.

use std::cell::OnceCell;

use smallvec::SmallVec;

use crate::contact::{Frame, Local, gap, locate};
use crate::dynamics::closing::constants::{SPEED_ROUNDING, STEP_SAMPLES};
use crate::dynamics::closing::gap_curvature::GapCurvature;
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::sample_times::sample_times;
use crate::dynamics::locate::subdivision::GapSample;
use crate::dynamics::model::edge_node::{Edge, EdgeEnds};
use crate::dynamics::model::meeting::{Meeting, SectionPoses};
use crate::dynamics::world::World;
use crate::dynamics::world::site_geometry::SiteGeometry;
use crate::dynamics::world::tracks::{PairTrack, Trajectory};

/// Corners of two faces, which come before the edges of their pair.
const CORNERS: usize = 8;

/// Depth of an excursion of the gap below zero that is round-off at `t` \[m\].
pub(super) fn resolution(world: &World, contact: usize, t: f64) -> f64 {
    let track = &world.contacts[contact];
    let sides = track.slots.into_iter().zip(track.sections);
    let moved = sides.filter_map(|(slot, section)| Some(world.frame(slot?, section, t).shift.length()));
    resolution_of(world, contact, moved.sum())
}

/// Resolution of the gap of a contact whose bodies have `moved` together from their placed poses \[m\]: the round-off of positions grows
/// with that \[m\].
pub(in crate::dynamics) fn resolution_of(world: &World, contact: usize, moved: f64) -> f64 {
    RESOLUTION * (world.contacts[contact].geometry.size + moved)
}

/// Poses of a pair's bodies at the sample times of a planned step, shared by its contacts.
pub(super) struct StepSamples {
    pub times: [f64; STEP_SAMPLES],
    /// Poses at the first sample time: of both sides, then of the sections of corners.
    first: SmallVec<[Frame; 2]>,
    /// Poses at the other sample times; empty until needed.
    others: Vec<SmallVec<[Frame; 2]>>,
    pub slots: [Option<usize>; 2],
    sections: [usize; 2],
    /// Slots and sections of corners that are of other sections than their sides.
    of_corners: Vec<(usize, usize)>,
    turned: OnceCell<f64>,
    bounds: OnceCell<GapCurvature>,
    /// Corners of one pair relative to their faces, which several edges share: number of the first contact of the pair, then by contact
    /// and sample.
    corners: (usize, Vec<[Option<Local>; STEP_SAMPLES]>),
}

impl StepSamples {
    /// With the poses of the first sample time.
    pub(super) fn begin(world: &World, pair: usize, t: f64, until: f64) -> Self {
        let PairTrack { slots, sections, ref corner_sections, .. } = world.pairs[pair];
        let times = sample_times([t, until]);
        let first = Self::frames(world, (slots, sections), corner_sections, t);
        let (turned, bounds, others) = (OnceCell::new(), OnceCell::new(), Vec::new());
        let (of_corners, corners) = (corner_sections.clone(), (usize::MAX, Vec::new()));
        Self { times, first, others, slots, sections, of_corners, turned, bounds, corners }
    }

    /// Whether these are the poses of a pair's bodies in the planned step from `t` to `until`.
    pub(super) fn are_of(&self, world: &World, pair: usize, [t, until]: [f64; 2]) -> bool {
        let PairTrack { slots, sections, .. } = world.pairs[pair];
        let own = (self.slots, self.sections, self.times[0], self.times[STEP_SAMPLES - 1]);
        own == (slots, sections, t, until)
    }

    /// Computes the poses of the other sample times.
    pub(super) fn fill(&mut self, world: &World) {
        if !self.others.is_empty() {
            return;
        }
        let frames = |&t: &f64| Self::frames(world, (self.slots, self.sections), &self.of_corners, t);
        self.others.extend(self.times[1..].iter().map(frames));
    }

    fn frames(
        world: &World,
        (slots, sections): ([Option<usize>; 2], [usize; 2]),
        of_corners: &[(usize, usize)],
        t: f64,
    ) -> SmallVec<[Frame; 2]> {
        let still = Frame::fixed(glam::DVec3::ZERO);
        let sides = [0, 1].map(|side| slots[side].map_or(still, |slot| world.frame(slot, sections[side], t)));
        let corners = of_corners.iter().map(|&(slot, section)| world.frame(slot, section, t));
        sides.into_iter().chain(corners).collect()
    }

    /// Pose of one of the pair's bodies at sample `i`, of the section that faces the other.
    pub(super) fn side(&self, slot: Option<usize>, i: usize) -> &Frame {
        &self.at(i)[usize::from(slot == self.slots[1])]
    }

    fn at(&self, i: usize) -> &[Frame] {
        i.checked_sub(1).map_or(&self.first, |other| &self.others[other])
    }

    /// Pose of a section of the pair's bodies at sample `i`.
    fn section(&self, slot: usize, section: usize, i: usize) -> &Frame {
        let side = usize::from(Some(slot) == self.slots[1]);
        let of_corner = || self.of_corners.iter().position(|own| *own == (slot, section));
        let place = if self.sections[side] == section { side } else { of_corner().map_or(side, |own| 2 + own) };
        &self.at(i)[place]
    }

    /// Poses at the first sample time of the sections of the bodies of the pair, which have met.
    pub(super) fn met(&self, world: &World, meeting: &Meeting) -> [SectionPoses; 2] {
        [0, 1].map(|side| {
            let pose = |section: usize| match self.slots[side] {
                Some(slot) if section != self.sections[side] => world.frame(slot, section, self.times[0]),
                slot => *self.side(slot, 0),
            };
            meeting.solids[side].poses(pose)
        })
    }

    /// Poses of node's and face's body of a contact at sample `i`.
    pub(super) fn sides<'a>(&'a self, world: &'a World, contact: usize, i: usize) -> [&'a Frame; 2] {
        let track = &world.contacts[contact];
        let site = &world.model.sites[track.site];
        [0, 1].map(|which| track.slots[which].map_or(&site.stand, |slot| self.section(slot, track.sections[which], i)))
    }

    /// Bounds on the motion of the two bodies over the step, the same for all their contacts.
    pub(super) fn bounds(&self, world: &World) -> &GapCurvature {
        let of_step = || GapCurvature::of(world, self.slots, self.times[0], self.times[STEP_SAMPLES - 1]);
        self.bounds.get_or_init(of_step)
    }

    /// Bound on the rotation of the two bodies together within the step \[rad\].
    pub(super) fn turned(&self, world: &World) -> f64 {
        // The excursion at a lever is at least the rotation times the lever.
        let turned = |slot: usize| {
            let arm = world.model_body(slot).radius;
            excursion(world, slot, arm, self.times[0], self.times[STEP_SAMPLES - 1]) / arm
        };
        *self.turned.get_or_init(|| self.slots.into_iter().flatten().map(turned).sum())
    }

    /// Depth of an excursion of the gap below zero that is round-off at the first sample time \[m\].
    pub(super) fn resolution(&self, world: &World, contact: usize) -> f64 {
        let track = &world.contacts[contact];
        let moved: f64 = track.slots.into_iter().flatten().map(|slot| self.side(Some(slot), 0).shift.length()).sum();
        resolution_of(world, contact, moved)
    }

    pub(super) fn local(&self, world: &World, contact: usize, i: usize) -> Local {
        let (site, [node, face]) = (world.site(contact), self.sides(world, contact, i));
        locate(&site.geometry, node, face)
    }

    /// Ends of the edge of an edge node relative to its face at sample `i`.
    pub(super) fn edge_ends(&mut self, world: &World, (contact, edge): (usize, &Edge), i: usize) -> EdgeEnds {
        let Some(corners) = world.contacts[contact].corners else {
            let [node, face] = self.sides(world, contact, i);
            return edge.ends(node, face);
        };
        edge.ends_at(corners.map(|corner| self.corner(world, corner, i)))
    }

    /// A corner relative to its face at sample `i`, computed once.
    pub(super) fn corner(&mut self, world: &World, contact: usize, i: usize) -> Local {
        let from = world.pair_of(contact).contacts.start;
        if self.corners.0 != from {
            self.corners.0 = from;
            self.corners.1.clear();
        }
        let own = contact - from;
        if self.corners.1.len() <= own {
            self.corners.1.reserve_exact(CORNERS.saturating_sub(self.corners.1.len()));
            self.corners.1.resize(own + 1, [None; STEP_SAMPLES]);
        }
        if let Some(known) = self.corners.1[own][i] {
            return known;
        }
        let here = self.local(world, contact, i);
        self.corners.1[own][i] = Some(here);
        here
    }

    /// Gap and rate of a contact at sample `i`.
    pub(super) fn gap(&self, world: &World, contact: usize, i: usize) -> GapSample {
        let (site, [node, face]) = (world.site(contact), self.sides(world, contact, i));
        let [gap, rate] = gap(&site.geometry, node, face);
        GapSample { t: self.times[i], gap, rate }
    }
}

/// Error bound of the rate of a contact's gap \[m/s\]: the tolerance of the run, at least round-off, times the speeds
/// of node and face.
pub(super) fn rate_error(world: &World, contact: usize, sides: [&Frame; 2]) -> f64 {
    let SiteGeometry { arm, lever, .. } = world.contacts[contact].geometry;
    let speed = |(side, arm): (&Frame, f64)| side.velocity.length() + side.spin.length() * arm;
    world.model.tolerance.max(SPEED_ROUNDING) * sides.into_iter().zip([arm, lever]).map(speed).sum::<f64>()
}

/// Bound on the displacement of a point at `arm` \[m\] from a body's G from `from` to `until` \[m\]; infinite where
/// no bound holds.
pub(super) fn excursion(world: &World, slot: usize, arm: f64, from: f64, until: f64) -> f64 {
    match &world.bodies[slot].now {
        Trajectory::Placed => f64::INFINITY,
        Trajectory::Island { island, index } => {
            world.islands[*island].as_ref().map_or(0.0, |island| island.excursion(&world.model, *index, arm, from))
        }
        Trajectory::Flight(flight) => {
            let bound = flight.bounds(from, until - from);
            if bound.window < until - from {
                return f64::INFINITY;
            }
            (bound.speed + bound.spin * arm) * (until - from)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::model::coordinates::planar::PlanarState;
    use crate::dynamics::penalty3d::example::{SPEED, free_to_turn, wall};
    use crate::dynamics::world::example::{in_flight, planned};

    /// A girder that hits its wall, slides along it and turns.
    const HIT: PlanarState = [0.0, 0.0, 0.0, SPEED, 0.1, 2.0];

    fn hit() -> (World, [f64; 2]) {
        let world = planned(&free_to_turn(wall()), &[HIT]);
        let step = &world.islands[0].as_ref().expect("an island").step;
        let span = [step.from, step.until];
        (world, span)
    }

    #[test]
    fn samples_are_at_equal_intervals_and_have_the_poses_of_their_times() {
        let (world, [t, until]) = hit();
        let mut samples = StepSamples::begin(&world, 0, t, until);
        samples.fill(&world);
        for i in 0..STEP_SAMPLES {
            let at = t + (until - t) * i as f64 / (STEP_SAMPLES - 1) as f64;
            assert!((samples.times[i] - at).abs() <= 1e-15 * until, "sample {i}");
            assert_eq!(*samples.side(Some(0), i), world.frame(0, 0, samples.times[i]));
            for contact in [0, 1] {
                assert_eq!(samples.corner(&world, contact, i), world.local(contact, samples.times[i]));
                let local = world.local(contact, samples.times[i]);
                let sample = samples.gap(&world, contact, i);
                assert_eq!((sample.gap, sample.rate), (local.gap, local.gap_rate));
            }
        }
        assert!(samples.are_of(&world, 0, [t, until]));
        assert!(!samples.are_of(&world, 0, [t, 0.5 * until]), "another stretch");
    }

    #[test]
    fn no_point_of_a_body_goes_farther_in_a_step_than_its_excursion() {
        let (world, [t, until]) = hit();
        for arm in [0.0, 0.1, 1.0] {
            let bound = excursion(&world, 0, arm, t, until);
            let at = |t: f64| {
                let frame = world.frame(0, 0, t);
                frame.shift + frame.turn(glam::DVec3::new(0.6, -0.8, 0.0) * arm)
            };
            let way = (at(until) - at(t)).length();
            assert!(way <= bound && bound < 3.0 * way, "{way} m of at most {bound} m at {arm} m");
        }
    }

    #[test]
    fn in_flight_the_excursion_is_the_way_at_the_speed_and_as_placed_there_is_no_bound() {
        let mut world = in_flight(&free_to_turn(wall()), &[[0.0, 0.0, 0.0, 0.3, 0.4, 2.0]]);
        let bound = excursion(&world, 0, 0.1, 0.1, 0.3);
        assert!((bound - 0.2 * (0.5 + 2.0 * 0.1)).abs() < 1e-12, "{bound} m");
        world.bodies[0].now = Trajectory::Placed;
        assert_eq!(excursion(&world, 0, 0.1, 0.1, 0.3), f64::INFINITY);
    }

    #[test]
    fn the_error_of_a_rate_is_the_tolerance_times_the_speeds_of_node_and_face() {
        let world = in_flight(&free_to_turn(wall()), &[[0.0, 0.0, 0.0, 0.3, 0.4, 2.0]]);
        let [node, face] = [world.side(0, 0, 0.0), world.side(0, 1, 0.0)];
        let arm = 0.095_f64.hypot(0.035);
        let error = rate_error(&world, 0, [&node, &face]);
        assert!((error / (1e-12 * (0.5 + 2.0 * arm)) - 1.0).abs() < 1e-12, "{error} m/s at a tolerance of 1e-12");
    }

    #[test]
    fn what_rounds_grows_with_the_distance_from_where_bodies_were_placed() {
        let world = in_flight(&wall(), &[[0.0, 0.0, 0.0, 0.3, 0.4, 0.0]]);
        let [placed, moved] = [0.0, 0.5].map(|t| resolution(&world, 0, t));
        assert!((moved - placed - RESOLUTION * 0.25).abs() < 1e-9 * moved, "0.25 m at 0.5 m/s");
    }
}
