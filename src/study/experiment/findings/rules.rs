//! The rules that decide the findings, from what was seen of runs. The paper gives few numbers; each limit is stated in the claim
//! and is none of the paper's unless it says so.

use super::verdict::Check;
use crate::study::experiment::observe::{FRAME, GirderSeen, HitSeen, Observed};

/// Cycles of a sine that are looked at, the last ones of a run.
const CYCLES: usize = 10;
/// Largest movement of an end by rotation that is almost none, of the transverse displacement: a tenth.
const ALMOST_NONE: f64 = 0.1;
/// Largest change of a displacement that is hardly a change: a fifth.
const HARDLY: f64 = 0.2;
/// Ratio that counts as "much more" \[–\].
const MUCH: f64 = 2.0;
/// Largest jump of a velocity that is not seen, of the largest velocity: a tenth.
const UNSEEN: f64 = 0.1;

/// Hits in succession: those less than half a period after the one before.
pub fn successions(hits: &[HitSeen], period: f64) -> Vec<&[HitSeen]> {
    hits.chunk_by(|a, b| b.from - a.until < 0.5 * period).collect()
}

/// Numbers of hits in the successions of the last cycles.
fn sizes(seen: &Observed, period: f64) -> Vec<usize> {
    let from = seen.end - (CYCLES as f64 + 1.0) * period;
    let all = successions(&seen.hits, period);
    // The first one begins before the stretch that is looked at, or may.
    let late = all.into_iter().filter(|hits| hits[0].from >= from);
    let sizes: Vec<usize> = late.map(<[HitSeen]>::len).collect();
    sizes[sizes.len().saturating_sub(CYCLES)..].to_vec()
}

/// Mean number of hits in the successions of the last cycles; none where there is not one a cycle.
pub fn hits_a_cycle(seen: &Observed, period: f64) -> Option<f64> {
    let sizes = sizes(seen, period);
    (sizes.len() == CYCLES).then(|| sizes.iter().sum::<usize>() as f64 / CYCLES as f64)
}

fn succession(seen: &Observed, period: f64, wanted: usize, amplitude: &str) -> Check {
    let sizes = sizes(seen, period);
    let holds = sizes.len() == CYCLES && sizes.iter().all(|&size| size == wanted);
    let found = match (sizes.iter().min(), sizes.iter().max()) {
        (Some(least), Some(most)) if least == most => format!("{least} in each of {}", sizes.len()),
        (Some(least), Some(most)) => format!("{least} to {most} in {}", sizes.len()),
        _ => "no hit".to_owned(),
    };
    let hits = if wanted == 1 { "hit" } else { "hits in succession" };
    Check::new(format!("{wanted} {hits} in each of the last {CYCLES} cycles at {amplitude}"), found, holds)
}

/// Head-on sine: one hit a cycle at the small amplitude, two in succession at the large one.
pub fn head_on(small: &Observed, large: &Observed, period: f64) -> Vec<Check> {
    vec![succession(small, period, 1, "0.23 g"), succession(large, period, 2, "0.40 g")]
}

/// Movement of the ends of a girder by its rotation over its transverse displacement.
pub fn end_movement(girder: &GirderSeen, half_length: f64) -> f64 {
    girder.largest[2] * half_length / girder.largest[1]
}

/// Median time between the first touches of the two corners in a succession of hits; none where one corner alone is hit \[s\].
pub fn corner_lag(hits: &[HitSeen], period: f64) -> Option<f64> {
    let first = |hits: &[HitSeen], side: usize| hits.iter().find_map(|hit| hit.corners[side]);
    let lag = |hits: &&[HitSeen]| Some((first(hits, 0)? - first(hits, 1)?).abs());
    let mut lags: Vec<f64> = successions(hits, period).iter().filter_map(lag).collect();
    lags.sort_by(f64::total_cmp);
    lags.get(lags.len() / 2).copied()
}

/// Straight girder hit obliquely: transverse displacement with almost no rotation at the small angle, one corner after the other
/// at the large one.
pub fn oblique(small: &Observed, large: &Observed, half_length: f64, period: f64) -> Option<Vec<Check>> {
    let (near, far) = (small.girders.first()?, large.girders.first()?);
    let (along, across) = (near.largest[0], near.largest[1]);
    let part = end_movement(near, half_length);
    let lag = corner_lag(&large.hits, period);
    let lag_words = lag.map_or("the other corner is not hit".to_owned(), |lag| format!("{:.2} ms apart", 1e3 * lag));
    let turn = |girder: &GirderSeen| girder.largest[2].to_degrees();
    Some(vec![
        Check::new(
            "at 22.5° it moves across, by a tenth of the way along at least",
            format!("{:.2} mm across, {:.2} mm along", 1e3 * across, 1e3 * along),
            across >= 0.1 * along,
        ),
        Check::new(
            "at 22.5° its ends move by its rotation less than a tenth of that",
            format!("{:.2}° moves them by {:.2} of it", turn(near), part),
            part < ALMOST_NONE,
        ),
        Check::new(
            "at 67.5° it turns more than at 22.5°",
            format!("{:.2}° against {:.2}°", turn(far), turn(near)),
            far.largest[2] > near.largest[2],
        ),
        Check::new(
            "at 67.5° one corner hits, then the other, a frame of the film (33 ms) apart at least",
            lag_words,
            lag.is_some_and(|lag| lag >= FRAME),
        ),
    ])
}

/// Rotation of the 45° girder over that of the 60° girder, both driven along the axis: over the whole run, of which the sudden
/// start of the sine is a part, and in its second half.
pub fn skew(of_60: &Observed, of_45: &Observed) -> Vec<Check> {
    let check = |when: &str, turned: [f64; 2]| {
        let [of_60, of_45] = turned.map(f64::to_degrees);
        let ratio = of_45 / of_60;
        let found = format!("{of_45:.2}° against {of_60:.2}°, ratio {ratio:.2}");
        [
            Check::new(format!("{when} the 45° girder turns more than the 60° one"), found.clone(), ratio > 1.0),
            Check::new(format!("{when} it turns much more: twice as much at least"), found, ratio >= MUCH),
        ]
    };
    let whole = check("over the run", [of_60, of_45].map(Observed::rotation));
    let late = check("in its second half", [of_60, of_45].map(Observed::late_rotation));
    whole.into_iter().chain(late).collect()
}

/// Largest rotation at angles of one sign over that on the axis; angles \[degrees\] and rotations \[rad\].
pub fn growth(rotations: &[(f64, f64)], sign: f64) -> Option<f64> {
    let axis = rotations.iter().find(|(angle, _)| *angle == 0.0)?.1;
    let side = rotations.iter().filter(|(angle, _)| angle * sign > 0.0).map(|(_, rotation)| *rotation);
    side.max_by(f64::total_cmp).map(|largest| largest / axis)
}

/// Rotation against excitation angle (Fig. 11).
pub fn leaving_the_axis(rotations: &[(f64, f64)]) -> Option<Vec<Check>> {
    let axis = rotations.iter().find(|(angle, _)| *angle == 0.0)?.1;
    let side = |sign: f64, word: &str| {
        let ratio = growth(rotations, sign)?;
        let found = format!("{:.2}° against {:.2}° on the axis", (ratio * axis).to_degrees(), axis.to_degrees());
        Some(Check::new(format!("it turns more at {word} angles than at 0°"), found, ratio > 1.0))
    };
    Some(vec![side(-1.0, "negative")?, side(1.0, "positive")?])
}

/// Spread of a quantity over runs that differ in restitution alone: largest over least, less 1.
pub fn spread(values: impl Iterator<Item = f64>) -> f64 {
    let (least, most) = values.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
    most / least - 1.0
}

/// Largest |x|, |y|, |θ| of runs with different restitution, one list a case.
pub fn restitution(cases: &[Vec<[f64; 3]>]) -> Vec<Check> {
    let check = |(axis, name): (usize, &str)| {
        // What is 0 throughout, the transverse motion of a girder driven along its axis, does not change.
        let moving = cases.iter().filter(|runs| runs.iter().all(|run| run[axis] > 1e-9));
        let worst = moving.map(|runs| spread(runs.iter().map(|run| run[axis]))).fold(0.0, f64::max);
        let found = format!("{:.0} %", 100.0 * worst);
        Check::new(
            format!("largest {name} differs by {:.0} % at most for e_n from 0.2 to 0.8", 100.0 * HARDLY),
            found,
            worst <= HARDLY,
        )
    };
    [(0, "displacement along"), (1, "displacement across"), (2, "rotation")].map(check).into()
}

/// Longest stretch of state c, contact that slides and turns \[s\].
pub fn longest_sliding_rotation(seen: &Observed) -> f64 {
    let stretches = seen.girders.iter().flat_map(|girder| &girder.states).filter(|stretch| stretch.letter == 'c');
    stretches.map(super::super::states::Stretch::length).fold(0.0, f64::max)
}

/// Sliding rotation that lasts longer than a hit does, `hit` \[s\].
fn sliding(seen: &Observed, hit: f64, wanted: bool) -> Check {
    let longest = longest_sliding_rotation(seen);
    let claim = if wanted {
        "contact that slides and turns (c) lasts longer than a hit"
    } else {
        "no contact slides and turns (c) for longer than a hit"
    };
    let claim = format!("{claim}, {:.1} ms", 1e3 * hit);
    Check::new(claim, format!("{:.1} ms at most", 1e3 * longest), (longest > hit) == wanted)
}

/// Straight girder, sine at 45°.
pub fn sliding_rotation(seen: &Observed, hit: f64) -> Vec<Check> {
    vec![sliding(seen, hit, true)]
}

/// The earthquake: both patterns of hits head-on; at 45° less rotation than under the sine, and no sliding rotation.
pub fn earthquake(head_on: &Observed, oblique: &Observed, sine: &Observed, period: f64, hit: f64) -> Vec<Check> {
    let sizes: Vec<usize> = successions(&head_on.hits, period).iter().map(|hits| hits.len()).collect();
    let (single, several) = (sizes.iter().filter(|&&n| n == 1).count(), sizes.iter().filter(|&&n| n > 1).count());
    let turned = [oblique.rotation(), sine.rotation()].map(f64::to_degrees);
    vec![
        Check::new(
            "head-on there are single hits and hits in succession",
            format!("{single} single, {several} successions"),
            single > 0 && several > 0,
        ),
        Check::new(
            "at 45° it turns less than under the sine of 0.40 g",
            format!("{:.2}° against {:.2}°", turned[0], turned[1]),
            turned[0] < turned[1],
        ),
        sliding(oblique, hit, false),
    ]
}

/// Largest change of the transverse velocity by a hit, of the largest transverse velocity.
pub fn transverse_jump(seen: &Observed) -> Option<Vec<Check>> {
    let girder = seen.girders.first()?;
    let largest = |axis: usize| seen.hits.iter().map(|hit| hit.jump[axis]).fold(0.0, f64::max) / girder.fastest[axis];
    let (along, across) = (largest(0), largest(1));
    let claim = format!("a hit changes v_y within a frame of the film by less than {UNSEEN} of its largest value");
    Some(vec![Check::new(claim, format!("{across:.2}, against {along:.2} of v_x"), across < UNSEEN)])
}

/// Rotations of girders against their transverse displacements.
pub fn tiny_rotations(seen: &Observed, half_length: f64) -> Vec<Check> {
    let check = |girder: &GirderSeen| {
        let part = end_movement(girder, half_length);
        let found = format!(
            "{:.3}° moves them by {part:.2} of {:.2} mm",
            girder.largest[2].to_degrees(),
            1e3 * girder.largest[1]
        );
        let claim = format!("the ends of {} move by its rotation less than a tenth of its way across", girder.name);
        Check::new(claim, found, part < ALMOST_NONE)
    };
    seen.girders.iter().map(check).collect()
}

/// Condition (6) of the two skewed girders against the paper's printed numbers.
pub fn rotation_condition(of_60: f64, of_45: f64) -> Vec<Check> {
    let check = |beta: u32, number: f64, printed: f64| {
        let claim = format!("(6) at β = {beta}° is the printed {printed}, and 1 or more");
        Check::new(claim, format!("{number:.3}"), number >= 1.0 && (number - printed).abs() <= 0.01)
    };
    vec![check(60, of_60, 1.18), check(45, of_45, 1.35)]
}
