//! The colours of a film: at most 255 for all its pictures, so that nothing that stands still flickers.
//!
//! Colours are chosen by [`color_quant`]'s neural network from a few pictures of the film. A picture is mostly background,
//! so a colour counts by the square root of its pixels, and those that the network serves worst are added as they are: a
//! state disk of some hundred pixels keeps its colour.

use std::collections::{BTreeMap, HashMap};

use color_quant::NeuQuant;

use crate::render::Image;

/// The number that stands for "as before"; colours come before it.
pub(super) const SAME: u8 = 255;

/// Colours that are taken from the pictures as they are.
const KEPT: usize = 32;

/// Chosen colours, red, green and blue.
#[derive(Debug)]
pub(super) struct Palette {
    colours: Vec<[u8; 3]>,
}

impl Palette {
    /// Chooses from some pictures of the film.
    pub(super) fn of(pictures: &[Image]) -> Self {
        let mut counts: BTreeMap<[u8; 3], u32> = BTreeMap::new();
        for pixel in pictures.iter().flat_map(|p| p.rgba.chunks_exact(4)) {
            *counts.entry([pixel[0], pixel[1], pixel[2]]).or_default() += 1;
        }
        let few = counts.len() <= usize::from(SAME);
        let colours = if few { counts.into_keys().collect() } else { learned(&counts) };
        Self { colours }
    }

    /// Red, green and blue of each in turn; the last stands for "as before".
    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.colours.concat();
        bytes.resize(256 * 3, 0);
        bytes
    }

    /// A picture by numbers of the nearest colours.
    pub(super) fn indexed(&self, image: &Image) -> Vec<u8> {
        let mut known: HashMap<[u8; 3], u8> = HashMap::new();
        let mut last = None;
        let number = |pixel: &[u8]| {
            let colour = [pixel[0], pixel[1], pixel[2]];
            // Most pixels are like the one beside them.
            match last {
                Some((before, number)) if before == colour => number,
                _ => {
                    let number = *known.entry(colour).or_insert_with(|| self.nearest(colour));
                    last = Some((colour, number));
                    number
                }
            }
        };
        image.rgba.chunks_exact(4).map(number).collect()
    }

    #[expect(clippy::cast_possible_truncation, reason = "at most 255 colours")]
    fn nearest(&self, colour: [u8; 3]) -> u8 {
        let nearest = self.colours.iter().enumerate().min_by_key(|(_, other)| apart(**other, colour));
        nearest.map_or(0, |(number, _)| number as u8)
    }
}

/// Most colours from the network; the rest are those of the pictures that it serves worst.
fn learned(counts: &BTreeMap<[u8; 3], u32>) -> Vec<[u8; 3]> {
    let weighed = counts.iter().flat_map(|(&[r, g, b], &count)| std::iter::repeat_n([r, g, b, 255], weight(count)));
    let pixels: Vec<u8> = weighed.flatten().collect();
    let net = NeuQuant::new(3, usize::from(SAME) - KEPT, &pixels);
    let mut colours: Vec<[u8; 3]> = net.color_map_rgb().chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    let nearest = |colour: &[u8; 3]| colours.iter().map(|other| apart(*colour, *other)).min().unwrap_or(0);
    let mut served: Vec<_> = counts.iter().map(|(c, &count)| (*c, weight(count), nearest(c))).collect();
    for _ in 0..KEPT {
        let cost = |&&(_, weight, off): &&([u8; 3], usize, u32)| weight as u64 * u64::from(off);
        let Some(&(worst, ..)) = served.iter().max_by_key(cost) else { break };
        colours.push(worst);
        for (colour, _, off) in &mut served {
            *off = (*off).min(apart(*colour, worst));
        }
    }
    colours
}

/// How much a colour of so many pixels counts.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the root of a pixel count")]
fn weight(count: u32) -> usize {
    f64::from(count).sqrt().ceil() as usize
}

/// The square of the distance of two colours.
fn apart(a: [u8; 3], b: [u8; 3]) -> u32 {
    a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(rgba: Vec<u8>) -> Image {
        Image { width: u32::try_from(rgba.len() / 4).expect("small"), height: 1, rgba }
    }

    #[test]
    fn few_colours_are_kept_exactly() {
        let picture = image([[10, 20, 30, 255], [250, 0, 7, 255], [10, 20, 30, 255]].concat());
        let palette = Palette::of(std::slice::from_ref(&picture));
        let bytes = palette.bytes();
        let seen: Vec<_> =
            palette.indexed(&picture).iter().map(|&i| bytes[usize::from(i) * 3..][..3].to_vec()).collect();
        assert_eq!(seen, [[10, 20, 30], [250, 0, 7], [10, 20, 30]], "the very colours");
    }

    #[test]
    fn a_rare_colour_survives_a_large_background() {
        // A grey ramp with a blue spot of a thousandth of its pixels.
        let ramp = (0..=255_u8).flat_map(|g| [0, 1, 2].map(|more| [g, g.saturating_add(more), g, 255]));
        let mut rgba: Vec<u8> = ramp.flatten().collect::<Vec<_>>().repeat(260);
        rgba[400..1200].copy_from_slice(&[0, 114, 178, 255].repeat(200));
        let picture = image(rgba);
        let palette = Palette::of(std::slice::from_ref(&picture));
        let number = usize::from(palette.indexed(&picture)[150]);
        let seen = &palette.bytes()[number * 3..][..3];
        let apart = seen.iter().zip([0_u8, 114, 178]).map(|(a, b)| a.abs_diff(b)).max();
        assert_eq!(apart, Some(0), "the blue of a state disk, got {seen:?}");
    }
}
