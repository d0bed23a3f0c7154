//! Every tolerance and count of the impact model: unit, effect, and where the number comes from.
//!
//! *Tuned* means that no derivation is known; where a number was checked, the check is given.

// Round-off of velocities, accelerations and places.

/// Speeds at a contact that differ by less than this part of the fastest in play are equal. A sum over two bodies of a few
/// products of three terms rounds by some 10 ε = 2e-15; the rest is room for the solves of [`SINGULAR_PIVOT`]. Tuned.
pub(super) const IMPACT_SPEED_ROUNDING: f64 = 1e-12;
/// Likewise, in parts of the largest speed since the start of the run: velocities of a flight come from places that round by
/// ε of their size; 45 ε. Tuned.
pub(super) const RUN_SPEED_ROUNDING: f64 = 1e-14;
/// Accelerations and forces that differ by less than this part of the sum of their terms are equal. Larger than
/// [`IMPACT_SPEED_ROUNDING`] because reactions come from a solve over several contacts, which magnifies round-off. Tuned: every
/// row of Tables 4–7 is met by states on the border between two rows (`tests/core/impact/tables.rs`).
pub(super) const IMPACT_FORCE_ROUNDING: f64 = 1e-10;
/// Normal speed that a kept point may gather from the error of the integrator, in parts of the largest speed of the run: a step errs by
/// the scene's tolerance, and below this number the errors of many steps add up to more than that of one. Tuned.
pub(super) const LEAST_NORMAL_DRIFT: f64 = 1e-8;
/// Normal speed of a point that is not kept and still counts as at rest, in units of the speed round-off. An impulse sums two
/// terms for each of two sides: 4 roundings.
pub(super) const REST_ROUNDINGS: f64 = 4.0;
/// Speed below which a body that rests on a wall is set to rest exactly, in units of the speed round-off. Tuned: it
/// is above what the projection of redundant contacts leaves and far below the stop speed.
pub(super) const REST_SNAP_ROUNDINGS: f64 = 1e3;
/// Penetration that is the round-off of the gap and no penetration, in parts of the girder's size. A gap is a sum of three
/// rotated vectors, some 20 ε, and 64 ε covers it; to project round-off out would turn a girder that is hit square.
pub(super) const PLACE_ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Rotation \[rad\] and relative coupling of bearings below which a girder counts as not turning: the state is a or b by it,
/// no motion depends on it. 4500 ε. Tuned.
pub(super) const ROTATION_ROUNDING: f64 = 1e-12;

// Touching.

/// Distance within which a point touches its face and a face is flush, in parts of the smaller girder's radius. It covers the
/// difference of the two corners of a face that arrives parallel after steps of an integrator at a fine tolerance, and its
/// effect on levers is of the same relative size. Tuned.
pub(super) const TOUCH: f64 = 1e-9;
/// Factor on [`TOUCH`] for a point in lasting contact: the integrator lets it drift by its tolerance, not by
/// round-off. Tuned.
pub(super) const KEPT_TOUCH: f64 = 1e3;
/// Depth at which a point that lifted off without speed is taken as hitting again, in parts of the smaller girder's radius: a thousandth of
/// [`TOUCH`]. Falling through it at 10 m/s² a girder of 30 m reaches 1.7e-5 m/s, below the speed at which it comes to rest.
pub(super) const LIFTED_DEPTH: f64 = 1e-12;
/// Round-off of a gap, in parts of the lengths whose difference it is; that depth is not less.
pub(super) const GAP_ROUNDING: f64 = 20.0 * f64::EPSILON;

// Impulses.

/// Bisections of a restitution that would add energy: the bits of a number in \[0, 1\].
pub(super) const RESTITUTION_BISECTIONS: u32 = 52;
/// Work of a flush impulse that is round-off, in parts of impulse times speed round-off. Tuned: 40,000 random hits
/// with μ up to 3 add no energy beyond 1e-12 of the kinetic energy (`tests/core/impact/rules.rs`).
pub(super) const WORK_ROUNDING: f64 = 1e-2;
/// Relative excess of a friction impulse over the cone that is round-off: that of the solve, as [`IMPACT_SPEED_ROUNDING`].
pub(super) const CONE_ROUNDING: f64 = 1e-12;
/// Hits at one instant beyond which there is no restitution. A girder that bounces between two walls keeps `e_n^k` of its speed after k
/// hits, 3e-26 of it after 64 at `e_n` = 0.4 and 1e-3 at 0.9.
pub(super) const HITS_WITH_RESTITUTION: usize = 64;
/// Hits at one instant beyond which all points that still approach are stopped by one set of impulses. Tuned: four times
/// [`HITS_WITH_RESTITUTION`].
pub(super) const SEQUENTIAL_HITS: usize = 256;
/// Changes of the active set of a simultaneous impact before it is given up. The program of Lawson and Hanson allows three
/// changes for each row; 500 are as many for 166 points at one instant.
pub(super) const ACTIVE_SET_CHANGES: usize = 500;
/// Approach speed left by a simultaneous impact, in parts of the largest before: the residual of a solve, 450 ε.
pub(super) const ACTIVE_SET_RESIDUAL: f64 = 1e-13;
/// Least pivot of a system with a unique solution, in parts of its largest entry \[–\]: the round-off of an elimination of some thousand
/// terms. Redundant points of a system with a lesser one share the load equally
/// ([`solve_regularised`](crate::dynamics::integrator::dense_lu::solve_regularised)).
pub(super) const SINGULAR_PIVOT: f64 = 1e-12;
/// Residual of accelerations, in parts of the free ones in the mass metric, up to which reactions within the friction cones balance \[–\]:
/// five times the round-off of a singular system, 2e-9.
pub(super) const CONE_RESIDUAL: f64 = 1e-8;
/// Halvings of an interval that bracket the time from which on a mode is consistent again: to 1e-12 of the interval.
pub(super) const CONSISTENCY_HALVINGS: usize = 40;

// Contact modes.

/// Combinations of contact modes that are tried one by one. A flush pair at rest has ten options, so three such pairs are
/// enumerated and more are relaxed pair by pair.
pub(super) const MODE_COMBINATIONS: usize = 4096;
/// Combinations that are tried one by one where relaxation finds none: a combination costs some 4 µs, all of them half a second. Tuned.
pub(super) const MODE_COMBINATIONS_LEFT: usize = 1 << 17;
/// Sweeps over the pairs when modes are relaxed pair by pair. Tuned.
pub(super) const MODE_SWEEPS: usize = 64;

// Integration of lasting contact.

/// Distance beyond the border of its face at which a point leaves it, in parts of the body's radius \[–\]: the places of two ends that lie flush
/// edge on edge round by some ε of their size, a thousandth of this.
pub(super) const BORDER: f64 = 1e-12;
/// Intervals between samples of each switching function per step. A step spans a quarter of the ground's period at most, so
/// that two samples are at most 5.6° of it apart; excursions between samples are found by
/// [`first_rise`](crate::dynamics::locate::first_rise).
pub(super) const SWITCHING_SAMPLES: usize = 16;
/// First step of an integration, in parts of the longest allowed; error control corrects it. Tuned.
pub(super) const FIRST_STEP: f64 = 1e-3;
/// A step that reaches this part of the longest is stretched to it: the remainder would cost a step. Tuned.
pub(super) const STRETCHED_STEP: f64 = 0.999;
/// Rejected steps in a row before the run stops. 60 halvings take a step of 1 s to 1e-18 s, below
/// the round-off of time.
pub(super) const REJECTED_STEPS: usize = 60;
/// Factor on a step whose slope has no finite value. Tuned.
pub(super) const NOT_FINITE_FACTOR: f64 = 0.1;
/// Largest factor on a rejected step: every rejection halves it at least.
pub(super) const REJECTED_FACTOR: f64 = 0.5;
/// Place and speed that the error norm of lasting contact starts from, in parts of the girder's size (per second): a run that
/// has not moved yet has no scale of its own. Tuned.
pub(super) const LEAST_SCALE: f64 = 1e-6;

// Search for the next impact.

/// Periods of a sine that one search covers. Girders in step with the ground hit once a period, so a search of two
/// mostly finds a hit. Tuned.
pub(super) const SEARCHED_PERIODS: f64 = 2.0;
/// Evaluations that share one set of motion bounds. The energies that bound a motion never grow, so older bounds stay valid;
/// they only shorten an advancement. Tuned.
pub(super) const SHARED_BOUNDS: u32 = 4;

// Progress of a run.

/// Events at one instant after which a run stops, besides four for each pair and two for each body that may all act in it.
pub(super) const EVENTS_AT_ONE_INSTANT: usize = 200;
/// Events at one instant after which a lasting contact is kept for [`LEAST_DURATION`]: reactions at round-off level may change
/// sign without end. Tuned: a quarter of [`EVENTS_AT_ONE_INSTANT`].
pub(super) const EVENTS_BEFORE_LEAST_DURATION: usize = 50;
/// Least duration of such a contact, in parts of the run. Tuned.
pub(super) const LEAST_DURATION: f64 = 1e-3;
