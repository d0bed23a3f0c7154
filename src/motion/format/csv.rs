//! A ground motion as a two-column table: time in s, acceleration, one line a sample.
//!
//! Bytes in, never a path. Lines that start with `#` are comments; a first line without numbers is a heading, which may state the unit
//! of the acceleration (`t [s], a [gal]`, `acc_g`). Without a unit there or beside the file the unit is m/s². Blank lines are skipped.
//! Columns are separated by commas, semicolons or tabs; the decimal mark is a point or a comma. The samples must be evenly spaced; the
//! first one is the acceleration at t = 0, whatever its own time.

use csv::{Reader, ReaderBuilder, StringRecord, Trim};

use super::heading::{in_seconds, unit_of_heading};
use super::record::{Channel, Format, Orientation, RecordError, Supplement};
use super::text::{LARGEST, quoted};
use super::unit::Unit;
use crate::language::{Text, message};

/// Times may be off by this part of the interval; a recorder's clock is better.
const UNEVEN: f64 = 0.01;
/// Unit u of the last digit of printed times, per interval Δt, below which a missing sample is found for certain \[–\]: it moves some time
/// by at least Δt/2 off the straight line through the first and the last, rounding takes u of that away, and the rest must exceed the
/// deviation u that is allowed: Δt/2 − u > u.
const FINE: f64 = 0.25;
/// Separators of columns. Between commas only a quoted number has a decimal comma.
const SEPARATORS: [u8; 3] = [b',', b';', b'\t'];

/// This format.
pub(super) const FORMAT: Format =
    Format { name: "CSV", extensions: &["csv", "txt"], contents: Text::new("record-csv"), sniff, read };

/// Whether two numbers stand in the first line, or in the second below a heading.
fn sniff(bytes: &[u8]) -> bool {
    separator(bytes).is_some()
}

/// Separator of the columns, if there are two of numbers.
fn separator(bytes: &[u8]) -> Option<u8> {
    let starts = |separator: u8| {
        let records = reader(bytes, separator).into_records().filter(|record| !record.as_ref().is_ok_and(is_blank));
        records.take(2).any(|record| record.is_ok_and(|record| sample(&record, 0).is_ok()))
    };
    SEPARATORS.into_iter().find(|&separator| starts(separator))
}

fn reader(bytes: &[u8], separator: u8) -> Reader<&[u8]> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut builder = ReaderBuilder::new();
    builder.delimiter(separator).has_headers(false).flexible(true).comment(Some(b'#')).trim(Trim::All);
    builder.from_reader(text)
}

/// Reads a record.
///
/// # Errors
/// The first line that is not two numbers, or that breaks the even spacing; points and commas as decimal marks in one file;
/// fewer than two samples.
fn read(bytes: &[u8], beside: &Supplement) -> Result<Vec<Channel>, RecordError> {
    Supplement { unit: None, ..*beside }.nothing(Text::new("record-states-csv"))?;
    let (mut times, mut samples, mut marks, mut stated) = (Vec::new(), Vec::new(), None, None);
    for (n, record) in reader(bytes, separator(bytes).unwrap_or(b',')).records().enumerate() {
        let record = record.map_err(|error| unreadable(&error))?;
        let line = record.position().map_or(0, csv::Position::line);
        match sample(&record, line) {
            Ok(sample) => {
                one_mark(&record, line, &mut marks)?;
                times.push(Time { line, t: sample.0, digits: Digits::of(&record[0]) });
                samples.push(sample.1);
            }
            Err(_) if is_blank(&record) => {}
            Err(_) if n == 0 && is_heading(&record) => {
                in_seconds(&record[0], line)?;
                match (unit_of_heading(&record[1], line), beside.unit) {
                    (Ok(unit), _) => stated = unit,
                    // Who states the unit beside the file has read the heading.
                    (Err(error), None) => return Err(error),
                    (Err(_), Some(_)) => {}
                }
            }
            Err(error) => return Err(error),
        }
    }
    let assumed = stated.or(beside.unit).is_none();
    let unit = match (stated, beside.unit) {
        (Some(stated), Some(beside)) if stated != beside => {
            let value = message!("record-units-differ", "stated" => stated.label(), "beside" => beside.label());
            return Err(RecordError::new(1, value, Text::new("record-unit-once")));
        }
        (stated, beside) => stated.or(beside).unwrap_or(Unit::MetrePerSecond2),
    };
    let mut channel = Channel::converted("", Orientation::Unstated, unit, interval(&times)?, samples);
    if assumed {
        channel.done.push(message!("record-unit-assumed", "unit" => unit.label()));
    }
    if let Some(begin) = times.first().map(|time| time.t).filter(|begin| *begin != 0.0) {
        channel.done.push(message!("record-begins", "begin" => begin));
    }
    Ok(vec![channel])
}

fn unreadable(error: &csv::Error) -> RecordError {
    let line = error.position().map_or(0, csv::Position::line);
    RecordError::new(line, Text::new("record-no-text"), Text::new("record-save-text"))
}

/// A heading has two columns, and no number in either.
fn is_heading(record: &StringRecord) -> bool {
    record.len() == 2 && record.iter().all(|field| number(field).is_none())
}

/// Whether there are only blanks and separators.
fn is_blank(record: &StringRecord) -> bool {
    record.iter().all(str::is_empty)
}

/// A number up to [`LARGEST`] with a decimal point or a decimal comma.
pub(crate) fn number(field: &str) -> Option<f64> {
    let value = match field.split_once(',') {
        Some((_, fraction)) if field.contains('.') || fraction.contains(',') => return None,
        Some(_) => field.replace(',', ".").parse(),
        None => field.parse(),
    };
    value.ok().filter(|value: &f64| value.abs() <= LARGEST)
}

fn sample(record: &StringRecord, line: u64) -> Result<(f64, f64), RecordError> {
    let wrong = |value: &str, remedy: Text| RecordError::new(line, quoted(value), remedy);
    let fields: Vec<&str> = record.iter().collect();
    let [t, a] = fields[..] else {
        return Err(wrong(&fields.join(","), Text::new("record-two-columns")));
    };
    let t = number(t).ok_or_else(|| wrong(t, Text::new("record-time-finite")))?;
    let a = number(a).ok_or_else(|| wrong(a, Text::new("record-acceleration-finite")))?;
    Ok((t, a))
}

/// Refuses a file in which both point and comma are decimal marks: one of them would separate thousands.
fn one_mark(record: &StringRecord, line: u64, mark: &mut Option<char>) -> Result<(), RecordError> {
    for field in record {
        let here = field.chars().find(|c| ['.', ','].contains(c));
        if here.is_some_and(|here| mark.is_some_and(|before| before != here)) {
            return Err(RecordError::new(line, quoted(field), Text::new("record-marks")));
        }
        *mark = mark.or(here);
    }
    Ok(())
}

/// The time of a sample.
struct Time {
    line: u64,
    /// \[s\]
    t: f64,
    digits: Digits,
}

/// Format of a printed number.
#[derive(Clone, Copy)]
struct Digits {
    /// Digits after the decimal mark, fewer by the exponent.
    decimals: i32,
    /// Digits from the first that is no 0.
    significant: i32,
}

impl Digits {
    fn of(field: &str) -> Self {
        let (mantissa, exponent) = field.split_once(['e', 'E']).unwrap_or((field, "0"));
        let fraction = mantissa.split_once(['.', ',']).map_or("", |(_, fraction)| fraction);
        let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
        let count = |text: &str| i32::try_from(text.len()).unwrap_or(i32::MAX);
        let decimals = count(fraction).saturating_sub(exponent.parse().unwrap_or(0));
        Self { decimals, significant: count(digits.trim_start_matches('0')) }
    }
}

/// The largest unit of a last digit \[s\] if all times are printed with one number of decimals, and if with one number of
/// significant digits. Zeros at the end may be missing, so the longest number tells.
fn printed_to(times: &[Time]) -> [f64; 2] {
    let decimals = times.iter().map(|time| time.digits.decimals).max().unwrap_or(0);
    let significant = times.iter().map(|time| time.digits.significant).max().unwrap_or(1);
    let largest = times.iter().map(|time| time.t.abs()).fold(0.0, f64::max);
    let leading = if largest > 0.0 { largest.log10().floor() + 1.0 } else { 0.0 };
    [10_f64.powi(decimals.saturating_neg()), 10_f64.powf(leading - f64::from(significant))]
}

/// The interval between samples, if there is one.
///
/// Rounded times may be off by half a unit of their last digit, and the first and the last, by which the others are judged,
/// by as much.
fn interval(times: &[Time]) -> Result<f64, RecordError> {
    let (Some(Time { t: first, .. }), Some(Time { t: last, line: last_line, .. })) = (times.first(), times.last())
    else {
        return Err(RecordError::new(1, Text::new("record-no-samples"), Text::new("wrong-too-few-samples")));
    };
    let dt = (last - first) / (times.len() - 1) as f64;
    if times.len() < 2 || dt <= 0.0 {
        let value = message!("record-time", "t" => short(*last));
        return Err(RecordError::new(*last_line, value, Text::new("record-growing")));
    }
    // The steps that most of the times take tell which one is at fault: a missing sample changes the mean interval.
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1].t - pair[0].t).collect();
    steps.sort_by(f64::total_cmp);
    let usual = steps[steps.len() / 2];
    let units = printed_to(times);
    let rounding = units.into_iter().filter(|&unit| unit < FINE * dt).fold(0.0, f64::max);
    let off = |(n, time): (usize, &Time)| (time.t - (first + dt * n as f64)).abs();
    match times.iter().enumerate().find(|&time| off(time) > rounding.max(UNEVEN * dt)) {
        None => Ok(dt),
        Some((n, time)) => {
            Err(match times.windows(2).find(|pair| (pair[1].t - pair[0].t - usual).abs() > 0.5 * usual) {
                Some(pair) if usual > 0.0 => uneven(&pair[1], (usual, pair[0].t + usual), units[0]),
                _ => uneven(time, (dt, first + dt * n as f64), units[0]),
            })
        }
    }
}

/// A time in a message, by its power of ten where it is beyond any recorder's clock.
fn short(time: f64) -> String {
    if time.abs() < 1e15 { time.to_string() } else { format!("{time:e}") }
}

/// A time that is not where its number in the file has it.
fn uneven(time: &Time, (dt, expected): (f64, f64), unit: f64) -> RecordError {
    let off = (time.t - expected).abs();
    let coarse =
        if unit >= FINE * dt && off <= unit { message!("record-coarse", "unit" => unit) } else { String::new().into() };
    let [dt, off] = [format!("{dt:.6e}"), format!("{off:.1e}")];
    let remedy = message!("record-uneven", "dt" => dt, "expected" => short(expected), "off" => off, "coarse" => coarse);
    RecordError::new(time.line, message!("record-time", "t" => short(time.t)), remedy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(bytes: &[u8]) -> Result<Channel, RecordError> {
        read(bytes, &Supplement::default()).map(|mut channels| channels.remove(0))
    }

    fn error(text: &str) -> String {
        table(text.as_bytes()).expect_err("it is no record").to_string()
    }

    #[test]
    fn heading_comments_and_a_later_start_are_read_over() {
        let text = "\u{feff}# El Centro\nt_s, a_m_s2\n1.00, 0.5\n1.02, -0.25\n# a gap in the paper\n1.04, 1e-3\n";
        let series = table(text.as_bytes()).expect("a record");
        assert_eq!(series.samples, [0.5, -0.25, 1e-3], "in order");
        assert!((series.dt - 0.02).abs() < 4.0 * f64::EPSILON, "from rounded times: {}", series.dt);
    }

    #[test]
    fn a_heading_states_the_unit_or_it_is_stated_beside_the_file_or_it_is_si() {
        let of = |heading: &str, beside: Option<Unit>| {
            let text = format!("{heading}\n0,100\n0.5,200\n");
            let beside = Supplement { unit: beside, dt: None };
            read(text.as_bytes(), &beside).map(|channels| (channels[0].unit, channels[0].samples[1]))
        };
        for heading in ["t [s],a [gal]", "t,acc (cm/s2)", "time_s,a_cm_s2", "t,acc gal"] {
            assert_eq!(of(heading, None), Ok((Unit::Gal, 2.0)), "{heading}");
        }
        assert_eq!(of("t,acc_g", None), Ok((Unit::G, 200.0 * 9.80665)), "by its last word");
        for heading in ["t_s,a_m_s2", "t,a", "t [s],a [m/s²]"] {
            assert_eq!(of(heading, None), Ok((Unit::MetrePerSecond2, 200.0)), "{heading}");
        }
        assert_eq!(of("t,a", Some(Unit::Gal)), Ok((Unit::Gal, 2.0)), "beside the file");
        assert_eq!(of("t,a [gal]", Some(Unit::Gal)), Ok((Unit::Gal, 2.0)), "the same twice");
        let refused = |heading: &str, beside: Option<Unit>| of(heading, beside).expect_err("refused").to_string();
        assert!(refused("t,a [gal]", Some(Unit::G)).contains("gal in the heading, g beside"), "one against the other");
        assert!(refused("t,a [counts]", None).contains("`counts`"), "no unit");
        for heading in
            ["t,a_mm/s2", "t,acc mm/s2", "t,acc_mg", "t,a ft/s2", "t,a_milli_g", "t,displacement_m", "t,vel_cm/s"]
                .into_iter()
                .chain(["t,mg", "t,mm", "t,v_m_s", "t,force_n", "t,deck.x", "t,deck.axial_mid"])
        {
            assert!(refused(heading, None).contains("unit"), "{heading}");
            assert_eq!(of(heading, Some(Unit::Gal)), Ok((Unit::Gal, 2.0)), "{heading}, stated beside the file");
        }
        for heading in ["t,g", "t,a/g", "t,acc x g"] {
            assert_eq!(of(heading, None), Ok((Unit::G, 200.0 * 9.80665)), "{heading}");
        }
        for heading in
            ["t,acc_x", "t,acceleration ns", "t,ground acceleration", "t,ax", "t,ground.x", "t,st1.acc", "t,Acc."]
        {
            assert_eq!(of(heading, None), Ok((Unit::MetrePerSecond2, 200.0)), "{heading}");
        }
        assert!(refused("t [ms],a [gal]", None).contains("times in ms"), "no seconds");
    }

    /// A channel of a table that states no unit, of two samples a second.
    fn without_unit(samples: Vec<f64>) -> Channel {
        let done = vec![message!("record-unit-assumed", "unit" => "m/s²")];
        Channel { done, ..Channel::plain(0.5, samples) }
    }

    #[test]
    fn a_table_that_begins_late_is_said_to() {
        let done = |text: &str| read(text.as_bytes(), &Supplement::default()).expect("two samples")[0].done.len();
        let [from_zero, late, assumed] = ["a_m_s2\n0,1\n0.01,2\n", "a_m_s2\n5,1\n5.01,2\n", "a\n0,1\n0.01,2\n"]
            .map(|text| done(&format!("t,{text}")));
        assert_eq!([from_zero, late], [0, 1], "times counted from the first");
        assert_eq!(assumed, 1, "no unit is stated");
    }

    #[test]
    fn a_complaint_names_line_value_and_remedy() {
        assert_eq!(
            error("0,1\n0.01,abc\n"),
            "line 2: found `abc`; the acceleration must be a number no larger than 1e15",
            "word"
        );
        assert!(error("0,1\n0.01,inf\n").starts_with("line 2: found `inf`"), "infinite");
        assert!(
            error("0,1\n0.01,-1e16\n").starts_with("line 2: found `-1e16`"),
            "of which the square is beyond what is drawn"
        );
        assert!(error("0,1\n0.01,2,3\n").contains("line 2: found `0.01,2,3`; give two columns"), "three columns");
        assert!(error("t,a\n0,1\nt,a\n").contains("line 3"), "a heading stands first only");
    }

    #[test]
    fn uneven_standing_or_missing_times_are_refused() {
        let uneven = error("0,1\n0.01,1\n0.025,1\n0.03,1\n");
        assert!(uneven.contains("line 3: found time 0.025") && uneven.contains("belongs at 0.02 s"), "{uneven}");
        assert!(error("0,1\n0,1\n").contains("times that grow"), "no interval");
        assert!(error("0,1\n").contains("at least 2 samples"), "one");
        assert!(error("").contains("at least 2 samples"), "none");
    }

    #[test]
    fn times_may_be_rounded_in_their_last_digit() {
        let series = |printed: &dyn Fn(f64) -> String| {
            let lines: Vec<_> = (0..6001).map(|i| format!("{},{}", printed(f64::from(i) / 60.0), i % 7)).collect();
            table(lines.join("\n").as_bytes()).expect("a record at 60 Hz").dt
        };
        // The interval is off by a unit of the last digit over the whole record.
        let unit = |dt: f64, unit: f64| assert!((dt - 1.0 / 60.0).abs() <= unit / 6000.0, "{dt}, to {unit}");
        unit(series(&|t| format!("{t:.3}")), 1e-3);
        unit(series(&|t| format!("{t:.3}").trim_end_matches('0').to_owned()), 1e-3);
        unit(series(&|t| format!("{t:.5e}")), 1e-3);
        unit(series(&|t| format!("{:.3}", t + 1e6)), 1e-3);
    }

    #[test]
    fn a_missing_sample_is_no_rounding() {
        let without = |gap: u32| {
            let kept = (0..2001).filter(|&i| i != gap);
            let lines: Vec<_> = kept.map(|i| format!("{:.2},1", f64::from(i) * 0.0425)).collect();
            table(lines.join("\n").as_bytes())
        };
        (1..2000).step_by(37).for_each(|gap| assert!(without(gap).is_err(), "sample {gap} is missing"));
        assert!(without(5000).is_ok(), "none is missing");
        let coarse = error("0.00,1\n0.01,1\n0.01,1\n0.02,1\n0.02,1\n0.03,1\n");
        assert!(coarse.contains("print the times with more digits than to 0.01 s"), "{coarse}");
    }

    #[test]
    fn decimal_commas_are_read_where_something_else_separates_the_columns() {
        let wanted = without_unit(vec![0.25, -1.5, 2.0]);
        for text in [
            "0,0;0,25\n0,5;-1,5\n1,0;2\n",
            "t;a\n0,0;0,25\n0,5;-15e-1\n1;2\n",
            "0,0\t0,25\n0,5\t-1,5\n1,0\t2\n",
            "0.0;0.25\n0.5;-1.5\n1.0;2\n",
            "\"0,0\",\"0,25\"\n\"0,5\",\"-1,5\"\n\"1,0\",2\n",
        ] {
            assert_eq!(table(text.as_bytes()).as_ref(), Ok(&wanted), "{text}");
        }
        assert!(error("0,00,0,25\n0,50,1,5\n").contains("separated by semicolons"), "what to do");
        let mixed = error("0,0;0,25\n0,5;1.5\n");
        assert!(mixed.contains("line 2") && mixed.contains("`1.5`") && mixed.contains("decimal mark"), "{mixed}");
        assert!(error("0;1\n0,5;1.234,5\n").contains("`1.234,5`"), "thousands");
    }

    #[test]
    fn blank_lines_are_skipped() {
        let wanted = without_unit(vec![1.0, 2.0]);
        for text in ["0,1\n0.5,2\n   \n", "0,1\n0.5,2\n\t\n\n", "  \n0,1\n\n0.5,2", "0;1\n0.5;2\n;\n"] {
            assert_eq!(table(text.as_bytes()).as_ref(), Ok(&wanted), "{text:?}");
        }
    }

    #[test]
    fn bytes_that_are_no_text_are_refused() {
        let error = table(b"0,1\n\xff\xfe,2\n").expect_err("not UTF-8");
        assert!(error.to_string().contains("line 2: found no text"), "{error}");
    }
}
