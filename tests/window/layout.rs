//! How the window looks: its panels keep to their places, nothing is cut off, and the picture is the blessed one.

use egui::accesskit::Role;
use egui::{Key, Rect, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{
    AppearanceCommand, Export, FileCommand, LearnCommand, SelectCommand, TimeCommand, Way, Workbench, lessons,
};
use girderbench::language::{Language, Text};
use girderbench::render::Image;
use girderbench::scene::presets;
use girderbench::view::Target;

use super::harness::{bench, bench_of, builder, in_harness, open, press, settle, show, view};
use super::{golden, studio};

/// Labels of the panels, with where they are; what is scrolled out of sight is not shown and not asked.
fn labels(harness: &Harness<'_, Workbench>) -> Vec<(String, Rect)> {
    let roles = [Role::Label, Role::Button, Role::CheckBox, Role::Slider, Role::SpinButton];
    let nodes = harness.root().children_recursive();
    let named = nodes.filter(|n| roles.contains(&n.accesskit_node().role()) && !n.accesskit_node().is_hidden());
    named.map(|n| (n.accesskit_node().label().or(n.accesskit_node().value()).unwrap_or_default(), n.rect())).collect()
}

/// What a text is in the language that is shown.
fn said(key: &'static str) -> String {
    Text::new(key).to_string()
}

/// A workbench on a preset without its plots of one quantity against another, which are windows over the view.
fn beside_the_view(preset: &str) -> Workbench {
    let mut scene = presets::load(preset).expect("ships");
    scene.view.plots.retain(|plot| plot.x.is_none());
    bench_of(scene)
}

#[test]
fn panels_keep_their_words_to_themselves() {
    let sizes = [([1024.0, 640.0], 1.0), ([1280.0, 720.0], 2.0), ([2560.0, 1440.0], 1.0)];
    for preset in presets::all() {
        // One run for all sizes and languages.
        let mut harness = builder(sizes[0].0).build_ui_state(show, beside_the_view(preset.name));
        harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
        for (language, (size, scale)) in Language::ALL.into_iter().flat_map(|l| sizes.map(|size| (l, size))) {
            // Another scale takes the size with it, in the frame after.
            harness.set_pixels_per_point(scale).step();
            harness.set_size(in_harness(size));
            harness.state_mut().apply(AppearanceCommand::Language(language));
            // A panel that grows with what is in it does so frame by frame.
            harness.run_steps(10);
            let (view, window) =
                (harness.get_by_label(&said("view")).rect(), harness.get_by_label(&said("timeline")).rect());
            for (words, rect) in labels(&harness) {
                let at = format!("{} at {size:?}: \"{words}\" at {rect}", preset.name);
                assert!(rect.left() >= window.left() - 1.0 && rect.right() <= window.right() + 1.0, "inside, {at}");
                let beside = rect.center().y > view.top() && rect.center().y < view.bottom();
                let over = rect.left() < view.right() - 1.0 && rect.right() > view.left() + 1.0;
                assert!(!(beside && over), "beside the view, not over it: {at}");
            }
        }
    }
}

#[test]
fn the_view_has_most_of_the_middle() {
    let harness = open(presets::OPENING);
    let rect = view(&harness);
    assert!(rect.width() > 700.0 && rect.height() > 380.0, "room to look at 1280 × 720: {rect}");
}

#[test]
fn a_lesson_leaves_room_for_the_view_in_a_small_window() {
    let mut harness = builder([1024.0, 640.0]).build_ui_state(show, bench(presets::OPENING));
    for (number, lesson) in lessons().iter().enumerate() {
        harness.state_mut().apply(LearnCommand::Open(number));
        harness.run_steps(10);
        let rect = view(&harness);
        assert!(rect.width() >= 430.0 && rect.height() >= 280.0, "{}: {rect}", lesson.name);
        assert!(harness.query_by_label("Show: Placed").is_some(), "what gave way can be had back");
    }
}

#[test]
fn panels_fold_by_keys_and_buttons_and_come_back() {
    let mut harness = open(presets::OPENING);
    let before = view(&harness);
    for (key, pane) in [(Key::F2, "Placed"), (Key::F3, "What if"), (Key::F4, "Plots")] {
        harness.key_press(key);
        settle(&mut harness);
        let wider = view(&harness);
        assert!(wider.area() > before.area() + 10_000.0, "{pane} gives its room to the view: {before} to {wider}");
        press(&mut harness, &format!("Show: {pane}"));
        assert_eq!(view(&harness), before, "{pane} is back");
        press(&mut harness, &format!("Fold: {pane}"));
        assert_eq!(view(&harness), wider, "{pane} by its button");
        harness.key_press(key);
        settle(&mut harness);
    }
    harness.key_press(Key::F6);
    settle(&mut harness);
    assert!(view(&harness).width() > 1200.0, "all of them: {}", view(&harness));
    harness.key_press(Key::F6);
    settle(&mut harness);
    assert_eq!(view(&harness), before, "and back");
}

#[test]
fn a_panel_that_was_folded_is_folded_at_the_next_start() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = open(presets::OPENING);
    harness.state_mut().keep_in(folder.path());
    harness.key_press(Key::F2);
    settle(&mut harness);
    let mut next = open(presets::OPENING);
    assert!(next.query_by_label("Fold: Placed").is_some(), "open where nothing is kept");
    next.state_mut().keep_in(folder.path());
    settle(&mut next);
    assert!(next.query_by_label("Show: Placed").is_some(), "folded");
    assert!(next.query_by_label("Fold: Plots").is_some(), "the others are not");
}

#[test]
fn a_narrow_window_has_every_menu_and_in_the_menus_what_has_no_button() {
    for (width, language) in [400.0, 700.0, 1024.0].into_iter().flat_map(|w| Language::ALL.map(|l| (w, l))) {
        let mut harness = builder([width, 640.0]).build_ui_state(show, bench(presets::OPENING));
        harness.state_mut().apply(AppearanceCommand::Language(language));
        harness.run_steps(6);
        for menu in ["file", "edit", "presets", "learn", "views", "help"] {
            let rect = harness.get_by_role_and_label(Role::Button, &said(menu)).rect();
            assert!(rect.left() >= 0.0 && rect.right() <= width, "{width}, {language:?}: {menu} at {rect}");
        }
        let top = said("view-top");
        assert_eq!(harness.query_by_role_and_label(Role::Button, &top).is_some(), width > 720.0, "{width}: a button");
        press(&mut harness, &said("views"));
        assert!(harness.query_by_role_and_label(Role::Button, &top).is_some(), "{width}: in the menu");
    }
}

/// Everything that can be read or pressed in the row over the timeline.
fn time_row(harness: &Harness<'_, Workbench>) -> Vec<(String, Rect)> {
    let y = harness.get_by_role_and_label(Role::Button, &said("to-start")).rect().center().y;
    labels(harness).into_iter().filter(|(words, rect)| !words.is_empty() && rect.y_range().contains(y)).collect()
}

#[test]
fn nothing_lies_on_the_time_in_a_lecture_hall_or_a_narrow_window() {
    for (size, scale) in [([683.0, 427.0], 1.0), ([853.0, 480.0], 1.5), ([560.0, 400.0], 1.0), ([1024.0, 640.0], 1.0)] {
        for (lecture, language) in [false, true].into_iter().flat_map(|on| Language::ALL.map(|l| (on, l))) {
            let builder = builder(size).with_pixels_per_point(scale);
            let mut harness = builder.build_ui_state(show, bench(presets::OPENING));
            harness.state_mut().apply(AppearanceCommand::Language(language));
            harness.state_mut().view.display.sight.lecture = lecture;
            harness.run_steps(6);
            let row = time_row(&harness);
            let window = harness.get_by_label(&said("timeline")).rect().expand(1.0);
            assert!(row.iter().any(|(words, _)| words.starts_with("t = ")), "the time is told: {row:?}");
            for (n, (words, rect)) in row.iter().enumerate() {
                assert!(window.x_range().contains(rect.right()), "{size:?}: {words} ends inside");
                for (other, there) in &row[n + 1..] {
                    let over = rect.shrink(1.0).intersects(there.shrink(1.0));
                    assert!(!over, "{size:?}, {lecture}: {words} at {rect} lies on {other} at {there}");
                }
            }
        }
    }
}

#[test]
fn the_help_names_every_key_and_closes() {
    let mut harness = open(presets::OPENING);
    harness.key_press(Key::F1);
    settle(&mut harness);
    assert!(harness.state().window.help, "F1");
    assert!(harness.query_by_label("play, pause").is_some(), "the keys are listed");
    harness.key_press(Key::Escape);
    settle(&mut harness);
    assert!(!harness.state().window.help, "Esc");
}

#[test]
fn both_themes_can_be_had() {
    let mut harness = builder([1280.0, 720.0]).with_theme(Theme::Dark).build_ui_state(show, bench(presets::OPENING));
    press(&mut harness, "Light");
    assert_eq!(harness.ctx.theme(), Theme::Light, "light");
    press(&mut harness, "Dark");
    assert_eq!(harness.ctx.theme(), Theme::Dark, "dark");
}

#[test]
fn what_is_selected_can_be_framed() {
    let mut harness = open("row-of-5");
    let far = harness.state().view.viewport.camera().expect("shown").distance;
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(2))));
    harness.key_press(Key::F);
    settle(&mut harness);
    let near = harness.state().view.viewport.camera().expect("shown").distance;
    assert!(near < 0.5 * far, "one of five fills the view: from {far} to {near}");
}

#[test]
fn a_window_without_room_for_a_view_does_not_mind() {
    let mut harness = builder([1280.0, 720.0]).build_ui_state(show, bench(presets::OPENING));
    for size in [[300.0, 120.0], [1.0, 1.0], [1280.0, 720.0]] {
        harness.set_size(size.into());
        harness.run_steps(3);
    }
    assert!(harness.state().view.viewport.list().is_some(), "and the view is back");
}

/// The opening scene half way through its first hit, near in time.
fn at_a_hit(harness: &mut Harness<'_, Workbench>) {
    for _ in 0..2 {
        harness.state_mut().apply(TimeCommand::StepEvent(Way::Forward));
    }
    let t = harness.state().replay.playback.clock.t;
    harness.state_mut().apply(TimeCommand::Window(Some([t - 0.02, t + 0.05])));
    settle(harness);
    harness.remove_cursor();
    harness.run();
}

fn picture(harness: &mut Harness<'_, Workbench>) -> Image {
    let image = harness.render().expect("the harness draws");
    Image { width: image.width(), height: image.height(), rgba: image.into_raw() }
}

#[test]
fn the_whole_window_looks_as_blessed() {
    let Some(studio) = studio::studio("the_whole_window_looks_as_blessed") else { return };
    let state = bench(presets::OPENING);
    let mut harness = builder([1280.0, 720.0]).with_theme(Theme::Dark).wgpu().build_ui_state(show, state);
    at_a_hit(&mut harness);
    // How long the run took differs from run to run, and so does the width of its words.
    let mut took = harness.get_by_label_contains("real time").rect();
    took.max.x = harness.get_by_label("Timeline").rect().right();
    harness.mask(took);
    let image = picture(&mut harness);
    let texts = studio.texts(harness.state().files.document.scene(), harness.state().replay.playback.clock.t);
    golden::check("window", &image, &texts).unwrap_or_else(|problem| panic!("{problem}"));
}

#[test]
fn the_3d_view_is_drawn_in_the_window() {
    let Some(_studio) = studio::studio("the_3d_view_is_drawn_in_the_window") else { return };
    let mut harness = builder([1280.0, 720.0]).wgpu().build_ui_state(show, bench(presets::OPENING));
    harness.run();
    let rect = view(&harness);
    let image = picture(&mut harness);
    let colours: std::collections::BTreeSet<&[u8]> = image
        .rgba
        .chunks_exact(4)
        .enumerate()
        .filter(|(i, _)| {
            let (x, y) = (i % image.width as usize, i / image.width as usize);
            rect.shrink(4.0).contains(egui::pos2(x as f32, y as f32))
        })
        .map(|(_, pixel)| pixel)
        .collect();
    assert!(colours.len() > 500, "shaded bodies, not one colour: {}", colours.len());
}

#[test]
fn the_picture_is_exported_while_the_window_goes_on() {
    let Some(_studio) = studio::studio("the_picture_is_exported_while_the_window_goes_on") else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("view.png");
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(FileCommand::Export(Export::Picture, path.clone()));
    for _ in 0..3000 {
        harness.run();
        if harness.state().window.notice().is_some() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    let bytes = std::fs::read(&path).unwrap_or_else(|e| panic!("{e}: {:?}", harness.state().window.notice()));
    let image = Image::from_png(&bytes).expect("a PNG");
    let rect = view(&harness);
    assert_eq!((image.width as f32, image.height as f32), (rect.width(), rect.height()), "as large as the view");
}
