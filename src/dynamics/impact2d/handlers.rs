//! Handlers of the impact model's events for one group of bodies: flights in closed form, hits located to round-off, lasting contact
//! in steps.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::event_loop::event_driven::EventDriven;
use crate::dynamics::event_loop::event_queue::Source;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::impact2d::InlineVec;
use crate::dynamics::impact2d::after_impact::resume;
use crate::dynamics::impact2d::constants::{EVENTS_AT_ONE_INSTANT, RUN_SPEED_ROUNDING, TOUCH};
use crate::dynamics::impact2d::event_source::EventSource;
use crate::dynamics::impact2d::impulse::sequential::impulses;
use crate::dynamics::impact2d::instant::ImpactInstant;
use crate::dynamics::impact2d::lasting::switch::Ending;
use crate::dynamics::impact2d::record::ImpactRecord;
use crate::dynamics::impact2d::run::ImpactRun;
use crate::dynamics::impact2d::tracks::BodyTrack;
use crate::dynamics::impact2d::world::World;
use crate::language::{Message, message};

impl ImpactRun {
    /// Sets up a group of bodies, by its number in the model, at t = 0.
    pub fn new(model: &Arc<Model>, group: usize) -> Self {
        let mut run = Self::before_start(World::new(model, group));
        run.begin();
        run
    }

    /// Contacts and trajectories at t = 0.
    fn begin(&mut self) {
        disarm_points_behind(&mut self.world);
        let mut seen = vec![false; self.world.bodies.len()];
        for slot in 0..seen.len() {
            if !seen[slot] {
                for member in self.act(0.0, &[slot], None) {
                    seen[member] = true;
                }
            }
        }
    }

    /// Counts an event; whether there are too many at this instant.
    fn is_stuck(&mut self, t: f64) -> bool {
        self.events_at_instant = if self.last_instant == t { self.events_at_instant + 1 } else { 1 };
        self.last_instant = t;
        self.events_at_instant > EVENTS_AT_ONE_INSTANT + 4 * self.world.pairs.len() + 2 * self.world.bodies.len()
    }

    /// One instant: impulses, contact modes, trajectories from there on. Returns the slots of all bodies concerned.
    fn act(&mut self, t: f64, seeds: &[usize], ending: Option<Ending>) -> InlineVec<usize> {
        let mut instant = ImpactInstant::new(&self.world, t, seeds);
        let slots = instant.slots.clone();
        if t == 0.0 && self.stop_if_overlapping(&slots) {
            return slots;
        }
        for (slot, state) in slots.iter().zip(instant.states.clone()) {
            self.world.update_peaks(*slot, &state);
        }
        instant.speed_noise = instant.speed_noise.max(RUN_SPEED_ROUNDING * self.world.peak_speed);
        let energy = instant.kinematics.cluster.kinetic_energy();
        let mut to = instant.before.clone();
        let lost = impulses(&self.world, &mut self.record, &mut instant, &mut to);
        resume(self, &mut instant, &to, energy - lost, ending);
        slots
    }

    /// Stops the run where girders overlap as placed.
    fn stop_if_overlapping(&mut self, slots: &[usize]) -> bool {
        let Some((pair, depth)) = overlap(&self.world, slots) else { return false };
        let world = &self.world;
        let name = world.model.pairs[world.pairs[pair].number].name.clone();
        let reason = message!("stop-starts-inside", "depth" => format!("{depth:.3e}"));
        self.schedule.give_up(0.0, name, reason);
        true
    }

    /// End of the planned step of a lasting contact.
    fn end_of_step(&mut self, number: usize, t: f64) {
        let Some(contact) = &self.world.lasting[number] else { return };
        let slots = self.world.slots(&contact.bodies);
        if let Some(ending) = contact.ending {
            if let Ending::LeavesFace(leaving) = ending
                && let Some(left) = self.world.site(leaving)
            {
                let site = &mut self.world.sites[left];
                site.pass_beside(t);
                site.kept = false;
                if let Some(pair) = self.world.pair(self.world.model.sites[leaving].pair) {
                    self.world.take_up_passed(pair, left, t);
                }
            }
            self.act(t, &slots, Some(ending));
            return;
        }
        for &slot in &slots {
            self.close_segment(slot, t);
        }
        if let Some(contact) = &mut self.world.lasting[number] {
            contact.commit();
        }
        for &slot in &slots {
            self.world.bodies[slot].since = t;
        }
        self.plan(number);
        self.search_around(&slots, t);
    }

    /// Ends all trajectories and lasting contacts; returns the time reached \[s\].
    pub(in crate::dynamics) fn end(&mut self) -> f64 {
        let end = self.schedule.reached(self.world.model.duration);
        for slot in 0..self.world.bodies.len() {
            self.close_segment(slot, end);
        }
        for number in 0..self.world.lasting.len() {
            self.end_lasting(number, end);
        }
        end
    }

    /// Bodies with their paths, log, and progress.
    pub(in crate::dynamics) fn into_parts(self) -> (Vec<BodyTrack>, ImpactRecord, Schedule) {
        let Self { world, mut record, schedule, .. } = self;
        let end = schedule.reached(world.model.duration);
        for site in world.sites {
            let last = site.beside.map(|from| [from, end]);
            record.beside.extend(site.was_beside.into_iter().chain(last).map(|stretch| (site.number, stretch)));
        }
        (world.bodies, record, schedule)
    }
}

impl EventDriven for ImpactRun {
    fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    fn schedule_mut(&mut self) -> &mut Schedule {
        &mut self.schedule
    }

    fn duration(&self) -> f64 {
        self.world.model.duration
    }

    fn exceeded(&mut self, t: f64) -> Option<Message> {
        if self.is_stuck(t) {
            let work = self.schedule.work;
            return Some(message!("stop-nowhere", "work" => work, "same" => self.events_at_instant));
        }
        if !self.bounds.is_due(self.schedule.work) {
            return None;
        }
        let exceeded = self.bounds.exceeded(&self.spent(t))?;
        Some(message!("stop-hits-too-fast", "spent" => exceeded.spent()))
    }

    fn place(&self, source: Source) -> String {
        let world = &self.world;
        match source.into() {
            EventSource::Pair(number) => world.model.pairs[world.pairs[number].number].name.clone(),
            EventSource::Lasting(number) => {
                world.lasting[number].as_ref().map_or(String::new(), |contact| world.names(&contact.bodies))
            }
        }
    }

    fn handle(&mut self, source: Source, t: f64) {
        match source.into() {
            EventSource::Lasting(number) => self.end_of_step(number, t),
            EventSource::Pair(number) if self.world.pairs[number].impact_due => {
                self.world.arm_in_front(number, t);
                let slots: InlineVec<usize> = self.world.pairs[number].slots.into_iter().flatten().collect();
                self.act(t, &slots, None);
            }
            EventSource::Pair(number) => self.search(number, t),
        }
    }

    fn states(&self, t: f64) -> Vec<(usize, Vec<f64>)> {
        let world = &self.world;
        world.bodies.iter().enumerate().map(|(slot, track)| (track.body, world.state(slot, t).to_vec())).collect()
    }

    fn name(&self, body: usize) -> String {
        self.world.model.bodies[body].name.clone()
    }
}

/// Disarms points that start behind the plane of their face: they hit after they have been in front of it.
fn disarm_points_behind(world: &mut World) {
    for pair in 0..world.pairs.len() {
        let near = TOUCH * world.radius(pair);
        for site in world.pairs[pair].sites.clone() {
            let point = world.point(site, pair, 0.0);
            if point.gap < near && !world.touches(site, pair, &point) {
                let depth = world.model.sites[world.sites[site].number].face.depth;
                let beside = point.inset < 0.0 || -point.gap >= depth;
                let track = &mut world.sites[site];
                track.armed = false;
                if beside {
                    track.pass_beside(0.0);
                }
            }
        }
    }
}

/// A pair of these bodies that overlaps at t = 0, and by how much \[m\].
fn overlap(world: &World, slots: &[usize]) -> Option<(usize, f64)> {
    for &slot in slots {
        for &pair in &world.bodies[slot].pairs {
            let depth = |site: usize| {
                let point = world.point(site, pair, 0.0);
                let within = -point.gap < world.model.sites[world.sites[site].number].face.depth;
                if point.inset >= 0.0 && within { -point.gap } else { 0.0 }
            };
            let deepest = world.pairs[pair].sites.clone().map(depth).fold(0.0, f64::max);
            if deepest > TOUCH * world.radius(pair) {
                return Some((pair, deepest));
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::GirderState;
    use crate::dynamics::impact2d::example;
    use crate::dynamics::run::{Finished, Run as _};
    use crate::scene::format;

    /// Girders of 2 kg without bearings, one behind the other's back, each before a wall of its own at this gap \[m\].
    fn model(count: usize, gap: f64, speed: f64, e_n: f64) -> Arc<Model> {
        let head = format!(
            "name = \"walls\"\nduration_s = 0.1\n[model]\nkind = \"impact\"\n[impact]\nrestitution_normal = {e_n:?}\n"
        );
        let girder = |i: usize| {
            format!(
                r#"
                [[girder]]
                name = "deck{i}"
                length_m = 0.19
                width_m = 0.07
                thickness_m = 0.02
                mass_kg = 2.0
                position_m = [{:?}, 0.0, 0.0]
                initial = {{ velocity_m_s = [{speed:?}, 0.0] }}
                [[abutment]]
                name = "wall{i}"
                faces = "deck{i}"
                end = "+x"
                gap_m = {gap:?}
                "#,
                10.0 * i as f64
            )
        };
        let text = head + &(0..count).map(girder).collect::<String>();
        let model = Model::compile(&format::parse(&text, "test").expect("a scene")).expect("a sound scene");
        Arc::new(model)
    }

    fn finished(model: &Arc<Model>, group: usize) -> Finished {
        let mut run = ImpactRun::new(model, group);
        run.advance(model.duration);
        Box::new(run).finish()
    }

    fn record(finished: &Finished) -> &ImpactRecord {
        finished.record.as_ref().expect("the log of the impact model")
    }

    #[test]
    fn a_free_girder_hits_once_and_comes_back_with_its_restitution() {
        let model = model(1, 0.003, 0.25, 0.4);
        let mut run = ImpactRun::new(&model, 0);
        run.advance(0.05);
        let (_, state) = EventDriven::states(&run, 0.05).pop().expect("one body");
        let expected = 0.003 - 0.1 * (0.05 - 0.012);
        assert!((state[0] - expected).abs() < 1e-15 && (state[3] + 0.1).abs() < 1e-15, "{state:?}");
        let end = finished(&model, 0);
        assert_eq!((record(&end).hits.len(), end.end), (1, 0.1), "one hit, to the end");
        let hit = &record(&end).hits[0];
        let lost = 0.5 * 2.0 * 0.25 * 0.25 * (1.0 - 0.16);
        assert!((hit.t - 0.012).abs() < 1e-15 && (hit.impulses.lost - lost).abs() < 1e-15, "{hit:?}");
        assert_eq!(record(&end).state(0, 0.05), GirderState::Free, "b");
    }

    #[test]
    fn a_run_ends_at_its_bound_of_memory() {
        let text = r#"
            name = "between walls"
            duration_s = 0.1
            model = { kind = "impact" }
            impact = { restitution_normal = 1.0 }
            [[girder]]
            name = "deck"
            length_m = 0.19
            width_m = 0.07
            thickness_m = 0.02
            mass_kg = 2.0
            initial = { velocity_m_s = [0.25, 0.0] }
            [[abutment]]
            name = "east"
            faces = "deck"
            end = "+x"
            gap_m = 1e-6
            [[abutment]]
            name = "west"
            faces = "deck"
            end = "-x"
            gap_m = 1e-6
        "#;
        let mut model = Model::compile(&format::parse(text, "test").expect("a scene")).expect("a sound scene");
        let hits = |model: &Model| record(&finished(&Arc::new(model.clone()), 0)).hits.len();
        let all = hits(&model);
        assert!((12_400..12_600).contains(&all), "one in 8 µs: {all}");
        model.memory_bytes = 1 << 20;
        let end = finished(&Arc::new(model.clone()), 0);
        let stop = end.stop.as_ref().expect("a reason");
        assert!(stop.reason.to_string().contains("1 MiB that a run may take"), "{stop:?}");
        assert!(stop.t > 0.01 && stop.t < 0.09 && record(&end).hits.len() > 1000, "what was found is kept: {stop:?}");
    }

    #[test]
    fn groups_after_the_first_run_alike() {
        let model = model(2, 0.003, 0.25, 0.4);
        assert_eq!(model.groups.len(), 2, "girders that never meet");
        let [first, second] = [0, 1].map(|group| finished(&model, group));
        assert_eq!(record(&second).hits.len(), 1, "its own wall");
        let later = (record(&second).hits[0].t - record(&first).hits[0].t).abs();
        assert!(later < 1e-13, "at the same time but for the round-off of its place, {later} s");
        assert_eq!(record(&second).hits[0].pair, 1, "numbers are those of the model");
    }

    #[test]
    fn an_overlap_stops_the_run_before_it_begins() {
        let model = Arc::new(example::at_wall(|scene| scene.girders[0].initial.displacement = [1e-3, 0.0, 0.0]));
        let end = finished(&model, 0);
        let stop = end.stop.expect("a reason");
        assert!(stop.t == 0.0 && stop.reason.to_string().contains("1.000e-3 m inside"), "{stop:?}");
    }

    #[test]
    fn a_plastic_hit_without_force_rests_at_the_wall() {
        let end = finished(&model(1, 0.0025, 0.25, 0.0), 0);
        assert_eq!(record(&end).hits.len(), 1, "no bounce");
        let states: Vec<GirderState> = record(&end).transitions.iter().map(|change| change.to).collect();
        assert!(!states.is_empty() && record(&end).state(0, 0.1) != GirderState::FreeTurning, "{states:?}");
    }
}
