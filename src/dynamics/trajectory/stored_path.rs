//! Trajectory of one body as stored in a history: beginnings of its segments, and codes of their representations.
//!
//! A flight is stored by its initial state, a step by its polynomial or, in long runs, by its number among the
//! recomputed steps ([`crate::dynamics::record::recomputed_steps`]). A segment ends where the next one begins; only
//! exceptions store an end.

use crate::dynamics::free_flight::body_flight::BodyFlight;
use crate::dynamics::free_flight::sliding_face::SlidingFace;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::coordinates::planar::PlanarState;
use crate::dynamics::trajectory::heading::{HalfTurns, StepHeading};
use crate::dynamics::trajectory::packed_states::PackedStates;
use crate::dynamics::trajectory::segment::{Segment, SegmentMotion};
use crate::dynamics::trajectory::segment_code::{NUMBERS, SegmentCode, SegmentKind};
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;

/// Stretches of a body's trajectory in order of time.
#[derive(Clone, Debug, Default)]
pub struct StoredPath {
    from: Vec<f64>,
    codes: Vec<SegmentCode>,
    /// End of the last segment \[s\].
    until: f64,
    /// Number and end \[s\] of segments that are not followed at once by another.
    breaks: Vec<(usize, f64)>,
    starts: PackedStates,
    /// Flights that are not determined by their initial state alone.
    flights: Vec<BodyFlight>,
    slides: Vec<SlidingFace>,
    pieces: Vec<StepPolynomial>,
    half_turns: HalfTurns,
    /// Over the steps that are recomputed.
    swept: Swept,
}

/// Bounds on displacement and rotation in steps whose polynomials are not kept.
#[derive(Clone, Copy, Debug, Default)]
pub struct Swept {
    /// Bound on the distance of G from where the body was placed \[m\].
    pub reach: f64,
    /// Largest chord of its rotation since placed, at the beginnings of the steps \[–\].
    pub chord: f64,
}

/// A flight that is stored by its initial state.
pub struct StoredFlight {
    /// Number of the segment.
    pub number: u32,
    /// Beginning \[s\].
    pub from: f64,
    /// Initial state.
    pub start: PlanarState,
}

/// Interval and kind of one segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeSpan {
    /// Beginning \[s\].
    pub from: f64,
    /// End \[s\].
    pub until: f64,
    /// Whether its motion has a closed form.
    pub flies: bool,
}

/// Representation from which a segment's motion is evaluated.
#[derive(Clone, Copy, Debug)]
pub enum StoredMotion<'a> {
    /// A flight of a rigid girder in plan with this initial state.
    Start(PlanarState),
    /// A flight.
    Flight(&'a BodyFlight),
    /// A face that slides along a wall.
    Slide(&'a SlidingFace),
    /// A step's polynomial.
    Step(&'a StepPolynomial),
    /// A step that is recomputed, by its number in the group.
    Recomputed(u32),
}

impl StoredPath {
    /// Adds a segment.
    pub fn push(&mut self, segment: Segment) {
        let Segment { from, until, path } = segment;
        let code = match path {
            SegmentMotion::Flight(flight) => match self.start(&flight, from) {
                Some(number) => SegmentCode::new(SegmentKind::Start, number),
                None => keep(&mut self.flights, *flight, SegmentKind::Flight),
            },
            SegmentMotion::Step(piece) => keep(&mut self.pieces, piece, SegmentKind::Step),
            SegmentMotion::Recomputed(number) => SegmentCode::new(SegmentKind::Recomputed, number),
            SegmentMotion::Slide(slide) => keep(&mut self.slides, *slide, SegmentKind::Slide),
        };
        if !self.from.is_empty() && self.until != from {
            self.breaks.push((self.from.len() - 1, self.until));
        }
        self.from.push(from);
        self.codes.push(code);
        self.until = until;
    }

    /// Widens what is swept in recomputed steps.
    pub fn sweep(&mut self, Swept { reach, chord }: Swept) {
        self.swept = Swept { reach: self.swept.reach.max(reach), chord: self.swept.chord.max(chord) };
    }

    /// Bound of the circular frequencies of flights on other springs than a girder's bearings; `None` without such flights \[rad/s\].
    pub fn fastest_on_springs(&self) -> Option<f64> {
        self.flights.iter().filter_map(BodyFlight::fastest_on_springs).reduce(f64::max)
    }

    /// Bounds on displacement and rotation in recomputed steps; 0 without one.
    pub fn swept(&self) -> Swept {
        self.swept
    }

    /// Counts the half turns of a body over the step that is added next.
    pub fn follow(&mut self, body: &Body, piece: &StepPolynomial, span: [f64; 2]) {
        if let Some(heading) = StepHeading::of(body, piece, span) {
            self.half_turns.follow(self.len(), &heading);
        }
    }

    /// Half turns of the body's angle at the beginning of segment `number`, where its attitude does not determine them.
    pub fn half_turns(&self, number: usize) -> i32 {
        self.half_turns.at(number)
    }

    /// Adds the only segment of a path, without reserving memory for more.
    pub fn push_only(&mut self, segment: Segment) {
        self.from.reserve_exact(1);
        self.codes.reserve_exact(1);
        self.starts.reserve_one();
        self.push(segment);
    }

    /// Stores a flight by its initial state; its number, `None` for a flight that is not determined by it.
    fn start(&mut self, flight: &BodyFlight, from: f64) -> Option<u32> {
        let state = flight.as_girder_start().filter(|_| flight.start().to_bits() == from.to_bits())?;
        self.starts.push(state)
    }

    /// Flight with which the path ends at `t`; `None` without one.
    pub fn flown_until(&self, t: f64) -> Option<StoredFlight> {
        let (code, from) = (*self.codes.last()?, *self.from.last()?);
        let flown = code.kind() == SegmentKind::Start && self.until == t;
        flown.then(|| StoredFlight {
            number: u32::try_from(self.codes.len() - 1).unwrap_or(u32::MAX),
            from,
            start: self.starts.get(code.number()),
        })
    }

    /// Beginning \[s\] and representation of segment `number`.
    pub fn motion_of(&self, number: usize) -> (f64, StoredMotion<'_>) {
        let code = self.codes[number];
        let which = code.number() as usize;
        let motion = match code.kind() {
            SegmentKind::Start => StoredMotion::Start(self.starts.get(code.number())),
            SegmentKind::Flight => StoredMotion::Flight(&self.flights[which]),
            SegmentKind::Step => StoredMotion::Step(&self.pieces[which]),
            SegmentKind::Recomputed => StoredMotion::Recomputed(code.number()),
            SegmentKind::Slide => StoredMotion::Slide(&self.slides[which]),
        };
        (self.from[number], motion)
    }

    /// Beginning of the segment after segment `number`; `None` after the last \[s\].
    pub fn next(&self, number: usize) -> Option<f64> {
        self.from.get(number + 1).copied()
    }

    /// Number of the segment at `t`; `None` for an empty path.
    pub fn number_at(&self, t: f64) -> Option<usize> {
        let number = self.from.partition_point(|from| *from <= t).saturating_sub(1);
        (number < self.from.len()).then_some(number)
    }

    /// Beginning \[s\] and representation of the segment at `t`; `None` for an empty path.
    pub fn at(&self, t: f64) -> Option<(f64, StoredMotion<'_>)> {
        self.number_at(t).map(|number| self.motion_of(number))
    }

    /// End of segment `number` \[s\].
    pub fn until(&self, number: usize) -> f64 {
        match self.breaks.binary_search_by_key(&number, |(at, _)| *at) {
            Ok(at) => self.breaks[at].1,
            Err(_) => self.from.get(number + 1).copied().unwrap_or(self.until),
        }
    }

    /// Number of segments.
    pub fn len(&self) -> usize {
        self.from.len()
    }

    /// Whether there are no segments.
    pub fn is_empty(&self) -> bool {
        self.from.is_empty()
    }

    /// Intervals of all segments.
    pub fn spans(&self) -> impl Iterator<Item = TimeSpan> + '_ {
        self.spans_from(0)
    }

    /// Intervals of the segments that end after `t`.
    pub fn spans_after(&self, t: f64) -> impl Iterator<Item = TimeSpan> + '_ {
        let begun = self.from.partition_point(|from| *from <= t).saturating_sub(1);
        let first = (begun..self.len()).find(|&number| self.until(number) > t).unwrap_or(self.len());
        self.spans_from(first)
    }

    fn spans_from(&self, first: usize) -> impl Iterator<Item = TimeSpan> + '_ {
        let span = |number: usize| TimeSpan {
            from: self.from[number],
            until: self.until(number),
            flies: !matches!(self.codes[number].kind(), SegmentKind::Step | SegmentKind::Recomputed),
        };
        (first..self.len()).map(span)
    }

    /// Memory of the path \[bytes\].
    pub fn bytes(&self) -> usize {
        let pieces: usize = self.pieces.iter().map(StepPolynomial::bytes).sum();
        let flights: usize = self.flights.iter().map(BodyFlight::bytes).sum();
        let slides = self.slides.len() * size_of::<SlidingFace>();
        let segments = self.len() * (size_of::<f64>() + size_of::<SegmentCode>());
        let breaks = self.breaks.len() * size_of::<(usize, f64)>();
        segments + breaks + self.starts.bytes() + flights + slides + pieces + self.half_turns.bytes()
    }

    /// Releases reserved memory.
    pub fn shrink(&mut self) {
        self.from.shrink_to_fit();
        self.codes.shrink_to_fit();
        self.starts.shrink();
        self.flights.shrink_to_fit();
        self.slides.shrink_to_fit();
        self.pieces.shrink_to_fit();
        self.half_turns.shrink();
    }
}

/// Adds a representation to those of its kind; its code.
fn keep<T>(kept: &mut Vec<T>, motion: T, kind: SegmentKind) -> SegmentCode {
    kept.push(motion);
    // Memory ends before 29 bits overflow.
    SegmentCode::new(kind, u32::try_from(kept.len() - 1).unwrap_or(NUMBERS - 1))
}

impl FromIterator<Segment> for StoredPath {
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
    use glam::DVec2;

    use crate::dynamics::Model;
    use crate::dynamics::free_flight::body_motion::BodyMotion;
    use crate::dynamics::integrator::dense_output::DenseOutput;
    use crate::dynamics::model::coordinates::planar::WIDTH;
    use crate::motion::Ground;
    use crate::scene::presets;

    #[test]
    fn stretches_end_where_the_next_begins_or_where_they_were_left() {
        let again = |from, until, number| Segment { from, until, path: SegmentMotion::Recomputed(number) };
        let path: StoredPath = [again(0.0, 1.0, 7), again(1.0, 2.0, 8), again(2.5, 3.0, 9)].into_iter().collect();
        let spans: Vec<(f64, f64)> = path.spans().map(|span| (span.from, span.until)).collect();
        assert_eq!(spans, [(0.0, 1.0), (1.0, 2.0), (2.5, 3.0)], "with a gap after the second");
        let after = |t| path.spans_after(t).map(|span| span.from).collect::<Vec<_>>();
        assert_eq!(after(1.0), [1.0, 2.5], "what ends at t is over");
        assert_eq!(after(2.2), [2.5], "in the gap");
        assert_eq!(after(3.0), [0.0; 0], "after the end");
        assert!(matches!(path.at(1.5), Some((1.0, StoredMotion::Recomputed(8)))), "{:?}", path.at(1.5));
    }

    #[test]
    fn every_representation_comes_back_by_its_code() {
        let model = Model::compile(&presets::load("straight-abutment").expect("a preset")).expect("a scene");
        let (body, ground) = (&model.bodies[0], Ground::Still);
        let state = [0.1, -0.2, 0.3, 1.0, 2.0, -3.0];
        let motion = BodyMotion::of(body, &ground, 9.0).expect("a girder in plan");
        let flight = |start: f64| SegmentMotion::Flight(Box::new(motion.fly(start, &state).expect("its state")));
        let dense = DenseOutput::new(2.0, 1.0, vec![[7.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]; WIDTH]);
        let slide = SlidingFace::new((body, &ground), [DVec2::X; 2], &ground.piece(0), (4.0, &state), 1.0);
        let motions = [
            flight(0.0),
            flight(0.5),
            SegmentMotion::Step(StepPolynomial::of(&dense, 0..WIDTH, None)),
            SegmentMotion::Recomputed(17),
            SegmentMotion::Slide(Box::new(slide)),
        ];
        let segment = |(i, path): (u32, SegmentMotion)| Segment { from: f64::from(i), until: f64::from(i + 1), path };
        let path: StoredPath = (0..).zip(motions).map(segment).collect();
        assert!(matches!(path.motion_of(0), (0.0, StoredMotion::Start(kept)) if kept == state), "by its start alone");
        assert!(
            matches!(path.motion_of(1), (1.0, StoredMotion::Flight(f)) if f.start() == 0.5),
            "begun before the segment"
        );
        let mut place = [0.0; WIDTH];
        let (_, StoredMotion::Step(piece)) = path.motion_of(2) else { panic!("a step") };
        piece.read(2.5, &mut place);
        assert_eq!(place, [7.5; WIDTH], "half way");
        assert!(matches!(path.motion_of(3), (3.0, StoredMotion::Recomputed(17))), "by its number");
        assert!(matches!(path.motion_of(4), (4.0, StoredMotion::Slide(s)) if s.from == 4.0), "a sliding face");
        let closed: Vec<bool> = path.spans().map(|span| span.flies).collect();
        assert_eq!(closed, [true, true, false, false, true], "closed forms");
        assert!(path.flown_until(5.0).is_none(), "the last one is no flight");
    }
}
