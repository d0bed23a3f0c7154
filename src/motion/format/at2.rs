//! PEER's .AT2: four header lines, then accelerations in g, five a line.
//!
//! The fourth line has the count and the interval, `NPTS=  4000, DT= .01000 SEC` or, numbers first, `4000 .01 NPTS, DT`;
//! the third the unit; the second ends in the azimuth of the component, or in `UP`.

use super::record::{Channel, Format, Orientation, RecordError, Supplement};
use super::text::{Lines, count, expect_count, find_word, first_number, interval, orientation, quoted, sample};
use super::unit::Unit;
use crate::language::Text;

/// This format.
pub(super) const FORMAT: Format =
    Format { name: "PEER AT2", extensions: &["at2"], contents: Text::new("record-at2"), sniff, read };

/// Whether count and interval stand in the fourth line.
fn sniff(bytes: &[u8]) -> bool {
    Lines::of(bytes).nth(3).is_some_and(|line| find_word(&line, "NPTS").is_some() && find_word(&line, "DT").is_some())
}

fn read(bytes: &[u8], beside: &Supplement) -> Result<Vec<Channel>, RecordError> {
    beside.nothing(Text::new("record-states-at2"))?;
    let mut lines = Lines::of(bytes);
    lines.header(Text::new("record-header"))?;
    let name = lines.header(Text::new("record-station-line"))?;
    let unit = unit(&lines.header(Text::new("record-unit-line"))?, lines.number)?;
    let (wanted, dt) = size(&lines.header(Text::new("record-count-line"))?, lines.number)?;
    let (mut numbers, mut last) = (Vec::new(), ["", ""].map(str::to_owned));
    while let Some(line) = lines.next() {
        for word in line.split_ascii_whitespace() {
            numbers.push(sample(word, lines.number)?);
            let [_, before] = last;
            last = [before, word.to_owned()];
        }
    }
    expect_count(wanted, numbers.len(), lines.number)?;
    if !bytes.ends_with(b"\n") && is_cut(&last) {
        return Err(RecordError::new(lines.number, quoted(&last[1]), Text::new("record-cut-number")));
    }
    Ok(vec![Channel::converted(&name, component(&name), unit, dt, numbers)])
}

/// Whether of the last two numbers, all of one width with an exponent, the last one is shorter than the one before, signs apart: the file
/// ends within it.
fn is_cut([before, last]: &[String; 2]) -> bool {
    let width = |word: &str| word.trim_start_matches(['-', '+']).len();
    before.contains(['E', 'e']) && width(last) < width(before)
}

/// `ACCELERATION TIME SERIES IN UNITS OF G`.
fn unit(text: &str, line: u64) -> Result<Unit, RecordError> {
    const UNITS: &str = "UNITS OF";
    let words = find_word(text, UNITS).and_then(|at| text.get(at + UNITS.len()..)).unwrap_or_default();
    let unit = words.split_whitespace().next().and_then(Unit::of_word);
    unit.filter(|_| find_word(text, "ACCEL").is_some())
        .ok_or_else(|| RecordError::new(line, quoted(text), Text::new("record-at2-unit")))
}

/// Count and interval \[s\].
fn size(text: &str, line: u64) -> Result<(usize, f64), RecordError> {
    let stated = || {
        let after = |word: &str| find_word(text, word).and_then(|at| text.get(at + word.len()..));
        let numbers_first = text.trim_start().starts_with(|c: char| c.is_ascii_digit() || c == '.');
        if numbers_first {
            let (points, rest) = first_number(text)?;
            return Some((points, first_number(rest)?.0));
        }
        Some((first_number(after("NPTS")?)?.0, first_number(after("DT")?)?.0))
    };
    let (points, dt) = stated().ok_or_else(|| RecordError::new(line, quoted(text), Text::new("record-at2-size")))?;
    Ok((count(&points.to_string(), line)?, interval(dt, line)?))
}

/// `EL CENTRO ARRAY #9, 270 (USGS STATION 117)`: the last field, its first word.
fn component(name: &str) -> Orientation {
    let field = name.rsplit(',').next().unwrap_or_default();
    orientation(field.split('(').next().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(fourth: &str, data: &str) -> Result<Vec<Channel>, RecordError> {
        let text =
            format!("PEER\nA QUAKE, A TOWN, 270 (STATION 1)\nACCELERATION IN UNITS OF G. HP=0.2\n{fourth}\n{data}");
        read(text.as_bytes(), &Supplement::default())
    }

    #[test]
    fn the_fourth_line_is_written_in_three_ways() {
        for line in [
            "NPTS=  4, DT= .01000 SEC",
            "NPTS=   4, DT=   .0100 SEC,        ",
            "4 .01 NPTS, DT",
            "   4    0.0100    NPTS, DT",
        ] {
            let channel = &with(line, " .1E-01 -.2E-01\n .3 1.0\n").expect("a record")[0];
            assert_eq!((channel.dt, channel.samples.len()), (0.01, 4), "{line}");
            assert!((channel.samples[3] - 9.80665).abs() < 1e-15, "one g");
            assert_eq!(channel.orientation, Orientation::Azimuth(270.0), "in the second line");
        }
    }

    #[test]
    fn a_count_that_is_wrong_or_hostile_is_refused() {
        let error = |fourth: &str, data: &str| with(fourth, data).expect_err("no record").to_string();
        let short = error("NPTS= 4, DT= .01 SEC", ".1 .2 .3\n");
        assert!(short.starts_with("line 5: found 3 samples; the header states 4 samples"), "{short}");
        assert!(error("NPTS= 2, DT= .01 SEC", ".1 .2 .3\n").contains("found 3 samples"), "one too many");
        for hostile in
            ["NPTS=1e18, DT= .01", "NPTS= 99999999999999999999, DT=.01", "NPTS= -4, DT=.01", "NPTS= 2.5, DT=.01"]
        {
            assert!(with(hostile, ".1 .2 .3\n").is_err(), "{hostile}");
        }
        assert!(error("NPTS= 3, DT= 0 SEC", ".1 .2 .3\n").contains("greater than 0"), "no interval");
        assert!(error("NPTS= 3, DT= .01 SEC", ".1 nan .3\n").contains("line 5: found `nan`"), "no number");
    }

    #[test]
    fn a_file_that_ends_within_its_last_number_is_refused() {
        let last = |end: &str| with("NPTS= 2, DT= .01 SEC", &format!("  -.3540000E-01  {end}")).map(|_| ());
        assert_eq!(last(".1200000E-02"), Ok(()), "whole, without an end of the line");
        for cut in [".1200000E-0", ".1200000", "-.12"] {
            assert!(last(cut).expect_err("cut").to_string().contains(cut), "{cut}");
            assert_eq!(last(&format!("{cut}\n")), Ok(()), "{cut}, a line of its own");
        }
    }

    #[test]
    fn velocities_are_refused() {
        let text = "PEER\nA, 1\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01\n1 2\n";
        let error = read(text.as_bytes(), &Supplement::default()).expect_err("a velocity").to_string();
        assert!(error.contains("line 3") && error.contains("velocities"), "{error}");
    }
}
