//! Supports that a run lost.

use glam::DVec3;

use crate::scene::Kind;
use crate::sim::seats::view::Seats;

/// A support that was lost.
#[derive(Clone, Debug, PartialEq)]
pub struct LostSupport {
    /// The bearing, `deck.bearing1`.
    pub name: String,
    /// Time \[s\].
    pub t: f64,
    /// Place of its point of the girder then, world \[m\].
    pub place: DVec3,
}

/// Whether a bearing carries its girder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Carrying {
    /// It does.
    #[default]
    Yes,
    /// A slider in space that is lifted: it may carry again.
    Lifted,
    /// It has lost its support.
    Lost,
}

impl Seats<'_> {
    /// Whether each bearing of a girder carries it at `t`, clamped to what was computed; empty where all of them always do: none slides in
    /// space or can lose its support.
    pub fn carrying(self, girder: usize, t: f64) -> Vec<Carrying> {
        let Some(supports) = self.history.model().supports.get(girder) else { return Vec::new() };
        let of = |number: usize| {
            if t >= self.bearing_lost_at(girder, number) {
                return Carrying::Lost;
            }
            if self.is_lifted(girder, number, t) { Carrying::Lifted } else { Carrying::Yes }
        };
        (0..supports.len()).map(of).collect()
    }

    /// Supports that were lost up to `t`, in order of time.
    pub fn lost_supports(self, t: f64) -> Vec<LostSupport> {
        let lost = |link: usize| {
            let at = self.lost_at(link)?;
            let place = self.history.connections().link(link, at)?.ends[0];
            Some(LostSupport { name: self.history.model().links[link].name.clone(), t: at, place })
        };
        let all = self.history.model().supports.iter().flatten().filter_map(|links| lost(*links.first()?));
        let mut all: Vec<LostSupport> = all.filter(|lost| lost.t <= t).collect();
        all.sort_by(|a, b| a.t.total_cmp(&b.t));
        all
    }

    /// The bearing of a girder that lost its support first, by its number in the girder, and when \[s\].
    pub fn first_lost_bearing(self, girder: usize) -> Option<(usize, f64)> {
        let supports = self.history.model().supports.get(girder)?.iter().enumerate();
        let lost = supports.filter_map(|(bearing, links)| Some((bearing, self.lost_at(*links.first()?)?)));
        lost.filter(|(_, at)| *at <= self.history.end()).min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Time at which a girder has lost the support of its last bearing \[s\]; `None` while any bearing carries it.
    pub fn without_support(self, girder: usize) -> Option<f64> {
        let supports = self.history.model().supports.get(girder).filter(|supports| !supports.is_empty())?;
        let lost = supports.iter().map(|links| self.lost_at(*links.first()?).filter(|at| *at <= self.history.end()));
        lost.collect::<Option<Vec<f64>>>()?.into_iter().reduce(f64::max)
    }

    /// Until when the computed motion of a body is one: the end, or when a girder in plan has lost the support of its last bearing and
    /// falls. Extremes and touches are of the time until then \[s\].
    pub fn sound_until(self, body: usize) -> f64 {
        let falls = if self.history.model().kind == Kind::Planar { self.without_support(body) } else { None };
        falls.unwrap_or(f64::INFINITY).min(self.history.end())
    }

    /// Time at which a bearing of a girder lost its support \[s\]; infinite where it keeps it.
    pub fn bearing_lost_at(self, girder: usize, number: usize) -> f64 {
        let first = self.history.connections().bearing_links(girder, number).first();
        first.and_then(|link| self.lost_at(*link)).unwrap_or(f64::INFINITY)
    }

    /// Time at which the support that a link is was lost for good, in its last phase \[s\].
    fn lost_at(self, link: usize) -> Option<f64> {
        let (at, phase) = self.history.connections().link_phases(link).last()?;
        self.history.model().links[link].device.is_lost(phase).then_some(*at)
    }
}
