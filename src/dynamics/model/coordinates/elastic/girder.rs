//! An elastic girder in plan, compiled: modes, sections, bearings, constant loads (`docs/physics.md#flexible-girders`).

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::bearings::{BearingAxis, BearingRows, axes_of};
use super::section::{Section, SectionFrame, station_and_offset};
use crate::dynamics::elastic::Modes;
use crate::dynamics::model::axial_motion::{AxialModes, AxialParts};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::coordinates::modal_amplitudes::ModalAmplitudes;
use crate::dynamics::model::coordinates::modal_springs::{ModalDamping, ModalSprings};
use crate::dynamics::model::coordinates::section_forces::{Bearer, LinkOf};
use crate::dynamics::model::linear_block::part::RIGID;
use crate::scene::facing::Flank;

/// Part of the distance of an end from G that the end's frame is taken to be displaced by at most, where bounds need it: far beyond what
/// a linear beam stands for.
pub(in crate::dynamics) const DEFORMED: f64 = 0.1;

/// Stations that differ by less than this part of half the length are one \[–\]: rounding of places, far below any distance that changes a
/// mode.
pub(in crate::dynamics) const SAME_STATION: f64 = 1e-12;

/// An elastic girder: x, y, θ of its mean axes, modal coordinates, and their rates. Sections: G, the −x end, the +x end, the faces
/// along it of a girder that has met another body, then those of its links.
#[derive(Clone, Debug)]
pub struct ElasticGirder {
    /// Its modes.
    pub modes: Modes,
    /// Its damping.
    pub damping: ModalDamping,
    /// Springs and dashpots of the modes.
    pub(super) springs: ModalSprings,
    /// Sections that move against the mean axes: of the ends, −x first, of faces along the girder, then of links.
    pub(super) deforming: Vec<Section>,
    /// Bearings, axis by axis.
    pub(in crate::dynamics) bearings: Vec<BearingAxis>,
    /// Spring and dashpot rows of the bearings' forces on the coordinates.
    pub(super) rows: BearingRows,
    /// Constant load of the given push on the modes.
    pub(super) pushed: Vec<f64>,
    /// Amplitudes of each mode, the largest of its sections: |(u, v)| and |φ|.
    pub(super) most: ModalAmplitudes,
    /// Modes along the world's x and y, where it can move along that axis alone.
    pub(super) axial: [Option<Arc<AxialModes>>; 2],
    /// The body it is of, with rigid coordinates: shape, place, mass, what holds it.
    pub(super) rigid: Body,
}

impl ElasticGirder {
    /// Of a rigid girder in plan with these modes.
    pub(in crate::dynamics) fn new(rigid: &Body, modes: Modes, damping: ModalDamping) -> Self {
        let axes = &rigid.axes;
        let half = 0.5 * modes.beam.length;
        let section = |station: f64| Section::at(&modes, axes, station, SectionFrame::Rigid);
        let (ends, middle) = (vec![section(-half), section(half)], section(0.0));
        let push = rigid.push.truncate();
        let pushed: Vec<f64> = middle.fields.iter().map(|f| f.truncate().dot(push) + f.z * rigid.moment.z).collect();
        let mut most = ModalAmplitudes::of_modes(modes.count());
        for section in &ends {
            most.widen(section.amplitudes());
        }
        let bearings = axes_of(&rigid.bearings, &modes, rigid.prism.shear(), axes);
        let springs = ModalSprings::of(modes.frequencies(), damping);
        let axial = [0, 1].map(|axis| axial(axis, &ends, (&springs, &pushed), &bearings).map(Arc::new));
        Self {
            springs,
            axial,
            rows: BearingRows::of(&bearings, RIGID + modes.count()),
            bearings,
            most,
            rigid: rigid.clone(),
            modes,
            damping,
            deforming: ends,
            pushed,
        }
    }

    /// Number of modal coordinates, `N_e`.
    pub fn count(&self) -> usize {
        self.springs.count()
    }

    /// Number of positions in a state.
    pub(in crate::dynamics) fn places(&self) -> usize {
        RIGID + self.count()
    }

    /// Masses of the coordinates: of x, y and θ the girder's, of the modes 1.
    pub(super) fn masses(&self) -> impl Iterator<Item = f64> + '_ {
        let Body { mass, gyration2, .. } = &self.rigid;
        [*mass, *mass, mass * gyration2].into_iter().chain(std::iter::repeat_n(1.0, self.count()))
    }

    /// A section by its number; nothing for that of G, which moves with the mean axes.
    pub(super) fn deforming(&self, section: usize) -> Option<&Section> {
        self.deforming.get(section.checked_sub(1)?)
    }

    /// Distance of the ends from G \[m\].
    pub(super) fn lever(&self) -> f64 {
        0.5 * self.modes.beam.length
    }

    /// Number of the section of a link's point at this arm from G as placed, world axes \[m\], which is added where there is none.
    pub(in crate::dynamics) fn section_of_link(&mut self, arm: DVec3, of: LinkOf) -> usize {
        let place = self.rigid.axes.mul_transpose_vec3(arm);
        let half = self.lever();
        let (station, _) = station_and_offset(place.truncate(), self.rigid.prism.shear(), half);
        let frame = if of == LinkOf::Bearing { SectionFrame::Linear } else { SectionFrame::Rigid };
        let there = Bearer::Station(station);
        let same = |own: &Section| own.frame == frame && own.bearer.is_like(&there, SAME_STATION * half);
        if let Some(known) = self.deforming.iter().position(same) {
            return known + 1;
        }
        let added = Section::at(&self.modes, &self.rigid.axes, station, frame);
        self.most.widen(added.amplitudes());
        self.deforming.push(added);
        self.deforming.len()
    }

    /// Gives the faces along the girder sections of their own.
    pub(in crate::dynamics) fn add_flanks(&mut self) {
        let (prism, axes) = (&self.rigid.prism, &self.rigid.axes);
        let flanks = [Flank::Right, Flank::Left].map(|flank| Section::flank(&self.modes, axes, flank.offset(prism)));
        for flank in flanks {
            self.most.widen(flank.amplitudes());
            self.deforming.push(flank);
        }
    }

    /// u, v and φ of the section at a station \[m\] in a state, girder axes \[m, rad\].
    pub fn deformation(&self, state: &[f64], station: f64) -> DVec3 {
        let q = &state[RIGID..self.places()];
        let fields = self.modes.section(2.0 * station / self.modes.beam.length);
        fields.into_iter().zip(q).map(|(field, q)| field * *q).sum()
    }

    /// Angular velocity in a state \[rad/s\], and distance of the centre of an end from the mean axes, the larger of both ends \[m\].
    pub fn spin_and_deflection(&self, state: &[f64]) -> [f64; 2] {
        let (place, rate) = self.halves(state);
        let away = |end: &Section| end.deformation(&place[RIGID..], &rate[RIGID..]).of.truncate().length();
        [rate[2].abs(), self.deforming[..2].iter().map(away).fold(0.0, f64::max)]
    }

    /// Displacement against the mean axes of a point at this place in girder axes \[m\], and its rate, in a state.
    pub fn displaced(&self, state: &[f64], place: DVec2) -> [DVec2; 2] {
        let (station, offset) = station_and_offset(place, self.rigid.prism.shear(), self.lever());
        let shapes = self.modes.point(2.0 * station / self.modes.beam.length, offset);
        let (q, rates) = self.halves(state);
        [q, rates].map(|half| shapes.iter().zip(&half[RIGID..]).map(|(shape, x)| *shape * *x).sum())
    }

    /// Energy in the elastic modes in a state \[J\].
    pub fn ringing(&self, state: &[f64]) -> f64 {
        let (place, rate) = self.halves(state);
        self.strain(&place[RIGID..]) + rate[RIGID..].iter().map(|v| 0.5 * v * v).sum::<f64>()
    }

    /// Acceleration of a corner by a unit force there, at most: with the inertia of the end that the modes leave \[1/kg\].
    pub(in crate::dynamics) fn mobility(&self) -> f64 {
        let corners = self.rigid.prism.plan_corners().map(|corner| (self.rigid.axes * corner.extend(0.0)).truncate());
        let of = |section: &Section, arm: DVec2| {
            let [x, y] = [DVec2::X, DVec2::Y].map(|unit| section.compliance(0.0, arm, unit));
            x.x + y.y
        };
        // The trace of a symmetric positive matrix is not below its largest eigenvalue.
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
}

/// Modes along a world axis; `None` where a girder leaves it once its ends or bearings are pushed along it.
fn axial(
    axis: usize,
    ends: &[Section],
    (springs, pushed): (&ModalSprings, &[f64]),
    bearings: &[BearingAxis],
) -> Option<AxialModes> {
    let across = 1 - axis;
    let of = |end: &Section| end.fields.iter().map(|field| [field[axis], field[across], field.z]).collect();
    let springs: Vec<[f64; 3]> = springs.iter().zip(pushed).map(|([k, c], load)| [*k, *c, *load]).collect();
    AxialModes::of(&AxialParts {
        along: axis,
        first: RIGID,
        places: RIGID + springs.len(),
        ends: [of(&ends[0]), of(&ends[1])],
        springs,
        bearings: bearings.iter().map(|b| (b.row.as_slice(), [b.stiffness, b.damping])).collect(),
    })
}
