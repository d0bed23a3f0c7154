//! Occupied areas of a picture in cells, so that a label is compared with near ones only.

use super::area::Area;

/// Side of a cell \[points\]: about the height of two lines of text.
const CELL: f32 = 32.0;
/// Cells along a side at the most, whatever size is asked for; the last takes what lies beyond.
const MOST_CELLS_A_SIDE: usize = 512;

/// Areas that are taken, filed by the cells that they touch.
#[derive(Debug)]
pub(super) struct Crowd {
    areas: Vec<Area>,
    cells: Vec<Vec<usize>>,
    columns: usize,
    rows: usize,
    side: f32,
}

impl Crowd {
    /// An empty picture.
    pub(super) fn new(size: [u32; 2], ppp: f32) -> Self {
        let side = CELL * ppp.max(0.1);
        let [columns, rows] = size.map(|pixels| cell(pixels as f32 / side, MOST_CELLS_A_SIDE - 1) + 1);
        Self { areas: Vec::new(), cells: vec![Vec::new(); columns * rows], columns, rows, side }
    }

    /// Takes an area. What is outside of the picture counts to the cells at its edge.
    pub(super) fn take(&mut self, area: Area) {
        let [columns, rows] = self.touched(&area);
        for row in rows {
            for column in columns.clone() {
                self.cells[row * self.columns + column].push(self.areas.len());
            }
        }
        self.areas.push(area);
    }

    /// Part of an area that is taken, counted once for each label there \[pixels²\]; `None` if it is more than `most`.
    pub(super) fn covered(&self, area: &Area, most: f32) -> Option<f32> {
        let [columns, rows] = self.touched(area);
        let mut overlaps: Vec<(usize, f32)> = Vec::new();
        let mut sum = 0.0;
        for row in rows {
            for &number in columns.clone().flat_map(|column| &self.cells[row * self.columns + column]) {
                let overlap = self.areas[number].overlap(area);
                if overlap > 0.0 && overlaps.iter().all(|(seen, _)| *seen != number) {
                    overlaps.push((number, overlap));
                    sum += overlap;
                    if sum > most * 1.001 {
                        return None;
                    }
                }
            }
        }
        // In the order in which they were taken, so that rounding does not depend on cells.
        overlaps.sort_unstable_by_key(|(number, _)| *number);
        Some(overlaps.into_iter().map(|(_, overlap)| overlap).sum::<f32>()).filter(|sum| *sum <= most)
    }

    fn touched(&self, area: &Area) -> [std::ops::RangeInclusive<usize>; 2] {
        let (min, max) = (area.min / self.side, area.max / self.side);
        [
            cell(min.x, self.columns - 1)..=cell(max.x, self.columns - 1),
            cell(min.y, self.rows - 1)..=cell(max.y, self.rows - 1),
        ]
    }
}

/// The cell of a coordinate, held within the picture.
#[expect(clippy::cast_sign_loss, reason = "held at 0 and above")]
fn cell(at: f32, last: usize) -> usize {
    (at.clamp(0.0, 1e6) as usize).min(last)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    /// Numbers in `[0, 1)` from a seed (a linear congruential generator; quality is no matter here).
    fn random(seed: &mut u32) -> f32 {
        *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (*seed >> 8) as f32 / 16_777_216.0
    }

    #[test]
    fn cells_find_what_looking_at_all_areas_finds() {
        let seed = &mut 7;
        let mut crowd = Crowd::new([640, 360], 1.0);
        for _ in 0..2000 {
            // Many of them beside the picture, some larger than a cell.
            let middle = Vec2::new(random(seed) * 900.0 - 130.0, random(seed) * 600.0 - 120.0);
            let area = Area::about(middle, Vec2::new(random(seed) * 60.0, random(seed) * 20.0));
            let all: f32 = crowd.areas.iter().map(|a| a.overlap(&area)).sum();
            assert_eq!(crowd.covered(&area, f32::INFINITY), Some(all), "to the last bit");
            let most = 300.0;
            assert_eq!(crowd.covered(&area, most), Some(all).filter(|sum| *sum <= most), "up to a bound");
            crowd.take(area);
        }
    }
}
