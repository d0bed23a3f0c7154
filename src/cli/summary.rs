//! A run's summary as text; millimetres and degrees, since people read it.

use super::digits::six;
use super::{columns, flexible, moved, seats};
use crate::language::{Text, said};
use crate::scene::FrictionLaw;
use crate::scene::keys::word_told;
use crate::scene::shown::{escaped, shown};
use crate::sim::moving_ground::MovedSupport;
use crate::tables::{
    BearingsReport, DeviceReport, LostReport, OutsideReport, OverlapReport, PassedReport, PierReport, Report,
    UpliftReport, VerdictReport,
};

/// So many quantities outside the domain, and as many overlaps, are listed; `summary.json` has all.
const MOST_LISTED: usize = 10;

/// The summary, one fact a line.
pub(super) fn text(report: &Report) -> String {
    let lines = [head(report), answer(report), accuracy(report), effort(report)].concat();
    let lines = lines.into_iter().map(|(label, value)| format!("  {} {value}\n", columns::left(&label, 22)));
    std::iter::once(format!(
        "{}\n",
        said!("run-head", "name" => name(&report.scene), "end" => six(report.end), "duration" => six(report.duration))
    ))
    .chain(lines)
    .chain([seats::table(&report.seats)])
    .collect()
}

/// A scene's name, on one line.
pub(super) fn name(scene: &str) -> String {
    /// Characters of it that are shown.
    const LONGEST: usize = 100;
    shown(scene, LONGEST)
}

type Line = (String, String);

fn line(label: impl Into<String>, value: String) -> Line {
    (label.into(), value)
}

fn head(report: &Report) -> Vec<Line> {
    let gave_up = report.gave_up.iter();
    let model = (report.model == "impact").then(|| line(Text::new("run-model"), Text::new("run-impact").into()));
    let outside = outside_words(&report.outside_domain).map(|words| line(Text::new("run-outside"), words));
    let gave_up = gave_up.map(|stop| {
        line(
            stop.cause.verb(),
            said!(
                "run-gave-up-at",
                "t" => six(stop.t),
                "place" => stop.place.as_str(),
                "reason" => stop.reason.to_string()
            ),
        )
    });
    let lost = report.lost_supports.iter().take(MOST_LISTED).map(lost);
    let uplifts = report.uplifts.iter().take(MOST_LISTED).map(uplift);
    let moves = |support: &MovedSupport| line(Text::new("run-ground-under"), moved::words(support));
    model
        .into_iter()
        .chain(report.moved_supports.iter().take(MOST_LISTED).map(moves))
        .chain(gave_up)
        .chain(lost)
        .chain(uplifts)
        .chain(outside)
        .chain(overlaps(&report.overlaps))
        .chain(law_sense(report))
        .chain(report.limits_passed.iter().take(MOST_LISTED).map(limit))
        .collect()
}

/// A limit of the scene that was passed.
fn limit(passed: &PassedReport) -> Line {
    let (t, reached) = (format!("{:.4}", passed.t), passed.reached());
    let whose = escaped(&passed.whose);
    line(
        Text::new("run-limit"),
        said!("report-limit-passed", "whose" => whose, "limit" => passed.limit.key(), "t" => t, "reached" => reached),
    )
}

/// A bearing without support.
fn lost(lost: &LostReport) -> Line {
    let LostReport { bearing, t, place: [x, y, _] } = lost;
    line(
        Text::new("run-support-lost"),
        said!(
            "run-lost-at",
            "bearing" => escaped(bearing),
            "t" => format!("{t:.6}"),
            "x" => format!("{x:.4}"),
            "y" => format!("{y:.4}")
        ),
    )
}

/// A bearing that stopped carrying.
fn uplift(uplift: &UpliftReport) -> Line {
    let UpliftReport { bearing, t, pull, pull_t, lifts, .. } = uplift;
    let (bearing, t, tp) = (escaped(bearing), format!("{t:.4}"), format!("{pull_t:.4}"));
    let value = match (*pull > 0.0, lifts) {
        (false, _) => said!("run-lifts-at", "bearing" => bearing, "t" => t),
        (true, true) => {
            said!("run-damped-at", "bearing" => bearing, "t" => t, "pull" => force(*pull), "tp" => tp)
        }
        (true, false) => said!("run-pulls-at", "bearing" => bearing, "t" => t, "pull" => force(*pull), "tp" => tp),
    };
    line(Text::new("run-uplift"), value)
}

/// Readings of the bearings of a girder.
fn bearings(of: &BearingsReport) -> Line {
    let value = said!(
        "run-bearings-of",
        "moved" => millimetres(of.deformation),
        "bearing" => of.bearing,
        "t" => format!("{:.4}", of.t),
        "force" => force(of.force),
        "which" => of.force_bearing,
        "tf" => format!("{:.4}", of.force_t)
    );
    line(said!("run-bearings", "girder" => escaped(&of.girder)), value)
}

/// Readings of a pier.
fn pier(pier: &PierReport) -> Line {
    let [along, across] = pier.periods;
    let yields = |t: f64| {
        let [along, across] = pier.residual_drift.unwrap_or_default().map(|drift| format!("{:.3}", 1e3 * drift));
        let ductility = pier.ductility_words().unwrap_or_default();
        let t = format!("{t:.4}");
        said!("run-pier-yields", "t" => t, "ductility" => ductility, "along" => along, "across" => across)
    };
    let second_order = pier.second_order_counts().map_or(String::new(), |words| format!("; {words}"));
    let yielded = pier.yielded_at.map_or(String::new(), yields) + &second_order;
    let value = said!(
        "run-pier-numbers",
        "along" => format!("{along:.3}"),
        "across" => format!("{across:.3}"),
        "drift" => millimetres(pier.drift),
        "td" => format!("{:.4}", pier.drift_t),
        "shear" => force(pier.shear),
        "ts" => format!("{:.4}", pier.shear_t),
        "yielded" => yielded
    );
    line(said!("run-pier", "name" => escaped(&pier.name)), value)
}

/// A kind of device by its word in the scene's file.
pub(super) fn device_kind(word: &'static str) -> &'static str {
    let words = match word {
        "restrainer" => Text::new("kind-restrainer"),
        "bumper" => Text::new("kind-bumper"),
        "damper" => Text::new("kind-damper"),
        "stopper" => Text::new("kind-stopper"),
        other => return other,
    };
    words.as_str()
}

/// Readings of a device.
fn device(device: &DeviceReport) -> Line {
    let label = said!("run-device", "kind" => device_kind(device.kind), "name" => escaped(&device.name));
    let Some(first) = device.first else { return line(label, Text::new("run-device-never").into()) };
    let [least, greatest] = device.deformation.map(|length| format!("{:.3}", 1e3 * length));
    let part = device
        .part_of_strength
        .map_or(String::new(), |part| said!("run-device-part", "part" => format!("{:.0}", 100.0 * part)));
    let yields = device.yielded_at.map_or(String::new(), |t| said!("run-device-yields", "t" => format!("{t:.4}")));
    let breaks = device.broke_at.map_or(String::new(), |t| said!("run-device-breaks", "t" => format!("{t:.4}")));
    let value = said!(
        "run-device-of",
        "force" => force(device.force),
        "t" => format!("{:.4}", device.t),
        "part" => part,
        "least" => least,
        "greatest" => greatest,
        "times" => device.times,
        "first" => format!("{first:.4}"),
        "yields" => yields,
        "breaks" => breaks
    );
    line(label, value)
}

/// Bodies that are inside each other where no contact carries it, a line for every two.
fn overlaps(all: &[OverlapReport]) -> Vec<Line> {
    let of = |o: &OverlapReport| {
        let [one, other] = &o.bodies;
        let value = said!(
            "run-overlap-of",
            "one" => escaped(one),
            "other" => escaped(other),
            "t" => format!("{:.4}", o.t),
            "depth" => millimetres(o.depth),
            "td" => format!("{:.4}", o.deepest_at)
        );
        line(Text::new("run-overlap"), value)
    };
    let more = all.len().saturating_sub(MOST_LISTED);
    let more = (more > 0).then(|| line(Text::new("run-overlap"), said!("run-overlap-more", "more" => more)));
    all.iter().take(MOST_LISTED).map(of).chain(more).collect()
}

/// Contacts that left the sense of their law.
fn law_sense(report: &Report) -> Vec<Line> {
    let deep = report.too_deep.iter().map(|deep| {
        let value = said!(
            "run-too-deep-of",
            "node" => escaped(&deep.node),
            "face" => escaped(&deep.face),
            "depth" => millimetres(deep.depth),
            "t" => format!("{:.4}", deep.t),
            "allowed" => millimetres(deep.allowed)
        );
        line(Text::new("run-too-deep"), value)
    });
    let dropped = report.dropped.iter().map(|dropped| {
        let value = said!(
            "run-left-face-of",
            "count" => dropped.count,
            "energy" => format!("{:.2e}", dropped.energy),
            "share" => format!("{:.1e}", dropped.share),
            "node" => escaped(&dropped.node),
            "face" => escaped(&dropped.face),
            "t" => format!("{:.4}", dropped.t)
        );
        line(Text::new("run-left-face"), value)
    });
    deep.take(MOST_LISTED).chain(dropped).collect()
}

/// A depth in mm, four digits \[m\].
fn millimetres(depth: f64) -> String {
    let mm = depth * 1e3;
    if mm >= 0.01 { format!("{mm:.3}") } else { format!("{mm:.1e}") }
}

/// Where the scene lies outside the domain; `None` where it does not.
fn outside_words(outside: &[OutsideReport]) -> Option<String> {
    let of = |d: &OutsideReport| match &d.pair {
        Some(pair) => format!("{} ({pair})", d.place),
        None => d.place.clone(),
    };
    let listed: Vec<String> = outside.iter().take(MOST_LISTED).map(of).collect();
    let more = outside.len() - listed.len();
    let more = if more > 0 { format!(" {}", said!("run-outside-more", "more" => more)) } else { String::new() };
    (!outside.is_empty()).then(|| format!("{}{more}", listed.join(", ")))
}

fn answer(report: &Report) -> Vec<Line> {
    let n = &report.numbers;
    let peak = match n.peak_time {
        Some(_) if n.peak_impulse.is_some() => said!("run-force-lasting", "force" => force(n.peak_force)),
        Some(t) => said!("run-force-at", "force" => force(n.peak_force), "t" => format!("{t:.6}")),
        None if n.peak_impulse_time.is_some() => Text::new("run-none-lasting").into(),
        None => Text::new("run-no-contact").into(),
    };
    let mut lines = vec![
        line(Text::new("run-displacement"), format!("{:.4} mm", n.max_displacement * 1e3)),
        line(Text::new("run-rotation"), format!("{:.4}°", n.max_rotation.to_degrees())),
        line(Text::new("run-force"), peak),
    ];
    if let Some(tilt) = report.max_tilt {
        lines.insert(2, line(Text::new("run-tilt"), format!("{:.4}°", tilt.to_degrees())));
    }
    if let Some(t) = n.peak_total_time {
        let total = said!("run-total-at", "force" => force(n.peak_total), "t" => format!("{t:.6}"));
        lines.push(line(Text::new("run-total"), total));
    }
    if let (Some(impulse), Some(t)) = (n.peak_impulse, n.peak_impulse_time) {
        lines.push(line(
            Text::new("run-impulse"),
            said!("run-impulse-at", "impulse" => short(impulse), "t" => format!("{t:.6}")),
        ));
    }
    lines.extend([
        line(Text::new("run-hits"), said!("run-hits-of", "hits" => n.hits, "touches" => n.touches)),
        line(
            Text::new("run-stick-slip"),
            said!("run-stick-slip-of", "stick" => short(n.stick_time), "slip" => short(n.slip_time)),
        ),
    ]);
    lines.extend(report.pairs.iter().map(|pair| {
        let law = word_told(FrictionLaw::WORDS, pair.law);
        let total = pair.peak_total.map_or(String::new(), |total| said!("run-pair-total", "total" => force(total)));
        let peak = force(pair.peak_force);
        let [asked, returned] = pair.restitution;
        let other = pair.peak_force > 0.0 && (returned - asked).abs() > OTHER_RESTITUTION;
        let restitution = if other {
            said!("run-pair-returns", "asked" => six(asked), "returned" => format!("{returned:.4}"))
        } else {
            String::new()
        };
        let value = said!("run-pair-of", "law" => law, "touches" => pair.touches, "peak" => peak, "total" => total)
            + &restitution;
        line(said!("run-pair", "name" => pair.name.as_str()), value)
    }));
    lines.extend(report.bearings.iter().take(MOST_LISTED).map(bearings));
    lines.extend(report.backfill.iter().map(|soil| {
        let value = said!(
            "run-soil-of",
            "push" => millimetres(soil.push),
            "t" => format!("{:.4}", soil.t),
            "force" => force(soil.force),
            "share" => format!("{:.0}", 100.0 * soil.force / soil.ultimate),
            "gap" => millimetres(soil.remaining_gap)
        );
        let value = soil.fails().map_or(value.clone(), |words| format!("{value}; {words}"));
        let value = if soil.is_beyond() { format!("{value}; {}", Text::new("soil-beyond")) } else { value };
        line(said!("run-soil", "name" => escaped(&soil.abutment)), value)
    }));
    lines.extend(report.piers.iter().map(pier));
    lines.extend(report.devices.iter().map(device));
    let verdict = |v: &VerdictReport| line(escaped(&v.girder), v.told.clone());
    lines.extend(report.verdicts.iter().map(verdict));
    lines.extend(flexible::lines(&report.flexible, report.degree_check.as_ref()));
    lines.extend(report.seats.iter().flat_map(seats::lines));
    lines
}

fn accuracy(report: &Report) -> Vec<Line> {
    let ledger = &report.ledger;
    let share = if ledger.scale > 0.0 { ledger.residual.abs() / ledger.scale } else { 0.0 };
    let unbalanced = if report.balances { String::new() } else { Text::new("run-unbalanced").into() };
    let error = match report.error_in_words() {
        Some(error) => {
            let of = said!("run-error-of", "error" => error, "tolerance" => format!("{:e}", report.tolerance));
            of + &Report::as_far_as(report.estimated_until)
        }
        None => Text::new("run-error-not").into(),
    };
    vec![
        line(Text::new("run-error"), error),
        line(
            Text::new("run-ledger"),
            said!(
                "run-ledger-of",
                "residual" => format!("{:.2e}", ledger.residual + 0.0),
                "share" => format!("{share:.1e}"),
                "unbalanced" => unbalanced
            ),
        ),
    ]
}

fn effort(report: &Report) -> Vec<Line> {
    let timed = report.run_time.zip(report.times_real_time);
    let time = timed.map(|(time, factor)| {
        line(Text::new("run-time-taken"), said!("run-time-of", "time" => short(time), "times" => times(factor)))
    });
    time.into_iter().chain([line(Text::new("run-digest"), report.digest.clone())]).collect()
}

/// A force, in kN where newtons would be many.
fn force(newtons: f64) -> String {
    if newtons < 1e4 { format!("{newtons:.4} N") } else { format!("{:.4} kN", newtons / 1e3) }
}

/// Difference of two coefficients of restitution from which it is mentioned \[–\]: one that two digits show. Chosen.
const OTHER_RESTITUTION: f64 = 0.01;

/// A time in few digits; adding 0 turns −0 into 0.
fn short(seconds: f64) -> String {
    if seconds == 0.0 || seconds >= 1e-3 { format!("{:.4}", seconds + 0.0) } else { format!("{seconds:.2e}") }
}

/// How many times, in three digits.
fn times(factor: f64) -> String {
    if factor >= 100.0 { format!("{factor:.0}") } else { format!("{factor:.2}") }
}
