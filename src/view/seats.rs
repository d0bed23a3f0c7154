//! Seats at abutments: walls from the ground to the bearings, as long as the scene says.

use glam::DVec3;

use super::block::Block;
use super::{ViewInput, decoration, piers};
use crate::geometry::End;
use crate::scene::{Girder, Scene, placed};

/// Reach of a seat without a length beyond its bearings towards the span, in deck depths \[–\].
const LEDGE: f64 = 0.6;

/// A seat under an end of a girder, along its axis before skewing, outwards from the middle.
struct Reach {
    end: End,
    /// Front edge, from mid-span \[m\].
    front: f64,
    /// Face of the abutment or end of the girder, from mid-span \[m\].
    back: f64,
}

/// Whether ends on the ground without a seat of a stated length are drawn on one: in a viaduct, and where decks are drawn as
/// bridges.
pub(super) fn are_shown(input: &ViewInput<'_>) -> bool {
    !input.scene.piers.is_empty() || input.overlays.decoration && decoration::has_bridge(input.scene)
}

/// The seats of a girder's ends that stand on the ground: those with a length; where `all` asks for it each that carries bearings.
pub(super) fn blocks(scene: &Scene, girder: &Girder, (all, level): (bool, f64)) -> Vec<Block> {
    reaches(scene, girder, all).iter().filter_map(|reach| block(scene, girder, reach, level)).collect()
}

/// Whether a bearing on the ground at this place in the girder's frame stands on a seat.
pub(super) fn carries(scene: &Scene, girder: &Girder, all: bool, [x, y]: [f64; 2]) -> bool {
    let way = x - y * girder.prism().shear();
    reaches(scene, girder, all).iter().any(|reach| (reach.front..=reach.back).contains(&(reach.end.sign() * way)))
}

fn reaches(scene: &Scene, girder: &Girder, all: bool) -> Vec<Reach> {
    let of = |end: End| {
        let bearings = nearest(scene, girder, end)?;
        let front = match girder.seat.length(end) {
            Some(length) => 0.5 * girder.length - length,
            None if !all => return None,
            None => bearings - LEDGE * girder.thickness,
        };
        Some(Reach { end, front, back: 0.5 * girder.length + abutment_gap(scene, girder, end) })
    };
    End::BOTH.into_iter().filter_map(of).collect()
}

/// Distance from mid-span to the innermost bearing of an end that stands on the ground, along the axis before skewing \[m\].
fn nearest(scene: &Scene, girder: &Girder, end: End) -> Option<f64> {
    let (supports, resolved) = (scene.supports(girder), girder.supports(scene.setting()));
    let shear = girder.prism().shear();
    let on_ground = resolved.iter().zip(&supports).filter(|(_, pier)| pier.is_none());
    on_ground.map(|(b, _)| end.sign() * (b.place.x - b.place.y * shear)).filter(|way| *way > 0.0).reduce(f64::min)
}

/// Its top at the feet of the bearings, down to the ground.
fn block(scene: &Scene, girder: &Girder, &Reach { end, front, back }: &Reach, level: f64) -> Option<Block> {
    let (axes, home, shear) = (placed::axes(girder), DVec3::from(girder.position), girder.prism().shear());
    let top = -0.5 * girder.thickness - piers::pad(scene);
    let corner = |way: f64, y: f64| home + axes * DVec3::new(end.sign() * way + y * shear, y, top);
    let half = 0.5 * girder.width;
    let face = [corner(front, -half), corner(back, -half), corner(back, half), corner(front, half)];
    let face = if end == End::Plus { face } else { [face[3], face[2], face[1], face[0]] };
    let down = level - face[0].z;
    (down < 0.0).then_some(Block { face, sweep: DVec3::Z * down })
}

/// Distance from an end to the abutment before it; 0 without one \[m\].
fn abutment_gap(scene: &Scene, girder: &Girder, end: End) -> f64 {
    let before = scene.abutments.iter().find(|a| a.faces == girder.name && a.end == end);
    before.and_then(|abutment| abutment.gap).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Seat, presets};

    #[test]
    fn a_seat_is_as_long_as_the_scene_says_and_carries_the_bearings_over_it() {
        let scene = presets::load("span-as-built").expect("ships");
        let girder = &scene.girders[0];
        let blocks = blocks(&scene, girder, (false, -10.0));
        assert_eq!(blocks.len(), 2, "one under each end");
        for block in &blocks {
            let [a, b, ..] = block.face;
            let along = (a - b).length();
            assert!((along - (1.0 + 0.05)).abs() < 1e-9, "{along} m of 1 m and the gap");
        }
        let shear = girder.prism().shear();
        assert!(carries(&scene, girder, false, [14.6 + 3.6 * shear, 3.6]), "as placed");
        assert!(!carries(&scene, girder, false, [13.9, 0.0]), "1.1 m from the end");
        let mut bare = scene.clone();
        bare.girders[0].seat = Seat::default();
        assert!(reaches(&bare, &bare.girders[0], false).is_empty(), "no seat is known");
    }
}
