//! The girder's shape: a homogeneous prism of parallelogram plan (`docs/physics.md#rigid-body`, (4e)).

use glam::{DMat3, DVec2, DVec3};

/// One of the two ends of a girder, named by the direction of the girder's own axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub enum End {
    /// The end that the girder's axis points to.
    #[serde(rename = "+x")]
    Plus,
    /// The end that the girder's axis points away from.
    #[serde(rename = "-x")]
    Minus,
}

impl End {
    /// Both ends, `+x` first.
    pub const BOTH: [Self; 2] = [Self::Plus, Self::Minus];

    /// +1 for `+x`, −1 for `-x`.
    pub fn sign(self) -> f64 {
        match self {
            Self::Plus => 1.0,
            Self::Minus => -1.0,
        }
    }

    /// The end across the girder's middle.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Plus => Self::Minus,
            Self::Minus => Self::Plus,
        }
    }

    /// The end as files spell it.
    pub fn label(self) -> &'static str {
        match self {
            Self::Plus => "+x",
            Self::Minus => "-x",
        }
    }
}

/// A prism of parallelogram plan about its centroid G; the body frame has x along the girder's axis and z up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prism {
    /// `a0`, along the axis \[m\].
    pub length: f64,
    /// `b0`, square to the axis \[m\].
    pub width: f64,
    /// `t0`, the depth of the girder \[m\].
    pub thickness: f64,
    /// Skew angle β between the axis and the support line, in (0, π); π/2 is a straight girder \[rad\].
    pub skew: f64,
}

impl Prism {
    /// `cot β`, the shift along the axis per length across it; exactly 0 for a straight girder.
    pub fn shear(&self) -> f64 {
        // tan(π/2) is 1.6e16 in floating point: a straight girder must be straight to the last bit.
        if self.skew == std::f64::consts::FRAC_PI_2 { 0.0 } else { self.skew.cos() / self.skew.sin() }
    }

    /// Plan corners in the body frame, anticlockwise from (−x, −y): `(±a0/2 + y cot β, y)`, `y = ±b0/2` \[m\].
    pub fn plan_corners(&self) -> [DVec2; 4] {
        let (a, b, c) = (self.length / 2.0, self.width / 2.0, self.shear());
        [(-a, -b), (a, -b), (a, b), (-a, b)].map(|(x, y)| DVec2::new(x + y * c, y))
    }

    /// Largest distance of a corner from the centre \[m\].
    pub fn radius(&self) -> f64 {
        self.corners().iter().map(|corner| corner.length()).fold(0.0, f64::max)
    }

    /// All eight corners in the body frame: the plan corners at the underside, then at the top \[m\].
    pub fn corners(&self) -> [DVec3; 8] {
        let plan = self.plan_corners();
        let h = self.thickness / 2.0;
        std::array::from_fn(|i| plan[i % 4].extend(if i < 4 { -h } else { h }))
    }

    /// Plan corner numbers of an end, the one at −y first.
    pub fn end_corners(end: End) -> [usize; 2] {
        match end {
            End::Plus => [1, 2],
            End::Minus => [0, 3],
        }
    }

    /// Angle of the plan at a corner, β or π − β \[rad\].
    pub fn corner_angle(&self, corner: usize) -> f64 {
        if corner.is_multiple_of(2) { self.skew } else { std::f64::consts::PI - self.skew }
    }

    /// The angle of the plan at a corner in a word.
    pub fn corner_kind(&self, corner: usize) -> &'static str {
        let over = self.corner_angle(corner) - std::f64::consts::FRAC_PI_2;
        if self.shear() == 0.0 {
            "right"
        } else if over < 0.0 {
            "acute"
        } else {
            "obtuse"
        }
    }

    /// The four corners of an end face in the body frame, anticlockwise seen from outside \[m\].
    pub fn end_face(&self, end: End) -> [DVec3; 4] {
        let plan = self.plan_corners();
        let h = self.thickness / 2.0;
        let (first, second) = match end {
            End::Plus => (1, 2),
            End::Minus => (3, 0),
        };
        [plan[first].extend(-h), plan[second].extend(-h), plan[second].extend(h), plan[first].extend(h)]
    }

    /// Length of an end face along the support line, `b0 / sin β` \[m\].
    pub fn end_length(&self) -> f64 {
        if self.skew == std::f64::consts::FRAC_PI_2 { self.width } else { self.width / self.skew.sin() }
    }

    /// Depth of the body behind an end face, square to it, `a0 sin β` \[m\].
    pub fn depth_behind_end(&self) -> f64 {
        if self.skew == std::f64::consts::FRAC_PI_2 { self.length } else { self.length * self.skew.sin() }
    }

    /// Inertia tensor about G per unit mass, body frame \[m²\]; its zz entry is `i²` of (4e).
    pub fn inertia_per_mass(&self) -> DMat3 {
        let (a2, b2, t2, c) = (self.length.powi(2), self.width.powi(2), self.thickness.powi(2), self.shear());
        let (xx, yy, zz, xy) = ((a2 + b2 * c * c) / 12.0, b2 / 12.0, t2 / 12.0, b2 * c / 12.0);
        DMat3::from_cols(DVec3::new(yy + zz, -xy, 0.0), DVec3::new(-xy, xx + zz, 0.0), DVec3::new(0.0, 0.0, xx + yy))
    }

    /// Left side of the rotation condition (6), `a0 sin 2β / (2 b0)`: a skewed girder can rotate when it is ≥ 1.
    pub fn rotation_number(&self) -> f64 {
        self.length * (2.0 * self.skew).sin() / (2.0 * self.width)
    }
}
