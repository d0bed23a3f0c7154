//! Force between two bodies: the sum over all their contacts, whichever faces these belong to (`docs/physics.md#sharing-of-a-pairs-stiffness`).
//! How it is divided among corners depends on how many touch at one place; their sum does not.

use std::collections::BTreeMap;

use glam::DVec3;
use rayon::prelude::*;

use super::touches::looks_in_hit;
use super::view::Hits;
use crate::dynamics::model::pair::Pair;
use crate::scene::facing::SolidId;
use crate::sim::report::{Extreme, Pounding, PoundingHit};
use crate::sim::{Touch, peaks};

impl<'a> Hits<'a> {
    /// Force of the second body of a pair on its first, of all contacts between the two \[N\].
    pub fn resultant(self, pair: usize, t: f64) -> DVec3 {
        let Some(own) = self.history.model().pairs.get(pair) else { return DVec3::ZERO };
        let solids = [own.first.solid(), own.second.solid()];
        let between = self.history.model().pairs.iter().filter(|pair| pair.is_between(solids));
        let closed = between.flat_map(Pair::nodes).filter_map(|contact| self.history.contacts().contact_at(contact, t));
        closed.filter_map(|now| Some(now.force * self.sign(now.contact, solids)?)).sum()
    }

    /// 1 where a contact's node is on the first of two bodies and its face on the second, −1 the other way round; `None` where it is
    /// between others.
    fn sign(self, contact: usize, [first, second]: [SolidId; 2]) -> Option<f64> {
        let site = &self.history.model().sites[contact];
        let pair = &self.history.model().pairs[site.pair];
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

    /// The largest |force| between any two bodies at an instant \[N\].
    pub fn largest_resultant(self, t: f64) -> f64 {
        let mut between: BTreeMap<[SolidId; 2], DVec3> = BTreeMap::new();
        for now in self.history.contacts().at(t) {
            let pair = &self.history.model().pairs[now.pair];
            let solids = pair.solids();
            *between.entry(solids).or_default() += now.force * self.sign(now.contact, solids).unwrap_or_default();
        }
        between.into_values().map(DVec3::length).fold(0.0, f64::max)
    }

    /// The hits of the two bodies with the largest force between them, and that force; none where all touches are impulses.
    pub fn hardest_pounding(self) -> Option<(&'a Pounding, Extreme)> {
        let most = |of: &'_ Pounding| of.most().map_or(0.0, |most| most.value);
        let hardest = self.poundings().iter().reduce(|a, b| if most(b) > most(a) { b } else { a })?;
        hardest.most().filter(|most| most.value > 0.0).map(|most| (hardest, most))
    }

    /// The closed contact with the largest force between the bodies of a pair.
    pub fn strongest_contact(self, pair: usize, t: f64) -> Option<usize> {
        let own = self.history.model().pairs.get(pair)?;
        let solids = [own.first.solid(), own.second.solid()];
        let closed = self.history.contacts().at(t).into_iter().filter(|now| self.sign(now.contact, solids).is_some());
        closed.max_by(|a, b| a.force.length().total_cmp(&b.force.length())).map(|now| now.contact)
    }

    /// The largest |force| between any two bodies that touched, by the pair of their hardest touch \[N\]; one entry for every two bodies,
    /// in the order of these pairs; none where all touches are impulses.
    pub fn largest_resultants(self) -> Vec<(usize, Extreme)> {
        let most = |of: &Pounding| Some((of.pair, of.most().filter(|most| most.value > 0.0)?));
        self.poundings().iter().filter_map(most).collect()
    }

    /// The hits of every two bodies that touched, in the order of their pairs.
    pub fn poundings(self) -> &'a [Pounding] {
        self.history.found.poundings.get_or_init(|| self.find_poundings())
    }

    /// The largest force between a girder and another body, all their contacts together, with the number of a pair of the two \[N\];
    /// `None` where the girder touched nobody.
    pub fn largest_total_on(self, girder: usize) -> Option<(usize, Extreme)> {
        let on =
            self.poundings().iter().filter(|of| self.history.model().pairs[of.pair].bodies.contains(&Some(girder)));
        let most = on.filter_map(|of| Some((of.pair, of.most().filter(|most| most.value > 0.0)?)));
        most.reduce(|a, b| if b.1.value > a.1.value { b } else { a })
    }

    fn find_poundings(self) -> Vec<Pounding> {
        let mut between: BTreeMap<[SolidId; 2], Vec<&Touch>> = BTreeMap::new();
        // In order of their start.
        for touch in self.touches() {
            let pair = &self.history.model().pairs[touch.pair];
            let solids = pair.solids();
            between.entry(solids).or_default().push(touch);
        }
        let of = |(solids, touches): ([SolidId; 2], Vec<&Touch>)| {
            // The pair of the hardest touch stands for the two bodies; of equals the first.
            let hardest = |a: &'_ Touch, b: &'_ Touch| a.peak_force.total_cmp(&b.peak_force).then(b.pair.cmp(&a.pair));
            let pair = touches.iter().copied().max_by(|a, b| hardest(a, b))?.pair;
            let hits = together(&touches).into_iter().map(|hit| PoundingHit {
                start: hit[0].start,
                end: hit.iter().map(|touch| touch.end).fold(hit[0].end, f64::max),
                peak: self.largest_of_hit(hit, solids),
            });
            Some(Pounding { pair, hits: hits.collect() })
        };
        let mut all: Vec<Pounding> = between.into_par_iter().filter_map(of).collect();
        all.sort_by_key(|of| of.pair);
        all
    }

    fn largest_of_hit(self, hit: &[&Touch], solids: [SolidId; 2]) -> Extreme {
        // The force of one contact is all there is.
        if let [touch] = hit {
            return Extreme { value: touch.peak_force, t: touch.peak_time };
        }
        // A contact touches once at a time, but for hits without length: at `t` in the last of its touches that have begun.
        let mut of_contact: BTreeMap<usize, Vec<&Touch>> = BTreeMap::new();
        let lasting = hit.iter().filter(|touch| touch.end > touch.start);
        lasting.for_each(|touch| of_contact.entry(touch.contact).or_default().push(touch));
        let touches = |own: &[&Touch], t: f64| {
            let begun = own.partition_point(|touch| touch.start <= t);
            begun.checked_sub(1).is_some_and(|last| t <= own[last].end)
        };
        let sum = |t: f64| {
            let touching = of_contact.iter().filter(|(_, own)| touches(own, t));
            let force =
                |contact| Some(self.history.contacts().contact_at(contact, t)?.force * self.sign(contact, solids)?);
            touching.filter_map(|(&contact, _)| force(contact)).sum::<DVec3>().length()
        };
        peaks::largest(&looks_in_hit(self.history, hit), &sum)
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
