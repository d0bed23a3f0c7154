//! Plot panels that the user has made, sampled: any quantity against time or against another.

use std::sync::Arc;

use crate::app::plot::resolution;
use crate::app::run::answer::Answer;
use crate::app::run::comparison::Pin;
use crate::app::text;
use crate::scene::{PlotSettings, PlotShows};
use crate::sim::{History, Quantity, spectra};

/// Points that a touch adds to a curve of a contact, so that its peak is not lost between two samples.
const IN_A_TOUCH: u32 = 6;

/// Most points of a curve.
const MOST_POINTS: usize = 20_000;

/// A panel's curves over a window of time.
#[derive(Clone, Debug, Default)]
pub(in crate::app) struct Sampled {
    /// Name, unit shown, values `[x or t, y]` in shown units.
    pub(in crate::app) curves: Vec<(String, Vec<[f64; 2]>)>,
    /// Upright quantity, with its unit.
    pub(in crate::app) y: String,
    /// That unit.
    pub(in crate::app) unit: &'static str,
    /// Level quantity, with its unit; time when absent.
    pub(in crate::app) x: Option<String>,
    /// Whether the level and the upright axis are logarithmic.
    pub(in crate::app) log: [bool; 2],
    /// Whether the curves are energies that are stored or lost: drawn one upon the other.
    pub(in crate::app) stacked: bool,
    /// Names of the panel's quantities that the run does not have.
    pub(in crate::app) missing: Vec<String>,
    /// Colours of the kept runs that the last curves are of.
    kept: Vec<usize>,
}

impl Sampled {
    /// Adds what kept runs say of the same panel; energies one upon the other stay alone.
    pub(in crate::app) fn beside_kept(
        mut self,
        pins: &[Pin],
        plot: &PlotSettings,
        window: [f64; 2],
        points: usize,
    ) -> Self {
        if self.stacked {
            return self;
        }
        for (number, pin) in (1..).zip(pins) {
            for (name, curve) in sample(&pin.answer.history, plot, window, points).curves {
                self.curves.push((text::of_pin(&name, number), curve));
                self.kept.push(pin.color);
            }
        }
        self
    }

    /// Colour of the kept run that the curve of this number is of; none of the run shown.
    pub(in crate::app) fn kept(&self, curve: usize) -> Option<usize> {
        let own = self.curves.len() - self.kept.len();
        self.kept.get(curve.checked_sub(own)?).copied()
    }

    /// As it is drawn in so many columns of a window of time. Against another quantity every point is a place; energies one upon the
    /// other share their times.
    pub(in crate::app) fn by_columns(mut self, window: [f64; 2], columns: usize) -> Self {
        if self.x.is_none() && !self.stacked {
            for (_, curve) in &mut self.curves {
                *curve = resolution::by_columns(std::mem::take(curve), window, columns.max(2));
            }
        }
        self
    }
}

/// Inputs that panels were sampled for.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    answer: u64,
    window: [f64; 2],
    points: usize,
    plots: Vec<PlotSettings>,
    pins: Vec<u64>,
}

/// Keeps the last samples until something else is to be seen.
#[derive(Default)]
pub(in crate::app) struct PanelCache {
    key: Option<Key>,
    panels: Arc<Vec<Sampled>>,
}

impl PanelCache {
    /// Every panel over a window, kept runs with it, about `points` samples long.
    pub(in crate::app) fn of(
        &mut self,
        (history, answer): (&History, u64),
        (plots, pins): (&[PlotSettings], &[Pin]),
        window: [f64; 2],
        points: usize,
    ) -> Arc<Vec<Sampled>> {
        let numbers = pins.iter().map(|pin| pin.answer.number).collect();
        let key = Key { answer, window, points, plots: plots.to_vec(), pins: numbers };
        if self.key.as_ref() != Some(&key) {
            let drawn = |p: &PlotSettings| {
                let sampled = sample(history, p, window, points).beside_kept(pins, p, window, points);
                sampled.by_columns(window, points)
            };
            self.panels = Arc::new(plots.iter().map(drawn).collect());
            self.key = Some(key);
        }
        self.panels.clone()
    }
}

/// A unit at an axis: a pure number has a dash.
fn in_brackets(unit: &str) -> String {
    format!("[{}]", if unit.is_empty() { "–" } else { unit })
}

/// A quantity of a panel, with its name.
type Found<'a> = (&'a String, Quantity);

/// A panel's curves, all at the same times; quantities that the run does not have are left out.
pub(in crate::app) fn sample(history: &History, plot: &PlotSettings, window: [f64; 2], points: usize) -> Sampled {
    let found: Vec<Found<'_>> = plot.y.iter().filter_map(|name| Some((name, Quantity::find(history, name)?))).collect();
    let is_missing = |name: &&String| Quantity::find(history, name).is_none();
    let missing: Vec<String> = plot.x.iter().chain(&plot.y).filter(is_missing).cloned().collect();
    if plot.shows == PlotShows::History
        && let Some(x) = plot.x.as_ref().filter(|x| missing.contains(x))
    {
        // Nothing can be drawn against it.
        return Sampled { x: Some(x.clone()), missing, ..Sampled::default() };
    }
    let sampled = match plot.shows {
        PlotShows::History => course(history, plot, &found, (window, points)),
        PlotShows::Fourier | PlotShows::Response => spectrum(history, plot, &found, window),
    };
    Sampled { missing, ..sampled }
}

/// Spectra of the stretch of time shown.
fn spectrum(history: &History, plot: &PlotSettings, found: &[Found<'_>], window: [f64; 2]) -> Sampled {
    let fourier = plot.shows == PlotShows::Fourier;
    let of = if fourier { spectra::fourier } else { spectra::response };
    let curve = |(name, quantity): &Found<'_>| {
        let (factor, _) = quantity.unit().shown();
        let lines = of(history, *quantity, window).into_iter().map(|[x, y]| [x, y * factor]);
        ((*name).clone(), lines.collect())
    };
    let unit = found.first().map_or("", |(_, q)| q.unit().shown().1);
    Sampled {
        curves: found.iter().map(curve).collect(),
        y: if fourier { format!("[{unit}·s]") } else { format!("[{unit}], 5 %") },
        unit,
        x: Some(if fourier { "f [Hz]" } else { "T [s]" }.to_owned()),
        log: [plot.log; 2],
        ..Sampled::default()
    }
}

/// Curves over time, or over another quantity.
fn course(history: &History, plot: &PlotSettings, found: &[Found<'_>], (window, points): ([f64; 2], usize)) -> Sampled {
    let x = plot.x.as_ref().and_then(|name| Some((name, Quantity::find(history, name)?)));
    let stacked = x.is_none() && found.len() > 1 && found.iter().all(|(_, q)| matches!(q, Quantity::Energy(_)));
    let end = [window[0], window[1].min(history.end())];
    let values = |t: f64| x.iter().chain(found).map(|(_, quantity)| quantity.at(history, t)).collect();
    let intervals = points.max(2) - 1;
    let fine = 1 + intervals * resolution::parts(end, intervals, MOST_POINTS, values);
    let times = times(history, window, fine);
    let (factor_x, unit_x) = x.map_or((1.0, "s"), |(_, q)| q.unit().shown());
    let level = |t: f64| x.map_or(t, |(_, q)| q.at(history, t) * factor_x);
    let curve = |(name, quantity): &Found<'_>| {
        let (factor, _) = quantity.unit().shown();
        let point = |&t: &f64| [level(t), quantity.at(history, t) * factor];
        ((*name).clone(), times.iter().map(point).collect())
    };
    let unit = found.first().map_or("", |(_, q)| q.unit().shown().1);
    Sampled {
        curves: found.iter().map(curve).collect(),
        y: in_brackets(unit),
        unit,
        log: [false, plot.log],
        x: x.map(|(name, _)| format!("{name} {}", in_brackets(unit_x))),
        stacked,
        ..Sampled::default()
    }
}

/// The panel's points at one instant; a spectrum has none.
pub(in crate::app) fn at(answer: &Answer, plot: &PlotSettings, t: f64) -> Vec<[f64; 2]> {
    if plot.shows != PlotShows::History {
        return Vec::new();
    }
    let value = |name: &String| {
        let quantity = answer.quantity(name)?;
        Some(quantity.at(&answer.history, t) * quantity.unit().shown().0)
    };
    let level = match &plot.x {
        None => t,
        Some(x) => match value(x) {
            Some(level) => level,
            None => return Vec::new(),
        },
    };
    plot.y.iter().filter_map(value).map(|y| [level, y]).collect()
}

/// Evenly spaced times, and enough of them inside every touch.
fn times(history: &History, window: [f64; 2], points: usize) -> Vec<f64> {
    let (from, to) = (window[0], window[1].min(history.end()));
    let step = (to - from) / (points.max(2) - 1) as f64;
    let mut times: Vec<f64> = (0..points.max(2)).map(|i| from + step * i as f64).collect();
    for touch in history.hits().touches().iter().filter(|touch| touch.end >= from && touch.start <= to) {
        if times.len() > MOST_POINTS {
            break;
        }
        let inside =
            (0..=IN_A_TOUCH).map(|i| touch.start + (touch.end - touch.start) * f64::from(i) / f64::from(IN_A_TOUCH));
        times.extend(inside.chain([touch.peak_time]).filter(|t| (from..=to).contains(t)));
    }
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}
