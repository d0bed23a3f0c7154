//! The heading of a table of time and acceleration: which unit it states.

use super::record::RecordError;
use super::text::quoted;
use super::unit::Unit;
use crate::language::{Text, message};

/// Refuses a heading of the times that says another unit than seconds.
pub(super) fn in_seconds(time: &str, line: u64) -> Result<(), RecordError> {
    match bracketed(time).or(last_word(time)).filter(|unit| ["ms", "min", "h"].contains(unit)) {
        Some(unit) => {
            Err(RecordError::new(line, message!("record-times-in", "unit" => unit), Text::new("record-seconds")))
        }
        None => Ok(()),
    }
}

/// The unit of acceleration that a heading states, in brackets or as its last word: `a [gal]`, `acc (cm/s2)`, `acc_g`, `a_m_s2`.
///
/// # Errors
/// A word that is no unit of acceleration where a unit would stand; another quantity.
pub(super) fn unit_of_heading(acceleration: &str, line: u64) -> Result<Option<Unit>, RecordError> {
    if let Some(word) = bracketed(acceleration) {
        let remedy = Text::new("record-units");
        let unit = Unit::of_word(word)
            .ok_or_else(|| RecordError::new(line, message!("record-unit-of", "unit" => quoted(word)), remedy))?;
        return Ok(Some(unit));
    }
    unit_in_words(acceleration).map_err(|OtherWord| {
        RecordError::new(line, message!("record-unit-of", "unit" => quoted(acceleration)), Text::new("record-units"))
    })
}

/// A heading has a word where a unit of acceleration would stand, or names another quantity.
struct OtherWord;

/// Words of a heading that name no unit: directions and numbers of components.
const DIRECTIONS: [&str; 18] =
    ["x", "y", "z", "h", "v", "n", "s", "e", "w", "ns", "sn", "ew", "we", "ud", "up", "north", "east", "vertical"];

/// Beginnings of words that name another quantity than an acceleration.
const OTHERS: [&str; 5] = ["disp", "vel", "speed", "time", "force"];

/// Words that are units of other quantities, or parts of a unit of acceleration that is not taken.
const OTHER_UNITS: [&str; 16] =
    ["mg", "ug", "mm", "cm", "m", "km", "in", "ft", "kn", "mn", "pa", "kpa", "mpa", "rad", "deg", "hz"];

/// The unit that a heading without brackets states behind the name of the quantity; none where it states none, as `a`, `acc x` and
/// `ground motion` do not.
fn unit_in_words(heading: &str) -> Result<Option<Unit>, OtherWord> {
    // `m_s2` is written for m/s2 where a name may have no slash, `m_s` for m/s.
    let heading = heading.trim().to_ascii_lowercase().replace("m_s2", "m/s2").replace("m_s", "m/s");
    let parted = |c: char| c.is_whitespace() || c == '_';
    let words: Vec<&str> = heading.split(parted).filter(|word| !word.is_empty()).collect();
    let [name, more @ ..] = &words[..] else { return Ok(None) };
    if OTHERS.iter().any(|other| name.starts_with(other)) || OTHER_UNITS.contains(name) || is_of_a_body(name) {
        return Err(OtherWord);
    }
    // `g`, or `a/g`: the acceleration in parts of it.
    let alone = Unit::of_word(name).or_else(|| Unit::of_word(name.split_once('/')?.1));
    let [between @ .., last] = more else {
        return if alone.is_none() && name.contains('/') { Err(OtherWord) } else { Ok(alone) };
    };
    // A direction, a number, or a word too long for a unit or its prefix.
    let names = |word: &&str| DIRECTIONS.contains(word) || word.chars().all(|c| c.is_ascii_digit()) || word.len() > 5;
    let unit = Unit::of_word(last);
    let known = if unit.is_some() { between.iter().all(&names) } else { names(last) };
    if known { Ok(unit) } else { Err(OtherWord) }
}

/// Whether a name is of a quantity of a body, as tables of this program write it: `deck.x`, and neither `ground.x`, an acceleration, nor
/// `st1.acc`.
fn is_of_a_body(name: &str) -> bool {
    let accelerates = |what: &str| what.starts_with("acc") || ["a", "ax", "ay", "az"].contains(&what);
    name.trim_end_matches('.').split_once('.').is_some_and(|(body, what)| body != "ground" && !accelerates(what))
}

/// Text in round or square brackets.
fn bracketed(field: &str) -> Option<&str> {
    let (_, rest) = field.split_once(['[', '('])?;
    rest.split_once([']', ')']).map(|(inside, _)| inside.trim())
}

/// The last of several words, parted by blanks or `_`.
fn last_word(field: &str) -> Option<&str> {
    field.trim().rsplit_once([' ', '_']).map(|(_, word)| word)
}
