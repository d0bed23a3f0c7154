//! Overlaps that no contact carries, through the real solver: seen when they begin and as deep as they are, by closed forms;
//! and none where contacts carry all.

use std::f64::consts::{FRAC_PI_4, PI, SQRT_2};

use girderbench::dynamics::Model;
use girderbench::scene::{Between, ModelKind, presets};
use girderbench::sim::{History, Overlap, SolidId, unjoined};
use glam::DVec3;

use crate::support::{run, scene, within};

const GIRDER: &str = "length_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = 2.0\n";

/// Two girders without bearings, the second of which moves as its keys say.
fn two(second: &str, duration: f64) -> History {
    let text = format!(
        "name = \"two\"\nduration_s = {duration}\n[contact]\nbetween = \"ends\"\n[[girder]]\nname = \"one\"\n{GIRDER}[[girder]]\nname = \"two\"\n{GIRDER}{second}"
    );
    History::of(&scene(&text)).expect("it runs")
}

fn only(history: &History) -> Overlap {
    let [overlap] = history.overlaps() else { panic!("one overlap: {:?}", history.overlaps()) };
    assert_eq!(overlap.bodies, [SolidId::Girder(0), SolidId::Girder(1)], "the two girders");
    overlap.clone()
}

#[test]
fn a_girder_that_goes_into_anothers_side_is_seen_when_it_enters_and_as_deep_as_it_gets() {
    // 0.09 m from centre to centre, 0.02 m apart, closing at 1 m/s.
    let history = two("position_m = [0.0, 0.09, 0.0]\ninitial = { velocity_m_s = [0, -1] }\n", 0.05);
    let overlap = only(&history);
    within("first seen", overlap.first() - (0.02 + 1e-6 * 0.07), 1e-9);
    within("depth", overlap.depth.value - 0.03, 1e-12);
    within("deepest at the end", overlap.depth.t - 0.05, 1e-9);
    // Shared: from y = 0.005 to 0.035, as long as the girders.
    assert!(overlap.place.distance(DVec3::new(0.0, 0.02, 0.0)) < 1e-12, "{overlap:?}");
}

#[test]
fn an_end_that_meets_a_side_is_seen() {
    // A T: the second girder points at the middle of the first one's side, 0.03 m away.
    let history = two("position_m = [0.0, 0.16, 0.0]\nheading_deg = 90\ninitial = { velocity_m_s = [0, -0.5] }\n", 0.1);
    let overlap = only(&history);
    within("first seen", overlap.first() - 0.06, 1e-6);
    within("depth", overlap.depth.value - 0.02, 1e-12);
}

#[test]
fn a_girder_beside_its_wall_that_goes_into_the_walls_flank_is_seen_under_either_model() {
    // Its end is 0.04 m behind the front of a wall 0.02 m wide, 0.015 m beside it; it goes 0.01 m in.
    for kind in ["contact", "impact"] {
        let history = run(&scene(&format!(
            "name = \"beside\"\nduration_s = 0.05\n[model]\nkind = \"{kind}\"\n[contact]\nbetween = \"ends\"\n[[girder]]\nname = \
             \"one\"\n{GIRDER}initial = {{ displacement_m = [0.05, 0.06], velocity_m_s = [0.0, -0.5] }}\n[[abutment]]\nname = \
             \"wall\"\nfaces = \"one\"\nend = \"+x\"\ngap_m = 0.01\nwidth_m = 0.02\n"
        )));
        let [overlap] = history.overlaps() else { panic!("{kind}: one overlap: {:?}", history.overlaps()) };
        within(&format!("{kind}: first seen"), overlap.first() - 0.03, 1e-6);
        within(&format!("{kind}: depth"), overlap.depth.value - 0.01, 1e-12);
    }
}

#[test]
fn a_corner_that_turns_into_a_side_is_seen() {
    // Turned by 45° the second girder's lowest corner is at its centre's height less (0.19 + 0.07)/(2 √2).
    let reach = (0.19 + 0.07) / (2.0 * SQRT_2);
    let lateral = 0.035 + reach - 0.01;
    let spin = 2.0;
    let keys = format!("position_m = [0.0, {lateral}, 0.0]\ninitial = {{ spin_deg_s = {} }}\n", f64::to_degrees(spin));
    let overlap = only(&two(&keys, FRAC_PI_4 / spin));
    // The corner is at (0.095, −0.035) in the girder's axes, 0.10124 m from G: lowest at an angle of −90°.
    let (arm, angle) = (0.095_f64.hypot(0.035), (-0.035_f64).atan2(-0.095));
    let height = |t: f64| lateral + arm * (angle + spin * t).sin() - 0.035;
    assert!(height(overlap.first()).abs() < 1e-6 * 0.07 + 1e-9, "{} at {}", height(overlap.first()), overlap.first());
    assert!(height(overlap.first() - 1e-5) > 0.0, "it is the first");
    within("depth", overlap.depth.value - 0.01, 1e-9);
}

#[test]
fn a_girder_that_goes_through_another_in_one_long_flight_is_seen() {
    // 2.93 m away at 20 m/s: 7 ms inside, in a flight of 10 s.
    let history = two("position_m = [0.0, 3.0, 0.0]\ninitial = { velocity_m_s = [0, -20] }\n", 10.0);
    let overlap = only(&history);
    let [[from, until]] = overlap.intervals[..] else { panic!("one interval: {overlap:?}") };
    within("entered", from - 2.93 / 20.0, 1e-8);
    within("left", until - 3.07 / 20.0, 1e-8);
}

#[test]
fn girders_that_pass_at_a_distance_do_not_overlap() {
    let past = two("position_m = [-1.0, 0.0701, 0.0]\ninitial = { velocity_m_s = [2, 0] }\n", 1.0);
    assert_eq!(past.overlaps(), [], "0.1 mm apart all the way");
}

#[test]
fn in_space_an_edge_that_meets_an_edge_is_seen() {
    // Side by side, the second girder 5 mm higher: it comes at 1 m/s from 0.02 m beside the first, and the way out is upwards
    // once it is 0.015 m inside.
    let text = format!(
        "name = \"beside\"\nkind = \"spatial\"\ngravity_m_s2 = 0.0\nduration_s = 0.05\n[contact]\nbetween = \"ends\"\n\
         [[girder]]\nname = \"one\"\n{GIRDER}[[girder]]\nname = \"two\"\n{GIRDER}position_m = [0.0, 0.09, 0.005]\n\
         initial = {{ velocity_m_s = [0, -1] }}\n"
    );
    let history = History::of(&scene(&text)).expect("it runs");
    let overlap = only(&history);
    within("first seen", overlap.first() - 0.02, 1e-6);
    within("depth", overlap.depth.value - 0.015, 1e-12);
}

#[test]
fn an_overlap_lasts_until_the_bodies_are_apart_again() {
    // Straight through, across: 0.07 m wide each, 0.02 m apart, at 1 m/s.
    let history = two("position_m = [0.0, 0.09, 0.0]\ninitial = { velocity_m_s = [0, -1] }\n", 0.2);
    let overlap = only(&history);
    let [[from, until]] = overlap.intervals[..] else { panic!("one interval: {overlap:?}") };
    within("entered", from - (0.02 + 1e-6 * 0.07), 1e-9);
    within("left", until - (0.02 + 0.14 - 1e-6 * 0.07), 1e-9);
    assert!(overlap.lasts_at(0.1) && !overlap.lasts_at(0.01) && !overlap.lasts_at(0.19), "{overlap:?}");
    within("half way in", overlap.depth_at(&history, 0.055) - 0.035, 1e-12);
}

#[test]
fn bodies_that_can_come_near_without_contact_are_known_before_a_run() {
    // Side by side on bearings of 1 Hz, started so that each swings by 0.1/(2π) m towards the other.
    let bearings = |offset: f64| {
        let girder = |name: &str, lateral: f64, speed: f64| {
            format!(
                "[[girder]]\nname = \"{name}\"\n{GIRDER}position_m = [0, {lateral}, 0]\n\
                 initial = {{ velocity_m_s = [0, {speed}] }}\nbearings = {{ frequency_hz = 1.0, damping_ratio = 0.0, at_m = [[0.05, 0.0], [-0.05, 0.0]] }}\n"
            )
        };
        let text = format!(
            "name = \"twins\"\nduration_s = 1\n{}{}",
            girder("one", 0.0, 0.1),
            girder("two", 0.07 + offset, -0.1)
        );
        let scene = scene(&text);
        unjoined(&scene, &Model::compile(&scene).expect("a scene"))
    };
    let swing = 0.1 / (2.0 * PI);
    let [found] = bearings(0.03)[..] else { panic!("one: {:?}", bearings(0.03)) };
    assert_eq!(found.bodies, [SolidId::Girder(0), SolidId::Girder(1)], "the two girders");
    within("apart", found.apart - 0.03, 1e-12);
    within("reach", found.reach - 2.0 * swing, 1e-9);
    assert_eq!(bearings(2.0 * swing + 1e-6), [], "they do not come near");
    for preset in presets::all() {
        let scene = presets::load(preset.name).expect("a preset");
        assert_eq!(unjoined(&scene, &Model::compile(&scene).expect("a scene")), [], "{}", preset.name);
    }
}

#[test]
fn what_contacts_carry_is_no_overlap() {
    for preset in presets::all() {
        let name = preset.name;
        let mut scene = presets::load(name).expect("a preset");
        for kind in [ModelKind::Contact, ModelKind::Impact] {
            scene.model.kind = kind;
            scene.contact.between = Between::Ends;
            let history = match History::of(&scene) {
                Ok(history) => history,
                Err(errors) => {
                    assert!(kind == ModelKind::Impact && errors.to_string().contains("model.kind"), "{name}: {errors}");
                    continue;
                }
            };
            if (name, kind) == ("row-of-5", ModelKind::Contact) {
                expect_the_corner_of_the_row(&history);
            } else if name == "viaduct-5" {
                // Its decks slide across as well: corners come past the facing ends and in beside them, where no contact is.
                assert!(!history.overlaps().is_empty(), "{name}: said");
            } else {
                assert_eq!(history.overlaps(), [], "{name}, {kind:?}");
            }
            scene.contact.between = Between::All;
            assert_eq!(History::of(&scene).expect("it runs").overlaps(), [], "{name}, {kind:?}: between all faces");
        }
    }
}

/// The corner of g4 crosses the plane of g3's end beside it, and is then 5 mm inside g3: armed contacts alone close.
fn expect_the_corner_of_the_row(history: &History) {
    let [overlap] = history.overlaps() else { panic!("one overlap: {:?}", history.overlaps()) };
    assert_eq!(overlap.bodies.map(|body| body.name(history.scene())), ["g3", "g4"], "which");
    within("first seen", overlap.first() - 1.044, 1e-3);
    within("depth", overlap.depth.value - 5.3e-3, 1e-4);
}

#[test]
fn a_contact_that_is_pressed_too_deep_is_said() {
    // 2 kg at v before a wall, elastic, K = 155 kN/m: the deepest penetration is v √(2 kg/K). A tenth of 70 mm is 7 mm.
    let deepest = |speed: f64| speed * (2.0 / 1.55e5_f64).sqrt();
    let against_the_wall = |speed: f64| {
        let text = format!(
            "name = \"wall\"\nduration_s = 0.05\n[contact]\nrestitution_normal = 1.0\nstiffness_n_per_m = 1.55e5\n\
             [[girder]]\nname = \"deck\"\n{GIRDER}initial = {{ velocity_m_s = [{speed}, 0] }}\n[[abutment]]\n\
             name = \"wall\"\nfaces = \"deck\"\nend = \"+x\"\ngap_m = 0.01\n"
        );
        History::of(&scene(&text)).expect("it runs")
    };
    let [speed, slower] = [2.0, 1.9];
    assert!(deepest(speed) > 7e-3 && deepest(slower) < 7e-3, "on either side of the limit");
    let history = against_the_wall(speed);
    let [deep] = history.contacts().too_deep()[..] else { panic!("one: {:?}", history.contacts().too_deep()) };
    within("depth", deep.depth.value - deepest(speed), 1e-9);
    within("allowed", deep.allowed - 7e-3, 1e-15);
    assert_eq!(against_the_wall(slower).contacts().too_deep(), [], "within the limit");
}

#[test]
fn a_contact_that_leaves_its_face_with_energy_in_its_spring_is_said() {
    let left = |lateral: f64, between: &str| {
        // Pressed against a wall, the girder slides along it and off its end.
        let text = format!(
            "name = \"off\"\nduration_s = 0.2\n[contact]\nbetween = \"{between}\"\nstiffness_n_per_m = 1e6\nmu_static = 0.0\nmu_kinetic = 0.0\n\
             [[girder]]\nname = \"deck\"\n{GIRDER}push = {{ force_n = [200, 0] }}\ninitial = {{ velocity_m_s = [0, {lateral}] }}\n[[abutment]]\n\
             name = \"wall\"\nfaces = \"deck\"\nend = \"+x\"\ngap_m = 0.0\nwidth_m = 0.24\n"
        );
        History::of(&scene(&text)).expect("it runs")
    };
    assert_eq!(left(0.0, "all").contacts().dropped(), None, "it stays before the wall");
    assert_eq!(
        left(1.0, "all").contacts().dropped(),
        None,
        "the wall's corner takes over what the girder's leaves with"
    );
    let history = left(1.0, "ends");
    let dropped = history.contacts().dropped().expect("it leaves the wall");
    within("the ledger's own", dropped.energy - history.energy().ledger(history.end()).jump_edge, 1e-12);
    assert!(dropped.share > 1e-6 && dropped.count > 0, "{dropped:?}");
    assert_eq!(
        history.contacts().too_deep(),
        [],
        "corners at the wall's edge touch its front, not its sides from within"
    );
}

#[test]
fn a_wall_thinner_than_the_girder_is_not_gone_through_in_silence() {
    let deck = "length_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\nmass_kg = 6e5\n";
    // v √(m/K) = 39 mm into a wall of 100 mm, without dashpots.
    let history = run(&scene(&format!(
        "name = \"thin\"\nduration_s = 0.3\n[contact]\nstiffness_n_per_m = 1e8\nrestitution_normal = 1.0\nrestitution_tangential = 1.0\n\
         [[girder]]\nname = \"a\"\n{deck}initial = {{ velocity_m_s = [0.5, 0.0] }}\n\
         [[abutment]]\nname = \"wall\"\nfaces = \"a\"\ngap_m = 0.005\ndepth_m = 0.1\n"
    )));
    let [deep] = &history.contacts().too_deep()[..] else { panic!("{:?}", history.contacts().too_deep()) };
    within("a tenth of its depth", deep.allowed - 0.01, 1e-15);
    within("depth", deep.depth.value / (0.5 * (6e5_f64 / 1e8).sqrt()) - 1.0, 1e-6);
}

/// A spring that takes 0.5 J over the 10 mm of a wall, and a girder of 9 J: its end comes out at the back, where no node is in the wall.
#[test]
fn a_girder_that_reaches_through_a_wall_is_inside_it_although_no_node_is() {
    let between = |between: &str| {
        run(&scene(&format!(
            "name = \"through\"\nduration_s = 1.0\n[contact]\nbetween = \"{between}\"\nstiffness_n_per_m = 1e4\n\
             restitution_normal = 1.0\n[[girder]]\nname = \"a\"\nlength_m = 1.0\nwidth_m = 0.5\nthickness_m = 0.2\n\
             mass_kg = 2.0\ninitial = {{ velocity_m_s = [3.0, 0.0] }}\n\
             [[abutment]]\nname = \"wall\"\nfaces = \"a\"\ngap_m = 0.5\ndepth_m = 0.01\n"
        )))
    };
    let history = between("ends");
    let [overlap] = history.overlaps() else { panic!("{:?}", history.overlaps()) };
    // The end is at the back after 0.51 m at 3 m/s, pressed back a little.
    assert!((overlap.first() - 0.17).abs() < 1e-3, "{} s", overlap.first());
    // Half of the girder's length and of the wall's thickness is the shortest way out at the most.
    within("depth", overlap.depth.value - 0.505, 1e-2);
    // Bodies that have met have contact between all faces: v √(m/K) deep, and back as it came.
    let history = between("all");
    assert!(history.overlaps().is_empty(), "{:?}", history.overlaps());
    let [deep] = &history.contacts().too_deep()[..] else { panic!("{:?}", history.contacts().too_deep()) };
    within("depth", deep.depth.value / (3.0 * (2.0_f64 / 1e4).sqrt()) - 1.0, 1e-6);
    within("rebound", history.motion(0, 1.0).velocity.x + 3.0, 1e-9);
}
