//! The path of one body as a history keeps it: when each stretch begins, and where what is needed to give it back stands.
//!
//! A flight is its state at the start; a step is a polynomial, or in long runs the number of a step that is taken again
//! ([`crate::dynamics::record::recomputed_steps`]). One stretch begins where the last one ended, so only the exceptions keep an end.

use crate::dynamics::free_flight::flight::{Flight, Planar};
use crate::dynamics::free_flight::sliding_face::Slide;
use crate::dynamics::trajectory::packed_states::Packed;
use crate::dynamics::trajectory::segment::{Path, Segment};
use crate::dynamics::trajectory::step_polynomial::Piece;

/// Bits of a code that say which of a kind; the three above them say the kind.
const BITS: u32 = 29;
const WHICH: u32 = (1 << BITS) - 1;

/// A body's stretches in order of time.
#[derive(Clone, Debug, Default)]
pub struct BodyPath {
    from: Vec<f64>,
    codes: Vec<u32>,
    /// Where the last stretch ends \[s\].
    until: f64,
    /// Ends of stretches after which another does not begin at once, by their numbers.
    breaks: Vec<(usize, f64)>,
    starts: Packed,
    /// Flights that keep more than their start.
    flights: Vec<Flight>,
    slides: Vec<Slide>,
    pieces: Vec<Piece>,
}

/// One stretch, without its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// From \[s\].
    pub from: f64,
    /// Until \[s\].
    pub until: f64,
    /// Whether it is of closed form, not a step.
    pub flies: bool,
}

/// What a stretch's motion is given back from.
#[derive(Clone, Copy, Debug)]
pub enum Kept<'a> {
    /// A flight from this state on.
    Start(Planar),
    /// A flight.
    Flight(&'a Flight),
    /// A face that slides along a wall.
    Slide(&'a Slide),
    /// A step's polynomial.
    Step(&'a Piece),
    /// A step to be taken again, by its number.
    Again(u32),
}

impl BodyPath {
    /// Adds a stretch.
    pub fn push(&mut self, segment: Segment) {
        let Segment { from, until, path } = segment;
        let (kind, which) = match path {
            Path::Flight(flight) => {
                if let Some(number) = self.start(&flight, from) {
                    (0, number as usize)
                } else {
                    self.flights.push(*flight);
                    (1, self.flights.len() - 1)
                }
            }
            Path::Step(piece) => {
                self.pieces.push(piece);
                (2, self.pieces.len() - 1)
            }
            Path::Again(number) => (3, number as usize),
            Path::Slide(slide) => {
                self.slides.push(*slide);
                (4, self.slides.len() - 1)
            }
        };
        if !self.from.is_empty() && self.until != from {
            self.breaks.push((self.from.len() - 1, self.until));
        }
        self.from.push(from);
        // More stretches of one body than 29 bits count would not fit into memory.
        self.codes.push(kind << BITS | u32::try_from(which).unwrap_or(WHICH) & WHICH);
        self.until = until;
    }

    /// Adds the only stretch that there will be.
    pub fn push_only(&mut self, segment: Segment) {
        self.from.reserve_exact(1);
        self.codes.reserve_exact(1);
        self.starts.reserve_one();
        self.push(segment);
    }

    /// The number of a flight kept as its start; nothing where that would not do.
    fn start(&mut self, flight: &Flight, from: f64) -> Option<u32> {
        if flight.has_anchors() || flight.start.to_bits() != from.to_bits() {
            return None;
        }
        self.starts.push(&flight.state)
    }

    /// Number and state of the flight kept as its start, with when it began, where that is how the path ends at `t`.
    pub fn flown_until(&self, t: f64) -> Option<(u32, f64, Planar)> {
        let (code, from) = (*self.codes.last()?, *self.from.last()?);
        let flown = code >> BITS == 0 && self.until == t;
        flown.then(|| (u32::try_from(self.codes.len() - 1).unwrap_or(u32::MAX), from, self.starts.get(code & WHICH)))
    }

    /// Start of stretch `number` and what it is given back from.
    pub fn kept(&self, number: usize) -> (f64, Kept<'_>) {
        let which = (self.codes[number] & WHICH) as usize;
        let kept = match self.codes[number] >> BITS {
            0 => Kept::Start(self.starts.get(self.codes[number] & WHICH)),
            1 => Kept::Flight(&self.flights[which]),
            2 => Kept::Step(&self.pieces[which]),
            3 => Kept::Again(self.codes[number] & WHICH),
            _ => Kept::Slide(&self.slides[which]),
        };
        (self.from[number], kept)
    }

    /// Start of the stretch that follows on stretch `number` \[s\].
    pub fn next(&self, number: usize) -> Option<f64> {
        self.from.get(number + 1).copied()
    }

    /// The stretch that holds at `t`; nothing where there is none.
    pub fn at(&self, t: f64) -> Option<(f64, Kept<'_>)> {
        let number = self.from.partition_point(|from| *from <= t).saturating_sub(1);
        (number < self.from.len()).then(|| self.kept(number))
    }

    fn until(&self, number: usize) -> f64 {
        match self.breaks.binary_search_by_key(&number, |(at, _)| *at) {
            Ok(at) => self.breaks[at].1,
            Err(_) => self.from.get(number + 1).copied().unwrap_or(self.until),
        }
    }

    /// How many stretches there are.
    pub fn len(&self) -> usize {
        self.from.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.from.is_empty()
    }

    /// Its stretches.
    pub fn spans(&self) -> impl Iterator<Item = Span> + '_ {
        self.spans_from(0)
    }

    /// Its stretches that end after `t`.
    pub fn spans_after(&self, t: f64) -> impl Iterator<Item = Span> + '_ {
        let begun = self.from.partition_point(|from| *from <= t).saturating_sub(1);
        let first = (begun..self.len()).find(|&number| self.until(number) > t).unwrap_or(self.len());
        self.spans_from(first)
    }

    fn spans_from(&self, first: usize) -> impl Iterator<Item = Span> + '_ {
        let span = |number: usize| Span {
            from: self.from[number],
            until: self.until(number),
            flies: !matches!(self.codes[number] >> BITS, 2 | 3),
        };
        (first..self.len()).map(span)
    }

    /// What it takes \[bytes\].
    pub fn bytes(&self) -> usize {
        let pieces: usize = self.pieces.iter().map(Piece::bytes).sum();
        let flights: usize = self.flights.iter().map(Flight::bytes).sum();
        let slides = self.slides.len() * size_of::<Slide>();
        let stretches = self.len() * (size_of::<f64>() + size_of::<u32>());
        stretches + self.breaks.len() * size_of::<(usize, f64)>() + self.starts.bytes() + flights + slides + pieces
    }

    /// Gives back the memory that more stretches would have taken.
    pub fn shrink(&mut self) {
        self.from.shrink_to_fit();
        self.codes.shrink_to_fit();
        self.starts.shrink();
        self.flights.shrink_to_fit();
        self.slides.shrink_to_fit();
        self.pieces.shrink_to_fit();
    }
}

impl FromIterator<Segment> for BodyPath {
    fn from_iter<I: IntoIterator<Item = Segment>>(segments: I) -> Self {
        let mut path = Self::default();
        segments.into_iter().for_each(|segment| path.push(segment));
        path.shrink();
        path
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_end_where_the_next_begins_or_where_they_were_left() {
        let again = |from, until, number| Segment { from, until, path: Path::Again(number) };
        let path: BodyPath = [again(0.0, 1.0, 7), again(1.0, 2.0, 8), again(2.5, 3.0, 9)].into_iter().collect();
        let spans: Vec<(f64, f64)> = path.spans().map(|span| (span.from, span.until)).collect();
        assert_eq!(spans, [(0.0, 1.0), (1.0, 2.0), (2.5, 3.0)], "with a gap after the second");
        let after = |t| path.spans_after(t).map(|span| span.from).collect::<Vec<_>>();
        assert_eq!(after(1.0), [1.0, 2.5], "what ends at t is over");
        assert_eq!(after(2.2), [2.5], "in the gap");
        assert_eq!(after(3.0), [0.0; 0], "after the end");
        assert!(matches!(path.at(1.5), Some((1.0, Kept::Again(8)))), "{:?}", path.at(1.5));
    }
}
