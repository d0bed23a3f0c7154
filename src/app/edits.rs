//! From what a hand does to the edits of [`scene::edit`](crate::scene::edit) that do it.

use glam::DVec3;

use crate::geometry::End;
use crate::scene::edit::{Edit, General, free_name};
use crate::scene::facing::{self, Side};
use crate::scene::{
    Abutment, ContactSettings, Girder, ImpactSettings, Initial, Kind, ModelSettings, Motion, Push, STANDARD_GRAVITY,
    Scene, Seat, SolverSettings, ViewSettings, placed,
};
use crate::view::Target;
use crate::view::block::abutment_block;

/// What undo calls an edit.
pub(super) fn label(edit: &Edit, scene: &Scene) -> String {
    let girder = |i: &usize| scene.girders.get(*i).map_or("girder", |g| g.name.as_str());
    let abutment = |i: &usize| scene.abutments.get(*i).map_or("abutment", |a| a.name.as_str());
    match edit {
        Edit::AddGirder(_, new) => format!("add {}", new.name),
        Edit::AddAbutment(_, new) => format!("add {}", new.name),
        Edit::RemoveGirder(i) => format!("remove {}", girder(i)),
        Edit::RemoveAbutment(i) => format!("remove {}", abutment(i)),
        Edit::MoveGirder(i, ..) => format!("move {}", girder(i)),
        Edit::ReplaceGirder(i, _) => format!("change {}", girder(i)),
        Edit::ReplaceAbutment(i, _) => format!("change {}", abutment(i)),
        Edit::Rename(from, to) => format!("rename {from} to {to}"),
        Edit::Contact(_) => "change contact".into(),
        Edit::Motion(_) => "change ground motion".into(),
        Edit::Model(_) => "change model".into(),
        Edit::Impact(_) => "change impact numbers".into(),
        Edit::Scene(other) => format!("open {}", other.name),
        Edit::General(_) | Edit::Solver(_) | Edit::View(_) | Edit::Set(_) => "change scene".into(),
        Edit::Batch(edits) => edits.first().map_or_else(|| "nothing".into(), |first| label(first, scene)),
    }
}

/// Gives a girder other numbers.
pub(super) fn girder(i: usize, girder: Girder) -> Edit {
    Edit::ReplaceGirder(i, Box::new(girder))
}

/// Gives an abutment other numbers.
pub(super) fn abutment(i: usize, abutment: Abutment) -> Edit {
    Edit::ReplaceAbutment(i, Box::new(abutment))
}

/// Turns the ends of one girder, or of all.
pub(super) fn skew(scene: &Scene, one: Option<usize>, skew_deg: f64) -> Edit {
    let turned = scene.girders.iter().enumerate().filter(|(i, _)| one.is_none_or(|one| one == *i));
    Edit::Batch(turned.map(|(i, g)| girder(i, Girder { skew_deg, ..g.clone() })).collect())
}

/// Gives the contact other numbers.
pub(super) fn contact(contact: ContactSettings) -> Edit {
    Edit::Contact(Box::new(contact))
}

/// Moves the ground otherwise.
pub(super) fn motion(motion: Motion) -> Edit {
    Edit::Motion(Box::new(motion))
}

/// Runs longer or shorter \[s\].
pub(super) fn duration(scene: &Scene, duration: f64) -> Edit {
    Edit::General(Box::new(General { duration, ..General::of(scene) }))
}

/// The gap of the first facing pair, which the slider shows \[m\].
pub(super) fn gap_of(scene: &Scene) -> Option<f64> {
    facing::find(scene).ok()?.first().map(|f| f.gap)
}

/// Opens every facing pair to the same gap: abutments by their own number, girders by standing farther apart \[m\].
pub(super) fn gap(scene: &Scene, gap: f64) -> Edit {
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
            (Side::Abutment(_), _) => {}
        }
    }
    let moved = scene.girders.iter().zip(shift).enumerate();
    edits.extend(moved.filter_map(|(i, (g, shift))| {
        Some(Edit::MoveGirder(i, tidy(DVec3::from(g.position) + shift?), g.heading_deg))
    }));
    Edit::Batch(edits)
}

/// A place in whole micrometres: it will be read in a file.
fn tidy(place: DVec3) -> [f64; 3] {
    place.to_array().map(|v| (v * 1e6).round() / 1e6)
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
pub(super) fn rename(scene: &Scene, target: Target, name: String) -> Option<Edit> {
    let old = match target {
        Target::Girder(i) => scene.girders.get(i).map(|g| g.name.clone()),
        Target::Abutment(i) => scene.abutments.get(i).map(|a| a.name.clone()),
        Target::Contact(_) => None,
    };
    old.map(|old| Edit::Rename(old, name))
}

/// Removes something.
pub(super) fn remove(target: Target) -> Option<Edit> {
    match target {
        Target::Girder(i) => Some(Edit::RemoveGirder(i)),
        Target::Abutment(i) => Some(Edit::RemoveAbutment(i)),
        Target::Contact(_) => None,
    }
}

/// The name without the number at its end, so that copies count on.
fn stem(name: &str) -> &str {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.is_empty() { name } else { stem }
}

/// A copy of a girder beyond the `+x` end of the row, one gap away.
pub(super) fn add_girder(scene: &Scene, like: Option<usize>) -> Edit {
    let model = like.and_then(|i| scene.girders.get(i)).or(scene.girders.last());
    let mut new = model.cloned().unwrap_or_else(first_girder);
    new.name = free_name(scene, stem(&new.name));
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
    Edit::AddGirder(scene.girders.len(), Box::new(new))
}

/// How far a wall reaches along a direction \[m\].
fn wall_end(scene: &Scene, abutment: &Abutment, along: DVec3) -> Option<f64> {
    let block = abutment_block(scene, abutment)?;
    block.corners().iter().map(|c| c.dot(along)).reduce(f64::max)
}

/// A scene with nothing in it.
pub(super) fn empty() -> Scene {
    Scene {
        format: crate::scene::format::VERSION,
        name: super::text::UNTITLED.into(),
        description: String::new(),
        kind: Kind::default(),
        duration: 5.0,
        gravity: STANDARD_GRAVITY,
        model: ModelSettings::default(),
        girders: Vec::new(),
        abutments: Vec::new(),
        contact: ContactSettings::default(),
        impact: ImpactSettings::default(),
        motion: Motion::default(),
        solver: SolverSettings::default(),
        view: ViewSettings::default(),
    }
}

/// The paper's straight girder, where nothing is placed that could be copied.
fn first_girder() -> Girder {
    Girder {
        name: "girder".into(),
        length: 0.190,
        width: 0.070,
        thickness: 0.020,
        skew_deg: 90.0,
        mass: 2.0,
        position: [0.0; 3],
        heading_deg: 0.0,
        bearings: None,
        initial: Initial::default(),
        push: Push::default(),
        held: Vec::new(),
        seat: Seat::default(),
    }
}

/// An abutment before the first end, of the chosen girder or of any, that faces nobody yet.
pub(super) fn add_abutment(scene: &Scene, before: Option<usize>) -> Option<Edit> {
    let pairs = facing::find(scene).unwrap_or_default();
    let taken = |side: Side| pairs.iter().any(|p| p.first == side || p.second == side);
    let ends = |i: usize| End::BOTH.into_iter().map(move |end| (i, end));
    let order = before.into_iter().chain(0..scene.girders.len());
    let (i, end) = order.flat_map(ends).find(|&(i, end)| !taken(Side::Girder(i, end)))?;
    let gap = gap_of(scene).unwrap_or(scene.girders[i].length * 0.016);
    let new = Abutment {
        name: free_name(scene, "abutment"),
        faces: scene.girders[i].name.clone(),
        end,
        gap: Some(gap),
        width: None,
        height: None,
        offset: None,
        polygon: None,
        depth: None,
    };
    Some(Edit::AddAbutment(scene.abutments.len(), Box::new(new)))
}
