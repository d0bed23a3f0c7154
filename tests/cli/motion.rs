//! `girderbench motion`: the figures that it prints of a record, and the files that it writes.

use crate::program::call;

const RECORDS: &str = "tests/data/records";

#[test]
fn every_channel_is_printed_with_its_unit_peak_and_duration() {
    let said = call(&["motion", &format!("{RECORDS}/csmip.V2"), &format!("{RECORDS}/old.AT2")]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    for words in [
        "csmip.V2: CSMIP Volume 2, 3 channels",
        "channel 2: Chan  2:  Up, upwards",
        "read in gal: 100 samples, 0.005 s apart, 0.495 s",
        "old.AT2: PEER AT2, 1 channel",
        "azimuth 270°",
        "peak 0.131996 g = 129.444 gal at 0.09 s",
        "integrated from rest",
        "5 to 95 % of the Arias intensity",
        "done to it: converted from g by the factor 9.80665 m/s²",
    ] {
        assert!(said.out.contains(words), "{words}: {}", said.out);
    }
}

#[test]
fn plots_and_tables_of_one_channel_are_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a UTF-8 path");
    let said = call(&["motion", &format!("{RECORDS}/csmip.V2"), "--channel", "2", "--out", out]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect(name);
    assert_eq!(read("csmip.V2-2-history.csv").lines().count(), 101, "heading and samples");
    assert_eq!(read("csmip.V2-2-spectrum.csv").lines().count(), 407, "heading and periods");
    for name in ["csmip.V2-2-history.svg", "csmip.V2-2-spectrum.svg"] {
        assert!(read(name).ends_with("</svg>\n"), "{name}");
    }
}

#[test]
fn an_unreadable_file_is_refused_with_place_and_remedy() {
    let folder = tempfile::tempdir().expect("a folder");
    let bare = folder.path().join("bare.acc");
    std::fs::write(&bare, "1\n2\n1\n").expect("written");
    let bare = bare.to_str().expect("a UTF-8 path");
    let csmip = format!("{RECORDS}/csmip.V2");
    for (flags, word) in [
        (vec!["nowhere.AT2"], "nowhere.AT2"),
        (vec!["Cargo.toml"], "PEER AT2 (.at2)"),
        (vec![bare], "dt_s"),
        (vec![bare, "--dt", "0.01"], "unit"),
        (vec![bare, "--dt", "0.01", "--unit", "feet"], "--unit"),
        (vec![&csmip, "--channel", "4"], "--channel 4: give channel, one of: 1 (Chan  1: 360 Deg)"),
        (vec![], "FILE"),
    ] {
        let said = call(&[&["motion"], flags.as_slice()].concat());
        assert!(said.status == Some(2) && said.err.contains(word), "{flags:?}: {}", said.err);
    }
    let said = call(&["motion", bare, "--dt", "0.01", "--unit", "cm/s2"]);
    assert!(said.status == Some(0) && said.out.contains("= 2 gal at 0.01 s"), "{}{}", said.out, said.err);
}

#[test]
fn what_is_done_to_a_record_is_printed() {
    let file = format!("{RECORDS}/old.AT2");
    let said =
        call(&["motion", &file, "--baseline", "mean", "--taper", "0.1", "--time-scale", "0.5", "--peak-g", "0.4"]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    for words in
        ["0.005 s apart", "peak -0.4 g", "baseline: mean removed; tapered over 0.1 s at both ends; time scaled by 0.5"]
    {
        assert!(said.out.contains(words), "{words}: {}", said.out);
    }
    let doubled = call(&["motion", &file, "--peak-g", "0.4", "--scale", "-2"]);
    assert!(doubled.out.contains("peak -0.8 g"), "{}{}", doubled.out, doubled.err);
    for (flags, word) in [
        (["--taper", "1"], "--taper 1: both tapers must fit"),
        (["--from", "5"], "--from 5: the cut must leave"),
        (["--baseline", "cubic"], "berg-housner"),
        (["--pad", "1e12"], "--pad"),
        (["--time-scale", "0"], "--time-scale"),
    ] {
        let said = call(&[&["motion", file.as_str()], flags.as_slice()].concat());
        assert!(said.status == Some(2) && said.err.contains(word), "{flags:?}: {}", said.err);
    }
}
