//! The picture of a map: cells, axes, colour bar, the scene's own point; the cell under the mouse or the keys.

use egui::epaint::{Mesh, TextShape, Vertex, WHITE_UV};
use egui::{Align2, Color32, EventFilter, FontId, Key, Painter, Pos2, Rect, Response, Role, Sense, Stroke, Ui};
use egui::{WidgetInfo, pos2, vec2};

use super::maps::{Map, Maps};
use super::offer;
use crate::app::command::{Command, MapCommand};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::unit::Unit;
use crate::plot::Colors;
use crate::plot::chart::{range, ticks};
use crate::plot::color_map::{LEVELS, level};
use crate::scene::Scene;
use crate::study::sweep::Status;

/// Room for the numbers of the upright axis, and for those of the level one with its name \[points\].
const MARGIN: [f32; 2] = [58.0, 40.0];
/// Room above the field, for names \[points\].
const ABOVE: f32 = 20.0;
/// Room for the colour bar with its numbers, and its width \[points\].
const BAR: [f32; 2] = [86.0, 14.0];
/// Numbers along an axis.
const LABELS: usize = 5;

/// Where the cells of a map are.
#[derive(Clone, Copy)]
struct Cells {
    rect: Rect,
    counts: [usize; 2],
}

impl Cells {
    /// Lower left corner and size of a cell \[points\].
    fn rect(self, [x, y]: [usize; 2]) -> Rect {
        let size = vec2(self.rect.width() / self.counts[0] as f32, self.rect.height() / self.counts[1] as f32);
        let corner = pos2(self.rect.left() + size.x * x as f32, self.rect.bottom() - size.y * (y + 1) as f32);
        Rect::from_min_size(corner, size)
    }

    /// The cell at a place.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside of the field")]
    fn at(self, place: Pos2) -> Option<[usize; 2]> {
        let inside = self.rect.contains(place);
        let part = (place - self.rect.left_bottom()) / self.rect.size();
        let cell = [part.x, -part.y].map(|part| part.clamp(0.0, 1.0));
        let number = |axis: usize| ((cell[axis] * self.counts[axis] as f32) as usize).min(self.counts[axis] - 1);
        inside.then(|| [number(0), number(1)])
    }
}

/// Shows a map over the rest of the room, and what the mouse and the keys do on it.
pub(super) fn show(ui: &mut Ui, maps: &Maps, map: &Map, scene: &Scene, out: &mut Vec<Command>) {
    let room = ui.available_size();
    let (area, _) = ui.allocate_exact_size(room, Sense::hover());
    let field = Rect::from_min_max(
        area.min + vec2(MARGIN[0], ABOVE),
        pos2(
            (area.right() - BAR[0]).max(area.left() + MARGIN[0] + 40.0),
            (area.bottom() - MARGIN[1]).max(area.top() + ABOVE + 40.0),
        ),
    );
    let cells = Cells { rect: field, counts: map.grid.counts() };
    let response = ui.interact(field, ui.scope_id().with("map"), Sense::click());
    let title = text::map_of(&map.measure(0).title());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &title));
    let palette = Palette::of(ui);
    let colors = range(values(map));
    draw_cells(ui.painter(), cells, map, colors, &palette);
    let units = [0, 1].map(|axis| offer::unit(scene, &map.draft.axes[axis].key, map.value_at(axis, 0)));
    draw_axes(ui.painter(), (area, cells), map, units, &palette);
    draw_bar(ui.painter(), (area, field), map, colors, &palette);
    if let Some(at) = own_point(cells, map, maps.own()) {
        ring(ui.painter(), at);
    }
    let cursor = keyed(ui, &response, cells.counts, out);
    let hovered = response.hover_pos().and_then(|place| cells.at(place));
    if let Some(cell) = hovered.or(cursor) {
        outline(ui.painter(), cells.rect(cell));
        let words = said(map, cell, units);
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(words.as_str()));
        let at = response.hover_pos().unwrap_or(cells.rect(cell).center());
        plate(ui.painter(), area, at, words, &palette);
    }
    if let Some(cell) = response.interact_pointer_pos().filter(|_| response.clicked()).and_then(|at| cells.at(at)) {
        out.push(MapCommand::Go(cell).into());
    }
}

/// Values that have come out, in the unit of pictures.
fn values(map: &Map) -> impl Iterator<Item = f64> {
    let factor = map.measure(0).drawn.1;
    map.rows.values().filter_map(move |row| Some(row.values[0]? * factor))
}

fn draw_cells(painter: &Painter, cells: Cells, map: &Map, colors: [f64; 2], palette: &Palette) {
    painter.rect_filled(cells.rect, 0.0, palette.track);
    let mut mesh = Mesh::default();
    for cell in (0..cells.counts[0]).flat_map(|x| (0..cells.counts[1]).map(move |y| [x, y])) {
        let Some(row) = map.standing_for(cell) else { continue };
        let fill = row.values[0].map_or(palette.line, |value| {
            let [r, g, b] = Colors::Even.rgb(level(value * map.measure(0).drawn.1, colors));
            Color32::from_rgb(r, g, b)
        });
        quad(&mut mesh, cells.rect(cell), fill);
    }
    painter.add(mesh);
}

/// Without a blurred edge, so that neighbours leave no seam.
fn quad(mesh: &mut Mesh, rect: Rect, color: Color32) {
    #[expect(clippy::cast_possible_truncation, reason = "four corners a cell")]
    let first = mesh.vertices.len() as u32;
    let corners = [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom()];
    mesh.vertices.extend(corners.map(|pos| Vertex { pos, uv: WHITE_UV, color }));
    mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
}

fn draw_axes(painter: &Painter, (area, cells): (Rect, Cells), map: &Map, units: [Unit; 2], palette: &Palette) {
    let (small, field) = (FontId::proportional(11.0), cells.rect);
    let label = |axis: usize, cell: usize| units[axis].written(map.value_at(axis, cell) * units[axis].factor);
    for cell in labelled(cells.counts[0]) {
        let x = cells.rect([cell, 0]).center().x;
        painter.vline(x, field.bottom()..=field.bottom() + 4.0, Stroke::new(1.0, palette.line));
        painter.text(pos2(x, field.bottom() + 6.0), Align2::CENTER_TOP, label(0, cell), small.clone(), palette.weak);
    }
    for cell in labelled(cells.counts[1]) {
        let y = cells.rect([0, cell]).center().y;
        painter.hline(field.left() - 4.0..=field.left(), y, Stroke::new(1.0, palette.line));
        painter.text(pos2(field.left() - 7.0, y), Align2::RIGHT_CENTER, label(1, cell), small.clone(), palette.weak);
    }
    let name = |axis: usize| text::with_unit(&text::title_of(&map.draft.axes[axis].key), units[axis].suffix);
    painter.text(pos2(field.center().x, area.bottom()), Align2::CENTER_BOTTOM, name(0), small.clone(), palette.force);
    let upright = painter.layout_no_wrap(name(1), small, palette.force);
    let foot = pos2(area.left(), field.center().y + 0.5 * upright.size().x);
    painter.add(TextShape::new(foot, upright, palette.force).with_angle(-std::f32::consts::FRAC_PI_2));
}

/// Which of so many cells are labelled: evenly spaced, both ends among them where that fits.
fn labelled(count: usize) -> impl Iterator<Item = usize> {
    (0..count).step_by((count.max(2) - 1).div_ceil(LABELS - 1))
}

fn draw_bar(painter: &Painter, (area, field): (Rect, Rect), map: &Map, colors: [f64; 2], palette: &Palette) {
    let left = field.right() + 14.0;
    let bar = Rect::from_min_max(pos2(left, field.top()), pos2(left + BAR[1], field.bottom()));
    let mut mesh = Mesh::default();
    let part = bar.height() / (f32::from(LEVELS) + 1.0);
    for level in 0..=LEVELS {
        let [r, g, b] = Colors::Even.rgb(level);
        let bottom = bar.bottom() - part * f32::from(level);
        let step = Rect::from_min_max(pos2(bar.left(), bottom - part), pos2(bar.right(), bottom));
        quad(&mut mesh, step, Color32::from_rgb(r, g, b));
    }
    painter.add(mesh);
    let (small, [low, high]) = (FontId::proportional(11.0), colors);
    for value in ticks(colors, 6.0) {
        #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
        let y = bar.bottom() - bar.height() * ((value - low) / (high - low)) as f32;
        painter.hline(bar.right()..=bar.right() + 3.0, y, Stroke::new(1.0, palette.line));
        let at = pos2(bar.right() + 6.0, y);
        painter.text(at, Align2::LEFT_CENTER, text::short(value), small.clone(), palette.weak);
    }
    let title = map.measure(0).title();
    painter.text(area.right_top(), Align2::RIGHT_TOP, title, small, palette.force);
}

/// Where the scene itself is; none outside.
fn own_point(cells: Cells, map: &Map, own: [Option<f64>; 2]) -> Option<Pos2> {
    let place = |axis: usize| {
        let (limits, value) = (&map.draft.axes[axis], own[axis]?);
        let scaled = |value: f64| if limits.is_log { value.abs().ln() } else { value };
        let part = (scaled(value) - scaled(limits.from)) / (scaled(limits.to) - scaled(limits.from));
        let last = cells.counts[axis] as f64 - 1.0;
        let sign = !limits.is_log || value * limits.from > 0.0;
        #[expect(clippy::cast_possible_truncation, reason = "inside of the field")]
        let cell = (part * last + 0.5) as f32 / cells.counts[axis] as f32;
        (sign && (-0.5 / last..=1.0 + 0.5 / last).contains(&part)).then_some(cell)
    };
    let (x, y) = (place(0)?, place(1)?);
    let field = cells.rect;
    Some(pos2(field.left() + field.width() * x, field.bottom() - field.height() * y))
}

/// A ring that is seen on every colour.
pub(super) fn ring(painter: &Painter, at: Pos2) {
    painter.circle_stroke(at, 6.0, Stroke::new(4.0, Color32::WHITE));
    painter.circle_stroke(at, 6.0, Stroke::new(1.6, Color32::from_rgb(0x22, 0x22, 0x22)));
}

fn outline(painter: &Painter, rect: Rect) {
    let rect = rect.expand(1.0);
    painter.rect_stroke(rect, 1.0, Stroke::new(3.0, Color32::WHITE), egui::StrokeKind::Middle);
    painter.rect_stroke(rect, 1.0, Stroke::new(1.0, Color32::from_rgb(0x22, 0x22, 0x22)), egui::StrokeKind::Middle);
}

/// Words beside a place, inside the room.
fn plate(painter: &Painter, room: Rect, at: Pos2, words: String, palette: &Palette) {
    let galley = painter.layout_no_wrap(words, FontId::proportional(12.5), palette.force);
    let size = galley.size() + vec2(12.0, 8.0);
    let left = (at.x + 16.0).min(room.right() - size.x).max(room.left());
    let top = (at.y + 16.0).min(room.bottom() - size.y).max(room.top());
    let plate = Rect::from_min_size(pos2(left, top), size);
    painter.rect(plate, 3.0, palette.track, Stroke::new(1.0, palette.line), egui::StrokeKind::Inside);
    painter.galley(plate.min + vec2(6.0, 4.0), galley, palette.force);
}

/// Values of both keys at a cell, and the result of its run.
fn said(map: &Map, [x, y]: [usize; 2], units: [Unit; 2]) -> String {
    let value = |axis: usize, cell: usize| {
        format!("{} {}", text::title_of(&map.draft.axes[axis].key), units[axis].words(map.value_at(axis, cell)))
    };
    let run = match map.row([x, y]) {
        None => text::MAP_NOT_YET.to_string(),
        Some(row) if row.status == Status::Complete => row.values[0].map_or(text::MAP_NO_VALUE.to_string(), |value| {
            let measure = map.measure(0);
            text::measured(measure.label.as_str(), value * measure.drawn.1, measure.drawn.0)
        }),
        Some(row) => format!("{}: {}", row.status.word(), row.reason),
    };
    format!("{}\n{}\n{run}", value(0, x), value(1, y))
}

/// The cell that the keys are on while the map has the focus: arrows lead on, Enter opens its run.
fn keyed(ui: &Ui, response: &Response, counts: [usize; 2], out: &mut Vec<Command>) -> Option<[usize; 2]> {
    if !response.has_focus() {
        return None;
    }
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    let middle = counts.map(|count| count / 2);
    let mut cell: [usize; 2] = ui.data(|data| data.get_temp(response.id)).unwrap_or(middle);
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    let ways = [[Key::ArrowLeft, Key::ArrowRight], [Key::ArrowDown, Key::ArrowUp]];
    for (axis, [less, more]) in ways.into_iter().enumerate() {
        let on = cell[axis] + usize::from(pressed(more));
        cell[axis] = on.saturating_sub(usize::from(pressed(less))).min(counts[axis].saturating_sub(1));
    }
    ui.data_mut(|data| data.insert_temp(response.id, cell));
    if pressed(Key::Enter) {
        out.push(MapCommand::Go(cell).into());
    }
    Some(cell)
}
