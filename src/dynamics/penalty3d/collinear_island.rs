//! The collinear kind of island: bodies that move along the axis and touch flush across it, without sliding and rotation.
//! The contacts of two faces act as one, and the motion of a body is that of one coordinate.
//!
//! `m ẍ + c ẋ + k x = Σ ±N(δ, δ̇) − m Ẍ` with the sum of a face's normal forces (`docs/physics.md#plane-motion`,
//! `docs/physics.md#linear-spring-and-dashpot`). The reduction is exact under these conditions: bearings and ground
//! motion act along the axis, faces are square to it, the levers across it cancel, and the other components of the
//! state are 0, which they then remain to the last bit.

use glam::DVec3;

use crate::contact::{Frame, FrictionLaw, Measured, Mode, Normal, NormalLaw, measure};
use crate::dynamics::Model;
use crate::dynamics::model::coordinates::planar;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::constants::LEVEL_ROUNDING;
use crate::dynamics::penalty3d::coupled_system::CoupledSystem;

/// Two sides in flush contact.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Joint {
    /// Index of the node's and the face's body of the first contact; `None` for an abutment.
    sides: [Option<usize>; 2],
    /// The face's normal along the axis, ±1.
    normal: f64,
    /// `g` as placed \[m\].
    rest: f64,
    /// Normal law of its contacts in parallel; `None` where the normal force is held at 0.
    law: Option<Normal>,
}

/// An island in one line.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::dynamics) struct CollinearIsland {
    axis: usize,
    /// Components of position and velocity of each body along the axis in the island's vector.
    components: Vec<[usize; 2]>,
    joints: Vec<Joint>,
    /// Index of the first contact of each contact's joint.
    first: Vec<usize>,
}

/// Quantities of a contact on the axis.
struct Touch {
    sides: [Option<usize>; 2],
    normal: f64,
    rest: f64,
    law: Option<Normal>,
    /// Levers of its force across the axis from G of either side \[m\].
    levers: [f64; 2],
    reach: f64,
}

impl CollinearIsland {
    /// Collinear island of these bodies and closed contacts; `None` where a condition on bodies, bearings, ground or
    /// faces fails, or a device acts.
    pub(in crate::dynamics) fn of(model: &Model, system: &CoupledSystem) -> Option<Self> {
        let CoupledSystem { bodies, layout, bases, active, links, .. } = system;
        if active.is_empty() || !links.is_empty() {
            return None;
        }
        let components = |axis: usize| -> Option<Vec<[usize; 2]>> {
            let along = |(i, (&b, base)): (usize, (&usize, &ReferencePose))| {
                let own = model.bodies[b].along(axis).filter(|_| planar::is_base_along(base, axis))?;
                Some(own.map(|component| layout.range(i).start + component))
            };
            bodies.iter().zip(bases).enumerate().map(along).collect()
        };
        (0..2).find_map(|axis| Self::across(model, bodies, components(axis)?, active, axis))
    }

    fn across(
        model: &Model,
        bodies: &[usize],
        components: Vec<[usize; 2]>,
        active: &[ActiveContact],
        axis: usize,
    ) -> Option<Self> {
        let touches: Option<Vec<Touch>> = active.iter().map(|a| Touch::of(model, bodies, a, axis)).collect();
        let touches = touches?;
        let first: Vec<usize> =
            touches.iter().map(|touch| touches.iter().position(|other| touch.joins(other)).unwrap_or(0)).collect();
        let mut joints = Vec::new();
        for number in (0..touches.len()).filter(|&number| first[number] == number) {
            let members = || (number..touches.len()).filter(|&n| first[n] == number).map(|n| &touches[n]);
            joints.push(Touch::together(&touches[number], members)?);
        }
        Some(Self { axis, components, joints, first })
    }

    /// Whether a state satisfies the conditions: all components off the axis are 0.
    #[inline]
    pub(in crate::dynamics) fn holds(&self, y: &[f64]) -> bool {
        planar::in_a_row(y).iter().all(|state| planar::is_along(state, self.axis))
    }

    /// Components of position and velocity of a body along the axis in the island's vector.
    #[inline]
    pub(in crate::dynamics) fn components(&self, index: usize) -> [usize; 2] {
        self.components[index]
    }

    /// The axis: 0 is x, 1 is y.
    pub(in crate::dynamics) fn axis(&self) -> usize {
        self.axis
    }

    /// Index of the first contact with the penetration of this one while the conditions hold.
    pub(in crate::dynamics) fn first(&self, contact: usize) -> usize {
        self.first[contact]
    }

    /// Derivative of a state that satisfies the conditions.
    #[inline]
    pub(in crate::dynamics) fn rates(
        &self,
        model: &Model,
        system: &CoupledSystem,
        ground: DVec3,
        y: &[f64],
        out: &mut [f64],
    ) {
        let axis = self.axis;
        out.fill(0.0);
        for joint in &self.joints {
            let [node, face] = joint.sides.map(|side| side.map(|i| self.components[i]));
            let at = |side: Option<[usize; 2]>, which: usize| side.map_or(0.0, |own| y[own[which]]);
            let gap = joint.rest + joint.normal * (at(node, 0) - at(face, 0));
            let rate = joint.normal * (at(node, 1) - at(face, 1));
            let force = joint.law.map_or(0.0, |law| joint.normal * (law.elastic(-gap) + law.damping(-gap, rate)));
            for (side, force) in [(node, force), (face, -force)] {
                if let Some([_, speed]) = side {
                    out[speed] += force;
                }
            }
        }
        for (i, &body) in system.bodies.iter().enumerate() {
            let (body, [at, rate]) = (&model.bodies[body], self.components[i]);
            let (place, speed) = (system.bases[i].planar()[axis] + y[at], y[rate]);
            let bearings = body.planar.stiffness.col(axis)[axis] * place + body.planar.damping.col(axis)[axis] * speed;
            let force = out[rate] + body.push[axis] - bearings;
            let rates = [speed, force / body.mass - ground[axis]];
            [out[at], out[rate]] = if body.free[axis] { rates } else { [0.0; 2] };
        }
    }
}

impl Touch {
    fn of(model: &Model, bodies: &[usize], active: &ActiveContact, axis: usize) -> Option<Self> {
        let site = &model.contacts[active.site];
        let frame = |side: Option<usize>| side.map_or(site.stand, |i| Frame::fixed(model.bodies[bodies[i]].home));
        let (node, face): (Frame, Frame) = (frame(active.node), frame(active.face));
        let normal = active.home.axes.z_axis;
        let square = normal[axis].abs() == 1.0 && normal[1 - axis] == 0.0 && site.face.is_upright();
        let Measured { here, arm, apart } = measure(&active.home, &node, &face);
        let (closed, law) = (&active.closed, &active.closed.law);
        let still = match closed.mode {
            Mode::Stick { anchor } => anchor == here.way,
            Mode::Slip { .. } => law.mu_k == 0.0 && law.friction == FrictionLaw::ReturnMapping && law.v_stick == 0.0,
        };
        (square && still && active.angle.is_none()).then(|| Self {
            sides: [active.node, active.face],
            normal: normal[axis],
            rest: here.gap,
            law: (!closed.held_at_zero).then_some(law.normal),
            levers: [arm[1 - axis], apart[1 - axis]],
            reach: site.reach(),
        })
    }

    /// Whether both contacts are between the same two sides, in either order.
    fn joins(&self, other: &Self) -> bool {
        let [a, b] = other.sides;
        (self.sides == [a, b] && self.normal == other.normal) || (self.sides == [b, a] && self.normal == -other.normal)
    }

    /// The joint of contacts between the same sides; `None` where their penetrations differ or their moments do not
    /// cancel.
    fn together<'a, I: Iterator<Item = &'a Self>>(first: &Self, members: impl Fn() -> I) -> Option<Joint> {
        let level = members().all(|m| m.law == first.law && (m.rest - first.rest).abs() <= LEVEL_ROUNDING * m.reach);
        let lever = |side: Option<usize>, m: &Self| if m.sides[0] == side { m.levers[0] } else { m.levers[1] };
        let balanced = first.sides.into_iter().all(|side| {
            let (sum, size) = members().fold((0.0, 0.0f64), |(sum, size), m| {
                let lever = lever(side, m);
                (sum + lever, size.max(lever.abs()))
            });
            side.is_none() || f64::abs(sum) <= LEVEL_ROUNDING * size
        });
        let count = members().count() as f64;
        let rest = members().map(|m| m.rest).sum::<f64>() / count;
        let law = first.law.map(|of_one| of_one.times(count));
        (level && balanced).then_some(Joint { sides: first.sides, normal: first.normal, rest, law })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Law;
    use crate::contact::normal::Linear;
    use crate::dynamics::model::coordinates::planar::WIDTH;
    use crate::dynamics::model::coordinates::state_layout::StateLayout;
    use crate::dynamics::model::ground_now::GroundNow;
    use crate::dynamics::penalty3d::contact_state::ClosedContact;
    use crate::dynamics::penalty3d::general_island;
    use crate::dynamics::penalty3d::workspace::Workspace;
    use crate::dynamics::{Body, ContactSite};
    use crate::scene::{Motion, Scene, presets};

    /// Two straight girders and their contacts in stick, all nodes closed.
    fn pressed(scene: &Scene) -> (Model, Vec<ActiveContact>) {
        let model = Model::compile(scene).expect("a valid scene");
        let stick = |site: usize| {
            let here = crate::contact::locate(
                &model.contacts[site].home,
                &frame(&model, model.contacts[site].node_body, site),
                &frame(&model, model.contacts[site].face_body, site),
            );
            let (k, c, c_t) = (4e4, 11.0, 7.0);
            let law = Law {
                normal: Normal::Linear(Linear { k, c }),
                k_t: k,
                c_t,
                mu_s: 0.2,
                mu_k: 0.15,
                friction: FrictionLaw::ReturnMapping,
                clamp: false,
                v_stick: 0.0,
            };
            let mode = Mode::Stick { anchor: here.way };
            let closed = ClosedContact::new(law, mode, 0.0);
            let ContactSite { node_body: node, face_body: face, .. } = model.contacts[site];
            let home = model.contacts[site].home;
            ActiveContact { site, node, face, sections: [0; 2], closed, home, angle: None, depth: 0.0 }
        };
        let mut active: Vec<ActiveContact> = (0..model.contacts.len()).map(stick).collect();
        for a in &mut active {
            a.find_sections(&model, &layout(&model));
        }
        (model, active)
    }

    fn straight_row() -> Scene {
        let mut scene = presets::load("row-of-5").expect("a preset");
        shake_along(&mut scene, 0.0);
        scene
    }

    fn shake_along(scene: &mut Scene, degrees: f64) {
        let Motion::Sine(sine) = &mut scene.motion else { panic!("it is shaken by a sine") };
        sine.angle_deg = degrees;
    }

    fn layout(model: &Model) -> StateLayout {
        StateLayout::of(model.bodies.iter())
    }

    fn system(model: &Model, active: &[ActiveContact]) -> CoupledSystem {
        let bodies: Vec<usize> = (0..model.bodies.len()).collect();
        let bases = model.bodies.iter().map(Body::placed).collect();
        CoupledSystem::without_rates((bodies, layout(model), bases), active.to_vec(), Vec::new(), Vec::new())
    }

    /// The collinear island of all bodies of a model.
    fn line(model: &Model, active: &[ActiveContact]) -> Option<CollinearIsland> {
        CollinearIsland::of(model, &system(model, active))
    }

    fn frame(model: &Model, body: Option<usize>, site: usize) -> Frame {
        body.map_or(model.contacts[site].stand, |body| model.bodies[body].planar_frame(&[0.0; WIDTH]))
    }

    #[test]
    fn in_line_the_rates_are_those_of_the_plan() {
        let scene = straight_row();
        let (model, active) = pressed(&scene);
        let line = line(&model, &active).expect("a straight row");
        let mut y = vec![0.0; WIDTH * model.bodies.len()];
        for (i, state) in y.chunks_exact_mut(WIDTH).enumerate() {
            (state[0], state[3]) = (1e-3 * (1.7 * i as f64).sin(), 0.2 * (2.9 * i as f64).cos());
        }
        assert!(line.holds(&y), "all else is 0");
        let (system, ground) = (system(&model, &active), model.ground.acceleration(0.3));
        let (mut short, mut whole) = (vec![9.0; y.len()], vec![9.0; y.len()]);
        line.rates(&model, &system, ground, &y, &mut short);
        general_island::rates(&model, &system, GroundNow::of(ground), &y, &mut Workspace::of(&active), &mut whole);
        let largest = whole.iter().fold(0.0f64, |most, rate| most.max(rate.abs()));
        for (i, (a, b)) in short.iter().zip(&whole).enumerate() {
            // The order of summation differs.
            assert!((a - b).abs() <= 1e-13 * largest, "component {i}: {a} against {b}");
        }
        y[2] = 1e-9;
        assert!(!line.holds(&y), "turned");
    }

    #[test]
    fn what_turns_or_slides_is_not_in_line() {
        let scene = straight_row();
        let (model, active) = pressed(&scene);
        assert!(line(&model, &active).is_some(), "all nodes of flush faces");
        assert!(line(&model, &active[1..]).is_none(), "a corner alone turns its girder");
        let mut dragged = active.clone();
        if let Mode::Stick { anchor } = &mut dragged[0].closed.mode {
            anchor.x += 1e-6;
        }
        assert!(line(&model, &dragged).is_none(), "a stretched spring pulls sideways");
        let mut aslant = scene.clone();
        shake_along(&mut aslant, 1.0);
        let (model, active) = pressed(&aslant);
        assert!(line(&model, &active).is_none(), "the ground drives it off");
        let (model, active) = pressed(&presets::load("skew45-abutment").expect("a preset"));
        assert!(line(&model, &active).is_none(), "a skewed face is not square to its girder");
    }
}
