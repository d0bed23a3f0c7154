//! Instants whose pictures an exposed picture is the mean of.

/// Instants of an exposure: a tenth of a pixel apart at the speeds of the paper's film, exposed for half of the time between pictures.
const SHARES: u32 = 33;

/// Instants \[s\] whose pictures are averaged into one of exposure `exposure` \[s\] about `t`: the middles of equal parts, held within
/// 0 to `end`; `t` alone where `exposure` is 0.
pub fn exposed(t: f64, exposure: f64, end: f64) -> impl Iterator<Item = f64> {
    let count = if exposure > 0.0 { SHARES } else { 1 };
    let share = move |n: u32| (f64::from(n) + 0.5) / f64::from(count) - 0.5;
    (0..count).map(move |n| (t + share(n) * exposure).clamp(0.0, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exposure_is_about_its_instant_and_within_the_run() {
        assert_eq!(exposed(0.5, 0.0, 1.0).collect::<Vec<_>>(), [0.5], "none");
        let all: Vec<f64> = exposed(0.5, 0.033, 1.0).collect();
        assert!((all.iter().sum::<f64>() / 33.0 - 0.5).abs() < 1e-15, "its mean is the instant");
        assert!((all[32] - all[0] - 0.032).abs() < 1e-15, "from the middle of the first part to that of the last");
        assert!(exposed(0.0, 0.033, 1.0).all(|t| t >= 0.0) && exposed(1.0, 0.033, 1.0).all(|t| t <= 1.0), "within");
    }
}
