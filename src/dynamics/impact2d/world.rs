//! State of one group of bodies during a run of the impact model: poses, contact points, touching pairs.

use std::sync::Arc;

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::free_flight::flight::FreeMotion;
use crate::dynamics::impact2d::closing::planar_gap::PlanarSite;
use crate::dynamics::impact2d::constants::{IMPACT_SPEED_ROUNDING, KEPT_TOUCH, LEAST_NORMAL_DRIFT, TOUCH};
use crate::dynamics::impact2d::delassus::ContactPoint;
use crate::dynamics::impact2d::lasting::lasting_contact::LastingContact;
use crate::dynamics::impact2d::tracks::{BodyTrack, PairTrack, SiteTrack, Trajectory};
use crate::dynamics::impact2d::{GirderState, InlineVec};
use crate::dynamics::model::coordinates::planar::{self, PlanarState, WIDTH};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::world::site_geometry::SiteGeometry;

/// Bodies, pairs and declared contacts of a group, with their motions in force. A *slot* is the place of a body here.
#[derive(Debug)]
pub(in crate::dynamics::impact2d) struct World {
    pub model: Arc<Model>,
    pub bodies: Vec<BodyTrack>,
    /// Rising in their numbers in the model.
    pub pairs: Vec<PairTrack>,
    /// Rising in their numbers in the model.
    pub sites: Vec<SiteTrack>,
    pub lasting: Vec<Option<LastingContact>>,
    /// Largest speed of any point of a body so far \[m/s\].
    pub peak_speed: f64,
    /// Largest displacement of any point of a body so far \[m\].
    pub peak_displacement: f64,
}

impl World {
    /// A group at t = 0, by its number in the model, every body in free flight.
    pub(in crate::dynamics::impact2d) fn new(model: &Arc<Model>, group: usize) -> Self {
        let mut world = Self {
            model: Arc::clone(model),
            bodies: model.groups[group].bodies.iter().map(|&body| body_track(model, body)).collect(),
            pairs: Vec::new(),
            sites: Vec::new(),
            lasting: Vec::new(),
            peak_speed: 0.0,
            peak_displacement: 0.0,
        };
        for &pair in &model.groups[group].pairs {
            world.add_pair(pair);
        }
        world
    }

    fn add_pair(&mut self, number: usize) {
        let model = Arc::clone(&self.model);
        let pair = &model.pairs[number];
        let slots = pair.bodies.map(|side| side.and_then(|b| self.slot(b)));
        let from = self.sites.len();
        self.sites.extend(pair.sites.clone().map(|site| site_track(&model, site)));
        for slot in slots.into_iter().flatten() {
            self.bodies[slot].pairs.push(self.pairs.len());
        }
        self.pairs.push(PairTrack { number, slots, sites: from..self.sites.len(), impact_due: false });
    }

    fn slot(&self, body: usize) -> Option<usize> {
        self.bodies.binary_search_by_key(&body, |track| track.body).ok()
    }

    /// Slots of bodies by their numbers in the model.
    pub(in crate::dynamics::impact2d) fn slots(&self, bodies: &[usize]) -> InlineVec<usize> {
        bodies.iter().filter_map(|&body| self.slot(body)).collect()
    }

    /// Index of a declared contact by its number in the model.
    pub(in crate::dynamics::impact2d) fn site(&self, number: usize) -> Option<usize> {
        self.sites.binary_search_by_key(&number, |site| site.number).ok()
    }

    /// Index of a pair by its number in the model.
    pub(in crate::dynamics::impact2d) fn pair(&self, number: usize) -> Option<usize> {
        self.pairs.binary_search_by_key(&number, |pair| pair.number).ok()
    }

    /// Names of bodies by their numbers in the model.
    pub(in crate::dynamics::impact2d) fn names(&self, bodies: &[usize]) -> String {
        bodies.iter().map(|&b| self.model.bodies[b].name.as_str()).collect::<Vec<_>>().join(", ")
    }

    /// Pairs of these bodies, each once, rising.
    pub(in crate::dynamics::impact2d) fn pairs_of(&self, slots: &[usize]) -> InlineVec<usize> {
        let mut pairs: InlineVec<usize> =
            slots.iter().flat_map(|&slot| self.bodies[slot].pairs.iter().copied()).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    /// Pairs of which every body is among these slots, rising.
    pub(in crate::dynamics::impact2d) fn pairs_within(&self, slots: &[usize]) -> InlineVec<usize> {
        let inside = |slot: Option<usize>| slot.is_none_or(|slot| slots.binary_search(&slot).is_ok());
        let mut pairs = self.pairs_of(slots);
        pairs.retain(|pair| self.pairs[*pair].slots.into_iter().all(inside));
        pairs
    }

    /// End of the planned step of a body; none in free flight \[s\].
    pub(in crate::dynamics::impact2d) fn planned_end(&self, slot: usize) -> Option<f64> {
        match self.bodies[slot].motion {
            Trajectory::Lasting(number, _) => self.lasting[number].as_ref().map(|contact| contact.until),
            Trajectory::Flight(_) => None,
        }
    }

    /// Bounds on the motion of a body in its planned step; none in free flight.
    pub(in crate::dynamics::impact2d) fn planned_bounds(&self, slot: usize) -> Option<MotionBounds> {
        match self.bodies[slot].motion {
            Trajectory::Lasting(number, place) => self.lasting[number].as_ref().map(|contact| contact.bounds(place)),
            Trajectory::Flight(_) => None,
        }
    }

    /// Makes a flight under a record keep the states from which it is evaluated up to `until`.
    pub(in crate::dynamics::impact2d) fn remember(&mut self, slot: usize, until: f64) {
        let track = &mut self.bodies[slot];
        if let Trajectory::Flight(flight) = &mut track.motion {
            track.free_motion.remember(flight, until);
        }
    }

    /// State of a body at `t` on the motion in force.
    pub(in crate::dynamics::impact2d) fn state(&self, slot: usize, t: f64) -> PlanarState {
        let track = &self.bodies[slot];
        match &track.motion {
            Trajectory::Flight(flight) => track.free_motion.state(flight, t),
            Trajectory::Lasting(number, place) => {
                self.lasting[*number].as_ref().map_or([0.0; WIDTH], |contact| contact.state(*place, t))
            }
        }
    }

    fn frame(&self, slot: usize, t: f64) -> Frame {
        self.model.bodies[self.bodies[slot].body].planar_frame(&self.state(slot, t))
    }

    /// Includes a state in the largest speed and displacement.
    pub(in crate::dynamics::impact2d) fn update_peaks(&mut self, slot: usize, state: &PlanarState) {
        let radius = self.model.bodies[self.bodies[slot].body].radius;
        let farthest = |v: DVec3| v.x.hypot(v.y) + radius * v.z.abs();
        self.peak_speed = self.peak_speed.max(farthest(planar::rates(state)));
        self.peak_displacement = self.peak_displacement.max(farthest(planar::positions(state)));
    }

    /// Radius of the smaller girder of a pair \[m\].
    pub(in crate::dynamics::impact2d) fn radius(&self, pair: usize) -> f64 {
        let radius = |slot: usize| self.model.bodies[self.bodies[slot].body].radius;
        self.pairs[pair].slots.into_iter().flatten().map(radius).fold(f64::INFINITY, f64::min)
    }

    /// A declared contact at `t` on the motions in force.
    pub(in crate::dynamics::impact2d) fn point(&self, site: usize, pair: usize, t: f64) -> ContactPoint {
        let slots = self.pairs[pair].slots;
        let still = Frame::fixed(DVec3::ZERO);
        let frames = slots.map(|slot| slot.map_or(still, |slot| self.frame(slot, t)));
        let places = slots.map(|slot| slot.map(|_| 0));
        ContactPoint::of(&self.model, self.sites[site].number, places, [&frames[0], &frames[1]])
    }

    /// Whether a point lies on its face: gap within [`TOUCH`], foot on the face.
    pub(in crate::dynamics::impact2d) fn touches(&self, site: usize, pair: usize, point: &ContactPoint) -> bool {
        if self.sites[site].beside.is_some() {
            return false;
        }
        let near = TOUCH * self.radius(pair);
        let reached = point.gap.abs() <= near || (self.sites[site].kept && point.gap.abs() <= KEPT_TOUCH * near);
        reached && point.inset >= -near
    }

    /// Arms the points of a pair that are in front of their face at `t`.
    pub(in crate::dynamics::impact2d) fn arm_in_front(&mut self, pair: usize, t: f64) {
        for site in self.pairs[pair].sites.clone() {
            let track = &mut self.sites[site];
            if let Some(at) = track.in_front_at.take_if(|at| *at <= t) {
                track.arm(at);
            }
        }
    }

    /// Takes up the corners of the other side that a corner passes as it leaves its face over an edge at `t`: they are at their face from then
    /// on, where they had been beside it.
    pub(in crate::dynamics::impact2d) fn take_up_passed(&mut self, pair: usize, left: usize, t: f64) {
        let near = TOUCH * self.radius(pair);
        for site in self.pairs[pair].sites.clone().filter(|&site| site != left) {
            let point = self.point(site, pair, t);
            if point.gap.abs() <= near && point.inset.abs() <= near {
                self.sites[site].arm(t);
            }
        }
    }

    /// Whether any declared contact of a pair touches at `t`.
    pub(in crate::dynamics::impact2d) fn pair_touches(&self, pair: usize, t: f64) -> bool {
        self.pairs[pair].sites.clone().any(|site| self.touches(site, pair, &self.point(site, pair, t)))
    }

    /// Whether all of these declared contacts, by their numbers in the model, are in lasting contact.
    pub(in crate::dynamics::impact2d) fn are_kept(&self, sites: &[usize]) -> bool {
        sites.iter().all(|&number| self.site(number).is_some_and(|site| self.sites[site].kept))
    }

    /// Normal speed that a kept point may gather from the error of the integrator, at an instant with this round-off of speeds \[m/s\].
    pub(in crate::dynamics::impact2d) fn normal_drift(&self, speed_noise: f64) -> f64 {
        self.model.tolerance.max(LEAST_NORMAL_DRIFT) / IMPACT_SPEED_ROUNDING * speed_noise
    }
}

fn body_track(model: &Model, body: usize) -> BodyTrack {
    let free_motion = Arc::new(FreeMotion::new(&model.bodies[body], &model.ground, model.duration));
    let initial = model.bodies[body].initial();
    let state: PlanarState = std::array::from_fn(|i| initial[i]);
    let motion = Trajectory::Flight(free_motion.fly(0.0, state));
    let (segments, pairs) = (Vec::new(), Vec::new());
    let [.., theta, _, _, spin] = state;
    let at_start = if theta != 0.0 || spin != 0.0 { GirderState::FreeTurning } else { GirderState::Free };
    BodyTrack { body, free_motion, motion, segments, since: 0.0, state: at_start, pairs }
}

fn site_track(model: &Model, site: usize) -> SiteTrack {
    let contact = &model.sites[site];
    let pair = &model.pairs[contact.pair];
    let side = |owner: Option<usize>| owner.map(|b| usize::from(pair.bodies[0] != Some(b)));
    let spot = SiteGeometry::of(model, site);
    SiteTrack {
        number: site,
        sides: [side(contact.node_body), side(contact.face_body)],
        depth: 0.0,
        spot,
        geometry: PlanarSite::of(model, site),
        kept: false,
        armed: true,
        lifted: false,
        beside: None,
        was_beside: Vec::new(),
        in_front_at: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;

    fn world(gap: f64) -> World {
        example::world(example::preset("straight-abutment", |scene| scene.abutments[0].gap = Some(gap)))
    }

    #[test]
    fn a_point_touches_within_a_billionth_of_the_girder_and_a_kept_one_within_a_millionth() {
        let radius = world(0.0).radius(0);
        for (parts, kept, touches) in [(0.5, false, true), (2.0, false, false), (2.0, true, true), (2e3, true, false)] {
            let mut world = world(parts * TOUCH * radius);
            world.sites.iter_mut().for_each(|site| site.kept = kept);
            assert_eq!(world.pair_touches(0, 0.0), touches, "{parts} × 1e-9, kept: {kept}");
        }
        let mut beside = world(0.0);
        beside.sites.iter_mut().for_each(|site| site.beside = Some(0.0));
        assert!(!beside.pair_touches(0, 0.0), "beside the face");
    }

    #[test]
    fn numbers_of_the_model_are_found_and_others_are_not() {
        let world = world(0.0);
        for (i, site) in world.sites.iter().enumerate() {
            assert_eq!(world.site(site.number), Some(i), "declared contact {i}");
        }
        assert_eq!((world.pair(0), world.pair(7), world.site(999)), (Some(0), None, None), "pairs");
        assert_eq!(world.slots(&[0, 5])[..], [0], "no such body");
    }

    #[test]
    fn peaks_include_rotation_at_the_farthest_corner() {
        let mut world = world(0.0);
        world.update_peaks(0, &[0.03, 0.04, 0.1, 0.0, 0.0, 2.0]);
        let radius = world.model.bodies[0].radius;
        assert_eq!(world.peak_speed, 2.0 * radius, "ω r");
        assert!((world.peak_displacement - (0.05 + 0.1 * radius)).abs() < 1e-16, "|q| + θ r");
    }
}
