//! The soil behind an abutment: the numbers in force, and which of them are assumed.

use crate::language::{Text, said, six};
use crate::scene::keys::word_told;
use crate::scene::{Abutment, BackfillLaw, Scene};

/// Two lines for a backwall that moves: of its soil, of the wall.
pub fn soil(scene: &Scene, abutment: &Abutment) -> Option<[String; 2]> {
    let (soil, given) = (abutment.soil(scene)?, abutment.backfill?);
    let said = |name: &str, value: f64, unit: &str, is_given: bool| {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        said!(
            "check-soil-number",
            "name" => name,
            "value" => six(value),
            "unit" => unit,
            "assumed" => if is_given { "" } else { Text::new("check-soil-assumed").as_str() }
        )
    };
    let envelope = match soil.law {
        BackfillLaw::Hyperbolic => said(", R_f", soil.failure_ratio, "", given.failure_ratio.is_some()),
        BackfillLaw::MeanStiffness => said(", y_max", soil.limit, "m", given.limit.is_some()),
        BackfillLaw::Bilinear => String::new(),
    };
    let base = soil.base.map_or_else(
        || Text::new("check-soil-no-base").into(),
        |[force, displacement]| {
            let from = said(&Text::new("check-soil-base"), force, "N", given.friction.is_some());
            said!("check-soil-base-from", "from" => from, "displacement" => six(displacement))
        },
    );
    let fuse = soil.fuse.map_or_else(
        String::new,
        |[stiffness, force]| said!("check-soil-fuse", "stiffness" => six(stiffness), "force" => six(force)),
    );
    Some([
        said!(
            "check-soil",
            "abutment" => abutment.name.as_str(),
            "law" => word_told(BackfillLaw::WORDS, soil.law.label()),
            "k" => said("K", soil.stiffness, "N/m", given.stiffness.is_some()),
            "ultimate" => said("F_ult", soil.ultimate, "N", given.ultimate.is_some()),
            "unloading" => said("K_ur", soil.unloading, "N/m", given.unloading.is_some()),
            "envelope" => envelope,
            "factor" => six(soil.reduction)
        ),
        said!(
            "check-soil-b",
            "mass" => said(&Text::new("check-soil-mass"), soil.mass, "kg", given.mass.is_some()),
            "base" => base,
            "fuse" => fuse
        ),
    ])
}
