//! Contents of each chart: curves with their styles, and names with values for its legend.

use std::borrow::Cow;

use egui::Color32;
use egui_plot::LineStyle;

use crate::app::plot::resolution::Curve;
use crate::app::plot::sampled::Sampled;
use crate::app::plot::source::Source;
use crate::app::plot::traces::{Band, Traces};
use crate::app::plot::value_axis::range;
use crate::app::style::theme::{OWN, PINS, Palette};
use crate::app::text;

/// A curve as it is drawn.
pub(super) struct Drawn<'a> {
    pub(super) curve: Cow<'a, Curve>,
    pub(super) color: Color32,
    pub(super) style: LineStyle,
    /// Whether it is the one to look at.
    pub(super) chosen: bool,
}

/// A line of a legend.
pub(super) struct Entry {
    pub(super) name: String,
    pub(super) color: Color32,
    pub(super) style: LineStyle,
    /// Its value at the time pointed to, or at the time shown.
    pub(super) value: Option<f64>,
}

/// A set of curves in one frame.
pub(super) struct Chart<'a> {
    pub(super) name: String,
    /// Unit of its values.
    pub(super) unit: &'static str,
    pub(super) curves: Vec<Drawn<'a>>,
    /// Bands of crowds of curves, behind them.
    pub(super) bands: Vec<(&'a Band, Color32)>,
    pub(super) entries: Vec<Entry>,
    /// Filled down to 0, the highest first.
    pub(super) filled: bool,
    /// Whether it shows logarithms of magnitudes.
    pub(super) log: bool,
    /// In words, what it was to show and the run does not have.
    pub(super) missing: String,
}

impl Chart<'_> {
    /// Lowest and highest value.
    pub(super) fn range(&self) -> [f64; 2] {
        let bands = self.bands.iter().flat_map(|(band, _)| band.low.iter().chain(&band.high).copied());
        range(self.curves.iter().flat_map(|c| c.curve.iter().map(|p| p[1])).chain(bands), self.log)
    }
}

/// Charts of every scene over time: place, rotation, contact force; `at` is the time that the legends are about \[s\].
pub(super) fn standing<'a>(source: &Source<'_>, traces: &'a Traces, at: f64, palette: &Palette) -> Vec<Chart<'a>> {
    let dashed = LineStyle::Dashed { length: 7.0 };
    let now = values(source, at);
    let name = |quantity: &str| named(source, quantity);
    let [x, y, turn] = traces.bands.as_ref().map_or([None; 3], |[x, y, turn]| [Some(x), Some(y), Some(turn)]);
    let band = |band: Option<&'a Band>, color: Color32| band.map(|band| (band, color.gamma_multiply(0.3)));
    let mut place = Chart {
        name: text::PLOT_PLACE.to_string(),
        unit: "mm",
        curves: several(source, traces, (&traces.x, palette.x, LineStyle::Solid)),
        bands: band(x, palette.x).into_iter().chain(band(y, palette.y)).collect(),
        entries: vec![
            Entry { name: name("x"), color: palette.x, style: LineStyle::Solid, value: now.map(|v| v[0]) },
            Entry { name: name("y"), color: palette.y, style: dashed, value: now.map(|v| v[1]) },
        ],
        filled: false,
        log: false,
        missing: String::new(),
    };
    place.curves.extend(several(source, traces, (&traces.y, palette.y, dashed)));
    let mut theta = Chart {
        name: text::PLOT_THETA.to_string(),
        unit: "°",
        curves: several(source, traces, (&traces.theta, palette.theta, LineStyle::Solid)),
        bands: band(turn, palette.theta).into_iter().collect(),
        entries: vec![Entry {
            name: name("θ"),
            color: palette.theta,
            style: LineStyle::Solid,
            value: now.map(|v| v[2]),
        }],
        filled: false,
        log: false,
        missing: String::new(),
    };
    beside(source, traces, [&mut place, &mut theta], at, palette);
    pinned(source, traces, [&mut place, &mut theta], at);
    for chart in [&mut place, &mut theta] {
        // The girder in question is drawn last, over the others.
        chart.curves.sort_by_key(|c| c.chosen);
    }
    vec![place, theta, force(source, traces, at, palette)]
}

/// A quantity of the girder in question, with the girder's name where there are others.
fn named(source: &Source<'_>, quantity: &str) -> String {
    match source.answer.map(|answer| answer.history.model().girders()) {
        Some(girders) if girders.len() > 1 => {
            girders.get(source.girder).map_or_else(|| quantity.into(), |girder| format!("{}.{quantity}", girder.name))
        }
        _ => quantity.into(),
    }
}

/// x, y \[mm\] and θ \[°\] of the girder in question.
fn values(source: &Source<'_>, at: f64) -> Option<[f64; 3]> {
    let history = &source.answer?.history;
    (source.girder < history.model().girders().len()).then(|| {
        let motion = history.motion(source.girder, at);
        [motion.displacement.x * 1e3, motion.displacement.y * 1e3, motion.theta.to_degrees()]
    })
}

/// Curves of every girder, the one in question strongest; of a crowd that one alone, as the others are in the band.
fn several<'a>(
    source: &Source<'_>,
    traces: &Traces,
    (curves, color, style): (&'a [Curve], Color32, LineStyle),
) -> Vec<Drawn<'a>> {
    let alone = traces.bands.is_some();
    // Dashes of a band would make a pattern that is not there; two bands are seen through each other.
    let (style, color) = if traces.dense { (LineStyle::Solid, color.gamma_multiply(0.6)) } else { (style, color) };
    let drawn = |(i, curve): (usize, &'a Curve)| {
        let chosen = i == source.girder;
        Drawn {
            curve: Cow::Borrowed(curve),
            color: if chosen { color } else { color.gamma_multiply(0.3) },
            style,
            chosen,
        }
    };
    curves.iter().enumerate().map(drawn).filter(|c| c.chosen || !alone).collect()
}

/// The other model's motion, dotted.
fn beside<'a>(
    source: &Source<'_>,
    traces: &'a Traces,
    [place, theta]: [&mut Chart<'a>; 2],
    at: f64,
    palette: &Palette,
) {
    let Some(other) = source.answer.and_then(|answer| answer.history.beside()) else { return };
    let style = LineStyle::Dotted { spacing: 4.0 };
    let motion = other.motion(source.girder.min(other.model().girders().len().saturating_sub(1)), at);
    let rows = [
        ("x", palette.x, motion.displacement.x * 1e3),
        ("y", palette.y, motion.displacement.y * 1e3),
        ("θ", palette.theta, motion.theta.to_degrees()),
    ];
    for (n, (name, color, value)) in rows.into_iter().enumerate() {
        let chart = if n < 2 { &mut *place } else { &mut *theta };
        chart.curves.extend(several(source, traces, (&traces.ghosts[n], color, style)));
        chart.entries.push(Entry { name: text::by_impacts(name), color, style, value: Some(value) });
    }
}

/// Runs that are kept, or by how much the run differs from each.
fn pinned<'a>(source: &Source<'_>, traces: &'a Traces, [place, theta]: [&mut Chart<'a>; 2], at: f64) {
    let now = values(source, at).unwrap_or([f64::NAN; 3]);
    for pin in &traces.pins {
        let there = source.pins.iter().find(|p| p.color == pin.color).map_or([f64::NAN; 3], |p| {
            let motion = p.answer.history.motion(pin.girder, at);
            [motion.displacement.x * 1e3, motion.displacement.y * 1e3, motion.theta.to_degrees()]
        });
        let number = source.pins.iter().position(|p| p.color == pin.color).unwrap_or(0) + 1;
        for (n, name) in ["x", "y", "θ"].into_iter().enumerate() {
            let chart = if n < 2 { &mut *place } else { &mut *theta };
            let style = if n == 1 { LineStyle::Dashed { length: 4.0 } } else { pin_style(pin.color) };
            let color = PINS[pin.color];
            chart.curves.push(Drawn { curve: Cow::Borrowed(&pin.curves[n]), color, style, chosen: false });
            let value = if traces.differences { now[n] - there[n] } else { there[n] };
            let name = if traces.differences { text::less_pin(name, number) } else { text::of_pin(name, number) };
            chart.entries.push(Entry { name, color, style, value: Some(value).filter(|v| v.is_finite()) });
        }
    }
}

/// Kept runs differ by their dashes too.
fn pin_style(color: usize) -> LineStyle {
    match color {
        0 => LineStyle::Solid,
        1 => LineStyle::Dashed { length: 10.0 },
        2 => LineStyle::Dashed { length: 5.0 },
        _ => LineStyle::Dotted { spacing: 5.0 },
    }
}

fn force<'a>(source: &Source<'_>, traces: &'a Traces, at: f64, palette: &Palette) -> Chart<'a> {
    let drawn = |curve: &'a Curve, color: Color32, style: LineStyle, chosen: bool| Drawn {
        curve: Cow::Borrowed(curve),
        color,
        style,
        chosen,
    };
    let value = source.answer.map(|answer| answer.history.hits().largest_resultant(at));
    let mut entries = vec![Entry { name: "|ΣR|".into(), color: palette.force, style: LineStyle::Solid, value }];
    let mut curves = Vec::new();
    // Of spikes at other times no difference is drawn: kept runs stand behind the one shown.
    for (number, pin) in (1..).zip(source.pins) {
        let (color, style) = (PINS[pin.color], pin_style(pin.color));
        let kept = traces.pins.iter().filter(|kept| kept.color == pin.color).flat_map(|kept| &kept.force);
        curves.extend(kept.map(|curve| drawn(curve, color, style, false)));
        let value = Some(pin.answer.history.hits().largest_resultant(at));
        entries.push(Entry { name: text::of_pin("|ΣR|", number), color, style, value });
    }
    curves.extend(traces.force.iter().map(|curve| drawn(curve, palette.force, LineStyle::Solid, true)));
    Chart {
        name: text::PLOT_FORCE.to_string(),
        unit: "N",
        curves,
        bands: Vec::new(),
        entries,
        filled: false,
        log: false,
        missing: String::new(),
    }
}

/// A panel of the user's own, against time; `values` are those of its curves at the time that the legend is about.
pub(super) fn own<'a>(panel: &'a Sampled, stack: &'a [Curve], values: &[[f64; 2]]) -> Chart<'a> {
    let log = panel.log[1] && !panel.stacked;
    let magnitude = |p: &[f64; 2]| [p[0], p[1].abs().log10()];
    let shown = |curve: &'a Curve| {
        if log {
            Cow::Owned(curve.iter().map(magnitude).filter(|p| p[1].is_finite()).collect())
        } else {
            Cow::Borrowed(curve)
        }
    };
    let plain = panel.curves.iter().map(|(_, curve)| curve);
    let curves: Vec<&Curve> = if panel.stacked { stack.iter().collect() } else { plain.collect() };
    let drawn = |(i, curve)| {
        let (color, style) = look(panel, i);
        Drawn { curve: shown(curve), color, style, chosen: panel.kept(i).is_none() }
    };
    // Kept runs lie behind the one shown. Of energies one upon the other the highest is filled first, so that the lower ones lie on it.
    let curves: Vec<Drawn<'a>> = curves.into_iter().enumerate().rev().map(drawn).collect();
    let entry = |(i, (name, _)): (usize, &(String, Curve))| {
        let (color, style) = look(panel, i);
        Entry { name: name.clone(), color, style, value: values.get(i).map(|v| v[1]) }
    };
    let named = panel.curves.iter().enumerate().filter(|(i, _)| panel.kept(*i).is_none());
    let names: Vec<&str> = named.map(|(_, (name, _))| name.as_str()).collect();
    Chart {
        name: names.join(", "),
        unit: panel.unit,
        curves,
        bands: Vec::new(),
        entries: panel.curves.iter().enumerate().map(entry).collect(),
        filled: panel.stacked,
        log,
        missing: if panel.missing.is_empty() { String::new() } else { text::missing(&panel.missing) },
    }
}

/// Colour and dashes of a curve of a panel of the user's own: by its place there, of a kept run those of that.
pub(super) fn look(panel: &Sampled, i: usize) -> (Color32, LineStyle) {
    if let Some(color) = panel.kept(i) {
        return (PINS[color], pin_style(color));
    }
    let style = if i < OWN.len() { LineStyle::Solid } else { LineStyle::Dashed { length: 6.0 } };
    (OWN[i % OWN.len()], style)
}

/// Curves one upon the other.
pub(super) fn stack(panel: &Sampled) -> Vec<Curve> {
    if !panel.stacked {
        return Vec::new();
    }
    let mut under: Curve = Vec::new();
    let mut all = Vec::with_capacity(panel.curves.len());
    for (_, curve) in &panel.curves {
        let sum = |(i, p): (usize, &[f64; 2])| [p[0], p[1] + under.get(i).map_or(0.0, |u| u[1])];
        under = curve.iter().enumerate().map(sum).collect();
        all.push(under.clone());
    }
    all
}
