//! A facing pair and its contact sites as constant data: a site is one node against one face (paper Fig. 24).

use std::sync::Arc;

use glam::DVec3;

use crate::contact::{Frame, Home, Law, Local};
use crate::geometry::{End, Face};
use crate::scene::facing::{PairContact, Side};

/// A facing pair, compiled.
#[derive(Clone, Debug)]
pub struct Pair {
    /// `deck+x|wall`.
    pub name: String,
    /// A girder's end.
    pub first: Side,
    /// A girder's end or an abutment.
    pub second: Side,
    /// The girders on both sides; nothing for an abutment.
    pub bodies: [Option<usize>; 2],
    /// The numbers in force.
    pub contact: PairContact,
    /// The law of the whole pair, which its nodes share.
    pub law: Law,
    /// Gap along the first girder's axis as placed \[m\].
    pub gap: f64,
    /// Its contacts, numbers in [`Model::contacts`](crate::dynamics::Model::contacts).
    pub contacts: std::ops::Range<usize>,
    /// Whether sliding has one direction only: the faces are vertical and no body can move vertically, roll or pitch.
    pub one_way: bool,
}

/// A declared node and face (Fig. 24).
#[derive(Clone, Debug)]
pub struct ContactSite {
    /// `deck.corner1`, as tables call the node.
    pub node: String,
    /// Name of the face, `wall` or `deck-x`.
    pub face_name: Arc<str>,
    /// Its pair.
    pub pair: usize,
    /// The ends of their bodies that node and face are of; nothing for an abutment.
    pub ends: [Option<End>; 2],
    /// The body that owns the node; nothing for an abutment's corner.
    pub node_body: Option<usize>,
    /// The node in its body's frame (about `fixed`, for an abutment) \[m\].
    pub point: DVec3,
    /// The body that owns the face; nothing for an abutment.
    pub face_body: Option<usize>,
    /// The face in its body's frame (about `fixed`, for an abutment).
    pub face: Face,
    /// Both as placed.
    pub home: Home,
    /// Where the frame of the abutment in this contact stands, if there is one \[m\].
    pub fixed: DVec3,
    /// That frame.
    pub stand: Frame,
}

impl ContactSite {
    /// Size that the node's coordinates on the face round with: of the face, and of either lever from G \[m\].
    pub fn reach(&self) -> f64 {
        self.face.size().max(self.point.length()).max(self.face.corners[0].length())
    }
    /// Distances of the node from G of its own body, and of the same point from G of the face's body, as an upper bound \[m\].
    pub(in crate::dynamics) fn levers(&self, here: &Local) -> [f64; 2] {
        [self.point.length(), self.face.corners[0].length() + here.gap.abs() + here.at.length()]
    }
}
