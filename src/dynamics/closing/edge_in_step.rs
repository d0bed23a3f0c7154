//! The first closing of an edge node within planned steps: subdivision of the gap of two edges with the bound on its
//! second derivative, at a crossing that is a contact point.
//!
//! The lines of two edges meet at many times at which the edges do not: a crossing of 0 beside the edges, at a corner
//! that is inside the polygon is passed over, and the gap has to be positive again before the next one.

use crate::dynamics::closing::constants::CLOSING_INTERVAL;
use crate::dynamics::closing::gap_curvature::GapCurvature;
use crate::dynamics::closing::step_samples::{StepSamples, excursion, rate_error};
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::subdivision::{GapClosing, GapSample, Subdivision};
use crate::dynamics::model::edge_node::{Edge, EdgeEnds};
use crate::dynamics::world::World;
use crate::dynamics::world::contact_points::{self, poses_at};

/// Closing of an edge node, and time from which it is armed if it was not \[s\]. There is none before `from`, and one after `last` may be
/// left out.
pub(super) fn search(
    world: &World,
    contact: usize,
    samples: &mut StepSamples,
    armed: bool,
    [from, last]: [f64; 2],
) -> GapClosing {
    let times = samples.times;
    let [t, until] = [times[0], times[times.len() - 1]];
    let site = world.site(contact);
    let Some(edge) = site.edge.as_deref().filter(|_| until > t) else { return GapClosing::NONE };
    let ends_at = |samples: &mut StepSamples, i: usize| samples.edge_ends(world, (contact, edge), i);
    if edge.is_of_met() && !edge.may_belong(samples.sides(world, contact, 0), samples.turned(world)) {
        return GapClosing::NONE;
    }
    let before = ends_at(samples, 0);
    let arms = levers(world, contact, samples);
    let slots = world.contacts[contact].slots;
    let reach: f64 =
        slots.iter().zip(arms).map(|(slot, arm)| slot.map_or(0.0, |s| excursion(world, s, arm, t, until))).sum();
    if edge.is_clear(&before, reach) {
        return GapClosing::NONE;
    }
    let first = with_sense(world, contact, samples, (before.sense(), armed), [from, last], arms);
    // The sign of the gap of two lines changes where they pass through parallel.
    if (before.inset[1] - before.inset[0]).abs() > 2.0 * reach {
        return first;
    }
    samples.fill(world);
    let turned = -before.sense();
    if (1..times.len()).all(|i| ends_at(samples, i).sense() != turned) {
        return first;
    }
    let other = with_sense(world, contact, samples, (turned, true), [from, last], arms);
    GapClosing { closing: first.closing.into_iter().chain(other.closing).reduce(f64::min), ..first }
}

/// Closing of an edge node with the gap times `sense` (±1); `arms` are bounds on the distances of the ends of the edge from G of both
/// bodies \[m\].
fn with_sense(
    world: &World,
    contact: usize,
    samples: &mut StepSamples,
    (sense, armed): (f64, bool),
    [from, last]: [f64; 2],
    arms: [f64; 2],
) -> GapClosing {
    let times = samples.times;
    let [t, until] = [times[0], times[times.len() - 1]];
    let Some(edge) = world.edge(contact) else { return GapClosing::NONE };
    let lines = EdgeGap { world, contact, edge, sense };
    let before = samples.edge_ends(world, (contact, edge), 0);
    let resolution = samples.resolution(world, contact) * edge.amplification(&before).max(1.0);
    let start = from.max(t);
    let (here, error) = if start > t {
        (lines.ends(start), lines.rate_error(start))
    } else {
        (before, rate_error(world, contact, samples.sides(world, contact, 0)))
    };
    let first = lines.sample(&here, start);
    let GapSample { gap, rate, .. } = first;
    let closes_now = armed && gap.abs() <= resolution && rate < -error * edge.amplification(&here).max(1.0);
    if closes_now && lines.begins(start) {
        return GapClosing::at(start);
    }
    // A gap that is negative beyond round-off, or falls through 0 now beside the edges, was passed over.
    let armed = armed && !is_positive_again(-gap, rate, start, resolution) && !closes_now;
    let pair = world.pair_of(contact).slots;
    let bounds = *samples.bounds(world);
    let node = usize::from(world.contacts[contact].slots[0] == pair[1]);
    let bound = |bounds: &GapCurvature, here: &EdgeEnds, stretch: f64| {
        let motion = [bounds.speed_on_face(node, arms, stretch), bounds.curvature(node, arms, stretch)];
        edge.curvature(here, motion, stretch)
    };
    let span = until - t;
    let curvature_bound = bound(&bounds, &before, span);
    let left = last.min(until) - start;
    let way = |rate: f64| resolution + left * (rate.max(0.0) + 0.5 * curvature_bound * left);
    // What stays positive does not close; what stays negative closes nothing and is not positive again.
    let stays = if armed { gap > way(-rate) } else { -gap > way(rate) };
    if stays && bounds.holds(span) {
        return GapClosing::NONE;
    }
    let curvature = |from: &GapSample, to: f64| {
        if bounds.holds(span) {
            return curvature_bound;
        }
        let part = GapCurvature::of(world, pair, from.t, to);
        if part.holds(to - from.t) { bound(&part, &lines.ends(from.t), to - from.t) } else { f64::INFINITY }
    };
    let gaps = lines.sampled(samples, first, last);
    lines.first_beginning(gaps, curvature, armed, resolution, last)
}

/// The gap of two edges, those of an edge node and across its face, with one sign.
struct EdgeGap<'w> {
    world: &'w World,
    contact: usize,
    edge: &'w Edge,
    /// The sign.
    sense: f64,
}

impl EdgeGap<'_> {
    fn ends(&self, t: f64) -> EdgeEnds {
        let [node, face] = poses_at(self.world, self.contact, t);
        self.edge.ends(&node, &face)
    }

    fn sample(&self, here: &EdgeEnds, t: f64) -> GapSample {
        let [gap, rate] = self.edge.gap(here, self.sense);
        GapSample { t, gap, rate }
    }

    fn at(&self, t: f64) -> GapSample {
        self.sample(&self.ends(t), t)
    }

    fn rate_error(&self, t: f64) -> f64 {
        let [node, face] = poses_at(self.world, self.contact, t);
        rate_error(self.world, self.contact, [&node, &face])
    }

    /// Gaps at the sample times of the step after `first`, up to `last` \[s\].
    fn sampled(&self, samples: &mut StepSamples, first: GapSample, last: f64) -> Vec<GapSample> {
        samples.fill(self.world);
        let times = samples.times;
        let within = (1..times.len()).filter(|&i| first.t < times[i] && times[i] <= last);
        let mut gaps = vec![first];
        for i in within {
            let ends = samples.edge_ends(self.world, (self.contact, self.edge), i);
            gaps.push(self.sample(&ends, times[i]));
        }
        if last < times[times.len() - 1] && gaps.last().is_some_and(|gap| gap.t < last) {
            gaps.push(self.at(last));
        }
        gaps
    }

    /// First closing between these samples that is a contact point, and when a gap that was not armed was positive again \[s\]: zeros beside
    /// the edges are passed over.
    fn first_beginning(
        &self,
        mut gaps: Vec<GapSample>,
        curvature: impl Fn(&GapSample, f64) -> f64,
        mut armed: bool,
        resolution: f64,
        last: f64,
    ) -> GapClosing {
        let interval = CLOSING_INTERVAL * self.world.pair_of(self.contact).simultaneity;
        let mut rearmed_at = None;
        loop {
            let functions = (|t| self.at(t), &curvature, |t| self.rate_error(t));
            let found = Subdivision::new(functions, armed, resolution, interval).search(&gaps);
            rearmed_at = rearmed_at.or(found.rearmed_at);
            match found.closing {
                Some(at) if at > last => return GapClosing { closing: None, rearmed_at },
                Some(at) if !self.begins(at) => {
                    armed = false;
                    gaps =
                        std::iter::once(self.at(at)).chain(gaps.into_iter().filter(|sample| sample.t > at)).collect();
                }
                closing => return GapClosing { closing, rearmed_at },
            }
        }
    }

    /// Whether a contact begins where the lines of the edges meet: at a contact point, with a gap of this sign, and with a
    /// distance of the lines that falls.
    fn begins(&self, t: f64) -> bool {
        let ends = self.ends(t);
        let crossing = contact_points::crossing(self.world, self.contact, &|other| poses_at(self.world, other, t));
        let rate = crossing.map_or(0.0, |crossing| self.edge.distance_rate(&crossing, &ends));
        ends.sense() == self.sense && rate < -self.rate_error(t)
    }
}

/// Bounds on the distances of the ends of a contact's edge from G of its own body and of the face's \[m\].
fn levers(world: &World, contact: usize, samples: &StepSamples) -> [f64; 2] {
    let site = world.site(contact);
    let [own, apart] = site.levers(&samples.local(world, contact, 0));
    [own, apart + site.half_edge()]
}
