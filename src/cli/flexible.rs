//! Elastic girders in the text of a summary.

use super::digits::six;
use crate::language::{Text, said, values};
use crate::scene::shown::escaped;
use crate::sim::DegreeCheck;
use crate::tables::{FlexibleReport, FlexibleRun, Report};

/// Lines, each with its label.
pub(super) fn lines(girders: &[FlexibleReport], check: Option<&DegreeCheck>) -> Vec<(String, String)> {
    let check = check.map(|check| (Text::new("run-polynomials").into(), checked(check)));
    girders.iter().flat_map(of_girder).chain(check).collect()
}

fn of_girder(girder: &FlexibleReport) -> Vec<(String, String)> {
    let label = said!("run-flexible", "girder" => escaped(&girder.girder));
    let Some(run) = &girder.run else {
        let value = said!(
            "run-flexible-rigid",
            "tol" => format!("{:e}", girder.tol_flex),
            "kappa" => format!("{:.2e}", girder.kappa_e)
        );
        return vec![(label, value)];
    };
    let frequencies: Vec<String> = girder.frequencies.iter().take(3).map(|f| six(*f)).collect();
    let numbers = said!(
        "run-flexible-of",
        "kappa" => six(girder.kappa),
        "kappae" => six(girder.kappa_e),
        "degree" => girder.degree,
        "count" => girder.modes,
        "frequencies" => frequencies.join(", "),
        "transit" => six(girder.transit_time * 1e3)
    );
    let mut lines = vec![(label, numbers)];
    lines.extend(hit(run));
    lines.push((String::new(), forces(run)));
    lines.extend(run.strength.filter(|_| run.strength_passed).map(|strength| {
        let value = said!("run-strength-of", "strength" => six(strength * 1e-6));
        (format!("  {}", Text::new("run-strength")), value)
    }));
    let bounds = run.neglected.named().map(|(name, bound)| format!("{name} {bound:.1e}"));
    lines.push((format!("  {}", Text::new("run-left-out")), bounds.join(", ")));
    if !run.not_negligible.is_empty() {
        let names: Vec<&str> = run.not_negligible.iter().map(|name| name.as_str()).collect();
        let said = said!("run-not-negligible", "names" => names.join(", "));
        lines.push((format!("  {}", Text::new("run-warning")), said));
    }
    lines
}

fn hit(run: &FlexibleRun) -> Option<(String, String)> {
    let hit = run.hit?;
    let restitution = hit.restitution.map_or(String::new(), |e| said!("run-returned", "e" => six(e)));
    let words = if hit.ended { Text::new("run-hit-of") } else { Text::new("run-hit-goes-on") };
    let value = words.with(&values![
        "t" => format!("{:.4}", hit.t),
        "time" => six(hit.contact_time * 1e3),
        "restitution" => restitution,
        "ringing" => format!("{:.2e}", hit.ringing)
    ]);
    Some((format!("  {}", Text::new("run-hardest")), value))
}

fn forces(run: &FlexibleRun) -> String {
    let in_space = run.vertical_moment.zip(run.torque).map_or_else(String::new, |(moment, torque)| {
        said!(
            "run-section-forces-space",
            "moment" => six(moment[0] * 1e-6),
            "torque" => six(torque[0] * 1e-6)
        )
    });
    said!(
        "run-section-forces",
        "axial" => six(run.axial[0] * 1e-6),
        "t" => format!("{:.4}", run.axial[1]),
        "difference" => format!("{:.1e}", run.local_error),
        "moment" => six(run.moment[0] * 1e-6),
        "in_space" => in_space,
        "stress" => six(run.stress[0] * 1e-6),
        "s" => six(run.stress[2])
    )
}

fn checked(check: &DegreeCheck) -> String {
    let differences = said!(
        "run-degrees",
        "one" => check.degree[0],
        "other" => check.degree[1],
        "force" => format!("{:.1e}", check.force),
        "impulse" => format!("{:.1e}", check.impulse),
        "ends" => format!("{:.1e}", check.ends),
        "section" => format!("{:.1e}", check.section),
        "moments" => format!("{:.1e}", check.moments)
    );
    differences + &Report::as_far_as(check.until)
}
