//! Text of `check` on a device: its points, its law, the deformations at which it yields and breaks.

use super::super::digits::{list, six};
use super::super::summary::{device_kind, name};
use crate::language::{Text, said};
use crate::scene::device::{Ends, Joint};
use crate::scene::{Bumper, Damper, Device, DeviceId, Restrainer, Scene, Stopper};

/// Rates at which the force of a damper is given \[m/s\].
const RATES: [f64; 2] = [0.1, 1.0];

/// Every device, some lines each.
pub(super) fn texts(scene: &Scene) -> impl Iterator<Item = String> + '_ {
    scene.devices().into_iter().filter_map(|(id, part)| {
        let joint = Joint::of(scene, &part.ends())?;
        let law = law(&scene.device(id)?, &joint);
        Some(format!("{}\n  {law}\n", points(id, &part.ends(), &joint)))
    })
}

fn points(id: DeviceId, ends: &Ends<'_>, joint: &Joint) -> String {
    let [first, second] = joint.points.map(|point| list(&point.to_array()));
    let to = ends.to.map_or_else(|| Text::new("check-ground").into(), name);
    let length = six(joint.length());
    said!(
        "check-device",
        "kind" => device_kind(id.kind.label()),
        "name" => name(ends.name),
        "girder" => name(ends.girder),
        "first" => first,
        "to" => to,
        "second" => second,
        "length" => length
    )
}

fn law(device: &Device, joint: &Joint) -> String {
    match device {
        Device::Restrainer(cable) => restrainer(cable, joint),
        Device::Bumper(rubber) => bumper(rubber, joint),
        Device::Damper(damper) => viscous(damper),
        Device::Stopper(key) => stopper(key, joint),
    }
}

fn restrainer(cable: &Restrainer, joint: &Joint) -> String {
    let stiffness = cable.stiffness(joint).unwrap_or(f64::NAN);
    let taut = said!("check-cable", "slack" => six(cable.slack * 1e3), "stiffness" => six(stiffness));
    let yields = cable.yield_force.map(|force| {
        let [at, after] = [force / stiffness * 1e3, cable.post_yield_stiffness.unwrap_or(0.0)].map(six);
        said!("check-cable-yields", "force" => six(force), "at" => at, "after" => after)
    });
    let breaks = cable.break_elongation.map(|elongation| {
        let elastic = stiffness * elongation;
        let after = cable.post_yield_stiffness.unwrap_or(0.0);
        let force = cable
            .yield_force
            .map_or(elastic, |yields| elastic.min(yields + after * (elongation - yields / stiffness).max(0.0)));
        said!("check-cable-breaks", "elongation" => six(elongation * 1e3), "force" => six(force))
    });
    [Some(taut), yields, breaks].into_iter().flatten().collect()
}

fn bumper(rubber: &Bumper, joint: &Joint) -> String {
    let normal = rubber.normal(joint).unwrap_or_default();
    let [gap, _] = rubber.gaps(joint).unwrap_or_default();
    let points = rubber.depths_and_forces();
    let lines = match (rubber.stiffness, points.as_slice()) {
        (Some(stiffness), _) => format!("K = {} N/m", six(stiffness)),
        (None, points) => {
            let each: Vec<String> = points
                .iter()
                .map(|[d, f]| said!("check-bumper-point", "force" => six(*f), "depth" => six(d * 1e3)))
                .collect();
            each.join(", ")
        }
    };
    let [gap, damping] = [gap * 1e3, rubber.damping].map(six);
    said!("check-bumper", "normal" => list(&normal.to_array()), "gap" => gap, "lines" => lines, "damping" => damping)
}

fn viscous(damper: &Damper) -> String {
    let Damper { coefficient, exponent, regularisation, .. } = *damper;
    let [slow, fast] = RATES.map(|v| six(coefficient * v.powf(exponent)));
    let [c, alpha] = [coefficient, exponent].map(six);
    let form = match damper.brace_stiffness {
        Some(brace) => said!("check-brace", "brace" => six(brace)),
        None if exponent < 1.0 => said!("check-regularised", "speed" => six(regularisation)),
        None => Text::new("check-linear").into(),
    };
    said!("check-damper", "c" => c, "alpha" => alpha, "slow" => slow, "fast" => fast, "form" => form)
}

fn stopper(key: &Stopper, joint: &Joint) -> String {
    let direction = key.direction(joint).unwrap_or_default();
    let sides: Vec<String> = key.stops().iter().map(|(sign, gap)| six(sign * gap * 1e3)).collect();
    let mm = |force: f64| six(force / key.stiffness * 1e3);
    let fails = match (key.break_force, key.yield_force, key.break_displacement) {
        (Some(force), ..) => said!("check-stop-breaks", "force" => six(force), "at" => mm(force)),
        (None, Some(force), None) => said!("check-stop-yields", "force" => six(force), "at" => mm(force)),
        (None, Some(force), Some(after)) => {
            said!("check-stop-yields-breaks", "force" => six(force), "at" => mm(force), "after" => six(after * 1e3))
        }
        (None, None, _) => String::new(),
    };
    let along = list(&direction.to_array());
    let both = |one, other| said!("found-both", "one" => one, "other" => other);
    said!(
        "check-stopper",
        "sides" => sides.into_iter().reduce(both).unwrap_or_default(),
        "along" => along,
        "stiffness" => six(key.stiffness),
        "fails" => fails
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{overrides, presets};

    #[test]
    fn each_device_is_said_with_its_deformations() {
        let ends = "girder = \"deck\", at_m = [-0.095, 0.0], to_m = [-0.195, 0.0]";
        let sets = [
            format!("restrainer=[{{ name = \"a\", {ends}, slack_m = 0.002, stiffness_n_per_m = 2e4, yield_force_n = 40, post_yield_stiffness_n_per_m = 1e3, break_elongation_m = 0.005 }}]"),
            format!("bumper=[{{ name = \"b\", {ends}, depth_force_m_n = [[0.001, 10], [0.002, 45]], damping_n_s_per_m = 8 }}]"),
            format!("damper=[{{ name = \"c\", {ends}, coefficient = 10, exponent = 0.5 }}]"),
            "stopper=[{ name = \"d\", girder = \"deck\", at_m = [0, 0], gap_m = 0.003, stiffness_n_per_m = 3e4, yield_force_n = 15, break_displacement_m = 0.006 }]".to_owned(),
        ];
        let scene = overrides::apply_all(&presets::load("straight-abutment").expect("ships"), &sets).expect("fits");
        let said: String = texts(&scene).collect();
        // T_y + K₂ (ε_u − T_y/K) = 40 + 1000 · 0.003 N; 10 √0.1 N; 15/3e4 m.
        for words in [
            "restrainer a: deck at -0.095, 0, 0 m to the ground at -0.195, 0, 0 m, 0.1 m apart",
            "taut at 2 mm, K = 20000 N/m, yields at 40 N (2 mm beyond), then K₂ = 1000 N/m, breaks at 5 mm beyond (43 N)",
            "pushes towards 1, 0, 0, from 100 mm on; 10 N at 1 mm, 45 N at 2 mm, c = 8 N·s/m",
            "F = 10 |v|^0.5 N: 3.16228 N at 0.1 m/s, 10 N at 1 m/s; regularised at 0.0001 m/s",
            "stops at 3 and -3 mm along 0, 1, 0, K = 30000 N/m, yields at 15 N (0.5 mm), breaks 6 mm on",
        ] {
            assert!(said.contains(words), "{words}: {said}");
        }
    }
}
