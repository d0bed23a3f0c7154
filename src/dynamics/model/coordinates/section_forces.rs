//! Section forces of an elastic girder from equilibrium, (F10), and from strain, in plan and in space.

use glam::{DMat3, DVec3};

use crate::dynamics::elastic::Fields;
use crate::dynamics::elastic::legendre::{integrals_to_end, moments_to_end, slopes, values};

/// Forces and moments of a section, of the part beyond it on the part before it, girder axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionForces {
    /// Normal force N, tension positive \[N\].
    pub axial: f64,
    /// Shear force Q in plan \[N\].
    pub shear: f64,
    /// Bending moment M in plan, positive where it compresses the +y edge \[N·m\].
    pub moment: f64,
    /// Vertical shear force `Q_z` \[N\]; 0 of a girder in plan.
    pub vertical_shear: f64,
    /// Vertical bending moment `M_y`, positive where it stretches the upper side \[N·m\]; 0 of a girder in plan.
    pub vertical_moment: f64,
    /// Torque T \[N·m\]; 0 of a girder in plan.
    pub torque: f64,
}

/// A load at a station: force in girder axes and moment about the section's centre.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Load {
    /// Station \[m\].
    pub station: f64,
    /// Force \[N\].
    pub force: DVec3,
    /// Moment \[N·m\].
    pub moment: DVec3,
}

/// Stiffness of a section: of N, Q, `Q_z`, and of T, `M_y`, M; 0 where a girder has no such strain.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct SectionStiffness {
    /// `E A`, `k_s G A` in plan and upwards \[N\].
    pub forces: DVec3,
    /// `G J_t`, `E I_y`, `E I_z` \[N·m²\].
    pub moments: DVec3,
}

/// What acts on an elastic girder at one instant, and how it accelerates.
#[derive(Clone, Debug)]
pub struct Equilibrium {
    /// Length \[m\] and mass \[kg\].
    pub(in crate::dynamics) size: [f64; 2],
    /// Rotary inertia of a section per mass \[m²\].
    pub(in crate::dynamics) rotary: DMat3,
    /// Stiffness of its sections.
    pub(in crate::dynamics) stiffness: SectionStiffness,
    /// Loads.
    pub(in crate::dynamics) loads: Vec<Load>,
    /// Acceleration of the mean axes by the loads alone, girder axes \[m/s²\], and of their turning \[rad/s²\].
    pub(in crate::dynamics) rigid: Fields,
    /// Accelerations of the fields, by polynomial.
    pub(in crate::dynamics) fields: Vec<Fields>,
    /// The fields themselves.
    pub(in crate::dynamics) strained: Vec<Fields>,
}

/// `e_x × v`.
fn across(v: DVec3) -> DVec3 {
    DVec3::new(0.0, -v.z, v.y)
}

impl Equilibrium {
    /// Of loads all together: force, and moment about G.
    pub(in crate::dynamics) fn sum(loads: &[Load]) -> [DVec3; 2] {
        let force = loads.iter().map(|load| load.force).sum();
        [force, loads.iter().map(|load| load.moment + load.station * across(load.force)).sum()]
    }

    /// Section forces at a station from −a0/2 to a0/2 \[m\]; at an end those just inside of it.
    pub fn at(&self, station: f64) -> SectionForces {
        let [length, mass] = self.size;
        let (half, degree) = (0.5 * length, self.fields.len() - 1);
        let xi = (station / half).clamp(-1.0, 1.0);
        let (s, beyond) = (xi * half, half - xi * half);
        let sum = |of: &[f64]| self.fields.iter().zip(of).map(|(f, x)| *f * *x).sum::<Fields>();
        let (once, twice) = (sum(&integrals_to_end(degree, xi)), sum(&moments_to_end(degree, xi)));
        let Fields { moved: a, turned: alpha } = self.rigid;
        let mu = mass / length;
        // α × e_x, by which a section's centre at s gains s times as much.
        let swept = -across(alpha);
        let moments = a * (0.5 * beyond * beyond)
            + swept * ((half.powi(3) - s.powi(3)) / 3.0 - s * (half * half - s * s) / 2.0)
            + twice.moved * (half * half);
        let mut force = (a * beyond + swept * (0.5 * (half * half - s * s)) + once.moved * half) * -mu;
        let mut moment = (across(moments) + self.rotary * (alpha * beyond + once.turned * half)) * -mu;
        for load in &self.loads {
            // The +x end is beyond every station, the −x end beyond none.
            if load.station > s || load.station >= half {
                force += load.force;
                moment += load.moment + (load.station - s) * across(load.force);
            }
        }
        SectionForces::of(force, moment)
    }

    /// Where loads act \[m\]: moments have kinks there and forces jump.
    pub fn loaded(&self) -> impl Iterator<Item = f64> + '_ {
        self.loads.iter().map(|load| load.station)
    }

    /// The same by the strain of the series: `E A u'`, `k_s G A (v' − φ_z)`, `k_s G A (w' + φ_y)`, `G J_t ψ'`, `E I φ'`.
    pub fn by_strain(&self, station: f64) -> SectionForces {
        let (half, degree) = (0.5 * self.size[0], self.strained.len() - 1);
        let xi = (station / half).clamp(-1.0, 1.0);
        let slope: Fields = self.strained.iter().zip(slopes(degree, xi)).map(|(f, x)| *f * (x / half)).sum();
        let turned: DVec3 = self.strained.iter().zip(values(degree, xi)).map(|(f, x)| f.turned * x).sum();
        let SectionStiffness { forces, moments } = self.stiffness;
        SectionForces::of(forces * (slope.moved + across(turned)), moments * slope.turned)
    }
}

impl SectionForces {
    fn of(force: DVec3, moment: DVec3) -> Self {
        Self {
            axial: force.x,
            shear: force.y,
            moment: moment.z,
            vertical_shear: force.z,
            vertical_moment: moment.y,
            torque: moment.x,
        }
    }
}
