//! Tables of texts: every language has the same keys, the code uses each, and a text takes no value that English lacks.
//!
//! What keys of the scene file mean (`*.keys.ftl`) and flags of the command line do (`*.help.ftl`) stands in English with them:
//! `scene::keys` and `cli::help` have the tests of that.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use girderbench::dynamics::Model;
use girderbench::language::{Language, Text};
use girderbench::motion::format::{self, Supplement};
use girderbench::scene::{ModelKind, presets};
use girderbench::sim::Session;

/// The tables that every language has: of the window, of complaints, of the command line.
const TABLES: [&str; 3] = ["", ".complaints", ".command"];

/// The lines of each key of a language's tables.
fn table(language: Language) -> BTreeMap<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/texts");
    let read = |table| fs::read_to_string(folder.join(format!("{}{table}.ftl", language.code()))).expect("a table");
    let text = TABLES.map(read).join("\n");
    let mut texts: BTreeMap<String, String> = BTreeMap::new();
    let mut last = String::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if line.starts_with(char::is_whitespace) {
            *texts.get_mut(&last).expect("a key stands before what goes on") += line;
            continue;
        }
        let (key, words) = line.split_once('=').unwrap_or_else(|| panic!("no text: {line}"));
        key.trim().clone_into(&mut last);
        assert!(texts.insert(last.clone(), words.trim().to_owned()).is_none(), "{last} stands once");
    }
    texts
}

/// Names of the values of a text.
fn values(text: &str) -> BTreeSet<String> {
    let names = text.split('$').skip(1);
    names.map(|rest| rest.chars().take_while(char::is_ascii_alphanumeric).collect()).collect()
}

/// Every source file of the program, one after the other.
fn code(folder: &Path) -> String {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let text = |path: std::path::PathBuf| {
        if path.is_dir() { code(&path) } else { fs::read_to_string(path).unwrap_or_default() }
    };
    entries.map(text).collect()
}

#[test]
fn every_language_has_every_text_and_no_value_of_its_own() {
    let english = table(Language::English);
    for language in Language::ALL {
        let other = table(language);
        let missing: Vec<_> = english.keys().filter(|key| !other.contains_key(*key)).collect();
        let more: Vec<_> = other.keys().filter(|key| !english.contains_key(*key)).collect();
        assert!(missing.is_empty() && more.is_empty(), "{}: lacks {missing:?}, alone has {more:?}", language.code());
        for (key, text) in &other {
            assert!(!text.is_empty(), "{}: {key} is empty", language.code());
            let unknown: Vec<_> = values(text).difference(&values(&english[key])).cloned().collect();
            assert!(unknown.is_empty(), "{}: {key} takes {unknown:?}", language.code());
        }
    }
}

#[test]
fn a_key_stands_in_one_table() {
    for language in Language::ALL {
        let mut tables = BTreeMap::new();
        for file in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/texts")).expect("a folder") {
            let path = file.expect("a file").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            if !name.starts_with(&format!("{}.", language.code())) {
                continue;
            }
            let text = fs::read_to_string(&path).expect("a table");
            let begins = |line: &&str| line.starts_with(|c: char| c.is_ascii_alphabetic());
            for key in text.lines().filter(begins).filter_map(|line| Some(line.split_once('=')?.0.trim())) {
                let other = tables.insert(key.to_owned(), name.clone());
                assert_eq!(other, None, "{key} of {name} stands there too");
            }
        }
        assert!(tables.len() > 1000, "{}: read", language.code());
    }
}

#[test]
fn the_code_uses_every_text() {
    let code = code(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    let english = table(Language::English);
    let unused: Vec<_> = english.keys().filter(|key| !code.contains(&format!("\"{key}\""))).collect();
    assert!(unused.is_empty(), "no use of {unused:?}");
    let used = ["Text::new(\"", "said!(\""].into_iter().flat_map(|call| code.split(call).skip(1));
    let used = used.filter_map(|rest| rest.split('"').next());
    // Nameless: the texts of plots, which egui_plot calls so too.
    let unknown: Vec<_> = used.filter(|key| !key.is_empty() && !english.contains_key(*key)).collect();
    assert!(unknown.is_empty(), "no text for {unknown:?}");
}

#[test]
fn texts_without_values_are_read_in_every_language() {
    for language in Language::ALL {
        language.speak();
        for (key, words) in table(language).into_iter().filter(|(_, words)| !words.contains('{')) {
            let read = Text::new(key.clone().leak()).to_string();
            assert_eq!(
                read.split_whitespace().collect::<String>(),
                words.split_whitespace().collect::<String>(),
                "{key}"
            );
        }
    }
}

/// Whether a sentence of English stands in it: three of its commonest words are enough to know one by.
fn has_english(text: &str) -> bool {
    let words = |word: &str| text.split(|c: char| !c.is_ascii_alphabetic()).any(|own| own == word);
    ["the", "must", "give", "is", "found", "line", "of", "a", "too"].into_iter().any(words)
}

#[test]
fn why_a_run_ends_is_told_in_the_language_of_its_reader_and_in_english_in_files() {
    let mut scene = presets::load("viaduct-5").expect("a preset");
    let model = Model::compile(&scene).expect("a model");
    scene.model.kind = ModelKind::Impact;
    let mut session = Session::of_model(&scene, model);
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    let stop = history.stop().expect("it gives up");
    assert!(stop.reason.to_string().contains("the impact model knows no devices, no piers"), "{stop:?}");
    Language::Japanese.within(|| {
        let said = stop.reason.to_string();
        assert!(said.contains("衝撃モデルは装置、橋脚") && !has_english(&said), "{said}");
        let file = serde_json::to_string(stop).expect("written");
        assert!(file.contains("the impact model knows no devices, no piers"), "{file}");
    });
}

#[test]
fn what_is_wrong_with_a_record_is_told_in_the_language_of_its_reader() {
    let at2 = "PEER\nA QUAKE, 270\nACCELERATION IN UNITS OF G\nNPTS= 4, DT= .01 SEC\n";
    for (name, text, japanese) in [
        ("a.csv", "0,1\n0.1,x\n".to_owned(), "加速度は 1e15 以下の数"),
        ("a.csv", "0,1\n0.1,2\n0.5,3\n".to_owned(), "データは等間隔とする"),
        ("a.dat", "1\n2\n".to_owned(), "時間刻みを与える"),
        ("a.at2", format!("{at2}0.1 0.2 0.3\n"), "見出しではデータ 4 個"),
        ("a.at2", "PEER\n".to_owned(), "ファイルが途切れている"),
        ("a.xyz", "no record\n".to_owned(), "読める形式の記録を与える"),
    ] {
        let wrong = format::read(text.as_bytes(), Path::new(name), &Supplement::default()).expect_err("no record");
        assert!(wrong.to_string().starts_with("line ") && has_english(&wrong.to_string()), "English: {wrong}");
        let said = Language::Japanese.within(|| wrong.to_string());
        assert!(said.contains(japanese) && !has_english(&said), "{name}: {said}");
    }
}
