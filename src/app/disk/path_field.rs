//! A path that is asked for in the window itself: what is typed, how it could go on, and what would be replaced.

use std::path::{MAIN_SEPARATOR, Path, PathBuf};

use crate::app::command::{Command, PathCommand, Wish};
use crate::app::disk::dialogs::{extensions, then};
use crate::app::host::home_folder;
use crate::app::text;
use crate::files::as_file_name;

/// Most ways to go on that are listed.
const MOST_OFFERS: usize = 200;

/// The path that is asked for, and where it begins.
#[derive(Default)]
pub struct PathField {
    asked: Option<Asked>,
    here: bool,
    /// Where the next path begins, and what a new file is called.
    begin: (PathBuf, String),
    /// Folder of the path that was taken last.
    last: Option<PathBuf>,
}

/// A path that is being typed.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Asked {
    pub(in crate::app) wish: Wish,
    /// Typed text.
    pub(in crate::app) text: String,
    /// How it could go on.
    pub(in crate::app) offers: Vec<Offer>,
    /// Question before the path is taken.
    pub(in crate::app) question: Option<Question>,
    /// Why it cannot be taken.
    pub(in crate::app) problem: Option<String>,
}

/// A way in which what is typed could go on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::app) struct Offer {
    /// A file comes after the folders.
    pub(in crate::app) is_file: bool,
    /// Its name in its folder; a folder's ends as one.
    pub(in crate::app) name: String,
    /// The whole text with it.
    pub(in crate::app) text: String,
}

/// Question before a path is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) enum Question {
    /// A file is there.
    Replace,
    /// The folder has something in it.
    Among,
    /// There is no such folder yet.
    Make,
}

impl PathField {
    /// Open question.
    pub(in crate::app) fn asked(&self) -> Option<&Asked> {
        self.asked.as_ref()
    }

    /// Whether paths are asked for here rather than by the system.
    pub(in crate::app) fn is_here(&self) -> bool {
        self.here
    }

    /// Everything of it that a frame shows.
    pub(in crate::app) fn seen(&self) -> (Option<Asked>, bool) {
        (self.asked.clone(), self.here)
    }

    /// Where the next path begins, and what a new file is called.
    pub(super) fn begin_in(&mut self, folder: &Path, name: &str) {
        self.begin = (folder.to_owned(), as_file_name(name));
    }

    /// The folder that paths begin in.
    pub(in crate::app) fn folder(&self) -> &Path {
        self.last.as_deref().unwrap_or(&self.begin.0)
    }

    /// Asks for a path.
    pub(super) fn ask(&mut self, wish: Wish) {
        let folder = in_folder(self.folder());
        let name = self.name_of_new(wish);
        self.asked = Some(Asked { wish, text: String::new(), offers: Vec::new(), question: None, problem: None });
        self.type_text(folder + &name);
    }

    /// Suggested name of a new file; empty for existing files and for folders.
    pub(in crate::app) fn name_of_new(&self, wish: Wish) -> String {
        wish.file_name(&self.begin.1).unwrap_or_default()
    }

    fn type_text(&mut self, text: String) {
        let Some(asked) = &self.asked else { return };
        let wish = asked.wish;
        let offers = offers(&text, wish);
        self.asked = Some(Asked { wish, text, offers, question: None, problem: None });
    }

    /// Does a command; answers with what is to be done with the path.
    pub(in crate::app) fn apply(&mut self, command: PathCommand) -> Option<Command> {
        match command {
            PathCommand::Ask(wish) => {
                // There will be none the next time either.
                self.here = true;
                self.ask(wish);
            }
            PathCommand::Type(text) => self.type_text(text),
            PathCommand::Here(here) => self.here = here,
            PathCommand::Leave => self.asked = None,
            PathCommand::Take => return self.take(false),
            PathCommand::Confirm => return self.take(true),
        }
        None
    }

    fn take(&mut self, confirmed: bool) -> Option<Command> {
        let asked = self.asked.as_ref()?;
        let (wish, path) = (asked.wish, asked.wish.complete(resolved(&asked.text)));
        if asked.text.trim().is_empty() {
            return self.refuse(text::PATH_EMPTY.to_string());
        }
        let is_folder = path.is_dir();
        if is_folder && !wish.is_for_folder() {
            // Into it.
            self.type_text(in_folder(&path) + &self.name_of_new(wish));
            return None;
        }
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if wish.is_for_folder() && path.exists() && !is_folder {
            return self.refuse(text::PATH_NO_FOLDER.to_string());
        }
        if wish.is_for_reading() && !path.is_file() {
            return self.refuse(format!("{}: {}", text::PATH_NOTHING, path.display()));
        }
        let question = match wish {
            _ if wish.is_for_reading() => None,
            _ if is_folder => is_used(&path).then_some(Question::Among),
            _ if path.exists() => Some(Question::Replace),
            _ => (!folder.is_dir()).then_some(Question::Make),
        };
        if let (Some(question), false) = (question, confirmed) {
            self.asked = self.asked.take().map(|asked| Asked { question: Some(question), problem: None, ..asked });
            return None;
        }
        if question == Some(Question::Make)
            && let Err(error) = std::fs::create_dir_all(folder)
        {
            return self.refuse(format!("{}: {error}", folder.display()));
        }
        self.last = Some(if wish.is_for_folder() { path.clone() } else { folder.to_owned() });
        self.asked = None;
        Some(then(wish, path))
    }

    fn refuse(&mut self, why: String) -> Option<Command> {
        self.asked = self.asked.take().map(|asked| Asked { question: None, problem: Some(why), ..asked });
        None
    }
}

impl Asked {
    /// Typed text, with the letters that all completions have in common.
    pub(in crate::app) fn completed(&self) -> Option<String> {
        let mut texts = self.offers.iter().map(|offer| offer.text.as_str());
        let first = texts.next()?;
        let common = texts.fold(first, |common, text| {
            let letters = common.char_indices().zip(text.chars());
            let same = letters.take_while(|((_, a), b)| a == b).map(|((at, a), _)| at + a.len_utf8()).last();
            &common[..same.unwrap_or(0)]
        });
        (common.len() > self.text.len()).then(|| common.to_owned())
    }

    /// The whole path that is meant.
    pub(in crate::app) fn path(&self) -> PathBuf {
        self.wish.complete(resolved(&self.text))
    }
}

/// A folder as a text that goes on.
pub(in crate::app) fn in_folder(folder: &Path) -> String {
    let mut text = folder.display().to_string();
    if !text.is_empty() && !text.ends_with(std::path::is_separator) {
        text.push(MAIN_SEPARATOR);
    }
    text
}

/// The path that a text means: `~` is the user's own folder.
fn resolved(text: &str) -> PathBuf {
    let text = text.trim();
    match text.strip_prefix('~').filter(|rest| rest.is_empty() || rest.starts_with(std::path::is_separator)) {
        Some(rest) => home_folder().map(|home| home.join(rest.trim_start_matches(std::path::is_separator))),
        None => std::path::absolute(text).ok(),
    }
    .unwrap_or_else(|| PathBuf::from(text))
}

/// Whether a folder has anything in it.
fn is_used(folder: &Path) -> bool {
    std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some())
}

/// How a text could go on: folders, and files that can be chosen.
fn offers(text: &str, wish: Wish) -> Vec<Offer> {
    let cut = text.rfind(std::path::is_separator).map_or(0, |at| at + 1);
    let (before, begun) = text.split_at(cut);
    let folder = if before.is_empty() { PathBuf::from(".") } else { resolved(before) };
    let fits = |name: &str| name.starts_with(begun) && (begun.starts_with('.') || !name.starts_with('.'));
    let ends = extensions(wish);
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let offer = |entry: std::fs::DirEntry| {
        let (path, mut name) = (entry.path(), entry.file_name().into_string().ok()?);
        let is_file = !path.is_dir();
        let end = path.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
        let wanted = fits(&name) && (!is_file || ends.contains(&end.as_str()));
        if !is_file {
            name.push(MAIN_SEPARATOR);
        }
        wanted.then(|| Offer { is_file, text: format!("{before}{name}"), name })
    };
    let mut all: Vec<Offer> = entries.filter_map(offer).collect();
    all.sort();
    all.truncate(MOST_OFFERS);
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::command::{Export, FileCommand};

    fn asking(wish: Wish, folder: &Path) -> PathField {
        let mut field = PathField::default();
        field.begin_in(folder, "east bridge");
        field.ask(wish);
        field
    }

    fn typed(field: &mut PathField, text: &Path) -> Asked {
        assert!(field.apply(PathCommand::Type(text.display().to_string())).is_none(), "only typed");
        field.asked().expect("asked").clone()
    }

    #[test]
    fn a_text_goes_on_with_folders_and_files_that_can_be_chosen() {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["deck-1.toml", "deck-2.toml", "deck.csv", ".hidden.toml"] {
            std::fs::write(folder.path().join(name), "").expect("written");
        }
        std::fs::create_dir(folder.path().join("decks")).expect("made");
        let mut field = asking(Wish::Open, folder.path());
        let names = |asked: &Asked| asked.offers.iter().map(|offer| offer.name.clone()).collect::<Vec<_>>();
        let decks = format!("decks{MAIN_SEPARATOR}");
        assert_eq!(names(field.asked().expect("asked")), [&decks, "deck-1.toml", "deck-2.toml"], "folders first");
        let asked = typed(&mut field, &folder.path().join("d"));
        assert_eq!(asked.completed(), Some(folder.path().join("deck").display().to_string()), "what all have");
        let asked = typed(&mut field, &folder.path().join("deck-"));
        assert_eq!(names(&asked), ["deck-1.toml", "deck-2.toml"], "those that begin so");
        assert_eq!(asked.completed(), None, "here they part");
    }

    #[test]
    fn a_file_that_is_there_and_a_folder_that_is_not_are_asked_about() {
        let folder = tempfile::tempdir().expect("a folder");
        let there = folder.path().join("there.toml");
        std::fs::write(&there, "").expect("written");
        let mut field = asking(Wish::Save, folder.path());
        assert_eq!(field.asked().expect("asked").path(), folder.path().join("east_bridge.toml"), "called so at first");
        typed(&mut field, &folder.path().join("there"));
        assert!(field.apply(PathCommand::Take).is_none(), "asked first");
        assert_eq!(field.asked().expect("still").question, Some(Question::Replace), "what about");
        let Some(Command::File(then)) = field.apply(PathCommand::Confirm) else { panic!("taken") };
        assert_eq!(then, FileCommand::SaveTo(there), "with its extension");
        let mut field = asking(Wish::Save, folder.path());
        typed(&mut field, &folder.path().join("new/one.toml"));
        assert!(field.apply(PathCommand::Take).is_none(), "asked first");
        assert_eq!(field.asked().expect("still").question, Some(Question::Make), "no such folder");
        assert!(field.apply(PathCommand::Confirm).is_some() && folder.path().join("new").is_dir(), "made");
        assert_eq!(field.folder(), folder.path().join("new"), "the next begins there");
    }

    #[test]
    fn what_cannot_be_taken_says_why() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut field = asking(Wish::Open, folder.path());
        typed(&mut field, &folder.path().join("nothing.toml"));
        assert!(field.apply(PathCommand::Take).is_none(), "not there");
        assert!(field.asked().expect("still").problem.as_deref().is_some_and(|p| p.contains("nothing.toml")), "said");
        typed(&mut field, folder.path());
        assert!(field.apply(PathCommand::Take).is_none(), "a folder is gone into");
        assert!(field.asked().expect("still").text.ends_with(MAIN_SEPARATOR), "and shown");
        std::fs::write(folder.path().join("summary.json"), "{}").expect("written");
        let mut field = asking(Wish::Export(Export::Tables), folder.path());
        assert!(field.apply(PathCommand::Take).is_none(), "asked first");
        assert_eq!(field.asked().expect("still").question, Some(Question::Among), "among other files");
    }
}
