//! Reactions of contacts at rest that are statically indeterminate.
//!
//! A girder that two walls hold at opposite corners has more reactions than equations: pressure along the line between the corners balances
//! itself. The accelerations of contacts that stick are unique then, the reactions are not, and Coulomb's law asks no more than that some
//! of them lie in the friction cones: the girder is *wedged*. Elastic bodies end there: where a contact reaches its cone first it slides
//! by its elastic stretch until the others carry (`docs/impact-model.md#ends-well`).
//!
//! With the generators `G_j` of all cones (`n ± μ_s s` at a point at rest, `n − μ_k σ s` at one that slips), the free accelerations `a` and
//! those `a*` of contacts that stick, sought is `λ ≥ 0` with `M⁻¹ Σ λ_j G_j = a* − a`. It is the non-negative least-squares
//! solution in the mass metric, where its residual is round-off.

use glam::{DVec2, DVec3};

use crate::dynamics::impact2d::InlineVec;
use crate::dynamics::impact2d::constants::CONE_RESIDUAL;
use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint};
use crate::dynamics::impact2d::impulse::simultaneous::non_negative_impulses;
use crate::dynamics::impact2d::kinematics::BodyKinematics;
use crate::dynamics::impact2d::lasting::constrained_motion::{
    ConstrainedMotion, ContactMode, FrictionMode, Reaction, least_reactions,
};
use crate::scene::ImpactSettings;

/// A generator of a friction cone.
struct Generator {
    /// Contact mode and point of the contact.
    of: [usize; 2],
    point: ContactPoint,
    /// Force per unit.
    force: DVec2,
}

/// Solves for the reactions of all contacts, `points` being theirs: those of least norm, of wedged contacts those within the friction cones
/// where there are such. None where a number is not finite.
pub fn solve_reactions(
    kinematics: &BodyKinematics,
    modes: &[ContactMode],
    points: &[Vec<ContactPoint>],
    settings: &ImpactSettings,
) -> Option<ConstrainedMotion> {
    let motion = least_reactions(kinematics, modes, points, settings)?;
    if modes.iter().any(|mode| mode.friction == FrictionMode::Wedged)
        && let Some(reactions) = reactions_in_cones(kinematics, modes, points, settings, &motion)
    {
        return Some(ConstrainedMotion { reactions, ..motion });
    }
    Some(motion)
}

/// Reactions within all friction cones with these accelerations of contacts that stick; none where there are no such.
pub(in crate::dynamics::impact2d) fn reactions_in_cones(
    kinematics: &BodyKinematics,
    modes: &[ContactMode],
    points: &[Vec<ContactPoint>],
    settings: &ImpactSettings,
    motion: &ConstrainedMotion,
) -> Option<Vec<Reaction>> {
    let cluster = &kinematics.cluster;
    let generators = generators(modes, points, settings);
    let wanted: InlineVec<DVec3> =
        kinematics.free.iter().zip(&motion.accelerations).map(|(free, held)| *free - *held).collect();
    let rows: Vec<(ContactPoint, DVec2)> = generators.iter().map(|g| (g.point, g.force)).collect();
    let rate = |(point, force): &(ContactPoint, DVec2)| {
        let part = |(body, row): (Option<usize>, DVec3)| body.map_or(0.0, |b| row.dot(wanted[b]));
        point.row(*force).into_iter().map(part).sum::<f64>()
    };
    let rates: Vec<f64> = rows.iter().map(rate).collect();
    let sizes = non_negative_impulses(cluster, &rows, &rates, 0);
    let mut left = wanted.clone();
    for ((point, force), size) in rows.iter().zip(&sizes) {
        for (body, row) in point.row(*force * *size) {
            if let Some(b) = body {
                left[b] += cluster.inverse[b] * row;
            }
        }
    }
    if energy(cluster, &left) > CONE_RESIDUAL * CONE_RESIDUAL * energy(cluster, &kinematics.free) {
        return None;
    }
    let mut reactions = vec![Reaction::default(); modes.len()];
    for (generator, size) in generators.iter().zip(sizes) {
        let [mode, at] = generator.of;
        reactions[mode].normal[at] += size;
        reactions[mode].tangential += size * generator.force.dot(generator.point.s);
    }
    Some(reactions)
}

fn generators(modes: &[ContactMode], points: &[Vec<ContactPoint>], settings: &ImpactSettings) -> Vec<Generator> {
    let mut all = Vec::new();
    for (number, (mode, points)) in modes.iter().zip(points).enumerate() {
        let [mu_s, mu_k] = mode.friction_coefficients(settings);
        let (along, at): ([f64; 2], Option<usize>) = match mode.friction {
            FrictionMode::Stick | FrictionMode::Wedged => ([-mu_s, mu_s], None),
            FrictionMode::Slip(sign) => ([-mu_k * sign; 2], None),
            FrictionMode::SlipAtEnd { sign, end } => (mode.friction_at_end(settings).map(|mu| -mu * sign), Some(end)),
            FrictionMode::Frictionless => ([0.0; 2], None),
        };
        let edges = if along[0] == along[1] { &along[..1] } else { &along[..] };
        for (i, point) in points.iter().enumerate().filter(|(i, _)| at.is_none_or(|end| end == *i)) {
            all.extend(edges.iter().map(|friction| Generator {
                of: [number, i],
                point: *point,
                force: point.n + point.s * *friction,
            }));
        }
    }
    all
}

/// Sum of `m a²` over all bodies in directions that are free.
fn energy(cluster: &Cluster, accelerations: &[DVec3]) -> f64 {
    let part = |a: f64, inverse: f64| if inverse > 0.0 { a * a / inverse } else { 0.0 };
    let body = |(a, inverse): (&DVec3, &DVec3)| (0..3).map(|i| part(a[i], inverse[i])).sum::<f64>();
    accelerations.iter().zip(&cluster.inverse).map(body).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::impact2d::lasting::constrained_motion::are_indeterminate;
    use crate::dynamics::model::coordinates::planar::WIDTH;
    use crate::scene::format;

    /// Half length, half width of the girder \[m\] and its turn \[rad\].
    const HALF: [f64; 2] = [0.1, 0.025];
    const TURN: f64 = 20.0 * std::f64::consts::PI / 180.0;

    /// A girder of 2 kg, turned, between two parallel walls that it touches with opposite corners, pushed along them by 5 N.
    fn between_walls() -> (Model, BodyKinematics, Vec<ContactMode>) {
        let gap = HALF[0] * TURN.cos() + HALF[1] * TURN.sin() - HALF[0];
        let wall = |name: &str, end: &str| {
            format!(
                "[[abutment]]\nname = \"{name}\"\nfaces = \"deck\"\nend = \"{end}\"\ngap_m = {gap:e}\nwidth_m = 2.0\n"
            )
        };
        let text = format!(
            "name = \"wedge\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = {:?}\nwidth_m = {:?}\n\
             thickness_m = 0.02\nmass_kg = 2.0\npush = {{ force_n = [0.0, 5.0] }}\n{}{}",
            2.0 * HALF[0],
            2.0 * HALF[1],
            wall("left", "-x"),
            wall("right", "+x")
        );
        let model = Model::compile(&format::parse(&text, "test").expect("a scene")).expect("a sound scene");
        let mut state = [0.0; WIDTH];
        state[2] = TURN;
        let kinematics = BodyKinematics::new(&model, &[0], &[state], DVec3::ZERO);
        let touching = |pair: usize| {
            let near = |&site: &usize| kinematics.point(&model, site).gap.abs() < 1e-12;
            model.pairs[pair].sites.clone().find(near).expect("a corner at the wall")
        };
        let mode = |pair: usize| ContactMode { pair, sites: vec![touching(pair)], friction: FrictionMode::Wedged };
        let modes = vec![mode(0), mode(1)];
        (model, kinematics, modes)
    }

    #[test]
    fn a_girder_is_wedged_where_the_line_between_its_corners_lies_in_both_friction_cones() {
        let (model, kinematics, modes) = between_walls();
        let points: Vec<_> = modes.iter().map(|mode| mode.points(&model, &kinematics)).collect();
        let across = HALF[0] * TURN.sin() - HALF[1] * TURN.cos();
        let along = HALF[0] * TURN.cos() + HALF[1] * TURN.sin();
        for (part, holds) in [(0.99, false), (1.01, true), (3.0, true)] {
            let mu = part * across / along;
            let settings = ImpactSettings { mu_static: mu, mu_kinetic: 0.5 * mu, ..ImpactSettings::default() };
            assert!(are_indeterminate(&kinematics, &modes, &points, &settings), "four reactions, three equations");
            let motion = least_reactions(&kinematics, &modes, &points, &settings).expect("a motion");
            assert!(motion.accelerations[0].length() < 1e-10, "at rest: {:?}", motion.accelerations);
            let least = motion.reactions[0];
            assert!(least.tangential.abs() > mu * least.total(), "those of least norm leave the cones: {least:?}");
            let reactions = reactions_in_cones(&kinematics, &modes, &points, &settings, &motion);
            assert_eq!(reactions.is_some(), holds, "{part}: {reactions:?}");
            let Some(reactions) = reactions else { continue };
            let sum: DVec2 = reactions
                .iter()
                .zip(&points)
                .map(|(r, points)| points[0].n * r.total() + points[0].s * r.tangential)
                .sum();
            assert!((sum + DVec2::new(0.0, 5.0)).length() < 1e-7, "they carry the push: {sum}");
            for reaction in &reactions {
                assert!(reaction.tangential.abs() <= mu * reaction.total() * (1.0 + 1e-9), "{reaction:?}");
            }
        }
    }

    #[test]
    fn one_corner_at_a_wall_is_not_indeterminate() {
        let (model, kinematics, modes) = between_walls();
        let points = vec![modes[0].points(&model, &kinematics)];
        assert!(!are_indeterminate(&kinematics, &modes[..1], &points, &ImpactSettings::default()), "two of three");
    }
}
