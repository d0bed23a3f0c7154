//! Friction that turns with its velocity, directly and through a slip angle, against exact solutions.

use super::*;
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::system::System;

/// Speed below which the friction is regularised, far below the increment of the Jacobian's difference quotients.
const LEAST_SPEED: f64 = 1e-10;

/// A unit mass under a force of 0.9 that rotates once in 2π and a regularised friction of 1: it creeps along the
/// force at 0.9 of the regularisation speed.
struct Creep {
    terms: Vec<RankOneTerm>,
    held: Option<DVec2>,
}

impl System for Creep {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        let v = DVec2::new(y[0], y[1]);
        let against = self.held.unwrap_or(v / v.length().max(LEAST_SPEED));
        let force = DVec2::new(t.cos(), t.sin()) * 0.9 - against;
        out.copy_from_slice(&force.to_array());
        let (along, speed) = (v.try_normalize().unwrap_or(DVec2::X), v.length());
        let term = |direction: DVec2, slope: f64| RankOneTerm {
            port: 0,
            input: direction * slope,
            output: direction,
            auxiliary: None,
        };
        let slowing = if speed < LEAST_SPEED { -1.0 / LEAST_SPEED } else { 0.0 };
        self.terms = vec![term(along.perp(), -1.0 / speed.max(LEAST_SPEED)), term(along, slowing)];
    }

    fn size2(&self, d: &[f64]) -> f64 {
        d.iter().map(|x| (x / (1e-6 * LEAST_SPEED)).powi(2)).sum()
    }
}

impl ImplicitSystem for Creep {
    fn port_count(&self) -> usize {
        1
    }

    fn rank_one_terms(&self) -> &[RankOneTerm] {
        &self.terms
    }

    fn freeze(&mut self, held: bool) {
        self.held = held.then_some(DVec2::X * 0.9);
    }

    fn port(&self, _: usize, _: &[f64], push: &mut [f64], view: &mut [f64]) {
        push.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
        view.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
    }
}

#[test]
fn creeping_friction_is_stepped_over_in_a_billion_of_its_time_constants() {
    let mut system = Creep { terms: Vec::new(), held: None };
    let (mut radau, mut y, mut slope) = (Radau::default(), vec![0.9 * LEAST_SPEED, 0.0], vec![0.0; 2]);
    radau.resize(2);
    for i in 0..10 {
        let (t, h) = (0.1 * f64::from(i), 0.1);
        system.slope(t, &y, &mut slope);
        let error = radau.attempt(&mut system, t, &y, &slope, h);
        assert!(error.is_finite(), "Newton's method ends at {t}");
        radau.accept(t, &mut y, h);
        let wanted = DVec2::new((t + h).cos(), (t + h).sin()) * (0.9 * LEAST_SPEED);
        assert!((DVec2::new(y[0], y[1]) - wanted).length() < 1e-6 * LEAST_SPEED, "{y:?} is not {wanted} at {t}");
    }
}

/// Speed of a body on which friction of 1 acts: a step of 0.1 spans 100 time constants of its turning.
const SLOW: f64 = 1e-3;
/// Regularisation length of a slip direction.
const LENGTH: f64 = 1e-11;

/// A unit mass under friction of 1 in a direction `d(φ)` that follows the velocity, `φ̇ = d⊥·v/ℓ`, and under the force
/// for which the velocity turns at a rate of 1: `v = v₀ (cos t, sin t)` and `φ = t − α`, with `sin α = ℓ/v₀`.
struct Following {
    /// 1, or 2 with one at which nothing acts, which has the direction solved together with the velocity.
    ports: usize,
    terms: Vec<RankOneTerm>,
    rates: [f64; 1],
}

impl System for Following {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        let (v, d) = (DVec2::new(y[0], y[1]), DVec2::from_angle(y[2]));
        let force = DVec2::from_angle(t).perp() * SLOW + DVec2::from_angle(t - (LENGTH / SLOW).asin());
        out[..2].copy_from_slice(&(force - d).to_array());
        out[2] = d.perp().dot(v) / LENGTH;
        self.rates = [-d.dot(v) / LENGTH];
        self.terms = vec![RankOneTerm { port: 0, input: -d.perp(), output: d.perp() / LENGTH, auxiliary: Some(0) }];
    }

    fn size2(&self, d: &[f64]) -> f64 {
        [d[0] / SLOW, d[1] / SLOW, d[2]].iter().map(|x| (x / 1e-10).powi(2)).sum()
    }
}

impl ImplicitSystem for Following {
    fn auxiliary_count(&self) -> usize {
        1
    }

    fn auxiliary_rates(&self) -> &[f64] {
        &self.rates
    }

    fn port_count(&self) -> usize {
        self.ports
    }

    fn rank_one_terms(&self) -> &[RankOneTerm] {
        &self.terms
    }

    fn port(&self, port: usize, _: &[f64], push: &mut [f64], view: &mut [f64]) {
        if port > 0 {
            return;
        }
        push.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
        view.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
    }
}

#[test]
fn a_direction_that_follows_is_stepped_over_in_ten_million_of_its_time_constants() {
    for ports in [1, 2] {
        let mut system = Following { ports, terms: Vec::new(), rates: [0.0] };
        let (mut radau, mut y, mut slope) = (Radau::default(), vec![SLOW, 0.0, -(LENGTH / SLOW).asin()], vec![0.0; 3]);
        radau.resize(3);
        for i in 0..10 {
            let (t, h) = (0.1 * f64::from(i), 0.1);
            system.slope(t, &y, &mut slope);
            let error = radau.attempt(&mut system, t, &y, &slope, h);
            assert!(error.is_finite(), "Newton's method ends at {t}, {ports} ports");
            radau.accept(t, &mut y, h);
            let off = DVec2::new(y[0], y[1]) - DVec2::from_angle(t + h) * SLOW;
            assert!(off.length() < 1e-9 * SLOW, "{y:?} is {off} off at {t}");
            assert!((y[2] - (t + h - (LENGTH / SLOW).asin())).abs() < 1e-9, "an angle of {} at {t}", y[2]);
        }
    }
}
