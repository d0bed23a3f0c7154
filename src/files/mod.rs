//! Opening and saving: the one room besides the window and the command line's own arguments that touches the disk.
//!
//! Reading a scene gathers everything it depends on (its text, overrides, the record it names) so that the rooms behind
//! see plain data and never a path. Writing is atomic: a reader sees the old file or the new one, never half of one.

mod load;
mod save;

pub use load::{ReadError, load_scene, read};
pub use save::{FileSet, WriteError, check_folder, save_scene, write_atomic, write_set};
