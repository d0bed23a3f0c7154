//! The vertical side of a girder in space: what its bearings carry, where they lift or pull, and how far it tilts.

use rayon::prelude::*;

use crate::contact::Frame;
use crate::dynamics::Body;
use crate::dynamics::connection::Connection;
use crate::scene::Kind;
use crate::sim::looks;
use crate::sim::peaks::largest;
use crate::sim::readings::first;
use crate::sim::report::{Extreme, Uplift, Upright};
use crate::sim::seats::view::Seats;

/// Part of the load at rest below which a bearing carries nothing \[–\]: of a slider that is lifted rounding is left.
const NOTHING: f64 = 1e-9;
/// Tilt from which a girder has tipped \[°\]. Chosen: a road falls to the side by less than 6°.
pub(in crate::sim) const TIPPED: f64 = 10.0;

impl<'a> Seats<'a> {
    /// Vertical force of a bearing on its girder, upwards \[N\]; 0 in a planar scene, and of a bearing that is not there.
    pub fn bearing_load(self, girder: usize, number: usize, t: f64) -> f64 {
        let known = self.history.model().girders().get(girder).is_some_and(|body| number < body.bearings.len());
        if self.history.model().kind == Kind::Planar || !known {
            return 0.0;
        }
        let t = t.clamp(0.0, self.history.end());
        self.load_of(girder, number, (t, &self.history.frame(girder, t)))
    }

    /// Whether a bearing is a slider in space that carries nothing at `t`.
    pub(in crate::sim) fn is_lifted(self, girder: usize, number: usize, t: f64) -> bool {
        self.slides(girder, number) && self.history.model().kind == Kind::Spatial && {
            let at_rest = self.history.model().bodies[girder].bearings[number].preload.z;
            self.bearing_load(girder, number, t) <= NOTHING * at_rest.abs()
        }
    }

    /// Whether a bearing is a slider, which can lift.
    fn slides(self, girder: usize, number: usize) -> bool {
        let (connections, links) = (self.history.connections(), &self.history.model().links);
        connections.bearing_links(girder, number).iter().any(|&link| links[link].device.lifts())
    }

    fn load_of(self, girder: usize, number: usize, (t, frame): (f64, &Frame)) -> f64 {
        let bearing = &self.history.model().bodies[girder].bearings[number];
        let motion = self.history.connections().bearing_motion((girder, bearing), (t, frame));
        let links = self.history.connections().bearing_links(girder, number).iter();
        let of_links: f64 = links.filter_map(|&link| Some(self.history.connections().link(link, t)?.force.z)).sum();
        bearing.preload.z + bearing.force(&(), &motion).z + of_links
    }

    /// Tilt of a girder in space, and its bearings that stopped carrying, until a support was lost: linear ones and lead rubber hold the
    /// girder down then, sliders lift. `None` in a planar scene.
    pub fn upright(self, girder: usize) -> Option<&'a Upright> {
        self.uprights().get(girder)
    }

    /// Tilt and uplifts of every girder, by its number; empty in a planar scene.
    pub fn uprights(self) -> &'a [Upright] {
        self.history.found.uprights.get_or_init(|| {
            let girders =
                if self.history.model().kind == Kind::Spatial { self.history.model().girders().len() } else { 0 };
            (0..girders).into_par_iter().map(|girder| self.find_upright(girder)).collect()
        })
    }

    fn find_upright(self, girder: usize) -> Upright {
        let body = &self.history.model().bodies[girder];
        let times = looks::of_body(self.history, girder);
        let frames: Vec<Frame> = times.iter().map(|&t| self.history.frame(girder, t)).collect();
        let tilts: Vec<f64> = frames.iter().map(|frame| tilt_of(body, frame)).collect();
        let at = (0..times.len()).fold(0, |most, i| if tilts[i] > tilts[most] { i } else { most });
        let around = &times[at.saturating_sub(1)..(at + 2).min(times.len())];
        let tilt = largest(around, &|t| tilt_of(body, &self.history.frame(girder, t)));
        let until = self.first_lost_bearing(girder).map_or(f64::INFINITY, |(_, t)| t);
        let standing = times.iter().take_while(|t| **t < until).count();
        let looks = (&times[..standing], &frames[..standing]);
        let mut uplifts: Vec<Uplift> =
            (0..body.bearings.len()).filter_map(|number| self.uplift_of((girder, number), looks)).collect();
        uplifts.sort_by(|a, b| a.t.total_cmp(&b.t));
        Upright { tilt, uplifts }
    }

    fn uplift_of(self, (girder, number): (usize, usize), (times, frames): (&[f64], &[Frame])) -> Option<Uplift> {
        let body = &self.history.model().bodies[girder];
        let at_rest = body.bearings[number].preload.z;
        if at_rest == 0.0 {
            return None;
        }
        let bound = NOTHING * at_rest.abs();
        let load = |t: f64| self.load_of(girder, number, (t, &self.history.frame(girder, t)));
        let seen = times.iter().zip(frames).map(|(&t, frame)| self.load_of(girder, number, (t, frame)));
        if seen.fold(f64::INFINITY, f64::min) > bound {
            return None;
        }
        let t = first(times, self.history.end(), &|t| bound - load(t))?;
        let pull = largest(times, &|t| -load(t));
        let pull = Extreme { value: if pull.value > bound { pull.value } else { 0.0 }, ..pull };
        let lifts = self.slides(girder, number);
        Some(Uplift { name: format!("{}.bearing{}", body.name, number + 1), t, pull, lifts, load: at_rest })
    }

    /// Time at which a girder has first tipped, and its largest tilt \[s, rad\]; `None` where it stays upright.
    pub fn tipped(self, girder: usize) -> Option<(f64, f64)> {
        let most = self.upright(girder)?.tilt;
        if most.value <= TIPPED.to_radians() {
            return None;
        }
        let body = &self.history.model().bodies[girder];
        let beyond = |t: f64| tilt_of(body, &self.history.frame(girder, t)) - TIPPED.to_radians();
        Some((first(&looks::of_body(self.history, girder), self.history.end(), &beyond)?, most.value))
    }
}

/// Angle of the body's third axis from the vertical, placed upright \[rad\].
fn tilt_of(body: &Body, frame: &Frame) -> f64 {
    let up = frame.turn(body.axes.z_axis);
    up.truncate().length().atan2(up.z)
}
