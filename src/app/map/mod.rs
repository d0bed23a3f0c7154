//! A number of the run over keys of the scene, filled in the background: as a map over two keys, and over the angle of the
//! shaking as polar plots; the runs on threads, the pictures.

mod angles;
mod angles_show;
mod background;
mod field;
mod maps;
mod offer;
mod polar;
mod progress;
mod show;
mod work;

pub use angles::Angles;
pub(in crate::app) use angles_show::show as show_angles;
pub use maps::Maps;
pub(in crate::app) use show::show;
