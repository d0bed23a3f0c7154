//! The map's window: what it is to show, the map that has come out so far.

use std::path::Path;

use super::background::{Asked, Background, Swept};
use super::offer;
use super::work::Order;
use crate::app::command::{MapAxis, MapCommand, MapDraft};
use crate::app::host::Wake;
use crate::scene::Scene;
use crate::scene::edit::Edit;
use crate::study::sweep::Row;

/// A map as far as it has come out.
pub(super) type Map = Swept<MapDraft>;

impl Asked for MapDraft {
    fn order(&self) -> Order {
        let vary = self.axes.each_ref().map(|axis| values(axis, self.cells));
        Order { vary: vary.into(), measures: vec![self.measure.to_owned()] }
    }
}

/// `KEY=LO..HI:N`.
fn values(axis: &MapAxis, cells: usize) -> String {
    let MapAxis { key, from, to, is_log } = axis;
    format!("{key}={from:?}..{to:?}:{cells}{}", if *is_log { ":log" } else { "" })
}

impl Map {
    /// The run that stands for a cell so far; none where nothing has come out near it.
    pub(super) fn standing_for(&self, cell: [usize; 2]) -> Option<&Row> {
        self.rows.get(&self.grid.standing_for(cell, |run| self.rows.contains_key(&run))?)
    }
}

/// The map's window.
#[derive(Default)]
pub struct Maps {
    /// Choices in the dialog, while it is open.
    pub(super) draft: Option<MapDraft>,
    pub(super) background: Background<MapDraft>,
}

impl Maps {
    /// Tells who is woken when a thread has news.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.background.set_wake(wake);
    }

    /// Choices in the dialog, while it is open.
    pub fn draft(&self) -> Option<&MapDraft> {
        self.draft.as_ref()
    }

    /// The map that has come out so far.
    pub fn map(&self) -> Option<&Map> {
        self.background.swept()
    }

    /// Whether the map is of the scene as it is now.
    pub fn fits(&self) -> bool {
        self.background.fits()
    }

    /// Values of both keys of the map in the present scene.
    pub(super) fn own(&self) -> [Option<f64>; 2] {
        [0, 1].map(|axis| self.background.own(axis))
    }

    /// Whether something else is to be shown than what was computed last.
    pub(super) fn is_due(&self) -> bool {
        self.draft.is_some() && self.draft.as_ref() != self.background.asked()
    }

    /// Runs that have come out and runs in all, while some are computed.
    pub fn progress(&self) -> Option<[usize; 2]> {
        self.background.progress()
    }

    /// State that determines the picture.
    pub(in crate::app) fn seen(&self) -> impl PartialEq + use<> {
        (self.draft.clone(), self.background.seen())
    }

    /// Does a command about a scene whose records lie in `folder`; answers with what is to be done to the scene.
    pub(in crate::app) fn apply(&mut self, command: MapCommand, scene: &Scene, folder: &Path) -> Option<Edit> {
        match command {
            MapCommand::Show(true) => {
                self.draft = self.draft.take().or_else(|| self.kept()).or_else(|| offer::first(scene));
            }
            MapCommand::Show(false) => {
                self.draft = None;
                self.background.leave();
            }
            MapCommand::Draft(draft) => self.draft = Some(draft),
            MapCommand::Compute => {
                if let Some(draft) = self.draft.clone() {
                    self.background.compute(draft, scene, folder);
                }
            }
            MapCommand::Cancel => self.background.stop(),
            MapCommand::Go(cell) => return self.map()?.edit_to(&cell),
        }
        None
    }

    /// Choices of the kept map.
    fn kept(&self) -> Option<MapDraft> {
        Some(self.map()?.draft.clone())
    }

    /// Takes what threads have brought; `scene` is the scene as it is now.
    pub(in crate::app) fn poll(&mut self, scene: &Scene) {
        self.background.poll(scene);
    }

    /// Another scene is worked on: its map is not computed yet, and what it is to show is chosen anew.
    pub(in crate::app) fn forget(&mut self) {
        self.draft = None;
        self.background.forget();
    }

    /// The scene is another one than before.
    pub(in crate::app) fn follow(&mut self, scene: &Scene) {
        self.background.follow(scene);
    }

    /// Waits until the map has come out (tests).
    pub fn wait(&mut self, scene: &Scene) {
        self.background.wait(scene);
    }
}
