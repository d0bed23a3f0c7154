//! Numbers as people type them: `12.5 mm`, `3,2 cm`, `60°`, `0.4 g`, `1.2e3 kN/m`.
//!
//! A number without a unit is in the unit that the field shows. A unit of another kind is refused, not ignored.

use crate::app::field::Unit;
use crate::app::text;

/// What kind of quantity a field holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) enum Dimension {
    /// No unit.
    Pure,
    /// Metres.
    Length,
    /// Degrees.
    Angle,
    /// Kilograms.
    Mass,
    /// Seconds.
    Time,
    /// Hertz.
    Frequency,
    /// Metres a second.
    Speed,
    /// Degrees a second.
    Turning,
    /// Multiples of standard gravity.
    Acceleration,
    /// Metres a second squared.
    Metric,
    /// Square metres.
    Area,
    /// Newtons.
    Force,
    /// Newton metres.
    Moment,
    /// Newtons a metre.
    Stiffness,
    /// Newton seconds a metre.
    Damping,
    /// Pascals.
    Pressure,
}

impl Dimension {
    /// Its units' names and how much of the unit in which the scene keeps it each is.
    fn units(self) -> &'static [(&'static str, f64)] {
        const PER_G: f64 = 1.0 / crate::scene::STANDARD_GRAVITY;
        match self {
            Self::Pure => &[("%", 0.01)],
            Self::Length => &[("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("µm", 1e-6), ("km", 1e3)],
            Self::Angle => &[("°", 1.0), ("deg", 1.0), ("rad", 180.0 / std::f64::consts::PI)],
            Self::Mass => &[("kg", 1.0), ("g", 1e-3), ("t", 1e3)],
            Self::Time => &[("s", 1.0), ("ms", 1e-3), ("min", 60.0)],
            Self::Frequency => &[("Hz", 1.0), ("kHz", 1e3), ("rad/s", 0.5 / std::f64::consts::PI)],
            Self::Speed => &[("m/s", 1.0), ("mm/s", 1e-3), ("cm/s", 1e-2)],
            Self::Turning => &[("°/s", 1.0), ("deg/s", 1.0), ("rad/s", 180.0 / std::f64::consts::PI)],
            Self::Acceleration => &[("g", 1.0), ("m/s²", PER_G), ("m/s2", PER_G), ("gal", 0.01 * PER_G)],
            Self::Metric => &[("m/s²", 1.0), ("m/s2", 1.0), ("g", 1.0 / PER_G), ("gal", 0.01)],
            Self::Area => &[("m²", 1.0), ("m2", 1.0), ("cm²", 1e-4), ("cm2", 1e-4), ("mm²", 1e-6), ("mm2", 1e-6)],
            Self::Force => &[("N", 1.0), ("kN", 1e3), ("MN", 1e6)],
            Self::Moment => &[("N m", 1.0), ("Nm", 1.0), ("kN m", 1e3), ("kNm", 1e3)],
            Self::Stiffness => &[("N/m", 1.0), ("kN/m", 1e3), ("MN/m", 1e6), ("GN/m", 1e9), ("N/mm", 1e3)],
            Self::Damping => &[("N s/m", 1.0), ("Ns/m", 1.0), ("kN s/m", 1e3), ("kNs/m", 1e3)],
            Self::Pressure => &[("Pa", 1.0), ("MPa", 1e6), ("GPa", 1e9)],
        }
    }
}

/// The number that a text means, in the unit that the field shows; none where there is no text.
///
/// # Errors
/// A text that means no number, or one of another kind: what is wrong and what can be written.
pub(in crate::app) fn read(text: &str, unit: Unit) -> Result<Option<f64>, String> {
    if text.trim().is_empty() {
        return Ok(None);
    }
    parse(text, unit).map(Some).ok_or_else(|| {
        let names: Vec<&str> = unit.dimension.units().iter().map(|(name, _)| *name).collect();
        format!("\u{201c}{}\u{201d} {} {}", text.trim(), text::NO_NUMBER, names.join(", "))
    })
}

/// The number that a text means, in the unit that the field shows; `None` when it means none.
pub(in crate::app) fn parse(text: &str, unit: Unit) -> Option<f64> {
    let text = text.trim().replace(['−', '–'], "-");
    let end = text.find(|c: char| !(c.is_ascii_digit() || "+-.,eE \u{a0}\u{202f}".contains(c))).unwrap_or(text.len());
    let (digits, name) = text.split_at(end);
    let number = digits.replace([' ', '\u{a0}', '\u{202f}'], "");
    // A comma is a decimal point, unless there is one already.
    let number = if number.contains('.') { number.replace(',', "") } else { number.replace(',', ".") };
    let value: f64 = number.parse().ok().filter(|v: &f64| v.is_finite())?;
    let name = name.trim();
    if name.is_empty() || name == unit.suffix.trim() {
        return Some(value);
    }
    let (_, scale) = unit.dimension.units().iter().find(|(known, _)| *known == name)?;
    Some(value * scale * unit.factor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::field::{DEGREES, GRAVITIES, PURE, length_unit};

    #[test]
    fn a_number_may_carry_any_unit_of_its_kind() {
        let (mm, m) = (length_unit(0.19), length_unit(30.0));
        let cases = [
            ("12.5", mm, 12.5),
            ("12.5 mm", mm, 12.5),
            ("12,5mm", m, 0.0125),
            ("1.25 cm", mm, 12.5),
            ("1 200 mm", m, 1.2),
            ("60°", DEGREES, 60.0),
            ("−0.5 rad", DEGREES, -0.5f64.to_degrees()),
            ("392.266 gal", GRAVITIES, 0.4),
            ("1e-3", PURE, 1e-3),
            ("15 %", PURE, 0.15),
        ];
        for (text, unit, wanted) in cases {
            let got = parse(text, unit).expect("a number");
            assert!((got - wanted).abs() < 1e-12 * wanted.abs(), "{text}: {wanted}, got {got}");
        }
    }

    #[test]
    fn what_is_no_number_of_the_kind_is_refused() {
        for text in ["", "mm", "12 kg", "1.2.3", "inf", "NaN", "- mm"] {
            assert_eq!(parse(text, length_unit(0.19)), None, "{text:?} is no length");
        }
    }
}
