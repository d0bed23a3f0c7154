//! Data of each body, pair and declared contact of a group during a run of the impact model.

use crate::dynamics::free_flight::flight::{Flight, FreeMotion};
use crate::dynamics::impact2d::State;
use crate::dynamics::impact2d::closing::planar_gap::PlanarSite;
use crate::dynamics::trajectory::segment::Segment;
use crate::dynamics::world::site_geometry::SiteGeometry;

/// The motion in force.
#[derive(Clone, Debug)]
pub(in crate::dynamics) enum Motion {
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
    pub free_motion: FreeMotion,
    /// Motion in force.
    pub motion: Motion,
    /// Motion so far.
    pub segments: Vec<Segment>,
    /// Start of the motion in force \[s\].
    pub since: f64,
    /// State among a–f.
    pub state: State,
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
#[expect(
    clippy::struct_excessive_bools,
    reason = "independent conditions of one point, each set and cleared by another event"
)]
pub(in crate::dynamics::impact2d) struct SiteTrack {
    /// Number in the model.
    pub number: usize,
    /// Which side of the pair owns the node, and which the face; none for an abutment.
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
    /// Whether it is behind the plane of the face beside the face, and has not been in front since.
    pub beside: bool,
    /// When it is in front of the face again on the trajectories in force \[s\].
    pub in_front_at: Option<f64>,
    /// Depth behind the face at which a point that has lifted off hits again \[m\].
    pub depth: f64,
}

impl SiteTrack {
    /// Arms a point that is in front of its face: its next crossing is an impact.
    pub(in crate::dynamics::impact2d) fn arm(&mut self) {
        (self.armed, self.lifted, self.beside) = (true, false, false);
    }
}

#[cfg(test)]
mod tests {
    use crate::dynamics::impact2d::example;

    #[test]
    fn an_armed_point_is_neither_lifted_nor_beside_its_face() {
        let mut world = example::world(example::at_wall(|_| ()));
        let site = &mut world.sites[0];
        (site.armed, site.lifted, site.beside, site.kept) = (false, true, true, true);
        site.arm();
        assert_eq!([site.armed, site.lifted, site.beside, site.kept], [true, false, false, true], "kept stays");
    }
}
