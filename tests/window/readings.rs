//! Panels of any quantity, plots as files, limits and their flags, readings at the girder.

use super::harness::{open, press, reach, settle};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{EditCommand, FileCommand, SelectCommand, TimeCommand, WindowCommand, Workbench};
use girderbench::scene::edit::Edit;
use girderbench::scene::{Limits, PlotSettings, presets};
use girderbench::sim::quantity::{OfPair, Quantity};
use girderbench::view::Target;

type Window = Harness<'static, Workbench>;

fn offer(harness: &mut Window, words: &str) {
    reach(harness, "Add plot");
    harness.get_by_label("Add plot").click();
    harness.run_steps(10);
    harness.get_by_label(words).click();
    harness.run_steps(10);
    settle(harness);
}

#[test]
fn panels_of_any_quantity_are_added_changed_and_taken_away() {
    let mut harness = open(presets::OPENING);
    let before = harness.state().files.document.scene().clone();
    for words in ["Energy ledger, stacked", "Orbit of a corner", "Use of the friction cone"] {
        offer(&mut harness, words);
    }
    let plots = harness.state().files.document.scene().view.plots.clone();
    assert_eq!(plots.len(), 3, "three panels");
    assert!(plots[0].y.len() >= 6 && plots[0].x.is_none(), "the ledger: {:?}", plots[0]);
    assert_eq!(plots[1].x.as_deref(), Some("deck.corner2.x"), "the orbit has an axis of its own");
    assert!(harness.query_all_by_label_contains("deck.corner2.x").count() >= 1, "and says so");
    reach(&mut harness, "remove plot 2");
    harness.get_by_label("remove plot 2").click();
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().view.plots.len(), 2, "one less");
    for _ in 0..4 {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        settle(&mut harness);
    }
    assert_eq!(*harness.state().files.document.scene(), before, "each was a step of undo");
}

#[test]
fn plots_are_written_as_svg_png_and_csv() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = open(presets::OPENING);
    let mut view = harness.state().files.document.scene().view.clone();
    view.plots = vec![PlotSettings { x: Some("deck.x".into()), ..PlotSettings::over_time(vec!["deck.y".into()]) }];
    harness.state_mut().apply(EditCommand::Change { edit: Edit::View(view), gesture: None });
    settle(&mut harness);
    for name in ["run.svg", "run.png", "run.csv"] {
        harness.state_mut().apply(WindowCommand::Dismiss);
        harness.state_mut().apply(FileCommand::Plots(folder.path().join(name)));
        for _ in 0..1000 {
            harness.run();
            if harness.state().window.notice().is_some() {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(10));
        }
        assert!(
            harness.state().window.notice().is_some_and(|n| n.contains(name)),
            "{:?}",
            harness.state().window.notice()
        );
    }
    let read = |name: &str| std::fs::read(folder.path().join(name)).expect(name);
    let svg = String::from_utf8(read("run.svg")).expect("text");
    assert!(svg.contains("deck.theta") && svg.matches("<polyline").count() >= 4, "three panels of curves");
    assert!(String::from_utf8(read("run-2.svg")).expect("text").contains("deck.x [mm]"), "the orbit beside it");
    assert!(read("run.png").starts_with(b"\x89PNG") && read("run-2.png").starts_with(b"\x89PNG"), "as pictures");
    let table = String::from_utf8(read("run.csv")).expect("text");
    let mut rows = table.lines();
    assert_eq!(rows.next(), Some("t [s],deck.x [mm],deck.y [mm]"), "heads with units");
    let history = &harness.state().replay.runner.answer().expect("run").history;
    for row in rows.step_by(97) {
        let values: Vec<f64> = row.split(',').map(|v| v.parse().expect("a number")).collect();
        let way = history.motion(0, values[0]).displacement * 1e3;
        assert!((values[1] - way.x).abs() < 1e-9 && (values[2] - way.y).abs() < 1e-9, "as the run says: {row}");
    }
}

/// The words of the button that stands for a limit that was passed.
fn flag_words(harness: &Window) -> String {
    let all = harness.query_all_by_label_contains("limit passed at");
    let mut buttons = all.filter(|n| n.accesskit_node().role() == Role::Button);
    buttons.next().and_then(|n| n.accesskit_node().label()).expect("a flag")
}

#[test]
fn a_limit_is_switched_on_and_flagged() {
    let mut harness = open(presets::OPENING);
    harness.get_by_role_and_label(Role::CheckBox, "Rotation limit").scroll_to_me();
    harness.run_steps(40);
    harness.get_by_role_and_label(Role::CheckBox, "Rotation limit").click();
    settle(&mut harness);
    assert!(harness.state().files.document.scene().limits.rotation_deg.is_some(), "set");
    let limits = Limits { rotation_deg: Some(1.0), ..Limits::default() };
    harness.state_mut().apply(EditCommand::Change { edit: Edit::Limits(limits), gesture: None });
    settle(&mut harness);
    let passed = harness.state().replay.runner.answer().expect("run").passed().to_vec();
    assert_eq!(passed.len(), 1, "one girder turns by more than a degree");
    // The status line and the panel say it, each with a button.
    let flag = flag_words(&harness);
    harness.query_all_by_role_and_label(Role::Button, &flag).next().expect("a button").click();
    settle(&mut harness);
    let t = harness.state().replay.playback.clock.t;
    assert_eq!(t, passed[0].t, "goes there");
    let turned = harness.state().replay.runner.answer().expect("run").history.motion(0, t).theta.to_degrees().abs();
    assert!((turned - 1.0).abs() < 1e-6, "where it turns by the limit: {turned}");
}

#[test]
fn a_girder_says_what_was_read_off_the_run() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    harness.run_steps(5);
    assert!(harness.query_by_label("Readings of the run").is_some(), "there");
    let peak =
        harness.state().replay.runner.answer().expect("run").reading(0).expect("a girder").force.expect("it hits");
    assert_eq!(peak.value, harness.state().replay.runner.answer().expect("run").summary.peak_force, "the one pair's");
    assert!(harness.query_by_label("peak force").is_some() && harness.query_by_label("drift 3").is_some(), "named");
}

#[test]
fn seats_are_shown_with_codes_and_the_report_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = open(presets::OPENING);
    let scene = harness.state().files.document.scene();
    let scene = girderbench::scene::overrides::apply(scene, "girder.deck.seat_m={ \"+x\" = 0.002 }").expect("fits");
    harness.state_mut().apply(EditCommand::Change { edit: Edit::Scene(Box::new(scene)), gesture: None });
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    assert_eq!(harness.query_all_by_label_contains("not confirmed").count(), 4, "AASHTO twice, Caltrans, EN");
    assert!(harness.query_all_by_label_contains("too short").count() >= 5, "2 mm are");
    let page = folder.path().join("run.html");
    harness.state_mut().apply(WindowCommand::Dismiss);
    harness.state_mut().apply(FileCommand::Export(girderbench::app::Export::Report, page.clone()));
    for _ in 0..1000 {
        harness.run();
        if harness.state().window.notice().is_some() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let text = std::fs::read_to_string(page).expect("written");
    assert!(text.contains("A corner comes off its seat: deck+x at "), "the run of the window");
    assert!(harness.state().window.notice().is_some(), "says where");
    wait(&mut harness, 11.0);
    assert!(harness.state().window.notice().is_none(), "and goes by itself");
    harness
        .state_mut()
        .apply(FileCommand::Export(girderbench::app::Export::Report, folder.path().join("none/run.html")));
    for _ in 0..1000 {
        harness.run();
        if harness.state().window.notice().is_some() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    wait(&mut harness, 11.0);
    assert!(harness.state().window.notice().is_some(), "what failed stays until it is dismissed");
}

/// Lets the window's clock go on by so much \[s\].
fn wait(harness: &mut Window, seconds: f64) {
    let now = harness.ctx.input(|input| input.time);
    harness.input_mut().time = Some(now + seconds);
    harness.run_steps(4);
}

/// What stands behind a name in a table of the panel.
fn behind(harness: &Window, name: &str) -> String {
    let labels = harness.root().children_recursive().map(|n| n.accesskit_node().value().or(n.accesskit_node().label()));
    let labels: Vec<String> = labels.flatten().collect();
    let at = labels.iter().position(|label| label == name).unwrap_or_else(|| panic!("no {name} in {labels:?}"));
    labels[at..].iter().find(|label| *label != name).expect("something").clone()
}

/// The number of newtons that a text begins with.
fn newtons(words: &str) -> f64 {
    let mut parts = words.split([' ', ',']);
    let number: f64 = parts.next().and_then(|n| n.parse().ok()).unwrap_or_else(|| panic!("no number: {words}"));
    let unit = parts.next().unwrap_or_default();
    number * [("N", 1.0), ("kN", 1e3), ("MN", 1e6)].iter().find(|(name, _)| *name == unit).expect("newtons").1
}

#[test]
fn view_panel_and_plots_tell_one_force_and_name_the_other() {
    let mut harness = open("deck-30m");
    let answer = harness.state().replay.runner.answer().expect("run").clone();
    // Just after it has closed the dashpot pushes hardest beside the spring.
    let touch = *answer.history.hits().hardest().expect("a hit");
    let at = |i: u32| touch.start + (touch.end - touch.start) * f64::from(i) / 50.0;
    let force = |t: f64| {
        answer
            .history
            .contacts()
            .contact_at(touch.contact, t)
            .map_or([0.0; 2], |c| [c.force, c.elastic_force()].map(glam::DVec3::length))
    };
    let apart = |t: f64| force(t)[0] - force(t)[1];
    let t = (1..50).map(at).max_by(|a, b| apart(*a).total_cmp(&apart(*b))).expect("instants");
    let [whole, elastic] = force(t);
    assert!(whole > 1.2 * elastic, "an instant at which they differ: {whole} N, {elastic} N");
    harness.state_mut().apply(TimeCommand::Seek(t));
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Contact(touch.contact))));
    settle(&mut harness);
    press(&mut harness, "Contact");
    let same = |words: &str, wanted: f64| (newtons(words) / wanted - 1.0).abs() < 5e-3;
    let list = harness.state().view.viewport.list().expect("shown").to_string();
    let said = list.split('"').filter(|words| words.contains(" without dashpots)"));
    let said: Vec<&str> = said.filter(|words| same(words, whole)).collect();
    let said = said.first().unwrap_or_else(|| panic!("a label of {whole} N in the view: {list}"));
    assert!(same(said.split('(').nth(1).expect("the other"), elastic), "and the other by its name: {said}");
    assert!(same(&behind(&harness, "force |R|"), whole), "so in the panel: {}", behind(&harness, "force |R|"));
    assert!(same(&behind(&harness, "without dashpots"), elastic), "and the other by its name");
    let plotted = Quantity::Pair(touch.pair, OfPair::Force).at(&answer.history, t);
    assert!(
        plotted >= whole && (plotted / whole - 1.0).abs() < 0.2,
        "the plot has the largest of the pair's: {plotted}"
    );
}

#[test]
fn a_verdict_and_every_reading_lead_to_their_moment_and_their_place() {
    let mut harness = open(presets::OPENING);
    let scene = harness.state().files.document.scene();
    let scene =
        girderbench::scene::overrides::apply(scene, "girder.deck.seat_m={ \"+x\" = 0.1, \"-x\" = 0.1 }").expect("fits");
    harness.state_mut().apply(EditCommand::Change { edit: Edit::Scene(Box::new(scene)), gesture: None });
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    let answer = harness.state().replay.runner.answer().expect("run").clone();
    let verdict = answer.history.seats().verdict(0).expect("seats");
    let words = format!("deck {}", verdict.words());
    assert!(words.contains("stays on its seats: at worst"), "{words}");
    reach(&mut harness, &words);
    press(&mut harness, &words);
    assert_eq!(harness.state().replay.playback.clock.t, verdict.t(), "the moment that decides it");
    let at = |harness: &Window, point: glam::DVec3| super::harness::on_screen(harness, point);
    let motion = answer.history.motion(0, verdict.t());
    let corner =
        answer.history.model().bodies[0].prism.plan_corners()[verdict.corner().expect("of a seat")].extend(0.0);
    let middle = super::harness::view(&harness).center();
    let off = at(&harness, motion.place + motion.attitude * corner).distance(middle);
    assert!(off < 3.0, "its corner in the middle of the view: {off} points aside");
    // Figures of the status line, one by one.
    for (words, t) in [
        ("pair peak ", answer.summary.peak_total_time.expect("a hit")),
        ("moves ", answer.history.largest_motion().expect("it moves").displacement.extreme.t),
        ("turns ", answer.history.largest_motion().expect("it turns").rotation.extreme.t),
        ("hits ", answer.history.hits().touches()[0].start),
    ] {
        let label = figure(&harness, words);
        press(&mut harness, &label);
        assert_eq!(harness.state().replay.playback.clock.t, t, "{words}");
    }
    let (hit, most) = answer.history.hits().hardest_pounding().expect("a hit");
    let strongest = answer.history.hits().strongest_contact(hit.pair, most.t).map(Target::Contact);
    let peak = figure(&harness, "pair peak ");
    press(&mut harness, &peak);
    assert!(strongest.is_some(), "closed then");
    assert_eq!(harness.state().files.document.selection().lead(), strongest, "and that contact is selected");
}

#[test]
fn a_force_that_is_followed_leaves_its_girder_selected() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    settle(&mut harness);
    let answer = harness.state().replay.runner.answer().expect("run").clone();
    let (_, most) = answer.history.hits().largest_total_on(0).expect("it hits");
    let words = behind(&harness, "peak force");
    let here = harness.query_all_by_role_and_label(Role::Button, &words).next().expect("a button");
    here.scroll_to_me();
    harness.run_steps(40);
    harness.query_all_by_role_and_label(Role::Button, &words).next().expect("a button").click();
    settle(&mut harness);
    assert_eq!(harness.state().replay.playback.clock.t, most.t, "the moment of the force");
    assert_eq!(harness.state().files.document.selection().lead(), Some(Target::Girder(0)), "still selected");
    assert!(harness.query_by_label("Readings of the run").is_some(), "and its readings are there to go on");
}

/// The words of the button of the status line that begins so.
fn figure(harness: &Window, begins: &str) -> String {
    let buttons = harness.root().children_recursive().filter(|n| n.accesskit_node().role() == Role::Button);
    let mut own = buttons.filter_map(|n| n.accesskit_node().label()).filter(|words| words.starts_with(begins));
    own.find(|words| words.chars().any(|c| c.is_ascii_digit())).expect("a figure that is a button")
}
