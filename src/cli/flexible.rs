//! Elastic girders in the text of a summary.

use super::digits::six;
use crate::scene::shown::escaped;
use crate::sim::DegreeCheck;
use crate::tables::{FlexibleReport, FlexibleRun};

/// Lines, each with its label.
pub(super) fn lines(girders: &[FlexibleReport], check: Option<&DegreeCheck>) -> Vec<(String, String)> {
    let check = check.map(|check| ("polynomials".to_owned(), checked(check)));
    girders.iter().flat_map(of_girder).chain(check).collect()
}

fn of_girder(girder: &FlexibleReport) -> Vec<(String, String)> {
    let label = format!("flexible {}", escaped(&girder.girder));
    let Some(run) = &girder.run else {
        let value = format!("elastic part below {:e} (κ_e = {:.2e}): rigid", girder.tol_flex, girder.kappa_e);
        return vec![(label, value)];
    };
    let frequencies: Vec<String> = girder.frequencies.iter().take(3).map(|f| six(*f)).collect();
    let numbers = format!(
        "κ = {}, κ_e = {}, degree {}, {} modes from {} Hz, a₀/c = {} ms",
        six(girder.kappa),
        six(girder.kappa_e),
        girder.degree,
        girder.modes,
        frequencies.join(", "),
        six(girder.transit_time * 1e3)
    );
    let mut lines = vec![(label, numbers)];
    lines.extend(hit(run));
    lines.push((String::new(), forces(run)));
    lines.extend(run.strength.filter(|_| run.strength_passed).map(|strength| {
        let value = format!("passes {} MPa: the girder is no longer elastic there", six(strength * 1e-6));
        ("  strength".to_owned(), value)
    }));
    let bounds = run.neglected.named().map(|(name, bound)| format!("{name} {bound:.1e}"));
    lines.push(("  left out".to_owned(), bounds.join(", ")));
    if !run.not_negligible.is_empty() {
        lines.push(("  warning".to_owned(), format!("not negligible: {}", run.not_negligible.join(", "))));
    }
    lines
}

fn hit(run: &FlexibleRun) -> Option<(String, String)> {
    let hit = run.hit?;
    let restitution = hit.restitution.map_or(String::new(), |e| format!(", returned e = {}", six(e)));
    let value = format!(
        "at {:.4} s for {} ms{restitution}; {:.2e} J left ringing",
        hit.t,
        six(hit.contact_time * 1e3),
        hit.ringing
    );
    Some(("  hardest hit".to_owned(), value))
}

fn forces(run: &FlexibleRun) -> String {
    format!(
        "mid-span |N| to {} MN at {:.4} s (strain differs by {:.1e}), |M| to {} MN·m; fibre to {} MPa at s = {} m",
        six(run.axial[0] * 1e-6),
        run.axial[1],
        run.local_error,
        six(run.moment[0] * 1e-6),
        six(run.stress[0] * 1e-6),
        six(run.stress[2])
    )
}

fn checked(check: &DegreeCheck) -> String {
    format!(
        "degree {} against {}: force {:.1e}, impulse {:.1e}, ends {:.1e}, N at mid-span {:.1e}",
        check.degree[0], check.degree[1], check.force, check.impulse, check.ends, check.section
    )
}
