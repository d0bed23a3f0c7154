//! Gragg's midpoint rule, extrapolated in h² (Bulirsch and Stoer; Hairer, Nørsett and Wanner I, II.9).

/// Substeps of the columns.
const SUBSTEPS: [usize; 6] = [2, 4, 6, 8, 10, 12];

/// Rate of a state.
pub(super) trait Rate {
    /// Writes it.
    fn rate(&mut self, t: f64, y: &[f64], out: &mut [f64]);
}

/// Scratch.
#[derive(Default)]
pub(super) struct Extrapolation {
    table: Vec<Vec<f64>>,
    before: Vec<f64>,
    here: Vec<f64>,
    slope: Vec<f64>,
    first: Vec<f64>,
}

impl Extrapolation {
    /// One step of `h`; the new state and the difference between the last two columns, against what `floor` and the
    /// state's size make of `tolerance`.
    pub(super) fn step<R: Rate>(
        &mut self,
        system: &mut R,
        t: f64,
        y: &[f64],
        h: f64,
        tolerance: f64,
    ) -> (Vec<f64>, f64) {
        let n = y.len();
        self.first.resize(n, 0.0);
        self.slope.resize(n, 0.0);
        let mut first = std::mem::take(&mut self.first);
        system.rate(t, y, &mut first);
        self.first = first;
        self.table.clear();
        for substeps in SUBSTEPS {
            let row = self.midpoint(system, t, y, h, substeps);
            self.table.push(row);
        }
        let mut error = 0.0_f64;
        for column in 1..SUBSTEPS.len() {
            for row in (column..SUBSTEPS.len()).rev() {
                let ratio = SUBSTEPS[row] as f64 / SUBSTEPS[row - column] as f64;
                let factor = 1.0 / (ratio * ratio - 1.0);
                let (lower, upper) = self.table.split_at_mut(row);
                let last = column + 1 == SUBSTEPS.len();
                for ((a, b), y) in upper[0].iter_mut().zip(&lower[row - 1]).zip(y) {
                    let change = (*a - b) * factor;
                    *a += change;
                    if last {
                        error = error.max(change.abs() / (tolerance * (1e-2 + y.abs())));
                    }
                }
            }
        }
        (self.table.pop().unwrap_or_default(), error)
    }

    fn midpoint<R: Rate>(&mut self, system: &mut R, t: f64, y: &[f64], h: f64, substeps: usize) -> Vec<f64> {
        let part = h / substeps as f64;
        self.before.clear();
        self.before.extend_from_slice(y);
        self.here.clear();
        self.here.extend(y.iter().zip(&self.first).map(|(y, k)| y + part * k));
        for i in 1..substeps {
            system.rate(t + part * i as f64, &self.here, &mut self.slope);
            for ((before, here), k) in self.before.iter_mut().zip(&mut self.here).zip(&self.slope) {
                (*before, *here) = (*here, *before + 2.0 * part * k);
            }
        }
        self.here.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Swing;

    impl Rate for Swing {
        fn rate(&mut self, _: f64, y: &[f64], out: &mut [f64]) {
            (out[0], out[1]) = (y[1], -y[0]);
        }
    }

    #[test]
    fn a_tenth_of_a_radian_is_exact_to_rounding() {
        let mut y = vec![1.0, 0.0];
        let mut method = Extrapolation::default();
        for i in 0..100 {
            y = method.step(&mut Swing, 0.1 * f64::from(i), &y, 0.1, 1e-14).0;
        }
        assert!((y[0] - 10.0_f64.cos()).abs() < 1e-13, "{} against cos 10", y[0]);
    }
}
