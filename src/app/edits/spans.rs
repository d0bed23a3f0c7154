//! Edits that add spans: a copy of a girder, one more at the end of the row, a row of them.

use glam::DVec3;

use super::change::{abutment, gap_of, girder, tidy, wall_end};
use super::fresh::first_girder;
use crate::geometry::End;
use crate::scene::edit::{Edit, free_name_after};
use crate::scene::facing::{self, Side};
use crate::scene::{Abutment, Girder, Initial, Scene, StandsOn, placed};

/// A copy of a girder beyond the `+x` end of the row, one gap away.
pub(in crate::app) fn add_girder(scene: &Scene, like: Option<usize>) -> Edit {
    let mut new = beyond_the_row(scene, like);
    stand_anew(scene, &mut new);
    Edit::AddGirder(scene.girders.len(), Box::new(new))
}

fn beyond_the_row(scene: &Scene, like: Option<usize>) -> Girder {
    let model = like.and_then(|i| scene.girders.get(i)).or(scene.girders.last());
    let mut new = model.cloned().unwrap_or_else(first_girder);
    new.name = free_name_after(scene, &new.name);
    new.initial = Initial::default();
    let along = placed::axes(&new).x_axis;
    let gap = gap_of(scene).unwrap_or(0.003).max(new.length * 0.005);
    let end = scene.girders.iter().map(|g| DVec3::from(g.position).dot(along) + g.length / 2.0);
    let walls = scene.abutments.iter().filter_map(|a| wall_end(scene, a, along));
    if let Some(farthest) = end.chain(walls).reduce(f64::max) {
        let place = DVec3::from(new.position);
        let there = place + along * (farthest + gap + new.length / 2.0 - place.dot(along));
        new.position = tidy(there);
    }
    new
}

/// Puts a copy of a girder on the ground, and an end that is part of a joint on the pier under the joint: what carries the girder
/// that was copied does not stand under the copy.
fn stand_anew(scene: &Scene, new: &mut Girder) {
    new.stand_on_ground();
    let number = scene.girders.len();
    let mut with = scene.clone();
    with.girders.push(new.clone());
    for pair in facing::find(&with).unwrap_or_default() {
        let (Side::Girder(first, end), Side::Girder(second, facing)) = (pair.first, pair.second) else { continue };
        if first == number {
            stand_beside(scene, (new, end), (second, facing));
        } else if second == number {
            stand_beside(scene, (new, facing), (first, end));
        }
    }
}

/// Puts an end on the pier, if any, under the other end of its joint.
fn stand_beside(scene: &Scene, (new, own): (&mut Girder, End), (other, end): (usize, End)) {
    if let Some(pier) = scene.pier_under(&scene.girders[other], end) {
        new.stand_on(own, Some(&scene.piers[pier].name));
    }
}

/// One more span beyond the `+x` end of the row. The abutment that stood before that end stands before the new span's.
pub(in crate::app) fn add_span(scene: &Scene, like: Option<usize>) -> Edit {
    let mut new = beyond_the_row(scene, like);
    let at = scene.girders.len();
    let along = placed::axes(&new).x_axis;
    let reach = |i: &usize| DVec3::from(scene.girders[*i].position).dot(along) + scene.girders[*i].length / 2.0;
    let last = (0..at).max_by(|a, b| reach(a).total_cmp(&reach(b)));
    let stands = |last: &Girder, wall: &Abutment| {
        wall.faces == last.name && wall.end == End::Plus && wall.polygon.is_none() && placed::axes(last).x_axis == along
    };
    let wall_of = |last: usize| scene.abutments.iter().position(|wall| stands(&scene.girders[last], wall));
    let Some((last, number)) = last.and_then(|last| Some((last, wall_of(last)?))) else {
        stand_anew(scene, &mut new);
        return Edit::AddGirder(at, Box::new(new));
    };
    let model = &scene.girders[last];
    let gap = gap_of(scene).unwrap_or(0.0).max(new.length * 1e-3);
    let place = DVec3::from(model.position) + along * (f64::midpoint(model.length, new.length) + gap);
    new.position = tidy(place);
    stand_anew(scene, &mut new);
    let mut edits = moved_walls(scene, [number].into_iter(), last, &mut new);
    edits.insert(0, Edit::AddGirder(at, Box::new(new)));
    Edit::Batch(edits)
}

/// Copies of a girder in a row beyond its `+x` end: so many spans, the first of them itself, `gap` apart \[m\]. The
/// abutment that stood before that end stands before the row's end then.
pub(in crate::app) fn array(scene: &Scene, first: usize, spans: usize, gap: f64) -> Edit {
    let Some(model) = scene.girders.get(first).filter(|_| spans > 1) else { return Edit::Batch(Vec::new()) };
    let mut names = scene.clone();
    let mut row: Vec<Girder> = Vec::with_capacity(spans - 1);
    for span in 1..spans {
        let way = placed::axes(model).x_axis * ((model.length + gap) * span as f64);
        let mut new = model.clone();
        new.name = free_name_after(&names, row.last().map_or(&model.name, |before| &before.name));
        new.position = tidy(DVec3::from(new.position) + way);
        new.stand_on_ground();
        names.girders.push(new.clone());
        row.push(new);
    }
    if let Some(second) = row.first_mut() {
        stand_beside(scene, (second, End::Minus), (first, End::Plus));
    }
    let before = |wall: &&usize| {
        let wall = &scene.abutments[**wall];
        wall.faces == model.name && wall.end == End::Plus && wall.polygon.is_none()
    };
    let walls: Vec<usize> = (0..scene.abutments.len()).collect();
    let walls = walls.iter().filter(before).copied();
    let moved = row.last_mut().map_or(Vec::new(), |last| moved_walls(scene, walls, first, last));
    let added = (scene.girders.len()..).zip(row).map(|(at, new)| Edit::AddGirder(at, Box::new(new)));
    Edit::Batch(added.chain(moved).collect())
}

/// Abutments that stood before the `+x` end of a girder stand before that of the new one, and carry what they carried of the old
/// one there.
fn moved_walls(scene: &Scene, walls: impl Iterator<Item = usize>, from: usize, new: &mut Girder) -> Vec<Edit> {
    let mut edits = Vec::new();
    for number in walls {
        let wall = &scene.abutments[number];
        edits.push(abutment(number, Abutment { faces: new.name.clone(), ..wall.clone() }));
        let mut old = scene.girders[from].clone();
        if scene.standing_under(&old, End::Plus) == Some(StandsOn::Abutment(number)) {
            new.stand_on(End::Plus, Some(&wall.name));
            old.stand_on(End::Plus, None);
            edits.push(girder(from, old));
        }
    }
    edits
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{presets, validate};

    fn viaduct() -> Scene {
        presets::load("viaduct-5").expect("a preset")
    }

    fn after(scene: &Scene, edit: Edit) -> Scene {
        let mut after = scene.clone();
        edit.apply(&mut after).expect("fits");
        assert_eq!(validate::validate(&after), Ok(()));
        after
    }

    fn under(scene: &Scene, number: usize) -> [Option<StandsOn>; 2] {
        [End::Minus, End::Plus].map(|end| scene.standing_under(&scene.girders[number], end))
    }

    #[test]
    fn copies_stand_on_the_ground_and_not_on_the_piers_of_their_model() {
        let scene = viaduct();
        let added = after(&scene, add_span(&scene, Some(2)));
        assert_eq!(under(&added, 5), [Some(StandsOn::Ground); 2], "before g5, whose end stands on the ground");
        let copied = after(&scene, add_girder(&scene, Some(1)));
        assert_eq!(under(&copied, 5), [Some(StandsOn::Ground); 2], "a copy behind the abutment");
        assert_eq!(scene.pier(2).top, copied.pier(2).top, "no pier has moved");
        assert_eq!((added.girders[5].name.as_str(), copied.girders[5].name.as_str()), ("g6", "g6"), "counted on");
    }

    #[test]
    fn a_copy_at_a_joint_stands_on_its_pier() {
        let mut scene = viaduct();
        scene.girders.truncate(4);
        scene.abutments.truncate(1);
        let pier = scene.pier_named("p4").map(StandsOn::Pier);
        for edit in [add_span(&scene, Some(0)), add_girder(&scene, None), array(&scene, 3, 3, 0.05)] {
            assert_eq!(under(&after(&scene, edit), 4), [pier, Some(StandsOn::Ground)], "g5");
        }
        let row = after(&scene, array(&scene, 3, 3, 0.05));
        assert_eq!(under(&row, 5), [Some(StandsOn::Ground); 2], "g6");
    }

    #[test]
    fn an_abutment_that_moves_on_carries_the_new_end() {
        let mut scene = viaduct();
        let east = scene.abutments.iter().position(|a| a.name == "east").map(StandsOn::Abutment);
        scene.girders[4].stand_on(End::Plus, Some("east"));
        let ground = Some(StandsOn::Ground);
        for edit in [add_span(&scene, None), array(&scene, 4, 2, 0.05)] {
            let longer = after(&scene, edit);
            assert_eq!(under(&longer, 4)[1], ground, "g5 no longer");
            assert_eq!(under(&longer, 5), [ground, east], "g6");
        }
    }
}
