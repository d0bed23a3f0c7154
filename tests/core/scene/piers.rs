//! Piers in scenes: what is wrong with them is said at its key, edits keep their names, stiffness follows from columns.

use girderbench::geometry::End;
use girderbench::scene::edit::Edit;
use girderbench::scene::{Bearings, Scene, format, validate};

use crate::support::{scene, within};

/// Two girders and a pier below the joint, with these keys of the pier.
fn with(pier: &str) -> String {
    let girder = |name: &str, x: f64, on: &str| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 30\nwidth_m = 10\nthickness_m = 1.5\nskew_deg = 60\nmass_kg = 6e5\nposition_m = [{x}, \
             0, 0]\nbearings = {{ frequency_hz = 1, damping_ratio = 0.05, at_skewed_m = [[14, 4], [14, -4], [-14, 4], [-14, -4]], {on} }}\n"
        )
    };
    let [one, other] = [girder("a", 0.0, "on_plus_x = \"p\""), girder("b", 30.1, "on_minus_x = \"p\"")];
    format!("name = \"piers\"\nduration_s = 1.0\n{one}{other}[[pier]]\nname = \"p\"\n{pier}\n")
}

fn said(text: &str) -> String {
    let checked = format::parse(text, "piers").and_then(|scene| validate::validate(&scene));
    checked.err().map_or_else(String::new, |errors| errors.to_string())
}

fn complaints(pier: &str) -> String {
    said(&with(pier))
}

#[test]
fn a_pier_stands_below_the_bearings_that_name_it() {
    let scene = scene(&with("mass_kg = 2e5\nfrequency_hz = 3.0"));
    let pier = scene.pier(0);
    within("between both rows", pier.top.x - 15.05, 1e-12);
    within("in the middle", pier.top.y, 1e-12);
    assert_eq!(pier.top.z, -0.75, "below the bearings");
    let [a, b] = [0, 1].map(|n| &scene.girders[n]);
    assert_eq!([scene.pier_under(a, End::Plus), scene.pier_under(a, End::Minus)], [Some(0), None]);
    assert_eq!([scene.pier_under(b, End::Plus), scene.pier_under(b, End::Minus)], [None, Some(0)]);
    let written = format::write(&scene);
    assert_eq!(format::parse(&written, "again").expect("reads"), scene, "written and read");
}

#[test]
fn what_a_pier_is_does_not_depend_on_the_order_of_its_girders() {
    let mut scene = scene(&with("mass_kg = 2e5\nfrequency_hz = 3.0"));
    (scene.girders[0].thickness, scene.girders[1].position[2]) = (1.9, 0.4);
    let pier = scene.pier(0);
    within("five depths of the deeper", pier.height - 9.5, 1e-12);
    within("its cap as deep", pier.cap[2] - 1.9, 1e-12);
    within("below the lower underside", pier.top.z + 0.95, 1e-12);
    scene.girders.reverse();
    assert_eq!(scene.pier(0), pier);
}

#[test]
fn the_stiffness_of_columns_is_that_of_beams() {
    let stiffness = |more: &str| scene(&with(&format!("mass_kg = 2e5\nheight_m = 9\n{more}"))).pier(0).stiffness;
    let i = std::f64::consts::PI * 1.6f64.powi(4) / 64.0;
    let [along, across] =
        stiffness("column_m = 1.6\nyoung_modulus_pa = 2e10\ncolumns = 2\ncolumn_top = \"fixed-across\"");
    within("3EI/h³", along / (2.0 * 3.0 * 2e10 * i / 729.0) - 1.0, 1e-14);
    within("12EI/h³", across / along - 4.0, 1e-14);
    let [along, across] = stiffness("column_m = [1.2, 4.0]");
    within("bh³/12 along", along / (3.0 * 3e10 * (4.0 * 1.728 / 12.0) / 729.0) - 1.0, 1e-14);
    within("across", across / along - (4.0 / 1.2f64).powi(2), 1e-12);
    let [fixed, _] = stiffness("column_m = [1.2, 4.0]\ncolumn_top = \"fixed\"");
    within("tops that do not turn", fixed / along - 4.0, 1e-14);
}

#[test]
fn what_is_wrong_with_a_pier_is_said_at_its_key() {
    let cases = [
        ("mass_kg = 2e5", "pier.p.stiffness_n_per_m"),
        ("mass_kg = 2e5\nfrequency_hz = 3\nstiffness_n_per_m = 1e7", "give one of them"),
        ("mass_kg = 2e5\ncolumn_m = 1.5", "pier.p.height_m"),
        ("mass_kg = 2e5\nfrequency_hz = 3\ncolumn_top = \"fixed\"", "pier.p.column_top"),
        ("mass_kg = 2e5\nfrequency_hz = 3\nyoung_modulus_pa = 2e10", "pier.p.young_modulus_pa"),
        ("mass_kg = 2e5\nfrequency_hz = 3\ncolumns = 1.5", "a whole number"),
        ("mass_kg = 2e5\nfrequency_hz = 3\npost_yield_ratio = 0.1", "yield_force_n"),
        ("mass_kg = 2e5\nfrequency_hz = 3\nturn_inertia_kg_m2 = 1e6", "turn_stiffness_n_m_per_rad"),
        ("mass_kg = 2e5\nfrequency_hz = 3\ncap_m = [2.0, 0.0, 1.0]", "pier.p.cap_m[1]"),
        ("mass_kg = -1\nfrequency_hz = 3", "pier.p.mass_kg"),
        ("mass_kg = 2e5\nfrequency_hz = [3, 0]", "pier.p.frequency_hz[1]"),
        (
            "mass_kg = 2e5\nfrequency_hz = 3\n[[pier]]\nname = \"q\"\nmass_kg = 1e5\nfrequency_hz = 2",
            "pier.q.position_m",
        ),
        (
            "mass_kg = 2e5\nfrequency_hz = 3\n[[pier]]\nname = \"a\"\nmass_kg = 1e5\nfrequency_hz = 2\nposition_m = [9, 9]",
            "another body",
        ),
    ];
    for (keys, wanted) in cases {
        let said = complaints(keys);
        assert!(said.contains(wanted), "{keys}: {said}");
    }
    assert_eq!(complaints("mass_kg = 2e5\nfrequency_hz = 3"), "", "nothing");
    let nobody = with("mass_kg = 2e5\nfrequency_hz = 3").replace("on_minus_x = \"p\"", "on_minus_x = \"q\"");
    let said = said(&nobody);
    assert!(said.contains("girder.b.bearings.on_minus_x") && said.contains("there are p"), "{said}");
}

#[test]
fn bearings_follow_the_name_of_their_abutment_and_stand_on_the_ground_without_it() {
    let text = with("mass_kg = 2e5\nfrequency_hz = 3.0").replace("on_minus_x = \"p\"", "on_minus_x = \"wall\"");
    let before = scene(&format!("{text}\n[[abutment]]\nname = \"wall\"\nfaces = \"b\"\ngap_m = 0.5\n"));
    let on = |scene: &Scene| {
        let Some(Bearings::Shared(bearings)) = &scene.girders[1].bearings else { panic!("equal bearings") };
        bearings.on_minus_x.clone()
    };
    assert_eq!(on(&before).as_deref(), Some("wall"));
    let mut changed = before.clone();
    let back = Edit::Rename("wall".into(), "east".into()).apply(&mut changed).expect("renamed");
    assert_eq!(on(&changed).as_deref(), Some("east"));
    back.apply(&mut changed).expect("back");
    let back = Edit::RemoveAbutment(0).apply(&mut changed).expect("removed");
    assert_eq!(on(&changed), None, "on the ground");
    back.apply(&mut changed).expect("back");
    assert_eq!(changed, before);
}

#[test]
fn edits_of_piers_keep_their_names_and_can_be_undone() {
    let before = scene(&with("mass_kg = 2e5\nfrequency_hz = 3.0"));
    let on = |scene: &Scene| {
        let Some(Bearings::Shared(bearings)) = &scene.girders[0].bearings else { panic!("equal bearings") };
        bearings.on_plus_x.clone()
    };
    let mut changed = before.clone();
    let back = Edit::Rename("p".into(), "north".into()).apply(&mut changed).expect("renamed");
    assert_eq!((changed.piers[0].name.as_str(), on(&changed).as_deref()), ("north", Some("north")));
    back.apply(&mut changed).expect("back");
    assert_eq!(changed, before);
    let back = Edit::RemovePier(0).apply(&mut changed).expect("removed");
    assert_eq!((changed.piers.len(), on(&changed)), (0, None), "on the ground");
    back.apply(&mut changed).expect("back");
    assert_eq!(changed, before);
    let pier = girderbench::scene::Pier { mass: 3e5, ..before.piers[0].clone() };
    let back = Edit::ReplacePier(0, Box::new(pier.clone())).apply(&mut changed).expect("another mass");
    assert_eq!(changed.piers[0].mass, 3e5);
    back.apply(&mut changed).expect("back");
    assert_eq!(changed, before);
    assert!(Edit::AddPier(1, Box::new(pier.clone())).apply(&mut changed).is_err(), "the name is taken");
    let other = girderbench::scene::Pier { name: "q".into(), position: Some([50.0, 0.0]), ..pier };
    Edit::AddPier(1, Box::new(other)).apply(&mut changed).expect("another");
    assert_eq!(changed.pier_named("q"), Some(1));
}
