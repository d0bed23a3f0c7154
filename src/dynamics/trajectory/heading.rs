//! Rotation of a spatial body about the vertical, counted along its path (`docs/physics.md#motion-in-space`).
//!
//! An attitude determines the heading of the body's axis in plan, an angle modulo 2π. Its half turns are counted segment
//! by segment when a step is stored, so that the angle at any time is a function of the stored path alone. A half turn
//! is a whole one of the heading, or of an axis that has passed through the vertical: there the heading reverses, and
//! the angle follows the line of the axis.

use std::f64::consts::PI;

use glam::DVec2;

use crate::dynamics::model::body::Body;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;

/// Horizontal part of a unit axis below which the axis counts as vertical, without a heading \[–\]. Tuned: a
/// twentieth of a degree, which at most ten bisections of a radian lead to.
const VERTICAL: f64 = 1e-3;

/// Half turns of a body's angle at the beginning of each of its segments.
#[derive(Clone, Debug, Default)]
pub struct HalfTurns {
    /// Stretches at which the number changes, and the number from there on.
    changes: Vec<(usize, i32)>,
    /// Angle at the end of the last segment where that is not in the right half-plane throughout; `None` elsewhere, and
    /// the number is that of the last change \[rad\].
    end: Option<f64>,
}

impl HalfTurns {
    /// Number at the beginning of segment `number`.
    pub fn at(&self, number: usize) -> i32 {
        let known = self.changes.partition_point(|(from, _)| *from <= number);
        known.checked_sub(1).map_or(0, |last| self.changes[last].1)
    }

    /// Follows the step that becomes segment `number`.
    pub(super) fn follow(&mut self, number: usize, step: &StepHeading<'_>) {
        let before = if number == 0 { Some(step.body.start[5]) } else { self.end };
        if before.is_none() && step.begins.x > step.length() {
            return;
        }
        let first = angle_of(step.begins);
        let mut turns = self.at(number);
        if let Some(before) = before {
            // Less than 2³¹ half turns by far.
            #[expect(clippy::cast_possible_truncation, reason = "a rounded number")]
            let counted = ((before - first) / PI).round() as i32;
            if counted != turns {
                turns = counted;
                self.changes.push((number, turns));
            }
        }
        let level = step.begins.x > step.length();
        self.end = (!level).then(|| step.angle(turns, step.until));
    }

    /// Memory \[bytes\].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.changes)
    }

    /// Releases reserved memory.
    pub(super) fn shrink(&mut self) {
        self.changes.shrink_to_fit();
    }
}

/// Heading of a body over a stored step: the horizontal part of its axis, along and across the axis as placed \[–\].
#[derive(Clone, Copy, Debug)]
pub struct StepHeading<'a> {
    body: &'a Body,
    piece: &'a StepPolynomial,
    from: f64,
    until: f64,
    /// At the beginning.
    begins: DVec2,
    /// Bound of the angular velocity \[rad/s\].
    spin: f64,
}

impl<'a> StepHeading<'a> {
    /// Of a step from `from` to `until` \[s\]; `None` for a body whose state has its angle.
    pub fn of(body: &'a Body, piece: &'a StepPolynomial, [from, until]: [f64; 2]) -> Option<Self> {
        let begins = heading(body, piece, from)?;
        let spin = body.bounds(&|range| piece.derivative_bounds(range)).spin;
        Some(Self { body, piece, from, until, begins, spin })
    }

    /// Angle at `t` of a step that begins with so many half turns \[rad\].
    pub fn angle(&self, turns: i32, t: f64) -> f64 {
        let t = t.clamp(self.from, self.until);
        let swept = self.swept([self.from, self.until], [self.begins, self.heading(self.until)], t);
        let here = angle_of(self.heading(t));
        match ((angle_of(self.begins) + swept - here) / PI).round() + f64::from(turns) {
            0.0 => here,
            half_turns => here + half_turns * PI,
        }
    }

    /// Bound of the way of the axis' end over the step \[–\].
    fn length(&self) -> f64 {
        self.spin * (self.until - self.from)
    }

    fn heading(&self, t: f64) -> DVec2 {
        heading(self.body, self.piece, t).unwrap_or(DVec2::X)
    }

    /// Angle that the heading sweeps from the beginning of an interval to `t` in it \[rad\]; the interval is halved
    /// until the sweep is determined, independently of `t`.
    fn swept(&self, [from, until]: [f64; 2], [begins, ends]: [DVec2; 2], t: f64) -> f64 {
        let way = self.spin * (until - from);
        // A way no longer than this stays in an ellipse about both ends that leaves the vertical out.
        if way < begins.length() + ends.length() {
            return begins.perp_dot(self.heading(t)).atan2(begins.dot(self.heading(t)));
        }
        if way < VERTICAL || begins.length().max(ends.length()) < VERTICAL {
            let here = self.heading(t);
            let along_line = here * begins.dot(here).signum();
            return begins.perp_dot(along_line).atan2(begins.dot(along_line));
        }
        let middle = f64::midpoint(from, until);
        let half_way = self.heading(middle);
        if t <= middle {
            return self.swept([from, middle], [begins, half_way], t);
        }
        let before = self.swept([from, middle], [begins, half_way], middle);
        before + self.swept([middle, until], [half_way, ends], t)
    }
}

fn heading(body: &Body, piece: &StepPolynomial, t: f64) -> Option<DVec2> {
    body.with_state(|state| body.restore(piece.read(t, state), state), |state| body.heading(state))
}

/// Angle of a heading \[rad\], by the system's library as every elementary function of the solver.
fn angle_of(heading: DVec2) -> f64 {
    heading.y.atan2(heading.x)
}
