//! A weight that bearings in space do not carry as a bridge's do: `check` says so before, `run` after.

use crate::program::{Said, call};

/// A deck of 600 t in space, with these bearings, alike where they are in no list among the other keys.
fn deck(command: &str, bearings: &str, more: &str) -> Said {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("deck.toml");
    let text = format!(
        "name = \"deck\"\nkind = \"spatial\"\nduration_s = 0.6\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\n\
         thickness_m = 1.5\nmass_kg = 6e5\n{more}\n{}",
        if bearings.is_empty() { String::new() } else { format!("bearings = {{ {bearings} }}\n") }
    );
    std::fs::write(&path, text).expect("written");
    call(&[command, path.to_str().expect("UTF-8")])
}

const FOUR: &str = "at_m = [[14, 4], [14, -4], [-14, 4], [-14, -4]], vertical_frequency_hz = 8.0";
const LINEAR: &str = "frequency_hz = 1.0, damping_ratio = 0.05";

#[test]
fn check_says_what_does_not_stand() {
    let linear = |places: &str| format!("{LINEAR}, vertical_frequency_hz = 8.0, at_m = {places}");
    let pendulum = format!("kind = \"pendulum\", friction = 0.05, radius_m = 1.0, {FOUR}");
    let four = format!("{LINEAR}, {FOUR}");
    for (bearings, more, words) in [
        (linear("[[14, 0], [-14, 0]]"), "", Some("it tips over as soon as")),
        (linear("[[14, 4], [12, 4], [14, -4]]"), "", Some("it holds the girder down")),
        (pendulum.clone(), "initial = { displacement_m = [0.3, 0.0] }", Some("its dish rises by 0.0450 m")),
        (pendulum, "initial = { displacement_m = [0.3, 0.0, 0.045] }", None),
        (four.clone(), "", None),
    ] {
        let said = deck("check", &bearings, more);
        assert_eq!(said.status, Some(0), "{}", said.err);
        let warned = ["it tips over", "holds the girder down", "its dish rises"].map(|words| said.out.contains(words));
        match words {
            Some(words) => assert!(said.out.contains(words), "{bearings}: {}", said.out),
            None => assert_eq!(warned, [false; 3], "{bearings}: {}", said.out),
        }
    }
    // 600 t given as 600.
    let said = call(&["check", "deck-30m", "--set", "girder.deck.mass_kg=600"]);
    assert!(said.out.contains("is mass_kg in kg?"), "{}", said.out);
    assert!(!call(&["check", "deck-30m"]).out.contains("is mass_kg in kg?"), "as it is");
}

#[test]
fn run_says_which_bearing_holds_the_girder_down_and_how_far_it_tilts() {
    let up = deck("run", &format!("{LINEAR}, {FOUR}"), "initial = { velocity_m_s = [0, 0, 0.5] }");
    assert_eq!(up.status, Some(0), "{}", up.err);
    assert_eq!(up.out.matches("carries nothing at").count(), 4, "{}", up.out);
    assert!(up.out.contains("and then pulls, by up to") && up.out.contains("largest tilt"), "{}", up.out);
    // Its dashpot holds it down before it lifts off: what a slider has no law for is not said of it.
    let leg = |[x, y]: [f64; 2]| {
        format!(
            "{{ at_m = [{x}, {y}], stiffness_n_per_m = [0, 0, 3e8], damping_n_s_per_m = [0, 0, 1e6], friction = 0.05 }}"
        )
    };
    let legs = [[14.0, 4.0], [14.0, -4.0], [-14.0, 4.0], [-14.0, -4.0]].map(leg).join(", ");
    let fallen = deck("run", "", &format!("initial = {{ displacement_m = [0, 0, 0.1] }}\nbearings = [{legs}]"));
    assert_eq!(fallen.out.matches("and lifts; its vertical dashpot pulls by up to").count(), 4, "{}", fallen.out);
    assert!(!fallen.out.contains("no uplift is in its law"), "{}", fallen.out);
    let calm = deck("run", &format!("{LINEAR}, {FOUR}"), "");
    assert!(!calm.out.contains("carries nothing at"), "{}", calm.out);
}

#[test]
fn the_impact_model_is_refused_where_something_acts_that_it_does_not_know() {
    for command in ["check", "run"] {
        let said = call(&[command, "span-as-built", "--set", "model.kind=impact"]);
        assert_eq!((said.status, said.out.as_str()), (Some(2), ""), "{}", said.err);
        assert!(said.err.contains("model.kind") && said.err.contains("make it \"contact\""), "{}", said.err);
    }
}
