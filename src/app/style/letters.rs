//! Letters that the font lacks: those of a language, from when it is first shown.

use egui::epaint::text::{FontInsert, FontPriority, InsertFontFamily};
use egui::{Context, FontData, FontFamily, Id};

use crate::language::{JAPANESE_FONT, Language};

/// Gives the fonts what a language needs, once for a context.
pub(in crate::app) fn install(ctx: &Context, language: Language) {
    let font = match language {
        Language::English => return,
        Language::Japanese => JAPANESE_FONT,
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
