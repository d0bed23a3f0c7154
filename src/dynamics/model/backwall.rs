//! Backwalls with backfill: bodies that move square to their face, on a slider and against the soil
//! (`docs/physics.md#backfill`).

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::dynamics::connection::{Device, Kinematics, Link};
use crate::dynamics::devices::{Backfill, ElastoPlastic, Envelope, Failure, Hysteresis, Stopper};
use crate::dynamics::model::body::{Body, BodyCoordinates};
use crate::dynamics::model::compiled_model::Backwall;
use crate::dynamics::model::coordinates::given_motion::GivenMotion;
use crate::dynamics::model::coordinates::guided::Guided;
use crate::dynamics::model::coordinates::guided_on_ground::GuidedOnGround;
use crate::dynamics::model::moving_ground::MovingGround;
use crate::dynamics::model::rate_bounds::{ModalRates, RateBounds};
use crate::geometry::Prism;
use crate::language::Text;
use crate::scene::{Abutment, BackfillLaw, ResolvedBackfill, Scene, SceneError, SceneErrors, placed};

/// The number among the bodies of an abutment's wall, behind the girders; `None` for one that stands.
pub(super) fn number(scene: &Scene, bodies: &[Body], abutment: usize) -> Option<usize> {
    // Behind the girders; a wall has its abutment's name, which nobody else has there.
    let (from, name) = (scene.girders.len(), &scene.abutments[abutment].name);
    let number = bodies.get(from..)?.iter().position(|body| body.name == *name)?;
    Some(from + number)
}

/// Adds the walls of a scene that move to its bodies and links, and says which abutment's each is.
///
/// # Errors
/// Soil that unloads softer than it loads.
pub(super) fn add(
    scene: &Scene,
    moving: Option<&MovingGround>,
    bodies: &mut Vec<Body>,
    links: &mut Vec<Link>,
) -> Result<Vec<Option<Backwall>>, SceneErrors> {
    let mut add = |(number, abutment): (usize, &Abutment)| {
        let Some(face) = placed::abutment_face(scene, abutment) else { return Ok(None) };
        let frame = WallFrame::of(face);
        let Some(soil) = abutment.soil(scene) else {
            let own = moving.and_then(|moving| Some((moving, moving.supports.of_abutment(number)?)));
            return Ok(own.map(|(moving, motion)| {
                let wall = Backwall { body: bodies.len(), soil: None, inward: frame.inward };
                let block = frame.block(placed::abutment_depth(scene, abutment));
                bodies.push(moving.body(abutment.name.clone(), block, frame.corner, motion));
                wall
            }));
        };
        let wall = Backwall { body: bodies.len(), soil: Some(links.len()), inward: frame.inward };
        let below = moving.and_then(|moving| Some(moving.given(moving.supports.of_abutment(number)?)));
        let body = frame.body(abutment, &soil, below);
        links.extend(frame.links(wall.body, &body, &soil).ok_or_else(|| complaint(abutment))?);
        bodies.push(body);
        Ok(Some(wall))
    };
    scene.abutments.iter().enumerate().map(&mut add).collect()
}

fn complaint(abutment: &Abutment) -> SceneErrors {
    SceneErrors::from(SceneError {
        file: "scene".to_owned(),
        place: format!("abutment.{}.backfill", abutment.name).into(),
        value: Text::new("found-no-soil").into(),
        remedy: Text::new("wrong-no-soil").into(),
    })
}

/// A wall's face: its first corner, centre and size, and the directions along it and into the soil.
struct WallFrame {
    corner: DVec3,
    centre: DVec3,
    /// Unit vector along the face, from its first corner to the second.
    side: DVec3,
    /// Unit vector into the soil.
    inward: DVec3,
    length: f64,
    height: f64,
}

impl WallFrame {
    fn of([a, b, c, d]: [DVec3; 4]) -> Self {
        let (along, up) = (b - a, d - a);
        let side = along.normalize_or_zero();
        // The face looks along side × up.
        let inward = up.cross(side).with_z(0.0).normalize_or_zero();
        Self { corner: a, centre: 0.25 * (a + b + c + d), side, inward, length: along.length(), height: up.length() }
    }

    /// A block of this depth behind the face \[m\].
    fn block(&self, depth: f64) -> Prism {
        Prism { length: depth, width: self.length, thickness: self.height, skew: std::f64::consts::FRAC_PI_2 }
    }

    /// The wall, free to move into the soil and out of it, on ground that moves otherwise where one is given; its frame stands at the
    /// face's first corner.
    fn body(&self, abutment: &Abutment, soil: &ResolvedBackfill, below: Option<GivenMotion>) -> Body {
        let (prism, own) = (self.block(soil.thickness), Guided { along: self.inward });
        let per_mass = prism.inertia_per_mass();
        let inertia = per_mass * soil.mass;
        let coordinates = BodyCoordinates::Custom(match below {
            None => Arc::new(own),
            Some(ground) => Arc::new(GuidedOnGround { own, ground }),
        });
        Body {
            mass: soil.mass,
            gyration2: per_mass.z_axis.z,
            inertia,
            inverse_inertia: inertia.inverse(),
            rate_bounds: RateBounds { mobility: 1.0 / soil.mass, stiffest: 0.0, modal: ModalRates::default() },
            free: [true, true, false, false, false, false],
            ..Body::immovable(abutment.name.clone(), coordinates, prism, self.corner)
        }
    }

    /// Soil, slider and fuse between the wall, as body `number`, and the ground.
    fn links(&self, number: usize, body: &Body, soil: &ResolvedBackfill) -> Option<Vec<Link>> {
        let axes = DMat3::from_cols(self.inward, -self.side, DVec3::Z);
        let arm = self.centre - self.corner;
        let link = |what: &str, device: Arc<dyn Device>| Link {
            name: format!("{}.{what}", body.name),
            bodies: [Some(number), None],
            arms: [arm, DVec3::ZERO],
            sections: [0; 2],
            homes: [self.corner, self.centre],
            axes,
            kinematics: Kinematics::Points,
            device,
        };
        let mut links = vec![link("soil", Arc::new(Backfill::new(0.0, envelope(soil)?, soil.unloading)?))];
        if let Some([force, displacement]) = soil.base {
            let element = ElastoPlastic { stiffness: force / displacement, force };
            links.push(link("base", Arc::new(Hysteresis::PerAxis([element; 2]))));
        }
        if let Some([stiffness, force]) = soil.fuse {
            links.push(link("fuse", Arc::new(Stopper { gap: 0.0, stiffness, failure: Failure::Brittle { force } })));
        }
        Some(links)
    }
}

fn envelope(soil: &ResolvedBackfill) -> Option<Envelope> {
    match soil.law {
        BackfillLaw::Hyperbolic => Some(Envelope::hyperbolic(soil.stiffness, soil.failure_ratio, soil.ultimate)),
        BackfillLaw::Bilinear => Some(Envelope::bilinear(soil.stiffness, soil.ultimate)),
        BackfillLaw::MeanStiffness => Envelope::of_mean_stiffness(soil.ultimate, soil.stiffness, soil.limit),
    }
}
