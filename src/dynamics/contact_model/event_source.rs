//! Sources of events of the contact model.

use crate::dynamics::event_loop::event_queue::Source;

/// A source of events. At equal times an island's event precedes a pair's, and a pair's precedes a link's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dynamics) enum EventSource {
    /// The end of an island's planned step, or an event within it.
    Island(usize),
    /// The closing of a pair, or the end of its search.
    Pair(usize),
    /// The beginning of a link's force, the end of its phase in flight, or the end of its search.
    Link(usize),
}

/// Ranks in the queue.
const ISLAND: usize = 0;
const PAIR: usize = 1;
const LINK: usize = 2;

impl From<EventSource> for Source {
    fn from(source: EventSource) -> Self {
        match source {
            EventSource::Island(number) => Self { rank: ISLAND, number },
            EventSource::Pair(number) => Self { rank: PAIR, number },
            EventSource::Link(number) => Self { rank: LINK, number },
        }
    }
}

impl From<Source> for EventSource {
    fn from(Source { rank, number }: Source) -> Self {
        match rank {
            ISLAND => Self::Island(number),
            PAIR => Self::Pair(number),
            // LINK, the last rank.
            _ => Self::Link(number),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_source_in_the_queue_is_the_one_that_was_entered() {
        let sources = [EventSource::Island(3), EventSource::Pair(2), EventSource::Link(1)];
        assert_eq!(sources.map(|source| EventSource::from(Source::from(source))), sources);
        assert!(sources.map(Source::from).is_sorted(), "an island's event first, a link's last");
    }
}
