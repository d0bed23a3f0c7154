//! Measured tables and layouts of marks with bytes changed, cut, repeated and overwritten: an answer or a complaint, never a panic.

use std::fmt::Write as _;

use girderbench::identify::{Columns, Given, History, Quantity, SteadyResponse, from_history, from_response};
use girderbench::measure::{Calibration, Finder, Grey, Layout, Poses, Tracker};
use girderbench::motion::oscillator::Shaking;

use crate::support::mutate::{Case, expect_words, many, mutated, other_value};

/// What a field may be made to be.
const HOSTILE: &[&str] = &[
    "1e300",
    "-1e300",
    "1e-300",
    "0",
    "1e400",
    "nan",
    "inf",
    "-",
    "",
    ",",
    ";",
    "\t",
    "\"",
    "\n",
    "\r\n",
    "\0",
    "\u{fffd}",
    "t",
    "t_s",
    "x_mm",
    "x_[",
    "_",
    "f_hz",
    "#",
    "1,5",
    "[[mark]]",
    "body = \"table\"",
    "pixel = []",
    "at_mm = [0.0, 0.0]",
    "fps = 1e-320",
    "from_s = -1e308",
    "mm_per_pixel = 1e-320",
    "= [1e19, -1e19]",
];

/// Values of a layout that may be made to be others.
const NUMBERS: &[&str] = &[
    "0",
    "3",
    "31.5",
    "1e300",
    "-1e300",
    "1e-300",
    "nan",
    "[21, 39]",
    "[79.0, 16]",
    "[0, 0]",
    "[1e300, 1e300]",
    "\"deck\"",
];

/// A decay of 60 rows.
fn table() -> Vec<u8> {
    let mut text = "t_s,x_mm\n".to_owned();
    for n in 0..60 {
        let t = 0.05 * f64::from(n);
        let _ = writeln!(text, "{t:.3},{:.4}", 10.0 * (-0.7 * t).exp() * (15.0 * t).cos() + 0.01 * (7.3 * t * t).sin());
    }
    text.into_bytes()
}

const LAYOUT: &str = "fps = 30.0\nfrom_s = 0.5\npictures = 3\n[[mark]]\nbody = \"table\"\npixel = [20.0, 40.0]\n\
    at_mm = [-10.0, 0.0]\n[[mark]]\nbody = \"table\"\npixel = [80.0, 40.0]\nat_mm = [10.0, 0.0]\n[[mark]]\n\
    body = \"deck\"\npixel = [30.0, 15.0]\n[[mark]]\nbody = \"deck\"\npixel = [70.0, 15.0]\n";

/// The marks of the layout, the deck's moved.
fn picture(moved: f64) -> Grey {
    let marks = [[20.0, 40.0], [80.0, 40.0], [30.0 + moved, 15.0], [70.0 + moved, 15.0]];
    let (width, height) = (100, 60);
    let bright = |n: usize| {
        let at = [(n % width) as f64 + 0.5, (n / width) as f64 + 0.5];
        marks.iter().any(|[x, y]| (x - at[0]).hypot(y - at[1]) < 3.0)
    };
    Grey { width, height, values: (0..width * height).map(|n| if bright(n) { 220.0 } else { 30.0 }).collect() }
}

/// Reads and identifies a table; whether both were done.
fn identified(bytes: &[u8], first: Quantity) -> bool {
    let columns = Columns { first, name: None, unit: None };
    let measured = match columns.read(bytes) {
        Ok(measured) => measured,
        Err(error) => {
            expect_words(&error.to_string());
            return false;
        }
    };
    assert!(measured.at.len() == measured.x.len() && measured.x.len() <= bytes.len(), "no more rows than bytes");
    let (times, x, shaking) = (&measured.at[..], &measured.x[..], &Shaking::Still);
    let found = match first {
        Quantity::Time => from_history(&History { times, x, shaking, scaled: false }, Given::default()),
        Quantity::Frequency => {
            from_response(&SteadyResponse { frequencies: times, amplitudes: x, ground: None }, Given::default())
        }
    };
    match found {
        Ok(found) => {
            let values = [found.frequency.value, found.damping.value];
            assert!(values.iter().all(|value| value.is_finite() && *value > 0.0), "{values:?}");
            true
        }
        Err(error) => {
            expect_words(&error.to_string());
            false
        }
    }
}

/// Reads a layout and measures two pictures by it; whether both were done.
fn measured(text: &str) -> bool {
    let said = |error: &dyn std::fmt::Display| {
        expect_words(&error.to_string());
        false
    };
    let layout = match Layout::parse(text) {
        Ok(layout) => layout,
        Err(error) => return said(&error),
    };
    let mut tracker = match Tracker::start(&layout, Finder { threshold: 120.0, least: 4 }, &picture(0.0)) {
        Ok(tracker) => tracker,
        Err(error) => return said(&error),
    };
    let calibration = match Calibration::of(&layout, tracker.places()) {
        Ok(calibration) => calibration,
        Err(error) => return said(&error),
    };
    let mut poses = Poses::start(&layout, calibration, tracker.places());
    match tracker.follow(&picture(2.0)) {
        Ok(places) => poses.of(places).len() == layout.bodies().len(),
        Err(error) => said(&error),
    }
}

fn survive(cases: u64) {
    let (table, mut done) = (table(), [0; 3]);
    let response =
        String::from_utf8(table.clone()).expect("text").replace("t_s", "f_hz").replace("\n0.000,", "\n0.001,");
    assert!(identified(&table, Quantity::Time) && measured(LAYOUT), "as they are");
    for seed in 0..cases {
        let _case = Case::of("measured", seed);
        done[0] += usize::from(identified(&mutated(&table, HOSTILE, seed), Quantity::Time));
        done[1] += usize::from(identified(&mutated(response.as_bytes(), HOSTILE, seed), Quantity::Frequency));
        let layout = mutated(LAYOUT.as_bytes(), HOSTILE, seed);
        done[2] += usize::from(measured(&String::from_utf8_lossy(&layout)));
        done[2] += usize::from(measured(&other_value(LAYOUT, NUMBERS, seed)));
    }
    assert!(done.iter().all(|done| *done as u64 >= cases / 40), "a change in a number leaves a table: {done:?}");
}

#[test]
fn changes_of_measured_tables_and_layouts_are_read_or_refused() {
    survive(150);
}

#[test]
#[ignore = "hours"]
fn a_million_changes_of_measured_tables_and_layouts_are_read_or_refused() {
    survive(many());
}
