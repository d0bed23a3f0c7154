//! What the plots are drawn from, and the samples that are kept between frames.

use std::cell::RefCell;
use std::sync::Arc;

use crate::app::plot::sampled::{self, PanelCache, Sampled};
use crate::app::plot::traces::{TraceCache, Traces};
use crate::app::run::answer::Answer;
use crate::app::run::comparison::Pin;
use crate::app::time::playback::Playback;
use crate::scene::Scene;

/// What the plots are drawn from.
#[derive(Clone, Copy)]
pub(in crate::app) struct Source<'a> {
    /// The scene as it is now.
    pub(in crate::app) scene: &'a Scene,
    /// The last good answer.
    pub(in crate::app) answer: Option<&'a Arc<Answer>>,
    /// The girder whose curves stand out.
    pub(in crate::app) girder: usize,
    /// Runs kept to compare with.
    pub(in crate::app) pins: &'a [Pin],
    /// The time shown, and the window of time.
    pub(in crate::app) playback: &'a Playback,
    /// End of the answer \[s\].
    pub(in crate::app) end: f64,
    /// Samples kept between frames.
    pub(in crate::app) samples: &'a Samples,
}

/// Samples kept until something else is to be seen.
#[derive(Default)]
pub(in crate::app) struct Samples {
    traces: RefCell<TraceCache>,
    panels: RefCell<PanelCache>,
}

impl Source<'_> {
    /// Samples for the standing plots, about `points` long.
    pub(in crate::app) fn traces(&self, window: [f64; 2], points: usize) -> Arc<Traces> {
        let name = self.scene.girders.get(self.girder).map_or("", |g| g.name.as_str());
        let of = |a: &Arc<Answer>| self.samples.traces.borrow_mut().of(a, window, points, (name, self.pins));
        self.answer.map(of).unwrap_or_default()
    }

    /// Samples for the panels of the user's own.
    pub(in crate::app) fn own_panels(&self, window: [f64; 2], points: usize) -> Arc<Vec<Sampled>> {
        let plots = &self.scene.view.plots;
        let of = |a: &Arc<Answer>| self.samples.panels.borrow_mut().of((&a.history, a.number), plots, window, points);
        self.answer.filter(|_| !plots.is_empty()).map(of).unwrap_or_default()
    }

    /// Where the curves of an own panel are at the time shown.
    pub(in crate::app) fn own_at(&self, panel: usize) -> Vec<[f64; 2]> {
        let (Some(answer), Some(plot)) = (self.answer, self.scene.view.plots.get(panel)) else { return Vec::new() };
        sampled::at(answer, plot, self.playback.clock.t)
    }
}
