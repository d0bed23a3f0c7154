//! A sweep of the scene that is filled in the background, coarse to fine: its rows so far, whether they are the scene's as it
//! is now, where the scene itself stands among them.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use super::work::{Job, News, Order, begin};
use crate::app::host::Wake;
use crate::scene::edit::Edit;
use crate::scene::overrides::Laid;
use crate::scene::{Scene, SceneErrors, ViewSettings, format};
use crate::study::sweep::{Measure, Nested, Plan, Row, own_value};

/// Request of a sweep.
pub(super) trait Asked: Clone + PartialEq {
    /// The keys with their values, and what is kept of each run.
    fn order(&self) -> Order;
}

/// A sweep as far as it has come out.
pub struct Swept<D> {
    pub(super) plan: Arc<Plan>,
    pub(super) draft: D,
    pub(super) grid: Nested,
    /// Results, by the number of the run.
    pub(super) rows: BTreeMap<usize, Row>,
    /// The scene with the first value of every key, as text: sweeps of the same text are the same.
    base: Option<String>,
}

impl<D> Swept<D> {
    /// Measure kept of each run, by its number.
    pub(super) fn measure(&self, number: usize) -> &'static Measure {
        self.plan.measures[number]
    }

    /// The run with these values of the keys, by their numbers, where it has come out.
    pub fn row<const N: usize>(&self, choice: [usize; N]) -> Option<&Row> {
        self.rows.get(&self.plan.run_of(&choice))
    }

    /// Value of a key by its number, in the unit of the key.
    pub(super) fn value_at(&self, axis: usize, number: usize) -> f64 {
        self.plan.axes[axis].values[number].parse().unwrap_or(f64::NAN)
    }

    /// Every key as in a run; none where there is no such run.
    pub(super) fn edit_to(&self, choice: &[usize]) -> Option<Edit> {
        let axes = || self.plan.axes.iter().zip(choice);
        let inside = axes().all(|(axis, value)| *value < axis.values.len());
        inside.then(|| Edit::Batch(axes().map(|(axis, value)| Edit::Set(axis.setting(*value))).collect()))
    }
}

/// A sweep in the background.
pub(super) struct Background<D> {
    /// Request computed last, or in work.
    asked: Option<D>,
    job: Option<Job>,
    swept: Option<Swept<D>>,
    problems: Option<SceneErrors>,
    /// Whether the sweep is of the scene as it is now.
    fits: bool,
    /// Value of each key in the present scene, where it is a number.
    own: Vec<Option<f64>>,
    wake: Wake,
}

impl<D> Default for Background<D> {
    fn default() -> Self {
        let wake: Wake = Arc::new(|| ());
        Self { asked: None, job: None, swept: None, problems: None, fits: false, own: Vec::new(), wake }
    }
}

impl<D: Asked> Background<D> {
    /// Tells who is woken when a thread has news.
    pub(super) fn set_wake(&mut self, wake: Wake) {
        self.wake = wake;
    }

    /// Request computed last, or in work.
    pub(super) fn asked(&self) -> Option<&D> {
        self.asked.as_ref()
    }

    /// Results so far.
    pub(super) fn swept(&self) -> Option<&Swept<D>> {
        self.swept.as_ref()
    }

    /// Why it cannot be computed.
    pub(super) fn problems(&self) -> Option<&SceneErrors> {
        self.problems.as_ref()
    }

    /// Whether it is of the scene as it is now.
    pub(super) fn fits(&self) -> bool {
        self.fits
    }

    /// Value of a key in the present scene, where it is a number.
    pub(super) fn own(&self, axis: usize) -> Option<f64> {
        self.own.get(axis).copied().flatten()
    }

    /// Runs that have come out and runs in all, while some are computed.
    pub(super) fn progress(&self) -> Option<[usize; 2]> {
        self.job.as_ref()?;
        Some(self.swept.as_ref().map_or([0, 1], |swept| [swept.rows.len(), swept.plan.runs()]))
    }

    /// State that determines the picture.
    pub(super) fn seen(&self) -> impl PartialEq + use<D> {
        let rows = self.swept.as_ref().map(|swept| swept.rows.len());
        (self.job.is_some(), rows, self.problems.clone(), self.fits)
    }

    /// Computes it of a scene whose records lie in `folder`.
    pub(super) fn compute(&mut self, asked: D, scene: &Scene, folder: &Path) {
        (self.problems, self.swept) = (None, None);
        self.job = Some(begin(scene.clone(), asked.order(), folder.to_owned(), self.wake.clone()));
        self.asked = Some(asked);
    }

    /// Begins no further run; what has come out stays.
    pub(super) fn stop(&mut self) {
        self.job = None;
    }

    /// Lets go of everything: it was of another scene.
    pub(super) fn forget(&mut self) {
        *self = Self { wake: self.wake.clone(), ..Self::default() };
    }

    /// The window is closed: what is kept is what came out, whether or not it is whole.
    pub(super) fn leave(&mut self) {
        self.stop();
        self.asked = self.swept.as_ref().map(|swept| swept.draft.clone());
    }

    /// Takes what threads have brought; `scene` is the scene as it is now.
    pub(super) fn poll(&mut self, scene: &Scene) {
        self.job.iter_mut().for_each(Job::go_on);
        while let Some(news) = self.job.as_ref().and_then(Job::take) {
            match news {
                News::Begun(plan) => {
                    let (Some(draft), Some(grid)) = (self.asked.clone(), Nested::of(&plan)) else { continue };
                    let base = base(&plan.scene, &plan);
                    self.swept = Some(Swept { plan, draft, grid, rows: BTreeMap::new(), base });
                    self.follow(scene);
                }
                News::Row(row) => self.swept.iter_mut().for_each(|swept| drop(swept.rows.insert(row.run, row.clone()))),
                News::Refused(errors) => (self.problems, self.job) = (Some(errors), None),
                News::Ended => self.job = None,
            }
        }
    }

    /// The scene is another one than before.
    pub(super) fn follow(&mut self, scene: &Scene) {
        let Some(swept) = self.swept.as_ref() else { return };
        self.fits = swept.base.is_some() && base(scene, &swept.plan) == swept.base;
        let laid = Laid::out(scene).ok();
        let own = |key: &str| laid.as_ref().and_then(|laid| own_value(laid, key));
        self.own = swept.plan.axes.iter().map(|axis| own(&axis.key)).collect();
    }

    /// Waits until it has come out (tests).
    pub(super) fn wait(&mut self, scene: &Scene) {
        while self.job.is_some() {
            self.poll(scene);
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
    }
}

/// A scene with the first value of every key, as text, but for what is only looked at.
fn base(scene: &Scene, plan: &Plan) -> Option<String> {
    let first: Vec<String> = plan.axes.iter().map(|axis| axis.setting(0)).collect();
    let plain =
        Scene { view: ViewSettings::default(), name: String::new(), description: String::new(), ..scene.clone() };
    Some(format::write(&Laid::out(&plain).ok()?.with(&first).ok()?))
}
