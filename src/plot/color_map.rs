//! Numbers as colours: viridis (S. van der Walt and N. Smith, 2015, CC0), whose lightness grows evenly and which every kind of
//! colour vision tells apart.

/// Ten samples of the map, evenly spaced from the lowest value to the highest; between them sRGB is linear.
const VIRIDIS: [[u8; 3]; 10] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x28, 0x78],
    [0x3e, 0x4a, 0x89],
    [0x31, 0x68, 0x8e],
    [0x26, 0x82, 0x8e],
    [0x1f, 0x9e, 0x89],
    [0x35, 0xb7, 0x79],
    [0x6d, 0xcd, 0x59],
    [0xb4, 0xde, 0x2c],
    [0xfd, 0xe7, 0x25],
];

/// Both sides of 0: C. Brewer's `PRGn` of seven classes, purple below, green above, light in the middle, told apart by every kind of
/// colour vision. Blue and vermilion are stick and slip, and mean nothing else.
const SIGNED: [[u8; 3]; 7] = [
    [0x76, 0x2a, 0x83],
    [0xaf, 0x8d, 0xc3],
    [0xe7, 0xd4, 0xe8],
    [0xf7, 0xf7, 0xf7],
    [0xd9, 0xf0, 0xd3],
    [0x7f, 0xbf, 0x7b],
    [0x1b, 0x78, 0x37],
];

/// A map of numbers to colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colors {
    /// From the lowest to the highest.
    #[default]
    Even,
    /// From as far below 0 as above it.
    Signed,
}

/// Levels that a map is drawn in: two neighbours look alike.
pub(crate) const LEVELS: u8 = 255;

/// The level of a value in a range, from 0 to [`LEVELS`].
pub(crate) fn level(value: f64, [low, high]: [f64; 2]) -> u8 {
    let part = ((value - low) / (high - low)).clamp(0.0, 1.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255; NaN is 0")]
    let level = (part * f64::from(LEVELS)).round() as u8;
    level
}

impl Colors {
    /// For values of both signs, or of one.
    pub const fn of_signed(both: bool) -> Self {
        if both { Self::Signed } else { Self::Even }
    }

    /// The colour of a level, red, green and blue.
    pub(crate) fn rgb(self, level: u8) -> [u8; 3] {
        match self {
            Self::Even => between(&VIRIDIS, level),
            Self::Signed => between(&SIGNED, level),
        }
    }

    /// The colour of a level, `#rrggbb`.
    pub(super) fn hex(self, level: u8) -> String {
        let [r, g, b] = self.rgb(level);
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// The range of the colours for values in a range.
    pub(crate) fn range(self, [low, high]: [f64; 2]) -> [f64; 2] {
        let most = low.abs().max(high.abs());
        if self == Self::Signed { [-most, most] } else { [low, high] }
    }
}

/// The colour of a level between samples.
fn between(samples: &[[u8; 3]], level: u8) -> [u8; 3] {
    let at = usize::from(level) * (samples.len() - 1);
    let (sample, over) = (at / usize::from(LEVELS), at % usize::from(LEVELS));
    let (from, to) = (samples[sample], samples[(sample + 1).min(samples.len() - 1)]);
    [0, 1, 2].map(|i| {
        let part = over as f64 / f64::from(LEVELS);
        let mixed = f64::from(from[i]) + part * (f64::from(to[i]) - f64::from(from[i]));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two bytes")]
        let byte = mixed.round() as u8;
        byte
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance (IEC 61966-2-1).
    fn luminance(level: u8) -> f64 {
        let linear = |byte: u8| {
            let c = f64::from(byte) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        let [r, g, b] = Colors::Even.rgb(level).map(linear);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    #[test]
    fn lightness_grows_evenly() {
        // CIE 1976 lightness.
        let lightness = |level| 116.0 * luminance(level).cbrt() - 16.0;
        let steps: Vec<f64> = (0..=240).step_by(15).map(|i| lightness(i + 15) - lightness(i)).collect();
        let even = (lightness(255) - lightness(0)) / 17.0;
        assert!(steps.iter().all(|step| (step - even).abs() < 0.35 * even), "about {even} each: {steps:?}");
    }

    #[test]
    fn ends_and_middle_are_those_of_the_range() {
        assert_eq!([level(1.0, [1.0, 3.0]), level(2.0, [1.0, 3.0]), level(3.0, [1.0, 3.0])], [0, 128, 255], "in it");
        assert_eq!([level(-9.0, [1.0, 3.0]), level(9.0, [1.0, 3.0])], [0, 255], "beyond it");
        assert_eq!([0, 255].map(|at| Colors::Even.hex(at)), ["#440154", "#fde725"], "the ends of the map");
        assert_eq!(Colors::Signed.range([-1.0, 3.0]), [-3.0, 3.0], "0 in the middle");
        assert_eq!([0, 255].map(|at| Colors::Signed.hex(at)), ["#762a83", "#1b7837"], "the ends of the signed map");
    }
}
