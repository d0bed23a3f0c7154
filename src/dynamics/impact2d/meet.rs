//! What happens at an instant: who touches, the hits until nobody is driven in, who stays.

use glam::{DVec2, DVec3};

use super::State;
use super::blow::{Blow, Edge, Rules, strike};
use super::decide::{Candidate, RuledOut, decide};
use super::engine::{Engine, Going, SINK};
use super::grip::{Ending, Grip};
use super::point::Point;
use super::reaction::{Scenery, Seat, Way, middle, shaking};
use super::record::{Hit, Transition};
use super::state::{After, Row};
use crate::dynamics::flight::Planar;

/// Points nearer than this touch, and faces with both ends nearer are flush, in parts of the girder's size.
const TOUCH: f64 = 1e-9;
/// Hits at one instant with a bounce; girders that are wedged between others lose theirs after as many.
const LIVELY: usize = 64;
/// Hits at one instant after which all who are still driven in stop together.
const MOST: usize = 256;
/// Speeds off the face that a kept point may have gathered by its integrator's error, in parts of the fastest.
const DRIFT: f64 = 1e-8;

/// Speeds that are rounding, in parts of the fastest that anybody has been.
const RUN: f64 = 1e-14;

/// Everybody whom an instant concerns.
struct Moment {
    t: f64,
    /// Slots, rising; so are the numbers in the model.
    slots: Vec<usize>,
    states: Vec<Planar>,
    scenery: Scenery,
    /// State among a–f before.
    before: Vec<State>,
    edges: Vec<Edge>,
    hush: f64,
}

impl Engine {
    /// States at t = 0.
    pub(super) fn begin(&mut self) {
        self.flag_those_behind();
        let mut seen = vec![false; self.bodies.len()];
        for slot in 0..self.bodies.len() {
            if !seen[slot] {
                for member in self.meet(0.0, &[slot], None) {
                    seen[member] = true;
                }
            }
        }
    }

    /// Points that start behind their face beside it count once they have come out in front.
    fn flag_those_behind(&mut self) {
        for pair in 0..self.pairs.len() {
            for site in self.pairs[pair].sites.clone() {
                let point = self.point(site, pair, 0.0);
                if point.gap < TOUCH * self.reach(pair) && !self.touches(site, pair, &point) {
                    let beside =
                        point.inset < 0.0 || -point.gap >= self.model.contacts[self.sites[site].number].face.depth;
                    (self.sites[site].armed, self.sites[site].left) = (false, beside);
                }
            }
        }
    }

    /// A declared contact, on the trajectories in force.
    fn point(&self, site: usize, pair: usize, t: f64) -> Point {
        let slots = self.pairs[pair].slots;
        let still = crate::contact::Frame::fixed(DVec3::ZERO);
        let frames = slots.map(|slot| slot.map_or(still, |slot| self.frame(slot, t)));
        let places = slots.map(|slot| slot.map(|_| 0));
        Point::of(&self.model, self.sites[site].number, places, [&frames[0], &frames[1]])
    }

    /// Meets whoever touches these bodies at `t`; returns the slots of all whom it concerned.
    pub(super) fn meet(&mut self, t: f64, seeds: &[usize], ending: Option<Ending>) -> Vec<usize> {
        let mut moment = self.moment(t, seeds);
        let slots = moment.slots.clone();
        if t == 0.0 && self.overlaps(&moment) {
            return slots;
        }
        let energy = kinetic(&moment);
        let mut to = moment.before.clone();
        let known = (self.record.hits.len(), self.record.transitions.len());
        let done = match self.hits(&mut moment, &mut to) {
            Ok(lost) => self.settle(&mut moment, &to, energy - lost, ending),
            Err((pair, why)) => Err((self.model.pairs[pair].name.clone(), why)),
        };
        if let Err((place, why)) = done {
            // The answer ends before this instant, and so does the record.
            self.record.hits.truncate(known.0);
            self.record.transitions.truncate(known.1);
            self.give_up(t, place, why);
        }
        slots
    }

    /// Bodies that touching pairs and grips join to the seeds, where they are at `t`.
    fn moment(&self, t: f64, seeds: &[usize]) -> Moment {
        let mut slots: Vec<usize> = seeds.to_vec();
        let mut next = 0;
        while let Some(&slot) = slots.get(next) {
            next += 1;
            let mut joined: Vec<usize> = Vec::new();
            if let Going::Grip(grip, _) = self.bodies[slot].now
                && let Some(grip) = &self.grips[grip]
            {
                joined.extend(self.slots(&grip.bodies));
            }
            for &pair in &self.bodies[slot].pairs {
                if let [Some(a), Some(b)] = self.pairs[pair].slots
                    && self.pairs[pair].sites.clone().any(|site| self.touches_at(site, pair, t))
                {
                    joined.extend([a, b]);
                }
            }
            joined.retain(|slot| !slots.contains(slot));
            joined.dedup();
            slots.extend(joined);
        }
        slots.sort_unstable();
        slots.dedup();
        let states: Vec<Planar> = slots.iter().map(|&slot| self.state(slot, t)).collect();
        let bodies: Vec<usize> = slots.iter().map(|&slot| self.bodies[slot].body).collect();
        let piece = self.model.ground.piece(self.model.ground.piece_number(t));
        let scenery = Scenery::new(&self.model, &bodies, &states, shaking(&self.model.ground, &piece, t));
        let before = slots.iter().map(|&slot| self.bodies[slot].state).collect();
        let mut moment = Moment { t, slots, states, scenery, before, edges: Vec::new(), hush: 0.0 };
        moment.edges = self.edges(&moment);
        let points: Vec<Point> = moment.edges.iter().flat_map(|edge| edge.points.clone()).collect();
        moment.hush = moment.scenery.cluster.rounding(&points).max(RUN * self.largest[0]);
        moment
    }

    fn touches_at(&self, site: usize, pair: usize, t: f64) -> bool {
        self.touches(site, pair, &self.point(site, pair, t))
    }

    /// Whether a point is on its face.
    fn touches(&self, site: usize, pair: usize, point: &Point) -> bool {
        if self.sites[site].left {
            return false;
        }
        let near = TOUCH * self.reach(pair);
        let near_enough = point.gap.abs() <= near || (self.sites[site].kept && point.gap.abs() <= 1e3 * near);
        near_enough && point.inset >= -near
    }

    /// Size of the smaller girder of a pair \[m\].
    fn reach(&self, pair: usize) -> f64 {
        let radius = |slot: usize| self.model.bodies[self.bodies[slot].body].radius;
        self.pairs[pair].slots.into_iter().flatten().map(radius).fold(f64::INFINITY, f64::min)
    }

    /// Pairs of a moment that touch: at a corner, or at the two outermost points of a face.
    fn edges(&self, moment: &Moment) -> Vec<Edge> {
        let mut pairs: Vec<usize> = moment.slots.iter().flat_map(|&slot| self.bodies[slot].pairs.clone()).collect();
        pairs.sort_unstable();
        pairs.dedup();
        let mut edges = Vec::new();
        for pair in pairs {
            let here = |slot: Option<usize>| slot.is_none_or(|slot| moment.slots.binary_search(&slot).is_ok());
            if !self.pairs[pair].slots.into_iter().all(here) {
                continue;
            }
            let mut touching: Vec<(usize, Point)> = Vec::new();
            for site in self.pairs[pair].sites.clone() {
                let number = self.sites[site].number;
                let point = moment.scenery.point(&self.model, number);
                if self.touches(site, pair, &point) {
                    touching.push((number, point));
                }
            }
            touching.sort_by(|a, b| a.1.along.total_cmp(&b.1.along));
            let near = TOUCH * self.reach(pair);
            let outermost = match (touching.first(), touching.last()) {
                (Some(&first), Some(&last)) if last.1.along - first.1.along > near => vec![first, last],
                (Some(&first), _) => vec![first],
                _ => continue,
            };
            let (sites, points) = outermost.into_iter().unzip();
            edges.push(Edge { pair: self.pairs[pair].number, sites, points });
        }
        edges
    }

    /// Rigid girders cannot start inside each other.
    fn overlaps(&mut self, moment: &Moment) -> bool {
        for slot in moment.slots.clone() {
            for pair in self.bodies[slot].pairs.clone() {
                let (near, depth) = (TOUCH * self.reach(pair), |site: usize| {
                    let point = self.point(site, pair, 0.0);
                    let within = -point.gap < self.model.contacts[self.sites[site].number].face.depth;
                    if point.inset >= 0.0 && within { -point.gap } else { 0.0 }
                });
                let deepest = self.pairs[pair].sites.clone().map(depth).fold(0.0, f64::max);
                if deepest > near {
                    let name = self.model.pairs[self.pairs[pair].number].name.clone();
                    let reason = format!(
                        "it starts {deepest:.3e} m inside: rigid girders cannot overlap; move it out by its initial \
                         displacement or its place, or take the contact model"
                    );
                    self.give_up(0.0, name, reason);
                    return true;
                }
            }
        }
        false
    }

    /// Hits everybody who is driven in until nobody is; the energy lost, and in `to` the states that the hits lead to.
    fn hits(&mut self, moment: &mut Moment, to: &mut [State]) -> Result<f64, (usize, String)> {
        let mut lost = 0.0;
        for count in 0.. {
            let cluster = &moment.scenery.cluster;
            let speed = |edge: &Edge| edge.points.iter().map(|p| cluster.speed(p, p.n)).fold(f64::INFINITY, f64::min);
            let worst =
                (0..moment.edges.len()).map(|i| (speed(&moment.edges[i]), i)).min_by(|a, b| a.0.total_cmp(&b.0));
            let Some((speed, number)) = worst else { break };
            if speed >= -moment.hush {
                break;
            }
            let edge = moment.edges[number].clone();
            let in_grip = self.is_kept(&edge);
            if in_grip && count == 0 && speed >= -DRIFT * moment.hush / 1e-12 && !self.is_driven(moment) {
                // A kept point has gathered this by its integrator's error.
                break;
            }
            if count > MOST {
                super::wedge::stop(&mut moment.scenery.cluster, &moment.edges);
                break;
            }
            lost += self.hit(moment, &edge, to, count > LIVELY)?;
        }
        Ok(lost)
    }

    /// Whether all points of an edge are in lasting contact already.
    fn is_kept(&self, edge: &Edge) -> bool {
        edge.sites.iter().all(|&number| self.sites.iter().any(|site| site.number == number && site.kept))
    }

    /// Whether an edge that is not kept comes in.
    fn is_driven(&self, moment: &Moment) -> bool {
        let cluster = &moment.scenery.cluster;
        moment
            .edges
            .iter()
            .filter(|edge| !self.is_kept(edge))
            .any(|edge| edge.points.iter().any(|p| cluster.speed(p, p.n) < -moment.hush))
    }

    fn hit(&mut self, moment: &mut Moment, edge: &Edge, to: &mut [State], dead: bool) -> Result<f64, (usize, String)> {
        let numbers = self.model.impact;
        let places = moment.scenery.places(&self.model, edge.pair);
        let place = places.into_iter().flatten().next().unwrap_or(0);
        let from = to[place];
        let rules = Rules { numbers: &numbers, hush: moment.hush, dead };
        let blow = strike(&mut moment.scenery.cluster, edge, from, &rules).map_err(|_| (edge.pair, painleve(from)))?;
        let body = moment.scenery.bodies[place];
        let to_wall = self.model.pairs[edge.pair].bodies.contains(&None);
        let row = if to_wall { Row::landing(&blow.landing) } else { None };
        let after = landed(&blow, to_wall);
        for place in places.into_iter().flatten() {
            to[place] = after;
        }
        let frame = &moment.scenery.frames[place];
        let lost = blow.lost;
        let at = |i: usize| edge.sites[i];
        self.record.hits.push(Hit {
            t: moment.t,
            pair: edge.pair,
            sites: edge.sites.clone(),
            point: frame.origin().truncate() + if places[0].is_some() { blow.arm } else { DVec2::ZERO },
            normal: blow.normal,
            approach: blow.approach,
            offset: blow.offset,
            first: blow.first,
            second: blow.second.map(|(end, second)| (at(end), second)),
            last: blow.last,
            lost,
            from,
            to: after,
            row,
        });
        if after != from {
            self.record.transitions.push(Transition {
                t: moment.t,
                body,
                pair: Some(edge.pair),
                from,
                to: after,
                row,
                lost: 0.0,
            });
        }
        Ok(lost)
    }

    /// Decides who stays in contact, and sends everybody on; `energy` is the kinetic energy that the hits have left.
    fn settle(
        &mut self,
        moment: &mut Moment,
        to: &[State],
        energy: f64,
        ending: Option<Ending>,
    ) -> Result<(), (String, String)> {
        let numbers = self.model.impact;
        // The velocities are those after the hits.
        for (state, v) in moment.states.iter_mut().zip(&moment.scenery.cluster.velocity) {
            state[3..].copy_from_slice(&v.to_array());
        }
        let bodies = moment.scenery.bodies.clone();
        let piece = self.model.ground.piece(self.model.ground.piece_number(moment.t));
        let shaking = shaking(&self.model.ground, &piece, moment.t);
        moment.scenery = Scenery::new(&self.model, &bodies, &moment.states, shaking);
        let mut candidates = self.candidates(moment, ending);
        let decided = decide(&self.model, &moment.scenery, &candidates, &numbers).or_else(|| {
            // Who slides slower than the stop speed and cannot go on may stay put.
            for candidate in candidates.iter_mut().filter(|c| along(moment, c).abs() <= numbers.stop_speed) {
                candidate.stays_or_leaves = true;
            }
            decide(&self.model, &moment.scenery, &candidates, &numbers)
        });
        let Some(mut seats) = decided else {
            let place = (0..to.len()).find(|&place| to[place].touches()).unwrap_or(0);
            return Err((self.names(&bodies), painleve(to[place])));
        };
        // A face that was to rest below the stop speed but cannot goes on as it goes.
        let mut again = false;
        for candidate in &mut candidates {
            let held = seats.iter().any(|seat| seat.pair == candidate.pair && seat.way == Way::Held);
            let v_s = along(moment, candidate);
            if candidate.slides == 0.0 && !held && v_s.abs() > moment.hush {
                (candidate.slides, again) = (v_s.signum(), true);
            }
        }
        if again && let Some(other) = decide(&self.model, &moment.scenery, &candidates, &numbers) {
            seats = other;
        }
        let strain = self.strain(moment);
        self.tidy(moment, &seats);
        let lost = energy - kinetic(moment) + strain - self.strain(moment);
        self.go_on(moment, to, seats, lost);
        Ok(())
    }

    /// Pairs of a moment with points that neither come nor go.
    fn candidates(&self, moment: &Moment, ending: Option<Ending>) -> Vec<Candidate> {
        let mut all = Vec::new();
        for edge in self.edges(moment) {
            let loose = if self.is_kept(&edge) { DRIFT / 1e-12 } else { 4.0 };
            let stays = |point: &Point| moment.scenery.cluster.speed(point, point.n).abs() <= loose * moment.hush;
            let kept: Vec<(usize, Point)> =
                edge.sites.iter().copied().zip(edge.points.iter().copied()).filter(|(_, p)| stays(p)).collect();
            if kept.is_empty() {
                continue;
            }
            let (sites, points): (Vec<usize>, Vec<Point>) = kept.into_iter().unzip();
            let rest = if points.len() > 1 { self.model.impact.stop_speed } else { loose * moment.hush };
            let mut candidate = Candidate {
                pair: edge.pair,
                sites,
                points,
                slides: 0.0,
                stays_or_leaves: false,
                ruled_out: RuledOut::default(),
            };
            let v_s = along(moment, &candidate);
            if v_s.abs() > rest && ending != Some(Ending::Stops(edge.pair)) {
                candidate.slides = v_s.signum();
            }
            candidate.ruled_out = match ending {
                Some(Ending::Lets(site)) => RuledOut { held: false, site: Some(site) },
                _ => RuledOut { held: ending == Some(Ending::Breaks(edge.pair)), site: None },
            };
            all.push(candidate);
        }
        all
    }

    /// Takes out of places and velocities what the integrator's error has left between what is kept.
    fn tidy(&self, moment: &mut Moment, seats: &[Seat]) {
        let points: Vec<Vec<Point>> = seats.iter().map(|seat| moment.scenery.points(&self.model, seat)).collect();
        let mut rows: Vec<(Point, DVec2, f64)> = Vec::new();
        for (seat, points) in seats.iter().zip(&points) {
            rows.extend(points.iter().map(|p| (*p, p.n, p.gap)));
            if seat.way == Way::Held {
                let middle = middle(points);
                rows.push((middle, middle.s, 0.0));
            }
        }
        let cluster = &moment.scenery.cluster;
        let entry = |r: usize, c: usize| cluster.mobility(&rows[r].0, rows[r].1, &rows[c].0, rows[c].1);
        let speeds = super::dense::solve(rows.len(), entry, |r| -cluster.speed(&rows[r].0, rows[r].1));
        let shifts = super::dense::solve(rows.len(), entry, |r| -rows[r].2);
        for (solution, from) in [(shifts, 0), (speeds, 3)] {
            for ((point, direction, _), size) in rows.iter().zip(solution.unwrap_or_default()) {
                for (body, row) in point.row(*direction * size) {
                    if let Some(b) = body {
                        let change = moment.scenery.cluster.inverse[b] * row;
                        for i in 0..3 {
                            moment.states[b][from + i] += change[i];
                        }
                    }
                }
            }
        }
        for (place, state) in moment.states.iter_mut().enumerate() {
            // Who lies still on his faces is still to the last bit.
            let seated = |seat: &Seat| moment.scenery.places(&self.model, seat.pair).contains(&Some(place));
            let rests = seats.iter().any(|s| seated(s) && s.is_flush() && s.way == Way::Held);
            if rests && self.model.pairs.iter().any(|pair| pair.bodies == [Some(moment.scenery.bodies[place]), None]) {
                for rate in &mut state[3..] {
                    *rate = if rate.abs() <= 1e3 * moment.hush { 0.0 } else { *rate };
                }
            }
        }
        moment.scenery.cluster.velocity = moment.states.iter().map(super::point::rates).collect();
    }

    /// Energy in the bearings of a moment \[J\].
    fn strain(&self, moment: &Moment) -> f64 {
        let body = |(&body, state): (&usize, &Planar)| {
            let q = DVec3::new(state[0], state[1], state[2]);
            0.5 * q.dot(self.model.bodies[body].planar.stiffness * q)
        };
        moment.scenery.bodies.iter().zip(&moment.states).map(body).sum()
    }

    /// Starts flights and grips, logs what changed, and looks for the next meetings.
    fn go_on(&mut self, moment: &Moment, to: &[State], seats: Vec<Seat>, lost: f64) {
        let t = moment.t;
        self.end_what_was(moment);
        for (place, &slot) in moment.slots.iter().enumerate() {
            let state = self.state_of(moment, place, &seats);
            self.log(moment, place, to[place], state, &seats, if place == 0 { lost } else { 0.0 });
            let track = &mut self.bodies[slot];
            track.since = t;
            track.state = state;
            track.now = Going::Flight(track.system.fly(t, moment.states[place]));
            let v = moment.scenery.cluster.velocity[place];
            let radius = self.model.bodies[track.body].radius;
            let reach = moment.states[place][0].hypot(moment.states[place][1]) + radius * moment.states[place][2].abs();
            self.largest[0] = self.largest[0].max(v.truncate().length() + radius * v.z.abs());
            self.largest[1] = self.largest[1].max(reach);
        }
        self.flag(moment, &seats);
        for group in joined(&self.model, &moment.scenery, seats) {
            self.start_grip(moment, group);
        }
        self.seek_around(&moment.slots, t);
    }

    fn end_what_was(&mut self, moment: &Moment) {
        for &slot in &moment.slots {
            self.close_segment(slot, moment.t);
        }
        for &slot in &moment.slots {
            if let Going::Grip(grip, _) = self.bodies[slot].now {
                self.end_grip(grip, moment.t);
            }
        }
    }

    fn start_grip(&mut self, moment: &Moment, (places, seats): (Vec<usize>, Vec<Seat>)) {
        let bodies: Vec<usize> = places.iter().map(|&place| moment.scenery.bodies[place]).collect();
        let states: Vec<Planar> = places.iter().map(|&place| moment.states[place]).collect();
        let number = self.grips.iter().position(Option::is_none).unwrap_or(self.grips.len());
        let grip = Some(Grip::new(bodies, seats, &states, moment.t));
        if number == self.grips.len() {
            self.grips.push(grip);
        } else {
            self.grips[number] = grip;
        }
        for (at, &place) in places.iter().enumerate() {
            self.bodies[moment.slots[place]].now = Going::Grip(number, at);
        }
        self.plan(number);
    }

    /// Marks who is kept, who has lifted off, who is behind a face without having come in through it.
    fn flag(&mut self, moment: &Moment, seats: &[Seat]) {
        let mut pairs: Vec<usize> = moment.slots.iter().flat_map(|&slot| self.bodies[slot].pairs.clone()).collect();
        pairs.sort_unstable();
        pairs.dedup();
        for pair in pairs {
            for site in self.pairs[pair].sites.clone() {
                let number = self.sites[site].number;
                let here = |slot: Option<usize>| slot.is_none_or(|slot| moment.slots.binary_search(&slot).is_ok());
                if !self.pairs[pair].slots.into_iter().all(here) {
                    continue;
                }
                let point = moment.scenery.point(&self.model, number);
                let near = TOUCH * self.reach(pair);
                let flush = seats.iter().find(|seat| seat.is_flush() && self.model.contacts[number].pair == seat.pair);
                let on_face = flush.is_some() && point.gap.abs() <= 1e3 * near;
                let kept = seats.iter().any(|seat| seat.sites.contains(&number)) || on_face;
                let touches = self.touches(site, pair, &point);
                let rate = moment.scenery.cluster.speed(&point, point.n);
                let track = &mut self.sites[site];
                (track.kept, track.out) = (kept, None);
                if touches && !kept {
                    // Going out for good, or without speed.
                    (track.armed, track.lifted) = (false, rate <= 4.0 * moment.hush);
                    track.sink = SINK * track.spot.size + (-point.gap).max(0.0);
                } else if point.gap < near && !touches && !kept {
                    // Behind the face, or beside it.
                    (track.armed, track.lifted, track.left) = (false, false, true);
                }
            }
        }
    }

    /// State among a–f of a body.
    fn state_of(&self, moment: &Moment, place: usize, seats: &[Seat]) -> State {
        let touching = |seat: &&Seat| moment.scenery.places(&self.model, seat.pair).contains(&Some(place));
        if let Some(seat) = seats.iter().find(touching) {
            return seat.state();
        }
        let body = &self.model.bodies[moment.scenery.bodies[place]];
        let v = moment.scenery.cluster.velocity[place];
        let turns = body.radius * v.z.abs() > moment.hush.max(1e-12 * v.truncate().length())
            || moment.states[place][2].abs() > 1e-12;
        if turns { State::FreeTurning } else { State::Free }
    }

    /// Logs a body's change of state.
    fn log(&mut self, moment: &Moment, place: usize, hit_to: State, now: State, seats: &[Seat], lost: f64) {
        let body = moment.scenery.bodies[place];
        let first = moment.t == 0.0 && !self.record.transitions.iter().any(|change| change.body == body);
        if now == hit_to && !first && lost.abs() <= f64::MIN_POSITIVE {
            return;
        }
        let touching = |seat: &&Seat| moment.scenery.places(&self.model, seat.pair).contains(&Some(place));
        let pair = seats.iter().find(touching).map(|seat| seat.pair);
        let pair = pair.or_else(|| {
            let edge = |edge: &&Edge| moment.scenery.places(&self.model, edge.pair).contains(&Some(place));
            moment.edges.iter().find(edge).map(|edge| edge.pair)
        });
        let to_wall = pair.is_some_and(|pair| self.model.pairs[pair].bodies.contains(&None));
        let row = if to_wall && now != hit_to { Row::between(hit_to, now) } else { None };
        let from = if first { now } else { hit_to };
        self.record.transitions.push(Transition { t: moment.t, body, pair, from, to: now, row, lost });
    }
}

/// Speed along the face of what a candidate keeps \[m/s\].
fn along(moment: &Moment, candidate: &Candidate) -> f64 {
    let middle = middle(&candidate.points);
    moment.scenery.cluster.speed(&middle, middle.s)
}

/// The state that a hit alone leads to.
fn landed(blow: &Blow, to_wall: bool) -> State {
    let landing = &blow.landing;
    let flat = landing.flush && (!landing.turns || blow.last.is_some());
    match (blow.last, landing.after) {
        (Some(_), _) => State::Sliding,
        (_, After::Free) if !landing.turns => State::Free,
        (_, After::Free) => State::FreeTurning,
        // Two girders part or go together: who stays is decided next.
        _ if !to_wall => State::FreeTurning,
        (_, After::Contact { still: true }) if flat => State::Resting,
        (_, After::Contact { still: false }) if flat => State::Sliding,
        (_, After::Contact { still: true } | After::Again { held: true }) => State::Turning,
        _ => State::SlidingTurning,
    }
}

/// Kinetic energy of a moment \[J\].
fn kinetic(moment: &Moment) -> f64 {
    let cluster = &moment.scenery.cluster;
    let part = |v: f64, inverse: f64| if inverse > 0.0 { 0.5 * v * v / inverse } else { 0.0 };
    let body = |(v, inverse): (&DVec3, &DVec3)| (0..3).map(|i| part(v[i], inverse[i])).sum::<f64>();
    cluster.velocity.iter().zip(&cluster.inverse).map(body).sum()
}

/// Bodies that seats join, by their places, each with its seats.
fn joined(model: &crate::dynamics::Model, scenery: &Scenery, seats: Vec<Seat>) -> Vec<(Vec<usize>, Vec<Seat>)> {
    let mut groups: Vec<(Vec<usize>, Vec<Seat>)> = Vec::new();
    for seat in seats {
        let places: Vec<usize> = scenery.places(model, seat.pair).into_iter().flatten().collect();
        let (mut into, others): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|(members, _)| places.iter().any(|place| members.contains(place)));
        let mut members = places;
        let mut all = Vec::new();
        for (places, seats) in into.drain(..) {
            members.extend(places);
            all.extend(seats);
        }
        all.push(seat);
        members.sort_unstable();
        members.dedup();
        groups = others;
        groups.push((members, all));
    }
    groups.sort_by_key(|(members, _)| members.first().copied());
    groups
}

fn painleve(state: State) -> String {
    format!(
        "in state {} ({}) neither staying put, sliding nor leaving agrees with the equations: past the Painlevé bound \
         w_n − μ |w_ns| ≤ 0, or several contacts together, friction drives a corner in; lower mu_kinetic, or take the \
         contact model",
        state.letter(),
        state.label()
    )
}
