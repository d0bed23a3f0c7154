//! The files of a plot: its SVG, and its PNG where this build draws one.

use super::failure::Failure;

/// Names and bytes of a plot's files.
///
/// # Errors
/// A picture that cannot be drawn from the SVG.
#[cfg(feature = "study")]
pub(super) fn plot_files(name: &str, svg: String) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let png = crate::plot::png(&svg).map_err(|error| Failure::NoPicture(format!("{name}.png: {error}")))?;
    Ok(vec![(format!("{name}.svg"), svg.into_bytes()), (format!("{name}.png"), png)])
}

/// Names and bytes of a plot's files: this build draws no PNG.
#[cfg(not(feature = "study"))]
#[expect(clippy::unnecessary_wraps, reason = "the same call as in a build with PNG")]
pub(super) fn plot_files(name: &str, svg: String) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    Ok(vec![(format!("{name}.svg"), svg.into_bytes())])
}
