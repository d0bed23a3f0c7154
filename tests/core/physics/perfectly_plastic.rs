//! A normal law with a memory, defined outside of the package, through the real solver: a spring `K` that yields at `N_y`, unloads with `K` and
//! has no force until it is loaded at its permanent depth again, against the closed form of its impact.

use std::f64::consts::FRAC_PI_2;

use crate::support::{free_hit, within};
use girderbench::contact::normal::{Custom, Phase, PhasedLaw, Phases};
use girderbench::contact::{Normal, NormalLaw};
use girderbench::dynamics::Model;
use girderbench::sim::Session;

const K: f64 = 1.55e5;
/// Penetration at yield \[m\].
const YIELD: f64 = 1e-3;
const MASS: f64 = 2.0;
const SPEED: f64 = 0.5;
const GAP: f64 = 0.005;

const ELASTIC: u32 = 0;
const YIELDING: u32 = 1;
const PARTED: u32 = 2;

/// Elastic and perfectly plastic spring; the memory is the penetration at which it has no force, the permanent depth `δ₀` \[m\].
#[derive(Clone, Copy, Debug)]
struct Plastic {
    phase: Phase,
}

static PLASTIC: Plastic = Plastic { phase: Phase { number: ELASTIC, memory: 0.0 } };

impl PhasedLaw for Plastic {
    fn phase(&self) -> Phase {
        self.phase
    }

    fn in_phase(self, phase: Phase) -> Self {
        Self { phase }
    }
}

impl Phases for Plastic {
    fn has_phases(&self) -> bool {
        true
    }

    fn begun(self, _: f64, _: f64) -> Self {
        PLASTIC
    }

    fn phase_end(&self, penetration: f64, velocity: f64) -> f64 {
        let Phase { number, memory } = self.phase;
        match number {
            ELASTIC if memory == 0.0 => penetration - YIELD,
            ELASTIC => (penetration - memory - YIELD).max(memory - penetration),
            YIELDING => velocity,
            _ => penetration - memory,
        }
    }

    fn phase_end_scale(&self, _: f64, speed: f64) -> f64 {
        if self.phase.number == YIELDING { speed } else { YIELD }
    }

    fn phase_end_change(&self, change: f64, frequency: f64) -> f64 {
        if self.phase.number == YIELDING { change * frequency } else { change }
    }

    fn next_phase(self, penetration: f64) -> Self {
        let Phase { number, memory } = self.phase;
        let phase = match number {
            ELASTIC if penetration - memory > 0.5 * YIELD => Phase { number: YIELDING, memory },
            ELASTIC => Phase { number: PARTED, memory },
            YIELDING => Phase { number: ELASTIC, memory: penetration - YIELD },
            _ => Phase { number: ELASTIC, memory },
        };
        Self { phase }
    }
}

impl NormalLaw for Plastic {
    fn elastic(&self, penetration: f64) -> f64 {
        match self.phase.number {
            ELASTIC => K * (penetration - self.phase.memory),
            YIELDING => K * YIELD,
            _ => 0.0,
        }
    }

    fn damping(&self, _: f64, _: f64) -> f64 {
        0.0
    }

    fn stored_energy(&self, penetration: f64) -> f64 {
        0.5 * self.elastic(penetration).powi(2) / K
    }

    fn tangent_stiffness(&self, _: f64) -> f64 {
        if self.phase.number == ELASTIC { K } else { 0.0 }
    }

    fn stiffness_bound(&self, _: f64) -> f64 {
        K
    }

    fn damping_coefficient(&self, _: f64) -> f64 {
        0.0
    }

    fn damping_bound(&self, _: f64) -> f64 {
        0.0
    }

    fn frequency(&self, mass: f64, _: f64) -> f64 {
        (K / mass).sqrt()
    }

    fn depth(&self, mass: f64, speed: f64) -> f64 {
        let elastic = speed * (mass / K).sqrt();
        if elastic <= YIELD { elastic } else { 0.5 * (YIELD + elastic * elastic / YIELD) }
    }

    fn can_pull(&self) -> bool {
        false
    }

    fn entry_energy(&self, penetration: f64) -> f64 {
        self.stored_energy(penetration)
    }

    fn plastic_power(&self, velocity: f64) -> f64 {
        if self.phase.number == YIELDING { -K * YIELD * velocity } else { 0.0 }
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        add(self.phase.memory);
    }
}

#[test]
fn a_spring_that_yields_and_parts_follows_the_closed_form() {
    let scene = free_hit();
    let mut model = Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    for pair in &mut model.pairs {
        pair.law.normal = Normal::Custom(Custom::phased(&PLASTIC));
    }
    let mut session = Session::of_model(&scene, model);
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    assert!(history.stop().is_none(), "{:?}", history.stop());

    let (omega, force) = ((K / MASS).sqrt(), K * YIELD);
    let at_yield = (SPEED * SPEED - (omega * YIELD).powi(2)).sqrt();
    let depth = YIELD + 0.5 * MASS * at_yield * at_yield / force;
    let rebound = omega * YIELD;
    let deepest = (omega * YIELD / SPEED).asin() / omega + MASS * at_yield / force;
    let duration = deepest + FRAC_PI_2 / omega + (depth - YIELD) / rebound;
    assert_eq!(history.hits().touches().len(), 2, "one touch a corner");
    for touch in history.hits().touches() {
        within("start", touch.start - GAP / SPEED, 1e-12);
        within("duration", (touch.end - touch.start) / duration - 1.0, 1e-9);
        within("a corner's share of the peak force", touch.peak_force / (0.5 * force) - 1.0, 1e-9);
    }
    within("depth", (history.motion(0, GAP / SPEED + deepest).displacement.x - GAP) / depth - 1.0, 1e-9);
    within("rebound", history.motion(0, scene.duration).velocity.x / rebound + 1.0, 1e-9);
    let books = history.energy().ledger(scene.duration);
    within("work of yielding", books.loss_normal / (force * (depth - YIELD)) - 1.0, 1e-9);
    within("balance", books.residual / books.scale, 1e-12);
}
