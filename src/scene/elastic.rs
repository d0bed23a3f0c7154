//! A girder that bends, shortens and rings (`docs/physics.md#flexible-girders`).

use std::fmt;

use serde::de::Visitor;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::keys::{Fallback, Range, Slot, Stands, Stated, table};

/// Least and largest degree of the polynomials.
pub(super) const DEGREES: [f64; 2] = [2.0, 64.0];
/// `k_s` of a rectangle.
const RECTANGLE: f64 = 5.0 / 6.0;

/// A number, or one word in its place.
macro_rules! number_or_word {
    ($(#[$meta:meta])* $Name:ident, $word:literal, $expecting:literal, by default $default:expr) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $Name(pub Option<f64>);

        impl Serialize for $Name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                match self.0 {
                    Some(number) => super::whole::serialize(&number, serializer),
                    None => serializer.serialize_str($word),
                }
            }
        }

        impl<'de> Deserialize<'de> for $Name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(NumberOrWord { word: $word, expecting: $expecting }).map(Self)
            }
        }

        impl Stands for $Name {
            fn by_default(_: Fallback) -> Self {
                Self($default)
            }

            fn is_left_out(&self) -> bool {
                self.0 == $default
            }

            fn stated(&self) -> Stated<'_> {
                self.0.map_or(Stated::Nothing, Stated::Number)
            }

            fn slot(&mut self) -> Slot<'_> {
                Slot::Optional(&mut self.0)
            }
        }

        impl Default for $Name {
            fn default() -> Self {
                Self($default)
            }
        }
    };
}

number_or_word! {
    /// Degree n of the polynomials; nothing: as many as the contacts need.
    Degree, "auto", "a whole number from 2 to 64, or \"auto\"", by default None
}

number_or_word! {
    /// `k_s`; nothing: rigid in shear (Euler–Bernoulli).
    ShearFactor, "none", "a number greater than 0, or \"none\"", by default Some(RECTANGLE)
}

struct NumberOrWord {
    word: &'static str,
    expecting: &'static str,
}

impl Visitor<'_> for NumberOrWord {
    type Value = Option<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expecting)
    }

    fn visit_f64<E>(self, number: f64) -> Result<Self::Value, E> {
        Ok(Some(number))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Self::Value, E> {
        Ok(Some(number as f64))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Self::Value, E> {
        Ok(Some(number as f64))
    }

    fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<Self::Value, E> {
        if word == self.word { Ok(None) } else { Err(E::invalid_value(serde::de::Unexpected::Str(word), &self)) }
    }
}

table! {
    /// `[girder.elastic.rayleigh]`: damping `α/2ω + β ω/2` of a mode.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Rayleigh, RAYLEIGH {
        mass: f64 = "mass" as "field-rayleigh-alpha", Range::NotNegative, Fallback::Number(0.0), "α, 1/s";
        stiffness: f64 = "stiffness" as "field-rayleigh-beta", Range::NotNegative, Fallback::Number(0.0), "β, s";
    }
}

table! {
    /// `[girder.elastic]`: a girder that is not rigid.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Elastic, ELASTIC {
        young_modulus: f64 = "young_modulus_pa" as "field-young", Range::Positive, Fallback::Number(30e9), "E, Pa";
        poisson_ratio: f64 = "poisson_ratio" as "field-poisson", Range::Between([-1.0, 0.5]), Fallback::Number(0.2), "ν";
        area: Option<f64> = "area_m2" as "field-section-area", Range::Positive, Fallback::Needed("this or the next"),
            "A of the cross-section, m²";
        density: Option<f64> = "density_kg_m3" as "field-density", Range::Positive, Fallback::Needed("this or the last"),
            "ρ, kg/m³: A is the mass over ρ a₀";
        second_moment: Option<f64> = "second_moment_m4" as "field-second-moment", Range::Positive, Fallback::Words("A b₀²/12"),
            "I_z of the section, for bending in plan, m⁴";
        second_moment_vertical: Option<f64> = "second_moment_vertical_m4" as "field-second-moment-vertical", Range::Positive,
            Fallback::Words("A t₀²/12"), "I_y of the section, for vertical bending, m⁴; spatial scenes", in in_space;
        torsion_constant: Option<f64> = "torsion_constant_m4" as "field-torsion-constant", Range::Positive,
            Fallback::Words("of a solid rectangle b₀ × t₀"), "J of the section, for torsion, m⁴; spatial scenes", in in_space;
        shear_factor: ShearFactor = "shear_factor" as "field-shear-factor", Range::Positive, Fallback::Number(RECTANGLE),
            "k_s of the section; none is rigid in shear";
        damping_ratio: Option<f64> = "damping_ratio" as "field-damping-zeta", Range::NotNegative, Fallback::Words("0.02"),
            "ζ of every mode; not together with rayleigh";
        rayleigh: Option<Rayleigh> = "rayleigh", Range::Free, Fallback::Words("none"), "Rayleigh damping, see below";
        modes: Degree = "modes" as "field-degree", Range::Within(DEGREES), Fallback::Word("auto"),
            "degree n of the polynomials, 3n − 1 modes, in space 6n − 2; auto is what the contacts need";
        tolerance: f64 = "tol_flex" as "field-rigid-below", Range::NotNegative, Fallback::Number(1e-4),
            "softening κ_e of the contacts below which auto takes the girder as rigid";
        strength: Option<f64> = "strength_pa" as "field-strength", Range::Positive, Fallback::Words("not looked at"),
            "stress of the extreme fibre, beyond the dead load's, that is flagged where it is passed, Pa";
    }
}

impl Elastic {
    /// Of concrete, 0.02 of critical damping, this density \[kg/m³\].
    pub fn of_density(density: f64) -> Self {
        Self { density: Some(density), ..Self::default() }
    }
}
