//! Numbers as people type them: `12.5 mm`, `3,2 cm`, `60°`, `0.4 g`, `1.2e3 kN/m`.
//!
//! A number without a unit is in the unit that the field shows. A unit of another kind is refused, not ignored.

use crate::app::text;
use crate::app::unit::Unit;

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
    use crate::app::unit::{DEGREES, GRAVITIES, PURE, length_unit};

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
