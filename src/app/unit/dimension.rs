//! Kinds of quantities, and the units in which a number of each may be typed.

/// Dimension of the quantity in a field.
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
    /// Newtons a metre to the power of 3/2.
    HertzStiffness,
    /// Newton metres a radian.
    TurnStiffness,
    /// Kilograms a cubic metre.
    Density,
    /// Metres to the fourth power.
    SecondMoment,
    /// Kilogram square metres.
    Inertia,
    /// Per second.
    Rate,
    /// Newtons by seconds a metre to a power that stands beside it.
    PowerDamping,
}

impl Dimension {
    /// Its units' names and how much of the unit in which the scene keeps it each is.
    pub(in crate::app) fn units(self) -> &'static [(&'static str, f64)] {
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
            Self::HertzStiffness => &[("N/m^1.5", 1.0), ("MN/m^1.5", 1e6), ("GN/m^1.5", 1e9)],
            Self::TurnStiffness => {
                &[("N m/rad", 1.0), ("Nm/rad", 1.0), ("kN m/rad", 1e3), ("kNm/rad", 1e3), ("MN m/rad", 1e6)]
            }
            Self::Density => &[("kg/m³", 1.0), ("kg/m3", 1.0), ("t/m³", 1e3), ("t/m3", 1e3)],
            Self::SecondMoment => &[("m⁴", 1.0), ("m4", 1.0), ("cm⁴", 1e-8), ("cm4", 1e-8)],
            Self::Inertia => &[("kg m²", 1.0), ("kg m2", 1.0), ("t m²", 1e3), ("t m2", 1e3)],
            Self::Rate => &[("1/s", 1.0)],
            Self::PowerDamping => &[("N (s/m)^α", 1.0), ("kN (s/m)^α", 1e3)],
        }
    }
}
