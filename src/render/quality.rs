//! How much work a frame may cost.

use super::AdapterSummary;

/// How much work a frame may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quality {
    /// Samples per pixel, 1 or 4.
    pub samples: u32,
    /// Shadow map look-ups per pixel, 1, 4 or 9.
    pub shadow_taps: u32,
}

impl Quality {
    /// 4 samples and 9 shadow look-ups a pixel.
    pub const FINE: Self = Self { samples: 4, shadow_taps: 9 };
    /// 1 sample and 1 shadow look-up a pixel.
    pub const DRAFT: Self = Self { samples: 1, shadow_taps: 1 };

    /// For pictures that move: fine on a graphics card, draft where a processor draws.
    pub fn for_adapter(adapter: &AdapterSummary) -> Self {
        if adapter.is_cpu { Self::DRAFT } else { Self::FINE }
    }

    /// For pictures that stand still: a processor keeps smooth edges and makes shadows a little harder.
    pub fn for_stills(adapter: &AdapterSummary) -> Self {
        if adapter.is_cpu { Self { samples: 4, shadow_taps: 4 } } else { Self::FINE }
    }

    /// Samples 1 or 4; shadow look-ups the largest of 1, 4 and 9 that is not above the value given.
    pub(super) fn checked(self) -> Self {
        let samples = if self.samples >= 4 { 4 } else { 1 };
        let shadow_taps = self.shadow_taps.clamp(1, 9).isqrt().pow(2);
        Self { samples, shadow_taps }
    }

    /// Side of the shadow map \[texels\]. Of a draft the map is about as fine as the picture of a window 1280 points wide: a processor draws
    /// it anew in every frame (19 ms to paint one with 1024 texels, 16.5 with 512, llvmpipe).
    pub(super) fn shadow_map_size(self) -> u32 {
        if self.shadow_taps > 1 { 2048 } else { 512 }
    }
}
