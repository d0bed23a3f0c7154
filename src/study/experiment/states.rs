//! The six states (Fig. 13) of a girder over time, under either model.
//!
//! The impact model has them itself. Of the contact model they are read off its contacts: nothing pressed is a or b, one end of
//! a face c or d, both ends e or f; any contact that slides makes the state a sliding one.

use serde::{Deserialize, Serialize};

use crate::sim::{ContactNow, ContactState, GirderState, History};

/// Rotation \[rad\] and its rate \[rad/s\] below which a girder counts as not turning: what rounding leaves of a girder that is
/// hit symmetrically is 1e-12 and less.
const TURNING: f64 = 1e-9;
/// Points of contact farther apart than this part of the width of the girder are both ends of its face.
const APART: f64 = 0.5;

/// A state from one change to the next.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stretch {
    /// From \[s\].
    pub from: f64,
    /// Until \[s\].
    pub until: f64,
    /// The paper's letter, a to f.
    pub letter: char,
}

impl Stretch {
    /// \[s\]
    pub fn length(&self) -> f64 {
        self.until - self.from
    }
}

/// States of a girder in order of time, without gaps.
pub(super) fn stretches(history: &History, girder: usize) -> Vec<Stretch> {
    let mut times: Vec<f64> = match history.impact() {
        Some(record) => record.transitions.iter().filter(|change| change.body == girder).map(|c| c.t).collect(),
        None => history.events().iter().map(|event| event.t).collect(),
    };
    times.extend([0.0, history.end()]);
    times.sort_by(f64::total_cmp);
    times.dedup();
    let mut all: Vec<Stretch> = Vec::new();
    for pair in times.windows(2) {
        let (from, until) = (pair[0], pair[1]);
        let letter = state(history, girder, f64::midpoint(from, until)).letter();
        match all.last_mut() {
            Some(last) if last.letter == letter => last.until = until,
            _ => all.push(Stretch { from, until, letter }),
        }
    }
    all
}

fn state(history: &History, girder: usize, t: f64) -> GirderState {
    if let Some(record) = history.impact() {
        return record.state(girder, t);
    }
    let site = |now: &&ContactNow| {
        let site = &history.model().sites[now.contact];
        [site.node_body, site.face_body].contains(&Some(girder))
    };
    let all = history.contacts().at(t);
    let own: Vec<&ContactNow> = all.iter().filter(site).collect();
    let motion = history.motion(girder, t);
    let turning = motion.theta.abs().max(motion.spin.z.abs()) > TURNING;
    of_contacts(&own, turning, APART * history.scene().girders[girder].width)
}

/// The state that contacts of one girder amount to.
fn of_contacts(contacts: &[&ContactNow], turning: bool, apart: f64) -> GirderState {
    let slides = contacts.iter().any(|now| now.state == ContactState::Slip);
    let distance = |a: &&ContactNow, b: &&ContactNow| a.point.truncate().distance(b.point.truncate());
    let flush = contacts.iter().any(|a| contacts.iter().any(|b| distance(a, b) > apart));
    match (contacts.is_empty(), flush, slides) {
        (true, ..) if turning => GirderState::FreeTurning,
        (true, ..) => GirderState::Free,
        (_, true, true) => GirderState::Sliding,
        (_, true, false) => GirderState::Resting,
        (_, false, true) => GirderState::SlidingTurning,
        (_, false, false) => GirderState::Turning,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn now(y: f64, state: ContactState) -> ContactNow {
        let zero = DVec3::ZERO;
        ContactNow {
            contact: 0,
            pair: 0,
            state,
            point: DVec3::new(0.0, y, 0.0),
            anchor: zero,
            normal: DVec3::X,
            penetration: 0.0,
            normal_velocity: 0.0,
            sliding: zero,
            normal_force: 1.0,
            tangential_force: zero,
            normal_damping: 0.0,
            tangential_damping: zero,
            force: zero,
            couple: zero,
            mu_static: 0.2,
            mu_kinetic: 0.15,
        }
    }

    #[test]
    fn contacts_amount_to_the_six_states() {
        let (left, right) = (now(0.035, ContactState::Slip), now(-0.035, ContactState::Stick));
        let (beside, held) = (now(0.034, ContactState::Stick), now(0.035, ContactState::Stick));
        let letter = |contacts: &[&ContactNow], turning| of_contacts(contacts, turning, 0.035).letter();
        assert_eq!([letter(&[], true), letter(&[], false)], ['a', 'b'], "free");
        assert_eq!([letter(&[&left], true), letter(&[&right], true)], ['c', 'd'], "one end");
        assert_eq!([letter(&[&left, &right], true), letter(&[&held, &right], true)], ['e', 'f'], "both ends");
        assert_eq!(letter(&[&held, &beside], true), 'd', "two corners side by side are one end");
    }
}
