//! The first overlap of two bodies that no contact carries, and the deepest.
//!
//! Let d be the separation of two bodies, negative where they overlap, and c the deepest penetration of a closed contact
//! between them. In the intervals in which contacts do not watch all that can meet ([`unwatched`]), the excess `−d − c` is
//! sought where it is above the least depth ε that counts. While none of their contacts is closed, d changes no faster
//! than the two bodies move, `v₁ + v₂`, each of its farthest corner: after a sample with separation d the next one is due once they may
//! have moved `max(d, 0) + ε` (conservative advancement, over as many steps of the integrator as that takes, each with bounds of its
//! own), by the bound on their speed or by their speed at that time and the bound on their acceleration, so that no overlap deeper than ε
//! lies between. Where
//! bodies stand against each other or pass within ε, that would take samples without end: the time is not less than that in
//! which d changes by [`RESOLVED`], or a part of the present stretch where that is shorter, and nothing deeper than
//! [`RESOLVED`] lies between. While a contact is closed, samples are taken at the ends and in the middle of the integrator's
//! steps, which resolve the contact's motion. Of a node that is not watched d is the separation from the other body.

use super::motion::{bound, speed};
use super::solid::{Joined, NodeInPlan, Solids};
use super::unwatched::{self, Interval, Turned, Unwatched, united};
use crate::contact::locate;
use crate::dynamics::penalty3d::constants::UNCARRIED;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::sim::History;
use crate::sim::peaks::golden;
use crate::sim::readings::before_face;
use crate::sim::report::{Extreme, Overlap};

/// Overlap, in parts of the smallest side of either body, from which it counts: thousands of times what the closing
/// search and the impact model leave over, and far below what a picture shows.
const COUNTS: f64 = 2.0 * UNCARRIED;
/// Depth, in parts of the smallest side of either body, that is not missed while bodies are nearer than their motion resolves.
/// Chosen: a hundred samples over the way of that side.
const RESOLVED: f64 = 1e-2;
/// Least samples of a stretch in which bodies stay nearer than their motion resolves.
const STRETCH_SAMPLES: f64 = 16.0;
/// Samples of an interval after which the rest has as many again, evenly spaced: seconds of work. Two bodies of a metre that stay nearer than
/// their motion resolves have gone 10 km by then. Chosen; beyond it less is seen, and such speeds are outside the domain.
const MOST_SAMPLES: u32 = 1_000_000;
/// Samples of a step with a closed contact.
const CLOSED_STEP_SAMPLES: f64 = 2.0;
/// Most halvings by which the first instant is found between two samples.
const HALVINGS: usize = 48;

/// Two bodies that may meet, and the contacts between them.
struct Meeting<'a> {
    history: &'a History,
    solids: &'a Solids,
    pair: [usize; 2],
    contacts: Vec<usize>,
    /// Depth that counts \[m\].
    least: f64,
    /// Depth that is not missed between two samples \[m\].
    resolved: f64,
}

/// Bodies or node that an interval is searched for.
#[derive(Clone, Copy, Debug)]
enum Followed {
    /// Two bodies.
    Bodies,
    /// The node of a contact, against the body of its face.
    Node(usize),
}

/// Separation and excess at one time \[m\].
#[derive(Clone, Copy, Debug)]
struct Sample {
    t: f64,
    separation: f64,
    excess: f64,
    /// Whether a contact between the two is closed and carries.
    carried: bool,
    /// Whether a node is in front of its face again, and watched.
    watched: bool,
    /// Whether a node is beyond the back of the body of its face: a girder that reaches through a wall has no node in it.
    beyond: bool,
}

/// Bound on how fast two bodies come nearer.
#[derive(Clone, Copy, Debug)]
struct Approach {
    /// From when to when it holds \[s\].
    from: f64,
    until: f64,
    /// \[m/s\]
    speed: f64,
    /// \[m/s²\]
    acceleration: f64,
}

/// Intervals in which the excess counts, and the time at which it is deepest.
#[derive(Clone, Debug)]
struct Found {
    intervals: Vec<Interval>,
    deepest: Extreme,
    followed: Followed,
}

/// The overlap of two bodies that no contact carries; `None` where there is none.
pub(super) fn first(
    history: &History,
    solids: &Solids,
    (joined, turned): (&Joined, &Turned),
    pair: [usize; 2],
) -> Option<Overlap> {
    let facing = joined.facing(pair.map(|number| solids.id(number)));
    let contacts = facing.iter().flat_map(|&number| history.model().pairs[number].nodes()).collect();
    let side = solids.least_side(pair);
    let meeting = Meeting { history, solids, pair, contacts, least: COUNTS * side, resolved: RESOLVED * side };
    let sought = match facing {
        _ if facing.iter().any(|&number| history.model().pairs[number].met) => {
            vec![(Followed::Bodies, vec![[0.0, history.end()]])]
        }
        [] => vec![(Followed::Bodies, vec![[0.0, history.end()]])],
        _ => facing.iter().flat_map(|&number| meeting.left_by(number, turned)).collect(),
    };
    let found: Vec<Found> = sought
        .iter()
        .flat_map(|(followed, intervals)| intervals.iter().filter_map(|&i| meeting.within(*followed, i)))
        .collect();
    let intervals = united(found.iter().flat_map(|found| found.intervals.iter().copied()).collect());
    let deepest = found.into_iter().max_by(|a, b| a.deepest.value.total_cmp(&b.deepest.value))?;
    Some(meeting.overlap(intervals, &deepest))
}

/// The intervals of two searches, and the deeper of them.
fn deeper(one: Option<Found>, other: Option<Found>) -> Option<Found> {
    match (one, other) {
        (Some(mut one), Some(mut other)) => {
            if other.deepest.value > one.deepest.value {
                std::mem::swap(&mut one, &mut other);
            }
            one.intervals.extend(other.intervals);
            Some(one)
        }
        (one, other) => one.or(other),
    }
}

impl Meeting<'_> {
    /// Bodies or nodes of facing pair `number` to search, and their intervals.
    fn left_by(&self, number: usize, turned: &Turned) -> Vec<(Followed, Vec<Interval>)> {
        match unwatched::of_pair(self.history, number, turned) {
            Unwatched::Bodies(intervals) => vec![(Followed::Bodies, intervals)],
            Unwatched::Nodes(nodes) => {
                nodes.into_iter().map(|(contact, intervals)| (Followed::Node(contact), intervals)).collect()
            }
        }
    }

    /// Intervals in which the excess counts, and the time at which it is deepest; `None` where it never counts.
    fn within(&self, followed: Followed, [from, until]: Interval) -> Option<Found> {
        let mut found: Option<Found> = None;
        let mut before = self.sample(followed, from);
        let mut bounds = self.bounds(from);
        let (mut since, mut taken) = (self.counts(&before).then_some(from), 0);
        let seen = |found: &mut Option<Found>, sample: &Sample| {
            let deepest = Extreme { value: sample.excess, t: sample.t };
            let so_far = found.get_or_insert_with(|| Found { intervals: Vec::new(), deepest, followed });
            if deepest.value > so_far.deepest.value {
                so_far.deepest = deepest;
            }
        };
        loop {
            if self.counts(&before) {
                seen(&mut found, &before);
            }
            if before.t >= until || before.watched || before.beyond {
                break;
            }
            let mut next;
            (next, bounds) = self.next(&before, bounds, until);
            taken += 1;
            if taken > MOST_SAMPLES {
                next = next.max(before.t + (until - from) / f64::from(MOST_SAMPLES)).min(until);
            }
            let after = self.sample(followed, next);
            match (since, self.counts(&after)) {
                (None, true) => since = Some(self.change(followed, [before.t, after.t])[1]),
                (Some(from), false) => {
                    since = None;
                    let [last, until] = self.change(followed, [before.t, after.t]);
                    // Where a contact closes the excess ends at its deepest.
                    let last = self.sample(followed, last);
                    if self.counts(&last) {
                        seen(&mut found, &last);
                    }
                    if let Some(found) = &mut found {
                        found.intervals.push([from, until]);
                    }
                }
                _ => {}
            }
            before = after;
        }
        let last = since.map(|from| [from, before.t]);
        if let Some(found) = &mut found {
            found.intervals.extend(last);
        }
        if before.beyond && before.t < until {
            return deeper(found, self.within(Followed::Bodies, [before.t, until]));
        }
        found
    }

    /// Whether an excess is above the least depth.
    fn counts(&self, sample: &Sample) -> bool {
        sample.excess > self.least
    }

    fn sample(&self, followed: Followed, t: f64) -> Sample {
        let (history, solids) = (self.history, self.solids);
        match followed {
            Followed::Bodies => {
                let separation = solids.separation(self.pair, &solids.placed(history, self.pair, t));
                // Apart, nothing has to be carried.
                let carried = if separation < 0.0 { self.carried(t) } else { None };
                let excess = -separation - carried.unwrap_or(0.0);
                Sample { t, separation, excess, carried: carried.is_some(), watched: false, beyond: false }
            }
            Followed::Node(contact) => {
                let NodeInPlan { separation, gap, before_back } = solids.node(history, self.pair, contact, t);
                // A node that has handed on its contact at a shared vertex is in the body no deeper than the one that took over.
                let carried = if separation < 0.0 { self.carried(t) } else { None };
                let excess = -separation - carried.unwrap_or(0.0);
                Sample {
                    t,
                    separation,
                    excess,
                    carried: carried.is_some(),
                    watched: gap > self.least,
                    beyond: before_back < self.least,
                }
            }
        }
    }

    /// Deepest penetration of a closed contact between the two bodies \[m\]; `None` where all are open.
    fn carried(&self, t: f64) -> Option<f64> {
        let closed = |&contact: &usize| matches!(self.history.trajectories.log(contact).at(t), Contact::Closed(_));
        let depth = |contact: usize| {
            let site = &self.history.model().sites[contact];
            let [node, face] = self.history.trajectories.sides(contact, t);
            // An edge node carries what overlaps at its crossing, and a corner that took over displaced along its normal what the corner
            // itself is behind its face.
            let gap = match &site.edge {
                Some(edge) => edge.distance(&node, &face),
                None => Some(locate(&site.geometry, &node, &face).gap),
            };
            gap.map_or(f64::NEG_INFINITY, |gap| -gap).max(-before_face(self.history, contact, t)[0])
        };
        self.contacts.iter().copied().filter(closed).map(depth).reduce(f64::max)
    }

    /// Bound on how fast the two bodies come nearer, from `t` on.
    fn bounds(&self, t: f64) -> Approach {
        let girders = self.pair.into_iter().filter_map(|number| Some((self.solids.body(number)?, number)));
        let bounds = girders.map(|(girder, number)| bound(self.history, girder, self.solids.radius(number), t));
        let still = Approach { from: t, until: f64::INFINITY, speed: 0.0, acceleration: 0.0 };
        bounds.fold(still, |both, one| Approach {
            until: both.until.min(one.until),
            speed: both.speed + one.speed,
            acceleration: both.acceleration + one.acceleration,
            ..both
        })
    }

    /// Time of the next sample, at most `end` \[s\], and the bounds that hold before it. `bounds` are those before this one.
    fn next(&self, now: &Sample, mut bounds: Approach, end: f64) -> (f64, Approach) {
        // Way by which the bodies can come nearer before an overlap counts.
        let (mut t, mut left) = (now.t, now.separation.max(0.0) + self.least);
        loop {
            if bounds.until <= t {
                bounds = self.bounds(t);
            }
            let until = bounds.until.min(end);
            let way = bounds.speed * (until - t);
            if now.carried || way >= left || until >= end {
                break;
            }
            (t, left) = (until, left - way);
        }
        let until = bounds.until.min(end);
        let window = until - bounds.from;
        // In this time the separation changes by `resolved` at the most.
        let resolving = (self.resolved / bounds.speed).min(window / STRETCH_SAMPLES);
        let step = if now.carried {
            window / CLOSED_STEP_SAMPLES
        } else {
            (left / bounds.speed).max(self.least_time(t, left, bounds.acceleration)).max(resolving)
        };
        // A window may be shorter than the spacing of times.
        ((t + step).min(until).max(now.t.next_up()), bounds)
    }

    /// Time that the bodies take for a way `left` \[m\] at the least, by their speed v at `t` and their acceleration, a at the most \[s\]:
    /// `v τ + a τ²/2` is the way.
    fn least_time(&self, t: f64, left: f64, acceleration: f64) -> f64 {
        if !acceleration.is_finite() {
            return 0.0;
        }
        let girders = self.pair.into_iter().filter_map(|number| Some((self.solids.body(number)?, number)));
        let speeds = girders.map(|(girder, number)| speed(self.history, girder, self.solids.radius(number), t));
        let now: f64 = speeds.sum();
        2.0 * left / (now + (now * now + 2.0 * acceleration * left).sqrt())
    }

    /// Time at which the excess begins or ceases to count between two samples of which one counts: the last time before and the first after
    /// \[s\].
    fn change(&self, followed: Followed, [mut before, mut after]: Interval) -> Interval {
        let counts = |t| self.counts(&self.sample(followed, t));
        let at_first = counts(before);
        for _ in 0..HALVINGS {
            let middle = before.midpoint(after);
            if middle <= before || middle >= after {
                break;
            }
            if counts(middle) == at_first { before = middle } else { after = middle }
        }
        [before, after]
    }

    fn overlap(&self, intervals: Vec<Interval>, &Found { deepest, followed, .. }: &Found) -> Overlap {
        let (history, solids) = (self.history, self.solids);
        let (next, _) = self.next(&self.sample(followed, deepest.t), self.bounds(deepest.t), history.end());
        let step = next - deepest.t;
        let around = [(deepest.t - step).max(intervals[0][0]), (deepest.t + step).min(history.end())];
        let most = golden(&|t| self.sample(followed, t).excess, around[0], around[1]);
        let depth = if most.value > deepest.value { most } else { deepest };
        let place = solids.shared(self.pair, &solids.placed(history, self.pair, depth.t));
        Overlap { bodies: self.pair.map(|number| solids.id(number)), intervals, depth, place }
    }
}
