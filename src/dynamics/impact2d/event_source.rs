//! Sources of events of the impact model.

use crate::dynamics::event_loop::event_queue::Source;

/// A source of events. At equal times the end of a lasting contact's step precedes a pair's impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dynamics::impact2d) enum EventSource {
    /// The end of the planned step of a lasting contact.
    Lasting(usize),
    /// The next impact of a pair, or the end of its search.
    Pair(usize),
}

/// Ranks in the queue.
const LASTING: usize = 0;
const PAIR: usize = 1;

impl From<EventSource> for Source {
    fn from(source: EventSource) -> Self {
        match source {
            EventSource::Lasting(number) => Self { rank: LASTING, number },
            EventSource::Pair(number) => Self { rank: PAIR, number },
        }
    }
}

impl From<Source> for EventSource {
    fn from(Source { rank, number }: Source) -> Self {
        match rank {
            LASTING => Self::Lasting(number),
            // PAIR, the last rank.
            _ => Self::Pair(number),
        }
    }
}
