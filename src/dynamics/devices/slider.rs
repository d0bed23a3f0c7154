//! A slider in space, flat or in a spherical dish, under the vertical force N of its own bearing
//! (`docs/physics.md#sliders-in-space`). Its link has the ground as its second end and the girder's axes as placed; the vertical
//! spring `k_z`, dashpot and preload P are the girder's bearing, as are horizontal springs and dashpots beside, which lift with it.
//!
//! In a dish of radius R the point rises by `h = u²/2R`: spring and dashpot see `w − h`. With `N = P − k_z (w − h)` and
//! `D = −c_z (ẇ − ḣ)` the vertical force is `N + D`, the horizontal one `−((N + D)/R) u − z`. Friction, of N without D:
//! elastic `ż = k_t u̇`, `k_t` = `μP/u_y` constant, up to `Q = μN`; sliding, `z = Q (cos φ, sin φ)` with
//! `φ̇ = (k_t/Q)(−sin φ u̇_x + cos φ u̇_y)` until `k_t n·u̇ − Q̇` turns. Where N falls to 0 the bearing is lifted: no force at all until
//! it lands.

use glam::{DVec2, DVec3};

use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Evolution, Phase, Separation, SeparationBounds, Switch, SwitchUnit,
};
use crate::language::Text;

/// Least friction limit in the rate `k_t/Q` at which the direction of friction turns, per limit at rest μP \[–\]: the rate has no bound
/// at N = 0. Chosen.
const LEAST_LOAD: f64 = 1e-2;

/// A slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// μ \[–\].
    pub friction: f64,
    /// 1/R; 0 of a flat slider \[1/m\].
    pub curvature: f64,
    /// `u_y` under the load at rest \[m\].
    pub displacement: f64,
    /// P \[N\].
    pub load: f64,
    /// `k_z`, more than 0 \[N/m\].
    pub stiffness: f64,
    /// `c_z` \[N·s/m\].
    pub damping: f64,
    /// Horizontal springs and dashpots of the girder's bearing beside it \[N/m, N·s/m\].
    pub beside: [DVec2; 2],
}

const ELASTIC: u32 = 0;
const SLIDING: u32 = 1;
const LIFTED: u32 = 2;

impl Slider {
    /// `k_t` \[N/m\].
    fn tangential(&self) -> f64 {
        self.friction * self.load / self.displacement
    }

    /// h \[m\].
    fn rise(&self, motion: &Separation) -> f64 {
        0.5 * self.curvature * motion.moved.truncate().length_squared()
    }

    /// N without uplift; negative where it would pull \[N\].
    fn normal(&self, motion: &Separation) -> f64 {
        self.load - self.stiffness * (motion.moved.z - self.rise(motion))
    }

    /// Energy of the horizontal springs beside \[J\].
    fn energy_beside(&self, motion: &Separation) -> f64 {
        let moved = motion.moved.truncate();
        0.5 * moved.dot(self.beside[0] * moved)
    }

    /// ḣ \[m/s\].
    fn rising(&self, motion: &Separation) -> f64 {
        self.curvature * motion.moved.truncate().dot(motion.rate.truncate())
    }

    /// Rate of N \[N/s\].
    fn normal_rate(&self, motion: &Separation) -> f64 {
        -self.stiffness * (motion.rate.z - self.rising(motion))
    }

    /// D \[N\].
    fn damping_force(&self, motion: &Separation) -> f64 {
        -self.damping * (motion.rate.z - self.rising(motion))
    }

    /// Horizontal force of a bearing that carries \[N\].
    fn horizontal(&self, phase: &Phase, motion: &Separation) -> DVec2 {
        let pressing = self.normal(motion) + self.damping_force(motion);
        -motion.moved.truncate() * (self.curvature * pressing) - self.friction_force(phase, motion)
    }

    /// Q \[N\].
    fn limit(&self, motion: &Separation) -> f64 {
        self.friction * self.normal(motion).max(0.0)
    }

    /// z \[N\]. Elastic, the memory is `z − k_t u`; sliding, the angle φ \[rad\].
    fn friction_force(&self, phase: &Phase, motion: &Separation) -> DVec2 {
        match phase.branch {
            ELASTIC => DVec2::new(phase.memory[0], phase.memory[1]) + motion.moved.truncate() * self.tangential(),
            SLIDING => DVec2::from_angle(phase.memory[0]) * self.limit(motion),
            _ => DVec2::ZERO,
        }
    }

    /// `n·u̇ − Q̇/k_t`: positive while it slides \[m/s\].
    fn slip_rate(&self, phase: &Phase, motion: &Separation) -> f64 {
        let growing = self.friction * self.normal_rate(motion) / self.tangential();
        DVec2::from_angle(phase.memory[0]).dot(motion.rate.truncate()) - growing
    }

    fn elastic(&self, z: DVec2, motion: &Separation) -> Phase {
        let remembered = z - motion.moved.truncate() * self.tangential();
        Phase { branch: ELASTIC, memory: [remembered.x, remembered.y, 0.0] }
    }

    /// On landing there is no friction yet: it slides at once unless Q grows faster than the spring.
    fn landed(&self, motion: &Separation) -> Phase {
        let slides = Phase { branch: SLIDING, memory: [motion.rate.truncate().to_angle(), 0.0, 0.0] };
        if self.slip_rate(&slides, motion) > 0.0 { slides } else { self.elastic(DVec2::ZERO, motion) }
    }
}

impl Connection for Slider {
    type State = Phase;
    type Motion = Separation;

    /// Lifted, it takes away what the girder's bearing has.
    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        if phase.branch == LIFTED {
            let [w, rate] = [motion.moved.z, motion.rate.z];
            let [springs, dashpots] = self.beside;
            let across = springs * motion.moved.truncate() + dashpots * motion.rate.truncate();
            return across.extend(self.stiffness * w + self.damping * rate - self.load);
        }
        let upwards = self.stiffness * self.rise(motion) + self.damping * self.rising(motion);
        self.horizontal(phase, motion).extend(upwards)
    }

    /// Beside the girder's bearing `k_z w²/2 − P w`: `h (P − k_z w + k_z h/2) + z²/(2 k_t)`; lifted, what leaves nothing of it
    /// but the energy of the unloaded spring.
    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        let upright = self.load - self.stiffness * motion.moved.z;
        if phase.branch == LIFTED {
            return -upright * upright / (2.0 * self.stiffness) - self.energy_beside(motion);
        }
        let rise = self.rise(motion);
        let friction = self.friction_force(phase, motion).length_squared() / (2.0 * self.tangential());
        rise * (upright + 0.5 * self.stiffness * rise) + friction
    }

    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        if phase.branch == LIFTED {
            let rate = motion.rate;
            return -rate.dot(self.beside[1].extend(self.damping) * rate);
        }
        let sliding = if phase.branch == SLIDING { self.limit(motion) * self.slip_rate(phase, motion) } else { 0.0 };
        // c_z (ẇ − ḣ)² less the c_z ẇ² of the girder's bearing.
        let rising = self.rising(motion);
        sliding + self.damping * rising * (rising - 2.0 * motion.rate.z)
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        (self.tangential() + self.curvature * self.load).max(self.stiffness).max(self.beside[0].max_element())
    }

    fn damping_bound(&self, phase: &Phase) -> f64 {
        if phase.branch == LIFTED {
            self.damping.max(self.beside[1].max_element())
        } else if self.curvature > 0.0 {
            self.damping
        } else {
            0.0
        }
    }
}

impl Device for Slider {
    /// Without friction as placed under its preload, and displaced from there in a straight line.
    fn initial(&self, motion: &Separation) -> Phase {
        if self.normal(motion) > 0.0 {
            let spring = motion.moved.truncate() * self.tangential();
            self.elastic(spring.clamp_length_max(self.limit(motion)), motion)
        } else {
            Phase { branch: LIFTED, ..Phase::default() }
        }
    }

    fn activity(&self, _: &Phase) -> Activity {
        Activity::Acts
    }

    fn gap(&self, _: &Phase, motion: &Separation) -> [f64; 2] {
        [-motion.moved.length(), -motion.rate.length()]
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }

    fn evolves(&self, phase: &Phase) -> bool {
        phase.branch == SLIDING
    }

    fn evolution(&self, phase: &Phase, motion: &Separation) -> Evolution {
        let (outwards, rate) = (DVec2::from_angle(phase.memory[0]), motion.rate.truncate());
        let (along, limit) = (outwards.perp(), self.limit(motion));
        let turning = self.tangential() / limit.max(LEAST_LOAD * self.friction * self.load);
        Evolution {
            rate: turning * along.dot(rate),
            decay: (-turning * outwards.dot(rate)).min(0.0),
            force: (along * -limit).extend(0.0),
            drive: (along * turning).extend(0.0),
        }
    }

    fn switches(&self, _: &Phase) -> usize {
        2
    }

    fn switch_unit(&self, number: usize, phase: &Phase) -> SwitchUnit {
        if number == 0 && phase.branch == SLIDING { SwitchUnit::Speed } else { SwitchUnit::Length }
    }

    /// 0: start of sliding (elastic), end of sliding (sliding), landing (lifted); 1: uplift.
    fn switch(&self, number: usize, phase: &Phase, motion: &Separation) -> f64 {
        let normal = self.normal(motion);
        match (number, phase.branch) {
            (0, ELASTIC) => (self.friction_force(phase, motion).length() - self.friction * normal) / self.tangential(),
            (0, SLIDING) => -self.slip_rate(phase, motion),
            (0, _) => normal / self.stiffness,
            (_, LIFTED) => -1.0,
            _ => -normal / self.stiffness,
        }
    }

    fn next(&self, event: Switch, phase: &Phase, motion: &Separation) -> (Phase, f64) {
        let z = self.friction_force(phase, motion);
        let next = match (event, phase.branch) {
            (Switch::Closing, _) => *phase,
            (Switch::Function(0), ELASTIC) => Phase { branch: SLIDING, memory: [z.to_angle(), 0.0, 0.0] },
            (Switch::Function(0), SLIDING) => self.elastic(z, motion),
            (Switch::Function(_), LIFTED) => self.landed(motion),
            (Switch::Function(_), _) => Phase { branch: LIFTED, ..Phase::default() },
        };
        // Springs beside lift with what they store, and land displaced.
        let released = match (phase.branch, next.branch) {
            (LIFTED, LIFTED) => 0.0,
            (_, LIFTED) => z.length_squared() / (2.0 * self.tangential()) + self.energy_beside(motion),
            (LIFTED, _) => -self.energy_beside(motion),
            _ => 0.0,
        };
        (next, released)
    }
}

impl DeviceReadings for Slider {
    fn state(&self, phase: &Phase) -> Text {
        match phase.branch {
            ELASTIC => Text::new("state-elastic"),
            SLIDING => Text::new("state-slides"),
            _ => Text::new("state-lifted"),
        }
    }

    fn distance_left(&self, _: &Phase, _: &Separation) -> f64 {
        f64::NAN
    }

    /// Of the bearing beside as well: N + D, and nothing where it is lifted.
    fn reaction(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        if phase.branch == LIFTED {
            return DVec3::ZERO;
        }
        self.horizontal(phase, motion).extend(self.normal(motion) + self.damping_force(motion))
    }

    /// μP, under the load at rest.
    fn strength(&self) -> Option<f64> {
        Some(self.friction * self.load)
    }

    fn lifts(&self) -> bool {
        true
    }

    /// No line: the bearing itself is drawn.
    fn centre_line(&self, _: &Phase, _: [DVec3; 2]) -> Vec<DVec3> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLIDER: Slider = Slider {
        friction: 0.1,
        curvature: 0.5,
        displacement: 1e-3,
        load: 50.0,
        stiffness: 4e3,
        damping: 3.0,
        beside: [DVec2::new(20.0, 30.0), DVec2::new(0.4, 0.7)],
    };

    fn at(moved: [f64; 3], rate: [f64; 3]) -> Separation {
        Separation { moved: moved.into(), rate: rate.into(), ..Separation::default() }
    }

    #[test]
    fn work_is_stored_or_lost_in_every_phase() {
        let (place, rate) = (DVec3::new(0.03, -0.02, 0.004), DVec3::new(0.2, 0.1, -0.05));
        for law in [ELASTIC, SLIDING, LIFTED] {
            let begin = Phase { branch: law, memory: [0.4, 0.2, 0.0] };
            let step = 1e-6;
            let phase_at = |t: f64| {
                let mut phase = begin;
                if law == SLIDING {
                    let motion = at(place.to_array(), rate.to_array());
                    phase.memory[0] += SLIDER.evolution(&begin, &motion).rate * t;
                }
                phase
            };
            let stored =
                |t: f64| SLIDER.stored_energy(&phase_at(t), &at((place + rate * t).to_array(), rate.to_array()));
            let gained = (stored(step) - stored(-step)) / (2.0 * step);
            let here = at(place.to_array(), rate.to_array());
            let lost = SLIDER.dissipated_power(&begin, &here);
            let work = -SLIDER.force(&begin, &here).dot(rate);
            assert!((gained + lost - work).abs() < 1e-7 * work.abs().max(1.0), "{law}: {gained} + {lost} for {work}");
        }
    }

    #[test]
    fn uplift_takes_the_whole_vertical_force_and_keeps_the_energy() {
        let lifts = 50.0 / 4e3;
        let here = at([0.0, 0.0, lifts], [0.3, 0.0, 0.1]);
        let (lifted, released) = SLIDER.next(Switch::Function(1), &Phase { branch: SLIDING, memory: [0.0; 3] }, &here);
        assert_eq!((lifted.branch, released), (LIFTED, 0.0));
        assert!(SLIDER.stored_energy(&lifted, &here).abs() < 1e-12, "continuous where N is 0");
        let above = at([0.0, 0.0, 2.0 * lifts], [0.3, 0.0, 0.1]);
        let bearing = 50.0 - 4e3 * 2.0 * lifts - 3.0 * 0.1;
        assert!((SLIDER.force(&lifted, &above).z + bearing).abs() < 1e-12, "nothing is left of the bearing's force");
        let down = at([0.0, 0.0, lifts], [0.3, 0.0, -0.1]);
        assert_eq!(SLIDER.next(Switch::Function(0), &lifted, &down).0.branch, SLIDING, "too fast for the spring");
        let down = at([0.0, 0.0, lifts], [1e-4, 0.0, -0.1]);
        assert_eq!(SLIDER.next(Switch::Function(0), &lifted, &down).0.branch, ELASTIC, "Q grows faster");
    }
}
