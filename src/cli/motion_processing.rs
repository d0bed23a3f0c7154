//! Flags of `girderbench motion` for what is done to the samples, as `[motion.processing]` of a scene does it.

use std::path::Path;

use super::args::{finite, not_negative, positive};
use super::digits::six;
use super::failure::Failure;
use crate::language::{Message, message, said};
use crate::motion::format::Channel;
use crate::scene::{Baseline, Processing};

/// What is done to the samples, in this order
#[derive(Clone, Debug, clap::Args)]
pub(super) struct ProcessingArgs {
    /// Cut the record to begin here, after its first sample [s]
    #[arg(long, value_name = "S", value_parser = not_negative, allow_negative_numbers = true)]
    from: Option<f64>,
    /// Cut the record to end here, after its first sample [s]
    #[arg(long, value_name = "S", value_parser = not_negative, allow_negative_numbers = true)]
    to: Option<f64>,
    /// Take off the mean, the line of least squares, or the parabola that leaves the least velocity: none, mean, linear,
    /// berg-housner
    #[arg(long, value_name = "METHOD", value_parser = baseline)]
    baseline: Option<Baseline>,
    /// Half cosine over which the record rises at its start and falls at its end [s]
    #[arg(long, value_name = "S", value_parser = not_negative, allow_negative_numbers = true)]
    taper: Option<f64>,
    /// Stillness before the start and after the end [s]
    #[arg(long, value_name = "S", value_parser = not_negative, allow_negative_numbers = true)]
    pad: Option<f64>,
    /// Factor of the interval between samples
    #[arg(long, value_name = "X", value_parser = positive, allow_negative_numbers = true)]
    time_scale: Option<f64>,
    /// Scale to this peak [g]
    #[arg(long, value_name = "G", value_parser = positive, allow_negative_numbers = true)]
    peak_g: Option<f64>,
    /// Multiply every sample, after the rest
    #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = finite)]
    scale: Option<f64>,
}

fn baseline(text: &str) -> Result<Baseline, String> {
    let found = Baseline::ALL.iter().copied().find(|method| method.label() == text);
    found.ok_or_else(|| said!("wrong-one-of", "words" => Baseline::WORDS.join(", ")))
}

impl ProcessingArgs {
    /// A channel with all of it done and noted.
    ///
    /// # Errors
    ///
    /// The fault of a record that is too short, with flag and remedy.
    pub(super) fn apply(&self, channel: &Channel, path: &Path) -> Result<Channel, Failure> {
        let processing = self.processing();
        if let Some((key, value, remedy)) = processing.fault(channel.dt, channel.samples.len()) {
            let flag = key.trim_end_matches("_s").replace('_', "-");
            return Err(Failure::Input(format!("{}: --{flag} {}: {remedy}", path.display(), six(value))));
        }
        let (dt, samples) = processing.apply(channel.dt, &channel.samples);
        let factor = processing.factor(|| samples.iter().fold(0.0, |most, a| most.max(a.abs())));
        let factor = factor * self.scale.unwrap_or(1.0);
        let mut done = channel.done.clone();
        done.extend(processing.in_words().into_iter().map(Message::from));
        done.extend(self.scale.map(|scale| message!("processed-scale", "scale" => six(scale))));
        let samples = samples.iter().map(|a| a * factor).collect();
        Ok(Channel { dt, samples, done, name: channel.name.clone(), ..*channel })
    }

    fn processing(&self) -> Processing {
        let none = Processing::default();
        Processing {
            from: self.from,
            until: self.to,
            baseline: self.baseline.unwrap_or(none.baseline),
            taper: self.taper.unwrap_or(none.taper),
            pad: self.pad.unwrap_or(none.pad),
            time_scale: self.time_scale.unwrap_or(none.time_scale),
            peak_g: self.peak_g,
        }
    }
}
