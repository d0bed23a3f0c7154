//! `--set path=value` reaches every value of a scene, and complains like a file.

use girderbench::motion::format::{Channel, Record};
use girderbench::scene::{
    Bearings, FrictionLaw, Motion, PerDirection, Scene, SceneError, overrides, presets, validate,
};

fn preset(name: &str) -> Scene {
    presets::load(name).unwrap_or_else(|errors| panic!("{errors}"))
}

fn set(scene: &Scene, settings: &[&str]) -> Scene {
    overrides::apply_all(scene, settings).unwrap_or_else(|errors| panic!("{errors}"))
}

fn complaint(scene: &Scene, setting: &str) -> SceneError {
    let errors = overrides::apply(scene, setting).expect_err("it cannot be set").0;
    assert_eq!(errors.len(), 1, "one mistake, one complaint: {errors:?}");
    assert_eq!(errors[0].place.plain(), format!("--set {setting}"), "the setting is the place");
    errors[0].clone()
}

#[test]
fn values_are_reached_by_key_and_name() {
    let scene = set(
        &preset("skew45-abutment"),
        &[
            "motion.angle_deg=45",
            "girder.deck.skew_deg=60",
            "abutment.wall.gap_m = 0.002",
            "contact.mu_static=0.3",
            "girder.deck.bearings.frequency_hz=3",
            "solver.tolerance=1e-8",
            "view.overlays.grid=false",
            "duration_s=2",
        ],
    );
    assert_eq!(scene.motion.angle_deg(), 45.0, "motion");
    assert_eq!(scene.girders[0].skew_deg, 60.0, "girder by name");
    assert_eq!(scene.abutments[0].gap, Some(0.002), "abutment by name");
    assert_eq!(scene.contact.mu_static, 0.3, "contact");
    let Some(Bearings::Shared(bearings)) = &scene.girders[0].bearings else { panic!("shared bearings") };
    assert_eq!(bearings.frequency_hz, PerDirection::Both(3.0), "a table in a list");
    assert_eq!((scene.solver.tolerance, scene.view.overlays.grid, scene.duration), (1e-8, false, 2.0), "settings");
}

#[test]
fn what_is_not_set_stays_to_the_last_bit() {
    for preset in presets::all() {
        let before = self::preset(preset.name);
        let mut after = set(&before, &["duration_s=1.5"]);
        after.duration = before.duration;
        assert_eq!(after, before, "{}", preset.name);
    }
}

#[test]
fn lists_are_reached_by_number_and_whole() {
    let settings = ["girder.2.mass_kg=5e5", "girder.g1.position_m=[-61, 0.5, 0]", "girder.g2.position_m.1=0.25"];
    let scene = set(&preset("row-of-5"), &settings);
    assert_eq!(scene.girders[2].mass, 5e5, "a body by its number");
    assert_eq!(scene.girders[0].position, [-61.0, 0.5, 0.0], "a list as a whole");
    assert_eq!(scene.girders[1].position[1], 0.25, "one number of a list");
}

#[test]
fn optional_keys_and_tables_are_made() {
    let scene = preset("flush-free-hit");
    let after = set(
        &scene,
        &[
            "girder.deck.push.force_n=[1, 2]",
            "girder.deck.seat_m.+x=0.1",
            "girder.deck.held=[\"yaw\"]",
            "abutment.wall.offset_m=0.01",
            "contact.pair=[{ between = [\"deck\", \"wall\"], mu_static = 0.5 }]",
            "contact.pair.0.mu_kinetic=0.4",
        ],
    );
    assert_eq!(after.girders[0].push.force, [1.0, 2.0, 0.0], "a new table");
    assert_eq!(after.girders[0].seat.plus, Some(0.1), "a key with a sign");
    assert_eq!(after.girders[0].held.len(), 1, "a new list");
    assert_eq!(after.abutments[0].offset, Some(0.01), "a new key");
    assert_eq!(after.contact.pairs[0].mu_kinetic, Some(0.4), "a pair by its number");
}

#[test]
fn words_need_no_quotes() {
    let scene =
        set(&preset("skew45-abutment"), &["contact.law=return-mapping", "abutment.wall.end=-x", "name=what if"]);
    assert_eq!(scene.contact.law, FrictionLaw::ReturnMapping, "a word");
    assert_eq!(scene.abutments[0].end.label(), "-x", "not even with a sign");
    assert_eq!(scene.name, "what if", "or two words");
}

#[test]
fn a_key_that_says_the_same_in_another_way_is_replaced() {
    let scene = preset("skew45-abutment");
    let Motion::Sine(sine) = set(&scene, &["motion.amplitude_m_s2=3"]).motion else { panic!("a sine") };
    assert_eq!((sine.amplitude_g, sine.amplitude), (None, Some(3.0)), "g gives way to m/s²");
    let contact = set(&scene, &["contact.young_modulus_pa=3e10", "contact.area_m2=0.001"]).contact;
    assert_eq!(
        (contact.stiffness, contact.young_modulus, contact.area),
        (None, Some(3e10), Some(0.001)),
        "K to E A / L"
    );
    let back = set(&scene, &["contact.young_modulus_pa=3e10", "contact.stiffness_n_per_m=2e5"]).contact;
    assert_eq!((back.stiffness, back.young_modulus), (Some(2e5), None), "and back");
    let wall = &set(&scene, &["abutment.wall.polygon_m=[[1,1,-1],[1,-1,-1],[1,-1,1],[1,1,1]]"]).abutments[0];
    assert_eq!((wall.gap, wall.width, wall.height, wall.polygon.is_some()), (None, None, None, true), "gap to corners");
    let elastic = |keys: &[&str]| set(&preset("deck-30m-elastic"), keys).girders[0].elastic.expect("it bends");
    let by_mass = elastic(&["girder.deck.elastic.damping_ratio=0.03", "girder.deck.elastic.rayleigh.mass=1"]);
    assert_eq!((by_mass.damping_ratio, by_mass.rayleigh.is_some()), (None, true), "a table made on the way");
    let piers = set(&preset("viaduct-5"), &["pier.p1.stiffness_n_per_m=1e8", "pier.p1.young_modulus_pa=2e10"]);
    let said = validate::validate(&piers).expect_err("E of no column").to_string();
    assert!(said.contains("young_modulus_pa") && !said.contains("found nothing"), "{said}");
    let scene = set(&scene, &["girder.deck.bearings.at_m=[[0.07, 0.025], [-0.07, 0.0]]"]);
    let Some(Bearings::Shared(bearings)) = &scene.girders[0].bearings else { panic!("shared bearings") };
    assert!(bearings.at_skewed.is_none() && bearings.at.is_some(), "skewed places to true ones");
}

#[test]
fn another_kind_of_motion_keeps_its_direction_only() {
    let scene =
        set(&preset("straight-straight"), &["motion.kind=record", "motion.samples_m_s2=[0, 1]", "motion.dt_s=0.01"]);
    let Motion::Record(record) = &scene.motion else { panic!("a record") };
    assert_eq!((record.angle_deg, record.samples.as_deref()), (22.5, Some(&[0.0, 1.0][..])), "the angle stays");
    let file = set(&scene, &["motion.file=el-centro.csv"]);
    let Motion::Record(record) = &file.motion else { panic!("a record") };
    assert_eq!(
        (record.samples.is_none(), record.dt, record.file.as_deref()),
        (true, None, Some("el-centro.csv")),
        "a file"
    );
    assert_eq!(set(&file, &["motion.kind=none"]).motion, Motion::None, "nothing stays");
}

#[test]
fn a_record_that_was_read_stays_read() {
    let mut scene = set(&preset("straight-abutment"), &["motion.kind=record", "motion.file=a.csv"]);
    let channels = vec![Channel::plain(0.01, vec![0.0, 1.0])];
    let read = Some(std::sync::Arc::new(Record { format: "CSV", channels }));
    if let Motion::Record(record) = &mut scene.motion {
        record.loaded.clone_from(&read);
    }
    let loaded = |scene: &Scene| if let Motion::Record(record) = &scene.motion { record.loaded.clone() } else { None };
    assert_eq!(loaded(&set(&scene, &["motion.scale=2"])), read, "the same file");
    assert_eq!(loaded(&set(&scene, &["motion.file=b.csv"])), None, "another file is not read yet");
}

#[test]
fn a_wrong_path_is_answered_with_what_there_is() {
    let scene = preset("skew45-abutment");
    let error = complaint(&scene, "motion.angel_deg=45");
    assert_eq!(error.value.plain(), "45", "the value");
    assert!(error.remedy.to_string().contains("did you mean `angle_deg`?"), "{error}");
    assert!(complaint(&scene, "motoin.angle_deg=45").remedy.to_string().contains("did you mean `motion`?"), "a table");
    let nobody = complaint(&scene, "girder.dek.skew_deg=45");
    assert!(nobody.remedy.to_string().contains("there is: deck"), "{nobody}");
    assert!(
        complaint(&scene, "girder.7.skew_deg=45").remedy.to_string().contains("there is: deck"),
        "a number too high"
    );
    assert!(complaint(&scene, "girder.deck.mass_kg.x=1").value.to_string().contains("mass_kg"), "a value has no keys");
    assert!(
        complaint(&scene, "contact.pair.0.mu_static=1").remedy.to_string().contains("there is: nothing"),
        "an empty list"
    );
    assert!(complaint(&scene, "girder.deck=5").remedy.to_string().contains("table"), "a girder is more than a number");
}

#[test]
fn a_wrong_value_is_answered_with_the_right_kind() {
    let scene = preset("skew45-abutment");
    let error = complaint(&scene, "girder.deck.mass_kg=heavy");
    assert!(error.value.plain() == "\"heavy\"" && error.remedy.to_string().contains("expected a number"), "{error}");
    assert!(complaint(&scene, "contact.law=papr").remedy.to_string().contains("did you mean `paper`?"), "a word");
    assert!(
        complaint(&scene, "girder.deck.position_m=[1").remedy.to_string().contains("a value as in the file"),
        "half a list"
    );
    assert!(complaint(&scene, "motion.angle_deg=").value.plain() == "``", "no value");
    assert!(complaint(&scene, "motion.angle_deg").remedy.to_string().contains("PATH=VALUE"), "no equals sign");
    let deep = overrides::apply(&scene, &format!("{}=1", vec!["a"; 10_000].join(".")))
        .expect_err("too many steps")
        .to_string();
    assert!(deep.contains("PATH=VALUE") && deep.contains("10000 steps") && deep.len() < 400, "{deep}");
    assert!(complaint(&scene, "motion..angle_deg=1").remedy.to_string().contains("PATH=VALUE"), "an empty step");
    let missing = complaint(&preset("flush-free-hit"), "girder.deck.bearings.frequency_hz=2");
    assert!(
        missing.remedy.to_string().starts_with("girder.deck.bearings.damping_ratio: this key must be given"),
        "{missing}"
    );
    let lines = overrides::apply(&scene, "name=a\nb=1").expect_err("one value");
    assert!(lines.to_string().contains("as in the file"), "{lines}");
}

#[test]
fn of_several_settings_the_wrong_one_is_blamed() {
    let settings = ["motion.angle_deg=3", "girder.deck.mass_kg=heavy", "duration_s=1"];
    let errors = overrides::apply_all(&preset("skew45-abutment"), &settings).expect_err("one is wrong");
    assert_eq!(errors.0[0].place.plain(), "--set girder.deck.mass_kg=heavy", "{errors}");
}

#[test]
fn the_spatial_deck_becomes_planar_by_one_word() {
    let scene = set(&preset("deck-30m"), &["kind=planar"]);
    assert_eq!(validate::validate(&scene), Ok(()), "what is vertical is not looked at");
}
