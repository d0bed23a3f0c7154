//! Overlaps that no contact carries: bodies that pass through each other where the model has no force between them.
//!
//! The search needs no law. It takes the answer as it stands, the shapes of the bodies and the closed contacts, and
//! compares, for every two bodies that come near, the depth of their overlap with the deepest penetration of a contact
//! between the two. What exceeds it is carried by nothing: a side that was entered, an end that faces none as placed, an edge
//! against an edge, a node that left its face. Whom to compare follows from the boxes that the bodies sweep during the run
//! ([`envelope`]); when, from bounds on their motion ([`search`]).

mod envelope;
mod expected;
mod motion;
mod search;
mod solid;
mod unwatched;

use rayon::prelude::*;

use super::History;
use super::report::Overlap;
use crate::geometry::broad;
use crate::scene::Kind;
pub use expected::{Unjoined, unjoined};
use solid::{Joined, Solids};
use unwatched::Turned;

/// Overlap, in parts of the smallest side of either body, that contact points of two tilted faces in space can leave between
/// them: a hundred times the largest that was measured, 8 µm of 1.5 m (`docs/physics.md#edge-nodes`).
const TILTED_FACE_OVERLAP: f64 = 5e-4;

impl History {
    /// Overlaps that no contact carries, one for every two bodies, in order of the time when each was seen first.
    pub fn overlaps(&self) -> &[Overlap] {
        self.found.overlaps.get_or_init(|| {
            let (solids, joined) = (Solids::of(self.scene(), self.model()), Joined::of(self.model()));
            if solids.len() < 2 {
                return Vec::new();
            }
            // Bodies, then pairs, each for itself.
            let bodies = (0..solids.len()).into_par_iter();
            let boxes: Vec<_> = bodies.map(|number| envelope::of(self, &solids, number)).collect();
            let near = broad::pairs(&boxes).into_par_iter();
            let near = near.filter(|&(one, other)| solids.moves(one) || solids.moves(other));
            let turned = Turned::of(self);
            let first = |(one, other)| search::first(self, &solids, (&joined, &turned), [one, other]);
            let mut found: Vec<Overlap> = near.filter_map(first).collect();
            found.sort_by(|a, b| a.first().total_cmp(&b.first()).then(a.bodies.cmp(&b.bodies)));
            found
        })
    }
}

impl Overlap {
    /// Whether two bodies that overlap without a contact have met where their pairs do not touch: not where the overlap is a sliver
    /// that contact between tilted faces in space leaves.
    pub(super) fn has_met(&self, history: &History) -> bool {
        let faces = !Joined::of(history.model()).facing(self.bodies).is_empty();
        let sliver = TILTED_FACE_OVERLAP * Solids::pair(history, self.bodies).least_side([0, 1]);
        !(faces && history.model().kind == Kind::Spatial && self.depth.value <= sliver)
    }

    /// Depth of the overlap of two bodies at `t`, along the shortest way out; 0 apart \[m\].
    pub fn depth_at(&self, history: &History, t: f64) -> f64 {
        let pair = Solids::pair(history, self.bodies);
        let placed = pair.placed(history, [0, 1], t);
        (-pair.separation([0, 1], &placed)).max(0.0)
    }
}
