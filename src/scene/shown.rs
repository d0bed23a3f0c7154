//! Text that comes from a file, as it is shown: of bounded length, and without characters that a terminal obeys.

use std::borrow::Cow;

/// The text with every character escaped that a terminal obeys: control characters, and those that turn the direction of
/// writing.
pub fn escaped(text: &str) -> Cow<'_, str> {
    if text.chars().any(is_obeyed) { text.chars().map(escape).collect::<String>().into() } else { text.into() }
}

/// The same, cut after `most` characters.
pub fn shown(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", escaped(&text[..end])),
        None => escaped(text).into_owned(),
    }
}

/// A character as it is written out: itself, or its escape.
fn escape(c: char) -> String {
    if is_obeyed(c) { c.escape_default().to_string() } else { c.to_string() }
}

/// Whether a terminal or a page obeys it: C0 and C1 control characters, Unicode's embeddings, overrides and isolates of direction (UAX 9).
pub fn is_obeyed(c: char) -> bool {
    c.is_control() || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_obeys_is_escaped_and_other_text_is_not_touched() {
        assert_eq!(escaped("a\u{1b}[2J\u{9b}\nb\u{202e}"), r"a\u{1b}[2J\u{9b}\nb\u{202e}", "escapes");
        assert!(matches!(escaped("接触 – β = 45°"), Cow::Borrowed(_)), "any script");
    }

    #[test]
    fn a_long_text_is_cut_between_characters() {
        assert_eq!(shown("接触滑り", 2), "接触…", "by characters, not bytes");
        assert_eq!(shown("接触", 2), "接触", "as long as allowed");
    }
}
