//! Ground motions that single supports have in place of `[motion]`, as written in a scene.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

use super::keys::{Fallback, Key, MOTION, Range};
use super::motion::{Motion, MotionVisitor};

/// `[[ground]]`: a motion with a name, which abutments and piers have where they give that name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedGround {
    /// Name by which supports refer to it.
    pub name: String,
    /// Motion.
    #[serde(flatten)]
    pub motion: Motion,
}

/// A motion of the ground in a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum GroundId {
    /// That of `[motion]`.
    #[default]
    Reference,
    /// The `[[ground]]` of this number.
    Named(usize),
}

/// `[[ground]]`, whatever its kind; of each kind the keys of `[motion]`.
pub const GROUND: &[Key] = &[
    Key::new("name", Range::Like("unique"), Fallback::Needed("must be given"), "what abutments and piers call it"),
    Key::new("kind", MOTION[0].range, Fallback::Needed("must be given"), MOTION[0].meaning),
];

/// The keys of a motion and, among them, the name.
impl<'de> Deserialize<'de> for NamedGround {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut name = None;
        let motion = deserializer.deserialize_map(MotionVisitor { name: Some(&mut name) })?;
        Ok(Self { name: name.ok_or_else(|| D::Error::missing_field("name"))?, motion })
    }
}
