//! A restrainer cable as placed.

use super::fault::{Fault, missing, written};
use super::joint::Joint;
use super::table::device_table;
use crate::language::{Text, message};
use crate::scene::keys::{Fallback, Range};

device_table! {
    /// A cable that pulls once its slack is used up.
    struct Restrainer, RESTRAINER {
        #[serde(default)]
        slack: f64 = "slack_m" as "field-slack", Range::NotNegative, Fallback::Number(0.0),
            "elongation since placed at which it is taut, m";
        stiffness: Option<f64> = "stiffness_n_per_m" as "field-stiffness-k", Range::Positive, Fallback::Needed("this or axial_stiffness_n"),
            "K = EA/ℓ, N/m";
        axial_stiffness: Option<f64> = "axial_stiffness_n" as "field-stiffness-ea", Range::Positive,
            Fallback::Needed("this or stiffness_n_per_m"), "EA of K = EA/ℓ, N";
        cable_length: Option<f64> = "length_m" as "field-cable-length", Range::Positive, Fallback::Words("distance of its points and slack_m"),
            "ℓ of K = EA/ℓ, m";
        yield_force: Option<f64> = "yield_force_n" as "field-yields-at", Range::Positive, Fallback::Words("none: elastic"),
            "T_y, force at the first yield, N";
        post_yield_stiffness: Option<f64> = "post_yield_stiffness_n_per_m" as "field-stiffness-after-yield", Range::NotNegative,
            Fallback::Words("0.0"), "K₂ in yield, less than K, N/m";
        break_elongation: Option<f64> = "break_elongation_m" as "field-breaks-at", Range::Positive, Fallback::Words("it does not break"),
            "elongation beyond the slack at which it breaks, m";
    }
}

impl Restrainer {
    /// K \[N/m\], where it is given.
    pub fn stiffness(&self, joint: &Joint) -> Option<f64> {
        let length = || self.cable_length.unwrap_or(joint.length() + self.slack);
        self.stiffness.or_else(|| self.axial_stiffness.map(|ea| ea / length()))
    }

    fn own_faults(&self, joint: Option<&Joint>) -> Vec<Fault> {
        let mut faults = Vec::new();
        match (self.stiffness, self.axial_stiffness) {
            (None, None) => faults.push(missing("stiffness_n_per_m", Text::new("wrong-cable-no-stiffness"))),
            (Some(_), Some(_)) => {
                let both = message!("found-both", "one" => "stiffness_n_per_m", "other" => "axial_stiffness_n");
                faults.push(("stiffness_n_per_m", both, Text::new("wrong-both").into()));
            }
            _ => {}
        }
        if let (Some(length), None) = (self.cable_length, self.axial_stiffness) {
            let remedy = Text::new("wrong-axial-stiffness-missing").into();
            faults.push(("length_m", written(length), remedy));
        }
        if let (Some(stiffness), None) = (self.post_yield_stiffness, self.yield_force) {
            let remedy = Text::new("wrong-yield-force-missing").into();
            faults.push(("post_yield_stiffness_n_per_m", written(stiffness), remedy));
        }
        let Some(joint) = joint else { return faults };
        faults.extend(joint.too_short());
        if let (Some(after), Some(before)) = (self.post_yield_stiffness, self.stiffness(joint))
            && after >= before
        {
            let remedy = message!("wrong-post-yield", "before" => format!("{before:?}"));
            faults.push(("post_yield_stiffness_n_per_m", written(after), remedy));
        }
        if let (Some(breaks), Some(force), Some(stiffness)) =
            (self.break_elongation, self.yield_force, self.stiffness(joint))
            && breaks <= force / stiffness
        {
            let remedy = message!("wrong-breaks-before-yield", "yields" => format!("{:?}", force / stiffness));
            faults.push(("break_elongation_m", written(breaks), remedy));
        }
        faults
    }
}
