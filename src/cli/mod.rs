//! The command line: one file per subcommand, one place that prints, one that turns failures into exit statuses.

mod args;
mod check;
mod columns;
mod compare;
mod compute;
mod console;
mod digits;
mod domain;
mod failure;
mod flexible;
mod headless;
mod help;
mod identify;
mod interrupt;
mod limits;
#[cfg(feature = "render")]
mod measure;
mod mistakes;
mod motion;
mod motion_processing;
mod moved;
mod open;
mod output;
mod plot;
mod plot_files;
mod presets;
mod progress;
#[cfg(feature = "render")]
mod render;
mod report;
mod run;
mod seats;
mod study;
mod summary;
mod sweep;
mod waves;

use console::Console;
use failure::Failure;

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::parser::ValueSource;
use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};

use crate::language::{Language, Text, said};

/// Bridge girders that pound, stick, slip and turn.
///
/// Without a command it opens the workbench; where there is no display it writes the opening scene's pictures and
/// tables instead.
#[derive(Debug, Parser)]
#[command(version, about, long_about, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    /// Where the pictures and tables go when there is no display
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
    /// The language of what is said, en or ja; the system's unless given, in the window the one chosen there last
    #[arg(long, value_name = "LANG", global = true)]
    lang: Option<Language>,
}

#[derive(Debug, Subcommand)]
enum Command {
    Open(open::OpenArgs),
    Run(run::RunArgs),
    Report(report::ReportArgs),
    Check(check::CheckArgs),
    Compare(compare::CompareArgs),
    Motion(motion::MotionArgs),
    Plot(plot::PlotArgs),
    Identify(identify::IdentifyArgs),
    #[cfg(feature = "render")]
    Measure(measure::MeasureArgs),
    /// Find the motion of bodies in pictures of marks (this build reads no pictures: build it with `--features render`)
    #[cfg(not(feature = "render"))]
    Measure {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
        rest: Vec<String>,
    },
    Study(study::StudyArgs),
    Sweep(sweep::SweepArgs),
    Waves(waves::WavesArgs),
    /// List the scenes that come with the program
    Presets,
    #[cfg(feature = "render")]
    Render(render::RenderArgs),
    /// Draw pictures of a scene (this build has no pictures: build it with `--features render`)
    #[cfg(not(feature = "render"))]
    Render {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
        rest: Vec<String>,
    },
}

/// Runs the program on the process's arguments.
pub fn main() -> ExitCode {
    let mut console = Console::standard();
    // Before the arguments are read: what is wrong with them is said in it too.
    asked(std::env::args_os()).unwrap_or_else(Language::of_system).speak();
    let mut command = help::told(Cli::command());
    let read = command.try_get_matches_from_mut(arguments(std::env::args_os().collect())).and_then(|found| {
        // A flag of the opening alone, unlike the language.
        let misplaced = found.subcommand().is_some() && found.value_source("out") == Some(ValueSource::CommandLine);
        let cli = Cli::from_arg_matches(&found).map_err(|mistake| mistake.format(&mut command))?;
        Ok((cli, misplaced))
    });
    let done = match read {
        Ok((_, true)) => Err(Failure::Input(Text::new("wrong-out-before").into())),
        Ok((cli, false)) => dispatch(cli, &mut console),
        Err(help_or_mistake) => return say(&help_or_mistake, &mut console),
    };
    let mut code = ExitCode::SUCCESS;
    // Of two failures the command's own decides.
    for failure in [console.finish().err(), done.err()].into_iter().flatten() {
        code = fail(&failure, &mut console);
    }
    interrupt::end_if_raised();
    code
}

/// Arguments as the library takes them: its command `help` takes names of commands alone, and the language has been read by then.
fn arguments(mut args: Vec<OsString>) -> Vec<OsString> {
    if args.get(1).is_some_and(|command| command == "help") {
        let is_flag = |arg: &OsString| arg.to_str().is_some_and(|arg| arg == "--lang" || arg.starts_with("--lang="));
        while let Some(at) = args.iter().position(is_flag) {
            let with_value = args[at] == "--lang" && at + 1 < args.len();
            args.drain(at..=at + usize::from(with_value));
        }
    }
    args
}

/// The language that arguments ask for, wherever it stands among them.
fn asked(mut args: impl Iterator<Item = OsString>) -> Option<Language> {
    let mut found = None;
    while let Some(arg) = args.next() {
        let code = match arg.to_str() {
            Some("--") => break,
            Some("--lang") => args.next()?,
            Some(arg) => arg.strip_prefix("--lang=").unwrap_or_default().into(),
            None => continue,
        };
        found = code.to_str().and_then(Language::of_locale).or(found);
    }
    found
}

/// Says what went wrong.
fn fail(failure: &Failure, console: &mut Console) -> ExitCode {
    console.note(&said!("failed", "failure" => failure.to_string()));
    failure.exit_code()
}

/// Prints the help that was asked for, or what is wrong with the arguments.
fn say(help_or_mistake: &clap::Error, console: &mut Console) -> ExitCode {
    if let Some(words) = mistakes::told(help_or_mistake) {
        return fail(&Failure::Input(words), console);
    }
    if help_or_mistake.use_stderr() {
        // There is nowhere left to say that it cannot be said.
        let _ = help_or_mistake.print();
    } else {
        console.write(|_| help_or_mistake.print());
    }
    let code = u8::try_from(help_or_mistake.exit_code()).unwrap_or(2);
    console.finish().err().map_or(ExitCode::from(code), |failure| fail(&failure, console))
}

fn dispatch(cli: Cli, console: &mut Console) -> Result<(), Failure> {
    match cli.command {
        None => open::run(&open::OpenArgs::opening(cli.out), cli.lang, console),
        Some(Command::Open(args)) => open::run(&args, cli.lang, console),
        Some(Command::Run(args)) => run::run(&args, console),
        Some(Command::Report(args)) => report::run(&args, console),
        Some(Command::Check(args)) => check::run(&args, console),
        Some(Command::Compare(args)) => compare::run(&args, console),
        Some(Command::Motion(args)) => motion::run(&args, console),
        Some(Command::Plot(args)) => plot::run(&args, console),
        Some(Command::Identify(args)) => identify::run(&args, console),
        Some(Command::Study(args)) => study::run(&args, console),
        Some(Command::Sweep(args)) => sweep::run(&args, console),
        Some(Command::Waves(args)) => waves::run(&args, console),
        Some(Command::Presets) => {
            presets::run(console);
            Ok(())
        }
        #[cfg(feature = "render")]
        Some(Command::Render(args)) => render::run(&args, console),
        #[cfg(feature = "render")]
        Some(Command::Measure(args)) => measure::run(&args, console),
        #[cfg(not(feature = "render"))]
        Some(Command::Render { .. } | Command::Measure { .. }) => {
            Err(Failure::NoPicture(Text::new("failed-no-pictures").into()))
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    /// Names of values that are numbers.
    const NUMBERS: [&str; 12] = ["S", "N", "HZ", "X", "MM", "G", "T", "SEED", "R", "N_PER_M", "MS", "DEG"];

    /// A number below the range of an option gives that range, and is not taken for another option.
    #[test]
    fn every_option_that_is_a_number_takes_a_negative_one() {
        fn look(command: &clap::Command, found: &mut usize) {
            for arg in command.get_arguments() {
                let is_number = |name: &clap::builder::Str| NUMBERS.contains(&name.as_str());
                if arg.get_long().is_some() && arg.get_value_names().is_some_and(|names| names.iter().all(is_number)) {
                    *found += 1;
                    let name = arg.get_id();
                    assert!(arg.is_allow_negative_numbers_set(), "--{name} of {}", command.get_name());
                }
            }
            command.get_subcommands().for_each(|command| look(command, found));
        }
        let mut found = 0;
        look(&Cli::command(), &mut found);
        assert!(found > 40, "{found} options");
    }
}
