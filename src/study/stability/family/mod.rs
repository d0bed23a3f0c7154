//! Families of random scenes: each looks for trouble in another place.

mod bodies;
mod devices;
mod faces;
mod pressed;
mod shaken;
mod thrown;

use super::random::Random;
use crate::scene::Scene;

/// Generator of a family's scenes.
type Maker = fn(&mut Random) -> Scene;

/// Every family by name; a seed belongs to number `seed mod` their count.
const FAMILIES: &[(&str, Maker)] = &[
    ("wide", shaken::wide),
    ("resonance", shaken::resonance),
    ("parallel", faces::parallel),
    ("corner", faces::corner),
    ("border", faces::border),
    ("grazing", faces::grazing),
    ("simultaneous", pressed::simultaneous),
    ("preloaded", pressed::preloaded),
    ("stick-slip", pressed::stick_slip),
    ("stiff", pressed::stiff),
    ("slender", bodies::slender),
    ("spinning", bodies::spinning),
    ("free", bodies::free),
    ("held", bodies::held),
    ("record", shaken::record),
    ("spatial", shaken::spatial),
];

/// The family that shakes for an hour.
pub const HOURS: &str = "hour";
/// One seed in this many shakes for an hour: ten in ten thousand.
const HOUR_EVERY: u64 = 1000;
/// Its number among these.
const HOUR: u64 = 7;

/// Girders thrown at one another.
pub const THROWN: &str = "thrown";
/// The seeds from this one on throw girders at one another; those below stay what they have always been.
pub const FIRST_THROWN: u64 = 1_000_000;
/// Girders thrown at one another in space.
pub const THROWN_IN_SPACE: &str = "thrown-in-space";
/// The seeds from this one on do so in space.
pub const FIRST_THROWN_IN_SPACE: u64 = 3_000_000;

/// Bearings that yield, slide and come off, devices, backfill, every normal law.
pub const DEVICES: &str = "devices";
/// The seeds from this one on.
pub const FIRST_DEVICES: u64 = 2_000_000;

/// Scenes with devices on supports whose ground moves later or more than that of the others.
pub const WAVES: &str = "waves";
/// The seeds from this one on.
pub const FIRST_WAVES: u64 = 4_000_000;

/// The scene of a seed, and the name of its family.
pub fn scene(seed: u64) -> (&'static str, Scene) {
    let mut random = Random::new(seed);
    let (family, maker) = if seed >= FIRST_WAVES {
        (WAVES, devices::waves as Maker)
    } else if seed >= FIRST_THROWN_IN_SPACE {
        (THROWN_IN_SPACE, thrown::thrown_in_space as Maker)
    } else if seed >= FIRST_DEVICES {
        (DEVICES, devices::devices as Maker)
    } else if seed >= FIRST_THROWN {
        (THROWN, thrown::thrown as Maker)
    } else if seed % HOUR_EVERY == HOUR {
        (HOURS, shaken::hour as Maker)
    } else {
        #[expect(clippy::cast_possible_truncation, reason = "below the number of families")]
        let number = (seed % FAMILIES.len() as u64) as usize;
        FAMILIES[number]
    };
    let mut scene = maker(&mut random);
    scene.name = format!("seed-{seed}");
    (family, scene)
}

/// Names of all families.
pub fn names() -> impl Iterator<Item = &'static str> {
    FAMILIES.iter().map(|(name, _)| *name).chain([HOURS, THROWN, DEVICES, THROWN_IN_SPACE, WAVES])
}
