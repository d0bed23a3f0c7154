//! Supports that are lost: when, what then acts, and where a run stops, against closed forms.

use girderbench::scene::{STANDARD_GRAVITY, Scene, overrides};
use girderbench::sim::{History, Quantity};
use girderbench::tables::{Report, TableOptions, trajectory};

use super::devices::girder;
use crate::support::{run, scene, within};

/// The model girder of 2 kg moving along x at 0.3 m/s on two springs of 100 N/m in line; the first loses its support at 10 mm.
fn on_two(after: &str) -> Scene {
    let leg = |x: f64, travel: &str| {
        format!("{{ at_m = [{x}, 0], stiffness_n_per_m = [100, 100], damping_n_s_per_m = [0, 0]{travel} }}")
    };
    let words = format!(
        "initial = {{ velocity_m_s = [0.3, 0.0] }}\nafter_unseating = \"{after}\"\nbearings = [{}, {}]",
        leg(0.05, ", travel_m = 0.01"),
        leg(-0.05, "")
    );
    girder(90.0, &words, [0.0, 1.0, 0.0], 0.4)
}

/// When the girder has moved 10 mm: u = v₀/ω sin ωt, ω = 10 rad/s.
fn lost_at() -> f64 {
    (0.01f64 * 10.0 / 0.3).asin() / 10.0
}

#[test]
fn a_run_stops_where_a_bearing_passes_its_travel() {
    let history = History::of(&on_two("stop")).expect("a scene");
    let stop = history.stop().expect("it stops").clone();
    within("when", stop.t - lost_at(), 1e-14);
    within("where it ends", history.end() - lost_at(), 1e-14);
    assert!(
        stop.reason.to_string().contains("vertical support is lost")
            && stop.reason.to_string().contains("deck.bearing1"),
        "{stop:?}"
    );
    let report = Report::of(&history, &TableOptions::default());
    let lost = &report.lost_supports[0];
    assert_eq!((lost.bearing.as_str(), report.lost_supports.len()), ("deck.bearing1", 1));
    within("place", lost.place[0] - 0.06, 1e-13);
}

#[test]
fn a_run_that_goes_on_is_without_the_bearing_and_releases_its_energy() {
    let history = run(&on_two("continue"));
    let t = lost_at();
    // Half of the stiffness remains: 50 rad/s².
    let (omega, speed) = (50f64.sqrt(), 0.3 * (10.0 * t).cos());
    for after in [0.05, 0.15, 0.3] {
        let u = 0.01 * (omega * after).cos() + speed / omega * (omega * after).sin();
        within("place", history.motion(0, t + after).displacement.x - u, 1e-11);
        within("no turn: both are on the axis", history.motion(0, t + after).theta, 1e-12);
    }
    for part in [0.3, 0.9] {
        let left = history.connections().link(0, part * t).expect("the support").gap;
        within("left of its travel", left - (0.01 - 0.03 * (10.0 * part * t).sin()), 1e-12);
    }
    let books = history.energy().ledger(0.4);
    within("released", books.jump_device - 0.5 * 100.0 * 0.01 * 0.01, 1e-13);
    within("ledger", books.residual / books.scale, 1e-10);
    let force = |name: &str, t: f64| Quantity::find(&history, name).expect("a quantity").at(&history, t);
    within("before", force("deck.bearing1.force-x", 0.9 * t) - 100.0 * force("deck.x", 0.9 * t), 1e-12);
    assert_eq!(force("deck.bearing1.force-x", t + 0.1), 0.0, "gone");
    assert!(force("deck.bearing2.force-x", t + 0.1) > 0.5, "the other is there");
    let mut table = Vec::new();
    trajectory(&history, 100.0, &mut table).expect("memory takes it");
    let table = String::from_utf8(table).expect("text");
    let marks: Vec<&str> = table.lines().filter_map(|line| line.rsplit(',').next()).collect();
    assert_eq!((marks[0], marks[1], marks[marks.len() - 1]), ("lost_supports", "0", "1"), "every later sample");
}

#[test]
fn a_bearing_that_yields_loses_its_support_with_what_it_had_stored() {
    let with = |travel: &str| {
        let words = format!(
            "initial = {{ velocity_m_s = [0.15, 0.0] }}\nafter_unseating = \"continue\"\nbearings = [{{ at_m = [0.0, 0.0], \
             stiffness_n_per_m = [10.0, 10.0], damping_n_s_per_m = [0.0, 0.0], yield_force_n = 0.55, \
             yield_displacement_m = 0.01{travel} }}]"
        );
        run(&girder(90.0, &words, [0.0, 1.0, 0.0], 0.6))
    };
    let (bound, lost) = (with(""), with(", travel_m = 0.02"));
    let supports = lost.seats().lost_supports(0.6);
    let t = supports[0].t;
    within("as far without the loss", bound.motion(0, t).displacement.x - 0.02, 1e-13);
    // z = Q, k_t = 55 N/m.
    let stored = 0.5 * 10.0 * 0.02 * 0.02 + 0.55 * 0.55 / (2.0 * 55.0);
    let books = lost.energy().ledger(0.6);
    within("released", books.jump_device - stored, 1e-12);
    within("ledger", books.residual / books.scale, 1e-10);
    let after = lost.motion(0, 0.6);
    within("free", after.velocity.x - lost.motion(0, t).velocity.x, 1e-12);
}

#[test]
fn a_bearing_leaves_the_seat_of_its_own_end_over_its_front_edge() {
    // 60°: the leg 20 mm from the +x end stands 30 · sin 60° mm behind the edge of a seat of 50 mm.
    let words = "initial = { velocity_m_s = [-0.1, 0.02] }\nafter_unseating = \"stop\"\n\
                 seat_m = { \"+x\" = 0.05, \"-x\" = 0.05 }\n\
                 bearings = [{ at_m = [0.075, 0], stiffness_n_per_m = [0, 0], damping_n_s_per_m = [0, 0] }, \
                 { at_m = [-0.075, 0], stiffness_n_per_m = [0, 0], damping_n_s_per_m = [0, 0] }]";
    let history = History::of(&girder(60.0, words, [0.0, 1.0, 0.0], 1.0)).expect("a scene");
    let (sine, cosine) = 60f64.to_radians().sin_cos();
    let expected = 0.03 * sine / (0.1 * sine + 0.02 * cosine);
    let stop = history.stop().expect("it stops");
    within("when", stop.t - expected, 1e-14);
    assert!(stop.reason.to_string().contains("deck.bearing1"), "that of the end that it leaves: {stop:?}");
    let measured = girder(60.0, &words.replace("after_unseating = \"stop\"\n", ""), [0.0, 1.0, 0.0], 1.0);
    assert!(run(&measured).seats().lost_supports(1.0).is_empty(), "a seat that is only measured");
    let short = words.replace("\"+x\" = 0.05", "\"+x\" = 0.015");
    let errors = History::of(&girder(60.0, &short, [0.0, 1.0, 0.0], 1.0)).expect_err("off as placed");
    assert!(errors.to_string().contains("bearing 1 beyond the front edge"), "{errors}");
}

/// A deck of 60 t in space sliding at 0.5 m/s on four legs without horizontal stiffness.
fn deck(words: &str) -> Scene {
    scene(&format!(
        r#"
        name = "deck"
        kind = "spatial"
        duration_s = 2.0
        [[girder]]
        name = "deck"
        length_m = 10.0
        width_m = 4.0
        thickness_m = 1.0
        mass_kg = 6e4
        initial = {{ velocity_m_s = [0.5, 0.0] }}
        {words}
        [solver]
        tolerance = 1e-11
        "#
    ))
}

#[test]
fn a_girder_in_space_that_loses_all_legs_falls_freely_until_its_corners_have_dropped() {
    let bearings = "bearings = { frequency_hz = 0, damping_ratio = 0, vertical_frequency_hz = 10, travel_m = 0.05, \
                    at_m = [[4, 1.5], [4, -1.5], [-4, 1.5], [-4, -1.5]] }";
    let history = History::of(&deck(bearings)).expect("a scene");
    let supports = history.seats().lost_supports(2.0);
    assert_eq!(supports.len(), 4);
    for lost in &supports {
        within("lost", lost.t - 0.1, 1e-12);
    }
    let stop = history.stop().expect("it falls");
    within("a tenth of a metre down", stop.t - (0.1 + (2.0 * 0.1 / STANDARD_GRAVITY).sqrt()), 1e-10);
    assert!(stop.reason.to_string().contains("comes off its supports"), "{stop:?}");
    let books = history.energy().ledger(history.end());
    // Springs under the weight: m g²/(2 ω²).
    let omega = std::f64::consts::TAU * 10.0;
    let springs = 6e4 * STANDARD_GRAVITY.powi(2) / (2.0 * omega * omega);
    within("the springs' energy", books.jump_device / springs - 1.0, 1e-9);
    within("ledger", books.residual / books.scale, 1e-9);
}

/// A pier that nothing moves is ground: in space bearings on it are lost as those on the ground are.
#[test]
fn a_girder_in_space_loses_its_support_on_a_pier_and_on_ground_that_moves_otherwise() {
    let on = |words: &str, supports: &str| {
        let bearings = "frequency_hz = 0, damping_ratio = 0, vertical_frequency_hz = 10, travel_m = 0.05, \
                        at_m = [[4, 1.5], [4, -1.5], [-4, 1.5], [-4, -1.5]]";
        History::of(&deck(&format!("bearings = {{ {bearings}{words} }}\n{supports}"))).expect("a scene")
    };
    let pier = "[[pier]]\nname = \"p\"\nmass_kg = 1e9\nfrequency_hz = 30\ndamping_ratio = 0.05";
    let walls = "[[abutment]]\nname = \"w\"\nfaces = \"deck\"\nend = \"-x\"\ngap_m = 1.0\nmotion_factor = 0.5\n\
                 [[abutment]]\nname = \"e\"\nfaces = \"deck\"\ngap_m = 1.0\nmotion_factor = 0.5\n\
                 [motion]\nkind = \"sine\"\namplitude_g = 1e-9\nfrequency_hz = 1.0";
    let cases = [(", on_minus_x = \"p\", on_plus_x = \"p\"", pier), (", on_minus_x = \"w\", on_plus_x = \"e\"", walls)];
    for (words, supports) in cases {
        let history = on(words, supports);
        let lost = history.seats().lost_supports(2.0);
        assert_eq!(lost.len(), 4, "{supports}");
        for lost in &lost {
            within("lost", lost.t - 0.1, 1e-6);
        }
        let stop = history.stop().expect("it falls");
        within("a tenth of a metre down", stop.t - (0.1 + (2.0 * 0.1 / STANDARD_GRAVITY).sqrt()), 1e-4);
        let books = history.energy().ledger(history.end());
        within("ledger", books.residual / books.scale, 1e-8);
    }
}

#[test]
fn a_girder_in_space_that_loses_two_legs_tips() {
    // Only the legs at one side can be lost: it tips about the others.
    let leg = |x: f64, y: f64, travel: &str| {
        format!("{{ at_m = [{x}, {y}], stiffness_n_per_m = [1e4, 1e5, 1e8], damping_n_s_per_m = [0, 0, 1e5]{travel} }}")
    };
    let legs = [
        leg(4.0, 1.5, ", travel_m = 0.05"),
        leg(4.0, -1.5, ", travel_m = 0.05"),
        leg(-4.0, 1.5, ""),
        leg(-4.0, -1.5, ""),
    ];
    let scene = deck(&format!("bearings = [{}]", legs.join(", ")));
    let history = History::of(&scene).expect("a scene");
    assert_eq!(history.seats().lost_supports(2.0).len(), 2, "at the +x end");
    let stop = history.stop().expect("it tips");
    let lost = history.seats().lost_supports(2.0)[0].t;
    let end = history.motion(0, stop.t);
    let nose = end.place + end.attitude * glam::DVec3::new(5.0, 0.0, -0.5);
    within("its nose is down", nose.z + 0.5 + 0.1, 1e-6);
    // A rod that swings about the legs at −4 m: α = g a/(i² + a²), the nose 9 m from them.
    let (arm, gyration2) = (4.0f64, (100.0 + 1.0) / 12.0);
    let swing = (2.0 * 0.1 * (gyration2 + arm * arm) / (STANDARD_GRAVITY * arm * 9.0)).sqrt();
    within("as fast as a rod", (stop.t - lost) / swing - 1.0, 0.1);
    let deeper = overrides::apply(&scene, "girder.deck.drop_m=0.2").expect("a key");
    assert!(History::of(&deeper).expect("a scene").stop().expect("later").t > stop.t + 0.02);
    let books = history.energy().ledger(history.end());
    within("ledger", books.residual / books.scale, 1e-8);
}

/// m v̇ = −F, Ḟ = K (v − F/c): the slow one of its two exponentials after a start without force, and all that the fast one
/// leaves, `x = Σ aᵢ (e^{λᵢt} − 1)/λᵢ` with `a₁ + a₂ = v₀`, `a₁λ₁ + a₂λ₂ = 0`.
#[test]
fn how_far_a_girder_is_beyond_its_lost_supports_is_no_measure_of_its_error() {
    let (mass, speed, coefficient, brace) = (6e4, 0.5, 6e4, 6e8f64);
    let scene = scene(&format!(
        r#"
        name = "adrift"
        kind = "planar"
        duration_s = 2.0
        motion = {{ kind = "none" }}
        [[girder]]
        name = "deck"
        length_m = 10.0
        width_m = 4.0
        thickness_m = 1.0
        mass_kg = {mass}
        initial = {{ velocity_m_s = [{speed}, 0.0] }}
        after_unseating = "continue"
        bearings = {{ frequency_hz = 0, damping_ratio = 0, travel_m = 0.004, at_m = [[4, 0], [-4, 0]] }}
        [[damper]]
        name = "braced"
        girder = "deck"
        at_m = [5.0, 0.0]
        to_m = [9.0, 0.0]
        coefficient = {coefficient}
        exponent = 1.0
        brace_stiffness_n_per_m = {brace}
        [solver]
        tolerance = 1e-8
        "#
    ));
    let history = History::of(&scene).expect("a scene");
    assert_eq!(history.seats().lost_supports(2.0).len(), 2, "a hundred travels away");
    let (half, root) = (-brace / (2.0 * coefficient), (brace / (2.0 * coefficient)).powi(2) - brace / mass);
    let fast = half - root.sqrt();
    let slow = brace / mass / fast;
    let [a, b] = [-fast, slow].map(|other| speed * other / (slow - fast));
    for t in [0.1, 0.5, 1.0, 2.0] {
        let exact = a * (slow * t).exp_m1() / slow + b * (fast * t).exp_m1() / fast;
        within("adrift", (history.motion(0, t).displacement.x - exact) / exact, 1e-8);
    }
}

/// Places of G of a thin deck that bends and loses a bearing in space, by an independent program that takes the bearing away \[s, m\]; the
/// bearing is lost at 0.0205 s. A force that takes the bearing's away on a rigid section left 2.9 mm of z and 0.6 mm of y.
#[test]
fn a_bending_girder_in_space_feels_nothing_of_a_lost_bearing() {
    const PLACES: [(f64, [f64; 3]); 4] = [
        (0.1, [0.036_497_751_525_139_566, 2.335_227_206_381_111_2e-5, -0.007_267_415_500_553_011_5]),
        (0.2, [0.024_037_797_611_479_98, 0.000_730_915_293_385_069_7, -0.026_999_018_539_272_01]),
        (0.35, [-0.031_791_269_634_220_87, 0.002_603_850_260_750_27, -0.067_047_469_432_561_79]),
        (0.5, [-0.006_617_723_834_936_124, -0.001_181_337_472_538_417_4, -0.088_054_351_703_656_22]),
    ];
    let bearing = |x: f64, y: f64| {
        let travel = if x > 0.0 && y < 0.0 { ", travel_m = 0.01" } else { "" };
        format!(
            "{{ at_m = [{x}, {y}], stiffness_n_per_m = [2e7, 2e7, 6e8], damping_n_s_per_m = [1e5, 1e5, 1e6], height_m = 0.0{travel} }}"
        )
    };
    let bearings: Vec<String> = [-13.0, 13.0].into_iter().flat_map(|x| [-3.0, 3.0].map(|y| bearing(x, y))).collect();
    let history = run(&scene(&format!(
        "name = \"deck\"\nkind = \"spatial\"\nduration_s = 0.5\n[solver]\ntolerance = 1e-12\n[[girder]]\nname = \"deck\"\n\
         length_m = 30.0\nwidth_m = 8.0\nthickness_m = 0.8\nmass_kg = 4e5\ndrop_m = 0.6\ninitial = {{ velocity_m_s = [0.5, 0.0, 0.0] }}\n\
         elastic = {{ young_modulus_pa = 3e10, poisson_ratio = 0.2, area_m2 = 5.0, damping_ratio = 0.02, modes = 6, \
         second_moment_vertical_m4 = 0.1, torsion_constant_m4 = 0.4 }}\nbearings = [{}]\n",
        bearings.join(", ")
    )));
    assert_eq!(Report::of(&history, &TableOptions::default()).lost_supports.len(), 1, "one is lost");
    for (t, place) in PLACES {
        let apart = history.motion(0, t).displacement - glam::DVec3::from_array(place);
        assert!(apart.length() < 1e-9, "{apart} m at {t} s");
    }
}
