//! The contact model as K → ∞ against the impact model: where it goes, and how far that is from the paper's impulses.

use crate::support::scene;
use girderbench::sim::History;

const MU: f64 = 0.15;
const E_N: f64 = 0.4;

/// The straight girder without bearings, turned by 0.2 rad, thrown at a wall so that one corner hits and slips throughout.
fn thrown(stiffness: f64) -> girderbench::scene::Scene {
    scene(&format!(
        r#"
        name = "thrown"
        duration_s = 0.03
        [[girder]]
        name = "deck"
        length_m = 0.19
        width_m = 0.07
        thickness_m = 0.02
        mass_kg = 2.0
        initial = {{ rotation_deg = 11.459155902616466, velocity_m_s = [0.5, 2.0] }}
        [[abutment]]
        name = "wall"
        faces = "deck"
        gap_m = 0.008
        width_m = 4.0
        [contact]
        stiffness_n_per_m = {stiffness:e}
        restitution_normal = {E_N}
        restitution_tangential = 1.0
        mu_static = {MU}
        mu_kinetic = {MU}
        law = "paper"
        [impact]
        restitution_normal = {E_N}
        restitution_tangential = -0.9
        [solver]
        tolerance = 1e-12
        "#
    ))
}

/// Velocity of G just after the touch, and spin.
fn after(history: &History) -> [f64; 3] {
    let end = history.hits().touches().iter().map(|touch| touch.end).fold(0.0, f64::max);
    assert!(
        end > 0.0 && history.hits().touches().len() == 1,
        "one corner touches once: {:?}",
        history.hits().touches()
    );
    let motion = history.motion(0, end);
    [motion.velocity.x, motion.velocity.y, motion.spin.z]
}

/// `(Q_n, Q_s, w_n, w_ns)` of the limit (`docs/physics.md#limits-of-the-impact-model`), and levers.
fn limit() -> [f64; 3] {
    let (a, b, theta) = (0.095f64, 0.035f64, 0.2f64);
    let i2 = (a * a + b * b) / 3.0;
    // The corner at (a, −b), turned.
    let (x, y) = (a * theta.cos() + b * theta.sin(), a * theta.sin() - b * theta.cos());
    // n = (−1, 0), s = (0, −1): ρ × n = y, ρ × s = −x.
    let (rho_n, rho_s) = (y, -x);
    let (w_n, w_ns) = (1.0 + rho_n * rho_n / i2, rho_n * rho_s / i2);
    let (v_n, v_s) = (-0.5, -2.0f64);
    let sigma = v_s.signum();
    let xi = -E_N.ln() / (std::f64::consts::PI.powi(2) + E_N.ln().powi(2)).sqrt();
    // Both nodes face the wall when the pair closes: each has half of K.
    let nodes = 2.0;
    let give = w_n - MU * sigma * w_ns;
    let xi = xi * w_n / (nodes * give).sqrt();
    let e = (-std::f64::consts::PI * xi / (1.0 - xi * xi).sqrt()).exp();
    let q_n = -(1.0 + e) * v_n / give;
    let q_s = -MU * sigma * q_n;
    [0.5 - q_n, 2.0 - q_s, (rho_n * q_n + rho_s * q_s) / i2]
}

#[test]
#[expect(clippy::print_stdout, reason = "the table, with --nocapture")]
fn a_slipping_corner_hit_goes_to_the_stated_limit_as_the_stiffness_grows() {
    let expected = limit();
    let mut scene = thrown(1e5);
    scene.model.kind = girderbench::scene::ModelKind::Impact;
    let printed = History::of(&scene).expect("runs");
    let m = printed.motion(0, 0.019);
    let impact = [m.velocity.x, m.velocity.y, m.spin.z];
    let apart =
        |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|i| (a[i] - b[i]).abs() * [1.0, 1.0, 0.1][i]).fold(0.0, f64::max);
    let mut errors = Vec::new();
    for k in [1e5, 1e7, 1e9, 1e11] {
        let found = after(&History::of(&thrown(k)).expect("runs"));
        let error = apart(&found, &expected);
        println!("K = {k:e} N/m: {error:.3e} m/s from the limit, {:.3e} from (29)-(31)", apart(&found, &impact));
        errors.push(error);
    }
    println!("the limit is {:.3e} m/s from (29)-(31)", apart(&expected, &impact));
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log(100.0);
        assert!((order - 0.5).abs() < 0.1, "a touch takes 1/√K: {errors:?}");
    }
    assert!(errors[3] < 3e-5, "what is left at 1e11 N/m: {errors:?}");
}

#[test]
#[expect(clippy::print_stdout, reason = "the table, with --nocapture")]
fn a_flush_hit_differs_by_nature() {
    // A skewed girder along its axis: an elastic face spreads the push where it is pressed in.
    let flush = |kind: &str, stiffness: f64, flush: &str| {
        let scene = scene(&format!(
            r#"
            name = "flush"
            duration_s = 0.05
            model = {{ kind = "{kind}" }}
            [[girder]]
            name = "deck"
            length_m = 0.19
            width_m = 0.07
            thickness_m = 0.02
            skew_deg = 45.0
            mass_kg = 2.0
            initial = {{ velocity_m_s = [0.5, 0.0] }}
            [[abutment]]
            name = "wall"
            faces = "deck"
            gap_m = 0.005
            width_m = 4.0
            [contact]
            stiffness_n_per_m = {stiffness:e}
            mu_static = 0.2
            mu_kinetic = 0.15
            [impact]
            flush = "{flush}"
            "#
        ));
        let history = History::of(&scene).expect("runs");
        let end = history.hits().touches().iter().map(|touch| touch.end).fold(0.0, f64::max);
        let m = history.motion(0, end.max(0.02));
        [m.velocity.x, m.velocity.y, m.spin.z]
    };
    let paper = flush("impact", 1e5, "paper");
    let corners = flush("impact", 1e5, "two-corner");
    println!("paper {paper:?}, two corners {corners:?}");
    let mut last = [0.0; 3];
    for k in [1e6, 1e8, 1e10] {
        last = flush("contact", k, "paper");
        println!("K = {k:e}: {last:?}");
    }
    assert!((last[2] - paper[2]).abs() > 0.05, "the models part in the spin: {last:?} against {paper:?}");
}
