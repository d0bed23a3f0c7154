//! Code of a stored segment: by what its motion is represented, and its number among the segments of that kind.

/// Bits of a code that number the segment among those of its kind; the three bits above them are the kind.
const NUMBER_BITS: u32 = 29;
/// Numbers that a code can hold \[–\].
pub(in crate::dynamics) const NUMBERS: u32 = 1 << NUMBER_BITS;

/// Representation of the motion of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SegmentKind {
    /// The initial state of a rigid girder's flight in plan.
    Start,
    /// A flight with all that determines it.
    Flight,
    /// A step's polynomial.
    Step,
    /// The number of a step that is recomputed.
    Recomputed,
    /// A face that slides along a wall.
    Slide,
}

/// A segment's kind and number in four bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct SegmentCode(u32);

impl SegmentCode {
    /// A segment of this kind and number.
    pub(super) fn new(kind: SegmentKind, number: u32) -> Self {
        Self((kind as u32) << NUMBER_BITS | number & (NUMBERS - 1))
    }

    pub(super) fn kind(self) -> SegmentKind {
        match self.0 >> NUMBER_BITS {
            0 => SegmentKind::Start,
            1 => SegmentKind::Flight,
            2 => SegmentKind::Step,
            3 => SegmentKind::Recomputed,
            _ => SegmentKind::Slide,
        }
    }

    /// Number among the segments of its kind; of a recomputed step in its group.
    pub(super) fn number(self) -> u32 {
        self.0 & (NUMBERS - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kind_and_number_come_back() {
        use SegmentKind::{Flight, Recomputed, Slide, Start, Step};
        for kind in [Start, Flight, Step, Recomputed, Slide] {
            for number in [0, 17, NUMBERS - 1] {
                let code = SegmentCode::new(kind, number);
                assert_eq!((code.kind(), code.number()), (kind, number));
            }
        }
    }
}
