//! Range of a key: the one rule of the check of files and of the window.

use crate::language::{Message, Text, message};

/// Beyond this no unit of this world makes sense, and squares begin to overflow.
const LARGEST: f64 = 1e15;
/// The least of a number that must be positive, likewise.
const SMALLEST: f64 = 1e-15;

/// Allowed values of a key; of a list of numbers, of each number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Any number; none larger than 1e15 either way.
    Any,
    /// More than 0; from 1e-15 to 1e15.
    Positive,
    /// 0 or more, up to 1e15.
    NotNegative,
    /// 0 or more, and not less than what stands under another key of the table.
    NotBelow(&'static str),
    /// From the first to the second number.
    Within([f64; 2]),
    /// Between these, both excluded.
    Between([f64; 2]),
    /// One of these words.
    Words(&'static [&'static str]),
    /// True or false.
    Switch,
    /// Something in words; numbers in it may be any.
    Like(&'static str),
    /// A table with keys of its own, or a line of text: nothing to be out of.
    Free,
}

impl Range {
    /// Remedy for a number out of range; `None` of one in range.
    pub fn fault(self, value: f64) -> Option<Message> {
        if value.is_finite() {
            (!self.takes(value)).then(|| self.remedy(value))
        } else {
            Some(message!("wrong-not-finite", "remedy" => self.remedy(value)))
        }
    }

    fn takes(self, value: f64) -> bool {
        match self {
            Self::Positive => (SMALLEST..=LARGEST).contains(&value),
            Self::NotNegative | Self::NotBelow(_) => (0.0..=LARGEST).contains(&value),
            Self::Within([low, high]) => (low..=high).contains(&value),
            Self::Between([low, high]) => low < value && value < high,
            Self::Any | Self::Words(_) | Self::Switch | Self::Like(_) | Self::Free => value.abs() <= LARGEST,
        }
    }

    fn remedy(self, value: f64) -> Message {
        let sized = value.is_finite() && value > 0.0;
        match self {
            Self::Positive if sized => Text::new("wrong-extreme").into(),
            Self::Positive => Text::new("wrong-not-positive").into(),
            Self::NotNegative | Self::NotBelow(_) if sized => Text::new("wrong-too-large").into(),
            Self::NotNegative | Self::NotBelow(_) => Text::new("wrong-negative").into(),
            Self::Within([low, high]) => {
                message!("wrong-outside", "low" => format!("{low:?}"), "high" => format!("{high:?}"))
            }
            Self::Between([low, high]) => {
                message!("wrong-not-between", "low" => format!("{low:?}"), "high" => format!("{high:?}"))
            }
            Self::Any | Self::Words(_) | Self::Switch | Self::Like(_) | Self::Free => {
                Text::new("wrong-not-plain").into()
            }
        }
    }

    /// Allowed number for a drag to `wanted`: the nearest limit beyond a range, `now` where no limit is nearest.
    #[must_use]
    pub fn nearest(self, wanted: f64, now: f64) -> f64 {
        match self {
            Self::Within([low, high]) => wanted.clamp(low, high),
            Self::NotNegative | Self::NotBelow(_) => wanted.clamp(0.0, LARGEST),
            _ if self.fault(wanted).is_some() => now,
            _ => wanted,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hand_stops_at_the_limit() {
        assert_eq!(Range::Within([0.01, 1.0]).nearest(1.4, 0.9), 1.0, "at the upper limit");
        assert_eq!(Range::NotNegative.nearest(-3.0, 0.2), 0.0, "at 0");
        assert_eq!(Range::Positive.nearest(-3.0, 0.2), 0.2, "0 itself is none: it stays");
        assert_eq!(Range::Any.nearest(-3.0, 0.2), -3.0, "anywhere");
    }

    #[test]
    fn every_range_refuses_what_is_no_number() {
        let ranges = [Range::Any, Range::Positive, Range::NotNegative, Range::Within([0.0, 1.0]), Range::Free];
        for range in ranges {
            assert!(range.fault(f64::NAN).is_some_and(|f| f.to_string().contains("finite")), "{range:?}");
            assert!(range.fault(1e16).is_some(), "{range:?}: too large for any unit");
            assert_eq!(range.fault(0.5), None, "{range:?}: a plain number");
        }
    }
}
