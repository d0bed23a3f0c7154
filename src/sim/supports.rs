//! Supports that a run lost.

use glam::DVec3;

use super::History;

/// A support that was lost.
#[derive(Clone, Debug, PartialEq)]
pub struct LostSupport {
    /// The bearing, `deck.bearing1`.
    pub name: String,
    /// When \[s\].
    pub t: f64,
    /// Where its point of the girder was, world \[m\].
    pub place: DVec3,
}

impl History {
    /// Supports that were lost up to `t`, in order of time.
    pub fn lost_supports(&self, t: f64) -> Vec<LostSupport> {
        let model = self.model();
        let lost = |link: usize| {
            let (device, phases) = (&model.links[link].device, self.link_phases(link));
            let (at, _) = phases.iter().find(|(_, phase)| device.is_lost(phase))?;
            let place = self.link(link, *at)?.ends[0];
            Some(LostSupport { name: model.links[link].name.clone(), t: *at, place })
        };
        let all = model.supports.iter().flatten().filter_map(|links| lost(*links.first()?));
        let mut all: Vec<LostSupport> = all.filter(|lost| lost.t <= t).collect();
        all.sort_by(|a, b| a.t.total_cmp(&b.t));
        all
    }

    /// The bearing of a girder that lost its support first, by its number in the girder, and when \[s\].
    pub fn first_lost_bearing(&self, girder: usize) -> Option<(usize, f64)> {
        let model = self.model();
        let lost = |(bearing, links): (usize, &Vec<usize>)| {
            let link = *links.first()?;
            let device = &model.links[link].device;
            let (at, _) = self.link_phases(link).iter().find(|(_, phase)| device.is_lost(phase))?;
            (*at <= self.end()).then_some((bearing, *at))
        };
        let supports = model.supports.get(girder)?;
        supports.iter().enumerate().filter_map(lost).min_by(|a, b| a.1.total_cmp(&b.1))
    }
}
