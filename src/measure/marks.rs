//! Bright marks in a picture, and their centroids.
//!
//! The centroid is weighted by brightness above the surroundings, over the pixels of the mark and two more around it, so that the
//! half-covered pixels of its rim count with their share and the threshold does not move it. The surroundings are the median
//! of the rim of the rectangle around them.

use super::grey::Grey;

/// Reach of a mark's light beyond the threshold's edge \[pixels\]: a half-covered pixel and one more of blur.
const REACH: usize = 2;
/// Share of a picture's pixels above the level taken as the brightness of its marks (chosen: less than the marks cover).
const BRIGHTEST: f64 = 2e-4;
/// Least difference between that level and the median for which a threshold is set automatically, of 255 (chosen).
const CONTRAST: f32 = 24.0;

/// Criteria of a mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finder {
    /// Brightness above which a pixel is of a mark, 0 to 255.
    pub threshold: f32,
    /// Fewest pixels of a mark: less is noise.
    pub least: usize,
}

/// A mark in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Centroid from the top left of the picture, to the right and down; the middle of the first pixel is (0.5, 0.5)
    /// \[pixels\].
    pub at: [f64; 2],
    /// Pixels above the threshold.
    pub area: usize,
    /// Whether it reaches the edge of the picture, so that a part may be missing.
    pub at_edge: bool,
}

impl Finder {
    /// A threshold half-way between the median of a picture and its brightest pixels; none where these do not stand out.
    pub fn threshold_of(image: &Grey) -> Option<f32> {
        let [dark, bright] = [image.quantile(0.5), image.quantile(1.0 - BRIGHTEST)];
        (bright - dark >= CONTRAST).then_some(f32::midpoint(dark, bright))
    }

    /// Every mark of a picture, from the top down.
    pub fn find(&self, image: &Grey) -> Vec<Mark> {
        let mut labels = vec![0_u32; image.values.len()];
        let mut marks = Vec::new();
        let mut label = 0;
        for start in 0..image.values.len() {
            if labels[start] != 0 || image.values[start] <= self.threshold {
                continue;
            }
            label += 1;
            let blob = self.flood(image, start, label, &mut labels);
            if blob.area >= self.least {
                marks.push((label, blob));
            }
        }
        marks.iter().map(|(label, blob)| blob.mark(image, *label, &labels)).collect()
    }

    /// Labels the pixels that hang together with one, by sides and corners.
    fn flood(&self, image: &Grey, start: usize, label: u32, labels: &mut [u32]) -> Blob {
        let mut blob = Blob { min: [usize::MAX; 2], max: [0; 2], area: 0 };
        let mut due = vec![start];
        labels[start] = label;
        while let Some(pixel) = due.pop() {
            let (x, y) = (pixel % image.width, pixel / image.width);
            blob.take([x, y]);
            for ny in y.saturating_sub(1)..=(y + 1).min(image.height - 1) {
                for nx in x.saturating_sub(1)..=(x + 1).min(image.width - 1) {
                    let next = ny * image.width + nx;
                    if labels[next] == 0 && image.values[next] > self.threshold {
                        labels[next] = label;
                        due.push(next);
                    }
                }
            }
        }
        blob
    }
}

/// Pixels that hang together: their rectangle and count.
struct Blob {
    min: [usize; 2],
    max: [usize; 2],
    area: usize,
}

impl Blob {
    fn take(&mut self, at: [usize; 2]) {
        for (axis, at) in at.into_iter().enumerate() {
            self.min[axis] = self.min[axis].min(at);
            self.max[axis] = self.max[axis].max(at);
        }
        self.area += 1;
    }

    fn mark(&self, image: &Grey, label: u32, labels: &[u32]) -> Mark {
        let size = [image.width, image.height];
        let low = self.min.map(|v| v.saturating_sub(REACH));
        let high = [0, 1].map(|axis| (self.max[axis] + REACH).min(size[axis] - 1));
        let surroundings = surroundings(image, low, high);
        let near = |x: usize, y: usize| {
            (y.saturating_sub(REACH)..=(y + REACH).min(size[1] - 1)).any(|ny| {
                let row = ny * image.width;
                labels[row + x.saturating_sub(REACH)..=row + (x + REACH).min(size[0] - 1)].contains(&label)
            })
        };
        let [mut sum, mut sx, mut sy] = [0.0_f64; 3];
        for y in low[1]..=high[1] {
            for x in low[0]..=high[0] {
                let own = labels[y * image.width + x];
                if (own == 0 && near(x, y)) || own == label {
                    let weight = f64::from(image.at(x, y) - surroundings);
                    sum += weight;
                    sx += weight * (x as f64 + 0.5);
                    sy += weight * (y as f64 + 0.5);
                }
            }
        }
        let at_edge = (0..2).any(|axis| self.min[axis] == 0 || self.max[axis] + 1 == size[axis]);
        // Brighter surroundings than the mark, with a threshold far below both: no centroid.
        let middle = [0, 1].map(|axis| f64::midpoint(low[axis] as f64, high[axis] as f64) + 0.5);
        let at = if sum > 0.0 { [sx / sum, sy / sum] } else { middle };
        Mark { at, area: self.area, at_edge }
    }
}

/// Median brightness along the rim of a rectangle.
fn surroundings(image: &Grey, low: [usize; 2], high: [usize; 2]) -> f32 {
    let level = (low[0]..=high[0]).flat_map(|x| [image.at(x, low[1]), image.at(x, high[1])]);
    let upright = (low[1]..=high[1]).flat_map(|y| [image.at(low[0], y), image.at(high[0], y)]);
    let mut rim: Vec<f32> = level.chain(upright).collect();
    rim.sort_by(f32::total_cmp);
    rim[rim.len() / 2]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Disks of brightness 220 on 40, each pixel by 16 × 16 points.
    pub(crate) fn disks(width: usize, height: usize, all: &[([f64; 2], f64)]) -> Grey {
        let covered = |x: usize, y: usize| {
            let inside = |n: usize| {
                let at =
                    [x as f64 + (n % 16) as f64 / 16.0 + 1.0 / 32.0, y as f64 + (n / 16) as f64 / 16.0 + 1.0 / 32.0];
                all.iter().any(|(c, r)| (at[0] - c[0]).hypot(at[1] - c[1]) <= *r)
            };
            (0..256).filter(|n| inside(*n)).count() as f32 / 256.0
        };
        let values = (0..width * height).map(|n| 40.0 + 180.0 * covered(n % width, n / width)).collect();
        Grey { width, height, values }
    }

    #[test]
    fn centroids_of_disks_are_found_to_a_hundredth_of_a_pixel() {
        for n in 0..20 {
            let centre = [20.0 + 0.37 * f64::from(n), 15.0 - 0.23 * f64::from(n)];
            let image = disks(60, 40, &[(centre, 4.3), ([45.0, 30.0], 3.0)]);
            let threshold = 130.0;
            let marks = Finder { threshold, least: 5 }.find(&image);
            assert_eq!(marks.len(), 2, "two disks");
            let off = (marks[0].at[0] - centre[0]).hypot(marks[0].at[1] - centre[1]);
            assert!(off < 0.01, "{centre:?}: {off} pixels off");
            assert!(!marks[0].at_edge, "whole");
        }
    }

    #[test]
    fn noise_edges_and_dark_pictures_are_told() {
        let mut image = disks(40, 30, &[([1.0, 15.0], 4.0), ([30.0, 15.0], 4.0)]);
        image.values[5 * 40 + 20] = 255.0;
        let finder = Finder { threshold: 130.0, least: 5 };
        let marks = finder.find(&image);
        assert_eq!(marks.iter().map(|mark| mark.at_edge).collect::<Vec<_>>(), [true, false], "one is cut off");
        assert_eq!(Finder { least: 1, ..finder }.find(&image).len(), 3, "a single pixel counts when asked for");
        let wide = disks(200, 100, &[([90.0, 50.0], 5.0)]);
        let chosen = Finder::threshold_of(&wide).expect("it stands out");
        assert!((chosen - 130.0).abs() <= 1.0, "{chosen}");
        assert_eq!(Finder::threshold_of(&disks(200, 100, &[])), None, "nothing stands out");
    }
}
