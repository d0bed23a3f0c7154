//! The words that the window shows, but for those of errors, which stand where they arise, and how numbers are written.

mod edits;
mod fields;
mod handles;
mod map;
mod numbers;
mod panels;
mod paths;
mod plots;
mod readings;

pub(super) use edits::*;
pub(super) use fields::*;
pub(super) use handles::*;
pub(super) use map::*;
pub(super) use numbers::*;
pub(super) use panels::*;
pub(super) use paths::*;
pub(super) use plots::*;
pub(super) use readings::*;

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
pub(super) const EXPORT_REPORT: &str = "Export report…";
pub(super) const REPORT_WRITTEN: &str = "Report written";
pub(super) const QUIT: &str = "Quit";
pub(super) const PRESETS: &str = "Presets";
pub(super) const UNDO: &str = "Undo";
pub(super) const REDO: &str = "Redo";
pub(super) const ADD_GIRDER: &str = "Add girder";
pub(super) const ADD_ABUTMENT: &str = "Add abutment";
pub(super) const ADD_PIER: &str = "Add pier";
pub(super) const DUPLICATE: &str = "Duplicate";
pub(super) const REMOVE: &str = "Remove";
pub(super) const EDIT: &str = "Edit";
pub(super) const SELECT_ALL: &str = "Select all";
pub(super) const PLACE_GIRDER: &str = "Place girder with the mouse";
pub(super) const PLACE_ABUTMENT: &str = "Place abutment with the mouse";
pub(super) const ROW: &str = "Row of spans";
pub(super) const ROW_ASK: &str = "Row of spans…";
pub(super) const ROW_OF: &str = "In a row with equal gaps, like";
pub(super) const ROW_SPANS: &str = "Spans";
pub(super) const ROW_GAP: &str = "Gap between spans";
pub(super) const ROW_MAKE: &str = "Make the row";
pub(super) const TOOL_ENDS: &str = "click: place   Ctrl: no snapping   Esc: done";
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

// An empty scene.
pub(super) const START_BRIDGE: &str = "A bridge";
pub(super) const START_SPAN: &str = "Span length";
pub(super) const START_WIDTH: &str = "Deck width";
pub(super) const START_SKEW: &str = "Skew angle β";
pub(super) const START_SPANS: &str = "Number of spans";
pub(super) const START_BUILD: &str = "Build the bridge";
pub(super) const START_NOTHING: &str = "an empty scene";

// The view.
pub(super) const VIEW: &str = "3D view";
pub(super) const COMPUTING: &str = "Computing";
pub(super) const CANCEL: &str = "Cancel";
pub(super) const CANCELLED: &str = "Stopped: the picture shows the last finished run. Change anything to run again.";
pub(super) const CANCELLED_AT_ONCE: &str = "Stopped: the scene is shown as placed. Change anything to run again.";
pub(super) const PROBLEM: &str = "This scene cannot be run; the last good answer is still shown";
pub(super) const PROBLEM_AT_ONCE: &str = "This scene cannot be run";
pub(super) const STOPPED_EARLY: &str = "The run ended early";
pub(super) const EMPTY: &str = "Nothing is placed. Add a girder (G) or open a preset.";

// Time.
pub(super) const TIMELINE: &str = "Timeline";
pub(super) const CONTACTS: &str = "contacts";
pub(super) const PLAY: &str = "Play";
pub(super) const PAUSE: &str = "Pause";
pub(super) const TO_START: &str = "To the start";
pub(super) const TO_END: &str = "To the end";
pub(super) const STEP_BACK: &str = "Step back";
pub(super) const STEP_FORWARD: &str = "Step forward";
pub(super) const PREVIOUS_EVENT: &str = "Previous contact event";
pub(super) const NEXT_EVENT: &str = "Next contact event";
pub(super) const SPEED: &str = "Speed";
pub(super) const PLAYING: &str = "Playing";
pub(super) const LOOP: &str = "Loop";
pub(super) const LOOP_HINT: &str = "Begin again at the end (L)";
pub(super) const SLOW_AT_HITS: &str = "Slow at hits";
pub(super) const SLOW_HINT: &str = "Play at 1/100 while anything touches (M)";
pub(super) const ALL_SPAN: &str = "Play everything";
pub(super) const ALL_SPAN_HINT: &str = "Forget the stretch that is played (X); I and O set one";
pub(super) const ALL_TIME: &str = "Whole run";
pub(super) const ALL_TIME_HINT: &str = "Show the whole run (double click)";

// What is placed.
pub(super) const INSPECTOR: &str = "Numbers";
pub(super) const NOTHING_SELECTED: &str = "Select a girder or an abutment to see its numbers; these are the scene's.";
pub(super) const NAME: &str = "Name";
pub(super) const FREQUENCY_X: &str = "Bearings f x";
pub(super) const FREQUENCY_Y: &str = "Bearings f y";
pub(super) const DAMPING_X: &str = "Bearings h x";
pub(super) const DAMPING_Y: &str = "Bearings h y";
pub(super) const FREQUENCY_Z: &str = "Bearings f z";
pub(super) const DAMPING_Z: &str = "Bearings h z";
pub(super) const BEARINGS: &str = "Bearings";
pub(super) const BEARINGS_NONE: &str = "No bearings: it slides freely.";
pub(super) const BEARINGS_ADD: &str = "Put it on four bearings";
pub(super) const BEARINGS_ADD_LEAD: &str = "Put it on lead rubber";
pub(super) const BEARINGS_ADD_PENDULUM: &str = "Put it on friction pendulums";
pub(super) const BEARINGS_REMOVE: &str = "Take the bearings away";
pub(super) const BEARINGS_ONE_BY_ONE: &str = "Edit one by one";
pub(super) const BEARINGS_ONE_BY_ONE_HINT: &str = "Each bearing gets its own springs and dashpots, equal to begin with";
pub(super) const BEARING: &str = "Bearing";
pub(super) const BEARING_ADD: &str = "Add a bearing";
pub(super) const BEARING_REMOVE: &str = "Remove no.";
pub(super) const BEARING_HEIGHT: &str = "Height";
pub(super) const BEARING_X: &str = "At x";
pub(super) const BEARING_Y: &str = "At y";
pub(super) const BEARING_YIELD: &str = "Yield Q";
pub(super) const BEARING_YIELDS_AT: &str = "Yields at";
pub(super) const BEARING_PER_AXIS: &str = "Each axis for itself";
pub(super) const AT: &str = "Places, from the middle of the girder";
pub(super) const AT_SKEWED: &str = "Places, from the middle, x along the skewed plan";
pub(super) const AT_FOLLOWS: &str = "Places go with the skew";
pub(super) const START_SECTION: &str = "Start, push, held";
pub(super) const HELD: &str = "Held";
pub(super) const BACKFILL_SECTION: &str = "Soil behind the wall";
pub(super) const BACKFILL_NONE: &str = "The backwall is fixed.";
pub(super) const BACKFILL_ADD: &str = "Let it move against soil";
pub(super) const BACKFILL_REMOVE: &str = "Fix the backwall";
pub(super) const BACKFILL_ASSUMED: &str =
    "What is not ticked is assumed from the deck's width, the wall's height and the skew.";
pub(super) const ON_MINUS: &str = "-x half on";
pub(super) const ON_PLUS: &str = "+x half on";
pub(super) const ON_PIER: &str = "Stands on";
pub(super) const ON_GROUND: &str = "ground";
pub(super) const PIER_MORE: &str = "Damping, yield, place, cap";
pub(super) const PIER_WAY: &str = "Stiffness from";
pub(super) const PIER_BY_STIFFNESS: &str = "its number";
pub(super) const PIER_BY_FREQUENCY: &str = "its frequency";
pub(super) const PIER_BY_COLUMN: &str = "its columns";
pub(super) const PIER_K_ALONG: &str = "Stiffness along";
pub(super) const PIER_K_ACROSS: &str = "Stiffness across";
pub(super) const PIER_F_ALONG: &str = "Frequency along";
pub(super) const PIER_F_ACROSS: &str = "Frequency across";
pub(super) const PIER_COLUMN_ALONG: &str = "Column along";
pub(super) const PIER_COLUMN_ACROSS: &str = "Column across";
pub(super) const PIER_YIELD: &str = "Base yields at";
pub(super) const PIER_X: &str = "Place x";
pub(super) const PIER_Y: &str = "Place y";
pub(super) const PIER_CAP_ALONG: &str = "Cap along";
pub(super) const PIER_CAP_ACROSS: &str = "Cap across";
pub(super) const PIER_CAP_DEPTH: &str = "Cap depth";
pub(super) const PIER_PERIODS: &str = "Alone its periods along and across are";
pub(super) const PIER_DRIFT: &str = "In the run: drift";
pub(super) const PIER_SHEAR: &str = "base shear";
pub(super) const PIER_YIELDS: &str = "it yields at";
pub(super) const ELASTIC_SECTION: &str = "Flexibility";
pub(super) const ELASTIC_NONE: &str = "The girder is rigid.";
pub(super) const ELASTIC_ADD: &str = "Let it bend";
pub(super) const ELASTIC_REMOVE: &str = "Make it rigid";
pub(super) const ELASTIC_ASSUMED: &str = "Give the area or the density. Damping is a ratio of every mode, or Rayleigh's α and β. An empty degree is what the contacts need.";
pub(super) const SEAT_SECTION: &str = "Seats";
pub(super) const CODES_SECTION: &str = "Design codes";
pub(super) const SCENE_SECTION: &str = "Scene";
pub(super) const DESCRIPTION: &str = "About";
pub(super) const KIND: &str = "Motion in";
pub(super) const PLANAR: &str = "plan";
pub(super) const SPATIAL: &str = "space";
pub(super) const PAIRS_SECTION: &str = "Contact pairs";
pub(super) const PAIR: &str = "Pair";
pub(super) const OF_PAIR: &str = "of pair";
pub(super) const PAIR_RESET: &str = "Use the scene's numbers";
pub(super) const PAIR_RESET_HINT: &str = "Forget the numbers that this pair has of its own";
pub(super) const FROM_PAIR: &str = "of this pair";
pub(super) const FROM_SCENE: &str = "of the scene";
pub(super) const FROM_EA_L: &str = "E A / L (64)";
pub(super) const FROM_65: &str = "from e and K (65)";
pub(super) const FROM_NORMAL_LAW: &str = "of a head-on hit";
pub(super) const FROM_PLACES: &str = "as placed";
pub(super) const FACES: &str = "Stands before";
pub(super) const END: &str = "End";
pub(super) const CORNER: &str = "Corner";
pub(super) const FACE_BY_GAP: &str = "Give the face by its gap";
pub(super) const FACE_BY_CORNERS: &str = "Give the face by its corners";
pub(super) const COMPUTED: &str = "Computed";
pub(super) const CONTACT_OPEN: &str = "Open at this time.";

// What if.
pub(super) const ALL_GIRDERS: &str = "all girders";
pub(super) const MODEL_SECTION: &str = "Models";
pub(super) const MODEL_SPATIAL: &str = "The impact model knows planar scenes only.";
pub(super) const STATE_HINT: &str = "State under the impact model: a, b free; c, d on a corner; e, f on the face";
pub(super) const APART_NOW: &str = "Models apart now:";
pub(super) const APART_MOST: &str = "At the most:";
pub(super) const FLUSH_NOTE: &str = "A whole face hits in this run. There the models differ by nature: an elastic face \
spreads the push along itself for as long as the hit lasts, a rigid one takes it at once.";
pub(super) const PINS_SECTION: &str = "Before and after";
pub(super) const PIN: &str = "run";
pub(super) const PIN_THIS: &str = "Pin this run";
pub(super) const PIN_HINT: &str = "Keep it as a ghost and as thin lines to compare with (P)";
pub(super) const UNPIN_ALL: &str = "Unpin all";
pub(super) const PIN_THERE: &str = "This run is pinned already.";
pub(super) const PINS_FULL: &str = "Four runs are pinned: unpin one first.";
pub(super) const NO_PINS: &str = "Pin a run, change something, and see both.";
pub(super) const NOW: &str = "now";
pub(super) const PLOTS_SECTION: &str = "Plot panels";
pub(super) const ADD_PANEL: &str = "Add plot";
pub(super) const EXPORT_PLOTS: &str = "Export plots";
pub(super) const PLOTS_WRITTEN: &str = "Plots written";
#[cfg(not(feature = "study"))]
pub(super) const NO_PNG: &str = "this build draws no PNG (feature study); SVG and CSV it does";
pub(super) const ADD_CURVE: &str = "Add curve";
pub(super) const CHANGE_CURVE: &str = "Other curve";
pub(super) const AGAINST: &str = "Against";
pub(super) const TIME: &str = "time";
pub(super) const NARROW: &str = "part of its name";
pub(super) const OFFER_ENERGY: &str = "Energy ledger, stacked";
pub(super) const OFFER_DRIFT: &str = "Drift of a corner";
pub(super) const OFFER_ORBIT: &str = "Orbit of a corner";
pub(super) const OFFER_PENETRATION: &str = "Force against penetration";
pub(super) const OFFER_HYSTERESIS: &str = "Hysteresis of a contact";
pub(super) const OFFER_LOOP_DEVICE: &str = "Loop of a device or of soil";
pub(super) const OFFER_LOOP_BEARING: &str = "Loop of a bearing";
pub(super) const OFFER_USE: &str = "Use of the friction cone";
pub(super) const OFFER_EMPTY: &str = "Any quantity";
pub(super) const LIMITS_SECTION: &str = "Limits";
pub(super) const LIMITS_KEPT: &str = "No limit is passed.";
pub(super) const READINGS: &str = "Readings of the run";
pub(super) const GO_TO_PEAK: &str = "Go to its peak";
pub(super) const CONTACTS_OF_PAIR: &str = "Contacts, each with its forces and its history";
pub(super) const VIEWS: &str = "View";
pub(super) const PLAN_BESIDE: &str = "Plan beside the view";
pub(super) const GAP_SECTION: &str = "Section of the gap";
pub(super) const LECTURE: &str = "Lecture hall: view and time only, large";
pub(super) const FOLLOW: &str = "The view goes with";
pub(super) const FOLLOW_NOTHING: &str = "nothing";
pub(super) const SIZE: &str = "Size of everything";
pub(super) const EXAGGERATION: &str = "Motion shown";
pub(super) const BENT: &str = "Draw girders bent, larger than they are";
pub(super) const BENT_PLAIN: &str = "in their own colour";
pub(super) const PLAN: &str = "Plan";
pub(super) const CONTACT_SECTION: &str = "Contact";
pub(super) const SHOW_SECTION: &str = "Show";
pub(super) const FIRST_VIEW: &str = "Opens in";
pub(super) const FORCE_SCALE: &str = "Force scale";
pub(super) const AUTO_SCALE: &str = "Scale from peak";

/// Names of the numbers in the status line, and what they mean.
pub(super) const STATUS: [(&str, &str); 7] = [
    ("moves", "largest displacement of any girder"),
    ("turns", "largest rotation of any girder"),
    ("peak", "largest force |R| of any contact, dashpots included"),
    ("hits", "touches of a pair, from the first closing to the last opening"),
    ("ledger", "what the energy balance leaves over, of the largest energy in play"),
    ("error", "largest displacement difference from a run at a hundredth of the tolerance"),
    ("run in", "how long the run took"),
];
pub(super) const OUTSIDE: &str = "outside the domain";
pub(super) const BEYOND_LAW: &str = "a contact beyond its law";
pub(super) const UNBALANCED: &str = "energy does not balance";
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
pub(super) const GIVE_UP: &str = "Go on without saving";
pub(super) const SAVE_FIRST: &str = "Save first";
pub(super) const KEEP_OPEN: &str = "Keep working";
pub(super) const DISMISS: &str = "Dismiss";
pub(super) const CLOSE: &str = "Close";
pub(super) const WORK_FOUND: &str = "Work that was not saved before the program ended. Bring it back?";
pub(super) const WITHOUT_FILE: &str = "without a file";
pub(super) const WORK_IS_OLDER: &str = " The file has been written since then.";
pub(super) const RECOVER: &str = "Recover";
pub(super) const DISCARD: &str = "Discard";
pub(super) const LATER: &str = "Keep for later";
pub(super) const FILE_CHANGED: &str = "was changed by another program.";
pub(super) const RELOAD_REPLACES: &str = " Reloading replaces what you have changed here; undo brings it back.";
pub(super) const RELOAD: &str = "Reload";
pub(super) const KEEP_MINE: &str = "Keep mine";
pub(super) const FILE_GONE: &str = "the file is no longer there; save to write it again";
pub(super) const NOT_KEPT: &str = "Unsaved work cannot be kept:";
/// On the terminal: the window's display has gone, and with it the process ends.
pub(super) const CUT_OFF: &str = "error: the display is gone, and the window with it; nothing was unsaved";
/// The same with unsaved work.
pub(super) const CUT_OFF_KEPT: &str = "error: the display is gone, and the window with it; unsaved work is kept: it is offered when the program is opened \
                                      again";
/// The graphics device was lost, and everything is drawn on another.
pub(super) const DRAWN_ANEW: &str =
    "The graphics device was lost; everything is drawn anew, and nothing of the work is lost.";

/// Every key, for the help.
pub(super) const KEYS: &[(&str, &str)] = &[
    ("Space", "play, pause"),
    ("Left Right", "one step back, on; with Shift ten steps"),
    ("Ctrl Left Right", "previous, next contact event"),
    ("Home End", "to the start, to the end"),
    (", .", "slower, faster (down to 1/1000)"),
    ("Shift P", "add a pier under a joint"),
    ("P", "pin this run to compare with"),
    ("I  O  X", "play from here, play up to here, play everything"),
    ("Shift M", "map of a number of the run over two values"),
    ("Shift W", "which way of shaking is worst"),
    ("L", "begin again at the end, or stop"),
    ("M", "slow motion around hits"),
    ("1 2 3 4", "view: iso, top, side, contact"),
    ("F", "frame what is selected, or everything"),
    ("left drag", "turn the view; on what is selected: move it"),
    ("middle or Shift drag", "shift the view"),
    ("wheel", "nearer, farther; over the timeline: zoom in time"),
    ("click", "select; in timeline and plots: go to that time"),
    ("Ctrl or Shift click", "select more, or fewer"),
    ("Ctrl A", "select every girder and abutment"),
    ("drag a handle", "move, turn, length, width, skew, gap; with Ctrl without snapping"),
    ("digits on a handle", "type its number, also while dragging it: 12.5 mm, 60°; Enter sets it, Esc puts it back"),
    ("Tab, arrows", "to the next handle or control; pull a handle, with Shift ten times as far"),
    ("Alt arrows", "move what is selected by a small step; with Shift ten"),
    ("[ ]", "turn what is selected by 1°; with Shift by 15°"),
    ("G  B", "add a girder, an abutment"),
    ("Shift G  Shift B", "place a girder, an abutment with the mouse"),
    ("Ctrl R", "make a row of spans"),
    ("Ctrl D  Delete", "duplicate, remove what is selected"),
    ("Ctrl Z", "undo"),
    ("Ctrl Shift Z, Ctrl Y", "redo"),
    ("Ctrl N  Ctrl O  Ctrl S", "new, open, save"),
    ("Ctrl Shift S", "save as"),
    ("Esc", "select nothing, close this"),
    ("F2 F3 F4 F5", "fold or show: what is placed, the sliders, the plots, the lesson"),
    ("F6", "fold every panel, or show all"),
    ("F1", "this help"),
];
