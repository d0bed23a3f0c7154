//! The words that the window shows, but for those of errors, which stand where they arise, and how numbers are written.

mod edits;
mod fields;
mod handles;
mod map;
mod numbers;
mod panels;
mod paths;
mod piers;
mod plots;
mod readings;

use crate::language::Text;

pub(super) use edits::*;
pub(super) use fields::*;
pub(super) use handles::*;
pub(super) use map::*;
pub(super) use numbers::*;
pub(super) use panels::*;
pub(super) use paths::*;
pub(super) use piers::*;
pub(super) use plots::*;
pub(super) use readings::*;

impl From<Text> for egui::WidgetText {
    fn from(text: Text) -> Self {
        text.as_str().into()
    }
}

impl From<Text> for egui::RichText {
    fn from(text: Text) -> Self {
        text.as_str().into()
    }
}

/// The program's name, in the title.
pub(super) const PROGRAM: &str = "Girderbench";
/// Stands before the title of a scene with unsaved changes.
pub(super) const UNSAVED: &str = "● ";

// The bar at the top.
pub(super) const FILE: Text = Text::new("file");
pub(super) const NEW: Text = Text::new("new");
pub(super) const UNTITLED: &str = "untitled";
pub(super) const OPEN: Text = Text::new("open");
pub(super) const OPEN_RECENT: Text = Text::new("open-recent");
pub(super) const NO_RECENT: Text = Text::new("no-recent");
pub(super) const FORGET: Text = Text::new("forget");
pub(super) const FORGET_HINT: Text = Text::new("forget-hint");
pub(super) const FORGET_ALL: Text = Text::new("forget-all");
pub(super) const MISSING: Text = Text::new("missing");
pub(super) const SAVE: Text = Text::new("save");
pub(super) const SAVE_AS: Text = Text::new("save-as");
pub(super) const EXPORT_PICTURE: Text = Text::new("export-picture");
pub(super) const EXPORT_PRINT: Text = Text::new("export-print");
pub(super) const EXPORT_FILM: Text = Text::new("export-film");
pub(super) const EXPORT_TABLES: Text = Text::new("export-tables");
pub(super) const EXPORT_REPORT: Text = Text::new("export-report");
pub(super) const REPORT_WRITTEN: Text = Text::new("report-written");
pub(super) const QUIT: Text = Text::new("quit");
pub(super) const PRESETS: Text = Text::new("presets");
pub(super) const UNDO: Text = Text::new("undo");
pub(super) const REDO: Text = Text::new("redo");
pub(super) const ADD_GIRDER: Text = Text::new("add-girder");
pub(super) const ADD_ABUTMENT: Text = Text::new("add-abutment");
pub(super) const ADD_PIER: Text = Text::new("add-pier");
pub(super) const DUPLICATE: Text = Text::new("duplicate");
pub(super) const REMOVE: Text = Text::new("remove");
pub(super) const EDIT: Text = Text::new("edit");
pub(super) const SELECT_ALL: Text = Text::new("select-all");
pub(super) const PLACE_GIRDER: Text = Text::new("place-girder");
pub(super) const PLACE_ABUTMENT: Text = Text::new("place-abutment");
pub(super) const ROW: Text = Text::new("row");
pub(super) const ROW_ASK: Text = Text::new("row-ask");
pub(super) const ROW_OF: Text = Text::new("row-of");
pub(super) const ROW_SPANS: Text = Text::new("row-spans");
pub(super) const ROW_GAP: Text = Text::new("row-gap");
pub(super) const ROW_MAKE: Text = Text::new("row-make");
pub(super) const TOOL_ENDS: Text = Text::new("tool-ends");
pub(super) const HELP: Text = Text::new("help");
pub(super) const THEME_LIGHT: Text = Text::new("theme-light");
pub(super) const THEME_DARK: Text = Text::new("theme-dark");
pub(super) const THEME_HINT: Text = Text::new("theme-hint");
pub(super) const VIEW_ISO: Text = Text::new("view-iso");
pub(super) const VIEW_TOP: Text = Text::new("view-top");
pub(super) const VIEW_SIDE: Text = Text::new("view-side");
pub(super) const VIEW_CONTACT: Text = Text::new("view-contact");
pub(super) const VIEW_BACK: Text = Text::new("view-back");
pub(super) const VIEW_FRAME: Text = Text::new("view-frame");
pub(super) const FRAME_HINT: Text = Text::new("frame-hint");

// An empty scene.
pub(super) const START_BRIDGE: Text = Text::new("start-bridge");
pub(super) const START_SPAN: Text = Text::new("start-span");
pub(super) const START_WIDTH: Text = Text::new("start-width");
pub(super) const START_SKEW: Text = Text::new("start-skew");
pub(super) const START_SPANS: Text = Text::new("start-spans");
pub(super) const START_BUILD: Text = Text::new("start-build");
pub(super) const START_NOTHING: Text = Text::new("start-nothing");

// The view.
pub(super) const VIEW: Text = Text::new("view");
pub(super) const COMPUTING: Text = Text::new("computing");
pub(super) const BEING_WRITTEN: Text = Text::new("being-written");
pub(super) const RUN_AGAIN: Text = Text::new("run-again");
pub(super) const COARSE_ALONE: Text = Text::new("coarse-alone");
pub(super) const EVALUATING: Text = Text::new("evaluating");
pub(super) const CANCEL: Text = Text::new("cancel");
pub(super) const CANCELLED: Text = Text::new("cancelled");
pub(super) const CANCELLED_AT_ONCE: Text = Text::new("cancelled-at-once");
pub(super) const PROBLEM: Text = Text::new("problem");
pub(super) const PROBLEM_AT_ONCE: Text = Text::new("problem-at-once");
pub(super) const STOPPED_EARLY: Text = Text::new("stopped-early");
pub(super) const EMPTY: Text = Text::new("empty");

// Time.
pub(super) const TIMELINE: Text = Text::new("timeline");
pub(super) const CONTACTS: Text = Text::new("contacts");
pub(super) const PLAY: Text = Text::new("play");
pub(super) const PAUSE: Text = Text::new("pause");
pub(super) const TO_START: Text = Text::new("to-start");
pub(super) const TO_END: Text = Text::new("to-end");
pub(super) const STEP_BACK: Text = Text::new("step-back");
pub(super) const STEP_FORWARD: Text = Text::new("step-forward");
pub(super) const PREVIOUS_EVENT: Text = Text::new("previous-event");
pub(super) const NEXT_EVENT: Text = Text::new("next-event");
pub(super) const SPEED: Text = Text::new("speed");
pub(super) const PLAYING: Text = Text::new("playing");
pub(super) const LOOP: Text = Text::new("loop");
pub(super) const LOOP_HINT: Text = Text::new("loop-hint");
pub(super) const SLOW_AT_HITS: Text = Text::new("slow-at-hits");
pub(super) const SLOW_HINT: Text = Text::new("slow-hint");
pub(super) const ALL_SPAN: Text = Text::new("all-span");
pub(super) const ALL_SPAN_HINT: Text = Text::new("all-span-hint");
pub(super) const ALL_TIME: Text = Text::new("all-time");
pub(super) const ALL_TIME_HINT: Text = Text::new("all-time-hint");

// What is placed.
pub(super) const INSPECTOR: Text = Text::new("inspector");
pub(super) const NOTHING_SELECTED: Text = Text::new("nothing-selected");
pub(super) const NAME: Text = Text::new("name");
pub(super) const FREQUENCY_X: Text = Text::new("frequency-x");
pub(super) const FREQUENCY_Y: Text = Text::new("frequency-y");
pub(super) const DAMPING_X: Text = Text::new("damping-x");
pub(super) const DAMPING_Y: Text = Text::new("damping-y");
pub(super) const FREQUENCY_Z: Text = Text::new("frequency-z");
pub(super) const DAMPING_Z: Text = Text::new("damping-z");
pub(super) const BEARINGS: Text = Text::new("bearings");
pub(super) const BEARINGS_NONE: Text = Text::new("bearings-none");
pub(super) const BEARINGS_ADD: Text = Text::new("bearings-add");
pub(super) const BEARINGS_ADD_LEAD: Text = Text::new("bearings-add-lead");
pub(super) const BEARINGS_ADD_PENDULUM: Text = Text::new("bearings-add-pendulum");
pub(super) const BEARINGS_LINEAR: Text = Text::new("bearings-linear");
pub(super) const BEARINGS_REMOVE: Text = Text::new("bearings-remove");
pub(super) const BEARINGS_ONE_BY_ONE: Text = Text::new("bearings-one-by-one");
pub(super) const BEARINGS_ONE_BY_ONE_HINT: Text = Text::new("bearings-one-by-one-hint");
pub(super) const BEARING: Text = Text::new("bearing");
pub(super) const BEARING_ADD: Text = Text::new("bearing-add");
pub(super) const BEARING_REMOVE: Text = Text::new("bearing-remove");
pub(super) const BEARING_HEIGHT: Text = Text::new("bearing-height");
pub(super) const BEARING_X: Text = Text::new("bearing-x");
pub(super) const BEARING_Y: Text = Text::new("bearing-y");
pub(super) const BEARING_YIELD: Text = Text::new("bearing-yield");
pub(super) const BEARING_YIELDS_AT: Text = Text::new("bearing-yields-at");
pub(super) const BEARING_PER_AXIS: Text = Text::new("bearing-per-axis");
pub(super) const AT: Text = Text::new("at");
pub(super) const AT_SKEWED: Text = Text::new("at-skewed");
pub(super) const AT_FOLLOWS: Text = Text::new("at-follows");
pub(super) const START_SECTION: Text = Text::new("start-section");
pub(super) const HELD: Text = Text::new("held");
pub(super) const BACKFILL_SECTION: Text = Text::new("backfill-section");
pub(super) const BACKFILL_NONE: Text = Text::new("backfill-none");
pub(super) const BACKFILL_ADD: Text = Text::new("backfill-add");
pub(super) const BACKFILL_REMOVE: Text = Text::new("backfill-remove");
pub(super) const BACKFILL_ASSUMED: Text = Text::new("backfill-assumed");
pub(super) const ON_MINUS: Text = Text::new("on-minus");
pub(super) const ON_PLUS: Text = Text::new("on-plus");
pub(super) const ON_PIER: Text = Text::new("on-pier");
pub(super) const ON_GROUND: Text = Text::new("on-ground");
pub(super) const ELASTIC_SECTION: Text = Text::new("elastic-section");
pub(super) const ELASTIC_NONE: Text = Text::new("elastic-none");
pub(super) const ELASTIC_ADD: Text = Text::new("elastic-add");
pub(super) const ELASTIC_REMOVE: Text = Text::new("elastic-remove");
pub(super) const ELASTIC_ASSUMED: Text = Text::new("elastic-assumed");
pub(super) const SEAT_SECTION: Text = Text::new("seat-section");
pub(super) const CODES_SECTION: Text = Text::new("codes-section");
pub(super) const SCENE_SECTION: Text = Text::new("scene-section");
pub(super) const DESCRIPTION: Text = Text::new("description");
pub(super) const KIND: Text = Text::new("kind");
pub(super) const PLANAR: Text = Text::new("planar");
pub(super) const SPATIAL: Text = Text::new("spatial");
pub(super) const PAIRS_SECTION: Text = Text::new("pairs-section");
pub(super) const PAIR: Text = Text::new("pair");
pub(super) const WHOSE_PAIR: Text = Text::new("whose-pair");
pub(super) const RETURNED_E: Text = Text::new("returned-e");
pub(super) const PAIR_RESET: Text = Text::new("pair-reset");
pub(super) const PAIR_RESET_HINT: Text = Text::new("pair-reset-hint");
pub(super) const FROM_PAIR: Text = Text::new("from-pair");
pub(super) const FROM_SCENE: Text = Text::new("from-scene");
pub(super) const FROM_EA_L: Text = Text::new("from-ea-l");
pub(super) const FROM_65: Text = Text::new("from-65");
pub(super) const FROM_NORMAL_LAW: Text = Text::new("from-normal-law");
pub(super) const FROM_PLACES: Text = Text::new("from-places");
pub(super) const FACES: Text = Text::new("faces");
pub(super) const END: Text = Text::new("end");
pub(super) const CORNER: Text = Text::new("corner");
pub(super) const FACE_BY_GAP: Text = Text::new("face-by-gap");
pub(super) const FACE_BY_CORNERS: Text = Text::new("face-by-corners");
pub(super) const COMPUTED: Text = Text::new("computed");
pub(super) const CONTACT_OPEN: Text = Text::new("contact-open");

// What if.
pub(super) const ALL_GIRDERS: Text = Text::new("all-girders");
pub(super) const MODEL_SECTION: Text = Text::new("model-section");
pub(super) const MODEL_SPATIAL: Text = Text::new("model-spatial");
pub(super) const STATE_HINT: Text = Text::new("state-hint");
pub(super) const APART_NOW: Text = Text::new("apart-now");
pub(super) const APART_MOST: Text = Text::new("apart-most");
pub(super) const FLUSH_NOTE: Text = Text::new("flush-note");
pub(super) const PINS_SECTION: Text = Text::new("pins-section");
pub(super) const PIN: Text = Text::new("pin");
pub(super) const PIN_THIS: Text = Text::new("pin-this");
pub(super) const PIN_HINT: Text = Text::new("pin-hint");
pub(super) const UNPIN_ALL: Text = Text::new("unpin-all");
pub(super) const PIN_THERE: Text = Text::new("pin-there");
pub(super) const PINS_FULL: Text = Text::new("pins-full");
pub(super) const NO_PINS: Text = Text::new("no-pins");
pub(super) const NOW: Text = Text::new("now");
pub(super) const PIN_DIFFERS_HINT: Text = Text::new("pin-differs-hint");
pub(super) const PLOTS_SECTION: Text = Text::new("plots-section");
pub(super) const ADD_PANEL: Text = Text::new("add-panel");
pub(super) const EXPORT_PLOTS: Text = Text::new("export-plots");
pub(super) const PLOTS_WRITTEN: Text = Text::new("plots-written");
#[cfg(not(feature = "study"))]
pub(super) const NO_PNG: Text = Text::new("no-png");
pub(super) const ADD_CURVE: Text = Text::new("add-curve");
pub(super) const CHANGE_CURVE: Text = Text::new("change-curve");
pub(super) const AGAINST: Text = Text::new("against");
pub(super) const TIME: Text = Text::new("time");
pub(super) const NARROW: Text = Text::new("narrow");
pub(super) const OFFER_ENERGY: Text = Text::new("offer-energy");
pub(super) const OFFER_DRIFT: Text = Text::new("offer-drift");
pub(super) const OFFER_ORBIT: Text = Text::new("offer-orbit");
pub(super) const OFFER_PENETRATION: Text = Text::new("offer-penetration");
pub(super) const OFFER_HYSTERESIS: Text = Text::new("offer-hysteresis");
pub(super) const OFFER_LOOP_DEVICE: Text = Text::new("offer-loop-device");
pub(super) const OFFER_LOOP_BEARING: Text = Text::new("offer-loop-bearing");
pub(super) const OFFER_USE: Text = Text::new("offer-use");
pub(super) const OFFER_EMPTY: Text = Text::new("offer-empty");
pub(super) const LIMITS_SECTION: Text = Text::new("limits-section");
pub(super) const LIMITS_KEPT: Text = Text::new("limits-kept");
pub(super) const READINGS: Text = Text::new("readings");
pub(super) const GO_TO_PEAK: Text = Text::new("go-to-peak");
pub(super) const CONTACTS_OF_PAIR: Text = Text::new("contacts-of-pair");
pub(super) const VIEWS: Text = Text::new("views");
pub(super) const PLAN_BESIDE: Text = Text::new("plan-beside");
pub(super) const GAP_SECTION: Text = Text::new("gap-section");
pub(super) const LECTURE: Text = Text::new("lecture");
pub(super) const FOLLOW: Text = Text::new("follow");
pub(super) const FOLLOW_NOTHING: Text = Text::new("follow-nothing");
pub(super) const SIZE: Text = Text::new("size");
pub(super) const LANGUAGE: Text = Text::new("language");
pub(super) const EXAGGERATION: Text = Text::new("exaggeration");
pub(super) const BENT: Text = Text::new("bent");
pub(super) const BENT_PLAIN: Text = Text::new("bent-plain");
pub(super) const PLAN: Text = Text::new("plan");
pub(super) const CONTACT_SECTION: Text = Text::new("contact-section");
pub(super) const SHOW_SECTION: Text = Text::new("show-section");
pub(super) const FIRST_VIEW: Text = Text::new("first-view");
pub(super) const FORCE_SCALE: Text = Text::new("force-scale");
pub(super) const AUTO_SCALE: Text = Text::new("auto-scale");

/// Names of the numbers in the status line, and what they mean.
pub(super) const STATUS: [(Text, Text); 7] = [
    (Text::new("status-moves"), Text::new("status-moves-hint")),
    (Text::new("status-turns"), Text::new("status-turns-hint")),
    (Text::new("status-peak"), Text::new("status-peak-hint")),
    (Text::new("status-hits"), Text::new("status-hits-hint")),
    (Text::new("status-ledger"), Text::new("status-ledger-hint")),
    (Text::new("status-error"), Text::new("status-error-hint")),
    (Text::new("status-run-in"), Text::new("status-run-in-hint")),
];
pub(super) const OUTSIDE: Text = Text::new("outside");
pub(super) const DRIFTING: Text = Text::new("drifting");
pub(super) const BEYOND_LAW: Text = Text::new("beyond-law");
pub(super) const LEFT_FACE: Text = Text::new("left-face");
pub(super) const UNBALANCED: Text = Text::new("unbalanced");
pub(super) const FRICTIONLESS: Text = Text::new("frictionless");
pub(super) const SOIL_OVERPUSHED: Text = Text::new("soil-overpushed");
pub(super) const SAVED: Text = Text::new("saved");
pub(super) const PICTURE_WRITTEN: Text = Text::new("picture-written");
pub(super) const TABLES_WRITTEN: Text = Text::new("tables-written");
/// The same on a page.
pub(super) const TABLES_LOADED: Text = Text::new("tables-loaded");
pub(super) const BEFORE: Text = Text::new("before");

// Guided scenes; their own words are in `assets/lessons`.
pub(super) const LEARN: Text = Text::new("learn");
pub(super) const TRY: Text = Text::new("try");
pub(super) const RESET: Text = Text::new("reset");
pub(super) const RESET_HINT: Text = Text::new("reset-hint");
pub(super) const CLOSE_LESSON: Text = Text::new("close-lesson");

// Films.
pub(super) const FILM: Text = Text::new("film");
pub(super) const FILM_FORMAT: Text = Text::new("film-format");
pub(super) const FILM_GIF: &str = "GIF";
pub(super) const FILM_PNG: Text = Text::new("film-png");
pub(super) const FILM_FROM: Text = Text::new("film-from");
pub(super) const FILM_TO: Text = Text::new("film-to");
pub(super) const FILM_FPS: Text = Text::new("film-fps");
pub(super) const FILM_SIZE: Text = Text::new("film-size");
pub(super) const FILM_AS_VIEW: Text = Text::new("film-as-view");
pub(super) const FILM_WHERE: Text = Text::new("film-where");
pub(super) const FILM_IMPOSSIBLE: Text = Text::new("film-impossible");
pub(super) const FILMING: Text = Text::new("filming");
pub(super) const CANCEL_FILM: Text = Text::new("cancel-film");
pub(super) const FILM_CANCELLED: Text = Text::new("film-cancelled");
pub(super) const FILM_WRITTEN: Text = Text::new("film-written");
pub(super) const LINK_TOO_LONG: Text = Text::new("link-too-long");
pub(super) const COPY_LINK: Text = Text::new("copy-link");
pub(super) const LINK_COPIED: Text = Text::new("link-copied");
pub(super) const NOT_ON_A_PAGE: Text = Text::new("not-on-a-page");

// Questions and notices.
pub(super) const UNSAVED_QUESTION: Text = Text::new("unsaved-question");
pub(super) const CLOSE_ANYWAY: Text = Text::new("close-anyway");
pub(super) const GIVE_UP: Text = Text::new("give-up");
pub(super) const SAVE_FIRST: Text = Text::new("save-first");
pub(super) const KEEP_OPEN: Text = Text::new("keep-open");
pub(super) const DISMISS: Text = Text::new("dismiss");
pub(super) const CLOSE: Text = Text::new("close");
pub(super) const WORK_FOUND: Text = Text::new("work-found");
pub(super) const WITHOUT_FILE: Text = Text::new("without-file");
pub(super) const WORK_IS_OLDER: Text = Text::new("work-is-older");
pub(super) const RECOVER: Text = Text::new("recover");
pub(super) const DISCARD: Text = Text::new("discard");
pub(super) const LATER: Text = Text::new("later");
pub(super) const FILE_CHANGED: Text = Text::new("file-changed");
pub(super) const RELOAD_REPLACES: Text = Text::new("reload-replaces");
pub(super) const RELOAD: Text = Text::new("reload");
pub(super) const KEEP_MINE: Text = Text::new("keep-mine");
pub(super) const FILE_GONE: Text = Text::new("file-gone");
pub(super) const NOT_KEPT: Text = Text::new("not-kept");
/// On the terminal: the window's display has gone, and with it the process ends.
pub(super) const CUT_OFF: Text = Text::new("window-cut-off");
/// The same with unsaved work.
pub(super) const CUT_OFF_KEPT: Text = Text::new("window-cut-off-kept");
/// The graphics device was lost, and everything is drawn on another.
pub(super) const DRAWN_ANEW: Text = Text::new("drawn-anew");

/// Every key, for the help.
pub(super) const KEYS: &[(Text, Text)] = &[
    (Text::new("key-space"), Text::new("key-space-does")),
    (Text::new("key-left-right"), Text::new("key-left-right-does")),
    (Text::new("key-events"), Text::new("key-events-does")),
    (Text::new("key-home-end"), Text::new("key-home-end-does")),
    (Text::new("key-slower"), Text::new("key-slower-does")),
    (Text::new("key-add-pier"), Text::new("key-add-pier-does")),
    (Text::new("key-pin"), Text::new("key-pin-does")),
    (Text::new("key-span"), Text::new("key-span-does")),
    (Text::new("key-map"), Text::new("key-map-does")),
    (Text::new("key-worst"), Text::new("key-worst-does")),
    (Text::new("key-loop"), Text::new("key-loop-does")),
    (Text::new("key-slow"), Text::new("key-slow-does")),
    (Text::new("key-views"), Text::new("key-views-does")),
    (Text::new("key-frame"), Text::new("key-frame-does")),
    (Text::new("key-back"), Text::new("key-back-does")),
    (Text::new("key-left-drag"), Text::new("key-left-drag-does")),
    (Text::new("key-shift-drag"), Text::new("key-shift-drag-does")),
    (Text::new("key-wheel"), Text::new("key-wheel-does")),
    (Text::new("key-click"), Text::new("key-click-does")),
    (Text::new("key-more"), Text::new("key-more-does")),
    (Text::new("key-all"), Text::new("key-all-does")),
    (Text::new("key-handle"), Text::new("key-handle-does")),
    (Text::new("key-digits"), Text::new("key-digits-does")),
    (Text::new("key-tab"), Text::new("key-tab-does")),
    (Text::new("key-nudge"), Text::new("key-nudge-does")),
    (Text::new("key-turn"), Text::new("key-turn-does")),
    (Text::new("key-add"), Text::new("key-add-does")),
    (Text::new("key-place"), Text::new("key-place-does")),
    (Text::new("key-row"), Text::new("key-row-does")),
    (Text::new("key-duplicate"), Text::new("key-duplicate-does")),
    (Text::new("key-undo"), Text::new("key-undo-does")),
    (Text::new("key-redo"), Text::new("key-redo-does")),
    (Text::new("key-files"), Text::new("key-files-does")),
    (Text::new("key-save-as"), Text::new("key-save-as-does")),
    (Text::new("key-escape"), Text::new("key-escape-does")),
    (Text::new("key-fold"), Text::new("key-fold-does")),
    (Text::new("key-fold-all"), Text::new("key-fold-all-does")),
    (Text::new("key-help"), Text::new("key-help-does")),
];
