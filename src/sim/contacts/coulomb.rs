//! Whether friction obeyed Coulomb's law throughout an answer of the impact model.

use crate::dynamics::impact2d::LastingInterval;
use crate::dynamics::impact2d::lasting::constrained_motion::FrictionMode;
use crate::language::{Message, message};
use crate::sim::contacts::view::Contacts;

impl Contacts<'_> {
    /// In words, when and for how long lasting contacts of the impact model went on without friction, as no motion agreed with it
    /// (`docs/impact-model.md#ends-well`, Painlevé); none where they never did.
    pub fn without_friction(self) -> Option<Message> {
        let record = self.history.impact()?;
        let without =
            |interval: &&LastingInterval| interval.modes.iter().any(|mode| mode.friction == FrictionMode::Frictionless);
        let mut all = record.lasting.iter().filter(without).peekable();
        let from = all.peek()?.from;
        let sum: f64 = all.map(|interval| interval.until - interval.from).sum();
        Some(message!("without-friction", "from" => from, "sum" => sum))
    }
}
