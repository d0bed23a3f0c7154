//! Films: asked for in a dialog, written on a thread, whole or not at all.

use std::path::{Path, PathBuf};
use std::time::Duration;

use super::harness::{open, press, settle};
use super::studio;
use egui::Key;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use girderbench::app::{Command, FilmCommand, FilmFormat, FilmPlan, TimeCommand, Workbench};
use girderbench::render::Image;
use girderbench::scene::presets;

/// Opens the dialog through the menu.
fn ask(harness: &mut Harness<'_, Workbench>) -> FilmPlan {
    press(harness, "File");
    harness.get_by_label_contains("Export film…").click();
    settle(harness);
    harness.state().tasks.films.plan.expect("the dialog is open")
}

/// Goes on until nothing is being filmed.
fn finish(harness: &mut Harness<'_, Workbench>) {
    for _ in 0..6000 {
        harness.step();
        if harness.state().tasks.films.progress().is_none() {
            return;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    panic!("a film of some small pictures takes a minute");
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<_> = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()).collect();
    files.sort();
    files
}

/// A short film in small pictures.
fn short(plan: FilmPlan, format: FilmFormat) -> FilmPlan {
    assert!(plan.frames().is_some(), "the dialog opens with a film that can be made");
    FilmPlan { format, from: 0.6, to: 0.7, speed: 0.1, fps: 5.0, size: Some([160, 90]) }
}

#[test]
fn the_dialog_says_how_long_the_film_will_be() {
    let mut harness = open(presets::OPENING);
    harness.state_mut().apply(TimeCommand::Window(Some([1.0, 2.0])));
    let plan = ask(&mut harness);
    assert_eq!((plan.from, plan.to), (1.0, 2.0), "what the timeline shows");
    assert!(harness.query_by_label("251 frames, plays for 10 s").is_some(), "1 s at a tenth and 25 Hz, both ends");
    harness.get_by_label("PNG pictures").click();
    settle(&mut harness);
    harness.get_by_role_and_label(Role::SpinButton, "To").click();
    harness.run_steps(2);
    harness.event(egui::Event::Text("0.5".into()));
    harness.key_press(Key::Enter);
    settle(&mut harness);
    let plan = harness.state().tasks.films.plan.expect("open");
    assert_eq!(plan.format, FilmFormat::Png, "chosen");
    assert_eq!(plan.frames(), None, "it would end before it begins: {plan:?}");
    assert!(harness.get_by_role_and_label(Role::Button, "Choose where…").accesskit_node().is_disabled(), "not so");
    harness.key_press(Key::Escape);
    settle(&mut harness);
    assert!(harness.state().tasks.films.plan.is_none(), "closed");
}

#[test]
fn a_film_is_written_while_the_window_goes_on() {
    let Some(_studio) = studio::studio("a_film_is_written_while_the_window_goes_on") else { return };
    let folder = tempfile::tempdir().expect("a folder");
    for (format, wanted) in [(FilmFormat::Gif, "film.gif"), (FilmFormat::Png, "pictures")] {
        let mut harness = open(presets::OPENING);
        let plan = short(ask(&mut harness), format);
        harness.state_mut().apply(Command::Film(FilmCommand::Plan(plan)));
        let path = folder.path().join(wanted);
        harness.state_mut().apply(Command::Film(FilmCommand::Shoot(path.clone())));
        finish(&mut harness);
        assert!(
            harness.state().window.notice().is_some_and(|n| n.contains(wanted)),
            "{:?}",
            harness.state().window.notice()
        );
        match format {
            FilmFormat::Gif => is_a_film(&path),
            FilmFormat::Png => are_pictures(&path),
        }
    }
    assert_eq!(files(folder.path()).len(), 2, "one file and one folder, nothing else");
}

fn is_a_film(path: &Path) {
    let mut decoder = gif::DecodeOptions::new().read_info(std::fs::File::open(path).expect("written")).expect("a GIF");
    assert_eq!((decoder.width(), decoder.height()), (160, 90), "as large as asked");
    let mut changed = 0;
    for _ in 0..6 {
        let frame = decoder.read_next_frame().expect("whole").expect("0.1 s at a tenth, five a second, both ends");
        assert_eq!(frame.delay, 20, "a fifth of a second");
        changed += usize::from(frame.width) * usize::from(frame.height);
    }
    assert!(changed > 160 * 90 + 5, "later frames differ from the first");
    assert!(decoder.read_next_frame().expect("whole").is_none(), "no more than six");
}

fn are_pictures(folder: &Path) {
    let images: Vec<Image> = files(folder)
        .iter()
        .map(|path| Image::from_png(&std::fs::read(path).expect("written")).expect("a PNG"))
        .collect();
    assert_eq!(images.len(), 6, "0.1 s at a tenth, five a second, both ends");
    assert!(images.windows(2).all(|two| two[0] != two[1]), "another picture each");
}

#[test]
fn a_cancelled_film_leaves_nothing_behind() {
    let Some(_studio) = studio::studio("a_cancelled_film_leaves_nothing_behind") else { return };
    let folder = tempfile::tempdir().expect("a folder");
    for (format, inner) in [(FilmFormat::Gif, "inner/film.gif"), (FilmFormat::Png, "inner/pictures")] {
        let mut harness = open(presets::OPENING);
        let long = FilmPlan { to: 5.0, fps: 50.0, ..short(ask(&mut harness), format) };
        harness.state_mut().apply(Command::Film(FilmCommand::Plan(long)));
        harness.state_mut().apply(Command::Film(FilmCommand::Shoot(folder.path().join(inner))));
        while harness.state().tasks.films.progress().is_some_and(|(done, _)| done < 3) {
            harness.step();
            std::thread::sleep(Duration::from_millis(5));
        }
        assert!(harness.state().tasks.films.progress().is_some(), "thousands of frames are not done yet");
        assert!(!files(folder.path()).is_empty(), "something lies there while it is made");
        assert!(harness.query_by_label_contains("/2201").is_some(), "how far it is: 4.4 s at a tenth, 50 a second");
        press(&mut harness, "Cancel film");
        assert!(harness.state().tasks.films.progress().is_none(), "stopped");
        assert!(harness.state().window.notice().is_some_and(|n| n.contains("cancelled")), "said");
        assert!(files(folder.path()).is_empty(), "nothing is left of {inner}");
    }
}
