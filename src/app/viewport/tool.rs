//! Effect of a click in the 3D view: a selection, or a new girder or abutment there.

use egui::{CursorIcon, Response, Shape, Stroke, Ui};
use glam::DVec3;

use crate::app::command::{Command, PlaceCommand, Tool};
use crate::app::edits;
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::viewport::eye::Eye;
use crate::app::viewport::gizmo;
use crate::app::viewport::seen::Seen;
use crate::scene::Scene;
use crate::scene::edit::Edit;
use crate::view::Target;
use crate::view::block::{Block, abutment_block, girder_block};

/// Something that would be placed by a click here.
struct Ghost {
    edit: Edit,
    block: Block,
    words: String,
}

/// Shows what a click would place, and places it.
pub(in crate::app) fn show(ui: &Ui, eye: &Eye, response: &Response, seen: &Seen<'_>, out: &mut Vec<Command>) {
    let Some(at) = response.hover_pos().or(response.interact_pointer_pos()) else { return };
    if seen.display.tool == Tool::Select {
        return;
    }
    ui.set_cursor_icon(CursorIcon::Crosshair);
    let free = ui.input(|i| i.modifiers.command);
    let scene = seen.scene;
    let level = scene.girders.first().map_or(0.0, |g| g.position[2]);
    let Some(there) = eye.on_level(at, level) else { return };
    let found = match seen.display.tool {
        Tool::Select => None,
        Tool::Girder => girder(seen, there, eye.metres_per_point(there), free),
        Tool::Abutment => abutment(scene, there),
    };
    let Some(ghost) = found else { return };
    draw(ui, eye, &ghost.block);
    gizmo::say(ui, eye, at, &[ghost.words]);
    if response.clicked() {
        out.push(PlaceCommand::Put(ghost.edit).into());
    }
}

fn girder(seen: &Seen<'_>, there: DVec3, point: f64, free: bool) -> Option<Ghost> {
    let scene = seen.scene;
    let girder = seen.selection.iter().rev().find_map(|t| if let Target::Girder(i) = t { Some(*i) } else { None });
    let edit = edits::add_girder(scene, girder);
    let Edit::AddGirder(at, mut new) = edit else { return None };
    new.position = edits::tidy(there.with_z(new.position[2]));
    let (way, words) = gizmo::snapped(scene, &new, point, free);
    new.position = edits::tidy(DVec3::from(new.position) + way);
    let place = format!("{}   x {}   y {}", new.name, text::length(new.position[0]), text::length(new.position[1]));
    let words = std::iter::once(place).chain(words).collect::<Vec<_>>().join("\n");
    Some(Ghost { block: girder_block(&new), edit: Edit::AddGirder(at, new), words })
}

/// An abutment before the free end that is nearest.
fn abutment(scene: &Scene, there: DVec3) -> Option<Ghost> {
    let free = edits::free_ends(scene).into_iter().map(|(i, end)| {
        let face = crate::scene::placed::end_face(&scene.girders[i], end);
        (face.iter().sum::<DVec3>() / 4.0, i, end)
    });
    let (_, i, end) = free.min_by(|a, b| a.0.distance_squared(there).total_cmp(&b.0.distance_squared(there)))?;
    let new = edits::abutment_before(scene, i, end);
    let block = abutment_block(scene, &new)?;
    let words = text::abutment_before(&new.name, &new.faces, end.label());
    Some(Ghost { edit: Edit::AddAbutment(scene.abutments.len(), Box::new(new)), block, words })
}

fn draw(ui: &Ui, eye: &Eye, block: &Block) {
    let painter = ui.painter().with_clip_rect(eye.rect);
    let color = Palette::of(ui).x;
    for [from, to] in block.edges() {
        if let Some((a, b)) = eye.at(from).zip(eye.at(to)).filter(|(a, b)| a.distance(*b) < 4e3) {
            painter.extend(Shape::dashed_line(&[a, b], Stroke::new(1.5, color), 6.0, 4.0));
        }
    }
}
