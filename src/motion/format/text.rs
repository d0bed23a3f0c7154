//! Lines, words and numbers of a record file: bytes in, each with its line, every number finite.

use std::borrow::Cow;

use super::record::{Orientation, RecordError};
use crate::language::{Message, Text, message};

/// Characters of a file that a complaint repeats.
const SHOWN: usize = 40;

/// Lines with their numbers from 1. Headers hold Latin-1 at times: bytes that are no UTF-8 are replaced.
#[derive(Clone, Debug)]
pub(super) struct Lines<'a> {
    rest: Option<&'a [u8]>,
    /// Number of the line given last; 0 before the first.
    pub number: u64,
}

impl<'a> Lines<'a> {
    pub(super) fn of(bytes: &'a [u8]) -> Self {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        Self { rest: (!bytes.is_empty()).then_some(bytes), number: 0 }
    }

    /// The next line as bytes, without its end.
    pub(super) fn next_bytes(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest?;
        let (line, after) = match rest.iter().position(|byte| *byte == b'\n') {
            Some(end) => (&rest[..end], Some(&rest[end + 1..])),
            None => (rest, None),
        };
        self.rest = after.filter(|after| !after.is_empty());
        self.number += 1;
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }

    /// The next line of a header, which must be there.
    pub(super) fn header(&mut self, what: Text) -> Result<Cow<'a, str>, RecordError> {
        self.next().ok_or_else(|| self.ended(what.into()))
    }

    /// The file ends where something is missing.
    pub(super) fn ended(&self, what: Message) -> RecordError {
        RecordError::new(self.number.max(1), Text::new("record-end"), message!("record-cut-off", "what" => what))
    }

    /// A complaint about the line given last.
    pub(super) fn wrong(&self, value: &str, remedy: impl Into<Message>) -> RecordError {
        RecordError::new(self.number, quoted(value), remedy)
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Cow<'a, str>;

    fn next(&mut self) -> Option<Self::Item> {
        self.next_bytes().map(String::from_utf8_lossy)
    }
}

/// Text in quotes, cut to what a line of a message holds.
pub(super) fn quoted(text: &str) -> Message {
    let text = text.trim();
    let shown: String = text.chars().filter(|c| !c.is_control()).take(SHOWN).collect();
    if text.is_empty() { Text::new("found-nothing").into() } else { format!("`{shown}`").into() }
}

/// Largest magnitude of a number of a record, as of one of a scene: squares and integrals of it stay finite.
pub(super) const LARGEST: f64 = 1e15;

/// A number up to [`LARGEST`] as Fortran and C write it: `.12E-03`, `-1.5D+00`.
pub(super) fn number(word: &str) -> Option<f64> {
    finite(word).filter(|value| value.abs() <= LARGEST)
}

fn finite(word: &str) -> Option<f64> {
    let value = match word.parse() {
        Err(_) if word.contains(['d', 'D']) => word.replace(['d', 'D'], "E").parse(),
        other => other,
    };
    value.ok().filter(|value: &f64| value.is_finite())
}

/// A word of a data line as a finite number.
pub(super) fn sample(word: &str, line: u64) -> Result<f64, RecordError> {
    number(word).ok_or_else(|| RecordError::new(line, quoted(word), Text::new("record-not-finite")))
}

/// An interval between samples, from what a header states \[s\].
pub(super) fn interval(dt: f64, line: u64) -> Result<f64, RecordError> {
    let sound = dt > 0.0 && dt <= LARGEST;
    sound
        .then_some(dt)
        .ok_or_else(|| RecordError::new(line, message!("record-interval-of", "dt" => dt), Text::new("record-interval")))
}

/// A count of samples that a header states.
pub(super) fn count(word: &str, line: u64) -> Result<usize, RecordError> {
    let whole = word.trim().parse::<usize>().ok().filter(|count| *count >= 2);
    whole.ok_or_else(|| RecordError::new(line, quoted(word), Text::new("record-count")))
}

/// Refuses another number of samples than the header states.
pub(super) fn expect_count(stated: usize, found: usize, line: u64) -> Result<(), RecordError> {
    if stated == found {
        return Ok(());
    }
    let remedy = message!("record-stated-samples", "stated" => stated);
    Err(RecordError::new(line, message!("record-samples", "count" => found), remedy))
}

/// The first number in a text and what follows it: `= 4000, DT` → 4000, `, DT`. Whatever precedes it is passed over.
pub(super) fn first_number(text: &str) -> Option<(f64, &str)> {
    let starts = |(at, c): (usize, char)| (c.is_ascii_digit() || matches!(c, '.' | '-' | '+')).then_some(at);
    for at in text.char_indices().filter_map(starts) {
        let rest = &text[at..];
        let end = rest.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E')));
        let longest = end.unwrap_or(rest.len());
        // `10e` or `5.` at the end of a sentence: as much of it as is a number.
        let found = (1..=longest).rev().find_map(|end| Some((finite(rest.get(..end)?)?, &rest[end..])));
        if found.is_some() {
            return found.filter(|(value, _)| value.abs() <= LARGEST);
        }
    }
    None
}

/// Start of a word in a text, in either case.
pub(super) fn find_word(text: &str, word: &str) -> Option<usize> {
    text.to_ascii_lowercase().find(&word.to_ascii_lowercase())
}

/// The direction that a header's words state: `360 Deg`, `90 deg`, `Up`, `Vert`, or a single token such as `270` or `UP`.
pub(super) fn orientation(text: &str) -> Orientation {
    let words: Vec<&str> =
        text.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty()).collect();
    let of_word = |word: &str| match word.to_ascii_lowercase().as_str() {
        "up" | "ud" | "u-d" | "vert" | "vertical" => Some(Orientation::Up),
        _ => None,
    };
    let azimuth = |word: &str| {
        let degrees = word.parse::<f64>().ok().filter(|degrees| (0.0..=360.0).contains(degrees));
        degrees.map(|degrees| Orientation::Azimuth(degrees % 360.0))
    };
    let in_degrees =
        words.windows(2).find(|pair| find_word(pair[1], "deg") == Some(0)).and_then(|pair| azimuth(pair[0]));
    let alone = || if let [word] = words[..] { azimuth(word) } else { None };
    in_degrees.or_else(|| words.iter().find_map(|word| of_word(word))).or_else(alone).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_in_headers() {
        assert_eq!(first_number("NPTS=   5346, DT"), Some((5346.0, ", DT")), "after a sign of equality");
        assert_eq!(first_number("at  .005 sec."), Some((0.005, " sec.")), "without a leading 0");
        assert_eq!(first_number("- 10e and"), Some((10.0, "e and")), "no exponent");
        assert_eq!(first_number("none"), None, "no number");
    }

    #[test]
    fn directions_are_found_in_headers() {
        assert_eq!(orientation("Chan  1: 360 Deg"), Orientation::Azimuth(0.0), "north");
        assert_eq!(orientation("Chan  2:  Up"), Orientation::Up, "upwards");
        assert_eq!(orientation(" 270"), Orientation::Azimuth(270.0), "alone");
        assert_eq!(orientation("Chan 3"), Orientation::Unstated, "a number of a channel is no azimuth");
    }

    #[test]
    fn lines_end_in_either_way_and_have_numbers() {
        let mut lines = Lines::of(b"a\r\nb\n\nc");
        assert_eq!(lines.by_ref().collect::<Vec<_>>(), ["a", "b", "", "c"], "four");
        assert_eq!(lines.number, 4, "counted");
    }
}
