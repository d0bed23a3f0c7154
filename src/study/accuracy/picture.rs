//! The plots of a study: error against time, problem by problem.

use super::others::OTHERS;
use super::study::{Part, Study};
use crate::plot::{COLORS, Guide, Mark, Marker, Plot, Series, Ticks};

/// Goals: problem, seconds, displacement error \[m\].
pub(super) const GOALS: &[(&str, f64, f64)] = &[("P1", 1e-3, 1e-9), ("P2", 2e-3, 1e-8), ("record", 5e-3, 1e-8)];
/// Errors smaller than this are drawn here \[m\].
const LEAST: f64 = 1e-17;

/// Color and marker of a method, the same in every plot.
fn style(method: &str) -> (&'static str, Marker) {
    match method {
        "event-driven" => (COLORS[0], Marker::Circle),
        "semi-implicit-euler" => (COLORS[3], Marker::Square),
        "rk4" => (COLORS[2], Marker::Triangle),
        "newmark" | "newmark-elements" => (COLORS[1], Marker::Diamond),
        _ => (COLORS[4], Marker::Down),
    }
}

impl Study {
    /// The plots, by the problem's name.
    pub fn plots(&self) -> Vec<(String, Plot)> {
        self.parts.iter().map(|part| (part.problem.name.to_owned(), plot(part))).collect()
    }
}

fn plot(part: &Part) -> Plot {
    Plot {
        title: format!("{}: error against time", part.problem.name),
        subtitle: format!("{}. Down and to the left is better.", part.problem.summary),
        x: ("CPU time of a run [s]".into(), Ticks::Times),
        y: ("largest displacement error [m]".into(), Ticks::Powers),
        guides: guides(),
        series: series(part),
        marks: marks(part.problem.name),
        floor: (part.reference.known_to() > LEAST)
            .then(|| (part.reference.known_to(), "the references agree to this".into())),
    }
}

fn series(part: &Part) -> Vec<Series> {
    let mut names: Vec<&str> = part.rows.iter().map(|row| row.method).collect();
    names.dedup();
    let points = |name: &str| {
        let rows = part.rows.iter().filter(|row| row.method == name);
        // What has run away is in the table, not in the picture.
        let rows = rows.filter_map(|row| Some((row.seconds, row.errors?.displacement)));
        rows.filter(|(_, e)| *e < 30.0 * part.largest).map(|(t, e)| (t, e.max(LEAST))).collect::<Vec<_>>()
    };
    let of = |name: &str| {
        let (color, marker) = style(name);
        Series { name: name.to_owned(), color, marker, strong: name == "event-driven", points: points(name) }
    };
    names.into_iter().map(of).filter(|s| !s.points.is_empty()).collect()
}

/// Orders to hold the lines against.
fn guides() -> Vec<Guide> {
    [1, 2, 4].map(|order| Guide { slope: -f64::from(order), name: format!("order {order}") }).to_vec()
}

fn marks(problem: &str) -> Vec<Mark> {
    let others = OTHERS.iter().filter(|o| o.problem == problem);
    let others = others.filter_map(|o| Some(Mark { name: o.program.into(), at: (o.seconds?, o.error?), goal: false }));
    let goals = GOALS.iter().filter(|goal| goal.0 == problem);
    let goals = goals.map(|goal| Mark { name: "goal".into(), at: (goal.1, goal.2), goal: true });
    others.chain(goals).collect()
}
