//! When a pair of which both sides fly or stand closes next: leaps over everything that cannot close a gap.
//!
//! All open contacts of the pair are searched together: each look asks both flights once, and the leap is the shortest
//! that any contact allows. A pair whose gaps are out of reach for good is not looked at again until somebody is hit.

use crate::contact::{Local, locate};
use crate::dynamics::ContactSite;
use crate::dynamics::closing::constants::CUT_SHORT;
use crate::dynamics::closing::flight_view::{View, horizon, remember};
use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::locate::advancement::{AdvanceOutcome, Advancement, BoundedGap, polish};
use crate::dynamics::locate::constants::MAX_ADVANCES;
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::root::root;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::world::World;
use crate::dynamics::world::site_geometry::SiteGeometry;

/// An open contact under search.
struct OpenContact<'a> {
    contact: usize,
    site: &'a ContactSite,
    spot: SiteGeometry,
    /// Which side of the pair owns the node, and which the face.
    sides: [Option<usize>; 2],
    advancement: Advancement,
}

impl OpenContact<'_> {
    fn look(&self, view: &View) -> Local {
        let frame = |which: usize| self.sides[which].map_or(&self.site.stand, |side| &view.frames[side]);
        locate(&self.site.home, frame(0), frame(1))
    }

    fn bounded_gap(&self, view: &View) -> BoundedGap {
        let still = MotionBounds::still(view.between.window);
        let bound = |which: usize| self.sides[which].map_or(&still, |side| &view.bounds[side]);
        self.spot.bounded_gap(&self.look(view), bound(0), bound(1), &view.between)
    }
}

/// Searches a pair from `t` on: enters the closing of each contact that closes first, and returns when the pair is to be
/// met or searched on; infinite when neither is needed \[s\].
pub(in crate::dynamics) fn search(world: &mut World, pair: usize, t: f64) -> NextClosing {
    let duration = world.model.duration;
    let until = horizon(&world.model.ground, t, duration);
    remember(world, world.pairs[pair].slots, until);
    let present = &*world;
    let mut looks = 1;
    let first = View::of(present, present.pairs[pair].slots, t, duration);
    let mut open_contacts = open(present, pair, t, &first);
    // Those that are in front now; a hunt may find others come out later.
    let armed: Vec<usize> = open_contacts.iter().filter(|q| q.advancement.armed()).map(|q| q.contact).collect();
    let out = !open_contacts.iter().any(|q| !(q.advancement.out_of_reach() && first.between.window >= duration - t));
    let (due, closing) = if out {
        (f64::INFINITY, Vec::new())
    } else {
        advance_all(present, pair, &mut open_contacts, [t, until], &mut looks)
    };
    let cut = closing.is_empty() && due < until;
    let out: Vec<(usize, Option<f64>)> =
        open_contacts.iter().map(|q| (q.contact, q.advancement.rearmed_at())).collect();
    for contact in world.pairs[pair].contacts.clone() {
        world.contacts[contact].closing = None;
    }
    for (contact, at) in out {
        world.contacts[contact].out = at;
    }
    for contact in armed {
        world.contacts[contact].state = Contact::Open { armed: true };
    }
    for (contact, at) in closing {
        world.contacts[contact].closing = Some(at);
    }
    NextClosing { due, looks, work: if cut { CUT_SHORT } else { 0 } }
}

/// The open contacts of a pair; a node that has come out in front is armed again.
fn open<'a>(world: &'a World, pair: usize, t: f64, view: &View) -> Vec<OpenContact<'a>> {
    let slots = world.pairs[pair].slots;
    let moved: f64 = view.frames.iter().map(|frame| frame.shift.length()).sum();
    let open_contact = |contact: usize| {
        let track = &world.contacts[contact];
        let Contact::Open { armed } = track.state else { return None };
        let side = |slot: Option<usize>| slot.map(|slot| usize::from(Some(slot) == slots[1]));
        let (site, spot) = (&world.model.contacts[track.site], track.spot);
        let unseen = BoundedGap { gap: 0.0, rate: 0.0, curvature: 0.0, window: 0.0, out_of_reach: false };
        let advancement = Advancement::begin(unseen, false, 0.0);
        let mut open_contact = OpenContact { contact, site, spot, sides: track.slots.map(side), advancement };
        let (here, resolution) = (open_contact.bounded_gap(view), RESOLUTION * (spot.size + moved));
        let armed = armed || is_positive_again(here.gap, here.rate, t, resolution);
        open_contact.advancement = Advancement::begin(here, armed, resolution);
        Some(open_contact)
    };
    world.pairs[pair].contacts.clone().filter_map(open_contact).collect()
}

/// Leaps until a contact closes or the search has come to its end: when the pair is due, and who closes then.
fn advance_all(
    world: &World,
    pair: usize,
    open_contacts: &mut [OpenContact<'_>],
    [mut t, until]: [f64; 2],
    looks: &mut u64,
) -> (f64, Vec<(usize, f64)>) {
    let at_once: Vec<(usize, f64)> =
        open_contacts.iter().filter(|q| q.advancement.crosses_now()).map(|q| (q.contact, t)).collect();
    if !at_once.is_empty() {
        return (t, at_once);
    }
    let mut views = Views { world, pair, until, seen: Vec::new() };
    for _ in 0..MAX_ADVANCES {
        if t >= until {
            break;
        }
        let leap =
            open_contacts.iter_mut().map(|q| q.advancement.step()).enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((shortest, leap)) = leap else { break };
        let next = (t + leap).min(until);
        if next <= t {
            // Less than the clock can tell.
            let stuck = &open_contacts[shortest];
            return (t, if stuck.advancement.armed() { vec![(stuck.contact, t)] } else { Vec::new() });
        }
        views.seen.clear();
        let there = views.at(next);
        let closed: Vec<(usize, f64)> =
            open_contacts.iter_mut().filter_map(|q| arrive(q, &there, [t, next], &mut views)).collect();
        *looks += views.seen.len() as u64;
        if let Some(first) = closed.iter().map(|(_, at)| *at).min_by(f64::total_cmp) {
            return (first, with_simultaneous(world, pair, open_contacts, closed, first));
        }
        t = next;
    }
    (if t >= world.model.duration { f64::INFINITY } else { t }, Vec::new())
}

/// Looks at a pair about one instant: contacts of a flush face ask for the same ones.
struct Views<'a> {
    world: &'a World,
    pair: usize,
    until: f64,
    seen: Vec<(f64, View)>,
}

impl Views<'_> {
    fn at(&mut self, t: f64) -> View {
        if let Some((_, view)) = self.seen.iter().find(|(at, _)| *at == t) {
            return *view;
        }
        let view = View::of(self.world, self.world.pairs[self.pair].slots, t, self.until);
        self.seen.push((t, view));
        view
    }
}

/// When a contact closes, if the look at `next` shows that it does.
fn arrive(
    open_contact: &mut OpenContact<'_>,
    there: &View,
    [t, next]: [f64; 2],
    views: &mut Views<'_>,
) -> Option<(usize, f64)> {
    let look = open_contact.bounded_gap(there);
    let sight = open_contact.advancement.advance(look, next);
    let (open_contact, until) = (&*open_contact, views.until);
    let mut ask = |at: f64| open_contact.bounded_gap(&views.at(at));
    match sight {
        AdvanceOutcome::Open => None,
        AdvanceOutcome::Closed => {
            let open = open_contact.advancement.last_open(t, next);
            Some((open_contact.contact, root(|at| -ask(at).gap, open, next)))
        }
        AdvanceOutcome::Closing => Some((open_contact.contact, polish(&mut ask, next, &look, until))),
    }
}

/// Contacts that close within rounding of the first close with it.
fn with_simultaneous(
    world: &World,
    pair: usize,
    open_contacts: &[OpenContact<'_>],
    mut closed: Vec<(usize, f64)>,
    first: f64,
) -> Vec<(usize, f64)> {
    if closed.len() < open_contacts.len() {
        let at = first + world.pairs[pair].together;
        let view = View::of(world, world.pairs[pair].slots, at, at);
        for open_contact in open_contacts.iter().filter(|q| q.advancement.armed()) {
            if closed.iter().all(|(contact, _)| *contact != open_contact.contact) && open_contact.look(&view).gap < 0.0
            {
                closed.push((open_contact.contact, at));
            }
        }
    }
    closed
}
