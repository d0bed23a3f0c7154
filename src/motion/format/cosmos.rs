//! COSMOS v1.20, volumes 1 and 2: a text header, integers, reals and comments, each announced with count and format; then
//! accelerations, announced with their unit. A file may hold several channels one after the other.
//!
//! The interval is real-header value 62, ms; the direction stands in the text line `Sta Chan  1: 340 deg`.

use super::fortran::announced;
use super::record::{Channel, Format, Orientation, RecordError, Supplement};
use super::text::{Lines, find_word, first_number, interval, orientation, quoted};
use super::unit::Unit;
use crate::language::{Text, message};

/// This format.
pub(super) const FORMAT: Format = Format {
    name: "COSMOS",
    extensions: &["v1", "v1c", "v2c", "cosmos"],
    contents: Text::new("record-cosmos"),
    sniff,
    read,
};

/// Real-header value that holds the interval of the series \[ms\], from 1.
const INTERVAL: usize = 62;
/// Text lines of a header at the most.
const MOST_TEXT: f64 = 100.0;

fn sniff(bytes: &[u8]) -> bool {
    Lines::of(bytes).next().is_some_and(|line| find_word(&line, "(Format v01").is_some())
}

fn read(bytes: &[u8], beside: &Supplement) -> Result<Vec<Channel>, RecordError> {
    beside.nothing(Text::new("record-states-cosmos"))?;
    let mut lines = Lines::of(bytes);
    let mut channels = Vec::new();
    while let Some(first) = lines.next() {
        if first.trim().is_empty() && !channels.is_empty() {
            continue;
        }
        if let Some(channel) = section(&first, &mut lines)? {
            channels.push(channel);
        }
    }
    if channels.is_empty() {
        return Err(lines.ended(Text::new("record-series").into()));
    }
    Ok(channels)
}

/// One series with its headers; nothing where it is a velocity or a displacement.
fn section(first: &str, lines: &mut Lines<'_>) -> Result<Option<Channel>, RecordError> {
    let (direction, name) = text_header(first, lines)?;
    let mut header = lines.header(Text::new("record-integers"))?;
    let (count, columns) = announced(&header, lines.number)?;
    columns.read(lines, count)?;
    header = lines.header(Text::new("record-reals"))?;
    let at = lines.number;
    let (count, columns) = announced(&header, at)?;
    let reals = columns.read(lines, count)?;
    comments(lines)?;
    let data = lines.header(Text::new("record-announcement"))?;
    let announced_at = lines.number;
    let (count, columns) = announced(&data, announced_at)?;
    let acceleration = find_word(&data, "accel").is_some();
    let unit = if acceleration { Some(unit(&data, announced_at)?) } else { None };
    let numbers = columns.read(lines, count)?;
    let end = lines.header(Text::new("record-end-line"))?;
    if find_word(&end, "End-of-data").is_none() {
        return Err(lines.wrong(&end, message!("record-end-after", "count" => count)));
    }
    let Some(unit) = unit else { return Ok(None) };
    let dt =
        reals.get(INTERVAL - 1).copied().filter(|ms| *ms > 0.0).ok_or_else(|| {
            RecordError::new(at, Text::new("record-no-interval"), Text::new("record-cosmos-interval"))
        })?;
    let dt = interval(dt / 1000.0, at)?;
    lasts(&data, count as f64 * dt, announced_at)?;
    Ok(Some(Channel::converted(&name, direction, unit, dt, numbers)))
}

/// The text lines, as many as the first of them states: direction and name of the channel.
fn text_header(first: &str, lines: &mut Lines<'_>) -> Result<(Orientation, String), RecordError> {
    let stated = find_word(first, " with ").and_then(|at| first_number(&first[at..])).map(|(count, _)| count);
    let count = stated
        .filter(|count| (1.0..=MOST_TEXT).contains(count))
        .ok_or_else(|| lines.wrong(first, Text::new("record-cosmos-first")))?;
    let (mut direction, mut name) = (Orientation::Unstated, String::new());
    for n in 1.. {
        if f64::from(n) >= count {
            break;
        }
        let line = lines.header(Text::new("record-text-header"))?;
        if find_word(&line, "Sta Cha").is_some_and(|at| at < 3) {
            let own = line.split('(').next().unwrap_or_default();
            direction = orientation(own);
            own.trim().clone_into(&mut name);
        }
    }
    Ok((direction, name))
}

/// `6 Comment line(s) follow, each starting with a "|":` and these lines.
fn comments(lines: &mut Lines<'_>) -> Result<(), RecordError> {
    let head = lines.header(Text::new("record-comments-line"))?;
    let count = first_number(&head).filter(|_| find_word(&head, "comment").is_some()).map(|(count, _)| count);
    let count = count.ok_or_else(|| lines.wrong(&head, Text::new("record-comments-count")))?;
    let mut read = 0.0;
    while read < count {
        let comment = lines.header(Text::new("record-comment"))?;
        if !comment.trim_start().starts_with('|') {
            return Err(lines.wrong(&comment, message!("record-comments", "count" => count)));
        }
        read += 1.0;
    }
    Ok(())
}

/// `units=cm/sec2(04)`.
fn unit(text: &str, line: u64) -> Result<Unit, RecordError> {
    const UNITS: &str = "units=";
    let word = find_word(text, UNITS).and_then(|at| text.get(at + UNITS.len()..)).unwrap_or_default();
    let word = word.split(['(', ',']).next().unwrap_or_default();
    Unit::of_word(word).ok_or_else(|| RecordError::new(line, quoted(text), Text::new("record-cosmos-unit")))
}

/// Holds the length of the series against the seconds that its announcement states, rounded to whole ones.
fn lasts(text: &str, seconds: f64, line: u64) -> Result<(), RecordError> {
    let stated = find_word(text, "approx").and_then(|at| first_number(&text[at..])).map(|(stated, _)| stated);
    match stated {
        Some(stated) if (stated - seconds).abs() > 1.0 => {
            let remedy = message!("record-lasts", "seconds" => seconds);
            Err(RecordError::new(line, format!("approx {stated} s"), remedy))
        }
        _ => Ok(()),
    }
}
