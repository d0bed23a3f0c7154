//! Text of `check` on an elastic girder.

use std::f64::consts::TAU;

use crate::cli::digits::six;
use crate::dynamics::model::flexible::Flexible;
use crate::dynamics::{Body, Model};
use crate::language::{Text, said};

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
        None => said!("check-flexible-rigid", "tol" => format!("{:e}", flexible.tolerance)),
        Some(made) => {
            let first: Vec<String> =
                made.frequencies().into_iter().take(LISTED).map(|omega| six(omega / TAU)).collect();
            said!(
                "check-flexible-degree",
                "degree" => made.degree(),
                "count" => made.count(),
                "frequencies" => first.join(", ")
            )
        }
    };
    let twice = if flexible.softness.kappa < 2.0 && flexible.softness.kappa > 0.5 {
        format!("\n  {}", Text::new("check-flexible-twice"))
    } else {
        String::new()
    };
    let in_space = flexible.space.map_or_else(String::new, |_| {
        let text = said!(
            "check-flexible-space",
            "second" => six(section.second_moment_vertical),
            "constant" => six(section.torsion_constant),
            "bending" => six(section.vertical_bending),
            "torsion" => six(section.torsion)
        );
        format!("\n  {text}")
    });
    format!(
        "{}{in_space}\n  {}\n",
        said!(
            "check-flexible",
            "name" => body.name.as_str(),
            "area" => six(section.area),
            "second" => six(section.second_moment),
            "axial" => six(section.axial),
            "bending" => six(section.bending),
            "shear" => six(section.shear)
        ),
        said!(
            "check-flexible-b",
            "speed" => six(flexible.beam.wave_speed()),
            "transit" => six(flexible.beam.transit_time() * 1e3),
            "kappa" => six(flexible.softness.kappa),
            "kappae" => six(flexible.softness.end),
            "degree" => degree,
            "twice" => twice
        )
    )
}
