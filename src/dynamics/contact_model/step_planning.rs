//! The next step of an island: planned, with the first event within it located and entered in the queue.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::contact_model::event_forecast::earliest_change;
use crate::dynamics::contact_model::event_source::EventSource;
use crate::dynamics::event_loop::effort::Effort;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::integrator::constants::WORTHWHILE_CUT;
use crate::dynamics::penalty3d::constants::SIMULTANEOUS_PHASE;
use crate::dynamics::penalty3d::due::Due;
use crate::dynamics::penalty3d::event_location;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::penalty3d::link_events;
use crate::dynamics::world::World;
use crate::language::message;

/// Plans the next step of the island of this number, locates the first event within it and enters its time, or the end
/// of the step, in the queue. A step that cannot be made stops the run.
pub(in crate::dynamics) fn plan(world: &mut World, schedule: &mut Schedule, number: usize) {
    let model = Arc::clone(&world.model);
    let Some(mut island) = world.islands[number].take() else { return };
    let from = island.step.until;
    if from >= model.duration {
        island.step.from = from;
        world.islands[number] = Some(island);
        return;
    }
    let cap = model.duration.min(island.stepper.latest_end(&model, from));
    schedule.effort.steps += 1;
    let controller = island.stepper.controller_state();
    let going_on = controller.stiff && controller.step > 0.0;
    let forecast =
        if going_on { earliest_change(world, &island, WORTHWHILE_CUT * controller.step) } else { f64::INFINITY };
    let due = match island.plan(&model, cap, forecast) {
        Err(error) => {
            let reason = message!("stop-step", "step" => format!("{:.1e}", error.step));
            schedule.give_up(from, world.names(island.slots.iter().copied()), reason);
            island.step.until
        }
        Ok(()) => find_due(&model, &mut schedule.effort, &mut island).map_or(island.step.until, |t| t.max(from)),
    };
    schedule.queue.set(EventSource::Island(number).into(), due);
    world.islands[number] = Some(island);
}

/// Enters in the island the first event within its planned step; its time. Of events of a contact and a device at
/// equal times the contact's comes first; the device's is located at the start of the next step.
fn find_due(model: &Model, effort: &mut Effort, island: &mut Island) -> Option<f64> {
    let mut contacts = first_events(model, effort, island);
    let mut link = link_events::first_phase_end(model, island);
    if let Some((t, _)) = link
        && contacts.as_ref().is_none_or(|(first, _)| t < *first)
        && !island.is_exact_inside()
        && island.end_beyond(model, t)
    {
        effort.steps += 1;
        contacts = first_events(model, effort, island);
        link = link_events::first_phase_end(model, island);
    }
    match (contacts, link) {
        (Some((t, _)), Some((earlier, due))) if earlier < t => {
            island.step.link_due = Some(due);
            Some(earlier)
        }
        (Some((t, due)), _) => {
            island.step.due = due;
            Some(t)
        }
        (None, Some((t, due))) => {
            island.step.link_due = Some(due);
            Some(t)
        }
        (None, None) => None,
    }
}

/// The first events of an island's contacts within its planned step, and their time. An event well inside the step has
/// the step retaken to end at it.
fn first_events(model: &Model, effort: &mut Effort, island: &mut Island) -> Option<(f64, Vec<Due>)> {
    let simultaneity = SIMULTANEOUS_PHASE / island.omega();
    let (t, due) = event_location::first_contact_events(model, island, simultaneity)?;
    if !island.end_beyond(model, t) {
        return Some((t, due));
    }
    effort.steps += 1;
    event_location::first_contact_events(model, island, simultaneity)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::penalty3d::due::Reason;
    use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, wall};
    use crate::dynamics::world::example::planned;

    #[test]
    fn an_island_is_in_the_queue_with_the_end_of_its_step_then_with_the_opening_within_it() {
        let mut world = planned(&wall(), &[[0.0, 0.0, 0.0, SPEED, 0.0, 0.0]]);
        let mut schedule = Schedule::default();
        let opening = std::f64::consts::PI / (STIFFNESS / MASS).sqrt();
        let mut ends = Vec::new();
        while world.islands[0].as_ref().expect("the island").step.due.is_empty() {
            plan(&mut world, &mut schedule, 0);
            ends.push(schedule.queue.first_time());
        }
        let last = ends.pop().expect("steps");
        assert!((last / opening - 1.0).abs() < 1e-9, "opens at {last} s, not {opening} s");
        assert!(ends.is_sorted() && ends.iter().all(|&end| end < opening), "steps end before it: {ends:?}");
        let island = world.islands[0].as_ref().expect("the island");
        assert!(island.step.due.iter().all(|due| due.reason == Reason::Opening), "{:?}", island.step.due);
        assert!(schedule.effort.steps > ends.len() as u64, "{} steps are counted", schedule.effort.steps);
    }

    #[test]
    fn a_step_that_cannot_be_made_stops_the_run() {
        let mut world = planned(&wall(), &[[0.0, 0.0, 0.0, SPEED, 0.0, 0.0]]);
        world.islands[0].as_mut().expect("the island").stepper.y[0] = f64::NAN;
        let mut schedule = Schedule::default();
        plan(&mut world, &mut schedule, 0);
        let stop = schedule.stop().expect("a reason");
        assert!(stop.reason.to_string().starts_with("the step fell to"), "{stop:?}");
    }
}
