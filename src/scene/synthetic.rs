//! A synthetic earthquake, as written in a scene.

use std::cell::RefCell;

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table};
use super::motion::STANDARD_GRAVITY;
use crate::language::Text;
use crate::motion::matching::{deviation_from, matched, without_drift};
use crate::motion::process::scale_to;
use crate::motion::synthetic::Earthquake;

/// Most samples of a synthetic record.
const MOST_SAMPLES: f64 = 1e6;
/// Least samples in the longest period: bringing an earthquake to rest takes two of its numbers, and of few nothing would be left. Chosen.
const LEAST_SAMPLES: f64 = 20.0;

table! {
    /// `kind = "synthetic"`: filtered noise under an envelope, by seed.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    default struct SyntheticMotion, SYNTHETIC {
        #[serde(serialize_with = "super::whole::serialize")]
        seed: f64 = "seed" as "field-seed", Range::Within([0.0, 1e6]), Fallback::Number(1.0), "seed of the noise, a whole number", slider [0.0, 100.0];
        peak_g: f64 = "peak_g" as "field-peak", Range::NotNegative, Fallback::Number(0.35), "largest magnitude, g", slider [0.0, 1.0];
        duration: f64 = "length_s" as "field-length", Range::Positive, Fallback::Number(40.0), "length of the record, s", slider [5.0, 100.0];
        dt: f64 = "dt_s" as "field-interval", Range::Positive, Fallback::Number(0.01), "interval between samples, s", slider [0.001, 0.02];
        ground_hz: f64 = "ground_hz" as "field-ground-frequency", Range::Positive, Fallback::Number(2.5), "frequency of the ground ω_g / 2π, Hz", slider [0.5, 10.0];
        ground_damping: f64 = "ground_damping" as "field-ground-damping", Range::Positive, Fallback::Number(0.6), "damping of the ground ζ_g, of critical", slider [0.1, 1.0];
        rise: f64 = "rise_s" as "field-rise", Range::NotNegative, Fallback::Number(2.0), "time within which the envelope rises, as a parabola, s", slider [0.0, 10.0];
        strong: f64 = "strong_s" as "field-strong-motion", Range::NotNegative, Fallback::Number(10.0), "time for which it then is 1, s", slider [0.0, 40.0];
        decay: f64 = "decay_s" as "field-decay", Range::Positive, Fallback::Number(7.0), "time τ of its decay exp(−t/τ), s", slider [1.0, 20.0];
        longest: Option<f64> = "longest_period_s" as "field-longest-period", Range::Positive, Fallback::Words("none: the ground may drift"),
            "period beyond which amplitudes fall as its square, so that the ground comes to rest where it began; without target_psa_g, s", slider [1.0, 20.0];
        angle_deg: f64 = "angle_deg" as "field-angle", Range::Any, Fallback::Number(0.0), "excitation angle α, degrees", slider [-180.0, 180.0];
        across: f64 = "across" as "field-across", Range::Any, Fallback::Number(0.0), "multiplies an independent component square to the first in plan, of the next seed", slider [0.0, 1.5];
        target: Option<Vec<[f64; 2]>> = "target_psa_g", Range::Like("two or more pairs"), Fallback::Words("none"),
            "spectrum that each component is matched to in place of its peak: period in s and 5 % pseudo-acceleration in g, periods growing";
        vertical: f64 = "vertical" as "field-vertical", Range::Any, Fallback::Number(0.0), "multiplies an independent vertical component, of the seed after that", slider [0.0, 1.5], in in_space;
    }
}

/// A matched component with what it was made of: earthquake, target.
type Matched = (Earthquake, Vec<[f64; 2]>, Vec<f64>);

thread_local! {
    /// The components that this thread matched last, the latest at the end. Matching takes longer than many a run (27 ms for
    /// 30 s), and runs that differ in other keys are shaken by the same.
    static MATCHED: RefCell<Vec<Matched>> = const { RefCell::new(Vec::new()) };
}

/// Samples matched to a target spectrum; those of the last three, the components of one earthquake, are kept \[m/s²\].
fn matched_once(quake: Earthquake, target: Vec<[f64; 2]>) -> Vec<f64> {
    MATCHED.with_borrow_mut(|made| {
        let at = made.iter().position(|(from, to, _)| (from, to) == (&quake, &target));
        let known = at.map(|at| made.remove(at));
        let one = known.unwrap_or_else(|| {
            let samples = matched(&quake.samples(), quake.dt, &target);
            (quake, target, samples)
        });
        let samples = one.2.clone();
        made.push(one);
        made.drain(..made.len().saturating_sub(3));
        samples
    })
}

impl SyntheticMotion {
    /// Samples of its first, second or third component, 0 to 2 \[m/s²\].
    pub fn samples(&self, component: u64) -> Vec<f64> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 1e6")]
        let seed = self.seed as u64 + component;
        let quake = Earthquake {
            seed,
            duration: self.duration.min(MOST_SAMPLES * self.dt),
            dt: self.dt,
            peak: self.peak_g * STANDARD_GRAVITY,
            ground: std::f64::consts::TAU * self.ground_hz,
            damping: self.ground_damping,
            rise: self.rise,
            until: self.rise + self.strong,
            decay: 1.0 / self.decay,
        };
        let Some(target) = &self.target else {
            let Some(longest) = self.longest else { return quake.samples() };
            let mut samples = without_drift(&quake.samples(), quake.dt, longest);
            scale_to(&mut samples, quake.peak);
            return samples;
        };
        let target: Vec<[f64; 2]> = target.iter().map(|[period, g]| [*period, g * STANDARD_GRAVITY]).collect();
        matched_once(quake, target)
    }

    /// Largest magnitude of its components \[m/s²\].
    pub fn peak(&self) -> f64 {
        let largest = self.factors().into_iter().fold(0.0, |most: f64, factor| most.max(factor.abs()));
        let own = match &self.target {
            // The pseudo-acceleration of a stiff oscillator is the peak of the ground; of others it is seldom less.
            Some(target) => target.iter().fold(0.0, |most: f64, pair| most.max(pair[1])),
            None => self.peak_g,
        };
        own * STANDARD_GRAVITY * largest
    }

    /// Mean deviation of a component's spectrum from the target, in parts of it; none without a target.
    pub fn deviation(&self, component: u64) -> Option<f64> {
        let target: Vec<[f64; 2]> =
            self.target.as_ref()?.iter().map(|[period, g]| [*period, g * STANDARD_GRAVITY]).collect();
        Some(deviation_from(&self.samples(component), self.dt, &target))
    }

    /// Factors of its components along the angle, across and upwards.
    pub fn factors(&self) -> [f64; 3] {
        [1.0, self.across, self.vertical]
    }

    fn target_is_sound(&self) -> bool {
        let Some(target) = &self.target else { return true };
        let [Some(first), Some(last)] = [target.first(), target.last()] else { return false };
        let positive = target.iter().flatten().all(|number| number.is_finite() && *number > 0.0);
        let grows = target.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        (2..=1000).contains(&target.len()) && positive && grows && first[0] >= 2.0 * self.dt && last[0] <= self.duration
    }

    /// Fault of keys that contradict each other: key, value and remedy.
    pub(in crate::scene) fn fault(&self) -> Option<(&'static str, f64, Text)> {
        // The filter's step is semi-implicit: stable below 2 / ω_g, true to a few percent below a tenth of that.
        let coarse = self.dt * std::f64::consts::TAU * self.ground_hz * self.ground_damping.max(1.0) > 0.5;
        let count = self.duration / self.dt;
        match () {
            () if self.seed.fract() != 0.0 => Some(("seed", self.seed, Text::new("wrong-not-whole"))),
            () if !(2.0..=MOST_SAMPLES).contains(&count) => {
                Some(("length_s", self.duration, Text::new("wrong-quake-length")))
            }
            () if !self.target_is_sound() => Some((
                "target_psa_g",
                self.target.as_ref().map_or(0.0, |target| target.len() as f64),
                Text::new("wrong-target"),
            )),
            () if self.target.is_some() && self.longest.is_some() => {
                Some(("longest_period_s", self.longest.unwrap_or_default(), Text::new("wrong-longest-of-target")))
            }
            () if !self.longest.is_none_or(|longest| (LEAST_SAMPLES * self.dt..=self.duration).contains(&longest)) => {
                Some(("longest_period_s", self.longest.unwrap_or_default(), Text::new("wrong-longest-period")))
            }
            () if coarse => Some(("dt_s", self.dt, Text::new("wrong-quake-coarse"))),
            () => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_earthquake_that_comes_to_rest_keeps_its_peak_and_wants_a_period_that_it_can_hold() {
        let quake =
            |longest| SyntheticMotion { duration: 4.0, dt: 0.01, longest: Some(longest), ..SyntheticMotion::default() };
        for longest in [0.2, 4.0] {
            assert_eq!(quake(longest).fault().map(|(key, ..)| key), None, "{longest} s fits");
            let samples = quake(longest).samples(0);
            let peak = samples.iter().fold(0.0_f64, |most, a| most.max(a.abs()));
            assert!((peak / (0.35 * STANDARD_GRAVITY) - 1.0).abs() < 1e-12, "{longest} s: {peak} m/s²");
            assert!(samples.iter().sum::<f64>().abs() < 1e-9 * peak, "{longest} s: no velocity at its end");
        }
        for longest in [1e-300, 0.19, 4.1] {
            assert_eq!(quake(longest).fault().map(|(key, ..)| key), Some("longest_period_s"), "{longest} s");
        }
    }

    #[test]
    fn a_matched_component_is_the_same_however_often_and_after_whichever_others() {
        let quake = |seed: f64| SyntheticMotion {
            seed,
            duration: 2.0,
            target: Some(vec![[0.05, 0.3], [0.2, 0.8], [1.0, 0.3]]),
            ..SyntheticMotion::default()
        };
        let first: Vec<Vec<f64>> = (0..3).map(|component| quake(1.0).samples(component)).collect();
        let other = quake(7.0).samples(0);
        let again: Vec<Vec<f64>> = (0..3).map(|component| quake(1.0).samples(component)).collect();
        assert!(first == again && first[0] != first[1] && other != first[0], "each its own");
        assert!(MATCHED.with_borrow(|made| made.len() == 3), "no more than are in use");
    }
}
