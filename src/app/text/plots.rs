//! Words about plots.

use crate::language::{Text, values};

pub(in crate::app) const PLOTS: Text = Text::new("plots");
pub(in crate::app) const PLOT_PLACE: Text = Text::new("plot-place");
pub(in crate::app) const PLOT_THETA: Text = Text::new("plot-theta");
pub(in crate::app) const PLOT_FORCE: Text = Text::new("plot-force");
pub(in crate::app) const VALUES_HINT: Text = Text::new("values-hint");
pub(in crate::app) const NO_ANSWER: Text = Text::new("no-answer");
pub(in crate::app) const SHOWS: Text = Text::new("shows");
pub(in crate::app) const SHOWN: [Text; 3] =
    [Text::new("history"), Text::new("fourier-amplitudes"), Text::new("response-spectrum")];
pub(in crate::app) const LOG: Text = Text::new("log");
pub(in crate::app) const COPY_PLOTS: Text = Text::new("copy-plots");
pub(in crate::app) const OFFER_FOURIER: Text = Text::new("offer-fourier");
pub(in crate::app) const OFFER_RESPONSE: Text = Text::new("offer-response");
pub(in crate::app) const DIFFERENCES: Text = Text::new("differences");
pub(in crate::app) const DIFFERENCES_HINT: Text = Text::new("differences-hint");

/// The axis of values of a chart.
pub(in crate::app) fn values_of(chart: &str) -> String {
    Text::new("values-of").with(&values!["chart" => chart])
}

/// A curve by the other model.
pub(in crate::app) fn by_impacts(name: &str) -> String {
    Text::new("by-impacts").with(&values!["name" => name])
}

/// A curve of a run that is kept.
pub(in crate::app) fn of_pin(name: &str, number: usize) -> String {
    Text::new("of-pin").with(&values!["name" => name, "number" => number])
}

/// A key and its value in a run that is kept, where the run shown has another.
pub(in crate::app) fn pin_differs(key: &str, value: &str) -> String {
    Text::new("pin-differs").with(&values!["key" => key, "value" => value])
}

/// A list of which so many are left out.
pub(in crate::app) fn and_more(list: &str, more: usize) -> String {
    Text::new("pin-more").with(&values!["list" => list, "more" => more])
}

/// By how much the run shown differs from one that is kept.
pub(in crate::app) fn less_pin(name: &str, number: usize) -> String {
    Text::new("less-pin").with(&values!["name" => name, "number" => number])
}

/// A time pointed to, with as many digits as the mouse can tell, `step` \[s\] apart.
pub(in crate::app) fn short_instant(t: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 2 and 9")]
    let decimals = (-step.max(1e-12).log10().floor()).clamp(2.0, 9.0) as usize;
    format!("{t:.decimals$} s")
}

/// A section force of a girder over time and station.
pub(in crate::app) fn wave_chart(force: &str, girder: &str) -> String {
    Text::new("wave-chart").with(&values!["force" => force, "girder" => girder])
}

/// Label that leads to the waves of the hardest hit; a wave runs from end to end in `transit` \[s\].
pub(in crate::app) fn show_waves(transit: f64) -> String {
    Text::new("show-waves").with(&values!["transit" => format!("{} ms", super::short(transit * 1e3))])
}

/// A value at a station \[m\].
pub(in crate::app) fn at_station(value: &str, station: f64) -> String {
    Text::new("at-station").with(&values!["value" => value, "station" => super::length(station)])
}

/// Quantities that a panel asks for and the run does not have.
pub(in crate::app) fn missing(names: &[String]) -> String {
    Text::new("plot-missing").with(&values!["names" => names.join(", ")])
}
