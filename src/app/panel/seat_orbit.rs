//! The corner's orbit over its seat, drawn in the window: seat, front edge, orbit from light to dark through time, the corner at the
//! time shown.

use egui::{Align2, Color32, Pos2, Rect, Sense, Stroke, TextStyle, Ui, Vec2, pos2};

use crate::app::style::theme::Palette;
use crate::app::text;
use crate::sim::History;
use crate::sim::seats::{OrbitPoint, Seat};

/// Height of a picture \[points\].
const HEIGHT: f32 = 130.0;
/// Air around an orbit, in parts of its extent.
const AIR: f64 = 0.08;

/// A corner of a seat in the picture: from along and remaining \[m\] to points.
struct Panel {
    rect: Rect,
    low: [f64; 2],
    /// Points a metre.
    scale: f64,
}

impl Panel {
    /// To scale, with the orbit, the corner as placed and the front edge inside.
    fn of(rect: Rect, seat: &Seat, which: usize, orbit: &[OrbitPoint]) -> Self {
        let placed = seat.ledge.place_along(which, glam::DVec3::ZERO);
        let start = [[placed, placed], [0.0, seat.ledge.placed()]];
        let [along, remaining] = [0, 1].map(|axis| {
            orbit.iter().map(|point| point.corners[which][axis]).fold(start[axis], |[a, b], v| [a.min(v), b.max(v)])
        });
        let size = [rect.width(), rect.height()].map(f64::from);
        let spans = [along, remaining].map(|[a, b]| ((b - a) * (1.0 + 2.0 * AIR)).max(1e-9));
        let scale = (size[0] / spans[0]).min(size[1] / spans[1]);
        let low = [0, 1].map(|axis| {
            let [a, b] = [along, remaining][axis];
            f64::midpoint(a, b) - 0.5 * size[axis] / scale
        });
        Self { rect, low, scale }
    }

    #[expect(clippy::cast_possible_truncation, reason = "points of a picture")]
    fn at(&self, [along, remaining]: [f64; 2]) -> Pos2 {
        let [x, y] = [along - self.low[0], remaining - self.low[1]].map(|metres| (metres * self.scale) as f32);
        pos2(self.rect.left() + x, self.rect.bottom() - y)
    }
}

/// Shows both corners of an end over their seat; the time shown is `t` \[s\].
pub(super) fn show(ui: &mut Ui, history: &History, (girder, seat): (usize, &Seat), orbit: &[OrbitPoint], t: f64) {
    let now = history.seats().corners_at(girder, &seat.ledge, t);
    ui.horizontal(|ui| {
        let width = 0.5 * (ui.available_width() - ui.spacing().item_spacing.x);
        for (which, (corner, here)) in seat.corners.iter().zip(now).enumerate() {
            let (rect, response) = ui.allocate_exact_size(Vec2::new(width, HEIGHT), Sense::hover());
            let panel = Panel::of(rect, seat, which, orbit);
            draw(ui, &panel, seat, orbit, (which, here));
            let font = TextStyle::Small.resolve(ui.style());
            let place = rect.left_top() + Vec2::splat(4.0);
            ui.painter().text(place, Align2::LEFT_TOP, text::orbit_corner(corner.corner), font, Palette::of(ui).weak);
            response.on_hover_text(text::orbit_of(corner.corner));
        }
    });
}

fn draw(ui: &Ui, panel: &Panel, seat: &Seat, orbit: &[OrbitPoint], (which, now): (usize, [f64; 2])) {
    let (painter, palette) = (ui.painter_at(panel.rect), Palette::of(ui));
    let half = seat.ledge.side.map_or(1e6, |side| seat.ledge.half_end + side);
    let ledge = Rect::from_two_pos(panel.at([-half, seat.ledge.placed()]), panel.at([half, 0.0])).intersect(panel.rect);
    painter.rect_filled(ledge, 0.0, ui.visuals().faint_bg_color);
    let edge = panel.at([0.0, 0.0]).y;
    painter.hline(ledge.x_range(), edge, Stroke::new(2.0, palette.problem));
    let ink = ui.visuals().text_color();
    for (number, pair) in orbit.windows(2).enumerate() {
        let part = number as f32 / orbit.len() as f32;
        let ends = [panel.at(pair[0].corners[which]), panel.at(pair[1].corners[which])];
        painter.line_segment(ends, Stroke::new(1.0, ink.gamma_multiply(0.25 + 0.6 * part)));
    }
    let least = orbit.iter().min_by(|a, b| a.corners[which][1].total_cmp(&b.corners[which][1]));
    if let Some(point) = least {
        painter.circle_stroke(panel.at(point.corners[which]), 4.0, Stroke::new(1.5, ink));
    }
    let color: Color32 = if now[1] < 0.0 { palette.problem } else { ink };
    painter.circle_filled(panel.at(now), 3.5, color);
}
