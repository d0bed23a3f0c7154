//! A closed contact between bodies of one island, as a connection under the penalty law
//! (`docs/physics.md#normal-law`, `docs/physics.md#friction-laws`).

use glam::{DVec2, DVec3};

use crate::contact::{ContactGeometry, Frame, Local, Mode, NormalLaw, SlipDirection, locate};
use crate::dynamics::Model;
use crate::dynamics::connection::Connection;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::penalty3d::contact_state::ClosedContact;

/// A closed contact between bodies of one island.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct ActiveContact {
    /// Number of its site in the model.
    pub site: usize,
    /// Indices in the island of the node's and the face's body; `None` for an abutment.
    pub ends: [Option<usize>; 2],
    /// Sections of node and face among those of the island's bodies; 0 for an abutment.
    pub sections: [usize; 2],
    /// State with law and mode.
    pub closed: ClosedContact,
    /// Contact geometry at the reference poses of both bodies, the origin of the node's displacement along the face
    /// and of the anchor.
    pub geometry: ContactGeometry,
    /// Index of the slip angle in the island's vector; `None` where the angle is no state.
    pub angle: Option<usize>,
    /// Penetration at which the bounds of stiffness and damping are evaluated \[m\]; a law that stiffens can exceed
    /// it.
    pub depth: f64,
    /// Overlap of its two bodies beyond the deepest penetration between them that no contact can carry, and that is tolerated \[m\].
    pub tolerated: f64,
}

impl ActiveContact {
    /// At this site of the model, between bodies of these indices, node then face, with its contact geometry at their reference poses.
    pub(in crate::dynamics) fn new(
        site: usize,
        ends: [Option<usize>; 2],
        closed: ClosedContact,
        geometry: ContactGeometry,
    ) -> Self {
        Self { site, ends, sections: [0; 2], closed, geometry, angle: None, depth: 0.0, tolerated: 0.0 }
    }

    /// Position and velocity of the node relative to the face, with poses `frames` of the island's bodies relative to
    /// their reference poses.
    pub(in crate::dynamics) fn look(&self, model: &Model, frames: &[Frame]) -> Local {
        let [node, face] = self.sides(model, frames);
        locate(&self.geometry, node, face)
    }

    /// Outward unit normal of the face, with poses `frames` of the island's bodies relative to their reference poses.
    pub(in crate::dynamics) fn normal(&self, model: &Model, frames: &[Frame]) -> DVec3 {
        let [node, face] = self.sides(model, frames);
        self.geometry.normal(node, face)
    }

    /// Poses of the sections of node and face, relative to the reference poses.
    fn sides<'a>(&self, model: &'a Model, frames: &'a [Frame]) -> [&'a Frame; 2] {
        let stand = &model.sites[self.site].stand;
        [0, 1].map(|end| self.ends[end].map_or(stand, |_| &frames[self.sections[end]]))
    }

    /// Finds its sections among those of the island's bodies.
    pub(in crate::dynamics) fn find_sections(&mut self, model: &Model, layout: &StateLayout) {
        let own = model.sections(self.site);
        self.sections = [0, 1].map(|end| self.ends[end].map_or(0, |i| layout.sections(i).start + own[end]));
    }

    /// Largest penetration to be expected \[m\]: the present one, or that to which the normal speed leads with the
    /// mass of the lighter body.
    pub(in crate::dynamics) fn expected_depth(&self, model: &Model, frames: &[Frame]) -> f64 {
        let here = self.look(model, frames);
        let pair = &model.pairs[model.sites[self.site].pair];
        let mass = pair.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
        here.gap.abs().max(self.closed.law.normal.depth(mass, here.gap_rate.abs()))
    }

    /// Whether the contact is in slip with friction in the direction of `V_t` at every instant.
    pub(in crate::dynamics) fn slides_along_velocity(&self) -> bool {
        matches!(self.closed.mode, Mode::Slip { .. }) && self.closed.law.slip_direction() == SlipDirection::OfVelocity
    }

    /// The state with the slip direction of the island's vector.
    #[inline]
    pub(in crate::dynamics) fn state_in(&self, y: &[f64]) -> ClosedContact {
        let mut closed = self.closed;
        if let Some(at) = self.angle {
            closed.mode = Mode::Slip { direction: direction(y[at]) };
        }
        closed
    }
}

/// Force on the node in the face's axes \[N\]; bounds hold up to the expected penetration.
impl Connection for ActiveContact {
    type State = Mode;
    type Motion = Local;

    fn force(&self, mode: &Mode, here: &Local) -> DVec3 {
        let forces = self.closed.forces_in(mode, here);
        forces.tangential_total().extend(forces.normal_total())
    }

    fn stored_energy(&self, mode: &Mode, here: &Local) -> f64 {
        self.closed.law.strain(here, &self.closed.forces_in(mode, here))
    }

    fn dissipated_power(&self, mode: &Mode, here: &Local) -> f64 {
        self.closed.law.dissipated_powers(&self.closed.forces_in(mode, here)).iter().sum()
    }

    fn stiffness_bound(&self, _: &Mode) -> f64 {
        self.closed.law.stiffness_bound(self.depth)
    }

    fn damping_bound(&self, _: &Mode) -> f64 {
        self.closed.law.damping_bound(self.depth)
    }
}

/// Unit vector at an angle \[rad\] from the x axis.
pub(in crate::dynamics) fn direction(angle: f64) -> DVec2 {
    let (sin, cos) = angle.sin_cos();
    DVec2::new(cos, sin)
}
