//! Tolerance factors of the contact model: unit, effect, and derivation or the word "tuned".

// Round-off

/// Round-off of a node's coordinates on a face, per distance that both bodies have moved \[–\]: no stretch is known
/// better. Tuned.
pub(in crate::dynamics) const POSITION_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Penetration below which an entering node is taken to be at the face, per distance that both bodies have moved
/// \[–\]. Tuned: 45 units of round-off, three times [`POSITION_ROUNDING`]; within it the signs of gap, stretch and
/// force are round-off.
pub(in crate::dynamics) const ENTRY_ROUNDING: f64 = 1e-14;
/// Round-off of the time of entry, per time \[–\]: times speed it is a penetration.
pub(in crate::dynamics) const CLOCK_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Difference of gaps and sum of levers of a flush face that count as 0, per lever \[–\]: round-off of their sums.
/// Tuned.
pub(in crate::dynamics) const LEVEL_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Round-off of position and velocity over an explicit step, which spans less than a radian, per distance moved
/// \[–\]: a gap is a sum of three terms. A larger value would exceed errors of the method, which add up over a thousand
/// elastic touches. Tuned.
pub(in crate::dynamics) const EXPLICIT_ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Round-off of position and velocity over an implicit step, which spans many radians, per distance moved \[–\]: the
/// force of every stage carries the round-off of its positions, which a shorter step does not reduce. Tuned.
pub(in crate::dynamics) const IMPLICIT_ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Least distance moved, per size of body or face, that round-off is proportional to \[–\]. Tuned.
pub(in crate::dynamics) const SIZE_ROUNDING_SHARE: f64 = 1e-3;
/// Lower bound of the error scale, per round-off of the contact point's position \[–\]. Prevents resolving undamped
/// oscillations below round-off. Tuned.
pub(in crate::dynamics) const ROUNDING_FLOOR: f64 = 0.1;
/// Lower bound of the error scale where a slip direction turns, per round-off of the contact point's position \[–\]:
/// steps are implicit and need not resolve such an oscillation. Tuned: at 0.1 contacts of grams on 1e12 N/m exceed
/// their tolerance.
pub(in crate::dynamics) const ROUNDING_FLOOR_TURNING: f64 = 0.01;

// Error scale

/// Steps with contact N₀ of a body after which the tolerance of step n falls as N₀/n \[–\]. A step loses a part ε of
/// the tolerance, always of one sign: N steps lose ε N at a constant tolerance, ε N₀ (1 + ln(N/N₀)) so. The explicit
/// method's ε of an oscillation is 1 − |R(iθ)| over the tolerance, with R its stability function and θ the phase in
/// which its estimate comes to the safety factor's 0.43 tolerances: 0.07, 0.013 and 0.002 at tolerances of 1e-4, 1e-7
/// and 1e-10. N₀ is tuned: ε N₀ is about ten tolerances at 1e-7.
pub(in crate::dynamics) const LONG_RUN_CONTACT: f64 = 1000.0;
/// [`LONG_RUN_CONTACT`] of steps without contact \[–\]. Measured: a rotating girder loses ε = 1/12 in each. Tuned: ε N₀ is twenty
/// tolerances.
pub(in crate::dynamics) const LONG_RUN_FREE: f64 = 250.0;
/// Least speed that errors are relative to at a point of reversal, per speed gained by its acceleration in one radian
/// \[–\]. Tuned.
pub(in crate::dynamics) const REVERSAL_SPEED: f64 = 0.1;
/// Least speed that errors are relative to, per speed gained in one radian from ground motion, weight and push \[–\].
/// Tuned.
pub(in crate::dynamics) const REST_SPEED: f64 = 1e-3;
/// Least square of an island's circular frequency \[rad²/s²\]: that of a body without contact and bearings, for which
/// steps and error scales need a frequency above 0. Tuned.
pub(in crate::dynamics) const LEAST_SQUARED_FREQUENCY: f64 = 1e-6;
/// Acceleration that stands for no load at all \[m/s²\]: keeps the error scale of a body at rest above 0. Tuned.
pub(in crate::dynamics) const LEAST_ACCELERATION: f64 = 1e-9;
/// Least tolerance of a step without contact \[–\], where no stiff spring is between position and force; with contact it is the scene's
/// finest. Measured: a million steps of a tumbling girder change its energy by 1e-10 at 1e-13, and by a tenth of that at 1e-14.
pub(in crate::dynamics) const FINEST_TOLERANCE_FREE: f64 = 1e-14;

// Step length

/// Shortest step, in radians of the fastest motion \[rad\]; a shorter one ends the run. A hard impact takes sliding
/// through its stop, within the regularisation speed, in less than 1e-9 rad.
pub(in crate::dynamics) const SMALLEST_PHASE: f64 = 1e-12;
/// Phase of the fastest motion that the first step of a touch spans at a tolerance of 1e-10 \[rad\]; it varies with
/// the 8th root of the tolerance, the order of the method. The estimate of an oscillation comes to 1e-10 at 0.35 rad
/// of its true frequency; tuned by the bound on it, which is larger.
pub(in crate::dynamics) const FIRST_PHASE: f64 = 0.48;
/// Longest implicit step with contact, in radians θ of the ground motion \[rad\]. A stiff contact follows the ground
/// quasi-statically. The error estimate of the step does not see that motion: its filter divides by the phase of the
/// contact, and the stage values lie on the motion. Between them the collocation polynomial of s stages errs by
/// `θ^(s+1)/(s+1)! max |x ∏(x − c_i)|` of it, for five stages 1.6e-6 at 1 rad and 1e-4, the coarsest tolerance of the
/// domain, at 2 rad.
pub(in crate::dynamics) const GROUND_PHASE_CONTACT: f64 = 1.0;
/// Longest step without contact, in radians of the ground motion \[rad\]. A slow body has no motion of its own that holds its
/// steps below a period of the ground, and an estimate from stages that span several periods says nothing of them.
/// Measured: a residual of 5.0e-3 of the energy at a tolerance of 4.5e-5 without it (ground 79 Hz, bearings 0.04 Hz, seed
/// 15199 of the stability study), 2.1e-4 with it. Tuned: up to four radians the estimate exceeds the error twelve times.
pub(in crate::dynamics) const GROUND_PHASE_FREE: f64 = 2.0;
/// An event nearer to either end of a step than this part of it starts from the dense output \[–\]; otherwise the
/// explicit step is retaken to end at the event. Tuned.
pub(in crate::dynamics) const RETAKE_MARGIN: f64 = 0.03;
/// Estimate of the error of an explicit step, in units of the tolerance, up to which the inside of the step is as exact as the tolerance
/// asks for \[–\]. Where a component follows a slow motion the inside errs by 2.6 of the estimate over three time constants, the most of a
/// device's memory, and by 65 over the five of a decay (`dynamics::integrator::dop853`, test of a follower): 0.07 of the tolerance.
pub(in crate::dynamics) const RETAKE_ERROR: f64 = 1e-3;
/// Distance beyond the event, per length, at which a retaken step ends \[–\]. Tuned: past the error of the event's
/// time.
pub(in crate::dynamics) const RETAKE_OVERSHOOT: f64 = 1e-3;

// Event location

/// Samples of a switching function in an explicit step. The step is short against all motions in it, so that five
/// samples show every sign change except short excursions, and the second difference of three samples shows those.
pub(in crate::dynamics) const SAMPLES_EXPLICIT: usize = 5;
/// Samples in an implicit step whose phase is between the two [`SHORT_PHASES`]: half the interval of
/// [`SAMPLES_EXPLICIT`].
pub(in crate::dynamics) const SAMPLES_MEDIUM: usize = 2 * SAMPLES_EXPLICIT - 1;
/// Samples in an implicit step, which may span several oscillations of a contact.
pub(in crate::dynamics) const SAMPLES_IMPLICIT: usize = 17;
/// Phases of implicit steps that are sampled like explicit ones, and twice as densely \[rad\]. Tuned: the longest
/// phase of an explicit step, and two of them.
pub(in crate::dynamics) const SHORT_PHASES: [f64; 2] = [2.5, 5.0];
/// At the start of a step, values below this part of a switching function's scale are the zero that the last event
/// left \[–\]. Tuned.
pub(in crate::dynamics) const ZERO_BAND: f64 = 1e-10;
/// Dead band of the opening of a node that moves out, per round-off of its entry \[–\]: bounds the delay of the
/// opening. Tuned.
pub(in crate::dynamics) const PARTING_BAND: f64 = 0.1;
/// Phase of a step from which on round-off of speeds is that of positions over the step's length \[rad\]. Tuned.
pub(in crate::dynamics) const SPEED_ROUNDING_PHASE: f64 = 16.0;
/// Retries of a stop at one instant before its dead band widens. Tuned.
pub(in crate::dynamics) const FREE_RETRIES: u32 = 4;
/// Most doublings of that dead band: 2³⁶ [`ZERO_BAND`] exceeds the scale itself.
pub(in crate::dynamics) const RETRY_DOUBLINGS: u32 = 36;

/// Overlap of two bodies beyond the deepest contact between them at which another contact takes over, in parts of the smallest side
/// of either body: half of that which a run reports as carried by no contact, and far above the round-off of places.
pub(crate) const UNCARRIED: f64 = 5e-7;

// Simultaneous events

/// Interval within which equal events of contacts change state together, in radians of the fastest motion \[rad\]
/// (`docs/physics.md#simultaneous-events`). Tuned: far above the rounding of an event's time, far below a period.
pub(in crate::dynamics) const SIMULTANEOUS_PHASE: f64 = 1e-9;
/// Radian per simultaneity interval \[1/rad\], the reciprocal of [`SIMULTANEOUS_PHASE`].
pub(in crate::dynamics) const SIMULTANEOUS_PER_RADIAN: f64 = 1e9;

// Forecast and differences

/// Time over which switching functions are differenced for the forecast, in radians of the fastest motion \[rad\].
/// Tuned.
pub(in crate::dynamics) const SLOPE_PHASE: f64 = 1e-4;
/// Longest forecast, in radians of the fastest motion \[rad\]. Tuned.
pub(in crate::dynamics) const FORECAST_PHASE: f64 = 0.4;
/// A forecast event is confirmed where the switching function is above this part of its value at the start (both are
/// negative) at the forecast time \[–\]. Tuned.
pub(in crate::dynamics) const CONFIRMED_RISE: f64 = 0.5;
/// Change of a slip angle over which its force is differenced \[rad\]: one-sided, with a truncation of 5e-7 and a
/// round-off of 2e-10.
pub(in crate::dynamics) const ANGLE_DIFFERENCE: f64 = 1e-6;

// Cost of steps

/// Operations of a slope, per component \[–\]: the estimate by which implicit steps are weighed against explicit ones. Tuned.
pub(super) const SLOPE_OPERATIONS: f64 = 30.0;
