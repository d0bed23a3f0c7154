//! An abutment as placed: a fixed backwall before the end of a girder.

use serde::{Deserialize, Serialize};

use super::Backfill;
use super::keys::{Fallback, Range, table};
use crate::geometry::End;

table! {
    /// A backwall, fixed unless there is backfill: either it faces the end of a girder, or its face is given as a polygon.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct Abutment, ABUTMENT {
        name: String = "name", Range::Like("unique"), Fallback::Needed("must be given"), "its name";
        faces: String = "faces", Range::Like("a girder"), Fallback::Needed("must be given"),
            "the girder that it stands before";
        #[serde(default = "plus")]
        end: End = "end", Range::Words(&["+x", "-x"]), Fallback::Word("+x"), "the end that it stands before";
        gap: Option<f64> = "gap_m" as "field-gap", Range::NotNegative, Fallback::Needed("this or polygon_m"),
            "distance to that end as placed, along the girder's axis, m (square to the face it is gap · sin β)";
        width: Option<f64> = "width_m" as "field-face-width", Range::Positive, Fallback::Words("three times the girder's end"),
            "extent along the face, m";
        height: Option<f64> = "height_m" as "field-face-height", Range::Positive, Fallback::Words("three times the girder's thickness"),
            "height of the face, about the girder's mid-depth, m";
        offset: Option<f64> = "offset_m" as "field-sideways", Range::Any, Fallback::Number(0.0),
            "shift of the face's centre along the face, to the right as seen from the girder, m";
        polygon: Option<Vec<[f64; 3]>> = "polygon_m", Range::Like("four corners [x, y, z]"),
            Fallback::Needed("this or gap_m"),
            "the face in the world, anticlockwise as seen from the girder, m; flat, convex, a rectangle or a trapezium \
             whose first and third sides are parallel";
        depth: Option<f64> = "depth_m" as "field-depth", Range::Positive, Fallback::Words("the girder's length"),
            "how far it reaches behind its face, m";
        backfill: Option<Backfill> = "backfill", Range::Free, Fallback::Words("none: the backwall is fixed"),
            "soil behind a backwall that can move, see below";
        ground: Option<String> = "ground", Range::Like("the name of a [[ground]]"), Fallback::Words("as [motion]"),
            "how its ground moves";
        delay: Option<f64> = "delay_s" as "field-delay", Range::NotNegative, Fallback::Words("by [wave] where it moves as [motion], else 0.0"),
            "how much later its ground begins to move, s";
        motion_factor: Option<f64> = "motion_factor" as "field-motion-factor", Range::Any, Fallback::Words("1.0"),
            "multiplies the acceleration of its ground";
    }
}

fn plus() -> End {
    End::Plus
}
