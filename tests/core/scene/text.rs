//! Saving a scene into the text that it was read from: comments, order and spelling stay where nothing has changed.

use girderbench::geometry::End;
use girderbench::scene::{Bearing, Bearings, Limits, Motion, PairSettings, PerDirection, PlotSettings, Scene};
use girderbench::scene::{format, overrides, presets};
use girderbench::study::stability::family;

const MINE: &str = r#"# Two decks before a wall.
format = 1
name = "mine"       # as on the drawing
duration_s = 1e1
kind = "planar"

# The wall comes first here.
[[abutment]]
name = "wall"
faces = "east"
gap_m = 5e-2        # measured

# East of the pier.
[[girder]]
mass_kg = 600e3     # with its surfacing
name = "east"
length_m = 30.0
width_m = 10.0
thickness_m = 1.5
position_m = [0, 0.0, 0.00]   # where it was built
bearings = { frequency_hz = 0.9, damping_ratio = 0.1, at_m = [
    [14.0, 4.0],    # north
    [-14.0, -4.0],  # south
] }

# West of the pier.
[[girder]]
name = "west"
length_m = 30.0
width_m = 10.0
thickness_m = 1.5
mass_kg = 600e3
position_m = [-30.05, 0.0, 0.0]
initial.spin_deg_s = 0.1      # dotted
[girder.bearings]             # under a header
frequency_hz = 1.3
damping_ratio = [0.1, 0.1]
at_skewed_m = [[0.0, 0.0]]

# Numbers of the joint.
[contact]
restitution_normal = 0.40
# Measured on site.
mu_static = 0.30
mu_kinetic = 0.150

[[contact.pair]]    # the pier
between = ["east", "west"]
law = "paper"

[view]
camera = "top"      # from above
# The end.
"#;

fn parsed(text: &str) -> Scene {
    format::parse(text, "mine").unwrap_or_else(|errors| panic!("{errors}\n{text}"))
}

/// The text after a change of the scene; it reads as that scene.
fn after(change: impl FnOnce(&mut Scene)) -> String {
    let mut scene = parsed(MINE);
    change(&mut scene);
    let text = format::update(MINE, &scene);
    assert_eq!(parsed(&text), scene, "{text}");
    text
}

fn set(setting: &str) -> String {
    after(|scene| *scene = overrides::apply(scene, setting).unwrap_or_else(|errors| panic!("{errors}")))
}

/// The text with one piece replaced.
fn with(from: &str, to: &str) -> String {
    assert_eq!(MINE.matches(from).count(), 1, "{from} stands once");
    MINE.replacen(from, to, 1)
}

#[test]
fn an_unchanged_scene_leaves_every_byte() {
    let texts = presets::all().iter().map(|preset| preset.text).chain([MINE]);
    for text in texts {
        assert_eq!(format::update(text, &parsed(text)), text, "as it was");
        let windows = text.replace('\n', "\r\n");
        assert_eq!(format::update(&windows, &parsed(&windows)), windows, "with its line ends");
    }
}

#[test]
fn a_changed_value_changes_its_own_place_only() {
    let cases = [
        ("duration_s=12", "duration_s = 1e1", "duration_s = 12.0"),
        ("name=ours", "name = \"mine\" ", "name = \"ours\" "),
        ("girder.east.mass_kg=5e5", "mass_kg = 600e3     #", "mass_kg = 500000.0     #"),
        ("girder.east.position_m.1=2", "[0, 0.0, 0.00]", "[0, 2.0, 0.00]"),
        ("girder.east.bearings.frequency_hz=1.25", "frequency_hz = 0.9,", "frequency_hz = 1.25,"),
        ("girder.east.bearings.frequency_hz=[1, 2]", "frequency_hz = 0.9,", "frequency_hz = [1.0, 2.0],"),
        ("girder.west.bearings.damping_ratio.1=0.2", "[0.1, 0.1]", "[0.1, 0.2]"),
        ("girder.west.initial.spin_deg_s=0", "spin_deg_s = 0.1 ", "spin_deg_s = 0.0 "),
        ("abutment.wall.gap_m=0.04", "gap_m = 5e-2", "gap_m = 0.04"),
        ("contact.mu_static=0.25", "mu_static = 0.30", "mu_static = 0.25"),
        ("contact.pair.0.law=return-mapping", "law = \"paper\"", "law = \"return-mapping\""),
        // Its default is not written in a new file; here it stands.
        ("view.camera=iso", "camera = \"top\"", "camera = \"iso\""),
    ];
    for (setting, from, to) in cases {
        assert_eq!(set(setting), with(from, to), "{setting}");
    }
    let windows = MINE.replace('\n', "\r\n");
    let mut scene = parsed(&windows);
    scene.contact.mu_static = 0.25;
    let expected = with("mu_static = 0.30", "mu_static = 0.25").replace('\n', "\r\n");
    assert_eq!(format::update(&windows, &scene), expected, "with its line ends");
}

#[test]
fn a_new_key_comes_where_the_documentation_lists_it() {
    let cases = [
        ("description=two decks", "# as on the drawing\n", "# as on the drawing\ndescription = \"two decks\"\n"),
        ("contact.restitution_tangential=0.8", "= 0.40\n", "= 0.40\nrestitution_tangential = 0.8\n"),
        ("girder.west.initial.rotation_deg=3", "initial.spin", "initial.rotation_deg = 3.0\ninitial.spin"),
        ("girder.west.push.moment_n_m=7", "[girder.bearings] ", "push = { moment_n_m = 7.0 }\n[girder.bearings] "),
        ("girder.west.bearings.vertical_frequency_hz=9", "[[0.0", "[[0.0"),
        ("view.overlays.grid=false", "# from above\n", "# from above\n\n[view.overlays]\ngrid = false\n"),
        ("solver.tolerance=1e-9", "\n[view]", "\n[solver]\ntolerance = 1e-9\n\n[view]"),
        ("limits.drift_m=0.1", "\n[view]", "\n[limits]\ndrift_m = 0.1\n\n[view]"),
    ];
    for (setting, from, to) in cases {
        let expected = if from == to {
            with("damping_ratio = [0.1, 0.1]\n", "damping_ratio = [0.1, 0.1]\nvertical_frequency_hz = 9.0\n")
        } else {
            with(from, to)
        };
        assert_eq!(set(setting), expected, "{setting}");
    }
    let text = set("ground=[{ name = \"bank\", kind = \"sine\", amplitude_g = 0.4, frequency_hz = 2 }]");
    let ground = "\n[[ground]]\nname = \"bank\"\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 2.0\nphase_deg = 0.0\nangle_deg = 0.0\n";
    assert_eq!(text, with("\n[view]", &format!("{ground}\n[view]")), "a named ground in the documented order");
    let text = set("girder.east.bearings.vertical_frequency_hz=9");
    assert!(text.contains("0.1, vertical_frequency_hz = 9.0, at_m = ["), "in braces, where it belongs: {text}");
    assert!(text.contains("# north") && text.contains("# south"), "with its comments: {text}");
    let text = set("motion={kind=\"sine\", amplitude_g=0.4, frequency_hz=2}");
    let table =
        "\n[motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 2.0\nphase_deg = 0.0\nangle_deg = 0.0\n";
    assert_eq!(text, with("\n[view]", &format!("{table}\n[view]")), "a whole table in the documented order");
}

#[test]
fn what_is_removed_takes_its_comments_with_it() {
    let text = after(|scene| scene.contact.pairs.clear());
    assert_eq!(text, with("\n[[contact.pair]]    # the pier\nbetween = [\"east\", \"west\"]\nlaw = \"paper\"\n", ""));
    let limited = format!("{MINE}\n# Of the joint.\n[limits]\ndrift_m = 0.1\n");
    let mut scene = parsed(&limited);
    scene.limits = Limits::default();
    assert!(!format::update(&limited, &scene).contains("[limits]"), "the whole table");
    let text = after(|scene| drop(scene.girders.remove(1)));
    assert!(!text.contains("# West") && !text.contains("under a header"), "the girder with its bearings: {text}");
    assert!(text.contains("# East of the pier.\n[[girder]]\nmass_kg = 600e3     # with its surfacing"), "{text}");
}

#[test]
fn girders_come_go_and_change_places_with_their_comments() {
    let text = after(|scene| scene.girders.swap(0, 1));
    let [west, east] = ["# West of the pier.", "# East of the pier."].map(|c| text.find(c).expect(c));
    assert!(west < east, "in the new order: {text}");
    assert!(text.contains("[girder.bearings]             # under a header\nfrequency_hz = 1.3"), "{text}");

    for at in 0..=2 {
        let text = after(|scene| {
            let mut new = scene.girders[1].clone();
            (new.name, new.position[1], new.heading_deg) = ("new".into(), 50.0, 15.0);
            scene.girders.insert(at, new);
        });
        let new = "\n[[girder]]\nname = \"new\"\nlength_m = 30.0\n";
        assert!(text.contains(new), "a girder of its own at {at}: {text}");
        assert_eq!(text.matches('#').count(), MINE.matches('#').count(), "every comment once: {text}");
        assert!(text.contains("initial = { displacement_m = [0.0, 0.0], "), "its tables on one line: {text}");
    }

    let text = after(|scene| {
        scene.girders[0].name = "E1".into();
        scene.abutments[0].faces = "E1".into();
        scene.contact.pairs[0].between[0] = "E1".into();
    });
    let renamed = MINE.replace("\"east\"", "\"E1\"");
    assert_eq!(text, renamed, "a new name is a changed value");

    let text = after(|scene| {
        let mut second = scene.abutments[0].clone();
        (second.name, second.faces, second.end) = ("far".into(), "west".into(), End::Minus);
        scene.abutments.insert(0, second);
    });
    assert!(text.find("name = \"far\"") < text.find("name = \"wall\""), "{text}");
}

#[test]
fn lists_and_tables_change_their_shape() {
    let single = Bearing::linear([0.0, 0.0], [1e7, 1e7, 0.0], [0.0; 3]);
    for girder in [0, 1] {
        let text = after(|scene| scene.girders[girder].bearings = Some(Bearings::Each(vec![single.clone(); 2])));
        assert!(text.contains("bearings = [{ at_m = [0.0, 0.0], stiffness_n_per_m"), "{text}");
        after(|scene| scene.girders[girder].bearings = None);
    }
    let places = |change: &dyn Fn(&mut Vec<[f64; 2]>)| {
        after(|scene| {
            let Some(Bearings::Shared(shared)) = &mut scene.girders[0].bearings else { panic!("shared") };
            change(shared.at.as_mut().expect("given"));
        })
    };
    let south = "    [-14.0, -4.0],  # south\n";
    assert_eq!(places(&|at| at.push([1.0, 2.0])), with(south, &format!("{south}    [1.0, 2.0],\n")), "one more");
    assert_eq!(places(&|at| at.truncate(1)), with(south, ""), "one less");
    let inline = "name = \"i\"\nduration_s = 1\ngirder = [{ name = \"a\", length_m = 2, width_m = 1, thickness_m = 1, mass_kg = 5 }]\nview.camera = \"top\"\ncontact.mu_static = 0.3 # dotted\n";
    let mut scene = parsed(inline);
    scene.girders.push(scene.girders[0].clone());
    scene.girders[1].name = "b".into();
    scene.girders[0].heading_deg = 90.0;
    scene.view.plots.push(PlotSettings::over_time(vec!["a.x".into()]));
    scene.view.overlays.grid = false;
    let pair = "between = [\"a\", \"b\"]\nmu_kinetic = 0.1\n";
    scene.contact.pairs.push(toml::from_str::<PairSettings>(pair).expect("a pair"));
    let text = format::update(inline, &scene);
    assert_eq!(parsed(&text), scene, "{text}");
    for kept in ["length_m = 2, width_m", "# dotted", "view.camera = \"top\"", "contact.pair = [{ between"] {
        assert!(text.contains(kept), "{kept}: {text}");
    }
}

#[test]
fn a_text_that_is_no_scene_is_written_anew() {
    let scene = parsed(MINE);
    for text in ["", "not = [toml", "format = 2\n", "girder = 1\n"] {
        assert_eq!(format::update(text, &scene), format::write(&scene), "{text}");
    }
}

/// A comment in every line of a text without lines of its own inside values.
fn commented(text: &str) -> String {
    text.lines().map(|line| if line.is_empty() { "\n".into() } else { format!("{line} # kept\n") }).collect()
}

#[test]
fn any_scene_can_be_written_into_the_text_of_any_other() {
    let scenes: Vec<Scene> = (0..60).map(|seed| family::scene(seed).1).collect();
    for (n, scene) in scenes.iter().enumerate() {
        let text = commented(&format::write(scene));
        assert_eq!(format::update(&text, scene), text, "seed {n}: unchanged");
        let mut mixed = scene.clone();
        mixed.girders.rotate_left(1);
        mixed.contact.pairs.clear();
        mixed.motion = Motion::None;
        mixed.girders.iter_mut().step_by(2).for_each(|girder| girder.mass *= 1.5);
        if let Some(Bearings::Shared(shared)) = &mut mixed.girders[0].bearings {
            shared.frequency_hz = PerDirection::Each([1.0, 2.0]);
        }
        for (other, to) in
            [(n, &mixed), (n + 1, &scenes[(n + 1) % scenes.len()]), (n + 7, &scenes[(n + 7) % scenes.len()])]
        {
            let written = format::update(&text, to);
            assert_eq!(parsed(&written), *to, "seed {n} becomes {other}:\n{written}");
            assert!(
                written.starts_with("format = 1 # kept\nname = "),
                "seed {n} becomes {other}: into its text\n{written}"
            );
        }
    }
}
