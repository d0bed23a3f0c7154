//! The energy ledger (`docs/physics.md#energy-ledger`), kept after the run from what the run left.
//!
//! Powers are integrated over every body's path and every contact's states, each on its own steps, so the balance checks
//! the trajectory against the forces that it claims; nothing is booked while a run is computed.

use std::collections::BTreeMap;

use rayon::prelude::*;

use crate::contact::Frame;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::impact2d::LastingInterval;
use crate::dynamics::model::body::{BodyEnergies, BodyPowers};
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::trajectory::stored_path::StoredMotion;
use crate::motion::Ground;
use crate::sim::energy::contact_account::{contact_account, contact_powers};
use crate::sim::energy::ledger_steps::{given_power, step_borders};
use crate::sim::energy::power_integrals::{Account, PowerIntegrals};
use crate::sim::energy::quadrature::{COUNT, Nodes, integrate};
use crate::sim::energy::view::Energy;
use crate::sim::impact::forces;
use crate::sim::looks::{MOST_LOOKS, flight_rate};
use crate::sim::{EventKind, History, Ledger};
use glam::DVec3;

/// Quadrature cells per look in free flight.
const PER_LOOK: f64 = 0.25;

impl Energy<'_> {
    /// The energy ledger at `t`.
    pub fn ledger(self, t: f64) -> Ledger {
        let history = self.history;
        let integrals = history.found.power_integrals.get_or_init(|| PowerIntegrals::open(history));
        integrals.at(history, t.clamp(0.0, history.end()))
    }
}

impl PowerIntegrals {
    /// Integrates all powers of a history: accounts in parallel, each by itself.
    fn open(history: &History) -> Self {
        let mut integrals = Self {
            bodies: (0..history.model().bodies.len()).into_par_iter().map(|body| body_account(history, body)).collect(),
            contacts: (0..history.model().sites.len())
                .into_par_iter()
                .map(|contact| contact_account(history, contact))
                .collect(),
            devices: device_accounts(history),
            lasting: history.impact().map_or(Vec::new(), |record| {
                record.lasting.iter().map(|interval| lasting_account(history, interval)).collect()
            }),
            bearings: bearings(history),
            initial: 0.0,
            kinetic: largest_kinetic(history),
        };
        let start = integrals.stored(history, 0.0);
        // Hits at the very start have taken theirs already.
        let hits = history.impact().map_or(0.0, |record| {
            let hits = record.hits.iter().take_while(|hit| hit.t <= 0.0).map(|hit| hit.impulses.lost).sum::<f64>();
            hits + record.transitions.iter().take_while(|change| change.t <= 0.0).map(|change| change.lost).sum::<f64>()
        });
        integrals.initial =
            start.kinetic + start.bearing + start.girder + start.gravity + start.contact + start.device + hits;
        integrals
    }

    /// The ledger at `t`.
    fn at(&self, history: &History, t: f64) -> Ledger {
        let mut ledger = self.stored(history, t);
        for (body, account) in self.bodies.iter().enumerate() {
            let [ground, push, loss, own] = account.at(t, |a, b| body_works(history, body, [a, b]));
            ledger.work_ground += ground;
            ledger.work_push += push;
            ledger.loss_bearing += loss;
            ledger.loss_girder += own;
        }
        for (contact, account) in self.contacts.iter().enumerate() {
            let [normal, tangential, friction, given] =
                account.at(t, |a, b| integrate(a, b, |s| contact_powers(history, contact, s)));
            ledger.loss_normal += normal;
            ledger.loss_tangential += tangential;
            ledger.loss_friction += friction;
            ledger.work_ground += given;
        }
        for (link, account) in self.devices.iter().enumerate() {
            let rest =
                |a: f64, b: f64| if a < b { device_works(history, link, &mut Poses::within(a, b)) } else { [0.0; 2] };
            let [loss, given] = account.at(t, rest);
            ledger.work_ground += given;
            let entry = if self.bearings[link] { &mut ledger.loss_bearing } else { &mut ledger.loss_device };
            *entry += loss;
            ledger.jump_device += history.trajectories.link_log(link).map_or(0.0, |log| log.released(t));
        }
        if let Some(record) = history.impact() {
            for (interval, account) in record.lasting.iter().zip(&self.lasting) {
                let [friction] =
                    account.at(t, |a, b| integrate(a, b, |s| [forces::friction_power(history, interval, s)]));
                ledger.loss_friction += friction;
            }
            let stops = record.transitions.iter().take_while(|change| change.t <= t).map(|change| change.lost);
            ledger.loss_hits += stops.sum::<f64>();
        }
        jumps(history, t, &mut ledger);
        let seen = self.kinetic.partition_point(|(instant, _)| *instant <= t);
        balance(&mut ledger, self.initial, seen.checked_sub(1).map_or(0.0, |last| self.kinetic[last].1));
        ledger
    }

    fn stored(&self, history: &History, t: f64) -> Ledger {
        let mut ledger = Ledger::default();
        for body in 0..self.bodies.len() {
            let [kinetic, bearing, girder, gravity] = energies(history, body, t);
            ledger.kinetic += kinetic;
            ledger.bearing += bearing;
            ledger.girder += girder;
            ledger.gravity += gravity;
        }
        for contact in 0..history.model().sites.len() {
            if let Some((closed, action)) = history.contacts().acting(contact, t) {
                ledger.contact += closed.law.strain(&action.here, &action.forces);
            }
        }
        for link in 0..history.model().links.len() {
            let entry = if self.bearings[link] { &mut ledger.bearing } else { &mut ledger.device };
            *entry += history.connections().link_energy(link, t);
        }
        ledger
    }
}

/// Whether each link is a girder's bearing, or the elastic part of a pier's column.
fn bearings(history: &History) -> Vec<bool> {
    let model = history.model();
    let mut bearings: Vec<bool> = model.links.iter().map(|link| link.device.is_linear()).collect();
    model.supports.iter().flatten().flatten().for_each(|&link| bearings[link] = true);
    bearings
}

fn jumps(history: &History, t: f64, ledger: &mut Ledger) {
    for event in history.events().iter().take_while(|event| event.t <= t) {
        let entry = match event.kind {
            EventKind::StickToSlip | EventKind::SlipToStick => &mut ledger.jump_slip,
            EventKind::Opened => &mut ledger.jump_open,
            EventKind::LeftFace | EventKind::Moved => &mut ledger.jump_edge,
            EventKind::OpenToStick | EventKind::OpenToSlip | EventKind::Missed => &mut ledger.jump_entry,
            EventKind::Hit => &mut ledger.loss_hits,
        };
        *entry += event.released;
    }
}

/// Instants at which the kinetic energy is looked at. Chosen: it tells the size of the energy in play, no more.
const KINETIC_LOOKS: u32 = 64;

/// The largest kinetic energy up to each of some instants, which no period of a motion repeats: they are multiples of the golden section
/// of the run, so that a motion that is at rest at the end, as on a sine of whole periods, is seen as it moves.
fn largest_kinetic(history: &History) -> Vec<(f64, f64)> {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut times: Vec<f64> = (0..KINETIC_LOOKS).map(|i| history.end() * (f64::from(i) * golden).fract()).collect();
    times.sort_by(f64::total_cmp);
    let kinetic = |t: f64| (0..history.model().bodies.len()).map(|body| energies(history, body, t)[0]).sum::<f64>();
    let seen: Vec<f64> = times.par_iter().map(|&t| kinetic(t)).collect();
    let mut most = 0.0_f64;
    let running = seen.into_iter().map(|energy| {
        most = most.max(energy);
        most
    });
    times.iter().copied().zip(running).collect()
}

/// The residual, and the largest energy in play: of what is stored, lost, worked and moving at the end, at the start, and in the largest
/// kinetic energy before, `kinetic` \[J\].
fn balance(ledger: &mut Ledger, initial: f64, kinetic: f64) {
    let l = &*ledger;
    let (stored, lost) = (l.stored(), l.lost());
    let all = [stored, lost, initial, l.work_ground, l.work_push, l.kinetic, kinetic];
    let scale = all.into_iter().fold(0.0f64, |m, x| m.max(x.abs()));
    ledger.residual = stored + lost + l.released() - (l.work_ground + l.work_push) - initial;
    ledger.scale = scale;
}

fn body_account(history: &History, body: usize) -> Account<4> {
    let mut account = Account::new();
    let rate = flight_rate(history, body) * PER_LOOK;
    let closed = history.trajectories.free_motion(body).is_some_and(BodyMotion::has_works);
    for span in history.trajectories.path(body).spans().take_while(|span| span.from < history.end()) {
        let until = span.until.min(history.end());
        let cells = if span.flies && !closed { (until - span.from) * rate } else { 1.0 };
        for (a, b) in cut(&history.model().ground, span.from, until, cells) {
            account.add(a, b, body_works(history, body, [a, b]));
        }
    }
    account
}

/// Work of the ground and of pushes, losses in the bearings and in the body, over a cell \[J\].
fn body_works(history: &History, body: usize, [a, b]: [f64; 2]) -> [f64; 4] {
    let flown = || match history.trajectories.path(body).at(a)?.1 {
        StoredMotion::Flight(flight) => flight.works([a, b]),
        _ => None,
    };
    flown().unwrap_or_else(|| integrate(a, b, |t| body_powers(history, body, t)))
}

/// Cuts a stretch into about `cells` equal parts, and at every kink of the ground motion.
fn cut(ground: &Ground, from: f64, until: f64, cells: f64) -> Vec<(f64, f64)> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count of cells, clamped")]
    let count = cells.ceil().clamp(1.0, MOST_LOOKS) as usize;
    let mut borders: Vec<f64> = (0..=count).map(|i| from + (until - from) * i as f64 / count as f64).collect();
    borders[count] = until;
    let mut kink = ground.next_kink(from);
    while kink < until {
        borders.push(kink);
        kink = ground.next_kink(kink);
    }
    borders.sort_by(f64::total_cmp);
    borders.windows(2).map(|w| (w[0], w[1])).filter(|(a, b)| b > a).collect()
}

/// Accounts of all devices. Those of links between the same bodies are kept together, as they share the poses at the nodes of a cell.
fn device_accounts(history: &History) -> Vec<Account<2>> {
    let mut sets: BTreeMap<[Option<usize>; 2], Vec<usize>> = BTreeMap::new();
    for link in 0..history.model().links.len() {
        sets.entry(history.model().links[link].bodies).or_default().push(link);
    }
    let sets: Vec<_> = sets.into_iter().collect();
    let accounts = |(bodies, links): ([Option<usize>; 2], Vec<usize>)| {
        let accounts = accounts_between(history, bodies, &links);
        links.into_iter().zip(accounts)
    };
    let mut all: Vec<(usize, Account<2>)> = sets.into_par_iter().flat_map_iter(accounts).collect();
    all.sort_by_key(|(link, _)| *link);
    all.into_iter().map(|(_, account)| account).collect()
}

/// Losses in links between these bodies while their forces act, and work of the ground that they are on where that moves as given, step
/// by step.
fn accounts_between(history: &History, bodies: [Option<usize>; 2], links: &[usize]) -> Vec<Account<2>> {
    let phases = |link: usize| history.connections().link_phases(link);
    let mut borders = step_borders(history, bodies.into_iter().flatten(), 0.0, history.end());
    borders.extend(bodies.into_iter().flatten().flat_map(|body| borders_on_springs(history, body)));
    borders.extend(links.iter().flat_map(|&link| phases(link)).map(|(t, _)| t.clamp(0.0, history.end())));
    borders.sort_by(f64::total_cmp);
    borders.dedup();
    let mut accounts: Vec<Account<2>> = links.iter().map(|_| Account::new()).collect();
    // Number of each link's phase that is next, and whether its force has acted.
    let mut now = vec![(0, false); links.len()];
    for w in borders.windows(2) {
        let mut poses = Poses::within(w[0], w[1]);
        for ((&link, account), (next, acted)) in links.iter().zip(&mut accounts).zip(&mut now) {
            *next += phases(link)[*next..].iter().take_while(|(t, _)| *t <= w[0]).count();
            let phase = next.checked_sub(1).map(|phase| phases(link)[phase].1);
            let acts = phase.is_some_and(|phase| history.model().links[link].device.acts(&phase));
            match (acts, *acted) {
                (true, _) => account.add(w[0], w[1], device_works(history, link, &mut poses)),
                // An idle cell after the last, so that what follows is not integrated again.
                (false, true) => account.add(w[0], w[0], [0.0; 2]),
                (false, false) => {}
            }
            *acted = acts;
        }
    }
    for (account, (_, acted)) in accounts.iter_mut().zip(now) {
        if acted {
            account.add(history.end(), history.end(), [0.0; 2]);
        }
    }
    accounts
}

/// Borders of the cells into which a body's flights on springs to the ground are cut.
fn borders_on_springs(history: &History, body: usize) -> Vec<f64> {
    let (path, rate) = (history.trajectories.path(body), flight_rate(history, body) * PER_LOOK);
    if path.fastest_on_springs().is_none() {
        return Vec::new();
    }
    let on_springs = |from: f64| match path.at(from) {
        Some((_, StoredMotion::Flight(flight))) => flight.is_on_springs(),
        _ => false,
    };
    let spans = path.spans().take_while(|span| span.from < history.end()).filter(|span| on_springs(span.from));
    let cells = |from: f64, until: f64| cut(&history.model().ground, from, until, (until - from) * rate);
    spans.flat_map(|span| cells(span.from, span.until.min(history.end()))).map(|(from, _)| from).collect()
}

/// Poses of sections of bodies at the nodes of a cell, each computed when first asked for.
struct Poses {
    from: f64,
    nodes: Nodes,
    of: Vec<((usize, usize), [Frame; COUNT])>,
}

impl Poses {
    /// Those of \[a, b\], which is not empty.
    fn within(a: f64, b: f64) -> Self {
        Self { from: a, nodes: Nodes::within(a, b), of: Vec::new() }
    }

    /// Computes those of a section of a body where they are not known; their place in `of`.
    fn place(&mut self, history: &History, body: usize, section: usize) -> usize {
        let known = self.of.iter().position(|(of, _)| *of == (body, section));
        known.unwrap_or_else(|| {
            self.of.push((
                (body, section),
                self.nodes.times.map(|t| history.trajectories.section_frame(body, section, t)),
            ));
            self.of.len() - 1
        })
    }
}

/// Loss in a device over a cell, and work of the ground that moves as given \[J\]. What a linear bearing takes while its bodies fly
/// together is booked with the works of their flight.
fn device_works(history: &History, number: usize, poses: &mut Poses) -> [f64; 2] {
    let link = &history.model().links[number];
    if link.device.is_linear()
        && link.bodies.into_iter().flatten().any(|body| flies_with_works(history, body, poses.from))
    {
        return [0.0; 2];
    }
    let places = [0, 1].map(|end| Some(poses.place(history, link.bodies[end]?, link.sections[end])));
    poses.nodes.sum(|node, t| {
        let frames = link.frames(|end, _| places[end].map(|place| poses.of[place].1[node]));
        [history.connections().link_power(number, t, &frames), given_device_power(history, number, t)]
    })
}

/// Whether a body is in a flight at `t` that says its works.
fn flies_with_works(history: &History, body: usize, t: f64) -> bool {
    let flight = history.trajectories.path(body).spans_after(t).next().is_some_and(|span| span.flies);
    // Ground that moves as given always flies.
    flight
        && !history.model().moves_as_given(body)
        && history.trajectories.free_motion(body).is_some_and(BodyMotion::has_works)
}

/// Loss in the friction of a stretch of lasting contact, step by step.
fn lasting_account(history: &History, interval: &LastingInterval) -> Account<1> {
    let mut account = Account::new();
    let borders = step_borders(history, interval.bodies.iter().copied(), interval.from, interval.until);
    for w in borders.windows(2).filter(|w| w[1] > w[0]) {
        account.add(w[0], w[1], integrate(w[0], w[1], |t| [forces::friction_power(history, interval, t)]));
    }
    account.add(interval.until, interval.until, [0.0]);
    account
}

/// Powers of the ground and of pushes, and those lost in bearings and in the body itself \[W\].
fn body_powers(history: &History, body: usize, t: f64) -> [f64; 4] {
    let (model, state) = (history.model(), history.state(body, t));
    let BodyPowers { ground, push, bearings } =
        model.bodies[body].powers(&state, GroundNow { acceleration: model.ground.acceleration(t), t, since: t });
    [ground, push, bearings, model.bodies[body].own_loss(&state)]
}

/// Kinetic energy, strain in the bearings and in the body itself, potential of gravity \[J\].
fn energies(history: &History, body: usize, t: f64) -> [f64; 4] {
    let (model, state) = (history.model(), history.state(body, t));
    let BodyEnergies { kinetic, bearings, gravity } = model.bodies[body].energies(&state, model.gravity);
    [kinetic, bearings, model.bodies[body].own_strain(&state), gravity]
}

/// Power of the ground where one end of a device moves as given \[W\].
fn given_device_power(history: &History, link: usize, t: f64) -> f64 {
    if history.model().moving.is_none() {
        return 0.0;
    }
    let bodies = history.model().links[link].bodies;
    let force = history.connections().link(link, t).map_or(DVec3::ZERO, |now| now.force);
    given_power(history, [(bodies[0], force), (bodies[1], -force)], t)
}
