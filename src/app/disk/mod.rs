//! Files: session files, autosave, recent files, records, exports, films, and the system's file dialogs.

pub(in crate::app) mod autosave;
pub(in crate::app) mod dialogs;
pub(in crate::app) mod exit_hook;
pub(in crate::app) mod export;
pub(in crate::app) mod film;
pub(in crate::app) mod film_dialog;
pub(in crate::app) mod path_dialog;
pub(in crate::app) mod path_field;
pub(in crate::app) mod recent;
pub(in crate::app) mod record;
pub(in crate::app) mod scene_files;
pub(in crate::app) mod session_files;
mod show_folder;
pub(in crate::app) mod tasks;
