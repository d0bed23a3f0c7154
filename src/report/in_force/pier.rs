//! A pier: where it stands, its numbers in force, its frequencies, what stands on it.

use std::f64::consts::TAU;

use crate::geometry::End;
use crate::language::{Text, said, six};
use crate::scene::{ResolvedPier, Scene};

/// Largest coordinate that is shown as 0 \[m\].
const ROUNDING: f64 = 1e-9;

/// All piers, two lines each, or three where the base yields: place and mass, springs, yield.
pub fn piers(scene: &Scene) -> impl Iterator<Item = Vec<String>> + '_ {
    scene.piers.iter().enumerate().map(|(number, pier)| {
        let resolved = scene.pier(number);
        // What is no distance but the rounding of a mean of places is 0.
        let metres = |v: f64| six(if v.abs() < ROUNDING { 0.0 } else { v });
        let [x, y] = [resolved.top.x, resolved.top.y].map(metres);
        let two = |[along, across]: [f64; 2]| format!("{}, {}", six(along), six(across));
        let [f_along, f_across, _] = resolved.frequencies().map(|omega| omega / TAU);
        let place = said!(
            "check-pier",
            "name" => pier.name.as_str(),
            "x" => x,
            "y" => y,
            "mass" => six(resolved.mass),
            "height" => six(resolved.height),
            "standing" => standing(scene, number)
        );
        let springs = said!(
            "check-pier-b",
            "stiffness" => two(resolved.stiffness),
            "damping" => two(resolved.damping),
            "frequency" => two([f_along, f_across]),
            "period" => two([1.0 / f_along, 1.0 / f_across]),
            "turning" => turning(&resolved)
        );
        [place, springs].into_iter().chain(yielding(&resolved)).collect()
    })
}

/// Ends of girders that stand on a pier.
fn standing(scene: &Scene, number: usize) -> String {
    let of_girder = |girder| {
        let ends = End::BOTH.into_iter().filter(move |end| scene.pier_under(girder, *end) == Some(number));
        ends.map(move |end| format!("{}{}", girder.name, end.label()))
    };
    let ends: Vec<String> = scene.girders.iter().flat_map(of_girder).collect();
    if ends.is_empty() {
        Text::new("check-pier-alone").into()
    } else {
        said!("check-pier-ends", "ends" => ends.join(", "))
    }
}

fn turning(pier: &ResolvedPier) -> String {
    let [.., omega] = pier.frequencies();
    pier.turn_stiffness.map_or_else(
        || Text::new("check-pier-rigid").into(),
        |k| said!("check-pier-turns", "stiffness" => six(k), "frequency" => six(omega / TAU)),
    )
}

fn yielding(pier: &ResolvedPier) -> Option<String> {
    let base = pier.yielding?;
    let [along, across] = base.force.map(six);
    Some(said!("check-pier-yields", "along" => along, "across" => across, "ratio" => six(base.ratio)))
}
