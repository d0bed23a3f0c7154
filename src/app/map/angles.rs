//! Which way of shaking is worst: the scene turned through every angle of its motion, in the background.

use std::path::Path;

use super::background::{Asked, Background, Swept};
use super::work::Order;
use crate::app::command::AngleCommand;
use crate::app::host::Wake;
use crate::scene::edit::Edit;
use crate::scene::{Heading, ModelKind, Motion, RecordMotion, Scene};

/// Angles all round: every fifth degree, as the directions of a bidirectional analysis are commonly stepped.
const COUNT: usize = 72;

/// The key of a scene that turns its shaking, and what is kept of each run.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn {
    key: &'static str,
    /// First and last value \[degrees\]: a whole turn less one step.
    ends: [i32; 2],
    /// Direction of the shaking in plan, from world x, where the key is 0 \[degrees\].
    pub(super) zero: f64,
    measures: Vec<String>,
}

impl Asked for Turn {
    fn order(&self) -> Order {
        let [from, to] = self.ends;
        Order { vary: vec![format!("{}={from}..{to}:{COUNT}", self.key)], measures: self.measures.clone() }
    }
}

impl Turn {
    /// Of a scene; none where nothing shakes it in plan.
    fn of(scene: &Scene) -> Option<Self> {
        let measures = measures(scene);
        match &scene.motion {
            Motion::None => None,
            Motion::Record(record) if !record.components.is_empty() => {
                let zero = first_heading(record)? - record.x_azimuth_deg?;
                Some(Self { key: "motion.x_azimuth_deg", ends: [0, 355], zero, measures })
            }
            _ => Some(Self { key: "motion.angle_deg", ends: [-175, 180], zero: 0.0, measures }),
        }
    }
}

/// Direction of the first component in plan, from world x \[degrees\].
fn first_heading(record: &RecordMotion) -> Option<f64> {
    (0..record.components.len()).find_map(|n| match record.heading(n)? {
        Heading::InPlan(angle) => Some(angle),
        Heading::Up => None,
    })
}

/// Rotation; the largest force between two bodies, or impulse where hits take no time; the least seat where there is one.
fn measures(scene: &Scene) -> Vec<String> {
    let hit = if scene.model.kind == ModelKind::Impact { "max_impulse" } else { "max_total_force" };
    let seated = scene.girders.iter().any(|girder| girder.seat.plus.or(girder.seat.minus).is_some());
    let last = if seated { "least_seat" } else { "max_drift" };
    ["max_rotation", hit, last].map(str::to_owned).into()
}

/// The runs of every angle.
pub(super) type Turned = Swept<Turn>;

/// The window of the angles.
#[derive(Default)]
pub struct Angles {
    open: bool,
    pub(super) background: Background<Turn>,
}

impl Angles {
    /// Tells who is woken when a thread has news.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.background.set_wake(wake);
    }

    /// Whether it is shown.
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// Results so far.
    pub fn turned(&self) -> Option<&Swept<Turn>> {
        self.background.swept()
    }

    /// Whether it is of the scene as it is now.
    pub fn fits(&self) -> bool {
        self.background.fits()
    }

    /// Runs that have come out and runs in all, while some are computed.
    pub fn progress(&self) -> Option<[usize; 2]> {
        self.background.progress()
    }

    /// State that determines the picture.
    pub(in crate::app) fn seen(&self) -> impl PartialEq + use<> {
        (self.open, self.background.seen())
    }

    /// Does a command about a scene whose records lie in `folder`; answers with what is to be done to the scene.
    pub(in crate::app) fn apply(&mut self, command: AngleCommand, scene: &Scene, folder: &Path) -> Option<Edit> {
        match command {
            AngleCommand::Show(true) => {
                self.open = true;
                if !self.fits() && self.progress().is_none() {
                    self.compute(scene, folder);
                }
            }
            // What is on its way goes on: the window may be closed while it fills.
            AngleCommand::Show(false) => self.open = false,
            AngleCommand::Compute => self.compute(scene, folder),
            AngleCommand::Cancel => self.background.stop(),
            AngleCommand::Go(number) => return self.turned()?.edit_to(&[number]),
        }
        None
    }

    fn compute(&mut self, scene: &Scene, folder: &Path) {
        if let Some(turn) = Turn::of(scene) {
            self.background.compute(turn, scene, folder);
        }
    }

    /// Takes what threads have brought; `scene` is the scene as it is now.
    pub(in crate::app) fn poll(&mut self, scene: &Scene) {
        self.background.poll(scene);
    }

    /// Another scene is worked on.
    pub(in crate::app) fn forget(&mut self) {
        self.open = false;
        self.background.forget();
    }

    /// The scene is another one than before.
    pub(in crate::app) fn follow(&mut self, scene: &Scene) {
        self.background.follow(scene);
    }

    /// Waits until every angle has come out (tests).
    pub fn wait(&mut self, scene: &Scene) {
        self.background.wait(scene);
    }
}

/// Whether a scene can be turned.
pub(super) fn can_turn(scene: &Scene) -> bool {
    Turn::of(scene).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::study::sweep::Plan;

    #[test]
    fn every_preset_that_shakes_can_be_turned_all_round_once() {
        for preset in presets::all() {
            let scene = presets::load(preset.name).expect("ships");
            let Some(turn) = Turn::of(&scene) else {
                assert!(matches!(scene.motion, Motion::None), "{}: shakes and cannot be turned", preset.name);
                continue;
            };
            let order = turn.order();
            let plan = Plan::new(scene, &order.vary, &order.measures, Box::new(|_| Ok(()))).expect("a sweep");
            let values = plan.axes[0].numbers().expect("numbers");
            assert_eq!(values.len(), COUNT, "{}", preset.name);
            assert!(
                values.windows(2).all(|two| two[1] - two[0] == 360.0 / COUNT as f64),
                "{}: {values:?}",
                preset.name
            );
        }
    }
}
