//! A section of an elastic girder: where it is and how fast it moves, and what a force on it does to the modes.
//!
//! The frame of a section that touches or holds something at its true place is rigid: it turns by θ + φ. That of a section for a planar
//! bearing is linear, (F6): `(x, y) + d` at the point, with `d = (u, v) + φ ẑ × (l − s)` in axes as placed; the frame's origin, `l` from
//! the point, is displaced by `(u, v) − φ ẑ × s`. Forces do virtual work by the motion that the frame has, so that energy balances.

use glam::{DMat2, DMat3, DVec2, DVec3};

use super::turn::{composed, planar_turn};
use crate::dynamics::elastic::{Fields, Modes};
use crate::dynamics::model::coordinates::section_forces::Bearer;

/// Station of the oblique section that carries a point \[m\], and the point's offset from its centre, girder axes \[m\]; points beyond the
/// ends, at ±`half`, are carried by the end sections. `shear` is cot β.
pub(in crate::dynamics) fn station_and_offset(place: DVec2, shear: f64, half: f64) -> (f64, DVec2) {
    let [oblique, across] = [place.x - place.y * shear, place.y * shear];
    let station = oblique.clamp(-half, half);
    (station, DVec2::new(across + (oblique - station), place.y))
}

/// Motion of a section's frame by φ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dynamics) enum SectionFrame {
    /// It turns by θ + φ.
    Rigid,
    /// Linear in φ, in axes as placed.
    Linear,
}

/// A rigid section of the girder, or a face along it: where it is, and its motion in every mode.
#[derive(Clone, Debug)]
pub(in crate::dynamics) struct Section {
    /// Its frame.
    pub frame: SectionFrame,
    /// Point of the girder at which forces on the section act.
    pub bearer: Bearer,
    /// From G to its centre, world axes as placed \[m\].
    pub lever: DVec2,
    /// u, v in the world's axes as placed, φ, of every mode \[1/√kg, 1/(m√kg)\].
    pub fields: Vec<DVec3>,
}

/// Motion of a section against the body's frame: u, v in the world's axes as placed, φ; and their rates.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Deformation {
    pub of: DVec3,
    pub rate: DVec3,
}

/// Force on a section and moment about its centre, in the axes that turn with the body, as placed.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct SectionLoad {
    pub force: DVec2,
    pub moment: f64,
}

/// Rotation matrices of the body and of a section relative to it, each less the identity: R − 1.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Turns {
    /// By θ.
    body: DMat2,
    /// By φ.
    own: DMat2,
    /// By θ + φ.
    pub whole: DMat2,
}

impl Turns {
    /// Of a section turned by φ in a body that is turned by θ.
    pub(in crate::dynamics) fn of(theta: f64, phi: f64) -> Self {
        let [body, own] = [theta, phi].map(planar_turn);
        Self { body, own, whole: composed(body, own) }
    }
}

impl Section {
    /// At a station of a girder whose axes as placed are the columns.
    pub(in crate::dynamics) fn at(modes: &Modes, axes: &DMat3, station: f64, frame: SectionFrame) -> Self {
        let [along, across] = [axes.x_axis.truncate(), axes.y_axis.truncate()];
        let turned = |field: DVec3| (along * field.x + across * field.y).extend(field.z);
        let xi = 2.0 * station / modes.beam.length;
        let fields = modes.section(xi).into_iter().map(turned).collect();
        Self { frame, bearer: Bearer::Station(station), lever: along * station, fields }
    }

    /// A face along a girder, at `offset` from its axis as placed, girder axes \[m\].
    pub(in crate::dynamics) fn flank(modes: &Modes, axes: &DMat3, offset: DVec3) -> Self {
        let half = 0.5 * modes.beam.length;
        let [minus, plus] = [-1.0, 1.0].map(|xi| modes.section(xi).into_iter().map(Fields::plane));
        let moved = minus.zip(plus).map(|(minus, plus)| Bearer::between([minus, plus], half, offset).in_axes(axes));
        let fields = moved.map(|fields| fields.moved.truncate().extend(fields.turned.z)).collect();
        let lever = (*axes * offset).truncate();
        Self { frame: SectionFrame::Rigid, bearer: Bearer::Flank { half, offset }, lever, fields }
    }

    /// Amplitudes of each mode: |(u, v)| and |φ|.
    pub(in crate::dynamics) fn amplitudes(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.fields.iter().map(|field| [field.truncate().length(), field.z.abs()])
    }

    /// By the modal coordinates and their rates.
    pub(in crate::dynamics) fn deformation(&self, q: &[f64], rates: &[f64]) -> Deformation {
        let (mut of, mut rate) = (DVec3::ZERO, DVec3::ZERO);
        for ((field, q), v) in self.fields.iter().zip(q).zip(rates) {
            of += *field * *q;
            rate += *field * *v;
        }
        Deformation { of, rate }
    }

    /// Displacement of the origin of the section's frame against G: a point that was at `l` from G is at `R(θ + φ) l` from the origin.
    pub(in crate::dynamics) fn offset(&self, turns: &Turns, deformation: &Deformation) -> DVec2 {
        if self.frame == SectionFrame::Linear {
            return deformation.of.truncate() - self.lever.perp() * deformation.of.z;
        }
        let own = deformation.of.truncate() - turns.own * self.lever;
        own + turns.body * own
    }

    /// Velocity of that origin, which is at `offset`, against G, where the body turns at `spin`.
    pub(in crate::dynamics) fn velocity(&self, turns: &Turns, offset: DVec2, spin: f64, rate: DVec3) -> DVec2 {
        let moved = rate.truncate();
        if self.frame == SectionFrame::Linear {
            return moved - self.lever.perp() * rate.z;
        }
        let turned = self.lever + turns.whole * self.lever;
        offset.perp() * spin + moved + turns.body * moved - turned.perp() * rate.z
    }

    /// A force on the section with its moment about the frame's origin as it acts on the modes.
    pub(in crate::dynamics) fn load(&self, turns: &Turns, force: DVec2, moment: f64) -> SectionLoad {
        if self.frame == SectionFrame::Linear {
            return self.load_unrotated(force, moment);
        }
        let lever = self.lever + turns.whole * self.lever;
        let back = force + turns.body.transpose() * force;
        SectionLoad { force: back, moment: moment - lever.perp_dot(force) }
    }

    /// [`load`](Self::load) of a linear frame, whose force has the same moment about G as about the frame's origin.
    pub(in crate::dynamics) fn load_unrotated(&self, force: DVec2, moment: f64) -> SectionLoad {
        SectionLoad { force, moment: moment - self.lever.perp_dot(force) }
    }

    /// Adds what a load does to the modes.
    pub(in crate::dynamics) fn push(&self, load: &SectionLoad, modal: &mut [f64]) {
        for (field, modal) in self.fields.iter().zip(modal) {
            *modal += field.x * load.force.x + field.y * load.force.y + field.z * load.moment;
        }
    }

    /// Acceleration of a point at `arm` from the frame's origin by a force there and by the modes alone, in a frame turned by `angle`.
    pub(in crate::dynamics) fn compliance(&self, angle: f64, arm: DVec2, force: DVec2) -> DVec2 {
        let turn = match self.frame {
            SectionFrame::Rigid => DMat2::from_angle(angle),
            SectionFrame::Linear => DMat2::IDENTITY,
        };
        let r = arm - turn * self.lever;
        let moved = |field: &DVec3| turn * field.truncate() + r.perp() * field.z;
        self.fields.iter().map(moved).map(|d| d * d.dot(force)).sum()
    }
}
