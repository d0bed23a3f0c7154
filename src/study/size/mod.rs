//! Cost against size: rows of 1 to 1000 girders, with many neighbours colliding and with few.

mod page;
mod rows;

use crate::plot::{COLORS, Guide, Marker, Plot, Series, Ticks};
use crate::scene::{Scene, SceneErrors};
use crate::sim::{Comparison, History};
use crate::study::clock::fastest;

pub use page::page;
pub use rows::{colliding, few_touch};

/// Girders in a row.
pub const SIZES: [usize; 5] = [1, 3, 10, 100, 1000];
/// Sizes in a quick study.
pub const SIZES_QUICK: [usize; 4] = [1, 3, 10, 100];

/// One measurement.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name of the row of girders.
    pub scene: &'static str,
    /// Girders.
    pub girders: usize,
    /// Simulated time \[s\].
    pub simulated: f64,
    /// Least time of a run \[s\].
    pub seconds: f64,
    /// Runs that were timed.
    pub runs: usize,
    /// Hits in the run.
    pub hits: usize,
    /// Largest difference in displacement from the run at a thousandth of the tolerance \[m\].
    pub error: f64,
}

/// Measures; `said` is called with the name of the next run.
///
/// # Errors
/// A row that does not validate.
pub fn study(quick: bool, repeat: usize, said: &mut dyn FnMut(&str)) -> Result<Vec<Row>, SceneErrors> {
    let sizes: &[usize] = if quick { &SIZES_QUICK } else { &SIZES };
    let mut rows = Vec::new();
    for (scene, build) in [("colliding", colliding as fn(usize) -> Scene), ("few-touch", few_touch)] {
        for &girders in sizes {
            said(&format!("{scene}, {girders} girders"));
            rows.push(measure(scene, &build(girders), repeat)?);
        }
    }
    Ok(rows)
}

fn measure(name: &'static str, scene: &Scene, repeat: usize) -> Result<Row, SceneErrors> {
    let timed = fastest(repeat, || History::of(scene));
    let history = timed.value?;
    let mut finer = scene.clone();
    finer.solver.tolerance = scene.solver.tolerance / 1000.0;
    let error = Comparison::of(&history, &History::of(&finer)?).of_all().place;
    Ok(Row {
        scene: name,
        girders: scene.girders.len(),
        simulated: scene.duration,
        seconds: timed.seconds,
        runs: timed.runs,
        hits: history.summary().hits,
        error,
    })
}

/// The measurements as CSV.
pub fn csv(rows: &[Row]) -> String {
    let head = "scene,girders,simulated_s,seconds,runs,hits,difference_from_finer_m\n".to_owned();
    let line = |r: &Row| {
        format!("{},{},{},{:.4e},{},{},{:.3e}\n", r.scene, r.girders, r.simulated, r.seconds, r.runs, r.hits, r.error)
    };
    std::iter::once(head).chain(rows.iter().map(line)).collect()
}

/// The measurements as a plot.
pub fn plot(rows: &[Row]) -> Plot {
    let points = |name: &str| -> Vec<(f64, f64)> {
        rows.iter().filter(|r| r.scene == name).map(|r| (r.girders as f64, r.seconds / r.simulated)).collect()
    };
    let series = |name: &str, label: &str, color: usize, marker: Marker| Series {
        name: label.to_owned(),
        color: COLORS[color],
        marker,
        strong: name == "colliding",
        points: points(name),
    };
    Plot {
        title: "Cost against size: rows of girders".into(),
        subtitle: "One simulated second of a row, neighbours colliding all along it, or three girders of all.".into(),
        x: ("girders in the row".into(), Ticks::Counts),
        y: ("CPU time per simulated second [s]".into(), Ticks::Times),
        series: vec![
            series("colliding", "all collide", 0, Marker::Circle),
            series("few-touch", "three touch", 1, Marker::Diamond),
        ],
        marks: Vec::new(),
        guides: vec![Guide { slope: 1.0, name: "linear".into() }],
        floor: None,
    }
}
