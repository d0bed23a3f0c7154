//! Round numbers for scales, and numbers as people read them.

use crate::sim::History;

/// The largest of 1, 2, 5, 10, … that is not above `x`; 1 where `x` is not a positive number.
pub fn round_down(x: f64) -> f64 {
    if !(x.is_finite() && x > 0.0) {
        return 1.0;
    }
    // Up by a rounding error, so that 1000 (or 0.05) is its own answer.
    let x = x * (1.0 + 1e-12);
    let power = 10f64.powf(x.log10().floor());
    [5.0, 2.0].into_iter().find(|m| m * power <= x).unwrap_or(1.0) * power
}

/// The smallest of 1, 2, 5, 10, … that is not below `x`; 1 where `x` is not a positive number.
pub fn round_up(x: f64) -> f64 {
    let below = round_down(x);
    if below * (1.0 + 1e-12) >= x || !x.is_finite() {
        return below;
    }
    // The next step up: 1 to 2, 2 to 5, 5 to 10.
    [2.0, 2.5].into_iter().map(|m| round_down(below * m)).find(|&v| v > below).unwrap_or(below)
}

/// A force scale for a whole run, from its peak: a round number of N per metre \[N/m\].
///
/// The largest arrow of the run is then between a fifth and half of its shortest girder long.
pub fn auto_force_scale(history: &History) -> f64 {
    let peak = history.hits().touches().iter().map(|touch| touch.peak_force).fold(0.0, f64::max);
    force_scale_for(peak, history.scene())
}

/// A scale for the impulses of a whole run, as for forces; nothing where there are none \[N·s/m\].
pub fn auto_impulse_scale(history: &History) -> Option<f64> {
    let peak = history.hits().touches().iter().map(|touch| touch.impulse).fold(0.0, f64::max);
    (peak > 0.0).then(|| force_scale_for(peak, history.scene()))
}

pub(super) fn force_scale_for(peak: f64, scene: &crate::scene::Scene) -> f64 {
    let shortest = scene.girders.iter().map(|g| g.length).fold(f64::INFINITY, f64::min);
    let longest_arrow = if shortest.is_finite() && shortest > 0.0 { 0.5 * shortest } else { 0.5 };
    round_up(peak / longest_arrow)
}

/// Sizes that read well without an exponent.
const PLAIN: std::ops::Range<f64> = 1e-6..1e10;

/// A number of any size in few digits: `2e18`, `1.23e-9`.
fn with_exponent(x: f64) -> String {
    format!("{:e}", format!("{x:.2e}").parse().unwrap_or(x)).replacen('-', "\u{2212}", usize::from(x < 0.0))
}

/// Whether a number is so large or so small that its digits would fill the picture.
fn is_absurd(x: f64) -> bool {
    x != 0.0 && !PLAIN.contains(&x.abs())
}

/// `x` with three significant digits; what rounds to 0 has no sign.
fn three_digits(x: f64) -> String {
    let whole = [1e1, 1e2].into_iter().filter(|power| x.abs() >= *power).count();
    let x = if x.abs() < 0.005 { 0.0 } else { x };
    // A true minus: the hyphen is easily overlooked.
    format!("{x:.*}", 2 - whole).replace('-', "\u{2212}")
}

/// A force in N, kN or MN; short at any size, `2.34e18 N`.
pub fn force(newton: f64) -> String {
    let (value, unit) = match newton.abs() {
        n if n >= PLAIN.end => return format!("{} N", with_exponent(newton)),
        n if n >= 1e6 => (newton / 1e6, "MN"),
        n if n >= 1e3 => (newton / 1e3, "kN"),
        _ => (newton, "N"),
    };
    format!("{} {unit}", three_digits(value))
}

/// A round impulse: `0.2 N·s`, `500 kN·s`.
pub fn round_impulse(newton_second: f64) -> String {
    format!("{}·s", round_force(newton_second))
}

/// A length in mm, or in m from 1 m on; short at any size.
pub fn length(metre: f64) -> String {
    if metre.abs() >= PLAIN.end {
        return format!("{} m", with_exponent(metre));
    }
    if metre.abs() >= 1.0 { format!("{} m", three_digits(metre)) } else { format!("{} mm", three_digits(metre * 1e3)) }
}

/// A round number without the digits that say nothing: `0.5`, `20`, `2e18`.
pub fn plain(x: f64) -> String {
    if is_absurd(x) {
        return with_exponent(x);
    }
    let text = format!("{x:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A round length: `50 mm`, `2 m`.
pub fn round_length(metre: f64) -> String {
    if metre >= 1.0 { format!("{} m", plain(metre)) } else { format!("{} mm", plain(metre * 1e3)) }
}

/// A round force: `200 N`, `5 kN`; short at any size, `2e18 N`.
pub fn round_force(newton: f64) -> String {
    match newton {
        n if is_absurd(n) => format!("{} N", with_exponent(n)),
        n if n >= 1e6 => format!("{} MN", plain(n / 1e6)),
        n if n >= 1e3 => format!("{} kN", plain(n / 1e3)),
        n => format!("{} N", plain(n)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_round_numbers() {
        let up = [0.9, 1.0, 1.1, 2.0, 3.0, 5.1, 1999.0, 0.03].map(round_up);
        let close = |a: f64, b: f64| (a - b).abs() < 1e-9 * b;
        let wanted = [1.0, 1.0, 2.0, 2.0, 5.0, 10.0, 2000.0, 0.05];
        assert!(up.iter().zip(wanted).all(|(&a, b)| close(a, b)), "got {up:?}");
        assert!(close(round_down(0.05), 0.05) && close(round_down(1000.0), 1000.0), "round numbers stay");
        assert!([0.0, -1.0, f64::NAN, f64::INFINITY].iter().all(|&x| round_up(x) == 1.0), "never 0, never NaN");
    }

    #[test]
    fn quantities_read_well() {
        assert_eq!([force(123.4), force(0.5), force(45_600.0)], ["123 N", "0.50 N", "45.6 kN"], "forces");
        assert_eq!([length(0.003), length(0.05), length(30.0)], ["3.00 mm", "50.0 mm", "30.0 m"], "lengths");
        assert_eq!([length(-2e-6), length(-6e-6)], ["0.00 mm", "\u{2212}0.01 mm"], "no sign without a digit");
        assert_eq!([round_length(0.05), round_length(2.0), round_force(2e3)], ["50 mm", "2 m", "2 kN"], "scales");
    }

    #[test]
    fn absurd_quantities_stay_short() {
        assert_eq!(
            [round_force(2e18), round_force(5e9), round_force(1e-300)],
            ["2e18 N", "5000 MN", "1e-300 N"],
            "bars"
        );
        assert_eq!([force(2.346e18), force(-3e200)], ["2.35e18 N", "\u{2212}3e200 N"], "forces");
        assert_eq!([length(4e90), round_length(1e12)], ["4e90 m", "1e12 m"], "lengths");
        assert_eq!([plain(1e-9), plain(0.0), plain(-45.0)], ["1e-9", "0", "-45"], "numbers");
    }
}
