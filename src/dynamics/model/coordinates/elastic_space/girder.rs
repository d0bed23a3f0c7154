//! An elastic girder in space, compiled: modes, sections, bearings (`docs/physics.md#flexible-girders`).

use glam::{DMat3, DVec3};

use super::bearings::BearingPoint;
use super::section::{Section, Turns};
use crate::dynamics::elastic::{Fields, SpaceModes};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::coordinates::elastic::girder::SAME_STATION;
use crate::dynamics::model::coordinates::elastic::section::station_and_offset;
use crate::dynamics::model::coordinates::modal_amplitudes::ModalAmplitudes;
use crate::dynamics::model::coordinates::modal_springs::{ModalDamping, ModalSprings};
use crate::dynamics::model::coordinates::section_forces::LinkOf;
use crate::dynamics::model::wrench::Wrench;
use crate::scene::facing::Flank;

/// Places of the mean axes that come before those of the modes: displacement and quaternion.
pub(super) const POSITIONS: usize = 7;
/// Their velocities.
pub(super) const RATES: usize = 6;

/// An elastic girder in space: displacement and quaternion of its mean axes, modal coordinates; velocity and angular velocity of the
/// mean axes, rates of the modal coordinates. Sections: G, the −x end, the +x end, the faces along it of a girder that has met another
/// body, then those of its links.
#[derive(Clone, Debug)]
pub struct SpatialElasticGirder {
    /// Its modes.
    pub modes: SpaceModes,
    /// Its damping.
    pub damping: ModalDamping,
    /// Springs and dashpots of the modes.
    pub(super) springs: ModalSprings,
    /// Sections that move against the mean axes: of the ends, −x first, of faces along the girder, then of links.
    pub(super) deforming: Vec<Section>,
    /// The section through G, and the given push on it; `None` without a push.
    pub(super) pushed: Option<(Section, Wrench)>,
    /// Bearings.
    pub(super) bearings: Vec<BearingPoint>,
    /// Amplitudes of each mode, the largest of its sections: |(u, v, w)| and |φ|.
    pub(super) most: ModalAmplitudes,
    /// The body it is of, with rigid coordinates: shape, place, mass, what holds it.
    pub(super) rigid: Body,
}

impl SpatialElasticGirder {
    /// Of a rigid girder in space with these modes.
    pub(in crate::dynamics) fn new(rigid: &Body, modes: SpaceModes, damping: ModalDamping) -> Self {
        let half = 0.5 * modes.beam.plan.length;
        let section = |station: f64| Section::at(&modes, &rigid.axes, station);
        let push = Wrench { force: rigid.push, moment: rigid.moment };
        let pushed = (push.force != DVec3::ZERO || push.moment != DVec3::ZERO).then(|| (section(0.0), push));
        let deforming = vec![section(-half), section(half)];
        let mut most = ModalAmplitudes::of_modes(modes.count());
        for section in &deforming {
            most.widen(section.amplitudes());
        }
        Self {
            springs: ModalSprings::of(modes.frequencies(), damping),
            bearings: BearingPoint::all(&rigid.bearings, &modes, rigid.prism.shear(), &rigid.axes),
            pushed,
            most,
            rigid: rigid.clone(),
            modes,
            damping,
            deforming,
        }
    }

    /// Number of modal coordinates, `N_e`.
    pub fn count(&self) -> usize {
        self.springs.count()
    }

    /// Number of positions in a state.
    pub(super) fn places(&self) -> usize {
        POSITIONS + self.count()
    }

    /// Places and rates of a state.
    pub(super) fn halves<'a>(&self, state: &'a [f64]) -> (&'a [f64], &'a [f64]) {
        state.split_at(self.places())
    }

    /// Modal coordinates and their rates in a state.
    pub(super) fn modal<'a>(&self, state: &'a [f64]) -> [&'a [f64]; 2] {
        let (places, rates) = self.halves(state);
        [&places[POSITIONS..], &rates[RATES..]]
    }

    /// A section by its number; nothing for that of G, which moves with the mean axes.
    pub(super) fn deforming(&self, section: usize) -> Option<&Section> {
        self.deforming.get(section.checked_sub(1)?)
    }

    /// Distance of the ends from G \[m\].
    pub(super) fn lever(&self) -> f64 {
        0.5 * self.modes.beam.plan.length
    }

    /// Number of the section of a link's point at this arm from G as placed, world axes \[m\], which is added where there is none.
    pub(in crate::dynamics) fn section_of_link(&mut self, arm: DVec3, of: LinkOf) -> usize {
        let (axes, cot, half) = (&self.rigid.axes, self.rigid.prism.shear(), self.lever());
        let place = axes.mul_transpose_vec3(arm);
        let added = match of {
            LinkOf::Bearing => Section::point(&self.modes, axes, place, cot),
            LinkOf::Device => Section::at(&self.modes, axes, station_and_offset(place.truncate(), cot, half).0),
        };
        let same = |own: &Section| own.bearer.is_like(&added.bearer, SAME_STATION * half);
        if let Some(known) = self.deforming.iter().position(same) {
            return known + 1;
        }
        self.most.widen(added.amplitudes());
        self.deforming.push(added);
        self.deforming.len()
    }

    /// Gives the faces along the girder sections of their own.
    pub(in crate::dynamics) fn add_flanks(&mut self) {
        let (prism, axes) = (&self.rigid.prism, &self.rigid.axes);
        let all = [Flank::Right, Flank::Left, Flank::Bottom, Flank::Top];
        for flank in all.map(|flank| Section::flank(&self.modes, axes, flank.offset(prism))) {
            self.most.widen(flank.amplitudes());
            self.deforming.push(flank);
        }
    }

    /// Motion of the section at a station \[m\] against the mean axes in a state, girder axes.
    pub fn deformation(&self, state: &[f64], station: f64) -> Fields {
        let [q, _] = self.modal(state);
        let fields = self.modes.section(2.0 * station / self.modes.beam.plan.length);
        fields.into_iter().zip(q).map(|(field, q)| field * *q).sum()
    }

    /// Angular velocity in a state \[rad/s\], and distance of the centre of an end from the mean axes, the larger of both ends \[m\].
    pub fn spin_and_deflection(&self, state: &[f64]) -> [f64; 2] {
        let [q, rates] = self.modal(state);
        let away = |end: &Section| end.deformation(q, rates).of.moved.length();
        let spin = DVec3::from_slice(&self.halves(state).1[3..RATES]);
        [spin.length(), self.deforming[..2].iter().map(away).fold(0.0, f64::max)]
    }

    /// Displacement against the mean axes of a point at this place in girder axes \[m\], and its rate, in a state.
    pub fn displaced(&self, state: &[f64], place: DVec3) -> [DVec3; 2] {
        let (station, offset) = station_and_offset(place.truncate(), self.rigid.prism.shear(), self.lever());
        let shapes = self.modes.point(2.0 * station / self.modes.beam.plan.length, offset.extend(place.z));
        self.modal(state).map(|half| shapes.iter().zip(half).map(|(shape, x)| *shape * *x).sum())
    }

    /// Energy in the elastic modes in a state \[J\].
    pub fn ringing(&self, state: &[f64]) -> f64 {
        let [q, rates] = self.modal(state);
        self.strain(q) + rates.iter().map(|v| 0.5 * v * v).sum::<f64>()
    }

    /// Acceleration of a corner by a unit force there, at most: with the inertia of the end that the modes leave \[1/kg\].
    pub(in crate::dynamics) fn mobility(&self) -> f64 {
        let corners = self.rigid.prism.corners().map(|corner| self.rigid.axes * corner);
        // The trace of a symmetric positive matrix is not below its largest eigenvalue.
        let of = |section: &Section, arm: DVec3| {
            let along = |unit: DVec3| section.compliance(&DMat3::ZERO, arm, unit).dot(unit);
            DVec3::AXES.into_iter().map(along).sum::<f64>()
        };
        let ends = &self.deforming[..2];
        let most = corners.iter().flat_map(|&arm| ends.iter().map(move |end| (end, arm)));
        let nearest = most.filter(|(end, arm)| (*arm - end.lever).length() < (*arm + end.lever).length());
        self.rigid.rate_bounds.mobility + nearest.map(|(end, arm)| of(end, arm)).fold(0.0, f64::max)
    }

    /// Springs and dashpots of its modes.
    pub(in crate::dynamics) fn springs(&self) -> &ModalSprings {
        &self.springs
    }

    /// Strain energy of the girder by its modal coordinates \[J\].
    pub fn strain(&self, q: &[f64]) -> f64 {
        self.springs.strain(q)
    }

    /// Power lost in the girder by the rates of its modal coordinates \[W\].
    pub fn loss(&self, rates: &[f64]) -> f64 {
        self.springs.loss(rates)
    }

    /// The rotations of a section in a state of a body that adds `body` to the identity.
    pub(super) fn turns(section: &Section, body: DMat3, [q, rates]: [&[f64]; 2]) -> Turns {
        Turns::of(body, section.deformation(q, rates).of.turned)
    }
}
