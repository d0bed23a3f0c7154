//! Measures of a scan's runs.

use crate::study::experiment::cases::girder::HALF_LENGTH;
use crate::study::experiment::cases::{Case, Shaking, Specimen};
use crate::study::experiment::findings::rules;
use crate::study::experiment::observe::Observed;

/// A number of one or several cases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// Hits a cycle of the straight girder driven along its axis.
    Hits(Shaking),
    /// Movement of the straight girder's ends by rotation over its transverse displacement, at 22.5°.
    EndMovement,
    /// Rotation of the 45° girder over that of the 60° one, along the axis.
    Skews,
    /// Rotation of the 60° girder driven at −60° over that on the axis; at +60° the motion runs along the wall.
    OffAxis,
    /// Largest rotation of the 45° girder \[degrees\].
    Rotation,
    /// Part of the successions of hits under the earthquake that have two hits or more, straight girder head-on.
    Successions,
    /// Rotation under the earthquake over that under the sine of 0.40 g, straight girder at 45°.
    RecordRotation,
    /// Larger end movement of the two girders over their transverse displacement.
    PairMovement,
}

impl Measure {
    /// With its unit.
    pub fn label(self) -> &'static str {
        match self {
            Self::Hits(_) => "hits a cycle",
            Self::EndMovement | Self::PairMovement => "end movement / y",
            Self::Skews => "θ(45°) / θ(60°)",
            Self::OffAxis => "θ(−60°) / θ(0°)",
            Self::Rotation => "largest θ [°]",
            Self::Successions => "part in succession",
            Self::RecordRotation => "θ record / θ sine",
        }
    }

    /// The cases that it needs.
    pub(super) fn cases(self) -> Vec<Case> {
        use Shaking::{Large, Record};
        use Specimen::{Pair, Skew45, Skew60, Straight};
        match self {
            Self::Hits(shaking) => vec![Case::new(Straight, 0.0, shaking)],
            Self::EndMovement => vec![Case::new(Straight, 22.5, Large)],
            Self::Skews => vec![Case::new(Skew60, 0.0, Large), Case::new(Skew45, 0.0, Large)],
            Self::OffAxis => [0.0, -60.0].map(|angle| Case::new(Skew60, angle, Large)).into(),
            Self::Rotation => vec![Case::new(Skew45, 0.0, Large)],
            Self::Successions => vec![Case::new(Straight, 0.0, Record)],
            Self::RecordRotation => vec![Case::new(Straight, 45.0, Record), Case::new(Straight, 45.0, Large)],
            Self::PairMovement => vec![Case::new(Pair, 22.5, Large)],
        }
    }

    /// Its value, from what was seen of its cases.
    pub(super) fn value(self, seen: &[Observed]) -> Option<f64> {
        let period = 1.0 / Specimen::Straight.sine_hz();
        let turned = |i: usize| seen.get(i).map(Observed::rotation);
        let value = match self {
            Self::Hits(_) => rules::hits_a_cycle(seen.first()?, period)?,
            Self::EndMovement | Self::PairMovement => {
                let girders = seen.first()?.girders.iter();
                girders.map(|girder| rules::end_movement(girder, HALF_LENGTH)).fold(0.0, f64::max)
            }
            Self::Skews | Self::OffAxis => turned(1)? / turned(0)?,
            Self::Rotation => turned(0)?.to_degrees(),
            Self::Successions => {
                let all = rules::successions(&seen.first()?.hits, period);
                all.iter().filter(|hits| hits.len() > 1).count() as f64 / all.len() as f64
            }
            Self::RecordRotation => turned(0)? / turned(1)?,
        };
        value.is_finite().then_some(value)
    }
}
