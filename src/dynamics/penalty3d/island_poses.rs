//! What the bodies of an island do within its planned step.

use crate::contact::Frame;
use crate::dynamics::free_flight::motion_bounds::MotionBounds;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::rigid_body;
use crate::dynamics::penalty3d::island::{Island, normalise};
use crate::dynamics::{Body, Model};
use crate::scene::Kind;

impl Island {
    /// State of one of its bodies within the planned step, counted from its base.
    pub(in crate::dynamics) fn state_at(&self, model: &Model, index: usize, t: f64) -> Vec<f64> {
        let width = rigid_body::width(model.kind);
        let range = index * width..(index + 1) * width;
        match &self.dense {
            Some(dense) if t < self.until => {
                let mut out = vec![0.0; width];
                dense.read(range, t, &mut out);
                normalise(model, &self.bodies[index..=index], &mut out);
                out
            }
            _ => self.y[range].to_vec(),
        }
    }

    /// Pose of one of its bodies within the planned step.
    pub(in crate::dynamics) fn frame(&self, model: &Model, index: usize, t: f64) -> Frame {
        self.bases[index].whole(&self.frame_since(model, index, t))
    }

    /// The same, counted from its base.
    pub(in crate::dynamics) fn frame_since(&self, model: &Model, index: usize, t: f64) -> Frame {
        let width = rigid_body::width(model.kind);
        let range = index * width..(index + 1) * width;
        let (base, body): (&ReferencePose, &Body) = (&self.bases[index], &model.bodies[self.bodies[index]]);
        match &self.dense {
            Some(dense) => {
                let mut state = [0.0; rigid_body::SPATIAL];
                dense.read(range, t, &mut state[..width]);
                base.since(body, &state[..width])
            }
            None => base.since(body, &self.y[range]),
        }
    }

    /// Poses of all its bodies within the planned step, counted from their bases, time after time.
    pub(in crate::dynamics) fn frames_since(&self, model: &Model, times: &[f64]) -> Vec<Frame> {
        let mut frames = Vec::with_capacity(times.len() * self.bodies.len());
        for &t in times {
            frames.extend((0..self.bodies.len()).map(|index| self.frame_since(model, index, t)));
        }
        frames
    }

    /// How far a point at `arm` from G of one of its bodies goes at most from where it is at `t`, within the planned step
    /// \[m\].
    pub(in crate::dynamics) fn excursion(&self, model: &Model, index: usize, arm: f64, t: f64) -> f64 {
        let width = rigid_body::width(model.kind);
        let Some(dense) = &self.dense else { return 0.0 };
        let span = |range: std::ops::Range<usize>| {
            dense.displacement_bound(index * width + range.start..index * width + range.end)
        };
        let from_start = match model.kind {
            Kind::Planar => span(0..2) + arm * span(2..3),
            // A quaternion turns half the angle; the chord is not longer than the arc.
            Kind::Spatial => span(0..3) + 2.0 * arm * span(3..7),
        };
        if t > self.from { 2.0 * from_start } else { from_start }
    }

    /// What one of its bodies can do at most within the planned step.
    pub(in crate::dynamics) fn bound(&self, model: &Model, index: usize) -> MotionBounds {
        let Some(dense) = &self.dense else { return MotionBounds::still(f64::INFINITY) };
        let [place, turn] = rigid_body::parts(model.kind, index);
        let ([speed, acceleration], [turning, bending]) =
            (dense.derivative_bounds(place), dense.derivative_bounds(turn));
        let (spin, spin_rate) = match model.kind {
            Kind::Planar => (turning, bending),
            // A quaternion turns half the angle; its length differs from 1 by less than a tenth.
            Kind::Spatial => (2.2 * turning, 2.2 * bending + 8.0 * turning * turning),
        };
        MotionBounds { speed, spin, acceleration, spin_rate, ..MotionBounds::still(f64::INFINITY) }
    }

    /// Bounds on how fast G of one of its bodies moves and changes its speed against that of another.
    pub(in crate::dynamics) fn apart(&self, model: &Model, [a, b]: [usize; 2]) -> [f64; 2] {
        let [one, other] = [a, b].map(|index| rigid_body::parts(model.kind, index)[0].clone());
        self.dense.as_ref().map_or([0.0; 2], |dense| dense.difference_derivative_bounds(one, other.start))
    }
}
