//! A way on where no motion agrees with friction.
//!
//! Past the Painlevé bound, and where several contacts with friction hang together, it can be that a slide neither goes on
//! nor ends: whatever the face pushes, friction turns it against itself. Then, in this order,
//!
//! 1. who slides slower than the stop speed stays put;
//! 2. **impact without collision**: friction stops slides at once, the slowest first and as few as it takes, by the least
//!    impulses that stop them and drive nothing in (an orthogonal projection in the metric of the masses: no energy is
//!    added);
//! 3. what is left goes along the faces without friction for a step of the integrator, which always has an answer, and is
//!    decided anew.

use glam::DVec3;

use crate::dynamics::impact2d::after_impact::along;
use crate::dynamics::impact2d::delassus::{Cluster, Point};
use crate::dynamics::impact2d::engine::Engine;
use crate::dynamics::impact2d::impulse::simultaneous;
use crate::dynamics::impact2d::instant::Moment;
use crate::dynamics::impact2d::lasting::constrained_motion::{Answer, Scenery, Seat, Way, middle};
use crate::dynamics::impact2d::lasting::lasting_contact::Ending;
use crate::dynamics::impact2d::lasting::mode_selection::{Candidate, decide};

impl Engine {
    /// Who may stay in contact, and how they do; velocities change where friction has to stop a slide.
    pub(in crate::dynamics::impact2d) fn agree(
        &self,
        moment: &mut Moment,
        ending: Option<Ending>,
        shaking: DVec3,
    ) -> (Vec<Candidate>, Vec<Seat>) {
        let mut candidates = self.candidates(moment, ending);
        if let Some(seats) = self.consistent(moment, &mut candidates) {
            return (candidates, seats);
        }
        let mut sliding: Vec<(f64, usize, Point)> = candidates
            .iter()
            .filter(|candidate| candidate.slides != 0.0)
            .map(|candidate| (along(moment, candidate).abs(), candidate.pair, middle(&candidate.points)))
            .collect();
        sliding.sort_by(|a, b| a.0.total_cmp(&b.0));
        let before = moment.scenery.cluster.clone();
        let stops = ending.filter(|ending| matches!(ending, Ending::Stops(_)));
        for count in 1..=sliding.len() {
            let stopped: Vec<Point> = sliding[..count].iter().map(|slide| slide.2).collect();
            self.stop_at_once(moment, &before, &stopped, shaking);
            candidates = self.candidates(moment, stops);
            for candidate in &mut candidates {
                if sliding[..count].iter().any(|slide| slide.1 == candidate.pair) {
                    candidate.slides = 0.0;
                }
            }
            if let Some(seats) = self.consistent(moment, &mut candidates) {
                return (candidates, seats);
            }
        }
        let seats = smooth(&moment.scenery, &candidates);
        (candidates, seats)
    }

    /// What agrees with friction; who slides slower than the stop speed and cannot go on may stay put.
    fn consistent(&self, moment: &Moment, candidates: &mut [Candidate]) -> Option<Vec<Seat>> {
        let numbers = self.model.impact;
        decide(&self.model, &moment.scenery, candidates, &numbers).or_else(|| {
            let mut slow = false;
            for candidate in candidates.iter_mut().filter(|c| along(moment, c).abs() <= numbers.stop_speed) {
                (candidate.stays_or_leaves, slow) = (true, true);
            }
            slow.then(|| decide(&self.model, &moment.scenery, candidates, &numbers)).flatten()
        })
    }

    /// Stops the slides at these points, from the velocities `before`.
    fn stop_at_once(&self, moment: &mut Moment, before: &Cluster, slides: &[Point], shaking: DVec3) {
        let mut cluster = before.clone();
        simultaneous::stop(&mut cluster, &moment.edges, slides);
        for (state, v) in moment.states.iter_mut().zip(&cluster.velocity) {
            state[3..].copy_from_slice(&v.to_array());
        }
        moment.scenery = Scenery::new(&self.model, &moment.scenery.bodies, &moment.states, shaking);
    }
}

/// Everybody who is pressed stays, without friction: the accelerations nearest to the free ones that drive nothing in.
fn smooth(scenery: &Scenery, candidates: &[Candidate]) -> Vec<Seat> {
    let free = Answer { reactions: Vec::new(), accelerations: scenery.free.clone() };
    let points: Vec<Point> = candidates.iter().flat_map(|candidate| candidate.points.clone()).collect();
    let rates: Vec<f64> = points.iter().map(|p| free.along(p, p.n, p.bias[0])).collect();
    let rows: Vec<_> = points.iter().map(|p| (*p, p.n)).collect();
    let pushes = simultaneous::least(&scenery.cluster, &rows, &rates, 0);
    let mut pushed = points.iter().zip(pushes).map(|(point, push)| push > scenery.rounding(point));
    let mut seats = Vec::new();
    for candidate in candidates {
        let kept = pushed.by_ref().take(candidate.sites.len());
        let sites: Vec<usize> = candidate.sites.iter().zip(kept).filter(|(_, kept)| *kept).map(|(&s, _)| s).collect();
        if !sites.is_empty() {
            seats.push(Seat { pair: candidate.pair, sites, way: Way::Slides(0.0) });
        }
    }
    seats
}
