//! Elastic girders of a scene: how many polynomials each needs, and their bodies (`docs/physics.md#flexible-girders`).

use std::sync::Arc;

use glam::{DVec2, DVec3};

use crate::dynamics::connection::Phase;
use crate::dynamics::devices::laws;
use crate::dynamics::elastic::{Beam, Modes, Softness, SpaceBeam, SpaceModes, automatic_degree};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::coordinates::elastic::ElasticGirder;
use crate::dynamics::model::coordinates::elastic_space::SpatialElasticGirder;
use crate::dynamics::model::coordinates::modal_springs::ModalDamping;
use crate::dynamics::model::elastic_body::ElasticBody;
use crate::geometry::Prism;
use crate::scene::device::{DeviceId, Joint, Part};
use crate::scene::facing::Facing;
use crate::scene::{Elastic, Girder, Kind, ResolvedBearing, ResolvedElastic, Scene};

/// Elastic properties of a girder with a section in the scene, and its degrees of freedom.
#[derive(Clone, Debug)]
pub struct Flexible {
    /// Its beam, along the axis and in plan.
    pub beam: Beam,
    /// Its beam with vertical bending and torsion too, in a spatial scene.
    pub space: Option<SpaceBeam>,
    /// Section and moduli.
    pub section: ResolvedElastic,
    /// Ratio of its stiffness to the stiffest of its contacts and devices, or of its bearings where it has neither.
    pub softness: Softness,
    /// `κ_e` below which it is computed as rigid \[–\].
    pub tolerance: f64,
    /// Its degrees of freedom; `None` where it is computed as rigid.
    pub girder: Option<ElasticBody>,
}

/// Beam of a girder of that section.
pub fn beam(girder: &Girder, section: &ResolvedElastic) -> Beam {
    let Prism { width, skew, .. } = girder.prism();
    let sine = skew.sin();
    Beam {
        length: girder.length,
        mass: girder.mass,
        rotary: width * width / (12.0 * sine * sine),
        axial: section.axial,
        bending: section.bending,
        shear: section.shear,
    }
}

/// The girder as a beam in space.
fn space_beam(girder: &Girder, section: &ResolvedElastic) -> SpaceBeam {
    SpaceBeam {
        plan: beam(girder, section),
        rotary: SpaceBeam::rotary_of(girder.width, girder.thickness, girder.prism().shear()),
        bending: section.vertical_bending,
        // k_s of a rectangle is the same both ways.
        shear: section.shear,
        torsion: section.torsion,
    }
}

/// Gives the elastic girders of a scene their degrees of freedom; for each girder what is known of it.
pub(super) fn add(scene: &Scene, facings: &[Facing], bodies: &mut [Body]) -> Vec<Option<Flexible>> {
    let girders = scene.girders.iter().enumerate();
    girders.map(|(n, girder)| girder.elastic.map(|e| one(scene, &e, (n, facings), &mut bodies[n]))).collect()
}

fn one(scene: &Scene, elastic: &Elastic, (number, facings): (usize, &[Facing]), body: &mut Body) -> Flexible {
    let girder = &scene.girders[number];
    let section = elastic.resolve(girder);
    let beam = beam(girder, &section);
    let space = (scene.kind == Kind::Spatial).then(|| space_beam(girder, &section));
    let is_own = |facing: &&Facing| [facing.first, facing.second].iter().any(|side| side.girder() == Some(number));
    let of_contacts = facings.iter().filter(is_own).filter(|facing| !facing.met);
    let stiffest = of_contacts.map(|facing| facing.contact.stiffness).fold(of_devices(scene, number, &beam), f64::max);
    let stiffness = if stiffest > 0.0 { stiffest } else { of_bearings(scene, girder, &beam) };
    let half = 0.5 * girder.width;
    let corner = |y: f64| DVec2::new(y * body.prism.shear(), y);
    let softness = space.as_ref().map_or_else(
        || Softness::of(&beam, stiffness, &[corner(half), corner(-half)]),
        |space| Softness::in_space(space, stiffness, &corners_in_space(girder)),
    );
    let degree = section.degree.or_else(|| automatic_degree(&softness, elastic.tolerance));
    let damping = section.damping.map_or_else(
        |rayleigh| ModalDamping::Rayleigh { mass: rayleigh.mass, stiffness: rayleigh.stiffness },
        ModalDamping::Ratio,
    );
    let has_met = facings.iter().filter(is_own).any(|facing| facing.met);
    let mut made = degree.map(|degree| match space {
        None => ElasticBody::Plan(Arc::new(ElasticGirder::new(body, Modes::of(beam, degree), damping))),
        Some(space) => {
            ElasticBody::Space(Arc::new(SpatialElasticGirder::new(body, SpaceModes::of(space, degree), damping)))
        }
    });
    if let Some(made) = &mut made {
        if has_met {
            made.add_flanks();
        }
        (body.rate_bounds.mobility, body.rate_bounds.modal) = (made.mobility(), made.modal_rates());
        // No closed form of motion along an axis in space.
        body.keeps_to_axis = body.keeps_to_axis.map(|straight| straight && matches!(made, ElasticBody::Plan(_)));
        body.coordinates = made.coordinates();
    }
    Flexible { beam, space, section, softness, tolerance: elastic.tolerance, girder: made }
}

/// Offsets of an end's corners from its centre \[m\].
fn corners_in_space(girder: &Girder) -> [DVec3; 4] {
    let (half, cot) = (0.5 * girder.width, girder.prism().shear());
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .map(|[y, z]| DVec3::new(y * half * cot, y * half, 0.5 * z * girder.thickness))
}

/// Stiffness of the stiffest device at a girder \[N/m\].
fn of_devices(scene: &Scene, girder: usize, beam: &Beam) -> f64 {
    let laws_of = |(id, part): (DeviceId, &dyn Part)| {
        let joint = Joint::of(scene, &part.ends())?;
        let own = joint.girder == girder || joint.other == Some(girder);
        Some(laws(&scene.device(id).filter(|_| own)?, &joint))
    };
    let laws = scene.devices().into_iter().filter_map(laws_of).flatten();
    let phase = Phase::default();
    laws.map(|law| law.device.stiffness_bound(&phase).max(of_dashpot(law.device.damping_bound(&phase), beam)))
        .fold(0.0, f64::max)
}

/// Stiffness of the stiffest bearing of a girder before it yields or slides \[N/m\].
fn of_bearings(scene: &Scene, girder: &Girder, beam: &Beam) -> f64 {
    let of = |bearing: &ResolvedBearing| {
        let [[along, across, up], [c_along, c_across, c_up]] = [bearing.stiffness, bearing.damping];
        let upwards = |of: f64| if scene.kind == Kind::Spatial { of } else { 0.0 };
        let spring = along.max(across).max(upwards(up)) + bearing.yielding.map_or(0.0, |yielding| yielding.stiffness());
        spring.max(of_dashpot(c_along.max(c_across).max(upwards(c_up)), beam))
    };
    girder.supports(scene.setting()).iter().map(of).fold(0.0, f64::max)
}

/// Stiffness that a dashpot c counts as \[N/m\]: κ is c over the impedance `Z = √(E A m/a₀)`, to which the girder gives way as it does
/// to a spring of EA/a₀; at 1 at the most, since a stiffer dashpot is a fixed point to a wave and has no frequency of its own.
fn of_dashpot(damping: f64, beam: &Beam) -> f64 {
    let stiffness = beam.axial / beam.length;
    let impedance = (stiffness * beam.mass).sqrt();
    stiffness * (damping / impedance).min(1.0)
}
