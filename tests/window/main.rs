//! The window: what its lessons claim, computed (`gui`), and the whole of it, driven headless by its labels (`ui-tests`).

mod lesson_claims;

#[cfg(feature = "ui-tests")]
mod angles;
#[cfg(feature = "ui-tests")]
mod compare;
#[cfg(feature = "ui-tests")]
mod crowd;
#[cfg(feature = "ui-tests")]
mod devices;
#[cfg(feature = "ui-tests")]
mod fields;
#[cfg(feature = "ui-tests")]
mod files;
#[cfg(feature = "ui-tests")]
mod film;
#[cfg(feature = "ui-tests")]
mod framing;
#[cfg(feature = "ui-tests")]
#[path = "../pictures/golden.rs"]
mod golden;
#[cfg(feature = "ui-tests")]
mod grounds;
#[cfg(feature = "ui-tests")]
mod harness;
#[cfg(feature = "ui-tests")]
mod keys;
#[cfg(feature = "ui-tests")]
mod language;
#[cfg(feature = "ui-tests")]
mod layout;
#[cfg(feature = "ui-tests")]
mod lessons;
#[cfg(feature = "ui-tests")]
mod maps;
#[cfg(feature = "ui-tests")]
mod monkey;
#[cfg(feature = "ui-tests")]
mod numbers;
#[cfg(feature = "ui-tests")]
mod paths;
#[cfg(feature = "ui-tests")]
mod placing;
#[cfg(feature = "ui-tests")]
mod plots;
#[cfg(feature = "ui-tests")]
mod quake;
#[cfg(feature = "ui-tests")]
mod readings;
#[cfg(feature = "ui-tests")]
mod scene;
#[cfg(feature = "ui-tests")]
#[path = "../pictures/studio.rs"]
mod studio;
#[cfg(feature = "ui-tests")]
mod time;
#[cfg(feature = "ui-tests")]
mod views;
