//! What `check` says of the soil behind an abutment: the numbers in force, and which of them are assumed.

use crate::cli::digits::six;
use crate::scene::shown::escaped;
use crate::scene::{Abutment, BackfillLaw, Scene};

/// A line for a backwall that moves.
pub(super) fn text(scene: &Scene, abutment: &Abutment) -> Option<String> {
    let (soil, given) = (abutment.soil(scene)?, abutment.backfill?);
    let said = |name: &str, value: f64, unit: &str, is_given: bool| {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        format!("{name} {}{unit}{}", six(value), if is_given { "" } else { " (assumed)" })
    };
    let envelope = match soil.law {
        BackfillLaw::Hyperbolic => said(", R_f", soil.failure_ratio, "", given.failure_ratio.is_some()),
        BackfillLaw::MeanStiffness => said(", y_max", soil.limit, "m", given.limit.is_some()),
        BackfillLaw::Bilinear => String::new(),
    };
    let base = soil.base.map_or_else(
        || "no base friction".to_owned(),
        |[force, displacement]| {
            let from = said("base slides with", force, "N", given.friction.is_some());
            format!("{from} from {} m on", six(displacement))
        },
    );
    let fuse = soil.fuse.map_or_else(String::new, |[stiffness, force]| {
        format!(", fuse of {} N/m that breaks at {} N", six(stiffness), six(force))
    });
    Some(format!(
        "backfill {}: {}, {}, {}, {}{envelope}; skew factor {}\n  wall of {}, {base}{fuse}\n",
        escaped(&abutment.name),
        soil.law.label(),
        said("K", soil.stiffness, "N/m", given.stiffness.is_some()),
        said("F_ult", soil.ultimate, "N", given.ultimate.is_some()),
        said("K_ur", soil.unloading, "N/m", given.unloading.is_some()),
        six(soil.reduction),
        said("mass", soil.mass, "kg", given.mass.is_some()),
    ))
}
