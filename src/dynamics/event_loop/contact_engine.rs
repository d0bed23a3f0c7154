//! The event loop for one group of bodies that pairs join (`docs/physics.md#contact-events`).
//!
//! Every body has a trajectory into the future: a closed-form flight, or the planned step of the island it touches in.
//! Every pair knows when its next contact closes on those trajectories. The earliest of all that is due happens; only
//! the bodies it concerns get new trajectories, and only their pairs are looked at again. Nobody else notices.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::closing::collinear_pair::Abreast;
use crate::dynamics::closing::in_flight::Spot;
use crate::dynamics::event_loop::event_queue::{Agenda, Item};
use crate::dynamics::free_flight::flight::{Flight, System};
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::step_control::Pace;
use crate::dynamics::model::reference_pose::Base;
use crate::dynamics::model::rigid_body;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::record::event::{Event, Stop};
use crate::dynamics::record::recomputed_steps::Replay;
use crate::dynamics::trajectory::stored_path::BodyPath;
use crate::scene::Kind;

/// Events of one contact at one instant before the run gives up there.
const SAME_INSTANT: usize = 64;
/// Planned steps, meetings and searches per body before the run gives up: more than the million that an hour of a stiff contact
/// may take, and as many steps as memory should hold.
const WORK: usize = 10_000_000;
/// Events of one contact during one touch before the run gives up there.
const PER_TOUCH: usize = 1_000_000;

/// How a body moves from now on.
#[derive(Debug)]
pub(in crate::dynamics) enum Trajectory {
    /// In closed form, until something happens.
    Flight(Flight),
    /// With others, as that island's body of that number.
    Island { island: usize, index: usize },
}

/// A body of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct BodyTrack {
    /// Its number in the model.
    pub body: usize,
    /// Its free motion, where that has a closed form.
    pub system: Option<System>,
    /// What it does now.
    pub now: Trajectory,
    /// What it did.
    pub path: BodyPath,
    /// The pairs it is in.
    pub pairs: Vec<usize>,
}

/// A pair of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct PairTrack {
    /// Its number in the model.
    pub pair: usize,
    /// Slots of its bodies; nothing for an abutment.
    pub slots: [Option<usize>; 2],
    /// Its contacts in the engine.
    pub contacts: std::ops::Range<usize>,
    /// Nodes that share K and C while it is closed; 0 while it is open.
    pub sharers: usize,
    /// Two events closer than this are one \[s\].
    pub together: f64,
    /// Its one gap, where it has one as long as its bodies move along an axis.
    pub abreast: Option<Abreast>,
}

/// A contact of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct ContactTrack {
    /// Its number in the model.
    pub site: usize,
    /// Its pair in the engine.
    pub pair: usize,
    /// Slots of the node's and the face's body.
    pub slots: [Option<usize>; 2],
    /// Its state now.
    pub state: Contact,
    /// Other contacts of the same node: it touches one face at a time.
    pub rivals: Vec<usize>,
    /// Where its two sides stand as placed.
    pub spot: Spot,
    /// Its next closing on the trajectories in force \[s\].
    pub closing: Option<f64>,
    /// When it comes out in front of the face on them, after it was behind \[s\].
    pub out: Option<f64>,
    /// Its states so far.
    pub log: ContactLog,
    /// Events of the touch in hand, and the time and number of those at one instant.
    pub counted: (usize, f64, usize),
}

impl ContactTrack {
    /// At `t`, before the trajectories are looked at anew: a node that has come out on the old ones is armed.
    pub(in crate::dynamics) fn take_note(&mut self, t: f64) {
        if self.out.take().is_some_and(|at| at <= t) && self.state.closed().is_none() {
            self.state = Contact::Open { armed: true };
        }
    }
}

/// The run of one group of bodies.
#[derive(Debug)]
pub struct Engine {
    pub(in crate::dynamics) model: Arc<Model>,
    pub(in crate::dynamics) bodies: Vec<BodyTrack>,
    pub(in crate::dynamics) pairs: Vec<PairTrack>,
    pub(in crate::dynamics) contacts: Vec<ContactTrack>,
    pub(in crate::dynamics) islands: Vec<Option<Box<Island>>>,
    /// Numbers of islands that are no more.
    pub(in crate::dynamics) vacant: Vec<usize>,
    /// What their integrators have left.
    #[expect(clippy::vec_box, reason = "handed on in their boxes")]
    pub(in crate::dynamics) spare: Vec<Box<Radau>>,
    pub(in crate::dynamics) agenda: Agenda,
    pub(in crate::dynamics) events: Vec<Event>,
    stop: Option<Stop>,
    now: f64,
    pub(in crate::dynamics) work: usize,
    /// Steps kept by their starts.
    pub(in crate::dynamics) replay: Replay,
    /// What the polynomials of the others take \[bytes\].
    pub(in crate::dynamics) polynomials: usize,
    pub(in crate::dynamics) effort: Effort,
}

/// What a run has done, counted: for seeing that what a scene does not need is left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Searches for the next touch of a pair.
    pub searches: u64,
    /// Looks at a pair in flight.
    pub looks: u64,
    /// Steps of integrators.
    pub steps: u64,
}

impl std::ops::AddAssign for Effort {
    fn add_assign(&mut self, other: Self) {
        self.searches += other.searches;
        self.looks += other.looks;
        self.steps += other.steps;
    }
}

impl Engine {
    /// Sets up a group of bodies, by its number in the model, at t = 0.
    pub fn new(model: &Arc<Model>, group: usize) -> Self {
        let mut engine = Self {
            model: Arc::clone(model),
            bodies: Vec::new(),
            pairs: Vec::new(),
            contacts: Vec::new(),
            islands: Vec::new(),
            vacant: Vec::new(),
            spare: Vec::new(),
            agenda: Agenda::default(),
            events: Vec::new(),
            stop: None,
            now: 0.0,
            work: 0,
            replay: Replay::default(),
            polynomials: 0,
            effort: Effort::default(),
        };
        engine.gather(group);
        engine.begin();
        engine
    }

    fn gather(&mut self, number: usize) {
        let model = Arc::clone(&self.model);
        let group = model.groups[number].as_slice();
        let pairs = model.group_pairs[number].as_slice();
        self.bodies.reserve_exact(group.len());
        self.pairs.reserve_exact(pairs.len());
        self.contacts.reserve_exact(pairs.iter().map(|&pair| model.pairs[pair].contacts.len()).sum());
        let slot = |side: Option<usize>| side.and_then(|b| group.binary_search(&b).ok());
        for &body in group {
            let planar = model.kind == Kind::Planar;
            let system = planar.then(|| System::new(&model.bodies[body], &model.ground, model.duration));
            let rest = Flight::at_rest();
            let now = Trajectory::Flight(rest);
            self.bodies.push(BodyTrack { body, system, now, path: BodyPath::default(), pairs: Vec::new() });
        }
        for &number in pairs {
            let pair = &model.pairs[number];
            let slots = pair.bodies.map(slot);
            let from = self.contacts.len();
            for site in pair.contacts.clone() {
                let owners = [model.contacts[site].node_body, model.contacts[site].face_body].map(slot);
                self.contacts.push(ContactTrack {
                    site,
                    pair: self.pairs.len(),
                    slots: owners,
                    spot: Spot::of(&model, site),
                    rivals: Vec::new(),
                    state: Contact::Open { armed: true },
                    closing: None,
                    out: None,
                    log: ContactLog::default(),
                    counted: (0, -1.0, 0),
                });
            }
            for slot in slots.into_iter().flatten() {
                self.bodies[slot].pairs.push(self.pairs.len());
            }
            let mass = pair.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
            let together = 1e-9 / (pair.contact.stiffness / mass).sqrt();
            let contacts = from..self.contacts.len();
            let abreast = Abreast::of(&model, number, &self.contacts[from..]);
            self.pairs.push(PairTrack { pair: number, slots, contacts, sharers: 0, together, abreast });
        }
        self.find_rivals(pairs);
    }

    /// States at t = 0: nodes that overlap start in stick, everyone gets a trajectory.
    fn begin(&mut self) {
        let model = Arc::clone(&self.model);
        let slots: Vec<usize> = (0..self.bodies.len()).collect();
        let start = |track: &BodyTrack| {
            let body = &model.bodies[track.body];
            let mut state = rigid_body::initial(model.kind, body);
            (Base::of(model.kind, body, &mut state), state)
        };
        let (bases, states) = self.bodies.iter().map(start).unzip();
        let now = self.instant(slots, bases, states, 0.0);
        self.close_overlapping(&now);
        self.form(now, Pace::default());
    }

    /// The time of whatever comes next; infinite when the run is over \[s\].
    pub fn next_time(&self) -> f64 {
        if self.stop.is_some() { f64::INFINITY } else { self.agenda.first_time() }
    }

    /// How many events have come up.
    pub fn events(&self) -> usize {
        self.events.len()
    }

    /// What has been done so far.
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// How far the run has come \[s\].
    fn now(&self) -> f64 {
        if self.stop.is_none() && self.agenda.first_time() > self.model.duration {
            self.model.duration
        } else {
            self.now
        }
    }

    /// Does everything that is due until `until` \[s\].
    pub fn advance(&mut self, until: f64) {
        while self.next_time() <= until.min(self.model.duration) {
            let Some((t, item)) = self.agenda.pop() else { return };
            self.now = t;
            self.work += 1;
            if self.work > WORK * self.bodies.len() {
                self.out_of_work(t, item);
                return;
            }
            match item {
                Item::Island(island) => self.commit_step(island, t),
                Item::Pair(pair) => self.meet(pair, t),
            }
        }
    }

    /// Everything that was computed: paths, contact states, events, and why it stopped early.
    pub fn finish(mut self) -> Finished {
        let end = self.now();
        self.commit_all(end);
        self.bodies.iter_mut().for_each(|track| track.path.shrink());
        self.contacts.iter_mut().for_each(|track| track.log.shrink());
        self.replay.shrink();
        self.events.shrink_to_fit();
        Finished {
            end,
            stop: self.stop,
            bodies: self.bodies.into_iter().map(|track| (track.body, track.path, track.system)).collect(),
            contacts: self.contacts.into_iter().map(|track| (track.site, track.log)).collect(),
            replay: self.replay,
            events: self.events,
            effort: self.effort,
        }
    }

    /// Numbers of its bodies and their states at `t`, until which everything is done.
    pub fn states(&self, t: f64) -> impl Iterator<Item = (usize, Vec<f64>)> + '_ {
        self.bodies.iter().enumerate().map(move |(slot, track)| (track.body, self.state(slot, t)))
    }

    /// Why it stopped early.
    pub fn stop(&self) -> Option<&Stop> {
        self.stop.as_ref()
    }

    /// Counts an event and says whether the contact has had too many.
    pub(in crate::dynamics) fn counted(&mut self, contact: usize, t: f64) {
        let track = &mut self.contacts[contact];
        let (touch, at, same) = &mut track.counted;
        *touch += 1;
        *same = if *at == t { *same + 1 } else { 1 };
        *at = t;
        if *same > SAME_INSTANT || *touch > PER_TOUCH {
            let (touch, same) = (*touch, *same);
            let place = self.model.contacts[track.site].node.clone();
            self.give_up(
                t,
                place,
                format!(
                    "{touch} changes of state in one touch, {same} of them at this instant: stick and slip alternate without \
                     end; another law, a lower stiffness or a larger tolerance may end it"
                ),
            );
        }
    }

    /// The work bound: says who kept the run busy.
    fn out_of_work(&mut self, t: f64, item: Item) {
        let slots = match item {
            Item::Island(island) => self.islands[island].as_ref().map(|i| i.slots.clone()).unwrap_or_default(),
            Item::Pair(pair) => self.pairs[pair].slots.into_iter().flatten().collect(),
        };
        let names: Vec<&str> = slots.iter().map(|&s| self.model.bodies[self.bodies[s].body].name.as_str()).collect();
        let place = names.join(", ");
        let reason = format!(
            "{} steps and looks are more than any answer is worth: a contact, a bearing or the ground is far too fast for \
             the duration; lower its stiffness or frequency, or shorten the run",
            self.work
        );
        self.give_up(t, place, reason);
    }

    pub(in crate::dynamics) fn give_up(&mut self, t: f64, place: String, reason: String) {
        if self.stop.is_none() {
            self.stop = Some(Stop { t, place, reason });
        }
    }
}

/// What an engine leaves behind.
#[derive(Debug)]
pub struct Finished {
    /// How far it came \[s\].
    pub end: f64,
    /// Why it stopped early.
    pub stop: Option<Stop>,
    /// Number, path and free motion of every body.
    pub bodies: Vec<(usize, BodyPath, Option<System>)>,
    /// Steps that are kept by their starts.
    pub replay: Replay,
    /// Number and states of every contact.
    pub contacts: Vec<(usize, ContactLog)>,
    /// Events in order of time.
    pub events: Vec<Event>,
    /// What it took.
    pub effort: Effort,
}
