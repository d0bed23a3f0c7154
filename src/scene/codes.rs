//! Inputs of design codes for seat lengths beside the scene; the run does not depend on them.

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table, words};

words! {
    /// A support of a bridge as Caltrans' criteria tell them apart.
    Support, by default Abutment {
        /// The backwall and seat of an abutment.
        Abutment = "abutment",
        /// A hinge within a span or on a pier.
        Hinge = "hinge",
    }
}

words! {
    /// Ground type of the Japanese specifications.
    JapaneseGround, by default Second {
        /// Stiff.
        First = "I",
        /// Medium.
        Second = "II",
        /// Soft.
        Third = "III",
    }
}

words! {
    /// Ground type of EN 1998-1.
    EuropeanGround, by default C {
        /// Rock.
        A = "A",
        /// Very dense sand, gravel, very stiff clay.
        B = "B",
        /// Dense or medium-dense sand, gravel, stiff clay.
        C = "C",
        /// Loose-to-medium or soft soil.
        D = "D",
        /// A soft layer on rock.
        E = "E",
    }
}

table! {
    /// `[codes]`: what design codes for seat lengths need beside the scene.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Codes, CODES {
        deck_length: Option<f64> = "deck_length_m" as "field-deck-to-joint", Range::Positive, Fallback::Words("the girder's length"),
            "deck to the next joint: L of AASHTO, l and L_θ of JRA, L_eff of EN 1998-2, m";
        support_distance: Option<f64> = "support_distance_m" as "field-between-supports", Range::Positive, Fallback::Words("the girder's length"),
            "distance between the supports that move apart: L of JRA's u_G, m";
        column_height: Option<f64> = "column_height_m" as "field-column-height", Range::NotNegative, Fallback::Words("that of the pier under the end, else under the other end, or 0.0"),
            "average height of the columns, 0 for a single span: H of AASHTO, m";
        zone_percent: Option<f64> = "zone_percent" as "field-zone-percentage", Range::Within([50.0, 200.0]), Fallback::Words("150.0"),
            "percentage of N by seismic zone: of AASHTO LRFD";
        rotation_deg: Option<f64> = "rotation_deg" as "field-rotation-e", Range::Between([0.0, 45.0]), Fallback::Words("5.0"),
            "rotation of the deck: α_E of JRA, degrees";
        japanese_ground: Option<JapaneseGround> = "japanese_ground" as "field-ground-jra", Range::Words(JapaneseGround::WORDS),
            Fallback::Words("\"II\""), "ground type of JRA, for ε_G";
        european_ground: Option<EuropeanGround> = "european_ground" as "field-ground-en", Range::Words(EuropeanGround::WORDS),
            Fallback::Words("\"C\""), "ground type of EN 1998, for S, T_C, T_D and L_g";
        ground_acceleration_g: Option<f64> = "ground_acceleration_g" as "field-design-ag", Range::Positive, Fallback::Words("0.25"),
            "design ground acceleration: a_g of EN 1998, g";
        soil_factor: Option<f64> = "soil_factor" as "field-soil-factor", Range::Positive, Fallback::Words("by european_ground"),
            "S of EN 1998";
        corner_period: Option<f64> = "corner_period_s" as "field-period-tc", Range::Positive, Fallback::Words("by european_ground"),
            "T_C of EN 1998, s";
        displacement_period: Option<f64> = "displacement_period_s" as "field-period-td", Range::Positive, Fallback::Words("by european_ground"),
            "T_D of EN 1998, s";
        bearing_length: Option<f64> = "bearing_length_m" as "field-bearing-length", Range::Positive, Fallback::Words("0.4"),
            "length of support that carries the reaction: l_m of EN 1998-2, at least 0.4 there, m";
        long_term: Option<f64> = "long_term_m" as "field-long-term", Range::NotNegative, Fallback::Words("0.0"),
            "prestress, creep and shrinkage: Δ_p/s + Δ_cr+sh of Caltrans, d_G of EN 1998-2, m";
        temperature: Option<f64> = "temperature_m" as "field-thermal", Range::NotNegative, Fallback::Words("0.0"),
            "movement by temperature: Δ_temp of Caltrans, d_T of EN 1998-2, m";
        caltrans_support: Option<Support> = "caltrans_support" as "field-support-caltrans", Range::Words(Support::WORDS),
            Fallback::Words("\"abutment\""), "kind of support, for the least length of Caltrans";
    }
}
