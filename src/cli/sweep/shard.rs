//! `--shard I/N`: a part of a sweep for a process of its own.

use crate::language::Text;

/// One of so many parts of a sweep: runs are dealt out in turn, so that each part has costly ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shard {
    /// From 1 on.
    number: usize,
    count: usize,
}

impl Shard {
    /// Reads `I/N`.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match parts {
            Some((number, count)) if 1 <= number && number <= count => Ok(Self { number, count }),
            _ => Err(Text::new("wrong-shard").into()),
        }
    }

    /// Whether a run belongs to it.
    pub(super) fn has(self, run: usize) -> bool {
        run % self.count == self.number - 1
    }

    /// Name of its journal.
    pub(super) fn journal(self) -> String {
        format!("shard-{}-of-{}.journal", self.number, self.count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_run_belongs_to_one_shard() {
        let shards: Vec<Shard> = (1..=7).map(|i| Shard::parse(&format!("{i}/7")).expect("one of seven")).collect();
        for run in 0..100 {
            assert_eq!(shards.iter().filter(|shard| shard.has(run)).count(), 1, "run {run}");
        }
    }

    #[test]
    fn what_is_no_shard_is_told() {
        for text in ["", "1", "0/3", "4/3", "1/0", "-1/3", "a/b", "1/2/3"] {
            assert!(Shard::parse(text).is_err(), "{text}");
        }
    }
}
