//! Who faces whom: found by itself, declared, and with which numbers.

use girderbench::scene::facing::{self, Facing};
use girderbench::scene::{FrictionLaw, Scene, Sharing, Tension, format, overrides, presets};
use girderbench::sim::History;

/// Girders of 30 × 10 × 1.5 m: name, skew, heading, position.
fn scene(girders: &[(&str, f64, f64, [f64; 3])], rest: &str) -> Scene {
    let mut text = "name = \"s\"\nduration_s = 1\n".to_owned();
    for (name, skew, heading, position) in girders {
        let girder = format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 30\nwidth_m = 10\nthickness_m = 1.5\nmass_kg = 6e5\n\
             skew_deg = {skew}\nheading_deg = {heading}\nposition_m = {position:?}\n"
        );
        text.push_str(&girder);
    }
    format::parse(&(text + rest), "s").unwrap_or_else(|errors| panic!("{errors}"))
}

fn find(scene: &Scene) -> Vec<Facing> {
    facing::find(scene).unwrap_or_else(|errors| panic!("{errors}"))
}

fn names(scene: &Scene) -> Vec<String> {
    find(scene).into_iter().map(|pair| pair.name).collect()
}

/// Two girders, the second one displaced from 50 mm ahead of the first, turned about its near end.
fn two(ahead: f64, beside: f64, above: f64, turned_deg: f64) -> Vec<String> {
    let (sin, cos) = turned_deg.to_radians().sin_cos();
    let place = [15.05 + ahead + 15.0 * cos, beside + 15.0 * sin, above];
    names(&scene(&[("a", 90.0, 0.0, [0.0; 3]), ("b", 90.0, turned_deg, place)], ""))
}

#[test]
fn ends_face_each_other_while_they_look_at_each_other() {
    let pair = ["a+x|b-x"];
    assert_eq!(two(0.0, 0.0, 0.0, 0.0), pair, "in line");
    assert_eq!(two(40.0, 0.0, 0.0, 0.0), pair, "far away");
    assert_eq!(two(1.0, 0.0, 0.0, 29.9), pair, "turned by less than 30°");
    assert!(two(1.0, 0.0, 0.0, 30.1).is_empty(), "turned by more than 30°");
    assert_eq!(two(0.0, 9.9, 0.0, 0.0), pair, "beside by less than the mean end length");
    assert!(two(0.0, 10.1, 0.0, 0.0).is_empty(), "beside by more");
    assert_eq!(two(0.0, 0.0, 1.4, 0.0), pair, "heights overlap");
    assert!(two(0.0, 0.0, 1.6, 0.0).is_empty(), "one passes over the other");
    assert_eq!(two(-0.05, 0.0, 0.0, 0.0), pair, "touching");
    assert!(two(-1.0, 0.0, 0.0, 0.0).is_empty(), "not in front any more");
    assert_eq!(two(1.0, 0.0, 0.0, 180.0 + 5.0).len(), 0, "turned about its near end it lies over the first");
}

#[test]
fn a_girder_turned_round_shows_its_other_end() {
    let turned = scene(&[("a", 90.0, 0.0, [0.0; 3]), ("b", 90.0, 180.0, [30.1, 0.0, 0.0])], "");
    assert_eq!(names(&turned), ["a+x|b+x"], "both plus ends");
}

#[test]
fn skewed_ends_face_each_other_when_they_are_parallel() {
    let line = |skew: f64| names(&scene(&[("a", 60.0, 0.0, [0.0; 3]), ("b", skew, 0.0, [30.1, 0.0, 0.0])], ""));
    assert_eq!(line(60.0), ["a+x|b-x"], "the same skew");
    assert!(line(120.0).is_empty(), "the mirrored skew: 60° between the faces");
}

#[test]
fn neighbours_only_and_whatever_the_order_in_the_file() {
    let at = |name, n: i32| (name, 75.0, 0.0, [30.1 * f64::from(n), 0.0, 0.0]);
    let forward = scene(&[at("a", 0), at("b", 1), at("c", 2), at("d", 3)], "");
    assert_eq!(names(&forward), ["a+x|b-x", "b+x|c-x", "c+x|d-x"], "neighbours");
    let shuffled = scene(&[at("c", 2), at("a", 0), at("d", 3), at("b", 1)], "");
    assert_eq!(names(&shuffled), ["c+x|d-x", "c-x|b+x", "a+x|b-x"], "the same pairs, the first of the file first");
}

#[test]
fn a_scene_turned_as_a_whole_has_the_same_pairs_and_gaps() {
    let turned = |angle: f64| {
        let (sin, cos) = if angle == 90.0 { (1.0, 0.0) } else { angle.to_radians().sin_cos() };
        let b = [30.1 * cos, 30.1 * sin, 0.0];
        let wall = "[[abutment]]\nname = \"w\"\nfaces = \"b\"\ngap_m = 0.07\n";
        find(&scene(&[("a", 65.0, angle, [0.0; 3]), ("b", 65.0, angle, b)], wall))
    };
    let straight = turned(0.0);
    assert_eq!(straight.len(), 2, "a pair and a wall");
    for angle in [37.0, 90.0, -120.0] {
        for (here, there) in straight.iter().zip(turned(angle)) {
            assert_eq!((&here.name, here.second), (&there.name, there.second), "{angle}°");
            // Rounding of places 30 m away.
            assert!((here.gap - there.gap).abs() < 1e-14 * 30.0, "{angle}°: {} and {}", here.gap, there.gap);
        }
    }
}

#[test]
fn the_gap_is_measured_along_the_first_girders_axis() {
    // Two girders of 60° skew, the second also 2 m to the side: the planes' distance along the axis changes by 2 cot 60°.
    let beside = find(&scene(&[("a", 60.0, 0.0, [0.0; 3]), ("b", 60.0, 0.0, [31.5, 2.0, 0.0])], ""));
    let expected = 1.5 - 2.0 / 60.0_f64.to_radians().tan();
    assert!((beside[0].gap - expected).abs() < 1e-14, "{} for {expected}", beside[0].gap);
    let corners = "polygon_m = [[16, 9, -2], [16, -9, -2], [16, -9, 2], [16, 9, 2]]\n";
    let wall =
        find(&scene(&[("a", 90.0, 0.0, [0.0; 3])], &format!("[[abutment]]\nname = \"w\"\nfaces = \"a\"\n{corners}")));
    assert_eq!(wall[0].gap, 1.0, "a wall given by its corners");
}

#[test]
fn a_wall_between_two_girders_parts_them() {
    let wall = |gap: f64| format!("[[abutment]]\nname = \"w\"\nfaces = \"a\"\ngap_m = {gap}\ndepth_m = 0.1\n");
    let girders = [("a", 90.0, 0.0, [0.0; 3]), ("b", 90.0, 0.0, [32.0, 0.0, 0.0])];
    assert_eq!(names(&scene(&girders, &wall(0.05))), ["a+x|w"], "the wall stands nearer");
}

#[test]
fn a_pair_can_be_declared() {
    let girders = [("a", 90.0, 0.0, [0.0; 3]), ("b", 90.0, 40.0, [28.0, 12.0, 0.0])];
    let declared = "[[contact.pair]]\nbetween = [\"b\", \"a\"]\nends = [\"-x\", \"+x\"]\nmu_static = 0.6\n";
    let pairs = find(&scene(&girders, declared));
    assert_eq!(pairs.len(), 1, "40° apart: not found by itself");
    assert_eq!(pairs[0].name, "a+x|b-x", "the girder that comes first in the file is first");
    assert_eq!(pairs[0].contact.mu_static, 0.6, "and brings its numbers");
    let wall = "[[abutment]]\nname = \"w\"\nfaces = \"a\"\ngap_m = 0.05\n";
    let both = format!("{wall}[[contact.pair]]\nbetween = [\"w\", \"b\"]\nends = [\"+x\", \"+x\"]\n");
    assert_eq!(names(&scene(&girders, &both)), ["a+x|w", "b+x|w"], "a wall may be struck by two");
    let again = format!("{wall}[[contact.pair]]\nbetween = [\"w\", \"a\"]\nends = [\"+x\", \"+x\"]\n");
    assert_eq!(names(&scene(&girders, &again)), ["a+x|w"], "declaring what is found adds nothing");
}

#[test]
fn overrides_apply_to_the_pair_they_name_and_no_other() {
    let settings = "[contact]\nstiffness_n_per_m = 1e9\nrestitution_normal = 0.3\n\
        [[contact.pair]]\nbetween = [\"b\", \"a\"]\nrestitution_normal = 0.5\nlaw = \"paper\"\nsharing = \"per-node\"\ntension = \"clamp\"\n\
        [[contact.pair]]\nbetween = [\"b\", \"c\"]\nends = [\"-x\", \"+x\"]\nmu_kinetic = 0.01\n";
    let at = |name, n: i32| (name, 90.0, 0.0, [30.1 * f64::from(n), 0.0, 0.0]);
    let pairs = facing::find(&scene(&[at("a", 0), at("b", 1), at("c", 2)], settings));
    // b−x and c+x do not face each other: the entry declares that pair, and is not about b+x and c−x.
    let pairs = pairs.unwrap_or_else(|errors| panic!("{errors}"));
    let ab = &pairs[0].contact;
    assert_eq!((ab.restitution_normal, ab.law), (0.5, FrictionLaw::Paper), "named in either order");
    assert_eq!((ab.sharing, ab.tension, ab.stiffness), (Sharing::PerNode, Tension::Clamp, 1e9), "key by key");
    let bc = &pairs[1];
    assert_eq!(
        (bc.name.as_str(), bc.contact.mu_kinetic, bc.contact.restitution_normal),
        ("b+x|c-x", 0.15, 0.3),
        "not meant"
    );
    assert_eq!((pairs[2].name.as_str(), pairs[2].contact.mu_kinetic), ("b-x|c+x", 0.01), "declared");
}

#[test]
fn stiffness_is_given_or_e_a_over_l_of_the_softer_girder() {
    let stiffness = |settings: &[&str]| {
        let scene = presets::load("row-of-5").unwrap_or_else(|errors| panic!("{errors}"));
        let scene = overrides::apply_all(&scene, settings).unwrap_or_else(|errors| panic!("{errors}"));
        find(&scene)[0].contact.stiffness
    };
    assert_eq!(stiffness(&[]), 1e9, "given");
    let e = "contact.young_modulus_pa=2e10";
    assert_eq!(stiffness(&[e]), 2e10 * 15.0 / 30.0, "E A / L with the end section (64)");
    assert_eq!(stiffness(&[e, "contact.area_m2=3"]), 2e10 * 3.0 / 30.0, "A given");
    assert_eq!(stiffness(&[e, "girder.g2.length_m=29"]), 2e10 * 15.0 / 30.0, "the smaller of the two");
    assert_eq!(stiffness(&[e, "girder.g2.width_m=6"]), 2e10 * 9.0 / 30.0, "the smaller of the two");
    let pair = "contact.pair=[{ between = [\"g1\", \"g2\"], young_modulus_pa = 1e10 }]";
    assert_eq!(stiffness(&[pair]), 1e10 * 15.0 / 30.0, "a pair's E, whatever K the others have");
    assert_eq!(
        stiffness(&["contact.area_m2=15"]),
        girderbench::scene::CONCRETE_MODULUS * 15.0 / 30.0,
        "concrete by default"
    );
}

/// A pair's sides are in the order of its bodies, girders before abutments, wherever these stand and whichever was declared first:
/// pairs of two bodies that have met are looked up by it.
#[test]
fn girders_come_before_abutments_and_by_number_in_every_pair_wherever_they_stand() {
    let wall = |gap: f64| format!("[[abutment]]\nname = \"w\"\nfaces = \"a\"\ngap_m = {gap}\n");
    let alone = scene(&[("a", 90.0, 0.0, [0.0; 3])], &wall(0.05));
    let behind = scene(&[("a", 90.0, 0.0, [30.1, 0.0, 0.0]), ("b", 90.0, 0.0, [0.0; 3])], &wall(0.05));
    let turned = scene(&[("a", 90.0, 180.0, [30.1, 0.0, 0.0]), ("b", 90.0, 180.0, [0.0; 3])], "");
    let shipped =
        presets::all().iter().map(|preset| presets::load(preset.name).unwrap_or_else(|errors| panic!("{errors}")));
    for scene in [alone, behind, turned].into_iter().chain(shipped) {
        let pairs = find(&scene);
        assert!(!pairs.is_empty(), "{}", scene.name);
        for pair in pairs {
            let [first, second] = [pair.first.solid(), pair.second.solid()];
            assert!(first < second, "{}, {}: {first:?} and {second:?}", scene.name, pair.name);
        }
    }
}

/// Sideways is along either face: whom an end faces does not depend on which girder is the first in the file.
#[test]
fn two_ends_face_each_other_in_either_order_and_in_the_mirror_image() {
    let girder = |skew: f64, heading: f64, place: [f64; 3]| move |name| (name, skew, heading, place);
    for turned in [0.0, 10.0, 20.0, 29.0] {
        for (ahead, beside) in [(2.0, 0.0), (2.0, 6.0), (2.0, -6.0), (2.0, 9.0), (2.0, 11.0), (5.0, 13.0), (9.0, -12.0)]
        {
            let (sin, cos) = f64::to_radians(turned).sin_cos();
            let one = girder(90.0, 0.0, [0.0; 3]);
            let other =
                |side: f64| girder(90.0, side * turned, [15.0 + ahead + 15.0 * cos, side * (beside + 15.0 * sin), 0.0]);
            let faces = |first: bool, side: f64| {
                let both = if first { [one("a"), other(side)("b")] } else { [other(side)("b"), one("a")] };
                !names(&scene(&both, "")).is_empty()
            };
            let all = [faces(true, 1.0), faces(false, 1.0), faces(true, -1.0), faces(false, -1.0)];
            assert!(all.iter().all(|is| *is == all[0]), "{turned}°, {ahead} m ahead, {beside} m beside: {all:?}");
        }
    }
    for heading in [0.0, 37.0, 90.0, 180.0, -143.0] {
        let (sin, cos) = f64::to_radians(heading).sin_cos();
        let before = |skew: f64| {
            names(&scene(&[("a", skew, heading, [0.0; 3]), ("b", 90.0, heading, [40.0 * cos, 40.0 * sin, 0.0])], ""))
        };
        assert_eq!(before(60.0), before(120.0), "turned by 30° on either hand, heading {heading}°");
        assert_eq!(before(60.0).len(), 1, "30° are within 30°");
    }
}

#[test]
fn pairs_of_bodies_that_have_met_are_in_the_same_order() {
    let decks = scene(&[("a", 90.0, 0.0, [0.0, 10.2, 0.0]), ("b", 90.0, 0.0, [0.0; 3])], "");
    let thrown = overrides::apply_all(&decks, &["girder.a.initial.velocity_m_s=[0.0,-1.0]"]);
    let scene = thrown.unwrap_or_else(|errors| panic!("{errors}"));
    let history = History::of(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    let met: Vec<_> = history.model().pairs.iter().filter(|pair| pair.met).collect();
    assert!(!met.is_empty(), "side by side, 0.2 m apart");
    for pair in met {
        assert!(pair.first.solid() < pair.second.solid(), "{}", pair.name);
    }
}
