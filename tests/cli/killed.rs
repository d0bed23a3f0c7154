//! A process that is killed while it writes leaves whole scenes behind, and its unsaved work is found.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use girderbench::files::{SceneSource, SideFile, find_beside, load_scene, load_unsaved, save_scene};
use girderbench::scene::{Scene, presets};

/// Where the child writes; set in the child alone.
const FOLDER: &str = "GIRDERBENCH_TEST_KILLED_IN";
/// Times that the process is killed.
const KILLS: u32 = 24;

/// A large scene whose every girder says which writing it is from: two halves of different writings do not agree.
fn scene(writing: u32) -> Scene {
    let mut scene = presets::load("row-of-5").expect("ships");
    let girder = scene.girders[0].clone();
    let mass = 1.0e5 + f64::from(writing);
    scene.abutments.clear();
    scene.contact.pairs.clear();
    let each = |i: u32| {
        let position = [f64::from(i) * (girder.length + 0.05), 0.0, 0.0];
        girderbench::scene::Girder { name: format!("girder{i}"), mass, position, ..girder.clone() }
    };
    scene.girders = (0..200).map(each).collect();
    scene
}

fn is_whole(scene: &Scene) -> bool {
    scene.girders.len() == 200 && scene.girders.iter().all(|g| g.mass == scene.girders[0].mass)
}

/// What the child does: writes the scene and its side file again and again, until it is killed.
#[test]
#[ignore = "runs in the process that is killed"]
fn write_for_ever() {
    let Some(folder) = std::env::var_os(FOLDER).map(PathBuf::from) else { return };
    let file = folder.join("mine.toml");
    let mut side = SideFile::create(&scene(0), &SceneSource::New, &file).expect("written");
    for writing in 1.. {
        save_scene(&scene(writing), &SceneSource::New, &file).expect("written");
        side.write(&scene(writing), &SceneSource::New).expect("written");
    }
}

fn start(folder: &Path) -> Child {
    let this = std::env::current_exe().expect("this test");
    let mut child = Command::new(this);
    child.args(["--exact", "killed::write_for_ever", "--ignored"]).env(FOLDER, folder).stdout(Stdio::null());
    child.stderr(Stdio::null()).spawn().expect("started")
}

#[test]
fn a_killed_process_leaves_whole_scenes() {
    let mut seen = Vec::new();
    for kill in 0..KILLS {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("mine.toml");
        let mut child = start(folder.path());
        while !file.is_file() {
            assert!(child.try_wait().expect("its state").is_none(), "the child writes until it is killed");
            std::thread::sleep(Duration::from_millis(1));
        }
        assert!(find_beside(&file).is_empty(), "a living process's work is its own");
        std::thread::sleep(Duration::from_micros(u64::from(kill) * 3_700));
        child.kill().expect("killed");
        child.wait().expect("ended");
        let saved = load_scene(&file, &[]).expect("the scene on the disk is whole");
        assert!(is_whole(&saved), "kill {kill}: one writing, not two halves");
        let found = find_beside(&file);
        assert_eq!(found.len(), 1, "kill {kill}: its unsaved work is found, now that nobody holds it");
        let unsaved = load_unsaved(&found[0].path).expect("the side file is whole");
        assert!(is_whole(&unsaved), "kill {kill}: one writing");
        let writings = saved.girders[0].mass - unsaved.girders[0].mass;
        assert!((0.0..=1.0).contains(&writings), "kill {kill}: nothing older than the last writing, {writings}");
        seen.push(saved.girders[0].mass);
    }
    seen.dedup();
    assert!(seen.len() > 1, "killed at different points of the writing");
}
