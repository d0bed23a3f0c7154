//! An elastic girder in plan or in space: what both answer.

use std::sync::Arc;

use glam::DVec3;

use crate::dynamics::elastic::Fields;
use crate::dynamics::model::body::BodyCoordinates;
use crate::dynamics::model::coordinates::elastic::ElasticGirder;
use crate::dynamics::model::coordinates::elastic_space::SpatialElasticGirder;
use crate::dynamics::model::coordinates::modal_springs::ModalDamping;
use crate::dynamics::model::coordinates::section_forces::{Equilibrium, LinkOf, Strained};
use crate::dynamics::model::rate_bounds::ModalRates;
use crate::dynamics::model::wrench::Wrench;

/// The degrees of freedom of an elastic girder.
#[derive(Clone, Debug)]
pub enum ElasticBody {
    /// In plan.
    Plan(Arc<ElasticGirder>),
    /// In space.
    Space(Arc<SpatialElasticGirder>),
}

/// The value of an expression for whichever it is.
macro_rules! of_both {
    ($body:expr, $girder:ident => $value:expr) => {
        match $body {
            Self::Plan($girder) => $value,
            Self::Space($girder) => $value,
        }
    };
}

impl ElasticBody {
    /// As the coordinates of a body.
    pub(in crate::dynamics) fn coordinates(&self) -> BodyCoordinates {
        match self {
            Self::Plan(girder) => BodyCoordinates::Custom(Arc::<ElasticGirder>::clone(girder)),
            Self::Space(girder) => BodyCoordinates::Custom(Arc::<SpatialElasticGirder>::clone(girder)),
        }
    }

    /// Degree n of its polynomials.
    pub fn degree(&self) -> usize {
        of_both!(self, girder => girder.modes.degree)
    }

    /// Number of its modes.
    pub fn count(&self) -> usize {
        of_both!(self, girder => girder.count())
    }

    /// Circular frequencies of the modes, rising \[rad/s\].
    pub fn frequencies(&self) -> Vec<f64> {
        of_both!(self, girder => girder.modes.frequencies().collect())
    }

    /// Its damping.
    pub fn damping(&self) -> ModalDamping {
        of_both!(self, girder => girder.damping)
    }

    /// Acceleration of a corner by a unit force there, at most \[1/kg\].
    pub(in crate::dynamics) fn mobility(&self) -> f64 {
        of_both!(self, girder => girder.mobility())
    }

    /// Largest rates of its modes on their own springs and dashpots.
    pub(in crate::dynamics) fn modal_rates(&self) -> ModalRates {
        of_both!(self, girder => girder.springs().rates())
    }

    /// Number of the section of a link's point at this arm from G as placed, world axes \[m\], which is added where there is none.
    pub(in crate::dynamics) fn section_of_link(&mut self, arm: DVec3, of: LinkOf) -> usize {
        match self {
            Self::Plan(girder) => Arc::make_mut(girder).section_of_link(arm, of),
            Self::Space(girder) => Arc::make_mut(girder).section_of_link(arm, of),
        }
    }

    /// Gives the faces along the girder sections of their own.
    pub(in crate::dynamics) fn add_flanks(&mut self) {
        match self {
            Self::Plan(girder) => Arc::make_mut(girder).add_flanks(),
            Self::Space(girder) => Arc::make_mut(girder).add_flanks(),
        }
    }

    /// Loads in a state, less those of the placed state, under wrenches on its sections about the origins of their frames, and the ground's
    /// acceleration.
    pub fn equilibrium(&self, state: &[f64], wrenches: &[Wrench], ground: DVec3) -> Equilibrium {
        match self {
            Self::Plan(girder) => girder.equilibrium(state, wrenches, ground),
            Self::Space(girder) => girder.equilibrium(state, wrenches),
        }
    }

    /// The fields in a state, for the section forces of their strain.
    pub fn strained(&self, state: &[f64]) -> Strained {
        of_both!(self, girder => girder.strained(state))
    }

    /// Motion of the section at a station \[m\] against the mean axes in a state, girder axes.
    pub fn deformation(&self, state: &[f64], station: f64) -> Fields {
        match self {
            Self::Plan(girder) => Fields::plane(girder.deformation(state, station)),
            Self::Space(girder) => girder.deformation(state, station),
        }
    }

    /// Displacement against the mean axes of a point at this place in girder axes \[m\], and its rate, in a state; in axes that turn with
    /// the girder in space, as placed in plan.
    pub fn displaced(&self, state: &[f64], place: DVec3) -> [DVec3; 2] {
        match self {
            Self::Plan(girder) => girder.displaced(state, place.truncate()).map(|d| d.extend(0.0)),
            Self::Space(girder) => girder.displaced(state, place),
        }
    }

    /// Angular velocity in a state \[rad/s\], and distance of the centre of an end from the mean axes, the larger of both ends \[m\].
    pub fn spin_and_deflection(&self, state: &[f64]) -> [f64; 2] {
        of_both!(self, girder => girder.spin_and_deflection(state))
    }

    /// Energy in the elastic modes in a state \[J\].
    pub fn ringing(&self, state: &[f64]) -> f64 {
        of_both!(self, girder => girder.ringing(state))
    }
}
