//! Touches and their peaks, found from the states that the run left and the forces at any time.

use rayon::prelude::*;

use super::view::Hits;
use crate::contact::Mode;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::sim::report::Extreme;
use crate::sim::{History, Touch, impact, peaks};

/// Looks per step of an integrator when a peak is searched; a step is short against the contact's period. Chosen: with six, and a search
/// about the highest alone, the peaks of 1000 colliding girders print alike.
const LOOKS: usize = 3;

impl<'a> Hits<'a> {
    /// All touches, ordered by their start.
    pub fn touches(self) -> &'a [Touch] {
        let history = self.history;
        history.found.touches.get_or_init(|| match history.impact() {
            Some(record) => impact::touches::of(history, record),
            None => find(history),
        })
    }

    /// The touch with the largest force; of the impact model one that lasts, if there is one.
    pub(in crate::sim) fn strongest(self) -> Option<&'a Touch> {
        // Of equals the first.
        let touches = self.touches().iter().filter(|touch| self.history.impact().is_none() || touch.peak_force > 0.0);
        touches.rev().max_by(|a, b| a.peak_force.total_cmp(&b.peak_force))
    }

    /// The hardest touch: that of the largest force, of the impact model that of the largest impulse.
    pub fn hardest(self) -> Option<&'a Touch> {
        // Of equals the first; an impulse outweighs every force that takes its time.
        let size = |touch: &Touch| (touch.impulse, touch.peak_force);
        let heavier = |a: &&Touch, b: &&Touch| {
            let (a, b) = (size(a), size(b));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        };
        self.touches().iter().rev().max_by(heavier)
    }
}

/// Every touch of every contact, by start, then by contact. Contacts are searched in parallel, each for itself.
fn find(history: &History) -> Vec<Touch> {
    let contacts = (0..history.model().sites.len()).into_par_iter();
    let mut all: Vec<Touch> = contacts.flat_map_iter(|contact| of_contact(history, contact)).collect();
    all.sort_by(|a, b| a.start.total_cmp(&b.start).then(a.contact.cmp(&b.contact)));
    all
}

fn of_contact(history: &History, contact: usize) -> Vec<Touch> {
    let states: Vec<(f64, Contact)> = history.trajectories.log(contact).states().collect();
    let site = &history.model().sites[contact];
    let (pair, bodies) = (site.pair, [site.node_body, site.face_body]);
    let sound =
        bodies.into_iter().flatten().map(|body| history.seats().sound_until(body)).fold(history.end(), f64::min);
    let mut touches: Vec<Touch> = Vec::new();
    let mut open = true;
    for (i, (from, state)) in states.iter().enumerate().filter(|(_, (t, _))| *t <= sound) {
        let Contact::Closed(closed) = state else {
            open = true;
            continue;
        };
        let until = states.get(i + 1).map_or(sound, |(t, _)| t.min(sound));
        if open {
            touches.push(Touch {
                pair,
                contact,
                start: *from,
                end: until,
                peak_time: *from,
                peak_force: 0.0,
                impulse: 0.0,
                stick: 0.0,
                slip: 0.0,
            });
            open = false;
        }
        if let Some(touch) = touches.last_mut() {
            touch.end = until;
            match closed.mode {
                Mode::Stick { .. } => touch.stick += until - from,
                Mode::Slip { .. } => touch.slip += until - from,
            }
            let most = peak(history, contact, *from, until);
            if most.value > touch.peak_force {
                (touch.peak_time, touch.peak_force) = (most.t, most.value);
            }
        }
    }
    touches
}

/// Largest force of a contact in one state, and when.
fn peak(history: &History, contact: usize, from: f64, until: f64) -> Extreme {
    let force = |t: f64| history.contacts().contact(contact, t.min(until)).map_or(0.0, |now| now.force.length());
    peaks::largest(&in_order(looks_in_state(history, contact, from, until)), &force)
}

/// Times at which the forces of a hit are looked at: the beginning of every state of every contact, and in every step.
pub(in crate::sim) fn looks_in_hit(history: &History, hit: &[&Touch]) -> Vec<f64> {
    if history.impact().is_some() {
        let of_touch = |touch: &&Touch| impact::touches::looks(touch.start, touch.end).chain([touch.peak_time]);
        return in_order(hit.iter().flat_map(of_touch).collect());
    }
    let of_touch = |touch: &&Touch| {
        let log = history.trajectories.log(touch.contact);
        let starts = log.beginnings(touch.start, touch.end);
        let ends = starts.iter().copied().skip(1).chain([touch.end]).collect::<Vec<_>>();
        let looks = starts.iter().zip(&ends).map(|(&from, &until)| looks_in_state(history, touch.contact, from, until));
        looks.flatten().collect::<Vec<f64>>()
    };
    in_order(hit.iter().flat_map(of_touch).collect())
}

/// Times in rising order, each once: two bodies of one island have the same steps, and a look taken twice would hide the hump on its far
/// side.
fn in_order(mut times: Vec<f64>) -> Vec<f64> {
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// Times at which the force of a contact in one state is looked at, in no order.
fn looks_in_state(history: &History, contact: usize, from: f64, until: f64) -> Vec<f64> {
    let mut times = vec![from];
    let site = &history.model().sites[contact];
    for body in [site.node_body, site.face_body].into_iter().flatten() {
        for span in history.trajectories.path(body).spans_after(from).take_while(|span| span.from < until) {
            let (a, b) = (span.from.max(from), span.until.min(until));
            times.extend((0..LOOKS).map(|i| a + (b - a) * (i as f64 + 0.5) / LOOKS as f64));
        }
    }
    // Just inside: at its very end the next state begins.
    times.push(until - (until - from) * 1e-9);
    times
}
