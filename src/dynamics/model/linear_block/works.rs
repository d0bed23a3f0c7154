//! Work of the ground and of pushes on a block, and losses in it, over a stretch of a flight.

use super::block::LinearBlock;
use crate::dynamics::linear::{FlightParameters, LineOrSine, PowerForm};
use crate::motion::Ground;

impl LinearBlock {
    /// Work of the ground's inertia forces and of pushes, losses in bearings and in the bodies themselves \[J\]; of all members, over a
    /// stretch within one piece of the ground's motion.
    pub(super) fn works_of_all(&self, flight: FlightParameters<'_>, span: [f64; 2]) -> [f64; 4] {
        let parts = span.map(|t| self.motion.at(flight, t));
        let push = |member: usize| -> f64 {
            let own = &self.members[member];
            let ends = [0, 1].map(|i| {
                let mut state = vec![0.0; 2 * own.start.len()];
                self.write(member, &parts[i], &mut state);
                state
            });
            own.push.iter().zip(ends[0].iter().zip(&ends[1])).map(|(force, (a, b))| force * (b - a)).sum()
        };
        let pushed = (0..self.members.len()).map(push).sum();
        let lost =
            |form: &Option<_>| form.as_ref().map_or(0.0, |form: &PowerForm| form.work(&self.motion, flight, span));
        let [bearings, own] = [&self.losses[0], &self.losses[1]].map(lost);
        [self.ground_work(flight, span), pushed, bearings, own]
    }

    fn ground_work(&self, flight: FlightParameters<'_>, [from, until]: [f64; 2]) -> f64 {
        (0..2).map(|axis| self.ground_work_along(axis, flight, [from, until])).sum()
    }

    fn ground_work_along(&self, axis: usize, flight: FlightParameters<'_>, [from, until]: [f64; 2]) -> f64 {
        let mut row = vec![0.0; self.motion.spectrum.size];
        let mut work = 0.0;
        for member in &self.members {
            let Some(&(at, _, root)) = member.coordinates.iter().find(|(_, i, _)| *i == axis) else { continue };
            if let Some(drift) = self.motion.spectrum.drifts.iter().position(|&i| i == at) {
                let [a, b] = [from, until].map(|t| self.motion.at(flight, t).drifts[drift]);
                // A coordinate without stiffness and damping: the gain of kinetic energy less the work of the push.
                work += 0.5 * (b[1] * b[1] - a[1] * a[1]) - member.push[axis] / root * (b[0] - a[0]);
            } else {
                row[at] = -root;
            }
        }
        if row.iter().any(|x| *x != 0.0) {
            work += self.motion.moved_by(flight, &row, [from, until], &self.line(axis, from));
        }
        work
    }

    /// The ground's acceleration along an axis from `t` on, within a piece.
    fn line(&self, axis: usize, t: f64) -> LineOrSine {
        match &self.ground {
            Ground::Still => LineOrSine::Line(0.0, 0.0),
            Ground::Sine { amplitude, omega, phase, .. } => {
                LineOrSine::Sine(amplitude[axis], *omega, omega * t + phase)
            }
            Ground::Record { .. } => {
                let piece = self.ground.piece(self.ground.piece_number(t));
                LineOrSine::Line(piece.acceleration(t)[axis], piece.rate()[axis])
            }
        }
    }
}
