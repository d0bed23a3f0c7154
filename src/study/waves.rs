//! Waves in an elastic girder: a section force over time and station, as a picture and as a table.

use std::fmt::Write as _;

use crate::plot::Colors;
use crate::plot::heat_map::{HeatMap, Map, Steps};
use crate::sim::{History, OfSection, SectionField};

/// Times and stations of a picture, such that labels fall on round ones.
const COUNTS: [usize; 2] = [161, 81];
/// Transits of a wave that are shown after a hit.
const AFTER: f64 = 3.0;
/// Transits before it.
const BEFORE: f64 = 0.5;

/// Section force to draw: girder, quantity, span of time \[s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// Number of the girder.
    pub girder: usize,
    /// The section force.
    pub what: OfSection,
    /// From and until; what is left out follows from the hardest hit.
    pub span: [Option<f64>; 2],
}

/// Waves of one girder.
#[derive(Clone, Debug)]
pub struct Waves {
    /// The section force over time and station.
    pub field: SectionField,
    /// The girder's name.
    pub girder: String,
    what: OfSection,
    /// Way of a wave from end to end \[s\], and when the hardest hit began, where there is one.
    transit: f64,
    hit: Option<f64>,
}

impl Waves {
    /// Of a run; `None` where the girder does not bend.
    pub fn of(history: &History, wanted: &Wanted) -> Option<Self> {
        let flexible = history.sections().flexible(wanted.girder)?;
        let transit = flexible.beam.transit_time();
        let hit = history.sections().elastic_hit(wanted.girder);
        let [start, end] = hit_span(history, wanted.girder).unwrap_or([0.0, history.end()]);
        let from = wanted.span[0].unwrap_or(start).clamp(0.0, history.end());
        // An end that is not asked for makes the axis round.
        let length = wanted.span[1].map_or_else(|| round_up(end - from), |until| until - from);
        let span = [from, (from + length).min(history.end())];
        let field = history.sections().field(wanted.girder, wanted.what, span, COUNTS)?;
        let girder = history.scene().girders[wanted.girder].name.clone();
        Some(Self { field, girder, what: wanted.what, transit, hit: hit.map(|hit| hit.t) })
    }

    /// The picture.
    pub fn picture(&self) -> HeatMap {
        let (unit, size) = self.what.unit();
        let from = self.field.times[0];
        let hit = self.hit.map_or(String::new(), |t| format!("; hardest hit from {:.1} ms on", (t - from) * 1e3));
        HeatMap {
            title: format!("{}: {} over time and station", self.girder, self.what.label()),
            subtitle: format!("A wave runs from end to end in {:.2} ms{hit}.", self.transit * 1e3),
            x: Steps {
                name: format!("time after {from:.4} s [ms]"),
                values: self.field.times.iter().map(|t| rounded((t - from) * 1e3)).collect(),
                mark: None,
            },
            y: Steps {
                name: "station from −x end to +x end [m]".to_owned(),
                values: self.field.stations.iter().map(|s| rounded(*s)).collect(),
                mark: None,
            },
            bar: format!("[{unit}]"),
            colors: Colors::of_signed(self.what.is_signed()),
            maps: vec![Map {
                name: String::new(),
                values: self.field.values.iter().map(|value| Some(value / size)).collect(),
            }],
        }
    }

    /// The table: a row a time and station, SI.
    pub fn csv(&self) -> String {
        let mut text = String::from("t_s,station_m,value_si\n");
        let SectionField { times, stations, values } = &self.field;
        for (column, t) in times.iter().enumerate() {
            for (row, station) in stations.iter().enumerate() {
                let _ = writeln!(text, "{t:.9},{station:.6},{:.6e}", values[row * times.len() + column]);
            }
        }
        text
    }
}

/// From shortly before the hardest hit of a girder that bends until its wave has run some times \[s\]; `None` where nothing hits it.
pub fn hit_span(history: &History, girder: usize) -> Option<[f64; 2]> {
    let transit = history.sections().flexible(girder)?.beam.transit_time();
    let hit = history.sections().elastic_hit(girder)?;
    let end = (hit.t + hit.contact_time + AFTER * transit).min(history.end());
    Some([(hit.t - BEFORE * transit).max(0.0), end])
}

/// Time at which the force of the hardest hit of an elastic girder is largest \[s\]; `None` without a hit.
pub fn hit_peak(history: &History, girder: usize) -> Option<f64> {
    let hit = history.sections().elastic_hit(girder)?;
    let own =
        history.hits().poundings().iter().filter(|of| history.model().pairs[of.pair].bodies.contains(&Some(girder)));
    let within = own.flat_map(|of| &of.hits).filter(|one| one.start <= hit.t + hit.contact_time && one.end >= hit.t);
    within.map(|one| one.peak).reduce(|a, b| if b.value > a.value { b } else { a }).map(|peak| peak.t)
}

/// The next length that five labels divide into round numbers \[s\].
fn round_up(length: f64) -> f64 {
    let power = 10f64.powf(length.log10().floor());
    [1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 8.0, 10.0]
        .into_iter()
        .map(|x| x * power)
        .find(|x| *x >= length)
        .unwrap_or(length)
}

/// Without the rounding of the last bits.
fn rounded(x: f64) -> f64 {
    (x * 1e6).round() / 1e6
}
