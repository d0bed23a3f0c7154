//! Data of the plots, and the samples that are kept between frames.

use std::cell::RefCell;
use std::sync::Arc;

use crate::app::plot::sampled::{self, PanelCache, Sampled};
use crate::app::plot::traces::{TraceCache, Traces};
use crate::app::plot::views::PlotViews;
use crate::app::plot::wave_picture::WaveCache;
use crate::app::run::answer::Answer;
use crate::app::run::comparison::Pin;
use crate::app::time::playback::Playback;
use crate::scene::{PlotSettings, PlotShows, Scene};
use crate::sim::OfSection;

/// Data of the plots.
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
    /// Whether the differences from kept runs are drawn instead of them.
    pub(in crate::app) differences: bool,
    /// The section force that is drawn of a girder that bends.
    pub(in crate::app) section_force: OfSection,
    /// Which values of the charts are shown.
    pub(in crate::app) views: &'a PlotViews,
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
    /// Of panels over time, and of the others.
    panels: [RefCell<PanelCache>; 2],
    pub(super) waves: RefCell<WaveCache>,
}

impl Source<'_> {
    /// Samples for the standing plots, about `points` long.
    pub(in crate::app) fn traces(&self, window: [f64; 2], points: usize) -> Arc<Traces> {
        let name = self.scene.girders.get(self.girder).map_or("", |g| g.name.as_str());
        let kept = (name, self.pins, self.differences);
        let of = |a: &Arc<Answer>| self.samples.traces.borrow_mut().of(a, window, points, kept);
        self.answer.map(of).unwrap_or_default()
    }

    /// Whether a panel is drawn over time.
    pub(in crate::app) fn is_over_time(plot: &PlotSettings) -> bool {
        plot.shows == PlotShows::History && plot.x.is_none()
    }

    /// Samples for the panels of the user's own that are drawn over time, or for the others, each with its number.
    pub(in crate::app) fn own_panels(
        &self,
        over_time: bool,
        (window, points): ([f64; 2], usize),
    ) -> (Vec<usize>, Arc<Vec<Sampled>>) {
        let plots = self.scene.view.plots.iter().enumerate().filter(|(_, plot)| Self::is_over_time(plot) == over_time);
        let (numbers, plots): (Vec<usize>, Vec<PlotSettings>) = plots.map(|(i, plot)| (i, plot.clone())).unzip();
        let cache = &self.samples.panels[usize::from(over_time)];
        let of = |a: &Arc<Answer>| cache.borrow_mut().of((&a.history, a.number), (&plots, self.pins), window, points);
        let panels = self.answer.filter(|_| !plots.is_empty()).map(of).unwrap_or_default();
        (numbers, panels)
    }

    /// Where the curves of an own panel are at a time, those of kept runs after its own \[s\].
    pub(in crate::app) fn own_at(&self, panel: usize, t: f64) -> Vec<[f64; 2]> {
        let (Some(answer), Some(plot)) = (self.answer, self.scene.view.plots.get(panel)) else { return Vec::new() };
        let kept = self.pins.iter().flat_map(|pin| sampled::at(&pin.answer, plot, t));
        sampled::at(answer, plot, t).into_iter().chain(kept).collect()
    }
}
