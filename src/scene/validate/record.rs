//! A record of ground motion: where its samples are, what is done to them, how its components fit together.

use super::complaints::{At, Complaints, number};
use crate::language::{Text, message};
use crate::motion::format::Record;
use crate::scene::keys::{self, Range};
use crate::scene::{Component, Heading, Kind, RecordMotion};

/// Intervals of two components may differ by this part: rounding of printed times.
const ROUNDING: f64 = 1e-9;

pub(super) fn record(place: &str, record: &RecordMotion, kind: Kind, complaints: &mut Complaints) {
    let at = &mut complaints.at(place, keys::RECORD);
    at.number("scale", record.scale);
    at.number("vertical_scale", record.vertical_scale);
    if let Some(key) = keys::find(keys::RECORD, "vertical_scale") {
        at.fits_key(key, record.vertical_scale, kind);
    }
    at.number("angle_deg", record.angle_deg);
    at.if_given("x_azimuth_deg", record.x_azimuth_deg);
    at.if_given("dt_s", record.dt);
    if record.components.is_empty() {
        one_component(record, at);
    } else {
        several(record, kind, at);
    }
    processing(place, record, complaints);
}

/// Samples, and the keys that describe them.
struct Source<'a> {
    samples: Option<&'a Vec<f64>>,
    dt: Option<f64>,
    file: Option<&'a String>,
    channel: Option<usize>,
    has_unit: bool,
    loaded: Option<&'a Record>,
}

fn one_component(record: &RecordMotion, at: &mut At<'_>) {
    if let Some(azimuth) = record.x_azimuth_deg {
        at.add("x_azimuth_deg", number(azimuth), Text::new("wrong-azimuth-of-one"));
    }
    let source = Source {
        samples: record.samples.as_ref(),
        dt: record.dt,
        file: record.file.as_ref(),
        channel: record.channel,
        has_unit: record.unit.is_some(),
        loaded: record.loaded.as_deref(),
    };
    samples_or_file(&source, at);
}

fn samples_or_file(source: &Source<'_>, at: &mut At<'_>) {
    match (source.samples, source.file) {
        (None, None) => at.add("samples_m_s2", Text::new("found-nothing"), Text::new("wrong-no-record")),
        (Some(_), Some(_)) => at.add(
            "samples_m_s2",
            message!("found-both", "one" => "samples_m_s2", "other" => "file"),
            Text::new("wrong-both"),
        ),
        (Some(list), None) => {
            if source.dt.is_none() {
                at.add("dt_s", Text::new("found-nothing"), Text::new("wrong-no-interval"));
            }
            for (key, given) in [("channel", source.channel.is_some()), ("unit", source.has_unit)] {
                if given {
                    at.add(key, "samples_m_s2", Text::new("wrong-of-a-file"));
                }
            }
            samples("samples_m_s2", list, at);
        }
        (None, Some(file)) => recorded_file(source, file, at),
    }
}

fn recorded_file(source: &Source<'_>, file: &str, at: &mut At<'_>) {
    let Some(loaded) = source.loaded else {
        at.add("file", format!("\"{file}\""), Text::new("wrong-not-loaded"));
        return;
    };
    match loaded.channel(source.channel) {
        Ok(channel) => {
            at.obeys("file", channel.dt, Range::Positive);
            samples("file", &channel.samples, at);
        }
        Err(remedy) => {
            let found = source.channel.map_or_else(|| Text::new("found-nothing").into(), |channel| channel.to_string());
            at.add("channel", found, remedy);
        }
    }
}

fn samples(key: &str, list: &[f64], at: &mut At<'_>) {
    if list.len() < 2 {
        at.add(key, message!("found-samples", "count" => list.len()), Text::new("wrong-too-few-samples"));
    }
    at.each(key, list);
}

/// Several components: nothing of a single one beside them, each of its own direction, all at one interval.
fn several(record: &RecordMotion, kind: Kind, at: &mut At<'_>) {
    let alone = [
        ("samples_m_s2", record.samples.is_some()),
        ("file", record.file.is_some()),
        ("dt_s", record.dt.is_some()),
        ("channel", record.channel.is_some()),
        ("unit", record.unit.is_some()),
        ("angle_deg", record.angle_deg != 0.0),
        ("vertical_scale", record.vertical_scale != 0.0),
    ];
    for (key, _) in alone.into_iter().filter(|(_, given)| *given) {
        at.add(key, Text::new("found-component-beside"), Text::new("wrong-of-one-component"));
    }
    if record.components.len() > 3 {
        at.add("component", record.components.len(), Text::new("wrong-too-many-components"));
    }
    let first = record.component_series(0).map(|(dt, _)| dt);
    for (n, component) in record.components.iter().enumerate() {
        let place = format!("component[{n}]");
        let at = &mut at.below(&place, keys::COMPONENT);
        one_of_several(record, (n, component), kind, at);
        if let (Some(first), Some((dt, _))) = (first, record.component_series(n))
            && (dt - first).abs() > ROUNDING * first
        {
            let remedy = message!("wrong-intervals-differ", "first" => first);
            at.add("dt_s", number(dt), remedy);
        }
    }
}

fn one_of_several(record: &RecordMotion, (n, component): (usize, &Component), kind: Kind, at: &mut At<'_>) {
    at.number("scale", component.scale);
    at.if_given("azimuth_deg", component.azimuth_deg);
    at.if_given("dt_s", component.dt);
    let loaded = record.component_record(n);
    let source = Source {
        samples: component.samples.as_ref(),
        dt: component.dt,
        file: component.file.as_ref(),
        channel: component.channel,
        has_unit: component.unit.is_some(),
        loaded,
    };
    samples_or_file(&source, at);
    let readable = component.file.is_none() || loaded.is_some_and(|loaded| loaded.channel(component.channel).is_ok());
    match record.heading(n) {
        Some(Heading::Up) if kind == Kind::Planar => {
            at.add("vertical", Text::new("found-upward"), Text::new("wrong-upward-in-plan"));
        }
        None if readable && record.x_azimuth_deg.is_none() => {
            at.add("azimuth_deg", Text::new("found-no-azimuth"), Text::new("wrong-no-x-azimuth"));
        }
        None if readable => {
            at.add("azimuth_deg", Text::new("found-nothing"), Text::new("wrong-no-direction"));
        }
        _ => {}
    }
}

fn processing(place: &str, record: &RecordMotion, complaints: &mut Complaints) {
    let at = &mut complaints.at(format!("{place}.processing"), keys::PROCESSING);
    at.all(&record.processing);
    let all = (0..record.components.len()).filter_map(|n| record.component_series(n)).chain(record.series());
    let fault = all.filter(|(dt, samples)| *dt > 0.0 && samples.len() >= 2);
    if let Some((key, value, remedy)) =
        fault.into_iter().find_map(|(dt, samples)| record.processing.fault(dt, samples.len()))
    {
        at.add(key, number(value), remedy);
    } else if let Some(peak) = record.processing.peak_g.filter(|_| record.scale != 0.0)
        && record.extent().is_some_and(|(largest, ..)| largest == 0.0)
    {
        at.add("peak_g", number(peak), Text::new("wrong-peak-of-nothing"));
    }
}
