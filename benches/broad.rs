//! Who is near whom in a row: the tree of boxes against asking everyone about everyone.

use divan::{Bencher, black_box};
use girderbench::geometry::broad::Broad;
use girderbench::geometry::shape::AlignedBox;
use girderbench::scene::facing;
use girderbench::scene::validate::validate;
use glam::DVec3;

#[path = "../tests/support/rows.rs"]
mod rows;

const LENGTHS: [usize; 3] = [10, 100, 1000];

fn main() {
    divan::main();
}

/// Boxes of a row whose gaps the boxes' margins close.
fn boxes(count: usize) -> Vec<AlignedBox> {
    let hull = |n: usize| {
        let min = DVec3::new(n as f64 * 0.193 - 0.1, -0.04, -0.01);
        AlignedBox { min, max: min + DVec3::new(0.2, 0.08, 0.02) }
    };
    (0..count).map(hull).collect()
}

#[divan::bench(args = LENGTHS)]
fn pairs_by_tree(bencher: Bencher<'_, '_>, count: usize) {
    let boxes = boxes(count);
    bencher.bench(|| Broad::of(black_box(&boxes).iter().copied()).pairs().len());
}

#[divan::bench(args = LENGTHS)]
fn pairs_by_asking_all(bencher: Bencher<'_, '_>, count: usize) {
    let boxes = boxes(count);
    let meet = |a: &AlignedBox, b: &AlignedBox| a.min.cmple(b.max).all() && b.min.cmple(a.max).all();
    bencher.bench(|| {
        let boxes = black_box(&boxes);
        let of = |a: usize| (a + 1..boxes.len()).filter(|&b| meet(&boxes[a], &boxes[b])).count();
        (0..boxes.len()).map(of).sum::<usize>()
    });
}

/// The neighbours of one girder, from the tree.
#[divan::bench(args = LENGTHS)]
fn neighbours_from_the_tree(bencher: Bencher<'_, '_>, count: usize) {
    let (boxes, mut found) = (boxes(count), Vec::new());
    let tree = Broad::of(boxes.iter().copied());
    bencher.bench_local(|| {
        tree.meeting(black_box(&boxes[count / 2]), &mut found);
        found.len()
    });
}

/// The neighbours of one girder, by asking all.
#[divan::bench(args = LENGTHS)]
fn neighbours_by_asking_all(bencher: Bencher<'_, '_>, count: usize) {
    let boxes = boxes(count);
    let meet = |a: &AlignedBox, b: &AlignedBox| a.min.cmple(b.max).all() && b.min.cmple(a.max).all();
    bencher.bench(|| {
        let moved = black_box(boxes[count / 2]);
        boxes.iter().filter(|b| meet(&moved, b)).count()
    });
}

/// Facing ends of a whole row.
#[divan::bench(args = LENGTHS)]
fn who_faces_whom(bencher: Bencher<'_, '_>, count: usize) {
    let scene = rows::Row::many(count).scene();
    bencher.bench(|| facing::find(black_box(&scene)).map(|pairs| pairs.len()));
}

/// Everything that is checked before a run.
#[divan::bench(args = LENGTHS)]
fn validation(bencher: Bencher<'_, '_>, count: usize) {
    let scene = rows::Row::many(count).scene();
    bencher.bench(|| validate(black_box(&scene)));
}
