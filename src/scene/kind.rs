//! Planar or spatial.

use super::keys::words;

words! {
    /// Directions in which the bodies of a scene may move.
    Kind, by default Planar {
        /// x, y and the rotation about the vertical; bearings linear at every rotation (the paper's experiments).
        Planar = "planar",
        /// Six degrees of freedom, gravity, bearings at their true attachment points.
        Spatial = "spatial",
    }
}
