//! How numbers are shown: in which unit, how fast a drag changes them.

use super::dimension::Dimension;

/// How a number is shown: `shown = SI × factor`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) struct Unit {
    /// Shown units per SI unit.
    pub factor: f64,
    /// Written after the number.
    pub suffix: &'static str,
    /// Change per point of dragging, shown units.
    pub speed: f64,
    /// Dimension of its entries.
    pub dimension: Dimension,
    /// Most decimals that are kept of a number that is dragged.
    pub decimals: usize,
}

impl Unit {
    const fn new(dimension: Dimension, factor: f64, suffix: &'static str, speed: f64) -> Self {
        Self { factor, suffix, speed, dimension, decimals: 6 }
    }

    /// A number of the scene as it is shown, with its unit.
    pub(in crate::app) fn words(&self, value: f64) -> String {
        format!("{}{}", self.written(value * self.factor), self.suffix)
    }

    /// A shown number, to six significant digits where it is not a small part.
    pub(in crate::app) fn written(&self, shown: f64) -> String {
        if self.decimals > 6 && shown != 0.0 { format!("{shown:e}") } else { trimmed(significant(shown)) }
    }
}

/// A pure number.
pub(in crate::app) const PURE: Unit = Unit::new(Dimension::Pure, 1.0, "", 0.005);
/// A small part, written with its power of ten.
pub(in crate::app) const PARTS: Unit = Unit { decimals: 15, ..Unit::new(Dimension::Pure, 1.0, "", 1e-11) };
/// Degrees that are degrees in the scene too.
pub(in crate::app) const DEGREES: Unit = Unit::new(Dimension::Angle, 1.0, "°", 0.25);
/// Hertz.
pub(in crate::app) const HERTZ: Unit = Unit::new(Dimension::Frequency, 1.0, " Hz", 0.01);
/// Seconds.
pub(in crate::app) const SECONDS: Unit = Unit::new(Dimension::Time, 1.0, " s", 0.05);
/// Metres a second.
pub(in crate::app) const SPEED: Unit = Unit::new(Dimension::Speed, 1.0, " m/s", 0.01);
/// Millimetres a second.
pub(in crate::app) const SLOW: Unit = Unit::new(Dimension::Speed, 1e3, " mm/s", 0.01);
/// Degrees a second.
pub(in crate::app) const TURNING: Unit = Unit::new(Dimension::Turning, 1.0, " °/s", 0.1);
/// Multiples of standard gravity.
pub(in crate::app) const GRAVITIES: Unit = Unit::new(Dimension::Acceleration, 1.0, " g", 0.005);
/// Metres a second squared.
pub(in crate::app) const ACCELERATION: Unit = Unit::new(Dimension::Metric, 1.0, " m/s²", 0.05);
/// Newton metres.
pub(in crate::app) const MOMENTS: Unit = Unit::new(Dimension::Moment, 1.0, " N m", 1.0);
/// Pascals, in thousands of millions.
pub(in crate::app) const MODULUS: Unit = Unit::new(Dimension::Pressure, 1e-9, " GPa", 0.1);
/// Stiffnesses of Hertz springs.
pub(in crate::app) const HERTZ_STIFFNESS: Unit = Unit::new(Dimension::HertzStiffness, 1e-6, " MN/m^1.5", 0.01);

/// Metres a second of waves in the ground.
pub(in crate::app) const WAVE_SPEED: Unit = Unit::new(Dimension::Speed, 1.0, " m/s", 1.0);
/// Newton metres a radian.
pub(in crate::app) const TURN_STIFFNESS: Unit = Unit::new(Dimension::TurnStiffness, 1.0, " N m/rad", 1.0);
/// Kilograms a cubic metre.
pub(in crate::app) const DENSITY: Unit = Unit::new(Dimension::Density, 1.0, " kg/m³", 1.0);
/// Metres to the fourth power.
pub(in crate::app) const SECOND_MOMENT: Unit = Unit::new(Dimension::SecondMoment, 1.0, " m⁴", 0.01);
/// Kilogram square metres.
pub(in crate::app) const INERTIA: Unit = Unit::new(Dimension::Inertia, 1.0, " kg m²", 1.0);
/// Per second.
pub(in crate::app) const RATE: Unit = Unit::new(Dimension::Rate, 1.0, " 1/s", 0.01);
/// Coefficients of dampers whose force is a power of the speed.
pub(in crate::app) const POWER_DAMPING: Unit = Unit::new(Dimension::PowerDamping, 1.0, " N (s/m)^α", 1.0);

/// Lengths of a scene: millimetres on the bench, metres at a bridge.
pub(in crate::app) fn length_unit(size: f64) -> Unit {
    if size < 2.0 {
        Unit::new(Dimension::Length, 1e3, " mm", 0.1)
    } else {
        Unit::new(Dimension::Length, 1.0, " m", 0.01)
    }
}

/// Areas of a scene: square millimetres on the bench, square metres at a bridge.
pub(in crate::app) fn area_unit(area: f64) -> Unit {
    if area < 0.05 {
        Unit::new(Dimension::Area, 1e6, " mm²", 10.0)
    } else {
        Unit::new(Dimension::Area, 1.0, " m²", 0.01)
    }
}

/// Masses of a scene: kilograms or tonnes.
pub(in crate::app) fn mass_unit(mass: f64) -> Unit {
    if mass < 5e3 { Unit::new(Dimension::Mass, 1.0, " kg", 0.01) } else { Unit::new(Dimension::Mass, 1e-3, " t", 1.0) }
}

/// Forces: newtons or kilonewtons, as the weight of the body is.
pub(in crate::app) fn force_unit(mass: f64) -> Unit {
    if mass < 5e3 { Unit::new(Dimension::Force, 1.0, " N", 0.1) } else { Unit::new(Dimension::Force, 1e-3, " kN", 1.0) }
}

/// Stiffnesses: as readable as they come.
pub(in crate::app) fn stiffness_unit(k: f64) -> Unit {
    match k.abs() {
        k if k >= 1e9 => Unit::new(Dimension::Stiffness, 1e-9, " GN/m", 0.01),
        k if k >= 1e6 => Unit::new(Dimension::Stiffness, 1e-6, " MN/m", 0.01),
        k if k >= 1e4 => Unit::new(Dimension::Stiffness, 1e-3, " kN/m", 0.1),
        _ => Unit::new(Dimension::Stiffness, 1.0, " N/m", 1.0),
    }
}

/// Dashpots: as readable as they come.
pub(in crate::app) fn damping_unit(c: f64) -> Unit {
    if c.abs() >= 1e4 {
        Unit::new(Dimension::Damping, 1e-3, " kN s/m", 0.1)
    } else {
        Unit::new(Dimension::Damping, 1.0, " N s/m", 0.1)
    }
}

/// Rounded to a power of ten, with no digits beyond it.
pub(in crate::app) fn rounded(value: f64, step: f64) -> f64 {
    // Dividing by a whole number keeps the decimal digits short, multiplying by 0.0001 does not.
    if step < 1.0 {
        let per_unit = (1.0 / step).round();
        (value * per_unit).round() / per_unit
    } else {
        (value / step).round() * step
    }
}

/// To six significant digits, of numbers from 1 to 10⁶; others have as many or are whole.
fn significant(value: f64) -> f64 {
    let magnitude = value.abs();
    if !(1.0..1e6).contains(&magnitude) {
        return value;
    }
    let step = 10f64.powf(magnitude.log10().floor() - 5.0);
    rounded(value, step)
}

/// Numbers from here on are written with their power of ten: nobody counts more zeros.
const WITH_POWER: f64 = 1e12;

/// Up to six decimals, none of them needless; with a power of ten beyond [`WITH_POWER`].
pub(in crate::app) fn trimmed(value: f64) -> String {
    if value.abs() >= WITH_POWER {
        return format!("{value:.5e}").replace(".00000e", "e");
    }
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_show_no_needless_zeros() {
        assert_eq!(trimmed(3.2), "3.2", "short");
        assert_eq!(trimmed(-1e-9), "0", "no minus zero");
        assert_eq!([trimmed(1e300), trimmed(1.5e15)], ["1e300", "1.50000e15"], "no row of zeros");
        let fields = [60.123_456, 0.051_234_5, 51.234_56, 300.0, 123_456.7].map(|v| PURE.written(v));
        assert_eq!(
            fields,
            ["60.1235", "0.051235", "51.2346", "300", "123457"],
            "as many digits as a field has room for"
        );
    }
}
