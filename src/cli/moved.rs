//! A support whose ground moves otherwise, in words.

use super::digits::six;
use crate::language::said;
use crate::scene::shown::escaped;
use crate::sim::moving_ground::MovedSupport;

/// Which support, and how it moves.
pub(super) fn words(moved: &MovedSupport) -> String {
    let MovedSupport { name, motion, ground, largest, last, .. } = moved;
    let [delay, factor, largest, last] = [motion.delay, motion.factor, *largest, *last].map(six);
    let own = |ground: &String| said!("moved-own-ground", "ground" => escaped(ground));
    said!(
        "moved-support",
        "name" => escaped(name),
        "ground" => ground.as_ref().map_or(String::new(), own),
        "delay" => delay,
        "factor" => factor,
        "largest" => largest,
        "last" => last
    )
}
