//! The window in another language than English: chosen by a button, its words fit, its letters are there.

use std::fs;
use std::path::Path;

use egui::{FontFamily, FontId};
use egui_kittest::kittest::Queryable as _;
use girderbench::app::{AppearanceCommand, SelectCommand};
use girderbench::language::Language;
use girderbench::scene::presets;
use girderbench::view::Target;

use super::harness::{bench, builder, open, press, reach, settle, show, slide};

#[test]
fn the_language_is_chosen_in_the_menu_of_views_and_taken_back() {
    let mut harness = open(presets::OPENING);
    press(&mut harness, "View");
    reach(&mut harness, "日本語");
    press(&mut harness, "日本語");
    assert_eq!(harness.state().window.language, Language::Japanese, "chosen");
    harness.run_steps(4);
    assert!(harness.query_by_label("3D ビュー").is_some(), "the view is named in Japanese");
    assert!(harness.query_by_label("ファイル").is_some() && harness.query_by_label("File").is_none(), "and the menus");
    harness.state_mut().apply(AppearanceCommand::Language(Language::English));
    settle(&mut harness);
    assert!(harness.query_by_label("File").is_some(), "English again");
}

#[test]
fn a_chosen_language_is_there_at_the_next_start() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut harness = open(presets::OPENING);
    harness.state_mut().keep_in(folder.path());
    assert_eq!(harness.state().files.session.chosen().language, None, "nothing chosen yet");
    harness.state_mut().apply(AppearanceCommand::Language(Language::Japanese));
    let mut next = open(presets::OPENING);
    next.state_mut().keep_in(folder.path());
    assert_eq!(next.state().files.session.chosen().language, Some(Language::Japanese), "kept");
    assert!(harness.state().window.notice().is_none(), "and nothing to say");
}

#[test]
fn fonts_have_every_letter_of_every_language() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    for language in Language::ALL {
        let mut harness = builder([1024.0, 640.0]).build_ui_state(show, bench(presets::OPENING));
        harness.state_mut().apply(AppearanceCommand::Language(language));
        harness.run_steps(4);
        let code = language.code();
        let lessons = fs::read_dir(root.join("lessons")).expect("lessons").map(|file| file.expect("a file").path());
        let own = lessons.filter(|path| path.to_string_lossy().ends_with(&format!(".{code}.lesson.toml")));
        let tables = ["", ".keys", ".complaints"].map(|table| root.join(format!("texts/{code}{table}.ftl")));
        for path in own.chain(tables.into_iter().filter(|path| path.exists())) {
            let text = fs::read_to_string(&path).expect("a text");
            let letters = text.chars().chain(language.name().chars()).filter(|c| !c.is_control());
            let font = FontId::new(14.0, FontFamily::Proportional);
            let lacks: String =
                harness.ctx.fonts_mut(|fonts| letters.filter(|&c| !fonts.has_glyph(&font, c)).collect());
            assert!(lacks.is_empty(), "{}: no glyphs for {lacks}; README says how the font is made", path.display());
        }
    }
}

/// Brackets behind which no line ends, and signs with which none begins.
const OPENING: &str = "(（「『【〔［｛";
const CLOSING: &str = ")）」』】〕］｝、。";

#[test]
fn no_japanese_line_ends_with_an_opening_bracket_or_begins_with_a_closing_one() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    let mut harness = builder([1024.0, 640.0]).build_ui_state(show, bench(presets::OPENING));
    harness.state_mut().apply(AppearanceCommand::Language(Language::Japanese));
    harness.run_steps(4);
    let lessons = fs::read_dir(root.join("lessons")).expect("lessons").map(|file| file.expect("a file").path());
    let lessons = lessons.filter(|path| path.to_string_lossy().ends_with(".ja.lesson.toml"));
    let tables = ["", ".keys", ".complaints"].map(|table| root.join(format!("texts/ja{table}.ftl")));
    let mut broken = 0;
    for path in tables.into_iter().chain(lessons) {
        let text = fs::read_to_string(&path).expect("a text");
        for words in text.lines().filter_map(|line| Some(line.split_once(" = ")?.1)).filter(|words| words.contains('('))
        {
            // A column so wide holds the longest word in brackets.
            for width in (14u16..40).map(|letters| 13.0 * f32::from(letters) + 6.0) {
                let font = FontId::new(13.0, FontFamily::Proportional);
                let galley =
                    harness.ctx.fonts_mut(|fonts| fonts.layout(words.to_owned(), font, egui::Color32::BLACK, width));
                let rows: Vec<String> = galley.rows.iter().map(|row| row.row.text()).collect();
                broken += rows.len() - 1;
                let ends = rows[..rows.len() - 1].iter().any(|row| row.trim_end().ends_with(|c| OPENING.contains(c)));
                let begins = rows[1..].iter().any(|row| row.starts_with(|c| CLOSING.contains(c)));
                assert!(!ends && !begins, "{}: {rows:#?}", path.display());
            }
        }
    }
    assert!(broken > 1000, "lines are broken: {broken}");
}

#[test]
fn what_a_girder_is_shown_with_is_japanese() {
    let mut harness = builder([1280.0, 720.0]).build_ui_state(show, bench("deck-30m"));
    harness.state_mut().apply(AppearanceCommand::Language(Language::Japanese));
    harness.state_mut().apply(SelectCommand::Only(Some(Target::Girder(0))));
    harness.run_steps(10);
    for words in ["計算値", "計算の最大応答", "配置", "条件", "桁長 a₀", "質量 m", "桁かかり内にとどまる"]
    {
        assert!(harness.query_all_by_label_contains(words).next().is_some(), "{words}");
    }
}

#[test]
fn what_is_wrong_with_a_scene_follows_the_language_of_the_window() {
    let mut harness = open(presets::OPENING);
    slide(&mut harness, "μ kinetic", 0.9);
    assert!(harness.query_all_by_label_contains("mu_static = 0.2").count() >= 2, "over the view and at the field");
    harness.state_mut().apply(AppearanceCommand::Language(Language::Japanese));
    harness.run_steps(4);
    assert!(harness.query_all_by_label_contains("mu_static = 0.2 を超えない値にする").count() >= 2, "both again");
}
