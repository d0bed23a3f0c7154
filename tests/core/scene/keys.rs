//! The list of keys, the reader of files, the checks of a scene and the documentation say the same.

use girderbench::motion::format::FORMATS;
use girderbench::scene::keys::{self, Editable as _, Fallback, Key, Range, Slot, TABLES};
use girderbench::scene::{
    ContactNumber, ContactSettings, DeviceKind, FrictionLaw, PairSettings, Scene, SceneErrors, Tension, facing, format,
    overrides, validate,
};
use toml::{Table, Value};

/// A scene in which every table stands, but for a record; each way to say a thing that has two ways stands somewhere.
const FULL: &str = r#"
name = "full"
kind = "spatial"
duration_s = 1.0
[[girder]]
name = "deck"
length_m = 30.0
width_m = 10.0
thickness_m = 1.5
mass_kg = 6e5
seat_m = { "+x" = 0.7, "-x" = 0.7 }
initial = { spin_deg_s = 0.1 }
push = { moment_n_m = 1.0 }
bearings = { frequency_hz = 0.8, damping_ratio = 0.1, vertical_frequency_hz = 9.0, at_m = [[12, 4], [-12, -4]] }
[[girder]]
name = "other"
length_m = 20.0
width_m = 10.0
thickness_m = 1.5
mass_kg = 4e5
position_m = [-25.1, 0.0, 0.0]
bearings = [{ at_m = [0, 0], stiffness_n_per_m = [1e7, 1e7, 1e9], damping_n_s_per_m = [0, 0, 0] }]
[[abutment]]
name = "wall"
faces = "deck"
gap_m = 0.05
backfill = { base_friction = 0.5 }
[[pier]]
name = "p1"
mass_kg = 1e5
position_m = [12.0, 0.0]
frequency_hz = 3.0
[[restrainer]]
name = "cable"
girder = "deck"
to = "other"
at_m = [-15, 0]
to_m = [9, 0]
stiffness_n_per_m = 1e7
[[bumper]]
name = "rubber"
girder = "deck"
to = "wall"
at_m = [15, 0]
to_m = [0, 0]
stiffness_n_per_m = 1e8
[[damper]]
name = "dashpot"
girder = "deck"
at_m = [-15, 0]
to_m = [9, 0]
coefficient = 1e5
[[stopper]]
name = "key"
girder = "deck"
at_m = [0, 0]
stiffness_n_per_m = 1e8
[contact]
mu_static = 0.3
[[contact.pair]]
between = ["deck", "wall"]
[model]
kind = "contact"
[impact]
mu_static = 0.3
[motion]
kind = "sine"
amplitude_g = 0.4
frequency_hz = 0.8
[[ground]]
name = "bank"
kind = "none"
[solver]
tolerance = 1e-9
[limits]
drift_m = 0.1
[codes]
column_height_m = 8.0
[view]
camera = "top"
[[view.plot]]
y = ["deck.x"]
[view.overlays]
grid = false
"#;

const RECORD: &str = "kind = \"record\"\nsamples_m_s2 = [0.0, 1.0, 0.0]\ndt_s = 0.1\n";

const COMPONENT: &str = "kind = \"record\"\nx_azimuth_deg = 30.0\n[motion.processing]\nbaseline = \"mean\"\n\
    [[motion.component]]\nsamples_m_s2 = [0.0, 1.0, 0.0]\ndt_s = 0.1\nazimuth_deg = 75.0\n";

fn full() -> Scene {
    format::read(FULL, "full").unwrap_or_else(|errors| panic!("{errors}"))
}

/// The same with a record as its motion.
fn recorded(record: &str) -> Scene {
    let text = FULL.replace("kind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 0.8\n", record);
    format::read(&text, "recorded").unwrap_or_else(|errors| panic!("{errors}"))
}

/// The same under a wave; its abutment stands without soil.
fn waved() -> Scene {
    let text = FULL.replace("backfill = { base_friction = 0.5 }\n", "") + "[wave]\nspeed_m_per_s = 500.0\n";
    format::read(&text, "waved").unwrap_or_else(|errors| panic!("{errors}"))
}

/// A spatial scene with an elastic girder.
fn elastic() -> Scene {
    let text = "name = \"elastic\"\nkind = \"spatial\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\n\
                thickness_m = 1.5\nmass_kg = 6e5\n[girder.elastic]\narea_m2 = 8.0\nrayleigh = { mass = 0.1 }\n";
    format::read(text, "elastic").unwrap_or_else(|errors| panic!("{errors}"))
}

/// The path of a table as `--set` walks it in the full scene, and the scene.
fn standing(table: &str) -> (Scene, String) {
    let scene = match table {
        "girder.bearings kind" => {
            let text =
                FULL.replace("frequency_hz = 0.8, damping_ratio = 0.1, vertical", "kind = \"lead-rubber\", vertical");
            format::read(&text, "deck").unwrap_or_else(|errors| panic!("{errors}"))
        }
        "motion kind = record" => recorded(RECORD),
        "motion kind = synthetic" => recorded("kind = \"synthetic\"\n"),
        "motion kind = sweep" => recorded("kind = \"sweep\"\n"),
        "wave" => waved(),
        _ if table.starts_with("motion.") => recorded(COMPONENT),
        _ if table.starts_with("girder.elastic") => elastic(),
        _ => full(),
    };
    let path = match table {
        "girder.bearings[]" => "girder.other.bearings.0".to_owned(),
        "contact.pair" | "view.plot" | "motion.component" => format!("{table}.0"),
        "restrainer" => "restrainer.cable".to_owned(),
        "bumper" => "bumper.rubber".to_owned(),
        "damper" => "damper.dashpot".to_owned(),
        "stopper" => "stopper.key".to_owned(),
        "pier" => "pier.p1".to_owned(),
        "ground" => "ground.bank".to_owned(),
        _ if table.starts_with("abutment") => table.replacen("abutment", "abutment.wall", 1),
        "girder.bearings kind" => "girder.deck.bearings".to_owned(),
        _ if table.starts_with("girder") => table.replacen("girder", "girder.deck", 1),
        _ => table.split(" kind").next().unwrap_or_default().to_owned(),
    };
    (scene, path)
}

fn set(table: &str, key: &str, value: &str) -> Result<Scene, SceneErrors> {
    let (scene, path) = standing(table);
    let dot = if path.is_empty() { "" } else { "." };
    overrides::apply(&scene, &format!("{path}{dot}{key}={value}"))
}

#[test]
fn the_reader_knows_these_keys_and_no_others() {
    for table in TABLES {
        let errors = set(table.path, "no_such_key", "1").expect_err("not a key").0;
        let remedy = errors[0].remedy.to_string();
        let known = remedy.rsplit("keys known here: ").next().expect("it lists them");
        let mut known: Vec<&str> = known.split(", ").collect();
        let mut listed: Vec<&str> = table.keys.iter().map(|key| key.name).collect();
        if table.path.starts_with("motion kind") {
            listed.push("kind");
        }
        // Which other keys are known there is decided by the kind.
        if table.path == "motion" {
            known = vec!["kind"];
        }
        if table.path == "ground" {
            known = vec!["name", "kind"];
        }
        if table.path.starts_with("motion kind") {
            known.push("kind");
        }
        known.sort_unstable();
        listed.sort_unstable();
        assert_eq!(known, listed, "[{}]", table.path);
    }
}

/// A row of one of the documentation's tables: key, default, range, meaning, without marks.
fn documented() -> Vec<(String, [String; 4])> {
    let text = std::fs::read_to_string("docs/scene-format.md").expect("the documentation is there");
    let (mut heading, mut rows, mut seen_at) = (String::new(), Vec::new(), 0);
    for line in text.lines() {
        if let Some(title) = line.trim_start_matches('#').strip_prefix(' ').filter(|_| line.starts_with('#')) {
            title.replace(['`', '[', ']'], "").clone_into(&mut heading);
            seen_at = 0;
        }
        if let Some(kind) = line.strip_prefix("`kind = \"").and_then(|rest| rest.split('"').next()) {
            heading = format!("motion kind = {kind}");
        }
        let Some(row) = line.strip_prefix("| `").filter(|_| !heading.starts_with("Presets")) else { continue };
        let mut cells: Vec<String> = row.trim_end_matches(" |").split('|').map(|c| c.trim().replace('`', "")).collect();
        if cells.len() == 3 {
            cells.insert(2, "true or false".into());
        }
        let cells: [String; 4] = cells.try_into().unwrap_or_else(|c| panic!("{line}: four cells, got {c:?}"));
        seen_at += usize::from(heading == "bearings" && cells[0] == "at_m");
        let table = match heading.as_str() {
            "Top of the file" => String::new(),
            "bearings" if seen_at == 2 => "girder.bearings[]".into(),
            "Whole decks" => "girder.bearings kind".into(),
            "bearings" | "initial" | "push" | "seat_m" | "elastic" => format!("girder.{heading}"),
            "rayleigh" => "girder.elastic.rayleigh".into(),
            "backfill" => "abutment.backfill".into(),
            other => other.to_owned(),
        };
        rows.push((table, cells));
    }
    rows
}

fn default_in_words(key: &Key) -> String {
    match key.fallback {
        Fallback::Needed(words) | Fallback::Words(words) => words.to_owned(),
        Fallback::Number(number) => format!("{number:?}"),
        Fallback::Zeros(count) => format!("{:?}", vec![0.0; count]),
        Fallback::Word(word) => format!("{word:?}"),
        Fallback::Switch(on) => on.to_string(),
    }
}

fn range_in_words(range: Range) -> String {
    let short = |v: f64| if v != 0.0 && v.abs() < 1e-3 { format!("{v:e}") } else { v.to_string().replace('-', "−") };
    match range {
        Range::Any | Range::Free => String::new(),
        Range::Positive => "> 0".into(),
        Range::NotNegative => "≥ 0".into(),
        Range::NotBelow(key) => format!("≥ {key}"),
        Range::Within([low, high]) => format!("{} to {}", short(low), short(high)),
        Range::Between([low, high]) => format!("between {} and {}", short(low), short(high)),
        Range::Words(words) => words.iter().map(|w| format!("{w:?}")).collect::<Vec<_>>().join(", "),
        Range::Switch => "true or false".into(),
        Range::Like(words) => words.into(),
    }
}

#[test]
fn the_documentation_says_what_the_program_does() {
    let rows = documented();
    // The keys that every device begins with stand once.
    let ends = keys::Table { path: "Devices", keys: keys::ENDS };
    for table in TABLES.iter().chain([&ends]) {
        let own: Vec<&[String; 4]> = rows.iter().filter(|(t, _)| t == table.path).map(|(_, row)| row).collect();
        // A pair may have every key of `[contact]` but `pair` and `between`, which has a meaning of its own there: said in a
        // sentence.
        let said = table.keys.iter().filter(|key| {
            let own = key.name == "between" || keys::find(keys::CONTACT, key.name).is_none();
            let shared = DeviceKind::ALL.iter().any(|kind| kind.label() == table.path) && keys::ENDS.contains(key);
            (table.path != "contact.pair" || own) && !shared
        });
        let said: Vec<&Key> = said.collect();
        let names: Vec<&str> = own.iter().map(|row| row[0].as_str()).collect();
        assert_eq!(said.iter().map(|key| key.name).collect::<Vec<_>>(), names, "[{}]", table.path);
        for (key, [name, default, range, meaning]) in said.iter().zip(own) {
            let at = format!("[{}] {name}", table.path);
            let same = default.parse::<f64>().is_ok_and(|v| Some(v) == key.number());
            let plain = default.split(" (concrete)").next().expect("at least one");
            assert!(
                same || plain.parse::<f64>().is_ok_and(|v| Some(v) == key.number())
                    || *default == default_in_words(key),
                "{at}: {default}"
            );
            assert_eq!(range.replace("1e-2", "0.01"), range_in_words(key.range), "{at}");
            assert_eq!(*meaning, key.meaning, "{at}");
        }
    }
}

#[test]
fn fields_of_a_table_have_names_of_their_own_and_sliders_within_their_ranges() {
    let mut sliders = 0;
    for table in TABLES {
        for key in table.keys {
            let called = |key: &Key| key.label.unwrap_or(key.name);
            let alike = table.keys.iter().filter(|other| called(other) == called(key) && other.name != key.name);
            let alike: Vec<_> = alike.filter(|other| !overrides::replaced_by(key.name).contains(&other.name)).collect();
            assert!(alike.is_empty(), "[{}] {} and {alike:?} are called the same", table.path, key.name);
            let Some([from, to]) = key.slider else { continue };
            assert!(from < to, "[{}] {}: {from} to {to}", table.path, key.name);
            for bound in [from, to] {
                assert_eq!(key.range.fault(bound), None, "[{}] {}: {bound}", table.path, key.name);
            }
            sliders += 1;
        }
    }
    assert!(sliders > 15, "sliders of every table, got {sliders}");
}

#[test]
fn an_editor_reaches_every_value_by_its_key() {
    let mut contact = ContactSettings::default();
    let mut seen = Vec::new();
    for (key, slot) in contact.slots() {
        match slot {
            Slot::Number(number) => *number = 0.5,
            Slot::Optional(number) => *number = Some(2.0),
            Slot::Word(word) => {
                assert_eq!(word.chosen, word.default, "{}", key.name);
                word.choose(Some(1));
            }
            Slot::Apart | Slot::Switch(_) | Slot::Numbers(_) => assert_eq!(key.name, "pair"),
        }
        seen.push(key.name);
    }
    assert_eq!(seen, keys::CONTACT.iter().map(|key| key.name).collect::<Vec<_>>(), "in the order of the page");
    let text = format!("{contact:?}");
    assert!(text.contains("mu_static: 0.5") && text.contains("area: Some(2.0)"), "{text}");
    assert_eq!((contact.law, contact.tension), (FrictionLaw::ReturnMapping, Tension::Clamp), "the second word");
    let mut pair = PairSettings { law: Some(FrictionLaw::Paper), ..PairSettings::default() };
    for (_, slot) in pair.slots() {
        if let Slot::Word(word) = slot {
            assert_eq!(word.default, None, "it may be left out");
            word.choose(None);
        }
    }
    assert_eq!(pair.law, None, "the scene's again");
}

#[test]
fn every_format_of_records_is_documented() {
    let page = std::fs::read_to_string("docs/scene-format.md").expect("the documentation is there");
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    for format in FORMATS {
        assert!(page.contains(&format!("- {}", format.words())), "{}", format.words());
    }
}

/// The full scene without one key.
fn without(table: &str, key: &str) -> Scene {
    let (scene, path) = standing(table);
    let mut whole: Value = format::write(&scene).parse::<Table>().expect("as written").into();
    let steps = path.replace("deck", "0").replace("other", "1").replace("wall", "0");
    let first =
        |name: &str| matches!(name, "cable" | "rubber" | "dashpot" | "key").then_some("0").unwrap_or(name).to_owned();
    let steps = steps.split('.').map(first).collect::<Vec<_>>().join(".");
    let mut here = &mut whole;
    for step in steps.split('.').filter(|step| !step.is_empty()) {
        here = match step.parse::<usize>() {
            Ok(number) => &mut here[number],
            Err(_) if here.get(step).is_some() => &mut here[step],
            // Written only where something stands in it.
            Err(_) => return scene,
        };
    }
    here.as_table_mut().expect("a table").remove(key);
    format::parse(&toml::to_string(&whole).expect("a table"), "without").unwrap_or_else(|e| panic!("{key}: {e}"))
}

#[test]
fn what_is_said_to_be_the_default_is_what_the_reader_takes() {
    let mut checked = 0;
    for (table, key) in TABLES.iter().flat_map(|table| table.keys.iter().map(move |key| (table.path, key))) {
        let default = match key.fallback {
            Fallback::Needed(_) | Fallback::Words(_) => continue,
            Fallback::Number(_) if key.name == "format" => "1".to_owned(),
            // Under another kind there are other keys: the table is left out with it.
            _ if table == "motion" => continue,
            _ => default_in_words(key),
        };
        let without = without(table, key.name);
        let path = standing(table).1;
        let dot = if path.is_empty() { "" } else { "." };
        let with = overrides::apply(&without, &format!("{path}{dot}{}={default}", key.name));
        let with = with.unwrap_or_else(|e| panic!("[{table}] {}: {e}", key.name));
        if matches!(key.name, "young_modulus_pa" | "offset_m") {
            // Left out they stay unsaid in the scene: what follows from them is the same.
            assert_eq!(facing::find(&with), facing::find(&without), "[{table}] {}", key.name);
        } else {
            assert_eq!(with, without, "[{table}] {} = {default}", key.name);
        }
        checked += 1;
    }
    assert!(checked > 40, "defaults of every table, got {checked}");
}

#[test]
fn a_number_out_of_its_range_is_refused_with_the_ranges_own_words() {
    let mut checked = 0;
    for table in TABLES {
        for key in table.keys {
            let outside = match key.range {
                Range::Positive => 0.0,
                Range::NotNegative | Range::NotBelow(_) => -0.5,
                Range::Within([_, high]) => high * 2.0,
                Range::Between([low, _]) => low,
                Range::Any => 1e16,
                Range::Words(_) | Range::Switch | Range::Like(_) | Range::Free => continue,
            };
            let several = match key.name {
                "stiffness_n_per_m" | "damping_n_s_per_m" if table.path.ends_with("[]") => {
                    format!("[1e9, 1e9, {outside:?}]")
                }
                _ => format!("{outside:?}"),
            };
            let scene =
                set(table.path, key.name, &several).unwrap_or_else(|e| panic!("{}.{}: {e}", table.path, key.name));
            let errors = validate::validate(&scene).expect_err(key.name).0;
            let fault = key.range.fault(outside).expect("outside");
            // Of a table with several forms the place does not say which.
            let form = |path: &'static str| path.split(" kind").next();
            let found = errors.iter().any(|e| {
                keys::of_place(e.place.plain()).is_some_and(|(t, k)| {
                    (form(t.path), k.name) == (form(table.path), key.name) || t.path.starts_with("motion")
                }) && e.remedy == fault
            });
            assert!(found, "[{}] {}: {fault}; got {errors:#?}", table.path, key.name);
            checked += 1;
        }
    }
    assert!(checked > 50, "every number, got {checked}");
}

#[test]
fn a_planar_scene_refuses_every_key_of_space_and_a_spatial_one_has_it() {
    let mut checked = 0;
    for table in TABLES {
        for key in table.keys.iter().filter(|key| key.spatial) {
            let scene =
                set(table.path, key.name, "0.25").unwrap_or_else(|e| panic!("{}.{}: {e}", table.path, key.name));
            assert_eq!(validate::validate(&scene), Ok(()), "[{}] {} in space", table.path, key.name);
            let plan = Scene { kind: girderbench::scene::Kind::Planar, ..scene };
            let errors = validate::validate(&plan).expect_err(key.name).0;
            let place = errors[0].place.plain();
            assert!(place.ends_with(key.name) && errors.len() == 1, "[{}] {}: {errors:#?}", table.path, key.name);
            assert!(errors[0].remedy.to_string().contains("kind = \"spatial\""), "[{}] {}", table.path, key.name);
            checked += 1;
        }
    }
    assert_eq!(checked, 17, "keys of spatial scenes");
}

/// Lines of the room of scenes, its tests left out, where a word stands.
fn lines_with(word: &str) -> Vec<String> {
    let mut folders = vec![std::path::PathBuf::from("src/scene")];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder of the package") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).expect("a source file is text");
            let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
            let lines = code.lines().filter(|line| line.contains(word));
            found.extend(lines.map(|line| format!("{}: {}", path.display(), line.trim())));
        }
    }
    found.sort();
    found
}

#[test]
fn a_key_is_stated_in_one_place() {
    // Each stands once in its own table; both models have restitutions.
    for (word, times) in [
        ("restitution_tangential", 2),
        ("remaining_seat", 1),
        ("stop_speed", 1),
        ("\"spin_deg_s\"", 1),
        ("= \"tangential\"", 1),
    ] {
        let lines = lines_with(word);
        // A use of the value is `self.KEY`.
        let used = format!("self.{word}");
        let tables: Vec<_> = lines.iter().filter(|line| !line.contains("(seat_m)") && !line.contains(&used)).collect();
        assert_eq!(tables.len(), times, "{word}: {lines:#?}");
    }
}

#[test]
fn the_numbers_of_contact_are_keys_of_both_tables() {
    let mut scene = full();
    for number in ContactNumber::ALL {
        let [all, pair] = [keys::CONTACT, keys::PAIR].map(|keys| keys::find(keys, number.key).expect(number.key));
        assert_eq!((all.range, all.meaning), (pair.range, pair.meaning), "{}", number.key);
        assert_eq!(Some(*(number.of_all)(&mut ContactSettings::default())), all.number(), "{}", number.key);
        *(number.of_pair)(&mut scene.contact.pairs[0]) = Some(0.5);
    }
    let pairs = facing::find(&scene).expect("good");
    let numbers =
        |n: usize| ContactNumber::ALL.iter().map(|number| (number.in_force)(&pairs[n].contact)).collect::<Vec<_>>();
    assert!(ContactNumber::ALL.len() >= 4, "restitution and friction");
    assert_eq!(numbers(0), vec![0.5; ContactNumber::ALL.len()], "the pair's own lie over the scene's");
}
