//! The workbench by a link: what one opens, and one that leads to what is shown.

use std::path::Path;
use std::sync::Arc;

use super::workbench::Workbench;
use crate::app::command::{AppearanceCommand, EditCommand, FileCommand, LearnCommand, TimeCommand, WindowCommand};
use crate::app::learn::lessons::lessons;
use crate::app::link::{Link, Target};
use crate::app::text;
use crate::files::{SceneSource, read_scene, scene_text};
use crate::scene::edit::Edit;
use crate::scene::presets;

impl Workbench {
    /// Follows a link; one without sense shows a message and changes nothing.
    pub fn follow(&mut self, fragment: &str) {
        // What was told of another link is about that one.
        self.apply(WindowCommand::Dismiss);
        match Link::parse(fragment) {
            Ok(link) => self.go_to(link),
            Err(words) => self.window.say(words),
        }
    }

    fn go_to(&mut self, Link { target, t, language }: Link) {
        match target {
            None => {}
            Some(Target::Preset(name)) if presets::get(&name).is_none() => {
                return self.window.say(text::link_refused(&format!("scene={name}")));
            }
            Some(Target::Preset(name)) => self.apply(FileCommand::OpenPreset(name)),
            Some(Target::Lesson(name)) => match numbered(&name) {
                Ok(number) => self.apply(LearnCommand::Open(number)),
                Err(words) => return self.window.say(words),
            },
            Some(Target::Text(words, lesson)) => match (read_scene(&words, "link"), lesson.as_deref().map(numbered)) {
                (Err(errors), _) => return self.window.say(errors.to_string()),
                (_, Some(Err(words))) => return self.window.say(words),
                (Ok(scene), None) => self.take_up(scene, SceneSource::Text(Arc::from(words))),
                // What was tried in the lesson: an edit of its scene. As where a link has a scene alone, undo brings back what
                // was there.
                (Ok(scene), Some(Ok(number))) => {
                    self.open_lesson(number);
                    self.apply(EditCommand::Change { edit: Edit::Scene(Box::new(scene)), gesture: None });
                }
            },
        }
        if let Some(language) = language {
            language.speak();
            self.apply(AppearanceCommand::Language(language));
        }
        // The moment is one of what the link opens, which may wait until unsaved work is saved.
        if let Some(t) = t.filter(|_| !self.window.asks()) {
            self.apply(TimeCommand::Seek(t));
        }
    }

    /// A link to the scene, the moment and the language that are shown.
    ///
    /// # Errors
    /// In words: the scene has too much text for a link.
    pub fn link(&self) -> Result<String, String> {
        let (document, changed) = (&self.files.document, self.files.document.is_dirty());
        let source = document.source();
        let shipped = |preset: &&presets::Preset| source == SceneSource::Shipped(preset.text);
        let target = match (self.learning.lesson(), presets::all().iter().find(shipped)) {
            (Some(lesson), _) if !changed => Target::Lesson(lesson.name.to_owned()),
            (None, Some(preset)) if !changed => Target::Preset(preset.name.to_owned()),
            (lesson, _) => {
                let as_seen = self.view.display.scene_as_seen(document.scene());
                Target::Text(scene_text(&as_seen, &source, Path::new("")), lesson.map(|lesson| lesson.name.to_owned()))
            }
        };
        let language = Some(self.window.language);
        Link { target: Some(target), t: Some(self.replay.t()), language }.write()
    }
}

/// Number of the lesson of this name; in words, that there is none.
fn numbered(name: &str) -> Result<usize, String> {
    let number = lessons().iter().position(|lesson| lesson.name == name);
    number.ok_or_else(|| text::link_refused(&format!("lesson={name}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::edits;
    use crate::language::Language;

    fn opened() -> Workbench {
        let mut bench =
            Workbench::new(presets::load(presets::OPENING).expect("ships"), SceneSource::of(presets::OPENING));
        bench.replay.runner.set_estimates(false);
        bench
    }

    #[test]
    fn a_link_to_what_is_shown_leads_back_to_it() {
        let mut bench = opened();
        bench.follow("#lesson=stick-and-slip&t=0.42&lang=ja");
        assert_eq!(
            (bench.learning.lesson().map(|lesson| lesson.name), bench.replay.t()),
            (Some("stick-and-slip"), 0.42)
        );
        assert_eq!(bench.window.language, Language::Japanese);
        assert_eq!(bench.link().as_deref(), Ok("lesson=stick-and-slip&t=0.42&lang=ja"));
        bench.follow("#scene=skew60-abutment&lang=en");
        assert_eq!(bench.link().as_deref(), Ok("scene=skew60-abutment&t=0&lang=en"), "another scene");
        let changed = edits::duration(bench.files.document.scene(), 3.5);
        bench.files.document.edit(changed, None).expect("fits");
        let link = bench.link().expect("small");
        let mut other = opened();
        other.follow(&link);
        assert_eq!(other.files.document.scene(), bench.files.document.scene(), "a scene of the user's own: {link}");
        assert!(other.window.notice().is_none() && !other.files.document.is_dirty(), "as it came");
    }

    #[test]
    fn a_link_to_what_was_tried_in_a_lesson_keeps_its_words() {
        let mut bench = opened();
        bench.follow("#lesson=stick-and-slip");
        let changed = edits::duration(bench.files.document.scene(), 3.5);
        bench.apply(EditCommand::Change { edit: changed, gesture: None });
        let link = bench.link().expect("small");
        let mut other = opened();
        other.follow(&link);
        assert_eq!(other.learning.lesson().map(|lesson| lesson.name), Some("stick-and-slip"), "{link}");
        assert_eq!(other.files.document.scene(), bench.files.document.scene(), "the scene that was tried");
        other.apply(EditCommand::Undo);
        assert!(other.files.document.scene().duration != 3.5, "and back to the lesson's own");
        let mut at_work = opened();
        let work = edits::duration(at_work.files.document.scene(), 7.0);
        at_work.apply(EditCommand::Change { edit: work, gesture: None });
        let before = at_work.files.document.scene().clone();
        at_work.follow(&link);
        assert_eq!(at_work.files.document.scene(), bench.files.document.scene(), "over work that is not saved");
        at_work.apply(EditCommand::Undo);
        at_work.apply(EditCommand::Undo);
        assert_eq!(*at_work.files.document.scene(), before, "which undo brings back");
    }

    #[test]
    fn a_link_that_leads_nowhere_is_told_and_leaves_the_scene() {
        let mut bench = opened();
        let before = bench.files.document.revision();
        for wrong in ["#scene=no-such", "#lesson=no-such", "#t=soon", "#toml=format%20%3D%202"] {
            bench.window.say("");
            bench.follow(wrong);
            assert!(bench.window.notice().is_some_and(|words| !words.is_empty()), "{wrong}: told");
        }
        assert_eq!(bench.files.document.revision(), before, "the scene that was there");
        bench.follow("#scene=no-such&lang=ja");
        assert_eq!(bench.window.language, Language::English, "nothing of it is done");
        bench.follow("#lesson=stick-and-slip");
        assert_eq!(bench.window.notice(), None, "what was told of another link is gone");
    }
}
