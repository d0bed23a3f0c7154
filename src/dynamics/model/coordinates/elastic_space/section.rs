//! A rigid section of an elastic girder in space: where it is and how fast it moves, and what a force on it does to the modes.
//!
//! A point that was at `l` from G as placed is at `G + R (s + u) + R E (l − s)`, with R of the body and `E = exp [φ]×` of the section. A
//! force does the virtual work of that motion, so that energy balances to rounding; against `u + φ × r`, (F1), it differs by φ²/2 of the offset.

use glam::{DMat3, DVec3};

use super::bearings::PlacedPoint;
use super::turn::SectionTurn;
use crate::dynamics::elastic::{Fields, SpaceModes};
use crate::dynamics::model::coordinates::section_forces::Bearer;

/// A rigid section of the girder, or a face along it: where it is, and its motion in every mode.
#[derive(Clone, Debug)]
pub(in crate::dynamics) struct Section {
    /// Point of the girder at which forces on the section act.
    pub(super) bearer: Bearer,
    /// From G to its centre, world axes as placed \[m\].
    pub(super) lever: DVec3,
    /// Motion in every mode, in the world's axes as placed \[1/√kg, 1/(m√kg)\].
    pub(super) fields: Vec<Fields>,
}

/// Motion of a section against the mean axes, in the world's axes as placed, and its rate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Deformation {
    pub(super) of: Fields,
    pub(super) rate: Fields,
}

/// Rotation matrices of the body and of a section relative to it, each less the identity: R − 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turns {
    /// Of the body.
    body: DMat3,
    /// Of the section against it.
    own: SectionTurn,
}

impl Turns {
    /// Of a section turned by φ in a body that adds `body` to the identity.
    pub(super) fn of(body: DMat3, phi: DVec3) -> Self {
        Self { body, own: SectionTurn::of(phi) }
    }

    /// Product of both rotations, less the identity.
    pub(super) fn whole(&self) -> DMat3 {
        self.body + self.own.own + self.body * self.own.own
    }

    /// A vector of the body's axes as placed in the world.
    fn forth(&self, v: DVec3) -> DVec3 {
        v + self.body * v
    }

    /// A vector of the world in the body's axes as placed.
    fn back(&self, v: DVec3) -> DVec3 {
        v + self.body.transpose() * v
    }
}

impl Section {
    /// At a station of a girder whose axes as placed are the columns.
    pub(super) fn at(modes: &SpaceModes, axes: &DMat3, station: f64) -> Self {
        let xi = 2.0 * station / modes.beam.plan.length;
        let fields = modes.section(xi).into_iter().map(|fields| fields.in_axes(axes)).collect();
        Self { bearer: Bearer::Station(station), lever: axes.x_axis * station, fields }
    }

    /// The point of a bearing at this place from G, girder axes \[m\], of a girder with this cot β: displaced as the modes displace it,
    /// without a rotation of its own, (F2).
    pub(super) fn point(modes: &SpaceModes, axes: &DMat3, place: DVec3, cot: f64) -> Self {
        let PlacedPoint { station, offset, lever, shapes } = PlacedPoint::of(modes, axes, place, cot);
        let fields = shapes.into_iter().map(|moved| Fields { moved, turned: DVec3::ZERO }).collect();
        Self { bearer: Bearer::Point { station, offset }, lever, fields }
    }

    /// A face along a girder, at `offset` from its axis as placed, girder axes \[m\].
    pub(super) fn flank(modes: &SpaceModes, axes: &DMat3, offset: DVec3) -> Self {
        let half = 0.5 * modes.beam.plan.length;
        let [minus, plus] = [-1.0, 1.0].map(|xi| modes.section(xi).into_iter());
        let moved = minus.zip(plus).map(|(minus, plus)| Bearer::between([minus, plus], half, offset).in_axes(axes));
        Self { bearer: Bearer::Flank { half, offset }, lever: *axes * offset, fields: moved.collect() }
    }

    /// Amplitudes of each mode: |(u, v, w)| and |φ|.
    pub(super) fn amplitudes(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.fields.iter().map(|fields| [fields.moved.length(), fields.turned.length()])
    }

    /// By the modal coordinates and their rates.
    pub(super) fn deformation(&self, q: &[f64], rates: &[f64]) -> Deformation {
        let (mut of, mut rate) = (Fields::default(), Fields::default());
        for ((fields, q), v) in self.fields.iter().zip(q).zip(rates) {
            of += *fields * *q;
            rate += *fields * *v;
        }
        Deformation { of, rate }
    }

    /// Displacement of the origin of the section's frame against G: a point that was at `l` from G is at `R E l` from the origin.
    pub(super) fn offset(&self, turns: &Turns, deformation: &Deformation) -> DVec3 {
        turns.forth(deformation.of.moved - turns.own.own * self.lever)
    }

    /// Velocity of that origin, which is at `offset`, against G, where the body turns at `spin`; and the section's angular velocity.
    pub(super) fn velocity(&self, turns: &Turns, offset: DVec3, spin: DVec3, rate: Fields) -> [DVec3; 2] {
        let own = turns.own.map * rate.turned;
        let moved = rate.moved - own.cross(self.now(turns));
        [spin.cross(offset) + turns.forth(moved), spin + turns.forth(own)]
    }

    /// A force on the section with its moment about the frame's origin as it acts on the fields u and φ.
    pub(super) fn load(&self, turns: &Turns, force: DVec3, moment: DVec3) -> Fields {
        let on_section = self.load_on_section(turns, force, moment);
        Fields { moved: on_section.moved, turned: turns.own.map.transpose() * on_section.turned }
    }

    /// The force in the body's axes as placed, and its moment about the section's centre.
    pub(super) fn load_on_section(&self, turns: &Turns, force: DVec3, moment: DVec3) -> Fields {
        let moved = turns.back(force);
        Fields { moved, turned: turns.back(moment) - self.now(turns).cross(moved) }
    }

    /// `E s`.
    fn now(&self, turns: &Turns) -> DVec3 {
        self.lever + turns.own.own * self.lever
    }

    /// Adds what a load does to the modes.
    pub(super) fn push(&self, load: &Fields, modal: &mut [f64]) {
        for (fields, modal) in self.fields.iter().zip(modal) {
            *modal += fields.work(load);
        }
    }

    /// Acceleration of a point at `arm` from the frame's origin by a force there and by the modes alone, in a frame that adds `turned`
    /// to the identity: φ is small beside that.
    pub(super) fn compliance(&self, turned: &DMat3, arm: DVec3, force: DVec3) -> DVec3 {
        let turn = *turned + DMat3::IDENTITY;
        let r = arm - turn * self.lever;
        let moved = |fields: &Fields| turn * fields.moved + (turn * fields.turned).cross(r);
        self.fields.iter().map(moved).map(|d| d * d.dot(force)).sum()
    }
}
