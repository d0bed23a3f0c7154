//! A group of bodies at t = 0, at rest as placed, with its facing pairs, open contacts and links.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::dynamics::locate::subdivision::GapClosing;
use crate::dynamics::model::compiled_model::Group;
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::dynamics::model::pair::Carrier;

use crate::contact::{ContactGeometry, NormalLaw};
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
use crate::dynamics::world::tracks::{
    BodyTrack, ChangeCount, ContactTrack, LinkTrack, PairTrack, SearchState, Trajectory,
};
use crate::dynamics::{ContactSite, Model};
use crate::scene::facing::SolidId;

/// Body and name of a node, and the two bodies of its contact.
type NodeOnBody<'a> = (Option<usize>, &'a str, [SolidId; 2]);

impl World {
    /// The group of this number in the model.
    pub(in crate::dynamics) fn of(model: &Arc<Model>, group: usize) -> Self {
        let mut world = Self {
            model: Arc::clone(model),
            bodies: Vec::new(),
            pairs: Vec::new(),
            contacts: Vec::new(),
            links: Vec::new(),
            blocks: Vec::new(),
            islands: Vec::new(),
        };
        world.gather(group);
        world
    }

    fn gather(&mut self, number: usize) {
        let model = Arc::clone(&self.model);
        let Group { bodies, pairs, links } = &model.groups[number];
        self.bodies.reserve_exact(bodies.len());
        self.pairs.reserve_exact(pairs.len());
        self.contacts.reserve_exact(pairs.iter().map(|&pair| model.pairs[pair].nodes().count()).sum());
        let slot = |side: Option<usize>| side.and_then(|b| bodies.binary_search(&b).ok());
        for &body in bodies {
            self.add_body(&model, body);
        }
        for &pair in pairs {
            self.add_pair(&model, pair, slot);
        }
        self.find_other_faces(pairs);
        for &number in links {
            self.add_link(&model, number, model.links[number].bodies.map(slot));
        }
        self.find_blocks();
    }

    fn add_body(&mut self, model: &Model, body: usize) {
        self.bodies.push(BodyTrack {
            body,
            free_motion: BodyMotion::of(&model.bodies[body], &model.ground, model.duration),
            block: None,
            now: Trajectory::Placed,
            path: StoredPath::default(),
            pairs: Vec::new(),
            links: Vec::new(),
        });
    }

    /// Adds a facing pair with its contacts; `slot` is the slot of a body by its number in the model.
    fn add_pair(&mut self, model: &Model, number: usize, slot: impl Fn(Option<usize>) -> Option<usize> + Copy) {
        let pair = &model.pairs[number];
        let slots = pair.bodies.map(slot);
        let from = self.contacts.len();
        for site in pair.nodes() {
            let owners = [model.sites[site].node_body, model.sites[site].face_body].map(slot);
            self.add_contact(model, site, owners);
        }
        self.find_corners(model, from);
        for slot in slots.into_iter().flatten() {
            self.bodies[slot].pairs.push(self.pairs.len());
        }
        let mass = pair.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
        let simultaneity = SIMULTANEOUS_PHASE / pair.law.normal.frequency(mass, NOMINAL_IMPACT_SPEED);
        let contacts = from..self.contacts.len();
        let sites: Vec<_> = self.contacts[from..].iter().map(|track| (track.site, track.geometry)).collect();
        let axial = AxialGap::of(model, number, &sites);
        let section =
            |i: usize| pair.bodies[i].map_or(0, |b| model.bodies[b].section_of(Carrier::of_face(pair.sides()[i])));
        let sections = [section(0), section(1)];
        let mut corner_sections: Vec<(usize, usize)> = Vec::new();
        for track in &self.contacts[from..] {
            for (slot, section) in track.slots.into_iter().zip(track.sections) {
                let Some(slot) = slot else { continue };
                let own = sections[usize::from(Some(slot) == slots[1])];
                if section != own && !corner_sections.contains(&(slot, section)) {
                    corner_sections.push((slot, section));
                }
            }
        }
        let meeting = if pair.met { model.meeting_of(pair) } else { None };
        self.pairs.push(PairTrack {
            model_pair: number,
            slots,
            sections,
            corner_sections,
            contacts,
            sharers: 0,
            simultaneity,
            axial,
            meeting,
            search_state: SearchState::Near,
            due: f64::INFINITY,
        });
    }

    /// Adds an open contact of the pair that is added next.
    fn add_contact(&mut self, model: &Model, site: usize, slots: [Option<usize>; 2]) {
        self.contacts.push(ContactTrack {
            site,
            pair: self.pairs.len(),
            slots,
            sections: model.sections(site),
            geometry: SiteGeometry::of(model, site),
            corners: None,
            other_faces: Vec::new(),
            state: Contact::Open { armed: true },
            divisor: 1.0,
            has_part: false,
            place: NodePlace::default(),
            found: GapClosing::NONE,
            log: ContactLog::default(),
            tolerated: 0.0,
            changes: ChangeCount::default(),
        });
    }

    /// Enters in each edge node among the contacts of one pair, from number `from` on, those of the ends of its edge.
    fn find_corners(&mut self, model: &Model, from: usize) {
        for contact in from..self.contacts.len() {
            let Some(edge) = &model.sites[self.contacts[contact].site].edge else { continue };
            let corner = |home: &ContactGeometry| {
                let is_there = |site: &ContactSite| site.edge.is_none() && site.geometry == *home;
                let rides = |other: usize| self.contacts[other].sections == self.contacts[contact].sections;
                (from..contact).find(|&other| is_there(&model.sites[self.contacts[other].site]) && rides(other))
            };
            let [first, second] = edge.homes().map(corner);
            self.contacts[contact].corners = first.zip(second).map(|(first, second)| [first, second]);
        }
    }

    fn add_link(&mut self, model: &Model, number: usize, slots: [Option<usize>; 2]) {
        for slot in slots.into_iter().flatten() {
            self.bodies[slot].links.push(self.links.len());
        }
        let link = &model.links[number];
        let frames = link.frames(|_, _| None);
        let phase = link.device.initial(&link.motion([&frames[0], &frames[1]]).0);
        let stiffness = link.device.stiffness_bound(&phase);
        let mass = link.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
        // A device without stiffness has no time scale; a nominal frequency stands for it.
        let frequency = if stiffness > 0.0 { (stiffness / mass).sqrt() } else { NOMINAL_FREQUENCY };
        let (simultaneity, log) = (SIMULTANEOUS_PHASE / frequency, LinkLog::default());
        self.links.push(LinkTrack { link: number, slots, phase, ends: None, omega: frequency, simultaneity, log });
    }

    /// Enters in each contact the other contacts of its node with faces of the same body, where an end is in more than one pair. In
    /// another body the node may be at the same time.
    fn find_other_faces(&mut self, pairs: &[usize]) {
        let model = Arc::clone(&self.model);
        let mut sides: Vec<_> = pairs.iter().flat_map(|&n| [model.pairs[n].first, model.pairs[n].second]).collect();
        sides.sort_unstable();
        if sides.windows(2).all(|two| two[0] != two[1]) {
            return;
        }
        let mut nodes: BTreeMap<NodeOnBody<'_>, Vec<usize>> = BTreeMap::new();
        // An edge node is another material point at each closing.
        let corners = self.contacts.iter().enumerate().filter(|(_, track)| model.sites[track.site].edge.is_none());
        for (contact, track) in corners {
            let solids = self.model_pair(track.pair).solids();
            nodes.entry((track.slots[0], &model.sites[track.site].node, solids)).or_default().push(contact);
        }
        for same in nodes.values().filter(|same| same.len() > 1) {
            for &contact in same {
                self.contacts[contact].other_faces = same.iter().copied().filter(|&other| other != contact).collect();
            }
        }
    }
}
