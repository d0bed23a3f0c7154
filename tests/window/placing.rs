//! Placing with the mouse: handles, snapping, tools, rows, several at once, numbers with units.

use super::harness::{click, drag, on_screen, open, open_for, press, settle};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{EditCommand, SelectCommand, TimeCommand, Tool, ViewCommand, Workbench};
use girderbench::scene::presets;
use girderbench::view::Target;
use glam::DVec3;

type Window = Harness<'static, Workbench>;

/// The opening preset from above, its girder selected.
fn from_above(preset: &str, select: &[Target]) -> Window {
    let mut harness = open(preset);
    harness.key_press(Key::Num2);
    harness.state_mut().apply(SelectCommand::Only(None));
    for target in select {
        harness.state_mut().apply(SelectCommand::Also(*target));
    }
    settle(&mut harness);
    harness
}

/// Drags a handle by its name, so many points to the right and down, without snapping.
fn pull(harness: &mut Window, name: &str, by: [f32; 2]) {
    let from: Pos2 = harness.get_by_role_and_label(Role::Splitter, name).rect().center();
    drag(harness, from, from + egui::vec2(by[0], by[1]));
}

/// Metres to a point on the screen, along x.
fn metres_per_point(harness: &Window) -> f64 {
    let ends = [DVec3::ZERO, DVec3::X * 0.1].map(|p| on_screen(harness, p));
    0.1 / f64::from(ends[1].x - ends[0].x)
}

fn undo(harness: &mut Window) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(harness);
}

#[test]
fn an_end_is_dragged_to_another_length_and_the_other_end_stays() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    let before = harness.state().files.document.scene().girders[0].clone();
    let by = metres_per_point(&harness) * 40.0;
    pull(&mut harness, "length of deck at -x", [-40.0, 0.0]);
    let after = harness.state().files.document.scene().girders[0].clone();
    assert!((after.length - before.length - by).abs() < 1e-3, "as far as the mouse: {}", after.length);
    let plus_end = |g: &girderbench::scene::Girder| g.position[0] + g.length / 2.0;
    assert!((plus_end(&after) - plus_end(&before)).abs() < 1e-6, "the +x end stays");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
    undo(&mut harness);
    assert_eq!(harness.state().files.document.scene().girders[0], before, "one drag is one step");
}

#[test]
fn a_corner_is_dragged_to_another_skew_and_snaps_to_round_angles() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    // cot β goes from 1 to cot 60° = 0.577: the left corner 0.423 b toward -x.
    let half = harness.state().files.document.scene().girders[0].width / 2.0;
    let far = half * (1.0 - 1.0 / 60f64.to_radians().tan()) / metres_per_point(&harness);
    #[expect(clippy::cast_possible_truncation, reason = "points on the screen")]
    pull(&mut harness, "skew of deck at -x left", [-far as f32 + 0.4, 0.0]);
    assert_eq!(harness.state().files.document.scene().girders[0].skew_deg, 60.0, "near enough to be meant");
}

#[test]
fn turning_moving_and_widening_by_their_handles() {
    let mut harness = from_above("flush-free-hit", &[Target::Girder(0)]);
    let name = harness.state().files.document.scene().girders[0].name.clone();
    let before = harness.state().files.document.scene().girders[0].clone();
    let by = metres_per_point(&harness) * 30.0;
    pull(&mut harness, &format!("move {name} across"), [3.0, -30.0]);
    let moved = harness.state().files.document.scene().girders[0].clone();
    assert_eq!(moved.position[0], before.position[0], "only across");
    assert!((moved.position[1] - before.position[1] - by).abs() < 1e-3, "as far as the mouse");
    pull(&mut harness, &format!("width of {name}"), [0.0, 20.0]);
    let width = harness.state().files.document.scene().girders[0].width;
    assert!(width > before.width, "wider: {width}");
    pull(&mut harness, &format!("turn {name}"), [-20.0, 0.0]);
    let heading = harness.state().files.document.scene().girders[0].heading_deg;
    assert!(heading > 1.0, "pulled to the left at its left side it turns against the clock: {heading}");
}

#[test]
fn a_gap_is_dragged_at_its_dimension() {
    let mut harness = from_above(presets::OPENING, &[]);
    let gap = |h: &Window| h.state().files.document.scene().abutments[0].gap.expect("given");
    let before = gap(&harness);
    let by = metres_per_point(&harness) * 12.0;
    let name = "gap of deck+x|wall";
    pull(&mut harness, name, [12.0, 0.0]);
    assert!((gap(&harness) - before - by).abs() < 1e-3, "wider by the mouse's way: {}", gap(&harness));
    pull(&mut harness, name, [-400.0, 0.0]);
    assert_eq!(gap(&harness), 0.0, "never into the girder");
    harness.event(egui::Event::ModifiersChanged(egui::Modifiers::ALT));
    pull(&mut harness, name, [100.0, 0.0]);
    let fine = metres_per_point(&harness) * 100.0 / 50.0;
    assert!(
        (gap(&harness) - fine).abs() < 0.05 * fine + 1e-4,
        "a fiftieth of the way with Alt: {} of {fine}",
        gap(&harness)
    );
}

#[test]
fn a_gap_that_is_dragged_names_the_one_set_and_the_one_shown_and_no_tooltip_covers_them() {
    let mut harness = from_above(presets::OPENING, &[]);
    harness.state_mut().apply(TimeCommand::Seek(0.4));
    settle(&mut harness);
    let name = "gap of deck+x|wall";
    let from = harness.get_by_role_and_label(Role::Splitter, name).rect().center();
    harness.hover_at(from);
    harness.run_steps(60);
    assert!(harness.query_by_role_and_label(Role::Label, name).is_some(), "at rest the handle is named");
    harness.drag_at(from);
    settle(&mut harness);
    harness.hover_at(from + vec2(12.0, 0.0));
    harness.run_steps(60);
    assert!(harness.query_by_role_and_label(Role::Label, name).is_none(), "no tooltip over the numbers");
    let said = harness.get_by_role_and_label(Role::Splitter, name).accesskit_node().value().expect("what is read");
    let set = harness.state().files.document.scene().abutments[0].gap.expect("given") * 1e3;
    let set = format!("gap as placed {} mm", (set * 1e4).round() / 1e4);
    assert!(said.starts_with(&set), "{said:?} begins with {set:?}");
    assert!(said.lines().any(|line| line.starts_with("gap ") && line.ends_with(" at 0.4000 s")), "{said:?}");
}

#[test]
fn a_gap_in_a_row_moves_the_rest_of_the_row() {
    let mut harness = from_above("row-of-5", &[]);
    let x = |h: &Window| h.state().files.document.scene().girders.iter().map(|g| g.position[0]).collect::<Vec<_>>();
    let before = x(&harness);
    let gaps = harness.query_all_by_role(Role::Splitter).count();
    assert!(gaps >= 4, "a handle at every gap, found {gaps}");
    let pair = &harness.state().replay.runner.answer().expect("run").history.model().pairs[2];
    let name = format!("gap of {}", pair.name);
    pull(&mut harness, &name, [20.0, 0.0]);
    let after = x(&harness);
    let moved: Vec<bool> = before.iter().zip(&after).map(|(a, b)| (a - b).abs() > 1e-9).collect();
    let first = moved.iter().position(|m| *m).expect("something moved");
    assert!(moved[first..].iter().all(|m| *m) && first > 0, "all beyond the gap, none before: {moved:?}");
    let ways: Vec<f64> = before.iter().zip(&after).skip(first).map(|(a, b)| b - a).collect();
    assert!(ways.iter().all(|w| (w - ways[0]).abs() < 2e-6), "together: {ways:?}");
}

#[test]
fn a_pier_is_dragged_to_another_height_and_another_stiffness() {
    let mut harness = open_for("viaduct-5", 1.0);
    // From the side: the foot is in view, and up is up.
    harness.key_press(Key::Num3);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Pier(0))));
    settle(&mut harness);
    let pier = |harness: &Window| harness.state().files.document.scene().pier(0);
    let before = pier(&harness);
    let ends = [0.0, 1.0].map(|z| on_screen(&harness, before.top + DVec3::Z * z));
    let metres = 1.0 / f64::from(ends[0].y - ends[1].y);
    pull(&mut harness, "height of p1", [0.0, 30.0]);
    let higher = pier(&harness);
    let longer = higher.height - before.height;
    assert!((longer / (30.0 * metres) - 1.0).abs() < 0.05, "as far as the mouse: {longer} m for {} m", 30.0 * metres);
    let softer = higher.stiffness[0] / before.stiffness[0] * (higher.height / before.height).powi(3);
    assert!((softer - 1.0).abs() < 1e-9, "3EI/h³: {softer}");
    undo(&mut harness);
    assert_eq!(pier(&harness), before, "one drag is one step");
    harness.get_by_role_and_label(Role::Splitter, "columns of p1").focus();
    harness.event(egui::Event::Text("2.1 m".into()));
    settle(&mut harness);
    harness.key_press(Key::Enter);
    settle(&mut harness);
    let thicker = pier(&harness).stiffness[0] / before.stiffness[0];
    let [diameter, _] = before.column.xy();
    assert!((thicker / (2.1 / diameter).powi(4) - 1.0).abs() < 1e-9, "π d⁴/64: {thicker}");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
}

#[test]
fn handles_are_pulled_by_keys_too() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    harness.get_by_role_and_label(Role::Splitter, "length of deck at -x").focus();
    settle(&mut harness);
    let (before, t) =
        (harness.state().files.document.scene().girders[0].length, harness.state().replay.playback.clock.t);
    harness.key_press(Key::ArrowRight);
    settle(&mut harness);
    let once = harness.state().files.document.scene().girders[0].length - before;
    assert!((once - 1e-3).abs() < 1e-9, "a millimetre, got {once}");
    harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
    settle(&mut harness);
    let back = harness.state().files.document.scene().girders[0].length - before;
    assert!((back + 9e-3).abs() < 1e-9, "ten back, got {back}");
    assert_eq!(harness.state().replay.playback.clock.t, t, "the time is left alone");
}

#[test]
fn a_girder_is_placed_with_the_mouse_and_snaps_into_the_row() {
    let mut harness = from_above("row-of-5", &[Target::Girder(4)]);
    let gone = harness.state().files.document.scene().girders[4].clone();
    harness.key_press(Key::Delete);
    settle(&mut harness);
    harness.key_press_modifiers(Modifiers::SHIFT, Key::G);
    settle(&mut harness);
    assert_eq!(harness.state().view.display.tool, Tool::Girder, "the tool");
    // A little off the axis and the gap that the row has.
    let near = on_screen(&harness, DVec3::from(gone.position)) + egui::vec2(3.0, 3.0);
    click(&mut harness, near);
    assert_eq!(harness.state().files.document.scene().girders.len(), 5, "one more");
    let new = harness.state().files.document.scene().girders[4].position;
    let off = (DVec3::from(new) - DVec3::from(gone.position)).length();
    assert!(off < 2e-6, "in the row as before: {new:?}");
    harness.key_press(Key::Escape);
    settle(&mut harness);
    assert_eq!(harness.state().view.display.tool, Tool::Select, "done");
    assert_eq!(harness.state().files.document.selection().lead(), Some(Target::Girder(4)), "the new one is selected");
}

#[test]
fn an_abutment_is_placed_before_the_nearest_free_end() {
    let mut harness = from_above(presets::OPENING, &[]);
    harness.key_press_modifiers(Modifiers::SHIFT, Key::B);
    settle(&mut harness);
    let girder = harness.state().files.document.scene().girders[0].clone();
    let left = on_screen(&harness, DVec3::new(girder.position[0] - girder.length * 0.6, 0.0, 0.0));
    click(&mut harness, left);
    let walls = &harness.state().files.document.scene().abutments;
    assert_eq!(walls.len(), 2, "one more");
    assert_eq!(walls[1].end.label(), "-x", "where the mouse was");
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
}

#[test]
fn a_row_of_five_is_made_from_one_and_undone_as_one() {
    let mut harness = from_above("flush-free-hit", &[Target::Girder(0)]);
    let before = harness.state().files.document.scene().clone();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::R);
    settle(&mut harness);
    harness.get_by_role_and_label(Role::SpinButton, "Gap between spans").click();
    settle(&mut harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(egui::Event::Text("3 cm".into()));
    settle(&mut harness);
    harness.key_press(Key::Enter);
    settle(&mut harness);
    press(&mut harness, "Make the row");
    let girders = &harness.state().files.document.scene().girders;
    assert_eq!(girders.len(), before.girders.len() + 4, "five spans");
    let at = girders[girders.len() - 1].position[0] - girders[girders.len() - 2].position[0];
    assert!((at - girders[0].length - 0.03).abs() < 1e-6, "30 mm apart, {at}");
    assert_eq!(
        harness.state().files.document.scene().abutments[0].faces,
        girders[4].name,
        "the wall stands before the last one"
    );
    assert_eq!(harness.state().replay.runner.problems(), None, "and it runs");
    undo(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "one step");
}

#[test]
fn several_are_selected_moved_copied_and_removed_together() {
    let mut harness = from_above("row-of-5", &[]);
    let before = harness.state().files.document.scene().clone();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    settle(&mut harness);
    assert_eq!(
        harness.state().files.document.selection().all().len(),
        before.girders.len() + before.abutments.len(),
        "everything"
    );
    harness.key_press_modifiers(Modifiers::ALT, Key::ArrowUp);
    settle(&mut harness);
    let ways: Vec<f64> = harness
        .state()
        .files
        .document
        .scene()
        .girders
        .iter()
        .zip(&before.girders)
        .map(|(a, b)| a.position[1] - b.position[1])
        .collect();
    assert!(ways[0] > 0.0 && ways.iter().all(|w| (w - ways[0]).abs() < 1e-9), "all by one step: {ways:?}");
    undo(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "one step of undo");
    harness.key_press(Key::Delete);
    settle(&mut harness);
    assert!(harness.state().files.document.scene().girders.is_empty(), "all gone");
    assert!(harness.state().files.document.scene().abutments.is_empty(), "walls too");
    undo(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "and back");
}

#[test]
fn a_number_is_typed_with_a_unit() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    for (typed, wanted) in [("25 cm", 0.25), ("1 m", 1.0), ("190", 0.19), ("12 kg", 0.19)] {
        harness.get_by_role_and_label(Role::SpinButton, "Length a₀").click();
        settle(&mut harness);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.event(egui::Event::Text(typed.into()));
        settle(&mut harness);
        harness.key_press(Key::Enter);
        settle(&mut harness);
        assert_eq!(harness.state().files.document.scene().girders[0].length, wanted, "{typed}");
    }
}

/// Lets the window go on for a little: the name of a handle under the mouse fades in.
fn calm(harness: &mut Window) {
    harness.step();
    harness.state_mut().replay.runner.wait();
    harness.run_steps(4);
}

fn undo_calmly(harness: &mut Window) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    calm(harness);
}

/// Closes the hand on a handle and begins to drag it.
fn grasp(harness: &mut Window, name: &str, by: [f32; 2]) -> Pos2 {
    let from: Pos2 = harness.get_by_role_and_label(Role::Splitter, name).rect().center();
    harness.drag_at(from);
    calm(harness);
    let to = from + egui::vec2(by[0], by[1]);
    harness.hover_at(to);
    calm(harness);
    to
}

fn write(harness: &mut Window, text: &str) {
    for letter in text.chars() {
        harness.event(egui::Event::Text(letter.into()));
        calm(harness);
    }
}

#[test]
fn a_number_typed_while_a_handle_is_dragged_takes_the_place_of_the_mouse() {
    type Read = fn(&girderbench::scene::Scene) -> f64;
    let cases: [(&str, &str, f64, Read); 7] = [
        ("length of deck at -x", "0.25 m", 0.25, |s| s.girders[0].length),
        ("length of deck at +x", "212,5", 0.2125, |s| s.girders[0].length),
        ("width of deck", "8 cm", 0.08, |s| s.girders[0].width),
        ("skew of deck at -x left", "63.5°", 63.5, |s| s.girders[0].skew_deg),
        ("turn deck", "-12.25", -12.25, |s| s.girders[0].heading_deg),
        ("move deck along", "-12.5 mm", -0.0125, |s| s.girders[0].position[0]),
        ("gap of deck+x|wall", "4.75", 0.00475, |s| s.abutments[0].gap.expect("given")),
    ];
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    let before = harness.state().files.document.scene().clone();
    for (name, typed, wanted, read) in cases {
        let at = grasp(&mut harness, name, [-9.0, 4.0]);
        write(&mut harness, typed);
        harness.hover_at(at + egui::vec2(-25.0, 10.0));
        calm(&mut harness);
        let now = read(harness.state().files.document.scene());
        assert!((now - wanted).abs() < 1e-9, "{name}: {wanted} as typed, whatever the mouse does; got {now}");
        harness.key_press(Key::Enter);
        calm(&mut harness);
        harness.hover_at(at + egui::vec2(40.0, 20.0));
        calm(&mut harness);
        let way = |h: &Window| h.state().view.viewport.camera().map(|camera| (camera.yaw, camera.pitch));
        let before_drop = way(&harness);
        harness.drop_at(at + egui::vec2(40.0, 20.0));
        calm(&mut harness);
        assert!((read(harness.state().files.document.scene()) - wanted).abs() < 1e-9, "{name}: set");
        assert_eq!(way(&harness), before_drop, "{name}: the view was not turned");
        undo_calmly(&mut harness);
        assert_eq!(*harness.state().files.document.scene(), before, "{name}: one step");
    }
}

#[test]
fn escape_puts_a_drag_back_as_if_it_had_never_begun() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    let before = harness.state().files.document.scene().clone();
    let at = grasp(&mut harness, "length of deck at -x", [-40.0, 0.0]);
    assert_ne!(*harness.state().files.document.scene(), before, "dragged");
    harness.key_press(Key::Escape);
    calm(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "as it was");
    assert_eq!(
        (harness.state().files.document.undo_label(), harness.state().files.document.redo_label()),
        (None, None),
        "nothing to undo or redo"
    );
    harness.hover_at(at + egui::vec2(30.0, 0.0));
    calm(&mut harness);
    harness.drop_at(at + egui::vec2(30.0, 0.0));
    calm(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "the hand is open");
    assert_eq!(harness.state().files.document.selection().all().len(), 1, "and the girder still selected");
}

#[test]
fn what_cannot_be_set_is_refused_beside_the_hand_and_a_letter_taken_back() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    let at = grasp(&mut harness, "skew of deck at -x left", [-4.0, 0.0]);
    write(&mut harness, "70");
    assert_eq!(harness.state().files.document.scene().girders[0].skew_deg, 70.0, "as typed");
    write(&mut harness, "0");
    assert_eq!(harness.state().files.document.scene().girders[0].skew_deg, 70.0, "700° is no skew: it stays");
    let plate = harness.state().view.viewport.hand.words.as_ref().expect("something is typed").join(" ");
    assert!(plate.contains("β 700|°") && plate.contains("between 0.0 and 180.0"), "the reason: {plate}");
    harness.key_press(Key::Backspace);
    calm(&mut harness);
    harness.key_press(Key::Backspace);
    calm(&mut harness);
    assert_eq!(harness.state().files.document.scene().girders[0].skew_deg, 7.0, "two letters less");
    assert_eq!(harness.state().files.document.scene().girders.len(), 1, "nothing was removed");
    harness.drop_at(at);
    calm(&mut harness);
    assert_eq!(harness.state().files.document.scene().girders[0].skew_deg, 7.0, "the mouse sets it too");
}

#[test]
fn two_numbers_are_typed_while_a_girder_is_dragged_over_the_ground() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    let before = harness.state().files.document.scene().girders[0].position;
    let from = on_screen(&harness, DVec3::new(-0.02, 0.0, 0.01));
    harness.drag_at(from);
    calm(&mut harness);
    harness.hover_at(from + egui::vec2(-30.0, -10.0));
    calm(&mut harness);
    write(&mut harness, "-20");
    harness.key_press(Key::Tab);
    calm(&mut harness);
    write(&mut harness, "5 mm");
    harness.key_press(Key::Enter);
    calm(&mut harness);
    harness.drop_at(from);
    calm(&mut harness);
    let after = harness.state().files.document.scene().girders[0].position;
    let way = [after[0] - before[0], after[1] - before[1]];
    assert!((way[0] + 0.02).abs() < 1e-9 && (way[1] - 0.005).abs() < 1e-9, "Δx and Δy, went {way:?}");
}

#[test]
fn a_handle_that_has_the_focus_takes_a_number_without_the_mouse() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    let before = harness.state().files.document.scene().clone();
    let view = *harness.state().view.viewport.camera().expect("shown");
    harness.get_by_role_and_label(Role::Splitter, "turn deck").focus();
    calm(&mut harness);
    for (key, letter) in [(Key::Num1, "1"), (Key::Num2, "2")] {
        harness.key_press(key);
        harness.event(egui::Event::Text(letter.into()));
        calm(&mut harness);
    }
    assert_eq!(harness.state().files.document.scene().girders[0].heading_deg, 12.0, "as typed");
    assert_eq!(*harness.state().view.viewport.camera().expect("shown"), view, "the digits were the handle's");
    harness.key_press(Key::Escape);
    calm(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "put back");
    harness.get_by_role_and_label(Role::Splitter, "turn deck").focus();
    calm(&mut harness);
    write(&mut harness, "0.5 rad");
    harness.key_press(Key::Enter);
    calm(&mut harness);
    assert!((harness.state().files.document.scene().girders[0].heading_deg - 0.5f64.to_degrees()).abs() < 1e-9, "set");
    undo_calmly(&mut harness);
    assert_eq!(*harness.state().files.document.scene(), before, "one step");
    // A girder of 2 mm has no room for its handles: that is on the way to 212 mm.
    harness.get_by_role_and_label(Role::Splitter, "length of deck at -x").focus();
    calm(&mut harness);
    write(&mut harness, "212");
    harness.key_press(Key::Enter);
    calm(&mut harness);
    assert_eq!(harness.state().files.document.scene().girders[0].length, 0.212, "to its last letter");
    harness.key_press(Key::Num1);
    calm(&mut harness);
    assert_ne!(harness.state().view.viewport.camera().expect("shown").yaw, view.yaw, "the keys are the view's again");
}

#[test]
fn a_walls_handles_take_numbers_too() {
    let mut harness = from_above(presets::OPENING, &[Target::Abutment(0)]);
    let mut narrow = harness.state().files.document.scene().abutments[0].clone();
    narrow.width = Some(0.15);
    let edit = girderbench::scene::edit::Edit::ReplaceAbutment(0, Box::new(narrow));
    harness.state_mut().apply(EditCommand::Change { edit, gesture: None });
    for (name, typed) in [("move wall sideways", "15 mm"), ("width of wall, one side", "25 cm")] {
        // Each edit makes the scene another size.
        harness.state_mut().apply(ViewCommand::Frame);
        calm(&mut harness);
        harness.get_by_role_and_label(Role::Splitter, name).focus();
        calm(&mut harness);
        write(&mut harness, typed);
        harness.key_press(Key::Enter);
        calm(&mut harness);
    }
    let wall = &harness.state().files.document.scene().abutments[0];
    assert!(wall.offset.is_some_and(|o| (o.abs() - 0.015).abs() < 2e-6), "sideways: {:?}", wall.offset);
    assert_eq!(wall.width, Some(0.25), "and as wide as typed");
}

/// The legend on the screen: the largest card of the picture.
fn legend(harness: &Window) -> egui::Rect {
    let list = harness.state().view.viewport.list().expect("shown").clone();
    let view = super::harness::view(harness);
    let cards = list.marks.iter().filter_map(|mark| match mark {
        girderbench::view::list::Mark::Panel { min, max, .. } => {
            let at = |corner: &glam::Vec2| view.min + vec2(corner.x, corner.y) / list.pixels_per_point;
            Some(egui::Rect::from_min_max(at(min), at(max)))
        }
        _ => None,
    });
    cards.max_by(|a, b| a.area().total_cmp(&b.area())).expect("a card")
}

#[test]
fn handles_are_hidden_under_the_legend() {
    let mut harness = from_above(presets::OPENING, &[Target::Girder(0)]);
    let handles = |harness: &Window| {
        harness.query_all_by_role(Role::Splitter).map(|node| node.rect().center()).collect::<Vec<Pos2>>()
    };
    let all = handles(&harness).len();
    let mut camera = *harness.state().view.viewport.camera().expect("shown");
    let corner = on_screen(&harness, camera.target);
    let by = metres_per_point(&harness);
    let way = legend(&harness).center() - corner;
    camera.target += DVec3::new(-f64::from(way.x) * by, f64::from(way.y) * by, 0.0);
    harness.state_mut().apply(ViewCommand::Camera(camera));
    settle(&mut harness);
    let (left, card) = (handles(&harness), legend(&harness));
    assert!(left.len() < all, "the middle of the girder is under the legend: {} of {all} handles", left.len());
    assert!(left.iter().all(|at| !card.contains(*at)), "{left:?} beside {card}");
}
