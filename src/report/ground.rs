//! The ground motion with its spectrum, and the motion of the girders, as charts.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::in_force;
use super::sections::{head, row};
use crate::language::{Text, said};
use crate::motion::Ground;
use crate::motion::integrate::{StrongMotion, integrate, peaks};
use crate::motion::spectrum::{DESIGN_DAMPING, periods, spectrum};
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::plot::draw::escape;
use crate::scene::STANDARD_GRAVITY;
use crate::sim::History;
use crate::sim::moving_ground::{MovedSupport, moved_supports};

/// Samples of a history that is drawn, and of a ground motion that is no record.
const SAMPLES: u32 = 4000;
/// Most samples of a record that are drawn one by one.
const MOST_SAMPLES: usize = 20_000;
/// Periods of the spectrum: from, to \[s\], count.
const PERIODS: ([f64; 2], u32) = ([0.05, 5.0], 120);

fn times(history: &History) -> impl Iterator<Item = f64> {
    let end = history.end();
    (0..=SAMPLES).map(move |i| end * f64::from(i) / f64::from(SAMPLES))
}

fn curve(name: &str, color: usize, points: Vec<[f64; 2]>) -> Curve {
    Curve { name: name.to_owned(), color: COLORS[color % COLORS.len()].to_owned(), dashes: "none", points }
}

/// Supports whose ground moves otherwise, a sentence each.
fn supports(history: &History) -> String {
    let sentence = |moved: MovedSupport| {
        let name = escape(&moved.name);
        let delay = format!("{:.4}", moved.motion.delay);
        let [factor, largest, last] = [moved.motion.factor, moved.largest, moved.last].map(|v| format!("{v:.3}"));
        let ground =
            moved.ground.map_or(String::new(), |ground| said!("report-own-ground", "ground" => escape(&ground)));
        said!("report-moved", "name" => name, "ground" => ground, "delay" => delay, "factor" => factor, "largest" => largest, "last" => last)
    };
    let sentences: Vec<String> = moved_supports(history.scene(), history.model()).into_iter().map(sentence).collect();
    if sentences.is_empty() { String::new() } else { format!("<p>{}</p>\n", sentences.join("<br>\n")) }
}

/// A ground motion that is drawn.
struct Drawn<'a> {
    name: String,
    ground: &'a Ground,
    /// Interval of its samples \[s\]: a record's own.
    dt: f64,
    /// Acceleration at them \[m/s²\].
    samples: Vec<[f64; 3]>,
}

impl<'a> Drawn<'a> {
    fn of(name: &str, ground: &'a Ground, history: &History) -> Self {
        let name = name.to_owned();
        if let Some((dt, samples)) = ground.samples_until(history.end()) {
            return Self { name, ground, dt, samples: samples.into_iter().map(|a| a.to_array()).collect() };
        }
        let samples = times(history).map(|t| ground.acceleration(t).to_array()).collect();
        Self { name, ground, dt: history.end() / f64::from(SAMPLES), samples }
    }

    /// Points of the picture along an axis \[s, g\].
    fn points(&self, axis: usize, history: &History) -> Vec<[f64; 2]> {
        if self.samples.len() > MOST_SAMPLES {
            return times(history).map(|t| [t, self.ground.acceleration(t)[axis] / STANDARD_GRAVITY]).collect();
        }
        let points = self.samples.iter().enumerate();
        points.map(|(i, a)| [self.dt * i as f64, a[axis] / STANDARD_GRAVITY]).collect()
    }

    fn moves(&self, axis: usize) -> bool {
        self.samples.iter().any(|a| a[axis] != 0.0)
    }
}

/// The ground of `[motion]`, and those with names that supports stand on.
fn grounds(history: &History) -> Vec<Drawn<'_>> {
    let (model, scene) = (history.model(), history.scene());
    let used: BTreeSet<usize> =
        moved_supports(scene, model).iter().map(|moved| moved.motion.ground).filter(|number| *number > 0).collect();
    let named = model.moving.iter().flat_map(|moving| {
        let of = |&number: &usize| Drawn::of(&scene.grounds[number - 1].name, moving.ground(number), history);
        used.iter().map(of).collect::<Vec<_>>()
    });
    std::iter::once(Drawn::of("[motion]", &model.ground, history)).chain(named).collect()
}

/// A line of the table of peaks: the largest acceleration and when it is reached first, the largest velocity from rest, Arias intensity
/// and the time from 5 to 95 % of it.
fn peak_row(name: &str, [value, t]: [f64; 2], (samples, dt): (&[f64], f64)) -> String {
    let [velocity, displacement] = integrate(samples, dt);
    let [velocity, _] = peaks(samples, [&velocity, &displacement], dt);
    let (velocity, strong) = (velocity.value.abs(), StrongMotion::of(samples, dt));
    let numbers = [
        format!("{:.4}", value / STANDARD_GRAVITY),
        format!("{t:.3}"),
        format!("{velocity:.3}"),
        format!("{:.3}", strong.arias),
        format!("{:.2}", strong.duration()),
    ];
    row(name, &numbers)
}

/// Histories of the ground's acceleration and their spectra; in words where it is still.
pub(super) fn section(history: &History) -> String {
    let grounds = grounds(history);
    let axes: Vec<usize> = (0..3).filter(|&axis| grounds.iter().any(|ground| ground.moves(axis))).collect();
    if axes.is_empty() {
        return format!("<p>{}</p>\n", Text::new("report-still"));
    }
    let names = ["x", "y", "z"];
    let mut html = format!("<p>{}</p>\n", escape(&in_force::motion(&history.scene().motion)));
    for named in &history.scene().grounds {
        let _ = writeln!(html, "<p>{}: {}</p>", escape(&named.name), escape(&in_force::motion(&named.motion)));
    }
    html += &head(&[
        Text::new("report-component").as_str(),
        &Text::new("report-peak"),
        &Text::new("report-peak-at"),
        &Text::new("report-peak-velocity"),
        &Text::new("report-arias"),
        &Text::new("report-significant"),
    ]);
    let (mut panels, mut spectra) = (Vec::new(), Vec::new());
    for &axis in &axes {
        let mut curves = Vec::new();
        for (number, ground) in grounds.iter().enumerate().filter(|(_, ground)| ground.moves(axis)) {
            // Alone it is called by its axis and has the axis' colour; of several each has its own.
            let alone = grounds.len() == 1;
            let name = if alone { names[axis].to_owned() } else { format!("{} {}", ground.name, names[axis]) };
            let color = if alone { axis } else { number * 3 + axis };
            let series: Vec<f64> = ground.samples.iter().map(|a| a[axis]).collect();
            html += &peak_row(&name, ground.ground.largest(axis, history.end()), (&series, ground.dt));
            curves.push(curve(&name, color, ground.points(axis, history)));
            let responses = spectrum(&series, ground.dt, &periods(PERIODS.0, PERIODS.1), DESIGN_DAMPING);
            let points = responses.iter().map(|r| [r.period, r.pseudo_acceleration() / STANDARD_GRAVITY]).collect();
            spectra.push(curve(&name, color, points));
        }
        panels.push(Panel { name: said!("report-ground-axis", "axis" => names[axis]), curves });
    }
    let motion = Chart { title: String::new(), x: Text::new("report-time").into(), panels };
    let spectrum = Panel { name: Text::new("report-pseudo").into(), curves: spectra };
    let spectrum = Chart { title: String::new(), x: Text::new("report-period").into(), panels: vec![spectrum] };
    let _ = writeln!(
        html,
        "</table>\n{}<div class=\"picture\">{}</div>\n<div class=\"picture\">{}</div>",
        supports(history),
        motion.to_svg(),
        spectrum.to_svg(),
    );
    if let Some(ground) = grounds.iter().find(|ground| matches!(ground.ground, Ground::Sine { .. })) {
        let (count, interval) = (ground.samples.len().to_string(), format!("{:.4}", ground.dt));
        let _ = writeln!(html, "<p>{}</p>", said!("report-samples", "count" => count, "interval" => interval));
    }
    html
}

/// Displacement and rotation of every girder.
pub(super) fn girders(history: &History) -> String {
    let bodies = &history.model().bodies;
    let of = |value: &dyn Fn(usize, f64) -> f64| -> Vec<Curve> {
        let points = |girder: usize| {
            let sound = history.seats().sound_until(girder);
            times(history).filter(|t| *t <= sound).map(|t| [t, value(girder, t)]).collect()
        };
        bodies.iter().enumerate().map(|(girder, body)| curve(&body.name, girder, points(girder))).collect()
    };
    let panels = vec![
        Panel {
            name: Text::new("report-x-of-g").into(),
            curves: of(&|g, t| 1e3 * history.motion(g, t).displacement.x),
        },
        Panel {
            name: Text::new("report-y-of-g").into(),
            curves: of(&|g, t| 1e3 * history.motion(g, t).displacement.y),
        },
        Panel { name: Text::new("report-theta").into(), curves: of(&|g, t| history.motion(g, t).theta.to_degrees()) },
    ];
    let chart = Chart { title: String::new(), x: Text::new("report-time").into(), panels };
    format!("<div class=\"picture\">{}</div>\n", chart.to_svg())
}
