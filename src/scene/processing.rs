//! Processing of a record's samples before they are scaled: cut, baseline, taper, pad, time scale, peak.
//!
//! In this order, so that a taper ends what a cut leaves and padding stays still.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table, words};
use crate::language::{Message, Text, message, said, six};
use crate::motion::format::STANDARD_GRAVITY;
use crate::motion::process;

words! {
    /// Baseline correction: the part subtracted from an acceleration.
    Baseline, by default None {
        /// Nothing.
        None = "none",
        /// Its mean.
        Mean = "mean",
        /// Its straight line of least squares.
        Linear = "linear",
        /// The parabola that leaves the least square of the velocity (Berg & Housner 1961).
        BergHousner = "berg-housner",
    }
}

table! {
    /// `[motion.processing]`: what is done to the samples of a record.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Processing, PROCESSING {
        from: Option<f64> = "from_s" as "field-cut-from", Range::NotNegative, Fallback::Words("its start"),
            "where the record is cut to begin, after its first sample, s";
        until: Option<f64> = "to_s" as "field-cut-to", Range::NotNegative, Fallback::Words("its end"), "where it is cut to end, after its first sample, s";
        baseline: Baseline = "baseline" as "field-baseline", Range::Words(Baseline::WORDS), Baseline::FALLBACK,
            "what is taken off: nothing, its mean, its line of least squares, or the parabola that leaves the least sum of squares of the velocity at the samples (Berg and Housner)";
        taper: f64 = "taper_s" as "field-taper", Range::NotNegative, Fallback::Number(0.0),
            "length of the half cosine over which it rises at its start and falls at its end, s", slider [0.0, 5.0];
        pad: f64 = "pad_s" as "field-padding", Range::NotNegative, Fallback::Number(0.0), "stillness before its start and after its end, s", slider [0.0, 10.0];
        time_scale: f64 = "time_scale" as "field-time-scale", Range::Positive, Fallback::Number(1.0),
            "multiplies the interval: √λ for a model of scale λ under the same accelerations", slider [0.1, 2.0];
        peak_g: Option<f64> = "peak_g" as "field-scaled-to-peak", Range::Positive, Fallback::Words("as recorded"),
            "largest magnitude that all samples are scaled to, of several components that of their sum, g; scale multiplies it";
    }
}

/// Most samples that padding may lead to: a day at 100 Hz.
const MOST: f64 = 1e7;

impl Processing {
    /// Samples as they are shaken by, unscaled: interval \[s\], samples \[m/s²\].
    pub fn apply<'s>(&self, dt: f64, samples: &'s [f64]) -> (f64, Cow<'s, [f64]>) {
        let (first, end) = self.kept(dt, samples.len());
        let mut all = Cow::Borrowed(&samples[first..end]);
        match self.baseline {
            Baseline::None => {}
            Baseline::Mean => process::remove_mean(all.to_mut()),
            Baseline::Linear => process::remove_line(all.to_mut()),
            Baseline::BergHousner => process::remove_velocity_parabola(all.to_mut()),
        }
        if self.taper > 0.0 {
            process::taper(all.to_mut(), dt, self.taper);
        }
        if self.pad > 0.0 {
            all = Cow::Owned(process::pad(&all, padding(self.pad, dt)));
        }
        (dt * self.time_scale, all)
    }

    /// Factor that brings the largest magnitude \[m/s²\] to the stated one; 1 where none is stated, or nothing shakes.
    pub fn factor(&self, largest: impl FnOnce() -> f64) -> f64 {
        let Some(peak) = self.peak_g else { return 1.0 };
        let largest = largest();
        if largest > 0.0 { peak * STANDARD_GRAVITY / largest } else { 1.0 }
    }

    /// Numbers of the first sample and of that after the last which a cut leaves.
    fn kept(&self, dt: f64, count: usize) -> (usize, usize) {
        /// A time that is a sample's own but for rounding is that sample's.
        const ROUNDING: f64 = 1e-6;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, and is held to the samples"
        )]
        let number = |x: f64| x as usize;
        let first = self.from.map_or(0, |from| number((from / dt - ROUNDING).ceil())).min(count);
        let end = self.until.map_or(count, |until| number((until / dt + ROUNDING).floor()).saturating_add(1));
        (first, end.clamp(first, count))
    }

    /// Fault for a record of `count` samples at intervals `dt` \[s\]: key, value and remedy.
    pub fn fault(&self, dt: f64, count: usize) -> Option<(&'static str, f64, Message)> {
        let (first, end) = self.kept(dt, count);
        let length = (end - first).saturating_sub(1) as f64 * dt;
        let backwards = self.from.zip(self.until).is_some_and(|(from, until)| until <= from);
        let key = if self.from.is_some() && !backwards { "from_s" } else { "to_s" };
        let stated = if backwards { self.until } else { self.from.or(self.until) };
        if let (Some(stated), true) = (stated, end - first < 2) {
            let whole = count.saturating_sub(1) as f64 * dt;
            return Some((key, stated, message!("wrong-cut", "whole" => whole)));
        }
        if 2.0 * self.taper > length {
            let remedy = message!("wrong-taper", "length" => length);
            return Some(("taper_s", self.taper, remedy));
        }
        let padded = (end - first) as f64 + 2.0 * (self.pad / dt);
        (self.pad > 0.0 && padded > MOST).then(|| ("pad_s", self.pad, Text::new("wrong-padding").into()))
    }

    /// Texts of its steps, in order.
    pub fn in_words(&self) -> Vec<String> {
        let cut = (self.from.is_some() || self.until.is_some()).then(|| {
            let end = |t: Option<f64>, otherwise: Text| t.map_or_else(|| otherwise.into(), |t| format!("{t} s"));
            let [from, until] = [Text::new("processed-start"), Text::new("processed-end")];
            said!("processed-cut", "from" => end(self.from, from), "to" => end(self.until, until))
        });
        let baseline =
            (self.baseline != Baseline::None).then(|| said!("processed-baseline", "kind" => self.baseline.label()));
        let steps = [
            cut,
            baseline,
            (self.taper > 0.0).then(|| said!("processed-taper", "seconds" => six(self.taper))),
            (self.pad > 0.0).then(|| said!("processed-pad", "seconds" => six(self.pad))),
            (self.time_scale != 1.0).then(|| said!("processed-time", "factor" => six(self.time_scale))),
            self.peak_g.map(|peak| said!("processed-peak", "peak" => six(peak))),
        ];
        steps.into_iter().flatten().collect()
    }
}

/// Samples of padding, held to what may be.
fn padding(pad: f64, dt: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 1e7")]
    let count = (pad / dt).round().clamp(0.0, MOST) as usize;
    count
}
