//! Section forces of an elastic girder from equilibrium, (F10), and from strain, in plan and in space.

use glam::{DMat3, DVec3};
use smallvec::{SmallVec, smallvec};

use crate::dynamics::elastic::Fields;
use crate::dynamics::elastic::legendre::{integrals_to_end, moments_to_end, slopes, values};
use crate::scene::facing::Flank;

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

/// Kind of a link: at an elastic girder it decides how the link's point moves with the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dynamics) enum LinkOf {
    /// A part of a bearing: at the point at which the bearing's own spring acts, (F2).
    Bearing,
    /// A device: on a rigid section.
    Device,
}

/// Part of a girder at which forces on one of its sections act.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) enum Bearer {
    /// The section at this station \[m\].
    Station(f64),
    /// A point of a bearing.
    Point {
        /// Its station \[m\].
        station: f64,
        /// From the centre of the section there, girder axes \[m\].
        offset: DVec3,
    },
    /// Both end sections: a face along the girder, plane between the corners of both.
    Flank {
        /// Half of the girder's length \[m\].
        half: f64,
        /// From the centre of an end section to the middle of the face's edge there, girder axes \[m\].
        offset: DVec3,
    },
}

impl Bearer {
    /// Motion of a face along the girder by those of the sections at −x and +x, girder axes: of its centre, and of the line between the
    /// middles of its edges, with the mean of both rotations about x.
    pub(in crate::dynamics) fn between([minus, plus]: [Fields; 2], half: f64, offset: DVec3) -> Fields {
        let [from, to] = [minus, plus].map(|end| end.displacement(offset));
        let along = (to - from) / (2.0 * half);
        let twist = 0.5 * (minus.turned.x + plus.turned.x);
        Fields { moved: 0.5 * (from + to), turned: DVec3::new(twist, -along.z, along.y) }
    }

    /// Number of the section of a face along a girder, which has these sections after section 0 at G; the sections of such faces follow one
    /// another in the order of [`Flank`]. 0 where there are none.
    pub(in crate::dynamics) fn section_of(flank: Flank, mut deforming: impl Iterator<Item = Self>) -> usize {
        let first = deforming.position(|bearer| matches!(bearer, Self::Flank { .. }));
        first.map_or(0, |first| first + 1 + flank as usize)
    }

    /// Whether it is the same section or point of a bearing as another, up to `within` \[m\].
    pub(in crate::dynamics) fn is_like(&self, other: &Self, within: f64) -> bool {
        match (*self, *other) {
            (Self::Station(own), Self::Station(other)) => (own - other).abs() <= within,
            (Self::Point { station, offset }, Self::Point { station: other, offset: beside }) => {
                (station - other).abs() <= within && (offset - beside).abs().max_element() <= within
            }
            _ => false,
        }
    }

    /// The loads of a force on the section and a moment about its centre, that of a point about the point, girder axes: those that do the
    /// same work.
    pub(in crate::dynamics) fn loads(&self, force: DVec3, moment: DVec3) -> SmallVec<[Load; 2]> {
        match *self {
            Self::Station(station) => smallvec![Load { station, force, moment }],
            Self::Point { station, offset } => {
                smallvec![Load { station, force, moment: moment + offset.cross(force) }]
            }
            Self::Flank { half, offset } => {
                let couple = DVec3::new(0.0, moment.z, -moment.y) / (2.0 * half);
                let at = |sign: f64| {
                    let own = 0.5 * force + sign * couple;
                    let moment = offset.cross(own) + DVec3::X * (0.5 * moment.x);
                    Load { station: sign * half, force: own, moment }
                };
                smallvec![at(-1.0), at(1.0)]
            }
        }
    }
}

/// Stiffness of a section: of N, Q, `Q_z`, and of T, `M_y`, M; 0 where a girder has no such strain.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct SectionStiffness {
    /// `E A`, `k_s G A` in plan and upwards \[N\].
    pub forces: DVec3,
    /// `G J_t`, `E I_y`, `E I_z` \[N·m²\].
    pub moments: DVec3,
}

/// Loads and accelerations of an elastic girder at one instant.
#[derive(Clone, Debug)]
pub struct Equilibrium {
    /// Length \[m\] and mass \[kg\].
    pub(in crate::dynamics) size: [f64; 2],
    /// Rotary inertia of a section per mass \[m²\].
    pub(in crate::dynamics) rotary: DMat3,
    /// Loads.
    pub(in crate::dynamics) loads: Vec<Load>,
    /// Acceleration of the mean axes by the loads alone, girder axes \[m/s²\], and of their turning \[rad/s²\].
    pub(in crate::dynamics) rigid: Fields,
    /// Accelerations of the fields, by polynomial.
    pub(in crate::dynamics) fields: Vec<Fields>,
}

/// A station with what its section forces take from the polynomials of the fields, made once for all instants.
#[derive(Clone, Debug)]
pub struct Station {
    /// From −1 to 1 along the girder.
    xi: f64,
    /// `∫_ξ^1 P_k` and `∫_ξ^1 (x − ξ) P_k(x) dx`.
    integrals: [Vec<f64>; 2],
}

impl Station {
    /// At ξ from −1 to 1 along a girder of fields of this degree.
    pub fn new(degree: usize, xi: f64) -> Self {
        let xi = xi.clamp(-1.0, 1.0);
        Self { xi, integrals: [integrals_to_end(degree, xi), moments_to_end(degree, xi)] }
    }

    /// ξ.
    pub fn xi(&self) -> f64 {
        self.xi
    }
}

/// The fields of an elastic girder at one instant, for the section forces of their strain.
#[derive(Clone, Debug)]
pub struct Strained {
    /// Half of the girder's length \[m\].
    pub(in crate::dynamics) half: f64,
    /// Stiffness of its sections.
    pub(in crate::dynamics) stiffness: SectionStiffness,
    /// The fields, by polynomial.
    pub(in crate::dynamics) fields: Vec<Fields>,
}

impl Strained {
    /// Half of the girder's length \[m\].
    pub fn half(&self) -> f64 {
        self.half
    }

    /// `E A u'`, `k_s G A (v' − φ_z)`, `k_s G A (w' + φ_y)`, `G J_t ψ'`, `E I φ'` at a station \[m\].
    pub fn at(&self, station: f64) -> SectionForces {
        let (half, degree) = (self.half, self.fields.len() - 1);
        let xi = (station / half).clamp(-1.0, 1.0);
        let slope: Fields = self.fields.iter().zip(slopes(degree, xi)).map(|(f, x)| *f * (x / half)).sum();
        let turned: DVec3 = self.fields.iter().zip(values(degree, xi)).map(|(f, x)| f.turned * x).sum();
        let SectionStiffness { forces, moments } = self.stiffness;
        SectionForces::of(forces * (slope.moved + across(turned)), moments * slope.turned)
    }
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
        self.at_station(&Station::new(self.fields.len() - 1, station / self.half()))
    }

    /// Section forces at a station of the girder's table.
    pub fn at_station(&self, station: &Station) -> SectionForces {
        let [length, mass] = self.size;
        let half = 0.5 * length;
        let (s, beyond) = (station.xi * half, half - station.xi * half);
        let sum = |of: &[f64]| self.fields.iter().zip(of).map(|(f, x)| *f * *x).sum::<Fields>();
        let [once, twice] = station.integrals.each_ref().map(|of| sum(of));
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

    /// Half of the length \[m\].
    pub fn half(&self) -> f64 {
        0.5 * self.size[0]
    }

    /// Stations of the loads \[m\]: moments have kinks there and forces jump.
    pub fn loaded(&self) -> impl Iterator<Item = f64> + '_ {
        let acting = self.loads.iter().filter(|load| load.force != DVec3::ZERO || load.moment != DVec3::ZERO);
        acting.map(|load| load.station)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_of_a_side_do_the_work_of_its_motion() {
        let (half, offset) = (7.0, DVec3::new(0.8, -2.0, 0.3));
        let ends = [0.3f64, 1.1].map(|seed| Fields {
            moved: DVec3::new(seed.sin(), (2.0 * seed).cos(), (3.0 * seed).sin()),
            turned: DVec3::new((5.0 * seed).cos(), (7.0 * seed).sin(), (11.0 * seed).cos()),
        });
        let side = Bearer::between(ends, half, offset);
        let (force, moment) = (DVec3::new(2.0, -3.0, 5.0), DVec3::new(-7.0, 11.0, 13.0));
        let loads = Bearer::Flank { half, offset }.loads(force, moment);
        let by_ends: f64 =
            loads.iter().zip(ends).map(|(load, end)| load.force.dot(end.moved) + load.moment.dot(end.turned)).sum();
        let by_side = force.dot(side.moved) + moment.dot(side.turned);
        assert!((by_ends - by_side).abs() < 1e-13 * by_side.abs(), "{by_ends} and {by_side} J");
        let about_middle =
            loads.iter().map(|load| (DVec3::X * load.station).cross(load.force) + load.moment).sum::<DVec3>();
        let all = loads.iter().map(|load| load.force).sum::<DVec3>();
        assert!((all - force).length() < 1e-14 * force.length(), "the same force");
        assert!((about_middle - offset.cross(force) - moment).length() < 1e-13 * moment.length(), "the same moment");
    }
}
