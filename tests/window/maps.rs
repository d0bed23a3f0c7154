//! The map of a number of the run over two keys: coarse to fine on threads, a click opens the run of its cell.

use super::harness::{open, press, settle, type_in};
use super::studio;
use egui::accesskit::Role;
use egui::{Key, Pos2, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{EditCommand, MapAxis, MapCommand, MapDraft, Workbench};
use girderbench::scene::edit::Edit;
use girderbench::scene::presets;
use girderbench::study::sweep::Measure;

type Window = Harness<'static, Workbench>;

const KEYS: [&str; 2] = ["girder.deck.skew_deg", "motion.angle_deg"];

/// A coarse map of short runs.
fn draft(measure: &'static str) -> MapDraft {
    let axis = |key: &str, from, to| MapAxis { key: key.to_owned(), from, to, is_log: false };
    MapDraft { axes: [axis(KEYS[0], 30.0, 90.0), axis(KEYS[1], -80.0, 80.0)], measure, cells: 9 }
}

/// Waits until the map has come out, and shows it.
fn wait(harness: &mut Window) {
    let scene = harness.state().files.document.scene().clone();
    harness.state_mut().maps.wait(&scene);
    settle(harness);
}

/// The window on two seconds of the opening scene, with this map of it.
fn mapped(measure: &'static str) -> Window {
    let mut harness = open(presets::OPENING);
    let edit = Edit::Set("duration_s=2".into());
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    settle(&mut harness);
    harness.state_mut().apply(MapCommand::Show(true));
    harness.state_mut().apply(MapCommand::Draft(draft(measure)));
    harness.step();
    wait(&mut harness);
    harness
}

/// The middle of a cell of the map on the screen.
fn place(harness: &Window, [x, y]: [usize; 2]) -> Pos2 {
    let rect = harness.get_by_label_contains("Map of ").rect();
    let part = |cell: usize| (cell as f32 + 0.5) / 9.0;
    pos2(rect.left() + rect.width() * part(x), rect.bottom() - rect.height() * part(y))
}

fn numbers(harness: &Window) -> [f64; 2] {
    let scene = harness.state().files.document.scene();
    [scene.girders[0].skew_deg, scene.motion.angle_deg()]
}

#[test]
fn a_click_on_a_cell_opens_the_run_that_it_is_of_and_undo_takes_it_back_whole() {
    let mut harness = mapped("max_rotation");
    let map = harness.state().maps.map().expect("a map");
    let cell = [2, 6];
    let value = map.row(cell).expect("every run has come out").values[0].expect("a rotation");
    let (before, steps) = (numbers(&harness), harness.state().files.document.undo_label().map(str::to_owned));
    let at = place(&harness, cell);
    // A window asks for frames while the mouse is held down on it.
    harness.drag_at(at);
    harness.run_steps(2);
    harness.drop_at(at);
    settle(&mut harness);
    assert_eq!(numbers(&harness), [45.0, 40.0], "both keys as at the cell");
    let answer = harness.state().replay.runner.answer().expect("run").clone();
    let measure = Measure::named("max_rotation").expect("known");
    assert_eq!(measure.of(&answer.history), Some(value), "the run of the map, to the last bit");
    assert!(harness.state().maps.fits(), "the map is of this scene too");
    harness.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(
        (numbers(&harness), harness.state().files.document.undo_label().map(str::to_owned)),
        (before, steps),
        "one step"
    );
}

#[test]
fn keys_and_mouse_read_a_cell_and_enter_opens_it() {
    let mut harness = mapped("max_rotation");
    let at = place(&harness, [0, 0]);
    harness.hover_at(at);
    harness.run_steps(20);
    let said = |harness: &Window| harness.get_by_label_contains("Map of ").accesskit_node().value().unwrap_or_default();
    assert!(said(&harness).contains("30°") && said(&harness).contains("-80°"), "{}", said(&harness));
    assert!(said(&harness).contains("max rotation: "), "{}", said(&harness));
    harness.remove_cursor();
    harness.get_by_label_contains("Map of ").focus();
    harness.run_steps(4);
    for key in [Key::ArrowLeft, Key::ArrowUp, Key::ArrowUp] {
        harness.key_press(key);
        harness.run_steps(2);
    }
    harness.key_press(Key::Enter);
    settle(&mut harness);
    assert_eq!(numbers(&harness), [52.5, 40.0], "one to the left of the middle, two up");
}

#[test]
fn another_scene_makes_the_map_an_old_one_until_it_is_computed_again() {
    let mut harness = mapped("hits");
    assert!(harness.state().maps.fits() && harness.query_by_label("81 of 81 runs").is_some(), "whole");
    let edit = Edit::Set("contact.mu_kinetic=0.02".into());
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    settle(&mut harness);
    assert!(!harness.state().maps.fits(), "of the scene as it was");
    assert!(harness.query_by_label("of the scene as it was").is_some(), "which is said");
    press(&mut harness, "Compute the map");
    wait(&mut harness);
    assert!(harness.state().maps.fits(), "of this one now");
}

#[test]
fn a_map_is_stopped_and_what_has_come_out_stays_and_is_drawn() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(MapCommand::Show(true));
    harness.state_mut().apply(MapCommand::Draft(MapDraft { cells: 65, ..draft("max_force") }));
    for _ in 0..2000 {
        harness.step();
        if harness.state().maps.progress().is_some_and(|[done, _]| done > 30) {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    let [done, all] = harness.state().maps.progress().expect("on its way");
    assert!(done > 30 && done < all, "{done} of {all}");
    harness.get_by_role_and_label(Role::Button, "Stop the map").click();
    harness.step();
    assert_eq!(harness.state().maps.progress(), None, "stopped");
    settle(&mut harness);
    let map = harness.state().maps.map().expect("kept");
    let coarse = [0, 16, 32, 48, 64];
    assert!(coarse.iter().all(|x| coarse.iter().all(|y| map.row([*x, *y]).is_some())), "the coarsest grid came first");
    assert!(harness.query_by_label("stopped").is_some(), "which is said");
}

#[test]
fn what_cannot_be_computed_is_told_and_other_keys_are_chosen_by_their_names() {
    let mut harness = mapped("hits");
    type_in(&mut harness, "Across from", "200");
    wait(&mut harness);
    assert!(harness.query_by_label_contains("skew_deg").is_some(), "no skew is 200°: the complaint names the key");
    type_in(&mut harness, "Across from", "30");
    wait(&mut harness);
    press(&mut harness, "Skew β of deck");
    harness.run_steps(10);
    harness.event(egui::Event::Text("mass".into()));
    harness.run_steps(4);
    let mass =
        harness.query_by_label_contains("girder.deck.mass_kg").or(harness.query_by_label_contains("Mass m of deck"));
    mass.expect("in the list").click();
    settle(&mut harness);
    wait(&mut harness);
    let draft = harness.state().maps.draft().expect("open").clone();
    assert_eq!(draft.axes[0].key, "girder.deck.mass_kg", "another key");
    assert!(draft.axes[0].from < draft.axes[0].to, "with a stretch about what it is: {draft:?}");
}

#[test]
#[ignore = "leaves pictures to be looked at"]
fn pictures_of_maps() {
    let Some(_studio) = studio::studio("pictures_of_maps") else { return };
    let mut harness = super::harness::builder([1280.0, 720.0])
        .wgpu()
        .build_ui_state(super::harness::show, super::harness::bench("skew45-abutment"));
    settle(&mut harness);
    harness.state_mut().apply(MapCommand::Show(true));
    harness.step();
    wait(&mut harness);
    harness.render().expect("drawn").save("target/map-window.png").expect("written");
    let at = place(&harness, [2, 6]);
    harness.hover_at(at);
    harness.run_steps(30);
    harness.render().expect("drawn").save("target/map-hovered.png").expect("written");
}
