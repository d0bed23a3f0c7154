//! Loads and accelerations of an elastic girder in space, the input of its section forces, (F10): those beyond the dead load's, whose shape
//! is the zero of q.

use glam::DVec3;

use super::girder::SpatialElasticGirder;
use crate::dynamics::elastic::Fields;
use crate::dynamics::model::coordinates::section_forces::{Equilibrium, Load, SectionStiffness, Strained};
use crate::dynamics::model::wrench::Wrench;

impl SpatialElasticGirder {
    /// Loads in a state, less those of the placed state, under wrenches on its sections about the origins of their frames.
    pub fn equilibrium(&self, state: &[f64], wrenches: &[Wrench]) -> Equilibrium {
        let here = self.mean_axes(state);
        let mut modal = vec![0.0; self.count()];
        let _ = self.load(&here, state, wrenches, &mut modal);
        let loads = self.loads(state, wrenches);
        let [force, moment] = Equilibrium::sum(&loads);
        // Beyond the dead load a weight acts by what the rotation changes of its direction, the same everywhere: it is in the sum.
        let rigid = Fields { moved: force / self.rigid.mass, turned: self.rigid.inverse_inertia * moment };
        let beam = &self.modes.beam;
        let size = [beam.plan.length, beam.plan.mass];
        Equilibrium { size, rotary: beam.rotary, loads, rigid, fields: self.fields(&modal) }
    }

    /// The fields in a state.
    pub fn strained(&self, state: &[f64]) -> Strained {
        let beam = &self.modes.beam;
        let stiffness = SectionStiffness {
            forces: DVec3::new(beam.plan.axial, beam.plan.shear, beam.shear),
            moments: DVec3::new(beam.torsion, beam.bending, beam.plan.bending),
        };
        Strained { half: 0.5 * beam.plan.length, stiffness, fields: self.fields(self.modal(state)[0]) }
    }

    /// Fields of modal coordinates, by polynomial.
    fn fields(&self, q: &[f64]) -> Vec<Fields> {
        let mut sums = vec![Fields::default(); self.modes.degree + 1];
        for (j, q) in q.iter().enumerate() {
            sums.iter_mut().zip(self.modes.coefficients(j)).for_each(|(sum, c)| *sum += *c * *q);
        }
        sums
    }

    /// All loads on the modes, in girder axes.
    fn loads(&self, state: &[f64], wrenches: &[Wrench]) -> Vec<Load> {
        let (here, modal) = (self.mean_axes(state), self.modal(state));
        let girder_axes = |placed: DVec3| self.rigid.axes.mul_transpose_vec3(placed);
        let mut loads = Vec::new();
        let on_sections = wrenches.iter().enumerate().map(|(number, wrench)| (self.deforming(number), wrench));
        let pushed = self.pushed.as_ref().map(|(section, push)| (Some(section), push));
        for (section, wrench) in on_sections.chain(pushed) {
            if wrench.force == DVec3::ZERO && wrench.moment == DVec3::ZERO {
                continue;
            }
            if let Some(section) = section {
                let turns = Self::turns(section, here.turned, modal);
                let on = section.load(&turns, wrench.force, wrench.moment);
                loads.extend(section.bearer.loads(girder_axes(on.moved), girder_axes(on.turned)));
            } else {
                let [force, moment] =
                    [wrench.force, wrench.moment].map(|v| girder_axes(v + here.turned.transpose() * v));
                loads.push(Load { station: 0.0, force, moment });
            }
        }
        for point in &self.bearings {
            let now = point.now(&self.rigid.axes, &here, modal[0], modal[1]);
            let force = girder_axes(point.back(&here.turned, now.force));
            loads.push(Load { station: point.station, force, moment: point.offset.cross(force) });
        }
        loads
    }
}
