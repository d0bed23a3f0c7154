//! Films of marks made by the study: their errors stay where the theory of each influence has them.

use girderbench::scene::presets;
use girderbench::sim::History;
use girderbench::study::camera::{Camera, errors};

use crate::support::within;

/// Pictures of each film: half a second with two hits.
const COUNT: u32 = 16;

fn history() -> History {
    let mut scene = presets::load("skew45-abutment").expect("a preset");
    scene.duration = 1.0;
    History::of(&scene).expect("it runs")
}

/// RMS of the error of a film \[pixels\].
fn rms(history: &History, camera: &Camera) -> f64 {
    errors(history, camera, COUNT).expect("no mark is lost").rms() / camera.mm_per_pixel
}

#[test]
fn without_noise_and_blur_the_error_is_a_hundredth_of_a_pixel() {
    let history = history();
    let sharp = rms(&history, &Camera::papers());
    within("marks of 12 pixels [pixel]", sharp, 0.005);
    let small = rms(&history, &Camera { diameter: 4.0 * Camera::papers().mm_per_pixel, ..Camera::papers() });
    within("marks of 4 pixels [pixel]", small, 0.01);
    assert!(small > sharp && sharp > 0.0, "fewer pixels, more error");
}

#[test]
fn noise_moves_a_centroid_by_its_share_of_the_contrast() {
    let (history, noise) = (history(), 5.0);
    let found = rms(&history, &Camera { noise, ..Camera::papers() });
    // Of white noise over the disk of radius R in which the brightness Δ of a mark of radius r is weighed,
    // σ_x = (σ/Δ) √(Σ x²)/(π r²), Σ x² = π R⁴/4; a mean of three marks less that of two; since the first picture, √2.
    let radius = 0.5 * Camera::papers().diameter / Camera::papers().mm_per_pixel;
    let reach = radius + 2.0;
    let one =
        noise / 195.0 * (std::f64::consts::PI / 4.0).sqrt() * reach * reach / (std::f64::consts::PI * radius * radius);
    let expected = one * (2.0 * (1.0 / 3.0 + 1.0 / 2.0_f64)).sqrt();
    // 30 numbers of 16 pictures, of which the first is in all: their RMS is within a factor of 1.6 nearly always.
    within("over what white noise leads to, less 1", found / expected - 1.0, 0.6);
}

#[test]
fn an_exposure_moves_a_place_by_its_square_and_too_long_a_one_loses_marks() {
    let history = history();
    let film = |exposure: f64| rms(&history, &Camera { exposure, ..Camera::papers() });
    let [short, long] = [film(0.004), film(0.016)];
    assert!(long > 3.0 * short && long < 0.2, "4 ms: {short}, 16 ms: {long}");
    let smeared = errors(&history, &Camera { exposure: 0.033, diameter: 1.0, ..Camera::papers() }, COUNT);
    let lost = smeared.expect_err("smeared out").to_string();
    assert!(lost.contains("missing"), "{lost}");
}
