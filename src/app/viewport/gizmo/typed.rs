//! A number typed while a handle is held: it takes the place of the one that is read beside the hand.
//!
//! It is what the plate names: a length, an angle, a gap, or how far something moves. Without a unit it is in the unit
//! in which the numbers of the scene are shown.

use super::held::Held;
use super::pull::{self, Pull, Pulled};
use crate::app::command::Grip;
use crate::app::field::parse;
use crate::app::text;
use crate::app::unit::{DEGREES, Unit, length_unit};
use crate::scene::keys::{self, Range};
use crate::scene::{Girder, Scene};

/// Typed text so far; two numbers where the hand moves two ways.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::app) struct Typing {
    texts: [String; 2],
    second: bool,
}

impl Typing {
    /// Whether nothing has been typed.
    pub(in crate::app) fn is_empty(&self) -> bool {
        self.texts.iter().all(String::is_empty) && !self.second
    }

    /// Adds what belongs to a number or its unit; a number begins with a digit, a sign or a point.
    pub(in crate::app) fn add(&mut self, words: &str) {
        let text = &mut self.texts[usize::from(self.second)];
        for letter in words.chars().filter(|c| !c.is_control()) {
            if !text.is_empty() || begins_number(letter) {
                text.push(letter);
            }
        }
    }

    /// Takes the last letter back; of an empty second number, goes back to the first.
    pub(in crate::app) fn take_back(&mut self) {
        if self.texts[usize::from(self.second)].pop().is_none() {
            self.second = false;
        }
    }

    /// To the other number.
    pub(in crate::app) fn next(&mut self) {
        self.second = !self.second;
    }
}

/// Whether a number can begin with this letter.
pub(in crate::app) fn begins_number(letter: char) -> bool {
    letter.is_ascii_digit() || "+-−.,".contains(letter)
}

/// Result of the typed numbers: an edit where they are sound, and the text on the plate.
pub(in crate::app) struct Said {
    /// Change; `None` while the text is no number in range.
    pub(in crate::app) pulled: Option<Pulled>,
    /// Text on the plate; without an edit its last line gives the reason.
    pub(in crate::app) words: Vec<String>,
}

/// Reads what is typed for the handle that is held.
pub(in crate::app) fn read(held: &Held, typing: &Typing) -> Said {
    let unit = unit(&held.scene, held.grip);
    let count = if held.grip.moves_two_ways() { 2 } else { 1 };
    let mut numbers = [0.0; 2];
    let mut words = vec![on_plate(held.grip, typing, unit)];
    for (text, number) in typing.texts.iter().zip(&mut numbers).take(count) {
        match number_in(text, unit, range(held.grip)) {
            Ok(read) => *number = read,
            Err(why) => {
                words.push(why);
                return Said { pulled: None, words };
            }
        }
    }
    words.push(if count == 2 { text::TYPED_TWO.into() } else { text::TYPED.into() });
    let (scene, selected) = (&*held.scene, &held.selected[..]);
    let pull = Pull { scene, selected, from: held.from, to: held.from, step: 1e-9, reach: 0.0, typed: Some(numbers) };
    Said { pulled: pull::pulled(held.grip, &pull), words }
}

/// The number in the unit of the scene; an empty text of a way is no way at all.
fn number_in(text: &str, unit: Unit, range: Range) -> Result<f64, String> {
    let number = parse::read(text, unit)?.unwrap_or(0.0) / unit.factor;
    range.fault(number).map_or(Ok(number), |fault| Err(fault.to_string()))
}

/// `length 12.5| mm`: what is typed, where the next letter goes, and the unit that is meant without one.
fn on_plate(grip: Grip, typing: &Typing, unit: Unit) -> String {
    let one = |n: usize, name: &str| {
        let text = &typing.texts[n];
        let mark = if usize::from(typing.second) == n { "|" } else { "" };
        let named = text.chars().any(|c| c.is_alphabetic() && c != 'e' && c != 'E' || "°%²".contains(c));
        let (text, suffix) =
            (if text.is_empty() && mark.is_empty() { "0" } else { text }, if named { "" } else { unit.suffix });
        format!("{name} {text}{mark}{suffix}")
    };
    match grip {
        Grip::Bodies | Grip::DevicePoint(..) => format!("{}   {}", one(0, text::SHIFT_X), one(1, text::SHIFT_Y)),
        Grip::Along(_) => one(0, text::ALONG.as_str()),
        Grip::Across(_) => one(0, text::ACROSS.as_str()),
        Grip::Turn(_) => one(0, text::TURNED_TO.as_str()),
        Grip::Length(..) => one(0, text::LONG.as_str()),
        Grip::Width(..) => one(0, text::WIDE.as_str()),
        Grip::Skew(..) => one(0, text::SKEWED),
        Grip::Gap(_) => one(0, text::APART.as_str()),
        Grip::Offset(_) => one(0, text::SIDEWAYS.as_str()),
        Grip::FaceWidth(..) => one(0, text::FACE_WIDE.as_str()),
        Grip::PierHeight(_) => one(0, text::HIGH.as_str()),
        Grip::PierColumn(_) => one(0, text::COLUMN.as_str()),
    }
}

/// In what a handle's number is meant without a unit: as the inspector shows it.
fn unit(scene: &Scene, grip: Grip) -> Unit {
    let of = |girder: Option<&Girder>| length_unit(girder.map_or(1.0, |g| g.length));
    match grip {
        Grip::Turn(_) | Grip::Skew(..) => DEGREES,
        Grip::Along(i) | Grip::Across(i) | Grip::Length(i, _) | Grip::Width(i, _) => of(scene.girders.get(i)),
        Grip::Offset(i) | Grip::FaceWidth(i, _) => {
            let faces = scene.abutments.get(i).map(|a| &a.faces);
            of(scene.girders.iter().find(|g| Some(&g.name) == faces))
        }
        Grip::Bodies | Grip::Gap(_) | Grip::DevicePoint(..) | Grip::PierHeight(_) | Grip::PierColumn(_) => {
            of(scene.girders.first())
        }
    }
}

/// Range of the key that a handle changes.
fn range(grip: Grip) -> Range {
    let (table, key) = match grip {
        Grip::Length(..) => (keys::GIRDER, "length_m"),
        Grip::Width(..) => (keys::GIRDER, "width_m"),
        Grip::Skew(..) => (keys::GIRDER, "skew_deg"),
        Grip::Gap(_) => (keys::ABUTMENT, "gap_m"),
        Grip::FaceWidth(..) => (keys::ABUTMENT, "width_m"),
        Grip::PierHeight(_) => (keys::PIER, "height_m"),
        Grip::PierColumn(_) => (keys::PIER, "column_m"),
        Grip::Bodies | Grip::Along(_) | Grip::Across(_) | Grip::Turn(_) | Grip::Offset(_) | Grip::DevicePoint(..) => {
            return Range::Any;
        }
    };
    keys::find(table, key).map_or(Range::Any, |key| key.range)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_come_only_after_a_number_has_begun() {
        let mut typing = Typing::default();
        typing.add("xm");
        assert!(typing.is_empty(), "no number yet");
        typing.add("12.5 mm");
        assert_eq!(typing.texts[0], "12.5 mm", "with its unit");
        typing.next();
        typing.add("-3");
        typing.take_back();
        typing.take_back();
        typing.take_back();
        typing.take_back();
        assert_eq!(typing.texts[0], "12.5 m", "back in the first");
    }
}
