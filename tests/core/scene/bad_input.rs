//! Every mistake in a scene file is answered with file, place, value and remedy, and never with a panic.

use girderbench::scene::{SceneError, format};

const GOOD: &str = r#"
format = 1
name = "two and a wall"
duration_s = 1.0

[[girder]]
name = "deck"
length_m = 30.0
width_m = 10.0
thickness_m = 1.5
skew_deg = 60.0
mass_kg = 6e5
bearings = { frequency_hz = 0.8, damping_ratio = 0.1, at_m = [[12, 4], [-12, -4]] }

[[girder]]
name = "approach"
length_m = 20.0
width_m = 10.0
thickness_m = 1.5
skew_deg = 60.0
mass_kg = 4e5
position_m = [-25.1, 0.0, 0.0]

[[abutment]]
name = "wall"
faces = "deck"
end = "+x"
gap_m = 0.05

[contact]
mu_static = 0.3

[motion]
kind = "sine"
amplitude_g = 0.4
frequency_hz = 0.8
"#;

/// Complaints about a text, every one about the file by its name.
fn complaints(text: &str) -> Vec<SceneError> {
    let errors = format::read(text, "bad.toml").expect_err("this scene is wrong").0;
    for error in &errors {
        assert_eq!(error.file, "bad.toml", "the file is named");
        assert!(error.to_string().starts_with("bad.toml: "), "the file comes first: {error}");
    }
    errors
}

/// One change to the good scene must give exactly one complaint: place, value, words of the remedy.
fn assert_complaint(from: &str, to: &str, place: &str, value: &str, remedy: &str) {
    assert!(GOOD.contains(from), "the good scene has `{from}`");
    let errors = complaints(&GOOD.replacen(from, to, 1));
    assert_eq!(errors.len(), 1, "one mistake `{to}`, one complaint: {errors:#?}");
    let error = &errors[0];
    assert_eq!(error.place.to_string(), place, "where: {error}");
    assert!(error.value.to_string().contains(value), "the value `{value}`: {error}");
    assert!(error.remedy.to_string().contains(remedy), "a remedy with `{remedy}`: {error}");
    for part in [&error.place, &error.value, &error.remedy].map(ToString::to_string) {
        assert!(error.to_string().contains(part.as_str()), "said in the message: {error}");
    }
}

#[test]
fn the_scene_that_the_mistakes_are_made_in_is_good() {
    let scene = format::read(GOOD, "good.toml").unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!((scene.girders.len(), scene.abutments.len()), (2, 1), "all of it");
}

#[test]
fn an_unknown_key_is_answered_with_the_nearest_and_all_known_ones() {
    let deck = |key: &str| format!("girder.deck.{key}");
    assert_complaint("mass_kg = 6e5", "mass_kg = 6e5\nmas_kg = 1", &deck("mas_kg"), "1", "did you mean `mass_kg`?");
    assert_complaint("mass_kg = 6e5", "mass_kg = 6e5\nfoo = 1", &deck("foo"), "1", "keys known here: name, length_m");
    assert_complaint(
        "amplitude_g = 0.4",
        "amplitud_g = 0.4",
        "motion.amplitud_g",
        "0.4",
        "did you mean `amplitude_g`?",
    );
    assert_complaint("frequency_hz = 0.8, d", "freq_hz = 0.8, d", &deck("bearings.freq_hz"), "0.8", "frequency_hz");
    assert_complaint("[contact]", "[contakt]", "contakt", "mu_static = 0.3", "did you mean `contact`?");
    assert_complaint("mu_static", "mu_stat", "contact.mu_stat", "0.3", "mu_static");
    assert_complaint("gap_m", "gap_mm", "abutment.wall.gap_mm", "0.05", "did you mean `gap_m`?");
}

#[test]
fn a_missing_key_is_named() {
    assert_complaint("mass_kg = 6e5\n", "", "girder.deck.mass_kg", "nothing", "add `mass_kg = …`");
    assert_complaint("duration_s = 1.0\n", "", "duration_s", "nothing", "add `duration_s = …`");
    assert_complaint("kind = \"sine\"\n", "", "motion.kind", "nothing", "add `kind = …`");
    assert_complaint("frequency_hz = 0.8\n", "", "motion.frequency_hz", "nothing", "add `frequency_hz = …`");
    assert_complaint(", damping_ratio = 0.1", "", "girder.deck.bearings.damping_ratio", "nothing", "must be given");
    assert_complaint("amplitude_g = 0.4\n", "", "motion.amplitude_g", "nothing", "amplitude_m_s2");
    assert_complaint("gap_m = 0.05\n", "", "abutment.wall.gap_m", "nothing", "polygon_m");
    assert_complaint(", at_m = [[12, 4], [-12, -4]]", "", "girder.deck.bearings.at_m", "nothing", "at_skewed_m");
}

#[test]
fn a_wrong_type_is_answered_with_the_right_one() {
    let bearings = "girder.deck.bearings";
    assert_complaint("mass_kg = 6e5", "mass_kg = \"heavy\"", "girder.deck.mass_kg", "\"heavy\"", "expected a number");
    assert_complaint("name = \"deck\"", "name = 5", "girder[0].name", "5", "expected a string");
    assert_complaint(
        "position_m = [-25.1, 0.0, 0.0]",
        "position_m = [-25.1]",
        "girder.approach.position_m",
        "[-25.1]",
        "3 values",
    );
    assert_complaint("0.0, 0.0]", "0.0, 0.0, 7.5]", "girder.approach.position_m", "7.5", "3 values");
    assert_complaint("-25.1, 0.0", "-25.1, \"0\"", "girder.approach.position_m[1]", "\"0\"", "expected a number");
    let numbers = "a number, or a list of two numbers";
    assert_complaint(
        "frequency_hz = 0.8,",
        "frequency_hz = \"a\",",
        &format!("{bearings}.frequency_hz"),
        "\"a\"",
        numbers,
    );
    assert_complaint(
        "frequency_hz = 0.8,",
        "frequency_hz = [1, 2, 3],",
        &format!("{bearings}.frequency_hz"),
        "3",
        numbers,
    );
    assert_complaint("[[12, 4]", "[[12, true]", &format!("{bearings}.at_m[0][1]"), "true", "expected a number");
    assert_complaint("kind = \"sine\"", "kind = \"sinus\"", "motion.kind", "\"sinus\"", "did you mean `sine`?");
    assert_complaint(
        "kind = \"sine\"",
        "kind = 3",
        "motion.kind",
        "3",
        "\"none\", \"sine\", \"record\", \"synthetic\", \"sweep\"",
    );
    assert_complaint(
        "mu_static = 0.3",
        "mu_static = 0.3\nlaw = \"papr\"",
        "contact.law",
        "\"papr\"",
        "did you mean `paper`?",
    );
    assert_complaint("end = \"+x\"", "end = \"x\"", "abutment.wall.end", "\"x\"", "\"+x\", \"-x\"");
    assert_complaint("[contact]\nmu_static = 0.3", "[[contact]]", "contact", "[", "a table of keys");
    assert_complaint("[motion]", "[view]\ncamera = 1979-05-27\n[motion]", "view.camera", "1979-05-27", "\"iso\"");
    assert_complaint(
        "duration_s = 1.0",
        "duration_s = 1.0\nkind = \"flat\"",
        "kind",
        "\"flat\"",
        "\"planar\", \"spatial\"",
    );
}

#[test]
fn a_single_bearing_is_read_with_the_same_care() {
    let from = "{ frequency_hz = 0.8, damping_ratio = 0.1, at_m = [[12, 4], [-12, -4]] }";
    let one = |inner: &str| format!("[{{ {inner} }}]");
    let place = |key: &str| format!("girder.deck.bearings[0].{key}");
    let (at, k, c) = ("at_m = [1, 2]", "stiffness_n_per_m = [1, 2]", "damping_n_s_per_m = [1, 2]");
    assert_complaint(from, &one(&format!("{at}, {k}")), &place("damping_n_s_per_m"), "nothing", "must be given");
    assert_complaint(from, &one(&format!("{at}, {k}, {c}, x = 1")), &place("x"), "1", "keys known here: at_m");
    assert_complaint(
        from,
        &one(&format!("{at}, {c}, stiffness_n_per_m = [1]")),
        &place("stiffness_n_per_m"),
        "[1]",
        "two or three",
    );
    assert_complaint(
        from,
        &one(&format!("{at}, {c}, stiffness_n_per_m = 5")),
        &place("stiffness_n_per_m"),
        "5",
        "two or three",
    );
    assert_complaint(
        from,
        &one(&format!("{at}, {k}, damping_n_s_per_m = [1, -2]")),
        &place("damping_n_s_per_m[1]"),
        "-2.0",
        "0 or",
    );
    assert_complaint(from, "5", "girder.deck.bearings", "5", "a table { frequency_hz");
    assert_complaint(from, "[]", "girder.deck.bearings", "[]", "at least one");
}

#[test]
fn a_still_ground_has_no_other_keys() {
    assert_complaint(
        "\"sine\"\namplitude_g = 0.4\n",
        "\"none\"\n",
        "motion.frequency_hz",
        "0.8",
        "keys known here: kind",
    );
}

#[test]
fn nan_and_infinity_are_refused_wherever_a_number_stands() {
    let finite = "finite number";
    assert_complaint("mass_kg = 6e5", "mass_kg = nan", "girder.deck.mass_kg", "nan", finite);
    assert_complaint("mass_kg = 6e5", "mass_kg = inf", "girder.deck.mass_kg", "inf", finite);
    assert_complaint("-25.1, 0.0", "-25.1, -inf", "girder.approach.position_m[1]", "-inf", finite);
    assert_complaint("duration_s = 1.0", "duration_s = nan", "duration_s", "nan", finite);
    assert_complaint("skew_deg = 60.0", "skew_deg = nan", "girder.deck.skew_deg", "nan", finite);
    assert_complaint("mass_kg = 6e5", "mass_kg = 6e5\nheading_deg = nan", "girder.deck.heading_deg", "nan", finite);
    assert_complaint("mu_static = 0.3", "mu_static = inf", "contact.mu_static", "inf", finite);
    assert_complaint("mu_static", "mu_kinetic = nan\nmu_static", "contact.mu_kinetic", "nan", finite);
    assert_complaint("mu_static", "restitution_normal = nan\nmu_static", "contact.restitution_normal", "nan", finite);
    assert_complaint("amplitude_g = 0.4", "amplitude_g = nan", "motion.amplitude_g", "nan", finite);
    assert_complaint("amplitude_g = 0.4", "amplitude_g = 1\nphase_deg = inf", "motion.phase_deg", "inf", finite);
    assert_complaint("gap_m = 0.05", "gap_m = inf", "abutment.wall.gap_m", "inf", finite);
    assert_complaint("gap_m = 0.05", "gap_m = 0.05\noffset_m = nan", "abutment.wall.offset_m", "nan", finite);
    assert_complaint(
        "damping_ratio = 0.1",
        "damping_ratio = [0.1, nan]",
        "girder.deck.bearings.damping_ratio[1]",
        "nan",
        finite,
    );
    assert_complaint("[motion]", "[solver]\ntolerance = nan\n[motion]", "solver.tolerance", "nan", finite);
    let initial = "mass_kg = 6e5\ninitial = { velocity_m_s = [0, nan] }";
    assert_complaint("mass_kg = 6e5", initial, "girder.deck.initial.velocity_m_s[1]", "nan", finite);
    assert_complaint(
        "mass_kg = 6e5",
        "mass_kg = 6e5\npush = { moment_n_m = nan }",
        "girder.deck.push.moment_n_m",
        "nan",
        finite,
    );
}

#[test]
fn what_must_be_positive_is_refused_at_zero_and_below() {
    let positive = "greater than 0";
    for value in ["0", "-2"] {
        let found = &format!("{value}.0");
        let with = |key: &str| format!("{key} = {value}");
        assert_complaint("mass_kg = 6e5", &with("mass_kg"), "girder.deck.mass_kg", found, positive);
        assert_complaint("length_m = 30.0", &with("length_m"), "girder.deck.length_m", found, positive);
        assert_complaint("width_m = 10.0", &with("width_m"), "girder.deck.width_m", found, positive);
        assert_complaint("thickness_m = 1.5", &with("thickness_m"), "girder.deck.thickness_m", found, positive);
        assert_complaint("duration_s = 1.0", &with("duration_s"), "duration_s", found, positive);
        assert_complaint("mu_static = 0.3", &with("stiffness_n_per_m"), "contact.stiffness_n_per_m", found, positive);
        assert_complaint("mu_static = 0.3", &with("young_modulus_pa"), "contact.young_modulus_pa", found, positive);
        assert_complaint("mu_static = 0.3", &with("area_m2"), "contact.area_m2", found, positive);
        assert_complaint(
            "[motion]",
            &format!("[view]\n{}\n[motion]", with("force_scale_n_per_m")),
            "view.force_scale_n_per_m",
            found,
            positive,
        );
        let wall = |key: &str| format!("gap_m = 0.05\n{}", with(key));
        for key in ["width_m", "height_m", "depth_m"] {
            assert_complaint("gap_m = 0.05", &wall(key), &format!("abutment.wall.{key}"), found, positive);
        }
        let seat = format!("mass_kg = 6e5\nseat_m = {{ \"-x\" = {value} }}");
        assert_complaint("mass_kg = 6e5", &seat, "girder.deck.seat_m.-x", found, positive);
    }
}

#[test]
fn what_may_be_zero_is_refused_below_only() {
    let rule = "0 or a number greater than 0";
    let bearings = "girder.deck.bearings";
    assert_complaint(
        "frequency_hz = 0.8,",
        "frequency_hz = [0.8, -1],",
        &format!("{bearings}.frequency_hz[1]"),
        "-1.0",
        rule,
    );
    assert_complaint("damping_ratio = 0.1", "damping_ratio = -0.1", &format!("{bearings}.damping_ratio"), "-0.1", rule);
    assert_complaint("frequency_hz = 0.8\n", "frequency_hz = -0.8\n", "motion.frequency_hz", "-0.8", rule);
    assert_complaint("gap_m = 0.05", "gap_m = -0.05", "abutment.wall.gap_m", "-0.05", rule);
    assert_complaint("mu_static", "mu_kinetic = -0.1\nmu_static", "contact.mu_kinetic", "-0.1", rule);
    for (from, to) in [
        ("frequency_hz = 0.8,", "frequency_hz = 0,"),
        ("damping_ratio = 0.1", "damping_ratio = 0"),
        ("gap_m = 0.05", "gap_m = 0"),
    ] {
        let read = format::read(&GOOD.replacen(from, to, 1), "good.toml");
        assert!(read.is_ok(), "{to} is allowed: {read:?}");
    }
}

#[test]
fn skew_restitution_friction_and_tolerance_stay_in_their_ranges() {
    for value in ["0.0", "180.0", "-30.0", "270.0"] {
        assert_complaint(
            "skew_deg = 60.0",
            &format!("skew_deg = {value}"),
            "girder.deck.skew_deg",
            value,
            "between 0.0 and 180.0",
        );
    }
    for value in ["0.0", "0.009", "1.01", "-0.4"] {
        for key in ["restitution_normal", "restitution_tangential"] {
            let to = format!("{key} = {value}\nmu_static");
            assert_complaint("mu_static", &to, &format!("contact.{key}"), value, "from 0.01 to 1.0");
        }
    }
    assert_complaint(
        "mu_static",
        "mu_kinetic = 0.4\nmu_static",
        "contact.mu_kinetic",
        "0.4",
        "must not exceed mu_static = 0.3",
    );
    for value in ["1e-14", "0.1"] {
        let to = format!("[solver]\ntolerance = {value}\n[motion]");
        assert_complaint("[motion]", &to, "solver.tolerance", value, "from 1e-13 to 0.01");
    }
}

#[test]
fn a_pair_must_name_two_bodies_that_can_touch() {
    let pair = |rest: &str| format!("[[contact.pair]]\n{rest}\n\n[motion]");
    let check = |rest: &str, place: &str, value: &str, remedy: &str| {
        assert_complaint("[motion]", &pair(rest), &format!("contact.pair[0].{place}"), value, remedy);
    };
    check("between = [\"deck\", \"wal\"]", "between", "\"wal\"", "girders: deck, approach; abutments: wall");
    check("between = [\"deck\", \"deck\"]", "between", "\"deck\"", "does not touch itself");
    check("between = [\"approach\", \"wall\"]", "between", "\"approach\"", "add `ends");
    let away = "between = [\"approach\", \"deck\"]\nends = [\"-x\", \"-x\"]";
    check(away, "ends", "[\"-x\", \"-x\"]", "look away from each other");
    check("between = [\"wall\"]", "between", "[\"wall\"]", "2 values");
    check("between = [\"deck\", \"wall\"]\nends = [\"+x\", \"up\"]", "ends[1]", "\"up\"", "\"+x\", \"-x\"");
    check("between = [\"deck\", \"wall\"]\nmu_kinetic = 0.5", "mu_kinetic", "0.5", "must not exceed mu_static = 0.3");
    check("between = [\"deck\", \"wall\"]\nrestitution_normal = 2", "restitution_normal", "2.0", "0.01");
    check("between = [\"deck\", \"wall\"]\nstiffness_n_per_m = 0", "stiffness_n_per_m", "0.0", "greater than 0");
    let both = "stiffness_n_per_m = 1e9\nyoung_modulus_pa = 3e10\nmu_static";
    assert_complaint("mu_static", both, "contact.stiffness_n_per_m", "1000000000.0", "K = E A / L");
}

#[test]
fn an_abutment_must_face_somebody() {
    assert_complaint(
        "faces = \"deck\"",
        "faces = \"dek\"",
        "abutment.wall.faces",
        "\"dek\"",
        "girders: deck, approach",
    );
    assert_complaint("faces = \"deck\"\n", "", "abutment.wall.faces", "nothing", "must be given");
}

#[test]
fn a_support_names_a_ground_that_there_is() {
    let place = "abutment.wall.ground";
    assert_complaint("gap_m = 0.05", "gap_m = 0.05\nground = \"bank\"", place, "\"bank\"", "add a [[ground]]");
    let ground = |keys: &str| format!("[[ground]]\nname = \"bank\"\n{keys}\n[contact]");
    let complains = |keys: &str, place: &str, value: &str, remedy: &str| {
        assert_complaint("[contact]", &ground(keys), place, value, remedy);
    };
    complains("kind = \"sine\"\namplitude_g = 0.1", "ground.bank.frequency_hz", "nothing", "must be given");
    complains(
        "kind = \"sine\"\namplitude_g = 0.1\nfrequency_hz = -1",
        "ground.bank.frequency_hz",
        "-1.0",
        "greater than 0",
    );
    complains("kind = \"record\"\nsamples_m_s2 = [0, 1]", "ground.bank.dt_s", "nothing", "interval");
    complains("kind = \"none\"\nfrequency_hz = 1", "ground.bank.frequency_hz", "1", "known");
    complains("", "ground.bank.kind", "nothing", "must be given");
    complains("", "ground.bank.kind", "nothing", "one of \"none\", \"sine\", \"record\"");
    let nameless = "[[ground]]\nkind = \"none\"\n[contact]";
    assert_complaint("[contact]", nameless, "ground[0].name", "nothing", "must be given");
    let twice = "[[ground]]\nname = \"a\"\nkind = \"none\"\n[[ground]]\nname = \"a\"\nkind = \"none\"\n[contact]";
    assert_complaint("[contact]", twice, "ground[1].name", "\"a\"", "");
}

#[test]
fn names_are_given_once_and_fit_into_tables() {
    assert_complaint(
        "name = \"approach\"",
        "name = \"deck\"",
        "girder[1].name",
        "\"deck\"",
        "another body has this name",
    );
    assert_complaint(
        "name = \"wall\"",
        "name = \"approach\"",
        "abutment[0].name",
        "\"approach\"",
        "another body has this name",
    );
    for bad in ["a.b", "a,b", "it's", "a=b", "a|b", " a", "a\\tb"] {
        let to = format!("name = \"{bad}\"");
        assert_complaint("name = \"approach\"", &to, "girder[1].name", bad, "use letters, digits");
    }
    for taken in ["ground", "energy", "table"] {
        let to = format!("name = \"{taken}\"");
        assert_complaint("name = \"approach\"", &to, "girder[1].name", taken, "give another name");
    }
    for empty in ["", "  "] {
        let to = format!("name = \"{empty}\"");
        assert_complaint("name = \"approach\"", &to, "girder[1].name", empty, "give it a name");
    }
}

#[test]
fn a_scene_needs_a_girder_and_this_format() {
    let errors = complaints("name = \"empty\"\nduration_s = 1\n");
    assert_eq!((errors[0].place.plain(), errors.len()), ("girder", 1), "{errors:?}");
    assert!(errors[0].remedy.to_string().contains("[[girder]]"), "{}", errors[0]);
    assert_complaint("format = 1", "format = 2", "format", "2", "reads format 1");
    assert_complaint("format = 1", "format = \"one\"", "format", "\"one\"", "reads format 1");
}

#[test]
fn a_face_must_be_flat_convex_a_trapezium_and_look_at_its_girder() {
    let wall = |corners: &str| format!("polygon_m = [{corners}]");
    let check = |corners: &str, value: &str, remedy: &str| {
        assert_complaint("gap_m = 0.05", &wall(corners), "abutment.wall.polygon_m", value, remedy);
    };
    let good = wall("[16, 9, -2], [16, -9, -2], [16, -9, 2], [16, 9, 2]");
    let read = format::read(&GOOD.replacen("gap_m = 0.05", &good, 1).replace("60.0", "90.0"), "good.toml");
    assert!(read.is_ok(), "a wall by its corners: {read:?}");
    check("[16, 9, -2], [16, -9, -2], [17, -9, 2], [16, 9, 2]", "17.0", "not in one plane");
    check("[16, 9, -2], [16, -9, -2], [16, 8, -1], [16, 9, 2]", "8.0", "not convex");
    check("[16, 9, -2], [16, 9, -2], [16, -9, 2], [16, 9, 2]", "16.0", "not convex");
    check("[16, 9, -2], [16, -9, -3], [16, -9, 2], [16, 8, 3]", "-3.0", "trapezium");
    check("[16, 9, 2], [16, -9, 2], [16, -9, -2], [16, 9, -2]", "16.0", "faces away from deck");
    check("[16, 9, -2], [16, -9, -2], [16, -9, 2]", "3 corners", "four corners");
    let short = wall("[16, 9, -2], [16, -9], [16, -9, 2], [16, 9, 2]");
    assert_complaint("gap_m = 0.05", &short, "abutment.wall.polygon_m[1]", "[16, -9]", "3 values");
}

#[test]
fn an_abutment_is_placed_one_way() {
    let both = "gap_m = 0.05\npolygon_m = [[16, 9, -2], [16, -9, -2], [16, -9, 2], [16, 9, 2]]";
    assert_complaint("gap_m = 0.05", both, "abutment.wall.gap_m", "gap_m and polygon_m", "one of the two");
    let twice = "polygon_m = [[16, 9, -2], [16, -9, -2], [16, -9, 2], [16, 9, 2]]\nwidth_m = 3";
    assert_complaint("gap_m = 0.05", twice, "abutment.wall.width_m", "3", "leave this out");
}

#[test]
fn bodies_placed_overlapping_are_refused_and_touching_ones_are_not() {
    let approach = |x: &str| format!("position_m = [{x}, 0.0, 0.0]");
    let from = "position_m = [-25.1, 0.0, 0.0]";
    assert_complaint(from, &approach("-24.9"), "girder.approach.position_m", "[-24.9, 0.0, 0.0]", "into girder deck");
    assert_complaint(from, &approach("0.0"), "girder.approach.position_m", "[0.0, 0.0, 0.0]", "into girder deck");
    let touching = format::read(&GOOD.replacen(from, &approach("-25.0"), 1), "good.toml");
    assert!(touching.is_ok(), "ends that touch: {touching:?}");
    let errors = complaints(&GOOD.replacen(from, &approach("30.0"), 1));
    let wall = errors.iter().find(|error| error.place.plain() == "abutment.wall.gap_m");
    assert!(wall.is_some_and(|error| error.remedy.to_string().contains("abutment wall reaches")), "{errors:?}");
}

#[test]
fn a_planar_scene_is_one_cut() {
    let from = "position_m = [-25.1, 0.0, 0.0]";
    let above = "position_m = [-25.1, 0.0, 100.0]";
    assert_complaint(from, above, "girder.approach.position_m", "[-25.1, 0.0, 100.0]", "every body has");
    let level = format::read(&GOOD.replacen(from, "position_m = [-25.1, 0.0, 0.2]", 1), "good.toml");
    assert!(level.is_ok(), "cut where both are: {level:?}");
}

#[test]
fn an_overlap_that_comes_from_the_start_is_a_pressed_start() {
    let pressed = "mass_kg = 6e5\ninitial = { displacement_m = [0.06, 0.0] }";
    let read = format::read(&GOOD.replacen("mass_kg = 6e5", pressed, 1), "good.toml");
    assert!(read.is_ok(), "pressed 10 mm into the wall: {read:?}");
}

#[test]
fn a_spatial_girder_stands_on_vertical_springs() {
    let spatial = GOOD.replacen("format = 1", "format = 1\nkind = \"spatial\"", 1);
    let errors = complaints(&spatial);
    let place = "girder.deck.bearings.vertical_frequency_hz";
    assert_eq!((errors[0].place.plain(), errors.len()), (place, 1), "the approach has no bearings: {errors:?}");
    let held = spatial.replacen("mass_kg = 6e5", "mass_kg = 6e5\nheld = [\"z\", \"roll\"]", 1);
    assert!(format::read(&held, "good.toml").is_ok(), "held in z it needs none");
    let given = spatial.replacen("damping_ratio = 0.1", "damping_ratio = 0.1, vertical_frequency_hz = 8", 1);
    assert!(format::read(&given, "good.toml").is_ok(), "given");
}

#[test]
fn a_planar_scene_knows_no_vertical_push_or_start() {
    let push = "mass_kg = 6e5\npush = { force_n = [1, 2, 3] }";
    assert_complaint("mass_kg = 6e5", push, "girder.deck.push.force_n", "[1.0, 2.0, 3.0]", "give two numbers");
    let keys = [
        ("initial", "roll_deg"),
        ("initial", "pitch_deg"),
        ("initial", "roll_deg_s"),
        ("initial", "pitch_deg_s"),
        ("push", "moment_x_n_m"),
        ("push", "moment_y_n_m"),
    ];
    for (table, key) in keys {
        let with = |value: &str| format!("mass_kg = 6e5\n{table} = {{ {key} = {value} }}");
        let place = format!("girder.deck.{table}.{key}");
        assert_complaint("mass_kg = 6e5", &with("2.5"), &place, "2.5", "leave it out, or set kind = \"spatial\"");
        let none = GOOD.replacen("mass_kg = 6e5", &with("0.0"), 1);
        assert!(format::read(&none, "good.toml").is_ok(), "{key} of 0 says nothing");
    }
    let high = "damping_ratio = 0.1, height_m = -0.3";
    assert_complaint("damping_ratio = 0.1", high, "girder.deck.bearings.height_m", "-0.3", "leave it out");
    let held = GOOD.replacen("mass_kg = 6e5", "mass_kg = 6e5\nheld = [\"z\", \"roll\", \"pitch\"]", 1);
    assert!(format::read(&held, "good.toml").is_ok(), "holding what is held anyway is no mistake");
}

#[test]
fn a_record_has_samples_or_a_file() {
    let from = "kind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 0.8\n";
    let check = |rest: &str, place: &str, value: &str, remedy: &str| {
        assert_complaint(from, &format!("kind = \"record\"\n{rest}"), &format!("motion.{place}"), value, remedy);
    };
    check("", "samples_m_s2", "nothing", "or file");
    check("dt_s = 0.01\nsamples_m_s2 = [1.0]", "samples_m_s2", "1 samples", "at least 2");
    check("dt_s = 0\nsamples_m_s2 = [1, 2]", "dt_s", "0.0", "greater than 0");
    check("samples_m_s2 = [1, 2]", "dt_s", "nothing", "interval");
    check("dt_s = 0.01\nsamples_m_s2 = [1, nan]", "samples_m_s2[1]", "nan", "finite number");
    check("dt_s = 0.01\nsamples_m_s2 = [1, 2]\nscale = inf", "scale", "inf", "finite number");
    check("dt_s = 0.01\nsamples_m_s2 = [1, \"2\"]", "samples_m_s2[1]", "\"2\"", "a number");
    check("file = \"a.csv\"", "file", "\"a.csv\"", "has not been read");
    let silent = "dt_s = 0.01\nsamples_m_s2 = [0, 0, 0]\nprocessing = { peak_g = 0.4 }";
    check(silent, "processing.peak_g", "0.4", "nothing shakes");
    check("dt_s = 0.01\nsamples_m_s2 = [1, 2]\nchannel = 2", "channel", "samples_m_s2", "belongs to a file");
    check("file = \"a.dat\"\nunit = \"lb\"", "unit", "\"lb\"", "\"g\", \"gal\", \"m/s2\"");
    check("frequency_hz = 1", "frequency_hz", "1", "keys known here: samples_m_s2");
}

#[test]
fn both_amplitudes_are_one_too_many() {
    let both = "amplitude_g = 0.4\namplitude_m_s2 = 4";
    assert_complaint(
        "amplitude_g = 0.4",
        both,
        "motion.amplitude_g",
        "amplitude_g and amplitude_m_s2",
        "one of the two",
    );
}

#[test]
fn a_file_that_is_not_toml_is_answered_with_line_and_column() {
    assert_complaint("mass_kg = 6e5", "mass_kg = 6e5 kg", "line 12, column 11", "mass_kg = 6e5 kg", "not TOML");
    assert_complaint("mass_kg = 6e5", "mass_kg = 1\nmass_kg = 2", "line 13, column 1", "mass_kg = 2", "not TOML");
    assert_complaint("name = \"deck\"", "name = \"deck", "line 7, column 13", "name = \"deck", "not TOML");
    let errors = complaints("\u{0}\u{1}PNG");
    assert!(
        errors[0].place.to_string().starts_with("line 1, column")
            && errors[0].remedy.to_string().starts_with("not TOML"),
        "{}",
        errors[0]
    );
}

#[test]
fn absurd_but_finite_numbers_are_answered_and_never_panic() {
    for value in ["1e-320", "1e-300", "1e-12", "1e12", "1e300", "1.7976931348623157e308"] {
        for key in [
            "mass_kg = 6e5",
            "length_m = 30.0",
            "width_m = 10.0",
            "thickness_m = 1.5",
            "skew_deg = 60.0",
            "gap_m = 0.05",
        ] {
            let name = key.split(' ').next().unwrap_or_default();
            let _ = format::read(&GOOD.replacen(key, &format!("{name} = {value}"), 1), "absurd.toml");
        }
    }
}

#[test]
fn every_complaint_is_made_at_once() {
    let text = GOOD.replace("mass_kg = 6e5", "mass_kg = 0").replace("amplitude_g = 0.4", "amplitude_g = nan");
    let places: Vec<String> = complaints(&text).into_iter().map(|error| error.place.to_string()).collect();
    assert_eq!(places, ["girder.deck.mass_kg", "motion.amplitude_g"], "both");
}
