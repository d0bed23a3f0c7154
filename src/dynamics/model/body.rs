//! A girder as constant data: mass, inertia, bearings over `(x, y, θ)`, degrees of freedom and initial state.

use glam::{DMat3, DVec3};

use crate::contact::Frame;
use crate::dynamics::model::bearing::{Bearing, BearingQuantities, PlanarBearings, Standing};
use crate::dynamics::model::rate_bounds::RateBounds;
use crate::geometry::Prism;

/// A girder, compiled.
#[derive(Clone, Debug)]
pub struct Body {
    /// The girder's name.
    pub name: String,
    /// Its shape.
    pub prism: Prism,
    /// Where G is placed \[m\].
    pub home: DVec3,
    /// Girder axes as placed, in the columns, in the world.
    pub axes: DMat3,
    /// `m` \[kg\].
    pub mass: f64,
    /// `i²`, squared radius of gyration about the vertical \[m²\].
    pub gyration2: f64,
    /// Inertia about G in the body frame \[kg·m²\], and its inverse.
    pub inertia: [DMat3; 2],
    /// Largest distance of a corner from G \[m\].
    pub radius: f64,
    /// How fast it can answer.
    pub rate_bounds: RateBounds,
    /// What it stands on.
    pub bearings: Vec<Bearing>,
    /// Its weight on them; nothing in a planar scene.
    pub standing: Standing,
    /// The bearings over `(x, y, θ)`.
    pub planar: PlanarBearings,
    /// World directions it may move in: x, y, z, roll, pitch, yaw.
    pub free: [bool; 6],
    /// Constant force at G \[N\].
    pub push: DVec3,
    /// Constant moment about the vertical \[N·m\].
    pub moment: f64,
    /// For the world's x and y: whether nothing but a touch can drive it off that axis once it moves along it.
    pub straight: [bool; 2],
    /// Displacement and rotation at the start: x, y, z \[m\], θ \[rad\].
    pub start: [f64; 4],
    /// Velocity and spin at the start: x, y, z \[m/s\], ω \[rad/s\].
    pub start_rate: [f64; 4],
}

impl Body {
    /// (3), (4) of the girder in its own axes.
    pub fn quantities(&self) -> BearingQuantities {
        BearingQuantities::of(&self.bearings, self.mass, self.gyration2)
    }

    /// Pose and twist of a planar state `(x, y, θ, ẋ, ẏ, θ̇)`.
    #[inline]
    pub fn planar_frame(&self, state: &[f64]) -> Frame {
        // Most girders of a row never turn. Of half the angle, for the cosine less 1 without loss.
        let turned = if state[2] == 0.0 {
            DMat3::ZERO
        } else {
            let (s, c) = (0.5 * state[2]).sin_cos();
            let (sine, less) = (2.0 * s * c, -2.0 * s * s);
            DMat3::from_cols(DVec3::new(less, sine, 0.0), DVec3::new(-sine, less, 0.0), DVec3::ZERO)
        };
        Frame {
            home: self.home,
            shift: DVec3::new(state[0], state[1], self.start[2]),
            turned,
            velocity: DVec3::new(state[3], state[4], 0.0),
            spin: DVec3::new(0.0, 0.0, state[5]),
            level: true,
        }
    }
}
