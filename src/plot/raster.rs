//! A plot's SVG as PNG, in the fonts that the program brings along.

use std::sync::Arc;

use resvg::{tiny_skia, usvg};

/// Pixels per unit of the SVG.
const SCALE: f32 = 1.5;

/// Why a plot could not be drawn.
#[derive(Debug, thiserror::Error)]
pub enum RasterError {
    /// The SVG was not read.
    #[error("the plot's SVG cannot be read: {0}")]
    Svg(#[from] usvg::Error),
    /// No room for the pixels.
    #[error("there is no memory for a picture of {0} × {1} pixels")]
    Memory(u32, u32),
    /// The pixels could not be packed.
    #[error("the picture cannot be packed as PNG: {0}")]
    Png(String),
}

/// Draws an SVG document.
///
/// # Errors
/// A document that is no SVG, no memory for its pixels.
pub fn png(svg: &str) -> Result<Vec<u8>, RasterError> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(epaint_default_fonts::UBUNTU_LIGHT.to_vec());
    let family = fonts.faces().next().and_then(|face| face.families.first()).map(|(name, _)| name.clone());
    let family = family.unwrap_or_default();
    fonts.set_sans_serif_family(&family);
    let options = usvg::Options { fontdb: Arc::new(fonts), font_family: family, ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(svg, &options)?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the size of a plot")]
    let (width, height) = ((tree.size().width() * SCALE) as u32, (tree.size().height() * SCALE) as u32);
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or(RasterError::Memory(width, height))?;
    resvg::render(&tree, tiny_skia::Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| RasterError::Png(error.to_string()))
}
