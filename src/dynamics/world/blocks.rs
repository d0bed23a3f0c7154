//! Linear blocks of a group: bodies that linear bearings join for ever, which move together in closed form while nothing else acts on them
//! (`docs/physics.md#free-motion-of-bodies-that-bearings-join`).

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::model::groups::components;
use crate::dynamics::model::linear_block::{BlockMember, Joint, LinearBlock};
use crate::dynamics::world::World;
use crate::dynamics::world::constants::MOST_BLOCK_COORDINATES;
use crate::dynamics::world::tracks::LinkTrack;

impl World {
    /// Finds the blocks of the group and enters them in the tracks of their bodies.
    pub(super) fn find_blocks(&mut self) {
        let model = Arc::clone(&self.model);
        let linear = |track: &&LinkTrack| model.links[track.link].device.is_linear();
        let ends = self.links.iter().filter(linear).filter_map(|track| match track.slots {
            [Some(a), Some(b)] => Some([a, b]),
            _ => None,
        });
        for slots in components(self.bodies.len(), ends) {
            if let Some(block) = (slots.len() > 1).then(|| self.block(&model, &slots)).flatten() {
                let block = Arc::new(block);
                for (member, &slot) in slots.iter().enumerate() {
                    let free_motion = BodyMotion::Custom(Arc::new(BlockMember { block: Arc::clone(&block), member }));
                    (self.bodies[slot].free_motion, self.bodies[slot].block) =
                        (Some(free_motion), Some(self.blocks.len()));
                }
                self.blocks.push(slots);
            }
        }
    }

    /// The block of these bodies; `None` without a closed form, or with more than [`MOST_BLOCK_COORDINATES`], where steps take less work.
    fn block(&self, model: &Model, slots: &[usize]) -> Option<LinearBlock> {
        let count: usize = slots.iter().map(|&slot| self.model_body(slot).positions()).sum();
        if count > MOST_BLOCK_COORDINATES {
            return None;
        }
        let parts: Vec<_> = slots.iter().map(|&slot| self.model_body(slot).linear_part()).collect::<Option<_>>()?;
        let joints = self.links_of(slots).into_iter().map(|number| &self.links[number]);
        let joints = joints
            .filter(|track| model.links[track.link].device.is_linear())
            .map(|track| Joint::of(&model.links[track.link], track.slots.map(|slot| slots.binary_search(&slot?).ok())));
        LinearBlock::of(&parts, &joints.collect::<Option<Vec<_>>>()?, (&model.ground, model.duration))
    }

    /// Whether these bodies are those of a block that nothing acts on but its own bearings.
    pub(in crate::dynamics) fn moves_as_block(&self, slots: &[usize]) -> bool {
        let Some(block) = self.bodies[slots[0]].block else { return false };
        let acts = |&link: &usize| self.link_acts(link) && !self.is_linear_link(link);
        let free = |&slot: &usize| {
            let track = &self.bodies[slot];
            !track.pairs.iter().any(|&pair| self.pair_acts(pair)) && !track.links.iter().any(acts)
        };
        self.blocks[block] == slots && slots.iter().all(free)
    }

    /// Slots of the bodies that move with a body in flight: itself alone, or those of its block.
    pub(in crate::dynamics) fn flies_with(&self, slot: usize) -> Vec<usize> {
        self.bodies[slot].block.map_or_else(|| vec![slot], |block| self.blocks[block].clone())
    }

    /// Whether a link is a linear bearing, which acts for ever.
    pub(in crate::dynamics) fn is_linear_link(&self, link: usize) -> bool {
        self.model_link(link).device.is_linear()
    }
}
