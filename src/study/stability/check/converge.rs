//! A hundredth of the tolerance makes a smaller error, as long as the case can be trusted.
//!
//! Three runs: at the scene's tolerance, at a hundredth of it, and at a hundredth of that (never below the finest that a
//! scene may ask for), which stands for the truth. Where the finer error is not below the coarser one and not at the
//! rounding floor, the reference is run again with starts, ground motion and friction perturbed by [`PERTURBATION`] and by the finer
//! tolerance. The case counts as trusted until a perturbation has grown a thousandfold, of a backwall or a pier in parts of its own
//! motion: a wall that taps on its soil by micrometres is chaotic long before it shows beside girders that move by metres. The finer error
//! may be ten times the growth of the perturbations.
//!
//! All runs advance together from one instant of comparison to the next and end where the case is no longer trusted: beyond, differences
//! are those of a chaotic motion.

use super::super::watch::{Limits, NoAnswer, Watch};
use super::finding::{Check, Complaint, Figures};
use super::looks::size;
use crate::scene::{self, Direction, FINEST_TOLERANCE, Kind, Scene};
use crate::sim::{Cause, History, Motion, Session, Stop};

pub(super) const CLAIM: &str = "the error at a hundredth of the tolerance is below the error at it, or below the \
                                floor (rounding, or ten times what starts, grounds and friction that differ by \
                                the finer tolerance come apart), until the time to which the case can be trusted: those that \
                                differ by 1e-12 have then come a thousand times as far apart, backwalls and piers in parts of \
                                their own motion";

/// Instants at which answers are compared.
const COMPARED: usize = 400;
/// Rounding of a place at the end of a run, in parts of what moves and how far.
const FLOOR: f64 = 1e-12;
/// Largest weight of a body that moves less than the girders: below that part of their motion it does not count as moving \[–\]. Chosen: the
/// rounding of a place, 1e-16, is far below a thousandfold [`PERTURBATION`] of it.
const LARGEST_WEIGHT: f64 = 1e6;
/// Growth of a perturbation up to which a case is trusted \[–\]. Chosen.
const GROWN: f64 = 1e3;
/// Relative perturbation that stands for round-off \[–\].
const PERTURBATION: f64 = 1e-12;
/// Largest finer error over the grown perturbation \[–\]. Chosen.
const ERROR_PER_GROWTH: f64 = 10.0;

/// Puts the check.
pub fn convergence(history: &History, watch: &Watch<'_>, figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    match compare(history, watch, figures) {
        Ok(None) => {}
        Ok(Some(detail)) => complaints.push(Complaint::new(Check::Converges, detail)),
        Err(complaint) => complaints.push(complaint),
    }
}

/// Fault, if there is one; a run at another tolerance may fail as the first one might have.
fn compare(coarse: &History, watch: &Watch<'_>, figures: &mut Figures) -> Result<Option<String>, Complaint> {
    let scene = coarse.scene();
    let [tolerance, fine, finest] = [1.0, 1e-2, 1e-4].map(|part| (scene.solver.tolerance * part).max(FINEST_TOLERANCE));
    let mut truth = Run::new(with_tolerance(scene, finest))?;
    let mut finer = if finest < fine { Some(Run::new(with_tolerance(scene, fine))?) } else { None };
    let (extent, weights) = (extent(coarse), weights(coarse));
    let shares = [PERTURBATION, -PERTURBATION, fine, -fine];
    let starts = shares.map(|share| Run::new(perturbed(&truth.scene, share, extent)));
    let mut perturbed_runs = PerturbedRuns {
        starts: Vec::new(),
        weights,
        limits: shares.map(|share| GROWN * share.abs() * extent).to_vec(),
    };
    for start in starts {
        perturbed_runs.starts.push(start?);
    }
    let mut errors = vec![[0.0_f64; 2]];
    let mut trusted = COMPARED;
    let floor = FLOOR * extent;
    let rises = |[error, finer_error]: [f64; 2], floor: f64| finer_error > error.max(floor);
    for i in 1..=COMPARED {
        truth.go_on(watch)?;
        let t = instant(i, coarse.end());
        let here: Vec<Motion> = (0..coarse.model().bodies.len()).map(|body| coarse.motion(body, t)).collect();
        let mut error = errors[i - 1];
        error[0] = error[0].max(truth.apart(&here, i));
        if let Some(finer) = &mut finer {
            finer.go_on(watch)?;
            error[1] = error[1].max(truth.apart(&finer.motions[i], i));
        }
        errors.push(error);
        // The finer error is as large as a chaotic motion makes it: the comparison need not go on.
        let wild = error[1] > GROWN * fine * extent;
        if (rises(error, floor) || wild)
            && let Some(until) = perturbed_runs.until(&truth, i, watch)?
        {
            trusted = until;
            break;
        }
    }
    let error = errors[trusted];
    (figures.trusted, figures.error, figures.finer_error) = (instant(trusted, coarse.end()), error[0], error[1]);
    if !rises(error, floor) {
        return Ok(None);
    }
    let floor = perturbed_runs.floor(&truth, trusted, watch)?.max(floor);
    Ok(rises(error, floor).then(|| {
        format!(
            "until {} s: error {:e} m at tolerance {tolerance:e}, {:e} m at {fine:e}; floor there {floor:e} m",
            figures.trusted, error[0], error[1],
        )
    }))
}

/// A run that is brought on from one instant compared to the next.
struct Run {
    scene: Scene,
    session: Session,
    /// Motions of all bodies at the instants so far.
    motions: Vec<Vec<Motion>>,
}

impl Run {
    fn new(scene: Scene) -> Result<Self, Complaint> {
        let mut session =
            Session::new(&scene).map_err(|errors| failed(&scene, Check::Finishes, &errors.to_string()))?;
        session.advance(0.0, &mut |_| true);
        let mut run = Self { scene, session, motions: Vec::new() };
        run.note()?;
        Ok(run)
    }

    /// To the next instant.
    fn go_on(&mut self, watch: &Watch<'_>) -> Result<(), Complaint> {
        let t = instant(self.motions.len(), self.scene.duration);
        if let Err(NoAnswer::Slow(reached)) = watch.advance(&mut self.session, t, Limits::NONE) {
            let what = format!("came to {reached} s of {} s", self.scene.duration);
            return Err(failed(&self.scene, Check::Time, &what));
        }
        self.note()
    }

    fn note(&mut self) -> Result<(), Complaint> {
        let motions = match self.session.motions() {
            Ok(motions) => motions,
            // The model's motion ends there: the state of its end is compared.
            Err(Stop { cause: Cause::SupportLost, t, .. }) => self.session.motions_at(*t),
            Err(stop) => {
                let what = format!("t = {} s, {}: {}", stop.t, stop.place, stop.reason.english());
                return Err(failed(&self.scene, Check::Finishes, &what));
            }
        };
        self.motions.push(motions);
        Ok(())
    }

    /// The largest difference of any corner from these motions at an instant \[m\].
    fn apart(&self, others: &[Motion], i: usize) -> f64 {
        self.each_apart(others, i).fold(0.0, f64::max)
    }

    /// The largest difference of any corner of each body from these motions at an instant \[m\].
    fn each_apart(&self, others: &[Motion], i: usize) -> impl Iterator<Item = f64> {
        let radii = self.session.model().bodies.iter().map(|body| body.radius);
        let apart = |((a, b), radius): ((&Motion, &Motion), f64)| {
            let turned = (a.attitude.inverse() * b.attitude).xyz().length() * 2.0 * radius;
            (a.displacement - b.displacement).length() + turned
        };
        self.motions[i].iter().zip(others).zip(radii).map(apart)
    }

    /// The first instant, until `last`, at which a body's distance from the reference, times its weight, exceeds `limit` \[m\].
    fn strays(
        &mut self,
        truth: &Self,
        (limit, weights): (f64, &[f64]),
        last: usize,
        watch: &Watch<'_>,
    ) -> Result<Option<usize>, Complaint> {
        for i in 1..=last {
            if i == self.motions.len() {
                self.go_on(watch)?;
            }
            if truth.each_apart(&self.motions[i], i).zip(weights).any(|(apart, weight)| apart * weight > limit) {
                return Ok(Some(i));
            }
        }
        Ok(None)
    }
}

/// The reference with perturbed starts, ground motion and friction.
struct PerturbedRuns {
    starts: Vec<Run>,
    /// Allowed distances from the reference \[m\].
    limits: Vec<f64>,
    /// Weight of each body's distance from it \[–\].
    weights: Vec<f64>,
}

impl PerturbedRuns {
    /// The last instant until which the case can be trusted, where it cannot be until `last`.
    fn until(&mut self, truth: &Run, last: usize, watch: &Watch<'_>) -> Result<Option<usize>, Complaint> {
        let mut until = None;
        for (start, limit) in self.starts.iter_mut().zip(&self.limits) {
            let last = until.map_or(last, |until| until + 1);
            if let Some(lost) = start.strays(truth, (*limit, &self.weights), last, watch)? {
                until = Some(lost - 1);
            }
        }
        Ok(until)
    }

    /// Ten times the greatest difference at the finer tolerance until an instant \[m\].
    fn floor(&mut self, truth: &Run, last: usize, watch: &Watch<'_>) -> Result<f64, Complaint> {
        let mut floor: f64 = 0.0;
        for start in &mut self.starts {
            start.strays(truth, (f64::INFINITY, &self.weights), last, watch)?;
            let apart = (0..=last).map(|i| truth.apart(&start.motions[i], i));
            floor = apart.fold(floor, |floor, apart| floor.max(ERROR_PER_GROWTH * apart));
        }
        Ok(floor)
    }
}

fn with_tolerance(scene: &Scene, tolerance: f64) -> Scene {
    let mut scene = scene.clone();
    scene.solver.tolerance = tolerance;
    scene
}

/// The same scene with every girder displaced at its start by this part of that extent, which bearings may damp away, and with ground
/// motion and friction larger by this part, which last: a stick that holds by the last digit of its force breaks away by that.
fn perturbed(scene: &Scene, share: f64, extent: f64) -> Scene {
    let (mut scene, d) = (scene.clone(), share * extent);
    match &mut scene.motion {
        scene::Motion::Sine(sine) => {
            for amplitude in [&mut sine.amplitude, &mut sine.amplitude_g].into_iter().flatten() {
                *amplitude *= 1.0 + share;
            }
        }
        scene::Motion::Record(record) => record.scale *= 1.0 + share,
        scene::Motion::Synthetic(quake) => quake.peak_g *= 1.0 + share,
        scene::Motion::Sweep(sweep) => sweep.amplitude_g *= 1.0 + share,
        scene::Motion::None => {}
    }
    for mu in [&mut scene.contact.mu_static, &mut scene.contact.mu_kinetic] {
        *mu *= 1.0 + share;
    }
    for (i, girder) in scene.girders.iter_mut().enumerate() {
        // No symmetry survives: each girder by another part, and up where it can, or what happens above and below the
        // middle of a face stays alike for ever.
        let part = 1.0 / (1.0 + i as f64);
        girder.initial.displacement[0] += d * part;
        girder.initial.displacement[1] -= d * part * 0.7;
        if scene.kind == Kind::Spatial && !girder.held.contains(&Direction::Z) {
            girder.initial.displacement[2] += d * part * 0.4;
        }
        girder.initial.rotation_deg += (d / girder.length * part * 0.3).to_degrees();
    }
    scene
}

/// Times of comparison by their number \[s\]: closer to one another towards the start, where runs that chatter from the first instant on
/// can be trusted for no more than moments.
fn instant(i: usize, end: f64) -> f64 {
    end * (i as f64 / COMPARED as f64).powi(4)
}

fn failed(scene: &Scene, check: Check, what: &str) -> Complaint {
    let tolerance = scene.solver.tolerance;
    Complaint { check, detail: format!("at tolerance {tolerance:e}, {what}"), tolerance: Some(tolerance) }
}

/// Largest of the girders' sizes and of the displacements \[m\].
fn extent(history: &History) -> f64 {
    (0..history.model().bodies.len()).map(|body| farthest(history, body)).fold(size(history), f64::max)
}

/// Weight of each body: 1 of a girder, of another one what its motion is less than the extent.
fn weights(history: &History) -> Vec<f64> {
    let (extent, girders) = (extent(history), history.scene().girders.len());
    let other = |body: usize| (extent / farthest(history, body)).clamp(1.0, LARGEST_WEIGHT);
    (0..history.model().bodies.len()).map(|body| if body < girders { 1.0 } else { other(body) }).collect()
}

/// The largest displacement of a body \[m\].
fn farthest(history: &History, body: usize) -> f64 {
    let at = |i: u32| history.motion(body, history.end() * f64::from(i) / 100.0).displacement.length();
    (0..=100).map(at).fold(0.0, f64::max)
}
