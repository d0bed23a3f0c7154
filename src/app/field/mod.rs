//! One value in a panel: its label, its unit, what is allowed, what it is by itself, its complaint, the hand on it.
//!
//! Range, default and name of a field come from [`keys`](crate::scene::keys), as the checks of a scene do; [`rows`] and [`sliders`] show
//! every key of a table. Every field tells them to the mouse and to a screen reader; one that differs from its default has a small sign
//! beside it that resets it, and so do its context menu and an emptied field.

mod choice;
mod entry;
mod form;
mod frame;
mod narrowed;
mod number;
pub(in crate::app) mod parse;
mod place;
mod slider;
mod table;

pub(in crate::app) use choice::{choice, choice_line};
pub(in crate::app) use form::Form;
pub(in crate::app) use frame::{act, complain, mark, named, tag};
pub(in crate::app) use narrowed::narrowed;
pub(in crate::app) use number::{focus_next, number, optional, switched};
pub(in crate::app) use place::{CLICK, Change, Named, Place};
pub(in crate::app) use slider::slider_row;
pub(in crate::app) use table::{Look, Without, number_at, optional_at, rows, slider_at, slider_between, sliders};
