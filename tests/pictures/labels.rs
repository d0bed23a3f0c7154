//! Where words stand in a picture.

use girderbench::scene::{Overlays, presets};
use girderbench::view::list::Mark;
use girderbench::view::{Moment, ViewInput, draw_moment};
use glam::Vec2;

use crate::handmade;

#[test]
fn words_keep_clear_of_what_is_drawn_over_the_picture() {
    let scene = presets::load("skew45-abutment").expect("a preset");
    let (size, moment) = ([1280, 720], Moment::placed(&scene));
    let camera = handmade::camera(&scene, size);
    let input = handmade::input(&scene, &camera, size, 1.0, Overlays::default());
    let gap = |clear: &[Vec2]| {
        let list = draw_moment(&ViewInput { clear, ..input }, &moment);
        let words = list.marks.into_iter().find_map(|mark| match mark {
            Mark::Text { at, text, .. } if text.starts_with("gap ") => Some(at),
            _ => None,
        });
        words.expect("the gap's words")
    };
    let usual = gap(&[]);
    // A handle's half is 9 points, that of a line of words 8 at the least.
    let moved = gap(&[usual]);
    assert!((moved - usual).length() > 17.0, "from {usual} to {moved}");
    let beside = usual + Vec2::new(0.0, 60.0);
    assert_eq!(gap(&[beside]), usual, "a handle elsewhere moves nothing");
}
