//! Event handlers: end of a planned step, transition of a contact within it, closing of a pair, beginning of a
//! link's force or end of its phase in flight.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::dynamics::connection::Switch;
use crate::dynamics::contact_model::constants::ALTERNATING_EVENTS;
use crate::dynamics::contact_model::contact_closing::ContactClosing;
use crate::dynamics::contact_model::contact_states;
use crate::dynamics::contact_model::event_poses::{ContactPoses, EventPoses};
use crate::dynamics::contact_model::event_source::EventSource;
use crate::dynamics::contact_model::event_state::EventBodies;
use crate::dynamics::contact_model::run::ContactRun;
use crate::dynamics::contact_model::step_planning;
use crate::dynamics::contact_model::transitions::Transitions;
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::due::Due;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::world::tracks::Trajectory;

impl ContactRun {
    /// Handles the end of an island's planned step or the event within it: the step is committed as far as `t`,
    /// contacts and devices change state, and trajectories are rebuilt.
    pub(in crate::dynamics) fn end_step(&mut self, number: usize, t: f64) {
        let Some(mut island) = self.world.islands[number].take() else { return };
        self.store.commit(&mut self.world, &mut island, t);
        if island.step.due.is_empty() && island.step.link_due.is_none() {
            self.continue_island(number, island, t);
            return;
        }
        let states = (0..island.slots.len()).map(|index| island.state_at(&self.world.model, index, t)).collect();
        let now = EventBodies::of(&self.world, island.slots.clone(), island.system.bases.clone(), states, t);
        self.note_states(&island, t);
        let mut alternates = false;
        for Due { index: number, reason } in std::mem::take(&mut island.step.due) {
            let contact = island.contacts[number];
            Transitions { states: &mut self.contact_states(&now) }.change(contact, reason);
            alternates |= self.world.contacts[contact].changes.at_instant > ALTERNATING_EVENTS;
        }
        if let Some(due) = island.step.link_due.take() {
            let link = island.system.links[due.index].track;
            self.link_transitions(&now).change(link, Switch::Function(due.switch));
        }
        self.island_stock.take_back(number, &mut island);
        // Under alternating stick and slip the next step length follows from the island's frequency.
        self.rebuild(now, if alternates { ControllerState::default() } else { island.stepper.controller_state() });
    }

    /// Plans the next step of an island whose step ended without an event, and searches the pairs of its bodies again.
    fn continue_island(&mut self, number: usize, mut island: Box<Island>, t: f64) {
        let model = Arc::clone(&self.world.model);
        if model.next_kink(island.step.from) <= t {
            island.rewind(&model, t);
        }
        let slots = island.slots.clone();
        self.world.islands[number] = Some(island);
        step_planning::plan(&mut self.world, &mut self.schedule, number);
        self.search().around(&slots, t);
    }

    /// Handles the closing of a pair at `t` with all contacts that close within its simultaneity interval; continues
    /// the search where none is due.
    pub(in crate::dynamics) fn close_pair(&mut self, pair: usize, t: f64) {
        let limit = t + self.world.pairs[pair].simultaneity;
        let closes = |&c: &usize| self.world.contacts[c].found.closing.is_some_and(|at| at <= limit);
        let mut entered: Vec<usize> = self.world.pairs[pair].contacts.clone().filter(closes).collect();
        if entered.is_empty() {
            self.search().pair(pair, t);
            return;
        }
        let seen = EventPoses::of(&self.world, ascending(self.world.pairs[pair].slots), t);
        // A node that closes within the interval after `t` closes at `t`; a miss is recorded at its own time only.
        entered.retain(|&contact| {
            let over = ContactPoses { world: &self.world, now: &seen }.is_over(contact);
            if !over && self.world.contacts[contact].found.closing.is_some_and(|at| at <= t) {
                contact_states::miss(&mut self.world, &mut self.schedule, &mut self.events, contact, t);
            }
            over
        });
        if entered.is_empty() {
            self.search().pair(pair, t);
            return;
        }
        let (now, controller) = self.end_trajectories(&seen.slots, t);
        for contact in entered {
            ContactClosing { states: &mut self.contact_states(&now) }.close(contact);
        }
        self.rebuild(now, first_of_touch(controller));
    }

    /// Handles the beginning of a link's force at `t`, or the end of its phase on a body in flight; continues the search where
    /// none is due.
    pub(in crate::dynamics) fn change_phase(&mut self, number: usize, t: f64) {
        let Some((_, event)) = self.world.links[number].ends.filter(|(at, _)| *at <= t) else {
            self.search().link(number, t);
            return;
        };
        let (now, controller) = self.end_trajectories(&ascending(self.world.links[number].slots), t);
        self.link_transitions(&now).change(number, event);
        self.rebuild(now, first_of_touch(controller));
    }

    /// Ends at `t` the trajectories of bodies and of all bodies in an island or a block with them: their states, and the method
    /// and length of their integrators' next steps.
    pub(in crate::dynamics) fn end_trajectories(&mut self, slots: &[usize], t: f64) -> (EventBodies, ControllerState) {
        let mut all = BTreeSet::new();
        let mut controller = ControllerState::default();
        for &slot in slots {
            match self.world.bodies[slot].now {
                Trajectory::Placed | Trajectory::Flight(_) => all.extend(self.world.flies_with(slot)),
                Trajectory::Island { island, .. } => {
                    if let Some(island) = &self.world.islands[island] {
                        all.extend(island.slots.iter().copied());
                        controller = controller.with(island.stepper.controller_state());
                    }
                }
            }
        }
        let slots: Vec<usize> = all.into_iter().collect();
        let (bases, states) = slots.iter().map(|&slot| self.world.state_from_reference(slot, t)).unzip();
        self.end_islands(&slots, t);
        (EventBodies::of(&self.world, slots, bases, states, t), controller)
    }

    /// Stores in the tracks the states at `t` of an island's contacts, and the phases and memories of its devices.
    fn note_states(&mut self, island: &Island, t: f64) {
        for (number, &contact) in island.contacts.iter().enumerate() {
            self.world.contacts[contact].state = Contact::Closed(island.closed_at(number, t));
        }
        for (index, link) in island.system.links.iter().enumerate().filter(|(_, link)| link.evolving.is_some()) {
            self.world.links[link.track].phase = island.phase_at(index, t);
        }
    }

    /// Ends at `t` the islands of these bodies, within their planned steps.
    fn end_islands(&mut self, slots: &[usize], t: f64) {
        let island_of = |&slot: &usize| match self.world.bodies[slot].now {
            Trajectory::Island { island, .. } => Some(island),
            Trajectory::Placed | Trajectory::Flight(_) => None,
        };
        let numbers: BTreeSet<usize> = slots.iter().filter_map(island_of).collect();
        for number in numbers {
            self.schedule.queue.remove(EventSource::Island(number).into());
            if let Some(mut island) = self.world.islands[number].take() {
                self.store.commit(&mut self.world, &mut island, t);
                self.note_states(&island, t);
                self.island_stock.take_back(number, &mut island);
            }
        }
    }
}

/// Slots of the bodies of a pair or a link, ascending; ground and abutments have none.
fn ascending(slots: [Option<usize>; 2]) -> Vec<usize> {
    let mut slots: Vec<usize> = slots.into_iter().flatten().collect();
    slots.sort_unstable();
    slots
}

/// Method and length of the first step after a closing from those before it. An impact lasts about a radian of the
/// contact's oscillation, and the error estimate of an implicit step is blind to a motion that decays within the step:
/// the length of an implicit one follows from the island's frequency.
fn first_of_touch(controller: ControllerState) -> ControllerState {
    if controller.stiff { ControllerState { step: 0.0, ..controller } } else { controller }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::connection::{Activity, Anchor};
    use crate::dynamics::devices::{Failure, Stopper};
    use crate::dynamics::event_loop::event_driven::EventDriven;
    use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, wall};
    use crate::dynamics::record::event::EventKind;
    use crate::scene::Scene;

    /// Distance of the girder from its wall or its stopper \[m\].
    const GAP: f64 = 1e-3;

    /// A girder that moves along x and y before an elastic wall.
    fn scene(velocity: [f64; 2]) -> Scene {
        let mut scene = wall();
        scene.abutments[0].gap = Some(GAP);
        scene.girders[0].initial.velocity = [velocity[0], velocity[1], 0.0];
        scene
    }

    fn thrown(velocity: [f64; 2]) -> ContactRun {
        let model = Model::compile(&scene(velocity)).unwrap_or_else(|errors| panic!("{errors}"));
        ContactRun::new(&Arc::new(model), 0)
    }

    /// A girder far from its wall that moves towards a stopper of the ground.
    fn stopped() -> ContactRun {
        let mut scene = scene([SPEED, 0.0]);
        scene.abutments[0].gap = Some(1.0);
        let mut model = Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}"));
        let ends = [Anchor::Body { body: 0, point: DVec3::ZERO }, Anchor::Ground(DVec3::ZERO)];
        let stopper = Stopper { gap: GAP, stiffness: STIFFNESS, failure: Failure::Never };
        model.link("stopper", ends, DMat3::IDENTITY, Arc::new(stopper)).expect("a link in the plane");
        ContactRun::new(&Arc::new(model), 0)
    }

    /// Time for which the girder is in touch, half a period of its mass on the pair's stiffness \[s\].
    fn touch() -> f64 {
        std::f64::consts::PI / (STIFFNESS / MASS).sqrt()
    }

    fn near(got: f64, expected: f64, what: &str) {
        assert!((got - expected).abs() <= 1e-9 * expected.abs(), "{what}: {got} is not {expected}");
    }

    #[test]
    fn a_girder_that_meets_its_wall_squarely_closes_both_corners_and_is_thrown_back_after_half_a_period() {
        let mut run = thrown([SPEED, 0.0]);
        let due = run.world.pairs[0].due;
        near(due, GAP / SPEED, "it closes");
        run.close_pair(0, due);
        let kinds: Vec<EventKind> = run.events.iter().map(|event| event.kind).collect();
        assert_eq!(kinds, [EventKind::OpenToStick; 2]);
        assert!(matches!(run.world.bodies[0].now, Trajectory::Island { .. }), "it is integrated");
        run.advance(0.5);
        let opened: Vec<f64> = run.events[2..].iter().map(|event| event.t).collect();
        assert_eq!(opened.len(), 2, "both corners open: {:?}", run.events);
        near(opened[0], GAP / SPEED + touch(), "they open");
        assert!(matches!(run.world.bodies[0].now, Trajectory::Flight(_)), "it flies");
        let state = run.world.state(0, 0.5);
        near(state[3], -SPEED, "as fast as it came");
        near(state[0], GAP - SPEED * (0.5 - opened[0]), "from the wall on");
        assert!(run.world.islands.iter().all(Option::is_none), "no island is left");
    }

    #[test]
    fn the_end_of_a_step_without_an_event_is_the_beginning_of_the_next() {
        let mut run = thrown([SPEED, 0.0]);
        let due = run.world.pairs[0].due;
        run.close_pair(0, due);
        let step = |run: &ContactRun| {
            let island = run.world.islands[0].as_ref().expect("in touch");
            (island.step.from, island.step.until, island.step.due.len())
        };
        let (from, until, events) = step(&run);
        assert!(from == due && until < due + touch() && events == 0, "a step within the touch: {from} to {until} s");
        run.end_step(0, until);
        assert_eq!(step(&run).0, until);
        assert_eq!(run.events.len(), 2, "nothing but the closings");
    }

    #[test]
    fn a_pair_before_its_closing_is_searched_again_and_stays_open() {
        let mut run = thrown([SPEED, 0.0]);
        let searches = run.schedule.effort.searches;
        run.close_pair(0, 0.25 * GAP / SPEED);
        assert_eq!((run.events.len(), run.schedule.effort.searches), (0, searches + 1));
        near(run.world.pairs[0].due, GAP / SPEED, "the same closing");
        assert!(matches!(run.world.bodies[0].now, Trajectory::Flight(_)));
    }

    #[test]
    fn a_girder_that_passes_beside_its_wall_misses_it_and_flies_on() {
        // Its corner comes past the end of the wall at 1 m before it reaches the plane.
        let along = 1.1 / (GAP / SPEED);
        let mut run = thrown([SPEED, along]);
        run.advance(2.0 * GAP / SPEED);
        assert!(run.events.iter().all(|event| event.kind == EventKind::Missed), "{:?}", run.events);
        let states = [0, 1].map(|contact| run.world.contacts[contact].state);
        assert_eq!(states, [Contact::Open { armed: false }; 2]);
        let state = run.world.state(0, 2.0 * GAP / SPEED);
        near(state[0], 2.0 * GAP, "through the plane");
    }

    #[test]
    fn a_stopper_begins_where_its_gap_closes_and_not_before() {
        let mut run = stopped();
        let acts = |run: &ContactRun| {
            let track = &run.world.links[0];
            run.world.model.links[track.link].device.activity(&track.phase)
        };
        let (at, event) = run.world.links[0].ends.expect("a beginning");
        near(at, GAP / SPEED, "it touches");
        assert_eq!(event, Switch::Closing);
        run.change_phase(0, 0.5 * at);
        assert_eq!(
            (acts(&run), run.world.links[0].ends.map(|(_, event)| event)),
            (Activity::Idle, Some(Switch::Closing))
        );
        let (at, _) = run.world.links[0].ends.expect("a beginning");
        run.change_phase(0, at);
        assert_eq!(acts(&run), Activity::Acts);
        run.advance(0.5);
        assert_eq!(acts(&run), Activity::Idle, "it has opened");
        near(run.world.state(0, 0.5)[3], -SPEED, "as fast as the girder came");
    }

    #[test]
    fn the_bodies_of_a_pair_are_taken_in_ascending_order_without_the_ground() {
        assert_eq!(ascending([Some(3), Some(1)]), [1, 3]);
        assert_eq!(ascending([None, Some(2)]), [2]);
        assert!(ascending([None, None]).is_empty());
    }

    #[test]
    fn after_a_closing_an_implicit_step_begins_with_a_length_of_its_own_and_an_explicit_one_goes_on() {
        for (stiff, step) in [(true, 0.0), (false, 1e-3)] {
            let before = ControllerState { step: 1e-3, stiff };
            assert_eq!(first_of_touch(before).step, step, "implicit: {stiff}");
        }
    }
}
