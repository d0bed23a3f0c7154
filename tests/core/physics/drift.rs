//! Nothing drifts: energy over a million periods and ten thousand hits, the length of quaternions, held directions.

use crate::support::{run, scene, within};
use girderbench::scene::Scene;
use girderbench::sim::History;

/// Periods of the long flights; the bearings' frequency is 1 Hz.
const PERIODS: f64 = 1e6;

/// A girder on undamped bearings, started off its home with a speed and a spin.
fn swinging(bearings: &str, duration: f64, motion: &str) -> Scene {
    scene(&format!(
        "name = \"swing\"\nduration_s = {duration:?}\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
         mass_kg = 6e5\nbearings = {bearings}\ninitial = {{ displacement_m = [0.05, -0.02], rotation_deg = 0.1, \
         velocity_m_s = [0.2, 0.3], spin_deg_s = 0.4 }}\n{motion}"
    ))
}

const EQUAL: &str = "{ frequency_hz = 1.0, damping_ratio = 0.0, at_m = [[14, 4], [14, -4], [-14, 4], [-14, -4]] }";
const ECCENTRIC: &str = "[{ at_m = [14, 4], stiffness_n_per_m = [9e6, 4e6], damping_n_s_per_m = [0, 0] }, \
                         { at_m = [-10, -3], stiffness_n_per_m = [3e6, 8e6], damping_n_s_per_m = [0, 0] }]";

/// Kinetic energy and bearing strain, from motion and stiffness alone \[J\].
fn energy(history: &History, t: f64) -> f64 {
    let (body, m) = (&history.model().bodies[0], history.motion(0, t));
    let q = glam::DVec3::new(m.displacement.x, m.displacement.y, m.theta);
    let kinetic = body.mass * (m.velocity.length_squared() + body.gyration2 * m.spin.z * m.spin.z);
    0.5 * (kinetic + q.dot(body.planar.stiffness * q))
}

/// Largest change of the energy over a run, of its start.
fn drift(history: &History) -> f64 {
    let start = energy(history, 0.0);
    (0..=1000).map(|i| (energy(history, history.end() * f64::from(i) / 1000.0) / start - 1.0).abs()).fold(0.0, f64::max)
}

#[test]
fn an_undamped_flight_keeps_its_energy_for_a_million_periods() {
    // Nothing accumulates: every look is one evaluation from the start. A few roundings of energies and of cos² + sin².
    within("three oscillators", drift(&run(&swinging(EQUAL, PERIODS, ""))), 16.0 * f64::EPSILON);
    // Powers of the propagator are squared with twice the digits: some thirty products of rounded ones, each of 11 terms.
    within("eccentric bearings", drift(&run(&swinging(ECCENTRIC, PERIODS, ""))), 30.0 * 11.0 * f64::EPSILON);
}

#[test]
fn an_undamped_flight_is_in_phase_after_a_million_periods() {
    let history = run(&swinging(EQUAL, PERIODS, ""));
    let (start, end) = (history.motion(0, 0.0), history.motion(0, PERIODS));
    // ωt = 6e6 rad is rounded to its last bit, and so is ω: two roundings of the phase, at the swing's size.
    let phase = 2.0 * std::f64::consts::TAU * PERIODS * f64::EPSILON;
    let swing = start.displacement.length() + start.velocity.length() / std::f64::consts::TAU;
    within("place", (end.displacement - start.displacement).length() / swing, phase);
}

#[test]
fn a_shaken_flight_is_the_textbooks_after_a_million_periods() {
    let motion = "[motion]\nkind = \"sine\"\namplitude_m_s2 = 1.5\nfrequency_hz = 0.75\n";
    let history = run(&swinging(EQUAL, PERIODS, motion));
    let (w, f) = (std::f64::consts::TAU, 0.75 * std::f64::consts::TAU);
    // ẍ + w² x = −A sin ft: x = a cos wt + b sin wt + X sin ft.
    let amplitude = -1.5 / (w * w - f * f);
    let b = (0.2 - f * amplitude) / w;
    for back in [0.0, 0.3, 17.9] {
        let t = PERIODS - back;
        let exact = 0.05 * (w * t).cos() + b * (w * t).sin() + amplitude * (f * t).sin();
        // Both round the phase of 6e6 rad.
        let phase = 4.0 * w * PERIODS * f64::EPSILON * (0.05 + b.abs() + amplitude.abs());
        within("place under a sine", history.motion(0, t).displacement.x - exact, phase);
    }
}

#[test]
fn elastic_hits_keep_the_energy_for_thousands_of_touches() {
    // Fewer in space, where a touch takes longer to compute.
    for (kind, duration) in [("planar", 30.0), ("spatial", 6.0)] {
        let held = if kind == "spatial" { "held = [\"z\", \"roll\", \"pitch\"]\n" } else { "" };
        let text = format!(
            "name = \"bounce\"\nkind = \"{kind}\"\nduration_s = {duration:?}\n[[girder]]\nname = \"deck\"\nlength_m = 0.19\nwidth_m = 0.07\n\
             thickness_m = 0.02\nmass_kg = 2.0\n{held}initial = {{ velocity_m_s = [0.5, 0.0] }}\n\
             [[abutment]]\nname = \"east\"\nfaces = \"deck\"\ngap_m = 0.005\n\
             [[abutment]]\nname = \"west\"\nfaces = \"deck\"\nend = \"-x\"\ngap_m = 0.005\n\
             [contact]\nstiffness_n_per_m = 1.55e8\nrestitution_normal = 1.0\nrestitution_tangential = 1.0\nmu_static = 0.0\n\
             mu_kinetic = 0.0\n[solver]\ntolerance = 1e-12\n"
        );
        let history = run(&scene(&text));
        let hits = history.hits().touches().len() as f64;
        assert!(hits > 80.0 * duration, "{kind}: it bounces: {hits}");
        let speed = history.motion(0, duration).velocity.length();
        // A tolerance a step, some ten steps a touch, and all of them one way at the worst.
        within(&format!("{kind}: speed after {hits} touches"), speed / 0.5 - 1.0, 10.0 * 1e-12 * hits);
        let sideways = (0..=1000).map(|i| history.motion(0, 1e-3 * duration * f64::from(i)));
        let sideways = sideways.map(|m| m.displacement.y.abs().max(m.theta.abs())).fold(0.0, f64::max);
        // Both corners of a flush face change together; rounding of their levers, grown with the time.
        within(&format!("{kind}: neither sideways nor turned"), sideways, 1e-9);
    }
}

#[test]
fn quaternions_keep_their_length_and_held_directions_their_place() {
    let text = |held: &str, duration: f64| {
        format!(
            "name = \"deck\"\nkind = \"spatial\"\nduration_s = {duration:?}\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\n\
             thickness_m = 1.5\nskew_deg = 60.0\nmass_kg = 6e5\nheld = [{held}]\n\
             bearings = {{ frequency_hz = 0.8, damping_ratio = 0.02, vertical_frequency_hz = 5.0, \
             at_m = [[14, 4], [14, -4], [-14, 4], [-14, -4]] }}\ninitial = {{ rotation_deg = 2.0, spin_deg_s = 5.0 }}\n\
             [[abutment]]\nname = \"east\"\nfaces = \"deck\"\ngap_m = 0.05\n\
             [[abutment]]\nname = \"west\"\nfaces = \"deck\"\nend = \"-x\"\ngap_m = 0.05\n\
             [contact]\nstiffness_n_per_m = 1e9\nmu_static = 0.2\nmu_kinetic = 0.15\n\
             [motion]\nkind = \"sine\"\namplitude_g = 0.3\nfrequency_hz = 0.8\nangle_deg = 20.0\n"
        )
    };
    let free = run(&scene(&text("", 100.0)));
    let planar = run(&scene(&text("\"z\", \"roll\", \"pitch\"", 100.0)));
    assert!(free.hits().touches().len() > 100 && planar.hits().touches().len() > 100, "contacts are in play");
    for i in 0..=20_000 {
        let t = f64::from(i) * 0.005;
        for history in [&free, &planar] {
            let off = history.motion(0, t).attitude.length() - 1.0;
            assert!(off.abs() < 4.0 * f64::EPSILON, "a quaternion is off by {off:e} at {t} s");
        }
        let m = planar.motion(0, t);
        assert_eq!([m.displacement.z, m.velocity.z, m.spin.x, m.spin.y], [0.0; 4], "held at {t} s");
        assert_eq!([m.attitude.x, m.attitude.y], [0.0; 2], "it neither rolls nor pitches at {t} s");
    }
}
