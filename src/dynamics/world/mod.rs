//! The state of one group of bodies while a run under the contact model is computed.
//!
//! [`World`] holds bodies, facing pairs, contacts, links and islands at the present time, with their present
//! trajectories and the times found by searches on these. The event queue and the record are elsewhere; `closing`
//! reads a world and enters what it finds, `contact_model` changes it.

pub(in crate::dynamics) mod axial_gap;
mod blocks;
pub(in crate::dynamics) mod connectivity;
mod constants;
pub(in crate::dynamics) mod contact_points;
#[cfg(test)]
pub(in crate::dynamics) mod example;
mod ground_spring;
pub(in crate::dynamics) mod poses;
pub(in crate::dynamics) mod setup;
pub(in crate::dynamics) mod site_geometry;
pub(in crate::dynamics) mod tracks;

use std::sync::Arc;

use crate::dynamics::connection::Link;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::edge_node::Edge;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::{Body, ContactSite, Model, Pair};
use tracks::{BodyTrack, ContactTrack, LinkTrack, PairTrack};

/// Bodies, pairs, contacts, links and islands of one group.
#[derive(Debug)]
pub(in crate::dynamics) struct World {
    /// Constant data of the scene.
    pub model: Arc<Model>,
    /// Bodies of the group; the index of a body is its slot.
    pub bodies: Vec<BodyTrack>,
    /// Facing pairs.
    pub pairs: Vec<PairTrack>,
    /// Contacts, those of one pair in succession.
    pub contacts: Vec<ContactTrack>,
    /// Links.
    pub links: Vec<LinkTrack>,
    /// Slots of the bodies of each linear block, ascending.
    pub blocks: Vec<Vec<usize>>,
    /// Bodies that are integrated together; `None` at a vacant number.
    pub islands: Vec<Option<Box<Island>>>,
}

impl World {
    /// The site of a contact in the model.
    pub(in crate::dynamics) fn site(&self, contact: usize) -> &ContactSite {
        &self.model.sites[self.contacts[contact].site]
    }

    /// Whether a contact is in stick or slip.
    pub(in crate::dynamics) fn is_closed(&self, contact: usize) -> bool {
        self.contacts[contact].state.closed().is_some()
    }

    /// The pair of a contact.
    pub(in crate::dynamics) fn pair_of(&self, contact: usize) -> &PairTrack {
        &self.pairs[self.contacts[contact].pair]
    }

    /// A pair in the model.
    pub(in crate::dynamics) fn model_pair(&self, pair: usize) -> &Pair {
        &self.model.pairs[self.pairs[pair].model_pair]
    }

    /// The body in a slot as constant data.
    pub(in crate::dynamics) fn model_body(&self, slot: usize) -> &Body {
        &self.model.bodies[self.bodies[slot].body]
    }

    /// A link as constant data.
    pub(in crate::dynamics) fn model_link(&self, link: usize) -> &Link {
        &self.model.links[self.links[link].link]
    }

    /// Layout of the states and sections of bodies.
    pub(in crate::dynamics) fn layout_of(&self, slots: &[usize]) -> StateLayout {
        StateLayout::of(slots.iter().map(|&slot| self.model_body(slot)))
    }

    /// The edge of an edge node; `None` for a corner.
    pub(in crate::dynamics) fn edge(&self, contact: usize) -> Option<&Edge> {
        self.site(contact).edge.as_deref()
    }
}
