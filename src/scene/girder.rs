//! A girder as placed.

use serde::{Deserialize, Serialize};

use super::Bearings;
use super::settings::is_default;
use crate::geometry::Prism;

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

/// Where and how fast a girder starts, relative to where it was placed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Initial {
    /// Displacement of G in the world frame, x, y and (spatial) z; two or three numbers \[m\].
    #[serde(rename = "displacement_m", with = "super::format::two_or_three")]
    pub displacement: [f64; 3],
    /// Rotation about the vertical, anticlockwise \[degrees\].
    pub rotation_deg: f64,
    /// Velocity of G in the world frame; two or three numbers \[m/s\].
    #[serde(rename = "velocity_m_s", with = "super::format::two_or_three")]
    pub velocity: [f64; 3],
    /// Spin about the vertical \[degrees/s\].
    pub spin_deg_s: f64,
}

/// A constant push on a girder, at G, in the world frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Push {
    /// Force \[N\]; two or three numbers.
    #[serde(rename = "force_n", with = "super::format::two_or_three")]
    pub force: [f64; 3],
    /// Moment about the vertical \[N·m\].
    #[serde(rename = "moment_n_m")]
    pub moment: f64,
}

/// Length of seat under each end, along the axis, for what remains of it \[m\].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Seat {
    /// Under the `+x` end.
    #[serde(rename = "+x", skip_serializing_if = "Option::is_none")]
    pub plus: Option<f64>,
    /// Under the `-x` end.
    #[serde(rename = "-x", skip_serializing_if = "Option::is_none")]
    pub minus: Option<f64>,
}

/// A rigid girder: a prism of parallelogram plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Girder {
    /// Its name, unique in the scene.
    pub name: String,
    /// `a0`, along the axis \[m\].
    #[serde(rename = "length_m")]
    pub length: f64,
    /// `b0`, square to the axis \[m\].
    #[serde(rename = "width_m")]
    pub width: f64,
    /// `t0` \[m\].
    #[serde(rename = "thickness_m")]
    pub thickness: f64,
    /// Skew angle β, in (0, 180); 90 is straight \[degrees\].
    #[serde(default = "straight")]
    pub skew_deg: f64,
    /// `m` \[kg\].
    #[serde(rename = "mass_kg")]
    pub mass: f64,
    /// Where G is placed \[m\].
    #[serde(rename = "position_m", default)]
    pub position: [f64; 3],
    /// Direction of the axis in plan, anticlockwise from world x \[degrees\].
    #[serde(default, skip_serializing_if = "is_zero")]
    pub heading_deg: f64,
    /// What it stands on; nothing when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bearings: Option<Bearings>,
    /// Where and how fast it starts.
    #[serde(default, skip_serializing_if = "is_default")]
    pub initial: Initial,
    /// A constant push.
    #[serde(default, skip_serializing_if = "is_default")]
    pub push: Push,
    /// World directions it is held in.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub held: Vec<Direction>,
    /// Length of seat under each end.
    #[serde(rename = "seat_m", default, skip_serializing_if = "is_default")]
    pub seat: Seat,
}

fn straight() -> f64 {
    90.0
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
fn is_zero(v: &f64) -> bool {
    *v == 0.0
}

impl Girder {
    /// Its shape. 90° is π/2 to the last bit, so a straight girder has no shear.
    pub fn prism(&self) -> Prism {
        Prism { length: self.length, width: self.width, thickness: self.thickness, skew: self.skew_deg.to_radians() }
    }
}
