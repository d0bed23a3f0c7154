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
/// Largest ratio of a contact's penetration to the least overlap of its bodies, or of that to it, at which the contact counts as
/// carrying the overlap \[–\]. Chosen: the penetrations at the nodes of two flush ends differ by the angle between the faces alone.
pub(super) const DEPTH_RATIO: f64 = 2.0;
/// Difference of the cosines of two angles that counts as rounding \[–\]: of products of unit vectors that have been turned a few times,
/// each to 1e-15 or so.
pub(super) const COSINE_ROUNDING: f64 = 1e-12;
/// Largest sine of the angle between two faces of bodies that have met that count as flush \[–\]: 10°. Chosen: the force at a vertex turns
/// by at most this angle where one node replaces another.
pub(super) const FLUSH_SINE: f64 = 0.174;
