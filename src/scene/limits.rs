//! Limits that a designer sets: passing one is flagged, with the time; nothing of the run depends on them.

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table};

/// Without a limit nothing is flagged.
const NONE: Fallback = Fallback::Words("not watched");

table! {
    /// `[limits]`: what must not be passed.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Limits, LIMITS {
        rotation_deg: Option<f64> = "rotation_deg" as "field-rotation-limit", Range::NotNegative, NONE,
            "largest rotation of any girder, either way, degrees";
        drift: Option<f64> = "drift_m" as "field-drift-limit", Range::NotNegative, NONE,
            "largest distance of any corner in plan from where it was placed, m";
        remaining_seat: Option<f64> = "remaining_seat_m" as "field-seat-to-remain", Range::NotNegative, NONE,
            "least seat that remains under every end that has one (seat_m), square to its edge, m";
        force: Option<f64> = "force_n" as "field-force-limit", Range::NotNegative, NONE, "largest force of any contact, a single corner, N";
        total_force: Option<f64> = "total_force_n" as "field-total-force-limit", Range::NotNegative, NONE,
            "largest force between any two bodies, all their contacts together, N";
        bearing_displacement: Option<f64> = "bearing_displacement_m" as "field-bearing-limit", Range::NotNegative, NONE,
            "largest deformation in plan of any bearing, m";
        pier_drift: Option<f64> = "pier_drift_m" as "field-pier-limit", Range::NotNegative, NONE,
            "largest displacement in plan of any pier's cap against its foot, m";
    }
}
