//! A run's summary as text; millimetres and degrees, since people read it.

use super::{flexible, seats};
use crate::scene::shown::{escaped, shown};
use crate::tables::{DeviceReport, LostReport, OutsideReport, OverlapReport, PierReport, Report, VerdictReport};

/// So many quantities outside the domain, and as many overlaps, are listed; `summary.json` has all.
const MOST_LISTED: usize = 10;

/// The summary, one fact a line.
pub(super) fn text(report: &Report) -> String {
    let lines = [head(report), answer(report), accuracy(report), effort(report)].concat();
    let lines = lines.into_iter().map(|(label, value)| format!("  {label:<22} {value}\n"));
    std::iter::once(format!("{}: {} of {} s\n", name(&report.scene), plain(report.end), report.duration))
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

fn line(label: &str, value: String) -> Line {
    (label.to_owned(), value)
}

fn head(report: &Report) -> Vec<Line> {
    let gave_up = report.gave_up.iter();
    let model = (report.model == "impact").then(|| line("model", "impact (rigid bodies, impulses)".to_owned()));
    let outside = outside_words(&report.outside_domain).map(|words| line("outside the domain", words));
    let gave_up =
        gave_up.map(|stop| line(stop.cause.verb(), format!("at {} s, {}: {}", plain(stop.t), stop.place, stop.reason)));
    let lost = report.lost_supports.iter().take(MOST_LISTED).map(lost);
    model
        .into_iter()
        .chain(gave_up)
        .chain(lost)
        .chain(outside)
        .chain(overlaps(&report.overlaps))
        .chain(law_sense(report))
        .collect()
}

/// A bearing without support.
fn lost(lost: &LostReport) -> Line {
    let LostReport { bearing, t, place: [x, y, _] } = lost;
    line(
        "support lost",
        format!("{} at {t:.6} s, at ({x:.4}, {y:.4}) m: later samples are without it", escaped(bearing)),
    )
}

/// What the run did to a pier.
fn pier(pier: &PierReport) -> Line {
    let [along, across] = pier.periods;
    let yielded = pier.yielded_at.map_or(String::new(), |t| format!("; it yields from {t:.4} s on"));
    let value = format!(
        "T {along:.3} s along, {across:.3} s across; drift {} mm at {:.4} s, base shear {} at {:.4} s{yielded}",
        millimetres(pier.drift),
        pier.drift_t,
        force(pier.shear),
        pier.shear_t
    );
    line(&format!("pier {}", escaped(&pier.name)), value)
}

/// What the run did to a device.
fn device(device: &DeviceReport) -> Line {
    let label = format!("{} {}", device.kind, escaped(&device.name));
    let Some(first) = device.first else { return line(&label, "its force never sets in".to_owned()) };
    let [least, greatest] = device.deformation.map(|length| format!("{:.3}", 1e3 * length));
    let part = device.part_of_strength.map_or(String::new(), |part| format!(", {:.0} % of its strength", 100.0 * part));
    let yields = device.yielded_at.map_or(String::new(), |t| format!("; it yields from {t:.4} s on"));
    let breaks = device.broke_at.map_or(String::new(), |t| format!("; it breaks at {t:.4} s"));
    let value = format!(
        "{} at {:.4} s{part}; moves {least} to {greatest} mm; acts {} times from {first:.4} s on{yields}{breaks}",
        force(device.force),
        device.t,
        device.times
    );
    line(&label, value)
}

/// Bodies that are inside each other where no contact carries it, a line for every two.
fn overlaps(all: &[OverlapReport]) -> Vec<Line> {
    let of = |o: &OverlapReport| {
        let [one, other] = &o.bodies;
        let value = format!(
            "{} and {}, without contact: from {:.4} s, {} mm deep at {:.4} s",
            escaped(one),
            escaped(other),
            o.t,
            millimetres(o.depth),
            o.deepest_at
        );
        line("overlap", value)
    };
    let more = all.len().saturating_sub(MOST_LISTED);
    let more = (more > 0).then(|| line("overlap", format!("{more} more")));
    all.iter().take(MOST_LISTED).map(of).chain(more).collect()
}

/// Contacts that left the sense of their law.
fn law_sense(report: &Report) -> Vec<Line> {
    let deep = report.too_deep.iter().map(|deep| {
        let value = format!(
            "{} in {}: {} mm at {:.4} s, more than a tenth of the shortest side ({} mm)",
            escaped(&deep.node),
            escaped(&deep.face),
            millimetres(deep.depth),
            deep.t,
            millimetres(deep.allowed)
        );
        line("too deep", value)
    });
    let dropped = report.dropped.iter().map(|dropped| {
        let value = format!(
            "{} times with {:.2e} J in the springs, {:.1e} of the largest energy; {} from {} at {:.4} s the most",
            dropped.count,
            dropped.energy,
            dropped.share,
            escaped(&dropped.node),
            escaped(&dropped.face),
            dropped.t
        );
        line("left a face", value)
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
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    (!outside.is_empty()).then(|| format!("{}{more}", listed.join(", ")))
}

fn answer(report: &Report) -> Vec<Line> {
    let n = &report.numbers;
    let peak = match n.peak_time {
        Some(_) if n.peak_impulse.is_some() && n.peak_force == 0.0 => "none that lasts".to_owned(),
        Some(_) if n.peak_impulse.is_some() => format!("{} of a single corner, lasting", force(n.peak_force)),
        Some(t) => format!("{} of a single corner at {t:.6} s", force(n.peak_force)),
        None => "no contact".to_owned(),
    };
    let mut lines = vec![
        line("largest displacement", format!("{:.4} mm", n.max_displacement * 1e3)),
        line("largest rotation", format!("{:.4}°", n.max_rotation.to_degrees())),
        line("largest contact force", peak),
    ];
    if let (Some(impulse), Some(t)) = (n.peak_impulse, n.peak_time) {
        lines.push(line("largest impulse", format!("{} N·s at {t:.6} s", short(impulse))));
    }
    lines.extend([
        line("hits", format!("{} ({} touches of single contacts)", n.hits, n.touches)),
        line(
            "time in stick, slip",
            format!("{} s, {} s, summed over contacts", short(n.stick_time), short(n.slip_time)),
        ),
    ]);
    lines.extend(report.pairs.iter().map(|pair| {
        let value = format!("law {}, {} touches, peak {}", pair.law, pair.touches, force(pair.peak_force));
        line(&format!("pair {}", pair.name), value)
    }));
    lines.extend(report.backfill.iter().map(|soil| {
        let value = format!(
            "pushed {} mm at {:.4} s with {}, {:.0} % of its ultimate force; a gap of {} mm stays",
            millimetres(soil.push),
            soil.t,
            force(soil.force),
            100.0 * soil.force / soil.ultimate,
            millimetres(soil.remaining_gap)
        );
        line(&format!("soil {}", escaped(&soil.abutment)), value)
    }));
    lines.extend(report.piers.iter().map(pier));
    lines.extend(report.devices.iter().map(device));
    let verdict = |v: &VerdictReport| line(&escaped(&v.girder), v.words.clone());
    lines.extend(report.verdicts.iter().map(verdict));
    lines.extend(flexible::lines(&report.flexible, report.degree_check.as_ref()));
    lines.extend(report.seats.iter().flat_map(seats::lines));
    lines
}

fn accuracy(report: &Report) -> Vec<Line> {
    let ledger = &report.ledger;
    let share = if ledger.scale > 0.0 { ledger.residual.abs() / ledger.scale } else { 0.0 };
    let unbalanced = if report.balances { "" } else { ": beyond its bound" };
    let error = match report.estimated_error {
        Some(error) => format!("{error:.2e} m (against a hundredth of the tolerance {:e})", report.tolerance),
        None => "not asked for".to_owned(),
    };
    vec![
        line("estimated error", error),
        line(
            "ledger residual",
            format!("{:.2e} J, {share:.1e} of the largest energy{unbalanced}", ledger.residual + 0.0),
        ),
    ]
}

fn effort(report: &Report) -> Vec<Line> {
    let timed = report.run_time.zip(report.times_real_time);
    let time =
        timed.map(|(time, factor)| line("run time", format!("{} s, {} × real time", short(time), times(factor))));
    time.into_iter().chain([line("digest", report.digest.clone())]).collect()
}

/// A force, in kN where newtons would be many.
fn force(newtons: f64) -> String {
    if newtons < 1e4 { format!("{newtons:.4} N") } else { format!("{:.4} kN", newtons / 1e3) }
}

/// A time in few digits; adding 0 turns −0 into 0.
fn short(seconds: f64) -> String {
    if seconds == 0.0 || seconds >= 1e-3 { format!("{:.4}", seconds + 0.0) } else { format!("{seconds:.2e}") }
}

/// A number in all its digits, without a row of zeros before them.
pub(super) fn plain(value: f64) -> String {
    // Adding 0 turns −0 into 0.
    if value == 0.0 || value.abs() >= 1e-4 { format!("{}", value + 0.0) } else { format!("{value:e}") }
}

/// How many times, in three digits.
fn times(factor: f64) -> String {
    if factor >= 100.0 { format!("{factor:.0}") } else { format!("{factor:.2}") }
}
