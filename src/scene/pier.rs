//! A pier as placed: a mass on the top of a column, on which ends of girders stand (`docs/physics.md#piers`).

use serde::{Deserialize, Serialize};

use super::PerDirection;
use super::keys::{Fallback, Range, table, words};

words! {
    /// Support of a column's top by the cap.
    ColumnTop, by default Free {
        /// It turns freely: a cantilever, `3 E I/h³`.
        Free = "free",
        /// Across the pier a cap beam holds it from turning, `12 E I/h³`; along it is a cantilever.
        FixedAcross = "fixed-across",
        /// It does not turn, `12 E I/h³` both ways.
        Fixed = "fixed",
    }
}

table! {
    /// A pier: a body of its own, which sways on its column and may turn in plan.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct Pier, PIER {
        name: String = "name", Range::Like("unique"), Fallback::Needed("must be given"), "its name";
        mass: f64 = "mass_kg" as "field-mass", Range::Positive, Fallback::Needed("must be given"),
            "mass that moves with its cap: the cap and about a third of a cantilever column, kg";
        position: Option<[f64; 2]> = "position_m", Range::Like("two numbers"),
            Fallback::Words("the middle of the extent of the bearings on it, along and across"), "its place in plan, world, m";
        heading_deg: Option<f64> = "heading_deg" as "field-heading", Range::Any,
            Fallback::Words("square to the end of the first girder on it"),
            "direction of its first axis, which is called along, degrees from world x";
        stiffness: Option<PerDirection> = "stiffness_n_per_m", Range::Positive,
            Fallback::Needed("this, frequency_hz or column_m"), "k of its cap against the ground: one number, or [along, across], N/m";
        frequency: Option<PerDirection> = "frequency_hz", Range::Positive,
            Fallback::Needed("this, stiffness_n_per_m or column_m"), "f of the pier alone, k = m (2πf)²: one number, or [along, across], Hz";
        column: Option<PerDirection> = "column_m", Range::Positive,
            Fallback::Needed("this, stiffness_n_per_m or frequency_hz"),
            "its columns: one number, the diameter of round ones, or [along, across], the sides of rectangular ones, m";
        #[serde(default = "one", serialize_with = "super::whole::serialize")]
        columns: f64 = "columns" as "field-columns", Range::Within([1.0, 12.0]), Fallback::Number(1.0), "how many equal columns stand across it; in k where column_m gives it, else for the drawing";
        modulus: Option<f64> = "young_modulus_pa" as "field-modulus", Range::Positive, Fallback::Words("3e10"),
            "E of its columns, cracked where they are, Pa";
        #[serde(default)]
        top: ColumnTop = "column_top" as "field-column-tops", Range::Words(ColumnTop::WORDS), ColumnTop::FALLBACK,
            "whether the cap holds them from turning: k = 3EI/h³ a column where it is free, 12EI/h³ where it is held";
        damping_ratio: Option<PerDirection> = "damping_ratio", Range::NotNegative, Fallback::Words("0.05"),
            "h of the pier alone, c = 2 h √(k m): one number, or [along, across]";
        turn_stiffness: Option<f64> = "turn_stiffness_n_m_per_rad" as "field-turning-stiffness", Range::Positive,
            Fallback::Words("it does not turn"), "k_θ against rotation in plan, N·m/rad; its dashpot is c/k of the direction across times this";
        turn_inertia: Option<f64> = "turn_inertia_kg_m2" as "field-turning-inertia", Range::Positive,
            Fallback::Words("that of its cap as a plate of its mass"), "moment of inertia about its vertical axis, kg·m²";
        yield_force: Option<PerDirection> = "yield_force_n", Range::Positive, Fallback::Words("none: elastic"),
            "force at which its base yields: one number, or [along, across], N";
        post_yield_ratio: Option<f64> = "post_yield_ratio" as "field-after-yield", Range::Between([0.0, 1.0]), Fallback::Words("0.05"),
            "stiffness after yield over k";
        height: Option<f64> = "height_m" as "field-height", Range::Positive, Fallback::Words("five depths of its deepest girder"),
            "from its foot to the underside of the bearings, m; must be given with column_m";
        cap: Option<[f64; 3]> = "cap_m", Range::Like("three numbers > 0"), Fallback::Words("over its bearings and half the depth of its deepest girder beyond, as high as that is deep"),
            "sides of its cap along, across and up, m; for the drawing and the inertia";
        ground: Option<String> = "ground", Range::Like("the name of a [[ground]]"), Fallback::Words("as [motion]"),
            "how its ground moves";
        delay: Option<f64> = "delay_s" as "field-delay", Range::NotNegative, Fallback::Words("by [wave] where it moves as [motion], else 0.0"),
            "how much later its ground begins to move, s";
        motion_factor: Option<f64> = "motion_factor" as "field-motion-factor", Range::Any, Fallback::Words("1.0"),
            "multiplies the acceleration of its ground";
    }
}

fn one() -> f64 {
    1.0
}
