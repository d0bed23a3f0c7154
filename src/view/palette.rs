//! Every colour of a picture, one meaning each.
//!
//! The accents are Okabe and Ito's set: they stay apart for colour-blind eyes and in grey print. Meanings never rest
//! on colour alone: states have shapes, arrows have letters.

use super::MOST_KEPT;
use super::list::{Background, Rgba};
use crate::sim::ContactState;

/// The colours of one background.
#[derive(Clone, Copy, Debug)]
pub(super) struct Palette {
    /// Behind everything, at the top of the picture.
    pub(super) sky: Rgba,
    /// Behind everything, at the bottom.
    pub(super) floor: Rgba,
    /// Grid lines.
    pub(super) grid: Rgba,
    /// Shadow on the ground.
    pub(super) shadow: Rgba,
    /// Girders.
    pub(super) girder: Rgba,
    /// Abutments.
    pub(super) abutment: Rgba,
    /// Soil behind backwalls that move.
    pub(super) soil: Rgba,
    /// Bearings.
    pub(super) bearing: Rgba,
    /// Edges of bodies.
    pub(super) edge: Rgba,
    /// Dimension lines.
    pub(super) dimension: Rgba,
    /// Text.
    pub(super) ink: Rgba,
    /// Text that matters less.
    pub(super) faint_ink: Rgba,
    /// Behind text.
    pub(super) plate: Rgba,
    /// Around arrows and glyphs.
    pub(super) halo: Rgba,
    /// Resultant arrows.
    pub(super) resultant: Rgba,
    /// The other model's girders: dashed outlines.
    pub(super) ghost: Rgba,
    /// World axes x, y, z.
    pub(super) axes: [Rgba; 3],
}

/// Stick: a filled disk in this blue.
pub(super) const STICK: Rgba = Rgba::rgb(0x00, 0x72, 0xb2);
/// Slip: a ring in this vermilion.
pub(super) const SLIP: Rgba = Rgba::rgb(0xd5, 0x5e, 0x00);
/// Just opened: a cross in this grey.
pub(super) const OPENED: Rgba = Rgba::rgb(0x6b, 0x72, 0x78);
/// Normal force.
pub(super) const NORMAL: Rgba = Rgba::rgb(0x00, 0x9e, 0x73);
/// Tangential force.
pub(super) const TANGENTIAL: Rgba = Rgba::rgb(0xb8, 0x4f, 0x8d);
/// Dashpot force.
pub(super) const DAMPING: Rgba = Rgba::rgb(0xe6, 0x9f, 0x00);
/// Impulses of the impact model.
pub(super) const IMPULSE: Rgba = Rgba::rgb(0x8c, 0x2d, 0x6b);
/// Other runs, seen as ghosts, in the order in which they are given out: the first is far from the blue of the run shown.
pub const KEPT: [Rgba; MOST_KEPT] = [
    Rgba::rgb(0xcc, 0x79, 0xa7),
    Rgba::rgb(0xe6, 0x9f, 0x00),
    Rgba::rgb(0x00, 0x9e, 0x73),
    Rgba::rgb(0x56, 0xb4, 0xe9),
];
/// An overlap that no contact carries.
pub(super) const OVERLAP: Rgba = Rgba::rgb(0xc4, 0x1e, 0x3a);
/// Colour of a selection.
pub(super) const SELECTED: Rgba = Rgba::rgb(0xf0, 0xa2, 0x02);

const LIGHT: Palette = Palette {
    sky: Rgba::rgb(0xf7, 0xf8, 0xf9),
    floor: Rgba::rgb(0xe6, 0xe9, 0xec),
    grid: Rgba::new(0x5b, 0x6b, 0x7a, 0x50),
    shadow: Rgba::new(0x20, 0x2c, 0x38, 0x4c),
    girder: Rgba::rgb(0xd9, 0xd5, 0xcc),
    abutment: Rgba::rgb(0xb3, 0xb8, 0xbd),
    soil: Rgba::rgb(0xc8, 0xb0, 0x8c),
    bearing: Rgba::rgb(0x6e, 0x7b, 0x88),
    edge: Rgba::rgb(0x3c, 0x46, 0x50),
    dimension: Rgba::rgb(0x24, 0x2e, 0x38),
    ink: Rgba::rgb(0x1c, 0x25, 0x2e),
    faint_ink: Rgba::rgb(0x53, 0x5f, 0x6a),
    plate: Rgba::new(0xff, 0xff, 0xff, 0xd8),
    halo: Rgba::new(0xff, 0xff, 0xff, 0xe8),
    resultant: Rgba::rgb(0x16, 0x1b, 0x22),
    ghost: Rgba::rgb(0x00, 0x5a, 0x8c),
    axes: [Rgba::rgb(0xb0, 0x3a, 0x2e), Rgba::rgb(0x2e, 0x7d, 0x4f), Rgba::rgb(0x2c, 0x5a, 0xa0)],
};

const DARK: Palette = Palette {
    sky: Rgba::rgb(0x1d, 0x23, 0x2a),
    floor: Rgba::rgb(0x14, 0x18, 0x1d),
    grid: Rgba::new(0x9f, 0xb0, 0xc0, 0x48),
    shadow: Rgba::new(0x00, 0x00, 0x00, 0x78),
    girder: Rgba::rgb(0x8b, 0x88, 0x82),
    abutment: Rgba::rgb(0x55, 0x5d, 0x66),
    soil: Rgba::rgb(0x6d, 0x5c, 0x45),
    bearing: Rgba::rgb(0x45, 0x52, 0x5f),
    edge: Rgba::rgb(0x0c, 0x10, 0x14),
    dimension: Rgba::rgb(0xe6, 0xea, 0xee),
    ink: Rgba::rgb(0xee, 0xf1, 0xf4),
    faint_ink: Rgba::rgb(0xc3, 0xcc, 0xd4),
    plate: Rgba::new(0x12, 0x17, 0x1c, 0xd8),
    halo: Rgba::new(0x10, 0x14, 0x18, 0xd0),
    resultant: Rgba::rgb(0xfa, 0xfb, 0xfc),
    ghost: Rgba::rgb(0x56, 0xb4, 0xe9),
    axes: [Rgba::rgb(0xf0, 0x8a, 0x7c), Rgba::rgb(0x7f, 0xd1, 0x9e), Rgba::rgb(0x8f, 0xb8, 0xee)],
};

impl Palette {
    /// The colours that go with a background.
    pub(super) fn of(background: Background) -> Self {
        let white = Rgba::rgb(0xff, 0xff, 0xff);
        match background {
            Background::Studio => LIGHT,
            Background::White => Self { sky: white, floor: white, ..LIGHT },
            Background::Transparent => Self { sky: Rgba::CLEAR, floor: Rgba::CLEAR, ..LIGHT },
            Background::Dark => DARK,
        }
    }
}

/// The accent of a state.
pub(super) fn of_state(state: ContactState) -> Rgba {
    match state {
        ContactState::Stick => STICK,
        ContactState::Slip => SLIP,
        ContactState::Open => OPENED,
    }
}
