//! Files of a page in a browser: those that the user has chosen are kept by their names while the page is open, and what is
//! written goes to the browser's downloads.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::io::Write;
use std::path::{Path, PathBuf};

use js_sys::{Array, Uint8Array};
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Blob, HtmlAnchorElement, Url};

use super::write_error::WriteError;

thread_local! {
    static KEPT: RefCell<BTreeMap<PathBuf, Vec<u8>>> = const { RefCell::new(BTreeMap::new()) };
}

/// Keeps a file that the user has chosen: from now on it can be read.
pub fn take_in(path: &Path, bytes: Vec<u8>) {
    KEPT.with_borrow_mut(|kept| kept.insert(path.to_owned(), bytes));
}

/// A file that is kept.
pub(super) fn read(path: &Path) -> Option<Vec<u8>> {
    KEPT.with_borrow(|kept| kept.get(path).cloned())
}

/// Has the browser save a file under the last part of its path, and keeps it.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    download(path, bytes).map_err(|why| WriteError::new(path, std::io::Error::other(format!("{why:?}"))))?;
    take_in(path, bytes.to_owned());
    Ok(())
}

fn download(path: &Path, bytes: &[u8]) -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or("no document")?;
    let blob = Blob::new_with_u8_array_sequence(&Array::of1(&Uint8Array::from(bytes)))?;
    let address = Url::create_object_url_with_blob(&blob)?;
    let link: HtmlAnchorElement = document.create_element("a")?.unchecked_into();
    link.set_href(&address);
    link.set_download(&path.file_name().unwrap_or_default().to_string_lossy());
    link.click();
    Url::revoke_object_url(&address)
}

/// Files that are written together.
#[derive(Debug)]
pub(super) struct Stage {
    /// Where they go.
    pub(super) folder: PathBuf,
    files: Vec<(OsString, Vec<u8>)>,
}

impl Stage {
    #[expect(clippy::unnecessary_wraps, reason = "a folder may refuse")]
    pub(super) fn in_folder(folder: &Path) -> std::io::Result<Self> {
        Ok(Self { folder: folder.to_owned(), files: Vec::new() })
    }

    /// Takes a file.
    pub(super) fn write(
        &mut self,
        name: &OsStr,
        write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
    ) -> std::io::Result<()> {
        let mut bytes = Vec::new();
        write(&mut bytes)?;
        self.files.push((name.to_owned(), bytes));
        Ok(())
    }

    /// Has the browser save them.
    pub(super) fn finish(self) -> Result<(), WriteError> {
        self.files.iter().try_for_each(|(name, bytes)| write(&self.folder.join(name), bytes))
    }

    /// Files so far.
    pub(super) fn count(&self) -> usize {
        self.files.len()
    }
}
