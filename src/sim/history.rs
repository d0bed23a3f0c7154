//! The answer: a dense, continuous history that can be asked for any quantity at any time.

use std::sync::{Arc, OnceLock};

use super::energy::power_integrals::PowerIntegrals;
use super::impact::events;
use super::report::{LargestMotion, Overlap, Pounding};
use super::trajectories::Trajectories;
use super::{Event, Motion, Stop, Touch, Upright};
use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::event_loop::effort::Effort;
use crate::dynamics::impact2d::ImpactRecord;
use crate::dynamics::model::coordinates::BodyState;
use crate::dynamics::record::event::Cause;
use crate::dynamics::run::Finished;
use crate::geometry::End;
use crate::language::Text;
use crate::scene::{Between, Scene};

/// A run of a scene, from t = 0 to [`History::end`].
///
/// Results that are computed on first use are searched on all processors. No part of such a search waits for another search: a thread that
/// waits for the parts of one takes up parts of others, and would wait for itself.
#[derive(Clone, Debug)]
pub struct History {
    scene: Scene,
    stop: Option<Stop>,
    pub(super) trajectories: Trajectories,
    events: Vec<Event>,
    record: Option<ImpactRecord>,
    /// Answer of the scene by the other model.
    beside: Option<Arc<Self>>,
    effort: Effort,
    pub(super) found: Found,
}

/// Results that are computed on first use.
#[derive(Clone, Debug, Default)]
pub(super) struct Found {
    pub(super) touches: OnceLock<Vec<Touch>>,
    pub(super) power_integrals: OnceLock<PowerIntegrals>,
    pub(super) overlaps: OnceLock<Vec<Overlap>>,
    pub(super) poundings: OnceLock<Vec<Pounding>>,
    pub(super) uprights: OnceLock<Vec<Upright>>,
    pub(super) largest_motion: OnceLock<Option<LargestMotion>>,
}

impl History {
    /// Puts the groups of a run together; the impact model has a record of each.
    pub(super) fn gather(scene: Scene, model: Arc<Model>, groups: Vec<Finished>) -> Self {
        let end = groups.iter().map(|g| g.end).fold(model.duration, f64::min);
        let stop = groups.iter().filter_map(|g| g.stop.clone()).min_by(|a, b| a.t.total_cmp(&b.t));
        let mut trajectories = Trajectories::new(model, end);
        let (mut events, mut records, mut effort) = (Vec::new(), Vec::new(), Effort::default());
        for mut group in groups {
            trajectories.take_in(&mut group);
            effort += group.effort;
            records.extend(group.record);
            // The first group's stay where they are.
            if events.is_empty() {
                events = group.events;
            } else {
                events.extend(group.events);
            }
        }
        events.retain(|event| event.t <= end);
        let record = (!records.is_empty()).then(|| ImpactRecord::together(records, end));
        if let Some(record) = &record {
            events = events::of(record, trajectories.model());
        }
        events.sort_by(|a, b| a.t.total_cmp(&b.t));
        Self { scene, stop, trajectories, events, record, beside: None, effort, found: Found::default() }
    }

    /// The scene that was run.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Bodies, pairs and contacts as compiled from the scene.
    pub fn model(&self) -> &Model {
        self.trajectories.model()
    }

    /// Time that the answer reaches \[s\].
    pub fn end(&self) -> f64 {
        self.trajectories.end()
    }

    /// Record of the impact model; `None` where the contact model computed the run.
    pub fn impact(&self) -> Option<&ImpactRecord> {
        self.record.as_ref()
    }

    /// Answer of the scene by the model that does not lead, where it asks for both.
    pub fn beside(&self) -> Option<&Self> {
        self.beside.as_deref()
    }

    /// This answer with another model's beside it.
    #[must_use]
    pub fn with_beside(mut self, beside: Self) -> Self {
        self.beside = Some(Arc::new(beside));
        self
    }

    /// Counts of evaluations, steps and events.
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// This answer up to `t`, as of a scene that ends then \[s\].
    #[must_use]
    pub fn cut(mut self, t: f64) -> Self {
        self.scene.duration = self.scene.duration.min(t);
        self.stop = self.stop.filter(|stop| stop.t <= t);
        self.shorten(t);
        self.beside = self.beside.map(|beside| Arc::new(Arc::unwrap_or_clone(beside).cut(t)));
        self
    }

    /// The answer of the impact model as far as two bodies meet between which it has no contact, and the reason for that end,
    /// where the scene asks for contact between all faces.
    #[must_use]
    pub(super) fn until_met(mut self) -> Self {
        if self.impact().is_none() || self.scene.contact.between == Between::Ends {
            return self;
        }
        let Some(met) = self.overlaps().first() else { return self };
        let (t, [one, other]) = (met.first(), met.bodies.map(|body| body.name(&self.scene)));
        // A run that has ended by then says why.
        if self.stop.as_ref().is_some_and(|stop| stop.t <= t) {
            return self;
        }
        let place = format!("{one}, {other}");
        let reason = Text::new("stop-no-contact").into();
        self.stop = Some(Stop { cause: Cause::NoContact, t, place, reason });
        self.shorten(t);
        self
    }

    /// Ends the answer at `t` at the latest \[s\], without what was found of the longer one.
    fn shorten(&mut self, t: f64) {
        self.trajectories.shorten(t);
        self.events.retain(|event| event.t <= t);
        self.record = self.record.take().map(|record| ImpactRecord::together(vec![record], t));
        self.found = Found::default();
    }

    /// Reason of a stop before the scene's duration.
    pub fn stop(&self) -> Option<&Stop> {
        self.stop.as_ref()
    }

    /// Memory without the scene \[bytes\]: paths, contact states, events.
    pub fn bytes(&self) -> usize {
        self.trajectories.bytes() + self.events.len() * size_of::<Event>()
    }

    /// State of a body as its integrator holds it, at `t` clamped to what was computed.
    pub(super) fn state(&self, body: usize, t: f64) -> BodyState {
        self.trajectories.state(body, t)
    }

    /// Pose and twist of a body at G.
    pub fn frame(&self, body: usize, t: f64) -> Frame {
        self.trajectories.section_frame(body, 0, t)
    }

    /// Motion of a girder at `t`, clamped to what was computed.
    pub fn motion(&self, girder: usize, t: f64) -> Motion {
        self.trajectories.motion(girder, t)
    }

    /// Motion of an end of a girder at `t`, clamped to what was computed, as of a rigid girder that has this end: place and displacement are
    /// those of its G. The same for both ends of a rigid girder.
    pub fn end_motion(&self, girder: usize, end: End, t: f64) -> Motion {
        self.trajectories.end_motion(girder, end, t)
    }

    /// All events in order of time.
    pub fn events(&self) -> &[Event] {
        &self.events
    }
}
