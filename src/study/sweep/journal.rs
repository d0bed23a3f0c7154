//! The journal of a sweep: a line for each run that has come out, written when it has.
//!
//! A line is `CHECKSUM TAB RUN TAB STATUS TAB VALUE … TAB REASON`; the checksum (XXH3) is of the rest of the line behind the
//! identity of the sweep. What a process that was killed left of a line, and a line that was damaged, has no such
//! checksum: its run counts as not computed. The order of lines means nothing.

use std::collections::BTreeMap;

use xxhash_rust::xxh3::Xxh3;

use super::plan::Plan;
use super::row::{Row, Status};

/// Mark of a missing value.
const NONE: &str = "-";

/// Identity of a sweep: the same scene, records, keys, values, measures and version of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Identity(pub u64);

impl Identity {
    /// The first line of a journal.
    pub fn heading(self) -> String {
        format!("girderbench sweep journal, {:016x}\n", self.0)
    }

    fn checksum(self, rest: &str) -> u64 {
        let mut hash = Xxh3::new();
        hash.update(&self.0.to_le_bytes());
        hash.update(rest.as_bytes());
        hash.digest()
    }

    /// The line of a row.
    pub fn line(self, row: &Row) -> String {
        let mut cells = vec![row.run.to_string(), row.status.word().to_owned()];
        cells.extend(row.values.iter().map(|value| value.map_or(NONE.to_owned(), |value| format!("{value:?}"))));
        cells.push(row.reason.replace(['\t', '\r', '\n'], " "));
        let rest = cells.join("\t");
        format!("{:016x}\t{rest}\n", self.checksum(&rest))
    }

    /// The row of a line without its end; none where the line is not whole, or not of this sweep.
    fn row(self, line: &str, plan: &Plan) -> Option<Row> {
        let (checksum, rest) = line.split_once('\t')?;
        if u64::from_str_radix(checksum, 16).ok()? != self.checksum(rest) {
            return None;
        }
        let mut cells = rest.split('\t');
        let (run, status) = (cells.next()?.parse().ok()?, Status::of_word(cells.next()?)?);
        let mut value = || match cells.next()? {
            NONE => Some(None),
            number => Some(Some(number.parse().ok()?)),
        };
        let values = plan.measures.iter().map(|_| value()).collect::<Option<_>>()?;
        let reason = cells.next()?.to_owned();
        (run < plan.runs() && cells.next().is_none()).then_some(Row { run, status, values, reason })
    }
}

/// Contents of a journal.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contents {
    /// The rows by the numbers of their runs.
    pub rows: BTreeMap<usize, Row>,
    /// Bytes up to the end of the last line that has one: what is written next belongs there.
    pub whole: usize,
    /// Lines that are damaged.
    pub damaged: usize,
}

/// A journal of another sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OfAnother;

/// Reads a journal; an empty one, or one whose heading was not finished, holds nothing.
///
/// # Errors
/// The journal of another sweep, or none at all.
pub fn read(bytes: &[u8], identity: Identity, plan: &Plan) -> Result<Contents, OfAnother> {
    let heading = identity.heading();
    let Some(lines) = bytes.strip_prefix(heading.as_bytes()) else {
        return if heading.as_bytes().starts_with(bytes) { Ok(Contents::default()) } else { Err(OfAnother) };
    };
    let whole = lines.iter().rposition(|&byte| byte == b'\n').map_or(0, |last| last + 1);
    let mut contents = Contents { whole: heading.len() + whole, ..Contents::default() };
    for line in lines[..whole].split_inclusive(|&byte| byte == b'\n') {
        let text = std::str::from_utf8(&line[..line.len() - 1]).ok();
        match text.and_then(|text| identity.row(text, plan)) {
            Some(row) => drop(contents.rows.insert(row.run, row)),
            None => contents.damaged += 1,
        }
    }
    Ok(contents)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    const ID: Identity = Identity(0x1234_5678_9abc_def0);

    fn plan() -> Plan {
        let scene = presets::load("skew45-abutment").expect("ships");
        let texts = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
        let vary = texts(&["motion.angle_deg=0..90:4"]);
        Plan::new(scene, &vary, &texts(&["max_rotation", "hits"]), Box::new(|_| Ok(()))).expect("a plan")
    }

    fn rows() -> [Row; 3] {
        let row = |run, status, values: [Option<f64>; 2], reason: &str| Row {
            run,
            status,
            values: values.to_vec(),
            reason: reason.to_owned(),
        };
        [
            row(2, Status::Complete, [Some(0.1 + 0.2), Some(-1e-300)], ""),
            row(0, Status::GaveUp, [None, None], "at 0.25 s, deck: the step fell to 1e-20 s"),
            row(3, Status::Refused, [None, Some(28.0)], "接触\u{7f}"),
        ]
    }

    fn journal() -> Vec<u8> {
        let lines: String = rows().iter().map(|row| ID.line(row)).collect();
        (ID.heading() + &lines).into_bytes()
    }

    #[test]
    fn rows_come_back_to_the_last_bit() {
        let contents = read(&journal(), ID, &plan()).expect("its own");
        let wanted: BTreeMap<usize, Row> = rows().into_iter().map(|row| (row.run, row)).collect();
        assert_eq!(contents, Contents { rows: wanted, whole: journal().len(), damaged: 0 }, "all of it");
    }

    #[test]
    fn cut_anywhere_it_holds_the_whole_lines_before() {
        let (whole, plan) = (journal(), plan());
        for end in 0..whole.len() {
            let contents = read(&whole[..end], ID, &plan).expect("its own");
            let lines = whole[..end].split(|&byte| byte == b'\n').count() - 1;
            assert_eq!((contents.rows.len(), contents.damaged), (lines.saturating_sub(1), 0), "cut at {end}");
            assert!(whole[..contents.whole].last().is_none_or(|&byte| byte == b'\n'), "goes on after a whole line");
        }
    }

    #[test]
    fn a_damaged_line_is_lost_alone() {
        let (whole, plan) = (journal(), plan());
        for at in ID.heading().len()..whole.len() {
            let mut bytes = whole.clone();
            bytes[at] ^= 0x04;
            let contents = read(&bytes, ID, &plan).expect("its own");
            let kept = rows().into_iter().filter(|row| contents.rows.get(&row.run) == Some(row)).count();
            assert_eq!(kept, contents.rows.len(), "byte {at}: nothing but what was written");
            assert!((1..=2).contains(&kept), "byte {at}: the others stay: {kept}");
        }
    }

    #[test]
    fn another_sweeps_journal_is_refused() {
        for other in [Identity(7).heading().into_bytes(), b"notes\n".to_vec(), vec![0xff; 100]] {
            assert_eq!(read(&other, ID, &plan()), Err(OfAnother), "{other:?}");
        }
    }
}
