//! Motion of a section of a beam in space.

use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul};

use glam::{DMat3, DVec3};

/// Displacement and turn of a section: u, v, w and ψ, `φ_y`, `φ_z`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fields {
    /// (u, v, w), of its centre.
    pub moved: DVec3,
    /// (ψ, `φ_y`, `φ_z`), the small rotation vector.
    pub turned: DVec3,
}

impl Fields {
    /// Of a section in plan by u, v, φ.
    pub fn plane(of: DVec3) -> Self {
        Self { moved: of.truncate().extend(0.0), turned: DVec3::Z * of.z }
    }

    /// `(u, v, w) + φ × r`: displacement of a point at the offset `r` from the centre, linear in the fields.
    pub fn displacement(self, r: DVec3) -> DVec3 {
        self.moved + self.turned.cross(r)
    }

    /// The motion in the axes in which the columns are its own.
    #[must_use]
    pub fn in_axes(self, columns: &DMat3) -> Self {
        Self { moved: *columns * self.moved, turned: *columns * self.turned }
    }

    /// Work of a force and a moment about the centre.
    pub fn work(self, load: &Self) -> f64 {
        self.moved.dot(load.moved) + self.turned.dot(load.turned)
    }
}

impl Add for Fields {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { moved: self.moved + other.moved, turned: self.turned + other.turned }
    }
}

impl AddAssign for Fields {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul<f64> for Fields {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self { moved: self.moved * factor, turned: self.turned * factor }
    }
}

impl Sum for Fields {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), Add::add)
    }
}
