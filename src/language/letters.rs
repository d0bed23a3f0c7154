//! Letters that the fonts of the window and of pictures lack.

/// Kana, and the kanji of the Japanese texts and lessons: a subset of Noto Sans CJK JP (README says how it is made).
#[cfg(feature = "render")]
pub const JAPANESE_FONT: &[u8] = include_bytes!("../../assets/fonts/japanese.otf");

/// Whether a letter is one of those: kana, kanji and the signs among them, a square each.
pub const fn is_japanese(letter: char) -> bool {
    letter >= '\u{2e80}'
}
