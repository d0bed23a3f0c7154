//! After the hits: who stays in contact and how, where everybody goes on, what is logged.

use glam::{DVec2, DVec3};

use crate::dynamics::free_flight::flight::Planar;
use crate::dynamics::impact2d::State;
use crate::dynamics::impact2d::delassus::Point;
use crate::dynamics::impact2d::engine::{Engine, SINK};
use crate::dynamics::impact2d::impulse::collision::Edge;
use crate::dynamics::impact2d::instant::{Moment, TOUCH, kinetic};
use crate::dynamics::impact2d::lasting::constrained_motion::{Scenery, Seat, Way, middle, shaking};
use crate::dynamics::impact2d::lasting::lasting_contact::{Ending, Grip};
use crate::dynamics::impact2d::lasting::mode_selection::{Candidate, RuledOut, decide};
use crate::dynamics::impact2d::record::Transition;
use crate::dynamics::impact2d::state::Row;
use crate::dynamics::impact2d::tracks::Going;
use crate::dynamics::{Body, Model};

/// A point so little behind a face, in parts of its girder's size, is there by the rounding of the search's gap, not by a hop: to
/// take it out would turn a girder that is hit square.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Speeds off the face that a kept point may have gathered by its integrator's error, in parts of the fastest.
pub(in crate::dynamics::impact2d) const DRIFT: f64 = 1e-8;

impl Engine {
    /// Decides who stays in contact, and sends everybody on; `energy` is the kinetic energy that the hits have left.
    pub(in crate::dynamics::impact2d) fn settle(
        &mut self,
        moment: &mut Moment,
        to: &[State],
        energy: f64,
        ending: Option<Ending>,
    ) {
        let numbers = self.model.impact;
        // The velocities are those after the hits.
        for (state, v) in moment.states.iter_mut().zip(&moment.scenery.cluster.velocity) {
            state[3..].copy_from_slice(&v.to_array());
        }
        if self.all_part(moment) {
            let (lost, strain) = (energy - kinetic(moment), self.strain(moment));
            let shifted = self.tidy(moment, &[]);
            self.go_on(moment, to, Vec::new(), if shifted { lost + strain - self.strain(moment) } else { lost });
            return;
        }
        let bodies = moment.scenery.bodies.clone();
        let piece = self.model.ground.piece(self.model.ground.piece_number(moment.t));
        let shaking = shaking(&self.model.ground, &piece, moment.t);
        moment.scenery = Scenery::new(&self.model, &bodies, &moment.states, shaking);
        let (mut candidates, mut seats) = self.agree(moment, ending, shaking);
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
        moment.scenery = Scenery::new(&self.model, &bodies, &moment.states, shaking);
        let lost = energy - kinetic(moment) + strain - self.strain(moment);
        self.go_on(moment, to, seats, lost);
    }

    /// Whether every point that touches goes away.
    fn all_part(&self, moment: &Moment) -> bool {
        moment.edges.iter().all(|edge| {
            let loose = self.looseness(edge) * moment.hush;
            edge.points.iter().all(|point| moment.scenery.cluster.speed(point, point.n) > loose)
        })
    }

    /// Speeds along the normal that count as none, in parts of the hush.
    fn looseness(&self, edge: &Edge) -> f64 {
        if self.is_kept(edge) { DRIFT / 1e-12 } else { 4.0 }
    }

    /// Pairs of a moment with points that neither come nor go.
    pub(in crate::dynamics::impact2d) fn candidates(&self, moment: &Moment, ending: Option<Ending>) -> Vec<Candidate> {
        let mut all = Vec::new();
        for edge in self.edges(moment) {
            let loose = self.looseness(&edge);
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

    /// Takes out of places and velocities what the integrator's error has left between what is kept; returns whether
    /// there was anything.
    fn tidy(&self, moment: &mut Moment, seats: &[Seat]) -> bool {
        let points: Vec<Vec<Point>> = seats.iter().map(|seat| moment.scenery.points(&self.model, seat)).collect();
        let mut rows: Vec<(Point, DVec2, f64)> = Vec::new();
        for (seat, points) in seats.iter().zip(&points) {
            rows.extend(points.iter().map(|p| (*p, p.n, p.gap)));
            if seat.way == Way::Held {
                let middle = middle(points);
                rows.push((middle, middle.s, 0.0));
            }
        }
        let kept = rows.len();
        // Who leaves leaves from the face, not from a little behind it: else every small hop would end a little deeper.
        for edge in &moment.edges {
            let leaves = |site: &usize| !seats.iter().any(|seat| seat.sites.contains(site));
            let rounding = ROUNDING * self.reach(edge.pair);
            let behind = edge.sites.iter().zip(&edge.points).filter(|(site, p)| leaves(site) && p.gap < -rounding);
            rows.extend(behind.map(|(_, p)| (*p, p.n, p.gap)));
        }
        if rows.is_empty() {
            return false;
        }
        let cluster = &moment.scenery.cluster;
        let entry = |r: usize, c: usize| cluster.mobility(&rows[r].0, rows[r].1, &rows[c].0, rows[c].1);
        let speeds = crate::dynamics::impact2d::dense::solve(kept, entry, |r| -cluster.speed(&rows[r].0, rows[r].1));
        let shifts = crate::dynamics::impact2d::dense::solve(rows.len(), entry, |r| -rows[r].2);
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
        true
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
            self.note(slot, &moment.states[place]);
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
        for pair in self.pairs_of(&moment.slots) {
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
                let track = &mut self.sites[site];
                (track.kept, track.out) = (kept, None);
                if touches && !kept {
                    // Until it is clearly out, it is watched just behind the face.
                    (track.armed, track.lifted) = (false, true);
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
        let turns = turns_by_itself(body)
            || body.radius * v.z.abs() > moment.hush.max(1e-12 * v.truncate().length())
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

/// Whether a girder turns without being hit: eccentric bearings, or a given moment.
fn turns_by_itself(body: &Body) -> bool {
    let coupled = |m: &glam::DMat3| {
        let [x, y] = [m.z_axis.x, m.z_axis.y];
        x.abs() > 1e-12 * (m.x_axis.x * m.z_axis.z).sqrt() || y.abs() > 1e-12 * (m.y_axis.y * m.z_axis.z).sqrt()
    };
    body.free[5] && (body.moment != 0.0 || coupled(&body.planar.stiffness) || coupled(&body.planar.damping))
}

/// Speed along the face of what a candidate keeps \[m/s\].
pub(in crate::dynamics::impact2d) fn along(moment: &Moment, candidate: &Candidate) -> f64 {
    let middle = middle(&candidate.points);
    moment.scenery.cluster.speed(&middle, middle.s)
}

/// Bodies that seats join, by their places, each with its seats.
fn joined(model: &Model, scenery: &Scenery, seats: Vec<Seat>) -> Vec<(Vec<usize>, Vec<Seat>)> {
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
