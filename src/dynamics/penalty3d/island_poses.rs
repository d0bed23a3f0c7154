//! States, poses and bounds on the motion of an island's bodies within its planned step.

use std::ops::Range;

use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::penalty3d::island::Island;

impl Island {
    fn body<'a>(&self, model: &'a Model, index: usize) -> &'a Body {
        &model.bodies[self.bodies[index]]
    }

    /// State of a body at `t` within the planned step, relative to its reference pose.
    pub(in crate::dynamics) fn state_at(&self, model: &Model, index: usize, t: f64) -> Vec<f64> {
        let range = self.layout.range(index);
        match &self.dense {
            Some(dense) if t < self.until => {
                let mut out = vec![0.0; range.len()];
                dense.read(range, t, &mut out);
                self.body(model, index).normalise(&mut out);
                out
            }
            _ => self.y[range].to_vec(),
        }
    }

    /// Pose of a section of a body at `t` within the planned step, relative to its placed pose.
    pub(in crate::dynamics) fn frame(&self, model: &Model, index: usize, section: usize, t: f64) -> Frame {
        self.bases[index].whole(&self.frame_since(model, index, section, t))
    }

    /// Pose of a section of a body at `t` within the planned step, relative to its reference pose.
    pub(in crate::dynamics) fn frame_since(&self, model: &Model, index: usize, section: usize, t: f64) -> Frame {
        self.with_state(model, index, t, |body, state| body.frame_since(section, state))
    }

    /// Value of `take` at the state of a body at `t` within the planned step, relative to its reference pose, as the dense
    /// output gives it.
    fn with_state<T>(&self, model: &Model, index: usize, t: f64, take: impl FnOnce(&Body, &[f64]) -> T) -> T {
        let (range, body) = (self.layout.range(index), self.body(model, index));
        match &self.dense {
            Some(dense) => body.with_state(|state| dense.read(range, t, state), |state| take(body, state)),
            None => take(body, &self.y[range]),
        }
    }

    /// Poses of all sections of the bodies at `times` within the planned step, relative to their reference poses, time by
    /// time.
    pub(in crate::dynamics) fn frames_since(&self, model: &Model, times: &[f64]) -> Vec<Frame> {
        let mut frames = Vec::with_capacity(times.len() * self.layout.section_count());
        for &t in times {
            for index in 0..self.bodies.len() {
                self.with_state(model, index, t, |body, state| body.push_frames(state, &mut frames));
            }
        }
        frames
    }

    /// Components in the island's vector of the components `own` of a body's state.
    fn components(&self, index: usize, own: Range<usize>) -> Range<usize> {
        let from = self.layout.range(index).start;
        from + own.start..from + own.end
    }

    /// Bound of the displacement of a point at distance `arm` from G of a body from its position at `t` \[m\], within
    /// the planned step.
    pub(in crate::dynamics) fn excursion(&self, model: &Model, index: usize, arm: f64, t: f64) -> f64 {
        let Some(dense) = &self.dense else { return 0.0 };
        let way = |own: Range<usize>| dense.displacement_bound(self.components(index, own));
        let from_start = self.body(model, index).excursion(arm, &way);
        if t > self.from { 2.0 * from_start } else { from_start }
    }

    /// Bounds on the motion of a body within the planned step.
    pub(in crate::dynamics) fn bound(&self, model: &Model, index: usize) -> MotionBounds {
        let Some(dense) = &self.dense else { return MotionBounds::still(f64::INFINITY) };
        self.body(model, index).bounds(&|own| dense.derivative_bounds(self.components(index, own)))
    }

    /// Bounds of relative speed \[m/s\] and acceleration \[m/s²\] of a section of each of two bodies within the planned
    /// step; `None` where these are not differences of components.
    pub(in crate::dynamics) fn apart(&self, model: &Model, pair: [usize; 2]) -> Option<[f64; 2]> {
        let Some(dense) = &self.dense else { return Some([0.0; 2]) };
        let [one, other] = pair.map(|index| Some(self.components(index, self.body(model, index).displacements()?)));
        let (one, other) = (one?, other?);
        (one.len() == other.len()).then(|| dense.difference_derivative_bounds(one, other.start))
    }
}
