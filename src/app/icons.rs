//! Signs on the buttons of the transport, drawn: fonts differ in which of them they have.

use egui::{Color32, Painter, Rect, Shape, Stroke, Vec2, pos2, vec2};

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Icon {
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
}

/// Draws a sign in the middle of a rectangle.
pub(super) fn draw(painter: &Painter, rect: Rect, icon: Icon, color: Color32) {
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
    };
}
