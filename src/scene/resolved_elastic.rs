//! What the keys of an elastic girder come to for a girder of its size.

use super::elastic::{DEGREES, Elastic, Rayleigh};
use super::girder::Girder;

/// `k_s G A` of a girder that is rigid in shear, in parts of `G A`.
const RIGID_IN_SHEAR: f64 = 1e4;
/// What `ρ A a0` may differ from the mass by, in parts of it.
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
            damping,
            degree,
        }
    }

    /// What is wrong with keys that stand together: key, value, remedy.
    pub(in crate::scene) fn faults(&self, girder: &Girder) -> Vec<(&'static str, String, String)> {
        let mut faults = Vec::new();
        let mut add = |key, value: &str, remedy: &str| faults.push((key, value.to_owned(), remedy.to_owned()));
        match (self.area, self.density) {
            (None, None) => add("area_m2", "nothing", "give the section's area in m², or density_kg_m3"),
            (Some(area), Some(density)) => {
                let mass = area * density * girder.length;
                if (mass - girder.mass).abs() > SAME_MASS * girder.mass {
                    let value = format!("ρ A a₀ = {mass:.6e} kg beside a mass of {:.6e} kg", girder.mass);
                    add(
                        "density_kg_m3",
                        &value,
                        "give area_m2 or density_kg_m3 alone, or a mass that agrees within 1 %",
                    );
                }
            }
            _ => {}
        }
        if self.damping_ratio.is_some() && self.rayleigh.is_some() {
            add("damping_ratio", "damping_ratio and rayleigh", "give one of the two");
        }
        if let Some(degree) = self.modes.0.filter(|degree| degree.fract() != 0.0) {
            add("modes", &format!("{degree:?}"), "give a whole number from 2 to 64, or \"auto\"");
        }
        faults
    }
}
