//! A finished run with what the window asks of it again and again: closed intervals, state spans, headline numbers.

use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::Duration;

use crate::app::command::Way;
use crate::codes::{self, SeatDemands};
use crate::language::Message;
use crate::scene::Kind;
use crate::scene::difference::Values;
use crate::scene::domain::{self, Departure};
use crate::sim::moving_ground::{MovedSupport, moved_supports};
use crate::sim::readings::{self, Extreme, Passed, Reading};
use crate::sim::seats::OrbitPoint;
use crate::sim::seats::verdict::Verdict;
use crate::sim::{
    Balance, Comparison, ContactState, DeviceReading, Dropped, ErrorEstimate, EventKind, History, Hit, Overlap,
    Quantity, RunDifference, Summary, TooDeep,
};
use crate::tables::{self, BackfillReport, PierReport};

/// A stretch of time that a contact of a pair spends in one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// The facing pair.
    pub pair: usize,
    /// Stick or slip.
    pub state: ContactState,
    /// From \[s\].
    pub start: f64,
    /// To \[s\].
    pub end: f64,
}

/// How far the two models are apart at the most, where both computed the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelsApart {
    /// Of any girder.
    pub most: RunDifference,
    /// Whether a whole face hits.
    pub flush: bool,
}

/// A seat of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct SeatAnswer {
    /// The seat, its readings in the run, lengths required by codes.
    pub demands: SeatDemands,
    /// The way of its corners.
    pub orbit: Vec<OrbitPoint>,
}

/// Intervals of an orbit: they are drawn in every frame.
const ORBIT_INTERVALS: u32 = 1000;

/// Most girders whose verdicts are found together: those of a long row take longer than a frame.
pub(in crate::app) const MOST_VERDICTS: usize = 12;

/// A run, ready to be looked at.
pub struct Answer {
    /// The run itself.
    pub history: History,
    /// Counts the runs of this window, so that what is derived from one can be kept until the next.
    pub number: u64,
    /// How long the run took on the wall.
    pub took: Duration,
    /// Headline numbers.
    pub summary: Summary,
    /// Intervals in which any contact is closed, merged and ordered \[s\].
    pub touches: Vec<(f64, f64)>,
    /// Times of events, ordered, without repetition \[s\].
    pub event_times: Vec<f64>,
    /// Stick and slip of every contact, ordered by start.
    pub spans: Vec<Span>,
    /// Hits of the impact model: pair and time \[s\].
    pub hits: Vec<(usize, f64)>,
    /// How far the models are apart, where there are two.
    pub apart: Option<ModelsApart>,
    /// Residual of its energy ledger, beside its bound.
    pub balance: Balance,
    /// Quantities of its scene outside the domain in which the program is checked.
    pub outside: Vec<Departure>,
    /// Contacts pressed deeper than their law has a sense.
    pub too_deep: Vec<TooDeep>,
    /// Contacts that left a face while their springs held energy.
    pub dropped: Option<Dropped>,
    /// Supports whose ground moves otherwise.
    pub moved: Vec<MovedSupport>,
    /// In words, that contacts went on without friction.
    pub frictionless: Option<Message>,
    /// Keys of the scene that the run does not use.
    pub unused: Vec<Message>,
    found: Found,
}

/// Results that are computed on first use.
#[derive(Default)]
struct Found {
    error: OnceLock<ErrorEstimate>,
    passed: OnceLock<Vec<Passed>>,
    falls: OnceLock<Vec<(usize, Verdict)>>,
    readings: OnceLock<Vec<OnceLock<Reading>>>,
    devices: OnceLock<Vec<OnceLock<Option<DeviceReading>>>>,
    quantities: OnceLock<Vec<(String, Quantity)>>,
    seats: OnceLock<Vec<SeatAnswer>>,
    piers: OnceLock<Vec<PierReport>>,
    soils: OnceLock<Vec<BackfillReport>>,
    values: OnceLock<Values>,
    lost: OnceLock<f64>,
    /// Differences from other runs, by their numbers.
    differences: Mutex<Vec<(u64, RunDifference)>>,
}

impl Answer {
    /// Collects the results of a run for the window.
    pub fn new(history: History, took: Duration, number: u64) -> Self {
        let summary = history.summary();
        let touches = merged(history.hits().touches().iter().map(|t| (t.start, t.end)));
        let runs = [Some(&history), history.beside()];
        let mut event_times: Vec<f64> =
            runs.into_iter().flatten().flat_map(History::events).map(|event| event.t).collect();
        // Found here, on the thread that computes, and kept by the history.
        event_times.extend(history.overlaps().iter().map(Overlap::first));
        event_times.sort_by(f64::total_cmp);
        event_times.dedup();
        let spans = spans(&history);
        let record = runs.into_iter().flatten().find_map(History::impact);
        let hits = record.map_or(Vec::new(), |record| record.hits.iter().map(|hit| (hit.pair, hit.t)).collect());
        let apart = history.beside().map(|beside| apart(&history, beside));
        let (outside, balance) = (domain::outside(history.scene()), history.energy().balance());
        let (too_deep, dropped) = (history.contacts().too_deep(), history.contacts().dropped());
        let moved = moved_supports(history.scene(), history.model());
        let mut runs = std::iter::once(&history).chain(history.beside());
        let frictionless = runs.find_map(|run| run.contacts().without_friction());
        let unused = history.scene().unused_values();
        Self {
            history,
            number,
            took,
            summary,
            touches,
            event_times,
            spans,
            hits,
            apart,
            balance,
            too_deep,
            dropped,
            moved,
            frictionless,
            unused,
            outside,
            found: Found::default(),
        }
    }

    /// How far the models are apart at `t` \[s\]; 0 where there is one.
    pub fn apart_at(&self, t: f64) -> RunDifference {
        self.history
            .beside()
            .map_or_else(RunDifference::default, |beside| Comparison::of(&self.history, beside).of_girders_at(t))
    }

    /// How far the girders of this run and of another of this window are apart at the most; found when first asked for.
    pub fn apart_from(&self, other: &Self) -> RunDifference {
        let mut known = self.found.differences.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, found)) = known.iter().find(|(number, _)| *number == other.number) {
            return *found;
        }
        let found = Comparison::of(&self.history, &other.history).of_girders();
        known.push((other.number, found));
        found
    }

    /// Energy lost in dashpots, friction and hits until the end \[J\]; found when first asked for.
    pub fn lost(&self) -> f64 {
        *self.found.lost.get_or_init(|| self.history.energy().ledger(self.history.end()).lost())
    }

    /// Limits of the scene that were passed, the earliest first; found when first asked for.
    pub fn passed(&self) -> &[Passed] {
        self.found.passed.get_or_init(|| readings::passed(&self.history))
    }

    /// Whether the run goes on as if ends were carried that have come off their seats: no bearing is lost over an edge in it.
    pub fn goes_on_as_carried(&self) -> bool {
        let off = |(_, verdict): &(usize, Verdict)| matches!(verdict, Verdict::CornerOff { .. } | Verdict::Lost { .. });
        self.falls().iter().any(off) && self.history.seats().lost_supports(self.history.end()).is_empty()
    }

    /// When the first end comes off its seat that the run goes on to carry; infinite where none does \[s\].
    pub fn carried_from(&self) -> f64 {
        if !self.goes_on_as_carried() {
            return f64::INFINITY;
        }
        self.falls().iter().map(|(_, verdict)| verdict.t()).fold(f64::INFINITY, f64::min)
    }

    /// Girders that come off their seats, lose a support or tip, with their verdicts, the earliest first, among the first
    /// `MOST_VERDICTS` that could; found when first asked for.
    pub fn falls(&self) -> &[(usize, Verdict)] {
        self.found.falls.get_or_init(|| {
            let girders = self.history.scene().girders.iter().enumerate();
            // Whether a girder tips is found for all of them together: of a long row in space that would hold up a frame.
            let few_in_space = self.history.scene().kind == Kind::Spatial && girders.len() <= MOST_VERDICTS;
            let could = girders.filter(|(_, girder)| few_in_space || girder.seat.plus.or(girder.seat.minus).is_some());
            let verdicts = could.take(MOST_VERDICTS).filter_map(|(i, _)| Some((i, self.history.seats().verdict(i)?)));
            let mut falls: Vec<(usize, Verdict)> = verdicts.filter(|(_, verdict)| !verdict.stays()).collect();
            falls.sort_by(|(_, a), (_, b)| a.t().total_cmp(&b.t()));
            falls
        })
    }

    /// Readings of a girder; computed on first use.
    pub fn reading(&self, girder: usize) -> Option<&Reading> {
        let all = self
            .found
            .readings
            .get_or_init(|| self.history.model().girders().iter().map(|_| OnceLock::new()).collect());
        Some(all.get(girder)?.get_or_init(|| readings::reading(&self.history, girder)))
    }

    /// Names of the devices, in the order of the model.
    pub fn device_names(&self) -> impl Iterator<Item = &str> {
        self.history.model().devices.iter().map(|device| device.name.as_str())
    }

    /// Readings of the device of this name; computed on first use.
    pub fn device(&self, name: &str) -> Option<&DeviceReading> {
        let number = self.device_names().position(|known| known == name)?;
        let all =
            self.found.devices.get_or_init(|| self.history.model().devices.iter().map(|_| OnceLock::new()).collect());
        all.get(number)?.get_or_init(|| self.history.connections().device_reading(number)).as_ref()
    }

    /// Every seat with what codes require of it and the orbit of its corners; found when first asked for.
    pub fn seats(&self) -> &[SeatAnswer] {
        let of = |demands: SeatDemands| {
            let orbit = self.history.seats().orbit(demands.girder, &demands.seat, ORBIT_INTERVALS);
            SeatAnswer { demands, orbit }
        };
        self.found.seats.get_or_init(|| codes::of(&self.history).into_iter().map(of).collect())
    }

    /// Readings of the pier of this number; computed on first use.
    pub fn pier(&self, number: usize) -> Option<&PierReport> {
        self.found.piers.get_or_init(|| tables::piers(&self.history)).get(number)
    }

    /// Readings of the soil behind abutments; computed on first use.
    pub fn soils(&self) -> &[BackfillReport] {
        self.found.soils.get_or_init(|| tables::backfill(&self.history))
    }

    /// The same of the abutment of this name.
    pub fn soil(&self, abutment: &str) -> Option<&BackfillReport> {
        self.soils().iter().find(|soil| soil.abutment == abutment)
    }

    /// The least that any seat of the first `MOST_VERDICTS` girders is left with, square to its edge, and whose it is \[m\]; none without
    /// seats.
    pub fn least_seat(&self) -> Option<(usize, Extreme)> {
        let girders = 0..self.history.model().girders().len().min(MOST_VERDICTS);
        let seats = girders.filter_map(|girder| Some((girder, self.reading(girder)?)));
        let all = seats.flat_map(|(girder, reading)| reading.seats.iter().map(move |seat| (girder, seat)));
        let all = all.map(|(girder, seat)| (girder, seat.least()));
        all.reduce(|a, b| if b.1.value < a.1.value { b } else { a })
    }

    /// Every value of its scene; gathered when first asked for.
    pub fn values(&self) -> &Values {
        self.found.values.get_or_init(|| Values::of(self.history.scene()))
    }

    /// Every quantity with its name; listed when first asked for, as a long row has many.
    pub fn quantities(&self) -> &[(String, Quantity)] {
        self.found.quantities.get_or_init(|| Quantity::all(&self.history))
    }

    /// The quantity of this name.
    pub fn quantity(&self, name: &str) -> Option<Quantity> {
        self.quantities().iter().find(|(known, _)| known == name).map(|(_, quantity)| *quantity)
    }

    /// Estimated error, once it is known; NaN when it could not be had.
    pub fn error(&self) -> Option<ErrorEstimate> {
        self.found.error.get().copied()
    }

    /// Keeps the estimated error.
    pub fn set_error(&self, error: ErrorEstimate) {
        // The first estimate stands: the answer does not change.
        let _ = self.found.error.set(error);
    }

    /// Time of the next event after `t`, or of the one before \[s\].
    pub(in crate::app) fn neighbour_event(&self, t: f64, way: Way) -> Option<f64> {
        // A look-up lands on the event itself: it must not find the same one again.
        let step = 1e-9 * self.history.end().max(1.0);
        match way {
            Way::Forward => {
                let next = self.event_times.partition_point(|&e| e <= t + step);
                self.event_times.get(next).copied()
            }
            Way::Back => {
                let next = self.event_times.partition_point(|&e| e < t - step);
                next.checked_sub(1).map(|i| self.event_times[i])
            }
        }
    }

    /// Seconds of the answer per second of computing.
    pub fn times_real_time(&self) -> f64 {
        self.history.end() / self.took.as_secs_f64().max(1e-9)
    }
}

fn apart(one: &History, other: &History) -> ModelsApart {
    let flush = other.impact().is_some_and(|record| record.hits.iter().any(Hit::is_flush));
    ModelsApart { most: Comparison::of(one, other).of_girders(), flush }
}

/// Turns events into stretches of one state; what touches from the beginning has no event for it.
fn spans(history: &History) -> Vec<Span> {
    let mut open: Vec<Option<(ContactState, f64)>> = vec![None; history.model().sites.len()];
    for contact in history.contacts().at(0.0) {
        if let Some(slot) = open.get_mut(contact.contact) {
            *slot = Some((contact.state, 0.0));
        }
    }
    let mut spans = Vec::new();
    for event in history.events() {
        if matches!(event.kind, EventKind::Hit | EventKind::Moved) {
            // A hit takes no time; a node that is moved stays in its state.
            continue;
        }
        let Some(slot) = open.get_mut(event.site()) else { continue };
        if let Some((state, start)) = slot.take().filter(|(_, start)| event.t > *start) {
            let pair = history.model().sites[event.site()].pair;
            spans.push(Span { pair, state, start, end: event.t });
        }
        *slot = after(event.kind).map(|state| (state, event.t));
    }
    for (contact, slot) in open.into_iter().enumerate() {
        if let Some((state, start)) = slot {
            let pair = history.model().sites[contact].pair;
            spans.push(Span { pair, state, start, end: history.end() });
        }
    }
    spans.sort_by(|a, b| a.start.total_cmp(&b.start));
    spans
}

/// The state that an event leaves behind; `None` is open.
fn after(kind: EventKind) -> Option<ContactState> {
    match kind {
        EventKind::OpenToStick | EventKind::SlipToStick => Some(ContactState::Stick),
        EventKind::OpenToSlip | EventKind::StickToSlip => Some(ContactState::Slip),
        // The last two are passed over before.
        EventKind::Opened | EventKind::LeftFace | EventKind::Missed | EventKind::Moved | EventKind::Hit => None,
    }
}

/// Closed intervals of any contact, merged and ordered, from `(start, end)` pairs ordered by start \[s\].
fn merged(touches: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut merged: Vec<(f64, f64)> = Vec::new();
    for (start, end) in touches {
        match merged.last_mut() {
            Some(last) if start <= last.1 => last.1 = last.1.max(end),
            _ => merged.push((start, end)),
        }
    }
    merged
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlapping_touches_merge() {
        let merged = merged([(0.0, 1.0), (0.5, 2.0), (3.0, 4.0)].into_iter());
        assert_eq!(merged, vec![(0.0, 2.0), (3.0, 4.0)], "first two overlap");
    }
}
