//! Soil behind an abutment's backwall, and the backwall as a body that is pushed into it (`docs/physics.md#backfill`).

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table, words};

words! {
    /// Envelope of the soil's resistance F over the push y.
    BackfillLaw, by default Bilinear {
        /// `F = y/(1/K + R_f y/F_ult)`.
        Hyperbolic = "hyperbolic",
        /// The hyperbola through `F_ult/2` at `F_ult/(2K)` and `F_ult` at `y_max`, constant from there.
        MeanStiffness = "mean-stiffness",
        /// `K y` up to `F_ult`, constant from there.
        Bilinear = "bilinear",
    }
}

table! {
    /// `[abutment.backfill]`: soil behind a backwall that can move.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Backfill, BACKFILL {
        law: BackfillLaw = "law" as "field-soil", Range::Words(BackfillLaw::WORDS), BackfillLaw::FALLBACK,
            "envelope of the resistance over the push";
        height: Option<f64> = "height_m" as "field-wall-height", Range::Positive, Fallback::Words("the girder's thickness"),
            "height of the wall that presses on the soil, m";
        stiffness: Option<f64> = "stiffness_n_per_m" as "field-soil-stiffness", Range::Positive,
            Fallback::Words("by the law, b₀ and h"), "slope at no push; of mean-stiffness that through F_ult/2, N/m";
        ultimate: Option<f64> = "ultimate_n" as "field-ultimate-force", Range::Positive,
            Fallback::Words("by the law, b₀ and h, times exp(-skew/45°)"), "F_ult, N";
        failure_ratio: Option<f64> = "failure_ratio" as "field-failure-ratio", Range::Between([0.0, 1.0]), Fallback::Words("0.7"),
            "R_f of the hyperbolic law";
        limit: Option<f64> = "failing_push_m" as "field-failing-push", Range::Positive, Fallback::Words("0.05 h"),
            "y_max of mean-stiffness, m";
        unloading: Option<f64> = "unloading_stiffness_n_per_m" as "field-unloading-stiffness", Range::Positive,
            Fallback::Words("the slope at no push"), "K_ur, N/m";
        reduces_stiffness: bool = "skew_reduces_stiffness" as "field-skew-reduces", Range::Switch, Fallback::Switch(false),
            "whether exp(-skew/45°) reduces the stiffness that is not given as well";
        mass: Option<f64> = "wall_mass_kg" as "field-wall-mass", Range::Positive, Fallback::Words("of concrete, h/4 thick"),
            "mass of the backwall that moves, kg";
        friction: Option<f64> = "base_friction" as "field-base-friction", Range::NotNegative, Fallback::Words("0.6"),
            "friction coefficient below the wall";
        base_displacement: Option<f64> = "base_displacement_m" as "field-base-slides", Range::Positive,
            Fallback::Words("0.0001"), "displacement at which that friction is fully there, m";
        fuse_stiffness: Option<f64> = "fuse_stiffness_n_per_m" as "field-fuse-stiffness", Range::Positive,
            Fallback::Words("no fuse"), "of what holds the wall at its foot until it breaks, N/m";
        fuse_force: Option<f64> = "fuse_force_n" as "field-fuse-breaks", Range::Positive,
            Fallback::Needed("must be given with fuse_stiffness_n_per_m"), "force at which that breaks, N";
    }
}

impl Backfill {
    /// Keys of numbers in force that are left out.
    pub fn assumed(&self) -> Vec<&'static str> {
        let own = match self.law {
            BackfillLaw::Hyperbolic => Some(("failure_ratio", self.failure_ratio)),
            BackfillLaw::MeanStiffness => Some(("failing_push_m", self.limit)),
            BackfillLaw::Bilinear => None,
        };
        let all = [
            ("height_m", self.height),
            ("stiffness_n_per_m", self.stiffness),
            ("ultimate_n", self.ultimate),
            ("unloading_stiffness_n_per_m", self.unloading),
            ("wall_mass_kg", self.mass),
            ("base_friction", self.friction),
        ];
        all.into_iter().chain(own).filter(|(_, given)| given.is_none()).map(|(key, _)| key).collect()
    }
}
