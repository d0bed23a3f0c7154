//! Units of what a run can be asked for, and how an engineer reads them.

/// Unit of a quantity's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Metres.
    Metre,
    /// Radians.
    Radian,
    /// Metres a second.
    MetrePerSecond,
    /// Radians a second.
    RadianPerSecond,
    /// Metres a second squared.
    MetrePerSecond2,
    /// Newtons.
    Newton,
    /// Newton metres.
    NewtonMetre,
    /// Pascals.
    Pascal,
    /// Joules.
    Joule,
    /// None.
    One,
}

impl Unit {
    /// Name of the SI unit; a pure number has none.
    pub fn name(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Radian => "rad",
            Self::MetrePerSecond => "m/s",
            Self::RadianPerSecond => "rad/s",
            Self::MetrePerSecond2 => "m/s²",
            Self::Newton => "N",
            Self::NewtonMetre => "N·m",
            Self::Pascal => "Pa",
            Self::Joule => "J",
            Self::One => "",
        }
    }

    /// Representation for any values: factor from SI, and name.
    pub fn shown(self) -> (f64, &'static str) {
        match self {
            Self::Metre => (1e3, "mm"),
            Self::Radian => (180.0 / std::f64::consts::PI, "°"),
            Self::RadianPerSecond => (180.0 / std::f64::consts::PI, "°/s"),
            Self::Pascal => (1e-6, "MPa"),
            _ => (1.0, self.name()),
        }
    }

    /// Representation by the largest value, with at most five digits before the point: lengths from 1 m on in metres, forces, moments and
    /// energies from 10,000 on in thousands and from 10 million on in millions.
    pub fn shown_up_to(self, largest: f64) -> (f64, &'static str) {
        let names = match self {
            Self::Metre if largest.abs() >= 1.0 => return (1.0, "m"),
            Self::Newton => ["kN", "MN"],
            Self::NewtonMetre => ["kN·m", "MN·m"],
            Self::Joule => ["kJ", "MJ"],
            _ => return self.shown(),
        };
        match largest.abs() {
            size if size >= 1e7 => (1e-6, names[1]),
            size if size >= 1e4 => (1e-3, names[0]),
            _ => self.shown(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_shown_with_few_digits() {
        assert_eq!(Unit::Newton.shown_up_to(9999.0), (1.0, "N"), "four digits");
        assert_eq!(Unit::Newton.shown_up_to(-45e3), (1e-3, "kN"), "of either sign");
        assert_eq!(Unit::Joule.shown_up_to(2.5e7), (1e-6, "MJ"), "eight digits");
        assert_eq!(
            [0.02, 3.0].map(|x| Unit::Metre.shown_up_to(x)),
            [(1e3, "mm"), (1.0, "m")],
            "a deck and its corners"
        );
        assert_eq!(Unit::One.shown_up_to(1e9), (1.0, ""), "a pure number");
    }
}
