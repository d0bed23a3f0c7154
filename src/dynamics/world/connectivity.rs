//! Pairs and links of bodies, and the bodies that are joined by connections whose force acts.

use std::ops::Range;

use crate::dynamics::model::groups::components;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::LinkTrack;

impl World {
    /// Names of bodies by their slots.
    pub(in crate::dynamics) fn names(&self, slots: impl IntoIterator<Item = usize>) -> String {
        // Ground that moves as it is given is not what a run fails by.
        let bodies = slots.into_iter().map(|slot| self.bodies[slot].body);
        let of_motion = bodies.filter(|&body| !self.model.moves_as_given(body));
        of_motion.map(|body| self.model.bodies[body].name.as_str()).collect::<Vec<_>>().join(", ")
    }

    /// Numbers of the pairs of these bodies, ascending.
    pub(in crate::dynamics) fn pairs_of(&self, slots: &[usize]) -> Vec<usize> {
        let mut pairs: Vec<usize> = slots.iter().flat_map(|&slot| self.bodies[slot].pairs.iter().copied()).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    /// Numbers of the pairs of a pair's two bodies where these have met, which are in succession; of others the pair alone.
    pub(in crate::dynamics) fn meeting_of(&self, pair: usize) -> Range<usize> {
        let meeting = self.pairs[pair].meeting;
        if meeting.is_none() {
            return pair..pair + 1;
        }
        let same = |other: &usize| self.pairs[*other].meeting == meeting;
        let from = (0..pair).rev().take_while(same).last().unwrap_or(pair);
        let until = (pair..self.pairs.len()).take_while(same).last().unwrap_or(pair);
        from..until + 1
    }

    /// Whether a pair is the first of its two bodies, which have met.
    pub(in crate::dynamics) fn leads(&self, pair: usize) -> bool {
        pair == 0 || self.pairs[pair - 1].meeting != self.pairs[pair].meeting
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

    pub(super) fn pair_acts(&self, pair: usize) -> bool {
        self.pairs[pair].contacts.clone().any(|c| self.is_closed(c))
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
        let position = |slot: Option<usize>| slots.binary_search(&slot?).ok();
        let ends = slots.iter().flat_map(|&slot| self.joined_at(slot)).filter_map(|ends| match ends.map(position) {
            [Some(a), Some(b)] => Some([a, b]),
            _ => None,
        });
        components(slots.len(), ends)
    }

    /// Whether any connection's force acts on a body.
    pub(in crate::dynamics) fn is_joined(&self, slot: usize) -> bool {
        self.joined_at(slot).next().is_some()
    }
}

#[cfg(test)]
mod tests {
    use crate::dynamics::penalty3d::contact_state::Contact;
    use crate::dynamics::penalty3d::example::row;
    use crate::dynamics::world::example::planned;

    #[test]
    fn bodies_are_joined_while_a_contact_between_them_is_closed() {
        let mut world = planned(&row(), &[[0.0; 6]; 2]);
        assert_eq!(world.pairs_of(&[0, 1]), [0], "one pair, once");
        assert_eq!(world.joined(&[0, 1]), [vec![0, 1]], "touching");
        assert!(world.is_joined(0) && world.is_joined(1), "either of them");
        assert_eq!(world.joined(&[1]), [vec![0]], "what touches a body outside of the list is alone in it");
        for track in &mut world.contacts {
            track.state = Contact::Open { armed: true };
        }
        assert_eq!(world.joined(&[0, 1]), [vec![0], vec![1]], "apart");
        assert!(!world.is_joined(0), "no force acts");
        assert_eq!(world.names([1, 0]), format!("{}, {}", world.names([1]), world.names([0])));
    }
}
