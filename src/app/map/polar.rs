//! A polar plot of one measure: radius the value, angle the direction of the shaking in plan; the deck's plan in its middle.

use egui::{Align2, Color32, EventFilter, FontId, Key, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui};
use egui::{Vec2, WidgetInfo, pos2, vec2};
use glam::DVec2;

use super::angles::Turned;
use super::field::ring;
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::plot::chart::{range, ticks};
use crate::scene::{Scene, placed};
use crate::study::sweep::Measure;

/// Room about the circle, for the angles' names \[points\].
const MARGIN: f32 = 22.0;
/// The plan of the decks takes so much of the circle's radius.
const PLAN: f64 = 0.3;
/// Every so many degrees a spoke.
const SPOKE: usize = 30;
/// Measure that is worst where it is least.
const LEAST_IS_WORST: &str = "least_seat";

/// One measure over the angle.
pub(super) struct Polar {
    measure: &'static Measure,
    /// By number: value of the key and direction in plan \[degrees\], value in the unit of pictures where it has come out.
    points: Vec<(f64, f64, Option<f64>)>,
    /// Direction of the scene's own shaking \[degrees\].
    own: Option<f64>,
}

impl Polar {
    /// The measure of this number; `own` is the value of the key in the scene.
    pub(super) fn of(turned: &Turned, number: usize, own: Option<f64>) -> Self {
        let (measure, zero) = (turned.measure(number), turned.draft.zero);
        let value = |run: usize| Some(turned.row([run])?.values[number]? * measure.drawn.1);
        let point = |run| {
            let key = turned.value_at(0, run);
            (key, key + zero, value(run))
        };
        let points = (0..turned.plan.runs()).map(point).collect();
        Self { measure, points, own: own.map(|key| key + zero) }
    }

    /// The number of the worst angle so far.
    pub(super) fn worst(&self) -> Option<usize> {
        let sign = if self.measure.name == LEAST_IS_WORST { -1.0 } else { 1.0 };
        let values = self.points.iter().enumerate().filter_map(|(number, point)| Some((number, sign * point.2?)));
        // Of equal ones the first.
        Some(values.reduce(|most, next| if next.1 > most.1 { next } else { most })?.0)
    }

    /// The angle of a number, in words.
    pub(super) fn angle_of(&self, number: usize) -> String {
        self.points.get(number).map_or_else(String::new, |point| format!("{}°", text::short(point.0)))
    }

    /// The value of a number, in words.
    pub(super) fn value_of(&self, number: usize) -> String {
        match self.points.get(number).and_then(|point| point.2) {
            Some(value) => text::valued(value, self.measure.drawn.0),
            None => text::MAP_NOT_YET.to_string(),
        }
    }

    /// Values from the middle to the circle: from nought, or from the least where that is negative.
    fn range(&self) -> [f64; 2] {
        range(self.points.iter().filter_map(|point| point.2).chain([0.0]))
    }

    /// The number whose direction is nearest to an angle \[degrees\].
    fn nearest(&self, angle: f64) -> Option<usize> {
        let apart = |direction: f64| ((direction - angle + 180.0).rem_euclid(360.0) - 180.0).abs();
        let numbers = 0..self.points.len();
        numbers.min_by(|a, b| apart(self.points[*a].1).total_cmp(&apart(self.points[*b].1)))
    }
}

/// Where the circle is.
#[derive(Clone, Copy)]
struct Circle {
    middle: Pos2,
    radius: f32,
    values: [f64; 2],
}

impl Circle {
    /// A place by direction in plan \[degrees\] and value; y points up, as in plan.
    fn at(self, direction: f64, value: f64) -> Pos2 {
        let [low, high] = self.values;
        self.middle + way(direction) * (self.radius * part((value - low) / (high - low)))
    }

    /// Direction in plan of a place \[degrees\].
    fn direction(self, place: Pos2) -> f64 {
        let aside = place - self.middle;
        f64::from(-aside.y).atan2(f64::from(aside.x)).to_degrees()
    }
}

/// A direction on the screen.
#[expect(clippy::cast_possible_truncation, reason = "a direction on the screen")]
fn way(direction: f64) -> Vec2 {
    let (sin, cos) = direction.to_radians().sin_cos();
    vec2(cos as f32, -sin as f32)
}

/// A part of the radius.
#[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
fn part(value: f64) -> f32 {
    value.clamp(0.0, 1.0) as f32
}

/// Shows a plot of this size; the number of an angle that is chosen.
pub(super) fn show(ui: &mut Ui, size: Vec2, polar: &Polar, scene: &Scene) -> Option<usize> {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let title = text::angles_of(&polar.measure.title());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &title));
    let palette = Palette::of(ui);
    let circle =
        Circle { middle: rect.center(), radius: 0.5 * rect.width().min(rect.height()) - MARGIN, values: polar.range() };
    draw_axes(ui.painter(), (circle, polar.measure.drawn.0), &palette);
    draw_plan(ui.painter(), circle, scene, palette.line);
    draw_curve(ui.painter(), circle, polar, &palette);
    let (cursor, entered) = keyed(ui, &response, polar);
    let hovered = response.hover_pos().and_then(|place| polar.nearest(circle.direction(place)));
    if let Some(number) = hovered.or(cursor) {
        say(ui, &response, (rect, circle), polar, number, &palette);
    }
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked());
    clicked.and_then(|place| polar.nearest(circle.direction(place))).or(entered)
}

/// Circle, spokes with their angles, and circles of values of this unit.
fn draw_axes(painter: &Painter, (circle, unit): (Circle, &str), palette: &Palette) {
    let small = FontId::proportional(10.5);
    let [low, high] = circle.values;
    painter.circle(circle.middle, circle.radius, palette.track, Stroke::new(1.0, palette.line));
    for direction in (0..360).step_by(SPOKE) {
        let direction_deg = f64::from(u32::try_from(direction).unwrap_or(0));
        painter.line_segment([circle.middle, circle.at(direction_deg, high)], Stroke::new(0.5, palette.line));
        let at = circle.middle + way(direction_deg) * (circle.radius + 12.0);
        // From −150° to 180°, as angles are given.
        let signed = if direction > 180 { direction - 360 } else { direction };
        painter.text(at, Align2::CENTER_CENTER, format!("{signed}°"), small.clone(), palette.weak);
    }
    for value in ticks(circle.values, 3.0).into_iter().filter(|value| *value > low && *value < high) {
        let radius = circle.radius * part((value - low) / (high - low));
        painter.circle_stroke(circle.middle, radius, Stroke::new(0.7, palette.line));
        let at = circle.middle + way(75.0) * radius;
        painter.text(at, Align2::CENTER_CENTER, text::valued(value, unit), small.clone(), palette.weak);
    }
}

/// The decks in plan, so that directions are seen against their skew.
fn draw_plan(painter: &Painter, circle: Circle, scene: &Scene, color: Color32) {
    let decks: Vec<[DVec2; 4]> = scene.girders.iter().map(placed::plan).collect();
    let corners = || decks.iter().flatten();
    let (Some(low), Some(high)) = (corners().copied().reduce(DVec2::min), corners().copied().reduce(DVec2::max)) else {
        return;
    };
    let (middle, far) = (0.5 * (low + high), 0.5 * (high - low).length());
    for deck in &decks {
        let place = |corner: &DVec2| {
            let aside = (*corner - middle) / far;
            circle.middle + way(aside.to_angle().to_degrees()) * (circle.radius * part(PLAN * aside.length()))
        };
        painter.add(Shape::closed_line(deck.iter().map(place).collect(), Stroke::new(1.2, color)));
    }
}

/// The curve through what has come out, its values as dots, the worst, the scene's own direction.
fn draw_curve(painter: &Painter, circle: Circle, polar: &Polar, palette: &Palette) {
    let places: Vec<Pos2> = polar.points.iter().filter_map(|point| Some(circle.at(point.1, point.2?))).collect();
    if let Some(own) = polar.own {
        let end = circle.at(own, circle.values[1]);
        painter.line_segment([circle.middle, end], Stroke::new(2.0, palette.playhead));
    }
    for place in &places {
        painter.circle_filled(*place, 1.8, palette.force);
    }
    painter.add(Shape::closed_line(places, Stroke::new(1.6, palette.force)));
    if let Some((_, direction, Some(value))) = polar.worst().map(|number| polar.points[number]) {
        ring(painter, circle.at(direction, value));
    }
}

/// The direction that the keys have gone to, and the one that Enter chooses.
fn keyed(ui: &Ui, response: &Response, polar: &Polar) -> (Option<usize>, Option<usize>) {
    if !response.has_focus() {
        return (None, None);
    }
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let begun = || polar.own.and_then(|own| polar.nearest(own)).unwrap_or(0);
    let mut number = ui.data(|data| data.get_temp::<usize>(response.id)).unwrap_or_else(begun);
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    let count = polar.points.len().max(1);
    if pressed(Key::ArrowLeft) || pressed(Key::ArrowUp) {
        number = (number + 1) % count;
    }
    if pressed(Key::ArrowRight) || pressed(Key::ArrowDown) {
        number = (number + count - 1) % count;
    }
    ui.data_mut(|data| data.insert_temp(response.id, number));
    (Some(number), pressed(Key::Enter).then_some(number))
}

/// Marks a direction and tells its value.
fn say(ui: &Ui, response: &Response, (rect, circle): (Rect, Circle), polar: &Polar, number: usize, palette: &Palette) {
    let direction = polar.points[number].1;
    let painter = ui.painter();
    painter.line_segment([circle.middle, circle.at(direction, circle.values[1])], Stroke::new(1.0, palette.weak));
    let words = format!("{}: {}", polar.angle_of(number), polar.value_of(number));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(words.as_str()));
    painter.text(pos2(rect.left(), rect.top()), Align2::LEFT_TOP, words, FontId::proportional(12.0), palette.force);
}
