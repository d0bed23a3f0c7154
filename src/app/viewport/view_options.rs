//! How the view is looked at: exaggeration, what it follows, the plan beside it, the gap's section, sizes of everything.

use egui::{Button, Id, Rect, Slider, Stroke, Ui, Window, pos2, vec2};
use glam::DVec3;

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::field::slider_row;
use crate::app::style::theme::{Palette, SLIP, STICK};
use crate::app::text;
use crate::sim::{ContactState, History, readings};
use crate::view::Target;

/// Sizes of everything, as shares of the usual one.
pub(in crate::app) const SCALES: [(&str, f32); 5] =
    [("80 %", 0.8), ("100 %", 1.0), ("125 %", 1.25), ("150 %", 1.5), ("200 %", 2.0)];

/// Size of everything in a lecture hall.
pub(in crate::app) const LECTURE: f32 = 1.5;

/// What the camera goes with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follow {
    /// The middle of a girder.
    Middle(usize),
    /// A corner of a girder in plan, 0 to 3.
    Corner(usize, usize),
}

/// How the view is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// How many times larger than they are displacements are shown.
    pub exaggeration: f64,
    /// What the camera goes with.
    pub follow: Option<Follow>,
    /// Whether the plan is shown beside the view.
    pub plan: bool,
    /// Whether the section of the gap is shown.
    pub section: bool,
    /// Whether only the view and the time are shown, large.
    pub lecture: bool,
}

impl Default for Sight {
    fn default() -> Self {
        Self { exaggeration: 1.0, follow: None, plan: false, section: false, lecture: false }
    }
}

/// Where what is followed is at a time \[m\].
pub(in crate::app) fn followed(history: &History, follow: Follow, t: f64) -> Option<DVec3> {
    let (Follow::Middle(girder) | Follow::Corner(girder, _)) = follow;
    let body = history.model().bodies.get(girder)?;
    let motion = history.motion(girder, t);
    let arm = match follow {
        Follow::Middle(_) => DVec3::ZERO,
        Follow::Corner(_, corner) => body.prism.plan_corners().get(corner)?.extend(0.0),
    };
    Some(motion.place + motion.attitude * arm)
}

/// The menu of views beyond the standing ones.
pub(in crate::app) fn menu(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let sight = bench.sight();
    let mut new = sight;
    ui.checkbox(&mut new.plan, text::PLAN_BESIDE);
    ui.checkbox(&mut new.section, text::GAP_SECTION);
    ui.checkbox(&mut new.lecture, text::LECTURE);
    ui.separator();
    ui.label(text::FOLLOW);
    let girder = bench.shown_girder();
    let name = bench.scene().girders.get(girder).map_or("", |g| g.name.as_str());
    ui.radio_value(&mut new.follow, None, text::FOLLOW_NOTHING);
    ui.radio_value(&mut new.follow, Some(Follow::Middle(girder)), text::follow(name, None));
    for corner in 0..4 {
        ui.radio_value(&mut new.follow, Some(Follow::Corner(girder, corner)), text::follow(name, Some(corner)));
    }
    ui.separator();
    ui.label(text::SIZE);
    ui.horizontal(|ui| {
        for (words, scale) in SCALES {
            if ui.add(Button::selectable(ui.zoom_factor() == scale, words)).clicked() {
                out.push(Command::Scale(scale));
            }
        }
    });
    if new != sight {
        out.push(Command::Sight(new));
    }
}

/// The slider of the exaggeration, in the panel of what is shown.
pub(in crate::app) fn exaggeration(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let sight = bench.sight();
    let mut factor = sight.exaggeration;
    let slider = Slider::new(&mut factor, 1.0..=100.0).logarithmic(true).prefix("× ").max_decimals(1);
    if slider_row(ui, text::EXAGGERATION.into(), slider, "").changed() {
        let factor = if factor.is_finite() { factor.clamp(1.0, 1000.0) } else { 1.0 };
        out.push(Command::Sight(Sight { exaggeration: factor, ..sight }));
    }
}

/// The pair whose section is shown: of the selected contact or body, else the first.
fn pair_shown(bench: &Workbench, history: &History) -> Option<usize> {
    let pairs = &history.model().pairs;
    let of = match bench.selected() {
        Some(Target::Contact(c)) => history.model().contacts.get(c).map(|site| site.pair),
        Some(Target::Girder(i)) => pairs.iter().position(|p| p.bodies.contains(&Some(i))),
        Some(Target::Abutment(i)) => {
            let name = bench.scene().abutments.get(i).map(|a| a.name.clone())?;
            pairs.iter().position(|p| p.name.ends_with(&format!("|{name}")))
        }
        None => None,
    };
    of.or((!pairs.is_empty()).then_some(0))
}

/// The section of a gap seen from above, the distance of the faces drawn larger by a factor that is shown.
pub(in crate::app) fn section(ui: &Ui, rect: Rect, bench: &Workbench) {
    if !bench.sight().section {
        return;
    }
    let Some(answer) = bench.answer() else { return };
    let Some(pair) = pair_shown(bench, &answer.history) else { return };
    let t = bench.clock().t;
    Window::new(text::GAP_SECTION)
        .id(Id::unique("gap section"))
        .default_pos(rect.left_bottom() + vec2(12.0, -212.0))
        .default_size([230.0, 150.0])
        .resizable(false)
        .show(ui, |ui| draw_section(ui, &answer.history, pair, t));
}

/// A node before its face: place along the face and gap \[m\], and its state.
struct Before {
    along: f64,
    gap: f64,
    state: ContactState,
}

fn draw_section(ui: &mut Ui, history: &History, pair: usize, t: f64) {
    let model = history.model();
    let nodes: Vec<Before> = model.pairs[pair]
        .contacts
        .clone()
        .map(|c| {
            let [gap, along] = readings::before_face(history, c, t);
            let state = history.contact_at(c, t).map_or(ContactState::Open, |now| now.state);
            Before { along, gap, state }
        })
        .collect();
    let palette = Palette::of(ui);
    let (low, high) =
        nodes.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), n| (a.min(n.along), b.max(n.along)));
    let widest = model.pairs[pair].gap.abs().max(1e-9);
    let size = vec2(230.0, 120.0);
    let (place, _) = ui.allocate_exact_size(size, egui::Sense::hover());
    let painter = ui.painter_at(place);
    painter.rect_filled(place, 2.0, palette.track);
    let span = (high - low).max(1e-9);
    // The gap as placed takes a third of the width.
    let across = f64::from(size.x) / 3.0 / widest;
    let up = f64::from(size.y - 40.0) / span;
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    let at = |n: &Before| {
        let (x, y) =
            (f64::from(place.right()) - 40.0 - n.gap * across, f64::from(place.bottom()) - 20.0 - (n.along - low) * up);
        pos2(x.clamp(-1e5, 1e5) as f32, y.clamp(-1e5, 1e5) as f32)
    };
    let face = Rect::from_min_max(pos2(place.right() - 40.0, place.top()), place.max);
    painter.rect_filled(face, 0.0, palette.line);
    let mut ordered: Vec<&Before> = nodes.iter().collect();
    ordered.sort_by(|a, b| a.along.total_cmp(&b.along));
    let line: Vec<egui::Pos2> = ordered.iter().map(|n| at(n)).collect();
    painter.line(line, Stroke::new(2.0, palette.force));
    for node in &nodes {
        let here = at(node);
        match node.state {
            ContactState::Stick => drop(painter.circle_filled(here, 5.0, STICK)),
            ContactState::Slip => drop(painter.circle_stroke(here, 5.0, Stroke::new(2.5, SLIP))),
            ContactState::Open => drop(painter.circle_stroke(here, 3.0, Stroke::new(1.2, palette.weak))),
        }
    }
    let least = nodes.iter().map(|n| n.gap).fold(f64::INFINITY, f64::min);
    ui.label(text::section(&model.pairs[pair].name, least, across / up));
}
