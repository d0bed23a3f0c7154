//! Guided scenes: a scene, some words beside it, and things to try.
//!
//! The words and the scenes are files in `assets/lessons`; every statement in them is computed by a test. What a thing to
//! try sets is all that any of them sets, so that it shows what it says in whatever order they are tried. Words in another
//! language lie beside those in English; a lesson without them is shown in English.

use std::sync::LazyLock;

use serde::Deserialize;

use crate::files::SceneSource;
use crate::language::Language;
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
    /// Name of the scene.
    #[serde(skip)]
    pub name: &'static str,
}

/// Something to try.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Try {
    /// Text of the button.
    pub words: String,
    /// Text on the result.
    pub text: String,
    /// When it is seen; where it is left out the time stays \[s\].
    #[serde(default, rename = "at_s")]
    pub at: Option<f64>,
    /// Values by their paths, as in `--set`.
    pub set: Vec<String>,
}

/// The words of a lesson in another language than English.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Translation {
    title: String,
    text: Vec<String>,
    /// In the order of the lesson's own.
    #[serde(rename = "try")]
    tries: Vec<TranslatedTry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TranslatedTry {
    words: String,
    text: String,
}

impl Translation {
    /// A lesson in these words.
    fn of(self, mut lesson: Lesson) -> Lesson {
        (lesson.title, lesson.text) = (self.title, self.text);
        for (own, TranslatedTry { words, text }) in lesson.tries.iter_mut().zip(self.tries) {
            (own.words, own.text) = (words, text);
        }
        lesson
    }
}

macro_rules! file {
    ($path:expr) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/", $path))
    };
}

/// Words beside a scene of the same name, or beside a preset.
macro_rules! lesson {
    ($name:literal) => {
        ($name, file!(concat!("lessons/", $name, ".lesson.toml")), file!(concat!("lessons/", $name, ".toml")))
    };
    ($words:literal of $preset:literal) => {
        ($preset, file!(concat!("lessons/", $words, ".lesson.toml")), file!(concat!("presets/", $preset, ".toml")))
    };
}

/// Name, words, scene; in the order of the menu.
const FILES: [(&str, &str, &str); 8] = [
    lesson!("one-hit-or-two"),
    lesson!("skewed-deck"),
    lesson!("which-way-to-shake"),
    lesson!("stick-and-slip"),
    lesson!("friction-cone"),
    lesson!("skewed-seat"),
    lesson!("how-long-a-hit"),
    lesson!("what-the-paper-saw" of "straight-abutment"),
];

/// Name, words in Japanese.
const IN_JAPANESE: [(&str, &str); 8] = [
    ("one-hit-or-two", file!("lessons/one-hit-or-two.ja.lesson.toml")),
    ("skewed-deck", file!("lessons/skewed-deck.ja.lesson.toml")),
    ("which-way-to-shake", file!("lessons/which-way-to-shake.ja.lesson.toml")),
    ("stick-and-slip", file!("lessons/stick-and-slip.ja.lesson.toml")),
    ("friction-cone", file!("lessons/friction-cone.ja.lesson.toml")),
    ("skewed-seat", file!("lessons/skewed-seat.ja.lesson.toml")),
    ("how-long-a-hit", file!("lessons/how-long-a-hit.ja.lesson.toml")),
    ("straight-abutment", file!("lessons/what-the-paper-saw.ja.lesson.toml")),
];

/// By language, in the order of [`Language::ALL`].
static LESSONS: LazyLock<[Vec<Lesson>; 2]> = LazyLock::new(|| Language::ALL.map(read));

fn read(language: Language) -> Vec<Lesson> {
    let translated: &[(&str, &str)] = match language {
        Language::English => &[],
        Language::Japanese => &IN_JAPANESE,
    };
    let of = |&(name, words, toml): &(&'static str, &str, &'static str)| {
        // They are part of the program: a test reads them all.
        let lesson = Lesson { toml, name, ..toml::from_str(words).ok()? };
        let own = translated.iter().find(|(of, _)| *of == name);
        Some(match own.and_then(|(_, words)| toml::from_str::<Translation>(words).ok()) {
            Some(translation) => translation.of(lesson),
            None => lesson,
        })
    };
    FILES.iter().filter_map(of).collect()
}

/// Every guided scene, in the language of this thread.
pub fn lessons() -> &'static [Lesson] {
    &LESSONS[Language::current() as usize]
}

impl Lesson {
    /// The text of its scene.
    pub(in crate::app) fn source(&self) -> SceneSource {
        SceneSource::Shipped(self.toml)
    }

    /// The scene that it opens with.
    ///
    /// # Errors
    /// None: the scene is part of the program.
    pub fn scene(&self) -> Result<Scene, SceneErrors> {
        format::read(self.toml, self.name)
    }
}

impl Try {
    /// Edit of the scene.
    pub fn edit(&self) -> Edit {
        Edit::Batch(self.set.iter().cloned().map(Edit::Set).collect())
    }
}

/// Which lesson is open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Learning {
    open: Option<usize>,
    /// Step tried last.
    tried: Option<usize>,
}

impl Learning {
    /// Opens the lesson of this number; `None` where there is none, and the one that was open stays.
    pub(in crate::app) fn open(&mut self, number: usize) -> Option<&'static Lesson> {
        let lesson = lessons().get(number)?;
        *self = Self { open: Some(number), tried: None };
        Some(lesson)
    }

    /// Closes the one that is open.
    pub(in crate::app) fn close(&mut self) {
        *self = Self::default();
    }

    /// Notes that this was tried.
    pub(in crate::app) fn note(&mut self, number: usize) {
        self.tried = Some(number);
    }

    /// Step tried last, where this scene has all that it sets.
    pub(in crate::app) fn in_force(self, scene: &Scene) -> Option<usize> {
        let number = self.tried?;
        let mut with = scene.clone();
        (self.to_try(number)?.edit().apply(&mut with).is_ok() && with == *scene).then_some(number)
    }

    /// Number of the lesson that is open.
    pub(in crate::app) fn number(self) -> Option<usize> {
        self.open
    }

    /// The lesson that is open.
    pub fn lesson(self) -> Option<&'static Lesson> {
        self.open.and_then(|number| lessons().get(number))
    }

    /// A thing to try of the lesson that is open.
    pub(in crate::app) fn to_try(self, number: usize) -> Option<&'static Try> {
        self.lesson()?.tries.get(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lesson_in_japanese_is_the_same_lesson() {
        for (name, words) in IN_JAPANESE {
            let translation: Translation = toml::from_str(words).unwrap_or_else(|e| panic!("{name}: {e}"));
            let english = read(Language::English).into_iter().find(|lesson| lesson.name == name).expect(name);
            let counts = [english.text.len(), english.tries.len()];
            assert_eq!([translation.text.len(), translation.tries.len()], counts, "{name}");
        }
        let pairs = read(Language::English).into_iter().zip(read(Language::Japanese));
        let mut translated = 0;
        for (english, japanese) in pairs {
            assert_eq!((japanese.name, japanese.toml), (english.name, english.toml), "the same scene");
            let set = |lesson: &Lesson| lesson.tries.iter().flat_map(|t| t.set.clone()).collect::<Vec<_>>();
            assert_eq!((set(&japanese), japanese.at), (set(&english), english.at), "{}", english.name);
            translated += usize::from(japanese.title != english.title);
        }
        assert_eq!(translated, IN_JAPANESE.len());
    }

    #[test]
    fn what_was_tried_is_in_force_while_the_scene_has_what_it_sets() {
        let mut learning = Learning::default();
        let lesson = learning.open(0).expect("the first");
        let mut scene = lesson.scene().expect("part of the program");
        assert_eq!(learning.in_force(&scene), None, "nothing was tried");
        lesson.tries[0].edit().apply(&mut scene).expect("it fits");
        learning.note(0);
        assert_eq!(learning.in_force(&scene), Some(0), "as it left the scene");
        scene.duration *= 2.0;
        assert_eq!(learning.in_force(&scene), Some(0), "beside another change");
        assert_eq!(learning.in_force(&lesson.scene().expect("part of the program")), None, "taken back");
    }

    #[test]
    fn only_lessons_that_there_are_can_be_opened() {
        let mut learning = Learning::default();
        assert_eq!(learning.open(1).map(|l| l.name), Some(lessons()[1].name), "the second");
        assert!(learning.open(lessons().len()).is_none(), "one too far");
        assert_eq!(learning.number(), Some(1), "the second is still open");
        assert!(learning.to_try(usize::MAX).is_none(), "no such thing to try");
        learning.close();
        assert!(learning.lesson().is_none(), "closed");
    }
}
