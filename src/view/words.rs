//! Names of states, laws and section forces in the picture.

use crate::language::{Text, values};
use crate::scene::FrictionLaw;
use crate::sim::{ContactState, GirderState, OfSection};

/// A state of a contact.
pub fn contact_state(state: ContactState) -> Text {
    match state {
        ContactState::Open => Text::new("state-open"),
        ContactState::Stick => Text::new("state-stick"),
        ContactState::Slip => Text::new("state-slip"),
    }
}

/// A state of a girder under the impact model.
pub fn impact_state(state: GirderState) -> Text {
    match state {
        GirderState::FreeTurning => Text::new("impact-a"),
        GirderState::Free => Text::new("impact-b"),
        GirderState::SlidingTurning => Text::new("impact-c"),
        GirderState::Turning => Text::new("impact-d"),
        GirderState::Sliding => Text::new("impact-e"),
        GirderState::Resting => Text::new("impact-f"),
    }
}

/// Name of a section force, with its sign.
pub fn section_force(force: OfSection) -> Text {
    match force {
        OfSection::Axial => Text::new("section-axial"),
        OfSection::Shear => Text::new("section-shear"),
        OfSection::Moment => Text::new("section-moment"),
        OfSection::Stress => Text::new("section-stress"),
        OfSection::VerticalShear => Text::new("section-vertical-shear"),
        OfSection::VerticalMoment => Text::new("section-vertical-moment"),
        OfSection::Torque => Text::new("section-torque"),
    }
}

/// The friction laws in use.
pub(super) fn friction_laws(laws: &[FrictionLaw]) -> String {
    let name = |law: &FrictionLaw| match law {
        FrictionLaw::Paper => Text::new("law-paper"),
        FrictionLaw::ReturnMapping => Text::new("law-return-mapping"),
    };
    let names: Vec<&str> = laws.iter().map(|law| name(law).as_str()).collect();
    Text::new("legend-law").with(&values!["laws" => names.join(", ")])
}
