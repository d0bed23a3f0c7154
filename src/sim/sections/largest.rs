//! Largest section forces and stress of an elastic girder: in flights bounds of their second derivatives leave no peak unseen, in steps
//! they are looked for several times.

use crate::dynamics::free_flight::body_flight::BodyFlight;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::model::coordinates::section_forces::{Equilibrium, SectionForces, Station, Strained};
use crate::dynamics::model::elastic_body::ElasticBody;
use crate::dynamics::trajectory::stored_path::StoredMotion;
use crate::sim::looks;
use crate::sim::peaks::{self, NEAR, exceeds, golden};
use crate::sim::readings::Extreme;
use crate::sim::sections::view::Sections;

/// Fewest stations beside those where loads act.
const FEWEST: usize = 17;
/// Distance to the section before a load, in parts of half the length: a load is not beyond its own station. Chosen: moments change by
/// as small a part over it.
const BEFORE: f64 = 1e-9;
/// Part of the largest value by which a peak has to be able to be larger to be looked for. Chosen: the fifth printed digit.
const PART: f64 = 1e-5;
/// Part of the forces of a girder's sections below which one of them is rounding of the others. Chosen: seven digits above rounding.
const ROUNDING: f64 = 1e-9;
/// Factor on bounds by strain, for the difference of section forces by strain and from equilibrium, and for values between stations.
/// Measured: with it none of 8000 looks at 81 stations of 30 random girders was above what was found by more than [`PART`].
const MARGIN: f64 = 2.0;
/// Searches along the girder and in time by turns about the largest stress at the stations. Chosen: each begins at the
/// largest value of the one before.
const ALTERNATIONS: usize = 3;
/// Parts of the time of an axial wave from end to end on both sides of a peak within which its time is searched at another station. Chosen: half a
/// period of a wave of a twelfth of the length.
const PER_TRANSIT: f64 = 24.0;
/// Most halvings of the time between two looks: a guard, where values are rounding alone.
const DEEPEST: u32 = 40;

/// Number of values that are searched: the largest |N| \[N\], |M|, |`M_y`| and |T| \[N·m\] of both sides of mid-span; the largest stress of
/// the extreme fibre \[Pa\] and |N| of all stations.
pub(in crate::sim) const VALUES: usize = 6;

/// Below which each of the [`VALUES`] of a girder of this half length \[m\] is rounding of the others: its force is 1e-9 of N, and of the
/// moments over half the length.
pub(in crate::sim) fn rounding(values: &[f64; VALUES], half: f64) -> [f64; VALUES] {
    let [axial, moment, vertical, torque, stress, along] = *values;
    let moments = moment.max(vertical).max(torque);
    let force = ROUNDING * axial.max(along).max(moments / half);
    [force, force * half, force * half, force * half, ROUNDING * stress, force]
}

/// A reading of section forces: not negative, and of a sum of forces no larger than the sum of the readings of each.
struct Reading<'a> {
    /// Stress of the extreme fibre; `None` where no values of all stations are asked for.
    fibre: Option<&'a dyn Fn(&SectionForces) -> f64>,
    /// Stations that are looked at at every instant, and mid-span.
    fixed: Vec<Station>,
    middle: Station,
}

impl<'a> Reading<'a> {
    /// Reading of a girder whose fields have this degree.
    fn new(fibre: Option<&'a dyn Fn(&SectionForces) -> f64>, degree: usize) -> Self {
        let fixed = fixed_stations(degree).map(|xi| Station::new(degree, xi)).collect();
        Self { fibre, fixed, middle: Station::new(degree, 0.0) }
    }

    /// At one instant, beside the stations of every instant at those of its loads.
    fn values(&self, equilibrium: &Equilibrium) -> [f64; VALUES] {
        let (half, mut most) = (equilibrium.half(), [0.0f64; VALUES]);
        if equilibrium.loaded().any(|s| s.abs() <= BEFORE * half) {
            // The sections on both sides of a load at mid-span.
            for side in [-2.0, 2.0] {
                at_middle(&mut most, &equilibrium.at(side * BEFORE * half));
            }
        } else {
            at_middle(&mut most, &equilibrium.at_station(&self.middle));
        }
        let Some(fibre) = self.fibre else { return most };
        self.fixed.iter().for_each(|station| anywhere(&mut most, &equilibrium.at_station(station), fibre));
        beside_loads(equilibrium).for_each(|s| anywhere(&mut most, &equilibrium.at(s), fibre));
        most
    }

    /// Values at one instant by strain, at the stations of every instant.
    fn by_strain(&self, strained: &Strained) -> [f64; VALUES] {
        let mut most = [0.0f64; VALUES];
        at_middle(&mut most, &strained.at(0.0));
        let Some(fibre) = self.fibre else { return most };
        self.fixed.iter().for_each(|station| anywhere(&mut most, &strained.at(strained.half() * station.xi()), fibre));
        most
    }
}

/// Takes the section forces at mid-span into the first four values.
fn at_middle(most: &mut [f64; VALUES], forces: &SectionForces) {
    let own = [forces.axial, forces.moment, forces.vertical_moment, forces.torque];
    most.iter_mut().zip(own).for_each(|(most, own)| *most = most.max(own.abs()));
}

/// Takes the section forces at any station into the last two.
fn anywhere(most: &mut [f64; VALUES], forces: &SectionForces, fibre: &dyn Fn(&SectionForces) -> f64) {
    most[4] = most[4].max(fibre(forces));
    most[5] = most[5].max(forces.axial.abs());
}

/// Two looks that follow one another, with the flight between them.
struct Interval<'a> {
    span: [f64; 2],
    flight: Option<&'a BodyFlight>,
}

/// The largest value seen, and how far from it on both sides the next looks are \[s\].
#[derive(Clone, Copy)]
struct Seen {
    largest: Extreme,
    apart: [f64; 2],
}

impl<'a> Sections<'a> {
    /// The largest of each of the [`VALUES`] over the run; without `fibre`, its stress by section forces, 0 in place of the last two.
    pub(in crate::sim) fn largest_values(
        self,
        girder: usize,
        made: &ElasticBody,
        fibre: Option<&dyn Fn(&SectionForces) -> f64>,
    ) -> [Extreme; VALUES] {
        let reading = Reading::new(fibre, made.degree());
        let values = |t: f64| reading.values(&self.equilibrium_in(girder, made, (t, &self.history.state(girder, t))));
        let gains = self.gains(girder, made, &reading);
        let bound = |interval: &Interval<'_>| -> Option<[f64; VALUES]> {
            let second = interval.flight?.second_derivatives(interval.span);
            let mut sum = [0.0; VALUES];
            for (gain, second) in gains.iter().zip(second) {
                sum.iter_mut().zip(gain).for_each(|(sum, gain)| *sum += MARGIN * gain * second);
            }
            Some(sum)
        };
        let half = 0.5 * self.history.model().bodies[girder].prism.length;
        largest((&self.intervals(girder), half), &values, &bound)
    }

    /// By how much a unit coefficient of each exponential of the girder's free motion changes each value at most, by strain.
    fn gains(self, girder: usize, made: &ElasticBody, reading: &Reading<'_>) -> Vec<[f64; VALUES]> {
        let by = |state: &Vec<f64>| reading.by_strain(&made.strained(state));
        let shapes = self.history.trajectories.free_motion(girder).map_or(Vec::new(), BodyMotion::shapes);
        let both = |[real, imaginary]: &[Vec<f64>; 2]| {
            let (mut one, other) = (by(real), by(imaginary));
            one.iter_mut().zip(other).for_each(|(one, other)| *one += other);
            one
        };
        shapes.iter().map(both).collect()
    }

    /// The run of a girder, cut where it is looked at: as bodies are, and at every kink of the ground's motion in flights.
    fn intervals(self, girder: usize) -> Vec<Interval<'a>> {
        let (ground, path) = (&self.history.model().ground, self.history.trajectories.path(girder));
        let looks = looks::of_body(self.history, girder);
        let mut intervals = Vec::with_capacity(looks.len());
        for pair in looks.windows(2) {
            let flight = match path.at(pair[0]) {
                Some((_, StoredMotion::Flight(flight))) => Some(flight),
                _ => None,
            };
            let mut from = pair[0];
            while flight.is_some() && ground.next_kink(from) < pair[1] {
                let kink = ground.next_kink(from);
                intervals.push(Interval { span: [from, kink], flight });
                from = kink;
            }
            intervals.push(Interval { span: [from, pair[1]], flight });
        }
        intervals
    }

    /// The largest value over the stations about the time at which it is largest of those that are looked at, and where.
    pub(in crate::sim) fn between_stations(
        self,
        girder: usize,
        made: &ElasticBody,
        seen: Extreme,
        value: &dyn Fn(&SectionForces) -> f64,
    ) -> (Extreme, f64) {
        let at = |t: f64| self.equilibrium_in(girder, made, (t, &self.history.state(girder, t)));
        let near = self.flexible(girder).map_or(0.0, |flexible| flexible.beam.transit_time()) / PER_TRANSIT;
        let mut most = (seen, 0.0);
        for _ in 0..ALTERNATIONS {
            let here = at(most.0.t);
            let station = peaks::largest(&stations(&here, made.degree()), &|s| value(&here.at(s))).t;
            let around = [-near, 0.0, near].map(|dt| (most.0.t + dt).clamp(0.0, self.history.end()));
            most = (peaks::largest(&around, &|t| value(&at(t).at(station))), station);
        }
        most
    }
}

/// Largest values found so far.
struct Search {
    values: [Seen; VALUES],
    /// Below which each is rounding.
    rounding: [f64; VALUES],
}

impl Search {
    fn see(&mut self, t: f64, values: &[f64; VALUES], apart: [f64; 2]) {
        for (seen, &value) in self.values.iter_mut().zip(values) {
            if exceeds(value, seen.largest.value) {
                *seen = Seen { largest: Extreme { value, t }, apart };
            }
        }
    }

    /// Whether a value between two looks can be larger than the largest by more than [`PART`] of it, and than rounding.
    fn may_hide(&self, [one, other]: [&[f64; VALUES]; 2], second: &[f64; VALUES], width: f64) -> bool {
        let hides = |(i, seen): (usize, &Seen)| {
            let resolved = (PART * seen.largest.value).max(self.rounding[i]);
            one[i].max(other[i]) + second[i] * width * width / 8.0 > seen.largest.value + resolved
        };
        self.values.iter().enumerate().any(hides)
    }

    /// Takes note that an interval was halved.
    fn halved(&mut self, [from, until]: [f64; 2]) {
        let half = 0.5 * (until - from);
        for Seen { largest, apart: [before, after] } in &mut self.values {
            if largest.t == from {
                *after = half;
            } else if largest.t == until {
                *before = half;
            }
        }
    }
}

/// Largest values over intervals that follow one another. Where second derivatives are bounded, |f″| ≤ B, no value between looks that are
/// h apart is above both by more than `B h²/8`: intervals are halved until none can hide a larger one.
fn largest(
    (intervals, half): (&[Interval<'_>], f64),
    values: &dyn Fn(f64) -> [f64; VALUES],
    bound: &dyn Fn(&Interval<'_>) -> Option<[f64; VALUES]>,
) -> [Extreme; VALUES] {
    let Some(last) = intervals.last() else { return [Extreme { value: f64::NAN, t: 0.0 }; VALUES] };
    let times: Vec<f64> = intervals.iter().map(|interval| interval.span[0]).chain([last.span[1]]).collect();
    let looks: Vec<[f64; VALUES]> = times.iter().map(|t| values(*t)).collect();
    let around = |i: usize| [times[i] - times[i.saturating_sub(1)], times[(i + 1).min(times.len() - 1)] - times[i]];
    let nothing = Seen { largest: Extreme { value: 0.0, t: times[0] }, apart: around(0) };
    let mut search = Search { values: [nothing; VALUES], rounding: [0.0; VALUES] };
    for (i, look) in looks.iter().enumerate() {
        search.see(times[i], look, around(i));
    }
    search.rounding = rounding(&search.values.map(|seen| seen.largest.value), half);
    for (i, interval) in intervals.iter().enumerate() {
        let Some(second) = bound(interval) else { continue };
        let mut open = vec![(interval.span, [looks[i], looks[i + 1]], 0)];
        while let Some(([from, until], [one, other], depth)) = open.pop() {
            if depth == DEEPEST || !search.may_hide([&one, &other], &second, until - from) {
                continue;
            }
            let t = f64::midpoint(from, until);
            let middle = values(t);
            search.halved([from, until]);
            search.see(t, &middle, [0.5 * (until - from); 2]);
            open.push(([t, until], [middle, other], depth + 1));
            open.push(([from, t], [one, middle], depth + 1));
        }
    }
    // In steps: about every look that is not below its neighbours and near the highest.
    let in_steps = (1..intervals.len()).filter(|i| intervals[i - 1].flight.and(intervals[*i].flight).is_none());
    let peaks: Vec<usize> = in_steps.collect();
    std::array::from_fn(|own| {
        let Seen { largest, apart: [before, after] } = search.values[own];
        let own_peaks = peaks.iter().copied().filter(|&i| {
            let [one, here, other] = [i - 1, i, i + 1].map(|i| looks[i][own]);
            here >= one && here >= other && here > NEAR * largest.value && (exceeds(here, one) || exceeds(here, other))
        });
        let spans = own_peaks.map(|i| [times[i - 1], times[i + 1]]);
        spans.chain([[largest.t - before, largest.t + after]]).fold(largest, |most, [from, until]| {
            let inside = golden(&|t| values(t)[own], from, until);
            if exceeds(inside.value, most.value) { inside } else { most }
        })
    })
}

/// Stations that are looked at at every instant, in order, from −1 to 1: four for every turn that a polynomial of the moment's degree can
/// take, closer at the ends as its turns are.
fn fixed_stations(degree: usize) -> impl Iterator<Item = f64> {
    let last = (FEWEST - 1).max(4 * (degree + 2));
    (0..=last).map(move |i| (std::f64::consts::PI * (i as f64 / last as f64 - 0.5)).sin())
}

/// Stations on both sides of every load \[m\].
fn beside_loads(equilibrium: &Equilibrium) -> impl Iterator<Item = f64> + '_ {
    let half = equilibrium.half();
    equilibrium.loaded().flat_map(move |s| [s - BEFORE * half, s]).map(move |s| s.clamp(-half, half))
}

/// All of them, in order \[m\].
fn stations(equilibrium: &Equilibrium, degree: usize) -> Vec<f64> {
    let fixed = fixed_stations(degree).map(|xi| xi * equilibrium.half());
    let mut stations: Vec<f64> = fixed.chain(beside_loads(equilibrium)).collect();
    stations.sort_by(f64::total_cmp);
    stations.dedup();
    stations
}
