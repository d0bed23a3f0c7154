//! Files of an earlier answer in a folder that a later one is written into.

use std::path::Path;

use super::read::{LARGEST_INPUT, read_regular};

/// Files that the summaries in a folder name, as `names` reads them from the bytes of one.
pub fn earlier_files(folder: &Path, summaries: &[&str], names: fn(&[u8]) -> Vec<String>) -> Vec<String> {
    let summaries = summaries.iter().filter_map(|summary| read_regular(&folder.join(summary), LARGEST_INPUT).ok());
    summaries.flat_map(|bytes| names(&bytes)).collect()
}

/// Removes regular files from a folder; returns those that are gone now.
pub fn remove_files<'a>(folder: &Path, names: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let remove = |name: &&str| {
        let path = folder.join(name);
        path.symlink_metadata().is_ok_and(|about| about.is_file()) && std::fs::remove_file(path).is_ok()
    };
    names.into_iter().filter(remove).collect()
}
