//! Commands about the map of a run's number over two keys, and what a map is to show.

/// A key that varies: from where to where, in the unit of the key.
#[derive(Clone, Debug, PartialEq)]
pub struct MapAxis {
    /// The path of the key, as `--set` takes it.
    pub key: String,
    /// At the left or at the bottom.
    pub from: f64,
    /// At the right or at the top.
    pub to: f64,
    /// Whether values grow in equal ratios.
    pub is_log: bool,
}

/// Choices of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapDraft {
    /// The key across, and the key upwards.
    pub axes: [MapAxis; 2],
    /// Name of the measure.
    pub measure: &'static str,
    /// Values of each key.
    pub cells: usize,
}

/// The map of a run's number over two keys.
#[derive(Clone, Debug, PartialEq)]
pub enum MapCommand {
    /// Show it, or not.
    Show(bool),
    /// Show something else.
    Draft(MapDraft),
    /// Compute it.
    Compute,
    /// Stop computing; what has come out stays.
    Cancel,
    /// Give the scene the values of a cell: its number across, its number upwards.
    Go([usize; 2]),
}
