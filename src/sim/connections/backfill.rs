//! Readings of the soil behind backwalls.

use glam::DVec3;

use crate::dynamics::model::compiled_model::Backwall;
use crate::scene::ResolvedBackfill;
use crate::sim::connections::view::Connections;

/// Part of the greatest push that a gap is by rounding alone \[–\]: a difference of two numbers of its size.
const ROUNDED: f64 = 1e-12;

/// A backwall at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallNow {
    /// Displacement of the wall \[m\].
    pub displacement: DVec3,
    /// The soil behind it; `None` of an abutment that moves as one with its ground.
    pub soil: Option<SoilNow>,
}

/// The soil behind a backwall at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoilNow {
    /// Displacement of its front \[m\].
    pub front: DVec3,
    /// Its resistance \[N\].
    pub force: f64,
}

/// Largest push of the soil behind one abutment over a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BackfillReading {
    /// Number of the abutment in the scene.
    pub abutment: usize,
    /// Greatest push into the soil \[m\].
    pub push: f64,
    /// Time \[s\].
    pub t: f64,
    /// Resistance there, the greatest of the run \[N\].
    pub force: f64,
    /// `F_ult` \[N\].
    pub ultimate: f64,
    /// Height of the wall \[m\].
    pub height: f64,
    /// Gap that stays between the wall as placed and the soil, unloaded, at the end \[m\].
    pub remaining_gap: f64,
}

impl Connections<'_> {
    /// The backwall of an abutment at `t`, clamped to what was computed; `None` for one that stands.
    pub fn wall(self, abutment: usize, t: f64) -> Option<WallNow> {
        let Backwall { body, soil, inward } = (*self.history.model().walls.get(abutment)?)?;
        let displacement = self.history.motion(body, t).displacement;
        let Some(soil) = soil else {
            return Some(WallNow { displacement, soil: None });
        };
        let soil = self.link(soil, t)?;
        // The soil's front is at the wall, or stays where the wall has left it.
        let front = displacement + inward * soil.gap.max(0.0);
        Some(WallNow { displacement, soil: Some(SoilNow { front, force: -soil.force.dot(inward) }) })
    }

    /// Readings of the soil behind every backwall that moves, in the order of the abutments.
    pub fn backfill(self) -> Vec<BackfillReading> {
        (0..self.history.model().walls.len()).filter_map(|abutment| self.backfill_of(abutment)).collect()
    }

    fn backfill_of(self, abutment: usize) -> Option<BackfillReading> {
        let Backwall { body, soil, inward } = (*self.history.model().walls.get(abutment)?)?;
        let soil = soil?;
        let ResolvedBackfill { ultimate, height, .. } =
            self.history.scene().abutments.get(abutment)?.soil(self.history.scene())?;
        // Against the wall's own ground: the first of its coordinates.
        let push_at = |t: f64| self.history.state(body, t)[0];
        // The push on the envelope grows until the phase ends.
        let ends = self.link_phases(soil).iter().map(|(t, _)| *t).chain([self.history.end()]);
        let (t, push) = ends.map(|t| (t, push_at(t))).max_by(|a, b| a.1.total_cmp(&b.1))?;
        let (then, now) = (self.link(soil, t)?, self.link(soil, self.history.end())?);
        // F²/(2 K_ur) is stored: unloading by F/K_ur leaves the gap.
        let elastic = if now.acts { 2.0 * now.stored / now.force.length().max(f64::MIN_POSITIVE) } else { -now.gap };
        let (push, gap) = (push.max(0.0), push_at(self.history.end()) - elastic);
        Some(BackfillReading {
            abutment,
            push,
            t,
            // Of soil that was not reached −0.
            force: (-then.force.dot(inward)).max(0.0) + 0.0,
            ultimate,
            height,
            remaining_gap: if gap > ROUNDED * push { gap } else { 0.0 },
        })
    }
}
