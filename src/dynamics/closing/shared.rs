//! Results that the searches of all pairs of two bodies share at one time: poses, and the time up to which the bodies are apart.
//!
//! Between two bodies that have met every face of one has a pair with every face of the other. While the bodies are apart, nodes cross
//! planes of faces outside the polygons, which is no closing. The pairs are therefore searched from the time on at which the bodies can
//! touch, and nodes are armed or disarmed then by the side of the plane on which they are. The distance of the bodies changes by at
//! most their relative displacement plus the displacement of their corners by rotation.

use glam::DVec3;
use smallvec::smallvec;

use crate::contact::Frame;
use crate::dynamics::closing::constants::{NEAR, PARTED_ADVANCES};
use crate::dynamics::closing::flight_view::{FlightSample, horizon, remember};
use crate::dynamics::closing::step_samples::{StepSamples, excursion};
use crate::dynamics::locate::advancement::FirstZero;
use crate::dynamics::locate::subdivision::GapClosing;
use crate::dynamics::model::meeting::Meeting;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::{PairTrack, SearchState};

/// Of searches from one time on, on the same trajectories.
#[derive(Default)]
pub(in crate::dynamics) struct Shared {
    samples: Option<StepSamples>,
    /// Last sample of two bodies in flight, with its slots, sections and time.
    sample: Option<(FlightKey, FlightSample)>,
    /// Number of a meeting, and how long its bodies stand apart.
    parted: Option<(usize, Parted)>,
}

/// Slots, sections, and time and horizon of a [`FlightSample`] \[s\].
type FlightKey = ([Option<usize>; 2], [usize; 2], [f64; 2]);

/// Time for which two bodies stand apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Parted {
    /// They are near, or have not met: every pair is searched.
    Near,
    /// Until this time in flight, from which on every pair is searched \[s\].
    Until(f64),
    /// Until the end of the search, this time; infinite where that is the end of the run \[s\].
    Throughout(f64),
}

impl Shared {
    /// Poses of a pair's bodies in the planned step from `t` to `until`.
    pub(super) fn samples(&mut self, world: &World, pair: usize, [t, until]: [f64; 2]) -> &mut StepSamples {
        let known = self.samples.take().filter(|samples| samples.are_of(world, pair, [t, until]));
        self.samples.insert(known.unwrap_or_else(|| StepSamples::begin(world, pair, t, until)))
    }

    /// Poses of a pair's bodies in flight at `t`, with bounds up to `until` at most.
    pub(super) fn flight_sample(&mut self, world: &World, pair: usize, [t, until]: [f64; 2]) -> FlightSample {
        let PairTrack { slots, sections, .. } = world.pairs[pair];
        let key = (slots, sections, [t, until]);
        match &self.sample {
            Some((known, sample)) if *known == key => *sample,
            _ => self.sample.insert((key, FlightSample::of(world, slots, sections, t, until))).1,
        }
    }

    /// Time for which the bodies of a pair stand apart from `t` on, in the planned step that ends at `step_end` or in flight. Nodes of the
    /// pair are armed or disarmed for the time from which it is searched.
    pub(super) fn parted(&mut self, world: &mut World, pair: usize, (t, step_end): (f64, Option<f64>)) -> Parted {
        let Some(meeting) = world.pairs[pair].meeting else { return Parted::Near };
        let parted = match (self.parted, step_end) {
            (Some((known, parted)), _) if known == meeting => parted,
            (_, Some(until)) => in_step(world, meeting, self.samples(world, pair, [t, until])),
            (_, None) => in_flight(world, (meeting, pair), t),
        };
        self.parted = Some((meeting, parted));
        match parted {
            Parted::Throughout(_) if part(world, pair) => parted,
            Parted::Throughout(_) => Parted::Near,
            Parted::Until(from) => {
                approach(world, pair, from);
                world.pairs[pair].search_state = SearchState::Searched;
                parted
            }
            Parted::Near => {
                if std::mem::take(&mut world.pairs[pair].search_state) != SearchState::Near {
                    approach(world, pair, t);
                }
                parted
            }
        }
    }
}

/// By the planes of the faces at the beginning of a planned step, and bounds on the way of all corners in it.
fn in_step(world: &World, meeting: usize, samples: &StepSamples) -> Parted {
    let (meeting, slots) = (&world.model.meetings[meeting], samples.slots);
    let [t, until] = [samples.times[0], samples.times[samples.times.len() - 1]];
    let reach =
        |side: usize| slots[side].map_or(0.0, |slot| excursion(world, slot, meeting.solids[side].radius, t, until));
    let apart = meeting.apart(&samples.met(world, meeting));
    if apart > reach(0) + reach(1) { Parted::Throughout(f64::INFINITY) } else { Parted::Near }
}

/// By conservative advancement: from a distance `d` on the bodies are `near` apart for as long as `(d − near)/v` at the least, with `v`
/// a bound on the speed at which it changes, and for as long as `v₀ τ + a τ²/2` is less, with the speed `v₀` at the look and a bound `a`
/// on its rate. It ends within twice `near`, so that a touch is always ahead of the time from which the pairs are searched.
fn in_flight(world: &mut World, (number, pair): (usize, usize), t: f64) -> Parted {
    let duration = world.model.duration;
    let mut until = horizon(world, world.pairs[pair].slots, t);
    remember(world, world.pairs[pair].slots, until);
    let in_block = in_block(world, pair);
    let meeting = &world.model.meetings[number];
    if meeting.solids.iter().any(|solid| solid.sections().len() > 1) {
        return in_flight_by_sections(world, (meeting, pair), [t, until]);
    }
    let near = NEAR * meeting.least_side;
    let mut from = t;
    for _ in 0..PARTED_ADVANCES {
        let sample = FlightSample::of_pair(world, pair, from, until);
        let apart = meeting.apart(&sample.frames.map(|frame| smallvec![frame]));
        if apart <= 2.0 * near {
            break;
        }
        let turning = |of: &dyn Fn(usize) -> f64| of(0) * meeting.solids[0].radius + of(1) * meeting.solids[1].radius;
        let window = sample.bounds.iter().map(|bound| bound.window).fold(sample.between.window, f64::min);
        if in_block {
            until = until.min(t + window);
        }
        let speed = sample.between.speed + turning(&|side| sample.bounds[side].spin);
        let [a, b] = &sample.frames;
        let now = (a.velocity - b.velocity).length() + turning(&|side| sample.frames[side].spin.length());
        let gains = turning(&|side| sample.bounds[side].spin_rate + sample.bounds[side].spin.powi(2));
        let advance = ((apart - near) / speed).max(soonest(apart - near, now, sample.between.acceleration + gains));
        from += advance.min(window);
        if from >= until {
            return Parted::Throughout(FirstZero::NoneUntil(until).due(duration));
        }
    }
    if from > t { Parted::Until(from) } else { Parted::Near }
}

/// [`in_flight`] of elastic girders: from the distance of the bodies in the poses of all sections at `t`, and bounds on the excursions of
/// all corners until the end of the search.
fn in_flight_by_sections(world: &World, (meeting, pair): (&Meeting, usize), [t, until]: [f64; 2]) -> Parted {
    let slots = world.pairs[pair].slots;
    let still = Frame::fixed(DVec3::ZERO);
    let poses = |side: usize| {
        meeting.solids[side].poses(|section| slots[side].map_or(still, |slot| world.frame(slot, section, t)))
    };
    let reach =
        |side: usize| slots[side].map_or(0.0, |slot| excursion(world, slot, meeting.solids[side].radius, t, until));
    if meeting.apart(&[poses(0), poses(1)]) > reach(0) + reach(1) {
        Parted::Throughout(FirstZero::NoneUntil(until).due(world.model.duration))
    } else {
        Parted::Near
    }
}

/// Least time to travel `way` \[m\] from speed `speed` \[m/s\] at an acceleration of at most `gain` \[m/s²\]: the root of `speed t + gain
/// t²/2 = way` \[s\].
fn soonest(way: f64, speed: f64, gain: f64) -> f64 {
    2.0 * way / (speed + (speed * speed + 2.0 * gain * way).sqrt())
}

/// Whether a body of a pair is of a linear block, of which any event ends the searches of all its pairs: none of these looks further than
/// the first bounds hold.
pub(super) fn in_block(world: &World, pair: usize) -> bool {
    world.pairs[pair].slots.into_iter().flatten().any(|slot| world.bodies[slot].block.is_some())
}

/// Ends the search of a pair whose bodies stand apart; `false` where one of its contacts is closed.
fn part(world: &mut World, pair: usize) -> bool {
    if world.pairs[pair].search_state == SearchState::Idle {
        return true;
    }
    let contacts = world.pairs[pair].contacts.clone();
    if contacts.clone().any(|contact| world.is_closed(contact)) {
        return false;
    }
    for contact in contacts {
        world.contacts[contact].found = GapClosing::NONE;
    }
    world.pairs[pair].search_state = SearchState::Idle;
    true
}

/// Arms the open nodes of a pair that are before their faces at `t`, and disarms those behind, beside the face.
fn approach(world: &mut World, pair: usize, t: f64) {
    for contact in world.pairs[pair].contacts.clone() {
        let track = &world.contacts[contact];
        if track.state.closed().is_none() {
            // An edge node needs no disarming: the sign of its gap is evaluated by its own search.
            let is_edge = world.model.sites[track.site].edge.is_some();
            let armed = is_edge || world.local(contact, t).gap > 0.0;
            let track = &mut world.contacts[contact];
            (track.state, track.found) = (Contact::Open { armed }, GapClosing::NONE);
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::contact::Mode;
    use crate::dynamics::penalty3d::contact_state::ClosedContact;
    use crate::dynamics::penalty3d::example::{met, row};
    use crate::dynamics::world::example::{flying, in_flight};

    /// Distance of two girders at t = 0 \[m\].
    const APART: f64 = 0.02;

    /// Two girders in a row that have met, the second `apart` beyond the first, which moves towards it at a speed; with the first
    /// of the pairs that their meeting has added.
    fn approaching(apart: f64, speed: f64) -> (World, usize) {
        let states = [[0.0, 0.0, 0.0, speed, 0.0, 0.0], [apart, 0.0, 0.0, 0.0, 0.0, 0.0]];
        let world = flying(met(&row()), &states);
        let pair = world.pairs.iter().position(|pair| pair.meeting.is_some()).expect("a pair of the meeting");
        (world, pair)
    }

    fn parted(world: &mut World, pair: usize) -> Parted {
        Shared::default().parted(world, pair, (0.0, None))
    }

    fn near(world: &World) -> f64 {
        NEAR * world.model.meetings[0].least_side
    }

    #[test]
    fn bodies_that_face_each_other_as_placed_are_searched_from_the_start() {
        let mut world = in_flight(&row(), &[[0.0; 6], [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]]);
        assert_eq!(parted(&mut world, 0), Parted::Near);
    }

    #[test]
    fn bodies_that_approach_are_searched_from_just_before_their_touch() {
        let (world, _) = approaching(APART, 0.0);
        let near = near(&world);
        for (apart, speed) in [(APART, 0.1), (3.0 * near, 0.1), (3.0 * near, 1e-3)] {
            let (mut world, pair) = approaching(apart, speed);
            let Parted::Until(from) = parted(&mut world, pair) else { panic!("they touch within the run") };
            let left = apart - speed * from;
            assert!(left > 0.99 * near && left <= 2.0 * near * (1.0 + 1e-9), "{left} m are left, {near} m is near");
            assert_eq!(world.pairs[pair].search_state, SearchState::Searched);
        }
        let (mut world, pair) = approaching(2.0 * near * (1.0 - 1e-6), 1e-3);
        assert_eq!(parted(&mut world, pair), Parted::Near, "within twice that they are near");
    }

    #[test]
    fn bodies_that_do_not_meet_within_the_run_are_not_searched() {
        // At 1 cm/s the girders are 1 cm apart at the end of the run of 1 s; the others part.
        for speed in [0.01, 0.0, -0.1] {
            let (mut world, pair) = approaching(APART, speed);
            let first = world.pairs[pair].contacts.start;
            world.contacts[first].found.closing = Some(0.5);
            assert_eq!(parted(&mut world, pair), Parted::Throughout(f64::INFINITY), "at {speed} m/s");
            assert_eq!(world.pairs[pair].search_state, SearchState::Idle);
            assert_eq!(world.contacts[first].found.closing, None, "what an earlier search has found is forgotten");
        }
    }

    #[test]
    fn bodies_apart_with_a_closed_contact_are_searched() {
        let (mut world, pair) = approaching(APART, -0.1);
        let law = world.model_pair(pair).law;
        let closed = ClosedContact::new(law, Mode::Slip { direction: DVec2::X }, 0.0);
        let first = world.pairs[pair].contacts.start;
        world.contacts[first].state = Contact::Closed(closed);
        assert_eq!(parted(&mut world, pair), Parted::Near);
    }

    #[test]
    fn near_each_other_open_nodes_are_armed_by_the_side_of_their_plane_once() {
        let (mut world, pair) = approaching(0.0, 0.1);
        world.pairs[pair].search_state = SearchState::Idle;
        assert_eq!(parted(&mut world, pair), Parted::Near);
        let contacts = world.pairs[pair].contacts.clone();
        for contact in contacts.clone() {
            let armed = world.local(contact, 0.0).gap > 0.0;
            assert_eq!(world.contacts[contact].state, Contact::Open { armed });
            world.contacts[contact].state = Contact::Open { armed: !armed };
        }
        assert_eq!(parted(&mut world, pair), Parted::Near);
        for contact in contacts {
            let armed = world.local(contact, 0.0).gap <= 0.0;
            assert_eq!(world.contacts[contact].state, Contact::Open { armed }, "searches see to them from then on");
        }
    }

    #[test]
    fn all_pairs_of_a_meeting_share_one_look() {
        let (mut world, pair) = approaching(APART, 0.1);
        let mut shared = Shared::default();
        let first = shared.parted(&mut world, pair, (0.0, None));
        assert_eq!(shared.parted(&mut world, pair + 1, (0.0, None)), first);
        assert_eq!(shared.parted, Some((0, first)));
    }

    #[test]
    fn the_soonest_time_is_that_of_a_constant_acceleration() {
        for (way, speed, gain) in [(0.3, 0.2, 9.81), (0.3, 0.0, 2.0), (1e-9, 0.5, 1e3)] {
            let t = soonest(way, speed, gain);
            assert!((speed * t + 0.5 * gain * t * t - way).abs() < 1e-15 + 1e-14 * way, "{t} s for {way} m");
        }
        assert_eq!((soonest(0.3, 0.5, 0.0), soonest(0.3, 0.0, 0.0)), (0.6, f64::INFINITY));
    }
}
