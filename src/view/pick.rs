//! Target at a point of the picture.

use glam::{DVec2, DVec3};

use super::moment::Moment;
use super::{Target, ViewInput};
use crate::geometry::shape::{Convex, Stand};
use crate::scene::placed;

/// A contact is picked this near its glyph \[points\].
const REACH: f64 = 9.0;

/// Target at a point of the picture (`[-1, 1]`, y up): a contact's glyph, else the nearest body.
pub fn pick(input: &ViewInput<'_>, ndc: [f64; 2]) -> Option<Target> {
    let moment = super::shown(input);
    let device = || pick_device(input, &moment, ndc);
    pick_contact(input, &moment, ndc).or_else(device).or_else(|| pick_body(input, &moment, ndc))
}

fn pick_contact(input: &ViewInput<'_>, moment: &Moment, ndc: [f64; 2]) -> Option<Target> {
    if !input.overlays.contacts {
        return None;
    }
    let size = input.size.map(f64::from);
    let at = [f64::midpoint(1.0, ndc[0]) * size[0], f64::midpoint(1.0, -ndc[1]) * size[1]];
    let reach = REACH * f64::from(input.pixels_per_point);
    let near = moment.contacts.iter().filter_map(|c| {
        let [x, y] = input.camera.project(c.point, size)?;
        let distance = (x - at[0]).hypot(y - at[1]);
        (distance <= reach).then_some((distance, c.contact))
    });
    near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, contact)| Target::Contact(contact))
}

/// The device whose line is nearest on the screen, within reach.
fn pick_device(input: &ViewInput<'_>, moment: &Moment, ndc: [f64; 2]) -> Option<Target> {
    let model = input.history?.model();
    let size = input.size.map(f64::from);
    let at = DVec2::new(f64::midpoint(1.0, ndc[0]) * size[0], f64::midpoint(1.0, -ndc[1]) * size[1]);
    let on_screen = |point: &DVec3| input.camera.project(*point, size).map(DVec2::from);
    let distance = |line: &[DVec3]| {
        let ends = line.windows(2).filter_map(|two| on_screen(&two[0]).zip(on_screen(&two[1])));
        ends.map(|(a, b)| to_segment(at, a, b)).reduce(f64::min)
    };
    let near = moment.devices.iter().filter_map(|device| {
        let id = model.devices.iter().find(|known| known.links.contains(&device.link))?.id;
        let distance = distance(&device.line)?;
        (distance <= REACH * f64::from(input.pixels_per_point)).then_some((distance, id))
    });
    near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, id)| Target::Device(id))
}

/// Distance of a point from a stretch of a line.
fn to_segment(at: DVec2, a: DVec2, b: DVec2) -> f64 {
    let part = ((at - a).dot(b - a) / (b - a).length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    at.distance(a.lerp(b, part))
}

fn pick_body(input: &ViewInput<'_>, moment: &Moment, ndc: [f64; 2]) -> Option<Target> {
    let (from, along) = input.camera.ray(ndc, input.aspect());
    let girders = input.scene.girders.iter().zip(&moment.motions).enumerate();
    let girders = girders.filter_map(|(i, (girder, motion))| {
        let stand = Stand { place: motion.place, attitude: motion.attitude };
        Some((Convex::girder(&girder.prism())?.pick(stand, from, along)?, Target::Girder(i)))
    });
    let walls = input.scene.abutments.iter().enumerate();
    let walls = walls.filter_map(|(i, abutment)| {
        let face = placed::abutment_face(input.scene, abutment)?;
        let wall = Convex::behind(face, placed::abutment_depth(input.scene, abutment))?;
        Some((wall.pick(Stand::WORLD, from, along)?, Target::Abutment(i)))
    });
    let piers = moment.piers.iter().enumerate().filter_map(|(i, pier)| {
        let blocks = [pier.cap()].into_iter().chain(pier.columns().0);
        let nearest = blocks.filter_map(|block| block.entry(from, along)).reduce(f64::min)?;
        Some((nearest, Target::Pier(i)))
    });
    girders.chain(walls).chain(piers).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, target)| target)
}
