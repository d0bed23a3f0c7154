//! Hysteresis loops: force against displacement of bearings that yield or slide, of piers whose base yields, of devices and of backfill.

use glam::DVec2;

use crate::dynamics::model::compiled_model::Pier;
use crate::language::{Text, said};
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::scene::Girder;
use crate::sim::quantity::{OfBearing, OfLink, OfPier};
use crate::sim::{History, Quantity};
use crate::tables::{BearingsReport, Report};

/// Points of a loop that are equally far apart in time; between two of them more are taken where it bends.
const POINTS: u32 = 4000;
/// Distance of a loop from the line between two of its points, in parts of its width and height, above which a point is taken between
/// them \[–\], and most halvings of the time between two. Chosen: half the width of its line, and a hit of tens of milliseconds in a
/// run of a minute.
const BENDS: f64 = 2e-3;
const MOST_HALVINGS: u32 = 5;
/// Loops of a page at most; the rest has none.
const MOST_LOOPS: usize = 12;

/// Directions of the two curves of a bearing, and of a pier.
const AXES: [Text; 2] = [Text::new("report-along"), Text::new("report-across")];
const PIER_AXES: [Text; 2] = [Text::new("report-along-pier"), Text::new("report-across-pier")];

/// Pictures with their captions: along and across the girder for a bearing, along its line for a device. What never moved apart or
/// carried a force has none.
pub(super) fn pictures(history: &History, report: &Report) -> Vec<(String, String)> {
    bearings(history, &report.bearings)
        .into_iter()
        .chain(piers(history))
        .chain(links(history))
        .take(MOST_LOOPS)
        .collect()
}

/// Of every girder on bearings that yield or slide, the one of them that moves most of all.
fn bearings(history: &History, readings: &[BearingsReport]) -> Vec<(String, String)> {
    let scene = history.scene();
    let yields = |(girder, placed): (usize, &Girder)| {
        let number = readings.iter().find(|of| of.girder == placed.name)?.bearing - 1;
        let bearing = placed.supports(scene.setting()).into_iter().nth(number)?;
        if bearing.yielding.is_none() && bearing.sliding.is_none() {
            return None;
        }
        let name = said!("report-loop-most", "girder" => placed.name.as_str(), "number" => number + 1);
        let curve = |axis: usize| {
            let [x, y] = [OfBearing::Deformation(axis), OfBearing::Force(axis)];
            let [x, y] = [x, y].map(|what| Quantity::Bearing(girder, number, what));
            curve((history, history.seats().bearing_lost_at(girder, number)), &AXES[axis], axis, [x, y])
        };
        drawn(&name, [curve(0), curve(1)].into_iter().flatten().collect())
    };
    scene.girders.iter().enumerate().filter_map(yields).collect()
}

/// Of every pier whose base yields the base shear against the drift of its cap, along and across the pier.
fn piers(history: &History) -> Vec<(String, String)> {
    let model = history.model();
    let yielding = model.piers.iter().enumerate().filter(|(_, pier)| pier.yielding.is_some());
    let of_pier = |(number, pier): (usize, &Pier)| {
        let curve = |axis: usize| {
            let pair = [OfPier::DriftAlong(axis), OfPier::ShearAlong(axis)].map(|what| Quantity::Pier(number, what));
            curve((history, f64::INFINITY), &PIER_AXES[axis], axis, pair)
        };
        drawn(&model.bodies[pier.body].name, [curve(0), curve(1)].into_iter().flatten().collect())
    };
    yielding.filter_map(of_pier).collect()
}

fn links(history: &History) -> Vec<(String, String)> {
    let link_of = |(_, quantity): &(String, Quantity)| match quantity {
        Quantity::Link(link, OfLink::Force) => Some(*link),
        _ => None,
    };
    let of_link = |link: usize| {
        let pair = [OfLink::Deformation, OfLink::Force].map(|what| Quantity::Link(link, what));
        drawn(&history.model().links[link].name, curve((history, f64::INFINITY), "", 0, pair).into_iter().collect())
    };
    Quantity::all(history).iter().filter_map(link_of).filter_map(of_link).collect()
}

/// A loop in mm and kN, until a time \[s\] or the end; `None` where no force acts.
fn curve((history, until): (&History, f64), name: &str, color: usize, [x, y]: [Quantity; 2]) -> Option<Curve> {
    let end = history.end().min(until);
    let point = |i: f64| {
        let t = end * i / f64::from(POINTS);
        [1e3 * x.at(history, t), 1e-3 * y.at(history, t)]
    };
    let even: Vec<[f64; 2]> = (0..=POINTS).map(|i| point(f64::from(i))).collect();
    let acts = even.iter().any(|[_, force]| *force != 0.0);
    if !acts {
        return None;
    }
    let size = [0, 1].map(|axis| {
        let values = even.iter().map(|p| p[axis]);
        let most = values.clone().fold(f64::NEG_INFINITY, f64::max);
        (most - values.fold(f64::INFINITY, f64::min)).max(f64::MIN_POSITIVE)
    });
    let mut points = vec![even[0]];
    for (i, two) in even.windows(2).enumerate() {
        let from = i as f64;
        between(&point, [(from, two[0]), (from + 1.0, two[1])], size, MOST_HALVINGS, &mut points);
        points.push(two[1]);
    }
    Some(Curve { name: name.to_owned(), color: COLORS[color].to_owned(), dashes: "none", points })
}

/// Adds points between two where the loop is off the line through them; `size` is its width and height.
fn between(
    point: &impl Fn(f64) -> [f64; 2],
    [(from, a), (to, b)]: [(f64, [f64; 2]); 2],
    size: [f64; 2],
    halvings: u32,
    points: &mut Vec<[f64; 2]>,
) {
    let middle = from.midpoint(to);
    let at = point(middle);
    let seen = |p: [f64; 2]| DVec2::new(p[0] / size[0], p[1] / size[1]);
    let (way, off) = (seen(b) - seen(a), seen(at) - seen(a));
    let along = (off.dot(way) / way.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    if halvings == 0 || (off - along * way).length() <= BENDS {
        return;
    }
    between(point, [(from, a), (middle, at)], size, halvings - 1, points);
    points.push(at);
    between(point, [(middle, at), (to, b)], size, halvings - 1, points);
}

fn drawn(name: &str, curves: Vec<Curve>) -> Option<(String, String)> {
    if curves.is_empty() {
        return None;
    }
    let panel = Panel { name: Text::new("report-force-kn").into(), curves };
    let chart = Chart { title: String::new(), x: Text::new("report-displacement-mm").into(), panels: vec![panel] };
    Some((said!("report-loop", "name" => name), chart.to_svg()))
}
