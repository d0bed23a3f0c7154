//! Whether the polynomials of elastic girders suffice: the same run with half as many again, or with two thirds of them where there can
//! be no more.

use crate::dynamics::elastic::degree::{LARGEST_DEGREE, SMALLEST_DEGREE};
use crate::geometry::End;
use crate::scene::facing::SolidId;
use crate::scene::{Degree, Scene};
use crate::sim::energy::quadrature::integrate;
use crate::sim::sections::largest::rounding;
use crate::sim::sections::view::Sections;
use crate::sim::{Comparison, History, Touch};

/// Instants at which places of the ends are compared.
const COMPARED: u32 = 400;

/// Part of the largest force, or impulse, of two bodies below which that of others is not compared: nothing to a designer. Chosen.
const GRAZE: f64 = 1e-6;
/// Part of a girder's length below which a displacement of its ends is rounding of places.
const STILL: f64 = 1e-12;

/// The difference of two values in parts of the larger one, or of what is `nothing` beside others.
fn part(a: f64, b: f64, nothing: f64) -> f64 {
    if a == b { 0.0 } else { (a - b).abs() / a.max(b).max(nothing) }
}

/// A value of every two bodies that touched.
type OfBodies = Vec<([SolidId; 2], f64)>;

/// The value of two bodies, 0 at first.
fn of_two(of: &mut OfBodies, bodies: [SolidId; 2]) -> &mut f64 {
    let known = of.iter().position(|(own, _)| *own == bodies);
    let number = known.unwrap_or(of.len());
    if known.is_none() {
        of.push((bodies, 0.0));
    }
    &mut of[number].1
}

/// Differences from a run of degree `⌈3n/2⌉`, of `⌊2n/3⌋` where that is more than there can be: the largest of all pairs or girders,
/// each in parts of the greatest of its kind of that pair or girder.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct DegreeCheck {
    /// Largest degree of a girder, and what it was compared with.
    pub degree: [usize; 2],
    /// End of the comparison, where the other run stopped before the end of this one \[s\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub until: Option<f64>,
    /// Of the largest force of a contact of a pair.
    pub force: f64,
    /// Of the impulses of all contacts of a pair.
    pub impulse: f64,
    /// Of the displacements of both ends of a girder.
    pub ends: f64,
    /// Of the largest normal force at mid-span.
    pub section: f64,
    /// Of the largest moments at mid-span, in space of both ways of bending and of torsion, in parts of the largest of them.
    pub moments: f64,
}

impl Sections<'_> {
    /// Runs the scene again with other degrees; nothing where no girder bends.
    pub fn check_degree(self) -> Option<DegreeCheck> {
        let (scene, degree) = self.of_other_degree()?;
        let against = History::of(&scene).ok()?;
        match Comparison::of(&against, self.history).ends_before() {
            None => Some(self.compare(degree, against.sections())),
            // Largest values and impulses are compared of runs of one length.
            Some(until) => {
                let mut scene = self.history.scene().clone();
                scene.duration = until;
                let check = History::of(&scene).ok()?.sections().compare(degree, against.sections());
                Some(DegreeCheck { until: Some(until), ..check })
            }
        }
    }

    /// The differences from a run of another degree that is as long.
    fn compare(self, degree: [usize; 2], against: Sections<'_>) -> DegreeCheck {
        let pairs = |mut own: OfBodies, mut other: OfBodies| {
            // A touch that is nothing beside the others is no force to be compared.
            let nothing = GRAZE * own.iter().chain(&other).map(|(_, value)| *value).fold(0.0, f64::max);
            let bodies: Vec<[SolidId; 2]> = own.iter().chain(&other).map(|(bodies, _)| *bodies).collect();
            let apart = |bodies| part(*of_two(&mut own, bodies), *of_two(&mut other, bodies), nothing);
            bodies.into_iter().map(apart).fold(0.0, f64::max)
        };
        let mut check = DegreeCheck {
            degree,
            until: None,
            force: pairs(self.largest_forces(), against.largest_forces()),
            impulse: pairs(self.impulses(), against.impulses()),
            ends: self.ends_apart(against),
            section: 0.0,
            moments: 0.0,
        };
        for girder in 0..self.history.model().girders().len() {
            let made = |run: Sections<'_>| run.flexible(girder)?.girder.clone();
            let (Some(own), Some(other)) = (made(self), made(against)) else { continue };
            let half = 0.5 * self.history.model().bodies[girder].prism.length;
            let most = |run: Sections<'_>, made| run.largest_values(girder, made, None).map(|most| most.value);
            let (own, other) = (most(self, &own), most(against, &other));
            let [nothing, of_moments, ..] = rounding(&other, half);
            check.section = check.section.max(part(own[0], other[0], nothing));
            let apart = (1..4).map(|i| (own[i] - other[i]).abs()).fold(0.0, f64::max);
            let largest = (1..4).map(|i| other[i]).fold(of_moments, f64::max);
            check.moments = check.moments.max(if apart == 0.0 { 0.0 } else { apart / largest });
        }
        check
    }

    /// The scene with girders of other degrees, and that of its finest girder before and after.
    fn of_other_degree(self) -> Option<(Scene, [usize; 2])> {
        let mut scene = self.history.scene().clone();
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

    /// Largest force of a contact \[N\].
    fn largest_forces(self) -> OfBodies {
        let mut largest = OfBodies::new();
        for touch in self.history.hits().touches() {
            let own = of_two(&mut largest, self.history.model().pairs[touch.pair].solids());
            *own = own.max(touch.peak_force);
        }
        largest
    }

    /// Impulses of all contacts \[N·s\].
    fn impulses(self) -> OfBodies {
        let of = |touch: &Touch| {
            let site = &self.history.model().sites[touch.contact];
            let bodies = [site.node_body, site.face_body].into_iter().flatten();
            let mut borders: Vec<f64> = bodies
                .flat_map(|body| self.history.trajectories.path(body).spans_after(touch.start).map(|span| span.from))
                .filter(|t| *t > touch.start && *t < touch.end)
                .chain([touch.start, touch.end])
                .collect();
            borders.sort_by(f64::total_cmp);
            let force =
                |t: f64| [self.history.contacts().contact_at(touch.contact, t).map_or(0.0, |now| now.force.length())];
            borders.windows(2).map(|w| integrate(w[0], w[1], force)[0]).sum::<f64>()
        };
        let mut sums = OfBodies::new();
        for touch in self.history.hits().touches() {
            *of_two(&mut sums, self.history.model().pairs[touch.pair].solids()) += of(touch);
        }
        sums
    }

    fn ends_apart(self, other: Sections<'_>) -> f64 {
        let of = |girder: usize| {
            let (mut apart, mut largest) = (0.0f64, STILL * self.history.model().bodies[girder].prism.length);
            for i in 0..=COMPARED {
                let t = self.history.end().min(other.history.end()) * f64::from(i) / f64::from(COMPARED);
                for end in End::BOTH {
                    let place = |run: Sections<'_>| run.end_displacement(girder, end, t);
                    let (one, two) = (place(self), place(other));
                    apart = apart.max((one - two).length());
                    largest = largest.max(two.length());
                }
            }
            apart / largest
        };
        (0..self.history.model().girders().len()).map(of).fold(0.0, f64::max)
    }

    /// Displacement of the centre of an end from where it was placed \[m\].
    pub fn end_displacement(self, girder: usize, end: End, t: f64) -> glam::DVec3 {
        let (body, motion) = (&self.history.model().bodies[girder], self.history.end_motion(girder, end, t));
        let here = glam::DVec3::X * (0.5 * end.sign() * body.prism.length);
        // From the displacement, not from the place: far from the origin the difference would round away.
        motion.displacement + (motion.attitude * here - body.axes * here)
    }
}
