//! The legend: what an arrow's length, a glyph, a cone and the grid mean. Only what the picture can show is explained, and no more of it
//! than leaves room for the picture.

use glam::Vec2;

use super::ViewInput;
use super::area::Area;
use super::bent;
use super::devices;
use super::forces::glyph;
use super::labels::text_size;
use super::list::{Mark, Rgba};
use super::moment::Moment;
use super::palette::{DAMPING, IMPULSE, NORMAL, OVERLAP, Palette, STICK, TANGENTIAL};
use super::scale::{round_down, round_force, round_impulse, round_length};
use super::seat_edges;
use super::texts::TEXT;
use super::words::{contact_state, friction_laws, section_force};
use crate::language::{Text, values};
use crate::sim::ContactState;

/// Height of a row \[points\].
const ROW: f32 = 19.0;
/// Width of the signs' column \[points\].
const SIGN: f32 = 40.0;
/// Length of the bar of a section force's colours \[points\].
const COLOR_BAR: f32 = 120.0;
/// Its parts of one colour each.
const COLOR_PARTS: u8 = 40;
/// Longest force bar \[points\].
const LONGEST_BAR: f64 = 150.0;
/// Largest part of a picture that the legend covers before it leaves out what can be spared. Chosen: of the view in a window of 1024 × 640
/// a legend with all rows covers a quarter, and without those that can be spared a ninth.
const MOST_COVERED: f32 = 0.16;

/// A row of the legend: a sign, what it means, and who needs it.
#[derive(Clone, Debug)]
struct Row {
    sign: Sign,
    text: String,
    need: Need,
}

/// Use of a row, in the order of its worth: the last are left out first where the picture is small.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Need {
    /// Reading off a value, or that something is wrong.
    Value,
    /// Telling apart what is drawn.
    State,
    /// Reading what is known from the scene, or seen by itself.
    Aside,
}

#[derive(Clone, Copy, Debug)]
enum Sign {
    None,
    Bar(f32),
    Arrow(Rgba),
    State(ContactState),
    Cone,
    /// A device whose force acts, or an idle one.
    Device(bool),
    Overlap,
    /// The front edge of a seat, so wide \[points\].
    SeatEdge(f32),
    Grid,
    Girder,
    Ghost,
    /// Colours of a section force, of both signs or of one.
    Colors(bool),
}

fn row(sign: Sign, need: Need, text: impl Into<String>) -> Row {
    Row { sign, text: text.into(), need }
}

/// The force whose bar is a round number of newtons, and the bar's length \[N, pixels\].
pub(super) fn force_bar(input: &ViewInput<'_>, moment: &Moment) -> Option<(f64, f32)> {
    let per_pixel = input.camera.metres_per_pixel(focus(input), f64::from(input.size[1])) * moment.force_scale?;
    let force = round_down(LONGEST_BAR * f64::from(input.pixels_per_point) * per_pixel);
    Some((force, (force / per_pixel) as f32))
}

/// The impulse whose bar is a round number, and the bar's length \[N·s, pixels\].
fn impulse_bar(input: &ViewInput<'_>, moment: &Moment) -> Option<(f64, f32)> {
    let per_pixel = input.camera.metres_per_pixel(focus(input), f64::from(input.size[1])) * moment.impulse_scale?;
    let impulse = round_down(LONGEST_BAR * f64::from(input.pixels_per_point) * per_pixel);
    Some((impulse, (impulse / per_pixel) as f32))
}

/// Point at which the scale is true in a perspective view, the same at all times of a run, so that a film has one bar: the node of the
/// hardest touch as placed, or the camera's target \[m\].
fn focus(input: &ViewInput<'_>) -> glam::DVec3 {
    let hardest =
        input.history.and_then(|history| Some(history.model().sites.get(history.hits().hardest()?.contact)?.point));
    hardest.unwrap_or(input.camera.target)
}

fn rows(input: &ViewInput<'_>, moment: &Moment, grid: Option<f64>) -> Vec<Row> {
    let o = input.overlays;
    let mut rows = Vec::new();
    let arrows = [
        (o.resultant, input_resultant(input), Text::new("legend-resultant")),
        (o.normal, NORMAL, Text::new("legend-normal")),
        (o.tangential, TANGENTIAL, Text::new("legend-tangential")),
        (o.damping, DAMPING, Text::new("legend-damping")),
    ];
    let shown = |(on, color, text): (bool, Rgba, Text)| on.then(|| row(Sign::Arrow(color), Need::Value, text));
    let can_touch = !moment.facings.is_empty();
    if let (true, Some((force, length))) =
        (can_touch && (o.cones || arrows.iter().any(|a| a.0)), force_bar(input, moment))
    {
        rows.push(row(Sign::Bar(length), Need::Value, round_force(force)));
        rows.extend(arrows.into_iter().filter_map(shown));
        rows.push(row(Sign::None, Need::Aside, Text::new("legend-on-owner")));
        if o.cones {
            rows.push(row(Sign::Cone, Need::Aside, Text::new("legend-cone")));
        }
    }
    if let Some((impulse, length)) = o.resultant.then(|| impulse_bar(input, moment)).flatten() {
        rows.push(row(Sign::Bar(length), Need::Value, round_impulse(impulse)));
        rows.push(row(Sign::Arrow(IMPULSE), Need::Value, Text::new("legend-impulse")));
    }
    if let Some((force, most)) = input.bent.and_then(|bent| bent.colored) {
        let (unit, size) = force.unit();
        let low = if force.is_signed() { -1.0 } else { 0.0 };
        let end = |part: f64| three(part * most / size);
        let range = values!["from" => end(low), "to" => end(1.0), "unit" => unit];
        rows.push(row(Sign::Colors(force.is_signed()), Need::Value, Text::new("legend-range").with(&range)));
        rows.push(row(Sign::None, Need::Value, section_force(force)));
    }
    if !moment.ghosts.is_empty() {
        rows.push(row(Sign::Girder, Need::State, Text::new("legend-contact-model")));
        rows.push(row(Sign::Ghost, Need::State, Text::new("legend-impact-model")));
    }
    if o.contacts && can_touch {
        rows.push(row(Sign::State(ContactState::Stick), Need::State, contact_state(ContactState::Stick)));
        rows.push(row(Sign::State(ContactState::Slip), Need::State, contact_state(ContactState::Slip)));
        rows.push(row(Sign::State(ContactState::Open), Need::Aside, Text::new("legend-opened")));
    }
    if moment.devices.iter().any(|device| !device.line.is_empty()) {
        rows.push(row(Sign::Device(true), Need::State, Text::new("legend-device-acts")));
        rows.push(row(Sign::Device(false), Need::State, Text::new("legend-device-idle")));
    }
    if moment.walls.iter().flatten().any(|wall| wall.soil.is_some()) {
        rows.push(row(Sign::None, Need::Aside, Text::new("legend-soil")));
    }
    if !moment.overlaps.is_empty() {
        rows.push(row(Sign::Overlap, Need::Value, Text::new("legend-overlap")));
    }
    if let Some(width) = seat_edges::shown(input, moment) {
        rows.push(row(Sign::SeatEdge(width), Need::State, Text::new("legend-seat-edge")));
    }
    if can_touch && !moment.laws.is_empty() {
        rows.push(row(Sign::None, Need::Aside, friction_laws(&moment.laws)));
    }
    let spacing = |g: f64| Text::new("legend-grid").with(&values!["spacing" => round_length(g)]);
    rows.extend(grid.map(|g| row(Sign::Grid, Need::Aside, spacing(g))));
    rows
}

/// A number of three digits.
fn three(value: f64) -> String {
    let digits = if value == 0.0 { 0 } else { (2 - value.abs().log10().floor() as i32).clamp(0, 6) };
    format!("{value:.*}", usize::try_from(digits).unwrap_or(0))
}

fn input_resultant(input: &ViewInput<'_>) -> Rgba {
    Palette::of(input.background).resultant
}

/// The legend at the bottom right (bridges run to the upper right in the standing views), and the area that it covers; nothing where there is nothing to explain.
pub(super) fn legend(
    input: &ViewInput<'_>,
    moment: &Moment,
    palette: &Palette,
    grid: Option<f64>,
) -> Option<(Vec<Mark>, Area)> {
    let ppp = input.pixels_per_point;
    let size = (TEXT - 1.0) * ppp;
    let pad = 10.0 * ppp;
    let picture = Vec2::from(input.size.map(|s| s as f32));
    let rows = spared(rows(input, moment, grid), |rows| {
        let room = extent(rows, ppp) + 2.0 * pad;
        room.x * room.y <= MOST_COVERED * picture.x * picture.y
    });
    if rows.is_empty() {
        return None;
    }
    let max = picture - 12.0 * ppp;
    let min = max - extent(&rows, ppp) - 2.0 * pad;
    let rim = palette.faint_ink.with_alpha(0x50);
    let mut marks = vec![Mark::Panel { min, max, color: palette.plate, rim }];
    for (i, row) in rows.iter().enumerate() {
        let at = min + Vec2::new(pad, pad + (i as f32 + 0.5) * ROW * ppp);
        sign_marks(row.sign, at, ppp, palette, &mut marks);
        let text_at = at + Vec2::new(sign_width(row, ppp), 0.0);
        let align = Vec2::new(0.0, 0.5);
        marks.push(Mark::Text { at: text_at, align, size, text: row.text.clone(), color: palette.ink, plate: None });
    }
    Some((marks, Area { min, max }))
}

/// Width and height of rows \[pixels\].
fn extent(rows: &[Row], ppp: f32) -> Vec2 {
    let width = |row: &Row| sign_width(row, ppp) + text_size(&row.text, (TEXT - 1.0) * ppp).x;
    Vec2::new(rows.iter().map(width).fold(0.0, f32::max), rows.len() as f32 * ROW * ppp)
}

/// The rows that a picture has room for: those that can be spared most go until the rest fits, values never.
fn spared(mut rows: Vec<Row>, fits: impl Fn(&[Row]) -> bool) -> Vec<Row> {
    for need in [Need::Aside, Need::State] {
        if fits(&rows) {
            break;
        }
        rows.retain(|row| row.need < need);
    }
    rows
}

/// Room for a row's sign \[pixels\].
fn sign_width(row: &Row, ppp: f32) -> f32 {
    match row.sign {
        Sign::None => 0.0,
        Sign::Bar(length) => length + 10.0 * ppp,
        Sign::Colors(_) => (COLOR_BAR + 10.0) * ppp,
        _ => SIGN * ppp,
    }
}

fn stroke(points: impl Into<Vec<Vec2>>, width: f32, color: Rgba) -> Mark {
    Mark::Stroke { points: points.into(), width, color }
}

fn sign_marks(sign: Sign, at: Vec2, ppp: f32, palette: &Palette, out: &mut Vec<Mark>) {
    let p = |x: f32, y: f32| at + Vec2::new(x, y) * ppp;
    match sign {
        Sign::None => {}
        Sign::Bar(length) => {
            let end = at + Vec2::new(length, 0.0);
            let tick = Vec2::new(0.0, 5.0 * ppp);
            out.push(stroke([at, end], 2.4 * ppp, palette.ink));
            out.extend([at, end].map(|x| stroke([x - tick, x + tick], 1.6 * ppp, palette.ink)));
        }
        Sign::Arrow(color) => {
            out.push(stroke([p(2.0, 0.0), p(20.0, 0.0)], 3.2 * ppp, color));
            out.push(Mark::Fill { points: vec![p(18.0, -5.0), p(30.0, 0.0), p(18.0, 5.0)], color });
        }
        Sign::Device(acts) => {
            let (width, color) = devices::stroke(acts, ppp, palette);
            out.push(stroke([p(2.0, 0.0), p(28.0, 0.0)], width, color));
        }
        Sign::State(state) => out.push(glyph(p(15.0, 0.0), state, ppp, palette)),
        Sign::Cone => {
            let fill = STICK.with_alpha(0x48);
            out.push(Mark::Fill { points: vec![p(15.0, 7.0), p(9.0, -7.0), p(21.0, -7.0)], color: fill });
            let outline = [p(6.0, -7.0), p(15.0, 7.0), p(24.0, -7.0)];
            out.push(stroke(outline, 1.2 * ppp, palette.faint_ink));
        }
        Sign::Overlap => {
            let outline = [p(2.0, -6.0), p(28.0, -6.0), p(28.0, 6.0), p(2.0, 6.0), p(2.0, -6.0)];
            out.push(stroke(outline, 2.2 * ppp, OVERLAP));
            out.extend([2.0, 9.0, 16.0].map(|x| stroke([p(x, 6.0), p(x + 12.0, -6.0)], 1.1 * ppp, OVERLAP)));
        }
        Sign::SeatEdge(width) => out.push(stroke([p(2.0, 0.0), p(28.0, 0.0)], width * ppp, OVERLAP)),
        Sign::Colors(signed) => {
            let low = if signed { -1.0 } else { 0.0 };
            for k in 0..COLOR_PARTS {
                let [from, to] = [k, k + 1].map(|k| COLOR_BAR * f32::from(k) / f32::from(COLOR_PARTS));
                let value = low + (1.0 - low) * (f64::from(k) + 0.5) / f64::from(COLOR_PARTS);
                let points = vec![p(from, -5.0), p(to, -5.0), p(to, 5.0), p(from, 5.0)];
                out.push(Mark::Fill { points, color: bent::of_value(signed, value) });
            }
            let rim = [p(0.0, -5.0), p(COLOR_BAR, -5.0), p(COLOR_BAR, 5.0), p(0.0, 5.0), p(0.0, -5.0)];
            out.push(stroke(rim, ppp, palette.edge));
        }
        Sign::Girder => {
            let points = vec![p(2.0, -5.0), p(28.0, -5.0), p(28.0, 5.0), p(2.0, 5.0)];
            out.push(Mark::Fill { points, color: palette.girder });
            out.push(stroke([p(2.0, -5.0), p(28.0, -5.0), p(28.0, 5.0), p(2.0, 5.0), p(2.0, -5.0)], ppp, palette.edge));
        }
        Sign::Ghost => {
            for k in [2.0, 11.5, 21.0] {
                out.extend([-5.0, 5.0].map(|y| stroke([p(k, y), p(k + 6.5, y)], 1.8 * ppp, palette.ghost)));
            }
        }
        Sign::Grid => {
            let color = palette.grid.with_alpha(0xb0);
            for k in [5.0, 15.0, 25.0] {
                out.push(stroke([p(k, -7.0), p(k, 7.0)], ppp, color));
            }
            out.extend([-4.0, 4.0].map(|y| stroke([p(2.0, y), p(28.0, y)], ppp, color)));
        }
    }
}

/// World axes as they stand in the picture, at the bottom left.
pub(super) fn axes(input: &ViewInput<'_>, palette: &Palette) -> (Vec<Mark>, Area) {
    let ppp = input.pixels_per_point;
    let reach = 34.0 * ppp;
    let origin = Vec2::new(62.0 * ppp, input.size[1] as f32 - 62.0 * ppp);
    let triad = Triad { origin, reach, ppp };
    let basis = input.camera.basis();
    let directions = [glam::DVec3::X, glam::DVec3::Y, glam::DVec3::Z];
    let mut axes: Vec<_> = directions.iter().zip(palette.axes).zip(["x", "y", "z"]).collect();
    // The one that points away from the eye first, so that the nearer ones lie over it.
    axes.sort_by(|((a, _), _), ((b, _), _)| a.dot(basis.back).total_cmp(&b.dot(basis.back)));
    let mut marks = Vec::new();
    for ((direction, color), name) in axes {
        let flat = Vec2::new(direction.dot(basis.right) as f32, -direction.dot(basis.up) as f32);
        axis_marks(&triad, flat, color, name, palette, &mut marks);
    }
    (marks, Area::about(origin, Vec2::splat(reach + 16.0 * ppp)))
}

/// World axes in the picture, seen from one point.
struct Triad {
    /// Point that they start at \[pixels\].
    origin: Vec2,
    /// Length of an axis that is square to the line of sight \[pixels\].
    reach: f32,
    /// Pixels per point.
    ppp: f32,
}

/// Adds the arrow and the name of an axis with this direction in the picture \[–\].
fn axis_marks(triad: &Triad, flat: Vec2, color: Rgba, name: &str, palette: &Palette, out: &mut Vec<Mark>) {
    let Triad { origin, reach, ppp } = *triad;
    let length = flat.length();
    if length < 0.08 {
        // Straight at the eye or away from it.
        out.push(Mark::Disk { at: origin, radius: 3.0 * ppp, color, halo: palette.halo });
        return;
    }
    let (along, tip) = (flat / length, origin + flat * reach);
    let aside = Vec2::new(-along.y, along.x) * (3.6 * ppp);
    let neck = tip - along * (8.0 * ppp).min(length * reach);
    out.push(stroke([origin, neck], 2.0 * ppp, color));
    out.push(Mark::Fill { points: vec![neck + aside, tip, neck - aside], color });
    let at = tip + along * (9.0 * ppp);
    let align = Vec2::splat(0.5);
    out.push(Mark::Text { at, align, size: TEXT * ppp, text: name.to_owned(), color, plate: None });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_small_picture_spares_asides_first_then_states_and_values_never() {
        let needs = [Need::Value, Need::Aside, Need::State, Need::Aside, Need::Value];
        let all = || needs.map(|need| row(Sign::None, need, "words")).to_vec();
        let kept =
            |most: usize| spared(all(), |rows| rows.len() <= most).iter().map(|row| row.need).collect::<Vec<_>>();
        assert_eq!(kept(5), needs, "all where there is room");
        assert_eq!(kept(4), [Need::Value, Need::State, Need::Value], "no asides");
        assert_eq!(kept(1), [Need::Value; 2], "values alone, be the picture as small as it is");
    }
}
