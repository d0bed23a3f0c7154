//! Texts in columns of a terminal.

use crate::language::is_japanese;

/// A text at the left of a column of so many places.
pub(super) fn left(text: &str, places: usize) -> String {
    format!("{text}{}", blank(text, places))
}

/// A text at the right of it.
pub(super) fn right(text: &str, places: usize) -> String {
    format!("{}{text}", blank(text, places))
}

/// Spaces from a text to the column's width: a square letter takes two places.
fn blank(text: &str, places: usize) -> String {
    let taken: usize = text.chars().map(|letter| if is_japanese(letter) { 2 } else { 1 }).sum();
    " ".repeat(places.saturating_sub(taken))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_end_at_one_place_whatever_the_letters() {
        assert_eq!(left("hits", 8), "hits    ", "a letter, a place");
        assert_eq!(left("衝突", 8), "衝突    ", "two places each");
        assert_eq!(right("必要", 8), "    必要", "at the right");
        assert_eq!(left("a longer text", 4), "a longer text", "never cut");
    }
}
