//! The section of a gap beside the view, seen from above.

use egui::{Id, Rect, Stroke, Ui, Window, pos2, vec2};

use crate::app::command::{Command, Sight, ViewCommand};
use crate::app::style::theme::{Palette, SLIP, STICK};
use crate::app::text;
use crate::app::viewport::seen::Seen;
use crate::sim::{ContactState, History, readings};
use crate::view::Target;

/// The pair whose section is shown: of the selected contact or body, else the first.
fn pair_shown(seen: &Seen<'_>, history: &History) -> Option<usize> {
    let pairs = &history.model().pairs;
    let of = match seen.selection.last().copied() {
        Some(Target::Contact(c)) => history.model().sites.get(c).map(|site| site.pair),
        Some(Target::Girder(i)) => pairs.iter().position(|p| p.bodies.contains(&Some(i))),
        Some(Target::Abutment(i)) => {
            let name = seen.scene.abutments.get(i).map(|a| a.name.clone())?;
            pairs.iter().position(|p| p.name.ends_with(&format!("|{name}")))
        }
        Some(Target::Pier(_) | Target::Device(_)) | None => None,
    };
    of.or((!pairs.is_empty()).then_some(0))
}

/// The section of a gap seen from above, the distance of the faces drawn larger by a factor that is shown.
pub(in crate::app) fn show(ui: &Ui, rect: Rect, seen: &Seen<'_>, out: &mut Vec<Command>) {
    if !seen.display.sight.section {
        return;
    }
    let Some(answer) = seen.answer() else { return };
    let Some(pair) = pair_shown(seen, &answer.history) else { return };
    let t = seen.t();
    let mut open = true;
    Window::new(text::GAP_SECTION)
        .open(&mut open)
        .id(Id::unique("gap section"))
        .default_pos(rect.left_bottom() + vec2(12.0, -212.0))
        .default_size([230.0, 150.0])
        .resizable(false)
        .show(ui, |ui| draw(ui, &answer.history, pair, t));
    if !open {
        out.push(ViewCommand::Sight(Sight { section: false, ..seen.display.sight }).into());
    }
}

/// A node before its face: place along the face and gap \[m\], and its state.
struct Before {
    along: f64,
    gap: f64,
    state: ContactState,
}

fn draw(ui: &mut Ui, history: &History, pair: usize, t: f64) {
    let model = history.model();
    let nodes: Vec<Before> = model.pairs[pair]
        .sites
        .clone()
        .map(|c| {
            let [gap, along] = readings::before_face(history, c, t);
            let state = history.contacts().contact_at(c, t).map_or(ContactState::Open, |now| now.state);
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
