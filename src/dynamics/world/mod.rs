//! The state of one group of bodies while a run under the contact model is computed.
//!
//! [`World`] holds bodies, facing pairs, contacts and islands at the present time with the trajectories and predictions in
//! force. It has no queue and no record: closing reads it, the contact model changes it.

pub(in crate::dynamics) mod axial_gap;
pub(in crate::dynamics) mod poses;
pub(in crate::dynamics) mod setup;
pub(in crate::dynamics) mod site_geometry;
pub(in crate::dynamics) mod tracks;

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::penalty3d::island::Island;
use tracks::{BodyTrack, ContactTrack, LinkTrack, PairTrack};

/// Bodies, pairs, contacts and islands of one group.
#[derive(Debug)]
pub(in crate::dynamics) struct World {
    /// The constant data.
    pub model: Arc<Model>,
    /// Bodies of the group; a body's place here is its slot.
    pub bodies: Vec<BodyTrack>,
    /// Facing pairs.
    pub pairs: Vec<PairTrack>,
    /// Contacts, those of one pair side by side.
    pub contacts: Vec<ContactTrack>,
    /// Links.
    pub links: Vec<LinkTrack>,
    /// Bodies that are integrated together; nothing at a number that is not in use.
    pub islands: Vec<Option<Box<Island>>>,
}
