//! Whether rows that are kept come out again: a solver or a measure that has changed since gives other numbers for the same
//! scene, and rows of both would make no one dataset.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::plan::Plan;
use super::row::Row;

/// Rows that are kept for each that is computed again.
const PER_CHECK: usize = 100;
/// Most rows that are computed again.
const MOST: usize = 5;

/// A row that comes out otherwise now.
#[derive(Clone, Debug, PartialEq)]
pub struct Changed {
    /// As it is kept.
    pub kept: Row,
    /// As it comes out now.
    pub now: Row,
}

/// Computes some of the rows again, one at least and of every hundred one up to five, evenly spread by their numbers; the first that
/// differs by a bit.
pub fn changed(plan: &Plan, kept: &BTreeMap<usize, Row>) -> Option<Changed> {
    let rows: Vec<&Row> = kept.values().collect();
    let count = (rows.len() / PER_CHECK).clamp(1, MOST).min(rows.len());
    let chosen: Vec<&Row> = (0..count).map(|i| rows[(2 * i + 1) * rows.len() / (2 * count)]).collect();
    let differs = |row: &&Row| {
        let now = Row::compute(plan, row.run);
        (!same(row, &now)).then(|| Changed { kept: (*row).clone(), now })
    };
    chosen.par_iter().find_map_first(differs)
}

/// To the last bit; a reason is words, and may be put otherwise.
fn same(a: &Row, b: &Row) -> bool {
    let bits = |row: &Row| row.values.iter().map(|value| value.map(f64::to_bits)).collect::<Vec<_>>();
    a.status == b.status && bits(a) == bits(b)
}

impl Changed {
    /// Difference, as a text.
    pub fn words(&self, plan: &Plan) -> String {
        let (kept, now) = (&self.kept, &self.now);
        if kept.status != now.status {
            return format!("run {} was \"{}\" and is \"{}\" now", kept.run, kept.status.word(), now.status.word());
        }
        let value = |value: Option<f64>| value.map_or("nothing".to_owned(), |value| format!("{value:?}"));
        let pairs = plan.measures.iter().zip(kept.values.iter().zip(&now.values));
        let mut other = pairs.filter(|(_, (was, is))| was.map(f64::to_bits) != is.map(f64::to_bits));
        other.next().map_or_else(String::new, |(measure, (was, is))| {
            format!("{} of run {} was {} and is {} now", measure.name, kept.run, value(*was), value(*is))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::study::sweep::Status;

    fn plan() -> Plan {
        let scene = presets::load("flush-free-hit").expect("ships");
        let texts = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
        let vary = texts(&["girder.deck.mass_kg=1..5:5"]);
        Plan::new(scene, &vary, &texts(&["max_force", "hits"]), Box::new(|_| Ok(()))).expect("a plan")
    }

    #[test]
    fn rows_that_come_out_again_pass_and_a_bit_of_difference_does_not() {
        let plan = plan();
        let mut rows: BTreeMap<usize, Row> = (1..4).map(|run| (run, Row::compute(&plan, run))).collect();
        assert_eq!(changed(&plan, &BTreeMap::new()), None, "nothing is kept");
        assert_eq!(changed(&plan, &rows), None, "the same");
        let middle = rows.get_mut(&2).expect("it");
        let force = middle.values[0].expect("a hit");
        middle.values[0] = Some(f64::from_bits(force.to_bits() + 1));
        let found = changed(&plan, &rows).expect("the middle one is looked at");
        assert!(found.words(&plan).starts_with("max_force of run 2 was "), "{}", found.words(&plan));
        let row = rows.get_mut(&2).expect("it");
        (row.values[0], row.status) = (Some(force), Status::GaveUp);
        let words = changed(&plan, &rows).expect("another end").words(&plan);
        assert_eq!(words, "run 2 was \"gave up\" and is \"complete\" now");
    }
}
