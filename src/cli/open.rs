//! The workbench, or, where there is no display, the main job without it.

use std::path::PathBuf;

use super::args::Changes;
use super::console::Console;
use super::failure::Failure;
use super::headless;
use crate::files;
use crate::language::Language;
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
    /// The language of the window, en or ja; the one chosen in it last, else the system's, unless given
    #[arg(long, value_name = "LANG")]
    lang: Option<Language>,
}

impl OpenArgs {
    /// The scene that the workbench opens on when none is named.
    pub(super) fn opening(out: PathBuf, lang: Option<Language>) -> Self {
        Self { scene: presets::OPENING.into(), changes: Changes::default(), out, lang }
    }
}

/// Does it.
///
/// # Errors
/// Bad input; a window that could not go on; without a window, what [`headless::run`] says.
pub(super) fn run(args: &OpenArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.changes.load(&args.scene)?;
    if let Some(why) = window(&scene, args)? {
        files::check_folder(&args.out)?;
        console.note(&format!("{why}: writing pictures and tables to {} instead", args.out.display()));
        headless::run(&scene, &args.out, console)?;
    }
    Ok(())
}

/// Runs the workbench until it is closed; else says why there is none.
///
/// # Errors
/// When it was open and had to end.
#[cfg(feature = "gui")]
fn window(scene: &Scene, args: &OpenArgs) -> Result<Option<String>, Failure> {
    use crate::app::AppError;
    match crate::app::run(scene.clone(), files::SceneSource::of(&args.scene), args.lang) {
        Ok(()) => Ok(None),
        Err(ended @ AppError::Ended { .. }) => Err(Failure::NoPicture(ended.to_string())),
        // A display that nothing can draw on is as good as none.
        Err(none) => Ok(Some(none.to_string())),
    }
}

/// Runs the workbench until it is closed; else says why there is none.
#[cfg(not(feature = "gui"))]
#[expect(clippy::unnecessary_wraps, reason = "as with a window")]
fn window(_: &Scene, _: &OpenArgs) -> Result<Option<String>, Failure> {
    Ok(Some("this build has no window (feature gui)".to_owned()))
}
