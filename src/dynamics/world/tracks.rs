//! Bodies, facing pairs, links and contacts of one group during a run: present states, trajectories, and times found
//! by searches.

use glam::DVec2;
use smallvec::SmallVec;

use crate::dynamics::connection::{Phase, Switch};
use crate::dynamics::free_flight::body_flight::BodyFlight;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::locate::subdivision::GapClosing;
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::record::link_log::LinkLog;
use crate::dynamics::trajectory::segment::{Segment, SegmentMotion};
use crate::dynamics::trajectory::stored_path::StoredPath;
use crate::dynamics::world::axial_gap::AxialGap;
use crate::dynamics::world::site_geometry::SiteGeometry;

/// Present trajectory of a body.
#[derive(Debug)]
pub(in crate::dynamics) enum Trajectory {
    /// At rest as placed, before t = 0 is handled.
    Placed,
    /// In closed form until the next event of the body.
    Flight(BodyFlight),
    /// Member `index` of the island of number `island`.
    Island { island: usize, index: usize },
}

/// A body of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct BodyTrack {
    /// Number in the model.
    pub body: usize,
    /// Free motion of the body; `None` where that has no closed form.
    pub free_motion: Option<BodyMotion>,
    /// Number of the linear block that it is of.
    pub block: Option<usize>,
    /// Present trajectory.
    pub now: Trajectory,
    /// Past trajectory.
    pub path: StoredPath,
    /// Numbers of its pairs in the group, ascending.
    pub pairs: Vec<usize>,
    /// Numbers of its links in the group, ascending.
    pub links: Vec<usize>,
}

impl BodyTrack {
    /// The present flight; `None` of a body that does not fly.
    pub(in crate::dynamics) fn flight(&self) -> Option<&BodyFlight> {
        match &self.now {
            Trajectory::Flight(flight) => Some(flight),
            Trajectory::Placed | Trajectory::Island { .. } => None,
        }
    }
}

/// A flight as segments of the path that end at `t`: one, with its states at the samples of a record, unless it swings
/// faster than its stretches.
pub(in crate::dynamics) fn flown(flight: &BodyFlight, t: f64) -> SmallVec<[Segment; 1]> {
    let (mut flight, mut segments) = (flight.clone(), SmallVec::new());
    flight.remember(t);
    let mut until = flight.window_end(flight.start());
    while until < t {
        let rest = flight.resume(until);
        segments.push(segment(std::mem::replace(&mut flight, rest), until));
        until = flight.window_end(until);
    }
    segments.push(segment(flight, t));
    segments
}

fn segment(flight: BodyFlight, until: f64) -> Segment {
    Segment { from: flight.start(), until, path: SegmentMotion::Flight(Box::new(flight)) }
}

/// A pair of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct PairTrack {
    /// Number in the model.
    pub model_pair: usize,
    /// Slots of its bodies; `None` for an abutment.
    pub slots: [Option<usize>; 2],
    /// Sections of these bodies that face each other.
    pub sections: [usize; 2],
    /// Slots and sections that carry its corners where these are others: the corners of a face along a girder that bends.
    pub corner_sections: Vec<(usize, usize)>,
    /// Numbers of its contacts in the group, corners before edge nodes.
    pub contacts: std::ops::Range<usize>,
    /// Number of nodes, in space of vertices, that share K and C while a contact of the pair is closed; 0 while all are
    /// open.
    pub sharers: usize,
    /// Simultaneity interval: equal events of the pair's contacts within it change state together \[s\]
    /// (`docs/physics.md#simultaneous-events`).
    pub simultaneity: f64,
    /// Common gap of all nodes of a pair on one axis; `None` for others.
    pub axial: Option<AxialGap>,
    /// Number in the model of the meeting of its bodies, where every face of the two has a pair.
    pub meeting: Option<usize>,
    /// Whether the two bodies of a meeting were near each other or apart at the last search.
    pub search_state: SearchState,
    /// Time of its next closing, or of its next search; infinite without either \[s\].
    pub due: f64,
}

/// Relative position of two bodies that have met at the last search of one of their pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::dynamics) enum SearchState {
    /// Near each other, or not searched yet: nodes are armed and disarmed as they pass planes.
    #[default]
    Near,
    /// Apart, and the pair was searched from the time on at which they can touch.
    Searched,
    /// Apart for as long as is known: none of the pair's contacts has a closing.
    Idle,
}

/// A link of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct LinkTrack {
    /// Number in the model.
    pub link: usize,
    /// Slots of the bodies at its ends; `None` for the ground.
    pub slots: [Option<usize>; 2],
    /// Present phase of its device.
    pub phase: Phase,
    /// Time at which its phase ends on the present trajectories, and how: its force begins or, in a body's flight, a switching
    /// function rises; `None` without an end before that of the search \[s\].
    pub ends: Option<(f64, Switch)>,
    /// Nominal circular frequency of its lighter body on its device \[rad/s\].
    pub omega: f64,
    /// Simultaneity interval \[s\], from that.
    pub simultaneity: f64,
    /// Phases since t = 0.
    pub log: LinkLog,
}

/// A contact of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct ContactTrack {
    /// Number of its site in the model.
    pub site: usize,
    /// Number of its pair in the group.
    pub pair: usize,
    /// Slots of the node's and the face's body; `None` for an abutment.
    pub slots: [Option<usize>; 2],
    /// Sections of these bodies that carry them.
    pub sections: [usize; 2],
    /// Present state.
    pub state: Contact,
    /// Number by which the pair's K and C are divided for this node in the present touch \[–\].
    pub divisor: f64,
    /// In plan, whether it is one of the nodes among which K and C were divided, and has passed its part to no other.
    pub has_part: bool,
    /// Node and normal of the contact since its last closing.
    pub place: NodePlace,
    /// Of an edge node the contacts of both ends of the edge with the same face, where these are nodes; `None` of a corner.
    pub corners: Option<[usize; 2]>,
    /// Other contacts of the node with the same body, of which it touches one face at a time.
    pub other_faces: Vec<usize>,
    /// Geometry of its site as placed.
    pub geometry: SiteGeometry,
    /// Next closing on the present trajectories, or when a disarmed contact has a positive gap again.
    pub found: GapClosing,
    /// States since t = 0.
    pub log: ContactLog,
    /// Overlap of its two bodies beyond the deepest penetration between them that no contact can carry, and that is tolerated while it is
    /// closed \[m\].
    pub tolerated: f64,
    /// Changes of state, counted.
    pub changes: ChangeCount,
}

impl ContactTrack {
    /// Enters a state from `t` \[s\] on, with the origin of its anchor: the displacement of the node along the face from the placed
    /// to the reference poses \[m\].
    pub(in crate::dynamics) fn enter(&mut self, t: f64, state: Contact, origin: DVec2) {
        (self.state, self.found.rearmed_at) = (state, None);
        self.log.push(t, state, origin);
    }

    /// Arms a disarmed contact whose gap has become positive before `t` on the trajectories of the last search.
    pub(in crate::dynamics) fn rearm_if_positive(&mut self, t: f64) {
        if self.found.rearmed_at.take().is_some_and(|at| at <= t) && self.state.closed().is_none() {
            self.state = Contact::Open { armed: true };
        }
    }
}

/// Changes of a contact's state, counted: too many end the run, and several at one instant widen dead bands.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct ChangeCount {
    /// Changes since the touch began.
    pub of_touch: usize,
    /// Time of the last change; −1 before the first \[s\].
    pub t: f64,
    /// Changes at that time.
    pub at_instant: usize,
}

impl Default for ChangeCount {
    fn default() -> Self {
        Self { of_touch: 0, t: -1.0, at_instant: 0 }
    }
}

impl ChangeCount {
    /// Counts a change at `t`.
    pub(in crate::dynamics) fn count(&mut self, t: f64) {
        self.of_touch += 1;
        self.at_instant = if self.t == t { self.at_instant + 1 } else { 1 };
        self.t = t;
    }
}
