//! The font of the window and of pictures.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use epaint::text::{FontData, FontDefinitions, Fonts, TextOptions};
use epaint::{FontFamily, FontId};

/// Its name.
const NAME: &str = "Ubuntu-Light";

/// One font for every family: its digits are as wide as one another, so that a clock needs no font for code.
pub fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    fonts.font_data.insert(NAME.to_owned(), FontData::from_static(epaint_default_fonts::UBUNTU_LIGHT).into());
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        fonts.families.insert(family, vec![NAME.to_owned()]);
    }
    fonts
}

/// Advance of every letter of the font, in heights of the font.
static ADVANCES: LazyLock<BTreeMap<char, f32>> = LazyLock::new(|| {
    let mut fonts = Fonts::new(TextOptions::default(), fonts());
    let mut fonts = fonts.with_pixels_per_point(1.0);
    let letters: Vec<char> = fonts.characters(&FontFamily::Proportional).keys().copied().collect();
    letters.into_iter().map(|letter| (letter, fonts.glyph_width(&FontId::proportional(1.0), letter))).collect()
});
/// Widest advance of a letter that the font lacks, with what is between letters, in heights of the font.
const OTHER: f32 = 1.3;
/// By how much kerning may widen a letter, in heights of the font, and rounding to parts of a pixel \[pixels\]. Chosen; a test in `flat`
/// compares the sum with lines as they are laid out.
const KERNING: f32 = 0.03;
const ROUNDING: f32 = 0.25;

/// A width that a line of text of this height does not exceed \[pixels\].
pub(super) fn width_bound(text: &str, size: f32) -> f32 {
    let advance = |letter: char| ADVANCES.get(&letter).copied().unwrap_or(OTHER);
    text.chars().map(|letter| (advance(letter) + KERNING) * size + ROUNDING).sum::<f32>() + ROUNDING
}
