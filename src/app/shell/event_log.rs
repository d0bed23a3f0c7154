//! Log of the window, as lines of a file: each frame with its times, and how long each edit took from the hand to the answer on the screen
//! (`docs/cost.md`). Written where `GIRDERBENCH_EVENT_LOG` names a file, and nothing is measured otherwise.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{LineWriter, Write};

use crate::app::host::{Instant, now};

/// The file that is written.
const VARIABLE: &str = "GIRDERBENCH_EVENT_LOG";

/// Parts of a frame, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Panels, edits, runs that are made at once, the view's list.
    LaidOut,
    /// Shapes as triangles.
    Tessellated,
    /// Drawn and handed to the display.
    Painted,
}

/// The log of a window.
pub(super) struct EventLog {
    file: LineWriter<File>,
    start: Instant,
    /// The first input since the last frame.
    input: Option<Instant>,
    /// When the frame began, and the ends of its parts.
    frame: (Instant, [Instant; 3]),
    /// When the hand moved that an edit came of, by revision; those whose answers are not shown yet.
    asked: BTreeMap<u64, Instant>,
    revision: u64,
    answered: Option<u64>,
    /// From hand to screen, one an answer \[ms\].
    delays: Vec<f64>,
}

impl EventLog {
    /// The log that the environment asks for.
    pub(super) fn wanted() -> Option<Self> {
        let path = std::env::var_os(VARIABLE)?;
        let begun = File::create(&path).map(LineWriter::new).and_then(|mut file| {
            writeln!(file, "at_ms,input_ms,layout_ms,tessellate_ms,paint_ms,revision,answered").map(|()| file)
        });
        if let Err(error) = &begun {
            // The window opens without.
            let _ = writeln!(std::io::stderr(), "{VARIABLE}: {}: {error}", path.to_string_lossy());
        }
        let file = begun.ok()?;
        let start = now();
        Some(Self {
            file,
            start,
            input: None,
            frame: (start, [start; 3]),
            asked: BTreeMap::new(),
            revision: 0,
            answered: None,
            delays: Vec::new(),
        })
    }

    /// Something has come from mouse or keys.
    pub(super) fn input(&mut self) {
        self.input.get_or_insert_with(now);
    }

    /// A frame begins.
    pub(super) fn begin(&mut self) {
        self.frame.0 = now();
    }

    /// A part of it has ended.
    pub(super) fn end(&mut self, part: Part) {
        self.frame.1[part as usize] = now();
    }

    /// The frame is shown, of a scene of this revision with the answer of that one.
    pub(super) fn shown(&mut self, revision: u64, answered: Option<u64>) {
        let (began, ends) = self.frame;
        let input = self.input.take();
        if revision != self.revision {
            self.revision = revision;
            self.asked.insert(revision, input.unwrap_or(began));
        }
        if answered != self.answered {
            self.answered = answered;
            self.answer(ends[2]);
        }
        let ms = |from: Instant, to: Instant| to.saturating_duration_since(from).as_secs_f64() * 1e3;
        let waited = input.map_or(0.0, |input| ms(input, began));
        let [laid, tessellated, painted] = [ms(began, ends[0]), ms(ends[0], ends[1]), ms(ends[1], ends[2])];
        let (at, of) = (ms(self.start, began), answered.map(|of| of.to_string()).unwrap_or_default());
        // A log that cannot be written any more is none.
        let _ = writeln!(self.file, "{at:.2},{waited:.2},{laid:.2},{tessellated:.2},{painted:.2},{revision},{of}");
    }

    /// Every edit up to the answered one has its answer on the screen; those that a later one overtook are not counted.
    fn answer(&mut self, at: Instant) {
        let Some(answered) = self.answered else { return };
        let later = self.asked.split_off(&(answered + 1));
        let done = std::mem::replace(&mut self.asked, later);
        if let Some(asked) = done.get(&answered) {
            self.delays.push(at.saturating_duration_since(*asked).as_secs_f64() * 1e3);
        }
    }
}

impl Drop for EventLog {
    fn drop(&mut self) {
        self.delays.sort_by(f64::total_cmp);
        let count = self.delays.len();
        let at = |part: usize| self.delays.get((count.max(1) - 1) * part / 10).copied().unwrap_or(f64::NAN);
        let _ = writeln!(
            self.file,
            "# from the hand to the answer on the screen: {count} edits, median {:.1} ms, nine of ten {:.1} ms, longest {:.1} ms",
            at(5),
            at(9),
            at(10)
        );
        let _ = self.file.flush();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edit_is_counted_from_the_hand_to_the_frame_that_shows_its_answer() {
        let path = std::env::temp_dir().join(format!("girderbench-events-{}.csv", std::process::id()));
        let mut log = EventLog {
            file: LineWriter::new(File::create(&path).expect("a file")),
            start: now(),
            input: None,
            frame: (now(), [now(); 3]),
            asked: BTreeMap::new(),
            revision: 1,
            answered: Some(1),
            delays: Vec::new(),
        };
        for (revision, answered) in [(2, Some(1)), (3, Some(1)), (4, Some(3)), (4, Some(4)), (4, Some(4))] {
            log.input();
            log.begin();
            for part in [Part::LaidOut, Part::Tessellated, Part::Painted] {
                log.end(part);
            }
            log.shown(revision, answered);
        }
        assert_eq!(log.delays.len(), 2, "the third and the fourth; the second was overtaken");
        assert!(log.asked.is_empty() && log.delays.iter().all(|delay| *delay >= 0.0));
        drop(log);
        let written = std::fs::read_to_string(&path).expect("written");
        assert_eq!(written.lines().count(), 6, "a line a frame, and what they come to: {written}");
        assert!(written.contains("2 edits"), "{written}");
        std::fs::remove_file(path).expect("cleared away");
    }
}
