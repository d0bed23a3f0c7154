//! Bodies and the connections that act on them: what is constant of an island between two events.

use std::sync::OnceLock;

use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::rate_bounds::ModalRates;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::carried_overlap::{BodiesAt, MetContacts};
use crate::dynamics::penalty3d::contact_rates::{decay, fastest, largest_decay_rate};

/// Bodies, and the connections that act on them.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Members {
    /// Numbers of the bodies in the model.
    pub bodies: Vec<usize>,
    /// Reference poses of their states.
    pub bases: Vec<ReferencePose>,
    /// Closed contacts.
    pub active: Vec<ActiveContact>,
    /// Devices whose force acts.
    pub links: Vec<ActiveLink>,
}

/// Bodies joined by connections, with bounds on the rates of the connections.
#[derive(Debug)]
pub(in crate::dynamics) struct CoupledSystem {
    /// Numbers of the bodies in the model.
    pub bodies: Vec<usize>,
    /// Positions of their states in the vector of the integrator.
    pub layout: StateLayout,
    /// Reference poses of their states.
    pub bases: Vec<ReferencePose>,
    /// Closed contacts.
    pub active: Vec<ActiveContact>,
    /// Closed contacts between bodies that have met, by their two bodies.
    pub met: Vec<MetContacts>,
    /// Devices whose force acts.
    pub links: Vec<ActiveLink>,
    /// Of each section of the bodies: whether it moves with G or a connection acts on it.
    pub acted_on: Vec<bool>,
    /// Largest distance of a corner from G, per body \[m\].
    pub radii: Vec<f64>,
    /// Upper bound of the circular frequency of a connection or a bearing \[rad/s\].
    pub omega: f64,
    /// Largest decay rate of the dashpot of a single connection \[1/s\].
    pub largest_decay_rate: f64,
    /// Largest rates of the modes of its girders.
    pub modal: ModalRates,
    /// Upper bound of the decay rate of all dashpots together \[1/s\], from when it is first needed.
    decay: OnceLock<f64>,
}

impl CoupledSystem {
    /// System of bodies with their states in `y` relative to reference poses; the slip angles that are states, then the memories that are
    /// states, are appended to `y`.
    pub(in crate::dynamics) fn of(
        model: &Model,
        Members { bodies, bases, mut active, mut links }: Members,
        y: &mut Vec<f64>,
    ) -> Self {
        for a in &mut active {
            if let Some(angle) = a.closed.slip_angle() {
                a.angle = Some(y.len());
                y.push(angle);
            }
        }
        for link in links.iter_mut().filter(|link| link.link(model).device.evolves(&link.phase)) {
            link.evolving = Some(y.len());
            y.push(link.phase.memory[0]);
        }
        let layout = StateLayout::of(bodies.iter().map(|&b| &model.bodies[b]));
        let states = bodies.iter().zip(layout.states(y));
        let mut frames = Vec::with_capacity(layout.section_count());
        states.for_each(|(&b, state)| model.bodies[b].push_frames(state, &mut frames));
        for link in &mut links {
            link.find_sections(model, &layout);
        }
        for a in &mut active {
            a.find_sections(model, &layout);
            a.depth = a.expected_depth(model, &frames);
        }
        let radii = bodies.iter().map(|&b| model.bodies[b].radius).collect();
        let met = MetContacts::of(model, &bodies, &active);
        let of_met: Vec<usize> =
            met.iter().flat_map(|met| met.sections(model)).map(|[i, own]| layout.sections(i).start + own).collect();
        let mut system = Self {
            met,
            omega: fastest(model, &bodies, &active, &links),
            largest_decay_rate: largest_decay_rate(model, &active, &links),
            modal: bodies.iter().fold(ModalRates::default(), |most, &b| most.max(model.bodies[b].rate_bounds.modal)),
            ..Self::without_rates(Members { bodies, bases, active, links }, layout, radii)
        };
        for section in of_met {
            system.acted_on[section] = true;
        }
        system
    }

    /// Without bounds on rates and without the bodies that have met, which a step of known length does not need.
    pub(in crate::dynamics) fn without_rates(
        Members { bodies, bases, active, links }: Members,
        layout: StateLayout,
        radii: Vec<f64>,
    ) -> Self {
        let mut acted_on = vec![false; layout.section_count()];
        let first = (0..bodies.len()).map(|i| layout.sections(i).start);
        let of_contacts = active.iter().flat_map(|a| ends(a.ends, a.sections));
        let of_links = links.iter().flat_map(|link| ends(link.ends, link.sections));
        first.chain(of_contacts).chain(of_links).for_each(|section| acted_on[section] = true);
        let (met, omega, largest_decay_rate, modal) = (Vec::new(), 0.0, 0.0, ModalRates::default());
        Self {
            bodies,
            layout,
            bases,
            active,
            met,
            links,
            acted_on,
            radii,
            omega,
            largest_decay_rate,
            modal,
            decay: OnceLock::new(),
        }
    }

    /// Whether no force acts between its bodies, or on them from the ground, but those of their bearings, standing or lost.
    pub(in crate::dynamics) fn is_free(&self, model: &Model) -> bool {
        self.active.is_empty() && self.acting(model).next().is_none()
    }

    /// Its bodies with poses `frames` of their sections relative to the reference poses.
    pub(in crate::dynamics) fn at<'a>(&'a self, frames: &'a [Frame]) -> BodiesAt<'a> {
        BodiesAt { layout: &self.layout, bases: &self.bases, active: &self.active, frames }
    }

    /// Devices but supports that are lost: the link of one takes away what the girder's bearing has, and together they have no
    /// force and no energy, however far the girder has gone.
    pub(in crate::dynamics) fn acting(&self, model: &Model) -> impl Iterator<Item = &ActiveLink> {
        self.links.iter().filter(|link| !link.link(model).device.is_lost(&link.phase))
    }

    /// Devices whose memory is a state, in the order of their components.
    pub(in crate::dynamics) fn evolving(&self) -> impl Iterator<Item = &ActiveLink> {
        self.links.iter().filter(|link| link.evolving.is_some())
    }

    /// Number of connections whose force acts.
    pub(in crate::dynamics) fn connection_count(&self) -> usize {
        self.active.len() + self.links.len()
    }

    /// Upper bound of the decay rate of all dashpots together \[1/s\].
    pub(in crate::dynamics) fn decay_bound(&self, model: &Model) -> f64 {
        *self.decay.get_or_init(|| self.modal.decay + decay(model, &self.bodies, &self.active, &self.links))
    }
}

/// Sections of a connection's ends that are bodies.
fn ends(bodies: [Option<usize>; 2], sections: [usize; 2]) -> impl Iterator<Item = usize> {
    bodies.into_iter().zip(sections).filter_map(|(body, section)| body.map(|_| section))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Body;
    use crate::dynamics::penalty3d::example::{MASS, STIFFNESS, closed, row, stick, wall};
    use crate::scene::Scene;

    /// All bodies of a scene with the contacts that are closed as placed, in stick.
    fn system(scene: &Scene, contacts: usize) -> (Model, CoupledSystem) {
        let (model, mut active) = closed(scene, stick);
        active.truncate(contacts);
        let bodies: Vec<usize> = (0..model.bodies.len()).collect();
        let bases = model.bodies.iter().map(Body::placed).collect();
        let mut y: Vec<f64> = model.bodies.iter().flat_map(Body::initial).collect();
        let width = y.len();
        let system = CoupledSystem::of(&model, Members { bodies, bases, active, ..Members::default() }, &mut y);
        assert_eq!(y.len(), width, "no slip turns, no angle is appended");
        (model, system)
    }

    #[test]
    fn bodies_without_an_acting_connection_are_free() {
        let (model, free) = system(&wall(), 0);
        assert!(free.is_free(&model) && free.connection_count() == 0);
        let (model, pressed) = system(&wall(), 2);
        assert!(!pressed.is_free(&model) && pressed.connection_count() == 2);
        assert!(free.omega < 1.0 && pressed.omega >= (STIFFNESS / 2.0 / MASS).sqrt(), "{} rad/s", pressed.omega);
    }

    #[test]
    fn all_dashpots_together_decay_no_slower_than_the_fastest_and_no_faster_than_their_sum() {
        let (mut model, active) = closed(&row(), stick);
        for body in &mut model.bodies {
            body.free[5] = false;
        }
        let (bodies, bases) = ((0..2).collect(), model.bodies.iter().map(Body::placed).collect());
        let mut y: Vec<f64> = model.bodies.iter().flat_map(Body::initial).collect();
        let damped: Vec<ActiveContact> = active
            .into_iter()
            .map(|mut contact| {
                contact.closed.law.c_t = 40.0;
                contact
            })
            .collect();
        let count = damped.len() as f64;
        let system = CoupledSystem::of(&model, Members { bodies, bases, active: damped, ..Members::default() }, &mut y);
        let together = system.decay_bound(&model);
        assert!(system.largest_decay_rate > 0.0 && together > 0.0, "{together} 1/s");
        // A contact slows both of its bodies; each body has the sum of its contacts.
        assert!(
            together <= 2.0 * count * system.largest_decay_rate,
            "{together} against {} 1/s",
            system.largest_decay_rate
        );
        assert_eq!(together, system.decay_bound(&model), "kept");
    }
}
