//! Who stays in contact and how, once no point is driven in any more (Tables 4–7).
//!
//! A corner leaves when its normal acceleration without any reaction is ≥ 0; else it sticks if `N ≥ 0` and
//! `|T| ≤ μ_s N`, else it slides the way whose own solution agrees. A face is kept while both of its ends are pushed, which
//! is `|η| ≤ b_f`. Where stick and slide are both consistent (high μ, before the Painlevé bound), stick is taken.

use crate::dynamics::Model;
use crate::dynamics::impact2d::delassus::Point;
use crate::dynamics::impact2d::lasting::constrained_motion::{Answer, Scenery, Seat, Way, middle, react};
use crate::scene::ImpactSettings;

/// Accelerations and forces that differ by less than this part of the largest are the same.
pub(in crate::dynamics::impact2d) const ROUNDING: f64 = 1e-10;
/// Guesses for all seats together; with more pairs than that, seat by seat.
const MOST_GUESSES: usize = 4096;
/// Rounds of going through the seats one by one.
const ROUNDS: usize = 64;

/// A pair that may stay in contact.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// The pair, its number in the model.
    pub pair: usize,
    /// Declared contacts with no gap and no speed along the normal: one or two.
    pub sites: Vec<usize>,
    /// Where they are.
    pub points: Vec<Point>,
    /// The way it slides; 0 where it is at rest along the face.
    pub slides: f64,
    /// Whether it is so slow that it stays put where it can, although it slides.
    pub stays_or_leaves: bool,
    /// What an event has just ruled out.
    pub ruled_out: RuledOut,
}

/// What an event has ended.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RuledOut {
    /// Staying put.
    pub held: bool,
    /// A contact, by its number in the model, that is not pushed any more.
    pub site: Option<usize>,
}

impl Candidate {
    /// Everything that the pair may do, in the order in which it is tried; nothing is leaving.
    fn options(&self) -> Vec<Option<Seat>> {
        let mut all = vec![None];
        let faces = (self.sites.len() > 1).then(|| self.sites.clone());
        let kept = |sites: &Vec<usize>| self.ruled_out.site.is_none_or(|out| !sites.contains(&out));
        for sites in faces.into_iter().chain(self.sites.iter().map(|&site| vec![site])).filter(kept) {
            let ways: &[Way] = match self.slides {
                _ if self.stays_or_leaves => &[Way::Held],
                v if v > 0.0 => &[Way::Slides(1.0)],
                v if v < 0.0 => &[Way::Slides(-1.0)],
                _ if self.ruled_out.held => &[Way::Slides(1.0), Way::Slides(-1.0)],
                _ => &[Way::Held, Way::Slides(1.0), Way::Slides(-1.0)],
            };
            all.extend(ways.iter().map(|&way| Some(Seat { pair: self.pair, sites: sites.clone(), way })));
        }
        all
    }
}

/// Seats of all candidates together; nothing where no choice is consistent (Painlevé).
pub fn decide(
    model: &Model,
    scenery: &Scenery,
    candidates: &[Candidate],
    numbers: &ImpactSettings,
) -> Option<Vec<Seat>> {
    let judge = Judge { model, scenery, candidates, numbers };
    let options: Vec<Vec<Option<Seat>>> = candidates.iter().map(Candidate::options).collect();
    let guesses = options.iter().map(Vec::len).try_fold(1usize, usize::checked_mul);
    let choice = match guesses {
        Some(guesses) if guesses <= MOST_GUESSES => (0..guesses).find_map(|guess| {
            let choice = digits(guess, &options);
            judge.agrees(&choice, None).then_some(choice)
        }),
        _ => one_by_one(&judge, &options),
    };
    choice.map(|choice| choice.into_iter().flatten().collect())
}

/// The guess of that number, the first candidate's options first.
fn digits(mut guess: usize, options: &[Vec<Option<Seat>>]) -> Vec<Option<Seat>> {
    let digit = |of: &Vec<Option<Seat>>| {
        let option = of[guess % of.len()].clone();
        guess /= of.len();
        option
    };
    options.iter().map(digit).collect()
}

/// Each takes its first option that agrees with what the others do, until nobody changes any more.
fn one_by_one(judge: &Judge<'_>, options: &[Vec<Option<Seat>>]) -> Option<Vec<Option<Seat>>> {
    let mut choice: Vec<Option<Seat>> = options.iter().map(|of| of.last().cloned().flatten()).collect();
    for _ in 0..ROUNDS {
        let before = choice.clone();
        for (i, of) in options.iter().enumerate() {
            for option in of {
                choice[i].clone_from(option);
                if judge.agrees(&choice, Some(i)) {
                    break;
                }
            }
        }
        if choice == before {
            return judge.agrees(&choice, None).then_some(choice);
        }
    }
    None
}

struct Judge<'a> {
    model: &'a Model,
    scenery: &'a Scenery,
    candidates: &'a [Candidate],
    numbers: &'a ImpactSettings,
}

impl Judge<'_> {
    /// Whether a choice contradicts nothing; of one candidate, or of all.
    fn agrees(&self, choice: &[Option<Seat>], only: Option<usize>) -> bool {
        let seats: Vec<Seat> = choice.iter().flatten().cloned().collect();
        let points: Vec<Vec<Point>> = seats.iter().map(|seat| self.scenery.points(self.model, seat)).collect();
        let Some(answer) = react(self.scenery, &seats, &points, self.numbers) else { return false };
        let scale = self.scale();
        let mut seated = 0;
        for (i, (option, candidate)) in choice.iter().zip(self.candidates).enumerate() {
            let number = seated;
            seated += usize::from(option.is_some());
            if only.is_some_and(|one| one != i) {
                continue;
            }
            let kept = option.as_ref().map_or(&[][..], |seat| &seat.sites[..]);
            let leaves = |(site, point): (&usize, &Point)| {
                kept.contains(site) || answer.along(point, point.n, point.bias[0]) >= -ROUNDING * scale
            };
            if !candidate.sites.iter().zip(&candidate.points).all(leaves) {
                return false;
            }
            if let Some(seat) = option
                && !self.holds(seat, &points[number], &answer, number, candidate)
            {
                return false;
            }
        }
        true
    }

    /// Whether a seat pushes, and its friction agrees with its way.
    fn holds(&self, seat: &Seat, points: &[Point], answer: &Answer, number: usize, candidate: &Candidate) -> bool {
        let reaction = &answer.reactions[number];
        let [mu_s, mu_k] = seat.friction(self.numbers);
        let middle = middle(points);
        let [w_n, _, w_ns] = self.scenery.cluster.mobilities(&middle);
        let force = self.scenery.rounding(&middle);
        let n = seat.sites.len();
        if reaction.normal[..n].iter().any(|push| *push < -force) {
            return false;
        }
        match seat.way {
            Way::Held => reaction.tangential.abs() <= mu_s * reaction.total() + force,
            // Past the Painlevé bound a push would drive the point in.
            Way::Slides(sign) if w_n - mu_k * sign * w_ns <= 0.0 => false,
            Way::Slides(sign) => {
                candidate.slides != 0.0
                    || sign * answer.along(&middle, middle.s, middle.bias[1]) >= -ROUNDING * self.scale()
            }
        }
    }

    /// Size of the accelerations in play \[m/s²\].
    fn scale(&self) -> f64 {
        self.scenery.scale()
    }
}
