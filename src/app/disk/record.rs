//! A record of ground motion from a file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::files::{Record, Records, Supplement, read_record};
use crate::scene::{Component, Motion, RecordMotion, RecordUnit};

/// Motion of the ground, and a message on a file that could not be read.
pub(in crate::app) type Shaking = (Motion, Option<String>);

/// Shaking by the record in a file, the path given from the scene's own `folder` on. The scales stay if there was a
/// record before, the angle in any case. A file that does not state its unit or interval is named all the same, so that they
/// can be stated beside it.
///
/// # Errors
/// In words: a file that is no record.
pub(in crate::app) fn shaking_by(path: &Path, folder: &Path, before: &Motion) -> Result<Shaking, String> {
    let (loaded, unread) = read(&folder.join(path))?;
    let [scale, vertical_scale] =
        if let Motion::Record(record) = before { [record.scale, record.vertical_scale] } else { [1.0, 0.0] };
    let (file, angle_deg) = (Some(seen_from(folder, path)), before.angle_deg());
    let channel = channel_of(loaded.as_deref());
    let record = RecordMotion { file, channel, scale, angle_deg, vertical_scale, loaded, ..RecordMotion::default() };
    Ok((Motion::Record(record), unread))
}

/// The same for a component of several, which keeps its direction and its factor.
///
/// # Errors
/// In words: a file that is no record.
pub(in crate::app) fn component_by(
    number: usize,
    path: &Path,
    folder: &Path,
    before: &Motion,
) -> Result<Shaking, String> {
    let Motion::Record(before) = before else { return Ok((before.clone(), None)) };
    let mut record = before.clone();
    record.loaded_components.resize(record.components.len(), None);
    let slots = record.components.get_mut(number).zip(record.loaded_components.get_mut(number));
    let Some((component, slot)) = slots else { return Ok((Motion::Record(record), None)) };
    let (loaded, unread) = read(&folder.join(path))?;
    let Component { azimuth_deg, vertical, scale, .. } = *component;
    let channel = channel_of(loaded.as_deref());
    let file = Some(seen_from(folder, path));
    *component = Component { file, channel, azimuth_deg, vertical, scale, ..Component::default() };
    *slot = loaded;
    Ok((Motion::Record(record), unread))
}

/// Shaking by these records: of files of which the same is stated as before what was read stays, others are read.
pub(in crate::app) fn read_anew(mut record: RecordMotion, folder: &Path, before: &Motion) -> Shaking {
    match before {
        Motion::Record(before) => record.take_loaded(before),
        _ => record.take_loaded(&RecordMotion::default()),
    }
    let mut motion = Motion::Record(record);
    let read = Records::in_folder(folder.to_owned()).complete_motion(("motion", &mut motion));
    (motion, read.err().map(|errors| errors.to_string()))
}

/// A record; none with what is missing, where it could be read if unit and interval were stated beside it.
fn read(path: &Path) -> Result<(Option<Arc<Record>>, Option<String>), String> {
    let errors = match read_record(path, &Supplement::default()) {
        Ok(record) => return Ok((Some(Arc::new(record)), None)),
        Err(errors) => errors.to_string(),
    };
    let both = Supplement { dt: Some(1.0), unit: Some(RecordUnit::G) };
    let dt = Supplement { dt: Some(1.0), unit: None };
    let unit = Supplement { dt: None, unit: Some(RecordUnit::G) };
    let could_be = [both, dt, unit].iter().any(|beside| read_record(path, beside).is_ok());
    if could_be { Ok((None, Some(errors))) } else { Err(errors) }
}

/// The first channel of a file that has several.
fn channel_of(record: Option<&Record>) -> Option<usize> {
    record.filter(|record| record.channels.len() > 1).map(|_| 1)
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
