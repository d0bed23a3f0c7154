//! Readings of elastic girders: section forces, stress, ringing, and the validity of the model.

use glam::DVec3;

use crate::dynamics::elastic::Fields;
use crate::dynamics::model::coordinates::section_forces::{Equilibrium, SectionForces, Strained};
use crate::dynamics::model::elastic_body::ElasticBody;
use crate::dynamics::model::flexible::Flexible;
use crate::dynamics::model::pair::{Carrier, Pair};
use crate::dynamics::model::wrench::Wrench;
use crate::language::Text;
use crate::sim::Touch;
use crate::sim::peaks::largest_of_each;
use crate::sim::readings::Extreme;
use crate::sim::sections::view::Sections;

/// Bound of a neglected term from which a run warns.
pub const NEGLIGIBLE: f64 = 1e-2;
/// Number of frequencies that are listed.
const LISTED: usize = 6;

/// Relative bounds of what the model leaves out (`docs/physics.md#flexible-girders`).
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Neglected {
    /// `(θ̇/ω₁)²`.
    pub centrifugal: f64,
    /// `2 θ̇/ω₁`.
    pub coriolis: f64,
    /// Largest displacement of an end against the mean axes over the length.
    pub inertia: f64,
    /// Largest axial force of all stations over the buckling load, `N a0²/(π² E I)`.
    pub thrust: f64,
    /// Largest distance of a load on a side of the girder from the nearer end, over the length: both ends carry it.
    pub side_load: f64,
}

impl Neglected {
    /// Each with its name.
    pub fn named(&self) -> [(Text, f64); 5] {
        [
            (Text::new("neglected-centrifugal"), self.centrifugal),
            (Text::new("neglected-coriolis"), self.coriolis),
            (Text::new("neglected-inertia"), self.inertia),
            (Text::new("neglected-thrust"), self.thrust),
            (Text::new("neglected-side-load"), self.side_load),
        ]
    }
}

/// The hardest hit of an elastic girder.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct ElasticHit {
    /// Beginning \[s\].
    pub t: f64,
    /// Time for which the two bodies were in touch, pauses of less than a wave's way there and back included \[s\].
    pub contact_time: f64,
    /// Whether it ended before the run did.
    pub ended: bool,
    /// Speed at which G of both part, over that at which they met, along the face's normal; nothing where they did not meet, or have not
    /// parted.
    pub restitution: Option<f64>,
    /// Energy in the elastic modes at its end, or at the end of the run \[J\].
    pub ringing: f64,
}

/// The largest value of a section force, how that is read from section forces, and section forces with that value alone.
pub(in crate::sim) type LargestForce = (Extreme, fn(&SectionForces) -> f64, fn(f64) -> SectionForces);

/// Largest section forces, stress and hardest hit of an elastic girder over a run.
#[derive(Clone, Debug, PartialEq)]
pub struct FlexibleReading {
    /// Number of the girder.
    pub girder: usize,
    /// Circular frequencies of the first modes \[rad/s\].
    pub frequencies: Vec<f64>,
    /// Largest |N| at mid-span \[N\].
    pub axial: Extreme,
    /// Largest |M| at mid-span \[N·m\].
    pub moment: Extreme,
    /// Largest |`M_y`| and |T| at mid-span \[N·m\], of a girder in space.
    pub in_space: Option<[Extreme; 2]>,
    /// Largest stress of the extreme fibre \[Pa\].
    pub stress: Extreme,
    /// Its station \[m\].
    pub stressed_at: f64,
    /// Greatest difference of N from equilibrium and from strain at mid-span, at the time of its peak, in parts of that.
    pub local_error: f64,
    /// Bounds of what is left out.
    pub neglected: Neglected,
    /// Its hardest hit.
    pub hit: Option<ElasticHit>,
}

impl<'a> Sections<'a> {
    /// Beam, section and modes of an elastic girder that bends; `None` of a rigid one, or one that is as good as rigid.
    pub fn flexible(self, girder: usize) -> Option<&'a Flexible> {
        self.history.model().flexible.get(girder)?.as_ref().filter(|flexible| flexible.girder.is_some())
    }

    /// Loads and inertia of an elastic girder at `t`, from which its section forces follow; `None` of one that does not bend.
    pub fn equilibrium(self, girder: usize, t: f64) -> Option<Equilibrium> {
        let made = self.flexible(girder)?.girder.as_ref()?;
        let t = t.clamp(0.0, self.history.end());
        Some(self.equilibrium_in(girder, made, (t, &self.history.state(girder, t))))
    }

    /// Loads and inertia of a girder that is in this state at `t`.
    pub(in crate::sim) fn equilibrium_in(
        self,
        girder: usize,
        made: &ElasticBody,
        (t, state): (f64, &[f64]),
    ) -> Equilibrium {
        let body = &self.history.model().bodies[girder];
        let mut wrenches = vec![Wrench::default(); body.sections()];
        let pairs = self.history.model().pairs.iter().filter(|pair| pair.bodies.contains(&Some(girder)));
        for contact in pairs.flat_map(Pair::nodes) {
            let Some(now) = self.history.contacts().contact(contact, t) else { continue };
            let site = &self.history.model().sites[contact];
            let sections = self.history.model().sections(contact);
            let sides = [(site.node_body, now.point, 1.0), (site.face_body, now.anchor, -1.0)];
            for ((owner, place, sign), section) in sides.into_iter().zip(sections) {
                if owner == Some(girder) {
                    let arm = place - body.frame(section, state).origin();
                    wrenches[section].push_with(sign * now.force, arm, sign * now.couple);
                }
            }
        }
        self.history.connections().push_links(girder, (t, state), &mut wrenches);
        made.equilibrium(state, &wrenches, self.history.model().ground.acceleration(t))
    }

    /// The fields of an elastic girder at `t`; `None` of one that does not bend.
    pub fn strained(self, girder: usize, t: f64) -> Option<Strained> {
        let made = self.flexible(girder)?.girder.as_ref()?;
        Some(made.strained(&self.history.state(girder, t)))
    }

    /// Section forces of an elastic girder at a station \[m\]; 0 of a rigid one.
    pub fn forces(self, girder: usize, station: f64, t: f64) -> SectionForces {
        self.equilibrium(girder, t).map_or(SectionForces::default(), |equilibrium| equilibrium.at(station))
    }

    /// Displacement of the centre of a section and its turn against the mean axes, girder axes \[m, rad\].
    pub fn deformation(self, girder: usize, station: f64, t: f64) -> Fields {
        let Some(made) = self.flexible(girder).and_then(|flexible| flexible.girder.as_ref()) else {
            return Fields::default();
        };
        made.deformation(&self.history.state(girder, t), station)
    }

    /// Displacement against the mean axes of a point at this place, and its rate, in axes as placed \[m, m/s\]; 0 of a rigid girder.
    pub(in crate::sim) fn displaced(self, girder: usize, place: DVec3, t: f64) -> [DVec3; 2] {
        let Some(made) = self.flexible(girder).and_then(|flexible| flexible.girder.as_ref()) else {
            return [DVec3::ZERO; 2];
        };
        let [bent, rate] = made.displaced(&self.history.state(girder, t), place);
        if matches!(made, ElasticBody::Plan(_)) {
            return [bent, rate];
        }
        // R d and its rate, in the girder's axes as placed.
        let (body, here) = (&self.history.model().bodies[girder], self.history.frame(girder, t));
        let axes = &body.axes;
        let [bent, rate] = [bent, rate].map(|d| here.turn(*axes * d));
        [bent, rate + here.spin.cross(bent)].map(|d| axes.mul_transpose_vec3(d))
    }

    /// Energy in the elastic modes of a girder at `t` \[J\].
    pub fn ringing(self, girder: usize, t: f64) -> f64 {
        let Some(made) = self.flexible(girder).and_then(|flexible| flexible.girder.as_ref()) else { return 0.0 };
        made.ringing(&self.history.state(girder, t))
    }

    /// Stress of the extreme fibre, the largest of all edges \[Pa\].
    pub fn stress(self, girder: usize, station: f64, t: f64) -> f64 {
        self.fibre_stress(girder, &self.forces(girder, station, t))
    }

    /// Stress of the extreme fibre under these section forces, the largest of all edges \[Pa\].
    pub(in crate::sim) fn fibre_stress(self, girder: usize, forces: &SectionForces) -> f64 {
        self.flexible(girder).map_or(0.0, |flexible| self.stress_of(girder, flexible, forces))
    }

    fn stress_of(self, girder: usize, flexible: &Flexible, forces: &SectionForces) -> f64 {
        let prism = &self.history.model().bodies[girder].prism;
        let section = &flexible.section;
        let in_plan = forces.moment.abs() * 0.5 * prism.width / section.second_moment;
        let upwards = forces.vertical_moment.abs() * 0.5 * prism.thickness / section.second_moment_vertical;
        forces.axial.abs() / section.area + in_plan + upwards
    }

    /// The largest |N|, |M| and |`M_y`| at mid-span of a girder, and its largest stress of the extreme fibre \[Pa\] with the station \[m\];
    /// `None` of one that does not bend.
    pub(in crate::sim) fn largest(self, girder: usize) -> Option<([LargestForce; 3], (Extreme, f64))> {
        let flexible = self.flexible(girder)?;
        let made = flexible.girder.as_ref()?;
        let fibre = |forces: &SectionForces| self.stress_of(girder, flexible, forces);
        let [axial, moment, vertical, _, stress, _] = self.largest_values(girder, made, Some(&fibre));
        let forces: [LargestForce; 3] = [
            (axial, |forces| forces.axial, |axial| SectionForces { axial, ..SectionForces::default() }),
            (moment, |forces| forces.moment, |moment| SectionForces { moment, ..SectionForces::default() }),
            (
                vertical,
                |forces| forces.vertical_moment,
                |vertical_moment| SectionForces { vertical_moment, ..SectionForces::default() },
            ),
        ];
        Some((forces, self.between_stations(girder, made, stress, &fibre)))
    }

    /// Readings of the elastic girders that bend, in the order of their numbers.
    pub fn readings(self) -> Vec<FlexibleReading> {
        let all = 0..self.history.model().girders().len();
        let bending = all.filter_map(|girder| {
            let flexible = self.flexible(girder)?;
            Some((girder, flexible, flexible.girder.as_ref()?))
        });
        bending.map(|(girder, flexible, made)| self.reading(girder, flexible, made)).collect()
    }

    fn reading(self, girder: usize, flexible: &Flexible, made: &ElasticBody) -> FlexibleReading {
        let fibre = |forces: &SectionForces| self.stress_of(girder, flexible, forces);
        let [axial, moment, vertical, torque, stress, thrust] = self.largest_values(girder, made, Some(&fibre));
        let in_space = flexible.space.map(|_| [vertical, torque]);
        let times = crate::sim::looks::of_body(self.history, girder);
        let [spin, bent] = largest_of_each(&times, &|t| made.spin_and_deflection(&self.history.state(girder, t)));
        let by_strain = made.strained(&self.history.state(girder, axial.t)).at(0.0).axial.abs();
        let (stress, stressed_at) = self.between_stations(girder, made, stress, &fibre);
        let frequencies: Vec<f64> = made.frequencies().into_iter().take(LISTED).collect();
        let first = frequencies.first().copied().unwrap_or(f64::INFINITY);
        let bending = flexible.space.map_or(f64::INFINITY, |space| space.bending).min(flexible.beam.bending);
        let buckling = (std::f64::consts::PI / flexible.beam.length).powi(2) * bending;
        FlexibleReading {
            girder,
            frequencies,
            axial,
            moment,
            in_space,
            stress,
            stressed_at,
            local_error: if axial.value > 0.0 { (by_strain - axial.value).abs() / axial.value } else { 0.0 },
            neglected: Neglected {
                centrifugal: (spin.value / first).powi(2),
                coriolis: 2.0 * spin.value / first,
                inertia: bent.value / flexible.beam.length,
                thrust: thrust.value / buckling,
                side_load: self.side_load(girder) / flexible.beam.length,
            },
            hit: self.elastic_hit(girder),
        }
    }

    /// Largest distance from the nearer end of a contact with a face along the girder, where its force is largest \[m\].
    fn side_load(self, girder: usize) -> f64 {
        let model = self.history.model();
        let is_on_side = |touch: &&Touch| {
            let site = &model.sites[touch.contact];
            site.face_body == Some(girder) && matches!(site.carriers[1], Carrier::Flank(_))
        };
        let prism = &model.bodies[girder].prism;
        let from_end = |touch: &Touch| {
            let here = self.history.motion(girder, touch.peak_time);
            let place = here.attitude.inverse()
                * (self.history.contacts().contact(touch.contact, touch.peak_time)?.anchor - here.place);
            Some(0.5 * prism.length - (place.x - place.y * prism.shear()).abs())
        };
        self.history.hits().touches().iter().filter(is_on_side).filter_map(from_end).fold(0.0, f64::max)
    }

    /// The hardest hit of an elastic girder that bends.
    pub fn elastic_hit(self, girder: usize) -> Option<ElasticHit> {
        let (flexible, model) = (self.flexible(girder)?, self.history.model());
        let own = |touch: &&Touch| model.pairs[touch.pair].bodies.contains(&Some(girder));
        let hardest =
            self.history.hits().touches().iter().filter(own).max_by(|a, b| a.peak_force.total_cmp(&b.peak_force))?;
        let pause = 2.0 * flexible.beam.transit_time();
        let mut span = [hardest.start, hardest.end];
        let same: Vec<&Touch> =
            self.history.hits().touches().iter().filter(|touch| touch.pair == hardest.pair).collect();
        for touch in &same {
            if touch.start >= span[0] && touch.start <= span[1] + pause {
                span[1] = span[1].max(touch.end);
            }
        }
        for touch in same.iter().rev() {
            if touch.end <= span[1] && touch.end + pause >= span[0] {
                span[0] = span[0].min(touch.start);
            }
        }
        let site = &model.sites[hardest.contact];
        let normal = self.history.contacts().contact_at(hardest.contact, hardest.peak_time)?.normal;
        let speed = |t: f64| {
            let of = |body: Option<usize>| body.map_or(DVec3::ZERO, |body| self.history.motion(body, t).velocity);
            (of(site.node_body) - of(site.face_body)).dot(normal)
        };
        let (before, after) = (speed(span[0]), speed(span[1]));
        let ended = span[1] < self.history.end();
        Some(ElasticHit {
            t: span[0],
            contact_time: span[1] - span[0],
            ended,
            restitution: (before < 0.0 && ended).then(|| -after / before),
            ringing: self.ringing(girder, span[1]),
        })
    }
}
