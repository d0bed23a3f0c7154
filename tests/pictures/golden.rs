//! Pictures against blessed ones: the one place that says how much may differ.

use std::path::{Path, PathBuf};

use girderbench::render::{Image, Packing};

/// A pixel differs when its colour is this far off, as a share of black to white, in the YIQ space that weighs what an
/// eye sees: below it are rounding and smoothing, a moved line or letter is far above.
const PIXEL: f64 = 0.06;
/// How many pixels of a picture may differ. Two software rasterisers of the same list differ in about 0.04 %, at
/// edges; a missing glyph or a moved label at 640 × 360 is 0.1 % and more.
const SHARE: f64 = 0.000_8;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots")
}

fn write(path: &Path, bytes: &[u8]) {
    let folder = path.parent().expect("a snapshot lies in a folder");
    std::fs::create_dir_all(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    std::fs::write(path, bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
}

/// Compares a picture with the blessed one of that name; `GIRDERBENCH_BLESS=1` blesses it instead.
///
/// # Errors
/// What is wrong, in words; the picture and the difference then lie in `tests/snapshots/failed`.
#[expect(clippy::print_stdout, reason = "how far a picture is from failing is worth a line")]
pub(crate) fn check(name: &str, image: &Image, texts: &[(&str, String)]) -> Result<(), String> {
    let blessed = folder().join(format!("{name}.png"));
    if std::env::var_os("GIRDERBENCH_BLESS").is_some_and(|v| v == "1") {
        write(&blessed, &image.to_png(texts, Packing::Small));
        return Ok(());
    }
    let failed = |what: String, difference: Option<Image>| {
        let failed = folder().join("failed");
        write(&failed.join(format!("{name}.png")), &image.to_png(texts, Packing::Small));
        if let Some(difference) = difference {
            write(&failed.join(format!("{name}-difference.png")), &difference.to_png(&[], Packing::Small));
        }
        Err(format!("{name}: {what}; look into {}, or bless it with GIRDERBENCH_BLESS=1", failed.display()))
    };
    let Ok(bytes) = std::fs::read(&blessed) else { return failed("there is no blessed picture".to_owned(), None) };
    let wanted = Image::from_png(&bytes).map_err(|e| format!("{name}: the blessed picture cannot be read: {e}"))?;
    if (wanted.width, wanted.height) != (image.width, image.height) {
        return failed(
            format!("{} x {} blessed, now {} x {}", wanted.width, wanted.height, image.width, image.height),
            None,
        );
    }
    let (count, difference) = compare(&wanted, image);
    let pixels = f64::from(image.width) * f64::from(image.height);
    let share = f64::from(count) / pixels;
    println!("{name}: {count} pixels differ, {:.4} %", 100.0 * share);
    if share <= SHARE {
        Ok(())
    } else {
        failed(format!("{count} pixels differ ({:.3} %)", 100.0 * share), Some(difference))
    }
}

/// How many pixels differ, and where: red on a pale copy.
fn compare(wanted: &Image, image: &Image) -> (u32, Image) {
    let mut count = 0;
    let pairs = wanted.rgba.chunks_exact(4).zip(image.rgba.chunks_exact(4));
    let rgba = pairs.flat_map(|(a, b)| {
        if distance(a, b) > PIXEL {
            count += 1;
            return [0xe0, 0x10, 0x10, 0xff];
        }
        let pale = |v: u8| 0xc0 + v / 4;
        [pale(b[0]), pale(b[1]), pale(b[2]), 0xff]
    });
    let rgba = rgba.collect();
    (count, Image { width: image.width, height: image.height, rgba })
}

/// How different two pixels look, from 0 to 1 (Kotsarenko and Ramos, "Measuring perceived color difference using YIQ
/// NTSC transmission color space in mobile applications", 2010), on white.
fn distance(a: &[u8], b: &[u8]) -> f64 {
    let on_white = |p: &[u8], i: usize| {
        let alpha = f64::from(p[3]) / 255.0;
        (f64::from(p[i]) / 255.0) * alpha + 1.0 - alpha
    };
    let d = [0, 1, 2].map(|i| on_white(a, i) - on_white(b, i));
    let y = 0.298_895_31 * d[0] + 0.586_622_47 * d[1] + 0.114_482_23 * d[2];
    let i = 0.595_977_99 * d[0] - 0.274_171_6 * d[1] - 0.321_801_9 * d[2];
    let q = 0.211_470_17 * d[0] - 0.522_617_1 * d[1] + 0.311_146_94 * d[2];
    (0.505_3 * y * y + 0.299 * i * i + 0.195_7 * q * q).sqrt() / 0.505_3f64.sqrt()
}

#[test]
fn a_missing_glyph_is_noticed() {
    let blank = Image { width: 640, height: 360, rgba: vec![0xff; 640 * 360 * 4] };
    let mut marked = blank.clone();
    for (x, y) in (0..15).flat_map(|x| (0..15).map(move |y| (300 + x, 100 + y))) {
        marked.rgba[(y * 640 + x) * 4] = 0x20;
    }
    let (count, _) = compare(&blank, &marked);
    assert_eq!(count, 225, "a square of 15 pixels, red taken away");
    assert!(f64::from(count) / (640.0 * 360.0) > SHARE, "and that is more than may differ");
}
