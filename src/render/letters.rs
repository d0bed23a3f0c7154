//! The font of the window and of pictures.

use epaint::FontFamily;
use epaint::text::{FontData, FontDefinitions};

/// Its name.
const NAME: &str = "Ubuntu-Light";

/// One font for every family: its digits are as wide as one another, so that a clock needs no font for code.
pub fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    fonts.font_data.insert(NAME.to_owned(), FontData::from_static(epaint_default_fonts::UBUNTU_LIGHT).into());
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        fonts.families.insert(family, vec![NAME.to_owned()]);
    }
    fonts
}
