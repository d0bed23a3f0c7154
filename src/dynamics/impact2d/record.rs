//! What a run of the impact model leaves beside its paths: hits, transitions, lasting contacts.

use glam::DVec2;

use crate::dynamics::impact2d::impulse::corner::Second;
use crate::dynamics::impact2d::lasting::constrained_motion::Seat;
use crate::dynamics::impact2d::state::{Row, State};

/// A hit of a pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit {
    /// When \[s\].
    pub t: f64,
    /// The pair, its number in the model.
    pub pair: usize,
    /// The declared contacts that touched: one at a corner, the two outermost of a face.
    pub sites: Vec<usize>,
    /// Where the first impulse acted, world \[m\].
    pub point: DVec2,
    /// Unit normal, from the second side towards the first.
    pub normal: DVec2,
    /// `[v_n, v_s]` there before \[m/s\].
    pub approach: [f64; 2],
    /// `ζ` (44), from the middle of the face along `ẑ × normal`; 0 at a corner \[m\].
    pub offset: f64,
    /// `[P_n, P_s]` of the first impulse, on the first side \[N·s\].
    pub first: [f64; 2],
    /// The second impulse, and the declared contact where it acted.
    pub second: Option<(usize, Second)>,
    /// `[P_n, P_s]` of a last impulse along a whole face \[N·s\].
    pub last: Option<[f64; 2]>,
    /// Energy lost \[J\].
    pub lost: f64,
    /// State of the first side's girder before.
    pub from: State,
    /// Its state after the hit.
    pub to: State,
    /// The row of Tables 8–10 that fired; nothing for hits that they do not know.
    pub row: Option<Row>,
}

impl Hit {
    /// `[P_n, P_s]` of all impulses \[N·s\].
    pub fn total(&self) -> [f64; 2] {
        let second = self.second.map_or([0.0; 2], |(_, s)| s.impulse);
        let last = self.last.unwrap_or([0.0; 2]);
        [0, 1].map(|i| self.first[i] + second[i] + last[i])
    }

    /// Whether a whole face was hit.
    pub fn is_flush(&self) -> bool {
        self.sites.len() > 1
    }
}

/// A girder goes from one state to another without a hit, or by one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transition {
    /// When \[s\].
    pub t: f64,
    /// The girder, its number in the model.
    pub body: usize,
    /// The pair that decided, where there is one.
    pub pair: Option<usize>,
    /// Before.
    pub from: State,
    /// After.
    pub to: State,
    /// The row of Tables 4–7 that fired, where no hit did it.
    pub row: Option<Row>,
    /// Energy that coming to rest below the stop speed took \[J\].
    pub lost: f64,
}

/// Bodies in lasting contact, from one change to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Stay {
    /// From \[s\].
    pub from: f64,
    /// Until \[s\].
    pub until: f64,
    /// The girders, numbers in the model, rising.
    pub bodies: Vec<usize>,
    /// What touches, and how.
    pub seats: Vec<Seat>,
}

/// What the impact model did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Hits in order of time.
    pub hits: Vec<Hit>,
    /// Changes of state in order of time; each girder's first is its state at the start.
    pub transitions: Vec<Transition>,
    /// Lasting contacts in order of their start.
    pub stays: Vec<Stay>,
    /// Where the answer ends \[s\].
    pub end: f64,
}

impl Record {
    /// State of a girder at `t` \[s\].
    pub fn state(&self, body: usize, t: f64) -> State {
        let until = self.transitions.partition_point(|change| change.t <= t);
        let last = self.transitions[..until].iter().rev().find(|change| change.body == body);
        last.map_or(State::Free, |change| change.to)
    }

    /// Lasting contacts at `t` \[s\].
    pub fn stays_at(&self, t: f64) -> impl Iterator<Item = &Stay> {
        let started = self.stays.partition_point(|stay| stay.from <= t);
        self.stays[..started].iter().filter(move |stay| t < stay.until || (t >= self.end && stay.until >= self.end))
    }

    /// The records of all groups in one, in order of time, up to `end` \[s\].
    #[must_use]
    pub fn together(records: Vec<Self>, end: f64) -> Self {
        let mut all = Self { end, ..Self::default() };
        for record in records {
            all.hits.extend(record.hits.into_iter().filter(|hit| hit.t <= end));
            all.transitions.extend(record.transitions.into_iter().filter(|change| change.t <= end));
            let cut = |stay: Stay| Stay { until: stay.until.min(end), ..stay };
            all.stays.extend(record.stays.into_iter().filter(|stay| stay.from < end).map(cut));
        }
        all.hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        all.transitions.sort_by(|a, b| a.t.total_cmp(&b.t));
        all.stays.sort_by(|a, b| a.from.total_cmp(&b.from));
        all
    }
}
