//! Forces, stiffnesses and masses with the unit in which they have few digits.

use crate::language::six;

/// A force \[N\]: in MN from 10 MN on, to a hundredth; in kN from 10 kN on, to a tenth; below in N, to four digits.
pub(super) fn force(newtons: f64) -> String {
    of_size(newtons, newtons)
}

/// Forces that are compared \[N\]: all in the unit of the largest.
pub(super) fn forces<const N: usize>(newtons: [f64; N]) -> [String; N] {
    let largest = newtons.into_iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    newtons.map(|force| of_size(force, largest))
}

/// A force in the unit for one of this size \[N\].
fn of_size(newtons: f64, size: f64) -> String {
    match size.abs() {
        below if below < 1e4 => format!("{} N", four(newtons)),
        below if below < 1e7 => format!("{:.1} kN", newtons / 1e3),
        _ => format!("{:.2} MN", newtons / 1e6),
    }
}

/// A stiffness \[N/m\], every digit, in the largest of GN/m, MN/m and kN/m of which it is one or more.
pub(super) fn stiffness(newtons_per_metre: f64) -> String {
    let units = [(1e9, "GN/m"), (1e6, "MN/m"), (1e3, "kN/m")];
    let unit = units.into_iter().find(|(size, _)| newtons_per_metre.abs() >= *size);
    let (size, name) = unit.unwrap_or((1.0, "N/m"));
    format!("{} {name}", newtons_per_metre / size)
}

/// A mass \[kg\]: in tonnes from one tonne on.
pub(super) fn mass(kilograms: f64) -> String {
    if kilograms < 1e3 { format!("{} kg", six(kilograms)) } else { format!("{} t", six(kilograms / 1e3)) }
}

/// Four significant digits.
fn four(value: f64) -> String {
    six(format!("{value:.3e}").parse().unwrap_or(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_and_large_values_keep_their_digits() {
        assert_eq!(
            [force(0.012_345), force(65.078_9), force(-318.0), force(0.0)],
            ["0.01235 N", "65.08 N", "-318 N", "0 N"]
        );
        assert_eq!(
            [force(9999.0), force(861.64e3), force(36.3e6)],
            ["9999 N", "861.6 kN", "36.30 MN"],
            "kN from 10 kN on"
        );
        assert_eq!(forces([14.93e6, 2.24e6]), ["14.93 MN", "2.24 MN"], "in one unit");
        assert_eq!([1.55e5, 2e9, 9.87e8, 12.5].map(stiffness), ["155 kN/m", "2 GN/m", "987 MN/m", "12.5 N/m"]);
        assert_eq!([mass(0.0015), mass(2.0), mass(600e3)], ["0.0015 kg", "2 kg", "600 t"], "tonnes from one on");
    }
}
