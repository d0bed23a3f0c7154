//! A wave that reaches the supports of a bridge one after another, as written in a scene.

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table};

table! {
    /// `[wave]`: the motion travels along the bridge; without it the ground moves as one.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    struct Wave, WAVE {
        speed: f64 = "speed_m_per_s" as "field-wave-speed", Range::Positive, Fallback::Needed("must be given"),
            "apparent speed of the wave along the ground, m/s", slider [100.0, 5000.0];
        #[serde(default)]
        angle_deg: f64 = "angle_deg" as "field-wave-angle", Range::Any, Fallback::Number(0.0),
            "direction in plan in which it travels, degrees from world x", slider [-180.0, 180.0];
    }
}

impl Default for Wave {
    /// Along world x at the speed of shear waves in stiff soil.
    fn default() -> Self {
        Self { speed: 500.0, angle_deg: 0.0 }
    }
}
