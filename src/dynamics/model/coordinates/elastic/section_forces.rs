//! Section forces of an elastic girder from equilibrium, (F10), and from strain.

use glam::{DVec2, DVec3};

use super::girder::ElasticGirder;
use super::section::Turns;
use crate::dynamics::elastic::legendre::{integrals_to_end, moments_to_end, slopes, values};
use crate::dynamics::model::linear_block::part::RIGID;
use crate::dynamics::model::wrench::Wrench;

/// Normal force N, tension positive \[N\]; shear force Q \[N\]; bending moment M, positive where it compresses the +y edge \[N·m\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionForces {
    /// N.
    pub axial: f64,
    /// Q.
    pub shear: f64,
    /// M.
    pub moment: f64,
}

/// A load at a station: force in girder axes and moment about the section's centre.
#[derive(Clone, Copy, Debug)]
struct Load {
    station: f64,
    force: DVec2,
    moment: f64,
}

/// What acts on an elastic girder at one instant, and how it accelerates.
#[derive(Clone, Debug)]
pub struct Equilibrium<'a> {
    girder: &'a ElasticGirder,
    loads: Vec<Load>,
    /// Acceleration of the mean axes with the ground's, girder axes \[m/s²\], and its turning \[rad/s²\].
    rigid: DVec3,
    /// Accelerations of the fields u, v, φ, by polynomial.
    fields: Vec<DVec3>,
    /// The fields themselves.
    strained: Vec<DVec3>,
}

impl ElasticGirder {
    /// What acts in a state since the girder was placed, under wrenches on its sections about the origins of their frames, and the
    /// ground.
    pub fn equilibrium(&self, state: &[f64], wrenches: &[Wrench], ground: DVec3) -> Equilibrium<'_> {
        let (place, _) = self.halves(state);
        let modal = self.accelerations(state, wrenches, ground).split_off(RIGID);
        let mut loads = self.on_sections(state, wrenches);
        loads.extend(self.on_bearings(state).map(|(axis, w, v)| {
            let force = axis.along * -(axis.stiffness * w + axis.damping * v);
            Load { station: axis.station, force, moment: axis.offset.perp_dot(force) }
        }));
        let push = self.girder_axes(self.rigid.push.truncate());
        loads.push(Load { station: 0.0, force: push, moment: self.rigid.moment.z });
        // A load on G's own section stands for what no end carries.
        let whole: DVec2 = loads.iter().map(|load| load.force).sum();
        let turning: f64 = loads.iter().map(|load| load.moment + load.station * load.force.y).sum();
        let rigid = (whole / self.rigid.mass).extend(turning / (self.rigid.mass * self.rigid.gyration2));
        let sums = |q: &[f64]| {
            let mut sums = vec![DVec3::ZERO; self.modes.degree + 1];
            for (j, q) in q.iter().enumerate() {
                sums.iter_mut().zip(self.modes.coefficients(j)).for_each(|(sum, c)| *sum += *c * *q);
            }
            sums
        };
        let (fields, strained) = (sums(&modal), sums(&place[RIGID..]));
        Equilibrium { girder: self, loads, rigid, fields, strained }
    }

    /// Loads of wrenches on the sections.
    fn on_sections(&self, state: &[f64], wrenches: &[Wrench]) -> Vec<Load> {
        let (place, rate) = self.halves(state);
        let of = |(section, wrench): (usize, &Wrench)| {
            let (force, moment) = (wrench.force.truncate(), wrench.moment.z);
            let Some(end) = self.deforming(section) else {
                let back = glam::DMat2::from_angle(-place[2]) * force;
                return Load { station: 0.0, force: self.girder_axes(back), moment };
            };
            let turns = Turns::of(place[2], end.deformation(&place[RIGID..], &rate[RIGID..]).of.z);
            let load = end.load(&turns, force, moment);
            Load { station: end.station, force: self.girder_axes(load.force), moment: load.moment }
        };
        wrenches.iter().enumerate().filter(|(_, w)| w.force != DVec3::ZERO || w.moment != DVec3::ZERO).map(of).collect()
    }

    fn girder_axes(&self, world: DVec2) -> DVec2 {
        (self.rigid.axes.transpose() * world.extend(0.0)).truncate()
    }
}

impl Equilibrium<'_> {
    /// Section forces at a station from −a0/2 to a0/2 \[m\]; at an end those just inside of it.
    pub fn at(&self, station: f64) -> SectionForces {
        let beam = &self.girder.modes.beam;
        let (half, degree) = (0.5 * beam.length, self.girder.modes.degree);
        let xi = (station / half).clamp(-1.0, 1.0);
        let (s, beyond) = (xi * half, half - xi * half);
        let (once, twice) = (integrals_to_end(degree, xi), moments_to_end(degree, xi));
        let [along, moments] =
            [&once, &twice].map(|of| self.fields.iter().zip(of).map(|(f, x)| *f * *x).sum::<DVec3>());
        let (rigid, mu) = (self.rigid, beam.mass / beam.length);
        let mut sum = SectionForces {
            axial: -mu * (rigid.x * beyond + half * along.x),
            shear: -mu * (rigid.y * beyond + rigid.z * 0.5 * (half * half - s * s) + half * along.y),
            moment: 0.0,
        };
        let carried = rigid.y * 0.5 * beyond * beyond
            + rigid.z * ((half.powi(3) - s.powi(3)) / 3.0 - s * (half * half - s * s) / 2.0)
            + half * half * moments.y
            + beam.rotary * (rigid.z * beyond + half * along.z);
        sum.moment = -mu * carried;
        for load in &self.loads {
            // The +x end is beyond every station, the −x end beyond none.
            if load.station > s || load.station >= half {
                sum.axial += load.force.x;
                sum.shear += load.force.y;
                sum.moment += load.moment + (load.station - s) * load.force.y;
            }
        }
        sum
    }

    /// The same by the strain of the series: `E A u'`, `k_s G A (v' − φ)`, `E I_z φ'`.
    pub fn by_strain(&self, station: f64) -> SectionForces {
        let beam = &self.girder.modes.beam;
        let (half, degree) = (0.5 * beam.length, self.girder.modes.degree);
        let xi = (station / half).clamp(-1.0, 1.0);
        let slope: DVec3 = self.strained.iter().zip(slopes(degree, xi)).map(|(f, x)| *f * (x / half)).sum();
        let turn: f64 = self.strained.iter().zip(values(degree, xi)).map(|(f, x)| f.z * x).sum();
        SectionForces {
            axial: beam.axial * slope.x,
            shear: beam.shear * (slope.y - turn),
            moment: beam.bending * slope.z,
        }
    }
}
