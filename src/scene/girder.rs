//! A girder as placed.

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Keyed as _, Range, Stands, table, words};
use super::{Bearings, Elastic};
use crate::geometry::{End, Prism};

/// A direction that a body can be held in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// World x.
    X,
    /// World y.
    Y,
    /// World z.
    Z,
    /// Rotation about world x.
    Roll,
    /// Rotation about world y.
    Pitch,
    /// Rotation about world z, the planar θ.
    Yaw,
}

table! {
    /// Initial displacement and velocity of a girder, relative to where it was placed.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Initial, INITIAL {
        #[serde(with = "super::two_or_three")]
        displacement: [f64; 3] = "displacement_m" as "field-starts-at", Range::Like("two or three numbers"), Fallback::Zeros(2),
            "of G, world frame, m; a third only in a spatial scene";
        rotation_deg: f64 = "rotation_deg" as "field-starts-turned", Range::Any, Fallback::Number(0.0), "about the vertical, degrees";
        #[serde(with = "super::two_or_three")]
        velocity: [f64; 3] = "velocity_m_s" as "field-starts-velocity", Range::Like("two or three numbers"), Fallback::Zeros(2),
            "of G, world frame, m/s";
        spin_deg_s: f64 = "spin_deg_s" as "field-starts-spin", Range::Any, Fallback::Number(0.0), "about the vertical, degrees/s";
        pitch_deg: Option<f64> = "pitch_deg" as "field-starts-pitched", Range::Any, Fallback::Words("0.0"),
            "about its y axis after that turn, +x end downwards, degrees", in in_space;
        roll_deg: Option<f64> = "roll_deg" as "field-starts-rolled", Range::Any, Fallback::Words("0.0"),
            "about its x axis after those two, degrees", in in_space;
        pitch_deg_s: Option<f64> = "pitch_deg_s" as "field-starts-pitch-rate", Range::Any, Fallback::Words("0.0"),
            "rate of pitch_deg, degrees/s", in in_space;
        roll_deg_s: Option<f64> = "roll_deg_s" as "field-starts-roll-rate", Range::Any, Fallback::Words("0.0"),
            "rate of roll_deg, degrees/s", in in_space;
    }
}

table! {
    /// A constant push on a girder, at G, in the world frame.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Push, PUSH {
        #[serde(with = "super::two_or_three")]
        force: [f64; 3] = "force_n" as "field-push", Range::Like("two or three numbers"), Fallback::Zeros(2),
            "constant force at G, world frame, N";
        moment: f64 = "moment_n_m" as "field-push-moment", Range::Any, Fallback::Number(0.0), "constant moment about the vertical, N·m";
        moment_x: Option<f64> = "moment_x_n_m" as "field-push-moment-x", Range::Any, Fallback::Words("0.0"),
            "constant moment about world x, N·m", in in_space;
        moment_y: Option<f64> = "moment_y_n_m" as "field-push-moment-y", Range::Any, Fallback::Words("0.0"),
            "constant moment about world y, N·m", in in_space;
    }
}

table! {
    /// Length of seat under each end, along the axis, and its width, for what remains of it \[m\].
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct Seat, SEAT {
        plus: Option<f64> = "+x" as "field-seat-plus", Range::Positive, Fallback::Words("not looked at"),
            "length of seat under the +x end, m";
        minus: Option<f64> = "-x" as "field-seat-minus", Range::Positive, Fallback::Words("not looked at"),
            "length of seat under the -x end, m";
        side: Option<f64> = "side" as "field-seat-side", Range::NotNegative, Fallback::Words("not looked at"),
            "by how much both seats are wider than the deck at either side, along their front edge, m";
    }
}

impl Seat {
    /// Length under an end along the axis \[m\].
    pub fn length(self, end: End) -> Option<f64> {
        match end {
            End::Plus => self.plus,
            End::Minus => self.minus,
        }
    }
}

impl Initial {
    /// Roll, pitch and yaw \[rad\], in the reverse order of their rotations.
    pub fn angles(&self) -> [f64; 3] {
        [self.roll_deg.unwrap_or(0.0), self.pitch_deg.unwrap_or(0.0), self.rotation_deg].map(f64::to_radians)
    }

    /// Their rates \[rad/s\].
    pub fn angle_rates(&self) -> [f64; 3] {
        [self.roll_deg_s.unwrap_or(0.0), self.pitch_deg_s.unwrap_or(0.0), self.spin_deg_s].map(f64::to_radians)
    }
}

impl Push {
    /// About the world's x, y and z \[N·m\].
    pub fn moments(&self) -> [f64; 3] {
        [self.moment_x.unwrap_or(0.0), self.moment_y.unwrap_or(0.0), self.moment]
    }
}

words! {
    /// Effect of a bearing's loss of support on a planar run.
    AfterUnseating, by default Stop {
        /// It stops, with the reason.
        Stop = "stop",
        /// It goes on without that bearing, and every later sample says so.
        Continue = "continue",
    }
}

/// Default drop of a corner of a spatial girder that lost a support at which its run stops \[m\].
const DROP: f64 = 0.1;

/// A girder whose ends are square to its axis \[degrees\].
const STRAIGHT: f64 = 90.0;

table! {
    /// A girder: a prism of parallelogram plan, rigid unless it is elastic.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct Girder, GIRDER {
        name: String = "name", Range::Like("unique"), Fallback::Needed("must be given"), "its name";
        length: f64 = "length_m" as "field-length-a", Range::Positive, Fallback::Needed("must be given"), "length along the axis, m";
        width: f64 = "width_m" as "field-width-b", Range::Positive, Fallback::Needed("must be given"), "width square to the axis, m";
        thickness: f64 = "thickness_m" as "field-thickness", Range::Positive, Fallback::Needed("must be given"), "depth of the deck, m";
        #[serde(default = "straight")]
        skew_deg: f64 = "skew_deg" as "field-skew", Range::Between([0.0, 180.0]), Fallback::Number(STRAIGHT),
            "skew angle β between the axis and the support line, degrees; 90 is straight", slider [20.0, 160.0];
        mass: f64 = "mass_kg" as "field-mass-m", Range::Positive, Fallback::Needed("must be given"), "mass, kg";
        #[serde(default)]
        position: [f64; 3] = "position_m" as "field-position", Range::Like("three numbers"), Fallback::Zeros(3), "where G is placed, m";
        #[serde(default)]
        heading_deg: f64 = "heading_deg" as "field-heading", Range::Any, Fallback::Number(0.0),
            "direction of the axis in plan, degrees from world x; multiples of 90 are exact";
        bearings: Option<Bearings> = "bearings", Range::Free, Fallback::Words("none: it flies free"),
            "what it stands on, see below";
        #[serde(default)]
        initial: Initial = "initial", Range::Free, Fallback::Words("at rest where placed"),
            "where and how fast it starts, see below";
        #[serde(default)]
        push: Push = "push", Range::Free, Fallback::Words("none"), "a constant push, see below";
        #[serde(default)]
        held: Vec<Direction> = "held", Range::Like("list of \"x\", \"y\", \"z\", \"roll\", \"pitch\", \"yaw\""),
            Fallback::Words("[]"), "world directions it is held in; planar scenes hold z, roll and pitch anyway";
        #[serde(default)]
        seat: Seat = "seat_m", Range::Free, Fallback::Words("none"), "length of seat under each end, see below";
        elastic: Option<Elastic> = "elastic", Range::Free, Fallback::Words("none: it is rigid"),
            "how it bends and shortens, see below; under the contact model";
        after_unseating: Option<AfterUnseating> = "after_unseating" as "field-off-a-seat", Range::Words(AfterUnseating::WORDS),
            Fallback::Words("stop where a bearing has travel_m; seats are only measured"),
            "what a planar run does when a bearing loses its support; given, bearings are lost over the front edges of seats as well";
        drop: Option<f64> = "drop_m" as "field-stops-dropped", Range::Positive, Fallback::Words("0.1"),
            "how far a corner of a spatial girder that lost a support drops before the run stops, m", in in_space;
    }
}

fn straight() -> f64 {
    STRAIGHT
}

impl Stands for Vec<Direction> {
    fn by_default(_: Fallback) -> Self {
        Self::new()
    }

    fn is_left_out(&self) -> bool {
        self.is_empty()
    }
}

impl Girder {
    /// A straight girder of this length, width and thickness \[m\] and mass \[kg\], at rest in the origin without bearings.
    pub fn straight(name: impl Into<String>, [length, width, thickness]: [f64; 3], mass: f64) -> Self {
        Self { name: name.into(), length, width, thickness, mass, ..Self::by_default() }
    }

    /// Drop of a corner, in space, at which the run stops \[m\].
    pub fn drop(&self) -> f64 {
        self.drop.unwrap_or(DROP)
    }

    /// Its shape. 90° is π/2 to the last bit, so a straight girder has no shear.
    pub fn prism(&self) -> Prism {
        Prism { length: self.length, width: self.width, thickness: self.thickness, skew: self.skew_deg.to_radians() }
    }
}
