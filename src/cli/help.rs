//! Help on commands and flags in the language in use: the English one from the definitions, another by its keys in
//! `assets/texts/*.help.ftl`.
//!
//! A text that stands with several has one key, under the first of them: `help-open-sets`.

use std::collections::BTreeMap;

use clap::{Arg, ArgAction, Command};

use crate::language::{self, Language};

/// Texts that are not those of a command or a flag.
const USAGE: &str = "heading-usage";
const COMMANDS: &str = "heading-commands";
const ARGUMENTS: &str = "heading-arguments";
const OPTIONS: &str = "heading-options";
const HELP: &str = "help-of-help";
const VERSION: &str = "help-of-version";
const HELP_COMMAND: &str = "help-of-commands";
const DEFAULT: &str = "help-default";
const CHOICES: &str = "help-choices";

/// The command line with its help in the language in use.
pub(super) fn told(command: Command) -> Command {
    if Language::current() == Language::English {
        return command;
    }
    let keys = keys(&command);
    let version = own_flag("version", 'V', (VERSION, ArgAction::Version));
    let mut command = spelled(command.disable_version_flag(true).arg(version), &keys);
    // Only now the library adds its command `help`, there and below.
    command.build();
    with_help_command(command)
}

fn with_help_command(command: Command) -> Command {
    const NAME: &str = "help";
    if command.find_subcommand(NAME).is_none() {
        return command;
    }
    let command = command.mut_subcommands(with_help_command);
    command.mut_subcommand(NAME, |help| help.about(language::own(HELP_COMMAND).unwrap_or_default()))
}

/// A flag that the library would add with English words.
fn own_flag(name: &'static str, letter: char, (key, action): (&str, ArgAction)) -> Arg {
    Arg::new(name).short(letter).long(name).action(action).help(language::own(key).unwrap_or_default())
}

fn spelled(mut command: Command, keys: &BTreeMap<String, String>) -> Command {
    let find = |text: Option<String>| language::own(keys.get(&text?)?);
    if let Some(about) = find(command.get_about().map(ToString::to_string)) {
        command = command.about(about);
    }
    if let Some(about) = find(command.get_long_about().map(ToString::to_string)) {
        command = command.long_about(about);
    }
    if let Some(heading) = language::own(COMMANDS) {
        command = command.subcommand_help_heading(heading);
    }
    let usage = language::own(USAGE).unwrap_or("{usage-heading}");
    command
        .help_template(format!("{{about-with-newline}}\n{usage} {{usage}}\n\n{{all-args}}{{after-help}}"))
        .disable_help_flag(true)
        .arg(own_flag("help", 'h', (HELP, ArgAction::Help)))
        .mut_args(|mut arg| {
            let heading = if arg.is_positional() { ARGUMENTS } else { OPTIONS };
            if let (None, Some(heading)) = (arg.get_help_heading(), language::own(heading)) {
                arg = arg.help_heading(heading);
            }
            let values = values(&arg);
            if let Some(long) = find(arg.get_long_help().map(ToString::to_string)) {
                arg = arg.long_help(format!("{long}{values}"));
            }
            if let Some(help) = find(arg.get_help().map(ToString::to_string)) {
                arg = arg.help(format!("{help}{values}"));
            }
            let takes = arg.get_action().takes_values();
            arg.hide_default_value(takes).hide_possible_values(takes)
        })
        .mut_subcommands(|below| spelled(below, keys))
}

/// Values of a flag and its default.
fn values(arg: &Arg) -> String {
    let choices: Vec<String> = arg.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
    let defaults: Vec<_> = arg.get_default_values().iter().map(|value| value.to_string_lossy()).collect();
    let told = |key, values: String| match language::own(key) {
        Some(words) if !values.is_empty() => format!(" [{words}{values}]"),
        _ => String::new(),
    };
    let wanted = !arg.is_hide_possible_values_set() && arg.get_action().takes_values();
    let choices = if wanted { choices.join(", ") } else { String::new() };
    let defaults = if arg.is_hide_default_value_set() { String::new() } else { defaults.join(" ") };
    told(CHOICES, choices) + &told(DEFAULT, defaults)
}

/// Every text of a command and those below it, with the key that another language has it under.
fn keys(command: &Command) -> BTreeMap<String, String> {
    let mut keys = BTreeMap::new();
    note(command, "help", &mut keys);
    keys
}

fn note(command: &Command, key: &str, keys: &mut BTreeMap<String, String>) {
    let mut add = |text: Option<String>, key: String| {
        if let Some(text) = text {
            keys.entry(text).or_insert(key);
        }
    };
    add(command.get_about().map(ToString::to_string), format!("{key}-about"));
    add(command.get_long_about().map(ToString::to_string), format!("{key}-long"));
    for arg in command.get_arguments().filter(|arg| !arg.is_hide_set()) {
        let key = format!("{key}-{}", arg.get_id());
        add(arg.get_help().map(ToString::to_string), key.clone());
        add(arg.get_long_help().map(ToString::to_string), format!("{key}-long"));
    }
    for below in command.get_subcommands() {
        note(below, &format!("{key}-{}", below.get_name()), keys);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use clap::CommandFactory as _;

    use super::*;
    use crate::cli::{Cli, mistakes, sweep};

    #[test]
    fn every_command_and_flag_is_told_in_every_language_and_nothing_else() {
        let headings = [USAGE, COMMANDS, ARGUMENTS, OPTIONS, HELP, VERSION, HELP_COMMAND, DEFAULT, CHOICES];
        let others = headings.into_iter().chain(mistakes::keys()).map(str::to_owned).chain(sweep::measure_keys());
        let wanted: BTreeSet<String> = keys(&Cli::command()).into_values().chain(others).collect();
        // Texts of commands that only a feature brings are there without it.
        let whole = cfg!(all(feature = "gui", feature = "study", feature = "parquet"));
        for language in Language::ALL.into_iter().filter(|language| *language != Language::English) {
            let there: BTreeSet<String> = language::keys_of(language, ".help").into_iter().collect();
            let missing: Vec<_> = wanted.difference(&there).collect();
            let more: Vec<_> = there.difference(&wanted).collect();
            let fits = missing.is_empty() && (more.is_empty() || !whole);
            assert!(fits, "{}: lacks {missing:?}, has {more:?}", language.code());
        }
    }

    #[test]
    fn the_help_is_in_the_language_in_use() {
        let help = |below: Option<&str>| {
            let mut command = told(Cli::command());
            let command = match below {
                Some(name) => command.find_subcommand_mut(name).expect("a command"),
                None => &mut command,
            };
            command.render_long_help().to_string()
        };
        assert!(help(None).contains("Usage: ") && help(None).contains("Commands:"), "{}", help(None));
        Language::Japanese.within(|| {
            assert!(help(None).contains("使い方：") && help(None).contains("コマンド:"), "{}", help(None));
            let run = help(Some("run"));
            assert!(run.contains("オプション:") && !run.contains("Options"), "{run}");
            told(Cli::command()).debug_assert();
        });
    }
}
