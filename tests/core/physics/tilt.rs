//! Roll, pitch, moments about x and y, heights of bearings and vertical ground motion, against closed forms.

use std::f64::consts::TAU;

use crate::support::{run, scene, within};
use girderbench::sim::{History, Quantity};
use glam::{DMat3, DQuat, DVec3};

const MASS: f64 = 3.0;
const SIZES: [f64; 3] = [1.0, 0.5, 0.2];

/// A straight spatial girder with these keys, and what follows it in the file.
fn deck(duration: f64, keys: &str, more: &str) -> History {
    let [length, width, thickness] = SIZES;
    run(&scene(&format!(
        "name = \"deck\"\nkind = \"spatial\"\nduration_s = {duration:?}\nsolver = {{ tolerance = 1e-12 }}\n{more}\n\
         [[girder]]\nname = \"deck\"\nlength_m = {length:?}\nwidth_m = {width:?}\nthickness_m = {thickness:?}\n\
         mass_kg = {MASS:?}\n{keys}"
    )))
}

/// Squared radius of gyration about the axis between two sides \[m²\].
fn gyration2(a: f64, b: f64) -> f64 {
    (a * a + b * b) / 12.0
}

/// Rotation since placed.
fn turned(history: &History, t: f64) -> DQuat {
    let placed = DQuat::from_mat3(&history.model().bodies[0].axes);
    history.motion(0, t).attitude * placed.inverse()
}

#[test]
fn a_vertical_sine_moves_a_girder_on_its_bearings_by_the_steady_amplitude_and_phase() {
    let (f0, h, f, a, phase) = (5.0, 0.1, 3.0, 2.0, 0.7f64);
    let bearings = format!(
        "bearings = {{ frequency_hz = 2.0, damping_ratio = 0.1, vertical_frequency_hz = {f0:?}, \
         vertical_damping_ratio = {h:?}, at_m = [[0.4, 0.2], [0.4, -0.2], [-0.4, 0.2], [-0.4, -0.2]] }}"
    );
    let motion = format!(
        "motion = {{ kind = \"sine\", amplitude_m_s2 = 0.0, frequency_hz = {f:?}, phase_deg = 25.0, \
         vertical_amplitude_m_s2 = {a:?}, vertical_phase_deg = {:?} }}",
        phase.to_degrees()
    );
    let history = deck(12.0, &bearings, &motion);
    let legs =
        [1, 2, 3, 4].map(|leg| Quantity::find(&history, &format!("deck.bearing{leg}.force-z")).expect("in space"));
    let (omega0, omega) = (TAU * f0, TAU * f);
    // z̈ + 2 h ω0 ż + ω0² z = −a sin(ω t + φ).
    let (real, imaginary) = (omega0 * omega0 - omega * omega, 2.0 * h * omega0 * omega);
    let (amplitude, lag) = (a / real.hypot(imaginary), imaginary.atan2(real));
    for i in 0..100 {
        // The free part has decayed by e^(−h ω0 t) < 2e-14.
        let t = 10.0 + 0.02 * f64::from(i);
        let wanted = -amplitude * (omega * t + phase - lag).sin();
        within("steady response", (history.motion(0, t).displacement.z - wanted) / amplitude, 1e-9);
        // What carries the girder: its weight, and its mass times its acceleration in space.
        let accelerated = a * (omega * t + phase).sin() - omega * omega * wanted;
        let carried: f64 = legs.iter().map(|leg| leg.at(&history, t)).sum();
        within("what the bearings carry", carried / (MASS * (history.model().gravity + accelerated)) - 1.0, 1e-9);
    }
    let ledger = history.energy().ledger(12.0);
    within("ledger", ledger.residual / ledger.scale, 1e-10);
    assert!(ledger.work_ground > 0.0, "the ground works against the dashpots");
}

#[test]
fn a_record_shakes_upwards_by_its_own_scale() {
    let motion = "motion = { kind = \"record\", samples_m_s2 = [1.0, 1.0], dt_s = 2.0, scale = 0.5, \
                  vertical_scale = -2.0 }\ngravity_m_s2 = 0.0";
    let moved = deck(1.0, "", motion).motion(0, 1.0).displacement;
    within("½ a t²", (moved - DVec3::new(-0.25, 0.0, 1.0)).length(), 1e-12);
}

#[test]
fn a_constant_moment_about_a_principal_axis_turns_by_half_alpha_t_squared() {
    let [length, width, thickness] = SIZES;
    let of = [
        ("moment_x_n_m", DVec3::X, gyration2(width, thickness)),
        ("moment_y_n_m", DVec3::Y, gyration2(length, thickness)),
    ];
    for (key, axis, i2) in of {
        let history = deck(2.0, &format!("push = {{ {key} = 0.05 }}"), "gravity_m_s2 = 0.0");
        let alpha = 0.05 / (MASS * i2);
        for t in [0.3, 1.1, 2.0] {
            let angle = 0.5 * alpha * t * t;
            let apart = turned(&history, t).dot(DQuat::from_axis_angle(axis, angle)).abs();
            within("½ α t²", (1.0 - apart).max(0.0).sqrt(), 1e-8);
            within("α t", (history.motion(0, t).spin - axis * (alpha * t)).length(), 1e-10 * alpha * t);
        }
        let ledger = history.energy().ledger(2.0);
        let work = 0.5 * MASS * i2 * (alpha * 2.0).powi(2);
        within("work of the push", ledger.work_push / work - 1.0, 1e-9);
    }
}

#[test]
fn a_free_girder_keeps_its_rate_of_roll_about_its_axis() {
    // Rolled by more than a turn; yawed and pitched first, on a heading of its own.
    let keys =
        "heading_deg = 30.0\ninitial = { rotation_deg = 20.0, pitch_deg = 40.0, roll_deg = 10.0, roll_deg_s = 90.0 }";
    let history = deck(5.0, keys, "gravity_m_s2 = 0.0");
    for t in [0.0, 1.3, 5.0] {
        let angles = [50.0, 40.0, 10.0 + 90.0 * t].map(f64::to_radians);
        let wanted =
            DMat3::from_rotation_z(angles[0]) * DMat3::from_rotation_y(angles[1]) * DMat3::from_rotation_x(angles[2]);
        let here = DMat3::from_quat(history.motion(0, t).attitude);
        let apart = (here - wanted).to_cols_array().into_iter().map(f64::abs).fold(0.0, f64::max);
        within("yaw, pitch, roll", apart, 1e-10);
        within("θ is the yaw", history.motion(0, t).theta - 20f64.to_radians(), 1e-10);
    }
}

#[test]
fn a_tumbling_girder_keeps_its_angle_about_the_vertical() {
    // About the axis of the middle inertia, where deviations grow as e^(4.6 t).
    let keys = "initial = { rotation_deg = 20.0, pitch_deg = 100.0, pitch_deg_s = 400.0 }";
    let history = deck(3.0, keys, "gravity_m_s2 = 0.0");
    for i in 0..=300 {
        let t = 0.01 * f64::from(i);
        within("no jump", history.motion(0, t).theta - 20f64.to_radians(), 1e-6);
    }
}

/// Bearings at height `h` couple sway and pitch: `m ẍ = −k (x + h θ)`, `I θ̈ = −k h (x + h θ) − k_θ θ`.
#[test]
fn a_bearings_height_couples_sway_and_pitch_with_the_frequencies_of_the_two_by_two_problem() {
    let (height, reach) = (-0.45, 0.4);
    let (k, kz) = (900.0, 2500.0);
    let one = |x: f64| {
        format!(
            "{{ at_m = [{x:?}, 0.0], height_m = {height:?}, stiffness_n_per_m = [{:?}, 0.0, {:?}], \
             damping_n_s_per_m = [0.0, 0.0, 0.0] }}",
            k / 2.0,
            kz / 2.0
        )
    };
    let bearings = format!("bearings = [{}, {}]", one(reach), one(-reach));
    let inertia = MASS * gyration2(SIZES[0], SIZES[2]);
    // Pitch θ moves the attachment points by h θ along x and by ∓reach θ upwards.
    let [a, b, d] = [k / MASS, k * height / MASS, (k * height * height + kz * reach * reach) / inertia];
    let c = k * height / inertia;
    let root = (((a - d) / 2.0).powi(2) + b * c).sqrt();
    let small = 1e-7f64;
    for omega2 in [f64::midpoint(a, d) - root, f64::midpoint(a, d) + root] {
        // Its mode: (a − ω²) x + b θ = 0.
        let mode = [b, omega2 - a].map(|v| small * v / b.abs().max((omega2 - a).abs()));
        let keys = format!(
            "{bearings}\ninitial = {{ displacement_m = [{:?}, 0.0], pitch_deg = {:?} }}",
            mode[0],
            mode[1].to_degrees()
        );
        let history = deck(3.0, &keys, "gravity_m_s2 = 0.0");
        let omega = omega2.sqrt();
        for i in 1..=30 {
            let t = 0.1 * f64::from(i);
            let cosine = (omega * t).cos();
            let pitch = 2.0 * turned(&history, t).y;
            within("sway", (history.motion(0, t).displacement.x - mode[0] * cosine) / small, 1e-9 * omega * t + small);
            within("pitch", (pitch - mode[1] * cosine) / small, 1e-9 * omega * t + small);
        }
    }
}

#[test]
fn a_height_at_the_underside_is_the_default_bit_for_bit() {
    let bearings = |height: &str| {
        format!(
            "bearings = {{ frequency_hz = 2.0, damping_ratio = 0.1, vertical_frequency_hz = 5.0{height}, \
             at_m = [[0.4, 0.2], [0.4, -0.2], [-0.4, 0.2], [-0.4, -0.2]] }}\ninitial = {{ velocity_m_s = [0.2, 0.1, 0.3] }}"
        )
    };
    let [absent, given] = ["", ", height_m = -0.1"].map(|height| deck(1.0, &bearings(height), "").digest());
    assert_eq!(absent, given, "half the thickness below G");
}

#[test]
fn a_girder_that_rolls_on_all_its_supports_is_computed_to_its_end() {
    // Its corners drop by more than `drop_m`, and no support comes to the end of its travel.
    let rolling = |travel: &str| {
        run(&scene(&format!(
            "name = \"rolling\"\nkind = \"spatial\"\nduration_s = 3.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 4.0\n\
             thickness_m = 6.0\nmass_kg = 6e5\nbearings = {{ frequency_hz = 1.5, damping_ratio = 0.02, vertical_frequency_hz = 3.0, {travel}\
             at_m = [[12, 1], [12, -1], [-12, 1], [-12, -1]] }}\n[motion]\nkind = \"sine\"\namplitude_g = 0.6\nfrequency_hz = 1.0\n\
             angle_deg = 90.0\n"
        )))
    };
    let [free, watched] = ["", "travel_m = 50.0, "].map(rolling);
    assert!(watched.stop().is_none(), "{:?}", watched.stop());
    let [one, other] = [&free, &watched].map(|history| history.motion(0, 3.0));
    within("as without a travel", (one.displacement - other.displacement).length(), 1e-9);
    let lowest = (0..=300).map(|i| {
        let m = watched.motion(0, 0.01 * f64::from(i));
        m.displacement.z - 2.0 * m.attitude.mul_vec3(glam::DVec3::Y).z.abs()
    });
    assert!(lowest.fold(0.0, f64::min) < -0.1, "a corner drops by more than 0.1 m");
}
