//! Models that compute a scene, and the numbers of the rigid-body impact model (`docs/physics.md#impact-model`).

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table, words};

words! {
    /// Models that compute a scene.
    ModelKind, by default Contact {
        /// The 3D contact-friction model (paper section 4).
        Contact = "contact",
        /// The 2D rigid-body impact model (paper section 3); planar scenes.
        Impact = "impact",
        /// Both, the contact model first.
        Both = "both",
    }
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
}

table! {
    /// `[model]`: what computes the scene.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
    default struct ModelSettings, MODEL {
        kind: ModelKind = "kind" as "field-model", Range::Words(ModelKind::WORDS), ModelKind::FALLBACK,
            "the 3D contact-friction model, the 2D rigid-body impact model (planar scenes only), or both, to be looked \
             at together; the contact model leads";
    }
}

words! {
    /// Treatment of a hit along a whole face by the impact model.
    Flush, by default Paper {
        /// The paper's: one impulse at the centroid of the approach speeds along the face (44), then one at the corner
        /// that the rotation drives in.
        Paper = "paper",
        /// An impulse at each end of the face, neither of them pulling, with Coulomb friction: the rigid parallelogram.
        TwoCorner = "two-corner",
    }
}

table! {
    /// `[impact]`: numbers of the impact model.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct ImpactSettings, IMPACT {
        restitution_normal: f64 = "restitution_normal" as "field-impact-en", Range::Within([0.0, 1.0]), Fallback::Number(0.4), "e_n (29)", slider [0.0, 1.0];
        restitution_tangential: f64 = "restitution_tangential" as "field-impact-et", Range::Within([-1.0, 1.0]), Fallback::Number(-0.9),
            "e_t (31); −1 is smooth", slider [-1.0, 1.0];
        mu_static: f64 = "mu_static" as "field-face-mus", Range::NotBelow("mu_kinetic"), Fallback::Number(0.2), "μ_s of a face", slider [0.0, 1.0];
        mu_kinetic: f64 = "mu_kinetic" as "field-face-muk", Range::NotNegative, Fallback::Number(0.15), "μ_k of a face", slider [0.0, 1.0];
        corner_mu_static: Option<f64> = "corner_mu_static" as "field-corner-mus", Range::NotBelow("corner_mu_kinetic"),
            Fallback::Words("mu_static"), "μ̄_s of a corner", slider [0.0, 1.0];
        corner_mu_kinetic: Option<f64> = "corner_mu_kinetic" as "field-corner-muk", Range::NotNegative,
            Fallback::Words("mu_kinetic, or μ̄_s where that is less"), "μ̄_k of a corner", slider [0.0, 1.0];
        flush: Flush = "flush" as "field-flush-hits", Range::Words(Flush::WORDS), Flush::FALLBACK,
            "a hit along a whole face: the paper's impulse at the centroid of the approach (44), or an impulse at each \
             of its ends";
        stop_speed: f64 = "stop_speed_m_s" as "field-stop-speed", Range::Positive, Fallback::Number(1e-4),
            "slower than this there is no bounce, m/s", slider [1e-6, 1e-2];
    }
}

impl ImpactSettings {
    /// `[μ̄_s, μ̄_k]` of a corner.
    pub fn corner_friction(&self) -> [f64; 2] {
        let mu_s = self.corner_mu_static.unwrap_or(self.mu_static);
        [mu_s, self.corner_mu_kinetic.unwrap_or(self.mu_kinetic.min(mu_s))]
    }
}
