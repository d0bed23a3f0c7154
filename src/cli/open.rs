//! The workbench, or, where there is no display, the main job without it.

use std::path::PathBuf;

use super::args::Changes;
use super::console::Console;
use super::failure::Failure;
use super::headless;
use crate::files;
use crate::language::{Language, said};
use crate::scene::{Scene, presets};

/// Open the workbench on a scene
#[derive(Clone, Debug, clap::Args)]
pub(super) struct OpenArgs {
    /// A scene file, or the name of a preset
    #[arg(value_name = "SCENE|PRESET", default_value = presets::OPENING)]
    scene: PathBuf,
    /// What to change in it.
    #[command(flatten)]
    changes: Changes,
    /// Where the pictures and tables go when there is no display
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
}

impl OpenArgs {
    /// The scene that the workbench opens on when none is named.
    pub(super) fn opening(out: PathBuf) -> Self {
        Self { scene: presets::OPENING.into(), changes: Changes::default(), out }
    }
}

/// Does it; the window is in this language, where one is given.
///
/// # Errors
/// Bad input; a window that could not go on; without a window, what [`headless::run`] says.
pub(super) fn run(args: &OpenArgs, lang: Option<Language>, console: &mut Console) -> Result<(), Failure> {
    let scene = args.changes.load(&args.scene)?;
    if let Some(why) = window(&scene, args, lang)? {
        files::check_folder(&args.out)?;
        console.note(&said!("open-headless", "why" => why, "folder" => args.out.display().to_string()));
        headless::run(&scene, &args.out, console)?;
    }
    Ok(())
}

/// Runs the workbench until it is closed; else says why there is none.
///
/// # Errors
/// When it was open and had to end.
#[cfg(feature = "gui")]
fn window(scene: &Scene, args: &OpenArgs, lang: Option<Language>) -> Result<Option<String>, Failure> {
    use crate::app::AppError;
    match crate::app::run(scene.clone(), files::SceneSource::of(&args.scene), lang) {
        Ok(()) => Ok(None),
        Err(ended @ AppError::Ended { .. }) => Err(Failure::NoPicture(ended.to_string())),
        // A display that nothing can draw on is as good as none.
        Err(none) => Ok(Some(none.to_string())),
    }
}

/// Runs the workbench until it is closed; else says why there is none.
#[cfg(not(feature = "gui"))]
#[expect(clippy::unnecessary_wraps, reason = "as with a window")]
fn window(_: &Scene, _: &OpenArgs, _: Option<Language>) -> Result<Option<String>, Failure> {
    Ok(Some(crate::language::Text::new("open-no-window").into()))
}
