//! Whether the polynomials of elastic girders suffice: the same run with half as many again, or with two thirds of them where there can
//! be no more.

use super::History;
use super::quadrature::integrate;
use crate::dynamics::elastic::degree::{LARGEST_DEGREE, SMALLEST_DEGREE};
use crate::geometry::End;
use crate::scene::{Degree, Scene};

/// Instants at which places of the ends are compared.
const COMPARED: u32 = 400;

/// Differences from a run of degree `⌈3n/2⌉`, of `⌊2n/3⌋` where that is more than there can be, each in parts of the greatest of its
/// kind.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct DegreeCheck {
    /// Largest degree of a girder, and what it was compared with.
    pub degree: [usize; 2],
    /// Where the other run gave up before the end of this one: until when both were compared \[s\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub until: Option<f64>,
    /// Of the largest force of a contact.
    pub force: f64,
    /// Of the impulses of all contacts.
    pub impulse: f64,
    /// Of the displacements of both ends of every girder.
    pub ends: f64,
    /// Of the largest normal force at mid-span.
    pub section: f64,
    /// Of the largest moments at mid-span, in space of both ways of bending and of torsion, in parts of the largest of them.
    pub moments: f64,
}

impl History {
    /// Runs the scene again with other degrees; nothing where no girder bends.
    pub fn check_degree(&self) -> Option<DegreeCheck> {
        let (scene, degree) = self.of_other_degree()?;
        let against = Self::of(&scene).ok()?;
        match against.ends_before(self) {
            None => Some(self.compare(degree, &against)),
            // Largest values and impulses are compared of runs of one length.
            Some(until) => {
                let mut scene = self.scene().clone();
                scene.duration = until;
                let check = Self::of(&scene).ok()?.compare(degree, &against);
                Some(DegreeCheck { until: Some(until), ..check })
            }
        }
    }

    /// The differences from a run of another degree that is as long.
    fn compare(&self, degree: [usize; 2], against: &Self) -> DegreeCheck {
        let [force, other] = [self, against].map(Self::largest_force);
        let [impulse, other_impulse] = [self, against].map(Self::impulse);
        let [[section, own @ ..], [other_section, others @ ..]] = [self, against].map(Self::largest_at_mid_span);
        let part = |a: f64, b: f64| if b == 0.0 { 0.0 } else { (a - b).abs() / b };
        DegreeCheck {
            degree,
            until: None,
            force: part(force, other),
            impulse: part(impulse, other_impulse),
            ends: self.ends_apart(against),
            section: part(section, other_section),
            moments: {
                let apart = own.iter().zip(others).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                let largest = others.into_iter().fold(0.0, f64::max);
                if largest == 0.0 { 0.0 } else { apart / largest }
            },
        }
    }

    /// The scene with girders of other degrees, and that of its finest girder before and after.
    fn of_other_degree(&self) -> Option<(Scene, [usize; 2])> {
        let mut scene = self.scene().clone();
        let degrees =
            (0..scene.girders.len()).filter_map(|girder| Some(self.flexible(girder)?.girder.as_ref()?.degree()));
        let fewer = degrees.max()? > 2 * LARGEST_DEGREE / 3;
        let mut largest = [0; 2];
        for (number, girder) in scene.girders.iter_mut().enumerate() {
            let made = self.flexible(number).and_then(|flexible| flexible.girder.as_ref());
            let (Some(made), Some(elastic)) = (made, girder.elastic.as_mut()) else { continue };
            let degree = made.degree();
            let other = if fewer { (2 * degree / 3).max(SMALLEST_DEGREE) } else { (3 * degree).div_ceil(2) };
            elastic.modes = Degree(Some(other as f64));
            largest = largest.max([degree, other]);
        }
        (largest[1] != largest[0]).then_some((scene, largest))
    }

    /// Impulses of all contacts \[N·s\].
    fn impulse(&self) -> f64 {
        let of = |touch: &super::Touch| {
            let site = &self.model().contacts[touch.contact];
            let bodies = [site.node_body, site.face_body].into_iter().flatten();
            let mut borders: Vec<f64> = bodies
                .flat_map(|body| self.paths[body].spans_after(touch.start).map(|span| span.from))
                .filter(|t| *t > touch.start && *t < touch.end)
                .chain([touch.start, touch.end])
                .collect();
            borders.sort_by(f64::total_cmp);
            let force = |t: f64| [self.contact_at(touch.contact, t).map_or(0.0, |now| now.force.length())];
            borders.windows(2).map(|w| integrate(w[0], w[1], force)[0]).sum::<f64>()
        };
        self.touches().iter().map(of).sum()
    }

    fn ends_apart(&self, other: &Self) -> f64 {
        let (mut apart, mut largest) = (0.0f64, f64::MIN_POSITIVE);
        for i in 0..=COMPARED {
            let t = self.end().min(other.end()) * f64::from(i) / f64::from(COMPARED);
            for girder in 0..self.model().girders().len() {
                for end in End::BOTH {
                    let place = |history: &Self| history.section_place(girder, end, t);
                    let (one, two) = (place(self), place(other));
                    apart = apart.max((one - two).length());
                    largest = largest.max(two.length());
                }
            }
        }
        apart / largest
    }

    /// Displacement of the centre of an end from where it was placed \[m\].
    pub fn section_place(&self, girder: usize, end: End, t: f64) -> glam::DVec3 {
        let (body, motion) = (&self.model().bodies[girder], self.end_motion(girder, end, t));
        let here = glam::DVec3::X * (0.5 * end.sign() * body.prism.length);
        // From the displacement, not from the place: far from the origin the difference would round away.
        motion.displacement + (motion.attitude * here - body.axes * here)
    }
}
