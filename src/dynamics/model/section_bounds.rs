//! Bounds on the frame of an end section, from those of the mean axes and of the section against them.

use crate::dynamics::model::motion_bounds::MotionBounds;

/// Bounds on the motion of the mean axes and of a section against them, and what they say of the section's frame.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::dynamics) struct SectionBounds {
    pub speed: f64,
    pub acceleration: f64,
    pub spin: f64,
    pub spin_rate: f64,
    /// |(u̇, v̇)| and |(ü, v̈)|.
    pub moved: [f64; 2],
    /// |φ̇| and |φ̈|.
    pub turned: [f64; 2],
}

impl SectionBounds {
    /// Of the frame's origin, `G + a` with `a = R(θ)(s + u) − R(θ + φ) s`, where |a| is at most `apart`:
    /// `ä = θ̈ ẑ × a + θ̇ ẑ × (ȧ + R u̇) + R ü − φ̈ ẑ × R′ s + φ̇ (θ̇ + φ̇) R′ s`.
    pub(in crate::dynamics) fn of_frame(&self, lever: f64, apart: f64, window: f64) -> MotionBounds {
        let ([u, uu], [p, pp]) = (self.moved, self.turned);
        let against = u + lever * p;
        let carried = self.spin * apart + against;
        MotionBounds {
            speed: self.speed + carried,
            spin: self.spin + p,
            acceleration: self.acceleration
                + self.spin_rate * apart
                + self.spin * (carried + u)
                + uu
                + lever * (pp + p * (self.spin + p)),
            spin_rate: self.spin_rate + pp,
            ..MotionBounds::still(window)
        }
    }

    /// [`of_frame`](Self::of_frame) in space, with `ω_E = J φ̇` of the section for φ̇ and R E for R′: |J| ≤ 1, and the part of its change,
    /// `J̇ φ̇`, is at most φ̇² up to φ = 1.
    pub(in crate::dynamics) fn of_frame_in_space(&self, lever: f64, apart: f64, window: f64) -> MotionBounds {
        let (plane, p) = (self.of_frame(lever, apart, window), self.turned[0]);
        MotionBounds {
            acceleration: plane.acceleration + lever * p * p,
            spin_rate: plane.spin_rate + p * (self.spin + p),
            ..plane
        }
    }
}
