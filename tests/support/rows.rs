//! Rows of straight model girders between two abutments, the problems that run times are stated for, and a record made up
//! from a seed. Tests and benches share them.
#![allow(dead_code, reason = "each test and each bench uses its part")]

use std::fmt::Write;

use girderbench::scene::{Motion, RecordMotion, Scene, format};

/// `SplitMix64`: a fixed stream of numbers for a seed.
#[derive(Debug)]
pub(crate) struct Stream(pub u64);

impl Stream {
    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A row of the paper's straight girder.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    /// How many girders.
    pub count: usize,
    /// Whether all collide, each with a frequency of its own, or only the three in the middle.
    pub all: bool,
    /// Gap between neighbours that may collide \[m\].
    pub gap: f64,
    /// Gap before the walls at the ends \[m\].
    pub wall_gap: f64,
    /// How long \[s\].
    pub duration: f64,
    /// Local error per step.
    pub tolerance: f64,
}

impl Row {
    /// Every girder has a frequency of its own between 2.4 and 3.8 Hz, those of the paper's two: neighbours collide all
    /// along.
    pub(crate) fn many(count: usize) -> Self {
        Self { count, all: true, gap: 0.005, wall_gap: 0.005, duration: 1.0, tolerance: 1e-9 }
    }

    /// A soft girder between two stiff ones hits both; all others are like these and stand 20 mm apart: they sway as one
    /// and touch nobody.
    pub(crate) fn few(count: usize) -> Self {
        Self { all: false, wall_gap: 0.05, ..Self::many(count) }
    }

    /// The row as a scene.
    pub(crate) fn scene(&self) -> Scene {
        let mut stream = Stream(17);
        let mut text = format!(
            "name = \"row-of-{}\"\nduration_s = {}\nsolver = {{ tolerance = {:e} }}\n\
             motion = {{ kind = \"sine\", amplitude_m_s2 = 3.924, frequency_hz = 2.4 }}\n\
             contact = {{ stiffness_n_per_m = 1.55e5, restitution_normal = 0.4, mu_static = 0.15, mu_kinetic = 0.15 }}\n",
            self.count, self.duration, self.tolerance
        );
        let (middle, mut x) = (self.count / 2, 0.0);
        for n in 0..self.count {
            let frequency = match (self.all, n == middle) {
                (true, _) => 2.4 + 1.4 * stream.unit(),
                (false, true) => 2.4,
                (false, false) => 3.8,
            };
            let _ = write!(
                text,
                "[[girder]]\nname = \"g{n}\"\nlength_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = 2.0\n\
                 position_m = [{x}, 0.0, 0.0]\n\
                 bearings = {{ frequency_hz = {frequency}, damping_ratio = 0.29, \
                 at_m = [[0.07, 0.025], [-0.07, 0.025], [-0.07, -0.025], [0.07, -0.025]] }}\n"
            );
            let close = self.all || n == middle || n + 1 == middle;
            x += 0.19 + if close { self.gap } else { 4.0 * self.gap };
        }
        let last = self.count - 1;
        let _ = write!(
            text,
            "[[abutment]]\nname = \"left\"\nfaces = \"g0\"\nend = \"-x\"\ngap_m = {gap}\n\
             [[abutment]]\nname = \"right\"\nfaces = \"g{last}\"\ngap_m = {gap}\n",
            gap = self.wall_gap
        );
        format::parse(&text, "row").unwrap_or_else(|errors| panic!("{errors}"))
    }
}

/// The straight girder before a wall at 5 mm, shaken at 0.4 g and 2.4 Hz from rest.
fn straight(name: &str, duration: f64, angle: f64, contact: &str, tolerance: f64) -> Scene {
    let text = format!(
        "name = \"{name}\"\nduration_s = {duration}\nsolver = {{ tolerance = {tolerance:e} }}\n\
         motion = {{ kind = \"sine\", amplitude_m_s2 = 3.924, frequency_hz = 2.4, angle_deg = {angle} }}\n\
         contact = {{ stiffness_n_per_m = 1.55e5, {contact} }}\n\
         [[girder]]\nname = \"deck\"\nlength_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = 2.0\n\
         bearings = {{ frequency_hz = 2.4, damping_ratio = 0.29, \
         at_m = [[0.07, 0.025], [-0.07, 0.025], [-0.07, -0.025], [0.07, -0.025]] }}\n\
         [[abutment]]\nname = \"wall\"\nfaces = \"deck\"\ngap_m = 0.005\n"
    );
    format::parse(&text, name).unwrap_or_else(|errors| panic!("{errors}"))
}

/// P1: head-on, elastic.
pub(crate) fn p1(tolerance: f64) -> Scene {
    let contact = "restitution_normal = 1.0, restitution_tangential = 1.0, mu_static = 0.0, mu_kinetic = 0.0";
    straight("P1", 10.0, 0.0, contact, tolerance)
}

/// P2: at 45° with friction, elastic, slipping only.
pub(crate) fn p2(tolerance: f64) -> Scene {
    let contact = "restitution_normal = 1.0, restitution_tangential = 1.0, mu_static = 0.15, mu_kinetic = 0.15";
    straight("P2", 5.0, 45.0, contact, tolerance)
}

/// 40 s of shaking made up from a seed, on the skewed girder: noise through a filter of 1.8 Hz under an envelope that
/// rises over 4 s and dies away, peak 0.4 g; `samples` of them.
pub(crate) fn record(samples: u32, tolerance: f64) -> Scene {
    let mut scene = girderbench::scene::presets::load("skew45-abutment").unwrap_or_else(|errors| panic!("{errors}"));
    let dt = 40.0 / f64::from(samples);
    let mut stream = Stream(1940);
    let (mut q, mut v, mut values) = (0.0f64, 0.0f64, Vec::new());
    let (omega, damping) = (std::f64::consts::TAU * 1.8, 0.6);
    for n in 0..samples {
        let t = f64::from(n) * dt;
        let envelope = (t / 4.0).min(1.0) * (-(t - 12.0).max(0.0) / 10.0).exp();
        v += dt * (-2.0 * damping * omega * v - omega * omega * q) + dt.sqrt() * (stream.unit() - 0.5);
        q += dt * v;
        values.push(envelope * v);
    }
    let peak = values.iter().fold(0.0f64, |most, a| most.max(a.abs()));
    let samples = values.iter().map(|a| a * 3.924 / peak).collect();
    scene.duration = 40.0;
    scene.solver.tolerance = tolerance;
    scene.motion = Motion::Record(RecordMotion { dt: Some(dt), samples: Some(samples), ..RecordMotion::default() });
    scene
}
