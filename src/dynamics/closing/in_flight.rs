//! The next closing of a pair in flight, by conservative advancement.
//!
//! All open contacts of the pair are advanced together: each evaluation takes the states of both flights once, and
//! the advance is the smallest that a contact allows. A pair whose gaps stay positive for the rest of the run is
//! searched again only after an event of one of its bodies.

use crate::contact::{Local, locate};
use crate::dynamics::ContactSite;
use crate::dynamics::closing::flight_view::{FlightSample, farthest, horizon, remember};
use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::closing::shared::{Shared, in_block};
use crate::dynamics::closing::step_samples::resolution_of;
use crate::dynamics::locate::advancement::{AdvanceOutcome, Advancement, BoundedGap, FirstZero, polish};
use crate::dynamics::locate::constants::MAX_ADVANCES;
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::root::root;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::world::World;
use crate::dynamics::world::site_geometry::SiteGeometry;
use crate::dynamics::world::tracks::PairTrack;

/// An open contact under search.
struct OpenContact<'a> {
    contact: usize,
    site: &'a ContactSite,
    geometry: SiteGeometry,
    /// Side of the pair that owns the node, and side that owns the face; `None` for an abutment.
    sides: [Option<usize>; 2],
    /// Sections of the pair's bodies that node and face are of.
    sections: [usize; 2],
    advancement: Advancement,
}

impl OpenContact<'_> {
    fn local(&self, sample: &FlightSample) -> Local {
        let frame = |which: usize| self.sides[which].map_or(&self.site.stand, |side| &sample.frames[side]);
        locate(&self.site.geometry, frame(0), frame(1))
    }

    fn bounded_gap(&self, sample: &FlightSample) -> BoundedGap {
        let still = MotionBounds::still(sample.between.window);
        let bound = |which: usize| self.sides[which].map_or(&still, |side| &sample.bounds[side]);
        self.geometry.bounded_gap(&self.local(sample), bound(0), bound(1), &sample.between)
    }
}

/// Searches a pair from `t` on: enters the closings of the contacts that close first, and returns the time of the
/// closing or of the end of the search, infinite without either \[s\].
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64, shared: &mut Shared) -> NextClosing {
    let duration = world.model.duration;
    let until = horizon(world, world.pairs[pair].slots, t);
    remember(world, world.pairs[pair].slots, until);
    let present = &*world;
    let mut evaluations = 1;
    let known = farthest(present, [t, until]);
    let first = shared.flight_sample(present, pair, [t, known]);
    let until = if in_block(present, pair) { until.min(t + first.between.window) } else { until };
    let mut open_contacts = open(present, pair, [t, known], &first);
    // Contacts armed at `t`; the search can arm others later.
    let armed: Vec<usize> = open_contacts.iter().filter(|q| q.advancement.armed()).map(|q| q.contact).collect();
    let never_closes =
        !open_contacts.iter().any(|q| !(q.advancement.out_of_reach() && first.between.window >= duration - t));
    let (end, closing) = if never_closes {
        (duration, Vec::new())
    } else {
        advance_all(present, pair, &mut open_contacts, [t, until], &mut evaluations)
    };
    let found = if closing.is_empty() { FirstZero::NoneUntil(end) } else { FirstZero::Crossing(end) };
    let rearmed: Vec<(usize, Option<f64>)> =
        open_contacts.iter().map(|q| (q.contact, q.advancement.rearmed_at())).collect();
    for contact in world.pairs[pair].contacts.clone() {
        world.contacts[contact].found.closing = None;
    }
    for (contact, at) in rearmed {
        world.contacts[contact].found.rearmed_at = at;
    }
    for contact in armed {
        world.contacts[contact].state = Contact::Open { armed: true };
    }
    for (contact, at) in closing {
        world.contacts[contact].found.closing = Some(at);
    }
    NextClosing::of(found, duration, evaluations)
}

/// The open corners of a pair (edge nodes are of spatial girders, which have no flight in closed form); a disarmed one whose gap is positive is armed again.
fn open<'a>(world: &'a World, pair: usize, [t, until]: [f64; 2], sample: &FlightSample) -> Vec<OpenContact<'a>> {
    let PairTrack { slots, sections: own, .. } = world.pairs[pair];
    let moved: f64 = sample.frames.iter().map(|frame| frame.shift.length()).sum();
    let open_contact = |contact: usize| {
        let track = &world.contacts[contact];
        if world.model.sites[track.site].edge.is_some() {
            return None;
        }
        let Contact::Open { armed } = track.state else { return None };
        let side = |slot: Option<usize>| slot.map(|slot| usize::from(Some(slot) == slots[1]));
        let (site, geometry) = (&world.model.sites[track.site], track.geometry);
        let unsampled = BoundedGap { gap: 0.0, rate: 0.0, curvature: 0.0, window: 0.0, out_of_reach: false };
        let advancement = Advancement::begin(unsampled, false, 0.0);
        let mut sections = own;
        for (slot, section) in track.slots.into_iter().zip(track.sections).filter(|(slot, _)| slot.is_some()) {
            sections[usize::from(slot == slots[1])] = section;
        }
        let sides = track.slots.map(side);
        let mut open_contact = OpenContact { contact, site, geometry, sides, sections, advancement };
        let of_corner = (sections != own).then(|| FlightSample::of(world, slots, sections, t, until));
        let sample = of_corner.as_ref().unwrap_or(sample);
        let (here, resolution) = (open_contact.bounded_gap(sample), resolution_of(world, contact, moved));
        let armed = armed || is_positive_again(here.gap, here.rate, t, resolution);
        open_contact.advancement = Advancement::begin(here, armed, resolution);
        Some(open_contact)
    };
    world.pairs[pair].contacts.clone().filter_map(open_contact).collect()
}

/// Advances until a contact closes or the search ends: that time \[s\] and the contacts that close then.
fn advance_all(
    world: &World,
    pair: usize,
    open_contacts: &mut [OpenContact<'_>],
    [mut t, until]: [f64; 2],
    evaluations: &mut u64,
) -> (f64, Vec<(usize, f64)>) {
    let at_once: Vec<(usize, f64)> =
        open_contacts.iter().filter(|q| q.advancement.crosses_now()).map(|q| (q.contact, t)).collect();
    if !at_once.is_empty() {
        return (t, at_once);
    }
    let mut samples = FlightSamples { world, pair, until, taken: Vec::new() };
    for _ in 0..MAX_ADVANCES {
        if t >= until {
            break;
        }
        let advance =
            open_contacts.iter_mut().map(|q| q.advancement.step()).enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((shortest, advance)) = advance else { break };
        if t + advance >= until && open_contacts.iter().all(|q| q.advancement.armed()) {
            // All are open up to the end for certain: no look there.
            t = until;
            break;
        }
        let next = (t + advance).min(until);
        if next <= t {
            // The advance is below the resolution of the time: the gap is zero to rounding, and a contact that is
            // armed closes.
            let contact_at = &open_contacts[shortest];
            return (t, if contact_at.advancement.armed() { vec![(contact_at.contact, t)] } else { Vec::new() });
        }
        samples.taken.clear();
        let closed: Vec<(usize, f64)> =
            open_contacts.iter_mut().filter_map(|q| closing_at(q, [t, next], &mut samples)).collect();
        *evaluations += samples.taken.len() as u64;
        if let Some(first) = closed.iter().map(|(_, at)| *at).min_by(f64::total_cmp) {
            return (first, with_simultaneous(world, pair, open_contacts, closed, first));
        }
        t = next;
    }
    (t, Vec::new())
}

/// Samples of a pair's flights near one time, kept because the contacts of a flush face ask for equal times.
struct FlightSamples<'a> {
    world: &'a World,
    pair: usize,
    until: f64,
    taken: Vec<(f64, [usize; 2], FlightSample)>,
}

impl FlightSamples<'_> {
    fn at(&mut self, t: f64, sections: [usize; 2]) -> FlightSample {
        if let Some((.., sample)) = self.taken.iter().find(|(at, of, _)| *at == t && *of == sections) {
            return *sample;
        }
        let sample = FlightSample::of(self.world, self.world.pairs[self.pair].slots, sections, t, self.until);
        self.taken.push((t, sections, sample));
        sample
    }
}

/// Closing of a contact if its sample at `next` shows one: number of the contact and time \[s\].
fn closing_at(
    open_contact: &mut OpenContact<'_>,
    [t, next]: [f64; 2],
    samples: &mut FlightSamples<'_>,
) -> Option<(usize, f64)> {
    let sections = open_contact.sections;
    let gap_there = open_contact.bounded_gap(&samples.at(next, sections));
    let outcome = open_contact.advancement.advance(gap_there, next);
    let (open_contact, until) = (&*open_contact, samples.until);
    let mut bounded_gap_at = |at: f64| open_contact.bounded_gap(&samples.at(at, sections));
    match outcome {
        AdvanceOutcome::Open => None,
        AdvanceOutcome::Closed => {
            let open = open_contact.advancement.last_open(t, next);
            Some((open_contact.contact, root(|at| -bounded_gap_at(at).gap, open, next)))
        }
        AdvanceOutcome::Closing => Some((open_contact.contact, polish(&mut bounded_gap_at, next, &gap_there, until))),
    }
}

/// Adds the contacts that close within the simultaneity interval of the first.
fn with_simultaneous(
    world: &World,
    pair: usize,
    open_contacts: &[OpenContact<'_>],
    mut closed: Vec<(usize, f64)>,
    first: f64,
) -> Vec<(usize, f64)> {
    if closed.len() < open_contacts.len() {
        let at = first + world.pairs[pair].simultaneity;
        let mut samples = FlightSamples { world, pair, until: at, taken: Vec::new() };
        for open_contact in open_contacts.iter().filter(|q| q.advancement.armed()) {
            if closed.iter().all(|(contact, _)| *contact != open_contact.contact)
                && open_contact.local(&samples.at(at, open_contact.sections)).gap < 0.0
            {
                closed.push((open_contact.contact, at));
            }
        }
    }
    closed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::model::coordinates::planar::PlanarState;
    use crate::dynamics::penalty3d::example::{free_to_turn, wall};
    use crate::dynamics::world::example::in_flight;

    /// Half of the girder's length and width \[m\].
    const HALF: [f64; 2] = [0.095, 0.035];

    fn flight(state: PlanarState) -> World {
        in_flight(&free_to_turn(wall()), &[state])
    }

    fn due(world: &mut World) -> f64 {
        super::search(world, 0, 0.0, &mut Shared::default()).due
    }

    #[test]
    fn a_girder_that_turns_in_place_reaches_its_wall_with_the_corner_that_swings_out() {
        let gap = 2e-3;
        // The corner at (95, ∓35) mm swings on a circle, at the angle ∓φ at first: out to the wall where its cosine is (95 + 2)/r.
        let (radius, first) = (HALF[0].hypot(HALF[1]), (HALF[1] / HALF[0]).atan());
        for spin in [0.8, -0.8] {
            let mut world = flight([-gap, 0.0, 0.0, 0.0, 0.0, spin]);
            let swing = first - ((HALF[0] + gap) / radius).acos();
            let expected = swing / f64::abs(spin);
            let found = due(&mut world);
            assert!((found - expected).abs() < 1e-12, "{found} s is not {expected} s at {spin} rad/s");
            for contact in [0, 1] {
                let swings_out = world.site(contact).point.y * spin < 0.0;
                assert_eq!(world.contacts[contact].found.closing.is_some(), swings_out, "contact {contact}");
            }
        }
    }

    #[test]
    fn both_corners_of_an_end_that_comes_squarely_close_together() {
        let mut world = flight([-1e-3, 0.0, 0.0, 0.5, 0.1, 0.0]);
        let found = due(&mut world);
        assert!((found - 2e-3).abs() < 1e-14, "1 mm at 0.5 m/s: {found} s");
        assert!([0, 1].iter().all(|&contact| world.contacts[contact].found.closing.is_some()));
    }

    #[test]
    fn a_girder_that_flies_off_closes_nothing_for_the_rest_of_the_run() {
        let mut world = flight([-1e-3, 0.0, 0.0, -0.5, 0.1, 0.0]);
        world.contacts[0].found.closing = Some(0.3);
        assert_eq!(due(&mut world), f64::INFINITY);
        assert_eq!(world.contacts[0].found.closing, None, "what an earlier search has found is forgotten");
    }

    #[test]
    fn a_disarmed_corner_closes_once_its_gap_has_been_positive_again() {
        for (x, armed) in [(-1e-3, true), (1e-3, false)] {
            let mut world = flight([x, 0.0, 0.0, 0.5, 0.1, 0.0]);
            for contact in [0, 1] {
                world.contacts[contact].state = Contact::Open { armed: false };
            }
            let found = due(&mut world);
            assert_eq!(found.is_finite(), armed, "at {x} m it moves in, found at {found} s");
            assert_eq!(world.contacts[0].state, Contact::Open { armed }, "at {x} m");
        }
    }
}
