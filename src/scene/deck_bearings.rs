//! Equal bearings of a whole deck by their kind: lead rubber or friction pendulums, with numbers proposed from the deck's mass
//! where the file gives none (`docs/physics.md#bearings-of-a-whole-deck`).

use std::f64::consts::{PI, TAU};

use serde::{Deserialize, Serialize};

use super::Kind;
use super::bearing_law::{BearingSlide, BearingYield, SLIDER_DISPLACEMENT};
use super::keys::{Fallback, Range, table, words};

/// Period after yield, or of a pendulum \[s\].
const PERIOD: f64 = 2.0;
/// `Q_d/W` \[–\].
const FORCE_PER_WEIGHT: f64 = 0.07;
/// k₁/k₂ \[–\]: the usual Japanese ratio, from memory.
const STIFFNESS_RATIO: f64 = 6.5;
/// μ \[–\], of the usual 0.03 to 0.12.
const FRICTION: f64 = 0.05;

words! {
    /// Kind of bearings under a whole deck.
    BearingKind, by default LeadRubber {
        /// Rubber with a lead plug: k₁ up to yield, k₂ after it.
        LeadRubber = "lead-rubber",
        /// Sliders in dishes of radius R with friction μ.
        Pendulum = "pendulum",
    }
}

table! {
    /// Equal bearings of a whole deck, by their kind.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct DeckBearings, DECK_BEARINGS {
        kind: BearingKind = "kind" as "field-bearings", Range::Words(BearingKind::WORDS), Fallback::Needed("must be given"),
            "what they are";
        period: Option<f64> = "post_yield_period_s" as "field-period", Range::Positive, Fallback::Words("2.0, assumed"),
            "T of the deck on k₂ of lead rubber, or on its pendulums, s";
        force_per_weight: Option<f64> = "yield_force_per_weight" as "field-q-over-w", Range::Positive, Fallback::Words("0.07, assumed"),
            "Q of all lead-rubber bearings per weight of the deck";
        stiffness_ratio: Option<f64> = "stiffness_ratio" as "field-k1-over-k2", Range::Positive, Fallback::Words("6.5, assumed"),
            "k₁/k₂ of lead rubber, more than 1";
        damping_ratio: Option<f64> = "damping_ratio" as "field-damping-h", Range::NotNegative, Fallback::Words("0.0"),
            "of the rubber itself, of critical at the period";
        friction: Option<f64> = "friction" as "field-friction", Range::Positive, Fallback::Words("0.05, assumed"),
            "μ of pendulums";
        radius: Option<f64> = "radius_m" as "field-radius", Range::NotNegative, Fallback::Words("of the period"),
            "R of pendulums, 0 of flat sliders, m";
        slider_displacement: Option<f64> = "slider_displacement_m" as "field-slides-at", Range::Positive, Fallback::Words("0.0005, assumed"),
            "displacement at which the friction of pendulums is fully there, a regularisation; full scale, m";
        vertical_frequency_hz: Option<f64> = "vertical_frequency_hz" as "frequency-z", Range::Positive,
            Fallback::Needed("must be given in a spatial scene (unless z is held)"),
            "f_z, Hz; not used in a planar scene";
        vertical_damping_ratio: Option<f64> = "vertical_damping_ratio" as "damping-z", Range::NotNegative, Fallback::Words("0.0"), "h_z";
        at: Option<Vec<[f64; 2]>> = "at_m", Range::Like("one or more [x, y]"), Fallback::Needed("this or the next"),
            "places in the girder's frame, m";
        at_skewed: Option<Vec<[f64; 2]>> = "at_skewed_m", Range::Like("one or more [x, y]"),
            Fallback::Needed("this or the last"),
            "places before skewing, m: y cot β is added to x, so that they follow the skew";
        travel: Option<f64> = "travel_m" as "field-free-travel", Range::Positive, Fallback::Words("no end"),
            "displacement square to the front edge of its seat, either way, at which a bearing loses its support, m";
        height: Option<f64> = "height_m" as "field-height", Range::Any, Fallback::Words("the underside, -thickness_m / 2"),
            "height above G in the girder's frame, m", in in_space;
        on_minus_x: Option<String> = "on_minus_x", Range::Like("a pier or an abutment"), Fallback::Words("the ground"),
            "the pier or abutment under the bearings of the -x half";
        on_plus_x: Option<String> = "on_plus_x", Range::Like("a pier or an abutment"), Fallback::Words("the ground"),
            "the pier or abutment under the bearings of the +x half";
    }
}

/// Loop of bearings that yield, of one or of all of a deck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loop {
    /// k₂, after yield \[N/m\].
    pub stiffness: f64,
    /// Its yield: Q and `u_y`.
    pub yielding: BearingYield,
}

impl Loop {
    /// k₁, before yield \[N/m\].
    pub fn first_stiffness(&self) -> f64 {
        self.stiffness + self.yielding.stiffness()
    }

    /// `k_eff` = k₂ + Q/U at the amplitude U \[N/m\].
    pub fn effective_stiffness(&self, amplitude: f64) -> f64 {
        self.stiffness + self.yielding.force / amplitude
    }

    /// Period of a mass on `k_eff` \[s\].
    pub fn effective_period(&self, amplitude: f64, mass: f64) -> f64 {
        TAU * (mass / self.effective_stiffness(amplitude)).sqrt()
    }

    /// `h_eq` = 2Q(U − `u_y`)/(π `k_eff` U²), of an amplitude beyond yield.
    pub fn equivalent_damping(&self, amplitude: f64) -> f64 {
        let BearingYield { force, displacement, .. } = self.yielding;
        2.0 * force * (amplitude - displacement) / (PI * self.effective_stiffness(amplitude) * amplitude.powi(2))
    }
}

impl DeckBearings {
    /// Bearings of this kind at these places before skewing \[m\], with every number proposed.
    pub fn proposed(kind: BearingKind, at_skewed: Vec<[f64; 2]>) -> Self {
        use super::keys::Keyed as _;
        Self { kind, at_skewed: Some(at_skewed), ..Self::by_default() }
    }

    /// T after yield \[s\].
    fn period(&self) -> f64 {
        self.period.unwrap_or(PERIOD)
    }

    /// R of a pendulum under this gravity \[m/s²\]; 0 of a flat slider \[m\].
    pub fn radius(&self, gravity: f64) -> f64 {
        self.radius.unwrap_or(gravity * (self.period() / TAU).powi(2))
    }

    /// Loop of all bearings together under a deck of this mass \[kg\].
    pub fn whole(&self, mass: f64, gravity: f64) -> Loop {
        let weight = mass * gravity;
        match self.kind {
            BearingKind::LeadRubber => {
                let stiffness = mass * (TAU / self.period()).powi(2);
                let force = self.force_per_weight.unwrap_or(FORCE_PER_WEIGHT) * weight;
                let beside = (self.stiffness_ratio.unwrap_or(STIFFNESS_RATIO) - 1.0) * stiffness;
                Loop { stiffness, yielding: BearingYield { force, displacement: force / beside, per_axis: false } }
            }
            BearingKind::Pendulum => {
                let slide = self.slide(weight, gravity);
                Loop { stiffness: slide.restoring(), yielding: slide.yielding() }
            }
        }
    }

    /// A slider of them with this load \[N\].
    pub(super) fn slide(&self, load: f64, gravity: f64) -> BearingSlide {
        let radius = self.radius(gravity);
        BearingSlide {
            friction: self.friction.unwrap_or(FRICTION),
            curvature: if radius > 0.0 { radius.recip() } else { 0.0 },
            displacement: self.slider_displacement.unwrap_or(SLIDER_DISPLACEMENT),
            load,
        }
    }

    /// c of all of them along a horizontal axis, under a deck of this mass \[N·s/m\].
    pub(super) fn damping(&self, mass: f64) -> f64 {
        2.0 * self.damping_ratio.unwrap_or(0.0) * mass * TAU / self.period()
    }

    /// `(f, h)` straight up and down; 0 in a planar scene, or where none is given.
    pub(super) fn vertical(&self, kind: Kind) -> (f64, f64) {
        match kind {
            Kind::Planar => (0.0, 0.0),
            Kind::Spatial => (self.vertical_frequency_hz.unwrap_or(0.0), self.vertical_damping_ratio.unwrap_or(0.0)),
        }
    }

    /// Keys that shape the loop and are left out, with the number assumed for each.
    pub fn assumed(&self) -> Vec<(&'static str, f64)> {
        let lead = [
            ("post_yield_period_s", self.period, PERIOD),
            ("yield_force_per_weight", self.force_per_weight, FORCE_PER_WEIGHT),
            ("stiffness_ratio", self.stiffness_ratio, STIFFNESS_RATIO),
        ];
        let pendulum = [
            ("friction", self.friction, FRICTION),
            // A radius that is given says the period.
            ("post_yield_period_s", self.radius.or(self.period), PERIOD),
            ("slider_displacement_m", self.slider_displacement, SLIDER_DISPLACEMENT),
        ];
        let keys = match self.kind {
            BearingKind::LeadRubber => lead,
            BearingKind::Pendulum => pendulum,
        };
        keys.into_iter().filter(|(_, given, _)| given.is_none()).map(|(key, _, number)| (key, number)).collect()
    }

    /// Keys that belong to another kind.
    fn of_other_kinds(&self) -> [(&'static str, Option<f64>); 3] {
        let lead = [
            ("yield_force_per_weight", self.force_per_weight),
            ("stiffness_ratio", self.stiffness_ratio),
            ("damping_ratio", self.damping_ratio),
        ];
        let pendulum = [
            ("friction", self.friction),
            ("radius_m", self.radius),
            ("slider_displacement_m", self.slider_displacement),
        ];
        match self.kind {
            BearingKind::LeadRubber => pendulum,
            BearingKind::Pendulum => lead,
        }
    }

    /// Keys that are given and belong to another kind.
    pub(super) fn foreign(&self) -> Vec<&'static str> {
        self.of_other_kinds().into_iter().filter(|(_, given)| given.is_some()).map(|(key, _)| key).collect()
    }

    /// Keys that are not given and belong to another kind: an editor leaves them out.
    pub fn not_of_this_kind(&self) -> Vec<&'static str> {
        self.of_other_kinds().into_iter().filter(|(_, given)| given.is_none()).map(|(key, _)| key).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::STANDARD_GRAVITY;

    /// A deck of 30 m \[kg\].
    const MASS: f64 = 3.0e5;

    fn near(what: &str, got: f64, expected: f64) {
        assert!((got / expected - 1.0).abs() < 1e-3, "{what}: {got} is not {expected}");
    }

    #[test]
    fn what_the_keys_say_is_assumed_is_what_is() {
        let assumed = [
            ("post_yield_period_s", PERIOD),
            ("yield_force_per_weight", FORCE_PER_WEIGHT),
            ("stiffness_ratio", STIFFNESS_RATIO),
            ("friction", FRICTION),
            ("slider_displacement_m", SLIDER_DISPLACEMENT),
        ];
        for (name, number) in assumed {
            let key = DECK_BEARINGS.iter().find(|key| key.name == name).expect("a key");
            let words = format!("{number:?}, assumed");
            assert!(matches!(key.fallback, Fallback::Words(said) if said == words), "{name}: {words}");
        }
    }

    #[test]
    fn lead_rubber_of_a_30_m_deck_has_the_worked_numbers() {
        let proposed = DeckBearings::proposed(BearingKind::LeadRubber, vec![[0.0; 2]; 8]);
        let whole = proposed.whole(MASS, STANDARD_GRAVITY);
        near("k₂", whole.stiffness, 2.961e6);
        near("k₂ a leg", whole.stiffness / 8.0, 370.1e3);
        near("Q", whole.yielding.force, 205.9e3);
        near("Q a leg", whole.yielding.force / 8.0, 25.74e3);
        near("k₁", whole.first_stiffness(), 19.25e6);
        near("u_y", whole.yielding.displacement, 12.65e-3);
        for (amplitude, stiffness, period, damping) in [(0.1, 5.020e6, 1.536, 0.2281), (0.2, 3.991e6, 1.723, 0.1539)] {
            near("k_eff", whole.effective_stiffness(amplitude), stiffness);
            near("T_eff", whole.effective_period(amplitude, MASS), period);
            near("h_eq", whole.equivalent_damping(amplitude), damping);
        }
        assert_eq!(proposed.assumed().len(), 3, "all of it is assumed");
    }

    #[test]
    fn a_pendulum_of_the_period_has_its_radius() {
        let pendulum = DeckBearings::proposed(BearingKind::Pendulum, vec![[0.0; 2]]);
        let radius = pendulum.radius(STANDARD_GRAVITY);
        near("T = 2π √(R/g)", TAU * (radius / STANDARD_GRAVITY).sqrt(), 2.0);
        let whole = pendulum.whole(MASS, STANDARD_GRAVITY);
        near("N/R", whole.stiffness, MASS * STANDARD_GRAVITY / radius);
        near("μN", whole.yielding.force, 0.05 * MASS * STANDARD_GRAVITY);
        assert_eq!(DeckBearings { radius: Some(0.0), ..pendulum }.whole(MASS, STANDARD_GRAVITY).stiffness, 0.0, "flat");
    }
}
