//! Guided scenes: a scene, some words beside it, and things to try.
//!
//! The words and the scenes are files in `assets/lessons`; every statement in them is computed by a test. What a thing to
//! try sets is all that any of them sets, so that it shows what it says in whatever order they are tried.

use std::sync::LazyLock;

use serde::Deserialize;

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::scene::edit::Edit;
use crate::scene::{Scene, SceneErrors, format};

/// A guided scene.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lesson {
    /// The question.
    pub title: String,
    /// The time that it opens at \[s\].
    #[serde(rename = "at_s")]
    pub at: f64,
    /// Paragraphs beside the view.
    pub text: Vec<String>,
    /// Things to try, in order.
    #[serde(rename = "try")]
    pub tries: Vec<Try>,
    /// The scene's file.
    #[serde(skip)]
    toml: &'static str,
    /// What the scene is called.
    #[serde(skip)]
    pub name: &'static str,
}

/// Something to try.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Try {
    /// What is done: on the button.
    pub words: String,
    /// What is seen then.
    pub text: String,
    /// Values by their paths, as in `--set`.
    pub set: Vec<String>,
}

/// A wish about lessons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Learn {
    /// Open the lesson of this number.
    Open(usize),
    /// Do the thing to try of this number.
    Try(usize),
    /// Put the lesson's scene back.
    Reset,
    /// Close the words; the scene stays.
    Close,
}

macro_rules! file {
    ($name:literal, $end:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/lessons/", $name, $end))
    };
}

macro_rules! lesson {
    ($name:literal) => {
        ($name, file!($name, ".lesson.toml"), file!($name, ".toml"))
    };
}

/// Name, words, scene; in the order of the menu.
const FILES: [(&str, &str, &str); 5] = [
    lesson!("one-hit-or-two"),
    lesson!("skewed-deck"),
    lesson!("which-way-to-shake"),
    lesson!("stick-and-slip"),
    lesson!("friction-cone"),
];

static LESSONS: LazyLock<Vec<Lesson>> = LazyLock::new(|| {
    // They are part of the program: a test reads them all.
    FILES.iter().filter_map(|&(name, words, toml)| Some(Lesson { toml, name, ..toml::from_str(words).ok()? })).collect()
});

/// Every guided scene.
pub fn lessons() -> &'static [Lesson] {
    &LESSONS
}

impl Lesson {
    /// The scene that it opens with.
    ///
    /// # Errors
    /// None: the scene is part of the program.
    pub fn scene(&self) -> Result<Scene, SceneErrors> {
        format::read(self.toml, self.name)
    }
}

impl Try {
    /// What it does to the scene.
    pub fn edit(&self) -> Edit {
        Edit::Batch(self.set.iter().cloned().map(Edit::Set).collect())
    }
}

impl Workbench {
    /// The guided scene whose words are shown.
    pub fn lesson(&self) -> Option<&'static Lesson> {
        self.lesson.and_then(|number| lessons().get(number))
    }

    /// Does what is wished.
    pub(in crate::app) fn apply_learn(&mut self, wish: Learn) {
        match wish {
            Learn::Open(number) => self.open_lesson(number),
            Learn::Reset => self.lesson.into_iter().for_each(|number| self.open_lesson(number)),
            Learn::Close => self.lesson = None,
            Learn::Try(number) => {
                let (Some(open), Some(lesson)) = (self.lesson, self.lesson()) else { return };
                if self.scene().name != lesson.name {
                    self.open_lesson(open);
                }
                if let Some(try_it) = lesson.tries.get(number) {
                    self.apply(Command::Edit { edit: try_it.edit(), gesture: None });
                }
            }
        }
    }

    fn open_lesson(&mut self, number: usize) {
        let Some(lesson) = lessons().get(number) else { return };
        match lesson.scene() {
            Ok(scene) => {
                self.aim_next = Some(scene.view.camera);
                self.take_up(scene, None);
                self.lesson = Some(number);
                self.clock.t = lesson.at.min(self.end());
            }
            Err(errors) => self.notice = Some(errors.to_string()),
        }
    }
}
