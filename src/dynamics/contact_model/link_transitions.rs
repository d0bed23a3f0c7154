//! Phases of devices: initial ones, and changes at an event.

use std::sync::Arc;

use crate::contact::Frame;
use crate::dynamics::connection::{Phase, Separation, Switch};
use crate::dynamics::contact_model::constants::DEVICE_EVENTS_PER_INSTANT;
use crate::dynamics::contact_model::event_state::EventBodies;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::record::event::Cause;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::LinkTrack;
use crate::language::{Message, message};

/// Devices of a group of bodies during an event.
pub(in crate::dynamics) struct LinkTransitions<'a> {
    /// Constant data and present states of the group.
    pub world: &'a mut World,
    /// Progress of the run, stopped where a device exceeds its number of events.
    pub schedule: &'a mut Schedule,
    /// States of the bodies that the event concerns.
    pub now: &'a EventBodies,
}

impl LinkTransitions<'_> {
    /// Enters the initial phases of all devices.
    pub(in crate::dynamics) fn begin(&mut self) {
        let model = Arc::clone(&self.world.model);
        for number in 0..self.world.links.len() {
            let phase = model.links[self.world.links[number].link].device.initial(&self.motion(number));
            self.enter(number, phase, 0.0);
        }
    }

    /// Changes a device's phase by `event` and records the energy released; ends the run above
    /// [`DEVICE_EVENTS_PER_INSTANT`] changes.
    pub(in crate::dynamics) fn change(&mut self, number: usize, event: Switch) {
        let model = Arc::clone(&self.world.model);
        let (motion, LinkTrack { link, phase, .. }) = (self.motion(number), &self.world.links[number]);
        let (next, released) = model.links[*link].device.next(event, phase, &motion);
        self.enter(number, next, released);
        if self.world.links[number].log.changes_at(self.now.poses.t) > DEVICE_EVENTS_PER_INSTANT {
            let track = &self.world.links[number];
            let reason = message!("stop-device", "name" => model.links[track.link].name.as_str());
            self.schedule.give_up(self.now.poses.t, self.world.names(track.slots.into_iter().flatten()), reason);
        }
    }

    fn enter(&mut self, number: usize, phase: Phase, released: f64) {
        let track = &mut self.world.links[number];
        track.phase = phase;
        track.log.push(self.now.poses.t, phase, released);
        if let Some(number) = self.ends_the_run(number) {
            let track = &self.world.links[number];
            let reason = self.end_of_support(number, &self.world.model.links[track.link].name);
            let names = self.world.names(track.slots.into_iter().flatten());
            self.schedule.end(self.now.poses.t, Cause::SupportLost, names, reason);
        }
    }

    /// The link by which the run ends after this one has entered its phase: itself where its support is lost, or the corner of the same
    /// girder that has dropped, once one of the girder's supports is lost. A girder that rolls on all of its supports does not end it.
    fn ends_the_run(&self, number: usize) -> Option<usize> {
        let links = &self.world.links;
        let device = |link: &LinkTrack| &self.world.model.links[link.link].device;
        let is_lost = |link: &LinkTrack| device(link).is_lost(&link.phase);
        let ends = |link: &LinkTrack| device(link).ends_run(&link.phase);
        let of_girder = |link: &&LinkTrack| link.slots[0] == links[number].slots[0];
        match (ends(&links[number]), is_lost(&links[number])) {
            (true, true) => Some(number),
            (true, false) => links.iter().filter(of_girder).any(is_lost).then_some(number),
            (false, true) => links.iter().position(|link| of_girder(&link) && ends(link) && !is_lost(link)),
            (false, false) => None,
        }
    }

    /// Why the run ends where a support is lost or a corner has dropped, with the place of the link's point.
    fn end_of_support(&self, number: usize, name: &str) -> Message {
        let LinkTrack { link, slots, phase, .. } = &self.world.links[number];
        let link = &self.world.model.links[*link];
        let frame = slots[0]
            .and_then(|slot| self.now.poses.pose(slot, link.sections[0]))
            .unwrap_or_else(|| Frame::fixed(link.homes[0]));
        let [x, y, z] = (frame.origin() + frame.turn(link.arms[0])).to_array().map(|place| format!("{place:.4}"));
        if link.device.is_lost(phase) {
            message!("stop-support-left", "name" => name, "x" => x, "y" => y)
        } else {
            message!("stop-support-dropped", "name" => name, "x" => x, "y" => y, "z" => z)
        }
    }

    /// Relative motion of a link's points at the time of the event.
    fn motion(&self, number: usize) -> Separation {
        let LinkTrack { link, slots, .. } = &self.world.links[number];
        let link = &self.world.model.links[*link];
        let frames = link.frames(|end, section| self.now.poses.pose(slots[end]?, section));
        link.motion([&frames[0], &frames[1]]).0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DMat3, DVec3};

    use crate::dynamics::Model;
    use crate::dynamics::connection::{
        Activity, Anchor, Connection, Device, DeviceReadings, SeparationBounds, acts_or_open,
    };
    use crate::dynamics::penalty3d::example::wall;
    use crate::language::Text;

    /// A device without force that changes its law at every event and releases energy \[J\].
    #[derive(Debug)]
    struct Ratchet;

    const RELEASED: f64 = 2.0;

    impl Connection for Ratchet {
        type State = Phase;
        type Motion = Separation;

        fn force(&self, _: &Phase, _: &Separation) -> DVec3 {
            DVec3::ZERO
        }

        fn stored_energy(&self, _: &Phase, _: &Separation) -> f64 {
            0.0
        }

        fn dissipated_power(&self, _: &Phase, _: &Separation) -> f64 {
            0.0
        }

        fn stiffness_bound(&self, _: &Phase) -> f64 {
            0.0
        }

        fn damping_bound(&self, _: &Phase) -> f64 {
            0.0
        }
    }

    impl Device for Ratchet {
        fn initial(&self, motion: &Separation) -> Phase {
            Phase { branch: 7, memory: motion.vector().to_array() }
        }

        fn activity(&self, _: &Phase) -> Activity {
            Activity::Idle
        }

        fn gap(&self, _: &Phase, _: &Separation) -> [f64; 2] {
            [1.0, 0.0]
        }

        fn gap_curvature(&self, _: &Phase, _: &SeparationBounds) -> f64 {
            0.0
        }

        fn switches(&self, _: &Phase) -> usize {
            0
        }

        fn switch(&self, _: usize, _: &Phase, _: &Separation) -> f64 {
            -1.0
        }

        fn next(&self, _: Switch, phase: &Phase, _: &Separation) -> (Phase, f64) {
            (Phase { branch: phase.branch + 1, ..*phase }, RELEASED)
        }
    }

    impl DeviceReadings for Ratchet {
        fn state(&self, phase: &Phase) -> Text {
            acts_or_open(self.acts(phase))
        }

        fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
            self.gap(phase, motion)[0]
        }
    }

    /// A girder that a ratchet joins to the ground, displaced by 3 mm at t = 0.
    fn joined() -> (World, EventBodies) {
        let mut model = Model::compile(&wall()).unwrap_or_else(|errors| panic!("{errors}"));
        let ends = [Anchor::Body { body: 0, point: DVec3::ZERO }, Anchor::Ground(DVec3::ZERO)];
        model.link("ratchet", ends, DMat3::IDENTITY, Arc::new(Ratchet)).expect("a link in the plane");
        let world = World::of(&Arc::new(model), 0);
        let (body, mut state) = (&world.model.bodies[0], world.model.bodies[0].initial());
        state[0] = 3e-3;
        let now = EventBodies::of(&world, vec![0], vec![body.placed()], vec![state], 0.0);
        (world, now)
    }

    #[test]
    fn a_device_starts_in_the_phase_of_its_present_stretch_and_logs_its_changes() {
        let ((mut world, now), mut schedule) = (joined(), Schedule::default());
        let mut links = LinkTransitions { world: &mut world, schedule: &mut schedule, now: &now };
        links.begin();
        assert_eq!(links.world.links[0].phase, Phase { branch: 7, memory: [3e-3, 0.0, 0.0] });
        links.change(0, Switch::Closing);
        let track = &world.links[0];
        assert_eq!((track.phase.branch, track.log.at(0.0)), (8, Some(track.phase)));
        assert_eq!(track.log.released(0.0), RELEASED, "in the log");
        assert_eq!(schedule.stop(), None);
    }

    #[test]
    fn a_device_that_changes_without_end_stops_the_run() {
        let ((mut world, now), mut schedule) = (joined(), Schedule::default());
        let mut links = LinkTransitions { world: &mut world, schedule: &mut schedule, now: &now };
        links.begin();
        (0..=DEVICE_EVENTS_PER_INSTANT).for_each(|_| links.change(0, Switch::Closing));
        let stop = schedule.stop().expect("a reason");
        assert!(stop.reason.to_string().contains("the device ratchet"), "{stop:?}");
        assert_eq!(stop.place, world.names([0]), "its body");
    }
}
