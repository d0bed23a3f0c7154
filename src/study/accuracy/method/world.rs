//! Bodies and contacts for methods that step: one vector, its slope, the states of the contacts between steps.

use glam::{DQuat, DVec3};

use super::contacts::Contacts;
use crate::contact::Frame;
use crate::dynamics::connection::Phase;
use crate::dynamics::model::coordinates::{planar, spatial};
use crate::dynamics::model::wrench::Wrench;
use crate::dynamics::{Body, Model};
use crate::scene::{Kind, Scene};
use crate::study::accuracy::answer::Place;

/// A scene in the hands of a method that steps.
#[derive(Debug)]
pub(super) struct World {
    pub(super) model: Model,
    /// Components of a body.
    pub(super) width: usize,
    /// All bodies.
    pub(super) y: Vec<f64>,
    contacts: Contacts,
    frames: Vec<Frame>,
    wrenches: Vec<Wrench>,
}

impl World {
    /// The scene at t = 0.
    pub(super) fn new(scene: &Scene) -> Result<Self, String> {
        crate::scene::validate::validate(scene).map_err(|errors| errors.to_string())?;
        let model = Model::compile(scene).map_err(|errors| errors.to_string())?.of_corners();
        let y = model.bodies.iter().flat_map(Body::initial).collect();
        let (width, contacts) = (model.bodies.first().map_or(0, Body::width), Contacts::new(&model));
        let mut world = Self { model, width, y, contacts, frames: Vec::new(), wrenches: Vec::new() };
        world.look();
        world.contacts.overlap(&world.model, &world.frames);
        Ok(world)
    }

    /// Largest force of a contact at the end of a step so far \[N\].
    pub(super) fn peak_force(&self) -> f64 {
        self.contacts.peak
    }

    /// Poses of the bodies in the state in hand.
    fn look(&mut self) {
        let y = std::mem::take(&mut self.y);
        self.pose(&y);
        self.y = y;
    }

    fn pose(&mut self, y: &[f64]) {
        self.frames.clear();
        for (i, body) in self.model.bodies.iter().enumerate() {
            self.frames.push(body.frame(0, &y[i * self.width..]));
        }
    }

    /// Rate of a state.
    pub(super) fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        self.pose(y);
        self.wrenches.clear();
        self.wrenches.resize(self.model.bodies.len(), Wrench::default());
        self.contacts.push(&self.model, &self.frames, &mut self.wrenches);
        self.push_bearings();
        let ground = self.model.ground.acceleration(t);
        for (i, body) in self.model.bodies.iter().enumerate() {
            let part = i * self.width..(i + 1) * self.width;
            let (state, rate, wrench) = (&y[part.clone()], &mut out[part], &self.wrenches[i]);
            match self.model.kind {
                Kind::Planar => planar::slope(body, state, wrench, ground, rate),
                Kind::Spatial => {
                    spatial::slope(body, &self.frames[i], state, wrench, ground, rate);
                }
            }
        }
    }

    /// Adds the forces of linear bearings between two bodies, as those on piers are.
    fn push_bearings(&mut self) {
        for link in self.model.links.iter().filter(|link| link.device.is_linear()) {
            let [Some(a), Some(b)] = link.bodies else { continue };
            let (motion, arms) = link.motion([&self.frames[a], &self.frames[b]]);
            let force = link.force(&Phase::default(), &motion, &self.frames[b]);
            self.wrenches[a].push(force, arms[0]);
            self.wrenches[b].push(-force, arms[1]);
        }
    }

    /// Ends a step: attitudes of length 1, contacts brought up to date. Answers whether any contact changed its state.
    pub(super) fn settle(&mut self) -> bool {
        if self.model.kind == Kind::Spatial {
            for state in self.y.chunks_mut(spatial::WIDTH) {
                let q = spatial::turn(state);
                state[3..7].copy_from_slice(&[q.x, q.y, q.z, q.w]);
            }
        }
        self.look();
        self.contacts.settle(&self.model, &self.frames)
    }

    /// Positions of the bodies in a state.
    pub(super) fn places(&self, y: &[f64]) -> Vec<Place> {
        let place = |(i, body): (usize, &Body)| {
            let state = &y[i * self.width..(i + 1) * self.width];
            match self.model.kind {
                Kind::Planar => [state[0], state[1], body.start[2], state[2]],
                Kind::Spatial => {
                    let x = spatial::turn(state) * DVec3::X;
                    [state[0], state[1], state[2], x.y.atan2(x.x)]
                }
            }
        };
        self.model.bodies.iter().enumerate().map(place).collect()
    }

    /// Range of the accelerations in a body's part of a slope.
    pub(super) fn rates(&self) -> std::ops::Range<usize> {
        match self.model.kind {
            Kind::Planar => 3..6,
            Kind::Spatial => 7..13,
        }
    }

    /// Accelerations of all bodies, out of a slope.
    pub(super) fn accelerations(&self, slope: &[f64]) -> Vec<f64> {
        slope.chunks(self.width).flat_map(|body| body[self.rates()].iter().copied()).collect()
    }

    /// Moves the places in `y` by `shift`, a displacement and a rotation of each body (3 or 6 numbers).
    pub(super) fn shift(&self, y: &mut [f64], shift: &[f64]) {
        let size = self.rates().len();
        for (state, shift) in y.chunks_mut(self.width).zip(shift.chunks(size)) {
            for i in 0..3 {
                state[i] += shift[i];
            }
            if self.model.kind == Kind::Spatial {
                let turn = DQuat::from_scaled_axis(DVec3::new(shift[3], shift[4], shift[5]));
                let q = turn * DQuat::from_xyzw(state[3], state[4], state[5], state[6]);
                state[3..7].copy_from_slice(&[q.x, q.y, q.z, q.w]);
            }
        }
    }
}
