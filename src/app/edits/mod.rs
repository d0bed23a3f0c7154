//! The scene that is worked on: the document with its past, what is selected, and the edits that the window makes.

mod assuming;
mod bearings;
mod bridge;
mod change;
mod devices;
mod document;
mod fresh;
mod pairs;
mod piers;
mod placing;
mod reshape;
mod selection;
mod spans;

pub(in crate::app) use bearings::{four_below, of_deck, one_by_one};
pub(in crate::app) use bridge::{MOST_BRIDGE_SPANS, RANGES, assumed, bridge, sound};
pub(in crate::app) use change::*;
pub(in crate::app) use devices::{device, points_before};
pub(in crate::app) use document::Document;
pub(in crate::app) use fresh::empty;
pub(in crate::app) use pairs::{elastic, names_of, new_pair, optional, pair_between, pair_entry};
pub(in crate::app) use piers::pier;
pub(in crate::app) use placing::{MOST_SPANS, offered_row};
pub(in crate::app) use reshape::{girders_alike, reshaped, skew, stretched};
pub(in crate::app) use selection::Selection;
pub(in crate::app) use spans::add_girder;
