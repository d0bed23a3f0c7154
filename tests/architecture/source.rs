//! Source files as the rules read them: comments and string contents blanked out.

use std::fs;
use std::path::{Path, PathBuf};

/// A source file: its path from the package's root, and its code with comments and string contents blanked out.
pub(crate) struct Source {
    pub(crate) path: String,
    pub(crate) text: String,
    pub(crate) code: String,
}

impl Source {
    /// The room that a file of `src/` belongs to; none for `lib.rs` and `main.rs`.
    pub(crate) fn room(&self) -> Option<&str> {
        let inside = self.path.strip_prefix("src/")?;
        let name = inside.split('/').next()?.trim_end_matches(".rs");
        (!["lib", "main"].contains(&name)).then_some(name)
    }

    /// Code outside of a test module at the end of the file.
    pub(crate) fn production(&self) -> &str {
        self.code.split("#[cfg(test)]\nmod ").next().unwrap_or(&self.code)
    }
}

pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

pub(crate) fn files_under(folder: &str, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|have| have == extension) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

pub(crate) fn sources(folder: &str, extension: &str) -> Vec<Source> {
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("a source file is text");
        let path = path.strip_prefix(root()).expect("inside the package").to_string_lossy().replace('\\', "/");
        Source { path, code: blank_comments_and_strings(&text), text }
    };
    files_under(folder, extension).into_iter().map(read).collect()
}

/// Keeps the line structure; good enough for this package's own style (no block comments, no raw strings with quotes).
pub(crate) fn blank_comments_and_strings(text: &str) -> String {
    text.lines().map(blank_line).collect::<Vec<_>>().join("\n")
}

fn blank_line(line: &str) -> String {
    let (mut out, mut in_string, mut escaped) = (String::new(), false, false);
    let mut characters = line.chars().peekable();
    while let Some(c) = characters.next() {
        if in_string {
            in_string = escaped || c != '"';
            escaped = !escaped && c == '\\';
            out.push(if in_string { ' ' } else { c });
        } else if c == '/' && characters.peek() == Some(&'/') {
            break;
        } else {
            in_string = c == '"' && !out.ends_with('\'');
            out.push(c);
        }
    }
    out
}

pub(crate) fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether `word` stands in `code` by itself, not as a part of a longer one.
pub(crate) fn has_word(code: &str, word: &str) -> bool {
    code.match_indices(word).any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let after = code[at + word.len()..].chars().next();
        !before.is_some_and(is_word) && !after.is_some_and(is_word)
    })
}
