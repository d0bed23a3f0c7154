//! Contacts beyond the validity of their law: pressed too deep, or left over a face's edge with energy in their springs.

use std::collections::BTreeMap;

use super::view::Contacts;
use crate::contact::normal::NormalLaw;
use crate::scene::Kind;
use crate::scene::facing::SolidId;
use crate::sim::peaks::largest;
use crate::sim::report::{Event, EventKind, Extreme};

/// Deepest penetration in parts of the shortest side of either girder: a penalty spring stands for what bodies give where
/// they touch; a tenth of a body is a deformation of the whole. Chosen, as no law has a limit of its own.
const DEEPEST: f64 = 0.1;
/// Parts into which a touch is divided to find its deepest penetration.
const PARTS: u32 = 32;
/// Energy from which a drop counts, in parts of the largest energy in play: the ledger's bound at a tolerance of 1e-8.
const LEAST_DROP: f64 = 1e-6;

/// A contact whose penetration exceeds a tenth of the shortest side of either girder, or of the depth behind its face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooDeep {
    /// The contact, the deepest of its pair.
    pub contact: usize,
    /// Its largest penetration \[m\], and when.
    pub depth: Extreme,
    /// Allowed value \[m\].
    pub allowed: f64,
}

/// Contacts that left a face over its edge, or behind the body, while their springs held energy that no other contact between the two
/// bodies took over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dropped {
    /// Number of times.
    pub count: usize,
    /// Energy of all of them, less what was taken over \[J\].
    pub energy: f64,
    /// That energy in parts of the largest energy in play \[–\].
    pub share: f64,
    /// The contact that lost most.
    pub contact: usize,
    /// Time at which it left \[s\].
    pub t: f64,
}

/// Energy that changes from contact to contact between two bodies.
#[derive(Clone, Copy, Debug, Default)]
struct HandOver {
    /// Closed contacts.
    closed: usize,
    /// Energy with which contacts came in at a depth since the two bodies touch, and that no contact has left with yet \[J\].
    taken: f64,
    /// Number of the last contact that left, in the list of those.
    last: Option<usize>,
}

impl HandOver {
    /// Takes what was taken over from what a contact lost.
    fn settle(&mut self, lost: &mut f64) {
        let common = self.taken.min(*lost);
        self.taken -= common;
        *lost -= common;
    }
}

impl<'a> Contacts<'a> {
    /// Contacts whose penetration exceeds a tenth of the shortest side, at most one a pair, in the order of the pairs.
    pub fn too_deep(self) -> Vec<TooDeep> {
        (0..self.history.model().pairs.len()).filter_map(|pair| self.too_deep_of(pair)).collect()
    }

    fn too_deep_of(self, pair: usize) -> Option<TooDeep> {
        let own = &self.history.model().pairs[pair];
        let sides = own.bodies.into_iter().flatten().map(|body| {
            let prism = &self.history.model().bodies[body].prism;
            // Heights have no meaning in plan.
            let thickness = if self.history.model().kind == Kind::Planar { f64::INFINITY } else { prism.thickness };
            prism.length.min(prism.width).min(thickness)
        });
        // What stands behind a face can be thinner than every girder: a backwall.
        let behind = own.nodes().map(|site| self.history.model().sites[site].face.depth);
        let allowed = DEEPEST * sides.chain(behind).fold(f64::INFINITY, f64::min);
        // At its deepest a contact has no normal velocity: its force is no less than the spring's. A node has at least the
        // whole law's share of one of them all.
        let force = own.law.normal.elastic(allowed) / own.nodes().count().max(1) as f64;
        let touches =
            self.history.hits().touches().iter().filter(|touch| touch.pair == pair && touch.peak_force >= force);
        let deepest = touches.map(|touch| {
            let part = (touch.end - touch.start) / f64::from(PARTS);
            let times: Vec<f64> = (0..=PARTS).map(|i| touch.start + part * f64::from(i)).collect();
            let depth = |t: f64| self.contact_at(touch.contact, t).map_or(0.0, |now| now.penetration);
            TooDeep { contact: touch.contact, depth: largest(&times, &depth), allowed }
        });
        deepest
            .filter(|deep| deep.depth.value > allowed)
            .reduce(|a, b| if b.depth.value > a.depth.value { b } else { a })
    }

    /// Contacts that left a face with energy in their springs; `None` where that is nothing beside the energy in play.
    pub fn dropped(self) -> Option<Dropped> {
        let scale = self.history.energy().ledger(self.history.end()).scale;
        let left = self.lost_over_edges();
        let (most, _) = left.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        let energy: f64 = left.iter().map(|(_, lost)| lost).sum();
        (energy > LEAST_DROP * scale).then(|| Dropped {
            count: left.len(),
            energy,
            share: energy / scale,
            contact: most.site(),
            t: most.t,
        })
    }

    /// Contacts that left a face, with the energy of their springs \[J\] less what contacts between the same two bodies took over: what
    /// they came in with at a depth during the same touch of the two, or at the instant at which this one left.
    fn lost_over_edges(self) -> Vec<(&'a Event, f64)> {
        let mut left: Vec<(&Event, f64)> = Vec::new();
        let mut between: BTreeMap<[SolidId; 2], HandOver> = BTreeMap::new();
        for event in self.history.events() {
            let pair = &self.history.model().pairs[self.history.model().sites[event.site()].pair];
            let solids = pair.solids();
            let hand_over = between.entry(solids).or_default();
            match event.kind {
                EventKind::OpenToStick | EventKind::OpenToSlip => {
                    hand_over.closed += 1;
                    hand_over.taken += (-event.released).max(0.0);
                    if let Some((leaving, lost)) = hand_over.last.and_then(|last| left.get_mut(last))
                        && leaving.t == event.t
                    {
                        hand_over.settle(lost);
                    }
                }
                EventKind::LeftFace | EventKind::Opened => {
                    hand_over.closed = hand_over.closed.saturating_sub(1);
                    if event.kind == EventKind::LeftFace {
                        let mut lost = event.released.max(0.0);
                        hand_over.settle(&mut lost);
                        hand_over.last = Some(left.len());
                        left.push((event, lost));
                    }
                    if hand_over.closed == 0 {
                        hand_over.taken = 0.0;
                    }
                }
                EventKind::StickToSlip
                | EventKind::SlipToStick
                | EventKind::Moved
                | EventKind::Missed
                | EventKind::Hit => {}
            }
        }
        left.retain(|(_, lost)| *lost > 0.0);
        left
    }
}
