//! The window of the angles: how far it has come, a polar plot of each measure, the worst angle in words.

use egui::{Id, RichText, Ui, Window, vec2};

use super::angles::{Angles, Turned, can_turn};
use super::polar::{self, Polar};
use super::progress;
use crate::app::command::{AngleCommand, Command};
use crate::app::text;
use crate::scene::Scene;

/// Width and height of a plot \[points\].
const PLOT: [f32; 2] = [236.0, 236.0];

/// Shows the window while it is open.
pub(in crate::app) fn show(ui: &mut Ui, angles: &Angles, scene: &Scene, out: &mut Vec<Command>) {
    if !angles.is_open() {
        return;
    }
    let mut open = true;
    let room = ui.content_rect();
    let window = Window::new(text::ANGLES).id(Id::unique("angles")).open(&mut open).resizable(false);
    window.default_pos(room.left_top() + vec2(255.0, 60.0)).show(ui, |ui| {
        if !can_turn(scene) {
            ui.label(text::ANGLES_STILL);
            return;
        }
        let [again, cancel] = [AngleCommand::Compute, AngleCommand::Cancel].map(Command::from);
        progress::show(ui, &angles.background, &text::OF_ANGLES, [again, cancel], out);
        if let Some(turned) = angles.turned() {
            ui.horizontal_top(|ui| plots(ui, angles, turned, scene, out));
            ui.label(RichText::new(text::ANGLES_HINT).weak().small());
        }
    });
    if !open {
        out.push(AngleCommand::Show(false).into());
    }
}

fn plots(ui: &mut Ui, angles: &Angles, turned: &Turned, scene: &Scene, out: &mut Vec<Command>) {
    for number in 0..turned.plan.measures.len() {
        let polar = Polar::of(turned, number, angles.background.own(0));
        ui.vertical(|ui| {
            ui.set_width(PLOT[0]);
            // Values stand in the plot with their units.
            ui.label(RichText::new(turned.measure(number).label).strong());
            if let Some(chosen) = polar::show(ui, PLOT.into(), &polar, scene) {
                out.push(AngleCommand::Go(chosen).into());
            }
            if let Some(worst) = polar.worst() {
                let whole = angles.progress().is_none();
                let words = text::worst(whole, &polar.angle_of(worst), &polar.value_of(worst));
                if ui.link(words).clicked() {
                    out.push(AngleCommand::Go(worst).into());
                }
            }
        });
    }
}
