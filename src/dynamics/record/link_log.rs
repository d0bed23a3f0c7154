//! Phases of one device over time as stored in a history.

use crate::dynamics::connection::Phase;
use crate::dynamics::integrator::dense_output::DenseOutput;

/// Phases in order of time.
#[derive(Clone, Debug, Default)]
pub struct LinkLog {
    phases: Vec<(f64, Phase)>,
    released: Vec<(f64, f64)>,
    /// Dense output of the memories that are states, per step, with the beginning of the step \[s\].
    pub(in crate::dynamics) memories: Vec<(f64, DenseOutput)>,
}

impl LinkLog {
    /// Enters the phase from `t` on \[s\], with the energy released by the change \[J\].
    pub fn push(&mut self, t: f64, phase: Phase, released: f64) {
        self.phases.push((t, phase));
        if released != 0.0 {
            self.released.push((t, released));
        }
    }

    /// The phase at `t`; before the first entry that of the first entry, `None` without entries.
    pub fn at(&self, t: f64) -> Option<Phase> {
        let after = self.phases.partition_point(|(from, _)| *from <= t);
        self.phases.get(after.max(1) - 1).map(|(_, phase)| *phase)
    }

    /// The phase at `t` with its memory at that time; `evolves`: whether the memory changes in a phase.
    pub fn evolved_at(&self, t: f64, evolves: impl Fn(&Phase) -> bool) -> Option<Phase> {
        let mut phase = self.at(t)?;
        if evolves(&phase)
            && let Some(i) = self.memories.partition_point(|(from, _)| *from <= t).checked_sub(1)
        {
            self.memories[i].1.read(0..1, t, &mut phase.memory[..1]);
        }
        Some(phase)
    }

    /// Phases with their beginnings \[s\].
    pub fn phases(&self) -> &[(f64, Phase)] {
        &self.phases
    }

    /// Energy released by changes up to `t` \[J\].
    pub fn released(&self, t: f64) -> f64 {
        self.released.iter().take_while(|(at, _)| *at <= t).map(|(_, energy)| energy).sum()
    }

    /// Number of changes at `t`; 0 unless `t` is the time of the latest change.
    pub(in crate::dynamics) fn changes_at(&self, t: f64) -> usize {
        self.phases.iter().rev().take_while(|(at, _)| *at == t).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_phase_at_a_time_is_the_last_that_began() {
        let phase = |law: u32| Phase { branch: law, ..Phase::default() };
        let mut log = LinkLog::default();
        assert_eq!(log.at(1.0), None, "nothing was entered");
        log.push(0.0, phase(0), 0.0);
        log.push(2.0, phase(1), 0.5);
        log.push(2.0, phase(2), 0.25);
        assert_eq!([0.0, 1.9, 2.0, 9.0].map(|t| log.at(t).map(|p| p.branch)), [Some(0), Some(0), Some(2), Some(2)]);
        assert_eq!([log.released(1.0), log.released(2.0)], [0.0, 0.75]);
        assert_eq!((log.changes_at(2.0), log.changes_at(1.0)), (2, 0));
    }
}
