//! Opening and saving: files are whole or not there, and a saved scene opens again as it was.

use std::fs;
use std::path::Path;

use girderbench::dynamics::Model;
use girderbench::files::{FileSet, SceneSource, WriteError, check_folder, load_scene, save_scene, write_atomic};
use girderbench::scene::{Heading, Motion, Scene, presets};

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder")
}

fn load(path: &Path) -> Scene {
    load_scene(path.to_str().expect("a UTF-8 path"), &[]).unwrap_or_else(|errors| panic!("it opens: {errors}"))
}

fn count_in(folder: &Path) -> usize {
    fs::read_dir(folder).expect("the folder is there").count()
}

/// A scene whose ground moves as the file `shake.csv` beside it says.
fn write_recorded_scene(folder: &Path) -> std::path::PathBuf {
    fs::write(folder.join("shake.csv"), "t_s,a_m_s2\n0.00,0.0\n0.02,0.5\n0.04,-0.25\n").expect("the record is written");
    let text = presets::get("flush-free-hit").expect("a preset").text;
    let path = folder.join("scene.toml");
    let text = format!("{}\n[motion]\nkind = \"record\"\nfile = \"shake.csv\"\n", without_motion(text));
    fs::write(&path, text).expect("the scene is written");
    path
}

fn without_motion(text: &str) -> String {
    let mut table: toml::Table = text.parse().expect("a preset is TOML");
    table.remove("motion");
    toml::to_string(&table).expect("a table is TOML")
}

#[test]
fn a_file_is_replaced_whole_and_nothing_is_left_beside_it() {
    let folder = folder();
    let path = folder.path().join("a.txt");
    write_atomic(&path, b"old").expect("written");
    write_atomic(&path, b"new and longer").expect("replaced");
    assert_eq!(fs::read(&path).expect("there"), b"new and longer", "the new bytes");
    assert_eq!(count_in(folder.path()), 1, "no temporary file stays");
}

#[test]
fn a_file_that_cannot_be_written_is_named_and_leaves_no_trace() {
    let folder = folder();
    let path = folder.path().join("nowhere").join("a.txt");
    let error = write_atomic(&path, b"x").expect_err("the folder is missing");
    assert!(error.to_string().contains("a.txt"), "names the file: {error}");
    fs::create_dir(folder.path().join("b.txt")).expect("a folder in the way");
    write_atomic(&folder.path().join("b.txt"), b"x").expect_err("a folder stands there");
    assert_eq!(count_in(folder.path()), 1, "only the folder in the way");
}

/// Writes files of these names that get their names together.
fn write_all(folder: &Path, names: &[&str]) -> Result<(), WriteError> {
    let mut set = FileSet::default();
    names.iter().try_for_each(|name| set.add(&folder.join(name), b"1"))?;
    set.finish()
}

#[test]
fn a_set_of_files_makes_its_folder() {
    let folder = folder();
    let inner = folder.path().join("deep").join("er");
    write_all(&inner, &["a.csv", "b.csv"]).expect("written");
    assert_eq!(count_in(&inner), 2, "both and nothing else");
}

#[test]
fn where_a_folder_has_the_name_of_one_file_none_is_written() {
    let folder = folder();
    let place = folder.path().join("out");
    std::fs::create_dir_all(place.join("b.csv")).expect("a folder");
    let error = write_all(&place, &["a.csv", "b.csv", "c.csv"]).expect_err("b.csv is a folder");
    assert!(error.to_string().contains("a folder stands there"), "{error}");
    assert_eq!(std::fs::read_dir(&place).expect("there").count(), 1, "the folder alone");
}

#[test]
fn trying_a_folder_makes_nothing() {
    let folder = folder();
    let inner = folder.path().join("deep").join("er");
    check_folder(&inner).expect("it could be made");
    check_folder(folder.path()).expect("it is there");
    assert_eq!(count_in(folder.path()), 0, "neither a folder nor a file");
    fs::write(folder.path().join("file"), b"x").expect("written");
    let error = check_folder(&folder.path().join("file").join("in")).expect_err("a file is no folder");
    assert!(error.to_string().contains("file/in"), "names it: {error}");
}

#[test]
fn a_saved_preset_opens_as_it_was() {
    let folder = folder();
    for preset in presets::all() {
        let scene = presets::load(preset.name).expect("a preset");
        let path = folder.path().join(format!("{}.toml", preset.name));
        save_scene(&scene, &SceneSource::New, &path).expect("saved");
        assert_eq!(load(&path), scene, "{} comes back", preset.name);
    }
}

#[test]
fn a_record_is_read_relative_to_its_scene() {
    let folder = folder();
    let scene = load(&write_recorded_scene(folder.path()));
    let Motion::Record(record) = &scene.motion else { panic!("a record: {:?}", scene.motion) };
    let (dt, samples) = record.series().expect("it has been read");
    assert_eq!((dt, samples), (0.02, &[0.0, 0.5, -0.25][..]), "interval and samples");
}

#[test]
fn channel_interval_and_unit_of_a_record_are_the_scenes_to_state() {
    let folder = folder();
    for name in ["csmip.V2", "one-column.dat"] {
        fs::copy(Path::new("tests/data/records").join(name), folder.path().join(name)).expect("copied");
    }
    fs::write(folder.path().join("bare.acc"), "100\n-50\n").expect("written");
    let path = write_recorded_scene(folder.path());
    let set = |settings: &[&str]| {
        let settings: Vec<String> = settings.iter().map(|setting| format!("motion.{setting}")).collect();
        load_scene(&path, &settings).map_err(|errors| errors.to_string())
    };
    let series = |scene: &Scene| match &scene.motion {
        Motion::Record(record) => record.series().map(|(dt, samples)| (dt, samples.len())),
        _ => None,
    };
    let several = set(&["file=csmip.V2"]).expect_err("which of three");
    assert!(several.contains("motion.channel: found nothing") && several.contains("2 (Chan  2:  Up)"), "{several}");
    assert_eq!(series(&set(&["file=csmip.V2", "channel=3"]).expect("the third")), Some((0.005, 100)), "of three");
    let bare = set(&["file=bare.acc"]).expect_err("no interval");
    assert!(bare.contains("dt_s"), "{bare}");
    let stated = set(&["file=bare.acc", "dt_s=0.02", "unit=gal"]).expect("both stated");
    let Motion::Record(record) = &stated.motion else { panic!("a record") };
    assert_eq!(record.series(), Some((0.02, &[1.0, -0.5][..])), "in m/s²");
    let twice = set(&["file=one-column.dat", "dt_s=0.02"]).expect_err("stated twice");
    assert!(twice.contains("line 1") && twice.contains("dt_s"), "{twice}");
}

#[test]
fn components_take_their_directions_from_their_files_and_keep_them_without() {
    let (here, there) = (folder(), folder());
    for name in ["old.AT2", "numbers-first.AT2"] {
        fs::copy(Path::new("tests/data/records").join(name), here.path().join(name)).expect("copied");
    }
    let path = here.path().join("scene.toml");
    let text = presets::get("flush-free-hit").expect("a preset").text;
    let motion = "[motion]\nkind = \"record\"\nx_azimuth_deg = 60\n[[motion.component]]\nfile = \"old.AT2\"\n\
                  [[motion.component]]\nfile = \"numbers-first.AT2\"\nscale = 0.5\n";
    fs::write(&path, format!("{}\n{motion}", without_motion(text))).expect("written");
    let scene = load(&path);
    let headings = |scene: &Scene| match &scene.motion {
        Motion::Record(record) => [0, 1].map(|n| record.heading(n)),
        _ => [None; 2],
    };
    // Azimuths 270° and 90°, against 60° of world x.
    assert_eq!(headings(&scene), [Some(Heading::InPlan(-210.0)), Some(Heading::InPlan(-30.0))], "as the files state");
    let (beside, away) = (here.path().join("copy.toml"), there.path().join("copy.toml"));
    save_scene(&scene, &SceneSource::New, &beside).expect("saved");
    save_scene(&scene, &SceneSource::New, &away).expect("saved");
    assert_eq!(load(&beside), scene, "beside its files it names them");
    let ground = |scene: &Scene| Model::compile(scene).expect("a sound scene").ground.acceleration(0.123);
    let apart = (ground(&load(&away)) - ground(&scene)).length();
    assert!(apart < 1e-14 && ground(&scene).length() > 0.1, "the same ground away from them: {apart}");
    fs::remove_file(here.path().join("old.AT2")).expect("removed");
    let missing = load_scene(&path, &[]).expect_err("a file is not there").to_string();
    assert!(missing.contains("motion.component[0].file") && missing.contains("old.AT2"), "{missing}");
}

#[test]
fn a_ground_of_a_support_has_a_record_of_its_own() {
    let (here, there) = (folder(), folder());
    for name in ["old.AT2", "one-column.dat"] {
        fs::copy(Path::new("tests/data/records").join(name), here.path().join(name)).expect("copied");
    }
    let path = here.path().join("scene.toml");
    let text = presets::get("skew45-abutment").expect("a preset").text;
    let grounds = "[motion]\nkind = \"record\"\nfile = \"old.AT2\"\n[[ground]]\nname = \"bank\"\nkind = \"record\"\n\
                   file = \"one-column.dat\"\nscale = 0.5\n";
    let text = without_motion(text).replace("[[abutment]]", "[[abutment]]\nground = \"bank\"");
    fs::write(&path, format!("{text}\n{grounds}")).expect("written");
    let scene = load(&path);
    let samples = |scene: &Scene| match &scene.grounds[0].motion {
        Motion::Record(record) => record.series().map(|(dt, samples)| (dt, samples.to_vec())),
        _ => None,
    };
    assert!(samples(&scene).is_some_and(|(_, samples)| samples.len() > 10), "it has been read");
    let (beside, away) = (here.path().join("copy.toml"), there.path().join("copy.toml"));
    save_scene(&scene, &SceneSource::New, &beside).expect("saved");
    save_scene(&scene, &SceneSource::New, &away).expect("saved");
    assert_eq!(load(&beside), scene, "beside its files it names them");
    assert_eq!(samples(&load(&away)), samples(&scene), "away from them it keeps the samples");
    let scaled = load_scene(&path, &["ground.bank.scale=2".to_owned()]).expect("a number of it set");
    assert_eq!(samples(&scaled), samples(&scene), "what was read stays");
    fs::remove_file(here.path().join("one-column.dat")).expect("removed");
    let missing = load_scene(&path, &[]).expect_err("a file is not there").to_string();
    assert!(missing.contains("ground.bank.file") && missing.contains("one-column.dat"), "{missing}");
}

#[test]
fn a_scene_saved_away_from_its_record_takes_the_samples_along() {
    let (here, there) = (folder(), folder());
    let scene = load(&write_recorded_scene(here.path()));
    let (beside, away) = (here.path().join("copy.toml"), there.path().join("copy.toml"));
    save_scene(&scene, &SceneSource::New, &beside).expect("saved");
    save_scene(&scene, &SceneSource::New, &away).expect("saved");
    let series = |scene: &Scene| match &scene.motion {
        Motion::Record(record) => record.series().map(|(dt, samples)| (dt, samples.to_vec())),
        _ => None,
    };
    assert_eq!(load(&beside), scene, "beside the record, the scene still names it");
    assert_eq!(series(&load(&away)), series(&scene), "away from it, the samples are the scene's own");
}

#[test]
fn a_saved_scene_keeps_the_comments_of_the_file_that_it_was_read_from() {
    let folder = folder();
    let (mine, copy) = (folder.path().join("mine.toml"), folder.path().join("copy.toml"));
    let text = presets::get("skew45-abutment").expect("ships").text;
    fs::write(&mine, text).expect("written");
    let mut scene = load(&mine);
    scene.contact.mu_static = 0.25;
    let expected = text.replacen("mu_static = 0.20", "mu_static = 0.25", 1);
    for path in [&copy, &mine] {
        save_scene(&scene, &SceneSource::File(mine.clone()), path).expect("saved");
        assert_eq!(fs::read_to_string(path).expect("text"), expected, "one value has changed");
    }
    fs::remove_file(&mine).expect("gone");
    save_scene(&scene, &SceneSource::File(mine.clone()), &copy).expect("saved without it");
    assert_eq!(load(&copy), scene, "written anew");
}

#[test]
fn a_broken_record_is_named_in_its_scene() {
    let folder = folder();
    let path = write_recorded_scene(folder.path());
    fs::write(folder.path().join("shake.csv"), "0.00,0.0\n0.02,much\n").expect("spoilt");
    let errors = load_scene(path.to_str().expect("a UTF-8 path"), &[]).expect_err("much is no number").to_string();
    for word in ["shake.csv", "much"] {
        assert!(errors.contains(word), "{word} in {errors}");
    }
}
