//! What happens at an instant: who touches, the hits until nobody is driven in, who stays.

use glam::{DVec2, DVec3};

use smallvec::smallvec;

use crate::dynamics::free_flight::flight::Planar;
use crate::dynamics::impact2d::after_impact::DRIFT;
use crate::dynamics::impact2d::delassus::Point;
use crate::dynamics::impact2d::engine::Engine;
use crate::dynamics::impact2d::impulse::collision::{Blow, Edge, Rules, strike};
use crate::dynamics::impact2d::lasting::constrained_motion::{Scenery, shaking};
use crate::dynamics::impact2d::lasting::lasting_contact::Ending;
use crate::dynamics::impact2d::record::{Hit, Transition};
use crate::dynamics::impact2d::state::{After, Row};
use crate::dynamics::impact2d::tracks::Going;
use crate::dynamics::impact2d::{Few, State};

/// Points nearer than this touch, and faces with both ends nearer are flush, in parts of the girder's size.
pub(in crate::dynamics::impact2d) const TOUCH: f64 = 1e-9;
/// Hits at one instant with a bounce; girders that are wedged between others lose theirs after as many.
const LIVELY: usize = 64;
/// Hits at one instant after which all who are still driven in stop together.
const MOST: usize = 256;

/// Speeds that are rounding, in parts of the fastest that anybody has been.
const RUN: f64 = 1e-14;

/// Everybody whom an instant concerns.
pub(in crate::dynamics::impact2d) struct Moment {
    pub(in crate::dynamics::impact2d) t: f64,
    /// Slots, rising; so are the numbers in the model.
    pub(in crate::dynamics::impact2d) slots: Few<usize>,
    pub(in crate::dynamics::impact2d) states: Few<Planar>,
    pub(in crate::dynamics::impact2d) scenery: Scenery,
    /// State among a–f before.
    pub(in crate::dynamics::impact2d) before: Few<State>,
    pub(in crate::dynamics::impact2d) edges: Few<Edge>,
    pub(in crate::dynamics::impact2d) hush: f64,
}

impl Engine {
    /// States at t = 0.
    pub(in crate::dynamics::impact2d) fn begin(&mut self) {
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
    pub(in crate::dynamics::impact2d) fn point(&self, site: usize, pair: usize, t: f64) -> Point {
        let slots = self.pairs[pair].slots;
        let still = crate::contact::Frame::fixed(DVec3::ZERO);
        let frames = slots.map(|slot| slot.map_or(still, |slot| self.frame(slot, t)));
        let places = slots.map(|slot| slot.map(|_| 0));
        Point::of(&self.model, self.sites[site].number, places, [&frames[0], &frames[1]])
    }

    /// Meets whoever touches these bodies at `t`; returns the slots of all whom it concerned.
    pub(in crate::dynamics::impact2d) fn meet(
        &mut self,
        t: f64,
        seeds: &[usize],
        ending: Option<Ending>,
    ) -> Few<usize> {
        let mut moment = self.moment(t, seeds);
        let slots = moment.slots.clone();
        if t == 0.0 && self.overlaps(&moment) {
            return slots;
        }
        for (slot, state) in slots.iter().zip(moment.states.clone()) {
            self.note(*slot, &state);
        }
        moment.hush = moment.hush.max(RUN * self.largest[0]);
        let energy = kinetic(&moment);
        let mut to = moment.before.clone();
        let lost = self.hits(&mut moment, &mut to);
        self.settle(&mut moment, &to, energy - lost, ending);
        slots
    }

    /// Bodies that touching pairs and grips join to the seeds, where they are at `t`.
    fn moment(&self, t: f64, seeds: &[usize]) -> Moment {
        let mut slots: Few<usize> = seeds.into();
        let mut next = 0;
        while let Some(&slot) = slots.get(next) {
            next += 1;
            let mut joined: Few<usize> = Few::new();
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
        let states: Few<Planar> = slots.iter().map(|&slot| self.state(slot, t)).collect();
        let bodies: Few<usize> = slots.iter().map(|&slot| self.bodies[slot].body).collect();
        let piece = self.model.ground.piece(self.model.ground.piece_number(t));
        let scenery = Scenery::new(&self.model, &bodies, &states, shaking(&self.model.ground, &piece, t));
        let before = slots.iter().map(|&slot| self.bodies[slot].state).collect();
        let mut moment = Moment { t, slots, states, scenery, before, edges: Few::new(), hush: 0.0 };
        moment.edges = self.edges(&moment);
        let points = moment.edges.iter().flat_map(|edge| &edge.points);
        moment.hush = moment.scenery.cluster.rounding(points).max(RUN * self.largest[0]);
        moment
    }

    fn touches_at(&self, site: usize, pair: usize, t: f64) -> bool {
        self.touches(site, pair, &self.point(site, pair, t))
    }

    /// Whether a point is on its face.
    pub(in crate::dynamics::impact2d) fn touches(&self, site: usize, pair: usize, point: &Point) -> bool {
        if self.sites[site].left {
            return false;
        }
        let near = TOUCH * self.reach(pair);
        let near_enough = point.gap.abs() <= near || (self.sites[site].kept && point.gap.abs() <= 1e3 * near);
        near_enough && point.inset >= -near
    }

    /// Size of the smaller girder of a pair \[m\].
    pub(in crate::dynamics::impact2d) fn reach(&self, pair: usize) -> f64 {
        let radius = |slot: usize| self.model.bodies[self.bodies[slot].body].radius;
        self.pairs[pair].slots.into_iter().flatten().map(radius).fold(f64::INFINITY, f64::min)
    }

    /// Pairs of a moment that touch: at a corner, or at the two outermost points of a face.
    pub(in crate::dynamics::impact2d) fn edges(&self, moment: &Moment) -> Few<Edge> {
        let mut edges = Few::new();
        for pair in self.pairs_of(&moment.slots) {
            let here = |slot: Option<usize>| slot.is_none_or(|slot| moment.slots.binary_search(&slot).is_ok());
            if !self.pairs[pair].slots.into_iter().all(here) {
                continue;
            }
            let mut touching: Few<(usize, Point)> = Few::new();
            for site in self.pairs[pair].sites.clone() {
                let number = self.sites[site].number;
                let point = moment.scenery.point(&self.model, number);
                if self.touches(site, pair, &point) {
                    touching.push((number, point));
                }
            }
            touching.sort_by(|a, b| a.1.along.total_cmp(&b.1.along));
            let near = TOUCH * self.reach(pair);
            let outermost: Few<(usize, Point)> = match (touching.first(), touching.last()) {
                (Some(&first), Some(&last)) if last.1.along - first.1.along > near => smallvec![first, last],
                (Some(&first), _) => smallvec![first],
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
                    self.schedule.give_up(0.0, name, reason);
                    return true;
                }
            }
        }
        false
    }

    /// Hits everybody who is driven in until nobody is; the energy lost, and in `to` the states that the hits lead to.
    fn hits(&mut self, moment: &mut Moment, to: &mut [State]) -> f64 {
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
                crate::dynamics::impact2d::impulse::simultaneous::stop(&mut moment.scenery.cluster, &moment.edges, &[]);
                break;
            }
            lost += self.hit(moment, &edge, to, count > LIVELY);
        }
        lost
    }

    /// Whether all points of an edge are in lasting contact already.
    pub(in crate::dynamics::impact2d) fn is_kept(&self, edge: &Edge) -> bool {
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

    fn hit(&mut self, moment: &mut Moment, edge: &Edge, to: &mut [State], dead: bool) -> f64 {
        let numbers = self.model.impact;
        let places = moment.scenery.places(&self.model, edge.pair);
        let place = places.into_iter().flatten().next().unwrap_or(0);
        let from = to[place];
        let rules = Rules { numbers: &numbers, hush: moment.hush, dead };
        let blow = strike(&mut moment.scenery.cluster, edge, from, &rules);
        let to_wall = self.model.pairs[edge.pair].bodies.contains(&None);
        let row = if to_wall { Row::landing(&blow.landing) } else { None };
        let after = landed(&blow, to_wall);
        for place in places.into_iter().flatten() {
            if to[place] != after {
                let (t, body, pair) = (moment.t, moment.scenery.bodies[place], Some(edge.pair));
                let change = Transition { t, body, pair, from: to[place], to: after, row, lost: 0.0 };
                self.record.transitions.push(change);
            }
            to[place] = after;
        }
        let frame = &moment.scenery.frames[place];
        let lost = blow.lost;
        let at = |i: usize| edge.sites[i];
        self.record.hits.push(Hit {
            t: moment.t,
            pair: edge.pair,
            sites: edge.sites.to_vec(),
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
        lost
    }
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
pub(in crate::dynamics::impact2d) fn kinetic(moment: &Moment) -> f64 {
    let cluster = &moment.scenery.cluster;
    let part = |v: f64, inverse: f64| if inverse > 0.0 { 0.5 * v * v / inverse } else { 0.0 };
    let body = |(v, inverse): (&DVec3, &DVec3)| (0..3).map(|i| part(v[i], inverse[i])).sum::<f64>();
    cluster.velocity.iter().zip(&cluster.inverse).map(body).sum()
}
