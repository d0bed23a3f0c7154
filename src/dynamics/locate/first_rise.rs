//! The first rise of a sampled function through zero: event location on dense output.
//!
//! The function is given at a few instants of a step and can be evaluated in between. A rise is bracketed by a change of sign
//! between neighbouring samples, by a dip below zero after a start at zero, or by a parabola through three negative samples
//! that comes near zero between them; the bracket is then closed by [`root_within_noise`].

use crate::dynamics::locate::constants::{DIP_HALVINGS, EXCURSION_MARGIN, EXCURSION_REDUCTIONS, RISE_LOOKS};
use crate::dynamics::locate::root::{root, root_within_noise};

/// Thresholds of a switching function for a zero at its start and for a rise, in the function's unit.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Resolution {
    /// Value up to which the start is at 0.
    pub zero: f64,
    /// Value above which a function that starts at 0 and is below 0 at the next sample rises in between: what the step errs by. A smaller
    /// rise is one of the dense output alone, and the phase that begins with it would end at once.
    pub rise: f64,
    /// Round-off of the function: a rise is located as far as the function is known.
    pub noise: f64,
}

impl Resolution {
    /// Of a function whose rise from 0 within a sample is no event of its own.
    pub(in crate::dynamics) fn at_start(zero: f64) -> Self {
        Self { zero, rise: f64::INFINITY, noise: 0.0 }
    }
}

/// First time at which a sampled function rises through 0. A start above 0 is a rise at the first sample; a function
/// that is `passing` must fall below 0 first, and its start is none.
pub(in crate::dynamics) fn first_rise(
    [times, values]: [&[f64]; 2],
    Resolution { zero, rise, noise }: Resolution,
    passing: bool,
    first: EarliestEvent,
    mut function: impl FnMut(f64) -> f64,
) -> Option<f64> {
    if values[0] > zero && !passing {
        return Some(times[0]);
    }
    let mut below = values[0] < 0.0;
    if !passing && values[0].abs() <= zero && rises_at_once(times, values, zero.max(rise), &mut function) {
        return Some(times[0]);
    }
    for i in 1..values.len() {
        if values[i] > 0.0 && (below || !passing) {
            let left =
                if values[i - 1] < 0.0 { Some(times[i - 1]) } else { dip(times[i - 1], times[i], &mut function) };
            return match left {
                Some(left) => {
                    let start = if left == times[i - 1] { values[i - 1] } else { function(left) };
                    Some(first.rise([left, times[i]], [start, values[i]], noise, &mut function))
                }
                // Never below 0 in between: the function is at 0 up to this sample.
                None if below => Some(times[i]),
                None => Some(times[i - 1]),
            };
        }
        below = below || values[i] < 0.0;
        if i >= 2
            && let Some(peak) = excursion(&times[i - 2..=i], &values[i - 2..=i], &mut function)
        {
            return Some(root(&mut function, times[i - 2], peak));
        }
    }
    None
}

/// The earliest rise among several functions, and which of them rises.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct EarliestRise<T> {
    found: Option<(f64, T)>,
}

impl<T> EarliestRise<T> {
    /// No rise yet.
    pub(in crate::dynamics) fn none() -> Self {
        Self { found: None }
    }

    /// The rise found so far, which a later one need not be located against.
    pub(in crate::dynamics) fn known(&self) -> EarliestEvent {
        self.found.as_ref().map_or(EarliestEvent::UNKNOWN, |(at, _)| EarliestEvent { at: *at, together: 0.0 })
    }

    /// Keeps the rise of a function at `t` \[s\] where it is earlier; of two at one time the first that was offered.
    pub(in crate::dynamics) fn offer(&mut self, t: Option<f64>, function: T) {
        if let Some(t) = t
            && self.found.as_ref().is_none_or(|(first, _)| t < *first)
        {
            self.found = Some((t, function));
        }
    }

    /// The earliest; `None` where no function rises.
    pub(in crate::dynamics) fn found(self) -> Option<(f64, T)> {
        self.found
    }
}

/// The earliest event known so far.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct EarliestEvent {
    /// Time \[s\].
    pub at: f64,
    /// Events at most this much later are simultaneous with it \[s\].
    pub together: f64,
}

impl EarliestEvent {
    pub(in crate::dynamics) const UNKNOWN: Self = Self { at: f64::INFINITY, together: 0.0 };

    /// Zero of a function that rises through 0 between `left` and `right`: the root where it is before the earliest event; else only
    /// whether both are simultaneous, by two evaluations, since contacts of a flush face change at one instant.
    fn rise(
        self,
        [left, right]: [f64; 2],
        [start, end]: [f64; 2],
        noise: f64,
        function: &mut impl FnMut(f64) -> f64,
    ) -> f64 {
        let (at, with) = (self.at, self.at + self.together);
        let below = |t: f64, function: &mut dyn FnMut(f64) -> f64| t <= left || (t < right && function(t) <= 0.0);
        if !at.is_finite() {
            root_within_noise(function, [left, right], [start, end], noise)
        } else if below(with, function) {
            right.max(with.next_up())
        } else if below(at, function) {
            at
        } else if at < right {
            let value = function(at);
            root_within_noise(function, [left, at], [start, value], noise)
        } else {
            root_within_noise(function, [left, right], [start, end], noise)
        }
    }
}

/// Whether a function that starts at 0 and is below 0 at the next sample is above `rise` in between: the event that the step begins with
/// is one of this function, too, and its rate changes its sign within the interval.
fn rises_at_once(times: &[f64], values: &[f64], rise: f64, function: &mut impl FnMut(f64) -> f64) -> bool {
    if values.len() < 2 || values[1] >= 0.0 {
        return false;
    }
    let interval = times[1] - times[0];
    RISE_LOOKS.iter().any(|part| function(times[0] + part * interval) > rise)
}

/// A time after `from` at which the function is below 0, where it starts at 0; none within [`DIP_HALVINGS`].
fn dip(from: f64, to: f64, function: &mut impl FnMut(f64) -> f64) -> Option<f64> {
    let mut step = (to - from) / 2.0;
    for _ in 0..DIP_HALVINGS {
        if function(from + step) < 0.0 {
            return Some(from + step);
        }
        step /= 2.0;
    }
    None
}

/// A time at which the function is above 0 between three negative samples; none where it stays below.
fn excursion(times: &[f64], values: &[f64], function: &mut impl FnMut(f64) -> f64) -> Option<f64> {
    let (a, b, c) = (values[0], values[1], values[2]);
    let bend = a - 2.0 * b + c;
    if !(a < 0.0 && b < 0.0 && c < 0.0 && bend < 0.0) {
        return None;
    }
    let vertex = (a - c) / (2.0 * bend);
    if vertex.abs() > 1.0 {
        return None;
    }
    let top = b - (a - c) * vertex / 4.0;
    if top < EXCURSION_MARGIN * bend {
        return None;
    }
    let (mut left, mut right, mut start, mut end) = (times[0], times[2], a, c);
    for _ in 0..EXCURSION_REDUCTIONS {
        let (u, v) = (left + (right - left) / 3.0, right - (right - left) / 3.0);
        let (fu, fv) = (function(u), function(v));
        if fu > 0.0 || fv > 0.0 {
            return Some(if fu > 0.0 { u } else { v });
        }
        // Between samples a parabola rises by an eighth of its second difference; eight times as much does not reach 0.
        let bend = (start - 2.0 * fu + fv).abs().max((fu - 2.0 * fv + end).abs());
        if start.max(fu).max(fv).max(end) + bend < 0.0 {
            return None;
        }
        if fu < fv { (left, start) = (u, fu) } else { (right, end) = (v, fv) }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first rise of `f` by its values at these times, none at once.
    fn rise(times: &[f64], passing: bool, f: impl Fn(f64) -> f64) -> Option<f64> {
        let values: Vec<f64> = times.iter().map(|t| f(*t)).collect();
        first_rise([times, &values], RESOLUTION, passing, EarliestEvent::UNKNOWN, f)
    }

    const RESOLUTION: Resolution = Resolution { zero: 1e-12, rise: 1e-9, noise: 0.0 };

    const TIMES: [f64; 3] = [0.0, 1.0, 2.0];

    #[test]
    fn a_start_at_zero_from_which_a_function_rises_and_falls_within_a_sample_is_due_at_once() {
        assert_eq!(rise(&TIMES, false, |t| t * (0.01 - t)), Some(0.0), "for a hundredth of the interval");
        assert_eq!(rise(&TIMES, false, |t| -t), None, "it falls");
        assert_eq!(rise(&TIMES, false, |t| -t * t), None, "with its rate 0 as well");
        assert_eq!(rise(&TIMES, false, |t| t * (1e-13 - t)), None, "rounding");
        assert_eq!(rise(&TIMES, false, |t| t * (0.03 - t) * 1e-6), None, "2e-10, which the step does not resolve");
    }

    #[test]
    fn a_start_above_zero_is_due_at_once_unless_passing() {
        assert_eq!(rise(&TIMES, false, |_| 1.0), Some(0.0), "at once");
        assert_eq!(rise(&TIMES, true, |_| 1.0), None, "passing, and never below 0");
        let again = rise(&TIMES, true, |t| (t - 0.5) * (t - 1.5)).expect("falls below 0 and rises");
        assert!((again - 1.5).abs() < 1e-15, "{again}");
    }

    #[test]
    fn a_change_of_sign_between_samples_is_bracketed() {
        let at = rise(&TIMES, false, |t| t * t - 2.0).expect("rises");
        assert!((at - std::f64::consts::SQRT_2).abs() < 1e-15, "{at}");
        assert_eq!(rise(&TIMES, false, |_| -1.0), None, "below 0 throughout");
    }

    #[test]
    fn a_start_at_zero_rises_after_its_dip_or_at_once() {
        let dips = rise(&TIMES, false, |t| t * (t - 0.2)).expect("dips and rises");
        assert!((dips - 0.2).abs() < 1e-15, "{dips}");
        assert_eq!(rise(&TIMES, false, |t| t), Some(0.0), "never below 0: where it starts");
    }

    #[test]
    fn an_excursion_between_negative_samples_is_seen_by_its_parabola() {
        let above = rise(&TIMES, false, |t| 0.01 - 4.0 * (t - 0.8).powi(2)).expect("above 0 from 0.75 to 0.85");
        assert!((above - 0.75).abs() < 1e-14, "{above}");
        assert_eq!(rise(&TIMES, false, |t| -0.01 - 4.0 * (t - 0.8).powi(2)), None, "its vertex is below 0");
    }

    #[test]
    fn beside_an_earlier_event_only_the_order_is_decided() {
        let f = |t: f64| t - 0.75;
        let values: Vec<f64> = TIMES.iter().map(|t| f(*t)).collect();
        let beside = |at: f64, together: f64| {
            let mut count = 0;
            let found = first_rise([&TIMES, &values], RESOLUTION, false, EarliestEvent { at, together }, |t| {
                count += 1;
                f(t)
            });
            (found.expect("rises"), count)
        };
        assert_eq!(beside(0.745, 0.01).0, 0.745, "within the interval: together with it");
        let (later, count) = beside(0.3, 0.01);
        assert!(later > 0.31 && count <= 2, "later, by {count} evaluations: {later}");
        assert!((beside(0.9, 0.01).0 - 0.75).abs() < 1e-15, "before it: exactly");
    }

    #[test]
    fn the_earliest_of_several_rises_is_kept_and_of_equal_ones_the_first() {
        let mut earliest = EarliestRise::none();
        for (t, function) in [(None, 0), (Some(0.7), 1), (Some(0.3), 2), (Some(0.3), 3), (Some(0.5), 4)] {
            earliest.offer(t, function);
        }
        assert_eq!(earliest.known().at, 0.3);
        assert_eq!(earliest.found(), Some((0.3, 2)));
        assert_eq!(EarliestRise::<usize>::none().found(), None);
    }
}
