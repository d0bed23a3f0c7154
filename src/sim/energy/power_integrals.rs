//! Sums of powers over a run, which the energy ledger is read from.

/// Running sums of a few integrals at the borders of their cells.
#[derive(Clone, Debug)]
pub(in crate::sim) struct Account<const N: usize> {
    /// Start of each cell, its end, and the sums up to its start.
    cells: Vec<(f64, f64, [f64; N])>,
    total: [f64; N],
}

impl<const N: usize> Account<N> {
    pub(in crate::sim) fn new() -> Self {
        Self { cells: Vec::new(), total: [0.0; N] }
    }

    pub(in crate::sim) fn add(&mut self, from: f64, until: f64, amounts: [f64; N]) {
        self.cells.push((from, until, self.total));
        for (sum, amount) in self.total.iter_mut().zip(amounts) {
            *sum += amount;
        }
    }

    /// Sums up to `t`; `rest` integrates over the part of the cell that `t` is in.
    pub(in crate::sim) fn at(&self, t: f64, rest: impl Fn(f64, f64) -> [f64; N]) -> [f64; N] {
        let n = self.cells.partition_point(|(from, ..)| *from < t);
        let Some(&(from, until, sums)) = n.checked_sub(1).and_then(|i| self.cells.get(i)) else { return [0.0; N] };
        if t >= until && n == self.cells.len() {
            return self.total;
        }
        let part = rest(from, t.min(until));
        std::array::from_fn(|i| sums[i] + part[i])
    }
}

/// Integrals of all powers of a run, from which the energy ledger is read.
#[derive(Clone, Debug)]
pub(in crate::sim) struct PowerIntegrals {
    /// Per body: work of the ground, work of pushes, losses in bearings and in the body itself.
    pub(in crate::sim) bodies: Vec<Account<4>>,
    /// Per contact: losses in the normal dashpot, the tangential dashpot and friction; work of ground that moves as given.
    pub(in crate::sim) contacts: Vec<Account<4>>,
    /// Per device: the loss; work of ground that moves as given.
    pub(in crate::sim) devices: Vec<Account<2>>,
    /// Whether each of these is a bearing.
    pub(in crate::sim) bearings: Vec<bool>,
    /// Per stretch of lasting contact of the impact model: the loss in friction.
    pub(in crate::sim) lasting: Vec<Account<1>>,
    pub(in crate::sim) initial: f64,
    /// Instants in rising order, and the largest kinetic energy up to each.
    pub(in crate::sim) kinetic: Vec<(f64, f64)>,
}
