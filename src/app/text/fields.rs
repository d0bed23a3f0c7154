//! Words around fields: what they say of themselves, the ground motion, contact numbers of all pairs.

// What a field says of itself.
pub(in crate::app) const ALLOWED: &str = "Allowed";
pub(in crate::app) const DEFAULT: &str = "Default";
pub(in crate::app) const NO_DEFAULT: &str = "No default";
pub(in crate::app) const MUST_BE_GIVEN: &str = "It must be given: it stays as it was.";
pub(in crate::app) const NO_NUMBER: &str = "is no number here: write one alone or with";
pub(in crate::app) const RESET_VALUE: &str = "Reset";
pub(in crate::app) const RESET_TO: &str = "Reset to";
pub(in crate::app) const ON: &str = "on";
pub(in crate::app) const OFF: &str = "off";
pub(in crate::app) const TYPED: &str = "Enter: set   Esc: put back";
pub(in crate::app) const TYPED_TWO: &str = "Tab: the other   Enter: set   Esc: put back";

// How the ground moves.
pub(in crate::app) const GROUND: &str = "Ground";
pub(in crate::app) const STILL: &str = "still";
pub(in crate::app) const SINE: &str = "sine";
pub(in crate::app) const RECORD: &str = "record";
pub(in crate::app) const SYNTHETIC: &str = "synthetic earthquake";
pub(in crate::app) const SWEEP: &str = "sine sweep";
pub(in crate::app) const AMPLITUDE_IN: &str = "Given in";
pub(in crate::app) const RECORD_FILE: &str = "Record file";
pub(in crate::app) const RECORD_IN_SCENE: &str = "in the scene itself";
pub(in crate::app) const CHOOSE: &str = "Choose…";
/// Files of every format of records.
pub(in crate::app) const RECORDS: &str = "Records";
pub(in crate::app) const KEEP_RECORD: &str = "Keep its samples in the scene";
pub(in crate::app) const KEEP_RECORD_HINT: &str = "The file is not needed then";
pub(in crate::app) const SAMPLES_FOLD: &str = "Samples";
pub(in crate::app) const SAMPLES: &str = "Samples, m/s²";
pub(in crate::app) const TOO_MANY_SAMPLES: &str = "Too many to be written out: choose a file.";
pub(in crate::app) const NO_SAMPLE: &str = "is no number: write accelerations in m/s², with spaces between them";
pub(in crate::app) const CHANNEL: &str = "Channel";
pub(in crate::app) const PROCESSING_FOLD: &str = "Processing";
pub(in crate::app) const UPWARDS: &str = "Upwards";
pub(in crate::app) const NO_DIRECTION: &str = "No direction";
pub(in crate::app) const IN_PLAN: &str = "in plan";
pub(in crate::app) const AS_FILE_STATES: &str = "as the file states";
pub(in crate::app) const X_AZIMUTH: &str = "Azimuth of x";
pub(in crate::app) const POINTS: &str = "Points";
pub(in crate::app) const RECORD_UNIT: &str = "Unit";
pub(in crate::app) const INTERVAL: &str = "Interval";
pub(in crate::app) const NOT_READ: &str = "No file has been read, and there are no samples.";
pub(in crate::app) const ADD_COMPONENT: &str = "Add a component";
pub(in crate::app) const TARGET_FOLD: &str = "Target spectrum";
pub(in crate::app) const TARGET_ADD: &str = "Match it to a spectrum";
pub(in crate::app) const TARGET_NONE: &str = "It has its own spectrum.";
pub(in crate::app) const TARGET_REMOVE: &str = "Match it to none";
pub(in crate::app) const TARGET_POINT: &str = "Add a period";
pub(in crate::app) const SHAKE: &str = "Shake it";
pub(in crate::app) const MOTION_SECTION: &str = "Ground motion";

// Histories and spectrum of the ground motion.
pub(in crate::app) const QUAKE: &str = "Ground motion";
pub(in crate::app) const QUAKE_OPEN: &str = "Histories and spectrum…";
pub(in crate::app) const QUAKE_OPEN_HINT: &str =
    "Acceleration, velocity, displacement and the 5 % response spectrum, with the girders' own periods";
pub(in crate::app) const QUAKE_STILL: &str = "The ground stands still.";
pub(in crate::app) const QUAKE_TIME: &str = "time [s]";
pub(in crate::app) const QUAKE_PERIOD: &str = "natural period [s], 5 % damping";
pub(in crate::app) const QUAKE_HINT: &str = "As it shakes, scaled; integrated from rest. Dots: the girders' own periods on their bearings. A click in a history goes to that time.";

// Contact of all pairs, and pairs by name.
pub(in crate::app) const ALL_PAIRS_SECTION: &str = "Contact of all pairs";
pub(in crate::app) const OF_ALL: &str = "of all";
pub(in crate::app) const THE_SCENES: &str = "the scene's";
pub(in crate::app) const DECLARED_SECTION: &str = "Pairs by name";
pub(in crate::app) const ADD_ENTRY: &str = "Name a pair";

// Devices between two points.
pub(in crate::app) const ADD_DEVICE: &str = "Add device";
pub(in crate::app) const DEVICE_ON: &str = "On girder";
pub(in crate::app) const DEVICE_AT: &str = "At";
pub(in crate::app) const DEVICE_TO: &str = "To";
pub(in crate::app) const DEVICE_TO_AT: &str = "To";
pub(in crate::app) const GROUND_ITSELF: &str = "the ground";
pub(in crate::app) const DEVICE_NORMAL: &str = "Normal given";
pub(in crate::app) const DEVICE_DIRECTION: &str = "Direction given";
pub(in crate::app) const DEVICE_TABLE: &str = "Give a table of forces";
pub(in crate::app) const DEVICE_TABLE_POINT: &str = "Add a depth";
pub(in crate::app) const DEVICE_ASSUMED: &str =
    "What a new device begins with is assumed: it fits the weight and the length of its girder.";

/// What a kind of device is called.
pub(in crate::app) fn device_kind(kind: crate::scene::DeviceKind) -> &'static str {
    use crate::scene::DeviceKind;
    match kind {
        DeviceKind::Restrainer => "Restrainer cable",
        DeviceKind::Bumper => "Bumper",
        DeviceKind::Damper => "Damper",
        DeviceKind::Stopper => "Stopper",
    }
}

/// What adds a device.
pub(in crate::app) fn add_device(kind: crate::scene::DeviceKind) -> String {
    format!("Add {}", device_kind(kind).to_lowercase())
}

/// Names of a depth and its force, and of the button that takes both away.
pub(in crate::app) fn depth(number: usize) -> [String; 3] {
    [format!("Depth {number}"), format!("Force {number}"), format!("Remove depth {number}")]
}
