//! Log of a run of the impact model: hits, changes of state, intervals of lasting contact.

use std::sync::OnceLock;

use glam::DVec2;

use crate::dynamics::impact2d::impulse::collision::HitImpulses;
use crate::dynamics::impact2d::lasting::constrained_motion::ContactMode;
use crate::dynamics::impact2d::state::GirderState;
use crate::dynamics::impact2d::tables::Row;

/// A hit of a pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit {
    /// \[s\].
    pub t: f64,
    /// The pair, its number in the model.
    pub pair: usize,
    /// The declared contacts that touched: one at a corner, the two outermost of a face.
    pub sites: Vec<usize>,
    /// Point of action of the first impulse, world \[m\].
    pub point: DVec2,
    /// Impulses, and the energy that they took.
    pub impulses: HitImpulses,
    /// State of the first side's girder before.
    pub from: GirderState,
    /// Its state after the hit.
    pub to: GirderState,
    /// The row of Tables 8–10; none for hits that the tables do not cover.
    pub row: Option<Row>,
}

impl Hit {
    /// Whether a whole face was hit.
    pub fn is_flush(&self) -> bool {
        self.sites.len() > 1
    }
}

/// A girder goes from one state to another, with a hit or without.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transition {
    /// \[s\].
    pub t: f64,
    /// The girder, its number in the model.
    pub body: usize,
    /// The pair that decided, where there is one.
    pub pair: Option<usize>,
    /// Before.
    pub from: GirderState,
    /// After.
    pub to: GirderState,
    /// The row of Tables 4–10.
    pub row: Option<Row>,
    /// Energy lost besides hits, in coming to rest below the stop speed \[J\].
    pub lost: f64,
}

/// Bodies in lasting contact, between two changes of any contact mode.
#[derive(Clone, Debug, PartialEq)]
pub struct LastingInterval {
    /// \[s\].
    pub from: f64,
    /// \[s\].
    pub until: f64,
    /// The girders, numbers in the model, rising.
    pub bodies: Vec<usize>,
    /// Contact modes.
    pub modes: Vec<ContactMode>,
}

/// Log of one run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImpactRecord {
    /// Hits in order of time.
    pub hits: Vec<Hit>,
    /// Changes of state in order of time; each girder's first is its state at the start.
    pub transitions: Vec<Transition>,
    /// Intervals of lasting contact in order of their start.
    pub lasting: Vec<LastingInterval>,
    /// Declared contacts, numbers in the model, with stretches in which their point is behind the plane of the face beside it and hits
    /// nothing \[s\].
    pub beside: Vec<(usize, [f64; 2])>,
    /// Time reached \[s\].
    pub end: f64,
    /// Index of the lists; made on first use of a finished log.
    index: Index,
}

/// Numbers of changes of state by girder, and of lasting intervals by the first of their girders, which is in one at a time: both rising.
#[derive(Clone, Debug, Default)]
struct Index(OnceLock<[Vec<Vec<usize>>; 2]>);

/// It follows from the lists.
impl PartialEq for Index {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl ImpactRecord {
    /// Memory of its lists \[bytes\], each hit and each interval with what a pair of contacts takes besides.
    pub fn bytes(&self) -> usize {
        let hits = self.hits.len() * (size_of::<Hit>() + 2 * size_of::<usize>());
        let lasting =
            self.lasting.len() * (size_of::<LastingInterval>() + 2 * size_of::<usize>() + 2 * size_of::<ContactMode>());
        hits + lasting + size_of_val(&*self.transitions) + size_of_val(&*self.beside)
    }

    /// Stretches in which the point of a declared contact is beside its face, in order of time \[s\].
    pub fn beside(&self, site: usize) -> impl Iterator<Item = [f64; 2]> {
        self.beside.iter().filter(move |(number, _)| *number == site).map(|(_, stretch)| *stretch)
    }

    /// State of a girder at `t` \[s\].
    pub fn state(&self, body: usize, t: f64) -> GirderState {
        let [of_body, _] = self.index();
        let own = of_body.get(body).map_or(&[][..], Vec::as_slice);
        let until = own.partition_point(|&number| self.transitions[number].t <= t);
        own[..until].last().map_or(GirderState::Free, |&number| self.transitions[number].to)
    }

    fn index(&self) -> &[Vec<Vec<usize>>; 2] {
        fn enter(lists: &mut Vec<Vec<usize>>, body: usize, number: usize) {
            lists.resize_with(lists.len().max(body + 1), Vec::new);
            lists[body].push(number);
        }
        self.index.0.get_or_init(|| {
            let [mut changes, mut intervals] = [Vec::new(), Vec::new()];
            self.transitions.iter().enumerate().for_each(|(i, change)| enter(&mut changes, change.body, i));
            for (i, interval) in self.lasting.iter().enumerate() {
                if let Some(&body) = interval.bodies.first() {
                    enter(&mut intervals, body, i);
                }
            }
            [changes, intervals]
        })
    }

    /// Lasting contacts at `t` \[s\].
    pub fn lasting_at(&self, t: f64) -> impl Iterator<Item = &LastingInterval> {
        let [_, of_first] = self.index();
        let lasts =
            move |interval: &&LastingInterval| t < interval.until || (t >= self.end && interval.until >= self.end);
        let last = move |own: &Vec<usize>| {
            let started = own.partition_point(|&number| self.lasting[number].from <= t);
            started.checked_sub(1).map(|last| &self.lasting[own[last]])
        };
        of_first.iter().filter_map(last).filter(lasts)
    }

    /// The logs of all groups in one, in order of time, up to `end` \[s\].
    #[must_use]
    pub fn together(records: Vec<Self>, end: f64) -> Self {
        let mut all = Self { end, ..Self::default() };
        for record in records {
            let cut = |(site, [from, until]): (usize, [f64; 2])| (site, [from, until.min(end)]);
            all.beside.extend(record.beside.into_iter().filter(|(_, [from, _])| *from < end).map(cut));
            all.hits.extend(record.hits.into_iter().filter(|hit| hit.t <= end));
            all.transitions.extend(record.transitions.into_iter().filter(|change| change.t <= end));
            let cut = |interval: LastingInterval| LastingInterval { until: interval.until.min(end), ..interval };
            all.lasting.extend(record.lasting.into_iter().filter(|interval| interval.from < end).map(cut));
        }
        all.hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        all.transitions.sort_by(|a, b| a.t.total_cmp(&b.t));
        all.lasting.sort_by(|a, b| a.from.total_cmp(&b.from));
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn change(t: f64, body: usize, to: GirderState) -> Transition {
        Transition { t, body, pair: None, from: GirderState::Free, to, row: None, lost: 0.0 }
    }

    fn interval(from: f64, until: f64) -> LastingInterval {
        LastingInterval { from, until, bodies: vec![0], modes: Vec::new() }
    }

    #[test]
    fn the_state_is_that_of_the_last_change_of_the_girder() {
        let transitions = vec![
            change(0.0, 0, GirderState::Free),
            change(1.0, 0, GirderState::Resting),
            change(2.0, 1, GirderState::Sliding),
        ];
        let record = ImpactRecord { transitions, end: 3.0, ..ImpactRecord::default() };
        assert_eq!(record.state(0, 0.5), GirderState::Free, "before the change");
        assert_eq!(record.state(0, 1.0), GirderState::Resting, "at the change");
        assert_eq!(record.state(0, 2.5), GirderState::Resting, "another girder's change");
    }

    #[test]
    fn intervals_are_half_open_but_for_the_end_of_the_run() {
        let record =
            ImpactRecord { lasting: vec![interval(0.0, 1.0), interval(1.0, 2.0)], end: 2.0, ..ImpactRecord::default() };
        let count = |t: f64| record.lasting_at(t).count();
        assert_eq!([count(0.5), count(1.0), count(2.0), count(-0.1)], [1, 1, 1, 0], "one at a time");
    }

    #[test]
    fn logs_of_groups_are_merged_in_order_and_cut_at_the_end() {
        let one = ImpactRecord { lasting: vec![interval(0.5, 3.0), interval(2.5, 3.0)], ..ImpactRecord::default() };
        let other = ImpactRecord {
            transitions: vec![change(0.0, 1, GirderState::Free), change(2.1, 1, GirderState::Free)],
            lasting: vec![interval(0.1, 0.2)],
            ..ImpactRecord::default()
        };
        let all = ImpactRecord::together(vec![one, other], 2.0);
        assert_eq!(all.transitions.len(), 1, "a change after the end");
        let spans: Vec<_> = all.lasting.iter().map(|i| (i.from, i.until)).collect();
        assert_eq!(spans, [(0.1, 0.2), (0.5, 2.0)], "sorted and cut");
    }
}
