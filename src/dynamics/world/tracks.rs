//! What one group of bodies is made of while it is computed: bodies, facing pairs, contacts, with their states and the
//! predictions in force.

use crate::dynamics::connection::Phase;
use crate::dynamics::free_flight::body_motion::{BodyFlight, BodyMotion};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::record::link_log::LinkLog;
use crate::dynamics::trajectory::segment::{Segment, SegmentMotion};
use crate::dynamics::trajectory::stored_path::StoredPath;
use crate::dynamics::world::axial_gap::AxialGap;
use crate::dynamics::world::site_geometry::SiteGeometry;

/// How a body moves from now on.
#[derive(Debug)]
pub(in crate::dynamics) enum Trajectory {
    /// Not yet begun.
    Placed,
    /// In closed form, until something happens.
    Flight(BodyFlight),
    /// With others, as that island's body of that number.
    Island { island: usize, index: usize },
}

/// A body of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct BodyTrack {
    /// Its number in the model.
    pub body: usize,
    /// Its free motion, where that has a closed form.
    pub system: Option<BodyMotion>,
    /// What it does now.
    pub now: Trajectory,
    /// What it did.
    pub path: StoredPath,
    /// The pairs it is in.
    pub pairs: Vec<usize>,
    /// The links it is at.
    pub links: Vec<usize>,
}

impl BodyTrack {
    /// A flight as a segment of the path that ends at `t`, with the states that a record's samples are counted from.
    pub(in crate::dynamics) fn flown(&self, flight: &BodyFlight, t: f64) -> Segment {
        let mut flight = flight.clone();
        if let Some(system) = &self.system {
            system.remember(&mut flight, t);
        }
        Segment { from: flight.start(), until: t, path: SegmentMotion::Flight(Box::new(flight)) }
    }
}

/// A pair of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct PairTrack {
    /// Its number in the model.
    pub pair: usize,
    /// Slots of its bodies; nothing for an abutment.
    pub slots: [Option<usize>; 2],
    /// Its contacts in the engine.
    pub contacts: std::ops::Range<usize>,
    /// Nodes that share K and C while it is closed; 0 while it is open.
    pub sharers: usize,
    /// Two events closer than this are one \[s\].
    pub together: f64,
    /// Its one gap, where it has one as long as its bodies move along an axis.
    pub axial: Option<AxialGap>,
}

/// A link of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct LinkTrack {
    /// Its number in the model.
    pub link: usize,
    /// Slots of the bodies at its ends; nothing for the ground.
    pub slots: [Option<usize>; 2],
    /// Its phase now.
    pub phase: Phase,
    /// When its force begins on the trajectories in force \[s\].
    pub begins: Option<f64>,
    /// Time within which a change of its phase is over \[s\].
    pub together: f64,
    /// Its phases so far.
    pub log: LinkLog,
}

/// A contact of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct ContactTrack {
    /// Its number in the model.
    pub site: usize,
    /// Its pair in the engine.
    pub pair: usize,
    /// Slots of the node's and the face's body.
    pub slots: [Option<usize>; 2],
    /// Its state now.
    pub state: Contact,
    /// Other contacts of the same node: it touches one face at a time.
    pub rivals: Vec<usize>,
    /// Where its two sides stand as placed.
    pub spot: SiteGeometry,
    /// Its next closing on the trajectories in force \[s\].
    pub closing: Option<f64>,
    /// When it comes out in front of the face on them, after it was behind \[s\].
    pub out: Option<f64>,
    /// Its states so far.
    pub log: ContactLog,
    /// Events of the touch in hand, and the time and number of those at one instant.
    pub counted: (usize, f64, usize),
}

impl ContactTrack {
    /// At `t`, before the trajectories are looked at anew: a node that has come out on the old ones is armed.
    pub(in crate::dynamics) fn take_note(&mut self, t: f64) {
        if self.out.take().is_some_and(|at| at <= t) && self.state.closed().is_none() {
            self.state = Contact::Open { armed: true };
        }
    }
}
