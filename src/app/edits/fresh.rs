//! Scene before anything has been placed.

use super::bridge::bridge;
use crate::app::command::BridgeDraft;
use crate::scene::{Girder, Scene};

/// A scene with nothing in it.
pub(in crate::app) fn empty() -> Scene {
    Scene::empty(crate::app::text::UNTITLED, 5.0)
}

/// A straight span of a bridge on its bearings, where nothing is placed that could be copied.
pub(super) fn first_girder() -> Girder {
    let draft = BridgeDraft { skew_deg: 90.0, spans: 1, ..BridgeDraft::default() };
    let span = bridge(draft).ok().and_then(|(scene, _)| scene.girders.into_iter().next());
    let new = span.unwrap_or_else(|| Girder::straight("", [draft.span, draft.width, 1.5], 6e5));
    Girder { name: "girder".to_owned(), ..new }
}
