//! States, poses and bounds on the motion of an island's bodies within its planned step.

use std::ops::Range;

use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::penalty3d::island::Island;

/// Motion of a body along its only axis in a planned step.
pub(in crate::dynamics) struct StepAlong<'a> {
    pub dense: &'a DenseOutput,
    /// Components of position and velocity in the dense output.
    pub components: [usize; 2],
    /// Coordinate of the body's reference pose \[m\].
    pub base: f64,
}

impl Island {
    fn body<'a>(&self, model: &'a Model, index: usize) -> &'a Body {
        &model.bodies[self.system.bodies[index]]
    }

    /// State of a body at `t` within the planned step, relative to its reference pose.
    pub(in crate::dynamics) fn state_at(&self, model: &Model, index: usize, t: f64) -> Vec<f64> {
        let range = self.system.layout.range(index);
        match &self.step.dense {
            Some(dense) if t < self.step.until => {
                let mut out = vec![0.0; range.len()];
                dense.read(range, t, &mut out);
                self.body(model, index).normalise(&mut out);
                out
            }
            _ => self.stepper.y[range].to_vec(),
        }
    }

    /// Pose of a section of a body at `t` within the planned step, relative to its placed pose.
    pub(in crate::dynamics) fn frame(&self, model: &Model, index: usize, section: usize, t: f64) -> Frame {
        self.system.bases[index].whole(&self.frame_since(model, index, section, t))
    }

    /// Pose of a section of a body at `t` within the planned step, relative to its reference pose.
    pub(in crate::dynamics) fn frame_since(&self, model: &Model, index: usize, section: usize, t: f64) -> Frame {
        self.with_state(model, index, t, |body, state| body.frame_since(section, state))
    }

    /// Value of `take` at the state of a body at `t` within the planned step, relative to its reference pose, as the
    /// dense output gives it.
    fn with_state<T>(&self, model: &Model, index: usize, t: f64, take: impl FnOnce(&Body, &[f64]) -> T) -> T {
        let (range, body) = (self.system.layout.range(index), self.body(model, index));
        match &self.step.dense {
            Some(dense) => body.with_state(|state| dense.read(range, t, state), |state| take(body, state)),
            None => take(body, &self.stepper.y[range]),
        }
    }

    /// Poses of the sections of the bodies that connections act on at `times` within the planned step, relative to their reference poses,
    /// time by time; in place of the other sections those as placed.
    pub(in crate::dynamics) fn frames_since(&self, model: &Model, times: &[f64]) -> Vec<Frame> {
        let mut frames = Vec::with_capacity(times.len() * self.system.layout.section_count());
        for &t in times {
            for index in 0..self.system.bodies.len() {
                let acted_on = &self.system.acted_on[self.system.layout.sections(index)];
                self.with_state(model, index, t, |body, state| body.push_frames_of(acted_on, state, &mut frames));
            }
        }
        frames
    }

    /// The motion of a body along `axis` in the planned step, where it has no other.
    pub(in crate::dynamics) fn along(&self, index: usize, axis: usize) -> Option<StepAlong<'_>> {
        let components = self.kind.components(index, axis)?;
        let dense = self.step.dense.as_ref()?;
        Some(StepAlong { dense, components, base: self.system.bases[index].planar()[axis] })
    }

    /// Components in the island's vector of the components `own` of a body's state.
    fn components(&self, index: usize, own: Range<usize>) -> Range<usize> {
        let from = self.system.layout.range(index).start;
        from + own.start..from + own.end
    }

    /// Bound of the displacement of a point at distance `arm` from G of a body from its position at `t` \[m\], within
    /// the planned step.
    pub(in crate::dynamics) fn excursion(&self, model: &Model, index: usize, arm: f64, t: f64) -> f64 {
        let Some(dense) = &self.step.dense else { return 0.0 };
        let way = |own: Range<usize>| dense.displacement_bound(self.components(index, own));
        let from_start = self.body(model, index).excursion(arm, &way);
        if t > self.step.from { 2.0 * from_start } else { from_start }
    }

    /// Bounds on the motion of a body within the planned step.
    pub(in crate::dynamics) fn bound(&self, model: &Model, index: usize) -> MotionBounds {
        let Some(dense) = &self.step.dense else { return MotionBounds::still(f64::INFINITY) };
        self.body(model, index).bounds(&|own| dense.derivative_bounds(self.components(index, own)))
    }

    /// Bounds of relative speed \[m/s\] and acceleration \[m/s²\] of a section of each of two bodies within the planned
    /// step; `None` where these are not differences of components.
    pub(in crate::dynamics) fn apart(&self, model: &Model, pair: [usize; 2]) -> Option<[f64; 2]> {
        let Some(dense) = &self.step.dense else { return Some([0.0; 2]) };
        let [one, other] = pair.map(|index| Some(self.components(index, self.body(model, index).displacements()?)));
        let (one, other) = (one?, other?);
        (one.len() == other.len()).then(|| dense.difference_derivative_bounds(one, other.start))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::penalty3d::example::{SPEED, closed, free_to_turn, island_of, row, stick, wall};

    const POSE_SAMPLES: u32 = 400;

    /// An island with its first step planned.
    fn planned(scene: &crate::scene::Scene, y: Vec<f64>) -> (Model, Island) {
        let (model, active) = closed(scene, stick);
        let mut island = island_of(&model, active, y);
        island.plan(&model, 1.0, f64::INFINITY).expect("a step that can be made");
        (model, island)
    }

    /// A girder that hits a wall, slides along it and turns.
    fn hit() -> (Model, Island) {
        planned(&free_to_turn(wall()), vec![0.0, 0.0, 0.0, SPEED, 0.1, 2.0])
    }

    fn times(island: &Island) -> Vec<f64> {
        (0..=POSE_SAMPLES)
            .map(|i| island.step.from + (island.step.until - island.step.from) * f64::from(i) / f64::from(POSE_SAMPLES))
            .collect()
    }

    /// Largest length of the differences of neighbouring vectors, per interval.
    fn steepest(values: &[glam::DVec3], interval: f64) -> f64 {
        values.windows(2).map(|two| (two[1] - two[0]).length() / interval).fold(0.0, f64::max)
    }

    #[test]
    fn bounds_on_the_motion_hold_and_are_not_far_above() {
        let (model, island) = hit();
        let frames: Vec<Frame> = times(&island).iter().map(|&t| island.frame_since(&model, 0, 0, t)).collect();
        let interval = (island.step.until - island.step.from) / f64::from(POSE_SAMPLES);
        let largest = |of: fn(&Frame) -> glam::DVec3| frames.iter().map(|f| of(f).length()).fold(0.0, f64::max);
        let change = |of: fn(&Frame) -> glam::DVec3| steepest(&frames.iter().map(of).collect::<Vec<_>>(), interval);
        let bound = island.bound(&model, 0);
        let pairs = [
            ("speed", largest(|f| f.velocity), bound.speed),
            ("spin", largest(|f| f.spin), bound.spin),
            ("acceleration", change(|f| f.velocity), bound.acceleration),
            ("spin rate", change(|f| f.spin), bound.spin_rate),
        ];
        for (name, value, bound) in pairs {
            assert!(value <= bound * (1.0 + 1e-9) && bound < 4.0 * value, "{name}: {bound} against {value}");
        }
    }

    #[test]
    fn no_point_of_a_body_leaves_its_excursion() {
        let (model, island) = hit();
        let arm = glam::DVec3::new(0.095, 0.035, 0.0);
        let place = |t: f64| {
            let frame = island.frame_since(&model, 0, 0, t);
            frame.shift + frame.turned * arm
        };
        for from in [island.step.from, f64::midpoint(island.step.from, island.step.until)] {
            let far = times(&island).into_iter().filter(|t| *t >= from).map(|t| (place(t) - place(from)).length());
            let (far, bound) = (far.fold(0.0, f64::max), island.excursion(&model, 0, arm.length(), from));
            assert!(far <= bound && bound < 6.0 * far, "from {from} s: {bound} m against {far}");
        }
    }

    #[test]
    fn a_common_motion_is_no_relative_motion() {
        let drift = [0.0, 0.0, 0.0, 1.0, 0.3, 0.0];
        let (model, island) = planned(&row(), [drift, drift].concat());
        let [speed, acceleration] = island.apart(&model, [0, 1]).expect("two rigid girders");
        assert!(speed < 1e-12 && acceleration < 1e-9, "{speed} m/s, {acceleration} m/s²");
        let towards = |u: f64| [0.0, 0.0, 0.0, u, 0.0, 0.0];
        let (model, island) = planned(&row(), [towards(SPEED), towards(-SPEED)].concat());
        let [speed, _] = island.apart(&model, [0, 1]).expect("two rigid girders");
        assert!((2.0 * SPEED..4.0 * SPEED).contains(&speed), "{speed} m/s of an approach at {}", 2.0 * SPEED);
    }

    #[test]
    fn states_and_poses_are_those_of_the_dense_output_and_of_the_end() {
        let (model, island) = hit();
        assert_eq!(island.state_at(&model, 0, island.step.until), island.stepper.y, "the end to the last bit");
        assert_eq!(island.state_at(&model, 0, island.step.from)[3..], [SPEED, 0.1, 2.0], "the start");
        let times = times(&island);
        let frames = island.frames_since(&model, &times);
        let alone: Vec<Frame> = times.iter().map(|&t| island.frame(&model, 0, 0, t)).collect();
        assert_eq!(frames.len(), times.len(), "one section of one body");
        let same = |(since, whole): (&Frame, &Frame)| since.shift == whole.shift && since.velocity == whole.velocity;
        assert!(frames.iter().zip(&alone).all(same), "the reference pose is the placed one");
    }
}
