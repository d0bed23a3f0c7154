//! Numbers in force of an elastic girder's keys, from the girder's size.

use super::elastic::{DEGREES, Elastic, Rayleigh};
use super::girder::Girder;
use crate::geometry::rectangle::torsion_constant;
use crate::language::{Message, Text, message};

/// `k_s G A` of a girder that is rigid in shear, in parts of `G A`.
const RIGID_IN_SHEAR: f64 = 1e4;
/// Allowed difference of `ρ A a0` from the mass, relative to it \[–\].
const SAME_MASS: f64 = 0.01;

/// The numbers in force of an elastic girder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResolvedElastic {
    /// A \[m²\].
    pub area: f64,
    /// `E A` \[N\].
    pub axial: f64,
    /// `E I_z` \[N·m²\].
    pub bending: f64,
    /// `k_s G A` \[N\].
    pub shear: f64,
    /// `I_z` \[m⁴\].
    pub second_moment: f64,
    /// `I_y` \[m⁴\].
    pub second_moment_vertical: f64,
    /// `E I_y` \[N·m²\].
    pub vertical_bending: f64,
    /// `J_t` \[m⁴\].
    pub torsion_constant: f64,
    /// `G J_t` \[N·m²\].
    pub torsion: f64,
    /// ζ, or α and β.
    pub damping: Result<f64, Rayleigh>,
    /// Degree where it is given.
    pub degree: Option<usize>,
}

impl Elastic {
    /// The numbers in force for a girder of this length, width and mass.
    pub fn resolve(&self, girder: &Girder) -> ResolvedElastic {
        let by_density = |density: f64| girder.mass / (density * girder.length);
        let area = self.area.or(self.density.map(by_density)).unwrap_or(f64::NAN);
        let second_moment = self.second_moment.unwrap_or(area * girder.width * girder.width / 12.0);
        let vertical = self.second_moment_vertical.unwrap_or(area * girder.thickness * girder.thickness / 12.0);
        let torsion_constant =
            self.torsion_constant.unwrap_or_else(|| torsion_constant(girder.width, girder.thickness));
        let shear_modulus = 0.5 * self.young_modulus / (1.0 + self.poisson_ratio);
        let damping = self.rayleigh.map_or(Ok(self.damping_ratio.unwrap_or(0.02)), Err);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a degree, checked")]
        let degree = self.modes.0.map(|degree| degree.clamp(DEGREES[0], DEGREES[1]) as usize);
        ResolvedElastic {
            area,
            axial: self.young_modulus * area,
            bending: self.young_modulus * second_moment,
            shear: self.shear_factor.0.unwrap_or(RIGID_IN_SHEAR) * shear_modulus * area,
            second_moment,
            second_moment_vertical: vertical,
            vertical_bending: self.young_modulus * vertical,
            torsion_constant,
            torsion: shear_modulus * torsion_constant,
            damping,
            degree,
        }
    }

    /// Faults of keys that contradict each other: key, value, remedy.
    pub(in crate::scene) fn faults(&self, girder: &Girder) -> Vec<(&'static str, Message, Message)> {
        let mut faults = Vec::new();
        let mut add = |key, value: Message, remedy: Text| faults.push((key, value, remedy.into()));
        match (self.area, self.density) {
            (None, None) => add("area_m2", Text::new("found-nothing").into(), Text::new("wrong-no-area")),
            (Some(area), Some(density)) => {
                let mass = area * density * girder.length;
                if (mass - girder.mass).abs() > SAME_MASS * girder.mass {
                    let value = message!(
                        "found-two-masses",
                        "mass" => format!("{mass:.6e}"),
                        "given" => format!("{:.6e}", girder.mass)
                    );
                    add("density_kg_m3", value, Text::new("wrong-two-masses"));
                }
            }
            _ => {}
        }
        if self.damping_ratio.is_some() && self.rayleigh.is_some() {
            add(
                "damping_ratio",
                message!("found-both", "one" => "damping_ratio", "other" => "rayleigh"),
                Text::new("wrong-both"),
            );
        }
        if let Some(degree) = self.modes.0.filter(|degree| degree.fract() != 0.0) {
            add("modes", format!("{degree:?}").into(), Text::new("wrong-degree"));
        }
        faults
    }
}
