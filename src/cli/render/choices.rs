//! What `render`'s flags can say, and what that is to the rooms that draw.

use clap::ValueEnum;

use crate::render::Quality;
use crate::scene::{Overlays, ViewPreset};
use crate::snapshot::{Instant, MOST_FPS};
use crate::view::Background;

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum View {
    Iso,
    Top,
    Side,
    Contact,
}

impl View {
    pub(super) fn preset(self) -> ViewPreset {
        match self {
            Self::Iso => ViewPreset::Iso,
            Self::Top => ViewPreset::Top,
            Self::Side => ViewPreset::Side,
            Self::Contact => ViewPreset::Contact,
        }
    }
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

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Layer {
    Grid,
    Bearings,
    Gap,
    Contacts,
    Normal,
    Tangential,
    Resultant,
    Damping,
    Cones,
    Axes,
    Legend,
    Title,
    Names,
}

impl Layer {
    pub(super) fn switch(self, overlays: &mut Overlays) -> &mut bool {
        match self {
            Self::Grid => &mut overlays.grid,
            Self::Bearings => &mut overlays.bearings,
            Self::Gap => &mut overlays.gap,
            Self::Contacts => &mut overlays.contacts,
            Self::Normal => &mut overlays.normal,
            Self::Tangential => &mut overlays.tangential,
            Self::Resultant => &mut overlays.resultant,
            Self::Damping => &mut overlays.damping,
            Self::Cones => &mut overlays.cones,
            Self::Axes => &mut overlays.axes,
            Self::Legend => &mut overlays.legend,
            Self::Title => &mut overlays.title,
            Self::Names => &mut overlays.names,
        }
    }
}

/// Width and height \[pixels\].
#[derive(Clone, Copy, Debug)]
pub(super) struct Size(pub(super) [u32; 2]);

pub(super) fn size(text: &str) -> Result<Size, String> {
    let read = |side: &str| side.trim().parse::<u32>().ok().filter(|s| (16..=16_384).contains(s));
    let sides = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some([read(w)?, read(h)?]));
    sides.map(Size).ok_or_else(|| "give width x height, each from 16 to 16384, such as 1280x720".to_owned())
}

pub(super) fn instant(text: &str) -> Result<Instant, String> {
    match text.parse::<f64>() {
        Ok(t) if t.is_finite() && t >= 0.0 => Ok(Instant::At(t)),
        _ if text == "peak" => Ok(Instant::Peak),
        _ => Err("give a time of 0 s or later, or `peak`".to_owned()),
    }
}

pub(super) fn frame_rate(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(fps) if (0.1..=MOST_FPS).contains(&fps) => Ok(fps),
        _ => Err(format!("give frames a second from 0.1 to {MOST_FPS}")),
    }
}
