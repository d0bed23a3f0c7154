//! The pictures of a film: which files, in which order, as grey.

use std::cmp::Ordering;
use std::path::{Path, PathBuf};

use crate::cli::failure::Failure;
use crate::files;
use crate::language::{Text, said};
use crate::measure::Grey;
use crate::render::Image;

/// First bytes of a PNG picture.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Most pixels of a picture: an eight-kilopixel square.
const MOST_READ_PIXELS: u64 = 1 << 26;

/// Every picture, in the order of its name where a folder is given; as many as belong to the film.
///
/// # Errors
/// A folder that cannot be read or has none; fewer than the layout states.
pub(super) fn listed(given: &[PathBuf], count: Option<usize>) -> Result<Vec<PathBuf>, Failure> {
    let mut all = match given {
        [folder] if folder.is_dir() => in_folder(folder)?,
        files => files.to_vec(),
    };
    if let Some(count) = count {
        if all.len() < count {
            let (folder, have) = (given[0].display(), all.len());
            let what = said!("measure-too-few", "count" => count, "have" => have);
            return Err(Failure::Input(format!("{folder}: {what}")));
        }
        all.truncate(count);
    }
    if all.is_empty() {
        return Err(Failure::Input(format!("{}: {}", given[0].display(), Text::new("measure-no-pictures"))));
    }
    Ok(all)
}

fn in_folder(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let unreadable = |error: std::io::Error| {
        let found = said!("found-unreadable", "error" => error.to_string());
        Failure::Input(format!("{}: {found}: {}", folder.display(), Text::new("wrong-unreadable")))
    };
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("png")) {
            all.push(path);
        }
    }
    all.sort_by(|a, b| by_number(&a.to_string_lossy(), &b.to_string_lossy()));
    if let Some([before, after]) = hole(&all) {
        let what = said!("measure-hole", "before" => before, "after" => after);
        return Err(Failure::Input(format!("{}: {what}", folder.display())));
    }
    Ok(all)
}

/// Neighbours, by their names, whose numbers are farther apart than those of any others; none where the last numbers of names do not
/// count the pictures.
fn hole(all: &[PathBuf]) -> Option<[String; 2]> {
    let name = |path: &PathBuf| path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let numbers: Vec<u64> = all.iter().map(|path| last_number(&name(path))).collect::<Option<_>>()?;
    let steps = || numbers.windows(2).map(|pair| pair[1].saturating_sub(pair[0]));
    let usual = steps().min().filter(|step| *step > 0)?;
    let at = steps().position(|step| step != usual)?;
    Some([name(&all[at]), name(&all[at + 1])])
}

/// The last number in a name.
fn last_number(name: &str) -> Option<u64> {
    let end = name.rfind(|c: char| c.is_ascii_digit())? + 1;
    let start = name[..end]
        .rfind(|c: char| !c.is_ascii_digit())
        .map_or(0, |at| at + name[at..].chars().next().map_or(1, char::len_utf8));
    name[start..end].parse().ok()
}

/// Names by their numbers: `frame9.png` before `frame10.png`.
fn by_number(a: &str, b: &str) -> Ordering {
    let (mut a, mut b) = (a, b);
    loop {
        let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
        match (digits(a), digits(b)) {
            (0, _) | (_, 0) => match (a.chars().next(), b.chars().next()) {
                (Some(one), Some(other)) if one == other => {
                    (a, b) = (&a[one.len_utf8()..], &b[other.len_utf8()..]);
                }
                (one, other) => return one.cmp(&other),
            },
            (one, other) => {
                let [x, y] = [a[..one].trim_start_matches('0'), b[..other].trim_start_matches('0')];
                match x.len().cmp(&y.len()).then(x.cmp(y)).then(one.cmp(&other)) {
                    Ordering::Equal => (a, b) = (&a[one..], &b[other..]),
                    differs => return differs,
                }
            }
        }
    }
}

/// A picture in grey.
///
/// # Errors
/// A file that is no PNG picture, or a larger one than is read.
pub(super) fn read(path: &Path) -> Result<Grey, Failure> {
    let bytes = files::read_input(path)?;
    let wrong = |what: String| Failure::Input(format!("{}: {what}", path.display()));
    // Width and height stand in the first chunk: before memory is taken for them.
    let side = |at: usize| bytes.get(at..at + 4).and_then(|b| b.try_into().ok()).map_or(0, u32::from_be_bytes);
    let [width, height] = [side(16), side(20)];
    if bytes.starts_with(PNG) && u64::from(width) * u64::from(height) > MOST_READ_PIXELS {
        return Err(wrong(said!("measure-pixels", "width" => width, "height" => height, "most" => MOST_READ_PIXELS)));
    }
    let image =
        Image::from_png(&bytes).map_err(|error| wrong(said!("measure-no-picture", "error" => error.to_string())))?;
    // Grey pictures are expanded to two bytes a pixel, grey and alpha.
    let rgba = if image.rgba.len() == 2 * (image.width as usize) * (image.height as usize) {
        image.rgba.chunks_exact(2).flat_map(|p| [p[0], p[0], p[0], p[1]]).collect()
    } else {
        image.rgba
    };
    if rgba.len() != 4 * (image.width as usize) * (image.height as usize) {
        return Err(wrong(Text::new("measure-depth").into()));
    }
    Ok(Grey::of_rgba(image.width, image.height, &rgba))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_that_is_missing_is_a_hole() {
        let paths = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
        assert_eq!(hole(&paths(&["f1.png", "f2.png", "f3.png"])), None, "none");
        assert_eq!(hole(&paths(&["f0.png", "f5.png", "f10.png"])), None, "every fifth");
        let missing = hole(&paths(&["f1.png", "f2.png", "f4.png"]));
        assert_eq!(missing, Some(["f2.png".to_owned(), "f4.png".to_owned()]), "the third");
        assert_eq!(hole(&paths(&["a.png", "b.png", "d.png"])), None, "without numbers");
        assert_eq!(
            hole(&paths(&["f1.mp4.png", "f2.mp4.png", "f4.mp5.png"])),
            None,
            "numbers that count something else"
        );
        assert_eq!(last_number("überf0012é.png"), Some(12), "among other letters");
    }

    #[test]
    fn pictures_are_ordered_by_their_numbers() {
        let mut names = ["f10.png", "f9.png", "f1.png", "a99.png", "f010.png", "f.png", "f9b.png"];
        names.sort_by(|a, b| by_number(a, b));
        assert_eq!(names, ["a99.png", "f.png", "f1.png", "f9.png", "f9b.png", "f10.png", "f010.png"], "by number");
    }
}
