//! Numbers in fixed columns, as a Fortran format in a header states them: `(8f10.6)`, `(10I8)`, `(1E15.6)`.
//!
//! Columns may stand without a blank between them, so the width counts and not the blanks.

use super::record::RecordError;
use super::text::{Lines, count as checked_count, number, quoted};
use crate::language::{Text, message};

/// Widest column that is read; Fortran's own numbers have at most 26 characters.
const WIDEST: usize = 64;
/// Most columns of a line.
const MOST: usize = 1000;

/// Columns of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Columns {
    /// Numbers of a full line.
    pub per_line: usize,
    /// Characters of each.
    pub width: usize,
}

impl Columns {
    /// The last format in brackets in a text: `units=cm/sec2(04),Format=(8F10.5)`.
    pub(super) fn find(text: &str) -> Option<Self> {
        text.rmatch_indices('(').find_map(|(at, _)| Self::parse(text[at + 1..].split(')').next()?))
    }

    /// `8f10.6`.
    fn parse(format: &str) -> Option<Self> {
        let letter = format.find(|c: char| c.is_ascii_alphabetic())?;
        let (repeat, rest) = format.split_at(letter);
        let mut letters = rest.chars();
        let known = matches!(letters.next()?.to_ascii_uppercase(), 'F' | 'E' | 'D' | 'G' | 'I');
        let per_line = if repeat.trim().is_empty() { 1 } else { repeat.trim().parse().ok()? };
        let width = letters.as_str().split('.').next()?.trim().parse().ok()?;
        let sound = known && (1..=MOST).contains(&per_line) && (1..=WIDEST).contains(&width);
        sound.then_some(Self { per_line, width })
    }

    /// Reads `count` numbers from the lines that follow, and no more.
    ///
    /// # Errors
    /// A column that is no finite number; lines that end too early.
    pub(super) fn read(self, lines: &mut Lines<'_>, count: usize) -> Result<Vec<f64>, RecordError> {
        let mut numbers = Vec::new();
        while numbers.len() < count {
            let line = lines.next_bytes().ok_or_else(|| {
                lines.ended(message!("record-sample-of", "number" => numbers.len() + 1, "count" => count))
            })?;
            let wanted = self.per_line.min(count - numbers.len());
            let found = line.trim_ascii_end().chunks(self.width);
            if found.len() > wanted || (found.len() < wanted && numbers.len() + found.len() < count) {
                let found = found.len();
                let remedy = message!("record-per-line", "count" => count, "each" => self.per_line, "wanted" => wanted);
                return Err(RecordError::new(lines.number, message!("record-columns", "found" => found), remedy));
            }
            for column in found {
                let word = String::from_utf8_lossy(column);
                let value = number(word.trim());
                numbers.push(value.ok_or_else(|| lines.wrong(&word, Text::new("record-column")))?);
            }
        }
        Ok(numbers)
    }
}

/// Count and format stated in a line above numbers: `12000 points of …`, `100 Real-header values follow …, Format= (5F15.6)`.
///
/// # Errors
/// No count or no format in that line.
pub(super) fn announced(text: &str, line: u64) -> Result<(usize, Columns), RecordError> {
    let count = checked_count(text.split_whitespace().next().unwrap_or_default(), line)?;
    let columns =
        Columns::find(text).ok_or_else(|| RecordError::new(line, quoted(text), Text::new("record-columns-format")))?;
    Ok((count, columns))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_need_no_blank_between_them() {
        let columns = Columns::find("4 points (3f6.2)").expect("a format");
        assert_eq!(columns, Columns { per_line: 3, width: 6 }, "three of six characters");
        let read = columns.read(&mut Lines::of(b"-99.00-12.34  5.00\n  1.50   \nnext\n"), 4);
        assert_eq!(read, Ok(vec![-99.0, -12.34, 5.0, 1.5]), "by the width");
    }

    #[test]
    fn too_few_too_many_and_overflown_columns_are_refused() {
        let columns = Columns { per_line: 2, width: 4 };
        let error =
            |text: &str, count| columns.read(&mut Lines::of(text.as_bytes()), count).expect_err("wrong").to_string();
        assert!(error("1.00 2.0\n", 4).contains("sample 3 of 4"), "cut off");
        assert!(error("1.00 2.0 3.0\n", 4).contains("line 1: found 3 columns"), "three in a line of two");
        assert!(error("1.00\n 2.0 3.0\n", 4).contains("line 1: found 1 columns"), "one in a line of two");
        assert!(error("****1.00\n", 2).contains("line 1: found `****`"), "Fortran's overflow");
    }

    #[test]
    fn hostile_formats_are_no_formats() {
        for format in ["(99999999999F1)", "(0F8.3)", "(1F0)", "(2X8)", "()", "(04)", "8f10.6"] {
            assert_eq!(Columns::find(format), None, "{format}");
        }
    }
}
