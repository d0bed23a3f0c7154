//! Differences of two runs: per quantity the largest difference, when, and when it first exceeds a tolerance; and the events that differ.

use std::collections::BTreeMap;

use super::read::{EventRow, Trajectory};

/// Difference of one quantity between two runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Its column, such as `deck.x`.
    pub name: String,
    /// Largest |A − B|, in the column's unit.
    pub largest: f64,
    /// Time of the largest difference \[s\].
    pub at: f64,
    /// Largest absolute value in either run, to measure by.
    pub scale: f64,
    /// Time at which the difference first exceeds the tolerance times `scale` \[s\].
    pub parts_at: Option<f64>,
}

/// Differences of two trajectories.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// Instants in both runs, bit for bit the same time; differences are taken at these.
    pub instants: usize,
    /// Instants in one run only.
    pub unmatched: usize,
    /// Quantities in both, in A's order.
    pub differences: Vec<Difference>,
    /// Columns that A alone has.
    pub only_a: Vec<String>,
    /// Columns that B alone has.
    pub only_b: Vec<String>,
}

/// Difference of the events of one contact.
#[derive(Clone, Debug, PartialEq)]
pub enum EventDifference {
    /// Both have the same kinds in the same order; times differ by this at most \[s\].
    Same(f64),
    /// From this one on they differ: what A has, what B has.
    From(Option<EventRow>, Option<EventRow>),
}

/// Compares two trajectories; `within` is relative to the largest value of each quantity.
pub fn compare(a: &Trajectory, b: &Trajectory, within: f64) -> Comparison {
    let (rows, unmatched) = common_rows(&a.t, &b.t);
    let mut out = Comparison { instants: rows.len(), unmatched, ..Comparison::default() };
    for (name, in_a) in &a.columns {
        match column(b, name) {
            Some(in_b) => out.differences.push(difference(name, &a.t, in_a, in_b, &rows, within)),
            None => out.only_a.push(name.clone()),
        }
    }
    out.only_b = b.columns.iter().map(|(name, _)| name).filter(|name| column(a, name).is_none()).cloned().collect();
    out
}

/// Compares the events of every contact that either run has, in order of their names.
pub fn compare_events(a: &[EventRow], b: &[EventRow]) -> Vec<(String, EventDifference)> {
    let mut contacts: BTreeMap<&str, [Vec<&EventRow>; 2]> = BTreeMap::new();
    for (run, events) in [a, b].into_iter().enumerate() {
        for event in events {
            contacts.entry(&event.contact).or_default()[run].push(event);
        }
    }
    contacts.into_iter().map(|(contact, [a, b])| (contact.to_owned(), event_difference(&a, &b))).collect()
}

fn column<'a>(table: &'a Trajectory, name: &str) -> Option<&'a [f64]> {
    table.columns.iter().find(|(have, _)| have == name).map(|(_, values)| values.as_slice())
}

/// Pairs of row numbers at equal times, and how many rows have no partner; both runs are in order of time.
fn common_rows(a: &[f64], b: &[f64]) -> (Vec<(usize, usize)>, usize) {
    let (mut i, mut j, mut rows) = (0, 0, Vec::new());
    while i < a.len() && j < b.len() {
        if a[i] == b[j] {
            rows.push((i, j));
            (i, j) = (i + 1, j + 1);
        } else if a[i] < b[j] {
            i += 1;
        } else {
            j += 1;
        }
    }
    let unmatched = a.len() + b.len() - 2 * rows.len();
    (rows, unmatched)
}

fn difference(name: &str, t: &[f64], a: &[f64], b: &[f64], rows: &[(usize, usize)], within: f64) -> Difference {
    let scale = rows.iter().map(|&(i, j)| a[i].abs().max(b[j].abs())).fold(0.0, f64::max);
    let mut out = Difference { name: name.to_owned(), largest: 0.0, at: 0.0, scale, parts_at: None };
    for &(i, j) in rows {
        let apart = (a[i] - b[j]).abs();
        if apart > out.largest {
            (out.largest, out.at) = (apart, t[i]);
        }
        if apart > within * scale && out.parts_at.is_none() {
            out.parts_at = Some(t[i]);
        }
    }
    out
}

fn event_difference(a: &[&EventRow], b: &[&EventRow]) -> EventDifference {
    let same = a.iter().zip(b).take_while(|(a, b)| a.kind == b.kind);
    let (count, apart) = same.fold((0, 0.0_f64), |(n, apart), (a, b)| (n + 1, apart.max((a.t - b.t).abs())));
    match (a.get(count), b.get(count)) {
        (None, None) => EventDifference::Same(apart),
        (a, b) => EventDifference::From(a.map(|&e| e.clone()), b.map(|&e| e.clone())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(t: &[f64], x: &[f64]) -> Trajectory {
        Trajectory { t: t.to_vec(), columns: vec![("deck.x".into(), x.to_vec())] }
    }

    fn event(t: f64, kind: &str) -> EventRow {
        EventRow { t, contact: "deck+x|wall".into(), kind: kind.into() }
    }

    #[test]
    fn the_largest_difference_and_the_parting_are_found() {
        let a = table(&[0.0, 0.1, 0.2, 0.3], &[0.0, 1.0, 2.0, 1.0]);
        let b = table(&[0.0, 0.1, 0.2, 0.3], &[0.0, 1.0 + 1e-9, 2.5, 1.25]);
        let out = compare(&a, &b, 1e-6);
        let d = &out.differences[0];
        assert_eq!((d.largest, d.at, d.parts_at), (0.5, 0.2, Some(0.2)), "1e-9 of 2.5 is within 1e-6");
    }

    #[test]
    fn rows_are_matched_by_time() {
        let a = table(&[0.0, 0.1, 0.2], &[0.0, 1.0, 2.0]);
        let b = table(&[0.0, 0.2, 0.4], &[0.0, 2.0, 9.0]);
        let out = compare(&a, &b, 0.0);
        assert_eq!((out.instants, out.unmatched), (2, 2), "0 and 0.2 are in both");
        assert_eq!(out.differences[0].largest, 0.0, "equal where both are");
    }

    #[test]
    fn events_part_at_the_first_other_kind() {
        let a = [event(0.5, "open->stick"), event(1.0, "stick->slip"), event(1.5, "->open")];
        let b = [event(0.5, "open->stick"), event(1.5, "->open")];
        let out = compare_events(&a, &b);
        assert_eq!(out[0].1, EventDifference::From(Some(a[1].clone()), Some(b[1].clone())), "the second one");
        let shifted = a.clone().map(|e| EventRow { t: e.t + 0.25, ..e });
        assert_eq!(compare_events(&a, &shifted)[0].1, EventDifference::Same(0.25), "same kinds, other times");
    }
}
