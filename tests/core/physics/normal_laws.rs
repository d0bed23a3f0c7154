//! The other normal laws through the solver: restitution, depth and duration of a free head-on hit against closed forms, and
//! runs of 5 s against an independent program.

use crate::support::reference::rows;
use crate::support::{momenta, run, scene, within};
use girderbench::scene::{Scene, overrides, presets};
use girderbench::sim::History;

/// A straight girder of 2 kg, 5 mm before a wall, moving at it; K = 155 kN/m.
fn hit(law: &str, restitution: f64, speed: f64) -> Scene {
    scene(&format!(
        r#"
        name = "hit"
        duration_s = 0.2
        [[girder]]
        name = "deck"
        length_m = 0.19
        width_m = 0.07
        thickness_m = 0.02
        mass_kg = 2.0
        initial = {{ velocity_m_s = [{speed}, 0.0] }}
        [[abutment]]
        name = "wall"
        faces = "deck"
        gap_m = 0.005
        width_m = 2.0
        [contact]
        stiffness_n_per_m = 1.55e5
        restitution_normal = {restitution}
        {law}
        [solver]
        tolerance = 1e-12
        "#
    ))
}

#[test]
fn a_force_held_at_zero_costs_the_ledger_no_digits() {
    // The loss of the held phase is that of the spring: its power has a root at the opening, in a step that no force shortens.
    for tolerance in [1e-10, 1e-12] {
        let mut scene = hit("normal_law = \"hertz-viscous\"\ntension = \"clamp\"", 0.4, 0.5);
        scene.solver.tolerance = tolerance;
        let history = run(&scene);
        let balance = history.energy().balance();
        assert!(balance.holds(), "{balance:?} at {tolerance:e}");
        within(&format!("residual at {tolerance:e}"), balance.residual, 100.0 * tolerance);
    }
}

/// Laws in words, with e', the largest penetration \[mm\] and the duration \[ms\] of a hit at restitution and speed:
/// `docs/physics.md#restitution-of-the-other-laws`, closed forms; NaN where there is none, or where the touch
/// outlasts the force.
const HITS: &[(&str, f64, f64, [f64; 3])] = &[
    ("normal_law = \"kelvin-voigt\"", 0.4, 0.3, [0.4, 0.740_368_332_179_9, 11.755_132_362]),
    ("tension = \"clamp\"", 0.4, 0.3, [0.472_013_980_170_6, 0.740_368_332_179_9, f64::NAN]),
    ("tension = \"clamp\"\ncalibration = \"exact\"", 0.4, 0.3, [0.4, 0.681_554_201_096_5, f64::NAN]),
    ("tension = \"clamp\"\ncalibration = \"exact\"", 0.65, 0.3, [0.65, 0.868_814_542_740_5, f64::NAN]),
    ("normal_law = \"approach\"", 0.4, 0.3, [0.4, 0.431_052_724_864_3, 9.386_800_123]),
    ("normal_law = \"approach\"", 0.65, 0.3, [0.65, 0.700_460_677_904_4, 10.341_669_064]),
    (
        "normal_law = \"approach\"\ncalibration = \"published\"",
        0.4,
        0.3,
        [0.407_076_199_889, 0.438_678_262_973_8, 9.419_163_760],
    ),
    ("normal_law = \"hertz\"", 0.4, 0.3, [1.0, 1.077_631_812_161, 10.572_556_569]),
    ("normal_law = \"hertz\"", 0.4, 0.1, [1.0, 0.447_479_763_307_5, 13.170_560_828]),
    ("normal_law = \"hertz-damp\"", 0.4, 0.3, [0.4, 0.776_847_021_985_6, 12.506_290_208]),
    ("normal_law = \"hertz-damp\"", 0.4, 0.1, [0.4, 0.322_580_790_211_9, 15.579_472_652]),
    (
        "normal_law = \"hertz-damp\"\ncalibration = \"published\"",
        0.4,
        0.3,
        [0.701_634_727_673_5, 0.941_053_419_495_8, 11.080_535_088],
    ),
    (
        "normal_law = \"hertz-damp\"\nlaw_parameter = 2.4",
        0.4,
        0.3,
        [0.362_872_318_508_3, 0.753_198_604_943_7, 12.844_574_749],
    ),
    ("normal_law = \"hertz-viscous\"", 0.4, 0.3, [0.4, 0.798_090_880_286_1, 11.991_315_790]),
    ("normal_law = \"hertz-viscous\"", 0.65, 0.3, [0.65, 0.920_720_769_162_3, 11.124_530_057]),
    ("normal_law = \"jankowski\"", 0.4, 0.3, [0.4, 0.517_747_960_168_7, 10.394_030_763]),
    ("normal_law = \"jankowski\"", 0.65, 0.3, [0.65, 0.763_486_019_248_1, 10.462_958_682]),
    ("normal_law = \"bilinear\"", 0.4, 0.3, [0.4, 0.792_642_939_878_9, 13.421_640_622]),
    ("normal_law = \"bilinear\"", 0.4, 0.1, [0.669_335_524_779_5, 0.131_351_310_765, 4.900_255_564]),
    (
        "normal_law = \"bilinear\"\ncalibration = \"published\"",
        0.4,
        0.3,
        [0.704_986_516_200_1, 0.877_776_227_867, 11.196_966_331],
    ),
];

#[test]
fn a_head_on_hit_returns_its_restitution_depth_and_duration() {
    for (law, restitution, speed, [returned, depth, duration]) in HITS {
        let (scene, what) =
            (hit(law, *restitution, *speed), format!("{} e {restitution} v {speed}", law.replace('\n', " ")));
        let history = run(&scene);
        let end = history.motion(0, scene.duration);
        within(&format!("{what}: e'"), -end.velocity.x / speed - returned, 1e-10);
        let touches = history.hits().touches();
        assert_eq!(touches.len(), 2, "{what}: one touch of each corner");
        let [start, end] = [touches[0].start, touches[0].end];
        if duration.is_finite() {
            within(&format!("{what}: duration"), (end - start) / (1e-3 * duration) - 1.0, 5e-9);
        }
        let deepest = history.motion(0, reversal(&history, [start, end])).displacement.x - 0.005;
        within(&format!("{what}: depth"), deepest / (1e-3 * depth) - 1.0, 1e-9);
        let books = history.energy().ledger(scene.duration);
        within(&format!("{what}: ledger"), books.residual / (speed * speed), 1e-9);
    }
}

/// When the girder turns back between two times \[s\].
fn reversal(history: &History, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if history.motion(0, middle).velocity.x > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// A straight girder on its bearings, 3 mm before a wall, shaken along its axis in resonance with its bearings for 5 s.
fn shaken(law: &str) -> Scene {
    scene(&format!(
        r#"
        name = "shaken"
        duration_s = 5.0
        [[girder]]
        name = "deck"
        length_m = 0.19
        width_m = 0.07
        thickness_m = 0.02
        mass_kg = 2.0
        bearings = {{ frequency_hz = 2.4, damping_ratio = 0.29, at_m = [[0.07, 0.025], [0.07, -0.025], [-0.07, 0.025], [-0.07, -0.025]] }}
        [[abutment]]
        name = "wall"
        faces = "deck"
        gap_m = 0.003
        width_m = 2.0
        [motion]
        kind = "sine"
        frequency_hz = 2.4
        amplitude_m_s2 = 3.92266
        [contact]
        stiffness_n_per_m = 1.55e5
        {law}
        [solver]
        tolerance = 1e-12
        "#
    ))
}

/// Runs of an independent program (`tests/data/README.md`), laws in words, and how far that program agrees with itself.
const RUNS: &[(&str, &str, f64)] = &[
    ("bilinear_exact", "normal_law = \"bilinear\"", 1e-9),
    ("bilinear_published", "normal_law = \"bilinear\"\ncalibration = \"published\"", 1e-9),
    ("hertz", "normal_law = \"hertz\"", 1e-9),
    ("hertz-viscous", "normal_law = \"hertz-viscous\"", 1e-9),
    ("hunt-crossley_exact", "normal_law = \"hertz-damp\"", 1e-9),
    ("hunt-crossley_mud", "normal_law = \"hertz-damp\"\ncalibration = \"published\"", 1e-9),
    ("hunt-crossley_ye", "normal_law = \"hertz-damp\"\nlaw_parameter = 2.4", 1e-9),
    ("jankowski_2006", "normal_law = \"jankowski\"\ncalibration = \"published\"", 1e-9),
    ("jankowski_exact", "normal_law = \"jankowski\"", 1e-9),
    ("kv-approach_exact", "normal_law = \"approach\"", 1e-9),
    ("kv-clamp_65", "tension = \"clamp\"", 1e-9),
    ("kv-clamp_exact", "tension = \"clamp\"\ncalibration = \"exact\"", 1e-9),
];

#[test]
fn five_seconds_of_pounding_are_those_of_an_independent_program() {
    for (name, law, tolerance) in RUNS {
        let history = run(&shaken(law));
        let rows = rows(&format!("laws/{name}"));
        let largest = rows.iter().map(|row| row[1].abs()).fold(0.0, f64::max);
        let off = rows.iter().map(|row| (history.motion(0, row[0]).displacement.x - row[1]).abs()).fold(0.0, f64::max);
        within(name, off / largest, *tolerance);
    }
}

#[test]
fn a_law_keeps_momentum_angular_momentum_and_energy_of_two_free_girders() {
    for law in ["approach", "hertz", "hertz-damp", "hertz-viscous", "jankowski", "bilinear"] {
        for friction in ["paper", "return-mapping"] {
            let scene = scene(&oblique(law, friction));
            let history = run(&scene);
            let what = format!("{law}, {friction}");
            assert!(!history.hits().touches().is_empty(), "{what}: they hit");
            let [before, after] = [0.0, scene.duration].map(|t| momenta(&history, t));
            for n in 0..2 {
                within(&format!("{what}: momentum {n}"), after[n] - before[n], 1e-11);
            }
            // The dashpots of a law of one stiffness act at the anchor and turn the pair, as in the paper.
            if law != "approach" {
                within(&format!("{what}: angular momentum"), after[2] - before[2], 1e-11);
            }
            let books = history.energy().ledger(scene.duration);
            within(&format!("{what}: ledger"), books.residual / books.scale, 1e-8);
        }
    }
}

#[test]
fn a_node_that_takes_over_at_depth_brings_its_energy_into_the_ledger() {
    // Corners pass each other in this row, so that faces hand over at finite depth.
    for law in ["hertz", "bilinear"] {
        let preset = presets::load("row-of-5").expect("a preset");
        let sets = [format!("contact.normal_law={law}"), "duration_s=3.5".to_owned()];
        let scene = overrides::apply_all(&preset, &sets).unwrap_or_else(|errors| panic!("{errors}"));
        let history = run(&scene);
        let books = history.energy().ledger(scene.duration);
        assert!(books.jump_entry < -100.0, "{law}: a node begins inside, {} J", books.jump_entry);
        within(&format!("{law}: ledger"), books.residual / books.scale, 1e-8);
    }
}

/// Two free girders, one of which hits the other's skewed end off its middle, turning.
fn oblique(law: &str, friction: &str) -> String {
    format!(
        r#"
        name = "oblique"
        duration_s = 0.2
        [[girder]]
        name = "one"
        length_m = 0.19
        width_m = 0.07
        thickness_m = 0.02
        skew_deg = 60
        mass_kg = 2.0
        initial = {{ velocity_m_s = [0.5, 0.1], spin_deg_s = 40 }}
        [[girder]]
        name = "two"
        length_m = 0.25
        width_m = 0.09
        thickness_m = 0.02
        skew_deg = 60
        mass_kg = 3.0
        position_m = [0.235, 0.01, 0.0]
        [contact]
        stiffness_n_per_m = 1.55e5
        normal_law = "{law}"
        law = "{friction}"
        [solver]
        tolerance = 1e-12
        "#
    )
}
