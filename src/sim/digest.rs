//! A hash of everything that a run's answer depends on, bit for bit.

use xxhash_rust::xxh3::Xxh3;

use super::History;
use crate::contact::{Mode, NormalLaw};
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::trajectory::stored_path::StoredMotion;

impl History {
    /// Hash of the whole answer, bit for bit.
    pub fn digest(&self) -> u64 {
        digest(self)
    }
}

/// Numbers are handed to the hash in blocks of so many bytes: number by number it keeps a state for each. The hash is the same.
const BLOCK: usize = 4096;

/// Hash of paths, contact states and events. A motion in closed form is kept by its start alone: its state in the middle says how the
/// girder moves from there.
fn digest(history: &History) -> u64 {
    let (mut hash, mut block) = (Xxh3::new(), Vec::with_capacity(BLOCK));
    let mut add = |x: f64| {
        block.extend_from_slice(&x.to_bits().to_le_bytes());
        if block.len() >= BLOCK {
            hash.update(&block);
            block.clear();
        }
    };
    for body in 0..history.model().bodies.len() {
        let path = history.trajectories.path(body);
        for (number, span) in path.spans().enumerate() {
            add(span.from);
            add(span.until);
            let (from, kept) = path.motion_of(number);
            if matches!(kept, StoredMotion::Start(_) | StoredMotion::Flight(_)) && span.from < history.end() {
                let middle = 0.5 * (span.from + span.until.min(history.end()));
                history.state(body, middle).into_iter().for_each(&mut add);
            }
            match kept {
                StoredMotion::Start(state) => std::iter::once(from).chain(state).for_each(&mut add),
                StoredMotion::Flight(flight) => flight.numbers().for_each(&mut add),
                StoredMotion::Slide(slide) => slide.numbers().for_each(&mut add),
                StoredMotion::Step(piece) => piece.numbers().for_each(&mut add),
                StoredMotion::Recomputed(step) => {
                    history.trajectories.stepped(body, (step, from), |piece| piece.numbers().for_each(&mut add));
                }
            }
        }
    }
    for (t, contact) in (0..history.model().sites.len()).flat_map(|contact| history.trajectories.log(contact).states())
    {
        add(t);
        match contact {
            Contact::Open { armed } => add(if armed { 1.0 } else { 2.0 }),
            Contact::Closed(closed) => {
                let (kind, vector) = match closed.mode {
                    Mode::Stick { anchor } => (3.0, anchor),
                    Mode::Slip { direction } => (4.0, direction),
                };
                [kind, vector.x, vector.y].into_iter().for_each(&mut add);
                closed.law.normal.digest(&mut add);
            }
        }
    }
    for event in history.events() {
        add(event.t);
        add(event.released);
    }
    if let Some(record) = history.impact() {
        for hit in &record.hits {
            [hit.t, hit.impulses.offset, hit.point.x, hit.point.y]
                .into_iter()
                .chain(hit.impulses.total())
                .for_each(&mut add);
        }
        for change in &record.transitions {
            add(change.t);
            add(f64::from(u32::from(change.to.letter())));
        }
    }
    hash.update(&block);
    hash.digest()
}
