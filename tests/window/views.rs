//! Ways of looking: larger motion, a camera that goes along, the plan beside the view, the gap's section, sizes.

use super::harness::{open, press, reach, settle, view};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{Follow, SelectCommand, Sight, TimeCommand, ViewCommand, Workbench, lessons};
use girderbench::scene::presets;
use girderbench::view::Target;

fn with(sight: Sight) -> Harness<'static, Workbench> {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(TimeCommand::Seek(0.42));
    harness.state_mut().apply(ViewCommand::Sight(sight));
    settle(&mut harness);
    harness
}

#[test]
fn motion_is_shown_larger_and_says_so_while_numbers_stay() {
    let plain = with(Sight::default());
    let large = with(Sight { exaggeration: 5.0, ..Sight::default() });
    let list = |h: &Harness<'_, Workbench>| h.state().view.viewport.list().expect("shown").to_string();
    assert!(list(&large).contains("motion shown × 5"), "the factor is in the picture");
    assert!(!list(&plain).contains("motion shown"), "and is not where there is none");
    let gap = |h: &Harness<'_, Workbench>| {
        let list = list(h);
        let at = list.find("\"gap ").expect("a gap") + 1;
        list[at..].split('"').next().unwrap_or_default().to_owned()
    };
    assert_eq!(gap(&plain), gap(&large), "the gap's number is the true one");
    let place = |h: &Harness<'_, Workbench>| {
        let solids = &h.state().view.viewport.list().expect("shown").solids;
        let deck = solids.iter().find(|s| s.name == "deck").expect("drawn");
        deck.face.iter().map(|c| c.as_dvec3()).sum::<glam::DVec3>() / 4.0 + deck.sweep.as_dvec3() / 2.0
    };
    let way = plain.state().replay.runner.answer().expect("run").history.motion(0, 0.42).displacement;
    let shift = place(&large) - place(&plain);
    assert!((shift - 4.0 * way).length() < 1e-6, "four ways farther: {shift} for {way}");
}

#[test]
fn the_camera_goes_with_a_corner() {
    let mut harness = with(Sight { follow: Some(Follow::Corner(0, 1)), ..Sight::default() });
    let place = |h: &Harness<'_, Workbench>, t| {
        let history = &h.state().replay.runner.answer().expect("run").history;
        let corner = history.model().bodies[0].prism.plan_corners()[1].extend(0.0);
        let motion = history.motion(0, t);
        motion.place + motion.attitude * corner
    };
    let before = harness.state().view.viewport.camera().expect("shown").target;
    harness.state_mut().apply(TimeCommand::Seek(0.7));
    settle(&mut harness);
    let after = harness.state().view.viewport.camera().expect("shown").target;
    let way = place(&harness, 0.7) - place(&harness, 0.42);
    assert!((after - before - way).length() < 1e-12, "by the corner's way {way}, got {}", after - before);
}

#[test]
fn the_plan_stands_beside_the_view_and_takes_clicks() {
    let mut harness = with(Sight { plan: true, ..Sight::default() });
    let plan = harness.get_by_label("Plan").rect();
    let beside = view(&harness);
    assert!(plan.right() <= beside.left() + 1.0 && plan.width() > 200.0, "beside: {plan} {beside}");
    harness.drag_at(plan.center());
    settle(&mut harness);
    harness.drop_at(plan.center());
    settle(&mut harness);
    assert_eq!(
        harness.state().files.document.selection().lead(),
        Some(Target::Girder(0)),
        "what is in the middle of the plan"
    );
}

#[test]
fn the_section_names_its_pair_and_its_factor() {
    let harness = with(Sight { section: true, ..Sight::default() });
    assert!(harness.query_by_label_contains("deck+x|wall:").is_some(), "its pair");
    assert!(harness.query_by_label_contains("drawn ×").is_some(), "and how much larger");
}

#[test]
fn everything_can_be_larger_and_the_panels_step_back_in_a_lecture() {
    let mut harness = open(presets::OPENING);
    let before = view(&harness);
    harness.get_by_label("View").click();
    harness.run_steps(10);
    harness.get_by_label_contains("Lecture hall").click();
    harness.run_steps(10);
    settle(&mut harness);
    assert!(harness.state().view.display.sight.lecture, "on");
    assert!(harness.query_by_label("What if").is_none(), "the panels are gone");
    assert!(view(&harness).area() * 2.25 > before.area(), "the view has the room");
    for (words, size) in [("200 %", 2.0), ("150 %", 1.5)] {
        harness.get_by_label("View").click();
        harness.run_steps(10);
        reach(&mut harness, words);
        harness.get_by_label(words).click();
        harness.run_steps(10);
        settle(&mut harness);
        assert_eq!(harness.ctx.zoom_factor(), size, "as large as asked for");
    }
    press(&mut harness, "Learn");
    press(&mut harness, &lessons()[0].title);
    assert!(harness.query_by_label("Reset").is_some() && harness.query_by_label("Placed").is_none(), "a lesson alone");
    harness.get_by_label("View").click();
    harness.run_steps(10);
    harness.get_by_label_contains("Lecture hall").scroll_to_me();
    harness.run_steps(40);
    harness.get_by_label_contains("Lecture hall").click();
    settle(&mut harness);
    assert!(!harness.state().view.display.sight.lecture, "off");
    assert_eq!(harness.ctx.zoom_factor(), 1.5, "as large as was chosen");
    // Panels that fold for want of room at that size are there again at the usual one.
    harness.get_by_label("View").click();
    harness.run_steps(10);
    reach(&mut harness, "100 %");
    harness.get_by_label("100 %").click();
    harness.run_steps(10);
    settle(&mut harness);
    assert!(harness.query_by_label("What if").is_some(), "and back");
}

#[test]
fn a_stretch_is_set_by_keys_and_played_again_and_again() {
    let mut harness = open(presets::OPENING);
    for (t, key) in [(1.0, egui::Key::I), (1.2, egui::Key::O)] {
        harness.state_mut().apply(TimeCommand::Seek(t));
        harness.key_press(key);
        settle(&mut harness);
    }
    assert_eq!(harness.state().replay.playback.clock.span, Some([1.0, 1.2]), "from here to there");
    harness.state_mut().apply(TimeCommand::Seek(1.1));
    harness.state_mut().apply(TimeCommand::Speed(1.0));
    harness.state_mut().apply(TimeCommand::TogglePlay);
    for _ in 0..40 {
        harness.step();
        let t = harness.state().replay.playback.clock.t;
        assert!((1.0..=1.2).contains(&t), "inside the stretch, at {t}");
    }
    harness.state_mut().apply(TimeCommand::TogglePlay);
    harness.key_press(egui::Key::X);
    settle(&mut harness);
    assert_eq!(harness.state().replay.playback.clock.span, None, "everything again");
}

#[test]
fn a_contact_is_selected_by_its_name_and_tells_its_history() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Abutment(0))));
    settle(&mut harness);
    let contact = harness.state().replay.runner.answer().expect("run").history.hits().hardest().expect("a hit").contact;
    let site = harness.state().replay.runner.answer().expect("run").history.model().sites[contact].clone();
    let name = format!("{} | {}", site.node_in_words(), site.face_name);
    reach(&mut harness, &name);
    harness.get_by_label(&name).click();
    settle(&mut harness);
    assert_eq!(harness.state().files.document.selection().lead(), Some(Target::Contact(contact)), "the contact");
    harness.run_steps(5);
    assert!(harness.query_by_label_contains("touches").is_some(), "how often it touches");
    let peak = harness
        .state()
        .replay
        .runner
        .answer()
        .expect("run")
        .history
        .hits()
        .touches()
        .iter()
        .find(|t| t.contact == contact);
    let peak = peak.expect("a touch").peak_time;
    harness.state_mut().apply(TimeCommand::Seek(peak));
    settle(&mut harness);
    harness.run_steps(5);
    assert!(harness.query_by_label("cone used").is_some(), "closed, it says how much of the cone it uses");
}
