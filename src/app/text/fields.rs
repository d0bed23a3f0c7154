//! Words around fields: what they say of themselves, the ground motion, contact numbers of all pairs.

use crate::language::{Text, values};
use crate::scene::keys::{self, Key};

// What a field says of itself.
pub(in crate::app) const ALLOWED: Text = Text::new("allowed");
pub(in crate::app) const DEFAULT: Text = Text::new("default");
pub(in crate::app) const NO_DEFAULT: Text = Text::new("no-default");
pub(in crate::app) const MUST_BE_GIVEN: Text = Text::new("must-be-given");
pub(in crate::app) const NO_NUMBER: Text = Text::new("no-number");
pub(in crate::app) const RESET_VALUE: Text = Text::new("reset-value");
pub(in crate::app) const RESET_TO: Text = Text::new("reset-to");
pub(in crate::app) const ON: Text = Text::new("on");
pub(in crate::app) const OFF: Text = Text::new("off");
pub(in crate::app) const TYPED: Text = Text::new("typed");
pub(in crate::app) const TYPED_TWO: Text = Text::new("typed-two");

// How the ground moves.
pub(in crate::app) const GROUND: Text = Text::new("ground");
pub(in crate::app) const STILL: Text = Text::new("still");
pub(in crate::app) const SINE: Text = Text::new("sine");
pub(in crate::app) const RECORD: Text = Text::new("record");
pub(in crate::app) const SYNTHETIC: Text = Text::new("synthetic");
pub(in crate::app) const SWEEP: Text = Text::new("sweep");
pub(in crate::app) const AMPLITUDE_IN: Text = Text::new("amplitude-in");
pub(in crate::app) const RECORD_FILE: Text = Text::new("record-file");
pub(in crate::app) const RECORD_IN_SCENE: Text = Text::new("record-in-scene");
pub(in crate::app) const CHOOSE: Text = Text::new("choose");
/// Files of every format of records.
pub(in crate::app) const RECORDS: Text = Text::new("records");
pub(in crate::app) const SCENES: Text = Text::new("scene-files");
pub(in crate::app) const KEEP_RECORD: Text = Text::new("keep-record");
pub(in crate::app) const KEEP_RECORD_HINT: Text = Text::new("keep-record-hint");
pub(in crate::app) const SAMPLES_FOLD: Text = Text::new("samples-fold");
pub(in crate::app) const SAMPLES: Text = Text::new("samples");
pub(in crate::app) const TOO_MANY_SAMPLES: Text = Text::new("too-many-samples");
pub(in crate::app) const NO_SAMPLE: Text = Text::new("no-sample");
pub(in crate::app) const CHANNEL: Text = Text::new("channel");
pub(in crate::app) const PROCESSING_FOLD: Text = Text::new("processing-fold");
pub(in crate::app) const UPWARDS: Text = Text::new("upwards");
pub(in crate::app) const NO_DIRECTION: Text = Text::new("no-direction");
pub(in crate::app) const IN_PLAN: Text = Text::new("in-plan");
pub(in crate::app) const AS_FILE_STATES: Text = Text::new("as-file-states");
pub(in crate::app) const X_AZIMUTH: Text = Text::new("x-azimuth");
pub(in crate::app) const POINTS: Text = Text::new("points");
pub(in crate::app) const RECORD_UNIT: Text = Text::new("record-unit");
pub(in crate::app) const INTERVAL: Text = Text::new("interval");
pub(in crate::app) const NOT_READ: Text = Text::new("not-read");
pub(in crate::app) const ADD_COMPONENT: Text = Text::new("add-component");
pub(in crate::app) const TARGET_FOLD: Text = Text::new("target-fold");
pub(in crate::app) const TARGET_ADD: Text = Text::new("target-add");
pub(in crate::app) const TARGET_NONE: Text = Text::new("target-none");
pub(in crate::app) const TARGET_REMOVE: Text = Text::new("target-remove");
pub(in crate::app) const TARGET_POINT: Text = Text::new("target-point");
pub(in crate::app) const SHAKE: Text = Text::new("shake");
pub(in crate::app) const MOTION_SECTION: Text = Text::new("motion-section");

// Histories and spectrum of the ground motion.
pub(in crate::app) const QUAKE: Text = Text::new("quake");
pub(in crate::app) const GROUND_SHOWN: Text = Text::new("ground-shown");
pub(in crate::app) const GROUND_OF_MOTION: Text = Text::new("ground-of-motion");
pub(in crate::app) const GROUND_NAME: Text = Text::new("ground-name");
pub(in crate::app) const GROUND_UNDER: Text = Text::new("ground-under");
pub(in crate::app) const GROUND_ADD: Text = Text::new("ground-add");
pub(in crate::app) const GROUND_ADD_HINT: Text = Text::new("ground-add-hint");
pub(in crate::app) const GROUND_REMOVE: Text = Text::new("ground-remove");
pub(in crate::app) const WAVE_ADD: Text = Text::new("wave-add");
pub(in crate::app) const WAVE_REMOVE: Text = Text::new("wave-remove");
pub(in crate::app) const QUAKE_OPEN: Text = Text::new("quake-open");
pub(in crate::app) const QUAKE_OPEN_HINT: Text = Text::new("quake-open-hint");
pub(in crate::app) const QUAKE_STILL: Text = Text::new("quake-still");
pub(in crate::app) const QUAKE_TIME: Text = Text::new("quake-time");
pub(in crate::app) const QUAKE_PERIOD: Text = Text::new("quake-period");
pub(in crate::app) const QUAKE_HINT: Text = Text::new("quake-hint");

// Contact of all pairs, and pairs by name.
pub(in crate::app) const ALL_PAIRS_SECTION: Text = Text::new("all-pairs-section");
pub(in crate::app) const WHOSE_ALL: Text = Text::new("whose-all");
pub(in crate::app) const THE_SCENES: Text = Text::new("the-scenes");
pub(in crate::app) const DECLARED_SECTION: Text = Text::new("declared-section");
pub(in crate::app) const ADD_ENTRY: Text = Text::new("add-entry");

// Devices between two points.
pub(in crate::app) const ADD_DEVICE: Text = Text::new("add-device");
pub(in crate::app) const DEVICE_ON: Text = Text::new("device-on");
pub(in crate::app) const DEVICE_AT: Text = Text::new("device-at");
pub(in crate::app) const DEVICE_TO: Text = Text::new("device-to");
pub(in crate::app) const DEVICE_TO_AT: Text = Text::new("device-to-at");
pub(in crate::app) const GROUND_ITSELF: Text = Text::new("ground-itself");
pub(in crate::app) const DEVICE_NORMAL: Text = Text::new("device-normal");
pub(in crate::app) const DEVICE_DIRECTION: Text = Text::new("device-direction");
pub(in crate::app) const DEVICE_TABLE: Text = Text::new("device-table");
pub(in crate::app) const DEVICE_TABLE_POINT: Text = Text::new("device-table-point");
pub(in crate::app) const DEVICE_ASSUMED: Text = Text::new("device-assumed");
pub(in crate::app) const ASSUMED_SECTION: Text = Text::new("assumed-section");
pub(in crate::app) const DIFFERS_HINT: Text = Text::new("differs-hint");
pub(in crate::app) const ASSUMED_HINT: Text = Text::new("assumed-hint");

/// The button that says of an assumed value that it is right.
pub(in crate::app) fn given(path: &str) -> String {
    Text::new("given").with(&values!["path" => path])
}

/// Name of the field of a key of the scene file.
pub(in crate::app) fn field(key: &Key) -> &'static str {
    key.label.map_or(key.name, |label| Text::new(label).as_str())
}

/// Name of the key at a place of the scene, without its unit: `girder.deck.skew_deg` is the skew of the deck.
pub(in crate::app) fn title_of(place: &str) -> String {
    let label = keys::of_place(place).map_or(place, |(_, key)| field(key));
    match place.split('.').collect::<Vec<_>>()[..] {
        ["girder" | "abutment", name, ..] if name != place => of_whom(label, name),
        [_, name, _] => of_whom(label, name),
        _ => label.to_owned(),
    }
}

/// Name of a quantity of a part of the scene.
pub(in crate::app) fn of_whom(quantity: &str, part: &str) -> String {
    Text::new("of-whom").with(&values!["quantity" => quantity, "part" => part])
}

/// Name of a kind of device.
pub(in crate::app) fn device_kind(kind: crate::scene::DeviceKind) -> &'static str {
    use crate::scene::DeviceKind;
    let words = match kind {
        DeviceKind::Restrainer => Text::new("device-restrainer"),
        DeviceKind::Bumper => Text::new("device-bumper"),
        DeviceKind::Damper => Text::new("device-damper"),
        DeviceKind::Stopper => Text::new("device-stopper"),
    };
    words.as_str()
}

/// Label of the button that adds a device.
pub(in crate::app) fn add_device(kind: crate::scene::DeviceKind) -> String {
    Text::new("add-device-kind").with(&values!["kind" => device_kind(kind).to_lowercase()])
}

/// Names of a depth and its force, and of the button that takes both away.
pub(in crate::app) fn depth(number: usize) -> [String; 3] {
    ["depth", "force-at-depth", "remove-depth"].map(|key| Text::new(key).with(&values!["number" => number]))
}
