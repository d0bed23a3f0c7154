//! Limits that a designer sets: passing one is flagged, with the time; nothing of the run depends on them.

use serde::{Deserialize, Serialize};

/// What must not be passed; what is not given is not watched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Limits {
    /// Largest rotation of any girder, either way \[degrees, ≥ 0\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rotation_deg: Option<f64>,
    /// Largest distance of any girder's corner from where it was placed, in plan \[m, ≥ 0\].
    #[serde(rename = "drift_m", skip_serializing_if = "Option::is_none")]
    pub drift: Option<f64>,
    /// Least seat that must remain under every end that has one \[m\].
    #[serde(rename = "remaining_seat_m", skip_serializing_if = "Option::is_none")]
    pub remaining_seat: Option<f64>,
    /// Largest force of any contact \[N, ≥ 0\].
    #[serde(rename = "force_n", skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
}
