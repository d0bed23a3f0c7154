//! Records with bytes changed, cut, repeated and overwritten by hostile words: a record or a complaint, never a panic, and
//! never more memory than the file has room for.

use super::formats::{FIXTURES, fixture, read};
use crate::support::mutate::{Case, many, mutated};

/// Words put into a header or between numbers.
const HOSTILE: &[&str] = &[
    "1e18",
    "NaN",
    "inf",
    "-1",
    "0",
    "99999999999999999999999",
    "NPTS=1e18",
    "DT=0",
    "DT=1e-300",
    "(999999F1)",
    "(8F0)",
    "%s%n",
    "\0",
    "\u{fffd}",
    "1e400",
    "-",
    ".",
    "=",
    "(",
    "/",
    "|",
    "units=",
    "approx",
    "/&",
    "points of accel data equally spaced",
    "End-of-data",
    "with 1e18 text lines",
    "Hz",
    "3920(gal)/0",
    "\r\n\r\n",
    "\n\n\n",
    "\t,;",
    "١٢٣",
];

/// So many cases of every file; how many were read all the same.
fn survive(cases: u64) {
    for (name, format) in FIXTURES {
        let whole = fixture(name);
        let mut read_all_the_same = 0;
        for seed in 0..cases {
            let _case = Case::of(name, seed);
            let bytes = mutated(&whole, HOSTILE, seed);
            match read(&bytes, name) {
                Ok(record) => {
                    read_all_the_same += 1;
                    for channel in &record.channels {
                        assert!(channel.dt > 0.0 && channel.dt.is_finite(), "{name} {seed}: interval {}", channel.dt);
                        assert!(channel.samples.len() >= 2, "{name} {seed}: samples");
                        assert!(channel.samples.iter().all(|a| a.is_finite()), "{name} {seed}: a number that is none");
                        assert!(
                            channel.samples.capacity() <= 2 * bytes.len() + 64,
                            "{name} {seed}: more room than file"
                        );
                    }
                }
                Err(error) => {
                    let lines = bytes.split(|byte| *byte == b'\n').count() + 1;
                    let line = usize::try_from(error.line).expect("small");
                    assert!((1..=lines).contains(&line), "{name} {seed}: {error}");
                    assert!(
                        error.value.to_string().chars().count() < 120 && !error.remedy.to_string().is_empty(),
                        "{name} {seed}: {error}"
                    );
                }
            }
        }
        assert!(read_all_the_same > 0, "{format}: a change in a sample leaves a record");
    }
}

#[test]
fn three_hundred_changes_of_every_file_are_read_or_refused() {
    survive(300);
}

#[test]
fn a_stray_quote_that_swallows_a_table_is_shown_cut() {
    let mut bytes = fixture("two-columns.csv");
    let at = bytes.iter().position(|byte| *byte == b'\n').expect("lines") + 1;
    bytes.insert(at, b'"');
    let error = read(&bytes, "two-columns.csv").expect_err("no table");
    assert!(error.value.to_string().chars().count() < 120, "{error}");
}

#[test]
#[ignore = "minutes"]
fn a_million_changes_of_every_file_are_read_or_refused() {
    survive(many());
}

#[test]
fn ten_million_samples_are_read_in_bounded_memory() {
    let count = 10_000_000;
    let mut text = format!("A\nB, 90\nACCELERATION IN UNITS OF G\nNPTS= {count}, DT= .01\n");
    text.push_str(&".1 -.2 .3 0 1\n".repeat(count / 5));
    let record = read(text.as_bytes(), "long.AT2").expect("a long record");
    let samples = &record.channels[0].samples;
    assert_eq!(samples.len(), count, "all of them");
    assert!(samples.capacity() <= 2 * count, "and no more room than twice that");
}
