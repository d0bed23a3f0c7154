//! The table of a language, read once.

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

/// The table of a language.
pub(super) const fn table(language: Language) -> &'static str {
    match language {
        Language::English => include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/texts/en.ftl")),
        Language::Japanese => include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/texts/ja.ftl")),
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

    /// Reads a table; what of it is no message is left out, which a test forbids.
    fn read(language: Language) -> Self {
        let resource =
            FluentResource::try_new(table(language).to_owned()).unwrap_or_else(|(readable, _mistakes)| readable);
        let keys: Vec<String> = keys(table(language)).map(str::to_owned).collect();
        let id: LanguageIdentifier = language.code().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![id]);
        // The marks that Fluent would put around values are no glyphs of our fonts, and both languages run one way.
        bundle.set_use_isolating(false);
        bundle.add_resource_overriding(resource);
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
