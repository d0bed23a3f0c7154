//! Tolerance factors and bounds on work of the contact model's events: unit, effect, and derivation or the word
//! "tuned".

// Regularisation of a slip direction that turns

/// Regularisation length `ℓ` of a slip direction that turns, per stretch of the deepest penetration that the entry
/// leads to \[–\] (`docs/physics.md#law-return-mapping`). The result depends on it linearly. Tuned.
pub(super) const REGULARISATION_LENGTH: f64 = 1e-3;
/// Coefficient of kinetic friction below which the regularisation length falls no further \[–\]. Tuned.
pub(super) const REGULARISATION_FRICTION: f64 = 0.05;

// Alternation of stick and slip

/// Changes of one contact at one instant above which stick and slip count as alternating: the length of the next step
/// then follows from the frequency of the island, not from the last step. Tuned.
pub(super) const ALTERNATING_EVENTS: usize = 2;

// Bounds that end a run

/// Changes of one contact at one instant; more end the run. Tuned: far above what a physical sequence of events needs.
pub(super) const CONTACT_EVENTS_PER_INSTANT: usize = 64;
/// Changes of phase of one device at one instant; more end the run. Tuned, equal to [`CONTACT_EVENTS_PER_INSTANT`].
pub(super) const DEVICE_EVENTS_PER_INSTANT: usize = 64;
/// Changes of one contact during one touch; more end the run. Tuned.
pub(super) const CONTACT_EVENTS_PER_TOUCH: usize = 1_000_000;
/// Planned steps, closings and searches per body; more end the run. Tuned: ten times the million steps of an hour of
/// a stiff contact, within the memory of a desktop computer.
pub(super) const WORK_BOUND_PER_BODY: usize = 10_000_000;
