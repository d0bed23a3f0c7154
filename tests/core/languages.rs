//! Tables of texts: every language has the same keys, the code uses each, and a text takes no value that English lacks.
//!
//! What keys of the scene file mean (`*.keys.ftl`) and flags of the command line do (`*.help.ftl`) stands in English with them:
//! `scene::keys` and `cli::help` have the tests of that.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use girderbench::language::{Language, Text};

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
