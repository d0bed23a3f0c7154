//! Which keys of a scene a map can have, how each is called, and what a map shows at first.

use crate::app::command::{MapAxis, MapDraft};
use crate::app::unit::{Size, Unit, unit_of};
use crate::scene::keys::{Fallback, Key, Range, TABLES, of_place};
use crate::scene::overrides::Laid;
use crate::scene::{Bearings, Motion, Scene};
use crate::study::sweep::own_value;

/// Keys that are looked for first, each by the end of its path.
const USUAL: [&str; 4] = [SKEW, "motion.angle_deg", ".gap_m", "motion.frequency_hz"];

/// That which turns the ends of one girder.
const SKEW: &str = ".skew_deg";

/// Values of a key that a map has at first.
const CELLS: usize = 33;

/// Paths of every key of a scene that is one number, as `--set` takes it.
pub(super) fn keys(scene: &Scene) -> Vec<String> {
    let Ok(laid) = Laid::out(scene) else { return Vec::new() };
    let of_table = |table: &'static crate::scene::keys::Table| {
        let numbers = table.keys.iter().filter(|key| is_number(key));
        let places = places(scene, table.path);
        places.into_iter().flat_map(move |place| {
            numbers
                .clone()
                .map(move |key| if place.is_empty() { key.name.into() } else { format!("{place}.{}", key.name) })
        })
    };
    let all = TABLES.iter().flat_map(of_table);
    all.filter(|path: &String| laid.value(path).is_none_or(|value| value.is_float() || value.is_integer())).collect()
}

fn is_number(key: &Key) -> bool {
    let number = matches!(
        key.range,
        Range::Any | Range::Positive | Range::NotNegative | Range::NotBelow(_) | Range::Within(_) | Range::Between(_)
    );
    number && !matches!(key.fallback, Fallback::Zeros(_))
}

/// Where a scene has a table of this path; what is only looked at and not computed with is left out.
fn places(scene: &Scene, path: &str) -> Vec<String> {
    let girders = || scene.girders.iter().map(|girder| format!("girder.{}", girder.name));
    let kind = match &scene.motion {
        Motion::None => "",
        Motion::Sine(_) => "motion kind = sine",
        Motion::Record(_) => "motion kind = record",
        Motion::Synthetic(_) => "motion kind = synthetic",
        Motion::Sweep(_) => "motion kind = sweep",
    };
    match path {
        "" | "contact" | "impact" => vec![path.to_owned()],
        "girder" => girders().collect(),
        "girder.bearings" => {
            let equal = scene.girders.iter().filter(|girder| matches!(girder.bearings, Some(Bearings::Shared(_))));
            equal.map(|girder| format!("girder.{}.bearings", girder.name)).collect()
        }
        "girder.initial" | "girder.push" => {
            let table = path.rsplit('.').next().unwrap_or_default();
            girders().map(|girder| format!("{girder}.{table}")).collect()
        }
        "abutment" => scene.abutments.iter().map(|wall| format!("abutment.{}", wall.name)).collect(),
        "abutment.backfill" => {
            let walls = scene.abutments.iter().filter(|wall| wall.backfill.is_some());
            walls.map(|wall| format!("abutment.{}.backfill", wall.name)).collect()
        }
        "motion.processing" if matches!(scene.motion, Motion::Record(_)) => vec![path.to_owned()],
        _ if path == kind => vec!["motion".to_owned()],
        device => {
            let own = scene.devices().into_iter().filter(|(id, _)| id.kind.label() == device);
            own.map(|(_, part)| format!("{device}.{}", part.ends().name)).collect()
        }
    }
}

/// How numbers of a key are shown in a scene.
pub(super) fn unit(scene: &Scene, path: &str, now: f64) -> Unit {
    unit_of(path, now, Size::of_scene(scene))
}

/// A key with the stretch of its slider, or about what it is now.
pub(super) fn axis(laid: &Laid, path: &str) -> MapAxis {
    let known = of_place(path).map(|(_, key)| *key);
    let now = own_value(laid, path).unwrap_or(0.0);
    let about = if now == 0.0 { [0.0, 1.0] } else { [0.5 * now, 2.0 * now] };
    let [from, to] = known.and_then(|key| key.slider).unwrap_or(about);
    let within = |value: f64| known.map_or(value, |key| key.range.nearest(value, now));
    MapAxis { key: path.to_owned(), from: within(from), to: within(to), is_log: false }
}

/// First choices of a map of a scene; `None` where the scene has not two keys.
pub(super) fn first(scene: &Scene) -> Option<MapDraft> {
    let (laid, keys) = (Laid::out(scene).ok()?, keys(scene));
    // The end of one girder among several would turn into its neighbour.
    let alone = scene.girders.len() == 1;
    let fitting = USUAL.iter().filter(|end| alone || **end != SKEW);
    let usual = fitting.filter_map(|end| keys.iter().find(|key| key.ends_with(end)));
    let mut chosen: Vec<&String> = usual.take(2).collect();
    chosen.extend(keys.iter().filter(|key| !chosen.contains(key)).take(2 - chosen.len()).collect::<Vec<_>>());
    let [x, y] = chosen[..] else { return None };
    Some(MapDraft { axes: [axis(&laid, x), axis(&laid, y)], measure: "max_rotation", cells: CELLS })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::text;
    use crate::scene::overrides;
    use crate::scene::presets;

    #[test]
    fn every_key_that_is_offered_can_be_set() {
        for preset in presets::all() {
            let scene = presets::load(preset.name).expect("ships");
            let laid = Laid::out(&scene).expect("fits");
            let keys = keys(&scene);
            assert!(keys.len() > 20, "{}: {keys:?}", preset.name);
            for key in keys {
                let value = own_value(&laid, &key).unwrap_or(1.0);
                let set = overrides::apply(&scene, &format!("{key}={value:?}"));
                assert!(set.is_ok(), "{}: {key}: {set:?}", preset.name);
            }
        }
    }

    #[test]
    fn a_map_of_several_girders_does_not_begin_with_the_skew_of_one() {
        let scene = presets::load("viaduct-5").expect("ships");
        let draft = first(&scene).expect("keys enough");
        assert!(draft.axes.iter().all(|axis| !axis.key.ends_with(SKEW)), "{draft:?}");
    }

    #[test]
    fn a_map_begins_with_skew_and_angle() {
        let scene = presets::load("skew45-abutment").expect("ships");
        let draft = first(&scene).expect("keys enough");
        assert_eq!(draft.axes.each_ref().map(|axis| axis.key.as_str()), ["girder.deck.skew_deg", "motion.angle_deg"]);
        assert!(draft.axes.iter().all(|axis| axis.from < axis.to), "a stretch each: {draft:?}");
        assert_eq!(
            text::title_of(&draft.axes[0].key),
            text::of_whom(text::field(of_place("girder.deck.skew_deg").expect("known").1), "deck")
        );
    }
}
