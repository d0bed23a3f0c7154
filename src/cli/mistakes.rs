//! Mistakes in the arguments, in the language in use: English in the library's words, another by its keys in `assets/texts/*.help.ftl`.

use std::error::Error as _;

use clap::Error;
use clap::error::{ContextKind, ErrorKind};

use crate::language::{self, said};

/// Kinds of mistakes found by the library, with the keys of their texts.
const KINDS: [(ErrorKind, &str); 10] = [
    (ErrorKind::InvalidSubcommand, "mistake-command"),
    (ErrorKind::UnknownArgument, "mistake-argument"),
    (ErrorKind::MissingRequiredArgument, "mistake-missing"),
    (ErrorKind::InvalidValue, "mistake-value"),
    (ErrorKind::ValueValidation, "mistake-value"),
    (ErrorKind::ArgumentConflict, "mistake-conflict"),
    (ErrorKind::TooManyValues, "mistake-count"),
    (ErrorKind::TooFewValues, "mistake-count"),
    (ErrorKind::WrongNumberOfValues, "mistake-count"),
    (ErrorKind::InvalidUtf8, "mistake-letters"),
];
/// Of a flag at the end, where a value is wanted.
const NO_VALUE: &str = "mistake-no-value";
/// Before the values that a flag takes.
const CHOICES: &str = "mistake-choices";
/// Where to read more.
const MORE: &str = "mistake-more";

/// It in words of the language in use; nothing where the library's own are to be taken.
pub(super) fn told(mistake: &Error) -> Option<String> {
    let shown = |kind| mistake.get(kind).map(ToString::to_string).filter(|words| !words.is_empty());
    let (_, key) = KINDS.iter().find(|(kind, _)| *kind == mistake.kind())?;
    let value = shown(ContextKind::InvalidValue);
    let wanted = mistake.kind() == ErrorKind::InvalidValue && value.is_none();
    let mut said = language::own(if wanted { NO_VALUE } else { key })?.to_owned();
    let subjects = [ContextKind::InvalidSubcommand, ContextKind::InvalidArg, ContextKind::PriorArg];
    let subjects: Vec<String> = subjects.into_iter().filter_map(shown).chain(value).collect();
    if !subjects.is_empty() {
        said = said!("mistake-of", "what" => said, "subject" => subjects.join(" "));
    }
    if let Some(reason) = mistake.source() {
        said = said!("mistake-of", "what" => said, "subject" => reason.to_string());
    }
    let near = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    if let Some(known) = near.into_iter().find_map(shown) {
        said += &said!("wrong-did-you-mean", "known" => known);
    }
    if let Some(choices) = shown(ContextKind::ValidValue) {
        said += "\n  ";
        said += language::own(CHOICES)?;
        said += &choices;
    }
    Some(format!("{said}\n  {}", language::own(MORE)?))
}

/// The keys of these words.
#[cfg(test)]
pub(super) fn keys() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|(_, key)| *key).chain([NO_VALUE, CHOICES, MORE])
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    use super::*;
    use crate::cli::{Cli, help};
    use crate::language::Language;

    #[test]
    fn a_mistake_is_told_with_what_it_is_about() {
        let said = |args: &[&str]| {
            let mistake = help::told(Cli::command()).try_get_matches_from(args).expect_err("a mistake");
            told(&mistake)
        };
        assert_eq!(said(&["girderbench", "ruin"]), None, "English is the library's own");
        Language::Japanese.within(|| {
            for (args, words) in [
                (["girderbench", "ruin", "x"], ["そのコマンドはない：ruin", "`run`"]),
                (["girderbench", "run", "--untill"], ["その引数はない：--untill", "`--until`"]),
                (["girderbench", "compare", "x"], ["必須の引数がない：<B>", "--help"]),
                (["girderbench", "run", "--until"], ["値がない：--until <S>", "--help"]),
                (["girderbench", "run", "--until=x"], ["使えない値：--until <S> x：0 より大きい数", "--help"]),
                (["girderbench", "open", "--until=-1"], ["使えない値：--until <S> -1：0 より大きい数", "--help"]),
            ] {
                let said = said(&args).unwrap_or_default();
                assert!(words.iter().all(|words| said.contains(words)), "{args:?}: {said}");
            }
        });
    }
}
