//! Edits of piers: under a joint, like another, moved.

use super::change::{girder, micrometres};
use crate::geometry::End;
use crate::scene::edit::{Edit, free_name, free_name_after};
use crate::scene::facing::{self, Side};
use crate::scene::{CONCRETE_MODULUS, ColumnTop, Girder, PerDirection, Pier, Scene};

/// Diameter of a new pier's columns, in widths of the deck (chosen).
const COLUMN: f64 = 0.15;
/// Height of a new pier, in depths of the deck (chosen).
const HEIGHT: f64 = 6.0;
/// Mass of a new pier, in masses of the deck (chosen).
const CAP: f64 = 0.4;
/// Modulus of cracked columns: half that of concrete \[Pa\].
const CRACKED: f64 = 0.5 * CONCRETE_MODULUS;

/// Gives a pier other numbers.
pub(in crate::app) fn pier(i: usize, pier: Pier) -> Edit {
    Edit::ReplacePier(i, Box::new(pier))
}

/// A pier under a joint that has none: at the `+x` end of the girder chosen, else the first one; bearings of both ends stand on it.
pub(super) fn add_pier(scene: &Scene, chosen: Option<usize>) -> Option<Edit> {
    let ends = joint(scene, chosen)?;
    let name = free_name(scene, "pier");
    let first = &scene.girders[ends[0].0];
    let mut edits = vec![Edit::AddPier(scene.piers.len(), Box::new(new_pier(&name, first)))];
    for (i, end) in ends {
        let mut standing = scene.girders[i].clone();
        if standing.stand_on(end, Some(&name)) {
            edits.push(girder(i, standing));
        }
    }
    Some(Edit::Batch(edits))
}

/// The ends of a joint whose bearings stand on the ground, that of the girder chosen first.
fn joint(scene: &Scene, chosen: Option<usize>) -> Option<Vec<(usize, End)>> {
    let pairs = facing::find(scene).unwrap_or_default();
    let end = |side: Side| if let Side::Girder(i, end) = side { Some((i, end)) } else { None };
    let free = |&(i, end): &(usize, End)| {
        scene.girders[i].bearings.is_some() && scene.pier_under(&scene.girders[i], end).is_none()
    };
    let joints = pairs.iter().filter_map(|pair| Some([end(pair.first)?, end(pair.second)?]));
    let joints: Vec<_> = joints.map(|ends| ends.into_iter().filter(free).collect::<Vec<_>>()).collect();
    let with = |ends: &&Vec<(usize, End)>| ends.iter().any(|&(i, end)| Some(i) == chosen && end == End::Plus);
    let of_chosen = joints.iter().find(with);
    of_chosen.or(joints.iter().find(|ends| ends.len() == 2)).filter(|ends| !ends.is_empty()).cloned()
}

/// Two columns under a cap, in proportion to the deck above.
fn new_pier(name: &str, deck: &Girder) -> Pier {
    let round = |v: f64| {
        let digit = 10f64.powf(v.abs().max(f64::MIN_POSITIVE).log10().floor() - 1.0);
        (v / digit).round() * digit
    };
    Pier {
        delay: None,
        motion_factor: None,
        ground: None,
        name: name.to_owned(),
        mass: round(CAP * deck.mass),
        position: None,
        heading_deg: None,
        stiffness: None,
        frequency: None,
        column: Some(PerDirection::Both(round(COLUMN * deck.width))),
        columns: 2.0,
        modulus: Some(CRACKED),
        top: ColumnTop::FixedAcross,
        damping_ratio: None,
        turn_stiffness: None,
        turn_inertia: None,
        yield_force: None,
        post_yield_ratio: None,
        height: Some(round(HEIGHT * deck.thickness)),
        cap: None,
    }
}

/// A pier of the same numbers beside another, on which nothing stands.
pub(super) fn add_pier_like(scene: &Scene, like: usize) -> Option<Edit> {
    let (here, old) = (scene.pier(like), scene.piers.get(like)?);
    let beside = here.top + here.axes.y_axis * (1.5 * here.cap[1]);
    let position = Some([beside.x, beside.y].map(micrometres));
    let new = Pier { name: free_name_after(scene, &old.name), position, cap: Some(here.cap), ..old.clone() };
    Some(Edit::AddPier(scene.piers.len(), Box::new(new)))
}

#[cfg(test)]
mod tests {
    use super::super::change::shifted;
    use super::*;
    use crate::scene::{presets, validate};
    use crate::view::Target;

    #[test]
    fn a_pier_comes_under_the_joint_of_the_girder_chosen_then_under_the_next() {
        let mut scene = presets::load("row-of-5").expect("a preset");
        for (chosen, ends) in [(Some(2), [2, 3]), (None, [0, 1]), (None, [1, 2]), (None, [3, 4])] {
            let number = scene.piers.len();
            add_pier(&scene, chosen).expect("a joint").apply(&mut scene).expect("done");
            let [one, other] = ends.map(|i| &scene.girders[i]);
            let under = [scene.pier_under(one, End::Plus), scene.pier_under(other, End::Minus)];
            assert_eq!(under, [Some(number); 2], "{chosen:?}");
        }
        assert_eq!(validate::validate(&scene), Ok(()));
        assert!(add_pier(&scene, None).is_none(), "every joint has one");
        let middle = 0.5 * (scene.girders[2].position[0] + scene.girders[3].position[0]);
        assert!((scene.pier(0).top.x - middle).abs() < 1e-9, "in the middle of the joint");
    }

    #[test]
    fn a_pier_that_is_moved_stays_where_it_is_put() {
        let mut scene = presets::load("viaduct-5").expect("a preset");
        let before = scene.pier(1).top;
        shifted(&scene, Target::Pier(1), [0.5, -0.25], 0.0).expect("a pier").apply(&mut scene).expect("done");
        let way = scene.pier(1).top - before;
        assert!((way.truncate() - glam::DVec2::new(0.5, -0.25)).length() < 2e-6, "{way}");
    }
}
