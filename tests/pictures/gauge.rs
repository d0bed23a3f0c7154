//! What a contact's picture says without colour, legend or words: how much of the cone is used, stick or slip.

use crate::handmade;
use crate::studio::studio;
use girderbench::render::Image;
use girderbench::scene::Overlays;
use girderbench::sim::ContactState;
use girderbench::view::list::Mark;
use girderbench::view::{Moment, draw_moment, gauge};

const SIZE: [u32; 2] = [640, 360];
/// Pixels to a point: a larger gauge is measured finer.
const PPP: f32 = 2.0;
/// Nothing that could tell by words or legend.
const BARE: Overlays = Overlays {
    grid: true,
    bearings: true,
    gap: false,
    contacts: true,
    normal: false,
    tangential: false,
    resultant: true,
    damping: false,
    cones: true,
    axes: false,
    legend: false,
    title: false,
    names: false,
    decoration: false,
};

/// How bright a pixel is in grey print, 0 to 1 (Rec. 709).
fn grey(image: &Image, x: u32, y: u32) -> f64 {
    let at = ((y * image.width + x) * 4) as usize;
    let [r, g, b] = [0, 1, 2].map(|i| f64::from(image.rgba[at + i]) / 255.0);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Rows of the gauge of the hardest contact from below: whether each is dark at the left, where no tick is.
fn rows(studio: &mut girderbench::snapshot::Studio, scene: &girderbench::scene::Scene, moment: &Moment) -> Vec<bool> {
    let camera = handmade::camera(scene, SIZE);
    let input = handmade::input(scene, &camera, SIZE, PPP, BARE);
    let mut list = draw_moment(&input, moment);
    list.marks.retain(|mark| !matches!(mark, Mark::Text { .. }));
    let image = studio.draw(&list).expect("it is drawn");
    let [min, max] = gauge::place(&input, &moment.contacts[0]).expect("in the picture");
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "pixels of a picture")]
    let [x, top, bottom] = [min.x + 0.3 * (max.x - min.x), min.y, max.y].map(|v| v.round() as u32);
    (top..bottom).rev().map(|y| grey(&image, x, y) < 0.6).collect()
}

#[test]
fn the_gauge_stays_where_it_is_when_the_friction_turns_round() {
    let (scene, mut moment) = handmade::sticking(0.6);
    let camera = handmade::camera(&scene, SIZE);
    let input = handmade::input(&scene, &camera, SIZE, PPP, BARE);
    let before = gauge::place(&input, &moment.contacts[0]);
    moment.contacts[0].tangential_force *= -1.0;
    assert!(before.is_some() && gauge::place(&input, &moment.contacts[0]) == before, "{before:?}");
}

#[test]
fn the_gauge_is_filled_as_far_as_the_cone_is_used_and_hatched_in_slip() {
    let Some(mut studio) = studio("the_gauge_is_filled_as_far_as_the_cone_is_used_and_hatched_in_slip") else { return };
    for share in [0.3, 0.6, 0.9] {
        let (scene, moment) = handmade::sticking(share);
        let rows = rows(&mut studio, &scene, &moment);
        let filled = rows.iter().filter(|dark| **dark).count() as f64 / rows.len() as f64;
        // A row at either end is blurred.
        assert!((filled - share).abs() < 2.0 / rows.len() as f64, "{share} of it: {filled} in {} rows", rows.len());
        assert!(rows.windows(2).filter(|two| two[0] != two[1]).count() <= 1, "one level, from below: {rows:?}");
    }
    let (scene, mut moment) = handmade::pressed([ContactState::Slip; 2]);
    moment.contacts.truncate(1);
    let rows = rows(&mut studio, &scene, &moment);
    let stripes = rows.windows(2).filter(|two| two[0] && !two[1]).count();
    assert!(stripes >= 5, "hatched over its whole height: {rows:?}");
}
