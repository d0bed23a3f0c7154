//! `contacts.csv`: every closed contact, at each sample and at every event and force peak.
//!
//! A touch of the model girder lasts about 10 ms, one sample at the usual rate, so the samples alone would miss what
//! matters: events and peaks have rows of their own, and `why` tells which instant a row is.

use std::io::Write;

use super::events::law_of;
use super::{number, sample_times, to_csv, xyz, xyz_header};
use crate::sim::{ContactNow, History};

/// The table. At an event, a row shows the contact just after it; a contact that has just opened has no row.
///
/// `point` is the node, `anchor` the point of the face that holds it, `normal` points out of the face; forces \[N\]:
/// `normal_force` is `N(δ)`, `friction` the tangential spring or friction, the dashpots apart, `force` the sum of all,
/// on the node's body.
///
/// # Errors
///
/// Those of the writer.
pub fn contacts(history: &History, sample_hz: f64, out: &mut dyn Write) -> std::io::Result<()> {
    let rows = instants(history, sample_hz).flat_map(|(t, why)| {
        let closed = history.contacts().at(t);
        closed.into_iter().map(move |contact| row(history, t, why, &contact)).collect::<Vec<_>>()
    });
    to_csv(&header(), rows, out)
}

/// Estimated number of cells: of each touch its duration times `sample_hz`, the run's events and force peaks within it, one row more.
pub fn contact_cells(history: &History, sample_hz: f64) -> f64 {
    let special = special_instants(history);
    let until = |t: f64| special.partition_point(|(instant, _)| *instant <= t);
    let rows = history.hits().touches().iter().map(|touch| {
        (touch.end - touch.start) * sample_hz + (until(touch.end).saturating_sub(until(touch.start)) + 1) as f64
    });
    rows.sum::<f64>() * header().len() as f64
}

/// Events and force peaks in order of time, each instant once; an event's name wins over a peak's.
fn special_instants(history: &History) -> Vec<(f64, &'static str)> {
    let events = history.events().iter().map(|event| (event.t, "event"));
    let peaks = history.hits().touches().iter().map(|touch| (touch.peak_time, "peak"));
    let mut special: Vec<_> = events.chain(peaks).collect();
    // Stable, so that the first of equals is the one named first above.
    special.sort_by(|a, b| a.0.total_cmp(&b.0));
    special.dedup_by(|later, kept| later.0 == kept.0);
    special
}

/// Events, force peaks and samples in order of time, each instant once; an event or peak replaces a sample at its time.
fn instants(history: &History, sample_hz: f64) -> impl Iterator<Item = (f64, &'static str)> {
    let mut special = special_instants(history).into_iter().peekable();
    let mut samples = sample_times(history.end(), sample_hz).map(|t| (t, "sample")).peekable();
    std::iter::from_fn(move || {
        let Some(next) = special.peek().copied() else { return samples.next() };
        samples.next_if(|sample| sample.0 < next.0).or_else(|| {
            samples.next_if(|sample| sample.0 == next.0);
            special.next()
        })
    })
}

fn header() -> Vec<String> {
    let names = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
    [
        names(&["t", "why", "pair", "node", "face", "state"]),
        xyz_header("point").into(),
        xyz_header("anchor").into(),
        xyz_header("normal").into(),
        names(&["penetration", "normal_velocity"]),
        xyz_header("sliding").into(),
        names(&["normal_force"]),
        xyz_header("friction").into(),
        names(&["normal_dashpot"]),
        xyz_header("tangential_dashpot").into(),
        xyz_header("force").into(),
        names(&["law"]),
    ]
    .concat()
}

fn row(history: &History, t: f64, why: &str, contact: &ContactNow) -> Vec<String> {
    let model = history.model();
    let (pair, site) = (&model.pairs[contact.pair], &model.sites[contact.contact]);
    let state = contact.state.label().to_owned();
    [
        vec![number(t), why.to_owned(), pair.name.clone(), site.node.clone(), site.face_name.to_string(), state],
        xyz(contact.point).into(),
        xyz(contact.anchor).into(),
        xyz(contact.normal).into(),
        vec![number(contact.penetration), number(contact.normal_velocity)],
        xyz(contact.sliding).into(),
        vec![number(contact.normal_force)],
        xyz(contact.tangential_force).into(),
        vec![number(contact.normal_damping)],
        xyz(contact.tangential_damping).into(),
        xyz(contact.force).into(),
        vec![law_of(history, contact.pair).to_owned()],
    ]
    .concat()
}
