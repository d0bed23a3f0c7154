//! Hysteresis loops: force against displacement of bearings that yield or slide, of devices and of backfill.

use crate::language::{Text, said};
use crate::sim::quantity::{OfBearing, OfLink};
use crate::sim::{History, Quantity};
use crate::study::plot::COLORS;
use crate::study::plot::chart::{Chart, Curve, Panel};

/// Points of a loop.
const POINTS: u32 = 4000;
/// Loops of a page at most; the rest has none.
const MOST_LOOPS: usize = 12;

/// Pictures with their captions: along and across the girder for a bearing, along its line for a device. What never moved apart or
/// carried a force has none.
pub(super) fn pictures(history: &History) -> Vec<(String, String)> {
    bearings(history).into_iter().chain(links(history)).take(MOST_LOOPS).collect()
}

fn bearings(history: &History) -> Vec<(String, String)> {
    let supports = history.model().supports.iter().enumerate();
    let numbers = supports.flat_map(|(girder, all)| (0..all.len()).map(move |n| (girder, n, all[n].last().copied())));
    let yields = |(girder, number, link): (usize, usize, Option<usize>)| {
        let name = &history.model().links[link?].name;
        let curve = |axis: usize| {
            let [x, y] = [OfBearing::Deformation(axis), OfBearing::Force(axis)];
            let [x, y] = [x, y].map(|what| Quantity::Bearing(girder, number, what));
            curve(history, &[Text::new("report-along"), Text::new("report-across")][axis], axis, [x, y])
        };
        drawn(name, [curve(0), curve(1)].into_iter().flatten().collect())
    };
    numbers.filter_map(yields).collect()
}

fn links(history: &History) -> Vec<(String, String)> {
    let link_of = |(_, quantity): &(String, Quantity)| match quantity {
        Quantity::Link(link, OfLink::Force) => Some(*link),
        _ => None,
    };
    let of_link = |link: usize| {
        let pair = [OfLink::Deformation, OfLink::Force].map(|what| Quantity::Link(link, what));
        drawn(&history.model().links[link].name, curve(history, "", 0, pair).into_iter().collect())
    };
    Quantity::all(history).iter().filter_map(link_of).filter_map(of_link).collect()
}

/// A loop in mm and kN; `None` where no force acts.
fn curve(history: &History, name: &str, color: usize, [x, y]: [Quantity; 2]) -> Option<Curve> {
    let end = history.end();
    let point = |i: u32| {
        let t = end * f64::from(i) / f64::from(POINTS);
        [1e3 * x.at(history, t), 1e-3 * y.at(history, t)]
    };
    let points: Vec<[f64; 2]> = (0..=POINTS).map(point).collect();
    let acts = points.iter().any(|[_, force]| *force != 0.0);
    acts.then(|| Curve { name: name.to_owned(), color: COLORS[color].to_owned(), dashes: "none", points })
}

fn drawn(name: &str, curves: Vec<Curve>) -> Option<(String, String)> {
    if curves.is_empty() {
        return None;
    }
    let panel = Panel { name: Text::new("report-force-kn").into(), curves };
    let chart = Chart { title: String::new(), x: Text::new("report-displacement-mm").into(), panels: vec![panel] };
    Some((said!("report-loop", "name" => name), chart.to_svg()))
}
