//! How handles look: a shape for each kind, a plate with what is pulled, the scene's outline where it cannot be run.

use egui::{Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Ui, Vec2, pos2, vec2};
use glam::DVec3;

use super::handles::Handle;
use super::pull::Pulled;
use crate::app::command::Grip;
use crate::app::style::theme::Palette;
use crate::app::viewport::eye::Eye;
use crate::app::viewport::seen::Seen;
use crate::view::block::{abutment_block, girder_block};

/// Length of a moving arrow \[points\].
const ARROW: f32 = 42.0;

/// From a girder's side to the knob that turns it \[points\].
const STEM: f32 = 26.0;

/// From the gap to its knob \[points\].
const ASIDE: f32 = 16.0;

/// Where a handle stands on the screen: beside the line that it changes, so that the line stays in view.
pub(super) fn place(eye: &Eye, handle: &Handle) -> Option<Pos2> {
    let at = eye.at(handle.at)?;
    let way = eye.way(handle.at, handle.along);
    let aside = match handle.grip {
        Grip::Along(_) | Grip::Across(_) | Grip::Offset(_) => ARROW,
        Grip::Length(..) => -14.0,
        Grip::Gap(_) => ASIDE,
        Grip::Turn(_) => return Some(at + eye.way(handle.at, DVec3::Z.cross(-handle.along)) * STEM),
        _ => 0.0,
    };
    Some(at + way * aside)
}

/// Draws a handle; `look` is whether the mouse or the focus is on it, and whether it is held.
pub(super) fn handle(ui: &Ui, eye: &Eye, handle: &Handle, at: Pos2, (near, held): (bool, bool)) {
    let painter = ui.painter().with_clip_rect(eye.rect);
    let palette = Palette::of(ui);
    let hot = ui.visuals().selection.bg_fill;
    let fill = if near || held { hot } else { palette.view };
    let line = Stroke::new(if near || held { 2.0 } else { 1.5 }, palette.force);
    let way = eye.way(handle.at, handle.along);
    match handle.grip {
        Grip::Along(_) => arrow(&painter, eye, handle, at, (palette.x, near)),
        Grip::Across(_) | Grip::Offset(_) => arrow(&painter, eye, handle, at, (palette.y, near)),
        Grip::Turn(_) => {
            if let Some(foot) = eye.at(handle.at) {
                painter.line_segment([foot, at], Stroke::new(1.0, palette.force));
            }
            painter.circle(at, 6.0, fill, line);
            painter.circle_filled(at, 1.8, palette.force);
        }
        Grip::Length(..) | Grip::Width(..) | Grip::FaceWidth(..) | Grip::PierHeight(_) | Grip::PierColumn(_) => {
            quad(&painter, at, way, (5.0, 5.0), fill, line);
        }
        Grip::Skew(..) => quad(&painter, at, (way + way.rot90()).normalized(), (4.5, 4.5), fill, line),
        Grip::Gap(_) => {
            double_arrow(&painter, at, way, line);
        }
        Grip::DevicePoint(..) => {
            painter.circle(at, 6.0, fill, line);
        }
        Grip::Bodies => {}
    }
}

fn arrow(painter: &Painter, eye: &Eye, handle: &Handle, tip: Pos2, (color, near): (Color32, bool)) {
    let Some(from) = eye.at(handle.at) else { return };
    let way = (tip - from).normalized();
    let width = if near { 3.5 } else { 2.2 };
    painter.line_segment([from + way * 6.0, tip - way * 6.0], Stroke::new(width, color));
    let side = way.rot90() * 5.5;
    let head = vec![tip + way * 4.0, tip - way * 8.0 + side, tip - way * 8.0 - side];
    painter.add(Shape::convex_polygon(head, color, Stroke::NONE));
}

fn quad(painter: &Painter, at: Pos2, way: Vec2, (a, b): (f32, f32), fill: Color32, line: Stroke) {
    let (u, v) = (way * a, way.rot90() * b);
    painter.add(Shape::convex_polygon(vec![at + u + v, at - u + v, at - u - v, at + u - v], fill, line));
}

fn double_arrow(painter: &Painter, at: Pos2, way: Vec2, line: Stroke) {
    for sign in [-1.0, 1.0] {
        let tip = at + way * (sign * 8.0);
        let side = way.rot90() * 4.5;
        let back = way * (sign * 5.0);
        painter.add(Shape::convex_polygon(vec![tip, tip - back + side, tip - back - side], line.color, Stroke::NONE));
    }
    painter.line_segment([at - way * 5.0, at + way * 5.0], line);
}

/// The lines that a pull snapped to, and its numbers beside the mouse.
pub(super) fn pulled(ui: &Ui, eye: &Eye, pulled: &Pulled) {
    let painter = ui.painter().with_clip_rect(eye.rect);
    let palette = Palette::of(ui);
    for [from, to] in &pulled.guides {
        if let Some((a, b)) = eye.at(*from).zip(eye.at(*to)) {
            painter.extend(Shape::dashed_line(&[a, b], Stroke::new(1.2, palette.x), 6.0, 4.0));
        }
    }
    if let Some(at) = ui.input(|i| i.pointer.latest_pos()) {
        plate(&painter, eye.rect, at, &pulled.words, &palette);
    }
}

/// Words on a plate beside a place, inside the view.
pub(super) fn plate(painter: &Painter, room: Rect, at: Pos2, words: &[String], palette: &Palette) {
    let galley = painter.layout_no_wrap(words.join("\n"), FontId::proportional(12.5), palette.force);
    let size = galley.size() + vec2(12.0, 8.0);
    let left = (at.x + 18.0).min(room.right() - size.x - 4.0).max(room.left() + 4.0);
    let top = (at.y + 14.0).min(room.bottom() - size.y - 4.0).max(room.top() + 4.0);
    let plate = Rect::from_min_size(pos2(left, top), size);
    painter.rect(plate, 3.0, palette.track, Stroke::new(1.0, palette.line), egui::StrokeKind::Inside);
    painter.galley(plate.min + vec2(6.0, 4.0), galley, palette.force);
}

/// The scene as it is edited, where the answer in view is an older one; dashed, in the colour of complaints when it
/// cannot be run.
pub(super) fn outlines(ui: &Ui, eye: &Eye, seen: &Seen<'_>) {
    if !seen.is_stale() || seen.answer().is_none() {
        return;
    }
    let palette = Palette::of(ui);
    let color = if seen.runner.problems().is_some() { palette.problem } else { palette.force };
    let painter = ui.painter().with_clip_rect(eye.rect);
    let scene = seen.scene;
    let girders = scene.girders.iter().map(girder_block);
    let walls = scene.abutments.iter().filter_map(|a| abutment_block(scene, a));
    for edges in girders.chain(walls).take(64).map(|block| block.edges()) {
        for [from, to] in edges {
            if let Some((a, b)) = eye.at(from).zip(eye.at(to)).filter(|(a, b)| a.distance(*b) < 4e3) {
                painter.extend(Shape::dashed_line(&[a, b], Stroke::new(1.2, color), 5.0, 4.0));
            }
        }
    }
}
