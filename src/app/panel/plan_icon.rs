//! Scenes in plan, small: what a preset looks like before it is opened.

use std::sync::OnceLock;

use egui::{Painter, Pos2, Rect, Shape, Stroke, vec2};
use glam::DVec2;

use crate::app::style::theme::Palette;
use crate::scene::{Scene, placed, presets};

/// Drawn parts of a scene, in the world \[m\].
struct PlanIcon {
    decks: Vec<[DVec2; 4]>,
    /// Faces of abutments.
    walls: Vec<[DVec2; 2]>,
    piers: Vec<DVec2>,
}

impl PlanIcon {
    fn of(scene: &Scene) -> Self {
        let walls = scene.abutments.iter().filter_map(|wall| placed::abutment_face(scene, wall));
        Self {
            decks: scene.girders.iter().map(placed::plan).collect(),
            walls: walls.map(|[a, b, ..]| [a, b].map(glam::DVec3::truncate)).collect(),
            piers: (0..scene.piers.len()).map(|number| scene.pier(number).top.truncate()).collect(),
        }
    }
}

/// The plan of every preset, in their order; read once.
fn icons() -> &'static [Option<PlanIcon>] {
    static ICONS: OnceLock<Vec<Option<PlanIcon>>> = OnceLock::new();
    ICONS.get_or_init(|| {
        presets::all().iter().map(|preset| presets::load(preset.name).ok().as_ref().map(PlanIcon::of)).collect()
    })
}

/// Draws the plan of the preset of this number as large as a rectangle allows: decks filled, abutments as strokes, piers as dots.
pub(super) fn draw(painter: &Painter, rect: Rect, preset: usize, palette: &Palette) {
    let Some(icon) = icons().get(preset).and_then(Option::as_ref) else { return };
    let corners = || icon.decks.iter().flatten().copied();
    let (Some(low), Some(high)) = (corners().reduce(DVec2::min), corners().reduce(DVec2::max)) else { return };
    let (size, middle) = (high - low, 0.5 * (low + high));
    #[expect(clippy::cast_possible_truncation, reason = "places on the screen")]
    let place = |at: DVec2| -> Pos2 {
        let scale = (f64::from(rect.width()) / size.x).min(f64::from(rect.height()) / size.y);
        let aside = (at - middle) * scale;
        rect.center() + vec2(aside.x as f32, -aside.y as f32)
    };
    let painter = painter.with_clip_rect(rect.expand(3.0).intersect(painter.clip_rect()));
    for deck in &icon.decks {
        let corners = deck.iter().map(|corner| place(*corner)).collect();
        painter.add(Shape::convex_polygon(corners, palette.track, Stroke::new(1.0, palette.weak)));
    }
    for wall in &icon.walls {
        painter.line_segment(wall.map(place), Stroke::new(2.2, palette.weak));
    }
    for pier in &icon.piers {
        painter.circle_filled(place(*pier), 1.6, palette.force);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_has_a_plan() {
        for (preset, icon) in presets::all().iter().zip(icons()) {
            assert!(icon.as_ref().is_some_and(|icon| !icon.decks.is_empty()), "{}", preset.name);
        }
    }
}
