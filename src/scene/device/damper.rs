//! A viscous damper as placed.

use super::fault::Fault;
use super::joint::Joint;
use super::table::device_table;
use crate::scene::keys::{Fallback, Range};

device_table! {
    /// A viscous damper along the line between its points.
    struct Damper, DAMPER {
        coefficient: f64 = "coefficient" as "field-coefficient", Range::Positive, Fallback::Needed("must be given"),
            "c of F = c sgn(v) abs(v)^α, N (s/m)^α";
        #[serde(default = "linear")]
        exponent: f64 = "exponent" as "field-exponent", Range::Within([0.1, 1.0]), Fallback::Number(LINEAR), "α; 1 is linear",
            slider [0.1, 1.0];
        #[serde(default = "usual")]
        regularisation: f64 = "regularisation_speed_m_s" as "field-regularised", Range::Positive, Fallback::Number(USUAL),
            "v_r of F = c v (v² + v_r²)^((α−1)/2) for α below 1, m/s";
        brace_stiffness: Option<f64> = "brace_stiffness_n_per_m" as "field-brace", Range::Positive,
            Fallback::Words("none: rigid"), "K_b of a spring in series, which takes the place of v_r, N/m";
    }
}

/// α of a linear damper.
const LINEAR: f64 = 1.0;
/// Speed below which a damper with α < 1 is nearly linear \[m/s\].
const USUAL: f64 = 1e-4;

fn linear() -> f64 {
    LINEAR
}

fn usual() -> f64 {
    USUAL
}

impl Damper {
    #[expect(clippy::unused_self, reason = "what every device is asked")]
    fn own_faults(&self, joint: Option<&Joint>) -> Vec<Fault> {
        joint.and_then(Joint::too_short).into_iter().collect()
    }
}
