//! Words about plots.

pub(in crate::app) const PLOTS: &str = "Plots";
pub(in crate::app) const PLOT_PLACE: &str = "Displacement";
pub(in crate::app) const PLOT_THETA: &str = "Rotation";
pub(in crate::app) const PLOT_FORCE: &str = "Contact force";
pub(in crate::app) const VALUES_HINT: &str =
    "Wheel: zoom the values (over the curves with Alt)\nDrag: move them\nDouble click: all of them";
pub(in crate::app) const NO_ANSWER: &str = "There is no run to plot yet.";
pub(in crate::app) const SHOWS: &str = "Shows";
pub(in crate::app) const SHOWN: [&str; 3] = ["history", "Fourier amplitudes", "response spectrum, 5 %"];
pub(in crate::app) const LOG: &str = "Logarithmic";
pub(in crate::app) const COPY_PLOTS: &str = "Copy as picture";
pub(in crate::app) const OFFER_FOURIER: &str = "Fourier amplitudes";
pub(in crate::app) const OFFER_RESPONSE: &str = "Response spectrum";
pub(in crate::app) const DIFFERENCES: &str = "Plot the differences";
pub(in crate::app) const DIFFERENCES_HINT: &str = "This run less each pinned one, as curves";

/// The axis of values of a chart.
pub(in crate::app) fn values_of(chart: &str) -> String {
    format!("Values of {chart}")
}

/// A curve by the other model.
pub(in crate::app) fn by_impacts(name: &str) -> String {
    format!("{name}, impact model")
}

/// A curve of a run that is kept.
pub(in crate::app) fn of_pin(name: &str, number: usize) -> String {
    format!("{name}, run {number}")
}

/// By how much the run shown differs from one that is kept.
pub(in crate::app) fn less_pin(name: &str, number: usize) -> String {
    format!("{name} − run {number}")
}

/// A time pointed to, with as many digits as the mouse can tell, `step` \[s\] apart.
pub(in crate::app) fn short_instant(t: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 2 and 9")]
    let decimals = (-step.max(1e-12).log10().floor()).clamp(2.0, 9.0) as usize;
    format!("{t:.decimals$} s")
}
