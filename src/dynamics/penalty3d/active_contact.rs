//! A closed contact between bodies of one island: the connection that the penalty law is.

use glam::{DVec2, DVec3};

use crate::contact::{Frame, FrictionLaw, Home, Local, Mode, NormalLaw, locate};
use crate::dynamics::Model;
use crate::dynamics::connection::Connection;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::penalty3d::contact_state::ClosedContact;

/// A closed contact between bodies of one island.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct ActiveContact {
    /// Its number in the model.
    pub site: usize,
    /// Which of the island's bodies owns the node; nothing for an abutment.
    pub node: Option<usize>,
    /// Which owns the face.
    pub face: Option<usize>,
    /// Sections of node and face among those of the island's bodies; 0 for an abutment.
    pub sections: [usize; 2],
    /// Its state.
    pub closed: ClosedContact,
    /// Node and face where the bases of their bodies are: its way, and its anchor's, count from there.
    pub home: Home,
    /// Where its slip angle stands in the vector, if it is a state.
    pub angle: Option<usize>,
    /// Penetration that it is expected not to exceed by much \[m\].
    pub depth: f64,
}

impl ActiveContact {
    /// The node against the face, with the island's bodies in `frames`, counted from their bases.
    pub(in crate::dynamics) fn look(&self, model: &Model, frames: &[Frame]) -> Local {
        let site = &model.contacts[self.site];
        let frame = |index: Option<usize>, which: usize| index.map_or(&site.stand, |_| &frames[self.sections[which]]);
        locate(&self.home, frame(self.node, 0), frame(self.face, 1))
    }

    /// Finds its sections among those of the island's bodies.
    pub(in crate::dynamics) fn find_sections(&mut self, model: &Model, layout: &StateLayout) {
        let own = model.sections(self.site);
        self.sections = [(self.node, own[0]), (self.face, own[1])]
            .map(|(body, own)| body.map_or(0, |i| layout.sections(i).start + own));
    }

    /// Penetration that its present one and its normal speed lead to, with the lighter of its bodies behind it \[m\].
    pub(in crate::dynamics) fn expected_depth(&self, model: &Model, frames: &[Frame]) -> f64 {
        let here = self.look(model, frames);
        let pair = &model.pairs[model.contacts[self.site].pair];
        let mass = pair.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
        here.gap.abs().max(self.closed.law.normal.depth(mass, here.gap_rate.abs()))
    }

    /// Whether its friction turns with `V_t` without delay: the paper's law in two directions.
    pub(in crate::dynamics) fn turns_at_once(&self) -> bool {
        let law = &self.closed.law;
        let slips = matches!(self.closed.mode, Mode::Slip { .. });
        slips && law.friction == FrictionLaw::Paper && law.v_stick > 0.0 && law.mu_k > 0.0
    }

    /// The contact with its slip direction as the vector has it.
    #[inline]
    pub(in crate::dynamics) fn turned(&self, y: &[f64]) -> ClosedContact {
        let mut closed = self.closed;
        if let Some(at) = self.angle {
            closed.mode = Mode::Slip { direction: direction(y[at]) };
        }
        closed
    }
}

/// The law's force on the node, in the face's axes, at the depth that the contact is expected not to exceed.
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
        self.closed.forces_in(mode, here).dissipated_powers().iter().sum()
    }

    fn stiffness_bound(&self, _: &Mode) -> f64 {
        let law = &self.closed.law;
        law.normal.stiffness_bound(self.depth).max(law.k_t)
    }

    fn damping_bound(&self, _: &Mode) -> f64 {
        let law = &self.closed.law;
        law.normal.damping_bound(self.depth).max(law.c_t)
    }
}

/// The unit vector at an angle.
pub(in crate::dynamics) fn direction(angle: f64) -> DVec2 {
    let (sin, cos) = angle.sin_cos();
    DVec2::new(cos, sin)
}
