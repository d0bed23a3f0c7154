//! Histories and spectra of the ground motion that is shown, computed on a thread when they are looked at.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};

use crate::app::command::QuakeCommand;
use crate::app::host::{Wake, spawn};
use crate::app::run::answer::Answer;
use crate::sim::History;
use crate::study::ground::{Component, Shaker, components};

/// A girder's own period along one of its axes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct OwnPeriod {
    /// Girder and axis: `deck x`.
    pub name: String,
    /// \[s\].
    pub period: f64,
}

/// Everything that is shown of one ground motion.
#[derive(Clone, Debug)]
pub struct Shaken {
    /// Its components.
    pub components: Vec<Component>,
}

/// The window of the ground motion.
pub struct Shaking {
    open: bool,
    /// Number of the component that is shown.
    pub(super) component: usize,
    /// Of which motion it is.
    of: Option<Shaker>,
    job: Option<Receiver<Shaken>>,
    shaken: Option<Shaken>,
    wake: Wake,
}

impl Default for Shaking {
    fn default() -> Self {
        let wake: Wake = Arc::new(|| ());
        Self { open: false, component: 0, of: None, job: None, shaken: None, wake }
    }
}

impl Shaking {
    /// Tells who is woken when a thread has news.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.wake = wake;
    }

    /// Whether it is shown.
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// Results, once they have been computed.
    pub fn shaken(&self) -> Option<&Shaken> {
        self.shaken.as_ref()
    }

    /// Whether it is being computed.
    pub fn is_computing(&self) -> bool {
        self.job.is_some()
    }

    /// State that determines the picture.
    pub(in crate::app) fn seen(&self) -> impl PartialEq + use<> {
        (self.open, self.component, self.job.is_some(), self.shaken.is_some())
    }

    /// Does a command.
    pub(in crate::app) fn apply(&mut self, command: QuakeCommand) {
        match command {
            QuakeCommand::Show(open) => self.open = open,
            QuakeCommand::Component(number) => self.component = number,
        }
    }

    /// Takes what a thread has brought, and begins anew where the motion of the answer is another one.
    pub(in crate::app) fn follow(&mut self, answer: Option<&Answer>) {
        if let Some(shaken) = self.job.as_ref().and_then(|job| job.try_recv().ok()) {
            (self.shaken, self.job) = (Some(shaken), None);
        }
        let Some(answer) = answer.filter(|_| self.open) else { return };
        let ground = &answer.history.model().ground;
        if self.of.as_ref() != Some(ground) {
            self.of = Some(ground.clone());
            self.job = Some(self.begin(ground.clone(), answer.history.end()));
        }
    }

    fn begin(&self, ground: Shaker, end: f64) -> Receiver<Shaken> {
        let ((send, done), wake) = (channel(), self.wake.clone());
        // It ends by itself.
        let _ = spawn(move || {
            // Nobody listens any more where another motion is asked for.
            let _ = send.send(Shaken { components: components(&ground, end) });
            wake();
        });
        done
    }

    /// Waits until it has been computed (tests).
    pub fn wait(&mut self) {
        if let Some(job) = self.job.take() {
            self.shaken = job.recv().ok().or(self.shaken.take());
        }
    }
}

/// The own periods of every girder on its bearings, along its axes and in rotation; none where a girder flies.
pub(super) fn own_periods(history: &History) -> Vec<OwnPeriod> {
    let of = |(girder, body): (usize, &crate::dynamics::Body)| {
        let omega = history.connections().bearing_quantities(girder).omega;
        let named = omega.into_iter().zip(["x", "y", "θ"]);
        let own = named.filter(|(omega, _)| *omega > 0.0 && omega.is_finite());
        own.map(|(omega, axis)| OwnPeriod {
            name: format!("{} {axis}", body.name),
            period: std::f64::consts::TAU / omega,
        })
        .collect::<Vec<_>>()
    };
    history.model().girders().iter().enumerate().filter(|(_, body)| !body.bearings.is_empty()).flat_map(of).collect()
}
