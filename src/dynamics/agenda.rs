//! What is due when: one entry per island and per pair, earliest first, ties in a fixed order.

use std::collections::{BTreeMap, BTreeSet};

/// Whose turn it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Item {
    /// An island's planned step ends, or an event of its contacts is due.
    Island(usize),
    /// A pair closes, or its search goes on.
    Pair(usize),
}

/// A priority queue whose entries can be moved.
#[derive(Debug, Default)]
pub(super) struct Agenda {
    queue: BTreeSet<(u64, Item)>,
    times: BTreeMap<Item, u64>,
}

impl Agenda {
    /// Enters an item, or moves it. Times are never negative, so their bits sort as they do.
    pub(super) fn set(&mut self, item: Item, t: f64) {
        let bits = t.max(0.0).to_bits();
        if let Some(old) = self.times.insert(item, bits) {
            self.queue.remove(&(old, item));
        }
        self.queue.insert((bits, item));
    }

    /// Takes an item off.
    pub(super) fn remove(&mut self, item: Item) {
        if let Some(old) = self.times.remove(&item) {
            self.queue.remove(&(old, item));
        }
    }

    /// The earliest time; infinite when nothing is due \[s\].
    pub(super) fn first_time(&self) -> f64 {
        self.queue.first().map_or(f64::INFINITY, |(bits, _)| f64::from_bits(*bits))
    }

    /// Takes the earliest item.
    pub(super) fn pop(&mut self) -> Option<(f64, Item)> {
        let (bits, item) = self.queue.pop_first()?;
        self.times.remove(&item);
        Some((f64::from_bits(bits), item))
    }
}
