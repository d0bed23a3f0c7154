//! The bar at the top: files, presets, undo, placing, views.

use std::path::PathBuf;

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{Button, MenuBar, PopupCloseBehavior, Theme, Ui};

use crate::app::command::{
    AppearanceCommand, Command, EditCommand, Export, FileCommand, FilmCommand, LeaveCommand, MapCommand, PathCommand,
    PlaceCommand, SelectCommand, Tool, ViewCommand, WindowCommand, Wish,
};
use crate::app::disk::recent;
use crate::app::disk::scene_files::SceneFiles;
use crate::app::edits::Document;
use crate::app::host::PAGE;
use crate::app::learn::lesson_panel;
use crate::app::learn::lessons::Learning;
use crate::app::panel::view_menu;
use crate::app::viewport::scene_view::SceneView;
use crate::app::{edits, text};
use crate::scene::{DeviceKind, Scene, ViewPreset, presets};

/// Least width of a bar with all of its buttons, in either language \[points\]. Measured: 660 in English.
const ALL_BUTTONS: f32 = 720.0;

/// Shows the bar for a scene and its files.
pub(in crate::app) fn show(
    ui: &mut Ui,
    files: &SceneFiles,
    (learning, view, paths_here): (Learning, &SceneView, bool),
    out: &mut Vec<Command>,
) {
    let document = &files.document;
    let some = document.selection().lead_body().is_some();
    // Without room for buttons, what they do is in the menus.
    let narrow = ui.available_width() < ALL_BUTTONS;
    MenuBar::new().ui(ui, |ui| {
        ui.menu_button(text::FILE, |ui| file(ui, files.session.recent(), paths_here, out));
        ui.menu_button(text::EDIT, |ui| {
            if narrow {
                steps(ui, document, out);
                ui.separator();
            }
            edit(ui, document.scene(), some, out);
        });
        ui.menu_button(text::PRESETS, |ui| preset_list(ui, document.scene(), out));
        ui.menu_button(text::LEARN, |ui| lesson_panel::menu(ui, learning, out));
        if !narrow {
            ui.separator();
            steps(ui, document, out);
            ui.separator();
            button(ui, some, text::DUPLICATE.as_str(), "Ctrl D", Command::Place(PlaceCommand::Duplicate), out);
            button(ui, some, text::REMOVE.as_str(), "Delete", Command::Place(PlaceCommand::Remove), out);
            ui.separator();
            views(ui, out);
        }
        // Several things are set one after the other.
        let stays = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        MenuButton::new(text::VIEWS).config(stays).ui(ui, |ui| {
            if narrow {
                ui.horizontal(|ui| views(ui, out));
                ui.separator();
            }
            view_menu::menu(ui, view, document, out);
        });
        button(ui, true, &text::MAP_OPEN, &text::MAP_OPEN_HINT, Command::Map(MapCommand::Show(true)), out);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            button(ui, true, text::HELP.as_str(), "F1", Command::Window(WindowCommand::Help(true)), out);
            theme(ui, out);
        });
    });
}

/// Back and forth through the edits.
fn steps(ui: &mut Ui, document: &Document, out: &mut Vec<Command>) {
    let (undo, redo) = (document.undo_label(), document.redo_label());
    for (label, words, keys, command) in
        [(undo, text::UNDO, "Ctrl Z", EditCommand::Undo), (redo, text::REDO, "Ctrl Y", EditCommand::Redo)]
    {
        button(ui, label.is_some(), words.as_str(), &text::keyed(label, keys), Command::Edit(command), out);
    }
}

fn button(ui: &mut Ui, enabled: bool, words: &str, keys: &str, command: Command, out: &mut Vec<Command>) {
    if ui.add_enabled(enabled, Button::new(words)).on_hover_text(keys).clicked() {
        out.push(command);
    }
}

fn file(ui: &mut Ui, used: &[PathBuf], mut paths_here: bool, out: &mut Vec<Command>) {
    item(ui, text::NEW.as_str(), "Ctrl N", Command::File(FileCommand::New), out);
    item(ui, text::OPEN.as_str(), "Ctrl O", Command::File(FileCommand::Ask(Wish::Open)), out);
    if !PAGE {
        ui.menu_button(text::OPEN_RECENT, |ui| recent::show(ui, used, out));
    }
    let items = [
        (text::SAVE, "Ctrl S", Command::File(FileCommand::Save)),
        (text::SAVE_AS, "Ctrl Shift S", Command::File(FileCommand::Ask(Wish::Save))),
        (text::EXPORT_PICTURE, "", Command::File(FileCommand::Ask(Wish::Export(Export::Picture)))),
        (text::EXPORT_PRINT, "", Command::File(FileCommand::Ask(Wish::Export(Export::Print)))),
        (text::EXPORT_FILM, "", Command::Film(FilmCommand::Ask)),
        (text::EXPORT_TABLES, "", Command::File(FileCommand::Ask(Wish::Export(Export::Tables)))),
        (text::EXPORT_REPORT, "", Command::File(FileCommand::Ask(Wish::Export(Export::Report)))),
    ];
    // A page has no threads to make films on.
    for (words, keys, command) in
        items.into_iter().filter(|(_, _, command)| !(PAGE && matches!(command, Command::Film(_))))
    {
        item(ui, &words, keys, command, out);
    }
    ui.separator();
    if PAGE {
        // The browser asks for paths, and closes its pages.
        return item(ui, text::COPY_LINK.as_str(), "", Command::File(FileCommand::CopyLink), out);
    }
    if ui.checkbox(&mut paths_here, text::PATHS_HERE).on_hover_text(text::PATHS_HERE_HINT).changed() {
        out.push(FileCommand::Path(PathCommand::Here(paths_here)).into());
    }
    ui.separator();
    item(ui, text::QUIT.as_str(), "Ctrl Q", Command::Leave(LeaveCommand::Close), out);
}

fn item(ui: &mut Ui, words: &str, keys: &str, command: Command, out: &mut Vec<Command>) {
    if ui.add(Button::new(words).shortcut_text(keys)).clicked() {
        out.push(command);
        ui.close();
    }
}

fn edit(ui: &mut Ui, scene: &Scene, bodies: bool, out: &mut Vec<Command>) {
    let any = !scene.girders.is_empty();
    let items = [
        (true, text::PLACE_GIRDER, "Shift G", Command::View(ViewCommand::Tool(Tool::Girder))),
        (any, text::PLACE_ABUTMENT, "Shift B", Command::View(ViewCommand::Tool(Tool::Abutment))),
        (any, text::ROW_ASK, "Ctrl R", Command::Window(WindowCommand::AskRow(Some(edits::offered_row(scene))))),
        (any, text::SELECT_ALL, "Ctrl A", Command::Select(SelectCommand::All)),
        (bodies, text::DUPLICATE, "Ctrl D", Command::Place(PlaceCommand::Duplicate)),
        (bodies, text::REMOVE, "Delete", Command::Place(PlaceCommand::Remove)),
    ];
    for (enabled, words, keys, command) in items {
        if ui.add_enabled(enabled, Button::new(words).shortcut_text(keys)).clicked() {
            out.push(command);
            ui.close();
        }
    }
    for kind in DeviceKind::ALL {
        let words = text::add_device(*kind);
        if ui.add_enabled(any, Button::new(words)).clicked() {
            out.push(PlaceCommand::AddDevice(*kind).into());
            ui.close();
        }
    }
}

fn preset_list(ui: &mut Ui, scene: &Scene, out: &mut Vec<Command>) {
    for preset in presets::all() {
        let chosen = scene.name == preset.name;
        if ui.add(Button::selectable(chosen, preset.name)).on_hover_text(&*preset.summary).clicked() {
            out.push(FileCommand::OpenPreset(preset.name.to_owned()).into());
            ui.close();
        }
    }
}

fn views(ui: &mut Ui, out: &mut Vec<Command>) {
    let presets = [
        (text::VIEW_ISO, "1", ViewPreset::Iso),
        (text::VIEW_TOP, "2", ViewPreset::Top),
        (text::VIEW_SIDE, "3", ViewPreset::Side),
        (text::VIEW_CONTACT, "4", ViewPreset::Contact),
    ];
    for (words, key, preset) in presets {
        button(ui, true, &words, key, Command::View(ViewCommand::Preset(preset)), out);
    }
    button(ui, true, &text::VIEW_FRAME, &text::FRAME_HINT, Command::View(ViewCommand::Frame), out);
}

fn theme(ui: &mut Ui, out: &mut Vec<Command>) {
    let (words, other) =
        if ui.visuals().dark_mode { (text::THEME_LIGHT, Theme::Light) } else { (text::THEME_DARK, Theme::Dark) };
    button(ui, true, &words, &text::THEME_HINT, Command::Appearance(AppearanceCommand::Theme(other)), out);
}
