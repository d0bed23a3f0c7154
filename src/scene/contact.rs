//! Contact numbers of a scene, and overrides for named pairs.

use serde::{Deserialize, Serialize};

use crate::geometry::End;

/// What friction does in slip and on re-stick (`docs/physics.md#friction-laws`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FrictionLaw {
    /// The paper's: the anchor is the projection in slip, the tangential force restarts at 0 on re-stick.
    Paper,
    /// Elastic-plastic Coulomb (Cundall and Strack): the anchor is dragged, the force is continuous on re-stick.
    #[default]
    ReturnMapping,
}

/// How the stiffness of a facing pair is shared between its nodes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sharing {
    /// K and C divided by the number of declared nodes inside the facing polygon when the pair first closes.
    #[default]
    Tributary,
    /// Each node has the whole K and C.
    PerNode,
}

/// Whether a contact may pull just before it opens.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Tension {
    /// The dashpot may pull; restitution is exact.
    #[default]
    Keep,
    /// The normal force is held at 0 or above.
    Clamp,
}

/// `[contact]`: numbers for every pair that `[[contact.pair]]` does not override.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ContactSettings {
    /// `K` of a pair of facing ends (54); `K = E A / L` (64) when absent \[N/m\].
    #[serde(rename = "stiffness_n_per_m", skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<f64>,
    /// `E` of (64), when `K` is not given \[Pa\].
    #[serde(rename = "young_modulus_pa", skip_serializing_if = "Option::is_none")]
    pub young_modulus: Option<f64>,
    /// `A` of (64); the girder's end section when absent \[m²\].
    #[serde(rename = "area_m2", skip_serializing_if = "Option::is_none")]
    pub area: Option<f64>,
    /// `e_n`, in \[0.01, 1\]; 1 is no dashpot (65).
    pub restitution_normal: f64,
    /// `e_t`, in \[0.01, 1\]; 1 is no dashpot (65).
    pub restitution_tangential: f64,
    /// `μ_s` (55).
    pub mu_static: f64,
    /// `μ_k` ≤ `μ_s` (59).
    pub mu_kinetic: f64,
    /// The friction law.
    pub law: FrictionLaw,
    /// How K and C are shared between nodes.
    pub sharing: Sharing,
    /// Whether a contact may pull.
    pub tension: Tension,
    /// Overrides, and pairs that are not found by themselves.
    #[serde(rename = "pair", skip_serializing_if = "Vec::is_empty")]
    pub pairs: Vec<PairSettings>,
}

impl Default for ContactSettings {
    fn default() -> Self {
        Self {
            stiffness: None,
            young_modulus: None,
            area: None,
            restitution_normal: 0.4,
            restitution_tangential: 0.9,
            mu_static: 0.20,
            mu_kinetic: 0.15,
            law: FrictionLaw::default(),
            sharing: Sharing::default(),
            tension: Tension::default(),
            pairs: Vec::new(),
        }
    }
}

/// `[[contact.pair]]`: what differs between two named bodies; with `ends`, also declares the pair.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairSettings {
    /// Names of the two bodies; at least one is a girder.
    pub between: [String; 2],
    /// Their ends, in the same order, when the pair is not found by itself; the end of an abutment is not looked at.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ends: Option<[End; 2]>,
    /// `K` \[N/m\].
    #[serde(rename = "stiffness_n_per_m", default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<f64>,
    /// `E` \[Pa\].
    #[serde(rename = "young_modulus_pa", default, skip_serializing_if = "Option::is_none")]
    pub young_modulus: Option<f64>,
    /// `A` \[m²\].
    #[serde(rename = "area_m2", default, skip_serializing_if = "Option::is_none")]
    pub area: Option<f64>,
    /// `e_n`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub restitution_normal: Option<f64>,
    /// `e_t`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub restitution_tangential: Option<f64>,
    /// `μ_s`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mu_static: Option<f64>,
    /// `μ_k`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mu_kinetic: Option<f64>,
    /// The friction law.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub law: Option<FrictionLaw>,
    /// How K and C are shared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sharing: Option<Sharing>,
    /// Whether a contact may pull.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<Tension>,
}
