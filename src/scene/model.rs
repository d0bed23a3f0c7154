//! Which model computes a scene, and the numbers of the rigid-body impact model (`docs/physics.md#impact-model`).

use serde::{Deserialize, Serialize};

/// Which of the two models computes a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ModelKind {
    /// The 3D contact-friction model (paper section 4).
    #[default]
    Contact,
    /// The 2D rigid-body impact model (paper section 3); planar scenes.
    Impact,
    /// Both, the contact model first.
    Both,
}

impl ModelKind {
    /// The models that this asks for, the one that leads first.
    pub fn models(self) -> &'static [Self] {
        match self {
            Self::Contact => &[Self::Contact],
            Self::Impact => &[Self::Impact],
            Self::Both => &[Self::Contact, Self::Impact],
        }
    }

    /// The word used in files and tables.
    pub fn label(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::Impact => "impact",
            Self::Both => "both",
        }
    }
}

/// `[model]`: what computes the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ModelSettings {
    /// The model, or both.
    pub kind: ModelKind,
}

/// How the impact model meets a hit along a whole face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Flush {
    /// The paper's: one impulse at the centroid of the approach speeds along the face (44), then one at the corner that
    /// the rotation drives in.
    #[default]
    Paper,
    /// An impulse at each end of the face, neither of them pulling, with Coulomb friction: the rigid parallelogram.
    TwoCorner,
}

/// `[impact]`: numbers of the impact model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ImpactSettings {
    /// `e_n` in \[0, 1\] (29, 30).
    pub restitution_normal: f64,
    /// `e_t` in \[−1, 1\]; −1 is smooth (31, 32).
    pub restitution_tangential: f64,
    /// `μ_s` of a face.
    pub mu_static: f64,
    /// `μ_k` of a face.
    pub mu_kinetic: f64,
    /// `μ̄_s` of a corner; the face's when absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner_mu_static: Option<f64>,
    /// `μ̄_k` of a corner; the face's when absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner_mu_kinetic: Option<f64>,
    /// How a whole face is hit.
    pub flush: Flush,
    /// Slower than this there is no bounce: `e_n` → 0, `e_t` → −1 \[m/s\].
    #[serde(rename = "stop_speed_m_s")]
    pub stop_speed: f64,
}

impl Default for ImpactSettings {
    fn default() -> Self {
        Self {
            restitution_normal: 0.4,
            restitution_tangential: -0.9,
            mu_static: 0.20,
            mu_kinetic: 0.15,
            corner_mu_static: None,
            corner_mu_kinetic: None,
            flush: Flush::default(),
            stop_speed: 1e-4,
        }
    }
}

impl ImpactSettings {
    /// `[μ̄_s, μ̄_k]` of a corner.
    pub fn corner_friction(&self) -> [f64; 2] {
        let mu_s = self.corner_mu_static.unwrap_or(self.mu_static);
        [mu_s, self.corner_mu_kinetic.unwrap_or(self.mu_kinetic.min(mu_s))]
    }
}
