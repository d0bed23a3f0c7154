//! Pictures of white disks as a sensor sees them: each pixel the mean of the light on it, noise, steps of brightness.

use crate::measure::Grey;

/// Brightness of what is dark and of marks.
const DARK: f64 = 40.0;
const BRIGHT: f64 = 235.0;
/// Points a pixel along each axis at the rim of a mark.
const POINTS: i32 = 8;

/// A camera straight above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Width and height \[pixels\].
    pub size: [f64; 2],
    /// Length of a pixel \[mm\].
    pub mm_per_pixel: f64,
    /// Diameter of the marks \[mm\].
    pub diameter: f64,
    /// Time of exposure, about the instant of the picture \[s\].
    pub exposure: f64,
    /// Standard deviation of the sensor's noise \[steps of 255\].
    pub noise: f64,
    /// Steps of brightness.
    pub levels: f64,
}

impl Camera {
    /// The paper's, with the marks of `girderbench render --marks`: 720 × 465, 256 steps; without blur and noise.
    pub fn papers() -> Self {
        let diameter = 0.08 * 70.0;
        Self {
            size: super::SIZE,
            mm_per_pixel: super::MM_PER_PIXEL,
            diameter,
            exposure: 0.0,
            noise: 0.0,
            levels: 256.0,
        }
    }

    /// Half-way between dark and bright.
    pub(super) fn threshold() -> f32 {
        #[expect(clippy::cast_possible_truncation, reason = "brightness of a picture")]
        let middle = f64::midpoint(DARK, BRIGHT) as f32;
        middle
    }

    /// Pixel of a place, from G as placed \[mm\], to the right and down \[pixels\].
    pub(super) fn pixel(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [0.5 * self.size[0] + x / self.mm_per_pixel, 0.45 * self.size[1] - y / self.mm_per_pixel]
    }

    /// A picture of disks at places that are seen one after another during the exposure, `number` of the film.
    pub(super) fn take(&self, instants: &[Vec<[f64; 2]>], number: u64) -> Grey {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sides of a picture")]
        let [width, height] = self.size.map(|side| side as usize);
        let mut light = vec![0.0_f64; width * height];
        for mark in instants.iter().flatten() {
            self.expose(&mut light, [width, height], *mark, 1.0 / instants.len() as f64);
        }
        let (mut noise, step) = (Normal::of(number), 255.0 / (self.levels - 1.0));
        let mut seen = |light: f64| {
            let value = DARK + (BRIGHT - DARK) * light + if self.noise > 0.0 { self.noise * noise.next() } else { 0.0 };
            ((value / step).round() * step).clamp(0.0, 255.0)
        };
        #[expect(clippy::cast_possible_truncation, reason = "brightness of a picture")]
        let values = light.into_iter().map(|light| seen(light) as f32).collect();
        Grey { width, height, values }
    }

    /// Adds the share of each pixel that a disk covers.
    fn expose(&self, light: &mut [f64], [width, height]: [usize; 2], [cx, cy]: [f64; 2], share: f64) {
        let radius = 0.5 * self.diameter / self.mm_per_pixel;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the picture")]
        let range = |middle: f64, side: usize| {
            let [from, to] = [middle - radius - 1.0, middle + radius + 2.0].map(|v| v.clamp(0.0, side as f64) as usize);
            from..to
        };
        for y in range(cy, height) {
            for x in range(cx, width) {
                let [dx, dy] = [x as f64 + 0.5 - cx, y as f64 + 0.5 - cy];
                light[y * width + x] += share * covered([dx, dy], radius);
            }
        }
    }
}

/// Share of a pixel at a distance from the middle of a disk that it covers.
fn covered([dx, dy]: [f64; 2], radius: f64) -> f64 {
    let distance = dx.hypot(dy);
    match distance - radius {
        // Half the diagonal of a pixel.
        off if off > 0.7072 => 0.0,
        off if off < -0.7072 => 1.0,
        _ => {
            let at = |n: i32| (f64::from(n) + 0.5) / f64::from(POINTS) - 0.5;
            let inside = |nx: i32, ny: i32| (dx + at(nx)).hypot(dy + at(ny)) <= radius;
            let count = (0..POINTS).flat_map(|ny| (0..POINTS).map(move |nx| (nx, ny))).filter(|(x, y)| inside(*x, *y));
            count.count() as f64 / f64::from(POINTS * POINTS)
        }
    }
}

/// Normal numbers by Box and Muller from a linear congruence (Knuth's MMIX constants), so that a film is the same for ever.
struct Normal {
    state: u64,
    spare: Option<f64>,
}

impl Normal {
    fn of(number: u64) -> Self {
        let mut normal = Self { state: number.wrapping_mul(0x9E37_79B9_7F4A_7C15), spare: None };
        // The first numbers of near seeds are near each other.
        let _first = [0; 8].map(|_| normal.uniform());
        normal
    }

    fn uniform(&mut self) -> f64 {
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn next(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        let (sin, cos) = (std::f64::consts::TAU * self.uniform()).sin_cos();
        self.spare = Some(radius * sin);
        radius * cos
    }
}
