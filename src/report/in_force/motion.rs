//! A ground motion.

use crate::language::{Text, said, six};
use crate::scene::keys::word_told;
use crate::scene::{Heading, Motion, RecordMotion, STANDARD_GRAVITY, SweepRate};

/// Kind, level, length and direction of a ground motion, and what is done to a record.
pub fn motion(motion: &Motion) -> String {
    match motion {
        Motion::None => Text::new("check-still").into(),
        Motion::Sine(sine) => {
            let amplitude = sine.amplitude_si();
            let [si, g] = [amplitude, amplitude / STANDARD_GRAVITY].map(six);
            let [frequency, phase, angle] = [sine.frequency_hz, sine.phase_deg, sine.angle_deg].map(six);
            let vertical = match sine.vertical_si() {
                0.0 => String::new(),
                a => {
                    let phase = sine.vertical_phase_deg.unwrap_or(sine.phase_deg);
                    said!("check-sine-vertical", "level" => six(a), "phase" => six(phase))
                }
            };
            said!(
                "check-sine",
                "si" => si,
                "g" => g,
                "frequency" => frequency,
                "phase" => phase,
                "angle" => angle,
                "vertical" => vertical
            )
        }
        Motion::Record(record) => recorded(record),
        Motion::Sweep(sweep) => {
            let [amplitude, from, to, length, angle] =
                [sweep.amplitude_g, sweep.from_hz, sweep.to_hz, sweep.length, sweep.angle_deg].map(six);
            let (rate, interval) = (word_told(SweepRate::WORDS, sweep.rate.label()), six(sweep.sweep().interval()));
            said!(
                "check-sweep",
                "rate" => rate,
                "amplitude" => amplitude,
                "from" => from,
                "to" => to,
                "length" => length,
                "angle" => angle,
                "interval" => interval
            )
        }
        Motion::Synthetic(quake) => {
            let largest = quake.samples(0).iter().fold(0.0, |most: f64, a| most.max(a.abs())) / STANDARD_GRAVITY;
            let [seed, peak, length, angle] = [quake.seed, largest, quake.duration, quake.angle_deg].map(six);
            let [_, across, vertical] = quake.factors().map(six);
            let target = quake.deviation(0).map(|off| {
                let pairs = quake.target.as_ref().map_or(0, Vec::len);
                said!("check-matched", "pairs" => pairs, "off" => format!("{:.1}", 100.0 * off))
            });
            said!(
                "check-synthetic",
                "seed" => seed,
                "peak" => peak,
                "length" => length,
                "angle" => angle,
                "across" => across,
                "vertical" => vertical,
                "target" => target.unwrap_or_default()
            )
        }
    }
}

/// A record: samples, interval, scale, directions, what is done to it.
fn recorded(record: &RecordMotion) -> String {
    let (peak, dt, count) = record.extent().unwrap_or((0.0, 0.0, 0));
    let length = dt * count.saturating_sub(1) as f64;
    let [dt, scale, length, peak] = [dt, record.scale, length, peak / STANDARD_GRAVITY].map(six);
    let direction = if record.components.is_empty() {
        let vertical = match record.vertical_scale {
            0.0 => String::new(),
            scale => said!("check-vertical-scale", "scale" => six(scale)),
        };
        said!("check-angle", "angle" => six(record.angle_deg), "vertical" => vertical)
    } else {
        let each = |n: usize| {
            let way = match record.heading(n) {
                Some(Heading::Up) => Text::new("check-up").into(),
                Some(Heading::InPlan(angle)) => said!("check-from-x", "angle" => six(angle)),
                None => Text::new("check-nowhere").into(),
            };
            let component = &record.components[n];
            let file = component.file.as_ref().map_or(String::new(), |file| format!("{file} "));
            format!("{file}× {} {way}", six(component.scale))
        };
        let all: Vec<String> = (0..record.components.len()).map(each).collect();
        said!("check-components", "count" => all.len(), "all" => all.join(", "))
    };
    let file = record.file.as_ref().map_or(String::new(), |file| format!("{file}: "));
    let steps: Vec<String> = record.processing.in_words().into_iter().map(|step| format!(", {step}")).collect();
    let words = said!(
        "check-record",
        "count" => count,
        "dt" => dt,
        "length" => length,
        "peak" => peak,
        "scale" => scale,
        "direction" => direction,
        "steps" => steps.concat()
    );
    file + &words
}
