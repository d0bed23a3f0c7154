//! Values of a section force on a grid of times and stations as a coloured mesh, kept until something else is to be seen.

use std::sync::Arc;

use egui::epaint::{Mesh, Vertex, WHITE_UV};
use egui::{Color32, Rect, pos2};

use crate::app::run::answer::Answer;
use crate::plot::Colors;
use crate::plot::color_map::level;
use crate::sim::{OfSection, SectionField};

/// Width of a column of the grid \[points\].
pub(super) const COLUMN: f32 = 3.0;
/// Stations of the grid.
const STATIONS: usize = 41;
/// Inputs that a grid was computed for, and its place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Key {
    pub(super) answer: u64,
    pub(super) girder: usize,
    pub(super) what: OfSection,
    pub(super) window: [f64; 2],
    pub(super) field: Rect,
}

/// The picture of values on a grid.
pub(super) struct Drawn {
    /// Values at the ends of the colours, SI.
    pub(super) range: [f64; 2],
    pub(super) mesh: Arc<Mesh>,
}

/// Keeps the last grid until something else is to be seen.
#[derive(Default)]
pub(super) struct WaveCache(Option<(Key, Arc<Drawn>)>);

impl WaveCache {
    /// The picture of a grid.
    pub(super) fn of(&mut self, answer: &Answer, key: Key) -> Option<Arc<Drawn>> {
        if let Some((kept, drawn)) = &self.0
            && *kept == key
        {
            return Some(drawn.clone());
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "columns on a screen")]
        let columns = (key.field.width() / COLUMN).clamp(2.0, 2000.0) as usize;
        let values = answer.history.sections().field(key.girder, key.what, key.window, [columns, STATIONS])?;
        let most = values.largest().max(f64::MIN_POSITIVE);
        let range = [if key.what.is_signed() { -most } else { 0.0 }, most];
        let mesh = Arc::new(mesh(&values, key.field, colors(key.what), range));
        let drawn = Arc::new(Drawn { range, mesh });
        self.0 = Some((key, drawn.clone()));
        Some(drawn)
    }
}

pub(super) fn colors(what: OfSection) -> Colors {
    Colors::of_signed(what.is_signed())
}

fn color(colors: Colors, value: f64, range: [f64; 2]) -> Color32 {
    let [r, g, b] = colors.rgb(level(value, range));
    Color32::from_rgb(r, g, b)
}

/// Colours at the points of the grid, the first station at the bottom.
#[expect(clippy::cast_possible_truncation, reason = "points of a grid on the screen")]
fn mesh(values: &SectionField, field: Rect, colors: Colors, range: [f64; 2]) -> Mesh {
    let [columns, rows] = [values.times.len(), values.stations.len()];
    let mut mesh = Mesh::default();
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let part = [column as f32 / (columns - 1) as f32, row as f32 / (rows - 1) as f32];
        let pos = pos2(field.left() + part[0] * field.width(), field.bottom() - part[1] * field.height());
        let color = color(colors, values.values[row * columns + column], range);
        mesh.vertices.push(Vertex { pos, uv: WHITE_UV, color });
        if row > 0 && column > 0 {
            let [here, left] = [row * columns + column, row * columns + column - 1].map(|i| i as u32);
            let [below, below_left] = [here, left].map(|i| i - columns as u32);
            mesh.indices.extend([below_left, below, here, below_left, here, left]);
        }
    }
    mesh
}
