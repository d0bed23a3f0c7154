//! Tables of a report: headline, scene, assumptions, readings, seats with codes, errors.

use std::fmt::Write as _;

use super::plan::trimmed;
use crate::codes::{Input, RotationCondition, Source};
use crate::scene::{Bearings, ContactSettings, Girder, Kind, Limits, Setting};
use crate::sim::{History, readings};
use crate::study::plot::draw::escape;
use crate::tables::{DemandReport, Report, SeatReport};

/// Rows of a table whose first cell is a heading.
fn facts(rows: impl IntoIterator<Item = (String, String)>) -> String {
    let row = |(name, value): (String, String)| {
        format!("<tr><th>{}</th><td class=\"number\">{}</td></tr>\n", escape(&name), escape(&value))
    };
    format!("<table>{}</table>\n", rows.into_iter().map(row).collect::<String>())
}

fn fact(name: &str, value: String) -> (String, String) {
    (name.to_owned(), value)
}

/// What came out, in a few lines.
pub(super) fn headline(report: &Report) -> String {
    let n = &report.numbers;
    let off: Vec<String> = report
        .seats
        .iter()
        .filter_map(|seat| Some(format!("{}{} at {:.3} s", seat.girder, seat.end, seat.left_at?)))
        .collect();
    let mut html = String::new();
    if !off.is_empty() {
        let carried =
            "The run goes on as if the end were carried: what follows that time is not the motion of a falling deck.";
        let _ =
            writeln!(html, "<p class=\"no\">A corner comes off its seat: {}. {carried}</p>", escape(&off.join(", ")));
    }
    if let Some(stop) = &report.gave_up {
        let _ = writeln!(
            html,
            "<p class=\"no\">The run ends at {} s, {}: {}</p>",
            stop.t,
            escape(&stop.place),
            escape(&stop.reason)
        );
    }
    html + &facts([
        fact("model", format!("{}, {}", report.model, if report.kind == Kind::Planar { "planar" } else { "spatial" })),
        fact("computed", format!("{} of {} s", report.end, report.duration)),
        fact("largest displacement of a G", format!("{:.2} mm", 1e3 * n.max_displacement)),
        fact("largest rotation", format!("{:.4}°", n.max_rotation.to_degrees())),
        fact("largest force of a contact", format!("{:.1} kN", n.peak_force / 1e3)),
        fact("hits", format!("{}", n.hits)),
    ])
}

/// Numbers of girders, bearings, abutments and contact.
pub(super) fn scene(history: &History) -> String {
    let scene = history.scene();
    let mut html = String::from(
        "<table><tr><th>girder</th><th>a₀ × b₀ × t₀ [m]</th><th>β</th><th>mass [t]</th><th>frequencies x, y, θ [Hz]</th>\
         <th>damping x, y, θ</th><th>bearings</th><th>seats [m]</th></tr>\n",
    );
    for (girder, body) in scene.girders.iter().zip(&history.model().bodies) {
        let q = body.quantities();
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
            trimmed(girder.mass / 1e3),
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
        yielding => format!("{count}, {yielding} of them yield (frequencies: after yield)"),
    }
}

/// What is assumed: of the model, numbers that stand at the program's default, inputs of codes that the scene does not give.
pub(super) fn assumptions(history: &History, report: &Report) -> String {
    let (contact, default) = (&history.scene().contact, ContactSettings::default());
    let mut items: Vec<String> = [
        "Girders are rigid; supports and abutments are fixed to one ground.",
        "A contact is a spring and a dashpot at a node with dry friction on a rigid face.",
        "Seats are fixed to the ground; a corner that is off goes on being carried by its bearings.",
    ]
    .map(str::to_owned)
    .to_vec();
    let numbers = [
        ("restitution, normal", contact.restitution_normal, default.restitution_normal),
        ("restitution, tangential", contact.restitution_tangential, default.restitution_tangential),
        ("μ_s", contact.mu_static, default.mu_static),
        ("μ_k", contact.mu_kinetic, default.mu_kinetic),
    ];
    items.extend(numbers.map(|(name, value, assumed)| {
        let mark = if value == assumed { " <b class=\"part\">assumed</b> (the program's default)" } else { "" };
        format!("{name} = {}{mark}", trimmed(value))
    }));
    if contact.stiffness.is_none() {
        items.push("contact stiffness of a pair: E A/L of what touches, or its own; <b class=\"part\">assumed</b> where no number is given".to_owned());
    }
    let listed = history.scene().assumed_numbers().into_iter();
    items.extend(listed.map(|(path, value)| {
        format!("{} = {} <b class=\"part\">assumed</b> (not given)", escape(&path), escape(&value))
    }));
    for girder in &history.scene().girders {
        let Some(Bearings::Deck(deck)) = &girder.bearings else { continue };
        let assumed = deck.assumed().into_iter().map(|(key, number)| format!("{key} = {}", trimmed(number)));
        let assumed: Vec<String> = assumed.collect();
        if !assumed.is_empty() {
            let (name, kind) = (escape(&girder.name), deck.kind.label());
            items.push(format!("{kind} bearings of {name}: {} <b class=\"part\">assumed</b>", assumed.join(", ")));
        }
    }
    let mut inputs: Vec<String> = Vec::new();
    for DemandReport { demand, .. } in report.seats.iter().flat_map(|seat| &seat.codes) {
        let assumed = demand.inputs.iter().filter(|input| input.source == Source::Assumed);
        let values: Vec<String> = assumed.map(input_words).collect();
        let words = format!("{}: {} <b class=\"part\">assumed</b>", escape(demand.rule), values.join(", "));
        if !values.is_empty() && !inputs.contains(&words) {
            inputs.push(words);
        }
    }
    items.extend(inputs);
    let outside = report.outside_domain.iter().map(|d| {
        let what = format!("{}, {} = {} {}: {}", d.place, d.quantity, trimmed(d.value), d.unit, d.consequence);
        format!("<b class=\"no\">outside the checked domain</b>: {}", escape(&what))
    });
    let mut html = String::from("<ul>\n");
    for item in items.into_iter().chain(outside) {
        let _ = writeln!(html, "<li>{item}</li>");
    }
    html + "</ul>\n"
}

/// Extremes of every girder, and limits that were passed.
pub(super) fn readings(history: &History, report: &Report) -> String {
    let mut html = String::from(
        "<table><tr><th>girder</th><th>rotation</th><th>drift of corners 1–4 [mm]</th><th>least gap [mm]</th>\
         <th>largest force [kN]</th></tr>\n",
    );
    for (number, body) in history.model().girders().iter().enumerate() {
        let reading = readings::reading(history, number);
        let drift = reading.drift.map(|e| format!("{:.1}", 1e3 * e.value)).join(", ");
        let gap = reading.gap.map_or("–".to_owned(), |e| format!("{:.2} at {:.3} s", 1e3 * e.value, e.t));
        let force = reading.force.map_or("–".to_owned(), |e| format!("{:.1} at {:.3} s", e.value / 1e3, e.t));
        let _ = writeln!(
            html,
            "<tr><td>{}</td><td class=\"number\">{:.4}° at {:.3} s</td><td class=\"number\">{drift}</td>\
             <td class=\"number\">{gap}</td><td class=\"number\">{force}</td></tr>",
            escape(&body.name),
            reading.rotation.value.to_degrees(),
            reading.rotation.t
        );
    }
    html.push_str("</table>\n");
    if history.scene().limits == Limits::default() {
        html.push_str("<p>The scene sets no limits.</p>\n");
    } else if report.limits_passed.is_empty() {
        html.push_str("<p class=\"yes\">No limit of the scene is passed.</p>\n");
    }
    for passed in &report.limits_passed {
        let _ = writeln!(
            html,
            "<p class=\"no\">{}: limit {} passed at {:.4} s, reached {}</p>",
            escape(&passed.whose),
            passed.limit,
            passed.t,
            trimmed(passed.reached)
        );
    }
    html
}

/// Needed, there, used of every seat.
pub(super) fn seats(report: &Report) -> String {
    if report.seats.is_empty() {
        return "<p>The scene gives no seats (<code>seat_m</code> of a girder).</p>\n".to_owned();
    }
    let mut html = String::from(
        "<p>All lengths square to the front edge of the seat. Used: placed less least. A code's number does not change the run.</p>\n",
    );
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
        let off = corner.left_at.map_or_else(
            || "stays on its seat".to_owned(),
            |t| {
                format!(
                    "<b class=\"no\">comes off at {t:.4} s</b>, {:.3} m along the edge",
                    corner.left_along.unwrap_or(0.0)
                )
            },
        );
        let turning =
            corner.zero_rotation_deg.map_or(String::new(), |a| format!("; turned about G it is off from {a:.2}°"));
        let _ = writeln!(
            html,
            "<p>Corner {} ({}): least {:.1} mm at {:.4} s, {off}{turning}.</p>",
            corner.corner,
            corner.angle,
            1e3 * corner.least_remaining,
            corner.t
        );
    }
    html.push_str(
        "<table><tr><th>code</th><th>needed [mm]</th><th>there [mm]</th><th>used [mm]</th><th>used/needed</th><th></th>\
         <th>edition, formula, inputs</th></tr>\n",
    );
    seat.codes.iter().for_each(|demand| html.push_str(&demand_row(demand)));
    html.push_str("</table>\n");
    html
}

/// Symbol, value and unit of an input.
fn input_words(input: &Input) -> String {
    let space = if matches!(input.unit, "" | "°") { "" } else { " " };
    format!("{} = {}{space}{}", escape(input.symbol), trimmed(input.value), input.unit)
}

fn demand_row(DemandReport { demand, met, ratio }: &DemandReport) -> String {
    let inputs: Vec<String> = demand
        .inputs
        .iter()
        .map(|input| {
            let class = if input.source == Source::Assumed { "part" } else { "open" };
            format!("{} <span class=\"{class}\">({})</span>", input_words(input), input.source.label())
        })
        .collect();
    let verdict = if *met { "<span class=\"yes\">long enough</span>" } else { "<span class=\"no\">too short</span>" };
    let confirmed = if demand.confirmed { "" } else { " <b class=\"part\">not confirmed: quoted from memory</b>" };
    format!(
        "<tr><td>{}</td><td class=\"number\">{:.1}</td><td class=\"number\">{:.1}</td><td class=\"number\">{:.1}</td>\
         <td class=\"number\">{:.2}</td><td>{verdict}</td><td>{}{confirmed}<br><code>{}</code><br>{}; {}</td></tr>\n",
        escape(demand.rule),
        1e3 * demand.required,
        1e3 * demand.provided,
        1e3 * demand.used,
        ratio,
        escape(demand.edition),
        escape(demand.formula),
        inputs.join(", "),
        escape(demand.note)
    )
}

/// Error, ledger, versions and digest.
pub(super) fn trust(report: &Report) -> String {
    let l = &report.ledger;
    let joule = |value: f64| format!("{:.4e} J", value + 0.0);
    let error = report.estimated_error.map_or("not computed".to_owned(), |e| {
        format!("{e:.2e} m, against a run at a hundredth of the tolerance {:e}", report.tolerance)
    });
    let balance = format!("{} of a bound of {}", joule(l.residual), joule(report.residual_bound));
    facts([
        fact("estimated error of displacements", error),
        fact("energy: work of the ground", joule(l.work_ground)),
        fact("kinetic at the end", joule(l.kinetic)),
        fact("stored in bearings", joule(l.bearing)),
        fact("lost in bearings", joule(l.loss_bearing)),
        fact("lost in contacts", joule(l.loss_normal + l.loss_tangential + l.loss_hits)),
        fact("lost in friction", joule(l.loss_friction)),
        fact("ledger residual", if report.balances { balance } else { format!("{balance}: does not balance") }),
        fact("overlaps without contact", report.overlaps.len().to_string()),
        fact(
            "program",
            format!("girderbench {}, scene format {}", report.versions.girderbench, report.versions.scene_format),
        ),
        fact("digest of the answer", report.digest.clone()),
    ])
}
