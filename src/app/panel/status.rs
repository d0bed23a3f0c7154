//! The line at the bottom: how large, how many, how exact, how fast, drawn by what.

use egui::{RichText, TextStyle, TextWrapMode, Ui, WidgetText};

use crate::app::command::{Command, Look, SelectCommand, TimeCommand, ViewCommand};
use crate::app::panel::limits;
use crate::app::run::answer::Answer;
use crate::app::run::runner::Runner;
use crate::app::run::spot::Spot;
use crate::app::style::theme::{Palette, greyed};
use crate::app::text;
use crate::scene::Limits;
use crate::sim::moving_ground;
use crate::sim::readings::Passed;
use crate::sim::{History, SolidId};
use crate::view::Target;

/// Shows the line: what became of the scene's run, limits that it passes, what draws. Where not all has room, figures yield to warnings.
pub(in crate::app) fn show(
    ui: &mut Ui,
    runner: &Runner,
    (limits, empty, adapter): (Limits, bool, &str),
    out: &mut Vec<Command>,
) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 14.0;
        // Warnings stand behind the figures: how wide they are is known from the frame before, or from a second pass over this one.
        let known = ui.scope_id().with("warnings");
        let before: f32 = ui.data(|data| data.get_temp(known)).unwrap_or(0.0);
        let room = ui.max_rect().right() - before;
        if empty {
            ui.label(RichText::new(text::START_NOTHING).weak());
        } else if let Some(problems) = runner.problems() {
            let first = problems.0.first().map(|e| format!("{}: {}", e.place, e.remedy)).unwrap_or_default();
            ui.add(egui::Label::new(RichText::new(first).color(Palette::of(ui).problem)).truncate());
        } else if let Some(answer) = runner.answer() {
            greyed(ui, runner.shows_older(), |ui| numbers(ui, answer, room, out));
        }
        let (left, mut cut) = (ui.cursor().left(), 0.0);
        if runner.is_coarse() {
            let follows = runner.progress().is_some() || !runner.is_stale();
            let words = if follows { text::COARSE } else { text::COARSE_ALONE };
            ui.label(RichText::new(words).strong()).on_hover_text(text::COARSE_MEANS);
        }
        if let Some(answer) = runner.fresh_answer() {
            balance(ui, answer);
            frictionless(ui, answer);
            outside(ui, answer);
            falls(ui, answer, out);
            overlaps(ui, answer, out);
            law_sense(ui, answer, out);
            soils(ui, answer, out);
            drifting(ui, answer);
            cut = flag(ui, runner, runner.passed(limits).unwrap_or_default(), out);
        }
        let warnings = ui.cursor().left() - left + cut;
        if warnings != before {
            ui.data_mut(|data| data.insert_temp(known, warnings));
            ui.ctx().request_discard("what has room beside warnings");
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.add(egui::Label::new(RichText::new(adapter).weak().small()).truncate());
        });
    });
}

/// That the scene lies outside the domain, and in what.
fn outside(ui: &mut Ui, answer: &Answer) {
    if answer.outside.is_empty() {
        return;
    }
    let words: Vec<String> = answer.outside.iter().map(ToString::to_string).collect();
    ui.label(RichText::new(text::OUTSIDE).color(Palette::of(ui).problem)).on_hover_text(words.join("\n"));
}

/// The energy ledger, where it does not balance.
fn balance(ui: &mut Ui, answer: &Answer) {
    if !answer.balance.holds() {
        let words = RichText::new(text::UNBALANCED).color(Palette::of(ui).problem);
        ui.label(words).on_hover_text(answer.balance.to_string());
    }
}

/// That contacts of the impact model went on without friction.
fn frictionless(ui: &mut Ui, answer: &Answer) {
    if let Some(words) = &answer.frictionless {
        ui.label(RichText::new(text::FRICTIONLESS).color(Palette::of(ui).problem)).on_hover_text(words.to_string());
    }
}

/// That soil was pushed further than its law goes; a click selects the abutment and goes to that moment.
fn soils(ui: &mut Ui, answer: &Answer, out: &mut Vec<Command>) {
    let beyond = || answer.soils().iter().filter_map(|soil| Some((soil, soil.fails()?)));
    let Some((soil, _)) = beyond().next() else { return };
    let words: Vec<String> = beyond().map(|(_, words)| words).collect();
    let label = ui.link(RichText::new(text::SOIL_OVERPUSHED).color(Palette::of(ui).problem));
    if label.on_hover_text(format!("{}\n{}", words.join("\n"), text::GO_THERE)).clicked() {
        let abutments = &answer.history.scene().abutments;
        if let Some(number) = abutments.iter().position(|abutment| abutment.name == soil.abutment) {
            out.push(SelectCommand::Only(Some(Target::Abutment(number))).into());
        }
        out.push(TimeCommand::StandAt(soil.t).into());
    }
}

/// The first girder that does not stay on its seats, and how many more; a click goes there.
fn falls(ui: &mut Ui, answer: &Answer, out: &mut Vec<Command>) {
    if let [(girder, verdict), more @ ..] = answer.falls() {
        let more = if more.is_empty() { String::new() } else { format!(" (+{})", more.len()) };
        let name = answer.history.scene().girders.get(*girder).map_or("", |girder| girder.name.as_str());
        let carried = if answer.goes_on_as_carried() { format!("\n{}", text::GOES_ON) } else { String::new() };
        let words = format!("{name} {}{carried}", verdict.words());
        let label = RichText::new(format!("{name} {}{more}", text::falls(verdict))).color(Palette::of(ui).problem);
        if ui.link(label).on_hover_text(format!("{words}\n{}", text::GO_THERE)).clicked() {
            Spot::verdict(*girder, verdict).go(out);
        }
    }
}

/// The first overlap that no contact carries, and how many more; a click goes there.
fn overlaps(ui: &mut Ui, answer: &Answer, out: &mut Vec<Command>) {
    if let [first, more @ ..] = answer.history.overlaps() {
        let more = if more.is_empty() { String::new() } else { format!(" (+{})", more.len()) };
        let words = format!("{}{more}", text::overlap(&answer.history, first));
        let label = ui.link(RichText::new(words).color(Palette::of(ui).problem)).on_hover_text(text::OVERLAP_MEANS);
        if label.clicked() {
            out.push(TimeCommand::StandAt(first.first()).into());
            if let SolidId::Girder(girder) = first.bodies[0] {
                out.push(ViewCommand::Look(Look::Girder(girder)).into());
            }
        }
    }
}

/// That the records of supports leave them moving against one another, and by how much.
fn drifting(ui: &mut Ui, answer: &Answer) {
    let words = moving_ground::drifting(&answer.moved);
    if !words.is_empty() {
        let label = RichText::new(text::DRIFTING).color(Palette::of(ui).problem);
        ui.label(label).on_hover_text(words.join("\n"));
    }
}

/// Part of the largest energy in play from which what contacts lost over the edges of faces is a fault of the answer and no detail of
/// it: a hundredth of the energy is half a hundredth of a velocity. Chosen.
const LOST_MUCH: f64 = 0.01;

/// That contacts were pressed too deep for their law, or left a face with energy in their springs.
fn law_sense(ui: &mut Ui, answer: &Answer, out: &mut Vec<Command>) {
    let words = text::law_sense(&answer.history, &answer.too_deep, answer.dropped.as_ref());
    if !words.is_empty() {
        let label = if answer.too_deep.is_empty() { text::LEFT_FACE } else { text::BEYOND_LAW };
        let detail = answer.too_deep.is_empty() && answer.dropped.is_some_and(|dropped| dropped.share < LOST_MUCH);
        let palette = Palette::of(ui);
        let label = RichText::new(label).color(if detail { palette.weak } else { palette.problem });
        let deepest = answer.too_deep.first().map(|deep| Spot::contact(deep.contact, deep.depth.t));
        let spot = deepest.or(answer.dropped.as_ref().map(|dropped| Spot::end_of_touch(&answer.history, dropped)));
        let response = ui.link(label).on_hover_text(format!("{}\n{}", words.join("\n"), text::GO_THERE));
        if let Some(spot) = spot.filter(|_| response.clicked()) {
            spot.go(out);
        }
    }
}

/// The first limit that is passed, and how many more; how much of it is cut \[points\].
fn flag(ui: &mut Ui, runner: &Runner, passed: &[Passed], out: &mut Vec<Command>) -> f32 {
    if let [first, more @ ..] = passed {
        let more = if more.is_empty() { String::new() } else { format!(" (+{})", more.len()) };
        let words = format!("{}{more}", text::passed(first));
        let words = RichText::new(words).color(Palette::of(ui).problem);
        let whole = width(ui, words.clone());
        let response = ui.add(egui::Button::new(words).frame(false).truncate()).on_hover_text(text::GO_THERE);
        if response.clicked() {
            limits::go_to(runner, first, out);
        }
        return (whole - response.rect.width()).max(0.0);
    }
    0.0
}

/// Width of a word or figure on one line \[points\].
fn width(ui: &Ui, words: impl Into<WidgetText>) -> f32 {
    words.into().into_galley(ui, Some(TextWrapMode::Extend), f32::INFINITY, TextStyle::Button).size().x.ceil()
}

/// The run's figures, as many as end left of `room` \[points\].
fn numbers(ui: &mut Ui, answer: &Answer, room: f32, out: &mut Vec<Command>) {
    let s = &answer.summary;
    let error = match answer.error() {
        None => "…".to_owned(),
        Some(estimate) => {
            let length = text::length(estimate.error);
            // The rotation too where a corner errs by that more.
            if answer.history.model().farthest_corner() * estimate.rotation > estimate.error {
                format!("{length}, {}°", text::short(estimate.rotation.to_degrees()))
            } else {
                length
            }
        }
    };
    let values = [
        text::length(s.max_displacement),
        format!("{}°", text::short(s.max_rotation.to_degrees())),
        s.peak_impulse.map_or_else(|| text::force(s.peak_total), text::impulse),
        s.hits.to_string(),
        format!("{:.0e}", answer.balance.residual),
        error,
        text::run_time(answer.took.as_secs_f64(), answer.times_real_time()),
    ];
    for (number, (value, (name, meaning))) in values.into_iter().zip(text::STATUS).enumerate() {
        let words = format!("{name} {value}");
        if ui.cursor().left() + width(ui, &words) > room {
            break;
        }
        let Some(there) = THERE.get(number) else {
            ui.label(words).on_hover_text(meaning);
            continue;
        };
        // Of the peaks; where one is seen is looked for in a frame only where that matters.
        let carried = answer.carried_from();
        let is_after =
            carried.is_finite() && number < PEAKS && there(&answer.history).is_some_and(|spot| spot.t > carried);
        let (words, meaning) = if is_after {
            let words = RichText::new(text::reached_after(&words)).color(Palette::of(ui).problem);
            (words, format!("{meaning}\n{}\n{}", text::GOES_ON, text::REACHED_AFTER_MEANS))
        } else {
            (RichText::new(words), meaning.to_string())
        };
        let response = ui.add(egui::Button::new(words).frame(false));
        if response.on_hover_text(format!("{meaning}\n{}", text::GO_THERE)).clicked()
            && let Some(spot) = there(&answer.history)
        {
            spot.go(out);
        }
    }
}

/// How many of them, from the first on, are peaks of the run.
const PEAKS: usize = 3;
/// Where the first of the numbers are seen: what moves farthest, what turns most, the hardest touch, the first hit.
const THERE: [fn(&History) -> Option<Spot>; 4] = [Spot::farthest, Spot::most_turned, Spot::hardest, Spot::first_touch];
