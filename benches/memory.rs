//! What a history of 1000 girders over 60 s takes: the largest resident size of the process after each run.
//! `cargo bench --no-default-features --bench memory [TOLERANCE]`; Linux only, where the system tells it.

#![expect(clippy::print_stdout, reason = "a bench prints its figures")]

#[path = "../tests/support/rows.rs"]
mod rows;

use girderbench::scene::{Direction, Kind};
use girderbench::sim::History;
use rows::Row;

/// Largest resident size of this process so far \[MB\].
fn peak_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().trim_end_matches(" kB").trim().parse().ok().map(|kb: f64| kb / 1024.0)
}

fn main() {
    let tolerance = std::env::args().skip(1).find_map(|a| a.parse().ok()).unwrap_or(1e-8);
    let row = Row { duration: 60.0, tolerance, ..Row::many(1000) };
    // From few to many, because a peak never falls.
    let few = Row { all: false, wall_gap: 0.05, ..row };
    let mut oblique = Row { count: 1000, ..row }.scene();
    if let girderbench::scene::Motion::Sine(sine) = &mut oblique.motion {
        sine.angle_deg = 20.0;
    }
    println!("{:<28} {:>10} {:>10} {:>12} {:>12}", "row of 1000, 60 s", "events", "steps", "answer MB", "peak MB");
    // Twice as many nodes, and flights in steps: a girder in space has no closed form.
    let in_space = |row: Row| {
        let mut scene = row.scene();
        scene.kind = Kind::Spatial;
        for girder in &mut scene.girders {
            girder.held = vec![Direction::Z, Direction::Roll, Direction::Pitch];
        }
        scene
    };
    let cases = [
        ("three collide", few.scene()),
        ("three collide, in space", in_space(few)),
        ("all collide head-on", row.scene()),
        ("all collide at 20°", oblique),
        ("all collide, in space", in_space(row)),
    ];
    for (name, scene) in cases {
        let history = History::of(&scene).unwrap_or_else(|errors| panic!("{errors}"));
        let peak = peak_mb().map_or_else(|| "unknown".to_owned(), |mb| format!("{mb:.0}"));
        let answer = history.bytes() as f64 / 1_048_576.0;
        println!("{name:<28} {:>10} {:>10} {answer:>12.0} {peak:>12}", history.events().len(), history.effort().steps);
    }
}
