//! Letters that egui's own fonts lack: those of a language, from when it is first shown.

use egui::epaint::text::{FontInsert, FontPriority, InsertFontFamily};
use egui::{Context, FontData, FontFamily, Id};

use crate::language::Language;

/// Kana, and the kanji of the Japanese texts and lessons: a subset of Noto Sans CJK JP (README says how it is made).
const JAPANESE: &[u8] = include_bytes!("../../../assets/fonts/japanese.otf");

/// Gives the fonts what a language needs, once for a context.
pub(in crate::app) fn install(ctx: &Context, language: Language) {
    let font = match language {
        Language::English => return,
        Language::Japanese => JAPANESE,
    };
    let there = Id::unique(("letters", language.code()));
    if ctx.data(|data| data.get_temp::<bool>(there)).is_some() {
        return;
    }
    ctx.data_mut(|data| data.insert_temp(there, true));
    let families = [FontFamily::Proportional, FontFamily::Monospace];
    let families = families.map(|family| InsertFontFamily { family, priority: FontPriority::Lowest });
    ctx.add_font(FontInsert::new(language.code(), FontData::from_static(font), families.to_vec()));
    // The font is there from the next frame on.
    ctx.request_repaint();
}
