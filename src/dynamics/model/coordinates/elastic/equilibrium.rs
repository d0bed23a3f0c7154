//! Loads and accelerations of an elastic girder in plan, the input of its section forces, (F10).

use glam::{DMat2, DMat3, DVec2, DVec3};
use smallvec::smallvec;

use super::AxisMotion;
use super::girder::ElasticGirder;
use super::section::Turns;
use crate::dynamics::elastic::Fields;
use crate::dynamics::model::coordinates::section_forces::{Equilibrium, Load, SectionStiffness, Strained};
use crate::dynamics::model::linear_block::part::RIGID;
use crate::dynamics::model::wrench::Wrench;

impl ElasticGirder {
    /// Loads in a state, less those of the placed state, under wrenches on its sections about the origins of their frames, and the ground's
    /// acceleration.
    pub fn equilibrium(&self, state: &[f64], wrenches: &[Wrench], ground: DVec3) -> Equilibrium {
        let modal = self.accelerations(state, wrenches, ground).split_off(RIGID);
        let mut loads = self.on_sections(state, wrenches);
        loads.extend(self.on_bearings(state).map(|AxisMotion { axis, w, v }| {
            let force = axis.along * -(axis.stiffness * w + axis.damping * v);
            in_plan(axis.station, force, axis.offset.perp_dot(force))
        }));
        loads.push(in_plan(0.0, self.girder_axes(self.rigid.push.truncate()), self.rigid.moment.z));
        // A load on G's own section stands for what no end carries.
        let [force, moment] = Equilibrium::sum(&loads);
        let rigid = Fields {
            moved: force / self.rigid.mass,
            turned: DVec3::Z * (moment.z / (self.rigid.mass * self.rigid.gyration2)),
        };
        let beam = &self.modes.beam;
        let rotary = DMat3::from_diagonal(DVec3::Z * beam.rotary);
        Equilibrium { size: [beam.length, beam.mass], rotary, loads, rigid, fields: self.fields(&modal) }
    }

    /// The fields in a state.
    pub fn strained(&self, state: &[f64]) -> Strained {
        let (beam, (place, _)) = (&self.modes.beam, self.halves(state));
        let stiffness =
            SectionStiffness { forces: DVec3::new(beam.axial, beam.shear, 0.0), moments: DVec3::Z * beam.bending };
        Strained { half: 0.5 * beam.length, stiffness, fields: self.fields(&place[RIGID..]) }
    }

    /// Fields of modal coordinates, by polynomial.
    fn fields(&self, q: &[f64]) -> Vec<Fields> {
        let mut sums = vec![Fields::default(); self.modes.degree + 1];
        for (j, q) in q.iter().enumerate() {
            sums.iter_mut().zip(self.modes.coefficients(j)).for_each(|(sum, c)| *sum += Fields::plane(*c * *q));
        }
        sums
    }

    /// Loads of wrenches on the sections.
    fn on_sections(&self, state: &[f64], wrenches: &[Wrench]) -> Vec<Load> {
        let (place, rate) = self.halves(state);
        let of = |(section, wrench): (usize, &Wrench)| {
            let (force, moment) = (wrench.force.truncate(), wrench.moment.z);
            let Some(end) = self.deforming(section) else {
                let back = DMat2::from_angle(-place[2]) * force;
                return smallvec![in_plan(0.0, self.girder_axes(back), moment)];
            };
            let turns = Turns::of(place[2], end.deformation(&place[RIGID..], &rate[RIGID..]).of.z);
            let load = end.load(&turns, force, moment);
            end.bearer.loads(self.girder_axes(load.force).extend(0.0), DVec3::Z * load.moment)
        };
        let acting = wrenches.iter().enumerate().filter(|(_, w)| w.force != DVec3::ZERO || w.moment != DVec3::ZERO);
        acting.flat_map(of).collect()
    }

    fn girder_axes(&self, world: DVec2) -> DVec2 {
        (self.rigid.axes.transpose() * world.extend(0.0)).truncate()
    }
}

fn in_plan(station: f64, force: DVec2, moment: f64) -> Load {
    Load { station, force: force.extend(0.0), moment: DVec3::Z * moment }
}
