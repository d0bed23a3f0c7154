//! Bounds that end a run under either model: unit, effect, and derivation or the word "tuned".

/// Handled events, and what [long searches](LONG_SEARCH) add, per body; more end the run. Tuned: ten times the
/// million steps of an hour of a stiff contact, within the memory of a desktop computer.
pub(super) const WORK_BOUND_PER_BODY: usize = 10_000_000;
/// Evaluations above which a search adds to the work of a run; inside the domain none takes as many (`tests/core/cost`). Tuned.
pub(super) const LONG_SEARCH: u64 = 1_000;
/// Evaluations of a long search that count as one handled event: a run stops after 2e8 of them a body. Tuned: 20 take about as long as an
/// event.
pub(super) const EVALUATIONS_PER_EVENT: u64 = 20;
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
