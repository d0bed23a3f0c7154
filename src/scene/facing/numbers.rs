//! The contact numbers in force for a pair: `[contact]`, overridden by every `[[contact.pair]]` between the two.

use super::{PairContact, Side};
use crate::scene::{ContactSettings, PairSettings, Scene};

/// `E` where neither `K` nor `E` is given: ordinary concrete \[Pa\].
pub const DEFAULT_YOUNG_MODULUS: f64 = 30e9;

/// Whether an entry of `[[contact.pair]]` is about this pair.
pub(super) fn is_between(scene: &Scene, pair: &PairSettings, sides: &(Side, Side)) -> bool {
    let matches = |side: Side, n: usize| match side {
        Side::Girder(g, end) => scene.girders[g].name == pair.between[n] && pair.ends.is_none_or(|ends| ends[n] == end),
        Side::Abutment(a) => scene.abutments[a].name == pair.between[n],
    };
    (matches(sides.0, 0) && matches(sides.1, 1)) || (matches(sides.0, 1) && matches(sides.1, 0))
}

/// The numbers in force; of several entries about one pair the last one wins, key by key.
pub(super) fn in_force(scene: &Scene, first: Side, second: Side) -> PairContact {
    // All but the list of pairs, which may be as long as the row.
    let ContactSettings { stiffness: k, young_modulus, area, law, sharing, tension, .. } = scene.contact;
    let ContactSettings { restitution_normal, restitution_tangential, mu_static, mu_kinetic, .. } = scene.contact;
    let mut settings = ContactSettings {
        stiffness: k,
        young_modulus,
        area,
        restitution_normal,
        restitution_tangential,
        mu_static,
        mu_kinetic,
        law,
        sharing,
        tension,
        pairs: Vec::new(),
    };
    let about = scene.contact.pairs.iter().filter(|pair| is_between(scene, pair, &(first, second)));
    about.for_each(|pair| lay_over(&mut settings, pair));
    PairContact {
        stiffness: stiffness(scene, &settings, first, second),
        restitution_normal: settings.restitution_normal,
        restitution_tangential: settings.restitution_tangential,
        mu_static: settings.mu_static,
        mu_kinetic: settings.mu_kinetic,
        law: settings.law,
        sharing: settings.sharing,
        tension: settings.tension,
    }
}

fn lay_over(settings: &mut ContactSettings, pair: &PairSettings) {
    fn set<T: Copy>(to: &mut T, from: Option<T>) {
        *to = from.unwrap_or(*to);
    }
    // A pair's E or A asks for E A / L there, whatever `[contact]` says about K.
    if pair.stiffness.is_some() || pair.young_modulus.is_some() || pair.area.is_some() {
        settings.stiffness = pair.stiffness;
    }
    settings.young_modulus = pair.young_modulus.or(settings.young_modulus);
    settings.area = pair.area.or(settings.area);
    set(&mut settings.restitution_normal, pair.restitution_normal);
    set(&mut settings.restitution_tangential, pair.restitution_tangential);
    set(&mut settings.mu_static, pair.mu_static);
    set(&mut settings.mu_kinetic, pair.mu_kinetic);
    set(&mut settings.law, pair.law);
    set(&mut settings.sharing, pair.sharing);
    set(&mut settings.tension, pair.tension);
}

/// `K` as given, or `K = E A / L` (64): of two girders the smaller.
fn stiffness(scene: &Scene, settings: &ContactSettings, first: Side, second: Side) -> f64 {
    if let Some(k) = settings.stiffness {
        return k;
    }
    let of = |side: Side| match side {
        Side::Girder(n, _) => {
            let girder = &scene.girders[n];
            let area = settings.area.unwrap_or(girder.width * girder.thickness);
            settings.young_modulus.unwrap_or(DEFAULT_YOUNG_MODULUS) * area / girder.length
        }
        Side::Abutment(_) => f64::INFINITY,
    };
    of(first).min(of(second))
}
