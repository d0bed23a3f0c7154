//! Runs that are kept to compare with.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::app::command::CompareCommand;
use crate::app::run::answer::Answer;
use crate::app::style::theme::PINS;
use crate::app::text;

/// Most runs that are kept: more cannot be told apart.
const MOST_PINS: usize = PINS.len();

/// A run that is kept.
#[derive(Clone)]
pub struct Pin {
    /// Name: the difference, as far as undo knows it.
    pub(in crate::app) name: String,
    /// The run.
    pub(in crate::app) answer: Arc<Answer>,
    /// Which of the colours it has.
    pub(in crate::app) color: usize,
}

/// The runs that are kept, in the order in which they were.
#[derive(Default)]
pub struct Comparison {
    pins: Vec<Pin>,
    /// Whether the plots show the differences from them.
    differences: bool,
    /// Which of the scenes that were opened they are of.
    work: u64,
    /// Those of other scenes, which are shown again when undo leads back to them.
    aside: BTreeMap<u64, Vec<Pin>>,
}

impl Comparison {
    /// All of them.
    pub fn pins(&self) -> &[Pin] {
        &self.pins
    }

    /// Whether the plots show the differences from them.
    pub fn differences(&self) -> bool {
        self.differences
    }

    /// Goes over to another of the scenes that were opened: its runs are shown, and those of the one before are not.
    pub(in crate::app) fn turn_to(&mut self, work: u64) {
        if self.work != work {
            let others = self.aside.remove(&work).unwrap_or_default();
            let mine = std::mem::replace(&mut self.pins, others);
            self.aside.insert(std::mem::replace(&mut self.work, work), mine);
        }
    }

    /// Numbers of their answers.
    pub(in crate::app) fn numbers(&self) -> Vec<u64> {
        self.pins.iter().map(|p| p.answer.number).collect()
    }

    /// Does a command; `shown` is the run that is shown, `what` was different in it.
    ///
    /// # Errors
    /// As [`Comparison::pin`].
    pub(in crate::app) fn apply(
        &mut self,
        command: CompareCommand,
        shown: Option<&Arc<Answer>>,
        what: &str,
    ) -> Result<(), &'static str> {
        match command {
            CompareCommand::Pin => shown.map_or(Ok(()), |answer| self.pin(answer, what)),
            CompareCommand::Unpin(number) => {
                self.unpin(number);
                Ok(())
            }
            CompareCommand::Differences(on) => {
                self.differences = on;
                Ok(())
            }
            CompareCommand::UnpinAll => {
                self.pins.clear();
                Ok(())
            }
        }
    }

    /// Keeps a run, named after what was different in it.
    ///
    /// # Errors
    /// In words: the same run is kept already, or there is no room.
    fn pin(&mut self, answer: &Arc<Answer>, what: &str) -> Result<(), &'static str> {
        let digest = answer.history.digest();
        if self.pins.iter().any(|p| p.answer.history.digest() == digest) {
            return Err(text::PIN_THERE.as_str());
        }
        let free = (0..MOST_PINS).find(|c| self.pins.iter().all(|p| p.color != *c));
        let color = free.ok_or(text::PINS_FULL.as_str())?;
        self.pins.push(Pin { name: what.to_owned(), answer: answer.clone(), color });
        Ok(())
    }

    /// Lets one go, by its number from 0; nothing where there is none.
    fn unpin(&mut self, number: usize) {
        if number < self.pins.len() {
            self.pins.remove(number);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::scene::presets;
    use crate::sim::History;

    fn answer(duration: f64) -> Arc<Answer> {
        let mut scene = presets::load(presets::OPENING).expect("ships");
        scene.duration = duration;
        Arc::new(Answer::new(History::of(&scene).expect("runs"), Duration::ZERO, 1))
    }

    #[test]
    fn a_run_is_kept_once_and_a_colour_is_free_again_when_its_run_goes() {
        let mut kept = Comparison::default();
        let runs: Vec<Arc<Answer>> = (0..=MOST_PINS).map(|i| answer(0.1 + 0.01 * i as f64)).collect();
        for run in &runs[..MOST_PINS] {
            kept.pin(run, "gap").expect("room for it");
        }
        assert_eq!(kept.pin(&runs[0], "gap"), Err(text::PIN_THERE.as_str()), "the same run");
        assert_eq!(kept.pin(&runs[MOST_PINS], "gap"), Err(text::PINS_FULL.as_str()), "one too many");
        kept.unpin(1);
        kept.unpin(99);
        kept.pin(&runs[MOST_PINS], "gap").expect("room again");
        assert_eq!(kept.pins().last().map(|p| p.color), Some(1), "the colour that became free");
    }

    #[test]
    fn runs_of_another_scene_are_put_aside_and_come_back_with_it() {
        let mut kept = Comparison::default();
        kept.pin(&answer(0.1), "gap").expect("room for it");
        kept.turn_to(1);
        assert!(kept.pins().is_empty(), "nothing of the scene before");
        kept.pin(&answer(0.1), "gap").expect("another scene's");
        kept.turn_to(0);
        assert_eq!(kept.pins().first().map(|p| p.name.as_str()), Some("gap"), "its own again");
    }
}
