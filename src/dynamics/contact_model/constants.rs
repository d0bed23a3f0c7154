//! Tolerance factors and bounds on work of the contact model's events: unit, effect, and derivation or the word
//! "tuned".

// Regularisation of a slip direction that turns

/// Coefficient of kinetic friction below which the regularisation length `ℓ` of a slip direction that turns falls no
/// further \[–\] (`docs/physics.md#law-return-mapping`): `ℓ` is in proportion to the force that it displaces, per normal
/// force. Tuned.
pub(super) const REGULARISATION_FRICTION: f64 = 0.05;
/// Least regularisation length, per stretch of the deepest penetration \[–\]; above it the length is in proportion to the
/// tolerance. Below, steps at the end of a touch fall to the shortest that the solver takes. Measured: at 1e-11 seed 3329 of the
/// stability study ends so at a tolerance of 1e-13, at 1e-10 it does not.
pub(super) const REGULARISATION_LEAST: f64 = 1e-10;
/// Round-off of the time of an event within which a slip direction does not turn, per time \[–\]: a direction turns within
/// `ℓ/|V_t|`, which must span many units of the last digit of time. Tuned: at 16 ε a run does not end (5.6e5 rad/s at 0.75 s,
/// seed 244 of the stability study), at 64 ε it does.
pub(super) const REGULARISATION_CLOCK: f64 = 256.0 * f64::EPSILON;

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
/// Handled events, and what searches add that ended at their bound of advances, per body; more end the run. Tuned: ten times the
/// million steps of an hour of a stiff contact, within the memory of a desktop computer.
pub(super) const WORK_BOUND_PER_BODY: usize = 10_000_000;
/// Work between two looks at the bounds; the look itself costs a few sums.
pub(super) const WORK_BETWEEN_LOOKS: usize = 4096;
/// Divisor of a run's memory: a group of bodies may take at least 1/8 of it, as most groups of a large scene take little \[–\]. Tuned.
pub(super) const MEMORY_SHARE_OF_GROUP: usize = 8;
/// Divisor of the bound on the work: the pace of a run is measured over stretches of 1/100 of that bound \[–\]. Tuned: a second of
/// computing.
pub(super) const PACE_SHARE: usize = 100;
/// A pace that would lead to so many times the bound on the work ends the run. Tuned: inside the domain a contact turns by 1e7
/// rad in a run, and no run comes near ten times the bound; dense stretches are short.
pub(super) const WORK_OVERRUN: f64 = 1000.0;
/// Part of the bound on the work that a pace may lead to where nothing touches in the whole of a measured stretch. Without contact the
/// frequencies of bearings, ground and spin and the samples of a record set the pace, and no stretch is denser than others: 1e5 rad,
/// the most inside the domain, take 1e5 steps, an hour of a record at 200 Hz between two walls 2.2e6 steps and searches.
pub(super) const STEADY: f64 = 0.25;
