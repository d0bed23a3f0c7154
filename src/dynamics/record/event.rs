//! What happens to contacts, and what can end a run early.

/// What happened to a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EventKind {
    /// Touched, and the anchor holds.
    OpenToStick,
    /// Touched, and slides at once.
    OpenToSlip,
    /// Broke away.
    StickToSlip,
    /// Came to hold.
    SlipToStick,
    /// Parted from the face.
    Opened,
    /// Left over the edge of the face.
    LeftFace,
    /// Went behind the plane of the face beside the polygon; no contact.
    Missed,
    /// Was hit by an impulse (impact model).
    Hit,
}

impl EventKind {
    /// The word used in tables.
    pub fn label(self) -> &'static str {
        match self {
            Self::OpenToStick => "open->stick",
            Self::OpenToSlip => "open->slip",
            Self::StickToSlip => "stick->slip",
            Self::SlipToStick => "slip->stick",
            Self::Opened => "->open",
            Self::LeftFace => "->left-face",
            Self::Missed => "miss",
            Self::Hit => "hit",
        }
    }

    /// Whether a touch begins here.
    pub fn is_touch(self) -> bool {
        matches!(self, Self::OpenToStick | Self::OpenToSlip | Self::Hit)
    }

    /// Whether a touch ends here.
    pub fn is_parting(self) -> bool {
        matches!(self, Self::Opened | Self::LeftFace | Self::Hit)
    }
}

/// One event of one contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// When \[s\].
    pub t: f64,
    /// The contact: half a `usize`, because a row of girders has millions of events.
    contact: u32,
    /// What.
    pub kind: EventKind,
    /// Energy that a jump of the anchor released (`docs/physics.md#energy-ledger`), or that a hit lost \[J\].
    pub released: f64,
}

impl Event {
    pub(crate) fn new(t: f64, contact: usize, kind: EventKind, released: f64) -> Self {
        // More contacts than a u32 counts would not fit into memory.
        Self { t, contact: u32::try_from(contact).unwrap_or(u32::MAX), kind, released }
    }

    /// Number of the contact in the model, which knows its pair.
    pub fn contact(&self) -> usize {
        self.contact as usize
    }
}

/// Why a run stopped before its end.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Stop {
    /// When \[s\].
    pub t: f64,
    /// Where: the pair or body.
    pub place: String,
    /// What was met, and what would help.
    pub reason: String,
}
