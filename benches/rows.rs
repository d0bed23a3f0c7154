//! Cost against size: rows of 1 to 1000 girders in which all or three collide, and rows side by side on one thread and on
//! all of them. One simulated second each.

use divan::{Bencher, black_box};
use girderbench::scene::Scene;
use girderbench::sim::History;

#[path = "../tests/support/rows.rs"]
mod rows;

use rows::Row;

fn main() {
    divan::main();
}

#[divan::bench(args = [1, 10, 100, 1000], sample_count = 10)]
fn all_collide(bencher: Bencher<'_, '_>, count: usize) {
    let scene = Row { tolerance: 1e-7, ..Row::many(count) }.scene();
    bencher.bench(|| History::of(black_box(&scene)));
}

#[divan::bench(args = [3, 10, 100, 1000], sample_count = 10)]
fn three_collide(bencher: Bencher<'_, '_>, count: usize) {
    let scene = Row { tolerance: 1e-7, ..Row::few(count) }.scene();
    bencher.bench(|| History::of(black_box(&scene)));
}

/// Sixteen rows of twenty side by side: sixteen groups that never feel one another.
fn lanes() -> Scene {
    let mut scene = Row { tolerance: 1e-7, ..Row::many(20) }.scene();
    let (row, walls) = (scene.girders.clone(), scene.abutments.clone());
    for lane in 1..16 {
        for girder in &row {
            let mut girder = girder.clone();
            girder.name = format!("{}-{lane}", girder.name);
            girder.position[1] = f64::from(lane) * 0.3;
            scene.girders.push(girder);
        }
        for wall in &walls {
            let mut wall = wall.clone();
            wall.name = format!("{}-{lane}", wall.name);
            wall.faces = format!("{}-{lane}", wall.faces);
            scene.abutments.push(wall);
        }
    }
    scene
}

/// Groups on a pool of so many threads; 0 is one for every core.
#[divan::bench(args = [1, 2, 0], sample_count = 10)]
fn sixteen_rows_on_threads(bencher: Bencher<'_, '_>, threads: usize) {
    let scene = lanes();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap_or_else(|error| panic!("{error}"));
    bencher.bench(|| pool.install(|| History::of(black_box(&scene))));
}
