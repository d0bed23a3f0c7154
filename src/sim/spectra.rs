//! Spectra of any quantity of a run: Fourier amplitudes over frequency, response over period (`docs/scene-format.md`, `[[view.plot]]`).
//!
//! A run is continuous: it is sampled evenly over the stretch asked for, often enough for a touch of some milliseconds in one of
//! ten seconds.

use super::History;
use super::quantity::Quantity;
use crate::motion::fourier::amplitudes;
use crate::motion::spectrum::{DESIGN_DAMPING, periods, spectrum};

/// Samples of a stretch: 1.2 ms apart in ten seconds.
const SAMPLES: u32 = 8192;
/// Shortest and longest period of a response spectrum \[s\].
const PERIODS: [f64; 2] = [0.02, 5.0];
/// Periods, evenly spaced by their logarithm.
const COUNT: u32 = 120;

/// Samples of a quantity over a stretch \[s\], SI, and their interval \[s\]; none where the stretch is empty.
fn sampled(history: &History, quantity: Quantity, [from, to]: [f64; 2]) -> Option<(Vec<f64>, f64)> {
    let dt = (to.min(history.end()) - from) / f64::from(SAMPLES - 1);
    let at = |n: u32| quantity.at(history, from + f64::from(n) * dt);
    (dt > 0.0).then(|| ((0..SAMPLES).map(at).collect(), dt))
}

/// Fourier amplitudes `|∫ q exp(−i 2π f t) dt|` of a quantity over a stretch \[s\]: pairs of frequency \[Hz\] and amplitude, SI times
/// seconds.
pub fn fourier(history: &History, quantity: Quantity, stretch: [f64; 2]) -> Vec<[f64; 2]> {
    sampled(history, quantity, stretch).map_or_else(Vec::new, |(samples, dt)| amplitudes(&samples, dt))
}

/// The largest `ω²|u|` of `ü + 2ζωu̇ + ω²u = q(t)` from rest, `ζ` = [`DESIGN_DAMPING`], with `q` a quantity over a stretch \[s\]: pairs of
/// period \[s\] and response in the quantity's unit, SI. Of a ground acceleration that is the pseudo-acceleration.
pub fn response(history: &History, quantity: Quantity, stretch: [f64; 2]) -> Vec<[f64; 2]> {
    let Some((samples, dt)) = sampled(history, quantity, stretch) else { return Vec::new() };
    let found = spectrum(&samples, dt, &periods(PERIODS, COUNT), DESIGN_DAMPING);
    found.iter().map(|r| [r.period, r.pseudo_acceleration()]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Motion, presets};

    #[test]
    fn the_ground_answers_as_a_sine_does() {
        let scene = presets::load(presets::OPENING).expect("ships");
        let Motion::Sine(sine) = scene.motion.clone() else { panic!("a sine") };
        let history = History::of(&scene).expect("runs");
        let ground = Quantity::find(&history, "ground.x").expect("the ground moves");
        let stretch = [0.0, history.end()];
        let lines = fourier(&history, ground, stretch);
        let highest = lines.iter().max_by(|a, b| a[1].total_cmp(&b[1])).expect("lines");
        let line = lines[0][0];
        assert!((highest[0] - sine.frequency_hz).abs() <= line, "at its frequency: {highest:?}");
        // Far above the frequency f of the ground an oscillator of f₀ follows it: ω²u = q to the order of (f/f₀)². The kink in q at
        // t = 0 leaves a free vibration of f/f₀ beside it, of which e^(−2πζ f₀/(4f)) is left at the first peak.
        let stiff = response(&history, ground, stretch)[0];
        let peak = (0..1000).map(|n| ground.at(&history, f64::from(n) * 0.01)).fold(0.0, |a: f64, v| a.max(v.abs()));
        let ratio = sine.frequency_hz * PERIODS[0];
        let bound = 1.05 * (ratio * ratio + ratio * (-std::f64::consts::TAU * DESIGN_DAMPING / (4.0 * ratio)).exp());
        assert!((stiff[1] / peak - 1.0).abs() < bound, "{} of {peak} m/s², bound {bound}", stiff[1]);
        assert!(fourier(&history, ground, [1.0, 1.0]).is_empty(), "no stretch, no lines");
    }
}
