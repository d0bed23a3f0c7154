//! What is there before anything has been placed.

use crate::scene::{Girder, Scene};

/// A scene with nothing in it.
pub(in crate::app) fn empty() -> Scene {
    Scene::empty(crate::app::text::UNTITLED, 5.0)
}

/// The paper's straight girder, where nothing is placed that could be copied.
pub(super) fn first_girder() -> Girder {
    Girder::straight("girder", [0.190, 0.070, 0.020], 2.0)
}
