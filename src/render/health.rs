//! Faults of a device: stored until read, where wgpu by itself would panic.

use std::sync::{Arc, Mutex, PoisonError};

use crate::language::{Text, said};

/// Why a device is of no more use. What was made on it is lost with it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// It has gone: a driver that was restarted or updated, a card that was taken out, a computer that slept.
    #[error("{}", said!("gpu-lost", "why" => .0.as_str()))]
    Lost(String),
    /// It has no room for what is to be drawn.
    #[error("{}", said!("gpu-no-memory", "why" => .0.as_str()))]
    OutOfMemory(String),
    /// It did not do what it was told.
    #[error("{}", said!("gpu-refused", "why" => .0.as_str()))]
    Refused(String),
}

impl Fault {
    fn of(error: &wgpu::Error) -> Self {
        let words = in_one_line(&error.to_string());
        match error {
            wgpu::Error::OutOfMemory { .. } => Self::OutOfMemory(words),
            wgpu::Error::Validation { .. } | wgpu::Error::Internal { .. } => Self::Refused(words),
        }
    }
}

/// The first fault of one device. All copies are one.
#[derive(Clone, Debug, Default)]
pub struct Health(Arc<Mutex<Option<Fault>>>);

impl Health {
    /// Listens to a device from now on.
    pub fn of(device: &wgpu::Device) -> Self {
        let health = Self::default();
        let (lost, error) = (health.clone(), health.clone());
        device.set_device_lost_callback(move |_, words| lost.note(Fault::Lost(in_one_line(&words))));
        device.on_uncaptured_error(Arc::new(move |e| error.note(Fault::of(&e))));
        health
    }

    /// The first fault, or the loss of the device, which explains all others.
    pub fn fault(&self) -> Option<Fault> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Something went wrong.
    pub fn note(&self, fault: Fault) {
        let mut first = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let explained = matches!((first.as_ref(), &fault), (Some(Fault::Refused(_)), Fault::Lost(_)));
        if first.is_none() || explained {
            *first = Some(fault);
        }
    }
}

/// A driver's words, which may have many lines, as one that fits into a sentence.
fn in_one_line(words: &str) -> String {
    let line = words.split_whitespace().collect::<Vec<_>>().join(" ");
    let line = line.trim_end_matches('.');
    if line.is_empty() { Text::new("gpu-unsaid").into() } else { line.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_device_without_memory_says_so_in_one_line() {
        let fault = Fault::of(&wgpu::Error::OutOfMemory { source: "  no\n  room.".into() });
        let words = fault.to_string();
        assert!(words.starts_with("the graphics device has no memory left (") && !words.contains('\n'), "{words}");
        let health = Health::default();
        for fault in [Fault::Refused("an invalid buffer".into()), Fault::Lost("gone".into()), fault] {
            health.note(fault);
        }
        assert_eq!(health.fault(), Some(Fault::Lost("gone".into())), "which is why it refuses, and why it has no room");
        assert!(Fault::Lost(in_one_line(" \n")).to_string().contains("does not say why"), "not an empty bracket");
    }
}
