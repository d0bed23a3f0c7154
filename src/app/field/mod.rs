//! One value in a panel: its label, its unit, what is allowed, what it is by itself, its complaint, the hand on it.
//!
//! What may stand in a field and its default come from [`keys`](crate::scene::keys), as the checks of a scene do. Every field says them to
//! the mouse and to a screen reader; one that is not as it would be by itself has a small sign beside it that takes it
//! back, and so do its context menu and an emptied field.

mod choice;
mod entry;
mod frame;
mod number;
pub(in crate::app) mod parse;
mod place;
mod slider;

pub(in crate::app) use choice::{choice, choice_line};
pub(in crate::app) use frame::{act, complain, mark, tag};
pub(in crate::app) use number::{laid_over, number, optional};
pub(in crate::app) use place::{CLICK, Change, Place};
pub(in crate::app) use slider::{slider, slider_of, slider_row};
