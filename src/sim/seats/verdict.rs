//! One sentence on the seats of a girder: whether it stays on them, what is left at the worst, or where and when it comes off
//! (`docs/seats.md`).

use crate::geometry::End;
use crate::language::{Text, values};
use crate::sim::report::Extreme;
use crate::sim::seats::uplift::TIPPED;
use crate::sim::seats::view::Seats;
use crate::sim::seats::{Seat, SeatCorner};

/// Verdict on the seats of a girder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// Every corner stays over its seat.
    Stays {
        /// The end with the least left.
        end: End,
        /// Its corner with the least left, by its number in plan.
        corner: usize,
        /// The least left, square to the front edge \[m\].
        least: Extreme,
        /// The seat as placed, square to the front edge \[m\].
        placed: f64,
    },
    /// Every corner stays over its seat, but a bearing has lost its support.
    SupportLost {
        /// The first such bearing, by its number in the girder.
        bearing: usize,
        /// Time \[s\].
        t: f64,
        /// The end with the least left.
        end: End,
        /// Its corner with the least left, by its number in plan.
        corner: usize,
        /// The least left, square to the front edge \[m\].
        least: Extreme,
        /// The seat as placed, square to the front edge \[m\].
        placed: f64,
    },
    /// No bearing carries the girder any more: it falls. A planar run that goes on does not show that.
    Falls {
        /// Time \[s\].
        t: f64,
        /// Time at which the first bearing lost its support \[s\].
        first: f64,
    },
    /// The girder tips over in space: what remains of a seat in plan says nothing then.
    Tipped {
        /// Time \[s\].
        t: f64,
        /// Its largest tilt \[rad\].
        tilt: f64,
    },
    /// A corner comes off, and its end is not lost.
    CornerOff {
        /// The end.
        end: End,
        /// The corner that comes off first, by its number in plan.
        corner: usize,
        /// Time \[s\].
        t: f64,
        /// Whether over a side of the seat, not over its front edge.
        side: bool,
        /// The least left of that seat, square to the front edge \[m\].
        least: Extreme,
    },
    /// Both corners of an end are off its front edge.
    Lost {
        /// The end, the first of two.
        end: End,
        /// A corner of it, by its number in plan.
        corner: usize,
        /// Time at which the end is lost \[s\].
        t: f64,
        /// Time at which its first corner came off \[s\].
        first: f64,
    },
}

impl Seats<'_> {
    /// Verdict on a girder; `None` where the scene gives it no seats, unless it falls or tips.
    pub fn verdict(self, girder: usize) -> Option<Verdict> {
        self.verdict_of(girder, &self.of_girder(girder), self.tipped(girder))
    }

    /// Verdict on a girder by its seats, and by the time and the largest tilt with which it has tipped \[s, rad\], which have been read
    /// already.
    pub fn verdict_of(self, girder: usize, seats: &[Seat], tipped: Option<(f64, f64)>) -> Option<Verdict> {
        let bearing = self.first_lost_bearing(girder);
        let falls = self.without_support(girder).zip(bearing).map(|(t, (_, first))| Verdict::Falls { t, first });
        falls.or_else(|| of_seats(seats, bearing, tipped))
    }
}

/// The verdict on the seats of one girder, of which a bearing has lost its support, number and time \[s\], or which has tipped, time and
/// largest tilt \[s, rad\]; none without seats of a girder that stays upright.
fn of_seats(seats: &[Seat], bearing: Option<(usize, f64)>, tipped: Option<(f64, f64)>) -> Option<Verdict> {
    let off = lost(seats).or_else(|| corner_off(seats));
    let tips = || tipped.map(|(t, tilt)| Verdict::Tipped { t, tilt });
    let verdict = off.or_else(tips).or_else(|| stays(seats))?;
    Some(match (verdict, bearing) {
        (Verdict::Stays { end, corner, least, placed }, Some((bearing, t))) => {
            Verdict::SupportLost { bearing, t, end, corner, least, placed }
        }
        _ => verdict,
    })
}

/// The end that is lost first.
fn lost(seats: &[Seat]) -> Option<Verdict> {
    let all = seats.iter().filter_map(|seat| Some((seat, seat.lost_at?)));
    let (seat, t) = all.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let corner = worst(seat).corner;
    Some(Verdict::Lost { end: seat.ledge.end, corner, t, first: seat.off_at().unwrap_or(t) })
}

/// The corner that comes off first, over an edge or over a side.
fn corner_off(seats: &[Seat]) -> Option<Verdict> {
    let corners = seats.iter().flat_map(|seat| seat.corners.map(|corner| (seat, corner)));
    let ways = corners.flat_map(|(seat, corner)| {
        let off = [(corner.off, false), (corner.off_side, true)];
        off.map(|(off, side)| Some((seat, corner.corner, off?.t, side)))
    });
    let (seat, corner, t, side) = ways.flatten().min_by(|a, b| a.2.total_cmp(&b.2))?;
    Some(Verdict::CornerOff { end: seat.ledge.end, corner, t, side, least: seat.least() })
}

/// The seat with the least remaining length.
fn stays(seats: &[Seat]) -> Option<Verdict> {
    let seat = seats.iter().min_by(|a, b| a.least().value.total_cmp(&b.least().value))?;
    let corner = worst(seat).corner;
    Some(Verdict::Stays { end: seat.ledge.end, corner, least: seat.least(), placed: seat.ledge.placed() })
}

/// The corner of a seat with the least left.
fn worst(seat: &Seat) -> SeatCorner {
    let [one, other] = seat.corners;
    if other.least.value < one.least.value { other } else { one }
}

impl Verdict {
    /// Whether the girder stays on all its seats.
    pub fn stays(&self) -> bool {
        matches!(self, Self::Stays { .. })
    }

    /// The moment that decides it \[s\].
    pub fn t(&self) -> f64 {
        match self {
            Self::Stays { least, .. } => least.t,
            Self::CornerOff { t, .. }
            | Self::Lost { t, .. }
            | Self::SupportLost { t, .. }
            | Self::Falls { t, .. }
            | Self::Tipped { t, .. } => *t,
        }
    }

    /// The corner that decides it, by its number in plan; none of a girder that falls or tips.
    pub fn corner(&self) -> Option<usize> {
        match self {
            Self::Stays { corner, .. }
            | Self::SupportLost { corner, .. }
            | Self::CornerOff { corner, .. }
            | Self::Lost { corner, .. } => Some(*corner),
            Self::Falls { .. } | Self::Tipped { .. } => None,
        }
    }

    /// In words, in the language of this thread: `stays on its seats: at worst 1.36 m of 1.50 m left square to the
    /// edge, end +x, 4.18 s`.
    pub fn words(&self) -> String {
        match self {
            Self::Stays { end, least, placed, .. } => {
                let [left, placed] = lengths(least.value, *placed);
                let values = values!["left" => left, "placed" => placed, "end" => end.label(), "t" => seconds(least.t)];
                Text::new("verdict-stays").with(&values)
            }
            Self::SupportLost { bearing, t, end, least, placed, .. } => {
                let ([left, placed], t) = (lengths(least.value, *placed), seconds(*t));
                let (bearing, end) = (bearing + 1, end.label());
                let values = values!["bearing" => bearing, "t" => t, "left" => left, "placed" => placed, "end" => end];
                Text::new("verdict-support-lost").with(&values)
            }
            Self::Falls { t, first } => {
                Text::new("verdict-falls").with(&values!["t" => seconds(*t), "first" => seconds(*first)])
            }
            Self::Tipped { t, tilt, .. } => {
                let tilt = format!("{:.0}", tilt.to_degrees());
                let values = values!["t" => seconds(*t), "tilt" => tilt, "limit" => format!("{TIPPED:.0}")];
                Text::new("verdict-tipped").with(&values)
            }
            Self::CornerOff { end, corner, t, side: true, .. } => {
                let values = values!["corner" => corner + 1, "end" => end.label(), "t" => seconds(*t)];
                Text::new("verdict-over-side").with(&values)
            }
            Self::CornerOff { end, corner, t, least, .. } => {
                let (corner, end, t) = (corner + 1, end.label(), seconds(*t));
                let (beyond, worst) = (length(-least.value), seconds(least.t));
                let values = values!["corner" => corner, "end" => end, "t" => t, "beyond" => beyond, "worst" => worst];
                Text::new("verdict-corner-off").with(&values)
            }
            Self::Lost { end, t, first, .. } => {
                let values = values!["end" => end.label(), "t" => seconds(*t), "first" => seconds(*first)];
                Text::new("verdict-lost").with(&values)
            }
        }
    }
}

/// A time as it is read.
fn seconds(t: f64) -> String {
    format!("{t:.2}")
}

/// A part of a length and the whole, in one unit.
fn lengths(part: f64, whole: f64) -> [String; 2] {
    if whole.abs() >= 0.5 { [part, whole].map(|metres| format!("{metres:.2} m")) } else { [part, whole].map(length) }
}

/// A length as it is read: metres from half a metre on, millimetres below.
fn length(metres: f64) -> String {
    match metres.abs() {
        m if m >= 0.5 => format!("{metres:.2} m"),
        m if m >= 0.01 => format!("{:.0} mm", metres * 1e3),
        _ => format!("{:.2} mm", metres * 1e3),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{self, presets};
    use crate::sim::History;

    /// The opening scene with seats of this length under both ends \[m\].
    fn with_seats(length: f64, side: Option<f64>) -> History {
        let mut scene = presets::load(presets::OPENING).expect("ships");
        scene.girders[0].seat = scene::Seat { plus: Some(length), minus: Some(length), side };
        History::of(&scene).expect("runs")
    }

    #[test]
    fn a_long_seat_keeps_its_girder_and_a_short_one_does_not() {
        let kept = with_seats(0.2, None).seats().verdict(0).expect("seats");
        let Verdict::Stays { least, placed, .. } = kept else { panic!("{kept:?}") };
        assert!(least.value > 0.0 && least.value < placed, "a part of it: {kept:?}");
        assert!(
            kept.words().starts_with("stays on its seats: at worst ")
                && kept.words().contains(" left square to the edge, end "),
            "said"
        );
        // The seat that is left at the worst is the seat less what was used: as long as that it just does not hold.
        let used = placed - least.value;
        let short = with_seats(0.9 * used / (45.0f64.to_radians().sin()), None);
        let off = short.seats().verdict(0).expect("seats");
        assert!(!off.stays() && off.words().starts_with("comes off its seat"), "{off:?}");
        let seat = short.seats().of_girder(0);
        let first = seat.iter().filter_map(Seat::off_at).fold(f64::INFINITY, f64::min);
        match off {
            Verdict::CornerOff { t, .. } => assert_eq!(t, first, "when the first corner does"),
            Verdict::Lost { first: corner, .. } => assert!(corner >= first, "no sooner than the first corner"),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_girder_that_loses_a_bearing_does_not_stay_though_its_corners_do() {
        let seats = with_seats(0.2, None).seats().of_girder(0);
        let lost = of_seats(&seats, Some((2, 1.5)), None).expect("seats");
        assert_eq!((lost.stays(), lost.t()), (false, 1.5));
        assert!(lost.words().starts_with("loses a support: bearing 3 at 1.50 s; at worst "), "{}", lost.words());
    }

    #[test]
    fn without_seats_there_is_no_verdict() {
        let history = History::of(&presets::load(presets::OPENING).expect("ships")).expect("runs");
        assert_eq!(history.seats().verdict(0), None, "none is given");
        assert_eq!(of_seats(&[], None, Some((1.0, 3.1))), Some(Verdict::Tipped { t: 1.0, tilt: 3.1 }), "but it tips");
    }

    #[test]
    fn a_corner_that_leaves_over_a_side_is_told_apart() {
        let narrow = with_seats(0.2, Some(1e-5)).seats().verdict(0).expect("seats");
        assert!(narrow.words().contains("over the side"), "{}", narrow.words());
    }

    #[test]
    fn lengths_read_well() {
        assert_eq!([1.3649, 0.034, 0.001_23].map(length), ["1.36 m", "34 mm", "1.23 mm"], "in their unit");
        assert_eq!([lengths(0.474, 0.606), lengths(0.034, 0.2)], [["0.47 m", "0.61 m"], ["34 mm", "200 mm"]], "in one");
    }
}
