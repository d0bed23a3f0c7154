//! Seats in `summary.json`: what remained at each corner of each end, when and where a corner came off, and what design codes
//! require.

use serde::Serialize;

use crate::codes::{self, Demand, RotationCondition, SeatDemands, rotation_to_zero};
use crate::geometry::Prism;
use crate::language::Text;
use crate::scene::Girder;
use crate::sim::History;
use crate::sim::seats::SeatCorner;

/// The text for the angle of a corner in plan, [`CornerReport::angle`].
pub fn corner_angle(angle: &str) -> Text {
    match angle {
        "acute" => Text::new("report-acute"),
        "obtuse" => Text::new("report-obtuse"),
        _ => Text::new("report-right"),
    }
}

/// A seat in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SeatReport {
    /// The girder.
    pub girder: String,
    /// Its end, `+x` or `-x`.
    pub end: &'static str,
    /// Length of the seat under it along the axis \[m\].
    pub length: f64,
    /// Length square to its front edge, `length · sin β` \[m\].
    pub placed: f64,
    /// The least that remained at either corner, square to the edge; negative when it came off \[m\].
    pub least_remaining: f64,
    /// Least remaining length along the axis \[m\].
    pub least_along_axis: f64,
    /// Length used, square to the edge: placed less least \[m\].
    pub used: f64,
    /// Time of the least remaining length \[s\].
    pub t: f64,
    /// Time at which the first corner came off, over the front edge or over a side; `None` where both stayed \[s\].
    pub left_at: Option<f64>,
    /// Time at which both corners were first off: the end is lost \[s\].
    pub lost_at: Option<f64>,
    /// The least share of the end that stood on its seat, 0 to 1.
    pub least_share: f64,
    /// Its corners, the one at −y of the girder first.
    pub corners: [CornerReport; 2],
    /// Rotation about G, either way, at which nothing remains in the middle of the end \[degrees\].
    pub middle_zero_rotation_deg: Option<f64>,
    /// Left side of the rotation condition of the girder, (6) of the paper and (16.5.1) of JRA part V.
    pub rotation_condition: f64,
    /// Lengths required by design codes.
    pub codes: Vec<DemandReport>,
}

/// A length of seat that a code requires, square to the front edge, and what the run makes of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DemandReport {
    /// Length required, provided and used.
    #[serde(flatten)]
    pub demand: Demand,
    /// Used in parts of required.
    pub ratio: f64,
    /// Whether as much is provided as is required.
    pub met: bool,
}

/// Remaining length at a corner, square to the edge.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CornerReport {
    /// Its number in plan, from 1.
    pub corner: usize,
    /// The angle of the plan there: `acute`, `obtuse`, `right`.
    pub angle: &'static str,
    /// The least that remained; negative where it came off \[m\].
    pub least_remaining: f64,
    /// Time of it \[s\].
    pub t: f64,
    /// Time at which it came off over the front edge; `None` where it stayed \[s\].
    pub left_at: Option<f64>,
    /// Rotation about G, either way, at which nothing remains at it \[degrees\].
    pub zero_rotation_deg: Option<f64>,
    /// Place along the edge at which it came off, from the middle of the end as placed \[m\].
    pub left_along: Option<f64>,
    /// The least distance from the sides of the seat, where the scene gives its width \[m\].
    pub least_at_side: Option<f64>,
    /// Time at which it left the seat over a side \[s\].
    pub left_side_at: Option<f64>,
}

/// Every seat that the scene gives.
pub(super) fn of(history: &History) -> Vec<SeatReport> {
    let girders = &history.scene().girders;
    codes::of(history).iter().map(|of| SeatReport::of(&girders[of.girder], of)).collect()
}

impl SeatReport {
    fn of(girder: &Girder, SeatDemands { seat, demands, .. }: &SeatDemands) -> Self {
        let (least, prism) = (seat.least(), girder.prism());
        let placed = seat.ledge.placed();
        let [one, other, middle] =
            rotation_to_zero(&prism, seat.ledge.end, placed).map(|angle| angle.map(f64::to_degrees));
        let [first, second] = seat.corners;
        Self {
            girder: girder.name.clone(),
            end: seat.ledge.end.label(),
            length: seat.ledge.length,
            placed,
            least_remaining: least.value,
            least_along_axis: least.value / seat.ledge.sine,
            used: seat.used(),
            t: least.t,
            left_at: seat.off_at(),
            lost_at: seat.lost_at,
            least_share: seat.least_share.value,
            corners: [CornerReport::of(&prism, &first, one), CornerReport::of(&prism, &second, other)],
            middle_zero_rotation_deg: middle,
            rotation_condition: RotationCondition::of(&prism).number,
            codes: demands.iter().map(DemandReport::of).collect(),
        }
    }
}

impl DemandReport {
    fn of(demand: &Demand) -> Self {
        Self { demand: demand.clone(), ratio: demand.ratio(), met: demand.is_met() }
    }
}

impl CornerReport {
    fn of(prism: &Prism, corner: &SeatCorner, zero_rotation_deg: Option<f64>) -> Self {
        Self {
            corner: corner.corner + 1,
            angle: prism.corner_kind(corner.corner),
            least_remaining: corner.least.value,
            t: corner.least.t,
            left_at: corner.off.map(|off| off.t),
            zero_rotation_deg,
            left_along: corner.off.map(|off| off.along),
            least_at_side: corner.side.map(|side| side.value),
            left_side_at: corner.off_side.map(|off| off.t),
        }
    }
}
