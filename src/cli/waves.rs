//! `girderbench waves`: a section force of a girder that bends over time and station.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::args::{SceneArgs, Threads, not_negative};
use super::compute::compute_as_asked;
use super::console::Console;
use super::digits::six;
use super::domain;
use super::failure::Failure;
use super::limits::after_end;
use super::output::write_files;
use super::plot_files::plot_files;
use crate::files::{as_file_name, check_folder};
use crate::language::{Text, said};
use crate::scene::Kind;
use crate::sim::{History, OfSection};
use crate::study::waves::{Wanted, Waves};
use crate::view;

/// Run a scene and draw a section force of a girder that bends over time and station: waves are seen to run and turn
#[derive(Clone, Debug, clap::Args)]
pub(super) struct WavesArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// The girder, by its name; the first that bends when left out
    #[arg(long, value_name = "NAME")]
    girder: Option<String>,
    /// What is drawn: axial (N), shear (Q), moment (M), stress of the extreme fibre; in space `shear_z`, `moment_y`, torque, too
    #[arg(long, value_name = "FORCE", value_parser = section_force(), default_value = "axial")]
    force: OfSection,
    /// When the picture begins [s]; shortly before the hardest hit when left out
    #[arg(long, value_name = "S", value_parser = not_negative, allow_negative_numbers = true)]
    from: Option<f64>,
    /// When it ends [s]; some passages of a wave after that hit when left out
    #[arg(long, value_name = "S", value_parser = not_negative, allow_negative_numbers = true)]
    to: Option<f64>,
    /// The folder of picture and table
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
    #[command(flatten)]
    threads: Threads,
}

/// A section force by its word.
pub(super) fn section_force() -> impl TypedValueParser<Value = OfSection> {
    let of =
        |word: String| OfSection::ALL.into_iter().find(|(name, _)| *name == word).map(|(_, what)| what).ok_or(word);
    PossibleValuesParser::new(OfSection::ALL.map(|(name, _)| name)).try_map(of)
}

/// Whether girders of a scene of this kind have a section force.
///
/// # Errors
///
/// The force and a remedy where they have not.
pub(super) fn known_in(force: OfSection, kind: Kind) -> Result<(), Failure> {
    let word = OfSection::ALL.iter().find(|(_, what)| *what == force).map_or("", |(word, _)| word);
    let known = OfSection::of(kind).any(|(_, what)| what == force);
    if known { Ok(()) } else { Err(Failure::Input(said!("wrong-force-in-space", "force" => word))) }
}

/// Does it.
///
/// # Errors
/// Bad input, no girder that bends, a time that the run does not reach, no place to write; a run that gave up, after its
/// picture has been written.
pub(super) fn run(args: &WavesArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    known_in(args.force, scene.kind)?;
    args.threads.start()?;
    check_folder(&args.out)?;
    domain::warn(&scene, console);
    let timed = args.scene.of_its_file(compute_as_asked(&scene))?;
    let history = &timed.history;
    let wanted = Wanted { girder: girder(history, args)?, what: args.force, span: span(history, args)? };
    let waves = Waves::of(history, &wanted).ok_or_else(rigid)?;
    let word = OfSection::ALL.iter().find(|(_, what)| *what == args.force).map_or("", |(word, _)| word);
    let name = format!("{}-{word}", as_file_name(&waves.girder));
    let mut files = vec![(format!("{name}.csv"), waves.csv().into_bytes())];
    files.extend(plot_files(&name, waves.picture().to_svg())?);
    let written = write_files(&args.out, &files)?;
    let (unit, size) = args.force.unit();
    let largest = format!("{:.6} {unit}", waves.field.largest() / size);
    let what = view::section_force(args.force);
    let [times, stations] = [waves.field.times.len(), waves.field.stations.len()];
    let found = said!("waves-largest", "what" => what, "largest" => largest, "times" => times, "stations" => stations);
    console.print(&format!("{found}\n{written}"));
    match history.stop() {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name, stop: stop.clone() }),
        None => Ok(()),
    }
}

/// Number of the girder that is asked for.
fn girder(history: &History, args: &WavesArgs) -> Result<usize, Failure> {
    let girders = &history.scene().girders;
    let bends = |&number: &usize| history.sections().flexible(number).is_some();
    let Some(name) = &args.girder else { return (0..girders.len()).find(bends).ok_or_else(rigid) };
    let of_name = (0..girders.len()).find(|&number| girders[number].name == *name);
    let number = of_name.ok_or_else(|| {
        let names: Vec<&str> = girders.iter().map(|girder| girder.name.as_str()).collect();
        Failure::Input(said!("wrong-girder-flag", "name" => name.as_str(), "names" => names.join(", ")))
    })?;
    Some(number).filter(bends).ok_or_else(rigid)
}

fn rigid() -> Failure {
    Failure::Input(Text::new("wrong-no-wave").into())
}

/// From when to when.
fn span(history: &History, args: &WavesArgs) -> Result<[Option<f64>; 2], Failure> {
    for (flag, t) in [("--from", args.from), ("--to", args.to)] {
        if let Some(t) = t.filter(|t| *t > history.end()) {
            return Err(after_end(flag, t, history));
        }
    }
    match (args.from, args.to) {
        (Some(from), Some(to)) if from >= to => {
            let [to, from] = [to, from].map(six);
            Err(Failure::Input(said!("wrong-picture-backwards", "to" => to, "from" => from)))
        }
        (None, Some(_)) => Err(Failure::Input(Text::new("wrong-no-from").into())),
        span => Ok(span.into()),
    }
}
