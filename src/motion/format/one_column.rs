//! One column of accelerations: an interval and a unit in header lines (`# dt = 0.01 s, unit = g`) or stated beside the
//! file; then one number a line.

use super::record::{Channel, Format, Orientation, RecordError, Supplement};
use super::text::{Lines, find_word, first_number, interval, number, sample};
use super::unit::Unit;
use crate::language::{Text, message};

/// This format.
pub(super) const FORMAT: Format =
    Format { name: "one column", extensions: &["dat", "acc"], contents: Text::new("record-one-column"), sniff, read };

/// Lines that may stand above the first number.
const HEADER: usize = 50;

/// Whether the first line that is no header is one number.
fn sniff(bytes: &[u8]) -> bool {
    let first = Lines::of(bytes).take(HEADER + 1).find(|line| !is_header(line));
    first.is_some_and(|line| number(line.trim()).is_some())
}

/// A blank line, a comment, or words.
fn is_header(line: &str) -> bool {
    let line = line.trim();
    line.is_empty() || line.starts_with('#') || (number(line).is_none() && line.contains(char::is_alphabetic))
}

fn read(bytes: &[u8], beside: &Supplement) -> Result<Vec<Channel>, RecordError> {
    let mut lines = Lines::of(bytes);
    let (mut dt, mut unit, mut numbers) = (None, None, Vec::new());
    while let Some(line) = lines.next() {
        let trimmed = line.trim();
        if numbers.is_empty() && is_header(trimmed) {
            dt = dt.or(stated(trimmed, &["dt", "Δt"]).and_then(|text| Some((first_number(text)?.0, lines.number))));
            unit = unit.or(unit_stated(trimmed, lines.number)?);
        } else if !(trimmed.is_empty() || trimmed.starts_with('#')) {
            numbers.push(sample(trimmed, lines.number)?);
        }
    }
    let dt = one_of("dt_s", dt, beside.dt, Text::new("record-give-interval"))?;
    let unit = one_of("unit", unit, beside.unit, Text::new("record-give-unit"))?;
    if numbers.len() < 2 {
        let remedy = Text::new("record-two-lines");
        return Err(RecordError::new(
            lines.number.max(1),
            message!("record-samples", "count" => numbers.len()),
            remedy,
        ));
    }
    let dt = interval(dt.0, dt.1)?;
    Ok(vec![Channel::converted("", Orientation::Unstated, unit.0, dt, numbers)])
}

/// Text after one of these words and `=` or `:` in a header line.
fn stated<'l>(line: &'l str, words: &[&str]) -> Option<&'l str> {
    words.iter().find_map(|word| {
        let at = find_word(line, word)?;
        let alone = !line[..at].ends_with(char::is_alphanumeric);
        let rest = line.get(at + word.len()..)?.trim_start();
        rest.strip_prefix(['=', ':']).filter(|_| alone)
    })
}

/// `unit = g`, `units: cm/s2`.
fn unit_stated(line: &str, number: u64) -> Result<Option<(Unit, u64)>, RecordError> {
    let Some(text) = stated(line, &["unit", "units"]) else { return Ok(None) };
    let word = text.trim().split([' ', ',', ';']).next().unwrap_or_default();
    let unit = Unit::of_word(word);
    let remedy = Text::new("record-units");
    unit.map(|unit| Some((unit, number)))
        .ok_or_else(|| RecordError::new(number, message!("record-unit-of", "unit" => format!("`{word}`")), remedy))
}

/// Value from the file, or from the keys beside it; not both, and one of them.
fn one_of<T>(key: &str, own: Option<(T, u64)>, beside: Option<T>, remedy: Text) -> Result<(T, u64), RecordError> {
    match (own, beside) {
        (Some((_, line)), Some(_)) => {
            Err(RecordError::new(line, message!("record-twice", "key" => key), Text::new("record-once")))
        }
        (Some(own), None) => Ok(own),
        (None, Some(beside)) => Ok((beside, 1)),
        (None, None) => Err(RecordError::new(1, Text::new("record-not-stated"), remedy)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BESIDE: Supplement = Supplement { dt: Some(0.02), unit: Some(Unit::Gal) };

    fn channel(text: &str, beside: &Supplement) -> Result<Channel, String> {
        read(text.as_bytes(), beside).map(|mut channels| channels.remove(0)).map_err(|error| error.to_string())
    }

    #[test]
    fn interval_and_unit_come_from_the_header_or_from_beside() {
        let header = channel("# A town, dt = 0.01 s, unit = g\n1\n-0.5\n", &Supplement::default()).expect("a record");
        assert_eq!((header.dt, header.samples), (0.01, vec![9.80665, -4.903_325]), "in the header");
        let words = channel("Recorded at A\nDT: 0.005\nUnits: cm/s/s\n\n100\n200\n", &Supplement::default());
        assert_eq!(words.map(|c| (c.dt, c.samples)), Ok((0.005, vec![1.0, 2.0])), "in words");
        let beside = channel("100\n\n# a gap in the paper\n200\n", &BESIDE).expect("a record");
        assert_eq!((beside.dt, beside.samples), (0.02, vec![1.0, 2.0]), "beside");
    }

    #[test]
    fn nothing_is_guessed_and_nothing_said_twice() {
        let error = |text: &str, beside: &Supplement| channel(text, beside).expect_err("no record");
        assert!(error("1\n2\n", &Supplement::default()).contains("# dt = 0.01 s"), "no interval");
        let no_unit = error("# dt = 0.01\n1\n2\n", &Supplement::default());
        assert!(no_unit.contains("# unit = g"), "{no_unit}");
        assert!(error("# dt = 0.01\n1\n2\n", &BESIDE).contains("dt_s in the file and beside it"), "twice");
        assert!(error("# dt = 0.01, unit = furlong\n1\n2\n", &Supplement::default()).contains("`furlong`"), "unknown");
        assert!(error("1\n2 3\n", &BESIDE).contains("line 2: found `2 3`"), "two columns");
        assert!(error("1\ninf\n", &BESIDE).contains("line 2"), "not finite");
        assert!(error("1\n", &BESIDE).contains("at least 2 samples"), "one");
    }
}
