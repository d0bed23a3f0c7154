//! Every word the window shows, and how numbers are written.

use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, Ui};

use super::theme::Palette;

/// The program's name, in the title.
pub(super) const PROGRAM: &str = "Girderbench";
/// Stands before the title of a scene with unsaved changes.
pub(super) const UNSAVED: &str = "● ";

// The bar at the top.
pub(super) const FILE: &str = "File";
pub(super) const NEW: &str = "New";
pub(super) const UNTITLED: &str = "untitled";
pub(super) const OPEN: &str = "Open…";
pub(super) const OPEN_RECENT: &str = "Open recent";
pub(super) const NO_RECENT: &str = "No files yet";
pub(super) const FORGET: &str = "Forget";
pub(super) const FORGET_HINT: &str = "Take it from this list; the file stays where it is";
pub(super) const FORGET_ALL: &str = "Forget all";
pub(super) const MISSING: &str = "missing";
pub(super) const SAVE: &str = "Save";
pub(super) const SAVE_AS: &str = "Save as…";
pub(super) const EXPORT_PICTURE: &str = "Export picture…";
pub(super) const EXPORT_FILM: &str = "Export film…";
pub(super) const EXPORT_TABLES: &str = "Export tables…";
pub(super) const QUIT: &str = "Quit";
pub(super) const PRESETS: &str = "Presets";
pub(super) const UNDO: &str = "Undo";
pub(super) const REDO: &str = "Redo";
pub(super) const ADD_GIRDER: &str = "Add girder";
pub(super) const ADD_ABUTMENT: &str = "Add abutment";
pub(super) const DUPLICATE: &str = "Duplicate";
pub(super) const REMOVE: &str = "Remove";
pub(super) const HELP: &str = "Help";
pub(super) const THEME_LIGHT: &str = "Light";
pub(super) const THEME_DARK: &str = "Dark";
pub(super) const THEME_HINT: &str = "Switch between the light and the dark theme";
pub(super) const VIEW_ISO: &str = "Iso";
pub(super) const VIEW_TOP: &str = "Top";
pub(super) const VIEW_SIDE: &str = "Side";
pub(super) const VIEW_CONTACT: &str = "Contact";
pub(super) const VIEW_FRAME: &str = "Frame";
pub(super) const FRAME_HINT: &str = "Frame what is selected, or everything (F)";

// The view.
pub(super) const VIEW: &str = "3D view";
pub(super) const COMPUTING: &str = "Computing";
pub(super) const CANCEL: &str = "Cancel";
pub(super) const CANCELLED: &str = "Stopped: the picture shows the last finished run. Change anything to run again.";
pub(super) const PROBLEM: &str = "This scene cannot be run; the last good answer is still shown";
pub(super) const PROBLEM_AT_ONCE: &str = "This scene cannot be run";
pub(super) const STOPPED_EARLY: &str = "The run ended early";
pub(super) const EMPTY: &str = "Nothing is placed. Add a girder (G) or open a preset.";

// Time.
pub(super) const TIMELINE: &str = "Timeline";
pub(super) const CONTACTS: &str = "contacts";
pub(super) const PLOTS: &str = "Plots";
pub(super) const PLAY: &str = "Play";
pub(super) const PAUSE: &str = "Pause";
pub(super) const TO_START: &str = "To the start";
pub(super) const TO_END: &str = "To the end";
pub(super) const STEP_BACK: &str = "Step back";
pub(super) const STEP_FORWARD: &str = "Step forward";
pub(super) const PREVIOUS_EVENT: &str = "Previous contact event";
pub(super) const NEXT_EVENT: &str = "Next contact event";
pub(super) const SPEED: &str = "Speed";
pub(super) const LOOP: &str = "Loop";
pub(super) const LOOP_HINT: &str = "Begin again at the end (L)";
pub(super) const SLOW_AT_HITS: &str = "Slow at hits";
pub(super) const SLOW_HINT: &str = "Play at 1/100 while anything touches (M)";
pub(super) const ALL_TIME: &str = "Whole run";
pub(super) const ALL_TIME_HINT: &str = "Show the whole run (double click)";
pub(super) const PLOT_PLACE: &str = "{x}x  {y}y  {}[mm]";
pub(super) const PLOT_PLACE_BOTH: &str = "{x}x  {y}y  {}[mm]  dotted: impact model";
pub(super) const PLOT_THETA: &str = "{t}θ  {}[°]";
pub(super) const PLOT_FORCE: &str = "{f}contact force";

// What is placed.
pub(super) const OUTLINER: &str = "Placed";
pub(super) const INSPECTOR: &str = "Numbers";
pub(super) const NOTHING_SELECTED: &str = "Select a girder or an abutment to see its numbers.";
pub(super) const NAME: &str = "Name";
pub(super) const LENGTH: &str = "Length a₀";
pub(super) const WIDTH: &str = "Width b₀";
pub(super) const THICKNESS: &str = "Thickness t₀";
pub(super) const SKEW: &str = "Skew β";
pub(super) const MASS: &str = "Mass m";
pub(super) const POSITION_X: &str = "Position x";
pub(super) const POSITION_Y: &str = "Position y";
pub(super) const POSITION_Z: &str = "Position z";
pub(super) const HEADING: &str = "Heading";
pub(super) const FREQUENCY_X: &str = "Bearings f x";
pub(super) const FREQUENCY_Y: &str = "Bearings f y";
pub(super) const DAMPING_X: &str = "Bearings h x";
pub(super) const DAMPING_Y: &str = "Bearings h y";
pub(super) const FREQUENCY_Z: &str = "Bearings f z";
pub(super) const BEARINGS_NONE: &str = "No bearings: it slides freely.";
pub(super) const BEARINGS_EACH: &str = "Bearings are given one by one in the file.";
pub(super) const START_VX: &str = "Starts with v x";
pub(super) const START_VY: &str = "Starts with v y";
pub(super) const GAP: &str = "Gap";
pub(super) const OFFSET: &str = "Sideways";
pub(super) const FACES: &str = "Stands before";
pub(super) const FACE_WIDTH: &str = "Face width";
pub(super) const FACE_HEIGHT: &str = "Face height";
pub(super) const POLYGON: &str = "The face is given as a polygon in the file; drag it to move it.";
pub(super) const COMPUTED: &str = "Computed";
pub(super) const CONTACT_OPEN: &str = "Open at this time.";

// What if.
pub(super) const WHAT_IF: &str = "What if";
pub(super) const ALL_GIRDERS: &str = "all girders";
pub(super) const MU_STATIC: &str = "μ static";
pub(super) const MU_KINETIC: &str = "μ kinetic";
pub(super) const E_NORMAL: &str = "e normal";
pub(super) const E_TANGENTIAL: &str = "e tangential";
pub(super) const AMPLITUDE: &str = "Amplitude";
pub(super) const FREQUENCY: &str = "Frequency";
pub(super) const ANGLE: &str = "Angle α";
pub(super) const RECORD_SCALE: &str = "Record scale";
pub(super) const DURATION: &str = "Duration";
pub(super) const LAW: &str = "Friction law";
pub(super) const LAW_PAPER: &str = "paper";
pub(super) const LAW_RETURN: &str = "return mapping";
pub(super) const MODEL_SECTION: &str = "Models";
pub(super) const MODEL: &str = "Model";
pub(super) const MODEL_CONTACT: &str = "contact";
pub(super) const MODEL_IMPACT: &str = "impact";
pub(super) const MODEL_BOTH: &str = "both";
pub(super) const MODEL_SPATIAL: &str = "The impact model knows planar scenes only.";
pub(super) const IMPACT_E_NORMAL: &str = "Impact e n";
pub(super) const IMPACT_E_TANGENTIAL: &str = "Impact e t";
pub(super) const IMPACT_MU_STATIC: &str = "Face μ s";
pub(super) const IMPACT_MU_KINETIC: &str = "Face μ k";
pub(super) const CORNER_MU_STATIC: &str = "Corner μ s";
pub(super) const CORNER_MU_KINETIC: &str = "Corner μ k";
pub(super) const STOP_SPEED: &str = "Stop speed";
pub(super) const FLUSH_HITS: &str = "Flush hits";
pub(super) const FLUSH_PAPER: &str = "paper (centroid)";
pub(super) const FLUSH_TWO_CORNER: &str = "two corners";
pub(super) const STATE_HINT: &str = "State under the impact model: a, b free; c, d on a corner; e, f on the face";
pub(super) const APART_NOW: &str = "Models apart now:";
pub(super) const APART_MOST: &str = "At the most:";
pub(super) const FLUSH_NOTE: &str = "A whole face hits in this run. There the models differ by nature: an elastic face \
spreads the push along itself for as long as the hit lasts, a rigid one takes it at once.";
pub(super) const NO_MOTION: &str = "The ground stands still.";
pub(super) const SHAKE: &str = "Shake it";
pub(super) const CONTACT_SECTION: &str = "Contact";
pub(super) const MOTION_SECTION: &str = "Ground motion";
pub(super) const SHOW_SECTION: &str = "Show";
pub(super) const FORCE_SCALE: &str = "Force scale";
pub(super) const AUTO_SCALE: &str = "Scale from peak";

// Overlays, in the order of `scene::Overlays`.
pub(super) const OVERLAYS: [&str; 13] = [
    "Grid",
    "Bearings",
    "Gap",
    "Contact points",
    "Normal force",
    "Tangential force",
    "Resultant",
    "Dashpot force",
    "Friction cones",
    "Axes",
    "Legend",
    "Title",
    "Names",
];

/// Names of the numbers in the status line, and what they mean.
pub(super) const STATUS: [(&str, &str); 7] = [
    ("moves", "largest displacement of any girder"),
    ("turns", "largest rotation of any girder"),
    ("peak", "largest force of any contact"),
    ("hits", "touches of a pair, from the first closing to the last opening"),
    ("ledger", "what the energy balance leaves over, of the largest energy in play"),
    ("error", "largest displacement difference from a run at a hundredth of the tolerance"),
    ("run in", "how long the run took"),
];
pub(super) const SAVED: &str = "Saved";
pub(super) const PICTURE_WRITTEN: &str = "Picture written";
pub(super) const TABLES_WRITTEN: &str = "Tables written into";
pub(super) const BEFORE: &str = "before";

// Guided scenes; their own words are in `assets/lessons`.
pub(super) const LEARN: &str = "Learn";
pub(super) const TRY: &str = "Try this";
pub(super) const RESET: &str = "Reset";
pub(super) const RESET_HINT: &str = "Put the scene back as it was; undo takes that back";
pub(super) const CLOSE_LESSON: &str = "Close the lesson";

// Films.
pub(super) const FILM: &str = "Film";
pub(super) const FILM_FORMAT: &str = "Format";
pub(super) const FILM_GIF: &str = "GIF";
pub(super) const FILM_PNG: &str = "PNG pictures";
pub(super) const FILM_FROM: &str = "From";
pub(super) const FILM_TO: &str = "To";
pub(super) const FILM_FPS: &str = "Frames a second";
pub(super) const FILM_SIZE: &str = "Size";
pub(super) const FILM_AS_VIEW: &str = "as the view";
pub(super) const FILM_WHERE: &str = "Choose where…";
pub(super) const FILM_IMPOSSIBLE: &str = "No film: it must end after it begins and have at most 20,000 frames.";
pub(super) const FILMING: &str = "Film:";
pub(super) const CANCEL_FILM: &str = "Cancel film";
pub(super) const FILM_CANCELLED: &str = "The film was cancelled; nothing of it was kept.";
pub(super) const FILM_WRITTEN: &str = "Film written, frames in";

// Questions and notices.
pub(super) const UNSAVED_QUESTION: &str = "The scene has changes that are not saved.";
pub(super) const CLOSE_ANYWAY: &str = "Close without saving";
pub(super) const SAVE_FIRST: &str = "Save first";
pub(super) const KEEP_OPEN: &str = "Keep working";
pub(super) const DISMISS: &str = "Dismiss";
pub(super) const CLOSE: &str = "Close";
pub(super) const WORK_FOUND: &str = "Work that was not saved before the program ended";
pub(super) const WITHOUT_FILE: &str = "a scene without a file";
pub(super) const WORK_IS_OLDER: &str = " The file has been written since then.";
pub(super) const BRING_BACK: &str = "Bring it back?";
pub(super) const RECOVER: &str = "Recover";
pub(super) const DISCARD: &str = "Discard";
pub(super) const LATER: &str = "Keep for later";
pub(super) const FILE_CHANGED: &str = "was changed by another program.";
pub(super) const RELOAD_REPLACES: &str = " Reloading replaces what you have changed here; undo brings it back.";
pub(super) const RELOAD: &str = "Reload";
pub(super) const KEEP_MINE: &str = "Keep mine";
pub(super) const FILE_GONE: &str = "the file is no longer there; save to write it again";
pub(super) const NOT_KEPT: &str = "Unsaved work cannot be kept:";

/// Every key, for the help.
pub(super) const KEYS: &[(&str, &str)] = &[
    ("Space", "play, pause"),
    ("Left Right", "one step back, on; with Shift ten steps"),
    ("Ctrl Left Right", "previous, next contact event"),
    ("Home End", "to the start, to the end"),
    (", .", "slower, faster (down to 1/1000)"),
    ("L", "begin again at the end, or stop"),
    ("M", "slow motion around hits"),
    ("1 2 3 4", "view: iso, top, side, contact"),
    ("F", "frame what is selected, or everything"),
    ("left drag", "turn the view; on what is selected: move it"),
    ("middle or Shift drag", "shift the view"),
    ("wheel", "nearer, farther; over the timeline: zoom in time"),
    ("click", "select; in timeline and plots: go to that time"),
    ("G  B", "add a girder, an abutment"),
    ("Ctrl D  Delete", "duplicate, remove what is selected"),
    ("Ctrl Z", "undo"),
    ("Ctrl Shift Z, Ctrl Y", "redo"),
    ("Ctrl N  Ctrl O  Ctrl S", "new, open, save"),
    ("Ctrl Shift S", "save as"),
    ("Esc", "select nothing, close this"),
    ("F1", "this help"),
];

/// A number with three significant digits and no needless zeros.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return "–".into();
    }
    let magnitude = value.abs().log10().floor();
    if !(-4.0..6.0).contains(&magnitude) {
        return format!("{value:.2e}");
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 6")]
    let decimals = (2.0 - magnitude).clamp(0.0, 6.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// What a button would do, and its keys.
pub(super) fn keyed(what: Option<&str>, keys: &str) -> String {
    what.map_or_else(|| keys.to_owned(), |what| format!("{what} ({keys})"))
}

/// What American texts call this skew.
pub(super) fn us_skew(skew_deg: f64) -> String {
    format!("β {}°, US skew {}°", short(skew_deg), short(90.0 - skew_deg))
}

/// A length in the unit that fits it.
pub(super) fn length(metres: f64) -> String {
    match metres.abs() {
        m if m.is_nan() => "–".into(),
        0.0 => "0 mm".into(),
        m if m >= 1.0 => format!("{} m", short(metres)),
        m if m >= 1e-4 => format!("{} mm", short(metres * 1e3)),
        _ => format!("{} m", short(metres)),
    }
}

/// A force in the unit that fits it.
pub(super) fn force(newtons: f64) -> String {
    match newtons.abs() {
        f if f >= 1e6 => format!("{} MN", short(newtons / 1e6)),
        f if f >= 1e4 => format!("{} kN", short(newtons / 1e3)),
        _ => format!("{} N", short(newtons)),
    }
}

/// The time of a tick, with as many digits as tell it from its neighbours.
pub(super) fn tick(t: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 9")]
    let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{t:.decimals$} s")
}

/// How long a run took, and how many times faster than the ground shakes.
pub(super) fn run_time(seconds: f64, times: f64) -> String {
    format!("{} ms, {} × real time", short(seconds * 1e3), short(times))
}

/// How many frames a film has, and how long it plays.
pub(super) fn film_length(frames: u32, seconds: f64) -> String {
    format!("{frames} frames, plays for {} s", short(seconds))
}

/// How long ago, roughly.
pub(super) fn ago(time: std::time::Duration) -> String {
    let (count, unit) = match time.as_secs() {
        s if s < 60 => return "from less than a minute ago".into(),
        s if s < 3600 => (s / 60, "minute"),
        s if s < 86_400 => (s / 3600, "hour"),
        s => (s / 86_400, "day"),
    };
    format!("from {count} {unit}{} ago", if count == 1 { "" } else { "s" })
}

/// A playing speed: `1/100`, `1`, `×5`.
pub(super) fn speed(speed: f64) -> String {
    if speed < 1.0 { format!("1/{}", short(1.0 / speed)) } else { format!("×{}", short(speed)) }
}

/// A chart's name with its symbols in the colours of their curves: `{x}x` is an x in the colour of x.
pub(super) fn legend(template: &str, palette: &Palette, ui: &Ui) -> LayoutJob {
    let mut job = LayoutJob::default();
    let font = FontId::proportional(11.0);
    for part in template.split('{').filter(|p| !p.is_empty()) {
        let (which, words) = part.split_once('}').unwrap_or(("", part));
        let color = match which {
            "x" => palette.x,
            "y" => palette.y,
            "t" => palette.theta,
            "f" => palette.force,
            _ => palette.weak,
        };
        job.append(words, 0.0, TextFormat::simple(font.clone(), color));
    }
    job.wrap.max_width = ui.available_width().max(200.0);
    job
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases =
            [(0.0, "0"), (1.0, "1"), (0.4, "0.4"), (12.345, "12.3"), (1234.6, "1235"), (-0.001_234, "-0.00123")];
        for (value, wanted) in cases {
            assert_eq!(short(value), wanted, "{value}");
        }
        assert_eq!(short(1.55e-7), "1.55e-7", "very small");
        assert_eq!(short(f64::NAN), "–", "no number");
    }

    #[test]
    fn speeds_are_fractions_below_one() {
        assert_eq!(speed(0.001), "1/1000", "slowest");
        assert_eq!(speed(1.0), "×1", "true");
    }
}
