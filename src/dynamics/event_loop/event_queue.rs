//! What is due when: one entry per island and per pair, earliest first, ties in a fixed order.

/// Whose turn it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::dynamics) enum Item {
    /// An island's planned step ends, or an event of its contacts is due.
    Island(usize),
    /// A pair closes, or its search goes on.
    Pair(usize),
}

/// A heap whose entries can be moved: everyone knows where in it he stands.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Agenda {
    heap: Vec<(u64, Item)>,
    islands: Vec<Option<usize>>,
    pairs: Vec<Option<usize>>,
}

impl Agenda {
    /// Enters an item, or moves it. Times are never negative, so their bits sort as they do.
    pub(in crate::dynamics) fn set(&mut self, item: Item, t: f64) {
        let entry = (t.max(0.0).to_bits(), item);
        let at = if let Some(at) = *self.place(item) {
            self.heap[at] = entry;
            at
        } else {
            self.heap.push(entry);
            self.heap.len() - 1
        };
        self.settle(at);
    }

    /// Takes an item off.
    pub(in crate::dynamics) fn remove(&mut self, item: Item) {
        if let Some(at) = self.place(item).take() {
            self.heap.swap_remove(at);
            if at < self.heap.len() {
                self.settle(at);
            }
        }
    }

    /// The earliest time; infinite when nothing is due \[s\].
    pub(in crate::dynamics) fn first_time(&self) -> f64 {
        self.heap.first().map_or(f64::INFINITY, |(bits, _)| f64::from_bits(*bits))
    }

    /// Takes the earliest item.
    pub(in crate::dynamics) fn pop(&mut self) -> Option<(f64, Item)> {
        let &(bits, item) = self.heap.first()?;
        self.remove(item);
        Some((f64::from_bits(bits), item))
    }

    /// Where in the heap an item stands.
    fn place(&mut self, item: Item) -> &mut Option<usize> {
        let (places, number) = match item {
            Item::Island(number) => (&mut self.islands, number),
            Item::Pair(number) => (&mut self.pairs, number),
        };
        if number >= places.len() {
            places.resize(number + 1, None);
        }
        &mut places[number]
    }

    /// Moves the entry at `at` up or down to where it belongs.
    fn settle(&mut self, mut at: usize) {
        let entry = self.heap[at];
        while at > 0 && entry < self.heap[(at - 1) / 2] {
            self.put(at, self.heap[(at - 1) / 2]);
            at = (at - 1) / 2;
        }
        loop {
            let (left, right) = (2 * at + 1, 2 * at + 2);
            let Some(mut child) = (left < self.heap.len()).then_some(left) else { break };
            if right < self.heap.len() && self.heap[right] < self.heap[left] {
                child = right;
            }
            if entry <= self.heap[child] {
                break;
            }
            self.put(at, self.heap[child]);
            at = child;
        }
        self.put(at, entry);
    }

    fn put(&mut self, at: usize, entry: (u64, Item)) {
        self.heap[at] = entry;
        *self.place(entry.1) = Some(at);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_come_in_order_however_they_were_entered_moved_and_taken_off() {
        let (mut agenda, mut plain, mut draw) = (Agenda::default(), std::collections::BTreeMap::new(), 7u64);
        for round in 0..5000 {
            draw = draw.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let number = usize::try_from(draw >> 59).expect("five bits");
            let item = if draw & (1 << 40) == 0 { Item::Pair(number) } else { Item::Island(number) };
            let t = ((draw >> 20) & 15) as f64;
            match (draw >> 33) & 3 {
                0 => {
                    agenda.remove(item);
                    plain.remove(&item);
                }
                1 => {
                    let first = plain.iter().map(|(item, t): (&Item, &f64)| (t.to_bits(), *item)).min();
                    let expected = first.map(|(bits, item)| (f64::from_bits(bits), item));
                    assert_eq!(agenda.pop(), expected, "round {round}");
                    expected.map(|(_, item)| plain.remove(&item));
                }
                _ => {
                    agenda.set(item, t);
                    plain.insert(item, t);
                }
            }
        }
    }
}
