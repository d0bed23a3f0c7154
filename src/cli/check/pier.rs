//! What `check` says of a pier: where it stands, its numbers in force, its frequencies, what stands on it.

use std::f64::consts::TAU;

use crate::cli::digits::six;
use crate::geometry::End;
use crate::scene::shown::escaped;
use crate::scene::{ResolvedPier, Scene};

/// All piers, some lines each.
pub(super) fn texts(scene: &Scene) -> impl Iterator<Item = String> + '_ {
    scene.piers.iter().enumerate().map(|(number, pier)| {
        let resolved = scene.pier(number);
        let [x, y] = [resolved.top.x, resolved.top.y].map(six);
        let two = |[along, across]: [f64; 2]| format!("{}, {}", six(along), six(across));
        let [f_along, f_across, _] = resolved.frequencies().map(|omega| omega / TAU);
        format!(
            "pier {}: at {x}, {y} m, {} kg, height {} m; {}\n  k along, across = {} N/m, c = {} N·s/m; alone f = {} Hz, T = {} \
             s{}{}\n",
            escaped(&pier.name),
            six(resolved.mass),
            six(resolved.height),
            standing(scene, number),
            two(resolved.stiffness),
            two(resolved.damping),
            two([f_along, f_across]),
            two([1.0 / f_along, 1.0 / f_across]),
            turning(&resolved),
            yielding(&resolved)
        )
    })
}

/// Ends of girders that stand on a pier.
fn standing(scene: &Scene, number: usize) -> String {
    let of_girder = |girder| {
        let ends = End::BOTH.into_iter().filter(move |end| scene.pier_under(girder, *end) == Some(number));
        ends.map(move |end| format!("{}{}", escaped(&girder.name), end.label()))
    };
    let ends: Vec<String> = scene.girders.iter().flat_map(of_girder).collect();
    if ends.is_empty() {
        "no end of a girder stands on it alone".to_owned()
    } else {
        format!("{} on it", ends.join(", "))
    }
}

fn turning(pier: &ResolvedPier) -> String {
    let [.., omega] = pier.frequencies();
    pier.turn_stiffness.map_or_else(
        || ", does not turn".to_owned(),
        |k| format!(", turns with k_θ = {} N·m/rad, {} Hz", six(k), six(omega / TAU)),
    )
}

fn yielding(pier: &ResolvedPier) -> String {
    pier.yielding.map_or_else(String::new, |base| {
        let [along, across] = base.force.map(six);
        format!("\n  its base yields at {along}, {across} N, with {} of k after", six(base.ratio))
    })
}
