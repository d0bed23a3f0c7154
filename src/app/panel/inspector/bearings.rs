//! Bearings: equal ones by frequency and damping, or each with its own place, springs and dashpots.

use egui::{ComboBox, RichText, Ui};

use super::rows::{grid, note};
use super::sliders;
use crate::app::field::{
    CLICK, Change, Look, Named, Place, Without, act, named, number, optional, rows, switched, tag,
};
use crate::app::unit::{HERTZ, PURE, Size, Unit, damping_unit, force_unit, length_unit, stiffness_unit};
use crate::app::{edits, text};
use crate::scene::keys::Key;
use crate::scene::{
    Bearing, BearingKind, Bearings, Girder, Kind, PerDirection, STANDARD_GRAVITY, Scene, SharedBearings,
};

/// Q of all bearings per weight \[–\], and k₁/k₂ \[–\], of a lead-rubber bearing to begin with: usual Japanese values, from
/// memory.
const USUAL_FORCE: f64 = 0.07;
const USUAL_RATIO: f64 = 6.5;
/// Displacement at which a slider without a stiffness of its own yields to begin with \[m\].
const SLIDER_YIELD: f64 = 5e-4;

/// Girder whose bearings have rows.
#[derive(Clone, Copy)]
struct BearingRow {
    /// Kind of the scene, by which a bearing has two directions or three.
    kind: Kind,
    /// Unit of lengths.
    unit: Unit,
    /// Height of the girder's underside above G \[m\], where a bearing is attached whose height is not given.
    underside: f64,
}

/// Shows a girder's bearings.
pub(super) fn show(ui: &mut Ui, (place, scene): (Place<'_>, &Scene), kind: Kind, g: &mut Girder) -> Option<Change> {
    let (length, shear) = (length_unit(g.length), g.prism().shear());
    let row = BearingRow { kind, unit: length, underside: -0.5 * g.thickness };
    let deck_radius = match &g.bearings {
        Some(Bearings::Deck(deck)) => deck.radius(STANDARD_GRAVITY),
        _ => 0.0,
    };
    match &mut g.bearings {
        Some(Bearings::Shared(shared)) => {
            let numbers = grid(ui, "bearings", |ui| {
                let rows = shared_rows(ui, place, kind, shared);
                let rows = rows.or(height_row(ui, place, row, "bearings.height_m", &mut shared.height));
                let minus = (&mut shared.on_minus_x, "bearings.on_minus_x", text::ON_MINUS.as_str());
                let plus = (&mut shared.on_plus_x, "bearings.on_plus_x", text::ON_PLUS.as_str());
                let rows = rows.or(sliders::travel(ui, place, length, &mut shared.travel));
                [minus, plus].into_iter().fold(rows, |change, on| change.or(on_row(ui, place, scene, on)))
            });
            let places = places(ui, place, length, shear, (&mut shared.at, &mut shared.at_skewed));
            numbers.or(places).or(end(ui, place, g, kind))
        }
        Some(Bearings::Deck(deck)) => {
            let size = Size { length: g.length, mass: g.mass };
            let table = format!("{}.bearings", place.table);
            let assumed = deck.assumed();
            let reckoned = |key: &Key| {
                let number = assumed.iter().find(|(name, _)| *name == key.name).map(|(_, number)| *number);
                number.unwrap_or(if key.name == "radius_m" { deck_radius } else { 0.0 })
            };
            let whole = Place { table: &table, ..place };
            let look = Look { without: Without::Reckoned(&reckoned), ..Look::new(whole, kind, size) };
            let numbers = grid(ui, "bearings", |ui| {
                let others = deck.not_of_this_kind();
                let rows = rows(ui, &look, deck, &others);
                let minus = (&mut deck.on_minus_x, "bearings.on_minus_x", text::ON_MINUS.as_str());
                let plus = (&mut deck.on_plus_x, "bearings.on_plus_x", text::ON_PLUS.as_str());
                [minus, plus].into_iter().fold(rows, |change, on| change.or(on_row(ui, place, scene, on)))
            });
            let places = places(ui, place, length, shear, (&mut deck.at, &mut deck.at_skewed));
            numbers.or(places).or(end(ui, place, g, kind))
        }
        Some(Bearings::Each(each)) => {
            let weight = g.mass * STANDARD_GRAVITY;
            let changed = list(ui, (place, scene), row, weight, each);
            if each.is_empty() {
                g.bearings = None;
            }
            changed
        }
        None => {
            grid(ui, "no bearings", |ui| note(ui, text::BEARINGS_NONE.as_str()));
            let shared = act(ui, place, "bearings", text::BEARINGS_ADD.as_str());
            let lead = act(ui, place, "bearings", text::BEARINGS_ADD_LEAD.as_str());
            let pendulum = act(ui, place, "bearings", text::BEARINGS_ADD_PENDULUM.as_str());
            g.bearings = match (shared, lead, pendulum) {
                (true, ..) => Some(Bearings::Shared(edits::four_below(g))),
                (_, true, _) => Some(edits::of_deck(BearingKind::LeadRubber, g)),
                (.., true) => Some(edits::of_deck(BearingKind::Pendulum, g)),
                _ => return None,
            };
            CLICK
        }
    }
}

/// Ways out of bearings of one kind for a whole deck: another kind where they stand, a list of single ones, or none.
fn end(ui: &mut Ui, place: Place<'_>, g: &mut Girder, kind: Kind) -> Option<Change> {
    let Some(now) = &g.bearings else { return None };
    let others = match now {
        Bearings::Shared(_) => vec![
            (text::BEARINGS_ADD_LEAD.as_str(), edits::of_deck(BearingKind::LeadRubber, g)),
            (text::BEARINGS_ADD_PENDULUM.as_str(), edits::of_deck(BearingKind::Pendulum, g)),
        ],
        _ => vec![(text::BEARINGS_LINEAR.as_str(), Bearings::Shared(edits::four_below(g)))],
    };
    for (label, other) in others {
        if act(ui, place, "bearings", label) {
            g.bearings = Some(other.where_stand(now));
            return CLICK;
        }
    }
    let each = ui.button(text::BEARINGS_ONE_BY_ONE).on_hover_text(text::BEARINGS_ONE_BY_ONE_HINT).clicked();
    let gone = act(ui, place, "bearings", text::BEARINGS_REMOVE.as_str());
    if each {
        g.bearings = Some(edits::one_by_one(g, kind));
    } else if gone {
        g.bearings = None;
    }
    if each || gone { CLICK } else { None }
}

fn tidy(place: [f64; 2]) -> [f64; 2] {
    place.map(edits::micrometres)
}

/// Places of equal bearings: in the girder's own frame, or in the frame that is skewed with it.
fn places(ui: &mut Ui, place: Place<'_>, unit: Unit, shear: f64, (at, skewed): Places<'_>) -> Option<Change> {
    let follows = follows_skew(ui, place, shear, (&mut *at, &mut *skewed));
    let lists = [("bearings.at_m", at, text::AT), ("bearings.at_skewed_m", skewed, text::AT_SKEWED)];
    let mut change = None;
    for (key, list, title) in lists {
        let Some(list) = list.as_mut() else { continue };
        ui.label(RichText::new(title).weak().small());
        change = change.or(place_rows(ui, place, unit, key, list));
    }
    change.or(follows)
}

/// Places in the girder's frame, and those before skewing.
type Places<'a> = (&'a mut Option<Vec<[f64; 2]>>, &'a mut Option<Vec<[f64; 2]>>);

/// Whether the places go with the skew; switched, the bearings stay where they are.
fn follows_skew(ui: &mut Ui, place: Place<'_>, shear: f64, (at, skewed): Places<'_>) -> Option<Change> {
    let mut follows = skewed.is_some();
    let response = ui.checkbox(&mut follows, text::AT_FOLLOWS);
    let switched =
        tag(ui, &response, place, Named { key: "bearings.at_skewed_m", label: text::AT_FOLLOWS.as_str() }).changed();
    if !switched {
        return None;
    }
    let moved =
        |list: Vec<[f64; 2]>, sign: f64| list.into_iter().map(|[x, y]| tidy([x + sign * y * shear, y])).collect();
    (*at, *skewed) = match (at.take(), skewed.take()) {
        (Some(at), _) => (None, Some(moved(at, -1.0))),
        (None, Some(at)) => (Some(moved(at, 1.0)), None),
        (None, None) => (Some(vec![[0.0; 2]]), None),
    };
    CLICK
}

fn place_rows(ui: &mut Ui, place: Place<'_>, unit: Unit, key: &str, list: &mut Vec<[f64; 2]>) -> Option<Change> {
    let mut change = None;
    let mut gone = None;
    grid(ui, key, |ui| {
        for (n, [x, y]) in list.iter_mut().enumerate() {
            let (name_x, name_y) = (format!("{} {} x", text::BEARING, n + 1), format!("{} {} y", text::BEARING, n + 1));
            change = change.or(number(ui, place, Named { key, label: &name_x }, x, unit));
            change = change.or(number(ui, place, Named { key, label: &name_y }, y, unit));
            ui.label("");
            if ui.small_button(format!("{} {}", text::BEARING_REMOVE, n + 1)).clicked() {
                gone = Some(n);
            }
            ui.end_row();
        }
    });
    if let Some(n) = gone.filter(|_| list.len() > 1) {
        list.remove(n);
        change = CLICK;
    }
    if ui.small_button(text::BEARING_ADD).clicked() {
        list.push([0.0, 0.0]);
        change = CLICK;
    }
    change
}

/// Single bearings, each in a fold of its own.
fn list(
    ui: &mut Ui,
    (place, scene): (Place<'_>, &Scene),
    row: BearingRow,
    weight: f64,
    each: &mut Vec<Bearing>,
) -> Option<Change> {
    let first_yield = USUAL_FORCE * weight / each.len().max(1) as f64;
    let mut change = None;
    let mut gone = None;
    for (n, bearing) in each.iter_mut().enumerate() {
        let title = format!("{} {}", text::BEARING, n + 1);
        super::rows::section(ui, (&format!("bearing {n}"), &title), n == 0, |ui| {
            change = change.or(grid(ui, &format!("bearing {n}"), |ui| {
                let numbers = single(ui, place, row, first_yield, n, bearing);
                let key = format!("bearings[{n}].height_m");
                let numbers = numbers.or(height_row(ui, place, row, &key, &mut bearing.height));
                let key = format!("bearings[{n}].on");
                numbers.or(on_row(ui, place, scene, (&mut bearing.on, &key, text::ON_PIER.as_str())))
            }));
            if ui.small_button(format!("{} {}", text::BEARING_REMOVE, n + 1)).clicked() {
                gone = Some(n);
            }
        });
    }
    if let Some(n) = gone {
        each.remove(n);
        change = CLICK;
    }
    if ui.small_button(text::BEARING_ADD).clicked() {
        let like = each.last().cloned();
        each.extend(like.map(|b| Bearing { at: [0.0; 2], ..b }));
        change = CLICK;
    }
    change
}

fn single(
    ui: &mut Ui,
    place: Place<'_>,
    BearingRow { kind, unit, .. }: BearingRow,
    first_yield: f64,
    n: usize,
    b: &mut Bearing,
) -> Option<Change> {
    let at = format!("bearings[{n}].at_m");
    let [x, y] = &mut b.at;
    let mut changes = vec![
        number(ui, place, Named { key: &at, label: text::BEARING_X.as_str() }, x, unit),
        number(ui, place, Named { key: &at, label: text::BEARING_Y.as_str() }, y, unit),
    ];
    let ways = if kind == Kind::Planar { 2 } else { 3 };
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate().take(ways) {
        let (k, c) = (&mut b.stiffness[axis], &mut b.damping[axis]);
        let key = (format!("bearings[{n}].stiffness_n_per_m"), format!("bearings[{n}].damping_n_s_per_m"));
        let (unit_k, unit_c) = (stiffness_unit(*k), damping_unit(*c));
        changes.push(number(ui, place, Named { key: &key.0, label: &format!("k {name}") }, k, unit_k));
        changes.push(number(ui, place, Named { key: &key.1, label: &format!("c {name}") }, c, unit_c));
    }
    changes.extend([yield_rows(ui, place, unit, n, b, first_yield), sliders::rows_of(ui, place, kind, n, b)]);
    changes.into_iter().flatten().next()
}

/// Force and displacement of yield, if it has any, and whether each axis yields for itself. Both begin at `first`, as a bearing
/// is commonly designed.
fn yield_rows(ui: &mut Ui, place: Place<'_>, unit: Unit, n: usize, b: &mut Bearing, first: f64) -> Option<Change> {
    let key = |name: &str| format!("bearings[{n}].{name}");
    let force = b.yield_force.unwrap_or(first);
    let newton = force_unit(force / STANDARD_GRAVITY);
    let yields = switched(
        ui,
        place,
        Named { key: &key("yield_force_n"), label: text::BEARING_YIELD.as_str() },
        (&mut b.yield_force, first),
        newton,
    );
    if b.yield_force.is_none() {
        (b.yield_displacement, b.per_axis) = (None, None);
        return yields;
    }
    let elastic = (USUAL_RATIO - 1.0) * b.stiffness[0];
    let at = b.yield_displacement.get_or_insert(if elastic > 0.0 { force / elastic } else { SLIDER_YIELD });
    let moved = number(
        ui,
        place,
        Named { key: &key("yield_displacement_m"), label: text::BEARING_YIELDS_AT.as_str() },
        at,
        unit,
    );
    let mut per_axis = b.per_axis == Some(true);
    let response = ui.checkbox(&mut per_axis, text::BEARING_PER_AXIS);
    let turned =
        tag(ui, &response, place, Named { key: &key("yields_per_axis"), label: text::BEARING_PER_AXIS.as_str() })
            .changed();
    ui.end_row();
    if turned {
        b.per_axis = per_axis.then_some(true);
        return CLICK;
    }
    yields.or(moved)
}

/// The pier or abutment that bearings stand on; no row where it makes no difference: without piers, on ground that moves as one.
fn on_row(
    ui: &mut Ui,
    place: Place<'_>,
    scene: &Scene,
    (on, key, label): (&mut Option<String>, &str, &str),
) -> Option<Change> {
    if scene.piers.is_empty() && on.is_none() && scene.moving_supports().is_none() {
        return None;
    }
    let before = on.clone();
    let name = ui.label(named(ui, place, Named { key, label }));
    let now = on.as_deref().unwrap_or(text::ON_GROUND.as_str()).to_owned();
    let combo = ComboBox::from_id_salt(key).width(79.0).selected_text(now).show_ui(ui, |ui| {
        if ui.selectable_label(on.is_none(), text::ON_GROUND).clicked() {
            *on = None;
        }
        let piers = scene.piers.iter().map(|pier| &pier.name);
        for name in piers.chain(scene.abutments.iter().map(|abutment| &abutment.name)) {
            if ui.selectable_label(on.as_ref() == Some(name), name).clicked() {
                *on = Some(name.clone());
            }
        }
    });
    tag(ui, &combo.response.labelled_by(name.id), place, Named { key, label });
    ui.end_row();
    if *on == before { None } else { CLICK }
}

/// Height of the attachment points, at the underside where it is not given; none in plan.
fn height_row(
    ui: &mut Ui,
    place: Place<'_>,
    BearingRow { kind, unit, underside }: BearingRow,
    key: &str,
    height: &mut Option<f64>,
) -> Option<Change> {
    if kind == Kind::Planar {
        return None;
    }
    optional(ui, place, Named { key, label: text::BEARING_HEIGHT.as_str() }, (height, underside), unit)
}

fn shared_rows(ui: &mut Ui, place: Place<'_>, kind: Kind, b: &mut SharedBearings) -> Option<Change> {
    let ([mut fx, mut fy], [mut hx, mut hy]) = (b.frequency_hz.xy(), b.damping_ratio.xy());
    let frequency = [
        number(ui, place, Named { key: "bearings.frequency_hz", label: text::FREQUENCY_X.as_str() }, &mut fx, HERTZ),
        number(ui, place, Named { key: "bearings.frequency_hz", label: text::FREQUENCY_Y.as_str() }, &mut fy, HERTZ),
    ];
    let damping = [
        number(ui, place, Named { key: "bearings.damping_ratio", label: text::DAMPING_X.as_str() }, &mut hx, PURE),
        number(ui, place, Named { key: "bearings.damping_ratio", label: text::DAMPING_Y.as_str() }, &mut hy, PURE),
    ];
    if frequency.iter().any(Option::is_some) {
        b.frequency_hz = per_direction(b.frequency_hz, fx, fy);
    }
    if damping.iter().any(Option::is_some) {
        b.damping_ratio = per_direction(b.damping_ratio, hx, hy);
    }
    let vertical = if kind == Kind::Spatial { vertical_rows(ui, place, hx, b) } else { None };
    frequency.into_iter().chain(damping).flatten().next().or(vertical)
}

fn vertical_rows(ui: &mut Ui, place: Place<'_>, hx: f64, b: &mut SharedBearings) -> Option<Change> {
    let mut fz = b.vertical_frequency_hz.unwrap_or(0.0);
    let names = Named { key: "bearings.vertical_frequency_hz", label: text::FREQUENCY_Z.as_str() };
    let frequency = number(ui, place, names, &mut fz, HERTZ);
    if frequency.is_some() {
        b.vertical_frequency_hz = Some(fz);
    }
    let names = Named { key: "bearings.vertical_damping_ratio", label: text::DAMPING_Z.as_str() };
    frequency.or(optional(ui, place, names, (&mut b.vertical_damping_ratio, hx), PURE))
}

/// One number stays one number as long as both directions agree.
fn per_direction(old: PerDirection, x: f64, y: f64) -> PerDirection {
    match old {
        PerDirection::Both(_) if x == y => PerDirection::Both(x),
        _ => PerDirection::Each([x, y]),
    }
}
