//! From what a hand does to the edits of [`scene::edit`](crate::scene::edit) that do it.

use glam::DVec3;

use crate::geometry::End;
use crate::scene::edit::{Edit, General, free_among, free_name};
use crate::scene::facing::{self, Side};
use crate::scene::{Abutment, ContactSettings, Girder, GroundId, Motion, NamedGround, Pier, Scene, Wave, placed};
use crate::view::Target;
use crate::view::block::abutment_block;

/// Gives a girder other numbers.
pub(in crate::app) fn girder(i: usize, girder: Girder) -> Edit {
    Edit::ReplaceGirder(i, Box::new(girder))
}

/// Gives an abutment other numbers.
pub(in crate::app) fn abutment(i: usize, abutment: Abutment) -> Edit {
    Edit::ReplaceAbutment(i, Box::new(abutment))
}

/// Gives the contact other numbers.
pub(in crate::app) fn contact(contact: ContactSettings) -> Edit {
    Edit::Contact(Box::new(contact))
}

/// Moves a ground otherwise.
pub(in crate::app) fn motion(scene: &Scene, ground: GroundId, motion: Motion) -> Edit {
    let GroundId::Named(number) = ground else { return Edit::Motion(Box::new(motion)) };
    let mut grounds = scene.grounds.clone();
    grounds.get_mut(number).into_iter().for_each(|named| named.motion = motion.clone());
    Edit::Grounds(grounds)
}

/// One more motion for supports to have of their own: it begins as that of `[motion]`.
pub(in crate::app) fn add_ground(scene: &Scene) -> Edit {
    let name = free_among("own-ground", |name| scene.ground_named(name).is_some());
    let named = NamedGround { name, motion: scene.motion.clone() };
    Edit::Grounds(scene.grounds.iter().cloned().chain([named]).collect())
}

/// Calls a ground otherwise, wherever it is named, or takes it away where there is no name; supports then stand on that of `[motion]`.
/// Where the name is taken only the ground takes it, so that those who stand on either can still be told apart.
pub(in crate::app) fn rename_ground(scene: &Scene, number: usize, name: Option<&str>) -> Edit {
    let mut grounds = scene.grounds.clone();
    let before = match name {
        Some(name) => std::mem::replace(&mut grounds[number].name, name.to_owned()),
        None => grounds.remove(number).name,
    };
    if name.is_some_and(|name| scene.ground_named(name).is_some()) {
        return Edit::Grounds(grounds);
    }
    let named = |ground: &Option<String>| ground.as_ref() == Some(&before);
    let ground = || name.map(str::to_owned);
    let mut edits = vec![Edit::Grounds(grounds)];
    for (i, a) in scene.abutments.iter().enumerate().filter(|(_, a)| named(&a.ground)) {
        edits.push(abutment(i, Abutment { ground: ground(), ..a.clone() }));
    }
    for (i, pier) in scene.piers.iter().enumerate().filter(|(_, pier)| named(&pier.ground)) {
        edits.push(Edit::ReplacePier(i, Box::new(Pier { ground: ground(), ..pier.clone() })));
    }
    Edit::Batch(edits)
}

/// Lets the motion travel: at a speed that was not given.
pub(in crate::app) fn wave_assumed(scene: &Scene, wave: Option<Wave>) -> Edit {
    let listed = scene.assumed.iter().cloned().chain(["wave".to_owned()]).collect();
    Edit::Batch(vec![Edit::Wave(wave), Edit::Assumed(listed)])
}

/// Runs longer or shorter \[s\].
pub(in crate::app) fn duration(scene: &Scene, duration: f64) -> Edit {
    Edit::General(Box::new(General { duration, ..General::of(scene) }))
}

/// The gap of the first facing pair, which the slider shows \[m\].
pub(in crate::app) fn gap_of(scene: &Scene) -> Option<f64> {
    gaps(scene).first().copied()
}

/// The gaps of all facing pairs \[m\].
pub(in crate::app) fn gaps(scene: &Scene) -> Vec<f64> {
    facing::find(scene).map_or(Vec::new(), |pairs| pairs.iter().map(|pair| pair.gap).collect())
}

/// How far an abutment stands before its girder's end, along the girder's axis \[m\].
pub(in crate::app) fn gap_before(scene: &Scene, abutment: &Abutment) -> Option<f64> {
    let number = scene.abutments.iter().position(|a| a.name == abutment.name)?;
    let pairs = facing::find(scene).ok()?;
    let own = pairs.iter().find(|p| p.second == Side::Abutment(number))?;
    Some(micrometres(own.gap).max(0.0))
}

/// Opens every facing pair to the same gap: abutments by their own number, girders by standing farther apart \[m\].
pub(in crate::app) fn gap(scene: &Scene, gap: f64) -> Edit {
    let mut edits = Vec::new();
    let mut shift = vec![None; scene.girders.len()];
    for pair in facing::find(scene).unwrap_or_default() {
        match (pair.first, pair.second) {
            (Side::Girder(..), Side::Abutment(i)) => {
                if let Some(wall) = scene.abutments.get(i).filter(|a| a.gap.is_some()) {
                    edits.push(abutment(i, Abutment { gap: Some(gap), ..wall.clone() }));
                }
            }
            (Side::Girder(first, end), Side::Girder(second, _)) => {
                let along = placed::axes(&scene.girders[first]).x_axis * end.sign();
                push_apart(&mut shift, first, second, along * (gap - pair.gap));
            }
            (Side::Abutment(_) | Side::Flank(..) | Side::Rear(..), _) | (_, Side::Flank(..) | Side::Rear(..)) => {}
        }
    }
    let moved = scene.girders.iter().zip(shift).enumerate();
    edits.extend(moved.filter_map(|(i, (g, shift))| {
        Some(Edit::MoveGirder(i, tidy(DVec3::from(g.position) + shift?), g.heading_deg))
    }));
    Edit::Batch(edits)
}

/// A place in whole micrometres: it will be read in a file.
pub(in crate::app) fn tidy(place: DVec3) -> [f64; 3] {
    place.to_array().map(micrometres)
}

/// To a whole micrometre \[m\].
pub(in crate::app) fn micrometres(v: f64) -> f64 {
    (v * 1e6).round() / 1e6
}

/// Moves a girder and every girder that stands in a row with it, up to `from`, by a way \[m\]: gaps beyond stay.
pub(in crate::app) fn row_shifted(scene: &Scene, from: usize, second: usize, way: DVec3) -> Edit {
    let pairs = facing::find(scene).unwrap_or_default();
    let mut row = vec![second];
    let mut next = 0;
    while let Some(&here) = row.get(next) {
        next += 1;
        for pair in &pairs {
            let (Side::Girder(a, _), Side::Girder(b, _)) = (pair.first, pair.second) else { continue };
            let there = if a == here { b } else { a };
            if (a == here || b == here) && there != from && !row.contains(&there) {
                row.push(there);
            }
        }
    }
    let moved = row.into_iter().filter_map(|i| {
        let girder = scene.girders.get(i)?;
        Some(Edit::MoveGirder(i, tidy(DVec3::from(girder.position) + way), girder.heading_deg))
    });
    Edit::Batch(moved.collect())
}

/// Moves the second girder with the first one's shift and `way` on; a girder already moved by another pair stays.
fn push_apart(shift: &mut [Option<DVec3>], first: usize, second: usize, way: DVec3) {
    match (shift[first], shift[second]) {
        (_, None) => {
            let base = *shift[first].get_or_insert(DVec3::ZERO);
            shift[second] = Some(base + way);
        }
        (None, Some(there)) => shift[first] = Some(there - way),
        (Some(_), Some(_)) => {}
    }
}

/// Gives something another name.
pub(in crate::app) fn rename(scene: &Scene, target: Target, name: String) -> Option<Edit> {
    let old = match target {
        Target::Girder(i) => scene.girders.get(i).map(|g| g.name.clone()),
        Target::Abutment(i) => scene.abutments.get(i).map(|a| a.name.clone()),
        Target::Pier(i) => scene.piers.get(i).map(|p| p.name.clone()),
        Target::Device(id) => scene.device(id).map(|device| device.part().ends().name.to_owned()),
        Target::Contact(_) => None,
    };
    old.map(|old| Edit::Rename(old, name))
}

/// Removes something.
pub(in crate::app) fn remove(target: Target) -> Option<Edit> {
    match target {
        Target::Girder(i) => Some(Edit::RemoveGirder(i)),
        Target::Abutment(i) => Some(Edit::RemoveAbutment(i)),
        Target::Pier(i) => Some(Edit::RemovePier(i)),
        Target::Device(id) => Some(Edit::RemoveDevice(id)),
        Target::Contact(_) => None,
    }
}

/// A body moved over the ground \[m\] and turned \[degrees\]; an abutment that follows a girder goes with its gap and
/// offset, and does not turn.
pub(in crate::app) fn shifted(scene: &Scene, target: Target, [dx, dy]: [f64; 2], turn_deg: f64) -> Option<Edit> {
    match target {
        Target::Girder(i) => {
            let girder = scene.girders.get(i)?;
            let [x, y, z] = girder.position;
            Some(Edit::MoveGirder(i, tidy(DVec3::new(x + dx, y + dy, z)), girder.heading_deg + turn_deg))
        }
        Target::Abutment(i) => shifted_abutment(scene, i, glam::DVec2::new(dx, dy)),
        Target::Pier(i) => shifted_pier(scene, i, [dx, dy], turn_deg),
        // It goes with the bodies that it is on.
        Target::Device(_) | Target::Contact(_) => None,
    }
}

/// A pier stands where it is put, no longer in the middle of its bearings.
fn shifted_pier(scene: &Scene, number: usize, [dx, dy]: [f64; 2], turn_deg: f64) -> Option<Edit> {
    let old = scene.piers.get(number)?;
    let here = scene.pier(number);
    let position = Some([here.top.x + dx, here.top.y + dy].map(micrometres));
    let along = here.axes.x_axis;
    let turned = || old.heading_deg.unwrap_or(along.y.atan2(along.x).to_degrees()) + turn_deg;
    let heading_deg = if turn_deg == 0.0 { old.heading_deg } else { Some(turned()) };
    Some(Edit::ReplacePier(number, Box::new(Pier { position, heading_deg, ..old.clone() })))
}

/// An abutment follows its gap and its offset, or its corners.
fn shifted_abutment(scene: &Scene, number: usize, way: glam::DVec2) -> Option<Edit> {
    let mut new = scene.abutments.get(number)?.clone();
    if let Some(corners) = &mut new.polygon {
        for corner in corners {
            *corner = tidy(DVec3::new(corner[0] + way.x, corner[1] + way.y, corner[2]));
        }
        return Some(abutment(number, new));
    }
    let girder = scene.girders.iter().find(|g| g.name == new.faces)?;
    let along = (placed::axes(girder).x_axis * new.end.sign()).truncate();
    let [a, b, ..] = placed::end_face(girder, new.end);
    let side = (a - b).truncate().normalize_or_zero();
    // way = u along + v side: the two are not square to each other on a skewed girder.
    let area = along.perp_dot(side);
    if area.abs() < 1e-9 {
        return None;
    }
    let (u, v) = (way.perp_dot(side) / area, along.perp_dot(way) / area);
    new.gap = Some(micrometres(new.gap? + u).max(0.0));
    new.offset = Some(micrometres(new.offset.unwrap_or(0.0) + v)).filter(|o| *o != 0.0);
    Some(abutment(number, new))
}

/// How far a wall reaches along a direction \[m\].
pub(super) fn wall_end(scene: &Scene, abutment: &Abutment, along: DVec3) -> Option<f64> {
    let block = abutment_block(scene, abutment)?;
    block.corners().iter().map(|c| c.dot(along)).reduce(f64::max)
}

/// An abutment before the first end, of the chosen girder or of any, that faces nobody yet.
pub(in crate::app) fn add_abutment(scene: &Scene, before: Option<usize>) -> Option<Edit> {
    let free = free_ends(scene);
    let (i, end) = free.iter().find(|(i, _)| Some(*i) == before).or(free.first()).copied()?;
    Some(Edit::AddAbutment(scene.abutments.len(), Box::new(abutment_before(scene, i, end))))
}

/// Ends of girders that face nobody.
pub(in crate::app) fn free_ends(scene: &Scene) -> Vec<(usize, End)> {
    let pairs = facing::find(scene).unwrap_or_default();
    let taken = |side: Side| pairs.iter().any(|p| p.first == side || p.second == side);
    let ends = (0..scene.girders.len()).flat_map(|i| End::BOTH.into_iter().map(move |end| (i, end)));
    ends.filter(|&(i, end)| !taken(Side::Girder(i, end))).collect()
}

/// An abutment before an end of a girder, at the scene's own gap.
pub(in crate::app) fn abutment_before(scene: &Scene, girder: usize, end: End) -> Abutment {
    Abutment {
        delay: None,
        motion_factor: None,
        ground: None,
        backfill: None,
        name: free_name(scene, "abutment"),
        faces: scene.girders[girder].name.clone(),
        end,
        gap: Some(gap_of(scene).unwrap_or(scene.girders[girder].length / 600.0)),
        width: None,
        height: None,
        offset: None,
        polygon: None,
        depth: None,
    }
}
