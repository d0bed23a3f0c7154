//! The paper's figures of histories redrawn from our runs, with its quantities on the axes. Its curves are measured ones beside
//! computed ones; measurements are not at hand, so that ours are of the models alone.

use super::plan;
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::study::experiment::cases::{Case, Shaking, Specimen};
use crate::study::experiment::observe::{DRAWN_HZ, Observed};
use crate::study::experiment::results::{MODELS, Results};

/// A figure.
pub(super) struct Figure {
    /// `Fig. 10`.
    pub(super) number: &'static str,
    pub(super) caption: String,
    /// One or more pictures, each with a line above it.
    pub(super) pictures: Vec<(String, String)>,
}

/// Colour and dashes of a model's curves, by its place in [`MODELS`].
const STYLES: [(&str, &str); 2] = [(COLORS[0], "none"), (COLORS[1], "6 3")];
/// Names of the columns of a drawn history.
const QUANTITIES: [&str; 3] = ["x, along the axis [mm]", "y, across [mm]", "rotation θ [°]"];

/// A curve of a girder under a model; the columns of a drawn history are x, y, θ.
fn curve(seen: &Observed, model: usize, girder: usize, column: usize) -> Curve {
    let drawn = seen.girders.get(girder).map_or(&[][..], |girder| &girder.drawn);
    let (color, dashes) = STYLES[model];
    Curve {
        name: format!("{} model", MODELS[model].label()),
        color: color.to_owned(),
        dashes,
        points: drawn.iter().enumerate().map(|(i, row)| [i as f64 / DRAWN_HZ, row[column]]).collect(),
    }
}

/// A panel with both models, as far as there are runs.
fn panel(results: &Results, case: &Case, models: &[usize], girder: usize, column: usize) -> Panel {
    let seen = models.iter().filter_map(|&model| Some((model, results.of(case, model)?)));
    Panel {
        name: QUANTITIES[column].to_owned(),
        curves: seen.map(|(model, seen)| curve(seen, model, girder, column)).collect(),
    }
}

/// A single curve needs no dashes.
fn undashed(mut panel: Panel) -> Panel {
    if let [only] = panel.curves.as_mut_slice() {
        only.dashes = "none";
    }
    panel
}

/// x, y and θ of a case under both models, girder by girder.
pub(super) fn histories(results: &Results, case: &Case, models: &[usize], columns: &[usize]) -> Option<String> {
    let seen = results.of(case, 0)?;
    let named = seen.girders.len() > 1;
    let panels = columns.iter().flat_map(|&column| {
        seen.girders.iter().enumerate().map(move |(girder, own)| {
            let panel = undashed(panel(results, case, models, girder, column));
            let name = if named { format!("{}: {}", own.name, panel.name) } else { panel.name };
            Panel { name, ..panel }
        })
    });
    Some(Chart { title: String::new(), x: "time [s]".into(), panels: panels.collect() }.to_svg())
}

/// The figures for which there are runs.
pub(super) fn figures(results: &Results) -> Vec<Figure> {
    let straight = |angle, shaking| Case::new(Specimen::Straight, angle, shaking);
    let pair = Case::new(Specimen::Pair, 22.5, Shaking::Large);
    let one = |number, case: Case, models: &[usize], columns: &[usize], words: &str| {
        let picture = histories(results, &case, models, columns)?;
        Some(Figure {
            number,
            caption: format!("{words}: {}.", case.label()),
            pictures: vec![(String::new(), picture)],
        })
    };
    let all = [
        plans(results),
        turns(results),
        angles(results),
        one("Fig. 15", straight(0.0, Shaking::Large), &[1], &[0], "Displacement along the axis, impact model"),
        one("Fig. 16", straight(0.0, Shaking::Record), &[1], &[0], "Displacement along the axis, impact model"),
        one("Fig. 17", straight(45.0, Shaking::Large), &[0, 1], &[0, 1, 2], "Along, across, rotation"),
        one("Fig. 18", straight(45.0, Shaking::Record), &[0, 1], &[0, 1, 2], "Along, across, rotation"),
        one("Fig. 25", straight(0.0, Shaking::Large), &[0], &[0], "Displacement along the axis, contact model"),
        one("Fig. 26", pair, &[0, 1], &[0, 1, 2], "Along, across, rotation of both girders"),
    ];
    all.into_iter().flatten().collect()
}

/// Fig. 9.
fn plans(results: &Results) -> Option<Figure> {
    let picture = |(angle, words): (f64, &str)| {
        let case = Case::new(Specimen::Straight, angle, Shaking::Large);
        let of_model = |model: usize| {
            let picture = plan::frames(results.of(&case, model)?)?;
            Some((format!("{words} {angle}°, {} model", MODELS[model].label()), picture))
        };
        (0..MODELS.len()).map(of_model).collect::<Option<Vec<_>>>()
    };
    let pictures = [(22.5, "(a)"), (67.5, "(b)")].map(picture).into_iter().collect::<Option<Vec<_>>>()?.concat();
    let caption = format!(
        "Straight girder and abutment in plan, 0.40 g, frames about a hit. Displacements and gap are drawn {} times as large as \
         the girder; dashed: as placed.",
        plan::FACTOR
    );
    Some(Figure { number: "Fig. 9", caption, pictures })
}

/// Fig. 10.
fn turns(results: &Results) -> Option<Figure> {
    let case = |specimen| Case::new(specimen, 0.0, Shaking::Large);
    results.of(&case(Specimen::Skew60), 0).and(results.of(&case(Specimen::Skew45), 0))?;
    let panels =
        [(Specimen::Skew60, "(a) 60° girder"), (Specimen::Skew45, "(b) 45° girder")].map(|(specimen, words)| {
            let panel = panel(results, &case(specimen), &[0, 1], 0, 2);
            Panel { name: format!("{words}: {}", panel.name), ..panel }
        });
    let chart = Chart { title: String::new(), x: "time [s]".into(), panels: panels.into() };
    Some(Figure {
        number: "Fig. 10",
        caption: "Rotation of the skewed girders driven along the axis, 0.40 g at 2.6 Hz; both on one scale."
            .to_owned(),
        pictures: vec![(String::new(), chart.to_svg_on_one_scale())],
    })
}

/// Fig. 11.
fn angles(results: &Results) -> Option<Figure> {
    let curve = |model: usize, shaking: Shaking| {
        let point = |&angle: &f64| {
            let seen = results.of(&Case::new(Specimen::Skew60, angle, shaking), model)?;
            Some([angle, seen.rotation().to_degrees()])
        };
        let (color, _) = STYLES[model];
        Some(Curve {
            name: format!("{}, {} g", MODELS[model].label(), shaking.key().trim_end_matches('g')),
            color: color.to_owned(),
            dashes: if shaking == Shaking::Large { "none" } else { "2 3" },
            points: Specimen::Skew60.angles().iter().map(point).collect::<Option<_>>()?,
        })
    };
    let curves =
        (0..MODELS.len()).flat_map(|model| [Shaking::Large, Shaking::Small].map(|shaking| curve(model, shaking)));
    let panel = Panel { name: "largest rotation [°]".into(), curves: curves.collect::<Option<_>>()? };
    let chart = Chart { title: String::new(), x: "excitation angle [°]".into(), panels: vec![panel] };
    Some(Figure {
        number: "Fig. 11",
        caption: "Largest rotation of the 60° girder against the excitation angle. The paper does not state which way its girder is \
                  skewed: its angles may have the other sign."
            .to_owned(),
        pictures: vec![(String::new(), chart.to_svg())],
    })
}
