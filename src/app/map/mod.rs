//! A number of the run over two keys of the scene, as a map: what is offered, its runs on threads, the picture.

mod field;
mod maps;
mod offer;
mod show;
mod work;

pub use maps::Maps;
pub(in crate::app) use show::show;
