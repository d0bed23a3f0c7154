//! The soil behind an abutment: the numbers in force, and which of them are assumed.

use crate::language::{Text, said, six};
use crate::scene::keys::word_told;
use crate::scene::{Abutment, BackfillLaw, Scene};

/// Two lines for a backwall that moves: of its soil, of the wall.
pub fn soil(scene: &Scene, abutment: &Abutment) -> Option<[String; 2]> {
    let (soil, assumed) = (abutment.soil(scene)?, abutment.backfill?.assumed());
    let said = |name: &str, value: f64, unit: &str, key: &str| {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        said!(
            "check-soil-number",
            "name" => name,
            "value" => six(value),
            "unit" => unit,
            "assumed" => if assumed.contains(&key) { Text::new("check-soil-assumed").as_str() } else { "" }
        )
    };
    let envelope = match soil.law {
        BackfillLaw::Hyperbolic => said(", R_f", soil.failure_ratio, "", "failure_ratio"),
        BackfillLaw::MeanStiffness => said(", y_max", soil.limit, "m", "failing_push_m"),
        BackfillLaw::Bilinear => String::new(),
    };
    let base = soil.base.map_or_else(
        || Text::new("check-soil-no-base").into(),
        |[force, displacement]| {
            let from = said(&Text::new("check-soil-base"), force, "N", "base_friction");
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
            "k" => said("K", soil.stiffness, "N/m", "stiffness_n_per_m"),
            "ultimate" => said("F_ult", soil.ultimate, "N", "ultimate_n"),
            "unloading" => said("K_ur", soil.unloading, "N/m", "unloading_stiffness_n_per_m"),
            "envelope" => envelope,
            "factor" => six(soil.reduction)
        ),
        said!(
            "check-soil-b",
            "mass" => said(&Text::new("check-soil-mass"), soil.mass, "kg", "wall_mass_kg"),
            "base" => base,
            "fuse" => fuse
        ),
    ])
}
