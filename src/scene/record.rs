//! A record of ground motion, as written in a scene: one component along an angle, or several by their azimuths.

use std::borrow::Cow;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Key, Range, Slot, Stands, Stated, Word, table};
use super::processing::Processing;
use crate::motion::format::{Orientation, Record, Unit};

/// `[motion]` of `kind = "record"`.
pub const RECORD: &[Key] = &[
    Key::new(
        "samples_m_s2",
        Range::Like("two or more numbers"),
        Fallback::Needed("this, file or component"),
        "acceleration from t = 0 on, m/s²",
    ),
    Key::new(
        "dt_s",
        Range::Positive,
        Fallback::Needed("must be given with samples_m_s2"),
        "interval between samples, s; beside a file only where that states none",
    )
    .labelled("field-interval")
    .slid([0.001, 0.1]),
    Key::new(
        "file",
        Range::Free,
        Fallback::Needed("this, samples_m_s2 or component"),
        "a file that holds it, beside the scene's file",
    ),
    Key::new("channel", CHANNEL, ONE_CHANNEL, "which channel of a file that has several"),
    Key::new("unit", Range::Words(Unit::WORDS), AS_STATED, "unit of the numbers in a file that states none"),
    Key::new("scale", Range::Any, Fallback::Number(1.0), "multiplies every sample")
        .labelled("field-record-scale")
        .slid([0.0, 3.0]),
    Key::new("angle_deg", Range::Any, Fallback::Number(0.0), "excitation angle α, degrees")
        .labelled("field-angle")
        .slid([-180.0, 180.0]),
    Key::new("vertical_scale", Range::Any, Fallback::Number(0.0), "multiplies every sample for a vertical component")
        .labelled("field-vertical-scale")
        .slid([0.0, 3.0])
        .in_space(),
    Key::new("processing", Range::Free, Fallback::Words("none"), "[motion.processing]"),
    Key::new(
        "x_azimuth_deg",
        Range::Any,
        Fallback::Words("must be given with component"),
        "azimuth of world x, clockwise from north, degrees",
    ),
    Key::new("component", Range::Free, Fallback::Words("none"), "[[motion.component]]"),
];

const CHANNEL: Range = Range::Like("a whole number from 1 on");
const ONE_CHANNEL: Fallback = Fallback::Words("the one channel of the file");
const AS_STATED: Fallback = Fallback::Words("as the file states");

impl Stands for usize {
    fn by_default(_: Fallback) -> Self {
        1
    }
}

impl Stands for Vec<f64> {
    fn by_default(_: Fallback) -> Self {
        Self::new()
    }

    fn stated(&self) -> Stated<'_> {
        Stated::Numbers(self)
    }
}

impl Stands for Unit {
    fn by_default(_: Fallback) -> Self {
        Self::MetrePerSecond2
    }

    fn optional_slot(value: &mut Option<Self>) -> Slot<'_> {
        Slot::Word(Word::optional(value, (Self::ALL, Self::WORDS)))
    }
}

table! {
    /// `[[motion.component]]`: one of several components of ground motion.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    default struct Component, COMPONENT {
        file: Option<String> = "file", Range::Free, Fallback::Needed("this or samples_m_s2"), "a file that holds it, beside the scene's file";
        channel: Option<usize> = "channel", CHANNEL, ONE_CHANNEL, "which channel of a file that has several";
        unit: Option<Unit> = "unit" as "field-unit", Range::Words(Unit::WORDS), AS_STATED, "unit of the numbers in a file that states none";
        samples: Option<Vec<f64>> = "samples_m_s2", Range::Like("two or more numbers"), Fallback::Needed("this or file"),
            "acceleration from t = 0 on, m/s²";
        dt: Option<f64> = "dt_s" as "field-interval", Range::Positive, Fallback::Needed("must be given with samples_m_s2"),
            "interval between samples, s; beside a file only where that states none";
        azimuth_deg: Option<f64> = "azimuth_deg" as "field-azimuth", Range::Any, Fallback::Words("as the file states"),
            "azimuth of positive samples, clockwise from north, degrees";
        vertical: Option<bool> = "vertical" as "field-points", Range::Switch, Fallback::Words("as the file states"), "whether positive samples point upwards";
        scale: f64 = "scale" as "field-factor", Range::Any, Fallback::Number(1.0), "multiplies every sample of this component";
    }
}

/// Components of a record together as they shake, world frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Combined {
    /// Interval \[s\].
    pub dt: f64,
    /// Samples of their sum \[m/s²\]; a component is 0 after its own last.
    pub samples: Vec<[f64; 3]>,
    /// Of each component that ends before others, number and value of its last sample \[m/s²\].
    pub ends: Vec<(usize, [f64; 3])>,
}

/// `kind = "record"`: samples at a constant interval, straight lines between them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordMotion {
    /// Acceleration samples \[m/s²\]; these with `dt_s`, or `file`.
    #[serde(rename = "samples_m_s2", default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<Vec<f64>>,
    /// Interval between samples \[s\].
    #[serde(rename = "dt_s", default, skip_serializing_if = "Option::is_none")]
    pub dt: Option<f64>,
    /// File of the record, relative to the scene's file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Number of the file's channel, from 1; needed where the file has several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub channel: Option<usize>,
    /// Unit of the numbers in a file that states none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<Unit>,
    /// Multiplies every sample.
    #[serde(default = "one")]
    pub scale: f64,
    /// Excitation angle α, anticlockwise from world x \[degrees\].
    #[serde(default)]
    pub angle_deg: f64,
    /// Multiplies every sample for a vertical component.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub vertical_scale: f64,
    /// Processing of the samples before they are scaled.
    #[serde(default, skip_serializing_if = "Stands::is_left_out")]
    pub processing: Processing,
    /// Azimuth of world x, clockwise from north \[degrees\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x_azimuth_deg: Option<f64>,
    /// Several components in place of the one above.
    #[serde(rename = "component", default, skip_serializing_if = "Vec::is_empty")]
    pub components: Vec<Component>,
    /// Samples of `file`, once it has been read. Never written.
    #[serde(skip)]
    pub loaded: Option<Arc<Record>>,
    /// Samples of each component's file.
    #[serde(skip)]
    pub loaded_components: Vec<Option<Arc<Record>>>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

fn one() -> f64 {
    1.0
}

impl Default for RecordMotion {
    /// No samples yet, scale 1 along x.
    fn default() -> Self {
        Self {
            samples: None,
            dt: None,
            file: None,
            channel: None,
            unit: None,
            scale: 1.0,
            angle_deg: 0.0,
            vertical_scale: 0.0,
            processing: Processing::default(),
            x_azimuth_deg: None,
            components: Vec::new(),
            loaded: None,
            loaded_components: Vec::new(),
        }
    }
}

/// Direction of a component in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Heading {
    /// Anticlockwise from world x \[degrees\].
    InPlan(f64),
    /// Upwards.
    Up,
}

/// Interval and samples of what is stated in a scene, else of what was read: s and m/s².
fn series<'a>(
    own: (Option<&'a Vec<f64>>, Option<f64>),
    loaded: Option<&'a Arc<Record>>,
    channel: Option<usize>,
) -> Option<(f64, &'a [f64])> {
    match (own, loaded) {
        ((Some(samples), Some(dt)), _) => Some((dt, samples)),
        ((None, _), Some(loaded)) => {
            loaded.channel(channel).ok().map(|channel| (channel.dt, channel.samples.as_slice()))
        }
        _ => None,
    }
}

impl RecordMotion {
    /// `(dt, samples)` in s and m/s², unscaled, from the scene or from the file that was read; `None` until it is, and where
    /// the file has no such channel.
    pub fn series(&self) -> Option<(f64, &[f64])> {
        series((self.samples.as_ref(), self.dt), self.loaded.as_ref(), self.channel)
    }

    /// Interval \[s\] and samples of a component, by its place in the list.
    pub fn component_series(&self, n: usize) -> Option<(f64, &[f64])> {
        let (component, loaded) = (self.components.get(n)?, self.loaded_components.get(n).and_then(Option::as_ref));
        series((component.samples.as_ref(), component.dt), loaded, component.channel)
    }

    /// Samples of a component's file, by the component's place in the list.
    pub fn component_record(&self, n: usize) -> Option<&Record> {
        self.loaded_components.get(n)?.as_deref()
    }

    /// Direction of a component: as stated, else as its file states; `None` where neither does, or where the azimuth of world
    /// x is not stated.
    pub fn heading(&self, n: usize) -> Option<Heading> {
        let component = self.components.get(n)?;
        let read = || self.component_record(n)?.channel(component.channel).ok().map(|channel| channel.orientation);
        let azimuth = match (component.vertical, component.azimuth_deg) {
            (Some(true), _) => return Some(Heading::Up),
            (_, Some(azimuth)) => azimuth,
            (stated, None) => match read()? {
                Orientation::Up if stated.is_none() => return Some(Heading::Up),
                Orientation::Azimuth(azimuth) => azimuth,
                _ => return None,
            },
        };
        Some(Heading::InPlan(self.x_azimuth_deg? - azimuth))
    }

    /// The one component as it shakes, unscaled: interval \[s\], samples \[m/s²\], and the factor that `processing.peak_g`
    /// makes of them.
    pub fn processed(&self) -> Option<(f64, Cow<'_, [f64]>, f64)> {
        let (dt, samples) = self.series()?;
        let (dt, samples) = self.processing.apply(dt, samples);
        let factor = self.processing.factor(|| samples.iter().fold(0.0, |most, a| most.max(a.abs())));
        Some((dt, samples, factor))
    }

    /// All components together as they shake, scaled; `direction` turns degrees from world x into a unit vector in plan.
    pub fn combined(&self, direction: impl Fn(f64) -> [f64; 2]) -> Option<Combined> {
        let (mut dt, mut sum, mut ends) = (None, Vec::<[f64; 3]>::new(), Vec::new());
        for (n, component) in self.components.iter().enumerate() {
            let (own, samples) = self.component_series(n)?;
            let (own, samples) = self.processing.apply(own, samples);
            dt = dt.or(Some(own));
            let along = match self.heading(n)? {
                Heading::Up => [0.0, 0.0, 1.0],
                Heading::InPlan(angle) => {
                    let [x, y] = direction(angle);
                    [x, y, 0.0]
                }
            };
            sum.resize(sum.len().max(samples.len()), [0.0; 3]);
            for (sum, a) in sum.iter_mut().zip(samples.iter()) {
                (0..3).for_each(|i| sum[i] += along[i] * (component.scale * a));
            }
            ends.extend(samples.last().map(|a| (samples.len() - 1, along.map(|i| i * (component.scale * a)))));
        }
        ends.retain(|(sample, _)| sample + 1 < sum.len());
        let largest = || sum.iter().fold(0.0_f64, |most, a| most.max(a[0].hypot(a[1]).hypot(a[2])));
        let factor = self.scale * self.processing.factor(largest);
        for a in sum.iter_mut().chain(ends.iter_mut().map(|(_, last)| last)).flatten() {
            *a *= factor;
        }
        Some(Combined { dt: dt?, samples: sum, ends })
    }

    /// Largest magnitude as it shakes \[m/s²\], interval \[s\] and number of samples.
    pub fn extent(&self) -> Option<(f64, f64, usize)> {
        if self.components.is_empty() {
            let (dt, samples, factor) = self.processed()?;
            let peak = samples.iter().fold(0.0_f64, |most, sample| most.max(sample.abs()));
            return Some((peak * (factor * self.scale.abs().max(self.vertical_scale.abs())), dt, samples.len()));
        }
        // A turn changes no magnitude.
        let Combined { dt, samples, .. } = self.combined(|angle| angle.to_radians().sin_cos().into())?;
        let peak = samples.iter().fold(0.0_f64, |most, a| most.max(a[0].hypot(a[1]).hypot(a[2])));
        Some((peak, dt, samples.len()))
    }

    /// Samples of the scene's own in place of those of files; whether there were any.
    pub fn keep_samples(&mut self) -> bool {
        let kept = |(dt, samples): (f64, &[f64])| (dt, samples.to_vec());
        let mut any = false;
        if let Some((dt, samples)) = self.file.as_ref().and(self.series().map(kept)) {
            (self.dt, self.samples) = (Some(dt), Some(samples));
            (self.file, self.channel, self.unit, self.loaded) = (None, None, None, None);
            any = true;
        }
        for n in 0..self.components.len() {
            let (Some((dt, samples)), heading) = (self.component_series(n).map(kept), self.heading(n)) else {
                continue;
            };
            let azimuth = self.component_azimuth(heading);
            let component = &mut self.components[n];
            if component.file.take().is_some() {
                (component.dt, component.samples) = (Some(dt), Some(samples));
                (component.channel, component.unit) = (None, None);
                component.azimuth_deg = component.azimuth_deg.or(azimuth);
                component.vertical = component.vertical.or((heading == Some(Heading::Up)).then_some(true));
                any = true;
            }
        }
        self.loaded_components.clear();
        any
    }

    /// Azimuth of a heading, clockwise from north \[degrees\].
    fn component_azimuth(&self, heading: Option<Heading>) -> Option<f64> {
        let Some(Heading::InPlan(angle)) = heading else { return None };
        Some((self.x_azimuth_deg? - angle).rem_euclid(360.0))
    }

    /// Takes over what was read for another, where the same would be read, and keeps nothing else.
    pub fn take_loaded(&mut self, before: &Self) {
        let same = (&self.file, self.dt, self.unit) == (&before.file, before.dt, before.unit);
        self.loaded = before.loaded.clone().filter(|_| same && self.file.is_some());
        let same =
            |own: &Component, other: &Component| (&own.file, own.dt, own.unit) == (&other.file, other.dt, other.unit);
        let known = |own: &Component| {
            own.file.as_ref()?;
            let at = before.components.iter().position(|other| same(own, other))?;
            before.loaded_components.get(at)?.clone()
        };
        self.loaded_components = self.components.iter().map(known).collect();
        if self.loaded_components.iter().all(Option::is_none) {
            self.loaded_components.clear();
        }
    }
}
