//! An answer of the impact model in the terms of any answer: events, touches, forces of lasting contact, losses.

pub(super) mod events;
pub(super) mod forces;
pub(super) mod touches;
