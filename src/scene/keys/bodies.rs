//! Keys of girders, what they stand on, and abutments.

use super::{Fallback, Key, Range};

/// `[[girder]]`.
pub const GIRDER: &[Key] = &[
    Key::new("name", Range::Like("unique"), Fallback::Needed("must be given"), "its name"),
    Key::new("length_m", Range::Positive, Fallback::Needed("must be given"), "length along the axis, m"),
    Key::new("width_m", Range::Positive, Fallback::Needed("must be given"), "width square to the axis, m"),
    Key::new("thickness_m", Range::Positive, Fallback::Needed("must be given"), "depth of the deck, m"),
    Key::new(
        "skew_deg",
        Range::Between([0.0, 180.0]),
        Fallback::Number(90.0),
        "skew angle β between the axis and the support line, degrees; 90 is straight",
    ),
    Key::new("mass_kg", Range::Positive, Fallback::Needed("must be given"), "mass, kg"),
    Key::new("position_m", Range::Like("three numbers"), Fallback::Zeros(3), "where G is placed, m"),
    Key::new(
        "heading_deg",
        Range::Any,
        Fallback::Number(0.0),
        "direction of the axis in plan, degrees from world x; multiples of 90 are exact",
    ),
    Key::new("bearings", Range::Free, Fallback::Words("none: it flies free"), "what it stands on, see below"),
    Key::new(
        "initial",
        Range::Free,
        Fallback::Words("at rest where placed"),
        "where and how fast it starts, see below",
    ),
    Key::new("push", Range::Free, Fallback::Words("none"), "a constant push, see below"),
    Key::new(
        "held",
        Range::Like("list of \"x\", \"y\", \"z\", \"roll\", \"pitch\", \"yaw\""),
        Fallback::Words("[]"),
        "world directions it is held in; planar scenes hold z, roll and pitch anyway",
    ),
    Key::new("seat_m", Range::Free, Fallback::Words("none"), "length of seat under each end, see below"),
];

/// `bearings` of equal bearings.
pub const BEARINGS: &[Key] = &[
    Key::new(
        "frequency_hz",
        Range::NotNegative,
        Fallback::Needed("must be given"),
        "f, Hz: one number, or [x, y] along and across the girder",
    ),
    Key::new(
        "damping_ratio",
        Range::NotNegative,
        Fallback::Needed("must be given"),
        "h, of critical: one number, or [x, y]",
    ),
    Key::new(
        "vertical_frequency_hz",
        Range::Positive,
        Fallback::Needed("must be given in a spatial scene (unless z is held)"),
        "f_z, Hz; not used in a planar scene",
    ),
    Key::new("vertical_damping_ratio", Range::NotNegative, Fallback::Words("as damping_ratio along x"), "h_z"),
    Key::new(
        "at_m",
        Range::Like("one or more [x, y]"),
        Fallback::Needed("this or the next"),
        "places in the girder's frame, m",
    ),
    Key::new(
        "at_skewed_m",
        Range::Like("one or more [x, y]"),
        Fallback::Needed("this or the last"),
        "places before skewing, m: y cot β is added to x, so that they follow the skew",
    ),
];

/// One of several single `bearings`.
pub const BEARING: &[Key] = &[
    Key::new("at_m", Range::Like("[x, y]"), Fallback::Needed("must be given"), "place in the girder's frame, m"),
    Key::new(
        "stiffness_n_per_m",
        Range::NotNegative,
        Fallback::Needed("must be given"),
        "[k_x, k_y] or [k_x, k_y, k_z] along, across and up, N/m; a spatial girder needs some k_z",
    ),
    Key::new(
        "damping_n_s_per_m",
        Range::NotNegative,
        Fallback::Needed("must be given"),
        "[c_x, c_y] or [c_x, c_y, c_z], N·s/m",
    ),
];

/// `initial`.
pub const INITIAL: &[Key] = &[
    Key::new(
        "displacement_m",
        Range::Like("two or three numbers"),
        Fallback::Zeros(2),
        "of G, world frame, m; a third only in a spatial scene",
    ),
    Key::new("rotation_deg", Range::Any, Fallback::Number(0.0), "about the vertical, degrees"),
    Key::new("velocity_m_s", Range::Like("two or three numbers"), Fallback::Zeros(2), "of G, world frame, m/s"),
    Key::new("spin_deg_s", Range::Any, Fallback::Number(0.0), "about the vertical, degrees/s"),
];

/// `push`.
pub const PUSH: &[Key] = &[
    Key::new("force_n", Range::Like("two or three numbers"), Fallback::Zeros(2), "constant force at G, world frame, N"),
    Key::new("moment_n_m", Range::Any, Fallback::Number(0.0), "constant moment about the vertical, N·m"),
];

/// `seat_m`.
pub const SEAT: &[Key] = &[
    Key::new("+x", Range::Positive, Fallback::Words("not looked at"), "length of seat under the +x end, m"),
    Key::new("-x", Range::Positive, Fallback::Words("not looked at"), "length of seat under the -x end, m"),
];

/// `[[abutment]]`.
pub const ABUTMENT: &[Key] = &[
    Key::new("name", Range::Like("unique"), Fallback::Needed("must be given"), "its name"),
    Key::new("faces", Range::Like("a girder"), Fallback::Needed("must be given"), "the girder that it stands before"),
    Key::new("end", Range::Words(&["+x", "-x"]), Fallback::Word("+x"), "the end that it stands before"),
    Key::new(
        "gap_m",
        Range::NotNegative,
        Fallback::Needed("this or polygon_m"),
        "distance to that end as placed, along the girder's axis, m (square to the face it is gap · sin β)",
    ),
    Key::new("width_m", Range::Positive, Fallback::Words("three times the girder's end"), "extent along the face, m"),
    Key::new(
        "height_m",
        Range::Positive,
        Fallback::Words("three times the girder's thickness"),
        "height of the face, about the girder's mid-depth, m",
    ),
    Key::new("offset_m", Range::Any, Fallback::Number(0.0), "sideways shift of the face's centre along the face, m"),
    Key::new(
        "polygon_m",
        Range::Like("four corners [x, y, z]"),
        Fallback::Needed("this or gap_m"),
        "the face in the world, anticlockwise as seen from the girder, m; flat, convex, a rectangle or a \
         trapezium whose first and third sides are parallel",
    ),
    Key::new(
        "depth_m",
        Range::Positive,
        Fallback::Words("the girder's length"),
        "how far it reaches behind its face, m",
    ),
];
