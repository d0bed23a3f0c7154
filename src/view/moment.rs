//! One instant of a run, gathered in one place: all that a picture needs to know of physics.

use glam::{DMat3, DQuat, DVec3};

use super::ViewInput;
use super::piers::{self, Pier};
use super::scale::{auto_force_scale, auto_impulse_scale};
use super::walls::{self, Wall};
use crate::geometry::{End, Prism};
use crate::scene::facing::{self, Side};
use crate::scene::{FrictionLaw, Girder, Motion as GroundMotion, Scene, placed};
use crate::sim::seats::seat_on::SeatOn;
use crate::sim::{Carrying, ContactNow, GirderState, History, Hit, LinkNow, Motion, Overlap, SolidId, moving_ground};

/// Impulses that fade at once, at most: the latest.
const MOST_IMPULSES: usize = 24;

/// Two ends that face each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facing {
    /// A girder's end.
    pub first: Side,
    /// A girder's end or an abutment.
    pub second: Side,
}

/// A contact that opened a moment ago.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opened {
    /// Its number.
    pub contact: usize,
    /// Point at which it parted \[m\].
    pub point: DVec3,
}

/// A hit of the impact model that fades.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impulse {
    /// Point of action \[m\].
    pub point: DVec3,
    /// All of it, on the first side's girder \[N·s\].
    pub impulse: DVec3,
    /// Rest of its brightness, from 1 at the hit down to 0.
    pub left: f64,
    /// A contact that touched.
    pub contact: usize,
}

/// An overlap of two bodies that no contact carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverlapNow {
    /// The two bodies.
    pub bodies: [SolidId; 2],
    /// Depth of the overlap, along the shortest way out \[m\].
    pub depth: f64,
    /// Place of the greatest depth \[m\].
    pub place: DVec3,
}

/// Remaining seat under an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeatNow {
    /// The girder.
    pub girder: usize,
    /// Its end.
    pub end: End,
    /// The front edge of the seat, as long as the end, at the underside of the girder as placed \[m\].
    pub edge: [DVec3; 2],
    /// Remaining length at the corners, square to the edge, in the order of [`Prism::end_corners`]; negative off it \[m\].
    pub remaining: [f64; 2],
}

impl SeatNow {
    /// Whether a corner is off it.
    pub(super) fn is_left(&self) -> bool {
        self.remaining[0].min(self.remaining[1]) < 0.0
    }
}

/// One instant of a run, or a scene as placed.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// When; nothing as placed \[s\].
    pub t: Option<f64>,
    /// Motion of each girder.
    pub motions: Vec<Motion>,
    /// Motion of the end sections of each girder, in the order of [`End::BOTH`]; none where no girder bends, and they move as it does.
    pub ends: Vec<[Motion; 2]>,
    /// Facing ends.
    pub facings: Vec<Facing>,
    /// Closed contacts.
    pub contacts: Vec<ContactNow>,
    /// Whether each bearing of each girder carries it; of a girder none where all always do.
    pub carrying: Vec<Vec<Carrying>>,
    /// Displacement of the ground under each bearing of each girder \[m\]; none where the ground moves as one.
    pub feet: Vec<Vec<DVec3>>,
    /// Backwalls by abutment; `None` for those that stand, none where all do.
    pub walls: Vec<Option<Wall>>,
    /// Piers.
    pub piers: Vec<Pier>,
    /// Devices between two points.
    pub devices: Vec<LinkNow>,
    /// Overlaps that no contact carries.
    pub overlaps: Vec<OverlapNow>,
    /// Seats that the scene gives.
    pub seats: Vec<SeatNow>,
    /// Contacts that opened a moment ago.
    pub opened: Vec<Opened>,
    /// The friction laws in use; empty where nothing can touch.
    pub laws: Vec<FrictionLaw>,
    /// Motion of each girder by the other model, where the answer has it beside this one.
    pub ghosts: Vec<Motion>,
    /// State of each girder under the impact model, this one or the one beside; empty without.
    pub states: Vec<GirderState>,
    /// Hits of the impact model a moment ago.
    pub impulses: Vec<Impulse>,
    /// Scale of the impulses' arrows, where there are any in the run \[N·s/m\].
    pub impulse_scale: Option<f64>,
    /// Gaps as they are, where motions are shown larger than they are; empty where they are not \[m\].
    pub true_gaps: Vec<Option<f64>>,
    /// Scale of the arrows, where there can be any \[N/m\].
    pub force_scale: Option<f64>,
}

impl Moment {
    /// The backwall of an abutment that moves.
    pub(super) fn wall(&self, abutment: usize) -> Option<&Wall> {
        self.walls.get(abutment)?.as_ref()
    }

    /// Whether a bearing carries its girder.
    pub(super) fn carrying(&self, girder: usize, bearing: usize) -> Carrying {
        self.carrying.get(girder).and_then(|all| all.get(bearing)).copied().unwrap_or_default()
    }

    /// Motion of the end section of a girder.
    pub(super) fn end(&self, girder: usize, end: End) -> Option<&Motion> {
        let number = End::BOTH.iter().position(|other| *other == end)?;
        self.ends.get(girder).map(|both| &both[number]).or_else(|| self.motions.get(girder))
    }

    /// Moment of `input`: the history at `t`, or the scene as placed.
    pub fn of(input: &ViewInput<'_>) -> Self {
        let mut moment = match input.history {
            Some(history) => Self::at(history, input.t),
            None => Self::placed(input.scene),
        };
        moment.force_scale = force_scale(input);
        moment
    }

    /// A run at `t`, clamped to what was computed.
    pub fn at(history: &History, t: f64) -> Self {
        let scene = history.scene();
        let t = if t.is_finite() { t.clamp(0.0, history.end()) } else { 0.0 };
        let model = history.model();
        let contacts = history.contacts().at(t);
        let by_impulses = [Some(history), history.beside()].into_iter().flatten().find(|h| h.impact().is_some());
        let record = by_impulses.and_then(History::impact);
        let fading = |history| impulses(history, t, 2.0 * linger(scene));
        Self {
            ghosts: history
                .beside()
                .map_or(Vec::new(), |beside| (0..model.girders().len()).map(|i| beside.motion(i, t)).collect()),
            states: record
                .map_or(Vec::new(), |record| (0..model.girders().len()).map(|body| record.state(body, t)).collect()),
            impulses: by_impulses.map_or(Vec::new(), fading),
            impulse_scale: by_impulses.and_then(auto_impulse_scale),
            t: Some(t),
            motions: (0..model.girders().len()).map(|i| history.motion(i, t)).collect(),
            ends: ends(history, t),
            facings: model
                .pairs
                .iter()
                .filter(|p| !p.met)
                .map(|p| Facing { first: p.first, second: p.second })
                .collect(),
            opened: just_opened(history, t, linger(scene), &contacts),
            contacts,
            carrying: (0..model.girders().len()).map(|girder| history.seats().carrying(girder, t)).collect(),
            feet: moving_ground::under_bearings(history, t),
            walls: walls::at(scene, Some((history, t))),
            piers: piers::at(scene, Some((history, t))),
            devices: history.connections().links(t),
            overlaps: overlaps(history, t),
            seats: seats(history, t),
            laws: match history.impact() {
                Some(_) => Vec::new(),
                None => distinct(model.pairs.iter().map(|p| p.contact.law)),
            },
            true_gaps: Vec::new(),
            force_scale: Some(auto_force_scale(history)),
        }
    }

    /// A scene as placed, before it has been run.
    pub fn placed(scene: &Scene) -> Self {
        let pairs = facing::find(scene).unwrap_or_default();
        Self {
            t: None,
            motions: scene.girders.iter().map(at_rest).collect(),
            ends: Vec::new(),
            facings: pairs.iter().map(|p| Facing { first: p.first, second: p.second }).collect(),
            contacts: Vec::new(),
            carrying: Vec::new(),
            feet: Vec::new(),
            walls: walls::at(scene, None),
            piers: piers::at(scene, None),
            devices: Vec::new(),
            overlaps: Vec::new(),
            seats: Vec::new(),
            opened: Vec::new(),
            laws: distinct(pairs.iter().map(|p| p.contact.law)),
            ghosts: Vec::new(),
            states: Vec::new(),
            impulses: Vec::new(),
            impulse_scale: None,
            true_gaps: Vec::new(),
            force_scale: None,
        }
    }
}

/// Motion of the end sections of all girders, where one of them bends.
fn ends(history: &History, t: f64) -> Vec<[Motion; 2]> {
    let girders = 0..history.model().girders().len();
    if !girders.clone().any(|girder| history.sections().flexible(girder).is_some()) {
        return Vec::new();
    }
    girders.map(|girder| End::BOTH.map(|end| history.end_motion(girder, end, t))).collect()
}

/// Overlaps at an instant.
fn overlaps(history: &History, t: f64) -> Vec<OverlapNow> {
    let now = history.overlaps().iter().filter(|overlap| overlap.lasts_at(t));
    let depth = |overlap: &Overlap| overlap.depth_at(history, t);
    now.map(|o| OverlapNow { bodies: o.bodies, depth: depth(o), place: o.place }).collect()
}

/// Every seat at an instant.
fn seats(history: &History, t: f64) -> Vec<SeatNow> {
    let ends = (0..history.model().girders().len()).flat_map(|girder| End::BOTH.map(|end| (girder, end)));
    ends.filter_map(|(girder, end)| {
        let ledge = history.seats().ledge(girder, end)?;
        let remaining = history.seats().corners_at(girder, &ledge, t).map(|[_, remaining]| remaining);
        let body = &history.model().bodies[girder];
        let back = ledge.normal * ledge.placed();
        let edge = Prism::end_corners(end).map(|corner| body.home + body.axes * body.prism.corners()[corner] - back);
        let edge = match ledge.on {
            SeatOn::Pier(pier) => edge.map(|place| carried(history, pier, place, t)),
            SeatOn::Moved(motion) => edge.map(|place| place + moving_ground::displacement(history, motion, t)),
            SeatOn::Ground => edge,
        };
        Some(SeatNow { girder, end, edge, remaining })
    })
    .collect()
}

/// Position at `t` of a place as placed, carried by a body that turns in plan alone \[m\].
fn carried(history: &History, body: usize, place: DVec3, t: f64) -> DVec3 {
    let (home, motion) = (history.model().bodies[body].home, history.motion(body, t));
    home + motion.displacement + DMat3::from_rotation_z(motion.theta) * (place - home)
}

/// Scale of the arrows: of the input, else of the scene, else from the run's peak \[N/m\].
fn force_scale(input: &ViewInput<'_>) -> Option<f64> {
    let usable = |s: &f64| s.is_finite() && *s > 0.0;
    let asked = input.force_scale.filter(usable).or(input.scene.view.force_scale.filter(usable));
    asked.or_else(|| input.history.map(auto_force_scale))
}

/// A girder's motion as placed: none.
pub fn at_rest(girder: &Girder) -> Motion {
    let axes: DMat3 = placed::axes(girder);
    Motion {
        place: DVec3::from(girder.position),
        displacement: DVec3::ZERO,
        theta: 0.0,
        attitude: DQuat::from_mat3(&axes),
        velocity: DVec3::ZERO,
        spin: DVec3::ZERO,
    }
}

/// Hits of the last moment, the latest last.
fn impulses(history: &History, t: f64, linger: f64) -> Vec<Impulse> {
    let Some(record) = history.impact() else { return Vec::new() };
    let until = record.hits.partition_point(|hit| hit.t <= t);
    let recent = record.hits[..until].iter().rev().take_while(|hit| hit.t > t - linger).take(MOST_IMPULSES);
    let height = |body: Option<usize>| body.map_or(0.0, |body| history.motion(body, t).place.z);
    let impulse = |hit: &Hit| {
        let [normal, tangential] = hit.impulses.total();
        let pair = &history.model().pairs[hit.pair];
        let n = hit.impulses.normal;
        let flat = n * normal + n.perp() * tangential;
        Impulse {
            point: hit.point.extend(height(pair.bodies.into_iter().flatten().next())),
            impulse: flat.extend(0.0),
            left: 1.0 - (t - hit.t) / linger,
            contact: hit.sites.first().copied().unwrap_or(pair.sites.start),
        }
    };
    let mut all: Vec<Impulse> = recent.map(impulse).collect();
    all.reverse();
    all
}

/// The period of a harmonic motion \[s\].
pub fn period(scene: &Scene) -> Option<f64> {
    match &scene.motion {
        GroundMotion::Sine(sine) if sine.frequency_hz > 0.0 => Some(1.0 / sine.frequency_hz),
        _ => None,
    }
}

/// Time for which an opened contact stays marked \[s\]: a tenth of the period of a sine, else a hundredth of the duration, from 0.01 s
/// to 0.2 s (chosen).
fn linger(scene: &Scene) -> f64 {
    period(scene).map_or((scene.duration / 100.0).clamp(0.01, 0.2), |p| p / 10.0)
}

fn just_opened(history: &History, t: f64, linger: f64, closed: &[ContactNow]) -> Vec<Opened> {
    let mut opened: Vec<Opened> = Vec::new();
    // A hit without length has no contact to open.
    let ended = history
        .hits()
        .touches()
        .iter()
        .filter(|u| u.end > u.start)
        .filter(|u| u.end <= t && u.end > t - linger && u.end < history.end());
    for touch in ended {
        let again = closed.iter().any(|c| c.contact == touch.contact);
        // Between the peak and the end the contact is closed; close to the end it is nearly where it parted.
        let before = touch.end - 1e-3 * (touch.end - touch.start);
        let last = history.contacts().at(before).into_iter().find(|c| c.contact == touch.contact);
        if let (false, Some(last)) = (again, last) {
            opened.retain(|o| o.contact != touch.contact);
            opened.push(Opened { contact: touch.contact, point: last.point });
        }
    }
    opened
}

fn distinct(laws: impl Iterator<Item = FrictionLaw>) -> Vec<FrictionLaw> {
    let laws: Vec<_> = laws.collect();
    FrictionLaw::ALL.iter().copied().filter(|law| laws.contains(law)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Initial, Motion, Seat, presets};

    #[test]
    fn a_turned_deck_has_its_acute_corners_off() {
        let mut scene = presets::load("skew60-abutment").expect("ships");
        (scene.motion, scene.duration) = (Motion::None, 0.01);
        scene.abutments.clear();
        scene.contact.pairs.clear();
        let girder = &mut scene.girders[0];
        // 1° takes 1.3 mm off the acute corners, 0.3 mm off the obtuse ones.
        girder.initial = Initial { rotation_deg: 1.0, ..Initial::default() };
        girder.seat = Seat { plus: Some(0.001), minus: Some(0.001), side: None };
        let history = History::of(&scene).expect("runs");
        let left =
            |history: &History, t: f64| seats(history, t).into_iter().filter(SeatNow::is_left).collect::<Vec<_>>();
        let off = left(&history, 0.0);
        assert_eq!(off.iter().map(|off| off.end).collect::<Vec<_>>(), End::BOTH, "both ends, by symmetry");
        let [plus, minus] = off.as_slice() else { panic!("two") };
        assert!(plus.remaining[0] > 0.0 && plus.remaining[1] < 0.0, "+y at +x: {plus:?}");
        assert!(minus.remaining[1] > 0.0 && minus.remaining[0] < 0.0, "−y at −x: {minus:?}");
        assert!(
            left(&History::of(&presets::load("skew60-abutment").expect("ships")).expect("runs"), 1.0).is_empty(),
            "no seats"
        );
    }
}
