//! What `check` says of an elastic girder.

use std::f64::consts::TAU;

use crate::cli::digits::six;
use crate::dynamics::model::flexible::Flexible;
use crate::dynamics::{Body, Model};

/// How many frequencies are listed.
const LISTED: usize = 4;

/// A line for each girder that the scene calls elastic.
pub(super) fn texts(model: &Model) -> Vec<String> {
    let one = |(body, flexible): (&Body, &Option<Flexible>)| Some(text(body, flexible.as_ref()?));
    model.bodies.iter().zip(&model.flexible).filter_map(one).collect()
}

fn text(body: &Body, flexible: &Flexible) -> String {
    let section = &flexible.section;
    let degree = match &flexible.girder {
        None => format!("rigid: elastic part below {:e}", flexible.tolerance),
        Some(made) => {
            let first: Vec<String> = made.modes.frequencies().take(LISTED).map(|omega| six(omega / TAU)).collect();
            format!("degree {}, {} modes from {} Hz", made.modes.degree, made.count(), first.join(", "))
        }
    };
    let twice = if flexible.softness.kappa < 2.0 && flexible.softness.kappa > 0.5 {
        "\n  K is about E A / a₀: where it stands for the girder's own flexibility (64), that counts twice"
    } else {
        ""
    };
    format!(
        "elastic {}: A = {} m², I_z = {} m⁴, E A = {} N, E I_z = {} N·m², k_s G A = {} N\n  c = {} m/s, a₀/c = {} ms, κ = {}, κ_e = {}: {degree}{twice}\n",
        body.name,
        six(section.area),
        six(section.second_moment),
        six(section.axial),
        six(section.bending),
        six(section.shear),
        six(flexible.beam.wave_speed()),
        six(flexible.beam.transit_time() * 1e3),
        six(flexible.softness.kappa),
        six(flexible.softness.end),
    )
}
