//! Plots against time: numbers and units along the axes, values where the mouse points, zoom of both axes, spectra, differences.

use super::harness::{open, press, reach_as, settle, slide};
use egui::accesskit::Role;
use egui::{Modifiers, Pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{CompareCommand, EditCommand, FileCommand, TimeCommand, Workbench};
use girderbench::scene::edit::Edit;
use girderbench::scene::{PlotSettings, PlotShows, presets};

type Window = Harness<'static, Workbench>;

fn wheel(harness: &mut Window, at: Pos2, turn: f32, modifiers: Modifiers) {
    harness.hover_at(at);
    harness.run();
    harness.event(egui::Event::ModifiersChanged(modifiers));
    harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: egui::vec2(0.0, turn),
        modifiers,
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
    });
    harness.run_steps(30);
    harness.event(egui::Event::ModifiersChanged(Modifiers::NONE));
    harness.run();
}

/// The words of a legend, by the name of its first curve.
fn legend(harness: &Window, first: &str) -> String {
    let all =
        harness.root().children_recursive().filter_map(|n| n.accesskit_node().value().or(n.accesskit_node().label()));
    let mut legends = all.filter(|words| words.starts_with(first));
    legends.next().unwrap_or_else(|| panic!("a legend that begins with {first}"))
}

fn add(harness: &mut Window, plot: PlotSettings) {
    let mut view = harness.state().files.document.scene().view.clone();
    view.plots.push(plot);
    harness.state_mut().apply(EditCommand::Change { edit: Edit::View(view), gesture: None });
    settle(harness);
}

#[test]
fn values_are_read_where_the_mouse_points_and_at_the_time_shown_else() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(TimeCommand::Seek(2.0));
    settle(&mut harness);
    let answer = harness.state().replay.runner.answer().expect("run").clone();
    let said = |t: f64| {
        let theta = answer.history.motion(0, t).theta.to_degrees();
        format!("θ {theta:.2}")
    };
    assert!(legend(&harness, "θ").starts_with(&said(2.0)), "{} at 2 s", legend(&harness, "θ"));
    let strip = harness.get_by_label("Plots").rect();
    harness.hover_at(strip.center());
    harness.run();
    assert!(legend(&harness, "θ").starts_with(&said(5.0)), "{}, not {}", legend(&harness, "θ"), said(5.0));
    assert!(legend(&harness, "|ΣR|").ends_with(" N"), "with its unit: {}", legend(&harness, "|ΣR|"));
    assert_eq!(harness.state().replay.playback.clock.t, 2.0, "the time shown stays");
}

#[test]
fn values_zoom_by_the_wheel_over_their_axis_and_with_alt_and_come_back() {
    let mut harness = open(presets::OPENING);
    let axis = harness.get_by_label("Values of Rotation").rect();
    let range = |harness: &Window| harness.state().plots.values("Rotation");
    assert_eq!(range(&harness), None, "all of them");
    wheel(&mut harness, axis.center(), 120.0, Modifiers::NONE);
    let near = range(&harness).expect("a part");
    let field = egui::pos2(harness.get_by_label("Plots").rect().center().x, axis.center().y);
    wheel(&mut harness, field, 120.0, Modifiers::ALT);
    let nearer = range(&harness).expect("a part");
    assert!(nearer[1] - nearer[0] < 0.8 * (near[1] - near[0]), "{near:?} to {nearer:?}");
    assert_eq!(harness.state().replay.playback.window, None, "time stays");
    super::harness::drag(&mut harness, axis.center(), axis.center() + egui::vec2(0.0, 10.0));
    let moved = range(&harness).expect("a part");
    assert!(moved[0] > nearer[0] && (moved[1] - moved[0] - nearer[1] + nearer[0]).abs() < 1e-9, "moved: {moved:?}");
    for _ in 0..2 {
        harness.drag_at(axis.center());
        harness.run_steps(1);
        harness.drop_at(axis.center());
        harness.run_steps(1);
    }
    harness.run();
    assert_eq!(range(&harness), None, "a double click shows all");
}

#[test]
fn a_pinned_run_is_plotted_as_a_difference() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(CompareCommand::Pin);
    let before = harness.state().replay.runner.answer().expect("run").clone();
    slide(&mut harness, "Skew β", 60.0);
    reach_as(&mut harness, Role::CheckBox, "Plot the differences");
    harness.get_by_role_and_label(Role::CheckBox, "Plot the differences").click();
    harness.state_mut().apply(TimeCommand::Seek(3.0));
    settle(&mut harness);
    let now = harness.state().replay.runner.answer().expect("run").clone();
    let turn = |answer: &girderbench::app::Answer| answer.history.motion(0, 3.0).theta.to_degrees();
    let words = legend(&harness, "θ");
    let said = words.split("θ − run 1 ").nth(1).unwrap_or_else(|| panic!("the difference: {words}"));
    let said: f64 = said.split(' ').next().and_then(|n| n.parse().ok()).expect("a number");
    let wanted = turn(&now) - turn(&before);
    assert!((said - wanted).abs() < 5e-3 * wanted.abs().max(0.1), "{said}, not {wanted}");
}

#[test]
fn spectra_and_logarithms_are_chosen_and_drawn() {
    let mut harness = open(presets::OPENING);
    add(&mut harness, PlotSettings::over_time(vec!["ground.x".into()]));
    reach_as(&mut harness, Role::ComboBox, "Shows");
    harness.get_by_role_and_label(Role::ComboBox, "Shows").click();
    harness.run_steps(10);
    harness.get_by_label("response spectrum, 5 %").click();
    settle(&mut harness);
    let plots = |harness: &Window| harness.state().files.document.scene().view.plots.clone();
    assert_eq!(plots(&harness)[0].shows, PlotShows::Response, "chosen");
    assert!(harness.query_by_label("T [s]").is_some(), "over the period, in a window of its own");
    reach_as(&mut harness, Role::CheckBox, "Logarithmic");
    harness.get_by_role_and_label(Role::CheckBox, "Logarithmic").click();
    settle(&mut harness);
    assert!(plots(&harness)[0].log, "on logarithmic axes");
    press(&mut harness, "Undo");
    press(&mut harness, "Undo");
    assert_eq!(plots(&harness)[0], PlotSettings::over_time(vec!["ground.x".into()]), "each a step of undo");
    assert!(harness.query_by_label("Values of ground.x").is_some(), "over time again");
}

#[test]
fn many_panels_keep_the_least_height_and_are_reached_by_a_bar() {
    let mut harness = open(presets::OPENING);
    for name in ["deck.vx", "deck.vy", "deck.omega", "ground.x", "ground.y", "energy.kinetic"] {
        add(&mut harness, PlotSettings::over_time(vec![name.into()]));
    }
    for name in ["Displacement", "Rotation", "deck.vx"] {
        let rect = harness.get_by_label(&format!("Values of {name}")).rect();
        assert!(rect.height() >= 39.9, "{name} has room for three numbers: {rect}");
    }
}

#[test]
fn the_plots_are_copied_as_a_picture() {
    let mut harness = open(presets::OPENING);
    reach_as(&mut harness, Role::Button, "Export plots");
    press(&mut harness, "Export plots");
    harness.get_by_label("Copy as picture").click();
    harness.step();
    let copied = harness.output().platform_output.commands.iter().find_map(|command| match command {
        egui::OutputCommand::CopyImage(image) => Some(image.clone()),
        _ => None,
    });
    let image = copied.expect("an image in the clipboard");
    let dark = image.pixels.iter().filter(|p| p.r() < 0x80).count();
    assert!(image.width() >= 800 && dark > 500, "{} x {}, {dark} dark pixels", image.width(), image.height());
}

/// Over the whole run a wave falls between two points of the screen: a button leads to the hardest hit, where the chart says what
/// `waves` writes.
#[test]
fn a_wave_is_read_over_time_and_station_where_a_deck_bends() {
    assert!(open("deck-30m").query_by_label_contains("the hardest hit").is_none(), "a rigid girder has no waves");
    let mut harness = open("deck-30m-elastic");
    harness.get_by_label_contains("show the hardest hit").click();
    settle(&mut harness);
    let answer = harness.state().replay.runner.answer().expect("run").clone();
    let history = &answer.history;
    let [from, until] = harness.state().replay.playback.window.expect("the window of the hit");
    let hit = history.sections().elastic_hit(0).expect("a hit");
    assert!(from < hit.t && until > hit.t + hit.contact_time, "[{from}, {until}] holds the hit at {}", hit.t);
    let (_, most) = history.hits().hardest_pounding().expect("one hit of one girder");
    assert_eq!(harness.state().replay.playback.clock.t, most.t, "where its force is largest");
    let chart =
        harness.get_by_role_and_label(Role::Canvas, "deck: normal force N, tension +, over time and station").rect();
    harness.hover_at(chart.center());
    harness.run();
    let named = harness.query_all_by_label_contains(" MN at station ").next().expect("the value pointed to");
    let said = named.accesskit_node().value().or(named.accesskit_node().label()).unwrap_or_default();
    let value: f64 = said.split(' ').next().and_then(|n| n.replace('−', "-").parse().ok()).expect("a number");
    // Half a point beside the middle of the chart, at most, and three digits.
    let axial = |station: f64, t: f64| history.sections().forces(0, station, t).axial / 1e6;
    let (t, step) = (from.midpoint(until), (until - from) / f64::from(chart.width()));
    let near = [-1.0, 1.0].map(|way| [axial(way * 30.0 / f64::from(chart.height()), t), axial(0.0, t + way * step)]);
    let spread = near.iter().flatten().map(|other| (other - axial(0.0, t)).abs()).fold(0.0, f64::max);
    assert!((value - axial(0.0, t)).abs() < spread + 0.01 * value.abs() + 1e-3, "{said}: {}", axial(0.0, t));
}

#[test]
fn a_curve_is_found_by_typing_and_asks_for_no_run() {
    let mut harness = open(presets::OPENING);
    let number = |harness: &Window| {
        let runner = &harness.state().replay.runner;
        runner.answer().filter(|_| !runner.is_stale()).map(|answer| answer.number)
    };
    let before = number(&harness);
    add(&mut harness, PlotSettings::over_time(vec!["deck.x".into()]));
    reach_as(&mut harness, Role::Button, "Other curve");
    press(&mut harness, "Other curve");
    harness.run_steps(5);
    harness.event(egui::Event::Text("bearing1.force".into()));
    harness.run_steps(5);
    assert!(harness.query_by_label("deck.theta").is_none(), "the list is narrowed");
    harness.get_by_label("deck.bearing1.force-y").click();
    settle(&mut harness);
    assert_eq!(harness.state().files.document.scene().view.plots[0].y, ["deck.bearing1.force-y"], "chosen");
    assert!(before.is_some() && number(&harness) == before, "what is plotted changes no answer");
}

#[test]
fn plots_are_written_as_they_are_seen() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(CompareCommand::Pin);
    add(&mut harness, PlotSettings::over_time(vec!["deck.vx".into()]));
    let legend = legend(&harness, "|ΣR|");
    assert!(legend.contains("|ΣR|, run 1"), "the kept run's force: {legend}");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("plots.svg");
    harness.state_mut().apply(FileCommand::Plots(path.clone()));
    for _ in 0..3000 {
        harness.step();
        if harness.state().window.notice().is_some() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    let svg = std::fs::read_to_string(path).expect("written");
    for words in ["deck+x|wall.total", "deck+x|wall.total, run 1", "deck.x, run 1", "deck.vx, run 1"] {
        assert!(svg.contains(words), "{words}");
    }
}
