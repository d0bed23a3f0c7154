//! Event handlers of devices: beginning of a force, change of phase.

use std::sync::Arc;

use crate::dynamics::connection::{Phase, Separation, Switch};
use crate::dynamics::contact_model::at_instant::EventInstant;
use crate::dynamics::contact_model::constants::DEVICE_EVENTS_PER_INSTANT;
use crate::dynamics::contact_model::run::ContactRun;
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::world::tracks::LinkTrack;

impl ContactRun {
    /// Enters the initial phases of all devices.
    pub(in crate::dynamics) fn begin_links(&mut self, now: &EventInstant) {
        let model = Arc::clone(&self.world.model);
        for number in 0..self.world.links.len() {
            let phase = model.links[self.world.links[number].link].device.initial(&self.link_motion(number, now));
            self.enter_phase(number, phase, 0.0, now.t);
        }
    }

    /// Handles the beginning of a link's force at `t`; continues the search where none is due.
    pub(in crate::dynamics) fn begin_force(&mut self, number: usize, t: f64) {
        if self.world.links[number].begins.is_none_or(|at| at > t) {
            self.search_link(number, t);
            return;
        }
        let mut slots: Vec<usize> = self.world.links[number].slots.into_iter().flatten().collect();
        slots.sort_unstable();
        let (now, pace) = self.release(&slots, t);
        self.change_link(number, Switch::Closing, &now);
        // As at the closing of a contact, the first implicit step follows from the island's frequency.
        self.rebuild(now, if pace.stiff { ControllerState { step: 0.0, ..pace } } else { pace });
    }

    /// Changes a device's phase by `event` and records the energy released; ends the run above
    /// [`DEVICE_EVENTS_PER_INSTANT`] changes.
    pub(in crate::dynamics) fn change_link(&mut self, number: usize, event: Switch, now: &EventInstant) {
        let model = Arc::clone(&self.world.model);
        let (motion, LinkTrack { link, phase, .. }) = (self.link_motion(number, now), &self.world.links[number]);
        let (next, released) = model.links[*link].device.next(event, phase, &motion);
        self.enter_phase(number, next, released, now.t);
        if self.world.links[number].log.changes_at(now.t) > DEVICE_EVENTS_PER_INSTANT {
            let slots: Vec<usize> = self.world.links[number].slots.into_iter().flatten().collect();
            let link = &model.links[self.world.links[number].link].name;
            let reason = format!("the device {link} changes its phase without end at one instant; give it some slack");
            self.schedule.give_up(now.t, self.names(&slots), reason);
        }
    }

    fn enter_phase(&mut self, number: usize, phase: Phase, released: f64, t: f64) {
        let track = &mut self.world.links[number];
        track.phase = phase;
        track.log.push(t, phase, released);
    }

    /// Relative motion of a link's points at the time of the event.
    fn link_motion(&self, number: usize, now: &EventInstant) -> Separation {
        let LinkTrack { link, slots, .. } = &self.world.links[number];
        let link = &self.world.model.links[*link];
        let frames = link.frames(|end| now.pose(slots[end]?));
        link.motion([&frames[0], &frames[1]]).0
    }
}
