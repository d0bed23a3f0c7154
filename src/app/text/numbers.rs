//! How numbers are written, with words around them.

use crate::language::{Message, Text, values};

/// A number with three significant digits and no needless zeros.
pub(in crate::app) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return "–".into();
    }
    let magnitude = value.abs().log10().floor();
    if !(-4.0..6.0).contains(&magnitude) {
        return format!("{value:.2e}");
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 6")]
    let decimals = (2.0 - magnitude).clamp(0.0, 6.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Hint of a button, with its keys.
pub(in crate::app) fn keyed(what: Option<&str>, keys: &str) -> String {
    what.map_or_else(|| keys.to_owned(), |what| format!("{what} ({keys})"))
}

/// The skew with its value in American texts.
pub(in crate::app) fn us_skew(skew_deg: f64) -> String {
    Text::new("skew-both").with(&values!["skew" => short(skew_deg), "us" => short(90.0 - skew_deg)])
}

/// A length in the unit that fits it.
pub(in crate::app) fn length(metres: f64) -> String {
    match metres.abs() {
        m if m.is_nan() => "–".into(),
        0.0 => "0 mm".into(),
        m if m >= 1.0 => format!("{} m", short(metres)),
        m if m >= 1e-4 => format!("{} mm", short(metres * 1e3)),
        _ => format!("{} m", short(metres)),
    }
}

/// A length as it is, to the micrometre, in the unit that fits it.
pub(in crate::app) fn exact_length(metres: f64) -> String {
    if metres.abs() >= 1.0 {
        format!("{} m", crate::app::unit::trimmed(metres))
    } else {
        format!("{} mm", crate::app::unit::trimmed(crate::app::unit::rounded(metres * 1e3, 1e-4)))
    }
}

/// How many samples, how far apart \[s\], how strong \[m/s²\].
pub(in crate::app) fn record(samples: usize, dt: f64, peak: f64) -> String {
    let (length, g) = (dt * (samples.max(1) - 1) as f64, peak / crate::scene::STANDARD_GRAVITY);
    let values = values![
        "samples" => samples,
        "dt" => short(dt),
        "length" => short(length),
        "peak" => short(peak),
        "g" => short(g)
    ];
    Text::new("record-figures").with(&values)
}

/// Text on the contents of a record: format, name of the channel, unit, processing of the numbers.
pub(in crate::app) fn record_read(format: &str, name: &str, unit: &str, done: &[Message]) -> String {
    let name = if name.is_empty() { String::new() } else { format!(", {name}") };
    let done: Vec<String> = done.iter().map(|step| format!("; {step}")).collect();
    Text::new("record-read").with(&values!["format" => format, "name" => name, "unit" => unit, "done" => done.concat()])
}

/// Direction of a component in plan \[degrees\].
pub(in crate::app) fn from_x(angle: f64) -> String {
    Text::new("from-x").with(&values!["angle" => short(angle)])
}

/// A component of ground motion and where it points.
pub(in crate::app) fn component(number: usize, way: &str) -> String {
    Text::new("component").with(&values!["number" => number, "way" => way])
}

/// Whose a number of a component is.
pub(in crate::app) fn whose_component(number: usize) -> String {
    Text::new("whose-component").with(&values!["number" => number])
}

/// A button that takes a component away.
pub(in crate::app) fn remove_component(number: usize) -> String {
    Text::new("remove-component").with(&values!["number" => number])
}

/// Names of a period and its acceleration in a target spectrum, and of the button that takes both away.
pub(in crate::app) fn target(number: usize) -> [String; 3] {
    ["target-period", "target-psa", "target-remove-period"].map(|key| Text::new(key).with(&values!["number" => number]))
}

/// Peak acceleration \[m/s²\], velocity \[m/s\] and displacement \[m\] of a ground motion, each with its time, and the duration of strong
/// motion \[s\].
pub(in crate::app) fn quake_figures([a, v, d]: [(f64, f64); 3], strong: f64) -> String {
    let values = values![
        "pga" => short(a.0 / crate::scene::STANDARD_GRAVITY),
        "ta" => short(a.1),
        "pgv" => short(v.0),
        "tv" => short(v.1),
        "pgd" => length(d.0),
        "td" => short(d.1),
        "strong" => short(strong)
    ];
    Text::new("quake-figures").with(&values)
}

/// An entry about a pair.
pub(in crate::app) fn entry(number: usize) -> String {
    Text::new("entry").with(&values!["number" => number])
}

/// A button that takes an entry about a pair away.
pub(in crate::app) fn remove_entry(number: usize) -> String {
    Text::new("remove-entry").with(&values!["number" => number])
}

/// Which body of an entry a list chooses.
pub(in crate::app) fn body_of_entry(number: usize, side: usize) -> String {
    Text::new("body-of-entry").with(&values!["side" => side, "number" => number])
}

/// A box that tells an entry to be about two ends only.
pub(in crate::app) fn ends_of_entry(number: usize) -> String {
    Text::new("ends-of-entry").with(&values!["number" => number])
}

/// How many are selected, whose numbers are shown, and what that means for what is typed: what a girder is given all girders get.
pub(in crate::app) fn several(count: usize, name: &str, girder: bool) -> String {
    Text::new(if girder { "several" } else { "several-alone" }).with(&values!["count" => count, "name" => name])
}

/// How many are not shown.
pub(in crate::app) fn more(count: usize) -> String {
    Text::new("more").with(&values!["count" => count])
}

/// A way in which a girder can be held.
pub(in crate::app) fn direction(way: crate::scene::Direction) -> &'static str {
    use crate::scene::Direction;
    let words = match way {
        Direction::X => Text::new("held-x"),
        Direction::Y => Text::new("held-y"),
        Direction::Z => Text::new("held-z"),
        Direction::Roll => Text::new("held-roll"),
        Direction::Pitch => Text::new("held-pitch"),
        Direction::Yaw => Text::new("held-yaw"),
    };
    words.as_str()
}

/// An energy in the unit that fits it.
pub(in crate::app) fn energy(joules: f64) -> String {
    match joules.abs() {
        e if e >= 1e6 => format!("{} MJ", short(joules / 1e6)),
        e if e >= 1e3 => format!("{} kJ", short(joules / 1e3)),
        e if e >= 1.0 || e == 0.0 => format!("{} J", short(joules)),
        _ => format!("{} mJ", short(joules * 1e3)),
    }
}

/// A button that lets a pinned run go.
pub(in crate::app) fn unpin(number: usize) -> String {
    Text::new("unpin").with(&values!["number" => number])
}

/// How far the run that is shown and a pinned one are apart at the most.
pub(in crate::app) fn apart_from(number: usize, place: f64, turn: f64) -> String {
    let values = values!["number" => number, "place" => length(place), "turn" => short(turn.to_degrees())];
    Text::new("apart-from").with(&values)
}

/// A plot panel's name.
pub(in crate::app) fn panel(number: usize) -> String {
    Text::new("panel").with(&values!["number" => number])
}

/// A button that takes a plot panel away.
pub(in crate::app) fn remove_panel(number: usize) -> String {
    Text::new("remove-panel").with(&values!["number" => number])
}

/// How often a contact touches.
pub(in crate::app) fn touches(count: usize) -> String {
    Text::new("touches").with(&values!["count" => count])
}

/// How many bars the timeline has, and how long contacts stick and slip in all of them \[s\].
pub(in crate::app) fn bars(count: usize, stick: f64, slip: f64) -> String {
    Text::new("bars").with(&values!["count" => count, "stick" => short(stick), "slip" => short(slip)])
}

/// Which numbers a new bridge can have: span and width \[m\], skew \[degrees\], and how many spans at most.
pub(in crate::app) fn ranges(ranges: [[f64; 2]; 3], spans: usize) -> String {
    let [span, width, skew] = ranges.map(|[least, most]| format!("{}–{}", short(least), short(most)));
    Text::new("start-ranges")
        .with(&values!["span" => span, "width" => width, "skew" => skew, "spans" => spans.to_string()])
}

/// Text on the assumed sizes of a new bridge: depth, gap and seat \[m\], mass of a span \[kg\], contact \[N/m\], bearings \[Hz\].
pub(in crate::app) fn assumed([depth, gap, seat]: [f64; 3], mass: f64, k: f64, frequency: f64) -> String {
    let values = values![
        "depth" => length(depth),
        "mass" => short(mass / 1e3),
        "gap" => length(gap),
        "seat" => length(seat),
        "k" => stiffness(k),
        "frequency" => short(frequency)
    ];
    Text::new("assumed").with(&values)
}

/// A touch in a line.
pub(in crate::app) fn touch(start: f64, end: f64, peak: f64, impulse: f64) -> String {
    if impulse > 0.0 {
        return Text::new("hit-of").with(&values!["t" => format!("{start:.4}"), "impulse" => short(impulse)]);
    }
    format!("{start:.4} s  {} ms  {}", short((end - start) * 1e3), force(peak))
}

/// Name of the point that the view follows.
pub(in crate::app) fn follow(name: &str, corner: Option<usize>) -> String {
    corner.map_or_else(|| name.to_owned(), |c| Text::new("corner-of").with(&values!["name" => name, "corner" => c + 1]))
}

/// Caption of the section of a gap, with the magnification of the gap against the face.
pub(in crate::app) fn section(pair: &str, least: f64, factor: f64) -> String {
    Text::new("section").with(&values!["pair" => pair, "least" => length(least), "factor" => short(factor)])
}

/// A stiffness in the unit that fits it.
pub(in crate::app) fn stiffness(k: f64) -> String {
    let unit = crate::app::unit::stiffness_unit(k);
    format!("{}{}", short(k * unit.factor), unit.suffix)
}

/// A dashpot in the unit that fits it.
pub(in crate::app) fn damping(c: f64) -> String {
    let unit = crate::app::unit::damping_unit(c);
    format!("{}{}", short(c * unit.factor), unit.suffix)
}

/// A force in the unit that fits it.
pub(in crate::app) fn force(newtons: f64) -> String {
    match newtons.abs() {
        f if f >= 1e6 => format!("{} MN", short(newtons / 1e6)),
        f if f >= 1e4 => format!("{} kN", short(newtons / 1e3)),
        _ => format!("{} N", short(newtons)),
    }
}

/// An impulse \[N·s\].
pub(in crate::app) fn impulse(newton_seconds: f64) -> String {
    match newton_seconds.abs() {
        j if j >= 1e6 => format!("{} MN·s", short(newton_seconds / 1e6)),
        j if j >= 1e4 => format!("{} kN·s", short(newton_seconds / 1e3)),
        _ => format!("{} N·s", short(newton_seconds)),
    }
}

/// The time of a tick, with as many digits as tell it from its neighbours.
pub(in crate::app) fn tick(t: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 9")]
    let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{t:.decimals$} s")
}

/// The time shown.
pub(in crate::app) fn instant(t: f64) -> String {
    format!("t = {t:.4} s")
}

/// How long a run took, and how many times faster than the ground shakes.
pub(in crate::app) fn run_time(seconds: f64, times: f64) -> String {
    Text::new("run-time").with(&values!["ms" => short(seconds * 1e3), "times" => short(times)])
}

/// How many frames a film has, and how long it plays.
pub(in crate::app) fn film_length(frames: u32, seconds: f64) -> String {
    Text::new("film-length").with(&values!["frames" => frames, "seconds" => short(seconds)])
}

/// A button about one of several pieces of unsaved work.
pub(in crate::app) fn of_work(what: &str, number: usize, name: &str) -> String {
    Text::new("of-work").with(&values!["what" => what, "number" => number, "name" => name])
}

/// How long ago, roughly.
pub(in crate::app) fn ago(time: std::time::Duration) -> String {
    let (count, key) = match time.as_secs() {
        s if s < 60 => return Text::new("ago-moment").into(),
        s if s < 3600 => (s / 60, "ago-minutes"),
        s if s < 86_400 => (s / 3600, "ago-hours"),
        s => (s / 86_400, "ago-days"),
    };
    Text::new(key).with(&values!["count" => count])
}

/// A playing speed: `1/100`, `1`, `×5`.
pub(in crate::app) fn speed(speed: f64) -> String {
    if speed < 1.0 { format!("1/{}", short(1.0 / speed)) } else { format!("×{}", short(speed)) }
}

/// That gaps differ, from the least to the largest \[m\], where one number is for all.
pub(in crate::app) fn gaps(gaps: &[f64]) -> String {
    let [least, most] = [gaps.iter().copied().reduce(f64::min), gaps.iter().copied().reduce(f64::max)];
    let [least, most] = [least, most].map(|gap| length(gap.unwrap_or(0.0)));
    Text::new("gaps-differ").with(&values!["least" => least, "most" => most])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases =
            [(0.0, "0"), (1.0, "1"), (0.4, "0.4"), (12.345, "12.3"), (1234.6, "1235"), (-0.001_234, "-0.00123")];
        for (value, wanted) in cases {
            assert_eq!(short(value), wanted, "{value}");
        }
        assert_eq!(short(1.55e-7), "1.55e-7", "very small");
        assert_eq!(short(f64::NAN), "–", "no number");
    }

    #[test]
    fn speeds_are_fractions_below_one() {
        assert_eq!(speed(0.001), "1/1000", "slowest");
        assert_eq!(speed(1.0), "×1", "true");
    }
}
