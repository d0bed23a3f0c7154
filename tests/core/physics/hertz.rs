//! A second normal law through the real solver: Hertz's spring, `N = k δ^{3/2}`, against the closed forms of its impact.

use crate::support::{free_hit, within};
use girderbench::contact::normal::Custom;
use girderbench::contact::{Normal, NormalLaw};
use girderbench::dynamics::Model;
use girderbench::scene::Scene;
use girderbench::sim::{History, Session};

/// Duration of an elastic impact in units of `δ_max / v₀`, `2 ∫₀¹ dx/√(1 − x^{5/2}) = ⅘ B(⅖, ½)` \[–\].
const DURATION: f64 = 2.943_275_184_324_704_7;
const STIFFNESS: f64 = 4e6;
const MASS: f64 = 2.0;
const SPEED: f64 = 0.5;
const GAP: f64 = 0.005;

/// `N = k δ √|δ|`, without damping.
#[derive(Debug)]
struct Hertz {
    /// \[N/m^{3/2}\].
    k: f64,
}

impl NormalLaw for Hertz {
    fn elastic(&self, penetration: f64) -> f64 {
        self.k * penetration * penetration.abs().sqrt()
    }

    fn damping(&self, _: f64, _: f64) -> f64 {
        0.0
    }

    fn stored_energy(&self, penetration: f64) -> f64 {
        0.4 * self.elastic(penetration) * penetration
    }

    fn tangent_stiffness(&self, penetration: f64) -> f64 {
        1.5 * self.k * penetration.abs().sqrt()
    }

    fn stiffness_bound(&self, deepest: f64) -> f64 {
        self.tangent_stiffness(deepest)
    }

    fn damping_coefficient(&self, _: f64) -> f64 {
        0.0
    }

    fn damping_bound(&self, _: f64) -> f64 {
        0.0
    }

    fn frequency(&self, mass: f64, speed: f64) -> f64 {
        std::f64::consts::PI * speed / (DURATION * self.depth(mass, speed))
    }

    fn depth(&self, mass: f64, speed: f64) -> f64 {
        (1.25 * mass * speed * speed / self.k).powf(0.4)
    }

    fn can_pull(&self) -> bool {
        false
    }

    fn digest(&self, add: &mut dyn FnMut(f64)) {
        add(self.k);
    }
}

static HERTZ: Hertz = Hertz { k: STIFFNESS };

/// Runs a scene with Hertz's law at every pair; the tangential spring is as stiff as the secant at the largest depth.
fn run(scene: &Scene) -> History {
    let mut model = Model::compile(scene).unwrap_or_else(|errors| panic!("{errors}"));
    let depth = HERTZ.depth(MASS, SPEED);
    for pair in &mut model.pairs {
        pair.law.normal = Normal::Custom(Custom::of(&HERTZ));
        pair.law.k_t = HERTZ.elastic(depth) / depth;
    }
    let mut session = Session::of_model(scene, model);
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    assert!(history.stop().is_none(), "{:?}", history.stop());
    history
}

/// Duration, depth, rebound and force of the impact that `scene` is, with its load shared by `nodes`.
fn check(what: &str, scene: &Scene, nodes: usize) {
    let history = run(scene);
    let depth = (5.0 * MASS * SPEED * SPEED / (4.0 * STIFFNESS)).powf(0.4);
    let duration = DURATION * depth / SPEED;
    assert_eq!(history.hits().touches().len(), nodes, "{what}: one touch a node");
    let motion = |t: f64| history.motion(0, t);
    for touch in history.hits().touches() {
        within(&format!("{what}: start"), touch.start - GAP / SPEED, 1e-12);
        within(&format!("{what}: duration"), (touch.end - touch.start) / duration - 1.0, 1e-8);
        let force = STIFFNESS * depth.powf(1.5) / nodes as f64;
        within(&format!("{what}: a node's share of the peak force"), touch.peak_force / force - 1.0, 1e-8);
    }
    let deepest = motion(GAP / SPEED + 0.5 * duration).displacement.x - GAP;
    within(&format!("{what}: depth"), deepest / depth - 1.0, 1e-8);
    within(&format!("{what}: rebound"), motion(scene.duration).velocity.x / SPEED + 1.0, 1e-8);
    let energy = |t: f64| {
        let books = history.energy().ledger(t);
        books.kinetic + books.contact
    };
    within(&format!("{what}: energy"), energy(GAP / SPEED + 0.4 * duration) / energy(0.0) - 1.0, 1e-8);
}

#[test]
fn a_flush_hit_of_two_corners_follows_the_closed_form() {
    check("along one axis", &free_hit(), 2);
}

#[test]
fn it_does_so_where_the_corners_slide_along_the_face() {
    let mut scene = free_hit();
    (scene.contact.mu_static, scene.contact.mu_kinetic) = (0.0, 0.0);
    scene.girders[0].initial.velocity[1] = 0.05;
    check("sliding without friction", &scene, 2);
}
