//! The two sides of a pair: faces of girders and abutments, by number and by name.

use glam::DVec3;

use crate::geometry::shape::block_behind;
use crate::geometry::{End, Prism};
use crate::language::{Message, Text, message};
use crate::scene::{Kind, Scene, placed};

/// A body of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SolidId {
    /// A girder, by its number.
    Girder(usize),
    /// An abutment, by its number.
    Abutment(usize),
}

impl SolidId {
    /// Its name in the scene.
    pub fn name(self, scene: &Scene) -> &str {
        match self {
            Self::Girder(number) => &scene.girders[number].name,
            Self::Abutment(number) => &scene.abutments[number].name,
        }
    }
}

/// A face of a girder other than its ends, by its outward normal in the girder's own axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Flank {
    /// At −y.
    Right,
    /// At +y.
    Left,
    /// Underside.
    Bottom,
    /// Upper side.
    Top,
}

impl Flank {
    /// From the centre of an oblique section of a girder to the middle of its edge in the face, girder axes \[m\].
    pub fn offset(self, prism: &Prism) -> DVec3 {
        let across = |y: f64| DVec3::new(prism.shear() * y, y, 0.0);
        match self {
            Self::Right => across(-0.5 * prism.width),
            Self::Left => across(0.5 * prism.width),
            Self::Bottom => DVec3::Z * (-0.5 * prism.thickness),
            Self::Top => DVec3::Z * (0.5 * prism.thickness),
        }
    }
}

/// A face of an abutment other than its front, seen from the girder before the front.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Rear {
    /// Behind the left edge of the front.
    Left,
    /// Behind the right edge of the front.
    Right,
    /// Opposite to the front.
    Back,
    /// Underside.
    Bottom,
    /// Upper side.
    Top,
}

/// A face that takes part in a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// An end of a girder, by its number in the scene.
    Girder(usize, End),
    /// The front of an abutment, by its number in the scene.
    Abutment(usize),
    /// Another face of a girder.
    Flank(usize, Flank),
    /// Another face of an abutment.
    Rear(usize, Rear),
}

impl Side {
    /// The body that has the face.
    pub fn solid(self) -> SolidId {
        match self {
            Self::Girder(n, _) | Self::Flank(n, _) => SolidId::Girder(n),
            Self::Abutment(n) | Self::Rear(n, _) => SolidId::Abutment(n),
        }
    }

    /// Number of the girder that has the face; `None` for an abutment.
    pub fn girder(self) -> Option<usize> {
        match self.solid() {
            SolidId::Girder(n) => Some(n),
            SolidId::Abutment(_) => None,
        }
    }

    /// All faces of a body that can touch: in plan those that stand upright.
    pub fn of(kind: Kind, solid: SolidId) -> Vec<Self> {
        match solid {
            SolidId::Girder(n) => {
                let mut all = vec![Self::Girder(n, End::Plus), Self::Girder(n, End::Minus)];
                all.extend([Flank::Right, Flank::Left].map(|flank| Self::Flank(n, flank)));
                if kind == Kind::Spatial {
                    all.extend([Flank::Bottom, Flank::Top].map(|flank| Self::Flank(n, flank)));
                }
                all
            }
            SolidId::Abutment(n) => {
                let mut all = vec![Self::Abutment(n)];
                all.extend([Rear::Left, Rear::Right, Rear::Back].map(|rear| Self::Rear(n, rear)));
                if kind == Kind::Spatial {
                    all.extend([Rear::Bottom, Rear::Top].map(|rear| Self::Rear(n, rear)));
                }
                all
            }
        }
    }

    /// Numbers of the face's corners among the eight of its body, anticlockwise seen from outside: of
    /// [`Prism::corners`](crate::geometry::Prism::corners) or [`block_behind`](crate::geometry::shape::block_behind).
    pub fn corners(self) -> [usize; 4] {
        match self {
            Self::Girder(_, End::Plus) => [1, 2, 6, 5],
            Self::Girder(_, End::Minus) => [3, 0, 4, 7],
            Self::Flank(_, Flank::Right) | Self::Rear(_, Rear::Bottom) => [0, 1, 5, 4],
            Self::Flank(_, Flank::Left) => [2, 3, 7, 6],
            Self::Flank(_, Flank::Bottom) => [0, 3, 2, 1],
            Self::Flank(_, Flank::Top) | Self::Abutment(_) => [4, 5, 6, 7],
            Self::Rear(_, Rear::Left) => [0, 4, 7, 3],
            Self::Rear(_, Rear::Right) => [5, 1, 2, 6],
            Self::Rear(_, Rear::Back) => [1, 0, 3, 2],
            Self::Rear(_, Rear::Top) => [7, 6, 2, 3],
        }
    }

    /// Ending of the face's name after the body's; empty for the front of an abutment.
    pub fn label(self) -> &'static str {
        match self {
            Self::Girder(_, end) => end.label(),
            Self::Abutment(_) => "",
            Self::Flank(_, Flank::Right) => "-y",
            Self::Flank(_, Flank::Left) => "+y",
            Self::Flank(_, Flank::Bottom) => "-z",
            Self::Flank(_, Flank::Top) => "+z",
            Self::Rear(_, Rear::Left) => ".left",
            Self::Rear(_, Rear::Right) => ".right",
            Self::Rear(_, Rear::Back) => ".back",
            Self::Rear(_, Rear::Bottom) => ".bottom",
            Self::Rear(_, Rear::Top) => ".top",
        }
    }
}

/// Corners of a face in the world as placed, anticlockwise seen from outside \[m\]; `None` where an abutment has no face yet.
fn face(scene: &Scene, side: Side) -> Option<[DVec3; 4]> {
    let of_block = |n: usize| {
        let abutment = &scene.abutments[n];
        Some(block_behind(placed::abutment_face(scene, abutment)?, placed::abutment_depth(scene, abutment)))
    };
    match side {
        Side::Girder(n, end) => Some(placed::end_face(&scene.girders[n], end)),
        Side::Abutment(n) => placed::abutment_face(scene, &scene.abutments[n]),
        Side::Flank(n, _) => {
            let girder = &scene.girders[n];
            let (axes, corners) = (placed::axes(girder), girder.prism().corners());
            Some(side.corners().map(|i| DVec3::from(girder.position) + axes * corners[i]))
        }
        Side::Rear(n, _) => of_block(n).map(|block| side.corners().map(|i| block[i])),
    }
}

/// Centre and outward normal of a side's face; `None` where an abutment has no face yet.
pub(super) fn front(scene: &Scene, side: Side) -> Option<(DVec3, DVec3)> {
    let [a, b, c, d] = face(scene, side)?;
    Some(((a + b + c + d) / 4.0, (c - a).cross(d - b).normalize_or_zero()))
}

pub(super) fn girder_named(scene: &Scene, name: &str) -> Option<usize> {
    scene.girders.iter().position(|g| g.name == name)
}

/// Names of the bodies, for complaints.
pub(in crate::scene) fn names(scene: &Scene) -> Message {
    let list = |names: Vec<&str>| {
        if names.is_empty() { Text::new("wrong-names-none").into() } else { Message::from(names.join(", ")) }
    };
    let girders = list(scene.girders.iter().map(|g| g.name.as_str()).collect());
    let abutments = list(scene.abutments.iter().map(|a| a.name.as_str()).collect());
    message!("wrong-names", "girders" => girders, "abutments" => abutments)
}
