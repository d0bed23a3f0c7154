//! Force between two bodies: the sum over all their contacts, whichever faces these belong to (`docs/physics.md#sharing-of-a-pairs-stiffness`).
//! How it is divided among corners depends on how many touch at one place; their sum does not.

use std::collections::BTreeMap;

use glam::DVec3;

use super::readings::largest;
use super::report::Extreme;
use super::{History, Touch};
use crate::dynamics::model::pair::Pair;
use crate::scene::facing::SolidId;

/// Most instants of a hit, those of the largest forces of single contacts, at which the sum is looked at first. Chosen: contacts that
/// chatter under another one that stays closed are many, and their peaks alike.
const MOST_LOOKS: usize = 64;

impl History {
    /// Force of the second body of a pair on its first, of all contacts between the two \[N\].
    pub fn resultant(&self, pair: usize, t: f64) -> DVec3 {
        let Some(own) = self.model().pairs.get(pair) else { return DVec3::ZERO };
        let solids = [own.first.solid(), own.second.solid()];
        let between = self.model().pairs.iter().filter(|pair| {
            let own = [pair.first.solid(), pair.second.solid()];
            own == solids || own == [solids[1], solids[0]]
        });
        let closed = between.flat_map(Pair::nodes).filter_map(|contact| self.contact_at(contact, t));
        closed.filter_map(|now| Some(now.force * self.sign(now.contact, solids)?)).sum()
    }

    /// 1 where a contact's node is on the first of two bodies and its face on the second, −1 the other way round; `None` where it is
    /// between others.
    fn sign(&self, contact: usize, [first, second]: [SolidId; 2]) -> Option<f64> {
        let site = &self.model().contacts[contact];
        let pair = &self.model().pairs[site.pair];
        let own = [pair.first.solid(), pair.second.solid()];
        let of_first = if site.node_body == pair.bodies[0] { 1.0 } else { -1.0 };
        if own == [first, second] {
            Some(of_first)
        } else if own == [second, first] {
            Some(-of_first)
        } else {
            None
        }
    }

    /// The largest |force| between any two bodies that touched, by a pair between them \[N\]; one entry for every two bodies, in the
    /// order of their pairs; none where all touches are impulses.
    pub fn largest_resultants(&self) -> Vec<(usize, Extreme)> {
        let most = |hits: Vec<(f64, Extreme)>| {
            hits.into_iter().map(|(_, most)| most).reduce(|a, b| if b.value > a.value { b } else { a })
        };
        self.hits_between()
            .into_iter()
            .filter_map(|(pair, hits)| Some((pair, most(hits)?)))
            .filter(|(_, most)| most.value > 0.0)
            .collect()
    }

    /// Of every two bodies that touched a pair between them and their hits: when each begins \[s\], and the largest |force| in it \[N\].
    /// In the order of the pairs.
    pub(super) fn hits_between(&self) -> Vec<(usize, Vec<(f64, Extreme)>)> {
        let mut between: BTreeMap<[SolidId; 2], Vec<&Touch>> = BTreeMap::new();
        // In order of their start.
        for touch in self.touches() {
            let pair = &self.model().pairs[touch.pair];
            let mut solids = [pair.first.solid(), pair.second.solid()];
            solids.sort_unstable();
            between.entry(solids).or_default().push(touch);
        }
        let mut all: Vec<(usize, Vec<(f64, Extreme)>)> = Vec::with_capacity(between.len());
        for (solids, touches) in between {
            let Some(pair) = touches.iter().map(|touch| touch.pair).min() else { continue };
            let hits = together(&touches).into_iter().map(|hit| (hit[0].start, self.largest_of_hit(hit, solids)));
            all.push((pair, hits.collect()));
        }
        all.sort_by_key(|(pair, _)| *pair);
        all
    }

    fn largest_of_hit(&self, hit: &[&Touch], solids: [SolidId; 2]) -> Extreme {
        let mut hardest = hit.to_vec();
        hardest.sort_by(|a, b| b.peak_force.total_cmp(&a.peak_force));
        hardest.truncate(MOST_LOOKS);
        let mut times: Vec<f64> = hardest.iter().map(|touch| touch.peak_time).collect();
        times.extend(hit.iter().map(|touch| touch.start).reduce(f64::min));
        times.extend(hit.iter().map(|touch| touch.end).reduce(f64::max));
        times.sort_by(f64::total_cmp);
        times.dedup();
        let of = |touch: &&Touch, t: f64| {
            let closed = touch.start <= t && t <= touch.end;
            let now = closed.then(|| self.contact_at(touch.contact, t))??;
            Some(now.force * self.sign(touch.contact, solids)?)
        };
        largest(&times, |t| hit.iter().filter_map(|touch| of(touch, t)).sum::<DVec3>().length())
    }
}

/// Touches in order of their start, in parts between which nothing is closed.
fn together<'a, 'b>(touches: &'b [&'a Touch]) -> Vec<&'b [&'a Touch]> {
    let mut parts = Vec::new();
    let (mut from, mut until) = (0, f64::NEG_INFINITY);
    for (i, touch) in touches.iter().enumerate() {
        if i > from && touch.start > until {
            parts.push(&touches[from..i]);
            from = i;
        }
        until = until.max(touch.end);
    }
    if from < touches.len() {
        parts.push(&touches[from..]);
    }
    parts
}
