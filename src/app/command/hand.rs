//! Handles of the 3D view, and commands for one that is held by keys.

use glam::DVec3;

use crate::geometry::End;
use crate::scene::DeviceId;

/// One of two long sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Flank {
    /// Toward `+y`.
    Left,
    /// Toward `-y`.
    Right,
}

impl Flank {
    /// Both.
    pub(in crate::app) const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// +1 or −1.
    pub(in crate::app) fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }
}

/// Quantity that a handle changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Grip {
    /// All that is selected, over the ground.
    Bodies,
    /// A girder along its own axis.
    Along(usize),
    /// A girder across its axis.
    Across(usize),
    /// A girder about its middle.
    Turn(usize),
    /// An end: the length.
    Length(usize, End),
    /// A long side: the width.
    Width(usize, Flank),
    /// A corner: the skew.
    Skew(usize, End, Flank),
    /// A gap, by the number of the facing pair.
    Gap(usize),
    /// An abutment along its face.
    Offset(usize),
    /// An abutment's side: the width of its face.
    FaceWidth(usize, Flank),
    /// A point of a device: its first, 0, or its second, 1.
    DevicePoint(DeviceId, usize),
    /// A pier's foot: its height.
    PierHeight(usize),
    /// The side of a pier's columns: their size, and by it the stiffness.
    PierColumn(usize),
}

impl Grip {
    /// Whether it moves two ways over the ground: two numbers can be typed.
    pub(in crate::app) fn moves_two_ways(self) -> bool {
        matches!(self, Self::Bodies | Self::DevicePoint(..))
    }

    /// Whether it moves up and down.
    pub(in crate::app) fn is_upright(self) -> bool {
        matches!(self, Self::PierHeight(_))
    }
}

/// A key for the number of the handle that is held.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum HandKey {
    /// Letters of it.
    Text(String),
    /// Take the last letter back.
    TakeBack,
    /// To the other number, where there are two.
    Next,
    /// It is good: let go.
    Set,
    /// Let go, and put everything back.
    Cancel,
}

/// A handle by keys.
#[derive(Clone, Debug)]
pub enum HandCommand {
    /// Take hold of a handle without the mouse, at its place \[m\].
    Take(Grip, DVec3),
    /// A key for the number of the handle that is held.
    Type(HandKey),
}
