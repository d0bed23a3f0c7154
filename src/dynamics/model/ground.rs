//! Motions of the ground as scenes say them, as functions of time (`docs/physics.md#ground-motion`).

use glam::DVec3;

use crate::motion::Ground;
use crate::scene::{Combined, Motion, RecordMotion, SyntheticMotion};

/// A motion of the ground as a function of time.
pub(super) fn compiled(motion: &Motion) -> Ground {
    let direction = Ground::direction(motion.angle_deg());
    match motion {
        Motion::None => Ground::Still,
        Motion::Sine(sine) => Ground::Sine {
            amplitude: (direction * sine.amplitude_si()).with_z(sine.vertical_si() * sine.vertical_lead().cos()),
            quadrature: DVec3::Z * (sine.vertical_si() * sine.vertical_lead().sin()),
            omega: std::f64::consts::TAU * sine.frequency_hz,
            phase: sine.phase_deg.to_radians(),
        },
        Motion::Record(record) => recorded(record, direction).unwrap_or(Ground::Still),
        Motion::Synthetic(quake) => synthetic(quake, direction),
        Motion::Sweep(sweep) => {
            let (dt, samples) = sweep.samples();
            Ground::record(direction, dt, samples)
        }
    }
}

/// A synthetic earthquake; a component that is 0 is not made.
fn synthetic(quake: &SyntheticMotion, direction: DVec3) -> Ground {
    let [_, across, vertical] = quake.factors();
    let first = quake.samples(0);
    if across == 0.0 && vertical == 0.0 {
        return Ground::record(direction, quake.dt, first);
    }
    let other = |number, factor: f64| if factor == 0.0 { Vec::new() } else { quake.samples(number) };
    let [second, third] = [other(1, across), other(2, vertical)];
    let left = DVec3::Z.cross(direction);
    let at = |samples: &[f64], n: usize| samples.get(n).copied().unwrap_or(0.0);
    let sum =
        |n: usize| direction * first[n] + left * (across * at(&second, n)) + DVec3::Z * (vertical * at(&third, n));
    Ground::components(quake.dt, (0..first.len()).map(sum), [])
}

/// A record as it shakes; nothing until it is read.
fn recorded(record: &RecordMotion, direction: DVec3) -> Option<Ground> {
    if !record.components.is_empty() {
        let in_plan = |angle: f64| Ground::direction(angle).truncate().to_array();
        let Combined { dt, samples, ends } = record.combined(in_plan)?;
        let ends = ends.into_iter().map(|(sample, last)| (sample, DVec3::from(last)));
        return Some(Ground::components(dt, samples.into_iter().map(DVec3::from), ends));
    }
    let (dt, samples, factor) = record.processed()?;
    let [scale, vertical] = [record.scale * factor, record.vertical_scale * factor];
    if vertical == 0.0 {
        return Some(Ground::record(direction, dt, samples.iter().map(|a| a * scale)));
    }
    let along = direction * scale + DVec3::Z * vertical;
    let scale = along.length();
    Some(Ground::record(along / scale, dt, samples.iter().map(|a| a * scale)))
}
