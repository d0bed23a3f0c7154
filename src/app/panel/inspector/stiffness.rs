//! K, or what it is reckoned from; and the rules of contact, which have few choices.

use egui::Ui;

use crate::app::field::{Change, Place, laid_over};
use crate::app::text;
use crate::app::unit::{MODULUS, area_unit, stiffness_unit};
use crate::scene::facing::DEFAULT_YOUNG_MODULUS;
use crate::scene::{FrictionLaw, Sharing, Tension};

pub(super) const LAWS: [(FrictionLaw, &str); 2] =
    [(FrictionLaw::Paper, text::LAW_PAPER), (FrictionLaw::ReturnMapping, text::LAW_RETURN)];
pub(super) const SHARINGS: [(Sharing, &str); 2] =
    [(Sharing::Tributary, text::SHARING_TRIBUTARY), (Sharing::PerNode, text::SHARING_PER_NODE)];
pub(super) const TENSIONS: [(Tension, &str); 2] =
    [(Tension::Keep, text::TENSION_KEEP), (Tension::Clamp, text::TENSION_CLAMP)];

/// K, E and A where they are given.
pub(super) struct Given<'a> {
    pub(super) k: &'a mut Option<f64>,
    pub(super) e: &'a mut Option<f64>,
    pub(super) a: &'a mut Option<f64>,
}

/// Rows of K, E and A. K says the same thing as the other two: whichever is given last stands.
pub(super) fn rows(
    ui: &mut Ui,
    place: Place<'_>,
    whose: &str,
    given: Given<'_>,
    (k_now, area): (f64, Option<f64>),
) -> Option<Change> {
    let Given { k, e, a } = given;
    let name = |words: &str| format!("{words} {whose}");
    let unit = stiffness_unit(k.unwrap_or(k_now));
    let by_k = laid_over(ui, place, ("stiffness_n_per_m", &name("K")), (k, k_now), unit);
    if by_k.is_some() && k.is_some() {
        (*e, *a) = (None, None);
    }
    let by_e = laid_over(ui, place, ("young_modulus_pa", &name("E")), (e, DEFAULT_YOUNG_MODULUS), MODULUS);
    let area = area.or(*a).unwrap_or(0.0);
    let by_a = laid_over(ui, place, ("area_m2", &name("A")), (a, area), area_unit(area));
    if (by_e.is_some() && e.is_some()) || (by_a.is_some() && a.is_some()) {
        *k = None;
    }
    by_k.or(by_e).or(by_a)
}
