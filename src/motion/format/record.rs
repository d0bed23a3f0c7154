//! A record of ground motion as read, and what a format of record files is.

use std::path::Path;

use super::unit::Unit;
use crate::language::{Message, Text, message};

/// A format of record files.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// Name of the format.
    pub name: &'static str,
    /// Usual extensions of its files, lower case, without the dot.
    pub extensions: &'static [&'static str],
    /// Contents of such a file, with units.
    pub contents: Text,
    /// Whether the first lines of a file are in this format.
    pub(super) sniff: fn(&[u8]) -> bool,
    /// Reads a whole file: its channels, one at least.
    pub(super) read: fn(&[u8], &Supplement) -> Result<Vec<Channel>, RecordError>,
}

/// Values from keys beside a file, for formats whose files may leave them out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Supplement {
    /// Interval between samples \[s\].
    pub dt: Option<f64>,
    /// Unit of the numbers in the file.
    pub unit: Option<Unit>,
}

/// A file of ground motion as read.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Name of its format.
    pub format: &'static str,
    /// Its channels, in the order of the file; one at least.
    pub channels: Vec<Channel>,
}

/// Direction of positive acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Orientation {
    /// The file states none.
    #[default]
    Unstated,
    /// Horizontal, clockwise from north \[degrees\].
    Azimuth(f64),
    /// Upwards.
    Up,
}

/// An evenly sampled acceleration, one component of ground motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name in the file; empty where it has none.
    pub name: String,
    /// Direction of positive samples.
    pub orientation: Orientation,
    /// Unit of the numbers in the file.
    pub unit: Unit,
    /// Interval \[s\].
    pub dt: f64,
    /// Samples from t = 0 on \[m/s²\].
    pub samples: Vec<f64>,
    /// Processing of the file's numbers, in order, as texts.
    pub done: Vec<Message>,
}

/// Fault of a record.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", self.message())]
pub struct RecordError {
    /// Line in the file, from 1.
    pub line: u64,
    /// Value found.
    pub value: Message,
    /// Remedy.
    pub remedy: Message,
}

impl RecordError {
    pub(super) fn new(line: u64, value: impl Into<Message>, remedy: impl Into<Message>) -> Self {
        Self { line, value: value.into(), remedy: remedy.into() }
    }

    fn message(&self) -> Message {
        message!("record-error", "line" => self.line, "value" => self.value.clone(), "remedy" => self.remedy.clone())
    }
}

impl Format {
    /// Whether the name of a file has one of the extensions, in either case.
    pub fn fits_name(&self, path: &Path) -> bool {
        let extension = path.extension().and_then(|extension| extension.to_str());
        extension.is_some_and(|extension| self.extensions.iter().any(|own| own.eq_ignore_ascii_case(extension)))
    }

    /// Name, extensions and contents in one line: `CSV (.csv, .txt): two columns, …`.
    pub fn words(&self) -> Message {
        let extensions: Vec<String> = self.extensions.iter().map(|extension| format!(".{extension}")).collect();
        let extensions = extensions.join(", ");
        message!("record-format-of", "name" => self.name, "extensions" => extensions, "contents" => self.contents)
    }
}

impl Supplement {
    /// Refuses what a file of such a format states itself.
    pub(super) fn nothing(&self, states: Text) -> Result<(), RecordError> {
        let beside = [("dt_s", self.dt.is_some()), ("unit", self.unit.is_some())];
        match beside.into_iter().find(|(_, given)| *given) {
            None => Ok(()),
            Some((key, _)) => {
                let remedy = message!("record-beside", "states" => states, "key" => key);
                Err(RecordError::new(1, message!("record-beside-value", "key" => key), remedy))
            }
        }
    }
}

impl Channel {
    /// Samples in m/s² without a name or direction: interval \[s\], samples \[m/s²\].
    pub fn plain(dt: f64, samples: Vec<f64>) -> Self {
        let orientation = Orientation::Unstated;
        Self { name: String::new(), orientation, unit: Unit::MetrePerSecond2, dt, samples, done: Vec::new() }
    }

    /// Numbers of a file in its unit, turned into m/s².
    pub(super) fn converted(name: &str, orientation: Orientation, unit: Unit, dt: f64, numbers: Vec<f64>) -> Self {
        let mut channel = Self { orientation, unit, ..Self::plain(dt, numbers) };
        name.trim().clone_into(&mut channel.name);
        if unit != Unit::MetrePerSecond2 {
            let factor = unit.in_si();
            for sample in &mut channel.samples {
                *sample *= factor;
            }
            channel.done.push(message!("record-converted", "unit" => unit.label(), "factor" => factor));
        }
        channel
    }

    /// Largest sample by magnitude with its sign, and its time: (m/s², s); the first of several.
    pub fn peak(&self) -> (f64, f64) {
        let most = self
            .samples
            .iter()
            .enumerate()
            .fold((0, 0.0_f64), |most, (n, sample)| if sample.abs() > most.1.abs() { (n, *sample) } else { most });
        (most.1, most.0 as f64 * self.dt)
    }
}

impl Record {
    /// One channel by its number, from 1; without a number that of a file with one channel.
    ///
    /// # Errors
    /// No such channel, or none stated where there are several: in words, with the list of them.
    pub fn channel(&self, number: Option<usize>) -> Result<&Channel, Message> {
        let found = match number {
            None if self.channels.len() == 1 => self.channels.first(),
            None => None,
            Some(number) => number.checked_sub(1).and_then(|index| self.channels.get(index)),
        };
        found.ok_or_else(|| message!("record-give-channel", "list" => self.list()))
    }

    /// `1 (Chan 1: 360 Deg), 2 (…)`.
    fn list(&self) -> String {
        let name =
            |channel: &Channel| if channel.name.is_empty() { String::new() } else { format!(" ({})", channel.name) };
        let each = self.channels.iter().enumerate().map(|(n, channel)| format!("{}{}", n + 1, name(channel)));
        each.collect::<Vec<_>>().join(", ")
    }
}
