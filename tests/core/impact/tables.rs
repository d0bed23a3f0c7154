//! Every row of the paper's Tables 4–10, each by a state that was made for it.

use girderbench::dynamics::Model;
use girderbench::dynamics::impact2d::delassus::{Cluster, ContactPoint};
use girderbench::dynamics::impact2d::impulse::collision::{ContactManifold, ImpactLaw, collide};
use girderbench::dynamics::impact2d::kinematics::BodyKinematics;
use girderbench::dynamics::impact2d::lasting::constrained_motion::ContactMode;
use girderbench::dynamics::impact2d::lasting::mode_selection::{Candidate, Excluded, select_modes};
use girderbench::dynamics::impact2d::{GirderState, Row};
use girderbench::scene::{ImpactSettings, format};
use glam::{DVec2, DVec3};

use GirderState::{Free, FreeTurning, Resting, Sliding, SlidingTurning, Turning};

/// A girder at a wall, by what acts on it: pushes along x and y \[N\], θ, speed along the wall, friction.
struct Held {
    push: [f64; 2],
    theta: f64,
    v_y: f64,
    mu: [f64; 2],
    /// Friction has just given way, `|R_y| > μ_s R_x`.
    broke: bool,
}

const AT_REST: Held = Held { push: [10.0, 1.0], theta: 0.0, v_y: 0.0, mu: [0.20, 0.15], broke: false };
/// Half length and half width of the paper's girder \[m\].
const A: f64 = 0.095;
const B: f64 = 0.035;

/// The row for leaving `from` in a state that is held at the wall.
fn row_between(from: GirderState, held: &Held) -> Option<Row> {
    let text = format!(
        r#"
        name = "held"
        duration_s = 1.0
        [[girder]]
        name = "deck"
        length_m = {}
        width_m = {}
        thickness_m = 0.02
        mass_kg = 2.0
        push = {{ force_n = [{:?}, {:?}] }}
        [[abutment]]
        name = "wall"
        faces = "deck"
        gap_m = 0.0
        width_m = 2.0
        "#,
        2.0 * A,
        2.0 * B,
        held.push[0],
        held.push[1]
    );
    let mut model = Model::compile(&format::parse(&text, "test").expect("a scene")).expect("a sound scene");
    let [r, alpha] = [A.hypot(B), B.atan2(A)];
    // The corner stays at the wall.
    let x = A - r * (alpha - held.theta.abs()).cos();
    let state = [x, 0.0, held.theta, 0.0, held.v_y, 0.0];
    let kinematics = BodyKinematics::new(&model, &[0], &[state], DVec3::ZERO);
    let touching: Vec<(usize, ContactPoint)> =
        (0..2).map(|site| (site, kinematics.point(&model, site))).filter(|(_, p)| p.gap.abs() < 1e-12).collect();
    let mut touching = touching;
    touching.sort_by(|a, b| a.1.along.total_cmp(&b.1.along));
    let (sites, points): (Vec<usize>, Vec<ContactPoint>) = touching.into_iter().unzip();
    let slides = kinematics.cluster.speeds(&points[0])[1];
    let candidate = Candidate {
        pair: 0,
        sites,
        points,
        slip: if slides == 0.0 { 0.0 } else { slides.signum() },
        stick_or_open: false,
        excluded: Excluded { stick: held.broke, site: None },
    };
    model.impact = ImpactSettings { mu_static: held.mu[0], mu_kinetic: held.mu[1], ..ImpactSettings::default() };
    let modes = select_modes(&model, &kinematics, &[candidate]).expect("a consistent motion");
    let to = modes.first().map_or(if held.theta == 0.0 { Free } else { FreeTurning }, ContactMode::state);
    Row::without_hit(from, to)
}

fn expect(from: GirderState, table: u8, cases: &[(u8, Held)]) {
    for (row, held) in cases {
        assert_eq!(row_between(from, held), Some(Row { table, row: *row }), "Table {table}, row {row}");
        let row = Row { table, row: *row };
        assert!(!row.conditions().is_empty(), "{} has its conditions", row.label());
    }
}

#[test]
fn table_4_from_contact_sliding_and_turning() {
    expect(
        SlidingTurning,
        4,
        &[
            (1, AT_REST),
            (2, Held { v_y: 0.1, ..AT_REST }),
            (3, Held { theta: 0.1, mu: [3.0, 2.0], push: [10.0, 0.0], ..AT_REST }),
            (4, Held { theta: 0.1, v_y: 0.1, ..AT_REST }),
            (5, Held { push: [-1.0, 0.0], ..AT_REST }),
            (6, Held { push: [-1.0, 0.0], theta: 0.1, ..AT_REST }),
        ],
    );
}

#[test]
fn table_5_from_contact_turning() {
    expect(
        Turning,
        5,
        &[
            (1, AT_REST),
            (2, Held { push: [10.0, 3.0], ..AT_REST }),
            (3, Held { theta: 0.1, mu: [3.0, 2.0], push: [10.0, 0.0], ..AT_REST }),
            (4, Held { theta: 0.1, mu: [0.01, 0.01], push: [10.0, 0.0], ..AT_REST }),
            (5, Held { push: [-1.0, 0.0], ..AT_REST }),
            (6, Held { push: [-1.0, 0.0], theta: 0.1, ..AT_REST }),
        ],
    );
}

#[test]
fn table_6_from_contact_sliding() {
    expect(
        Sliding,
        6,
        &[
            (1, AT_REST),
            (2, Held { v_y: 0.1, ..AT_REST }),
            (3, Held { push: [10.0, 5.0], mu: [0.9, 0.8], ..AT_REST }),
            // μ_k > b/a: the reaction's line leaves the face.
            (4, Held { v_y: 0.1, mu: [0.5, 0.4], ..AT_REST }),
            (5, Held { push: [-1.0, 0.0], ..AT_REST }),
        ],
    );
}

#[test]
fn table_7_from_contact_resting() {
    expect(
        Resting,
        7,
        &[
            (1, AT_REST),
            (2, Held { push: [10.0, 3.0], ..AT_REST }),
            (3, Held { push: [10.0, 5.0], mu: [0.9, 0.8], ..AT_REST }),
            (4, Held { push: [10.0, 6.0], mu: [0.45, 0.40], broke: true, ..AT_REST }),
            (5, Held { push: [-1.0, 0.0], ..AT_REST }),
        ],
    );
}

/// A hit of a straight girder of unit mass on a wall at +x: its half length and half width, the corner at an angle or the
/// whole face, its velocities, its numbers.
struct Struck {
    half: [f64; 2],
    theta: f64,
    velocity: [f64; 3],
    e_n: f64,
    e_t: f64,
    mu: f64,
}

const HEAD_ON: Struck = Struck { half: [A, B], theta: 0.0, velocity: [1.0, 0.0, 0.0], e_n: 0.4, e_t: -0.9, mu: 0.2 };

impl Struck {
    fn cluster(&self) -> Cluster {
        let [a, b] = self.half;
        let i2 = (a * a + b * b) / 3.0;
        Cluster {
            inverse: [DVec3::new(1.0, 1.0, 1.0 / i2)].into_iter().collect(),
            velocity: [DVec3::from(self.velocity)].into_iter().collect(),
        }
    }

    fn points(&self) -> Vec<ContactPoint> {
        let [a, b] = self.half;
        let corner = |y: f64| {
            let arm = DVec2::from_angle(self.theta).rotate(DVec2::new(a, y));
            let n = DVec2::NEG_X;
            ContactPoint {
                bodies: [Some(0), None],
                n,
                s: n.perp(),
                arms: [arm, DVec2::ZERO],
                gap: 0.0,
                inset: 1.0,
                along: arm.dot(n.perp()),
                bias: [0.0; 2],
            }
        };
        match self.theta {
            0.0 => vec![corner(b), corner(-b)],
            turned if turned > 0.0 => vec![corner(-b)],
            _ => vec![corner(b)],
        }
    }

    fn row(&self, from: GirderState) -> Option<Row> {
        let numbers = ImpactSettings {
            restitution_normal: self.e_n,
            restitution_tangential: self.e_t,
            mu_static: self.mu,
            mu_kinetic: self.mu,
            ..ImpactSettings::default()
        };
        let (mut cluster, points) = (self.cluster(), self.points());
        let law = ImpactLaw { settings: &numbers, speed_noise: cluster.speed_round_off(&points), inelastic: false };
        let manifold = ContactManifold { pair: 0, sites: (0..points.len()).collect(), points: points.into() };
        let collision = collide(&mut cluster, &manifold, from, &law);
        Row::of_hit(&collision.conditions)
    }

    /// Lowest normal velocity of the face's ends after the first impulse, for a restitution and smooth tangents.
    fn worst(&self, e_n: f64) -> (f64, f64) {
        let [a, b] = self.half;
        let i2 = (a * a + b * b) / 3.0;
        let [x, _, w] = self.velocity;
        let zeta = (-b * b * w / (3.0 * x)).clamp(-b, b);
        let q = (1.0 + e_n) * (x - w * zeta) / (1.0 + zeta * zeta / i2);
        let turn = w + zeta * q / i2;
        (-(x - q) - b * turn.abs(), turn)
    }
}

fn hits(from: GirderState, table: u8, cases: &[(u8, Struck)]) {
    for (row, struck) in cases {
        assert_eq!(struck.row(from), Some(Row { table, row: *row }), "Table {table}, row {row}");
        assert!(!Row { table, row: *row }.conditions().is_empty(), "Table {table}, row {row} has its conditions");
    }
}

#[test]
fn table_8_from_free_turning() {
    // The corner's slip after the normal impulse alone is 0: v_s = −w_ns Q_n.
    let corner = Struck { theta: 0.1, e_n: 0.0, e_t: -1.0, ..HEAD_ON };
    let (cluster, point) = (corner.cluster(), corner.points()[0]);
    let [w_n, _, w_ns] = cluster.mobilities(&point);
    let still = [1.0, w_ns * -cluster.speeds(&point)[0] / w_n, 0.0];
    let again = Struck { theta: 0.1, velocity: [1.0, -0.9, 0.0], e_n: 0.0, e_t: 1.0, ..HEAD_ON };
    let tumbling = Struck { velocity: [1.0, 0.5, 5.0], e_n: 0.0, e_t: -1.0, ..HEAD_ON };
    hits(
        FreeTurning,
        8,
        &[
            (1, Struck { theta: 0.1, ..HEAD_ON }),
            (2, Struck { velocity: still, ..corner }),
            (3, Struck { theta: 0.1, e_n: 0.0, e_t: -1.0, velocity: [1.0, 0.4, 0.0], ..HEAD_ON }),
            (4, Struck { mu: 50.0, ..again }),
            (5, Struck { theta: 0.1, velocity: [1.0, -0.9, 0.0], e_n: 0.0, e_t: 1.0, mu: 0.01, ..HEAD_ON }),
            (6, Struck { e_t: -1.0, ..HEAD_ON }),
            (7, Struck { velocity: [1.0, 0.0, 0.3], e_t: -1.0, ..HEAD_ON }),
            (8, Struck { e_n: 0.0, e_t: -1.0, ..HEAD_ON }),
            (9, Struck { e_n: 0.0, e_t: -1.0, velocity: [1.0, 0.3, 0.0], ..HEAD_ON }),
            (10, Struck { mu: 50.0, velocity: [1.0, -0.4, 5.0], ..tumbling }),
            (11, Struck { velocity: [1.0, 0.5, 5.0], e_n: 0.0, e_t: -1.0, mu: 0.01, ..HEAD_ON }),
        ],
    );
}

#[test]
fn table_9_from_translation() {
    let oblique = Struck { velocity: [1.0, 0.3, 0.0], ..HEAD_ON };
    let i2 = (A * A + B * B) / 3.0;
    // θ̇' is the tangential impulse's alone; the corner it drives in just stays at the wall where e_n ẋ = b |θ̇'|.
    let grazing = |e_t: f64| {
        let turn = A / i2 * (1.0 + e_t) * 0.3 / (1.0 + A * A / i2);
        Struck { e_n: B * turn, e_t, velocity: [1.0, 0.3, 0.0], ..HEAD_ON }
    };
    hits(
        Free,
        9,
        &[
            (1, Struck { e_n: 0.0, ..HEAD_ON }),
            (2, HEAD_ON),
            (3, Struck { e_n: 0.0, e_t: -1.0, velocity: [1.0, 0.3, 0.0], ..HEAD_ON }),
            (4, Struck { e_t: -1.0, velocity: [1.0, 0.3, 0.0], ..HEAD_ON }),
            (5, oblique),
            (6, grazing(0.0)),
            (7, grazing(-0.5)),
            (8, Struck { e_n: 0.0, mu: 50.0, velocity: [1.0, 0.3, 0.0], ..HEAD_ON }),
            (9, Struck { e_n: 0.0, mu: 0.001, velocity: [1.0, 0.3, 0.0], ..HEAD_ON }),
        ],
    );
}

#[test]
fn table_10_from_contact_landing_flush() {
    // One corner is on the wall, the other comes in: ẋ = b |θ̇| (50).
    let landing = |half: [f64; 2], v_y: f64| Struck { half, velocity: [2.0 * half[1], v_y, 2.0], e_t: -1.0, ..HEAD_ON };
    let square = [1.0, 1.0];
    // The restitution for which the worst corner just stays: by bisection.
    let probe = landing(square, 0.0);
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if probe.worst(middle).0 < 0.0 { low = middle } else { high = middle }
    }
    let turn = probe.worst(high).1;
    let staying = |v_y: f64| Struck { e_n: high, ..landing(square, v_y) };
    for from in [SlidingTurning, Turning] {
        hits(
            from,
            10,
            &[
                // 1 + e_n = (9 i²/b² + 1)/4 takes the spin away.
                (1, Struck { e_n: 0.75, ..landing(square, 0.0) }),
                (2, Struck { e_n: 1.0, ..landing([A, B], 0.0) }),
                (3, staying(-turn * square[0])),
                (4, staying(0.3)),
                (5, Struck { e_n: 0.0, mu: 50.0, ..landing([A, B], -2.0 * A) }),
                (6, Struck { e_n: 0.0, mu: 0.01, ..landing([A, B], 0.3) }),
            ],
        );
    }
}
