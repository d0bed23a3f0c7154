//! Scenes of every kind of contact, ground and bearing: they come to their end, their books balance, nothing overlaps uncarried.

use super::force_on_first;
use crate::support::{run, scene, within};
use girderbench::sim::History;

/// Two decks between two abutments, skewed, on bearings, by these words for contact and ground.
fn row(skew: f64, elastic: [&str; 2], rest: &str, duration: f64) -> girderbench::scene::Scene {
    let cot = 1.0 / f64::tan(skew.to_radians());
    let legs = [(13.0, 4.0), (13.0, -4.0), (-13.0, 4.0), (-13.0, -4.0)];
    let legs: Vec<String> = legs.iter().map(|(x, y)| format!("[{:?}, {y:?}]", x + y * cot)).collect();
    let deck = |name: &str, x: f64, frequency: f64, elastic: &str| {
        let elastic = if elastic.is_empty() { String::new() } else { format!("elastic = {{ {elastic} }}\n") };
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\nmass_kg = 6e5\nskew_deg = {skew:?}\n\
             position_m = [{x:?}, 0.0, 0.0]\nbearings = {{ frequency_hz = [{frequency:?}, {:?}], damping_ratio = 0.1, at_m = [{}] }}\n{elastic}",
            1.1 * frequency,
            legs.join(", ")
        )
    };
    let wall = |name: &str, faces: &str, end: &str| {
        format!("[[abutment]]\nname = \"{name}\"\nfaces = \"{faces}\"\nend = \"{end}\"\ngap_m = 0.04\n")
    };
    let girders = [deck("a", -15.02, 0.7, elastic[0]), deck("b", 15.02, 0.9, elastic[1])].concat();
    let walls = [wall("west", "a", "-x"), wall("east", "b", "+x")].concat();
    scene(&format!("name = \"row\"\nduration_s = {duration:?}\n{girders}{walls}{rest}[solver]\ntolerance = 1e-10\n"))
}

const SINE: &str = "[motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 0.8\nangle_deg = 25\n";
const QUAKE: &str = "[motion]\nkind = \"synthetic\"\npeak_g = 0.5\nlength_s = 6.0\nacross = 0.7\n";
const DAMPED: &str = "[contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 0.5\nrestitution_tangential = 0.8\n";
const SMOOTH: &str =
    "[contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 1.0\nmu_static = 0.0\nmu_kinetic = 0.0\n";
const RUBBING: &str = "[contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 0.7\nmu_static = 0.6\nmu_kinetic = 0.5\n\
                       law = \"return-mapping\"\n";
const HERTZ: &str = "[contact]\nstiffness_n_per_m = 2e9\nnormal_law = \"hertz-damp\"\nrestitution_normal = 0.6\n";

fn holds(name: &str, history: &History, allowed: f64) {
    let worst = (1..=20).map(|i| history.energy().ledger(history.end() * f64::from(i) / 20.0));
    let worst = worst.map(|books| (books.residual / books.scale).abs()).fold(0.0, f64::max);
    within(&format!("{name}: ledger"), worst, allowed);
    assert!(history.hits().count() > 0, "{name}: they meet");
    // Sides of girders that met beside each other move with G: what that leaves is said.
    let beside = !history.model().bodies_met().is_empty();
    assert!(beside || history.overlaps().is_empty(), "{name}: {:?}", history.overlaps());
}

#[test]
fn rows_of_decks_balance_under_every_law_and_ground() {
    let (soft, stiff) = ("area_m2 = 8.0", "area_m2 = 8.0, young_modulus_pa = 2e11, damping_ratio = 0.05");
    let cases = [
        ("straight, smooth", 90.0, [soft, soft], SMOOTH, SINE),
        ("60°, damped", 60.0, [soft, soft], DAMPED, SINE),
        ("115°, rubbing", 115.0, [soft, stiff], RUBBING, SINE),
        ("45°, beside a rigid deck", 45.0, [soft, ""], DAMPED, SINE),
        ("70°, quake", 70.0, [soft, soft], RUBBING, QUAKE),
        ("80°, Hertz", 80.0, [stiff, soft], HERTZ, QUAKE),
    ];
    for (name, skew, elastic, contact, ground) in cases {
        // The quake is slow to begin.
        let duration = if ground == QUAKE { 3.0 } else { 1.5 };
        let history = run(&row(skew, elastic, &[contact, ground].concat(), duration));
        holds(name, &history, 1e-8);
    }
}

#[test]
fn a_deck_that_is_pushed_against_a_wall_rests_with_the_force_of_the_push() {
    let mut scene = row(90.0, ["area_m2 = 8.0", "area_m2 = 8.0"], DAMPED, 30.0);
    scene.girders.truncate(1);
    scene.abutments.truncate(1);
    scene.girders[0].bearings = None;
    scene.girders[0].push.force = [-2e6, 0.0, 0.0];
    let history = run(&scene);
    within("force at rest", force_on_first(&history, history.end()).x / 2e6 - 1.0, 1e-6);
    // The push is at G: half of the deck is pressed, half is free.
    let end = history.end();
    let forces = |station: f64| history.sections().forces(0, station, end).axial / 2e6;
    within("N between push and wall", forces(-7.0) + 1.0, 1e-5);
    within("N beyond the push", forces(7.0), 1e-5);
}
