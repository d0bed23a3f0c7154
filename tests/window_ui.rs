//! The whole window, driven headless by its labels: time, scene, layout.
#![cfg(feature = "ui-tests")]

#[path = "window/compare.rs"]
mod compare;
#[path = "window/crowd.rs"]
mod crowd;
#[path = "window/fields.rs"]
mod fields;
#[path = "window/files.rs"]
mod files;
#[path = "window/film.rs"]
mod film;
#[path = "pictures/golden.rs"]
mod golden;
#[path = "window/harness.rs"]
mod harness;
#[path = "window/keys.rs"]
mod keys;
#[path = "window/layout.rs"]
mod layout;
#[path = "window/lessons.rs"]
mod lessons;
#[path = "window/monkey.rs"]
mod monkey;
#[path = "window/numbers.rs"]
mod numbers;
#[path = "window/placing.rs"]
mod placing;
#[path = "window/readings.rs"]
mod readings;
#[path = "window/scene.rs"]
mod scene;
#[path = "pictures/studio.rs"]
mod studio;
#[path = "window/time.rs"]
mod time;
#[path = "window/views.rs"]
mod views;
