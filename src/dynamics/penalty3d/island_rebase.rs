//! Replacement of the reference poses of an island by the present poses of its bodies.

use crate::contact::Mode;
use crate::dynamics::Model;
use crate::dynamics::model::reference_pose::seen_from;
use crate::dynamics::penalty3d::island::Island;

impl Island {
    /// Replaces the reference poses by the poses at the start of the next step. Positions of the nodes relative to
    /// their faces are kept to the last bit.
    pub(in crate::dynamics) fn rebase(&mut self, model: &Model) {
        let bodies = self.system.bodies.iter().map(|&body| &model.bodies[body]);
        self.workspace.frames.clear();
        for (body, state) in bodies.clone().zip(self.system.layout.states(&self.y)) {
            body.push_frames(state, &mut self.workspace.frames);
        }
        for active in &mut self.system.active {
            let here = active.look(model, &self.workspace.frames);
            active.closed.solver.rebased_node = Some(here.at.extend(here.gap));
            if let Mode::Stick { anchor } = &mut active.closed.mode {
                *anchor -= here.way;
            }
        }
        for (i, (base, body)) in self.system.bases.iter_mut().zip(bodies).enumerate() {
            let state = &mut self.y[self.system.layout.range(i)];
            body.restore(&base.numbers(), state);
            *base = body.rebase(state);
        }
        for active in &mut self.system.active {
            let bases = [active.node, active.face].map(|side| self.system.bases.get(side?));
            active.home = seen_from(&model.contacts[active.site], bases, active.closed.solver.rebased_node);
        }
        self.counted_anew(model);
    }
}
