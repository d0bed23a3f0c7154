//! Runs the program as a user does, and reads what it says and writes.

use std::process::{Command, Output, Stdio};
use std::time::Duration;

/// What a call of the program came to.
pub(crate) struct Said {
    /// Exit status; `None` when a signal ended it.
    pub(crate) status: Option<i32>,
    /// Standard output.
    pub(crate) out: String,
    /// Standard error.
    pub(crate) err: String,
}

/// The program, ready for arguments, in English; no display, so that nothing opens a window by mistake.
pub(crate) fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_girderbench"));
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
    command.env("LC_ALL", "C");
    command
}

/// Calls the program and waits for it.
pub(crate) fn call(args: &[&str]) -> Said {
    said(&program().args(args).output().expect("the program starts"))
}

/// Calls the program and stops it when it has not ended within so many seconds, which is a failure.
pub(crate) fn call_within(seconds: u64, command: &mut Command) -> Said {
    let spawned = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = spawned.expect("the program starts");
    let mut looks = 0..200 * seconds;
    while child.try_wait().expect("its state").is_none() {
        if looks.next().is_none() {
            child.kill().expect("stopped");
            panic!("{command:?} has not ended within {seconds} s");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    said(&child.wait_with_output().expect("its output"))
}

/// What an output says; a panic is a failure whatever the status.
pub(crate) fn said(output: &Output) -> Said {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("the program writes UTF-8");
    let said = Said { status: output.status.code(), out: text(&output.stdout), err: text(&output.stderr) };
    assert!(!said.err.contains("panicked"), "no panic: {}", said.err);
    said
}
