//! Bounds on the motion of a member's sections in a flight, for the search of touches, (F7).

use super::block::LinearBlock;
use super::part::RIGID;
use super::reach::Reach;
use crate::dynamics::linear::ModalCoordinates;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::section_bounds::SectionBounds;

impl LinearBlock {
    /// Bounds on any section of a member from `t`, whose parts these are, on for at most `horizon` \[s\].
    pub(super) fn member_bounds(&self, member: usize, parts: &ModalCoordinates, horizon: f64) -> MotionBounds {
        let window = self.motion.window(horizon);
        let sections = self.members[member].sections.iter();
        let all: Vec<MotionBounds> =
            sections.map(|reaches| self.section_bounds(member, reaches, parts, window)).collect();
        let most = |of: fn(&MotionBounds) -> f64| all.iter().map(of).fold(0.0, f64::max);
        MotionBounds {
            window,
            reach: most(|b| b.reach),
            turn: most(|b| b.turn),
            speed: most(|b| b.speed),
            spin: most(|b| b.spin),
            acceleration: most(|b| b.acceleration),
            spin_rate: most(|b| b.spin_rate),
        }
    }

    fn section_bounds(&self, member: usize, reaches: &[Reach], parts: &ModalCoordinates, window: f64) -> MotionBounds {
        let own = &self.members[member];
        let mut sum = SectionBounds::default();
        let (mut reach, mut turn, mut apart) = (0.0, 0.0, 0.0);
        for (k, r) in reaches.iter().enumerate() {
            let [c, rate, gain] = self.motion.largest(parts, k, window);
            reach += r.place * c;
            turn += r.turn * c;
            apart += (r.moved + own.lever * r.turned) * c;
            sum.speed += r.place * rate;
            sum.acceleration += r.place * gain;
            sum.spin += r.base[1] * rate;
            sum.spin_rate += r.base[1] * gain;
            sum.turned[0] += r.turned * rate;
            sum.turned[1] += r.turned * gain;
            sum.moved[0] += r.moved * rate;
        }
        sum.acceleration += self.motion.unsteady_peak();
        for (i, drift) in self.motion.spectrum.drifts.iter().enumerate() {
            let Some(&(_, coordinate, root)) = own.coordinates.iter().find(|(at, ..)| at == drift) else { continue };
            let [place, speed, gain] = self.motion.drift_bounds(parts, i, window).map(|b| b / root);
            if coordinate == 2 {
                turn += place;
                sum.spin += speed;
                sum.spin_rate += gain;
            } else {
                reach += place;
                sum.speed += speed;
                sum.acceleration += gain;
            }
        }
        for (i, start) in own.start.iter().take(RIGID).enumerate().filter(|(i, _)| !own.moves(*i)) {
            *(if i == 2 { &mut turn } else { &mut reach }) += start.abs();
        }
        // Place and (u, v) are summed as one: what `of_frame` adds of the latter is theirs already.
        let speeds = sum.moved[0];
        sum.moved = [0.0; 2];
        let mut frame = sum.of_frame(own.lever, apart, window);
        frame.acceleration += 2.0 * sum.spin * speeds;
        MotionBounds { reach: reach + apart, turn, ..frame }
    }
}
