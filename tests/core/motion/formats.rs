//! Every format of records against our own files, made by a stated formula, and against real ones where they lie.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

use girderbench::motion::format::{self, Channel, FORMATS, Orientation, Record, RecordError, Supplement, Unit};

/// Our own files with their format.
pub(super) const FIXTURES: &[(&str, &str)] = &[
    ("old.AT2", "PEER AT2"),
    ("nga.AT2", "PEER AT2"),
    ("numbers-first.AT2", "PEER AT2"),
    ("knet.EW", "K-NET ASCII"),
    ("cosmos.V2c", "COSMOS"),
    ("csmip.V2", "CSMIP Volume 2"),
    ("one-column.dat", "one column"),
    ("two-columns.csv", "CSV"),
];

pub(super) fn fixture(name: &str) -> Vec<u8> {
    std::fs::read(Path::new("tests/data/records").join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

pub(super) fn read(bytes: &[u8], name: &str) -> Result<Record, RecordError> {
    format::read(bytes, Path::new(name), &Supplement::default())
}

fn channels(name: &str) -> Vec<Channel> {
    read(&fixture(name), name).unwrap_or_else(|error| panic!("{name}: {error}")).channels
}

/// The stated formula \[m/s²\].
fn decaying([amplitude, phase]: [f64; 2], t: f64) -> f64 {
    amplitude * (TAU * 2.5 * t + phase).sin() * (-1.5 * t).exp()
}

/// Holds a channel against the formula: amplitude and phase, interval, count, and what the digits leave open \[m/s²\].
#[track_caller]
fn expect(channel: &Channel, shape: [f64; 2], (dt, count): (f64, usize), open: f64, offset: f64) {
    assert_eq!((channel.dt, channel.samples.len()), (dt, count), "{}: interval and count", channel.name);
    for (n, sample) in channel.samples.iter().enumerate() {
        let expected = decaying(shape, n as f64 * dt) - offset;
        assert!((sample - expected).abs() <= open, "{} sample {n}: {sample}, not {expected}", channel.name);
    }
}

#[test]
fn contents_tell_every_format_under_any_name() {
    for (name, format) in FIXTURES {
        for called in [name, "quake.txt", "quake", "a/quake.csv", "quake.at2"] {
            assert_eq!(read(&fixture(name), called).map(|record| record.format), Ok(*format), "{name} as {called}");
        }
    }
    for format in FORMATS {
        assert!(FIXTURES.iter().any(|(_, name)| *name == format.name), "a file in {}", format.name);
    }
}

#[test]
fn our_own_files_hold_the_formula_they_were_made_by() {
    for (name, orientation) in [
        ("old.AT2", Orientation::Azimuth(270.0)),
        ("nga.AT2", Orientation::Up),
        ("numbers-first.AT2", Orientation::Azimuth(90.0)),
    ] {
        let [channel] = &channels(name)[..] else { panic!("{name}: one channel") };
        // Half a unit of the seventh digit of 0.1 g.
        expect(channel, [1.5, 0.0], (0.01, 64), 5e-7, 0.0);
        assert_eq!((channel.orientation, channel.unit), (orientation, Unit::G), "{name}");
    }
    let [knet] = &channels("knet.EW")[..] else { panic!("one channel") };
    let mean = (0..100).map(|n| decaying([1.5, 0.0], f64::from(n) * 0.01)).sum::<f64>() / 100.0;
    // Half a count.
    expect(knet, [1.5, 0.0], (0.01, 100), 2e-6, mean);
    assert_eq!(knet.orientation, Orientation::Azimuth(90.0), "east");
    assert!(knet.done.iter().any(|done| done.to_string().starts_with("mean of ")), "{:?}", knet.done);
    let cosmos = channels("cosmos.V2c");
    assert_eq!(cosmos.len(), 2, "two channels");
    expect(&cosmos[0], [1.5, 0.0], (0.005, 200), 6e-8, 0.0);
    expect(&cosmos[1], [1.5, 1.0], (0.005, 200), 6e-8, 0.0);
    assert_eq!(cosmos[0].orientation, Orientation::Azimuth(340.0), "as the text header states");
    let csmip = channels("csmip.V2");
    for (channel, shape) in csmip.iter().zip([[1.5, 0.0], [0.75, 0.5], [1.2, 1.0]]) {
        expect(channel, shape, (0.005, 100), 1e-6, 0.0);
    }
    let directions: Vec<_> = csmip.iter().map(|channel| channel.orientation).collect();
    assert_eq!(directions, [Orientation::Azimuth(0.0), Orientation::Up, Orientation::Azimuth(90.0)], "three channels");
    expect(&channels("one-column.dat")[0], [1.5, 0.0], (0.01, 64), 6e-8, 0.0);
    let csv = &channels("two-columns.csv")[0];
    assert!((csv.dt - 0.01).abs() < 1e-15, "from the times: {}", csv.dt);
}

#[test]
fn a_channel_of_several_is_chosen_and_never_guessed() {
    let record = read(&fixture("csmip.V2"), "csmip.V2").expect("a record");
    assert_eq!(record.channel(Some(2)).map(|channel| channel.orientation), Ok(Orientation::Up), "by its number");
    for wrong in [None, Some(0), Some(4), Some(usize::MAX)] {
        let said = record.channel(wrong).expect_err("none of them");
        assert!(said.to_string().contains("1 (Chan  1: 360 Deg), 2 (Chan  2:  Up), 3 (Chan  3:  90 Deg)"), "{said}");
    }
}

#[test]
fn a_file_that_is_cut_off_anywhere_in_its_numbers_is_refused_with_its_line() {
    for (name, format) in FIXTURES {
        let whole = fixture(name);
        if matches!(*format, "CSV" | "one column") {
            // Neither states its count.
            continue;
        }
        for part in [30, 45, 70, 90] {
            let cut = whole.len() * part / 100;
            let error = read(&whole[..cut], name).expect_err("cut off");
            let lines = u64::try_from(whole[..cut].split(|byte| *byte == b'\n').count()).expect("few");
            assert!(error.line <= lines && error.line > 0, "{name} cut to {part} %: {error}");
            assert!(!error.remedy.to_string().is_empty(), "{name} cut to {part} %: {error}");
        }
    }
}

#[test]
fn what_is_stated_in_the_file_is_not_stated_beside_it() {
    for (name, format) in FIXTURES {
        for beside in [Supplement { dt: Some(0.5), unit: None }, Supplement { dt: None, unit: Some(Unit::G) }] {
            let error = format::read(&fixture(name), Path::new(name), &beside).expect_err("twice").to_string();
            let key = if beside.dt.is_some() { "dt_s" } else { "unit" };
            assert!(error.contains(key), "{format}: {error}");
        }
    }
}

/// The real records, where they lie beside the project or beside its work trees.
#[expect(clippy::print_stdout, reason = "a skipped test prints that it is")]
pub(super) fn real(name: &str) -> Option<Vec<u8>> {
    let path = PathBuf::from("../shared/records").join(name);
    let path = if path.exists() { path } else { PathBuf::from("../../shared/records").join(name) };
    let bytes = std::fs::read(&path).ok();
    if bytes.is_none() {
        println!("skipped: the real record {name} is not there");
    }
    bytes
}

#[test]
#[expect(clippy::print_stdout, reason = "a skipped test prints that it is")]
fn real_records_have_the_peaks_that_their_headers_state() {
    // File, channel, peak [m/s²] as its header or its source states it, when [s], count, to so many m/s².
    const G: f64 = 9.80665;
    let known: &[(&str, usize, f64, f64, usize, f64)] = &[
        ("I-ELC270.AT2", 1, -0.214_756_5 * G, 11.48, 4000, 1e-12),
        ("I-ELC180.AT2", 1, -0.312_880_6 * G, 2.15, 4000, 1e-12),
        ("RSN6_IMPVALL.I_I-ELC270-hor2.AT2", 1, -0.210_743 * G, 11.51, 5346, 1e-12),
        ("RSN6_IMPVALL.I_I-ELC180-hor1.AT2", 1, -0.280_795_5 * G, 2.18, 5372, 1e-12),
        ("RSN6_IMPVALL.I_I-ELC-UP.AT2", 1, -0.178_136_7 * G, 3.37, 5378, 1e-12),
        ("AOM0011801241951.EW", 1, 0.040_78, f64::NAN, 10_200, 6e-6),
        ("AOM0011801241951.NS", 1, 0.049_54, f64::NAN, 10_200, 6e-6),
        ("AOM0011801241951.UD", 1, 0.022_40, f64::NAN, 10_200, 6e-6),
        ("AKBMR.BNZ.acc.V2c", 1, -0.068_515_12, 76.215, 42_000, 1e-8),
        ("CE89146.V2", 1, 0.772_80, 30.585, 12_000, 6e-6),
        ("CE89146.V2", 2, 0.205_29, 30.585, 12_000, 6e-6),
        ("CE89146.V2", 3, -0.442_00, 30.575, 12_000, 6e-6),
    ];
    for &(name, number, peak, at, count, open) in known {
        let Some(bytes) = real(name) else { continue };
        let record = read(&bytes, name).unwrap_or_else(|error| panic!("{name}: {error}"));
        let channel = record.channel(Some(number)).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (found, when) = channel.peak();
        // K-NET's header states the magnitude alone.
        let apart = if at.is_nan() { found.abs() - peak } else { found - peak };
        assert!(apart.abs() <= open, "{name} channel {number}: {found} m/s², not {peak}");
        assert!(at.is_nan() || (when - at).abs() < 1e-9, "{name} channel {number}: at {when} s, not {at}");
        assert_eq!(channel.samples.len(), count, "{name} channel {number}");
        println!("{name} channel {number}: {found:.6} m/s² at {when:.3} s, {:?}", channel.orientation);
    }
    if let Some(cut) = real("Cosmos12TimeSeriesTest.v1.head120") {
        let error = read(&cut, "cut.v1").expect_err("its first 120 lines only").to_string();
        assert!(error.contains("line 120") && error.contains("of 7000"), "{error}");
    }
}
