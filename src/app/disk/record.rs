//! A record of ground motion from a file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::files::{Supplement, read_record};
use crate::scene::{Motion, RecordMotion};

/// Shaking by the record in a file, the path given from the scene's own `folder` on. The scales stay if there was a
/// record before, the angle in any case.
///
/// # Errors
/// In words: a file that is no record.
pub(in crate::app) fn shaking_by(path: &Path, folder: &Path, before: &Motion) -> Result<Motion, String> {
    let record = read_record(&folder.join(path), &Supplement::default()).map_err(|errors| errors.to_string())?;
    let [scale, vertical_scale] =
        if let Motion::Record(record) = before { [record.scale, record.vertical_scale] } else { [1.0, 0.0] };
    let (file, angle_deg) = (Some(seen_from(folder, path)), before.angle_deg());
    let channel = (record.channels.len() > 1).then_some(1);
    let loaded = Some(Arc::new(record));
    Ok(Motion::Record(RecordMotion {
        file,
        channel,
        scale,
        angle_deg,
        vertical_scale,
        loaded,
        ..RecordMotion::default()
    }))
}

/// The path as the scene's file writes it: from its own folder on, if the record is in there.
fn seen_from(folder: &Path, path: &Path) -> String {
    let inside = if folder.as_os_str().is_empty() { None } else { path.strip_prefix(folder).ok() };
    let path: PathBuf = inside.unwrap_or(path).to_owned();
    path.to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_beside_the_scene_is_named_from_there() {
        let folder = Path::new("bridges/east");
        assert_eq!(seen_from(folder, Path::new("bridges/east/records/quake.csv")), "records/quake.csv", "inside");
        assert_eq!(seen_from(folder, Path::new("elsewhere/quake.csv")), "elsewhere/quake.csv", "outside");
        assert_eq!(seen_from(Path::new(""), Path::new("quake.csv")), "quake.csv", "no folder yet");
    }
}
