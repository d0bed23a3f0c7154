//! Seat lengths that design codes require, beside what a run leaves of the seats (`docs/seats.md`).
//!
//! A code is one file here. Nothing of a run depends on it. Formulas are quoted with their edition and whether they were read
//! there; what an engineer would have to look up is an input of the scene (`[codes]`), and an input that the scene does not give
//! is marked as assumed.

mod aashto_guide;
mod aashto_lrfd;
mod caltrans;
mod demand;
mod en_1998_2;
mod jra;
mod rotation;

pub use demand::{Case, Demand, Input, Source};
pub use rotation::{RotationCondition, rotation_to_zero};

use crate::geometry::End;
use crate::scene::{Codes, Girder, Scene, Support};
use crate::sim::History;
use crate::sim::seats::Seat;
use demand::Code;

/// Length of a seat square to its edge that codes ask for whatever a run gives, of a span \[m\] with a skew angle \[degrees\]: `S_EM` and,
/// where it is skewed, `S_Eθ` of JRA, and the least of Caltrans at an abutment \[m\].
pub fn least_seat(span: f64, skew_deg: f64) -> f64 {
    let angle = skew_deg.min(180.0 - skew_deg).to_radians();
    let turned = if skew_deg == 90.0 { 0.0 } else { jra::of_rotation(span, angle, jra::ROTATION_DEG.to_radians()) };
    jra::least(span).max(caltrans::seat_width(0.0, Support::Abutment)).max(turned)
}

/// Every code, in the order of the tables.
const ALL: [&dyn Code; 5] =
    [&jra::Jra, &aashto_lrfd::AashtoLrfd, &aashto_guide::AashtoGuide, &caltrans::Caltrans, &en_1998_2::En1998Part2];

/// Value assumed for a number that `[codes]` leaves out, by its key, for a girder of this length \[m\].
pub fn assumed(key: &str, codes: &Codes, length: f64) -> f64 {
    let ground = en_1998_2::Ground::of(codes.european_ground.unwrap_or_default());
    match key {
        "deck_length_m" | "support_distance_m" => length,
        "zone_percent" => aashto_lrfd::PERCENT,
        "rotation_deg" => jra::ROTATION_DEG,
        "ground_acceleration_g" => en_1998_2::ACCELERATION_G,
        "soil_factor" => ground.soil,
        "corner_period_s" => ground.periods[0],
        "displacement_period_s" => ground.periods[1],
        "bearing_length_m" => en_1998_2::LEAST_SUPPORT,
        _ => 0.0,
    }
}

/// Required lengths of a seat by every code.
pub fn demands(case: &Case<'_>) -> Vec<Demand> {
    ALL.iter().flat_map(|code| code.demands(case)).collect()
}

/// Required lengths of a seat of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct SeatDemands {
    /// The girder's number.
    pub girder: usize,
    /// Readings of the seat in the run.
    pub seat: Seat,
    /// Every code's requirement.
    pub demands: Vec<Demand>,
}

/// Height of the columns that a seat's length depends on \[m\], assumed where the scene leaves it out: of the pier under the end, of an end
/// on an abutment the pier under the girder's other end, which carries the deck up to the next joint (AASHTO LRFD 4.7.4.4); `None` where
/// neither end stands on a pier.
fn columns(scene: &Scene, girder: &Girder, end: End) -> Option<(f64, Source)> {
    let pier = scene.pier_under(girder, end).or_else(|| scene.pier_under(girder, end.other()))?;
    let source = if scene.piers[pier].height.is_some() { Source::Scene } else { Source::Assumed };
    Some((scene.pier(pier).height, source))
}

/// Every seat of a run with what the codes require of it.
pub fn of(history: &History) -> Vec<SeatDemands> {
    let scene = history.scene();
    let of_girder = |girder: usize| {
        let prism = scene.girders[girder].prism();
        let seats = history.seats().of_girder(girder).into_iter();
        seats.map(move |seat| {
            let columns = columns(scene, &scene.girders[girder], seat.ledge.end);
            let demands = demands(&Case { prism: &prism, codes: &scene.codes, seat: &seat, columns });
            SeatDemands { girder, seat, demands }
        })
    };
    (0..scene.girders.len()).flat_map(of_girder).collect()
}
