//! The house's rules that a compiler does not know: which room may use which, what the physics rooms keep out, one
//! shader a pass, short files.

#[path = "architecture/imports.rs"]
mod imports;
#[path = "architecture/source.rs"]
mod source;
#[path = "architecture/summary_page.rs"]
mod summary_page;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use imports::Imports;
use source::{blank_comments_and_strings, files_under, has_word, is_word, root, sources};

/// Every room and the rooms that it may use: arrows run one way.
const ROOMS: &[(&str, &[&str])] = &[
    ("language", &[]),
    ("geometry", &[]),
    ("plot", &[]),
    ("contact", &["geometry"]),
    ("motion", &["geometry", "language"]),
    ("identify", &["motion", "language"]),
    ("measure", &["language"]),
    ("scene", &["geometry", "contact", "motion", "language"]),
    ("dynamics", &["geometry", "contact", "motion", "scene", "language"]),
    ("sim", &["geometry", "contact", "motion", "scene", "dynamics", "language"]),
    ("codes", &["geometry", "scene", "dynamics", "sim", "language"]),
    (
        "study",
        &["geometry", "contact", "motion", "identify", "measure", "scene", "dynamics", "sim", "plot", "language"],
    ),
    ("tables", &["geometry", "scene", "dynamics", "sim", "codes", "language"]),
    ("report", &["geometry", "motion", "scene", "dynamics", "sim", "codes", "study", "tables", "plot", "language"]),
    ("view", &["geometry", "scene", "dynamics", "sim", "plot", "language"]),
    ("render", &["view", "language"]),
    ("snapshot", &["scene", "sim", "view", "render"]),
    ("files", &["scene", "motion", "language"]),
    (
        "app",
        &[
            "geometry", "scene", "dynamics", "sim", "codes", "study", "tables", "report", "view", "render", "snapshot",
            "files", "plot", "language",
        ],
    ),
    (
        "cli",
        &[
            "geometry", "motion", "identify", "measure", "scene", "dynamics", "sim", "codes", "tables", "report",
            "view", "render", "snapshot", "files", "app", "study", "plot", "language",
        ],
    ),
    ("page", &["scene", "sim", "tables", "files", "app"]),
];

/// Every room of the window and the rooms of the window that it may use.
const APP_ROOMS: &[(&str, &[&str])] = &[
    ("host", &[]),
    ("style", &[]),
    ("unit", &[]),
    ("command", &[]),
    ("text", &["style", "unit", "command"]),
    ("field", &["style", "unit", "text"]),
    ("edits", &["command", "text"]),
    ("learn", &["command", "text"]),
    ("link", &["text"]),
    ("run", &["host", "style", "command", "text"]),
    ("time", &["style", "command", "text", "run"]),
    ("plot", &["host", "style", "command", "text", "field", "run", "time"]),
    ("disk", &["host", "command", "text", "edits", "run", "time"]),
    ("map", &["host", "style", "unit", "command", "text", "field"]),
    ("quake", &["host", "style", "command", "text", "run", "time", "plot"]),
    ("viewport", &["style", "unit", "command", "text", "field", "edits", "run", "time"]),
    (
        "bench",
        &[
            "host", "style", "command", "text", "edits", "learn", "link", "run", "time", "plot", "disk", "viewport",
            "map", "quake",
        ],
    ),
    (
        "panel",
        &[
            "host", "style", "unit", "command", "text", "field", "edits", "learn", "run", "time", "plot", "disk",
            "viewport", "map", "quake", "bench",
        ],
    ),
    ("shell", &["host", "command", "style", "text", "run", "disk", "bench", "panel"]),
];

/// Every room inside of `dynamics` and the rooms of `dynamics` that it may use, without exception.
const DYNAMICS_ROOMS: &[(&str, &[&str])] = &[
    ("integrator", &[]),
    ("locate", &[]),
    ("connection", &[]),
    ("devices", &["connection"]),
    ("elastic", &[]),
    ("linear", &[]),
    ("model", &["connection", "devices", "elastic", "linear"]),
    ("free_flight", &["integrator", "elastic", "linear", "model"]),
    ("trajectory", &["integrator", "model", "free_flight"]),
    ("penalty3d", &["integrator", "locate", "connection", "model", "free_flight", "trajectory"]),
    ("record", &["integrator", "connection", "model", "free_flight", "trajectory", "penalty3d"]),
    ("event_loop", &["record"]),
    ("world", &["locate", "connection", "model", "free_flight", "trajectory", "penalty3d", "record"]),
    ("closing", &["integrator", "locate", "connection", "linear", "model", "free_flight", "penalty3d", "world"]),
    (
        "contact_model",
        &["integrator", "connection", "model", "trajectory", "penalty3d", "record", "event_loop", "world", "closing"],
    ),
    ("impact2d", &["integrator", "locate", "model", "free_flight", "trajectory", "event_loop", "world"]),
    ("run", &["model", "free_flight", "trajectory", "record", "event_loop", "contact_model", "impact2d"]),
];

/// Files and rooms of the window that take the workbench whole; every other takes the parts that it needs.
const TAKE_THE_WORKBENCH: &[&str] = &["src/app/mod.rs", "src/app/bench/", "src/app/panel/layout.rs", "src/app/shell/"];

/// The core: rooms whose answer depends on their input alone, to the last bit.
const CORE: &[&str] =
    &["language", "geometry", "plot", "contact", "motion", "identify", "measure", "scene", "dynamics", "sim", "codes"];

/// Rooms that may open files.
const MAY_OPEN_FILES: &[&str] = &["app", "cli", "files", "snapshot"];

/// Where a room of the core may use such a word all the same, and why.
const EXCUSED: &[(&str, &str, &str)] = &[
    ("src/scene/format/read.rs", "f32", "serde's list of every type; a scene has no f32 to read"),
    ("src/language/catalog.rs", "HashMap", "texts are looked up by their keys and never walked"),
    ("src/measure/grey.rs", "f32", "a pixel's grey, from three numbers of 8 bits; sums over pixels are f64"),
    ("src/measure/marks.rs", "f32", "a pixel's grey, from three numbers of 8 bits; sums over pixels are f64"),
    ("src/plot/raster.rs", "f32", "pixels of a plot, which is finished before"),
];

/// Lines a file may have; look twice long before.
const LONGEST_FILE: usize = 400;
/// Lines a test may have: a table of cases is read by row.
const LONGEST_TEST: usize = 600;
/// Files that may be longer, and why.
const LONG_FILES: &[(&str, &str)] = &[];

/// Rooms that a piece of code reaches through `crate::…`, grouped imports included.
fn used_rooms(code: &str) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    for (at, path) in code.match_indices("crate::") {
        let rest = &code[at + path.len()..];
        match rest.strip_prefix('{') {
            None => used.extend([rest.chars().take_while(|&c| is_word(c)).collect()]),
            Some(group) => used.extend(first_words_of_group(group)),
        }
    }
    used
}

/// `a::b, c::{d, e}, f}` → a, c, f.
fn first_words_of_group(group: &str) -> Vec<String> {
    let (mut depth, mut words, mut word, mut at_start) = (0_i32, Vec::new(), String::new(), true);
    for c in group.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                words.push(std::mem::take(&mut word));
                at_start = true;
            }
            c if depth == 0 && at_start && is_word(c) => word.push(c),
            c if c.is_whitespace() => {}
            _ => at_start = false,
        }
    }
    words.push(word);
    words.retain(|word| !word.is_empty());
    words
}

/// The anchor of a heading in a rendered page: lower case, hyphens for spaces, other punctuation dropped.
fn anchor(heading: &str) -> String {
    let kept = |c: char| if c == ' ' { Some('-') } else { (is_word(c) || c == '-').then_some(c) };
    heading.trim().to_lowercase().chars().filter_map(kept).collect()
}

/// Anchors of a page's headings, code blocks left out.
fn anchors(page: &str) -> BTreeSet<String> {
    let outside = page.split("\n```").step_by(2);
    let headings = outside.flat_map(str::lines).filter(|line| line.starts_with('#'));
    headings.map(|line| anchor(line.trim_start_matches('#'))).collect()
}

/// Pages of `docs/` that a text names with an anchor, `("solver", "the-record")`.
fn named_anchors(text: &str) -> Vec<(&str, &str)> {
    text.split("docs/").skip(1).filter_map(named_anchor).collect()
}

/// `solver.md#the-record, …` without its rest.
fn named_anchor(text: &str) -> Option<(&str, &str)> {
    let word = |s: &str| s.find(|c: char| !is_word(c) && c != '-').unwrap_or(s.len());
    let (page, rest) = text.split_once(".md#")?;
    (word(page) == page.len()).then(|| (page, &rest[..word(rest)]))
}

/// Fails with every complaint in one message.
fn expect_none(complaints: &[String], rule: &str) {
    assert!(complaints.is_empty(), "{rule}:\n  {}", complaints.join("\n  "));
}

#[test]
fn imports_run_one_way() {
    let allowed: BTreeMap<&str, &[&str]> = ROOMS.iter().copied().collect();
    let mut complaints = Vec::new();
    for source in sources("src", "rs") {
        let Some(room) = source.room() else { continue };
        let Some(may_use) = allowed.get(room) else {
            complaints.push(format!("{}: the room {room} has no place in ROOMS", source.path));
            continue;
        };
        for used in used_rooms(&source.code) {
            if allowed.contains_key(used.as_str()) && used != room && !may_use.contains(&used.as_str()) {
                complaints.push(format!("{}: {room} uses {used}", source.path));
            }
        }
    }
    expect_none(&complaints, "a room uses only rooms listed before it (ROOMS)");
}

/// Imports between the rooms under a folder that a table of them does not allow.
fn climbs(folder: &str, rooms: &[(&str, &[&str])]) -> Vec<String> {
    let allowed: BTreeMap<&str, &[&str]> = rooms.iter().copied().collect();
    let room = |path: &str| -> Option<String> {
        let inside = path.strip_prefix(folder)?.split('/').next()?.trim_end_matches(".rs").to_owned();
        (inside != "mod").then_some(inside)
    };
    let imports = Imports::of(&sources("src", "rs"));
    let mut complaints = Vec::new();
    for (from, to) in imports.arrows() {
        let (Some(user), Some(used)) = (room(from), room(to)) else { continue };
        match allowed.get(user.as_str()) {
            None => complaints.push(format!("{from}: the room {user} has no place in the table")),
            Some(may_use) if used != user && !may_use.contains(&used.as_str()) => {
                complaints.push(format!("{from}: {user} uses {used} ({to})"));
            }
            Some(_) => {}
        }
    }
    complaints
}

#[test]
fn imports_inside_the_window_run_one_way() {
    let complaints = climbs("src/app/", APP_ROOMS);
    expect_none(&complaints, "a room of the window uses only rooms listed before it (APP_ROOMS)");
}

#[test]
fn imports_inside_of_dynamics_run_one_way() {
    let complaints = climbs("src/dynamics/", DYNAMICS_ROOMS);
    expect_none(&complaints, "a room of dynamics uses only rooms listed before it (DYNAMICS_ROOMS)");
}

#[test]
fn panels_take_the_parts_that_they_need() {
    let sources = sources("src/app", "rs");
    let others = sources.iter().filter(|source| !TAKE_THE_WORKBENCH.iter().any(|path| source.path.starts_with(path)));
    let whole = others.filter(|source| has_word(&source.code, "Workbench"));
    expect_none(&whole.map(|source| source.path.clone()).collect::<Vec<_>>(), "panels take parts (TAKE_THE_WORKBENCH)");
}

#[test]
fn files_do_not_import_each_other_in_a_circle() {
    let circles = Imports::of(&sources("src", "rs")).circles();
    let complaints: Vec<String> =
        circles.iter().map(|circle| format!("a circle of {}: {circle:?}", circle.len())).collect();
    expect_none(&complaints, "files do not import each other in a circle");
}

#[test]
fn the_core_knows_no_clock_no_file_no_hash_order_and_no_f32() {
    let words = ["f32", "Instant", "SystemTime", "HashMap", "HashSet", "RandomState", "std::fs", "File", "std::env"];
    let sources = sources("src", "rs");
    let core = sources.iter().filter(|source| source.room().is_some_and(|room| CORE.contains(&room)));
    let excused = |path: &str, word: &str| EXCUSED.iter().any(|(p, w, _)| *p == path && *w == word);
    let mut found = Vec::new();
    for source in core {
        let used = words.iter().filter(|word| has_word(source.production(), word) && !excused(&source.path, word));
        found.extend(used.map(|word| format!("{}: {word}", source.path)));
    }
    expect_none(&found, "the answer of a room of the core depends on its input alone");
}

#[test]
fn what_was_chosen_for_a_random_scene_is_named_in_the_docs() {
    let page = fs::read_to_string(root().join("docs/stability.md")).expect("the page");
    let named = |number: &str| page.split(|c: char| !c.is_ascii_digit()).any(|word| word == number);
    let mut missing = Vec::new();
    for source in sources("src", "rs") {
        for rest in source.production().split("seed ").skip(1) {
            let number: String = rest.chars().take_while(char::is_ascii_digit).collect();
            if !number.is_empty() && !named(&number) {
                missing.push(format!("{}: seed {number}", source.path));
            }
        }
    }
    expect_none(&missing, "docs/stability.md names every seed that a constant was chosen by");
}

#[test]
fn only_the_outer_rooms_open_files() {
    let sources = sources("src", "rs");
    let inner = sources.iter().filter(|source| source.room().is_some_and(|room| !MAY_OPEN_FILES.contains(&room)));
    let opens = inner.filter(|source| ["std::fs", "File"].iter().any(|word| has_word(source.production(), word)));
    expect_none(&opens.map(|source| source.path.clone()).collect::<Vec<_>>(), "files are opened by app, cli and files");
}

#[test]
fn every_pass_has_its_shader_and_every_shader_its_pass() {
    let stems = |folder: &str, extension: &str| -> BTreeSet<String> {
        let here = root().join(folder);
        let own = files_under(folder, extension).into_iter().filter(|path| path.parent() == Some(here.as_path()));
        own.filter_map(|path| Some(path.file_stem()?.to_string_lossy().into_owned())).filter(|s| s != "mod").collect()
    };
    let (shaders, passes) = (stems("shaders", "wgsl"), stems("src/render/pass", "rs"));
    assert!(!shaders.is_empty(), "shaders/ has shaders");
    assert_eq!(shaders, passes, "shaders/<stem>.wgsl and src/render/pass/<stem>.rs come in pairs");
}

#[test]
fn every_shader_says_something() {
    for source in sources("shaders", "wgsl") {
        assert!(!source.code.trim().is_empty(), "{} has code", source.path);
        assert!(source.text.starts_with("//"), "{} opens with what goes in, what comes out", source.path);
    }
}

#[test]
fn files_are_short() {
    let folders = [("src", "rs", LONGEST_FILE), ("shaders", "wgsl", LONGEST_FILE), ("tests", "rs", LONGEST_TEST)];
    let mut complaints = Vec::new();
    for (folder, extension, longest) in folders {
        for source in sources(folder, extension) {
            let lines = source.text.lines().count();
            if lines > longest && !LONG_FILES.iter().any(|(long, _)| *long == source.path) {
                complaints.push(format!("{}: {lines} lines, {longest} at most", source.path));
            }
        }
    }
    expect_none(&complaints, "a file is short, or has a reason in LONG_FILES");
}

#[test]
fn every_file_says_what_it_is_for() {
    let sources = sources("src", "rs");
    let silent = sources
        .iter()
        .filter(|source| source.text.lines().next().is_none_or(|line| line.len() < 20 || !line.starts_with("//! ")));
    expect_none(
        &silent.map(|source| source.path.clone()).collect::<Vec<_>>(),
        "a file opens with //! and what it is for",
    );
}

#[test]
fn links_in_the_pages_lead_somewhere() {
    let mut broken = Vec::new();
    for page in [vec![root().join("README.md")], files_under("docs", "md")].concat() {
        let text = fs::read_to_string(&page).expect("a page is text");
        let folder = page.parent().expect("a page lies in a folder");
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            if file.contains("://") {
                continue;
            }
            let target = if file.is_empty() { page.clone() } else { folder.join(file) };
            let leads = || fs::read_to_string(&target).is_ok_and(|text| anchors(&text).contains(anchor));
            if !target.exists() || !(anchor.is_empty() || leads()) {
                broken.push(format!("{}: {link}", page.display()));
            }
        }
    }
    expect_none(&broken, "a link leads to a file of this package, and to a heading of it");
}

#[test]
fn anchors_of_the_pages_exist() {
    let (mut broken, mut named) = (Vec::new(), 0);
    let code = ["src", "tests", "benches"].into_iter().flat_map(|folder| sources(folder, "rs"));
    for source in code.chain(sources("docs", "md")) {
        for (page, anchor) in named_anchors(&source.text) {
            let text = fs::read_to_string(root().join("docs").join(page).with_extension("md"));
            named += 1;
            if !text.is_ok_and(|text| anchors(&text).contains(anchor)) {
                broken.push(format!("{}: docs/{page}.md, anchor {anchor}", source.path));
            }
        }
    }
    assert!(named > 20, "comments name the sections of docs/physics.md: {named} found");
    expect_none(&broken, "a section that a comment names is a heading of that page");
}

#[test]
fn texts_of_commands_are_for_what_a_page_does_not_show() {
    // A page has no table of the command line's texts: elsewhere it would show their keys.
    const BY_COMMANDS: [&str; 5] = ["cli", "identify", "measure", "study", "render"];
    let table = fs::read_to_string(root().join("assets/texts/en.command.ftl")).expect("a table");
    let keys: BTreeSet<&str> = table.lines().filter_map(|line| Some(line.split_once(" = ")?.0)).collect();
    let mut shown = Vec::new();
    let by_others = |source: &source::Source| !source.room().is_some_and(|room| BY_COMMANDS.contains(&room));
    for source in sources("src", "rs").into_iter().filter(by_others) {
        let is_named = |key: &&&str| source.text.contains(&format!("\"{key}\""));
        shown.extend(keys.iter().filter(is_named).map(|key| format!("{}: {key}", source.path)));
    }
    assert!(keys.len() > 100, "{} keys", keys.len());
    expect_none(&shown, "its text belongs into the table that the page has, en.ftl and ja.ftl");
}

#[test]
fn lints_are_expected_with_a_reason_never_allowed() {
    let sources = sources("src", "rs");
    let allowing = sources.iter().filter(|source| source.code.contains("[allow("));
    expect_none(&allowing.map(|source| source.path.clone()).collect::<Vec<_>>(), "use #[expect(lint, reason = …)]");
}

#[test]
fn the_lint_table_is_in_force() {
    let manifest: toml::Table =
        fs::read_to_string(root().join("Cargo.toml")).expect("a manifest").parse().expect("a manifest is TOML");
    let lints = &manifest["lints"];
    assert_eq!(lints["rust"]["unsafe_code"].as_str(), Some("forbid"), "no unsafe code");
    assert_eq!(lints["rust"]["missing_docs"].as_str(), Some("warn"), "public items are documented");
    for lint in ["unwrap_used", "print_stdout", "print_stderr", "dbg_macro", "todo", "iter_over_hash_type"] {
        assert_eq!(lints["clippy"][lint].as_str(), Some("warn"), "{lint} is on (and an error in CI)");
    }
}

#[test]
fn the_rules_find_what_they_are_for() {
    assert_eq!(used_rooms("use crate::{scene::{a, b}, sim, view::c};\ncrate::app::run()").len(), 4, "all four");
    assert!(has_word("let x: f32 = 0.0;", "f32"), "a plain use");
    assert!(!has_word("as_f32_bits", "f32"), "a part of a longer word");
    assert_eq!(anchor(" Law `return-mapping`"), "law-return-mapping", "code marks are dropped");
    assert_eq!(anchor(" Sharing of a pair's stiffness"), "sharing-of-a-pairs-stiffness", "so is an apostrophe");
    let comment = ["see `docs/", "physics.md", "#a-b`, not docs/", "a.md or docs/*.md", "#c"].concat();
    assert_eq!(named_anchors(&comment), [("physics", "a-b")], "a page with an anchor, and no other");
    let blanked = blank_comments_and_strings("let a = \"f32 \\\" f32\"; // f32\nlet b = '\"';");
    assert!(!has_word(&blanked, "f32"), "comments and strings do not count: {blanked}");
    assert!(blanked.contains("let b"), "the next line does: {blanked}");
}
