//! Bearings of an elastic girder in space: at their true points `G + R (l + d)`, (F2), with d linear in the modes.
//!
//! The shape under the dead load is the zero of q: a constant load on the modes, `−φ f₀` of the forces at rest, cancels these in the placed
//! pose.

use glam::{DMat3, DVec3};

use crate::contact::Frame;
use crate::dynamics::connection::{Connection, Separation};
use crate::dynamics::elastic::SpaceModes;
use crate::dynamics::model::bearing::Bearing;
use crate::dynamics::model::coordinates::elastic::section::station_and_offset;

/// A point of the girder that the modes displace linearly, (F2).
#[derive(Clone, Debug)]
pub(super) struct PlacedPoint {
    /// Station along the girder's axis \[m\].
    pub(super) station: f64,
    /// Offset from the section's centre, girder axes \[m\].
    pub(super) offset: DVec3,
    /// From G as placed, world axes \[m\].
    pub(super) lever: DVec3,
    /// Displacement in every mode, world axes as placed.
    pub(super) shapes: Vec<DVec3>,
}

impl PlacedPoint {
    /// At this place from G, girder axes \[m\], of a girder with this cot β whose axes as placed are the columns.
    pub(super) fn of(modes: &SpaceModes, axes: &DMat3, place: DVec3, cot: f64) -> Self {
        let length = modes.beam.plan.length;
        let (station, in_plan) = station_and_offset(place.truncate(), cot, 0.5 * length);
        let offset = in_plan.extend(place.z);
        let shapes = modes.point(2.0 * station / length, offset).into_iter().map(|d| *axes * d).collect();
        Self { station, offset, lever: *axes * place, shapes }
    }
}

/// A bearing with its point's motion in the modes.
#[derive(Clone, Debug)]
pub(super) struct BearingPoint {
    pub(super) bearing: Bearing,
    /// Station along the girder's axis \[m\].
    pub(super) station: f64,
    /// Offset from the section's centre, girder axes \[m\].
    pub(super) offset: DVec3,
    /// From G as placed, world axes \[m\].
    lever: DVec3,
    /// Displacement in every mode, world axes as placed.
    shapes: Vec<DVec3>,
}

/// A bearing's point at one instant.
#[derive(Clone, Copy, Debug)]
pub(super) struct BearingNow {
    /// Its motion against the ground, in the girder's axes as placed.
    pub(super) motion: Separation,
    /// From G, world axes \[m\].
    pub(super) arm: DVec3,
    /// Part of that by the modes \[m\].
    pub(super) bent: DVec3,
    /// Force beyond that at rest, world axes \[N\].
    pub(super) force: DVec3,
}

impl BearingPoint {
    /// Of each bearing of a girder with this cot β whose axes as placed are the columns.
    pub(super) fn all(bearings: &[Bearing], modes: &SpaceModes, cot: f64, axes: &DMat3) -> Vec<Self> {
        let of = |bearing: &Bearing| {
            let PlacedPoint { station, offset, lever, shapes } = PlacedPoint::of(modes, axes, bearing.place, cot);
            Self { bearing: *bearing, station, offset, lever, shapes }
        };
        bearings.iter().map(of).collect()
    }

    /// Of a girder in this pose, by the modal coordinates and their rates.
    pub(super) fn now(&self, axes: &DMat3, here: &Frame, q: &[f64], rates: &[f64]) -> BearingNow {
        let (mut moved, mut moving) = (DVec3::ZERO, DVec3::ZERO);
        for ((shape, q), v) in self.shapes.iter().zip(q).zip(rates) {
            moved += *shape * *q;
            moving += *shape * *v;
        }
        let [bent, bending] = [moved, moving].map(|v| v + here.turned * v);
        let swung = here.turned * self.lever;
        let arm = self.lever + swung + bent;
        let motion = Separation {
            moved: axes.mul_transpose_vec3(here.shift + swung + bent),
            rate: axes.mul_transpose_vec3(here.velocity_at(arm) + bending),
            ..Separation::default()
        };
        BearingNow { motion, arm, bent, force: *axes * self.bearing.force(&(), &motion) }
    }

    /// Force on the modes, in the body's axes as placed: that of the bearing less its rest force in the placed pose.
    pub(super) fn back(&self, turned: &DMat3, force: DVec3) -> DVec3 {
        force + turned.transpose() * (force + self.bearing.preload)
    }

    /// Adds what that does to the modes.
    pub(super) fn push(&self, back: DVec3, modal: &mut [f64]) {
        for (shape, modal) in self.shapes.iter().zip(modal) {
            *modal += shape.dot(back);
        }
    }

    /// Work of the force at rest by what the modes move its point, less that of the constant load that cancels it.
    pub(super) fn preload_work(&self, turned: &DMat3, bent: DVec3) -> f64 {
        // bent = (1 + D) d: f·bent − f·d = f·D d, with d = (1 + D)ᵀ bent.
        self.bearing.preload.dot(*turned * (bent + turned.transpose() * bent))
    }
}
