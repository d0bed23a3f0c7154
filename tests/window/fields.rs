//! Every key of the scene has a field in the window, and every field says what is allowed and what it is by itself.

use std::collections::BTreeMap;

use super::harness::{bench_of, builder, choose, open, press, reach_as, settle, type_in};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _, by};
use girderbench::app::{FileCommand, SelectCommand, Workbench};
use girderbench::files::{Supplement, read_record};
use girderbench::scene::keys::{self, Fallback, Range, TABLES};
use girderbench::scene::{
    DeviceId, DeviceKind, GroundId, ModelKind, Motion, PlotSettings, Processing, Scene, overrides, presets,
};
use girderbench::view::Target;

type Window = Harness<'static, Workbench>;

/// Keys without a field, and why.
const NO_FIELD: &[(&str, &str, &str)] = &[("", "format", "the program writes its own version")];

/// Sections that are folded away at first.
const FOLDED: [&str; 11] = [
    "Assumed values",
    "Start, push, held",
    "Seats",
    "Design codes",
    "Contact of all pairs",
    "Pairs by name",
    "Samples",
    "Processing",
    "Soil behind the wall",
    "Damping, yield, place, cap",
    "Flexibility",
];

/// A window on the first instants of a scene, unfolded: what its fields say depends on no answer.
fn show(scene: Scene, select: Option<Target>) -> Window {
    let bench = bench_of(Scene { duration: 0.2, ..scene });
    let mut harness = builder([1280.0, 720.0]).build_ui_state(super::harness::show, bench);
    harness.state_mut().apply(SelectCommand::Only(select));
    settle(&mut harness);
    let mut folded = FOLDED.to_vec();
    // Sections are within sections.
    loop {
        let (there, hidden): (Vec<_>, Vec<_>) =
            folded.into_iter().partition(|label| harness.query_by_label(label).is_some());
        if there.is_empty() {
            return harness;
        }
        for label in there {
            harness.get_by_label(label).click_accesskit();
        }
        harness.run_steps(24);
        folded = hidden;
    }
}

/// Every field in the window: the place that it is for, and what it says of itself.
fn fields(harness: &Window) -> Vec<(String, String)> {
    let with_place = by().predicate(|node| node.author_id().is_some_and(|id| id.contains('/')));
    let said = harness.query_all(with_place).map(|node| {
        let node = node.accesskit_node();
        (node.author_id().unwrap_or_default().to_owned(), node.description().unwrap_or_default())
    });
    said.collect()
}

/// A scene with the file that its record names.
fn loaded(mut scene: Scene) -> Scene {
    let Motion::Record(record) = &mut scene.motion else { panic!("a record") };
    let file = std::path::PathBuf::from(record.file.clone().expect("a file"));
    record.loaded = Some(std::sync::Arc::new(read_record(&file, &Supplement::default()).expect("a record")));
    scene
}

/// A scene with the file of its first component.
fn with_first_read(mut scene: Scene) -> Scene {
    let Motion::Record(record) = &mut scene.motion else { panic!("a record") };
    let file = std::path::PathBuf::from(record.components[0].file.clone().expect("a file"));
    let read = read_record(&file, &Supplement::default()).expect("a record");
    record.loaded_components = vec![Some(std::sync::Arc::new(read)), None];
    scene
}

/// Windows that show between them everything that can be edited.
fn windows() -> Vec<Window> {
    let planar = presets::load(presets::OPENING).expect("ships");
    let with = |scene: &Scene, sets: &[&str]| overrides::apply_all(scene, sets).expect("fits");
    let mut both =
        with(&planar, &["girder.deck.seat_m={ \"+x\" = 0.01, \"-x\" = 0.01, side = 0.1 }", "limits.drift_m=0.1"]);
    both = with(&both, &["limits.rotation_deg=1", "limits.remaining_seat_m=0", "limits.force_n=10"]);
    let codes = "codes={ deck_length_m = 30, support_distance_m = 30, column_height_m = 8, zone_percent = 100, rotation_deg = 5, \
                 japanese_ground = \"I\", european_ground = \"A\", ground_acceleration_g = 0.2, soil_factor = 1, \
                 corner_period_s = 0.4, displacement_period_s = 2, bearing_length_m = 0.4, long_term_m = 0.01, \
                 temperature_m = 0.01, caltrans_support = \"hinge\" }";
    both = with(&both, &[codes]);
    both.model.kind = ModelKind::Both;
    both.view.plots = vec![PlotSettings::over_time(vec!["deck.x".into()])];
    let named = with(&planar, &["contact.pair=[{ between = [\"deck\", \"wall\"] }]"]);
    let record = ["motion.kind=record", "motion.samples_m_s2=[0, 1, 0]", "motion.dt_s=0.1"];
    let deck = presets::load("deck-30m").expect("ships");
    let [mut record, record_in_space] = [&planar, &deck].map(|scene| with(scene, &record));
    if let Motion::Record(record) = &mut record.motion {
        record.processing =
            Processing { from: Some(0.0), until: Some(0.2), peak_g: Some(0.1), ..Processing::default() };
    }
    let several = with(&planar, &["motion.kind=record", "motion.file=tests/data/records/csmip.V2", "motion.channel=2"]);
    let several = loaded(several);
    let twice = "motion.component=[{ file = \"tests/data/records/csmip.V2\", channel = 1 }, \
         { samples_m_s2 = [0, 1, 0], dt_s = 0.02, azimuth_deg = 90 }]";
    let components = with(&planar, &["motion.kind=record", "motion.x_azimuth_deg=90", twice]);
    let components = with_first_read(components);
    let matched = with(&deck, &["motion.kind=synthetic", "motion.target_psa_g=[[0.1, 0.2], [1, 0.3]]"]);
    let metric_in_space = with(&deck, &["motion.amplitude_m_s2=4", "motion.vertical_amplitude_m_s2=2"]);
    let each = "girder.deck.bearings=[{ at_m = [0, 0], stiffness_n_per_m = [1e7, 1e7, 1e9], damping_n_s_per_m = [0, 0, 0], \
         yield_force_n = 1e5, yield_displacement_m = 0.01, yields_per_axis = true }]";
    let metric = with(&planar, &["motion.amplitude_m_s2=4"]);
    let corners = "[[0.2, -0.1, -0.03], [0.2, 0.1, -0.03], [0.2, 0.1, 0.03], [0.2, -0.1, 0.03]]";
    let corners = with(&planar, &["girder.deck.skew_deg=90", &format!("abutment.wall.polygon_m={corners}")]);
    let soil = with(&planar, &["abutment.wall.backfill={ fuse_stiffness_n_per_m = 1e5, fuse_force_n = 10 }"]);
    let viaduct = presets::load("viaduct-5").expect("ships");
    let one_by_one = "girder.g1.bearings=[{ at_m = [14, 0], stiffness_n_per_m = [1e7, 1e7], damping_n_s_per_m = [0, 0], on = \"p1\" }]";
    let ends = "girder = \"deck\", to = \"wall\", at_m = [0.08, 0.02], to_m = [-0.02, 0.02]";
    let cable = format!(
        "restrainer=[{{ name = \"a\", {ends}, axial_stiffness_n = 1e4, length_m = 0.2, yield_force_n = 10, \
         post_yield_stiffness_n_per_m = 10, break_elongation_m = 0.01 }}]"
    );
    let rubber = format!(
        "bumper=[{{ name = \"b\", {ends}, normal = [-1, 0], gap_m = 0.002, depth_force_m_n = [[0.001, 10]] }}]"
    );
    let soft = format!("bumper=[{{ name = \"b\", {ends}, gap_m = 0.002, stiffness_n_per_m = 1e4 }}]");
    let damper = format!("damper=[{{ name = \"c\", {ends}, coefficient = 10, brace_stiffness_n_per_m = 1e4 }}]");
    let key = "stopper=[{ name = \"d\", girder = \"deck\", at_m = [0, 0], direction = [0, 1], minus_gap_m = 0.01, \
         stiffness_n_per_m = 1e4, yield_force_n = 10, break_displacement_m = 0.01 }]";
    let one = |set: &str, kind| show(with(&planar, &[set]), Some(Target::Device(DeviceId { kind, number: 0 })));
    let devices = vec![
        one(&cable, DeviceKind::Restrainer),
        one(&rubber, DeviceKind::Bumper),
        one(&soft, DeviceKind::Bumper),
        one(&damper, DeviceKind::Damper),
        one(key, DeviceKind::Stopper),
    ];
    let span = presets::load("span-as-built").expect("ships");
    let lead = "girder.g1.bearings={ kind = \"lead-rubber\", at_m = [[14, 0], [-14, 0]], on_plus_x = \"p1\" }";
    let lead = with(&viaduct, &[lead]);
    let high = "girder.deck.bearings={ kind = \"pendulum\", at_m = [[10, 0], [-10, 0]], vertical_frequency_hz = 5 }";
    let high = with(&deck, &[high]);
    let elastic = "girder.deck.elastic={ area_m2 = 0.001, rayleigh = { mass = 0.1, stiffness = 1e-5 } }";
    let elastic = with(&planar, &[elastic]);
    let places = with(&planar, &["girder.deck.bearings.at_m=[[0.05, 0]]"]);
    let others = vec![
        show(both.clone(), None),
        show(both, Some(Target::Girder(0))),
        show(named.clone(), None),
        show(named, Some(Target::Abutment(0))),
        show(record, None),
        show(several, None),
        show(components, None),
        show(matched, None),
        show(with(&deck, &["motion.kind=synthetic"]), None),
        show(with(&deck, &["motion.kind=sweep"]), None),
        show(record_in_space, None),
        show(metric_in_space, None),
        show(with(&deck, &["girder.deck.elastic={ area_m2 = 8 }"]), Some(Target::Girder(0))),
        show(with(&deck, &[each]), Some(Target::Girder(0))),
        show(metric, None),
        show(corners, Some(Target::Abutment(0))),
        show(places, Some(Target::Girder(0))),
        show(soil, Some(Target::Abutment(0))),
        show(with(&planar, &["wave.speed_m_per_s=500"]), None),
        show(viaduct.clone(), Some(Target::Girder(0))),
        show(viaduct.clone(), Some(Target::Pier(0))),
        show(with(&viaduct, &["pier.p1.frequency_hz=2"]), Some(Target::Pier(0))),
        show(with(&viaduct, &["pier.p1.stiffness_n_per_m=5e7", "pier.p1.yield_force_n=1e6"]), Some(Target::Pier(0))),
        show(with(&viaduct, &[one_by_one]), Some(Target::Girder(0))),
        show(elastic, Some(Target::Girder(0))),
        show(span, Some(Target::Girder(0))),
        show(lead, Some(Target::Girder(0))),
        show(high, Some(Target::Girder(0))),
    ];
    let bank = "ground=[{ name = \"bank\", kind = \"sine\", amplitude_g = 0.1, frequency_hz = 1 }]";
    let bank = with(&viaduct, &[bank]);
    let mut on_pier = show(bank.clone(), Some(Target::Pier(0)));
    choose(&mut on_pier, "Motion of", "bank");
    others.into_iter().chain(devices).chain(vec![on_pier, show(bank, Some(Target::Abutment(0)))]).collect()
}

#[test]
fn every_key_of_the_scene_file_has_a_field_that_says_its_range_and_default() {
    let mut found: BTreeMap<(&str, &str), Vec<String>> = BTreeMap::new();
    for harness in windows() {
        for (id, said) in fields(&harness) {
            let place = id.split('/').next().unwrap_or_default();
            let (table, key) = keys::of_place(place).unwrap_or_else(|| panic!("a field of no key: {id}"));
            found.entry((table.path, key.name)).or_default().push(said);
        }
    }
    let (mut missing, mut silent) = (Vec::new(), Vec::new());
    for (table, key) in TABLES.iter().flat_map(|t| t.keys.iter().map(move |key| (t.path, key))) {
        let stands_at = table.split(" kind").next().unwrap_or_default();
        let path = if table.is_empty() { key.name.to_owned() } else { format!("{stands_at}.{}", key.name) };
        let is_table = TABLES.iter().any(|t| t.path.split(" kind").next() == Some(path.as_str()));
        let excused = NO_FIELD.iter().any(|(t, name, _)| *t == table && (name.is_empty() || *name == key.name));
        // Kinds of motion, and of bearings, have keys of one name: one place in the file, found as that of the first kind.
        let twins = TABLES.iter().map(|t| t.path).filter(|path| path.split(" kind").next() == Some(stands_at));
        let twin = twins.into_iter().find_map(|twin| found.get(&(twin, key.name)));
        let Some(said) = found.get(&(table, key.name)).or(twin) else {
            if !is_table && !excused {
                missing.push(path);
            }
            continue;
        };
        // A list of things has buttons that add to it, and a name what is wrong with it.
        let plain = matches!(key.range, Range::Free | Range::Like(_)) && !matches!(key.fallback, Fallback::Zeros(_));
        let speaks = |words: &String| words.contains("Allowed: ") && words.to_lowercase().contains("default");
        // A button to the other way of saying it says where it leads.
        let mut fields = said.iter().filter(|words| !words.is_empty()).peekable();
        if !plain && (fields.peek().is_none() || !fields.all(speaks)) {
            silent.push((path, said.clone()));
        }
    }
    assert!(missing.is_empty(), "keys that cannot be edited in the window: {missing:?}");
    assert!(silent.is_empty(), "fields that do not say what is allowed and what they are by themselves: {silent:#?}");
}

fn undo(harness: &mut Window) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(harness);
}

fn deck() -> Window {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    harness
}

#[test]
fn what_is_not_the_default_can_be_taken_back_by_sign_by_menu_and_by_emptying_it() {
    let skew = |h: &Window| h.state().files.document.scene().girders[0].skew_deg;
    let mut harness = deck();
    assert_eq!(skew(&harness), 45.0, "not straight, to begin with");
    // Sign: it is in both panels, at the number and at the slider.
    let signs = harness.query_all_by_role_and_label(Role::Button, "Reset Skew β").count();
    assert_eq!(signs, 2, "a sign at each");
    let sign = harness.query_all_by_role_and_label(Role::Button, "Reset Skew β").next().expect("there");
    sign.click();
    settle(&mut harness);
    assert_eq!(skew(&harness), 90.0, "straight");
    harness.run_steps(4);
    assert!(harness.query_by_role_and_label(Role::Button, "Reset Skew β").is_none(), "nothing to take back any more");
    undo(&mut harness);
    assert_eq!(skew(&harness), 45.0, "one step");
    // The context menu; the number is the first of its name, the one behind the slider the second.
    let number = harness.query_all_by_role_and_label(Role::SpinButton, "Skew β").next().expect("there");
    number.click_secondary();
    harness.run_steps(10);
    press(&mut harness, "Reset to 90°");
    assert_eq!(skew(&harness), 90.0, "by the menu");
    undo(&mut harness);
    let number = harness.query_all_by_role_and_label(Role::SpinButton, "Skew β").next().expect("there");
    number.click();
    settle(&mut harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.key_press(Key::Backspace);
    settle(&mut harness);
    harness.key_press(Key::Enter);
    settle(&mut harness);
    assert_eq!(skew(&harness), 90.0, "emptied");
    assert_eq!(harness.state().files.document.selection().all().len(), 1, "the key was the field's");
    assert_eq!(harness.state().files.document.scene().girders.len(), 1, "nothing was removed");
}

#[test]
fn a_number_out_of_its_range_is_marked_with_the_reason_and_undone() {
    let mut harness = deck();
    let before = harness.state().files.document.scene().clone();
    type_in(&mut harness, "Mass m", "-2");
    assert_eq!(
        harness.state().files.document.scene().girders[0].mass,
        -2.0,
        "as typed: invalid while editing is allowed"
    );
    let problems = harness.state().replay.runner.problems().expect("no mass is negative").clone();
    let remedy = keys::find(keys::GIRDER, "mass_kg").and_then(|key| key.range.fault(-2.0)).expect("a reason");
    assert_eq!(problems.0[0].remedy, remedy, "the range's own words");
    assert!(harness.query_all_by_label_contains(&remedy.to_string()).count() >= 2, "at the field too");
    undo(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "one step");
    type_in(&mut harness, "Mass m", "12 mm");
    assert_eq!(*harness.state().files.document.scene(), before, "no mass: refused");
    assert!(harness.query_by_label_contains("\u{201c}12 mm\u{201d} is no number here").is_some(), "with the reason");
    type_in(&mut harness, "Amplitude", "0.4 kg");
    assert_eq!(*harness.state().files.document.scene(), before, "the number behind a slider refuses too");
    assert!(harness.query_by_label_contains("\u{201c}0.4 kg\u{201d} is no number here").is_some(), "with the reason");
    type_in(&mut harness, "Amplitude", "1.5 g");
    let beyond =
        matches!(&harness.state().files.document.scene().motion, Motion::Sine(s) if s.amplitude_g == Some(1.5));
    assert!(beyond, "and takes what lies beyond the slider");
    undo(&mut harness);
    type_in(&mut harness, "Mass m", "");
    assert_eq!(*harness.state().files.document.scene(), before, "it has no default");
    assert!(harness.query_by_label_contains("It must be given").is_some(), "with the reason");
    type_in(&mut harness, "Mass m", "3");
    assert!(harness.query_by_label_contains("It must be given").is_none(), "a number ends the complaint");
    assert_eq!(harness.state().files.document.scene().girders[0].mass, 3.0, "taken");
}

#[test]
fn a_reckoned_number_is_given_and_reckoned_again() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Abutment(0))));
    settle(&mut harness);
    let width = |h: &Window| h.state().files.document.scene().abutments[0].width;
    let before = width(&harness);
    type_in(&mut harness, "Face width", "0.5 m");
    assert_eq!(width(&harness), Some(0.5), "given");
    reach_as(&mut harness, Role::Button, "Reset Face width");
    press(&mut harness, "Reset Face width");
    assert_eq!(width(&harness), None, "reckoned from the girder");
    undo(&mut harness);
    undo(&mut harness);
    assert_eq!(width(&harness), before, "as it was");
}

#[test]
fn the_face_of_a_wall_is_given_by_its_corners_and_back() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Abutment(0))));
    settle(&mut harness);
    let digest = |h: &Window| h.state().replay.runner.answer().expect("run").history.digest();
    let gap = harness.state().files.document.scene().abutments[0].gap.expect("given");
    super::harness::reach(&mut harness, "Give the face by its corners");
    press(&mut harness, "Give the face by its corners");
    let corners = harness.state().files.document.scene().abutments[0].polygon.clone().expect("four corners");
    assert_eq!(corners.len(), 4, "four");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
    type_in(&mut harness, "Corner 1 z", "-25 mm");
    assert_eq!(
        harness.state().files.document.scene().abutments[0].polygon.as_ref().expect("still")[0][2],
        -0.025,
        "as typed"
    );
    undo(&mut harness);
    let by_corners = digest(&harness);
    super::harness::reach(&mut harness, "Give the face by its gap");
    press(&mut harness, "Give the face by its gap");
    let again = harness.state().files.document.scene().abutments[0].gap.expect("given");
    assert!((again - gap).abs() < 2e-6, "where it was, to the micrometre: {again}");
    assert_ne!(by_corners, 0, "it ran");
}

#[test]
fn the_ground_stands_still_is_a_sine_or_a_record_and_keeps_its_angle() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("quake.csv");
    std::fs::write(&file, "t_s,a_m_s2\n0.0,0.0\n0.1,2.0\n0.2,-1.0\n0.3,0.0\n").expect("written");
    let mut harness = open(presets::OPENING);
    super::harness::slide(&mut harness, "Angle α", 30.0);
    super::harness::slide(&mut harness, "Phase φ0", 90.0);
    assert!(
        matches!(&harness.state().files.document.scene().motion, Motion::Sine(s) if s.phase_deg == 90.0),
        "the phase"
    );
    choose(&mut harness, "Given in", "m/s²");
    let Motion::Sine(sine) = harness.state().files.document.scene().motion.clone() else { panic!("a sine") };
    assert!(sine.amplitude_g.is_none() && (sine.amplitude.expect("given") - 3.92266).abs() < 1e-9, "the same in m/s²");
    choose(&mut harness, "Ground", "record");
    assert!(
        matches!(&harness.state().files.document.scene().motion, Motion::Record(r) if r.angle_deg == 30.0),
        "the angle stays"
    );
    assert_eq!(harness.state().replay.runner.problems(), None, "silence runs");
    harness.state_mut().apply(FileCommand::Record(GroundId::Reference, file.clone()));
    settle(&mut harness);
    let Motion::Record(record) = harness.state().files.document.scene().motion.clone() else { panic!("a record") };
    let (dt, samples) = record.series().expect("read");
    assert!((dt - 0.1).abs() < 1e-12, "every 0.1 s, got {dt}");
    assert_eq!(samples, [0.0, 2.0, -1.0, 0.0], "as written");
    assert_eq!((record.angle_deg, record.samples), (30.0, None), "from the file");
    assert_eq!(harness.state().replay.runner.problems(), None, "and run");
    assert!(harness.query_by_label_contains("4 samples, 0.1 s apart").is_some(), "said in the panel");
    super::harness::slide(&mut harness, "Record scale", 2.0);
    super::harness::reach(&mut harness, "Keep its samples in the scene");
    press(&mut harness, "Keep its samples in the scene");
    let Motion::Record(record) = harness.state().files.document.scene().motion.clone() else { panic!("a record") };
    assert_eq!((record.scale, record.file.clone(), record.dt), (2.0, None, Some(dt)), "without the file");
    let kept = harness.state().files.document.scene().clone();
    harness.state_mut().apply(FileCommand::Record(GroundId::Reference, folder.path().join("nothing.csv")));
    settle(&mut harness);
    assert!(harness.state().window.notice().is_some_and(|n| n.contains("nothing.csv")), "a missing file is named");
    assert_eq!(*harness.state().files.document.scene(), kept, "and changes nothing");
    choose(&mut harness, "Ground", "still");
    assert_eq!(harness.state().files.document.scene().motion, Motion::None, "still");
    while harness.state().files.document.undo_label().is_some() {
        undo(&mut harness);
    }
    assert_eq!(
        *harness.state().files.document.scene(),
        presets::load(presets::OPENING).expect("ships"),
        "every step undone"
    );
}

#[test]
fn a_record_that_was_chosen_is_saved_with_the_scene_and_opened_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let (scene, quake) = (folder.path().join("mine.toml"), folder.path().join("quake.csv"));
    std::fs::write(&quake, "0,0\n0.1,2\n0.2,0\n").expect("written");
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(FileCommand::SaveTo(scene.clone()));
    harness.state_mut().apply(FileCommand::Record(GroundId::Reference, quake));
    settle(&mut harness);
    assert!(
        matches!(&harness.state().files.document.scene().motion, Motion::Record(r) if r.file.as_deref() == Some("quake.csv")),
        "named from the scene's folder on"
    );
    harness.state_mut().apply(FileCommand::SaveTo(scene.clone()));
    let saved = harness.state().files.document.scene().clone();
    harness.state_mut().apply(FileCommand::New);
    harness.state_mut().apply(FileCommand::Open(scene));
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().motion, saved.motion, "the record with it");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
}

#[test]
fn samples_are_typed_and_nonsense_among_them_is_said() {
    let mut harness = open(presets::OPENING);
    choose(&mut harness, "Ground", "record");
    let fold = harness.get_by_label("Samples");
    fold.scroll_to_me();
    fold.click_accesskit();
    harness.run_steps(40);
    let write = |harness: &mut Window, words: &str| {
        reach_as(harness, Role::MultilineTextInput, "Samples, m/s²");
        harness.get_by_role_and_label(Role::MultilineTextInput, "Samples, m/s²").focus();
        settle(harness);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.event(egui::Event::Text(words.into()));
        settle(harness);
    };
    write(&mut harness, "0 1.5 nonsense");
    assert!(harness.query_by_label_contains("nonsense").is_some(), "said at once");
    write(&mut harness, "0 1.5 -2; 0");
    harness.key_press(Key::Tab);
    settle(&mut harness);
    assert!(
        matches!(&harness.state().files.document.scene().motion, Motion::Record(r) if r.samples == Some(vec![0.0, 1.5, -2.0, 0.0])),
        "{:?}",
        harness.state().files.document.scene().motion
    );
}

#[test]
fn a_pair_that_is_not_found_by_itself_is_declared() {
    let mut harness = open("straight-straight");
    let unfold = harness.get_by_label("Pairs by name");
    unfold.scroll_to_me();
    unfold.click_accesskit();
    harness.run_steps(40);
    super::harness::reach(&mut harness, "Name a pair");
    press(&mut harness, "Name a pair");
    let pairs = |h: &Window| h.state().files.document.scene().contact.pairs.clone();
    assert_eq!(pairs(&harness).len(), 1, "an entry");
    reach_as(&mut harness, Role::CheckBox, "Entry 1: these ends only");
    harness.get_by_role_and_label(Role::CheckBox, "Entry 1: these ends only").click();
    settle(&mut harness);
    assert!(pairs(&harness)[0].ends.is_some(), "with its ends");
    super::harness::reach(&mut harness, "Remove entry 1");
    press(&mut harness, "Remove entry 1");
    assert!(pairs(&harness).is_empty(), "gone");
}

#[test]
fn stiffness_is_given_one_way_at_a_time() {
    let mut harness = open(presets::OPENING);
    let unfold = harness.get_by_label("Contact of all pairs");
    unfold.scroll_to_me();
    unfold.click_accesskit();
    harness.run_steps(40);
    let given = |h: &Window| {
        (h.state().files.document.scene().contact.stiffness, h.state().files.document.scene().contact.young_modulus)
    };
    assert_eq!(given(&harness), (Some(1.55e5), None), "the preset gives K");
    type_in(&mut harness, "E of all", "20 GPa");
    assert_eq!(given(&harness), (None, Some(2e10)), "E takes its place");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
    choose(&mut harness, "Sharing of all", "per-node");
    choose(&mut harness, "Tension of all", "clamp");
    let contact = harness.state().files.document.scene().contact.clone();
    assert_eq!(format!("{:?} {:?}", contact.sharing, contact.tension), "PerNode Clamp", "chosen");
    reach_as(&mut harness, Role::Button, "Reset Tension of all");
    press(&mut harness, "Reset Tension of all");
    assert_eq!(format!("{:?}", harness.state().files.document.scene().contact.tension), "Keep", "taken back");
}

#[test]
fn components_are_added_turned_and_taken_away_with_undo() {
    let mut harness = open(presets::OPENING);
    choose(&mut harness, "Ground", "record");
    harness.state_mut().apply(FileCommand::Record(GroundId::Reference, "tests/data/records/csmip.V2".into()));
    settle(&mut harness);
    let record = |harness: &Window| {
        let Motion::Record(record) = harness.state().files.document.scene().motion.clone() else { panic!("a record") };
        record
    };
    let one = record(&harness);
    super::harness::reach(&mut harness, "Add a component");
    press(&mut harness, "Add a component");
    let first = record(&harness);
    assert_eq!(
        (first.file, first.components.len(), first.x_azimuth_deg),
        (None, 1, Some(90.0)),
        "the same as a component"
    );
    assert_eq!(first.components[0].file, one.file, "of the same file");
    assert_eq!(first.components[0].azimuth_deg, Some(90.0), "along x, as it was");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
    super::harness::reach(&mut harness, "Add a component");
    press(&mut harness, "Add a component");
    let second = record(&harness);
    assert_eq!(second.components[1].azimuth_deg, Some(180.0), "square to the first");
    assert_eq!(harness.state().replay.runner.problems(), None, "still ground across runs");
    type_in(&mut harness, "Azimuth of component 2", "45");
    type_in(&mut harness, "Factor of component 2", "0.5");
    let turned = record(&harness).components[1].clone();
    assert_eq!((turned.azimuth_deg, turned.scale), (Some(45.0), 0.5), "as typed");
    harness.state_mut().apply(FileCommand::Component(GroundId::Reference, 1, "tests/data/records/csmip.V2".into()));
    settle(&mut harness);
    let filled = record(&harness);
    assert_eq!(filled.components[1].scale, 0.5, "the factor stays");
    assert!(filled.component_record(1).is_some_and(|read| read.channels.len() > 1), "read");
    choose(&mut harness, "Unit of component 2", "gal");
    assert!(harness.state().window.notice().is_some(), "the file states its unit: that is told");
    undo(&mut harness);
    super::harness::reach(&mut harness, "Remove component 1");
    press(&mut harness, "Remove component 1");
    let left = record(&harness);
    assert_eq!((left.components.len(), left.components[0].scale), (1, 0.5), "the second is left");
    assert!(left.component_record(0).is_some(), "with what was read for it");
    while harness.state().files.document.undo_label().is_some() {
        undo(&mut harness);
    }
    assert_eq!(*harness.state().files.document.scene(), presets::load(presets::OPENING).expect("ships"), "all undone");
}

#[test]
fn a_file_that_states_no_unit_is_read_when_that_is_stated() {
    let folder = tempfile::tempdir().expect("a folder");
    let bare = folder.path().join("bare.dat");
    std::fs::write(&bare, "0\n100\n-50\n0\n").expect("written");
    let mut harness = open(presets::OPENING);
    choose(&mut harness, "Ground", "record");
    harness.state_mut().apply(FileCommand::Record(GroundId::Reference, bare));
    settle(&mut harness);
    assert!(harness.state().window.notice().is_some_and(|notice| notice.contains("dt_s")), "what is missing is told");
    assert!(harness.state().replay.runner.problems().is_some(), "it cannot be run so");
    choose(&mut harness, "Unit", "gal");
    reach_as(&mut harness, Role::CheckBox, "Interval");
    harness.get_by_role_and_label(Role::CheckBox, "Interval").click();
    settle(&mut harness);
    let Motion::Record(record) = harness.state().files.document.scene().motion.clone() else { panic!("a record") };
    let (dt, samples) = record.series().expect("read now");
    assert_eq!((dt, samples), (0.01, &[0.0, 1.0, -0.5, 0.0][..]), "in m/s², at the interval that was stated");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
}

#[test]
fn a_synthetic_earthquake_is_matched_to_a_spectrum_by_hand() {
    let mut harness = open("el-centro-45");
    let target = |harness: &Window| match &harness.state().files.document.scene().motion {
        Motion::Synthetic(quake) => quake.target.clone(),
        other => panic!("{other:?}"),
    };
    if target(&harness).is_none() {
        let fold = harness.get_by_label("Target spectrum");
        fold.scroll_to_me();
        fold.click_accesskit();
        harness.run_steps(40);
        press(&mut harness, "Match it to a spectrum");
    }
    let before = target(&harness).expect("its own spectrum to begin with");
    assert!(before.len() >= 2 && before.windows(2).all(|two| two[0][0] < two[1][0]), "{before:?}");
    assert_eq!(harness.state().replay.runner.problems(), None, "it runs");
    type_in(&mut harness, "PSA 2", "0.9 g");
    assert_eq!(target(&harness).expect("there")[1][1], 0.9, "as typed");
    super::harness::reach(&mut harness, "Match it to none");
    press(&mut harness, "Match it to none");
    assert_eq!(target(&harness), None, "none");
    undo(&mut harness);
    assert_eq!(target(&harness).expect("there")[1][1], 0.9, "undone");
}
