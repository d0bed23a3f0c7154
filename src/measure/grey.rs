//! Grey pictures, from colours, and the brightness of a share of their pixels.

/// A picture in grey; brightness from 0 to 255, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Grey {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// A brightness a pixel.
    pub values: Vec<f32>,
}

impl Grey {
    /// From eight bits of red, green, blue and alpha a pixel, by the weights of Rec. 601; alpha is passed over.
    pub fn of_rgba(width: u32, height: u32, rgba: &[u8]) -> Self {
        let of = |p: &[u8]| 0.299 * f32::from(p[0]) + 0.587 * f32::from(p[1]) + 0.114 * f32::from(p[2]);
        let mut values: Vec<f32> = rgba.chunks_exact(4).map(of).collect();
        let (width, height) = (width as usize, height as usize);
        values.resize(width * height, 0.0);
        Self { width, height, values }
    }

    /// Brightness of a pixel.
    pub fn at(&self, x: usize, y: usize) -> f32 {
        self.values[y * self.width + x]
    }

    /// The brightness that this share of the pixels does not exceed.
    pub fn quantile(&self, share: f64) -> f32 {
        let mut count = [0_usize; 256];
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a byte")]
        self.values.iter().for_each(|v| count[v.clamp(0.0, 255.0) as usize] += 1);
        let mut left = share * self.values.len() as f64;
        for (level, count) in (0..=u8::MAX).zip(count) {
            left -= count as f64;
            if left <= 0.0 {
                return f32::from(level);
            }
        }
        255.0
    }
}
