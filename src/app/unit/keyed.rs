//! The unit of a key of the scene file, as its name says it (`length_m`), and how a number of it is shown.

use super::shown::{
    ACCELERATION, DEGREES, DENSITY, GRAVITIES, HERTZ, HERTZ_STIFFNESS, INERTIA, MODULUS, MOMENTS, PARTS, POWER_DAMPING,
    PURE, RATE, SECOND_MOMENT, SECONDS, SLOW, SPEED, TURN_STIFFNESS, TURNING, Unit, WAVE_SPEED, area_unit,
    damping_unit, force_unit, length_unit, mass_unit, stiffness_unit,
};
use crate::scene::keys::{Key, of_place};
use crate::scene::{Girder, Scene};

/// Sizes that decide between millimetres and metres, kilograms and tonnes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) struct Size {
    /// \[m\]
    pub length: f64,
    /// \[kg\]
    pub mass: f64,
}

impl Size {
    /// Of a girder and what is near it.
    pub(in crate::app) fn of(girder: &Girder) -> Self {
        Self { length: girder.length, mass: girder.mass }
    }

    /// Of a scene: of its first girder.
    pub(in crate::app) fn of_scene(scene: &Scene) -> Self {
        scene.girders.first().map_or(Self { length: 1.0, mass: 1.0 }, Self::of)
    }
}

/// How the number at a place of the scene file is shown; `now` is the number, in the unit of its key.
pub(in crate::app) fn unit_of(place: &str, now: f64, size: Size) -> Unit {
    let Some((table, key)) = of_place(place) else { return PURE };
    // The keys of `seat_m` are the ends: the unit stands with the table.
    let last = table.path.rsplit('.').next().unwrap_or_default();
    let named = by_ending(key.name, key, now, size).or_else(|| by_ending(last, key, now, size));
    named.or_else(|| by_meaning(key)).unwrap_or(match key.number() {
        Some(default) if default != 0.0 && default.abs() < 1e-3 => PARTS,
        _ => PURE,
    })
}

/// Unit by the ending of a name; of two endings that fit the longer counts.
fn by_ending(name: &str, key: &Key, now: f64, size: Size) -> Option<Unit> {
    let fits = |(ending, _): &&(&str, UnitOf)| name.ends_with(ending);
    let (_, shown) = ENDINGS.iter().filter(fits).max_by_key(|(ending, _)| ending.len())?;
    Some(shown(key, now, size))
}

/// The unit that stands at the end of what a key means, where its name has none.
fn by_meaning(key: &Key) -> Option<Unit> {
    let (_, unit) = key.meaning.rsplit_once(", ")?;
    [RATE, SECONDS, POWER_DAMPING].into_iter().find(|known| known.suffix.trim_start() == unit)
}

/// The unit of a key with this present value in a scene of this size.
type UnitOf = fn(&Key, f64, Size) -> Unit;

const ENDINGS: &[(&str, UnitOf)] = &[
    ("_m", |_, _, size| length_unit(size.length)),
    ("_m2", |_, now, _| area_unit(now)),
    ("_m4", |_, _, _| SECOND_MOMENT),
    ("_kg_m2", |_, _, _| INERTIA),
    ("_kg_m3", |_, _, _| DENSITY),
    ("_deg", |_, _, _| DEGREES),
    ("_kg", |_, _, size| mass_unit(size.mass)),
    ("_s", |_, _, _| SECONDS),
    ("_hz", |_, _, _| HERTZ),
    ("_m_s", |key, _, _| if key.number().is_some_and(|v| v != 0.0 && v.abs() < 0.01) { SLOW } else { SPEED }),
    ("_m_per_s", |_, _, _| WAVE_SPEED),
    ("_deg_s", |_, _, _| TURNING),
    ("_g", |_, _, _| GRAVITIES),
    ("_m_s2", |_, _, _| ACCELERATION),
    ("_n", |_, _, size| force_unit(size.mass)),
    ("_n_m", |_, _, _| MOMENTS),
    ("_n_m_per_rad", |_, _, _| TURN_STIFFNESS),
    ("_n_per_m", |_, now, _| stiffness_unit(now)),
    ("_n_per_m1_5", |_, _, _| HERTZ_STIFFNESS),
    ("_n_s_per_m", |_, now, _| damping_unit(now)),
    ("_pa", |_, _, _| MODULUS),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::unit::dimension::Dimension;
    use crate::scene::keys::{Range, TABLES};

    #[test]
    fn a_key_is_shown_in_the_unit_of_its_name() {
        let bench = Size { length: 0.19, mass: 2.0 };
        let cases = [
            ("girder.x_m.length_m", Dimension::Length),
            ("girder.x_m.initial.displacement_m[1]", Dimension::Length),
            ("girder.x_m.initial.spin_deg_s", Dimension::Turning),
            ("girder.x_m.seat_m.+x", Dimension::Length),
            ("girder.x_m.push.moment_n_m", Dimension::Moment),
            ("girder.x_m.bearings.damping_ratio", Dimension::Pure),
            ("contact.stiffness_n_per_m", Dimension::Stiffness),
            ("contact.pair[2].young_modulus_pa", Dimension::Pressure),
            ("impact.stop_speed_m_s", Dimension::Speed),
            ("motion.amplitude_g", Dimension::Acceleration),
            ("solver.tolerance", Dimension::Pure),
            ("wave.speed_m_per_s", Dimension::Speed),
            ("girder.x_m.elastic.density_kg_m3", Dimension::Density),
            ("girder.x_m.elastic.second_moment_m4", Dimension::SecondMoment),
            ("girder.x_m.elastic.rayleigh.mass", Dimension::Rate),
            ("girder.x_m.elastic.rayleigh.stiffness", Dimension::Time),
            ("pier.p.turn_stiffness_n_m_per_rad", Dimension::TurnStiffness),
            ("pier.p.turn_inertia_kg_m2", Dimension::Inertia),
        ];
        for (place, wanted) in cases {
            assert_eq!(unit_of(place, 1.0, bench).dimension, wanted, "{place}");
        }
        assert_eq!(unit_of("impact.stop_speed_m_s", 1.0, bench), SLOW, "as small as its default");
        assert_eq!(unit_of("solver.tolerance", 1.0, bench), PARTS, "with its power of ten");
    }

    #[test]
    fn a_meaning_that_ends_in_a_unit_is_of_the_unit_of_its_name() {
        let mut checked = 0;
        for table in TABLES {
            for key in table.keys.iter().filter(|key| !matches!(key.range, Range::Words(_) | Range::Free)) {
                let said = key.meaning.rsplit(", ").next().unwrap_or_default().replace('·', " ");
                let said = if said == "degrees" { "°" } else { &said };
                let place = table.path.split(" kind").next().unwrap_or_default();
                let unit = unit_of(&format!("{place}.{}", key.name).replacen("girder", "girder.deck", 1), 1.0, BENCH);
                if unit.dimension != Dimension::Pure && said.len() <= 5 {
                    let known = unit.dimension.units().iter().any(|(name, _)| *name == said);
                    assert!(known || said.contains('/'), "[{}] {}: {said}", table.path, key.name);
                    checked += usize::from(known);
                }
            }
        }
        assert!(checked > 15, "{checked} keys");
    }

    /// A name that ends in a unit is not shown without one, or with that of an end of it: `_m_per_s` is no time.
    #[test]
    fn no_name_with_a_unit_is_shown_as_a_pure_number() {
        const UNITS: [&str; 13] = ["m", "m2", "m3", "m4", "kg", "s", "hz", "g", "n", "pa", "rad", "deg", "s2"];
        for table in TABLES {
            for key in table.keys.iter().filter(|key| !matches!(key.range, Range::Words(_) | Range::Free)) {
                let unit = by_ending(key.name, key, 1.0, BENCH).or_else(|| by_meaning(key)).unwrap_or(PURE);
                let last = key.name.rsplit('_').next().unwrap_or_default();
                assert!(
                    !key.name.contains('_') || !UNITS.contains(&last) || unit.dimension != Dimension::Pure,
                    "[{}] {}",
                    table.path,
                    key.name
                );
                assert!(
                    unit.dimension != Dimension::Time || !key.name.contains("_per_"),
                    "[{}] {}",
                    table.path,
                    key.name
                );
            }
        }
    }

    const BENCH: Size = Size { length: 0.19, mass: 2.0 };
}
