//! Rows of girders on piers against an integration of their own equations of motion by the classical Runge–Kutta method, mirrored,
//! and long.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use girderbench::scene::{Motion, Scene};
use girderbench::sim::History;

use crate::support::{run, scene, within};

/// Mass of each girder and of each pier \[kg\].
const GIRDERS: [f64; 3] = [6e5, 7e5, 5e5];
const PIERS: [f64; 2] = [2e5, 2.6e5];
/// Frequencies of the girders on piers that stand still \[Hz\], and damping ratio.
const FREQUENCIES: [f64; 3] = [0.9, 0.8, 1.1];
const RATIO: f64 = 0.06;
/// Stiffness of the piers along and across \[N/m\], turning stiffness \[N·m/rad\] and inertia \[kg·m²\].
const STIFFNESS: [[f64; 2]; 2] = [[4e7, 6e7], [7e7, 5e7]];
const TURN: [f64; 2] = [3e9, 4e9];
const INERTIA: [f64; 2] = [2.5e6, 3e6];
/// Length of a girder and places of its bearings before skewing \[m\].
const LENGTH: f64 = 30.0;
const PLACES: [[f64; 2]; 4] = [[14.2, 4.0], [14.2, -4.0], [-14.2, 4.0], [-14.2, -4.0]];

/// Three girders on two piers, ground at the far ends. `gap` \[m\] is between ends.
fn three_spans(skew_deg: f64, gap: f64, damping: f64, more: &str) -> Scene {
    let mut text = format!("name = \"three spans\"\nduration_s = 2.5\n[solver]\ntolerance = 1e-12\n{more}\n");
    let pitch = LENGTH + gap;
    for (i, (mass, f)) in GIRDERS.into_iter().zip(FREQUENCIES).enumerate() {
        let on = |key: &str, pier: Option<usize>| pier.map_or(String::new(), |n| format!(", {key} = \"p{n}\""));
        let x = pitch * i as f64;
        write!(
            text,
            "[[girder]]\nname = \"g{i}\"\nlength_m = {LENGTH}\nwidth_m = 10\nthickness_m = 1.5\nskew_deg = {skew_deg}\nmass_kg = \
             {mass:?}\nposition_m = [{x:?}, 0, 0]\nbearings = {{ frequency_hz = {f}, damping_ratio = {damping}, at_skewed_m = \
             {PLACES:?}{}{} }}\n",
            on("on_minus_x", i.checked_sub(1)),
            on("on_plus_x", (i < 2).then_some(i)),
        )
        .expect("text");
    }
    for (i, mass) in PIERS.into_iter().enumerate() {
        let turn = if skew_deg == 90.0 {
            String::new()
        } else {
            format!("turn_stiffness_n_m_per_rad = {:?}\nturn_inertia_kg_m2 = {:?}", TURN[i], INERTIA[i])
        };
        write!(
            text,
            "[[pier]]\nname = \"p{i}\"\nmass_kg = {mass:?}\nheading_deg = 0.0\nstiffness_n_per_m = {:?}\ndamping_ratio = {damping}\nposition_m = [{:?}, \
             0.0]\n{turn}\n",
            STIFFNESS[i],
            pitch * (i as f64 + 0.5)
        )
        .expect("text");
    }
    scene(&text)
}

/// A spring and dashpot per axis between points of two bodies, or of a body and the ground.
struct Element {
    bodies: [Option<usize>; 2],
    arms: [[f64; 2]; 2],
    stiffness: [f64; 2],
    damping: [f64; 2],
}

/// The equations of motion, put together here from the numbers above.
struct Viaduct {
    mass: [f64; 5],
    inertia: [f64; 5],
    elements: Vec<Element>,
    /// `k_θ` and `c_θ` of the piers.
    turn: [[f64; 2]; 2],
    /// Stiffness of an end that is pressed \[N/m\], and the gap \[m\].
    contact: [f64; 2],
}

const ZERO: [f64; 30] = [0.0; 30];

impl Viaduct {
    fn new(skew_deg: f64, gap: f64, damping: f64, contact: f64) -> Self {
        let shear = 1.0 / skew_deg.to_radians().tan();
        let shear = if skew_deg == 90.0 { 0.0 } else { shear };
        let pitch = LENGTH + gap;
        let mut elements = Vec::new();
        for (i, (mass, f)) in GIRDERS.into_iter().zip(FREQUENCIES).enumerate() {
            let omega = TAU * f;
            let share = [mass * omega * omega / 4.0, 2.0 * damping * mass * omega / 4.0];
            for [x, y] in PLACES {
                let arm = [x + y * shear, y];
                let pier = if x > 0.0 { (i < 2).then_some(i) } else { i.checked_sub(1) };
                let lever = pier.map_or([0.0; 2], |n| [pitch * (i as f64 - n as f64 - 0.5) + arm[0], arm[1]]);
                elements.push(Element {
                    bodies: [Some(i), pier.map(|n| 3 + n)],
                    arms: [arm, lever],
                    stiffness: [share[0]; 2],
                    damping: [share[1]; 2],
                });
            }
        }
        let mut turn = [[0.0; 2]; 2];
        for i in 0..2 {
            let damping = STIFFNESS[i].map(|k| 2.0 * damping * (k * PIERS[i]).sqrt());
            elements.push(Element {
                bodies: [Some(3 + i), None],
                arms: [[0.0; 2]; 2],
                stiffness: STIFFNESS[i],
                damping,
            });
            if skew_deg != 90.0 {
                turn[i] = [TURN[i], TURN[i] * damping[1] / STIFFNESS[i][1]];
            }
        }
        // i² of a parallelogram about its centroid: (a² + b²/sin²β)/12 with a along the axis and b square to it.
        let per_mass = (LENGTH * LENGTH + 100.0 * (1.0 + shear * shear)) / 12.0;
        let held = if skew_deg == 90.0 { f64::INFINITY } else { 1.0 };
        Self {
            mass: [GIRDERS[0], GIRDERS[1], GIRDERS[2], PIERS[0], PIERS[1]],
            inertia: [
                GIRDERS[0] * per_mass,
                GIRDERS[1] * per_mass,
                GIRDERS[2] * per_mass,
                INERTIA[0] * held,
                INERTIA[1] * held,
            ],
            elements,
            turn,
            contact: [contact, gap],
        }
    }

    /// Depths to which ends are pressed into each other \[m\].
    fn depths(&self, y: &[f64; 30]) -> [f64; 2] {
        [0, 1].map(|i| y[6 * i] - y[6 * (i + 1)] - self.contact[1])
    }

    fn slope(&self, ground: [f64; 2], y: &[f64; 30]) -> [f64; 30] {
        let mut out = ZERO;
        for e in &self.elements {
            let motion = |end: usize| {
                e.bodies[end].map_or([0.0; 4], |b| {
                    let (q, [x, l]) = (&y[6 * b..], e.arms[end]);
                    [q[0] - q[2] * l, q[1] + q[2] * x, q[3] - q[5] * l, q[4] + q[5] * x]
                })
            };
            let (here, there) = (motion(0), motion(1));
            let force =
                [0, 1].map(|a| -e.stiffness[a] * (here[a] - there[a]) - e.damping[a] * (here[2 + a] - there[2 + a]));
            for (end, sign) in [1.0, -1.0].into_iter().enumerate() {
                let Some(b) = e.bodies[end] else { continue };
                out[6 * b + 3] += sign * force[0] / self.mass[b];
                out[6 * b + 4] += sign * force[1] / self.mass[b];
                out[6 * b + 5] += sign * (e.arms[end][0] * force[1] - e.arms[end][1] * force[0]) / self.inertia[b];
            }
        }
        for i in 0..2 {
            let q = &y[6 * (3 + i)..];
            out[6 * (3 + i) + 5] -= (self.turn[i][0] * q[2] + self.turn[i][1] * q[5]) / self.inertia[3 + i];
        }
        for (i, depth) in self.depths(y).into_iter().enumerate() {
            let force = self.contact[0] * depth.max(0.0);
            out[6 * i + 3] -= force / self.mass[i];
            out[6 * (i + 1) + 3] += force / self.mass[i + 1];
        }
        for b in 0..5 {
            (0..3).for_each(|i| out[6 * b + i] = y[6 * b + 3 + i]);
            (0..2).for_each(|i| out[6 * b + 3 + i] -= ground[i]);
        }
        out
    }

    fn step(&self, ground: &dyn Fn(f64) -> [f64; 2], t: f64, h: f64, y: &[f64; 30]) -> [f64; 30] {
        let add = |k: &[f64; 30], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
        let k1 = self.slope(ground(t), y);
        let k2 = self.slope(ground(t + 0.5 * h), &add(&k1, 0.5 * h));
        let k3 = self.slope(ground(t + 0.5 * h), &add(&k2, 0.5 * h));
        let k4 = self.slope(ground(t + h), &add(&k3, h));
        std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    }

    /// The same, cut where an end touches or parts.
    fn step_with_kinks(&self, ground: &dyn Fn(f64) -> [f64; 2], t: f64, h: f64, y: &[f64; 30]) -> ([f64; 30], u32) {
        let end = self.step(ground, t, h, y);
        let signs = |y: &[f64; 30]| self.depths(y).map(|depth| depth > 0.0);
        if signs(y) == signs(&end) {
            return (end, 0);
        }
        let (mut low, mut high) = (0.0, h);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if signs(&self.step(ground, t, middle, y)) == signs(y) { low = middle } else { high = middle }
        }
        let kink = self.step(ground, t, high, y);
        let (end, more) = if high < h { self.step_with_kinks(ground, t + high, h - high, &kink) } else { (kink, 0) };
        (end, more + 1)
    }
}

/// Largest difference of places of all bodies from the integration in `count` steps, over the largest displacement; and how many
/// kinks it met.
fn apart(history: &History, viaduct: &Viaduct, ground: &dyn Fn(f64) -> [f64; 2], count: u32) -> (f64, u32) {
    let h = 2.5 / f64::from(count);
    let (mut y, mut worst, mut largest, mut kinks) = (ZERO, 0.0f64, 0.0f64, 0);
    for n in 0..count {
        let (next, met) = viaduct.step_with_kinks(ground, f64::from(n) * h, h, &y);
        (y, kinks) = (next, kinks + met);
        if (n + 1) % 500 == 0 {
            for b in 0..5 {
                let motion = history.motion(b, f64::from(n + 1) * h);
                let here = [motion.displacement.x, motion.displacement.y, 15.0 * motion.theta];
                let there = [y[6 * b], y[6 * b + 1], 15.0 * y[6 * b + 2]];
                worst = (0..3).map(|i| (here[i] - there[i]).abs()).fold(worst, f64::max);
                largest = there.into_iter().map(f64::abs).fold(largest, f64::max);
            }
        }
    }
    (worst / largest, kinks)
}

#[test]
fn three_skewed_spans_on_piers_that_turn_are_those_of_an_integration_by_hand() {
    // Gaps so wide that nothing touches.
    let motion = "[motion]\nkind = \"record\"\nsamples_m_s2 = [0.0, 1.2, -0.7, 2.1, -2.4, 0.6, 1.8, -1.1, 0.9, -0.4, 0.0]\ndt_s = 0.2\nangle_deg = 30.0";
    let samples = [0.0, 1.2, -0.7, 2.1, -2.4, 0.6, 1.8, -1.1, 0.9, -0.4, 0.0, 0.0];
    let (sine, cosine) = 30f64.to_radians().sin_cos();
    let ground = |t: f64| {
        let j = (0..10).rev().find(|&j| 0.2 * j as f64 <= t + 1e-9).unwrap_or(0);
        let a = samples[j] + (samples[j + 1] - samples[j]) * (t / 0.2 - j as f64).clamp(0.0, 1.0);
        [a * cosine, a * sine]
    };
    let history = run(&three_spans(60.0, 0.6, RATIO, motion));
    assert_eq!(history.summary().hits, 0, "nothing touches");
    let viaduct = Viaduct::new(60.0, 0.6, RATIO, 0.0);
    let (error, _) = apart(&history, &viaduct, &ground, 25_000);
    within("three spans", error, 1e-9);
    assert!(history.energy().balance().holds(), "{:?}", history.energy().ledger(2.5));
}

#[test]
fn three_spans_that_pound_are_those_of_an_integration_by_hand() {
    let motion = "[contact]\nstiffness_n_per_m = 1e9\nrestitution_normal = 1.0\nrestitution_tangential = 1.0\n[motion]\nkind = \
                  \"sine\"\namplitude_m_s2 = 2.5\nfrequency_hz = 0.9";
    let history = run(&three_spans(90.0, 0.02, 0.0, motion));
    let ground = |t: f64| [2.5 * (TAU * 0.9 * t).sin(), 0.0];
    let viaduct = Viaduct::new(90.0, 0.02, 0.0, 1e9);
    let (error, kinks) = apart(&history, &viaduct, &ground, 50_000);
    assert!(kinks >= 4 && history.summary().hits >= 2, "they pound: {kinks}, {:?}", history.summary());
    within("three spans that pound", error, 1e-9);
    assert!(history.energy().balance().holds(), "{:?}", history.energy().ledger(2.5));
}

#[test]
fn a_viaduct_that_nothing_hits_takes_no_step_and_keeps_its_energy() {
    let history =
        run(&three_spans(60.0, 2.0, RATIO, "[motion]\nkind = \"sine\"\namplitude_g = 0.1\nfrequency_hz = 0.7"));
    assert_eq!(history.effort().steps, 0, "steps of the integrator");
    for t in [0.7, 1.9, 2.5] {
        let ledger = history.energy().ledger(t);
        let part = ledger.residual.abs() / ledger.scale;
        assert!(part < 1e-13, "{part} of the energy at {t} s");
    }
}

#[test]
fn a_mirrored_viaduct_moves_as_its_image() {
    let motion = |angle: f64| {
        format!("[motion]\nkind = \"sine\"\namplitude_m_s2 = 3.0\nfrequency_hz = 1.0\nangle_deg = {angle}")
    };
    let [one, image] =
        [(60.0, 25.0), (120.0, -25.0)].map(|(skew, angle)| run(&three_spans(skew, 0.03, RATIO, &motion(angle))));
    assert!(one.summary().hits > 0, "they touch");
    let mut worst = 0.0f64;
    for body in 0..5 {
        for i in 0..=50 {
            let (a, b) = (one.motion(body, 0.05 * f64::from(i)), image.motion(body, 0.05 * f64::from(i)));
            let (d, e) = (a.displacement, b.displacement);
            worst = [d.x - e.x, d.y + e.y, 15.0 * (a.theta + b.theta)].into_iter().map(f64::abs).fold(worst, f64::max);
        }
    }
    within("image", worst, 1e-9);
}

/// A row of `count` spans on piers that moves as one: each span at every pier as the next.
fn long(count: usize) -> Scene {
    let mut text = String::from(
        "name = \"long\"\nduration_s = 3.0\n[motion]\nkind = \"sine\"\namplitude_m_s2 = 2.0\nfrequency_hz = 0.8\nangle_deg = 20.0\n",
    );
    for i in 0..count {
        let on = |key: &str, pier: Option<usize>| pier.map_or(String::new(), |n| format!(", {key} = \"p{n}\""));
        write!(
            text,
            "[[girder]]\nname = \"g{i}\"\nlength_m = 30\nwidth_m = 10\nthickness_m = 1.5\nmass_kg = {}\nposition_m = [{:?}, 0, 0]\nbearings \
             = {{ frequency_hz = 0.9, damping_ratio = 0.05, at_m = [[14.2, 4], [14.2, -4], [-14.2, 4], [-14.2, -4]]{}{} }}\n",
            if i % 2 == 0 { 6e5 } else { 7e5 },
            30.3 * i as f64,
            on("on_minus_x", i.checked_sub(1)),
            on("on_plus_x", (i + 1 < count).then_some(i)),
        )
        .expect("text");
    }
    for i in 0..count - 1 {
        write!(text, "[[pier]]\nname = \"p{i}\"\nmass_kg = 2e5\nstiffness_n_per_m = [5e7, 8e7]\n").expect("text");
    }
    scene(&text)
}

#[test]
fn the_work_of_a_viaduct_of_two_hundred_spans_is_that_of_its_length() {
    let spent = |count: usize| {
        let history = run(&long(count));
        let effort = history.effort();
        (effort.steps, effort.searches as f64 / count as f64, history.bytes() as f64 / count as f64)
    };
    let ((few, searches, bytes), (many, searched, took)) = (spent(20), spent(200));
    assert!(
        many as f64 <= 1.2 * few as f64,
        "{many} steps of 200 spans, {few} of 20: a step of all bodies is linear in their number"
    );
    assert!(searched <= 1.5 * searches, "{searched} searches a span, {searches} of 20");
    assert!(took <= 1.3 * bytes, "{took} bytes a span, {bytes} of 20");
}

#[test]
fn still_ground_leaves_a_viaduct_at_rest() {
    let mut scene = three_spans(60.0, 0.05, RATIO, "");
    scene.motion = Motion::None;
    let history = run(&scene);
    let most = (0..5).map(|body| history.motion(body, 2.5).displacement.length()).fold(0.0, f64::max);
    assert_eq!(most, 0.0, "to the last bit");
}
