//! Change of the reference poses of an island: states, anchors and contact geometry are counted from the bodies' present poses.

use crate::contact::Mode;
use crate::dynamics::Model;
use crate::dynamics::model::reference_pose::{ReferencePose, seen_from};
use crate::dynamics::model::rigid_body;
use crate::dynamics::penalty3d::island::Island;

impl Island {
    /// Counts everything from where its bodies are now, where its next step begins: nodes keep the places before their faces
    /// that they had, to the last digit.
    pub(in crate::dynamics) fn rebase(&mut self, model: &Model) {
        let width = rigid_body::width(model.kind);
        let bodies = self.bodies.iter().map(|&body| &model.bodies[body]);
        let states = bodies.clone().zip(self.y.chunks_exact(width));
        self.frames = self.bases.iter().zip(states).map(|(base, (body, state))| base.since(body, state)).collect();
        for active in &mut self.active {
            let here = active.look(model, &self.frames);
            active.closed.solver.rebased_node = Some(here.at.extend(here.gap));
            if let Mode::Stick { anchor } = &mut active.closed.mode {
                *anchor -= here.way;
            }
        }
        for ((base, body), state) in self.bases.iter_mut().zip(bodies).zip(self.y.chunks_exact_mut(width)) {
            base.add(state);
            *base = ReferencePose::of(model.kind, body, state);
        }
        for active in &mut self.active {
            let bases = [active.node, active.face].map(|side| self.bases.get(side?));
            active.home = seen_from(&model.contacts[active.site], bases, active.closed.solver.rebased_node);
        }
        self.counted_anew(model);
    }
}
