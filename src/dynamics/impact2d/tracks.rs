//! Data of each body, pair and declared contact of a group during a run of the impact model.

use std::sync::Arc;

use crate::dynamics::free_flight::flight::{Flight, FreeMotion};
use crate::dynamics::impact2d::GirderState;
use crate::dynamics::impact2d::closing::planar_gap::PlanarSite;
use crate::dynamics::trajectory::segment::Segment;
use crate::dynamics::world::site_geometry::SiteGeometry;

/// Trajectory in force of a body.
#[derive(Clone, Debug)]
pub(in crate::dynamics) enum Trajectory {
    /// Free flight.
    Flight(Flight),
    /// Lasting contact: its number, and the place of the body in it.
    Lasting(usize, usize),
}

/// A body of the group.
#[derive(Debug)]
pub(in crate::dynamics) struct BodyTrack {
    /// Number in the model.
    pub body: usize,
    /// Free motion.
    pub free_motion: Arc<FreeMotion>,
    /// Motion in force.
    pub motion: Trajectory,
    /// Motion so far.
    pub segments: Vec<Segment>,
    /// Start of the motion in force \[s\].
    pub since: f64,
    /// State among a–f.
    pub state: GirderState,
    /// Pairs of the body.
    pub pairs: Vec<usize>,
}

/// A pair of the group.
#[derive(Debug)]
pub(in crate::dynamics::impact2d) struct PairTrack {
    /// Number in the model.
    pub number: usize,
    /// Slots of its bodies; none for an abutment.
    pub slots: [Option<usize>; 2],
    /// Its declared contacts.
    pub sites: std::ops::Range<usize>,
    /// Whether the event that is due is an impact; else the search is continued from there.
    pub impact_due: bool,
}

/// A declared contact of the group.
#[derive(Debug)]
pub(in crate::dynamics::impact2d) struct SiteTrack {
    /// Number in the model.
    pub number: usize,
    /// Numbers (0, 1) of the sides of the pair with node and face; `None` for an abutment.
    pub sides: [Option<usize>; 2],
    /// Lengths of the contact as placed.
    pub spot: SiteGeometry,
    /// Geometry of the contact as placed, in plan.
    pub geometry: PlanarSite,
    /// Whether it is in lasting contact.
    pub kept: bool,
    /// Whether its next crossing of the face is an impact.
    pub armed: bool,
    /// Whether it has lifted off without normal speed.
    pub lifted: bool,
    /// Since when it is behind the plane of the face beside the face, without having been in front since \[s\].
    pub beside: Option<f64>,
    /// Earlier stretches of that \[s\].
    pub was_beside: Vec<[f64; 2]>,
    /// Time at which it is in front of the face again on the trajectories in force \[s\].
    pub in_front_at: Option<f64>,
    /// Depth behind the face at which a point that has lifted off hits again \[m\].
    pub depth: f64,
}

impl SiteTrack {
    /// Arms a point that is in front of its face from `t` on: its next crossing is an impact.
    pub(in crate::dynamics::impact2d) fn arm(&mut self, t: f64) {
        self.was_beside.extend(self.beside.take().map(|from| [from, t]));
        (self.armed, self.lifted) = (true, false);
    }

    /// Disarms a point that is beside its face from `t` on.
    pub(in crate::dynamics::impact2d) fn pass_beside(&mut self, t: f64) {
        self.beside = self.beside.or(Some(t));
        (self.armed, self.lifted) = (false, false);
    }
}

#[cfg(test)]
mod tests {
    use crate::dynamics::impact2d::example;

    #[test]
    fn an_armed_point_is_neither_lifted_nor_beside_its_face() {
        let mut world = example::world(example::at_wall(|_| ()));
        let site = &mut world.sites[0];
        (site.lifted, site.kept) = (true, true);
        site.pass_beside(0.5);
        site.pass_beside(0.7);
        assert_eq!((site.armed, site.lifted, site.beside), (false, false, Some(0.5)), "since it passed first");
        site.arm(2.0);
        assert_eq!((site.armed, site.lifted, site.beside, site.kept), (true, false, None, true), "kept stays");
        site.arm(3.0);
        assert_eq!(site.was_beside, [[0.5, 2.0]], "once");
    }
}
