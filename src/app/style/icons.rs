//! Signs on the buttons of the transport, drawn: fonts differ in which of them they have.

use egui::{Color32, Painter, Rect, Shape, Stroke, Vec2, pos2, vec2};

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) enum Icon {
    /// A bar and a triangle to the left.
    Start,
    /// Two triangles to the left.
    PreviousEvent,
    /// A triangle to the left and a bar.
    StepBack,
    /// A triangle to the right.
    Play,
    /// Two bars.
    Pause,
    /// A bar and a triangle to the right.
    StepForward,
    /// Two triangles to the right.
    NextEvent,
    /// A triangle to the right and a bar.
    End,
    /// An arrow that turns back.
    TakeBack,
    /// An angle that points to the left.
    Left,
    /// An angle that points to the right.
    Right,
    /// An angle that points up.
    Up,
    /// An angle that points down.
    Down,
}

/// Draws a sign in the middle of a rectangle.
pub(in crate::app) fn draw(painter: &Painter, rect: Rect, icon: Icon, color: Color32) {
    let size = rect.height().min(rect.width()) * 0.46;
    let at = |x: f32| Rect::from_center_size(rect.center() + vec2(x * size, 0.0), Vec2::splat(size));
    let triangle = |x: f32, way: f32| {
        let r = at(x);
        let (tip, base) = if way > 0.0 { (r.right(), r.left()) } else { (r.left(), r.right()) };
        let points = vec![pos2(base, r.top()), pos2(tip, r.center().y), pos2(base, r.bottom())];
        painter.add(Shape::convex_polygon(points, color, Stroke::NONE));
    };
    let bar = |x: f32| {
        let r = Rect::from_center_size(at(x).center(), vec2(size * 0.22, size));
        painter.rect_filled(r, 0.0, color);
    };
    match icon {
        Icon::Start => (bar(-0.55), triangle(0.1, -1.0)),
        Icon::PreviousEvent => (triangle(-0.45, -1.0), triangle(0.45, -1.0)),
        Icon::StepBack => (triangle(-0.2, -1.0), bar(0.5)),
        Icon::Play => (triangle(0.08, 1.0), ()),
        Icon::Pause => (bar(-0.28), bar(0.28)),
        Icon::StepForward => (bar(-0.5), triangle(0.2, 1.0)),
        Icon::NextEvent => (triangle(-0.45, 1.0), triangle(0.45, 1.0)),
        Icon::End => (triangle(-0.1, 1.0), bar(0.55)),
        Icon::TakeBack => (take_back(painter, rect, color), ()),
        Icon::Left => (angle(painter, rect, color, vec2(-1.0, 0.0)), ()),
        Icon::Right => (angle(painter, rect, color, vec2(1.0, 0.0)), ()),
        Icon::Up => (angle(painter, rect, color, vec2(0.0, -1.0)), ()),
        Icon::Down => (angle(painter, rect, color, vec2(0.0, 1.0)), ()),
    };
}

/// Two strokes that meet in a tip.
fn angle(painter: &Painter, rect: Rect, color: Color32, way: Vec2) {
    let (tip, side) = (rect.center() + way * 2.4, way.rot90() * 4.0);
    let points = vec![tip - way * 4.4 + side, tip, tip - way * 4.4 - side];
    painter.line(points, Stroke::new(1.6, color));
}

/// Most of a circle against the clock, from the right over the top, with a head at its left end.
fn take_back(painter: &Painter, rect: Rect, color: Color32) {
    let (middle, radius) = (rect.center() + vec2(0.0, 0.5), 3.6);
    let at = |degrees: f32| middle + Vec2::angled(degrees.to_radians()) * radius;
    let arc: Vec<_> = (0_u8..=12).map(|i| at(100.0 - f32::from(i) * 22.5)).collect();
    let (tip, before) = (at(-190.0), at(-140.0));
    painter.line(arc, Stroke::new(1.3, color));
    let way = (tip - before).normalized();
    let side = way.rot90() * 2.6;
    let head = vec![tip + way * 2.2, tip - way * 1.8 + side, tip - way * 1.8 - side];
    painter.add(Shape::convex_polygon(head, color, Stroke::NONE));
}
