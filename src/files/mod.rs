//! Scenes, records, tables, settings and unsaved work on the disk. `app` and `cli` also list folders and read their own results
//! (`MAY_OPEN_FILES` in `tests/architecture.rs`).
//!
//! Reading a scene gathers everything it depends on (its text, overrides, the record it names) so that the rooms behind
//! see plain data and never a path. Writing is atomic: a reader sees the old file or the new one, never half of one.

mod earlier;
mod journal;
mod load;
#[cfg(target_arch = "wasm32")]
mod page;
mod read;
mod recent;
mod recovery;
mod save;
mod scene_source;
mod settings;
mod staging;
mod stamp;
mod write_error;

pub use crate::motion::format::{FORMATS as RECORD_FORMATS, Record, Supplement, formats_in_words, is_record};
pub use earlier::{earlier_files, remove_files};
pub use journal::Journal;
pub use load::{Records, load_scene, load_unsaved, read_record, read_scene};
#[cfg(target_arch = "wasm32")]
pub use page::take_in;
pub use read::{ReadError, read_input, read_table};
pub use recent::Recent;
pub use recovery::{Found, SideFile, find_beside, find_in};
pub use save::{Draft, FileSet, as_file_name, check_folder, save_scene, scene_text, write_atomic};
pub use scene_source::SceneSource;
pub use settings::{Chosen, FoldedPanels, Settings};
pub use stamp::Stamp;
pub use write_error::WriteError;
