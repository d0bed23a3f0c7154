//! What a click in the 3D view does: select, or put a girder or an abutment there.

use egui::{CursorIcon, Response, Shape, Stroke, Ui};
use glam::DVec3;

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::edits;
use crate::app::style::theme::Palette;
use crate::app::viewport::gizmo::{self, Eye};
use crate::scene::Scene;
use crate::scene::edit::Edit;
use crate::view::block::{Block, abutment_block, girder_block};

/// What the mouse does in the 3D view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Selects, and moves what is selected.
    #[default]
    Select,
    /// Puts a girder where it is clicked.
    Girder,
    /// Puts an abutment before the nearest free end.
    Abutment,
}

/// Something that would be placed by a click here.
struct Ghost {
    edit: Edit,
    block: Block,
    words: String,
}

/// Shows what a click would place, and places it.
pub(in crate::app) fn show(ui: &Ui, response: &Response, bench: &Workbench, out: &mut Vec<Command>) {
    let Some((at, &camera)) = response.hover_pos().or(response.interact_pointer_pos()).zip(bench.camera()) else {
        return;
    };
    if bench.tool() == Tool::Select {
        return;
    }
    let eye = &Eye { camera, rect: response.rect };
    ui.set_cursor_icon(CursorIcon::Crosshair);
    let free = ui.input(|i| i.modifiers.command);
    let scene = bench.scene();
    let level = scene.girders.first().map_or(0.0, |g| g.position[2]);
    let Some(there) = eye.on_level(at, level) else { return };
    let found = match bench.tool() {
        Tool::Select => None,
        Tool::Girder => girder(bench, there, eye.metres_per_point(there), free),
        Tool::Abutment => abutment(scene, there),
    };
    let Some(ghost) = found else { return };
    draw(ui, eye, &ghost.block);
    gizmo::say(ui, eye, at, &[ghost.words]);
    if response.clicked() {
        out.push(Command::Place(ghost.edit));
    }
}

fn girder(bench: &Workbench, there: DVec3, point: f64, free: bool) -> Option<Ghost> {
    let scene = bench.scene();
    let edit = edits::add_girder(scene, bench.selection.girders().last());
    let Edit::AddGirder(at, mut new) = edit else { return None };
    new.position = edits::tidy(there.with_z(new.position[2]));
    let (way, words) = gizmo::snapped(scene, &new, point, free);
    new.position = edits::tidy(DVec3::from(new.position) + way);
    let place = format!(
        "{}   x {}   y {}",
        new.name,
        crate::app::text::length(new.position[0]),
        crate::app::text::length(new.position[1])
    );
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
    let words = format!("{} before {} {}", new.name, new.faces, end.label());
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
