//! Values of `render`'s flags, and their counterparts in the rooms that draw.

use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::language::{Text, said};
use crate::render::Quality;
use crate::scene::{Layer, Overlays, ViewPreset};
use crate::snapshot::{Instant, MOST_FPS};
use crate::view::Background;

/// A standing place for the camera, by its word in the scene file.
pub(super) fn view() -> impl TypedValueParser<Value = ViewPreset> {
    let of = |word: String| ViewPreset::ALL.iter().copied().find(|view| view.label() == word).ok_or(word);
    PossibleValuesParser::new(ViewPreset::WORDS).try_map(of)
}

/// A layer of the view, by its key in the scene file.
pub(super) fn layer() -> impl TypedValueParser<Value = Layer> {
    let of = |key: String| Overlays::ALL.iter().copied().find(|layer| layer.key == key).ok_or(key);
    PossibleValuesParser::new(Overlays::ALL.iter().map(|layer| layer.key)).try_map(of)
}

/// How many times larger deformations are drawn; nothing: as large as is well seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct BendingFactor(pub(super) Option<f64>);

/// A factor, or `auto`.
pub(super) fn bending_factor(text: &str) -> Result<BendingFactor, String> {
    if text == "auto" {
        return Ok(BendingFactor(None));
    }
    let factor = text.parse::<f64>().ok().filter(|factor| factor.is_finite() && (0.0..=1e6).contains(factor));
    factor.map(|factor| BendingFactor(Some(factor))).ok_or_else(|| Text::new("wrong-bent").into())
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Behind {
    Studio,
    White,
    Transparent,
    Dark,
}

impl Behind {
    pub(super) fn background(self) -> Background {
        match self {
            Self::Studio => Background::Studio,
            Self::White => Background::White,
            Self::Transparent => Background::Transparent,
            Self::Dark => Background::Dark,
        }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Work {
    Auto,
    Draft,
    Fine,
}

impl Work {
    pub(super) fn quality(self) -> Option<Quality> {
        match self {
            Self::Auto => None,
            Self::Draft => Some(Quality::DRAFT),
            Self::Fine => Some(Quality::FINE),
        }
    }
}

/// Width and height \[pixels\].
#[derive(Clone, Copy, Debug)]
pub(super) struct Size(pub(super) [u32; 2]);

pub(super) fn size(text: &str) -> Result<Size, String> {
    let read = |side: &str| side.trim().parse::<u32>().ok().filter(|s| (16..=16_384).contains(s));
    let sides = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some([read(w)?, read(h)?]));
    sides.map(Size).ok_or_else(|| Text::new("wrong-size").into())
}

pub(super) fn instant(text: &str) -> Result<Instant, String> {
    match text.parse::<f64>() {
        Ok(t) if t.is_finite() && t >= 0.0 => Ok(Instant::At(t)),
        _ if text == "peak" => Ok(Instant::Peak),
        _ => Err(Text::new("wrong-instant").into()),
    }
}

pub(super) fn frame_rate(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(fps) if (0.1..=MOST_FPS).contains(&fps) => Ok(fps),
        _ => Err(said!("wrong-frame-rate", "most" => MOST_FPS.to_string())),
    }
}
