//! Colours and spacing of the window, light and dark.

use egui::epaint::text::{FontInsert, FontPriority, InsertFontFamily};
use egui::{Color32, Context, CornerRadius, FontData, FontFamily, Id, Stroke, Theme, Ui, Visuals};

use crate::render;
use crate::view::{KEPT, MOST_KEPT};

/// The glyphs of the paper's own names of the six states and of the name of Japanese, which the font does not have.
const PAPER_NAMES: &[u8] = include_bytes!("../../../assets/fonts/paper-names.otf");

/// Stick, as in the pictures.
pub(in crate::app) const STICK: Color32 = Color32::from_rgb(0x00, 0x72, 0xB2);

/// Slip, as in the pictures.
pub(in crate::app) const SLIP: Color32 = Color32::from_rgb(0xD5, 0x5E, 0x00);

/// Runs that are kept, as their ghosts in the view. A ghost's dashes and a curve's differ too.
pub(in crate::app) const PINS: [Color32; MOST_KEPT] = [of_view(0), of_view(1), of_view(2), of_view(3)];

const fn of_view(number: usize) -> Color32 {
    let [r, g, b, _] = KEPT[number].0;
    Color32::from_rgb(r, g, b)
}

/// Curves of the user's own panels, in their order; from the seventh on they begin again.
pub(in crate::app) const OWN: [Color32; 6] = [
    Color32::from_rgb(0x35, 0x8F, 0xC9),
    Color32::from_rgb(0xD5, 0x5E, 0x00),
    Color32::from_rgb(0x00, 0x9E, 0x73),
    Color32::from_rgb(0xE6, 0x9F, 0x00),
    Color32::from_rgb(0xCC, 0x79, 0xA7),
    Color32::from_rgb(0x8C, 0x96, 0xA3),
];

/// How much is left of the ink of curves and figures of an earlier scene \[–\]; the view is veiled.
const OLDER: f32 = 0.4;

/// Shows figures, greyed where they are of an earlier scene than the one worked on.
pub(in crate::app) fn greyed(ui: &mut Ui, older: bool, body: impl FnOnce(&mut Ui)) {
    ui.scope(|ui| {
        if older {
            ui.multiply_opacity(OLDER);
        }
        body(ui);
    });
}

/// Colours of the two themes beyond egui's own visuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) struct Palette {
    /// Behind the 3D view.
    pub(in crate::app) view: Color32,
    /// Behind plots and the timeline.
    pub(in crate::app) track: Color32,
    /// Thin lines and ticks.
    pub(in crate::app) line: Color32,
    /// Secondary text.
    pub(in crate::app) weak: Color32,
    /// The playhead.
    pub(in crate::app) playhead: Color32,
    /// The curve of x.
    pub(in crate::app) x: Color32,
    /// The curve of y.
    pub(in crate::app) y: Color32,
    /// The curve of θ.
    pub(in crate::app) theta: Color32,
    /// The curve of the contact force.
    pub(in crate::app) force: Color32,
    /// Complaints.
    pub(in crate::app) problem: Color32,
}

const DARK: Palette = Palette {
    view: Color32::from_rgb(0x17, 0x1A, 0x1F),
    track: Color32::from_rgb(0x14, 0x17, 0x1B),
    line: Color32::from_rgb(0x3A, 0x41, 0x4A),
    weak: Color32::from_rgb(0x9A, 0xA3, 0xAE),
    playhead: Color32::from_rgb(0xF2, 0xF4, 0xF7),
    x: Color32::from_rgb(0x3F, 0xC1, 0x98),
    y: Color32::from_rgb(0xD9, 0x8F, 0xB8),
    theta: Color32::from_rgb(0xE8, 0xB0, 0x3A),
    force: Color32::from_rgb(0xD6, 0xDB, 0xE2),
    problem: Color32::from_rgb(0xFF, 0x9B, 0x7A),
};

const LIGHT: Palette = Palette {
    view: Color32::from_rgb(0xF4, 0xF6, 0xF8),
    track: Color32::from_rgb(0xFF, 0xFF, 0xFF),
    line: Color32::from_rgb(0xC3, 0xCA, 0xD2),
    weak: Color32::from_rgb(0x5B, 0x64, 0x6F),
    playhead: Color32::from_rgb(0x14, 0x18, 0x1D),
    x: Color32::from_rgb(0x00, 0x7A, 0x58),
    y: Color32::from_rgb(0xA3, 0x3F, 0x7A),
    theta: Color32::from_rgb(0x8A, 0x60, 0x00),
    force: Color32::from_rgb(0x2A, 0x30, 0x38),
    problem: Color32::from_rgb(0xB0, 0x2A, 0x0C),
};

impl Palette {
    /// The palette of the theme in use.
    pub(in crate::app) fn of(ui: &egui::Ui) -> Self {
        if ui.visuals().dark_mode { DARK } else { LIGHT }
    }
}

/// A context that is ready for its first frame.
pub(in crate::app) fn context() -> Context {
    let ctx = Context::default();
    install(&ctx);
    ctx
}

/// Sets the font and both themes' styles, once for a context.
pub(in crate::app) fn install(ctx: &Context) {
    let there = Id::unique("theme");
    if ctx.data(|data| data.get_temp::<bool>(there)).is_some() {
        return;
    }
    ctx.data_mut(|data| data.insert_temp(there, true));
    ctx.set_fonts(render::fonts());
    let family = InsertFontFamily { family: FontFamily::Proportional, priority: FontPriority::Lowest };
    ctx.add_font(FontInsert::new("paper-names", FontData::from_static(PAPER_NAMES), vec![family]));
    ctx.set_visuals_of(Theme::Dark, dark());
    ctx.set_visuals_of(Theme::Light, light());
    ctx.all_styles_mut(|style| {
        style.spacing.item_spacing = egui::vec2(6.0, 4.0);
        style.spacing.button_padding = egui::vec2(6.0, 2.0);
        style.spacing.slider_width = 110.0;
        style.spacing.interact_size.y = 20.0;
        style.spacing.scroll = egui::style::ScrollStyle::thin();
    });
}

fn rounded(mut visuals: Visuals) -> Visuals {
    let widgets = &mut visuals.widgets;
    for w in [
        &mut widgets.noninteractive,
        &mut widgets.inactive,
        &mut widgets.hovered,
        &mut widgets.active,
        &mut widgets.open,
    ] {
        w.corner_radius = CornerRadius::same(3);
        w.expansion = 0.0;
    }
    visuals.slider_trailing_fill = true;
    visuals
}

fn dark() -> Visuals {
    let mut visuals = Visuals::dark();
    visuals.panel_fill = Color32::from_rgb(0x1F, 0x23, 0x29);
    visuals.window_fill = Color32::from_rgb(0x25, 0x2A, 0x31);
    visuals.extreme_bg_color = DARK.track;
    visuals.override_text_color = Some(Color32::from_rgb(0xDD, 0xE2, 0xE8));
    visuals.widgets.noninteractive.bg_stroke = Stroke::new(1.0, Color32::from_rgb(0x31, 0x37, 0x3F));
    visuals.widgets.inactive.bg_stroke = Stroke::new(1.0, Color32::from_rgb(0x45, 0x4D, 0x57));
    visuals.selection.bg_fill = Color32::from_rgb(0x2B, 0x5D, 0x86);
    rounded(visuals)
}

fn light() -> Visuals {
    let mut visuals = Visuals::light();
    visuals.panel_fill = Color32::from_rgb(0xEC, 0xEF, 0xF2);
    visuals.window_fill = Color32::from_rgb(0xF8, 0xF9, 0xFA);
    visuals.extreme_bg_color = LIGHT.track;
    visuals.override_text_color = Some(Color32::from_rgb(0x1D, 0x22, 0x28));
    visuals.widgets.noninteractive.bg_stroke = Stroke::new(1.0, Color32::from_rgb(0xD2, 0xD8, 0xDE));
    visuals.widgets.inactive.bg_stroke = Stroke::new(1.0, Color32::from_rgb(0xA9, 0xB3, 0xBD));
    visuals.widgets.inactive.bg_fill = Color32::from_rgb(0xD3, 0xDA, 0xE1);
    visuals.widgets.inactive.weak_bg_fill = Color32::from_rgb(0xE1, 0xE6, 0xEB);
    visuals.selection.bg_fill = Color32::from_rgb(0xA9, 0xCF, 0xEC);
    rounded(visuals)
}
