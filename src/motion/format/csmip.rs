//! CSMIP (CDMG) Volume 2: several channels one after the other, each with acceleration, velocity and displacement in fixed
//! columns below a line `12000 points of accel data equally spaced at  .005 sec, in cm/sec2. (8f10.6)`.

use super::fortran::announced;
use super::record::{Channel, Format, RecordError, Supplement};
use super::text::{Lines, find_word, first_number, interval, orientation, quoted};
use super::unit::Unit;
use crate::language::{Text, message};

/// This format.
pub(super) const FORMAT: Format =
    Format { name: "CSMIP Volume 2", extensions: &["v2"], contents: Text::new("record-csmip"), sniff, read };

/// Words that announce a series of accelerations.
const ANNOUNCED: &str = "points of accel data equally spaced";
/// Lines within which the first one does; a header has 45.
const HEADER: usize = 100;

fn sniff(bytes: &[u8]) -> bool {
    Lines::of(bytes).take(HEADER).any(|line| find_word(&line, ANNOUNCED).is_some())
}

fn read(bytes: &[u8], beside: &Supplement) -> Result<Vec<Channel>, RecordError> {
    beside.nothing(Text::new("record-states-csmip"))?;
    let mut lines = Lines::of(bytes);
    let (mut channels, mut name, mut complete) = (Vec::new(), String::new(), true);
    while let Some(line) = lines.next() {
        if line.trim_start().starts_with("Chan") {
            line.trim().clone_into(&mut name);
        } else if find_word(&line, ANNOUNCED).is_some() {
            channels.push(series(&line, &name, &mut lines)?);
            complete = false;
        } else if line.starts_with("/&") {
            complete = true;
        }
    }
    if channels.is_empty() || !complete {
        return Err(lines.ended(Text::new("record-csmip-end").into()));
    }
    Ok(channels)
}

/// The accelerations below their announcement.
fn series(text: &str, name: &str, lines: &mut Lines<'_>) -> Result<Channel, RecordError> {
    let at = lines.number;
    let (count, columns) = announced(text, at)?;
    let after = text.get(find_word(text, "spaced").unwrap_or(0)..).unwrap_or_default();
    let dt = first_number(after).map_or(f64::NAN, |(dt, _)| dt);
    let dt = interval(dt, at)?;
    let unit = text
        .split([' ', '(', ')', ','])
        .rev()
        .find_map(Unit::of_word)
        .ok_or_else(|| RecordError::new(at, quoted(text), Text::new("record-csmip-unit")))?;
    let numbers = columns.read(lines, count)?;
    let end = lines.clone().next().unwrap_or_default();
    if !(end.starts_with("/&") || find_word(&end, "points of").is_some()) {
        let remedy = message!("record-csmip-after", "count" => count);
        return Err(RecordError::new(lines.number + 1, quoted(&end), remedy));
    }
    Ok(Channel::converted(name, orientation(name), unit, dt, numbers))
}
