//! What `check` says of ground that does not move as one: delays, factors, how far supports move apart.

use crate::cli::digits::six;
use crate::dynamics::Model;
use crate::language::said;
use crate::scene::Scene;
use crate::scene::shown::escaped;
use crate::sim::moving_ground::{MovedSupport, moved_supports};

/// A line a support that moves otherwise than the ground of reference.
pub(super) fn texts(scene: &Scene, model: &Model) -> Vec<String> {
    let text = |MovedSupport { name, motion, ground, largest, last }: MovedSupport| {
        let [delay, factor, largest, last] = [motion.delay, motion.factor, largest, last].map(six);
        let name = escaped(&name);
        let ground = ground.map_or(String::new(), |ground| said!("check-own-ground", "ground" => escaped(&ground)));
        let line = said!(
            "check-moving",
            "name" => name,
            "ground" => ground,
            "delay" => delay,
            "factor" => factor,
            "largest" => largest,
            "last" => last
        );
        format!("{line}\n")
    };
    moved_supports(scene, model).into_iter().map(text).collect()
}
