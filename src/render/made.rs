//! Counts of resources made on a device and of passes drawn with them: the evidence that what is not seen costs nothing.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Something that costs memory, a call or time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Thing {
    /// A pipeline, compiled on its first use.
    Pipeline,
    /// A buffer: meshes, instances, uniforms, what is read back.
    Buffer,
    /// A texture: targets, shadow map, font atlas.
    Texture,
    /// A render pass that was recorded.
    Pass,
    /// Instances that were drawn.
    Drawn,
    /// Instances that the view does not reach: neither uploaded nor drawn.
    Culled,
}

/// How often each thing was made or done, by its label.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Made(BTreeMap<(Thing, &'static str), u64>);

impl Made {
    /// How many of a kind with this label.
    pub fn count(&self, thing: Thing, label: &'static str) -> u64 {
        self.0.get(&(thing, label)).copied().unwrap_or(0)
    }

    /// How many of a kind.
    pub fn total(&self, thing: Thing) -> u64 {
        self.0.iter().filter(|((kind, _), _)| *kind == thing).map(|(_, count)| count).sum()
    }

    /// Labels of a kind, in order.
    pub fn labels(&self, thing: Thing) -> Vec<&'static str> {
        self.0.keys().filter(|(kind, _)| *kind == thing).map(|(_, label)| *label).collect()
    }

    /// Counts since an earlier reading of the same device.
    #[must_use]
    pub fn since(&self, earlier: &Self) -> Self {
        let more = self.0.iter().map(|(key, count)| (*key, count - earlier.0.get(key).copied().unwrap_or(0)));
        Self(more.filter(|(_, count)| *count > 0).collect())
    }
}

/// The count that all copies of a device share.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally(Arc<Mutex<Made>>);

impl Tally {
    /// Counts some more.
    pub(super) fn add(&self, thing: Thing, label: &'static str, count: usize) {
        if count > 0 {
            let mut made = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            *made.0.entry((thing, label)).or_insert(0) += count as u64;
        }
    }

    /// The count so far.
    pub(super) fn so_far(&self) -> Made {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}
