//! A shear key or stopper as placed.

use glam::DVec3;

use super::fault::{Fault, missing, written};
use super::joint::{Joint, no_direction};
use super::table::device_table;
use crate::language::{Text, message};
use crate::scene::keys::{Fallback, Range, words};

words! {
    /// Sides at which a stopper stops.
    Sides, by default Both {
        /// At either side.
        Both = "both",
        /// Moving along the direction.
        Plus = "+",
        /// Moving against it.
        Minus = "-",
    }
}

device_table! {
    /// A shear key or stopper: a stop to either side along a direction.
    struct Stopper, STOPPER {
        #[serde(default, with = "crate::scene::two_or_three::optional")]
        direction: Option<[f64; 3]> = "direction" as "field-direction", Range::Like("two or three numbers"),
            Fallback::Words("across the girder"),
            "d as placed, in the girder's frame; it turns with the body of to_m";
        #[serde(default)]
        sides: Sides = "sides" as "field-sides", Range::Words(Sides::WORDS), Sides::FALLBACK,
            "whether it stops motion along d, against d, or both";
        #[serde(default)]
        gap: f64 = "gap_m" as "field-gap", Range::NotNegative, Fallback::Number(0.0),
            "way along d since placed before it touches, m";
        minus_gap: Option<f64> = "minus_gap_m" as "field-gap-against", Range::NotNegative, Fallback::Words("as gap_m"),
            "the same against d, m";
        stiffness: f64 = "stiffness_n_per_m" as "field-stiffness", Range::Positive, Fallback::Needed("must be given"), "K of each side, N/m";
        break_force: Option<f64> = "break_force_n" as "field-breaks-at", Range::Positive, Fallback::Words("none"),
            "F_u at which a brittle side breaks, N";
        yield_force: Option<f64> = "yield_force_n" as "field-yields-at", Range::Positive, Fallback::Words("none"),
            "F_y at which a ductile side yields, N";
        break_displacement: Option<f64> = "break_displacement_m" as "field-breaks-after", Range::Positive,
            Fallback::Words("it does not break"), "plastic displacement w_u at which a ductile side breaks, m";
    }
}

impl Stopper {
    /// Unit direction as placed, world axes.
    pub fn direction(&self, joint: &Joint) -> Option<DVec3> {
        joint.direction(self.direction.unwrap_or([0.0, 1.0, 0.0]))
    }

    /// Sides that stop: the sign of each along the direction, and its gap \[m\].
    pub fn stops(&self) -> Vec<(f64, f64)> {
        let stops = [(Sides::Plus, 1.0, self.gap), (Sides::Minus, -1.0, self.minus_gap.unwrap_or(self.gap))];
        let acts = |side: &(Sides, f64, f64)| self.sides == Sides::Both || self.sides == side.0;
        stops.into_iter().filter(acts).map(|(_, sign, gap)| (sign, gap)).collect()
    }

    fn own_faults(&self, _: Option<&Joint>) -> Vec<Fault> {
        let mut faults: Vec<Fault> = no_direction("direction", self.direction).into_iter().collect();
        if self.break_force.is_some() && self.yield_force.is_some() {
            let remedy = Text::new("wrong-brittle-and-ductile").into();
            faults.push((
                "break_force_n",
                message!("found-both", "one" => "break_force_n", "other" => "yield_force_n"),
                remedy,
            ));
        }
        if self.break_displacement.is_some() && self.yield_force.is_none() {
            faults.push(missing("yield_force_n", Text::new("wrong-break-displacement")));
        }
        if let (Some(gap), Sides::Plus) = (self.minus_gap, self.sides) {
            let remedy = Text::new("wrong-minus-gap").into();
            faults.push(("minus_gap_m", written(gap), remedy));
        }
        faults
    }
}
