//! Long rows: work and memory go with what happens, not with how many stand by; the answer does not know how many threads
//! computed it.

use crate::support::rows::{self, Row};
use crate::support::{run, within};
use girderbench::motion::{Ground, Samples};
use girderbench::scene::facing;
use girderbench::scene::{Motion, Scene, presets};
use girderbench::sim::{Comparison, History};

#[test]
fn three_that_touch_among_a_thousand_take_the_steps_of_three() {
    let (three, thousand) = (run(&Row::few(3).scene()), run(&Row::few(1000).scene()));
    assert!(three.summary().hits >= 4, "the three do touch: {:?}", three.summary());
    assert_eq!(thousand.summary().hits, three.summary().hits, "the same hits");
    assert_eq!(thousand.effort().steps, three.effort().steps, "the same steps");
    // Whoever stands by is searched once, at the start, and seen to be out of reach for good.
    let by = 1001 - 4;
    assert_eq!(thousand.effort().searches, three.effort().searches + by, "one search each");
    // The three see a neighbour now where a wall stood.
    assert!(thousand.effort().looks <= three.effort().looks + by + 100, "{:?}", thousand.effort());
    let apart = (0..3).map(|n| {
        let (few, many) = (three.motion(n, 1.0).displacement, thousand.motion(499 + n, 1.0).displacement);
        (few - many).length()
    });
    // A thousand lie up to 200 m from the origin, where places round to 3e-14 m; hits make some hundred times more of it.
    within("the three among a thousand", apart.fold(0.0, f64::max), 1e-11);
}

#[test]
fn work_grows_with_the_length_of_a_row_and_no_faster() {
    let per_girder = |count: usize| {
        let effort = run(&Row::many(count).scene()).effort();
        [effort.searches, effort.looks, effort.steps].map(|n| n as f64 / count as f64)
    };
    let (ten, hundreds) = (per_girder(10), per_girder(300));
    for (few, many) in ten.into_iter().zip(hundreds) {
        // Ten have two walls, and draws of their own.
        assert!(many < 1.5 * few, "{hundreds:?} a girder against {ten:?}");
    }
}

#[test]
fn a_row_at_rest_is_looked_at_once() {
    let mut scene = Row::many(50).scene();
    scene.motion = Motion::None;
    let effort = run(&scene).effort();
    assert_eq!((effort.steps, effort.searches, effort.looks), (0, 51, 51), "a look a pair");
}

#[test]
fn like_girders_under_a_record_are_looked_at_once() {
    let mut scene = Row::few(40).scene();
    scene.girders[20].bearings = scene.girders[0].bearings.clone();
    scene.motion = rows::record(800, 1e-9).motion;
    let effort = run(&scene).effort();
    assert_eq!(effort.steps, 0, "nobody touches");
    // The walls at the ends do not sway with the row.
    let between = 39;
    assert!(effort.searches < 2 * 60 + between, "{effort:?}");
}

fn in_a_pool(threads: usize, scene: &Scene) -> History {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
    pool.install(|| run(scene))
}

#[test]
fn the_answer_is_the_same_to_the_last_bit_for_any_number_of_threads() {
    // Ten rows side by side: groups that never feel one another.
    let mut scene = Row::many(12).scene();
    let (row, walls) = (scene.girders.clone(), scene.abutments.clone());
    for lane in 1..10 {
        for girder in &row {
            let mut girder = girder.clone();
            girder.name = format!("{}-{lane}", girder.name);
            girder.position[1] = f64::from(lane) * 0.3;
            girder.mass *= 1.0 + 0.01 * f64::from(lane);
            scene.girders.push(girder);
        }
        for wall in &walls {
            let mut wall = wall.clone();
            wall.name = format!("{}-{lane}", wall.name);
            wall.faces = format!("{}-{lane}", wall.faces);
            scene.abutments.push(wall);
        }
    }
    let (one, two, five) = (in_a_pool(1, &scene), in_a_pool(2, &scene), in_a_pool(5, &scene));
    assert_eq!(one.model().groups.len(), 10, "ten groups");
    assert!(one.events().len() > 1000, "{} events", one.events().len());
    assert_eq!(one.digest(), two.digest(), "two threads");
    assert_eq!(one.digest(), five.digest(), "five threads");
    assert_eq!(one.events(), five.events(), "events in the same order");
    assert_eq!(one.effort(), five.effort(), "by the same work");
}

/// The same row along another direction.
fn turned(scene: &Scene, degrees: f64) -> Scene {
    let mut turned = scene.clone();
    let along = Ground::direction(degrees);
    for girder in &mut turned.girders {
        girder.heading_deg += degrees;
        let x = girder.position[0];
        (girder.position[0], girder.position[1]) = (x * along.x, x * along.y);
    }
    if let Motion::Sine(sine) = &mut turned.motion {
        sine.angle_deg += degrees;
    }
    turned
}

#[test]
fn a_row_in_line_with_an_axis_moves_as_one_that_is_computed_in_the_plan() {
    // Along x and along y all is one coordinate; along any other direction nodes and faces are told apart.
    let scene = Row { duration: 0.6, ..Row::many(8) }.scene();
    let along_x = run(&scene);
    assert!(along_x.summary().hits > 10, "neighbours collide: {:?}", along_x.summary());
    for (degrees, bound) in [(90.0, 1e-13), (180.0, 1e-13), (-90.0, 1e-13), (30.0, 1e-11), (-137.0, 1e-11)] {
        let other = run(&turned(&scene, degrees));
        let along = Ground::direction(degrees);
        let apart = (0..=600).flat_map(|k| (0..8).map(move |n| (n, f64::from(k) * 1e-3))).map(|(n, t)| {
            let (one, two) = (along_x.motion(n, t), other.motion(n, t));
            let moved = two.displacement;
            let [forth, aside] = [moved.dot(along), along.x * moved.y - along.y * moved.x];
            (forth - one.displacement.x).abs().max(aside.abs()).max(0.1 * two.theta.abs())
        });
        // Rounding of places in the plan, some hundred times larger after the hits.
        within("a row in another direction", apart.fold(0.0, f64::max), bound);
        assert_eq!(other.events().len(), along_x.events().len(), "the same events along {degrees}°");
        assert_eq!(other.effort().steps, along_x.effort().steps, "the same steps along {degrees}°");
    }
}

#[test]
fn a_row_answers_as_its_finer_self() {
    let row = Row { duration: 0.6, ..Row::many(8) };
    let (coarse, fine) = (run(&row.scene()), run(&Row { tolerance: 1e-13, ..row }.scene()));
    assert!(coarse.summary().hits > 10, "neighbours collide: {:?}", coarse.summary());
    within("a row of 8 at 1e-9 against 1e-13", Comparison::of(&coarse, &fine).of_all().place, 1e-9);
}

#[test]
fn everyone_in_a_long_row_faces_his_neighbours() {
    let pairs = facing::find(&Row::many(400).scene()).expect("a valid row");
    let names: Vec<&str> = pairs.iter().map(|pair| pair.name.as_str()).collect();
    let mut expected: Vec<String> = (0..399).map(|n| format!("g{n}+x|g{}-x", n + 1)).collect();
    expected.insert(1, "g0-x|left".to_owned());
    expected.push("g399+x|right".to_owned());
    assert_eq!(names, expected, "in the order of the file");
}

#[test]
fn a_record_is_kept_once_however_many_fly_under_it() {
    let scene = presets::load("row-of-5").expect("a preset");
    let mut scene = scene;
    scene.motion = rows::record(4000, 1e-9).motion;
    scene.duration = 2.0;
    let history = run(&scene);
    let Ground::Record { samples: Samples::Along { values, .. }, .. } = &history.model().ground else {
        panic!("a record along one direction")
    };
    assert!(std::sync::Arc::strong_count(values) > 5, "the girders share the model's samples");
}
