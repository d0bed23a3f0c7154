//! The presets say what the paper's tables say, and are sound scenes.

use girderbench::scene::{
    Bearings, FrictionLaw, Motion, PerDirection, Scene, domain, facing, format, presets, validate,
};

fn load(name: &str) -> Scene {
    presets::load(name).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn every_preset_is_a_valid_scene_under_its_own_name() {
    for preset in presets::all() {
        let scene = load(preset.name);
        assert_eq!(scene.name, preset.name, "the file's name and the scene's");
        assert_eq!(validate::validate(&scene), Ok(()), "{}", preset.name);
    }
}

#[test]
fn every_preset_comes_back_from_its_written_text() {
    for preset in presets::all() {
        let scene = load(preset.name);
        let text = format::write(&scene);
        assert_eq!(format::parse(&text, preset.name), Ok(scene), "{text}");
    }
}

#[test]
fn the_pairs_of_each_preset_face_each_other_at_the_gap_written() {
    let pairs = |name: &str| -> Vec<(String, f64)> {
        let found = facing::find(&load(name)).unwrap_or_else(|errors| panic!("{errors}"));
        found.into_iter().map(|pair| (pair.name, pair.gap)).collect()
    };
    let wall = |gap| vec![("deck+x|wall".to_owned(), gap)];
    assert_eq!(pairs("straight-abutment"), wall(0.003), "as written");
    assert_eq!(pairs("skew60-abutment"), wall(0.003), "as written");
    assert_eq!(pairs("skew45-abutment"), wall(0.003), "as written");
    assert_eq!(pairs("flush-free-hit"), wall(0.005), "as written");
    let both = vec![("deck+x|east".to_owned(), 0.05), ("deck-x|west".to_owned(), 0.05)];
    assert_eq!(pairs("deck-30m"), both, "as written");
    let names: Vec<_> = pairs("row-of-5").into_iter().map(|pair| pair.0).collect();
    assert_eq!(names, ["g1+x|g2-x", "g2+x|g3-x", "g3+x|g4-x", "g4+x|g5-x"], "neighbours only");
    let two = pairs("straight-straight");
    assert_eq!(two[0].0, "deck1+x|deck2-x", "one pair");
    assert!((two[0].1 - 0.003).abs() < 1e-16, "3 mm to rounding of 0.193 − 0.19: {}", two[0].1);
}

#[test]
fn the_papers_girders_carry_the_numbers_of_its_tables() {
    // Table 3: β, f_x, h_x; Table 2: frequency and angle of the sine.
    let rows = [
        ("straight-abutment", 90.0, 2.4, 0.29, 2.4, 0.0),
        ("skew60-abutment", 60.0, 2.6, 0.28, 2.6, 0.0),
        ("skew45-abutment", 45.0, 2.6, 0.28, 2.6, 0.0),
        ("straight-straight", 90.0, 2.4, 0.29, 2.4, 22.5),
    ];
    for (name, skew, f, h, sine, angle) in rows {
        let scene = load(name);
        let girder = &scene.girders[0];
        assert_eq!((girder.skew_deg, girder.mass), (skew, 2.0), "{name}");
        assert_eq!((girder.length, girder.width, girder.thickness), (0.190, 0.070, 0.020), "{name}");
        let Some(Bearings::Shared(legs)) = &girder.bearings else { panic!("{name}: four equal legs") };
        assert_eq!((legs.frequency_hz, legs.damping_ratio), (PerDirection::Both(f), PerDirection::Both(h)), "{name}");
        let Motion::Sine(motion) = &scene.motion else { panic!("{name}: a sine") };
        assert_eq!((motion.frequency_hz, motion.angle_deg), (sine, angle), "{name}");
        assert_eq!(motion.amplitude_si(), 0.40 * 9.80665, "{name}: 0.40 g");
        let contact = &scene.contact;
        assert_eq!((contact.stiffness, contact.law), (Some(1.55e5), FrictionLaw::Paper), "{name}: (69a)");
        assert_eq!((contact.restitution_normal, contact.restitution_tangential), (0.4, 0.9), "{name}: section 8");
        assert_eq!((contact.mu_static, contact.mu_kinetic), (0.20, 0.15), "{name}: section 8");
    }
}

#[test]
fn assumed_values_are_marked_as_assumed() {
    for name in ["straight-abutment", "skew60-abutment", "skew45-abutment", "straight-straight"] {
        let text = presets::get(name).map_or("", |preset| preset.text);
        assert!(text.matches("ASSUMED").count() >= 2, "{name}: gap and legs");
    }
}

#[test]
fn an_unknown_preset_is_answered_with_the_names_there_are() {
    let errors = presets::load("skew45-abutmnt").expect_err("no such preset");
    let words = errors.to_string();
    assert!(words.contains("did you mean `skew45-abutment`?") && words.contains("row-of-5"), "{words}");
}

#[test]
fn presets_and_lessons_lie_inside_the_domain() {
    let lessons = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/lessons");
    let mut scenes: Vec<Scene> = presets::all().iter().map(|preset| load(preset.name)).collect();
    for entry in std::fs::read_dir(lessons).expect("the lessons' folder") {
        let path = entry.expect("an entry").path();
        if !path.to_string_lossy().ends_with(".lesson.toml") {
            let text = std::fs::read_to_string(&path).expect("a lesson's scene");
            scenes.push(format::parse(&text, "lesson").unwrap_or_else(|errors| panic!("{errors}")));
        }
    }
    assert!(scenes.len() > 10, "all of them: {}", scenes.len());
    for scene in scenes {
        assert_eq!(domain::outside(&scene), [], "{}", scene.name);
    }
}
