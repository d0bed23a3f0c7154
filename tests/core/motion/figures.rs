//! Figures and spectra of real records against what their sources state, where they lie.

use girderbench::motion::integrate::{Peak, integrate};
use girderbench::motion::spectrum::{periods, spectrum};

use super::formats::{read, real};

#[test]
fn peer_records_have_the_velocities_and_displacements_that_peer_states() {
    // PGV [m/s] and PGD [m], four digits: integrated from rest, straight lines between samples.
    let known = [
        ("I-ELC270.AT2", 0.2965, 0.2206),
        ("I-ELC180.AT2", 0.2968, 0.1303),
        ("RSN6_IMPVALL.I_I-ELC270-hor2.AT2", 0.3131, 0.2415),
        ("RSN6_IMPVALL.I_I-ELC180-hor1.AT2", 0.3093, 0.0866),
        ("RSN6_IMPVALL.I_I-ELC-UP.AT2", 0.0861, 0.0267),
    ];
    for (name, pgv, pgd) in known {
        let Some(bytes) = real(name) else { continue };
        let channel = read(&bytes, name).expect("a record").channels.remove(0);
        let [v, d] = integrate(&channel.samples, channel.dt);
        let [v, d] = [v, d].map(|series| Peak::of(&series, channel.dt).value.abs());
        assert!((v - pgv).abs() < 6e-5 && (d - pgd).abs() < 6e-5, "{name}: PGV {v}, PGD {d}");
    }
}

#[test]
fn volume_two_states_the_same_velocity_and_displacement() {
    let Some(bytes) = real("CE89146.V2") else { return };
    let record = read(&bytes, "CE89146.V2").expect("a record");
    for (number, pgv, pgd) in [(1, 0.031_50, 0.001_65), (2, 0.009_84, 0.000_78), (3, 0.027_83, 0.003_34)] {
        let channel = record.channel(Some(number)).expect("three channels");
        let [v, d] = integrate(&channel.samples, channel.dt);
        let [v, d] = [v, d].map(|series| Peak::of(&series, channel.dt).value.abs());
        // Within a percent: the network integrated with finer samples and filtered.
        assert!((v / pgv - 1.0).abs() < 0.01, "channel {number}: PGV {v}, not {pgv}");
        assert!((d / pgd - 1.0).abs() < 0.01, "channel {number}: PGD {d}, not {pgd}");
    }
}

#[test]
fn a_spectrum_begins_at_the_peak_of_the_ground() {
    let Some(bytes) = real("RSN6_IMPVALL.I_I-ELC180-hor1.AT2") else { return };
    let channel = read(&bytes, "e.AT2").expect("a record").channels.remove(0);
    let spectrum = spectrum(&channel.samples, channel.dt, &periods([0.02, 10.0], 50), 0.05);
    let ratio = spectrum[0].pseudo_acceleration() / channel.peak().0.abs();
    assert!((ratio - 1.0).abs() < 0.03, "of a stiff oscillator: {ratio}");
    let [_, d] = integrate(&channel.samples, channel.dt);
    let long = spectrum[49].displacement / Peak::of(&d, channel.dt).value.abs();
    assert!((0.5..2.0).contains(&long), "of a soft one, of the order of PGD: {long}");
}
