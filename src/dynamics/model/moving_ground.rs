//! Ground that does not move as one: how supports move against the ground of reference, and bodies that move as they are given
//! (`docs/physics.md#supports-that-move`).

use std::sync::Arc;

use glam::DVec3;

use crate::dynamics::model::body::{Body, BodyCoordinates};
use crate::dynamics::model::coordinates::given_motion::GivenMotion;
use crate::dynamics::model::ground::compiled;
use crate::geometry::Prism;
use crate::motion::Ground;
use crate::motion::support::{GroundPath, RelativeMotion, SupportMotion};
use crate::scene::{Kind, MovingSupports, Scene};

/// Ground that moves otherwise, as a body of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foundation {
    /// Its number among the bodies.
    pub body: usize,
    /// Motion.
    pub motion: SupportMotion,
}

/// Motions of the ground under the supports of a scene, and the paths of its grounds.
#[derive(Clone, Debug)]
pub struct MovingGround {
    /// Ground, delay and factor by support.
    pub supports: MovingSupports,
    /// Path of the ground of reference, then of those with names.
    paths: Vec<Arc<GroundPath>>,
    kind: Kind,
}

impl MovingGround {
    /// Of a scene; `None` where its ground moves as one.
    pub(super) fn of(scene: &Scene, ground: &Ground) -> Option<Self> {
        let supports = scene.moving_supports()?;
        let named = scene.grounds.iter().map(|named| compiled(&named.motion));
        let paths = std::iter::once(ground.clone()).chain(named).map(|ground| Arc::new(GroundPath::of(ground)));
        Some(Self { supports, paths: paths.collect(), kind: scene.kind })
    }

    /// Displacement of the ground of a support that moves in this way against the ground of reference \[m\].
    pub fn displacement(&self, own: SupportMotion, t: f64) -> DVec3 {
        self.relative(own).at(t)[1]
    }

    /// The motion of a support that moves in this way against the ground of reference.
    pub fn relative(&self, own: SupportMotion) -> RelativeMotion {
        RelativeMotion::of(&self.paths, own)
    }

    /// A ground by its number: 0 that of reference, from 1 on those with names.
    pub fn ground(&self, number: usize) -> &Ground {
        self.paths[number].ground()
    }

    /// The motion of a support against the ground of reference, as degrees of freedom.
    pub(super) fn given(&self, own: SupportMotion) -> GivenMotion {
        let motion = self.relative(own);
        GivenMotion { motion, axes: if self.kind == Kind::Planar { 2 } else { 3 } }
    }

    /// A block of this size with a given motion, that of the ground under a support, without forces; its frame stands at `home` \[m\].
    pub(super) fn body(&self, name: String, prism: Prism, home: DVec3, own: SupportMotion) -> Body {
        Body::immovable(name, BodyCoordinates::Custom(Arc::new(self.given(own))), prism, home)
    }
}
