//! The one place that writes to the terminal.

use std::io::{Error, ErrorKind, Write, stderr, stdout};

use super::failure::Failure;
use crate::language::said;
use crate::scene::shown::escaped;

/// Standard output for answers, standard error for notes about them.
///
/// Once standard output takes no more, what is left of the answer is dropped and the work goes on, so that files are still
/// written and nothing panics; [`finish`](Self::finish) tells whether that was an error. Characters that a terminal obeys
/// are escaped: names come from files.
pub(super) struct Console {
    out: Box<dyn Write>,
    notes: Box<dyn Write>,
    /// Why standard output took no more.
    ended: Option<Error>,
}

impl std::fmt::Debug for Console {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Console")
    }
}

impl Console {
    /// The process's own streams.
    pub(super) fn standard() -> Self {
        Self { out: Box::new(stdout()), notes: Box::new(stderr()), ended: None }
    }

    /// Prints a part of the answer as it is, line ends included.
    pub(super) fn print(&mut self, text: &str) {
        self.write(|out| out.write_all(escaped_lines(text).as_bytes()));
    }

    /// Writes a part of the answer to standard output, unless that takes no more.
    pub(super) fn write(&mut self, write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) {
        if self.ended.is_none() {
            self.ended = write(&mut self.out).and_then(|()| self.out.flush()).err();
        }
    }

    /// Says something about the answer, as one paragraph on standard error.
    pub(super) fn note(&mut self, text: &str) {
        if writeln!(self.notes, "{}", escaped_lines(text)).is_err() {
            self.notes = Box::new(std::io::sink());
        }
    }

    /// Whether standard output took the whole answer. A reader that stopped early (`girderbench run … | head`) is no error.
    ///
    /// # Errors
    /// Why it took no more.
    pub(super) fn finish(&mut self) -> Result<(), Failure> {
        match self.ended.take() {
            Some(error) if error.kind() != ErrorKind::BrokenPipe => {
                Err(Failure::Output(said!("failed-standard-output", "error" => error.to_string())))
            }
            _ => Ok(()),
        }
    }
}

/// [`escaped`] line by line.
fn escaped_lines(text: &str) -> String {
    text.split_inclusive('\n')
        .map(|line| match line.strip_suffix('\n') {
            Some(line) => format!("{}\n", escaped(line)),
            None => escaped(line).into_owned(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fails in one way.
    struct Broken(ErrorKind);

    impl Write for Broken {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(Error::from(self.0))
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Err(Error::from(self.0))
        }
    }

    fn finish(kind: ErrorKind) -> Result<(), Failure> {
        let mut console = Console { out: Box::new(Broken(kind)), notes: Box::new(Broken(kind)), ended: None };
        console.print("answer\n");
        console.note("note");
        console.print("more\n");
        console.finish()
    }

    #[test]
    fn a_closed_pipe_is_no_error_and_a_full_disk_is_one() {
        assert!(finish(ErrorKind::BrokenPipe).is_ok(), "its reader has read enough");
        assert!(matches!(finish(ErrorKind::StorageFull), Err(Failure::Output(_))), "nothing else is");
    }
}
