//! Pairs of faces of bodies that meet during a run and do not face each other as placed (`[contact] between = "all"`).

use super::{Facing, Side, SolidId, facing};
use crate::scene::Scene;

/// Pairs of every face of one body with every face of the other, less those in `known`, for each two bodies in `met`.
pub fn between(scene: &Scene, met: &[[SolidId; 2]], known: &[Facing]) -> Vec<Facing> {
    let mut all = Vec::new();
    for bodies in met {
        // Girders before abutments, and by number: the order in which a pair is kept.
        let [one, other] = [bodies[0].min(bodies[1]), bodies[0].max(bodies[1])].map(|body| Side::of(scene.kind, body));
        let pairs = one.iter().flat_map(|&first| other.iter().map(move |&second| (first, second)));
        let new = pairs.filter(|&(first, second)| !known.iter().any(|f| f.first == first && f.second == second));
        all.extend(new.map(|(first, second)| facing(scene, first, second, true)));
    }
    all
}

/// The bodies of pairs that were added by [`between`], each two once, in order.
pub fn bodies_met(pairs: impl Iterator<Item = (Side, Side)>) -> Vec<[SolidId; 2]> {
    let mut all: Vec<_> = pairs.map(|(first, second)| [first.solid(), second.solid()]).collect();
    all.sort_unstable();
    all.dedup();
    all
}
