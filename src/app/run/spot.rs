//! Where a number of a run is to be seen: the moment, what is selected there, what the camera turns to.

use crate::app::command::{Command, Look, SelectCommand, TimeCommand, ViewCommand};
use crate::scene::facing::Side;
use crate::scene::{Girder, StandsOn};
use crate::sim::quantity::{OfPair, Quantity};
use crate::sim::readings::Extreme;
use crate::sim::readings::Passed;
use crate::sim::seats::verdict::Verdict;
use crate::sim::{DeviceReading, Dropped, GirderExtreme, History, Touch};
use crate::view::Target;

/// A moment of a run, and what is to be looked at then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) struct Spot {
    /// When \[s\].
    pub(in crate::app) t: f64,
    /// Target to select; `None` keeps the selection.
    pub(in crate::app) select: Option<Target>,
    /// Object that the camera turns to.
    pub(in crate::app) look: Look,
}

/// Part of a touch before its end at which its contact is still seen closed (chosen).
const BEFORE_THE_END: f64 = 1e-3;

impl Spot {
    /// A girder, from above.
    pub(in crate::app) fn girder(girder: usize, t: f64) -> Self {
        Self { t, select: Some(Target::Girder(girder)), look: Look::Girder(girder) }
    }

    /// The girder of a largest value, at its time.
    fn of_girder(largest: GirderExtreme) -> Self {
        Self::girder(largest.girder, largest.extreme.t)
    }

    /// A corner of a girder, by both numbers.
    pub(in crate::app) fn corner(girder: usize, corner: usize, t: f64) -> Self {
        Self { t, select: Some(Target::Girder(girder)), look: Look::Corner(girder, corner) }
    }

    /// A contact, by its number.
    pub(in crate::app) fn contact(contact: usize, t: f64) -> Self {
        Self { t, select: Some(Target::Contact(contact)), look: Look::Contact(contact) }
    }

    /// The same moment and camera; what is selected stays selected.
    pub(in crate::app) fn keeping_selection(self) -> Self {
        Self { select: None, ..self }
    }

    /// The peak of a touch.
    pub(in crate::app) fn touch(touch: &Touch) -> Self {
        Self::contact(touch.contact, touch.peak_time)
    }

    /// A contact just before it leaves its face: from then on it is open, and there is nothing to be seen of it.
    pub(in crate::app) fn end_of_touch(history: &History, dropped: &Dropped) -> Self {
        let mut touches = history.hits().touches().iter().filter(|touch| touch.contact == dropped.contact);
        let ends = touches.find(|touch| (touch.start..=touch.end).contains(&dropped.t));
        let t = ends.map_or(dropped.t, |touch| dropped.t - BEFORE_THE_END * (dropped.t - touch.start));
        Self::contact(dropped.contact, t)
    }

    /// Where what moves farthest is then.
    pub(in crate::app) fn farthest(history: &History) -> Option<Self> {
        history.largest_motion().map(|largest| Self::of_girder(largest.displacement))
    }

    /// Where what turns most is turned most.
    pub(in crate::app) fn most_turned(history: &History) -> Option<Self> {
        history.largest_motion().map(|largest| Self::of_girder(largest.rotation))
    }

    /// The largest force between two bodies, at the contact that has most of it; the hardest touch where all are impulses.
    pub(in crate::app) fn hardest(history: &History) -> Option<Self> {
        let Some((of, most)) = history.hits().hardest_pounding() else {
            return history.hits().hardest().map(Self::touch);
        };
        history.hits().strongest_contact(of.pair, most.t).map(|contact| Self::contact(contact, most.t))
    }

    /// The largest force on a girder, at the contact that has most of it, and that force.
    pub(in crate::app) fn hardest_on(history: &History, girder: usize) -> Option<(Self, Extreme)> {
        let (pair, most) = history.hits().largest_total_on(girder)?;
        let spot = Self::contact(history.hits().strongest_contact(pair, most.t)?, most.t);
        Some((spot, most))
    }

    /// The largest force of a device, at its girder.
    pub(in crate::app) fn device(history: &History, reading: &DeviceReading) -> Option<Self> {
        let device = history.model().devices.get(reading.device)?;
        let girder = history.scene().device(device.id)?;
        let girder = history.scene().girders.iter().position(|known| known.name == girder.part().ends().girder)?;
        let look = Look::Girder(girder);
        Some(Self { t: reading.force.t, select: Some(Target::Device(device.id)), look })
    }

    /// The beginning of the first touch.
    pub(in crate::app) fn first_touch(history: &History) -> Option<Self> {
        history.hits().touches().first().map(|touch| Self::contact(touch.contact, touch.start))
    }

    /// Spot that decides a verdict on a girder.
    pub(in crate::app) fn verdict(girder: usize, verdict: &Verdict) -> Self {
        let t = verdict.t();
        verdict.corner().map_or(Self::girder(girder, t), |corner| Self::corner(girder, corner, t))
    }

    /// The end of a girder at the gap of its pairs that is least then; the girder where it has none.
    pub(in crate::app) fn gap(history: &History, girder: usize, t: f64) -> Self {
        let pairs = history.model().pairs.iter().enumerate();
        let own = pairs.filter(|(_, pair)| !pair.met && pair.bodies.contains(&Some(girder)));
        let at = |pair: usize| Quantity::Pair(pair, OfPair::Gap).at(history, t);
        let least = own.min_by(|(a, _), (b, _)| at(*a).total_cmp(&at(*b)));
        let sides = least.into_iter().flat_map(|(_, pair)| [pair.first, pair.second]);
        let mut ends = sides.filter_map(|side| match side {
            Side::Girder(number, end) if number == girder => Some(end),
            _ => None,
        });
        let look = ends.next().map_or(Look::Girder(girder), |end| Look::End(girder, end));
        Self { t, select: Some(Target::Girder(girder)), look }
    }

    /// Where a limit is passed for the first time.
    pub(in crate::app) fn passed(history: &History, passed: &Passed) -> Option<Self> {
        let model = history.model();
        // A bearing is seen with its girder.
        let whose = |name: &str| name == passed.whose || passed.whose.starts_with(&format!("{name}.bearing"));
        if let Some(girder) = model.girders().iter().position(|body| whose(&body.name)) {
            let look = passed.end.map_or(Look::Girder(girder), |end| Look::End(girder, end));
            return Some(Self { look, ..Self::girder(girder, passed.t) });
        }
        if let Some(pier) = history.scene().piers.iter().position(|pier| pier.name == passed.whose) {
            let scene = history.scene();
            let stands = |girder: &Girder| scene.standing(girder).contains(&StandsOn::Pier(pier));
            let stands = scene.girders.iter().position(stands);
            let look = Look::Girder(stands?);
            return Some(Self { t: passed.t, select: Some(Target::Pier(pier)), look });
        }
        let ours = |touch: &&Touch| model.pairs[touch.pair].name == passed.whose;
        let mut touches = history.hits().touches().iter().filter(ours);
        let touch = touches.find(|touch| (touch.start..=touch.end).contains(&passed.t))?;
        Some(Self::contact(touch.contact, passed.t))
    }

    /// Commands that lead there.
    pub(in crate::app) fn go(self, out: &mut Vec<Command>) {
        out.push(TimeCommand::StandAt(self.t).into());
        out.extend(self.select.map(|target| SelectCommand::Only(Some(target)).into()));
        out.push(ViewCommand::Look(self.look).into());
    }
}
