//! Body to which a seat is fixed, and its motion.

use glam::DVec3;

use crate::geometry::{End, Prism};
use crate::motion::support::SupportMotion;
use crate::scene::StandsOn;
use crate::sim::History;

/// Ground or pier that a seat is fixed to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SeatOn {
    /// The ground of reference.
    Ground,
    /// Ground that moves otherwise.
    Moved(SupportMotion),
    /// The pier of this number among the bodies.
    Pier(usize),
}

impl SeatOn {
    pub(in crate::sim) fn of(history: &History, girder: usize, end: End) -> Self {
        let (scene, model) = (history.scene(), history.model());
        let on = scene.standing_under(&scene.girders[girder], end).unwrap_or(StandsOn::Ground);
        if let StandsOn::Pier(number) = on {
            return model.piers.get(number).map_or(Self::Ground, |pier| Self::Pier(pier.body));
        }
        let body = &model.bodies[girder];
        let middle = Prism::end_corners(end).map(|corner| body.prism.plan_corners()[corner]);
        let place = body.home + body.axes * (0.5 * (middle[0] + middle[1])).extend(0.0);
        let moved = model.moving.as_ref().and_then(|moving| moving.supports.under(on, place));
        moved.map_or(Self::Ground, Self::Moved)
    }

    /// Displacement, rotation about the vertical, and where the axis of that is; nothing for the ground of reference.
    pub(in crate::sim) fn at(self, history: &History, t: f64) -> Option<(DVec3, f64, DVec3)> {
        match self {
            Self::Ground => None,
            Self::Moved(motion) => Some((history.model().moving.as_ref()?.displacement(motion, t), 0.0, DVec3::ZERO)),
            Self::Pier(pier) => {
                let cap = history.motion(pier, t);
                Some((cap.displacement, cap.theta, history.model().bodies[pier].home))
            }
        }
    }
}
