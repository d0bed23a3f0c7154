//! `girderbench render --marks`: a film of marks as the paper's camera takes it, with the layout that `measure` reads.

use std::path::PathBuf;

use super::args::{RenderArgs, Wanted};
use crate::cli::failure::Failure;
use crate::cli::output::write_files;
use crate::language::said;
use crate::measure::{LAYOUT, Layout, MarkPlace, TABLE, exposed};
use crate::sim::History;
use crate::snapshot::{Instant, Shot};
use crate::view::marks::{camera, pixels, places};

/// Most pictures of a film.
const MOST_PICTURES: f64 = 100_000.0;

/// A picture at every instant of the camera, seen by one camera that keeps all marks in view.
///
/// # Errors
/// An exposure longer than the time between pictures; a span that the run does not reach or that runs backwards; too many pictures.
pub(super) fn frames(args: &RenderArgs, history: &History) -> Result<Vec<Wanted>, Failure> {
    let (from, to) = args.span(history)?;
    let rate = args.marks.rate();
    // The last one may round to just before the end.
    let count = ((to - from) * rate + 1e-9).floor() + 1.0;
    if count > MOST_PICTURES {
        let [rate, count, most] = [rate, count, MOST_PICTURES].map(|number| number.to_string());
        return Err(Failure::Input(said!("wrong-rate", "rate" => rate, "count" => count, "most" => most)));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 1e5")]
    let instants: Vec<f64> = (0..count as u32).map(|n| (from + f64::from(n) / rate).min(to)).collect();
    let size = args.size();
    let camera = Some(camera(history, &instants, f64::from(size[0]) / f64::from(size[1])));
    args.marks.check(history.scene())?;
    let still = args.shot(Instant::Peak, history.scene());
    let exposure = args.marks.exposure()?;
    let during = |t: f64| if exposure > 0.0 { exposed(t, exposure, history.end()).collect() } else { Vec::new() };
    let frame = |(n, t): (usize, f64)| Wanted {
        path: args.path(history, &format!("{:05}", n + 1)),
        shot: Shot { at: Instant::At(t), during: during(t), camera, ..still.clone() },
    };
    Ok(instants.into_iter().enumerate().map(frame).collect())
}

/// Writes where the marks are in the first picture; says so.
///
/// # Errors
/// A file that cannot be written.
pub(super) fn write_layout(args: &RenderArgs, history: &History, wanted: &[Wanted]) -> Result<String, Failure> {
    let (Some(first), scene) = (wanted.first(), history.scene()) else { return Ok(String::new()) };
    let (t, camera) = (first.shot.at.of(history), first.shot.camera(history));
    let seen = pixels(history, t, &camera, args.size());
    let mark = |(place, pixel): (crate::view::marks::Place, [f64; 2])| MarkPlace {
        body: place.girder.map_or(TABLE, |n| &scene.girders[n].name).to_owned(),
        // To a tenth of a pixel: where to look, not what is measured.
        pixel: pixel.map(|v| (10.0 * v).round() / 10.0),
        at_mm: Some([place.at.x, place.at.y].map(|v| (1e6 * v).round() / 1e3)),
    };
    let layout = Layout {
        fps: args.marks.rate(),
        from_s: t,
        pictures: Some(wanted.len()),
        mm_per_pixel: None,
        mark: places(scene).into_iter().zip(seen).map(mark).collect(),
    };
    let text = toml::to_string(&layout).unwrap_or_default();
    write_files(&args.out, &[(LAYOUT.to_owned(), text.into_bytes())])?;
    let scale = 1e3 * camera.metres_per_pixel(glam::DVec3::ZERO, f64::from(args.size()[1]));
    let path: PathBuf = args.out.join(LAYOUT);
    let (file, count) = (path.display().to_string(), layout.mark.len());
    Ok(format!("{}\n", said!("render-marks", "file" => file, "count" => count, "scale" => format!("{scale:.4}"))))
}
