//! Piers: bodies with mass on their columns, and the bearings between girders and them (`docs/physics.md#piers`).

use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use crate::dynamics::connection::{Device, Kinematics, Link};
use crate::dynamics::devices::{ElastoPlastic, Hysteresis, LinearBearing};
use crate::dynamics::model::bearing::{Bearing, PlanarBearings};
use crate::dynamics::model::body::{Body, BodyCoordinates};
use crate::dynamics::model::compiled_model::{Model, Pier};
use crate::dynamics::model::coordinates::section_forces::LinkOf;
use crate::dynamics::model::rate_bounds::RateBounds;
use crate::geometry::Prism;
use crate::scene::{self, Kind, MovingSupports, ResolvedPier, Scene};

/// The bodies of a scene's piers; their column is a bearing of the body, less what yields of it.
pub(super) fn bodies(scene: &Scene, moving: Option<&MovingSupports>) -> Vec<Body> {
    let foot = |number: usize| moving.and_then(|moving| moving.of_pier(number));
    let of = |(number, pier): (usize, &scene::Pier)| body(&pier.name, &scene.pier(number), foot(number).is_some());
    scene.piers.iter().enumerate().map(of).collect()
}

/// A pier; its column is links where its foot moves otherwise than the ground of reference.
fn body(name: &str, pier: &ResolvedPier, linked: bool) -> Body {
    let [length, width, thickness] = pier.cap;
    let prism = Prism { length, width, thickness, skew: std::f64::consts::FRAC_PI_2 };
    let gyration2 = pier.inertia / pier.mass;
    let mut inertia = prism.inertia_per_mass() * pier.mass;
    inertia.z_axis.z = pier.inertia;
    let free = [true, true, false, false, false, pier.turn_stiffness.is_some()];
    let bearings = if linked { Vec::new() } else { column(pier) };
    Body {
        rate_bounds: RateBounds::of(&prism, pier.mass, [prism.radius(), gyration2], free, &bearings),
        planar: PlanarBearings::gather(&bearings, pier.axes),
        axes: pier.axes,
        mass: pier.mass,
        gyration2,
        inertia,
        inverse_inertia: inertia.inverse(),
        bearings,
        free,
        ..Body::immovable(name.to_owned(), BodyCoordinates::Planar, prism, pier.top)
    }
}

/// The elastic part of a pier's column: two springs beside its axis, so far apart along that their resistance across makes
/// `k_θ = k d²`, and two dashpots so far apart that they make `c_θ = k_θ c/k`, with k of the column before it yields.
fn column(pier: &ResolvedPier) -> Vec<Bearing> {
    let elastic = pier.yielding.map_or(1.0, |yielding| yielding.ratio);
    let [along, across] = pier.stiffness.map(|k| 0.5 * elastic * k);
    let [c_along, c_across] = pier.damping.map(|c| 0.5 * c);
    let apart = |across: f64| pier.turn_stiffness.map_or(0.0, |turn| (0.5 * turn / across).sqrt());
    let element = |x: f64, stiffness: DVec3, damping: DVec3| Bearing {
        place: DVec3::X * x,
        stiffness,
        damping,
        preload: DVec3::ZERO,
    };
    let (spring, dashpot) = (DVec3::new(along, across, 0.0), DVec3::new(c_along, c_across, 0.0));
    let [yielded, whole] = [apart(across), apart(0.5 * pier.stiffness[1])];
    if yielded == whole {
        return vec![element(whole, spring, dashpot), element(-whole, spring, dashpot)];
    }
    let springs = [yielded, -yielded].map(|x| element(x, spring, DVec3::ZERO));
    let dashpots = [whole, -whole].map(|x| element(x, DVec3::ZERO, dashpot));
    springs.into_iter().chain(dashpots).collect()
}

impl Model {
    /// Adds the yielding bases of piers, whose bodies are the last ones; their groups are formed later.
    pub(in crate::dynamics) fn add_piers(&mut self, scene: &Scene) {
        let from = self.bodies.len() - self.foundations.len() - scene.piers.len();
        for number in 0..scene.piers.len() {
            let (body, resolved) = (from + number, scene.pier(number));
            let foot = self.moving.as_ref().and_then(|moving| moving.supports.of_pier(number));
            let foot = foot.and_then(|motion| self.foundation(motion, (&scene.piers[number].name, resolved.top)));
            let column = foot.map_or(0..0, |foot| self.add_column([body, foot], &resolved));
            let yielding = self.add_base([Some(body), foot], &resolved);
            self.piers.push(Pier { body, yielding, column });
        }
    }

    /// The part of a pier's base that yields, on one circle where both directions are alike; its number among the links.
    fn add_base(&mut self, bodies: [Option<usize>; 2], pier: &ResolvedPier) -> Option<usize> {
        let elements = pier.yielding?.part(pier.stiffness).map(|[stiffness, force]| ElastoPlastic { stiffness, force });
        let device =
            if elements[0] == elements[1] { Hysteresis::Circle(elements[0]) } else { Hysteresis::PerAxis(elements) };
        self.add_link(self.between(bodies, (pier, DVec3::ZERO), "base", Arc::new(device)), LinkOf::Device);
        Some(self.links.len() - 1)
    }

    /// The elastic part of a column on a foot that moves; the numbers of its links.
    fn add_column(&mut self, [body, foot]: [usize; 2], pier: &ResolvedPier) -> Range<usize> {
        let from = self.links.len();
        for (n, Bearing { place, stiffness, damping, .. }) in (1..).zip(column(pier)) {
            let spring = Arc::new(LinearBearing { stiffness, damping });
            self.add_link(
                self.between([Some(body), Some(foot)], (pier, place), &format!("column{n}"), spring),
                LinkOf::Device,
            );
        }
        from..self.links.len()
    }

    /// A link between a place of a pier, in its own axes \[m\], and its foot below.
    fn between(
        &self,
        bodies: [Option<usize>; 2],
        (pier, place): (&ResolvedPier, DVec3),
        what: &str,
        device: Arc<dyn Device>,
    ) -> Link {
        let arm = pier.axes * place;
        let foot = bodies[1].map_or(pier.top + arm, |foot| self.bodies[foot].home);
        let name = bodies[0].map_or("", |body| self.bodies[body].name.as_str());
        Link {
            name: format!("{name}.{what}"),
            bodies,
            arms: [arm, pier.top + arm - foot],
            sections: [0; 2],
            homes: [pier.top, foot],
            axes: pier.axes,
            kinematics: Kinematics::Linear,
            device,
        }
    }

    /// A link between a place of a girder and the point of a pier below.
    pub(super) fn bearing_link(&self, name: String, bodies: [usize; 2], place: DVec3, device: Arc<dyn Device>) -> Link {
        let [girder, pier] = bodies.map(|body| &self.bodies[body]);
        let arm = girder.axes * place;
        // Bearings of planar scenes are linear in the rotations, as those on the ground are. In space the force acts on both bodies
        // at the girder's point: only in axes that turn with the pier its work is that of spring and dashpot.
        let kinematics = if self.kind == Kind::Planar { Kinematics::Linear } else { Kinematics::Carried };
        Link {
            name,
            bodies: bodies.map(Some),
            arms: [arm, girder.home + arm - pier.home],
            sections: [0; 2],
            homes: [girder.home, pier.home],
            axes: girder.axes,
            kinematics,
            device,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, format};

    #[test]
    fn a_pier_whose_base_yields_keeps_the_dashpot_of_its_rotation() {
        let body = |lines: &str| {
            let text = format!(
                "format = 1\nname = \"pier\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\n\
                 thickness_m = 1.5\nmass_kg = 3e5\nbearings = [{{ at_m = [14.0, 0.0], stiffness_n_per_m = [1e7, 1e7], damping_n_s_per_m = [0, 0], on = \"p\" }}]\n\
                 [[pier]]\nname = \"p\"\nmass_kg = 1.2e5\nstiffness_n_per_m = [6e7, 9e7]\ndamping_ratio = [0.05, 0.04]\n\
                 turn_stiffness_n_m_per_rad = 4e9\nturn_inertia_kg_m2 = 1.5e6\n{lines}"
            );
            let scene: Scene = format::read(&text, "pier").unwrap_or_else(|errors| panic!("{errors}"));
            let model = Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}"));
            model.bodies.last().expect("the pier").planar
        };
        let (elastic, yields) = (body(""), body("yield_force_n = [1e6, 1.5e6]\npost_yield_ratio = 0.08\n"));
        let of = |bearings: &PlanarBearings, i: usize| [bearings.stiffness.col(i)[i], bearings.damping.col(i)[i]];
        for i in 0..2 {
            let ([k, c], [k2, c2]) = (of(&elastic, i), of(&yields, i));
            assert!(
                (k2 / k - 0.08).abs() < 1e-12 && (c2 / c - 1.0).abs() < 1e-12,
                "direction {i}: {k2} of {k}, {c2} of {c}"
            );
        }
        let ([k, c], [k2, c2]) = (of(&elastic, 2), of(&yields, 2));
        assert!((k / 4e9 - 1.0).abs() < 1e-12 && (k2 / 4e9 - 1.0).abs() < 1e-12, "{k} and {k2} N·m");
        let [across, dashpot] = of(&elastic, 1);
        assert!(
            (c / (4e9 * dashpot / across) - 1.0).abs() < 1e-12 && (c2 / c - 1.0).abs() < 1e-12,
            "{c} and {c2} N·m·s"
        );
    }
}
