//! Events of contacts as recorded, and the reason of an early stop.

use crate::contact::Mode;
use crate::language::{Message, Text};

/// Kind of a contact's event (`docs/physics.md#contact-events`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EventKind {
    /// Closing in stick.
    OpenToStick,
    /// Closing in slip.
    OpenToSlip,
    /// Breakaway.
    StickToSlip,
    /// Stop of sliding.
    SlipToStick,
    /// Opening: the gap becomes positive.
    Opened,
    /// The projection leaves the polygon, or the node comes out behind the body.
    LeftFace,
    /// An edge node has moved along its edge to the present crossing; the contact goes on.
    Moved,
    /// The node crosses the plane of the face outside the polygon; no contact.
    Missed,
    /// Hit by an impulse (impact model).
    Hit,
}

impl EventKind {
    /// Of a contact that closes in this mode.
    pub fn of_closing(mode: &Mode) -> Self {
        match mode {
            Mode::Stick { .. } => Self::OpenToStick,
            Mode::Slip { .. } => Self::OpenToSlip,
        }
    }

    /// Name in tables.
    pub fn label(self) -> &'static str {
        match self {
            Self::OpenToStick => "open->stick",
            Self::OpenToSlip => "open->slip",
            Self::StickToSlip => "stick->slip",
            Self::SlipToStick => "slip->stick",
            Self::Opened => "->open",
            Self::LeftFace => "->left-face",
            Self::Moved => "moved",
            Self::Missed => "miss",
            Self::Hit => "hit",
        }
    }

    /// Whether a touch begins with this event.
    pub fn is_touch(self) -> bool {
        matches!(self, Self::OpenToStick | Self::OpenToSlip | Self::Hit)
    }

    /// Whether a touch ends with this event.
    pub fn is_parting(self) -> bool {
        matches!(self, Self::Opened | Self::LeftFace | Self::Hit)
    }
}

/// One event of one contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Time \[s\].
    pub t: f64,
    /// Number of the contact's site in the model, in 4 bytes: a row of girders has millions of events.
    site: u32,
    /// Kind.
    pub kind: EventKind,
    /// Energy released by a jump of the anchor (`docs/physics.md#energy-ledger`), or lost in a hit \[J\].
    pub released: f64,
}

impl Event {
    pub(crate) fn new(t: f64, site: usize, kind: EventKind, released: f64) -> Self {
        // Memory ends before a u32 overflows: four billion sites.
        Self { t, site: u32::try_from(site).unwrap_or(u32::MAX), kind, released }
    }

    /// Number of the contact's site in [`Model::sites`](crate::dynamics::Model::sites).
    pub fn site(&self) -> usize {
        self.site as usize
    }
}

/// Cause of an early end of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Cause {
    /// The computation: a step or a count of changes came to its bound.
    Computation,
    /// A vertical support is lost or a corner has dropped: the equations of the model end there (`docs/physics.md#loss-of-support`).
    SupportLost,
    /// Bodies meet where the model has no contact.
    NoContact,
}

impl Cause {
    /// Clause of the stop's text: "the run gave up at t = …".
    pub fn verb(self) -> Text {
        match self {
            Self::Computation => Text::new("stop-gave-up"),
            Self::SupportLost | Self::NoContact => Text::new("stop-ended"),
        }
    }
}

/// Why a run stopped before its end.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Stop {
    /// Computation or model.
    pub cause: Cause,
    /// Time \[s\].
    pub t: f64,
    /// Pair or bodies concerned.
    pub place: String,
    /// Cause, and a change of the scene that would avoid it.
    pub reason: Message,
}
