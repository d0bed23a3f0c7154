//! Beyond the domain: `check` and `run` warn, the run ends well, and the exit status is that of the run.

use crate::program::{Said, call};

/// A quantity just outside: what sets it on the preset, where the warning says that it lies.
const BEYOND: &[(&str, &[&str], &str)] = &[
    ("fine tolerance", &["solver.tolerance=9e-13"], "solver.tolerance"),
    ("coarse tolerance", &["solver.tolerance=1.1e-4"], "solver.tolerance"),
    ("light", &["girder.deck.mass_kg=0.9e-3", "contact.stiffness_n_per_m=155"], "girder.deck.mass_kg"),
    ("heavy", &["girder.deck.mass_kg=1.1e8", "contact.stiffness_n_per_m=1e13"], "girder.deck.mass_kg"),
    ("thin", &["girder.deck.thickness_m=0.9e-3"], "girder.deck.thickness_m"),
    ("wide", &["girder.deck.width_m=1.1e3"], "girder.deck.width_m"),
    ("sharp", &["girder.deck.skew_deg=4"], "girder.deck.skew_deg"),
    ("blunt", &["girder.deck.skew_deg=176"], "girder.deck.skew_deg"),
    ("soft", &["contact.stiffness_n_per_m=1.9"], "contact.stiffness_n_per_m"),
    ("stiff", &["contact.stiffness_n_per_m=2.1e9"], "contact.stiffness_n_per_m"),
    ("fast ground", &["motion.frequency_hz=4e4"], "motion.frequency_hz"),
    ("fast bearings", &["girder.deck.bearings.frequency_hz=4e4"], "girder.deck.bearings"),
    ("overdamped bearings", &["girder.deck.bearings.damping_ratio=1e4"], "girder.deck.bearings"),
    ("hard shaking", &["motion.amplitude_g=11"], "motion.amplitude_g"),
    ("hard push", &["girder.deck.push.force_n=[220, 0]"], "girder.deck.push.force_n"),
    ("hard turn", &["girder.deck.push.moment_n_m=20"], "girder.deck.push.moment_n_m"),
    ("fast start", &["girder.deck.initial.velocity_m_s=[110, 0]"], "girder.deck.initial.velocity_m_s"),
    ("spinning start", &["girder.deck.initial.spin_deg_s=7e4"], "girder.deck.initial.spin_deg_s"),
    ("far away", &["girder.deck.initial.displacement_m=[-10, 0]"], "girder.deck.initial.displacement_m"),
    ("pressed in", &["girder.deck.initial.displacement_m=[0.4, 0]"], "girder.deck.initial.displacement_m"),
    ("wound up", &["girder.deck.initial.rotation_deg=190"], "girder.deck.initial.rotation_deg"),
    ("much friction", &["contact.mu_static=2.1"], "contact.mu_static"),
];

/// Calls a command on the paper's girder before its wall, changed, for half a second.
fn on_preset(command: &[&str], sets: &[&str]) -> Said {
    let mut args = command.to_vec();
    args.extend(["skew45-abutment", "--until", "0.5"]);
    for set in sets {
        args.extend(["--set", set]);
    }
    call(&args)
}

#[test]
fn check_warns_of_every_quantity_beyond_the_domain_and_of_no_other() {
    let inside = on_preset(&["check"], &[]);
    assert_eq!((inside.status, inside.err.as_str()), (Some(0), ""), "nothing to warn of");
    let mut lacking = Vec::new();
    for (what, sets, place) in BEYOND {
        let said = on_preset(&["check"], sets);
        let warned = said.err.lines().all(|line| line.starts_with(&format!("warning: {place}")));
        let whole = said.err.contains("outside the domain: ") && said.err.contains("; ");
        if said.status != Some(0) || said.out.is_empty() || !warned || !whole {
            lacking.push(format!("{what}: status {:?}, said {}", said.status, said.err));
        }
    }
    assert!(lacking.is_empty(), "each is warned of:\n{}", lacking.join("\n"));
}

#[test]
fn runs_just_outside_end_with_an_answer_or_a_reason() {
    let mut lacking = Vec::new();
    for (what, sets, place) in BEYOND {
        let said = on_preset(&["run", "--digest"], sets);
        let word = match said.status {
            Some(0) => !said.err.contains("gave up"),
            Some(1) => said.err.contains("gave up at t = "),
            _ => false,
        };
        if !word || !said.err.contains(&format!("warning: {place}")) || said.out.trim().is_empty() {
            lacking.push(format!("{what}: status {:?}, said {}{}", said.status, said.out, said.err));
        }
    }
    assert!(lacking.is_empty(), "each ends well:\n{}", lacking.join("\n"));
}

#[test]
fn summaries_carry_what_lies_outside() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a UTF-8 path");
    let outside = |sets: &[&str]| -> (String, serde_json::Value) {
        let said = on_preset(&["run", "--out", out], sets);
        assert_eq!(said.status, Some(0), "a warning is no failure: {}", said.err);
        let text = std::fs::read_to_string(folder.path().join("summary.json")).expect("the summary");
        let summary: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        (said.out, summary["outside_domain"].clone())
    };
    let (said, listed) = outside(&[]);
    assert!(listed == serde_json::json!([]) && !said.contains("domain"), "inside: {listed}, {said}");
    let (said, listed) = outside(&["contact.stiffness_n_per_m=3e9"]);
    assert!(said.contains("outside the domain     contact.stiffness_n_per_m (deck+x|wall)\n"), "as a line: {said}");
    let one = &listed[0];
    assert_eq!(listed.as_array().map(Vec::len), Some(1), "{listed}");
    assert_eq!((one["place"].as_str(), one["pair"].as_str()), (Some("contact.stiffness_n_per_m"), Some("deck+x|wall")));
    assert_eq!((one["value"].as_f64(), one["bound"].as_f64()), (Some(1.5e9), Some(1e9)), "{one}");
    assert!(one["consequence"].as_str().is_some_and(|words| words.contains("in doubt")), "{one}");
}

#[test]
fn an_answer_that_does_not_balance_is_said_to() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a UTF-8 path");
    let summary = || {
        let bytes = std::fs::read(folder.path().join("summary.json")).expect("the summary");
        serde_json::from_slice::<serde_json::Value>(&bytes).expect("JSON")
    };
    let run = ["run", "skew45-abutment", "--until", "1", "--out", out];
    let said = call(&[&run[..], &["--set", "motion.frequency_hz=1e6"]].concat());
    assert_eq!(said.status, Some(0), "it runs: {}", said.err);
    assert!(said.err.contains("warning: skew45-abutment: the ledger's residual is"), "warns: {}", said.err);
    assert!(said.out.contains("beyond its bound"), "says so: {}", said.out);
    assert_eq!(summary()["balances"], false, "and writes so");
    let [residual, bound] =
        [&summary()["ledger"]["residual"], &summary()["residual_bound"]].map(serde_json::Value::as_f64);
    assert!(residual.expect("a number").abs() > bound.expect("a number"), "by these numbers");
    let said = call(&run);
    assert!(!said.err.contains("ledger") && summary()["balances"] == true, "a sound answer balances: {}", said.err);
}

#[cfg(feature = "render")]
#[test]
fn a_picture_of_an_answer_that_does_not_balance_comes_with_the_same_warning() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("one.png");
    let size = ["--size", "160x90", "--quality", "draft", "--threads", "2"];
    let picture = ["render", "skew45-abutment", "--until", "1", "--out", out.to_str().expect("a UTF-8 path")];
    let said = |set: &[&str]| call(&[&picture[..], &size, set].concat());
    let shaken = said(&["--set", "motion.frequency_hz=1e6"]);
    // Nothing draws here.
    if shaken.status == Some(3) {
        return;
    }
    assert_eq!(shaken.status, Some(0), "it is drawn: {}", shaken.err);
    assert!(shaken.err.contains("warning: skew45-abutment: the ledger's residual is"), "warns: {}", shaken.err);
    let sound = said(&[]);
    assert!(sound.status == Some(0) && !sound.err.contains("ledger"), "a sound answer balances: {}", sound.err);
    let none = call(&[&picture[..], &["--threads", "0"]].concat());
    assert!(none.status == Some(2) && none.err.contains("--threads"), "refused as by run: {}", none.err);
}

#[test]
fn check_says_which_restitution_a_normal_law_returns() {
    let line = |sets: &[&str]| {
        let said = on_preset(&["check"], sets);
        assert_eq!(said.status, Some(0), "{}", said.err);
        said.out.lines().find(|line| line.contains("normal law")).map(str::to_owned)
    };
    assert_eq!(line(&[]), None, "(65) returns e_n");
    // Closed forms: docs/physics.md, "Restitution of the other laws".
    let published =
        ["contact.normal_law=hertz-damp", "contact.calibration=published", "contact.restitution_normal=0.4"];
    assert!(
        line(&published).is_some_and(|line| line.ends_with("returns e = 0.701635")),
        "as printed: {:?}",
        line(&published)
    );
    let clamped = ["contact.tension=clamp", "contact.restitution_normal=0.4"];
    assert!(
        line(&clamped).is_some_and(|line| line.ends_with("returns e = 0.472014")),
        "(65), clamped: {:?}",
        line(&clamped)
    );
    let stiff = on_preset(&["check"], &["contact.normal_law=hertz", "contact.hertz_stiffness_n_per_m1_5=1e15"]);
    assert!(stiff.err.contains("contact.hertz_stiffness_n_per_m1_5"), "beyond the domain: {}", stiff.err);
    let soft = on_preset(&["check"], &["contact.normal_law=bilinear", "contact.restitution_normal=0.2"]);
    assert!(soft.status == Some(2) && soft.err.contains("0.2294"), "no stiffness after yield: {}", soft.err);
    let glued = on_preset(&["check"], &["contact.law_parameter=1"]);
    assert!(glued.status == Some(2) && glued.err.contains("contact.law_parameter"), "critical: {}", glued.err);
}
