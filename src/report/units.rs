//! Forces and masses with the unit in which they have few digits.

use crate::language::six;

/// A force \[N\]: in kN from 10 kN on, to a tenth; below in N, to four digits.
pub(super) fn force(newtons: f64) -> String {
    if newtons.abs() < 1e4 { format!("{} N", four(newtons)) } else { format!("{:.1} kN", newtons / 1e3) }
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
        assert_eq!([force(9999.0), force(36.3e6)], ["9999 N", "36300.0 kN"], "kN from 10 kN on");
        assert_eq!([mass(0.0015), mass(2.0), mass(600e3)], ["0.0015 kg", "2 kg", "600 t"], "tonnes from one on");
    }
}
