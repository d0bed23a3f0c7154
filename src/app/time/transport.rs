//! Play, step, jump, speed: the row over the timeline.

use egui::{Button, ComboBox, RichText, Ui};

use crate::app::command::{Command, Pane, TimeCommand, Way, WindowCommand};
use crate::app::style::icons::{self, Icon};
use crate::app::text;
use crate::app::time::clock::{Clock, SPEEDS};
use crate::app::time::playback::Playback;
use crate::scene::Motion;

/// Width of a row with everything in it \[points\]; in a narrower one, how it is played goes into a menu.
const WIDE: f32 = 800.0;

/// Button for the plots at the right end of the row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) enum PlotsButton {
    /// None: there are no plots.
    Absent,
    /// One that opens the plots, which are folded.
    Folded,
    /// One that folds the plots, which are open.
    Open,
}

/// Shows the row; time is also counted in periods of the motion.
pub(in crate::app) fn show(
    ui: &mut Ui,
    playback: &Playback,
    motion: &Motion,
    plots: PlotsButton,
    out: &mut Vec<Command>,
) {
    let clock = &playback.clock;
    let wide = ui.available_width() >= WIDE;
    ui.horizontal(|ui| {
        buttons(ui, clock.playing, out);
        ui.separator();
        if wide {
            how(ui, clock, out);
            ui.separator();
            time(ui, clock.t, motion);
        } else {
            ui.label(RichText::new(text::instant(clock.t)).monospace());
            ui.menu_button(text::PLAYING, |ui| how(ui, clock, out));
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            match plots {
                PlotsButton::Absent => {}
                PlotsButton::Folded => plots_button(ui, true, out),
                PlotsButton::Open => plots_button(ui, false, out),
            }
            whole(ui, playback, wide, out);
        });
    });
}

/// Speed, repetition, slowness around hits.
fn how(ui: &mut Ui, clock: &Clock, out: &mut Vec<Command>) {
    ui.horizontal(|ui| speed(ui, clock.speed, out));
    let (mut looping, mut slow) = (clock.looping, clock.slow_at_hits);
    if ui.checkbox(&mut looping, text::LOOP).on_hover_text(text::LOOP_HINT).changed() {
        out.push(TimeCommand::Loop(looping).into());
    }
    if ui.checkbox(&mut slow, text::SLOW_AT_HITS).on_hover_text(text::SLOW_HINT).changed() {
        out.push(TimeCommand::SlowAtHits(slow).into());
    }
}

/// Back to the whole run; in a narrow row only where a part of it is shown or played.
fn whole(ui: &mut Ui, playback: &Playback, wide: bool, out: &mut Vec<Command>) {
    let part = playback.window.is_some();
    if wide || part {
        let all = ui.add_enabled(part, Button::new(text::ALL_TIME)).on_hover_text(text::ALL_TIME_HINT);
        if all.clicked() {
            out.push(TimeCommand::Window(None).into());
        }
    }
    if playback.clock.span.is_some() && ui.button(text::ALL_SPAN).on_hover_text(text::ALL_SPAN_HINT).clicked() {
        out.push(TimeCommand::PlaySpan(None).into());
    }
}

/// Folds the plots under the timeline, or opens them.
fn plots_button(ui: &mut Ui, folded: bool, out: &mut Vec<Command>) {
    let words = if folded { text::unfold(Pane::Plots) } else { text::fold(Pane::Plots) };
    if sign(ui, if folded { Icon::Up } else { Icon::Down }, &words, text::pane_key(Pane::Plots)) {
        out.push(WindowCommand::Fold(Pane::Plots, !folded).into());
    }
}

/// A button with a sign on it and words for those who cannot see it.
fn sign(ui: &mut Ui, icon: Icon, words: &str, keys: &str) -> bool {
    let response = ui.add(Button::new("").min_size(egui::vec2(28.0, 22.0)));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, words));
    let color = ui.style().interact(&response).text_color();
    icons::draw(ui.painter(), response.rect, icon, color);
    response.on_hover_text(format!("{words} ({keys})")).clicked()
}

fn buttons(ui: &mut Ui, playing: bool, out: &mut Vec<Command>) {
    let (play, word) = if playing { (Icon::Pause, text::PAUSE) } else { (Icon::Play, text::PLAY) };
    let row = [
        (Icon::Start, text::TO_START, "Home", Command::Time(TimeCommand::Seek(0.0))),
        (Icon::PreviousEvent, text::PREVIOUS_EVENT, "Ctrl Left", Command::Time(TimeCommand::StepEvent(Way::Back))),
        (Icon::StepBack, text::STEP_BACK, "Left", Command::Time(TimeCommand::Step(-1.0))),
        (play, word, "Space", Command::Time(TimeCommand::TogglePlay)),
        (Icon::StepForward, text::STEP_FORWARD, "Right", Command::Time(TimeCommand::Step(1.0))),
        (Icon::NextEvent, text::NEXT_EVENT, "Ctrl Right", Command::Time(TimeCommand::StepEvent(Way::Forward))),
        (Icon::End, text::TO_END, "End", Command::Time(TimeCommand::Seek(f64::INFINITY))),
    ];
    for (icon, words, keys, command) in row {
        if sign(ui, icon, &words, keys) {
            out.push(command);
        }
    }
}

fn speed(ui: &mut Ui, now: f64, out: &mut Vec<Command>) {
    let mut chosen = now;
    let label = ui.label(text::SPEED);
    let combo = ComboBox::from_id_salt("speed").width(64.0).selected_text(text::speed(now)).show_ui(ui, |ui| {
        for option in SPEEDS {
            ui.selectable_value(&mut chosen, option, text::speed(option));
        }
    });
    combo.response.labelled_by(label.id).on_hover_text(", .");
    if chosen != now {
        out.push(TimeCommand::Speed(chosen).into());
    }
}

/// The time in seconds and in periods of the shaking.
fn time(ui: &mut Ui, t: f64, motion: &Motion) {
    ui.label(RichText::new(text::instant(t)).monospace());
    // In a narrow window the buttons at the other end come first.
    if let Some(period) = period(motion).filter(|_| ui.available_width() > 200.0) {
        ui.label(RichText::new(text::periods(t / period)).monospace().weak());
    }
}

/// Period of the shaking, to count time in \[s\].
fn period(motion: &Motion) -> Option<f64> {
    match motion {
        Motion::Sine(sine) if sine.frequency_hz > 0.0 => Some(1.0 / sine.frequency_hz),
        _ => None,
    }
}
