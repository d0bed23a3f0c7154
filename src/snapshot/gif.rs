//! A film as one GIF that begins again at its end.
//!
//! All pictures share one palette, and each holds only what is different from the one before: most of a film stands
//! still. GIF counts in hundredths of a second, so delays are rounded such that the whole film lasts as long as asked.

use std::collections::BTreeMap;
use std::io::Write;

use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::film::reel;
use super::palette::{Palette, SAME};
use super::{Shot, Studio};
use crate::render::GpuError;
use crate::sim::History;

/// More frames in a second are not shown by the programs that play GIFs \[Hz\].
pub const MOST_FPS: f64 = 50.0;

/// Pictures that the colours are chosen from.
const SAMPLED: usize = 8;

/// Why there is no GIF.
#[derive(Debug, thiserror::Error)]
pub enum GifError {
    /// GIF's sizes are 16 bits.
    #[error("{0} × {1} pixels: a GIF has at most 65535 on a side")]
    Size(u32, u32),
    /// It could not be written; the writer says which file.
    #[error("{0}")]
    Write(#[from] EncodingError),
}

/// The place of the part that differs, and its numbers.
struct Patch {
    left: u16,
    top: u16,
    width: u16,
    height: u16,
    pixels: Vec<u8>,
}

/// Takes the shots, all of one size, and writes them as a GIF of `fps` frames a second; `each` hears how many are
/// written. Returns how many different ones were drawn.
///
/// # Errors
///
/// Those of the device, the writer or `each`; after one of `each` the file is a GIF of the frames so far, if there are any.
pub fn gif<E: From<GpuError> + From<GifError>>(
    studio: &mut Studio,
    history: &History,
    shots: &[Shot],
    fps: f64,
    out: &mut dyn Write,
    each: &mut dyn FnMut(usize) -> Result<(), E>,
) -> Result<usize, E> {
    let [width, height] = shots.first().map_or([1, 1], |shot| shot.size);
    let side = |pixels: u32| u16::try_from(pixels).map_err(|_| GifError::Size(width, height));
    let size = [side(width)?, side(height)?];
    let palette = palette(studio, history, shots, each)?;
    let mut strip = Strip::new(out, size, &palette, fps)?;
    let mut early = BTreeMap::new();
    reel(studio, history, shots, &|image, _| palette.indexed(image), &mut |number, pixels: Vec<u8>| {
        early.insert(number, pixels);
        while let Some(pixels) = early.remove(&strip.written) {
            strip.write(pixels)?;
            each(strip.written)?;
        }
        Ok(())
    })
}

/// Colours from a few pictures of the film.
fn palette<E: From<GpuError>>(
    studio: &mut Studio,
    history: &History,
    shots: &[Shot],
    each: &mut dyn FnMut(usize) -> Result<(), E>,
) -> Result<Palette, E> {
    let count = shots.len().min(SAMPLED);
    let mut pictures = Vec::with_capacity(count);
    for i in 0..count {
        pictures.push(studio.shoot(history, &shots[i * (shots.len() - 1) / (count - 1).max(1)])?);
        each(0)?;
    }
    Ok(Palette::of(&pictures))
}

/// A GIF on its way.
struct Strip<'a> {
    encoder: Encoder<&'a mut dyn Write>,
    size: [u16; 2],
    fps: f64,
    before: Vec<u8>,
    written: usize,
}

impl<'a> Strip<'a> {
    fn new(out: &'a mut dyn Write, size: [u16; 2], palette: &Palette, fps: f64) -> Result<Self, GifError> {
        let mut encoder = Encoder::new(out, size[0], size[1], &palette.bytes())?;
        encoder.set_repeat(Repeat::Infinite)?;
        Ok(Self { encoder, size, fps: fps.clamp(0.01, MOST_FPS), before: Vec::new(), written: 0 })
    }

    fn write(&mut self, pixels: Vec<u8>) -> Result<(), GifError> {
        let patch = patch(&self.before, &pixels, self.size);
        let frame = Frame {
            delay: delay(self.written, self.fps),
            dispose: DisposalMethod::Keep,
            transparent: Some(SAME),
            left: patch.left,
            top: patch.top,
            width: patch.width,
            height: patch.height,
            buffer: patch.pixels.into(),
            ..Frame::default()
        };
        self.encoder.write_frame(&frame)?;
        self.before = pixels;
        self.written += 1;
        Ok(())
    }
}

/// How long a frame stands \[hundredths of a second\].
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 10,000")]
fn delay(number: usize, fps: f64) -> u16 {
    let until = |frames: usize| (100.0 * frames as f64 / fps).round();
    (until(number + 1) - until(number)) as u16
}

/// Rectangle that differs from the picture before; equal pixels inside are [`SAME`].
fn patch(before: &[u8], now: &[u8], [width, height]: [u16; 2]) -> Patch {
    let columns = usize::from(width);
    if before.len() != now.len() {
        return Patch { left: 0, top: 0, width, height, pixels: now.to_vec() };
    }
    let rows = || before.chunks_exact(columns).zip(now.chunks_exact(columns)).enumerate();
    let (mut left, mut right, mut top, mut bottom) = (columns, 0, usize::MAX, 0);
    for (y, (old, new)) in rows().filter(|(_, (old, new))| old != new) {
        let differs = |x: &usize| old[*x] != new[*x];
        (top, bottom) = (top.min(y), y);
        left = left.min((0..columns).find(differs).unwrap_or(columns));
        right = right.max((0..columns).rfind(differs).unwrap_or(0));
    }
    if top == usize::MAX {
        // A frame has at least one pixel.
        (left, right, top, bottom) = (0, 0, 0, 0);
    }
    let inside = rows().skip(top).take(bottom - top + 1);
    let pixels = inside.flat_map(|(_, (old, new))| {
        old[left..=right].iter().zip(&new[left..=right]).map(|(old, new)| if old == new { SAME } else { *new })
    });
    let pixels = pixels.collect();
    #[expect(clippy::cast_possible_truncation, reason = "inside of a picture whose sides are 16 bits")]
    let [left, top, width, height] = [left, top, right - left + 1, bottom - top + 1].map(|v| v as u16);
    Patch { left, top, width, height, pixels }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_whole_film_lasts_as_long_as_asked() {
        for fps in [7.0, 24.0, 30.0, 50.0] {
            let total: u32 = (0..300).map(|i| u32::from(delay(i, fps))).sum();
            assert!((f64::from(total) / 100.0 - 300.0 / fps).abs() < 0.006, "300 frames at {fps} Hz: {total} cs");
        }
    }

    #[test]
    fn a_patch_is_the_smallest_box_of_what_differs() {
        let before = vec![0; 12];
        let mut now = before.clone();
        (now[5], now[10]) = (1, 2);
        let patch = patch(&before, &now, [4, 3]);
        assert_eq!((patch.left, patch.top, patch.width, patch.height), (1, 1, 2, 2), "columns 1–2, rows 1–2");
        assert_eq!(patch.pixels, [1, SAME, SAME, 2], "and what is the same inside stays");
        let none = super::patch(&now, &now, [4, 3]);
        assert_eq!((none.width, none.height, none.pixels), (1, 1, vec![SAME]), "nothing: one pixel as before");
    }
}
