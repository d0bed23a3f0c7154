//! A group of bodies at t = 0, at rest as placed, with its facing pairs, open contacts and links; connected
//! components of bodies whose connections act.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::contact::NormalLaw;
use crate::dynamics::Model;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::penalty3d::constants::SIMULTANEOUS_PHASE;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::record::link_log::LinkLog;
use crate::dynamics::trajectory::stored_path::StoredPath;
use crate::dynamics::world::World;
use crate::dynamics::world::axial_gap::AxialGap;
use crate::dynamics::world::constants::{NOMINAL_FREQUENCY, NOMINAL_IMPACT_SPEED};
use crate::dynamics::world::site_geometry::SiteGeometry;
use crate::dynamics::world::tracks::{BodyTrack, ChangeCount, ContactTrack, LinkTrack, PairTrack, Trajectory};
use crate::scene::facing::Side;

impl World {
    /// The group of this number in the model.
    pub(in crate::dynamics) fn of(model: &Arc<Model>, group: usize) -> Self {
        let mut world = Self {
            model: Arc::clone(model),
            bodies: Vec::new(),
            pairs: Vec::new(),
            contacts: Vec::new(),
            links: Vec::new(),
            islands: Vec::new(),
        };
        world.gather(group);
        world
    }

    fn gather(&mut self, number: usize) {
        let model = Arc::clone(&self.model);
        let group = model.groups[number].as_slice();
        let pairs = model.group_pairs[number].as_slice();
        self.bodies.reserve_exact(group.len());
        self.pairs.reserve_exact(pairs.len());
        self.contacts.reserve_exact(pairs.iter().map(|&pair| model.pairs[pair].contacts.len()).sum());
        let slot = |side: Option<usize>| side.and_then(|b| group.binary_search(&b).ok());
        for &body in group {
            let system = BodyMotion::of(&model.bodies[body], &model.ground, model.duration);
            self.bodies.push(BodyTrack {
                body,
                system,
                now: Trajectory::Placed,
                path: StoredPath::default(),
                pairs: Vec::new(),
                links: Vec::new(),
            });
        }
        for &number in pairs {
            let pair = &model.pairs[number];
            let slots = pair.bodies.map(slot);
            let from = self.contacts.len();
            for site in pair.contacts.clone() {
                let owners = [model.contacts[site].node_body, model.contacts[site].face_body].map(slot);
                self.contacts.push(ContactTrack {
                    site,
                    pair: self.pairs.len(),
                    slots: owners,
                    sections: model.sections(site),
                    geometry: SiteGeometry::of(&model, site),
                    rivals: Vec::new(),
                    state: Contact::Open { armed: true },
                    closing: None,
                    rearmed_at: None,
                    log: ContactLog::default(),
                    changes: ChangeCount::default(),
                });
            }
            for slot in slots.into_iter().flatten() {
                self.bodies[slot].pairs.push(self.pairs.len());
            }
            let mass = pair.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
            let simultaneity = SIMULTANEOUS_PHASE / pair.law.normal.frequency(mass, NOMINAL_IMPACT_SPEED);
            let contacts = from..self.contacts.len();
            let sites: Vec<_> = self.contacts[from..].iter().map(|track| (track.site, track.geometry)).collect();
            let axial = AxialGap::of(&model, number, &sites);
            let sections = [pair.first, pair.second].map(|side| match side {
                Side::Girder(body, end) => model.bodies[body].section(end),
                Side::Abutment(_) => 0,
            });
            self.pairs.push(PairTrack { pair: number, slots, sections, contacts, sharers: 0, simultaneity, axial });
        }
        self.find_rivals(pairs);
        for &number in &model.group_links[number] {
            self.add_link(&model, number, model.links[number].bodies.map(slot));
        }
    }

    fn add_link(&mut self, model: &Model, number: usize, slots: [Option<usize>; 2]) {
        for slot in slots.into_iter().flatten() {
            self.bodies[slot].links.push(self.links.len());
        }
        let link = &model.links[number];
        let frames = link.frames(|_| None);
        let phase = link.device.initial(&link.motion([&frames[0], &frames[1]]).0);
        let stiffness = link.device.stiffness_bound(&phase);
        let mass = link.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
        // A device without stiffness has no time scale; a nominal frequency stands for it.
        let frequency = if stiffness > 0.0 { (stiffness / mass).sqrt() } else { NOMINAL_FREQUENCY };
        let (simultaneity, log) = (SIMULTANEOUS_PHASE / frequency, LinkLog::default());
        self.links.push(LinkTrack { link: number, slots, phase, begins: None, simultaneity, log });
    }

    /// Enters in each contact the other contacts of its node, where an end is in more than one pair.
    fn find_rivals(&mut self, pairs: &[usize]) {
        let model = Arc::clone(&self.model);
        let mut sides: Vec<_> = pairs.iter().flat_map(|&n| [model.pairs[n].first, model.pairs[n].second]).collect();
        sides.sort_unstable();
        if sides.windows(2).all(|two| two[0] != two[1]) {
            return;
        }
        let mut nodes: BTreeMap<(Option<usize>, &str), Vec<usize>> = BTreeMap::new();
        for (contact, track) in self.contacts.iter().enumerate() {
            nodes.entry((track.slots[0], &model.contacts[track.site].node)).or_default().push(contact);
        }
        for same in nodes.values().filter(|same| same.len() > 1) {
            for &contact in same {
                self.contacts[contact].rivals = same.iter().copied().filter(|&other| other != contact).collect();
            }
        }
    }

    /// Names of bodies by their slots.
    pub(in crate::dynamics) fn names(&self, slots: &[usize]) -> String {
        let name = |&slot: &usize| self.model.bodies[self.bodies[slot].body].name.as_str();
        slots.iter().map(name).collect::<Vec<_>>().join(", ")
    }

    /// Numbers of the pairs of these bodies, ascending.
    pub(in crate::dynamics) fn pairs_of(&self, slots: &[usize]) -> Vec<usize> {
        let mut pairs: Vec<usize> = slots.iter().flat_map(|&slot| self.bodies[slot].pairs.iter().copied()).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    /// Numbers of the links of these bodies, ascending.
    pub(in crate::dynamics) fn links_of(&self, slots: &[usize]) -> Vec<usize> {
        let mut links: Vec<usize> = slots.iter().flat_map(|&slot| self.bodies[slot].links.iter().copied()).collect();
        links.sort_unstable();
        links.dedup();
        links
    }

    /// Whether a link's force acts.
    pub(in crate::dynamics) fn link_acts(&self, link: usize) -> bool {
        let LinkTrack { link, phase, .. } = &self.links[link];
        self.model.links[*link].device.acts(phase)
    }

    fn pair_acts(&self, pair: usize) -> bool {
        self.pairs[pair].contacts.clone().any(|c| self.contacts[c].state.closed().is_some())
    }

    /// Slots at both ends of every connection of a body whose force acts: pairs with a closed contact, then links.
    fn joined_at(&self, slot: usize) -> impl Iterator<Item = [Option<usize>; 2]> + '_ {
        let body = &self.bodies[slot];
        let pairs = body.pairs.iter().filter(|&&pair| self.pair_acts(pair)).map(|&pair| self.pairs[pair].slots);
        let links = body.links.iter().filter(|&&link| self.link_acts(link)).map(|&link| self.links[link].slots);
        pairs.chain(links)
    }

    /// Connected components of `slots` under connections whose force acts, as positions in `slots`.
    pub(in crate::dynamics) fn joined(&self, slots: &[usize]) -> Vec<Vec<usize>> {
        let mut label: Vec<usize> = (0..slots.len()).collect();
        let position = |slot: usize| slots.binary_search(&slot).ok();
        for &slot in slots {
            for ends in self.joined_at(slot) {
                if let [Some(a), Some(b)] = ends.map(|s| s.and_then(position)) {
                    let (low, high) = (label[a].min(label[b]), label[a].max(label[b]));
                    label.iter_mut().filter(|l| **l == high).for_each(|l| *l = low);
                }
            }
        }
        let mut groups: Vec<Vec<usize>> = vec![Vec::new(); slots.len()];
        for (i, &l) in label.iter().enumerate() {
            groups[l].push(i);
        }
        groups.retain(|g| !g.is_empty());
        groups
    }

    /// Whether any connection's force acts on a body.
    pub(in crate::dynamics) fn is_joined(&self, slot: usize) -> bool {
        self.joined_at(slot).next().is_some()
    }
}
