//! Pairs of facing ends, found from the geometry or declared (Fig. 24, `docs/physics.md#contact-pairs`).
//!
//! An abutment pairs with the end that it faces. Two girders' ends pair when they look at each other (outward normals
//! opposed within [`LARGEST_TURN_DEG`]), each centre lies in front of the other's face, their sideways offset is less
//! than the mean length of the two ends, their heights overlap, no abutment stands nearer, and neither has a nearer
//! such partner (equally near ones count, so the order in the file does not matter). `[[contact.pair]]` with `ends`
//! declares any other pair.

mod declared;
mod end;
mod met;
mod numbers;
mod side;

pub use super::contact::PairContact;
pub use end::LARGEST_TURN_DEG;
pub use met::{between, bodies_met};
pub use numbers::contact_length;
pub(in crate::scene) use side::names;
pub use side::{Flank, Rear, Side, SolidId};

use super::{Scene, SceneError, SceneErrors, placed};
use crate::language::message;
use end::{EndFace, Walls};
use side::{front, girder_named};

/// Two faces that can touch.
#[derive(Clone, Debug, PartialEq)]
pub struct Facing {
    /// `deck+x|wall`, as tables and legends call it.
    pub name: String,
    /// Always of a girder, and of facing ends an end; of two girders, the one that comes first in the file.
    pub first: Side,
    /// Of a girder or an abutment.
    pub second: Side,
    /// Whether the pair was added because the two bodies met, where they do not face each other as placed.
    pub met: bool,
    /// The numbers in force.
    pub contact: PairContact,
    /// Reduced mass `M₁M₂/(M₁+M₂)` of the bodies, of an elastic girder what a dashpot sees of it \[kg\].
    pub mass: f64,
    /// Distance as placed, along the first girder's axis \[m\].
    pub gap: f64,
}

/// Finds every facing pair of a scene, in the order: girders' ends in file order (`+x` before `-x`), then declared ones.
///
/// # Errors
/// A pair that names nobody, a name that is no end, contact numbers that cannot be resolved.
pub fn find(scene: &Scene) -> Result<Vec<Facing>, SceneErrors> {
    let mut complaints = Vec::new();
    let mut sides = found(scene, &mut complaints);
    for (n, pair) in scene.contact.pairs.iter().enumerate() {
        match declared::pair(scene, pair, &sides) {
            Ok(new) => sides.extend(new),
            Err((place, value, remedy)) => {
                let place = format!("contact.pair[{n}].{place}").into();
                complaints.push(SceneError { file: "scene".to_owned(), place, value, remedy });
            }
        }
    }
    if !complaints.is_empty() {
        return Err(SceneErrors(complaints));
    }
    Ok(sides.into_iter().map(|(first, second)| facing(scene, first, second, false)).collect())
}

/// Pairs that are found by themselves.
fn found(scene: &Scene, complaints: &mut Vec<SceneError>) -> Vec<(Side, Side)> {
    for abutment in &scene.abutments {
        if girder_named(scene, &abutment.faces).is_none() {
            complaints.push(SceneError {
                file: "scene".to_owned(),
                place: format!("abutment.{}.faces", abutment.name).into(),
                value: format!("\"{}\"", abutment.faces).into(),
                remedy: message!("wrong-no-such-girder", "names" => names(scene)),
            });
        }
    }
    let walls = Walls::of(scene);
    let ends: Vec<EndFace> = end::all(scene, &walls);
    let lookout = end::Lookout::over(&ends);
    let mut sides = Vec::new();
    for (number, here) in ends.iter().enumerate() {
        let first = Side::Girder(here.girder, here.end);
        sides.extend(walls.before(here.girder, here.end).iter().map(|&n| (first, Side::Abutment(n))));
        sides.extend(lookout.partners(number).map(|there| (first, Side::Girder(there.girder, there.end))));
    }
    sides
}

fn facing(scene: &Scene, first: Side, second: Side, met: bool) -> Facing {
    let contact = numbers::in_force(scene, first, second);
    Facing {
        name: pair_name(scene, first, second),
        first,
        second,
        met,
        mass: numbers::dashpot_mass(scene, first, second, contact.stiffness),
        contact,
        gap: gap(scene, first, second),
    }
}

/// `deck+x|wall`.
fn pair_name(scene: &Scene, first: Side, second: Side) -> String {
    let ([body, end], [other, there]) = (name_of(scene, first), name_of(scene, second));
    [body, end, "|", other, there].concat()
}

/// `deck+x` in two pieces; an abutment has a name only.
fn name_of(scene: &Scene, side: Side) -> [&str; 2] {
    [side.solid().name(scene), side.label()]
}

/// The gap as it is written, to the last digit, where an abutment stands before this very end.
fn written_gap(scene: &Scene, first: Side, second: Side) -> Option<f64> {
    let (Side::Girder(girder, end), Side::Abutment(n)) = (first, second) else { return None };
    let abutment = &scene.abutments[n];
    let faced = abutment.faces == scene.girders[girder].name && abutment.end == end;
    abutment.gap.filter(|_| faced)
}

/// Distance from the first face's centre to the second's plane: of an end along the girder's axis, else square to the plane \[m\].
fn gap(scene: &Scene, first: Side, second: Side) -> f64 {
    if let Some(gap) = written_gap(scene, first, second) {
        return gap;
    }
    let (Some((here, _)), Some((there, normal))) = (front(scene, first), front(scene, second)) else { return 0.0 };
    let square = (here - there).dot(normal);
    let Side::Girder(girder, end) = first else { return square };
    // A declared pair may be turned so far that the axis never meets the plane: then square to it.
    let slope = -(placed::axes(&scene.girders[girder]).x_axis * end.sign()).dot(normal);
    if slope > 1e-6 { square / slope } else { square }
}
