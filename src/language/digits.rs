//! Numbers as people read them in texts; tables keep every digit.

/// Six significant digits, without zeros that say nothing: `50`, not `50.00000000000426`; never `-0`.
pub(crate) fn six(value: f64) -> String {
    let rounded = format!("{value:.5e}").parse().unwrap_or(value) + 0.0;
    if rounded == 0.0 || (1e-4..1e15).contains(&rounded.abs()) { format!("{rounded}") } else { format!("{rounded:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_carry_six_digits() {
        assert_eq!([six(50.000_000_000_004_26), six(-0.0), six(1.0 / 3.0)], ["50", "0", "0.333333"], "rounded");
        assert_eq!([six(1e-20), six(-2.5e17), six(123_456_789.0)], ["1e-20", "-2.5e17", "123457000"], "any size");
    }
}
