//! `render`: stills and films from one call, every file or none.

use std::path::Path;

use crate::program::{Said, call};
use girderbench::render::Image;

/// A call of `render` with small pictures into a folder; `None` where nothing draws and nothing has to.
fn render(folder: &Path, args: &[&str]) -> Option<Said> {
    let out = folder.to_str().expect("a UTF-8 path");
    let said = call(&[&["render", "skew45-abutment", "--until", "1", "--size", "160x90", "--out", out], args].concat());
    let required = std::env::var_os("GIRDERBENCH_REQUIRE_GPU").is_some_and(|v| v == "1");
    assert!(said.status != Some(3) || !required, "GIRDERBENCH_REQUIRE_GPU=1, but {}", said.err);
    (said.status != Some(3)).then_some(said)
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder")
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder is there");
    let mut names: Vec<_> = entries.map(|e| e.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

fn image(folder: &Path, name: &str) -> Image {
    let bytes = std::fs::read(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    Image::from_png(&bytes).unwrap_or_else(|e| panic!("{name}: {e}"))
}

#[test]
fn frames_are_the_stills_of_their_instants() {
    let folder = folder();
    let film = ["--view", "top", "--frames", "5", "--from", "0.25", "--to", "0.75"];
    let Some(said) = render(folder.path(), &film) else { return };
    assert_eq!(said.status, Some(0), "filmed: {}", said.err);
    assert!(said.out.contains("5 frames"), "says how many: {}", said.out);
    let numbered: Vec<_> = (1..=5).map(|i| format!("skew45-abutment-top-{i:04}.png")).collect();
    assert_eq!(names_in(folder.path()), numbered, "numbered from 1, nothing beside them");
    let stills = ["--view", "top", "--at", "0.25", "--at", "0.5", "--at", "0.75"];
    render(folder.path(), &stills).expect("it has drawn before");
    for (number, at) in [(1, "0.25"), (3, "0.5"), (5, "0.75")] {
        let frame = image(folder.path(), &format!("skew45-abutment-top-{number:04}.png"));
        let still = image(folder.path(), &format!("skew45-abutment-top-{at}s.png"));
        assert!(frame == still, "frame {number} is the picture at {at} s");
    }
}

#[test]
fn a_films_camera_stands_still() {
    let folder = folder();
    // Without anything that moves or counts, `contact` frames of different instants are one picture.
    let hide = "grid,bearings,gap,contacts,resultant,cones,axes,legend,title,names";
    let film = ["--set", "motion.kind=none", "--view", "contact", "--frames", "3", "--hide", hide];
    let Some(said) = render(folder.path(), &film) else { return };
    assert!(said.out.contains("3 frames, 1 different"), "drawn once: {}{}", said.out, said.err);
    assert_eq!(names_in(folder.path()).len(), 3, "three files all the same");
    let moving = ["--view", "contact", "--frames", "3", "--from", "0.2", "--to", "0.6", "--hide", hide];
    let said = render(folder.path(), &moving).expect("it has drawn before");
    assert!(said.out.contains("3 frames, 3 different"), "a girder that moves: {}{}", said.out, said.err);
}

#[test]
fn pictures_are_written_all_or_none() {
    let folder = folder();
    let inner = folder.path().join("film");
    for (args, word) in [
        (&["--at", "0.5", "--at", "2"][..], "--at 2"),
        (&["--frames", "3", "--to", "2"], "--to 2"),
        (&["--frames", "3", "--from", "2"], "--from 2"),
        (&["--frames", "3", "--from", "0.5", "--to", "0.4"], "--to 0.4"),
        (&["--frames", "3", "--at", "0.5"], "--at"),
        (&["--frames", "0"], "--frames"),
        (&["--from", "0.5"], "--frames"),
        (&["--frames", "3", "--from", "-1"], "--from"),
    ] {
        let Some(said) = render(&inner, args) else { return };
        assert_eq!(said.status, Some(2), "{args:?}: exit status 2, said {}", said.err);
        assert!(said.err.contains(word), "{args:?} names {word}: {}", said.err);
        assert!(!inner.exists(), "{args:?}: not even the folder");
    }
}

#[test]
fn a_format_that_is_not_written_is_refused() {
    let folder = folder();
    for name in ["a.jpg", "a.JPEG", "film.mp4", "a.svg"] {
        let out = folder.path().join(name);
        let said = call(&["render", "flush-free-hit", "--out", out.to_str().expect("a UTF-8 path")]);
        assert_eq!(said.status, Some(2), "{name}: exit status 2, said {}", said.err);
        for word in [name, ".png", ".gif", "folder"] {
            assert!(said.err.contains(word), "{name}: {word} in {}", said.err);
        }
        assert!(!out.exists(), "{name}: no folder is made");
    }
}

#[test]
fn one_file_holds_one_picture() {
    let folder = folder();
    let file = folder.path().join("one.png");
    let Some(said) = render(&file, &["--at", "0.5"]) else { return };
    assert_eq!((said.status, names_in(folder.path())), (Some(0), vec!["one.png".to_owned()]), "{}", said.err);
    for args in [&["--frames", "2"][..], &["--at", "0.5", "--at", "0.6"]] {
        let said = render(&file, args).expect("it has drawn before");
        assert_eq!(said.status, Some(2), "{args:?}: exit status 2, said {}", said.err);
        assert!(said.err.contains("one.png") && said.err.contains("folder"), "{args:?}: {}", said.err);
    }
    // A file where a folder should be is found out before the run: a thousand hours of it.
    let out = folder.path().join("one.png/film");
    let out = out.to_str().expect("a UTF-8 path");
    let said = call(&["render", "skew45-abutment", "--until", "3.6e6", "--frames", "2", "--out", out]);
    assert_eq!(said.status, Some(2), "exit status 2, said {}", said.err);
}

/// Every picture of a GIF as a player shows it, with how long it stands \[hundredths of a second\].
fn played(path: &Path) -> (Vec<Image>, Vec<u16>) {
    let file = std::fs::File::open(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let mut decoder = gif::DecodeOptions::new();
    decoder.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = decoder.read_info(file).expect("a GIF");
    assert_eq!(decoder.repeat(), gif::Repeat::Infinite, "it begins again");
    let (width, height) = (decoder.width().into(), decoder.height().into());
    let mut screen = Image { width, height, rgba: vec![0; (width * height * 4) as usize] };
    let (mut images, mut delays) = (Vec::new(), Vec::new());
    while let Some(frame) = decoder.read_next_frame().expect("a whole GIF") {
        let row = usize::from(frame.width) * 4;
        for (y, pixels) in frame.buffer.chunks_exact(row).enumerate() {
            let start = ((y + usize::from(frame.top)) * width as usize + usize::from(frame.left)) * 4;
            for (old, new) in screen.rgba[start..start + row].chunks_exact_mut(4).zip(pixels.chunks_exact(4)) {
                if new[3] > 0 {
                    old.copy_from_slice(new);
                }
            }
        }
        delays.push(frame.delay);
        images.push(screen.clone());
    }
    (images, delays)
}

#[test]
fn a_gif_shows_the_frames_of_the_film() {
    let folder = folder();
    let (film, pictures) = (folder.path().join("made/film.gif"), folder.path().join("pictures"));
    let cut = ["--frames", "5", "--from", "0.25", "--to", "0.75", "--view", "top"];
    let Some(said) = render(&film, &[&cut[..], &["--fps", "30"]].concat()) else { return };
    assert_eq!(said.status, Some(0), "filmed: {}", said.err);
    assert!(said.out.contains("film.gif: 5 frames, 5 different"), "says what: {}", said.out);
    assert_eq!(names_in(&folder.path().join("made")), ["film.gif"], "one file, nothing beside it");
    let (images, delays) = played(&film);
    assert_eq!(delays, [3, 4, 3, 3, 4], "thirtieths of a second in hundredths, none lost");
    render(&pictures, &cut).expect("it has drawn before");
    for (i, shown) in images.iter().enumerate() {
        let drawn = image(&pictures, &format!("skew45-abutment-top-{:04}.png", i + 1));
        assert_eq!((shown.width, shown.height), (160, 90), "as large as asked");
        let apart = |(a, b): (&u8, &u8)| f64::from(a.abs_diff(*b));
        let mean = shown.rgba.iter().zip(&drawn.rgba).map(apart).sum::<f64>() / drawn.rgba.len() as f64;
        // 255 colours for a shaded picture: two steps of 256 on average is what the eye does not see.
        assert!(mean < 2.0, "picture {i} is the frame but for its colours: {mean:.3} apart");
        assert!(i == 0 || images[i - 1] != *shown, "picture {i} is another one");
    }
}

#[test]
fn a_gif_is_a_film_or_nothing() {
    let folder = folder();
    let film = folder.path().join("inner/film.gif");
    for (args, word) in [
        (&["--at", "0.5"][..], "--frames"),
        (&["--frames", "3", "--background", "transparent"], "--background"),
        (&["--frames", "3", "--fps", "0"], "--fps"),
        (&["--frames", "3", "--fps", "60"], "--fps"),
        (&["--fps", "20"], "--frames"),
        (&["--frames", "3", "--to", "2"], "--to 2"),
    ] {
        let Some(said) = render(&film, args) else { return };
        assert_eq!(said.status, Some(2), "{args:?}: exit status 2, said {}", said.err);
        assert!(said.err.contains(word), "{args:?} names {word}: {}", said.err);
        assert!(names_in(folder.path()).is_empty(), "{args:?}: not even the folder");
    }
}
