//! The run of one group of bodies under either model: advance, states at a time, result.

use std::sync::Arc;

use crate::dynamics::contact_model::run::ContactRun;
use crate::dynamics::event_loop::effort::Effort;
use crate::dynamics::event_loop::event_driven::EventDriven;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::model::body::BodyCoordinates;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::record::event::{Event, Stop};
use crate::dynamics::record::link_log::LinkLog;
use crate::dynamics::record::recomputed_steps::RecomputedSteps;
use crate::dynamics::trajectory::stored_path::StoredPath;
use crate::dynamics::{Model, impact2d};
use crate::language::Text;
use crate::scene::ModelKind;

/// Result of the run of a group.
#[derive(Debug)]
pub struct Finished {
    /// Time reached \[s\].
    pub end: f64,
    /// Why it stopped early.
    pub stop: Option<Stop>,
    /// Motion of every body.
    pub bodies: Vec<FinishedBody>,
    /// Steps that are kept by their starts.
    pub recomputed: RecomputedSteps,
    /// Number and states of every contact (contact model).
    pub contacts: Vec<(usize, ContactLog)>,
    /// Number and phases of every link (contact model).
    pub links: Vec<(usize, LinkLog)>,
    /// Events in order of time (contact model).
    pub events: Vec<Event>,
    /// Hits, transitions and lasting contacts (impact model).
    pub record: Option<impact2d::ImpactRecord>,
    /// Counts of evaluations, steps and events.
    pub effort: Effort,
}

/// Motion of a body in a run.
#[derive(Debug)]
pub struct FinishedBody {
    /// Number in the model.
    pub body: usize,
    /// Path.
    pub path: StoredPath,
    /// Free motion; `None` of a body without a closed form.
    pub free_motion: Option<BodyMotion>,
}

/// A run of one group of bodies.
pub trait Run: EventDriven + std::fmt::Debug + Send + Sync {
    /// Number of contact events so far; 0 under the impact model, which records hits instead.
    fn events(&self) -> usize;

    /// Everything that was computed.
    fn finish(self: Box<Self>) -> Finished;
}

/// Sets up a group of bodies, by its number in the model, at t = 0; where both models are asked for, under the contact model.
pub fn start(model: &Arc<Model>, group: usize, kind: ModelKind) -> Box<dyn Run> {
    let planar = model.groups[group]
        .bodies
        .iter()
        .all(|&body| matches!(model.bodies[body].coordinates, BodyCoordinates::Planar));
    match kind {
        ModelKind::Contact | ModelKind::Both => Box::new(ContactRun::new(model, group)),
        ModelKind::Impact if !model.groups[group].links.is_empty() => {
            Box::new(ContactRun::refused(model, group, Text::new("stop-devices-in-impact")))
        }
        ModelKind::Impact if planar => Box::new(impact2d::run::ImpactRun::new(model, group)),
        ModelKind::Impact => Box::new(ContactRun::refused(model, group, Text::new("stop-space-in-impact"))),
    }
}

impl Run for ContactRun {
    fn events(&self) -> usize {
        self.events.len()
    }

    fn finish(mut self: Box<Self>) -> Finished {
        let end = self.end();
        let Self { world, schedule, events, store, .. } = *self;
        Finished {
            end,
            stop: schedule.stop().cloned(),
            bodies: world
                .bodies
                .into_iter()
                .map(|track| FinishedBody { body: track.body, path: track.path, free_motion: track.free_motion })
                .collect(),
            recomputed: store.recomputed,
            contacts: world.contacts.into_iter().map(|track| (track.site, track.log)).collect(),
            links: world.links.into_iter().map(|track| (track.link, track.log)).collect(),
            events,
            record: None,
            effort: schedule.effort,
        }
    }
}

impl Run for impact2d::run::ImpactRun {
    fn events(&self) -> usize {
        0
    }

    fn finish(mut self: Box<Self>) -> Finished {
        let end = self.end();
        let (bodies, record, schedule) = (*self).into_parts();
        Finished {
            end,
            stop: schedule.stop().cloned(),
            bodies: bodies
                .into_iter()
                .map(|track| FinishedBody {
                    body: track.body,
                    path: track.segments.into_iter().collect(),
                    free_motion: Some(BodyMotion::InPlan(track.free_motion)),
                })
                .collect(),
            recomputed: RecomputedSteps::default(),
            contacts: Vec::new(),
            links: Vec::new(),
            events: Vec::new(),
            record: Some(record),
            effort: schedule.effort,
        }
    }
}
