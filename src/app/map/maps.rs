//! The map's window: what it is to show, the map that has come out so far, whether it is the scene's as that is now.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use super::offer;
use super::work::{Job, News, begin};
use crate::app::command::{MapCommand, MapDraft};
use crate::app::host::Wake;
use crate::scene::edit::Edit;
use crate::scene::overrides::Laid;
use crate::scene::{Scene, SceneErrors, ViewSettings, format};
use crate::study::sweep::{Measure, Nested, Plan, Row, own_value};

/// A map as far as it has come out.
pub struct Map {
    pub(super) plan: Arc<Plan>,
    pub(super) draft: MapDraft,
    pub(super) grid: Nested,
    /// What has come out, by the number of the run.
    pub(super) rows: BTreeMap<usize, Row>,
    /// The scene with the first value of both keys, as text: maps of the same text are the same.
    base: Option<String>,
}

impl Map {
    /// What is drawn.
    pub(super) fn measure(&self) -> &'static Measure {
        self.plan.measures[0]
    }

    /// The run of a cell, where it has come out.
    pub fn row(&self, cell: [usize; 2]) -> Option<&Row> {
        self.rows.get(&self.plan.run_of(&cell))
    }

    /// The run that stands for a cell so far; none where nothing has come out near it.
    pub(super) fn standing_for(&self, cell: [usize; 2]) -> Option<&Row> {
        self.rows.get(&self.grid.standing_for(cell, |run| self.rows.contains_key(&run))?)
    }

    /// Value of a key at a cell, in the unit of the key.
    pub(super) fn value_at(&self, axis: usize, cell: usize) -> f64 {
        self.plan.axes[axis].values[cell].parse().unwrap_or(f64::NAN)
    }
}

/// The map's window.
pub struct Maps {
    /// What it is to show, while it is open.
    pub(super) draft: Option<MapDraft>,
    /// What was computed last, or is.
    asked: Option<MapDraft>,
    job: Option<Job>,
    map: Option<Map>,
    problems: Option<SceneErrors>,
    /// Whether the map is of the scene as it is now.
    fits: bool,
    /// What both keys of the map are in the scene as it is now, where each is a number.
    own: [Option<f64>; 2],
    wake: Wake,
}

impl Default for Maps {
    fn default() -> Self {
        let wake: Wake = Arc::new(|| ());
        Self { draft: None, asked: None, job: None, map: None, problems: None, fits: false, own: [None; 2], wake }
    }
}

impl Maps {
    /// Tells who is woken when a thread has news.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.wake = wake;
    }

    /// What it is to show, while it is open.
    pub fn draft(&self) -> Option<&MapDraft> {
        self.draft.as_ref()
    }

    /// The map that has come out so far.
    pub fn map(&self) -> Option<&Map> {
        self.map.as_ref()
    }

    /// Why the map cannot be computed.
    pub(super) fn problems(&self) -> Option<&SceneErrors> {
        self.problems.as_ref()
    }

    /// Whether the map is of the scene as it is now.
    pub fn fits(&self) -> bool {
        self.fits
    }

    /// What both keys of the map are in the scene as it is now.
    pub(super) fn own(&self) -> [Option<f64>; 2] {
        self.own
    }

    /// Whether something else is to be shown than what was computed last.
    pub(super) fn is_due(&self) -> bool {
        self.draft.is_some() && self.draft != self.asked
    }

    /// Runs that have come out and runs in all, while some are computed.
    pub fn progress(&self) -> Option<[usize; 2]> {
        self.job.as_ref()?;
        Some(self.map.as_ref().map_or([0, 1], |map| [map.rows.len(), map.plan.runs()]))
    }

    /// What of it can be seen.
    pub(in crate::app) fn seen(&self) -> impl PartialEq + use<> {
        let rows = self.map.as_ref().map(|map| map.rows.len());
        (self.draft.clone(), self.job.is_some(), rows, self.problems.clone(), self.fits)
    }

    /// Does a command about a scene whose records lie in `folder`; answers with what is to be done to the scene.
    pub(in crate::app) fn apply(&mut self, command: MapCommand, scene: &Scene, folder: &Path) -> Option<Edit> {
        match command {
            MapCommand::Show(true) => {
                self.draft = self.draft.take().or_else(|| self.kept()).or_else(|| offer::first(scene));
            }
            MapCommand::Show(false) => (self.draft, self.asked, self.job) = (None, self.kept(), None),
            MapCommand::Draft(draft) => self.draft = Some(draft),
            MapCommand::Compute => self.compute(scene, folder),
            MapCommand::Cancel => self.job = None,
            MapCommand::Go(cell) => return self.edit_to(cell),
        }
        None
    }

    /// What the map that is kept shows.
    fn kept(&self) -> Option<MapDraft> {
        Some(self.map.as_ref()?.draft.clone())
    }

    fn compute(&mut self, scene: &Scene, folder: &Path) {
        let Some(draft) = self.draft.clone() else { return };
        (self.problems, self.map, self.asked) = (None, None, Some(draft.clone()));
        self.job = Some(begin(scene.clone(), draft, folder.to_owned(), self.wake.clone()));
    }

    /// Both keys as at a cell.
    fn edit_to(&self, cell: [usize; 2]) -> Option<Edit> {
        let map = self.map.as_ref()?;
        let inside = cell.iter().zip(map.grid.counts()).all(|(number, count)| *number < count);
        let settings = || map.plan.axes.iter().zip(cell).map(|(axis, value)| Edit::Set(axis.setting(value))).collect();
        inside.then(|| Edit::Batch(settings()))
    }

    /// Takes what threads have brought; `scene` is the scene as it is now.
    pub(in crate::app) fn poll(&mut self, scene: &Scene) {
        while let Some(news) = self.job.as_ref().and_then(|job| job.news.try_recv().ok()) {
            match news {
                News::Begun(plan) => {
                    let (Some(draft), Some(grid)) = (self.asked.clone(), Nested::of(&plan)) else { continue };
                    let base = base(&plan.scene, &plan);
                    self.map = Some(Map { plan, draft, grid, rows: BTreeMap::new(), base });
                    self.follow(scene);
                }
                News::Row(row) => self.map.iter_mut().for_each(|map| drop(map.rows.insert(row.run, row.clone()))),
                News::Refused(errors) => (self.problems, self.job) = (Some(errors), None),
                News::Ended => self.job = None,
            }
        }
    }

    /// The scene is another one than before.
    pub(in crate::app) fn follow(&mut self, scene: &Scene) {
        let Some(map) = self.map.as_ref() else { return };
        self.fits = map.base.is_some() && base(scene, &map.plan) == map.base;
        let laid = Laid::out(scene).ok();
        let own = |key: &str| laid.as_ref().and_then(|laid| own_value(laid, key));
        self.own = [0, 1].map(|axis| own(&map.plan.axes[axis].key));
    }

    /// Waits until the map has come out (tests).
    pub fn wait(&mut self, scene: &Scene) {
        while self.job.is_some() {
            self.poll(scene);
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
    }
}

/// A scene with the first value of both keys, as text, but for what is only looked at.
fn base(scene: &Scene, plan: &Plan) -> Option<String> {
    let first: Vec<String> = plan.axes.iter().map(|axis| axis.setting(0)).collect();
    let plain =
        Scene { view: ViewSettings::default(), name: String::new(), description: String::new(), ..scene.clone() };
    Some(format::write(&Laid::out(&plain).ok()?.with(&first).ok()?))
}
