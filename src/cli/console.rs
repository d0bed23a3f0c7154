//! The one place that writes to the terminal.

use std::io::{Write, stderr, stdout};

/// Standard output for answers, standard error for notes about them.
///
/// A reader that stops early (`girderbench run … | head`) closes the pipe: what is left to say is then dropped and the
/// work goes on, so that files are still written and nothing panics.
pub(super) struct Console {
    out: Box<dyn Write>,
    notes: Box<dyn Write>,
}

impl std::fmt::Debug for Console {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Console")
    }
}

impl Console {
    /// The process's own streams.
    pub(super) fn standard() -> Self {
        Self { out: Box::new(stdout()), notes: Box::new(stderr()) }
    }

    /// Prints a part of the answer as it is, line ends included.
    pub(super) fn print(&mut self, text: &str) {
        if self.out.write_all(text.as_bytes()).and_then(|()| self.out.flush()).is_err() {
            self.out = Box::new(std::io::sink());
        }
    }

    /// Says something about the answer, as one paragraph on standard error.
    pub(super) fn note(&mut self, text: &str) {
        if writeln!(self.notes, "{text}").is_err() {
            self.notes = Box::new(std::io::sink());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Error, ErrorKind};

    struct ClosedPipe;

    impl Write for ClosedPipe {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(Error::from(ErrorKind::BrokenPipe))
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Err(Error::from(ErrorKind::BrokenPipe))
        }
    }

    #[test]
    fn a_closed_pipe_is_no_panic() {
        let mut console = Console { out: Box::new(ClosedPipe), notes: Box::new(ClosedPipe) };
        console.print("answer\n");
        console.note("note");
        console.print("more\n");
    }
}
