//! Assumptions of a report: of the model, of contact, and the numbers that the scene leaves out.

use std::fmt::Write as _;

use super::in_force;
use super::plan::trimmed;
use super::sections::input_words;
use super::units::stiffness;
use crate::codes::Source;
use crate::language::{Text, said, six};
use crate::plot::draw::escape;
use crate::scene::domain::{BesideGirder, beside_girders};
use crate::scene::facing::PairContact;
use crate::scene::keys::word_told;
use crate::scene::seating::{self, BeyondCap};
use crate::scene::{Bearings, ContactSettings, FrictionLaw, ImpactSettings, ModelKind, NormalName, Scene};
use crate::sim::History;
use crate::tables::{DemandReport, Report};

/// Facing pairs whose numbers are listed; a scene may have hundreds.
const MOST_LISTED: usize = 12;

/// Numbers that are assumed, by their paths, as they stand in the file.
type Listed = Vec<(String, String)>;

/// The list of assumptions.
pub(super) fn section(history: &History, report: &Report) -> String {
    let scene = history.scene();
    let mut listed = scene.assumed_numbers();
    let mut items = of_bodies(history);
    items.extend(if report.model == ModelKind::Impact.label() {
        of_impact(&scene.impact, &mut listed)
    } else {
        of_contact(history, &mut listed)
    });
    items.extend(not_given(&listed));
    items.extend(of_bearings(scene, report));
    items.extend(of_supports(scene));
    items.extend(of_codes(report));
    let outside = report.outside_domain.iter().map(|d| {
        let what = format!("{}, {} = {} {}: {}", d.place, d.quantity, trimmed(d.value), d.unit, d.consequence);
        format!("<b class=\"no\">{}</b>: {}", Text::new("report-outside"), escape(&what))
    });
    let mut html = String::from("<ul>\n");
    let off = seating::all_off(scene).into_iter().map(|(girder, off)| {
        let off: Vec<String> = off.iter().map(ToString::to_string).collect();
        let words = escape(&said!("off-seats", "girder" => girder, "bearings" => off.join(", ")));
        format!("<b class=\"no\">{words}</b>")
    });
    let wide = seating::beyond_caps(scene).into_iter().map(|BeyondCap { pier, ends, length, cap }| {
        let ends = ends.join(", ");
        let words =
            said!("seat-beyond-cap", "pier" => pier, "ends" => ends, "length" => six(length), "cap" => six(cap));
        format!("<b class=\"no\">{}</b>", escape(&words))
    });
    let beside = beside_girders(scene).into_iter().map(|BesideGirder { key, girder, by }| {
        let words = said!("device-beside", "key" => key, "girder" => girder, "by" => six(by));
        format!("<b class=\"no\">{}</b>", escape(&words))
    });
    for item in items.into_iter().chain(outside).chain(off).chain(wide).chain(beside) {
        let _ = writeln!(html, "<li>{item}</li>");
    }
    html + "</ul>\n"
}

fn mark() -> String {
    format!("<b class=\"part\">{}</b>", Text::new("report-assumed"))
}

/// Of girders, the ground and seats.
fn of_bodies(history: &History) -> Vec<String> {
    let scene = history.scene();
    let bends = |number: &usize| history.sections().flexible(*number).is_some();
    let bending: Vec<&str> =
        (0..scene.girders.len()).filter(bends).map(|number| scene.girders[number].name.as_str()).collect();
    let girders = if bending.is_empty() {
        Text::new("report-assume-rigid").into()
    } else {
        escape(&said!("report-assume-elastic", "girders" => bending.join(", ")))
    };
    let one = history.model().moving.is_none();
    let ground = if one { "report-one-ground" } else { "report-moving-supports" };
    let mut items = vec![girders, Text::new(ground).into()];
    if scene.girders.iter().any(|girder| girder.seat.plus.or(girder.seat.minus).is_some()) {
        items.push(Text::new("report-assume-seats").into());
    }
    items
}

/// A number of contact, and whether it is assumed or stands at the program's default.
fn number(listed: &mut Listed, path: &str, name: &str, [value, default]: [f64; 2]) -> String {
    let own = listed.iter().position(|(known, _)| known == path);
    let why = match own.map(|own| listed.remove(own)) {
        Some(_) => format!(" {} {}", mark(), Text::new("report-not-given")),
        None if value == default => format!(" {}", Text::new("report-by-default")),
        None => String::new(),
    };
    format!("{name} = {}{why}", trimmed(value))
}

/// Restitution along and across the normal, static and kinetic friction of a table, in this order.
fn numbers(listed: &mut Listed, table: &str, values: [f64; 4], defaults: [f64; 4]) -> Vec<String> {
    let (normal, tangential) = (Text::new("report-e-normal"), Text::new("report-e-tangential"));
    let names = [
        ("restitution_normal", normal.as_str()),
        ("restitution_tangential", tangential.as_str()),
        ("mu_static", "μ_s"),
        ("mu_kinetic", "μ_k"),
    ];
    let all = names.into_iter().zip(values.into_iter().zip(defaults));
    all.map(|((key, name), (value, default))| number(listed, &format!("{table}.{key}"), name, [value, default]))
        .collect()
}

/// Of the impact model.
fn of_impact(impact: &ImpactSettings, listed: &mut Listed) -> Vec<String> {
    let of = |s: &ImpactSettings| [s.restitution_normal, s.restitution_tangential, s.mu_static, s.mu_kinetic];
    let mut items = vec![Text::new("report-assume-impact").into()];
    items.extend(numbers(listed, "impact", of(impact), of(&ImpactSettings::default())));
    let [corner_static, corner_kinetic] = impact.corner_friction();
    if [corner_static, corner_kinetic] != [impact.mu_static, impact.mu_kinetic] {
        items.push(
            said!("report-corner-friction", "static" => trimmed(corner_static), "kinetic" => trimmed(corner_kinetic)),
        );
    }
    items
}

/// Of the contact model: its numbers for all pairs where a pair has them, then those of every pair.
fn of_contact(history: &History, listed: &mut Listed) -> Vec<String> {
    let contact = &history.scene().contact;
    let mut items = vec![Text::new("report-assume-contact").into()];
    if history.scene().model.kind == ModelKind::Both {
        items.push(Text::new("report-assume-both").into());
    }
    let of = |s: &ContactSettings| [s.restitution_normal, s.restitution_tangential, s.mu_static, s.mu_kinetic];
    let own =
        |pair: &PairContact| [pair.restitution_normal, pair.restitution_tangential, pair.mu_static, pair.mu_kinetic];
    let (pairs, general) = (&history.model().pairs, of(contact));
    if pairs.is_empty() || pairs.iter().any(|pair| own(&pair.contact) == general) {
        items.extend(numbers(listed, "contact", general, of(&ContactSettings::default())));
    }
    if contact.stiffness.is_none() && pairs.iter().any(|pair| !pair.met) {
        items.push(Text::new("report-assume-stiffness").into());
    }
    // Pairs with the same numbers in one line.
    let mut groups: Vec<(String, Vec<&str>)> = Vec::new();
    for pair in pairs.iter().filter(|pair| !pair.met) {
        let numbers = in_force(&pair.contact, own(&pair.contact) != general);
        match groups.iter_mut().find(|(known, _)| *known == numbers) {
            Some((_, names)) => names.push(&pair.name),
            None => groups.push((numbers, vec![&pair.name])),
        }
    }
    let more = groups.len().saturating_sub(MOST_LISTED);
    items.extend(groups.into_iter().take(MOST_LISTED).map(|(numbers, names)| {
        let shown = names.iter().take(MOST_LISTED).copied().collect::<Vec<_>>().join(", ");
        let others = if names.len() > MOST_LISTED { ", …" } else { "" };
        format!("{}{others}: {numbers}", escape(&shown))
    }));
    if more > 0 {
        items.push(said!("report-pairs-more", "more" => more));
    }
    items
}

/// Stiffness and laws of a pair, and restitution and friction where they are its own.
fn in_force(pair: &PairContact, own: bool) -> String {
    let mut words = format!("K = {}, ", stiffness(pair.stiffness));
    if own {
        let _ = write!(
            words,
            "e_n = {}, e_t = {}, μ_s = {}, μ_k = {}, ",
            trimmed(pair.restitution_normal),
            trimmed(pair.restitution_tangential),
            trimmed(pair.mu_static),
            trimmed(pair.mu_kinetic)
        );
    }
    let normal = word_told(NormalName::WORDS, pair.normal_law.label());
    let friction = word_told(FrictionLaw::WORDS, pair.law.label());
    words + &escape(&said!("report-laws", "normal" => normal, "friction" => friction))
}

/// The table that a key stands in, by its path; none at the top.
fn whose(path: &str) -> Option<&str> {
    path.rsplit_once('.').map(|(table, _)| table)
}

/// Numbers that are not given, those of one table in one line.
fn not_given(listed: &Listed) -> Vec<String> {
    let tables = listed.chunk_by(|(a, _), (b, _)| whose(a) == whose(b));
    let line = |table: &[(String, String)]| {
        let keys = table.iter().map(|(path, value)| {
            let key = whose(path).map_or(path.as_str(), |of| &path[of.len() + 1..]);
            format!("{} = {}", escape(key), escape(value))
        });
        let of =
            table.first().and_then(|(path, _)| whose(path)).map_or(String::new(), |of| format!("{}: ", escape(of)));
        format!("{of}{} {} {}", keys.collect::<Vec<_>>().join(", "), mark(), Text::new("report-not-given"))
    };
    tables.map(line).collect()
}

/// Numbers in force of equal bearings of a whole deck: their loop, its effective stiffness and equivalent damping at the largest movement
/// of the run, and which of them follow from the size of the deck.
fn of_bearings(scene: &Scene, report: &Report) -> Vec<String> {
    let of = |girder: &crate::scene::Girder| {
        let Some(Bearings::Deck(deck)) = &girder.bearings else { return None };
        let reached = report.bearings.iter().find(|bearings| bearings.girder == girder.name);
        let reached: Vec<f64> = reached.map(|bearings| bearings.deformation).into_iter().collect();
        let [together, effective] = super::in_force::deck_bearings(deck, girder, scene.setting(), &reached);
        let assumed: Vec<String> =
            deck.assumed().into_iter().map(|(key, number)| format!("{key} = {}", six(number))).collect();
        let assumed = if assumed.is_empty() { String::new() } else { format!("{} {}", assumed.join(", "), mark()) };
        let parts = [escape(&together), escape(&effective), assumed].into_iter().filter(|part| !part.is_empty());
        Some(format!("{}: {}", escape(&girder.name), parts.collect::<Vec<_>>().join("; ")))
    };
    scene.girders.iter().filter_map(of).take(MOST_LISTED).collect()
}

/// Numbers in force of piers and of the soil behind backwalls.
fn of_supports(scene: &Scene) -> Vec<String> {
    let piers = in_force::piers(scene).take(MOST_LISTED).map(|lines| escape(&lines.join("; ")));
    let more = scene.piers.len().saturating_sub(MOST_LISTED);
    let more = (more > 0).then(|| said!("report-piers-more", "more" => more));
    let soil = scene.abutments.iter().filter_map(|abutment| in_force::soil(scene, abutment));
    let soil = soil.map(|lines| {
        escape(&lines.join("; ")).replace(Text::new("check-soil-assumed").as_str(), &format!(" {}", mark()))
    });
    piers.chain(more).chain(soil).collect()
}

/// Inputs of codes that the scene does not give.
fn of_codes(report: &Report) -> Vec<String> {
    let mut inputs: Vec<String> = Vec::new();
    for DemandReport { demand, .. } in report.seats.iter().flat_map(|seat| &seat.codes) {
        let assumed = demand.inputs.iter().filter(|input| input.source == Source::Assumed);
        let values: Vec<String> = assumed.map(input_words).collect();
        let words = format!("{}: {} {}", escape(&demand.rule), values.join(", "), mark());
        if !values.is_empty() && !inputs.contains(&words) {
            inputs.push(words);
        }
    }
    inputs
}
