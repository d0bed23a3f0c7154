//! How numbers are written, with words around them.

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

/// What a button would do, and its keys.
pub(in crate::app) fn keyed(what: Option<&str>, keys: &str) -> String {
    what.map_or_else(|| keys.to_owned(), |what| format!("{what} ({keys})"))
}

/// What American texts call this skew.
pub(in crate::app) fn us_skew(skew_deg: f64) -> String {
    format!("β {}°, US skew {}°", short(skew_deg), short(90.0 - skew_deg))
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
    format!("{samples} samples, {} s apart, {} s; peak {} m/s² ({} g)", short(dt), short(length), short(peak), short(g))
}

/// What was read of a record: format, name of the channel, unit, what was done to the numbers.
pub(in crate::app) fn record_read(format: &str, name: &str, unit: &str, done: &[String]) -> String {
    let name = if name.is_empty() { String::new() } else { format!(", {name}") };
    let done: Vec<String> = done.iter().map(|step| format!("; {step}")).collect();
    format!("Read as {format}{name}, in {unit}{}", done.concat())
}

/// Direction of a component in plan \[degrees\].
pub(in crate::app) fn from_x(angle: f64) -> String {
    format!("{}° from x", short(angle))
}

/// A component of ground motion and where it points.
pub(in crate::app) fn component(number: usize, way: &str) -> String {
    format!("Component {number}: {way}")
}

/// Whose a number of a component is.
pub(in crate::app) fn of_component(number: usize) -> String {
    format!("of component {number}")
}

/// A button that takes a component away.
pub(in crate::app) fn remove_component(number: usize) -> String {
    format!("Remove component {number}")
}

/// Names of a period and its acceleration in a target spectrum, and of the button that takes both away.
pub(in crate::app) fn target(number: usize) -> [String; 3] {
    [format!("Period {number}"), format!("PSA {number}"), format!("Remove period {number}")]
}

/// Peak acceleration \[m/s²\], velocity \[m/s\] and displacement \[m\] of a ground motion, each with its time, and the duration of strong
/// motion \[s\].
pub(in crate::app) fn quake_figures([a, v, d]: [(f64, f64); 3], strong: f64) -> String {
    format!(
        "PGA {} g at {} s, PGV {} m/s at {} s, PGD {} at {} s; strong motion {} s",
        short(a.0 / crate::scene::STANDARD_GRAVITY),
        short(a.1),
        short(v.0),
        short(v.1),
        length(d.0),
        short(d.1),
        short(strong)
    )
}

/// An entry about a pair.
pub(in crate::app) fn entry(number: usize) -> String {
    format!("Entry {number}")
}

/// A button that takes an entry about a pair away.
pub(in crate::app) fn remove_entry(number: usize) -> String {
    format!("Remove entry {number}")
}

/// Which body of an entry a list chooses.
pub(in crate::app) fn body_of_entry(number: usize, side: usize) -> String {
    format!("Body {side} of entry {number}")
}

/// A box that tells an entry to be about two ends only.
pub(in crate::app) fn ends_of_entry(number: usize) -> String {
    format!("Entry {number}: these ends only")
}

/// How many are selected, and what that means for what is typed.
pub(in crate::app) fn several(count: usize) -> String {
    format!("{count} selected: what is changed here goes to all girders among them")
}

/// How many are not shown.
pub(in crate::app) fn more(count: usize) -> String {
    format!("and {count} more")
}

/// A way in which a girder can be held.
pub(in crate::app) fn direction(way: crate::scene::Direction) -> &'static str {
    use crate::scene::Direction;
    match way {
        Direction::X => "held along x",
        Direction::Y => "held along y",
        Direction::Z => "held along z",
        Direction::Roll => "held in roll",
        Direction::Pitch => "held in pitch",
        Direction::Yaw => "held in yaw",
    }
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
    format!("unpin {number}")
}

/// How far the run that is shown and a pinned one are apart at the most.
pub(in crate::app) fn apart_from(number: usize, place: f64, turn: f64) -> String {
    format!("from {number}: at the most {} and {}° apart", length(place), short(turn.to_degrees()))
}

/// A plot panel's name.
pub(in crate::app) fn panel(number: usize) -> String {
    format!("Plot {number}")
}

/// A button that takes a plot panel away.
pub(in crate::app) fn remove_panel(number: usize) -> String {
    format!("remove plot {number}")
}

/// How often a contact touches.
pub(in crate::app) fn touches(count: usize) -> String {
    match count {
        0 => "It never touches".to_owned(),
        1 => "One touch".to_owned(),
        n => format!("{n} touches"),
    }
}

/// How many bars the timeline has, and how long contacts stick and slip in all of them \[s\].
pub(in crate::app) fn bars(count: usize, stick: f64, slip: f64) -> String {
    let bars = if count == 1 { "bar" } else { "bars" };
    format!("{count} {bars}: {} s of stick, {} s of slip", short(stick), short(slip))
}

/// What is assumed of a new bridge: depth, gap and seat \[m\], mass of a span \[kg\], contact \[N/m\], bearings \[Hz\].
pub(in crate::app) fn assumed([depth, gap, seat]: [f64; 3], mass: f64, k: f64, frequency: f64) -> String {
    format!(
        "Assumed until you say otherwise: depth {}, {} t a span, gaps {}, seats {}, contact K {}, bearings {} Hz with 10 % \
         damping, a sine of 0.4 g at 0.8 Hz. The file says so beside each.",
        length(depth),
        short(mass / 1e3),
        length(gap),
        length(seat),
        stiffness(k),
        short(frequency)
    )
}

/// A touch in a line.
pub(in crate::app) fn touch(start: f64, end: f64, peak: f64, impulse: f64) -> String {
    if impulse > 0.0 {
        return format!("{start:.4} s  hit of {} N s", short(impulse));
    }
    format!("{start:.4} s  {} ms  {}", short((end - start) * 1e3), force(peak))
}

/// What the view goes with.
pub(in crate::app) fn follow(name: &str, corner: Option<usize>) -> String {
    corner.map_or_else(|| name.to_owned(), |c| format!("{name} corner {}", c + 1))
}

/// What the section of a gap shows, and how much larger the gap is drawn than the face is long.
pub(in crate::app) fn section(pair: &str, least: f64, factor: f64) -> String {
    format!("{pair}: {} apart, drawn × {}", length(least), short(factor))
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
    format!("{} ms, {} × real time", short(seconds * 1e3), short(times))
}

/// How many frames a film has, and how long it plays.
pub(in crate::app) fn film_length(frames: u32, seconds: f64) -> String {
    format!("{frames} frames, plays for {} s", short(seconds))
}

/// A button about one of several pieces of unsaved work.
pub(in crate::app) fn of_work(what: &str, number: usize, name: &str) -> String {
    format!("{what} {number}: {name}")
}

/// How long ago, roughly.
pub(in crate::app) fn ago(time: std::time::Duration) -> String {
    let (count, unit) = match time.as_secs() {
        s if s < 60 => return "from less than a minute ago".into(),
        s if s < 3600 => (s / 60, "minute"),
        s if s < 86_400 => (s / 3600, "hour"),
        s => (s / 86_400, "day"),
    };
    format!("from {count} {unit}{} ago", if count == 1 { "" } else { "s" })
}

/// A playing speed: `1/100`, `1`, `×5`.
pub(in crate::app) fn speed(speed: f64) -> String {
    if speed < 1.0 { format!("1/{}", short(1.0 / speed)) } else { format!("×{}", short(speed)) }
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
