//! The rules of a hit: the paper's printed equations, closed forms, energy.

use crate::support::within;
use girderbench::dynamics::impact2d::GirderState;
use girderbench::dynamics::impact2d::delassus::{Cluster, ContactPoint};
use girderbench::dynamics::impact2d::impulse::collision::{ContactManifold, ImpactLaw, collide};
use girderbench::dynamics::impact2d::impulse::corner::{Coefficients, first_impulse, second_impulse};
use girderbench::dynamics::impact2d::impulse::face::centroid;
use girderbench::scene::{Flush, ImpactSettings};
use glam::{DVec2, DVec3};

/// Numbers from a seed, in \[0, 1) (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// A point on a wall with this normal, at this lever from the girder's G.
fn at_wall(arm: DVec2, n: DVec2) -> ContactPoint {
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
}

/// One girder per unit mass.
fn girder(i2: f64, velocity: DVec3) -> Cluster {
    Cluster {
        inverse: [DVec3::new(1.0, 1.0, 1.0 / i2)].into_iter().collect(),
        velocity: [velocity].into_iter().collect(),
    }
}

/// The straight girder of Fig. 12, hit on a corner by a wall at x = a + c: `r`, `Ω`, sgn θ.
struct Straight {
    r: f64,
    omega: f64,
    sign: f64,
    i2: f64,
}

impl Straight {
    fn random(random: &mut Random) -> Self {
        let (a, b) = (random.between(0.05, 0.2), random.between(0.01, 0.1));
        let theta = random.between(0.01, 0.3);
        let sign = if random.next() < 0.5 { -1.0 } else { 1.0 };
        let r = a.hypot(b);
        Self { r, omega: b.atan2(a) - theta, sign, i2: (a * a + b * b) / 3.0 }
    }

    /// (11): the corner from G.
    fn arm(&self) -> DVec2 {
        DVec2::new(self.r * self.omega.cos(), -self.sign * self.r * self.omega.sin())
    }
}

#[test]
fn a_corner_hit_is_29_and_31_as_printed() {
    let mut random = Random(29);
    let mut worst = 0.0f64;
    for _ in 0..1000 {
        let g = Straight::random(&mut random);
        let [x, y, w] = [(); 3].map(|()| random.between(-1.0, 1.0));
        let w = 10.0 * w;
        let (e_x, e_y) = (random.next(), random.between(-1.0, 1.0));
        let mut cluster = girder(g.i2, DVec3::new(x, y, w));
        let numbers = Coefficients { e_n: e_x, e_t: e_y, mu_s: 0.2, mu_k: 0.15 };
        let ([p_n, p_s], _) = first_impulse(&mut cluster, &at_wall(g.arm(), DVec2::NEG_X), &numbers);
        let (r, sin, cos) = (g.r, g.omega.sin(), g.omega.cos());
        let q_x = -(1.0 + e_x) * (x + g.sign * w * r * sin) / (1.0 + r * r * sin * sin / g.i2);
        let q_y = -(1.0 + e_y) * (y + w * r * cos + g.sign * r * r * cos * sin / g.i2 * q_x)
            / (1.0 + r * r * cos * cos / g.i2);
        // The wall's normal is −x, its tangent −y.
        worst = worst.max((p_n + q_x).abs()).max((p_s + q_y).abs());
    }
    within("(29), (31)", worst, 1e-14 * 10.0);
}

#[test]
fn a_second_impulse_is_35_37_39_or_43_as_printed() {
    let (mut random, mut worst, mut held, mut slid) = (Random(35), 0.0f64, 0, 0);
    for _ in 0..4000 {
        let g = Straight::random(&mut random);
        let [x, y, w] = [(); 3].map(|()| random.between(-1.0, 1.0));
        let w = 10.0 * w;
        let mut cluster = girder(g.i2, DVec3::new(x, y, w));
        let point = at_wall(g.arm(), DVec2::NEG_X);
        if cluster.speeds(&point)[0] >= 0.0 {
            continue;
        }
        let numbers = Coefficients { e_n: 0.4, e_t: -0.9, mu_s: 0.2, mu_k: 0.15 };
        let v_s = cluster.speeds(&point)[1];
        let energy = |c: &Cluster| 0.5 * (c.velocity[0].truncate().length_squared() + g.i2 * c.velocity[0].z.powi(2));
        let before = energy(&cluster);
        let again = second_impulse(&mut cluster, &point, &numbers, 0.0);
        assert!(energy(&cluster) <= before * (1.0 + 1e-14), "no energy is added");
        let (r, sin, cos) = (g.r, g.omega.sin(), g.omega.cos());
        let after = cluster.velocity[0];
        if again.held {
            held += 1;
            let turn = (g.i2 * w - g.sign * x * r * sin - y * r * cos) / (g.i2 + r * r);
            let (q_x, q_y) = (-x - g.sign * turn * r * sin, -y - turn * r * cos);
            worst = worst.max((after.z - turn).abs() / 10.0);
            worst = worst.max((again.impulse[0] + q_x).abs()).max((again.impulse[1] + q_y).abs());
        } else if cluster.speeds(&point)[1] * v_s >= 0.0 {
            slid += 1;
            // ẏ0' is along +y, our v_s along −y.
            let slip = -v_s.signum() * numbers.mu_k;
            let turn = (g.i2 * w - (slip * r * cos + g.sign * r * sin) * x)
                / (g.i2 + slip * g.sign * r * r * cos * sin + r * r * sin * sin);
            worst = worst.max((after.z - turn).abs() / 10.0);
            worst = worst.max((after.x + g.sign * turn * r * sin).abs());
        }
    }
    assert!(held > 100 && slid > 100, "both rules are met: {held} held, {slid} slid");
    within("(35), (37), (39), (43)", worst, 1e-13);
}

#[test]
fn a_flush_hit_acts_where_44_says() {
    let mut random = Random(44);
    for _ in 0..500 {
        let (a, b) = (random.between(0.05, 0.2), random.between(0.01, 0.1));
        let (x, w) = (random.between(0.1, 1.0), random.between(-1.0, 1.0));
        let cluster = girder((a * a + b * b) / 3.0, DVec3::new(x, random.next(), w));
        // Further back along s = −y is +y.
        let ends = [DVec2::new(a, b), DVec2::new(a, -b)].map(|arm| at_wall(arm, DVec2::NEG_X));
        let place = ends[0].towards(&ends[1], centroid(&cluster, &ends)).arms[0].y;
        let printed = (-b * b * w / (3.0 * x)).clamp(-b, b);
        assert!((place - printed).abs() < 1e-15, "{place} against {printed}");
    }
}

#[test]
fn no_hit_adds_energy_and_none_leaves_a_point_driven_in() {
    let mut random = Random(7);
    let (mut jammed, mut faces) = (0, 0);
    for round in 0..40_000 {
        let two = random.next() < 0.5;
        let body = |random: &mut Random| {
            let mass = 10f64.powf(random.between(-2.0, 2.0));
            DVec3::new(1.0 / mass, 1.0 / mass, 1.0 / (mass * random.between(0.01, 1.0)))
        };
        let speed = |random: &mut Random| DVec3::from([(); 3].map(|()| random.between(-1.0, 1.0)));
        let cluster = Cluster {
            inverse: (0..=usize::from(two)).map(|_| body(&mut random)).collect(),
            velocity: (0..=usize::from(two)).map(|_| speed(&mut random)).collect(),
        };
        let n = DVec2::from_angle(random.between(0.0, std::f64::consts::TAU));
        let mut point = at_wall(DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0)), n);
        point.bodies[1] = two.then_some(1);
        point.arms[1] = DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let mut points = vec![point];
        if random.next() < 0.6 {
            let length = random.between(0.01, 1.0);
            let mut other = point;
            other.arms = point.arms.map(|arm| arm + point.s * length);
            other.along += length;
            points.push(other);
        }
        if points.iter().all(|p| cluster.speed(p, p.n) >= 0.0) {
            continue;
        }
        let mu_s = random.between(0.0, 3.0);
        let numbers = ImpactSettings {
            restitution_normal: random.next(),
            restitution_tangential: random.between(-1.0, 1.0),
            mu_static: mu_s,
            mu_kinetic: mu_s * random.next(),
            flush: if round % 2 == 0 { Flush::Paper } else { Flush::TwoCorner },
            ..ImpactSettings::default()
        };
        let speed_noise = cluster.speed_round_off(&points);
        let law = ImpactLaw { settings: &numbers, speed_noise, inelastic: false };
        let manifold =
            ContactManifold { pair: 0, sites: (0..points.len()).collect(), points: points.iter().copied().collect() };
        let mut after = cluster.clone();
        let collision = collide(&mut after, &manifold, GirderState::FreeTurning, &law);
        // Held by more than friction.
        let beyond = |p: [f64; 2]| p[1].abs() > mu_s * p[0] * (1.0 + 1e-9);
        let edge = collision.conditions.flush && round % 2 == 1 && beyond(collision.impulses.first);
        jammed += usize::from(
            edge || collision.impulses.second.is_some_and(|(_, again)| again.held && beyond(again.impulse)),
        );
        faces += usize::from(collision.conditions.flush);
        let energy = |c: &Cluster| {
            let body = |(v, i): (&DVec3, &DVec3)| (0..3).map(|k| 0.5 * v[k] * v[k] / i[k]).sum::<f64>();
            c.velocity.iter().zip(&c.inverse).map(body).sum::<f64>()
        };
        let (start, end) = (energy(&cluster), energy(&after));
        assert!(end <= start * (1.0 + 1e-12), "round {round}: {start} J became {end} J: {collision:?}");
        assert!(
            (start - end - collision.impulses.lost).abs() <= 1e-12 * start,
            "round {round}: {} J lost",
            collision.impulses.lost
        );
        if collision.conditions.flush || points.len() == 1 {
            let least = points.iter().map(|p| after.speed(p, p.n)).fold(f64::INFINITY, f64::min);
            assert!(least >= -10.0 * speed_noise, "round {round}: {least} m/s into the wall: {collision:?}");
        }
    }
    assert!(faces > 1000, "{faces} hits along a face");
    // Past the Painlevé bound staying put takes w_n/|w_ns| ≤ μ_k of the push at most: less than there is.
    assert_eq!(jammed, 0, "held by more than friction");
}
