//! Times at which the contacts of a facing pair do not limit all overlaps of its bodies.
//!
//! Let every node of one body's end be in front of the plane of the other's face, or closed against it. Then the whole body
//! is in front of that plane but for the depth of its closed contacts, since its far end lies behind its near one as long as
//! neither body has turned far ([`MOST_TURNED`]): what overlaps is carried. So nothing has to be sought while this holds for one
//! of the two faces. In plan, where it holds for neither, two ends that overlap have a node of one inside the other: nodes that
//! are not watched are followed alone. A contact ceases to watch when its node crosses the plane beside the face, leaves the face over an
//! edge, or starts behind it; from then on its state is "disarmed" until it closes or opens again.

use std::sync::OnceLock;

use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::trajectory::stored_path::StoredMotion;
use crate::scene::Kind;
use crate::sim::History;
use crate::sim::overlap::motion::turns;

/// Largest rotation of a body up to which the far end of a girder is taken to lie behind its near end, seen from the face
/// before it \[rad\]: a skew of 20° leaves 0.35 rad.
const MOST_TURNED: f64 = 0.3;

/// An interval of time \[s\].
pub(super) type Interval = [f64; 2];

/// Bodies or nodes whose overlap the contacts of a facing pair do not limit.
#[derive(Debug, PartialEq)]
pub(super) enum Unwatched {
    /// The two bodies, in these intervals.
    Bodies(Vec<Interval>),
    /// Nodes beside the other body, each by its contact and in its intervals: in plan what overlaps has a node inside.
    Nodes(Vec<(usize, Vec<Interval>)>),
}

/// Bodies or nodes to search of facing pair `number`.
pub(super) fn of_pair(history: &History, number: usize, turned: &Turned) -> Unwatched {
    let whole = || Unwatched::Bodies(vec![[0.0, history.end()]]);
    let model = history.model();
    let pair = &model.pairs[number];
    if pair.bodies.into_iter().flatten().any(|body| turned.far(history, body)) {
        return whole();
    }
    let nodes = match model.kind {
        Kind::Planar => 2,
        Kind::Spatial => 4,
    };
    let of_girder = |body| {
        let own = pair.sites.clone().filter(|&contact| model.sites[contact].node_body == Some(body));
        own.collect::<Vec<usize>>()
    };
    let views: Vec<Vec<usize>> = pair.bodies.into_iter().flatten().map(of_girder).collect();
    let complete = views.iter().filter(|contacts| contacts.len() == nodes);
    let intervals =
        complete.map(|contacts| united(contacts.iter().flat_map(|&contact| disarmed(history, contact)).collect()));
    let Some(intervals) = intervals.reduce(|one, other| common(&one, &other)) else { return whole() };
    if intervals.is_empty() || model.kind == Kind::Spatial {
        return Unwatched::Bodies(intervals);
    }
    // Not united: each ends where the node is in front of its face again.
    let of_node = |contact: usize| (contact, common(&disarmed(history, contact), &intervals));
    Unwatched::Nodes(pair.sites.clone().map(of_node).filter(|(_, intervals)| !intervals.is_empty()).collect())
}

/// Intervals in which a contact is disarmed; under the impact model those in which its point is beside its face.
fn disarmed(history: &History, contact: usize) -> Vec<Interval> {
    if let Some(record) = history.impact() {
        return record.beside(contact).collect();
    }
    let states = || history.trajectories.log(contact).states();
    let ends = states().map(|(from, _)| from).skip(1).chain([history.end()]);
    let off = |((from, state), until): ((f64, Contact), f64)| {
        (state == Contact::Open { armed: false }).then_some([from, until.min(history.end())])
    };
    states().zip(ends).filter_map(off).collect()
}

/// For each body whether it turns far, as far as it was asked for.
#[derive(Debug)]
pub(super) struct Turned(Vec<OnceLock<bool>>);

impl Turned {
    pub(super) fn of(history: &History) -> Self {
        Self(history.model().bodies.iter().map(|_| OnceLock::new()).collect())
    }

    fn far(&self, history: &History, body: usize) -> bool {
        *self.0[body].get_or_init(|| turns_far(history, body))
    }
}

/// Whether a body is turned by more than [`MOST_TURNED`] where one of its segments begins.
fn turns_far(history: &History, body: usize) -> bool {
    let (path, own) = (history.trajectories.path(body), &history.model().bodies[body]);
    if !turns(own) {
        return false;
    }
    let turned = |t: f64| {
        let (theta, attitude) = own.attitude(&history.state(body, t));
        theta.abs().max(attitude.to_axis_angle().1)
    };
    let swept = 2.0 * (0.5 * path.swept().chord).min(1.0).asin();
    swept > MOST_TURNED
        || (0..path.len()).any(|number| match path.motion_of(number) {
            // In plan, read without flying there.
            (_, StoredMotion::Start(state)) => state[2].abs() > MOST_TURNED,
            (_, StoredMotion::Recomputed(_)) => false,
            (from, _) => turned(from) > MOST_TURNED,
        })
        || turned(history.end()) > MOST_TURNED
}

/// The union of intervals, in order of time.
pub(super) fn united(mut intervals: Vec<Interval>) -> Vec<Interval> {
    intervals.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut all: Vec<Interval> = Vec::new();
    for [from, until] in intervals {
        match all.last_mut() {
            Some(last) if from <= last[1] => last[1] = last[1].max(until),
            _ => all.push([from, until]),
        }
    }
    all
}

/// Intersection of two lists of disjoint intervals in order of time.
pub(super) fn common(one: &[Interval], other: &[Interval]) -> Vec<Interval> {
    let both = one.iter().flat_map(|a| other.iter().map(move |b| [a[0].max(b[0]), a[1].min(b[1])]));
    both.filter(|[from, until]| from < until).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_united_where_they_meet_and_shared_where_both_are() {
        let one = united(vec![[3.0, 4.0], [0.0, 1.0], [1.0, 2.0], [0.5, 0.7]]);
        assert_eq!(one, [[0.0, 2.0], [3.0, 4.0]]);
        assert_eq!(common(&one, &[[1.5, 3.5], [3.7, 9.0]]), [[1.5, 2.0], [3.0, 3.5], [3.7, 4.0]]);
        assert_eq!(common(&one, &[]), Vec::<Interval>::new());
    }
}
