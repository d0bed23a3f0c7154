//! What the event loop knows of each body, pair and declared contact.

use crate::dynamics::free_flight::flight::{Flight, System};
use crate::dynamics::impact2d::State;
use crate::dynamics::impact2d::closing::gap_derivatives::Aim;
use crate::dynamics::trajectory::segment::Segment;
use crate::dynamics::world::site_geometry::SiteGeometry;

/// What a body does now.
#[derive(Clone, Debug)]
pub(in crate::dynamics) enum Going {
    /// It flies.
    Flight(Flight),
    /// It is in lasting contact, at a place of that grip.
    Grip(usize, usize),
}

/// A body of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct BodyTrack {
    /// Its number in the model.
    pub body: usize,
    /// Its free motion.
    pub system: System,
    /// What it does now.
    pub now: Going,
    /// What it did.
    pub segments: Vec<Segment>,
    /// Where the segment in hand begins \[s\].
    pub since: f64,
    /// Its state among a–f.
    pub state: State,
    /// The pairs it is in.
    pub pairs: Vec<usize>,
}

/// A pair of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct PairTrack {
    /// Its number in the model.
    pub number: usize,
    /// Slots of its bodies; nothing for an abutment.
    pub slots: [Option<usize>; 2],
    /// Its declared contacts.
    pub sites: std::ops::Range<usize>,
    /// Whether it is met when it is due, or searched on.
    pub meets: bool,
}

/// A declared contact of the group.
#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each says another thing about one point")]
pub(in crate::dynamics) struct SiteTrack {
    /// Its number in the model.
    pub number: usize,
    /// Which side of the pair owns the node, and which the face; nothing for an abutment.
    pub sides: [Option<usize>; 2],
    /// Where its two sides stand as placed.
    pub spot: SiteGeometry,
    /// The same in plan.
    pub aim: Aim,
    /// Whether it is in lasting contact.
    pub kept: bool,
    /// Whether its next crossing counts.
    pub armed: bool,
    /// Whether it has lifted off without speed.
    pub lifted: bool,
    /// Whether it has gone over the edge of the face, and is not in front of it again.
    pub left: bool,
    /// When it comes out in front of the face on the trajectories in force \[s\].
    pub out: Option<f64>,
    /// How far behind the face a point that has lifted off is met again \[m\].
    pub sink: f64,
}

impl SiteTrack {
    /// It is in front of the face: its next crossing counts.
    pub(in crate::dynamics) fn arm(&mut self) {
        (self.armed, self.lifted, self.left) = (true, false, false);
    }
}
