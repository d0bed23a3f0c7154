//! The tables of a language, read once.

use std::collections::HashMap;
use std::sync::LazyLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource};
use unic_langid::LanguageIdentifier;

use super::Language;

/// The texts of a language.
pub(super) struct Catalog {
    bundle: FluentBundle<FluentResource>,
    /// Texts without values, by their keys: what most of every frame is made of.
    words: HashMap<String, String>,
}

/// Tables by their files.
macro_rules! files {
    ($($name:literal),+) => {
        &[$(($name, include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/texts/", $name)))),+]
    };
}

/// A page in a browser has no command line.
const PAGE: bool = cfg!(target_arch = "wasm32");

/// The tables of a language, each with the name of its file.
pub(super) const fn tables(language: Language) -> &'static [(&'static str, &'static str)] {
    match language {
        Language::English if PAGE => files!["en.ftl", "en.complaints.ftl"],
        Language::English => files!["en.ftl", "en.complaints.ftl", "en.command.ftl"],
        Language::Japanese if PAGE => files!["ja.ftl", "ja.keys.ftl", "ja.complaints.ftl"],
        Language::Japanese => files!["ja.ftl", "ja.keys.ftl", "ja.complaints.ftl", "ja.command.ftl", "ja.help.ftl"],
    }
}

static ENGLISH: LazyLock<Catalog> = LazyLock::new(|| Catalog::read(Language::English));
static JAPANESE: LazyLock<Catalog> = LazyLock::new(|| Catalog::read(Language::Japanese));

impl Catalog {
    /// The texts of a language.
    pub(super) fn of(language: Language) -> &'static Self {
        match language {
            Language::English => &ENGLISH,
            Language::Japanese => &JAPANESE,
        }
    }

    /// Reads the tables; what of them is no message is left out, which a test forbids.
    fn read(language: Language) -> Self {
        let all = tables(language).iter().map(|(_, table)| *table);
        let keys: Vec<String> = all.clone().flat_map(keys).map(str::to_owned).collect();
        let id: LanguageIdentifier = language.code().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![id]);
        // The marks that Fluent would put around values are no glyphs of our fonts, and both languages run one way.
        bundle.set_use_isolating(false);
        for table in all {
            let read = FluentResource::try_new(table.to_owned());
            bundle.add_resource_overriding(read.unwrap_or_else(|(readable, _mistakes)| readable));
        }
        let plain = |key: &String| {
            let mut errors = Vec::new();
            let text = bundle.format_pattern(bundle.get_message(key)?.value()?, None, &mut errors).into_owned();
            errors.is_empty().then(|| (key.clone(), text))
        };
        let words = keys.iter().filter_map(plain).collect();
        Self { bundle, words }
    }

    /// A text without values.
    pub(super) fn words(&self, key: &str) -> Option<&str> {
        self.words.get(key).map(String::as_str)
    }

    /// A text with values in their places.
    pub(super) fn format(&self, key: &str, values: &FluentArgs<'_>) -> Option<String> {
        let pattern = self.bundle.get_message(key)?.value()?;
        Some(self.bundle.format_pattern(pattern, Some(values), &mut Vec::new()).into_owned())
    }
}

/// Keys of a table, in order.
pub(super) fn keys(table: &str) -> impl Iterator<Item = &str> {
    let begins = |line: &&str| line.starts_with(|c: char| c.is_ascii_alphabetic());
    table.lines().filter(begins).filter_map(|line| Some(line.split_once('=')?.0.trim()))
}
