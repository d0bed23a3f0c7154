//! An indexed priority queue of event times: earliest first, ties in the fixed order of the sources.

/// A source of events. At equal times the lower rank precedes, then the lower number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Source {
    /// Kind of source, in order of precedence.
    pub rank: usize,
    /// Number among the sources of its kind.
    pub number: usize,
}

/// A binary heap of which any entry can be moved or removed; the position of every source in the heap is stored.
#[derive(Debug, Default)]
pub struct EventQueue {
    heap: Vec<(u64, Source)>,
    /// Position in the heap by rank and number; `None` for a source without a time.
    places: Vec<Vec<Option<usize>>>,
    /// The last source whose time was no number.
    undefined: Option<Source>,
}

impl EventQueue {
    /// Enters the time of a source \[s\], or replaces it. Times are at least 0, so that their bits have the order of
    /// their values. Of a source whose time is no number that is noted, and it has no time.
    pub fn set(&mut self, source: Source, t: f64) {
        if t.is_nan() {
            self.undefined = Some(source);
            return self.remove(source);
        }
        let entry = (t.max(0.0).to_bits(), source);
        let at = if let Some(at) = *self.place(source) {
            self.heap[at] = entry;
            at
        } else {
            self.heap.push(entry);
            self.heap.len() - 1
        };
        self.settle(at);
    }

    /// A source whose time was no number.
    pub fn undefined(&self) -> Option<Source> {
        self.undefined
    }

    /// Removes a source.
    pub fn remove(&mut self, source: Source) {
        if let Some(at) = self.place(source).take() {
            self.heap.swap_remove(at);
            if at < self.heap.len() {
                self.settle(at);
            }
        }
    }

    /// The earliest time; infinite for an empty queue \[s\].
    pub fn first_time(&self) -> f64 {
        self.heap.first().map_or(f64::INFINITY, |(bits, _)| f64::from_bits(*bits))
    }

    /// Removes and returns the earliest time \[s\] and its source; `None` for an empty queue.
    pub fn pop(&mut self) -> Option<(f64, Source)> {
        let &(bits, source) = self.heap.first()?;
        self.remove(source);
        Some((f64::from_bits(bits), source))
    }

    /// Position of a source in the heap.
    fn place(&mut self, source: Source) -> &mut Option<usize> {
        let Source { rank, number } = source;
        if rank >= self.places.len() {
            self.places.resize(rank + 1, Vec::new());
        }
        let places = &mut self.places[rank];
        if number >= places.len() {
            places.resize(number + 1, None);
        }
        &mut places[number]
    }

    /// Moves the entry at position `at` up or down until the heap is ordered.
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

    fn put(&mut self, at: usize, entry: (u64, Source)) {
        self.heap[at] = entry;
        *self.place(entry.1) = Some(at);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_come_in_order_however_they_were_entered_moved_and_removed() {
        let (mut queue, mut plain, mut draw) = (EventQueue::default(), std::collections::BTreeMap::new(), 7u64);
        for round in 0..5000 {
            draw = draw.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let number = usize::try_from(draw >> 59).expect("five bits");
            let item = Source { rank: usize::from(draw & (1 << 40) == 0), number };
            let t = ((draw >> 20) & 15) as f64;
            match (draw >> 33) & 3 {
                0 => {
                    queue.remove(item);
                    plain.remove(&item);
                }
                1 => {
                    let first = plain.iter().map(|(item, t): (&Source, &f64)| (t.to_bits(), *item)).min();
                    let expected = first.map(|(bits, item)| (f64::from_bits(bits), item));
                    assert_eq!(queue.pop(), expected, "round {round}");
                    expected.map(|(_, item)| plain.remove(&item));
                }
                _ => {
                    queue.set(item, t);
                    plain.insert(item, t);
                }
            }
        }
    }
}
