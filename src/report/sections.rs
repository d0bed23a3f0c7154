//! Tables of a report: verdicts, headline, scene, assumptions, readings, seats with codes, errors.

use std::fmt::Write as _;

use super::plan::trimmed;
use super::units::{force, mass};
use crate::codes::{Input, RotationCondition, Source};
use crate::language::{Text, said, six};
use crate::plot::draw::escape;
use crate::scene::keys::word_told;
use crate::scene::{Girder, Kind, Limits, ModelKind, Setting};
use crate::sim::{History, readings};
use crate::tables::{DemandReport, Report, SeatReport, corner_angle};

/// Rows of a table whose first cell is a heading.
pub(super) fn facts(rows: impl IntoIterator<Item = (String, String)>) -> String {
    let row = |(name, value): (String, String)| {
        format!("<tr><th>{}</th><td class=\"number\">{}</td></tr>\n", escape(&name), escape(&value))
    };
    format!("<table>{}</table>\n", rows.into_iter().map(row).collect::<String>())
}

pub(super) fn fact(name: Text, value: String) -> (String, String) {
    (name.into(), value)
}

/// The first row of a table.
pub(super) fn head(columns: &[&str]) -> String {
    let mut html = String::from("<table><tr>");
    for column in columns {
        let _ = write!(html, "<th>{}</th>", escape(column));
    }
    html + "</tr>\n"
}

/// A row of a table: what it is of, and numbers.
pub(super) fn row(name: &str, numbers: &[String]) -> String {
    let mut html = format!("<tr><td>{}</td>", escape(name));
    for number in numbers {
        let _ = write!(html, "<td class=\"number\">{}</td>", escape(number));
    }
    html + "</tr>\n"
}

/// A value and when it is reached \[s\].
pub(super) fn at(value: String, t: f64) -> String {
    said!("report-value-at", "value" => value, "t" => format!("{t:.3}"))
}

/// From when on the run carries an end that has come off its seat, so that its values are those of no falling deck; infinite where it
/// carries none \[s\].
pub(super) fn carried_from(report: &Report) -> f64 {
    // Bearings that stand on what they lose stop carrying.
    let carries = report.lost_supports.is_empty();
    report.seats.iter().filter(|_| carries).filter_map(|seat| seat.left_at).fold(f64::INFINITY, f64::min)
}

/// A value with a sign where it is reached \[s\] when an end is `carried` that has come off.
pub(super) fn marked(value: String, t: Option<f64>, carried: f64) -> String {
    if t.is_some_and(|t| t > carried) { said!("reached-after", "reached" => value) } else { value }
}

/// What the sign means, where it stands.
pub(super) fn sign_told(html: &str, carried: f64) -> String {
    if !html.contains(" *<") {
        return String::new();
    }
    format!("<p class=\"open\">{}</p>\n", said!("report-after-means", "t" => format!("{carried:.3}")))
}

fn source(source: Source) -> Text {
    match source {
        Source::Scene => Text::new("report-from-scene"),
        Source::Assumed => Text::new("report-assumed"),
        Source::Run => Text::new("report-from-run"),
    }
}

/// Whether the girders stay on their seats, and whether the run came to its end, a line each.
pub(super) fn verdicts(report: &Report) -> String {
    let off: Vec<String> = report
        .seats
        .iter()
        .filter_map(|seat| {
            let (end, t) = (format!("{}{}", seat.girder, seat.end), format!("{:.3}", seat.left_at?));
            Some(said!("report-end-at", "end" => end, "t" => t))
        })
        .collect();
    let mut html = String::new();
    if !off.is_empty() {
        let words = said!("report-comes-off", "ends" => off.join(&Text::new("report-and")));
        // Bearings that stand on what they lose stop carrying; what becomes of the run then is said of each.
        let carried = if report.lost_supports.is_empty() { Text::new("report-goes-on").as_str() } else { "" };
        let _ = writeln!(html, "<p class=\"no\">{} {carried}</p>", escape(&words));
    }
    if let Some(stop) = &report.gave_up {
        let (t, place, reason) = (six(stop.t), stop.place.as_str(), stop.reason.to_string());
        let words = said!("report-gave-up", "t" => t, "place" => place, "reason" => reason);
        let _ = writeln!(html, "<p class=\"no\">{}</p>", escape(&words));
    }
    for verdict in &report.verdicts {
        let class = if verdict.stays { "" } else { " class=\"no\"" };
        let words = said!("report-verdict", "girder" => verdict.girder.as_str(), "told" => verdict.told.as_str());
        let _ = writeln!(html, "<p{class}>{}</p>", escape(&words));
    }
    for seat in &report.seats {
        let rules = seat.codes.iter().filter(|code| !code.met).map(|code| code.demand.rule.as_str());
        // Names of rules have commas in them.
        let rules = rules.collect::<Vec<_>>().join(&Text::new("report-and-rule"));
        if !rules.is_empty() {
            let words = said!("report-seat-short", "seat" => format!("{}{}", seat.girder, seat.end), "rules" => rules);
            let _ = writeln!(html, "<p class=\"no\">{}</p>", escape(&words));
        }
    }
    html
}

/// The largest numbers of the run.
pub(super) fn headline(history: &History, report: &Report) -> String {
    let (n, carried) = (&report.numbers, carried_from(report));
    let of = |value: String, t: Option<f64>| marked(value, t, carried);
    let largest = history.largest_motion();
    let (moved, turned) = (largest.map(|l| l.displacement.extreme.t), largest.map(|l| l.rotation.extreme.t));
    let dimensions = match report.kind {
        Kind::Planar => Text::new("report-planar"),
        Kind::Spatial => Text::new("report-spatial"),
    };
    let (end, duration) = (six(report.end), six(report.duration));
    let computed = said!("report-computed-of", "end" => end, "duration" => duration);
    let mut rows = vec![
        fact(
            Text::new("report-model"),
            [word_told(ModelKind::WORDS, report.model), dimensions.as_str()].join(&Text::new("report-and")),
        ),
        fact(Text::new("report-computed"), computed),
        fact(Text::new("report-max-displacement"), of(format!("{:.2} mm", 1e3 * n.max_displacement), moved)),
        fact(Text::new("report-max-rotation"), of(format!("{:.4}°", n.max_rotation.to_degrees()), turned)),
    ];
    if let Some(tilt) = report.max_tilt {
        let largest = history.seats().uprights().iter().map(|girder| girder.tilt);
        let at = largest.max_by(|one, other| one.value.total_cmp(&other.value)).map(|tilt| tilt.t);
        rows.push(fact(Text::new("report-max-tilt"), of(format!("{:.4}°", tilt.to_degrees()), at)));
    }
    // Hits of the impact model take no time; forces are those of lasting contact.
    if let Some(impulse) = n.peak_impulse {
        rows.push(fact(Text::new("report-max-impulse"), format!("{} N·s", six(impulse))));
        rows.push(fact(Text::new("report-max-lasting"), force(n.peak_force)));
    } else {
        rows.push(fact(Text::new("report-max-total"), of(force(n.peak_total), n.peak_total_time)));
        rows.push(fact(Text::new("report-max-force"), of(force(n.peak_force), n.peak_time)));
    }
    rows.push(fact(Text::new("report-hits"), format!("{}", n.hits)));
    let html = facts(rows);
    let told = sign_told(&html, carried);
    html + &told
}

/// Numbers of girders, bearings, abutments and contact.
pub(super) fn scene(history: &History) -> String {
    let scene = history.scene();
    let mut html = head(&[
        Text::new("report-girder").as_str(),
        "a₀ × b₀ × t₀ [m]",
        "β",
        &Text::new("report-mass"),
        &Text::new("report-frequencies"),
        &Text::new("report-damping"),
        &Text::new("report-bearings"),
        &Text::new("report-seats-m"),
    ]);
    for (number, (girder, body)) in scene.girders.iter().zip(&history.model().bodies).enumerate() {
        let q = history.connections().bearing_quantities(number);
        let [hertz, damping] = [q.omega.map(|w| w / std::f64::consts::TAU), q.damping_ratio]
            .map(|three| three.map(|v| if v.is_finite() { format!("{v:.3}") } else { "–".into() }).join(", "));
        let seat = |end: &str, length: Option<f64>| length.map(|l| format!("{end} {}", trimmed(l)));
        let seats: Vec<String> =
            [seat("+x", girder.seat.plus), seat("-x", girder.seat.minus)].into_iter().flatten().collect();
        let _ = writeln!(
            html,
            "<tr><td>{}</td><td class=\"number\">{} × {} × {}</td><td class=\"number\">{}°</td><td class=\"number\">{}</td>\
             <td class=\"number\">{hertz}</td><td class=\"number\">{damping}</td><td class=\"number\">{}</td>\
             <td class=\"number\">{}</td></tr>",
            escape(&girder.name),
            trimmed(girder.length),
            trimmed(girder.width),
            trimmed(girder.thickness),
            trimmed(girder.skew_deg),
            mass(girder.mass),
            bearings(girder, body.bearings.len(), scene.setting()),
            seats.join(", ")
        );
    }
    html.push_str("</table>\n");
    html
}

/// How many bearings a girder has, and how many of them yield or slide: its frequencies are those after yield.
fn bearings(girder: &Girder, count: usize, setting: Setting) -> String {
    let supports = girder.supports(setting);
    match supports.iter().filter(|b| b.yielding.is_some() || b.sliding.is_some()).count() {
        0 => count.to_string(),
        yielding => said!("report-yielding", "count" => count, "yielding" => yielding),
    }
}

/// Extremes of every girder.
pub(super) fn readings(history: &History, report: &Report) -> String {
    let carried = carried_from(report);
    let at = |value: String, t: f64| marked(at(value, t), Some(t), carried);
    let mut html = head(&[
        Text::new("report-girder").as_str(),
        &Text::new("report-rotation"),
        &Text::new("report-drift"),
        &Text::new("report-least-gap"),
        &Text::new("report-max-total"),
        &Text::new("report-max-force"),
    ]);
    for (number, body) in history.model().girders().iter().enumerate() {
        let reading = readings::reading(history, number);
        let drift = reading.drift.map(|e| marked(format!("{:.1}", 1e3 * e.value), Some(e.t), carried)).join(", ");
        let gap = reading.gap.map_or("–".to_owned(), |e| at(format!("{:.2}", 1e3 * e.value), e.t));
        let total = history.hits().largest_total_on(number).map(|(_, most)| most);
        let [total, corner] = [total, reading.force].map(|e| e.map_or("–".to_owned(), |e| at(force(e.value), e.t)));
        let _ = writeln!(
            html,
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{drift}</td>\
             <td class=\"number\">{gap}</td><td class=\"number\">{total}</td><td class=\"number\">{corner}</td></tr>",
            escape(&body.name),
            at(format!("{:.4}°", reading.rotation.value.to_degrees()), reading.rotation.t)
        );
    }
    let told = sign_told(&html, carried);
    html + "</table>\n" + &told
}

/// Limits that were passed.
pub(super) fn limits(history: &History, report: &Report) -> String {
    let mut html = String::new();
    if history.scene().limits == Limits::default() {
        let _ = writeln!(html, "<p>{}</p>", Text::new("report-no-limits"));
    } else if report.limits_passed.is_empty() {
        let _ = writeln!(html, "<p class=\"yes\">{}</p>", Text::new("report-limits-kept"));
    }
    for passed in &report.limits_passed {
        let words = said!(
            "report-limit-passed",
            "whose" => passed.whose.as_str(),
            "limit" => passed.limit.key(),
            "t" => format!("{:.4}", passed.t),
            "reached" => passed.reached()
        );
        let _ = writeln!(html, "<p class=\"no\">{}</p>", escape(&words));
    }
    html
}

/// Needed, there, used of every seat.
pub(super) fn seats(report: &Report) -> String {
    if report.seats.is_empty() {
        return format!("<p>{}</p>\n", Text::new("report-no-seats"));
    }
    let mut html = format!("<p>{}</p>\n", Text::new("report-seats-means"));
    for ends in report.seats.chunk_by(|one, other| one.girder == other.girder) {
        for seat in ends {
            html.push_str(&seat_table(seat));
        }
        if let Some(seat) = ends.first().filter(|seat| seat.rotation_condition != 0.0) {
            let condition = RotationCondition { number: seat.rotation_condition };
            let _ = writeln!(html, "<p>{}: {}</p>", escape(&seat.girder), escape(&condition.words()));
        }
    }
    html
}

fn seat_table(seat: &SeatReport) -> String {
    let mut html = format!("<h3>{}{}</h3>\n", escape(&seat.girder), seat.end);
    for corner in &seat.corners {
        let front = corner.left_at.map(|t| {
            let along = format!("{:.3}", corner.left_along.unwrap_or(0.0));
            said!("report-corner-off", "t" => format!("{t:.4}"), "along" => along)
        });
        let side = corner.left_side_at.map(|t| said!("report-corner-side", "t" => format!("{t:.4}")));
        let departures: Vec<String> = front.into_iter().chain(side).collect();
        let off = if departures.is_empty() { Text::new("report-corner-stays").into() } else { departures.join(", ") };
        let turning = corner
            .zero_rotation_deg
            .map_or(String::new(), |a| said!("report-corner-turned", "angle" => format!("{a:.2}")));
        let words = said!(
            "report-corner-least",
            "corner" => corner.corner,
            "kind" => corner_angle(corner.angle).as_str(),
            "least" => format!("{:.1}", 1e3 * corner.least_remaining),
            "t" => format!("{:.4}", corner.t),
            "off" => off,
            "turning" => turning
        );
        let class = if departures.is_empty() { "" } else { " class=\"no\"" };
        let _ = writeln!(html, "<p{class}>{}</p>", escape(&words));
    }
    html.push_str(&head(&[
        Text::new("report-code").as_str(),
        &Text::new("report-needed"),
        &Text::new("report-there"),
        &Text::new("report-used"),
        &Text::new("report-there-needed"),
        &Text::new("report-used-needed"),
        "",
        &Text::new("report-edition"),
    ]));
    seat.codes.iter().for_each(|demand| html.push_str(&demand_row(demand)));
    html.push_str("</table>\n");
    html
}

/// Symbol, value and unit of an input.
pub(super) fn input_words(input: &Input) -> String {
    let space = if matches!(input.unit, "" | "°") { "" } else { " " };
    format!("{} = {}{space}{}", escape(input.symbol), trimmed(input.value), input.unit)
}

fn demand_row(DemandReport { demand, ratio, .. }: &DemandReport) -> String {
    let inputs: Vec<String> = demand
        .inputs
        .iter()
        .map(|input| {
            let class = if input.source == Source::Assumed { "part" } else { "open" };
            format!("{} <span class=\"{class}\">({})</span>", input_words(input), source(input.source))
        })
        .collect();
    let class = if demand.holds() { "yes" } else { "no" };
    let verdict = format!("<span class=\"{class}\">{}</span>", demand.verdict());
    let doubt = || format!(" <b class=\"part\">{}</b>", Text::new("report-not-confirmed"));
    let confirmed = if demand.confirmed { String::new() } else { doubt() };
    format!(
        "<tr><td>{}</td><td class=\"number\">{:.1}</td><td class=\"number\">{:.1}</td><td class=\"number\">{:.1}</td>\
         <td class=\"number\">{:.2}</td><td class=\"number\">{:.2}</td><td>{verdict}</td><td>{}{confirmed}<br><code>{}</code><br>{}; {}</td></tr>\n",
        escape(&demand.rule),
        1e3 * demand.required,
        1e3 * demand.provided,
        1e3 * demand.used,
        demand.provided / demand.required,
        ratio,
        escape(&demand.edition),
        escape(demand.formula),
        inputs.join(", "),
        escape(&demand.note)
    )
}
