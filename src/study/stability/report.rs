//! Results of a study: a table of all seeds, and a page.

use std::fmt::Write as _;

use super::check::Check;
use super::{Asked, Outcome, Verdict, family};
use crate::scene::Kind;

/// Slowest seeds that the page lists.
const SLOWEST: usize = 10;

/// Every seed in a row of comma-separated values.
pub fn csv(verdicts: &[Verdict]) -> String {
    let mut text = String::from(
        "seed,family,kind,girders,duration_s,examined_s,tolerance,inside,outcome,checks,touches,events,residual,missed_m,cone,creates,gives_back,error_m,finer_error_m,trusted_s,seconds\n",
    );
    for v in verdicts {
        let f = &v.examined.figures;
        let checks: Vec<&str> = v.complaints().iter().map(|c| c.check.label()).collect();
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{:?},{:e},{:e},{},{},{},{},{},{:e},{:e},{:e},{:e},{:e},{:e},{:e},{:e},{:.4}",
            v.seed,
            v.family,
            if v.kind == Kind::Planar { "planar" } else { "spatial" },
            v.girders,
            v.duration,
            v.examined.until,
            v.tolerance,
            v.inside,
            outcome(v),
            checks.join(" "),
            f.touches,
            f.events,
            f.residual,
            f.missed,
            f.cone,
            f.creates,
            f.gives_back,
            f.error,
            f.finer_error,
            f.trusted,
            v.seconds,
        );
    }
    text
}

fn outcome(verdict: &Verdict) -> &'static str {
    match verdict.examined.outcome {
        Outcome::Passed => "passed",
        Outcome::GaveUp(_) => "gave up",
        Outcome::Refused(_) => "refused",
        Outcome::Failed(_) => "failed",
    }
}

/// The page: what was asked, what came out, every failure with the command that repeats it.
pub fn markdown(asked: &Asked, verdicts: &[Verdict], wall: f64) -> String {
    let count = |word: &str, inside: bool| verdicts.iter().filter(|v| outcome(v) == word && v.inside == inside).count();
    let all = |inside: bool| verdicts.iter().filter(|v| v.inside == inside).count();
    let cpu: f64 = verdicts.iter().map(|v| v.seconds).sum();
    let mut page = format!(
        "# Stability: {} seeds from {}{}\n\nInside the domain {}: {} passed every check, {} failed, {} refused by validation. \
         Outside {}, which are only to end well: {} ended, {} gave up and said why, {} failed, {} refused. \
         {:.1} s on {} threads, {:.4} s a seed, {} s of patience each. Of {} only the first {} events were examined.\n",
        verdicts.len(),
        asked.from,
        if asked.inside { ", those inside the domain only" } else { "" },
        all(true),
        count("passed", true),
        count("failed", true),
        count("refused", true),
        all(false),
        count("passed", false),
        count("gave up", false),
        count("failed", false),
        count("refused", false),
        wall,
        asked.threads,
        cpu / (verdicts.len().max(1)) as f64,
        asked.limits.patience,
        verdicts.iter().filter(|v| v.cut()).count(),
        asked.limits.events,
    );
    families(&mut page, verdicts);
    checks(&mut page, verdicts);
    failures(&mut page, verdicts);
    slowest(&mut page, verdicts);
    page
}

fn families(page: &mut String, verdicts: &[Verdict]) {
    page.push_str(
        "\n## Families\n\n| family | seeds | inside | failed | touches | events | slowest [s] |\n|---|---|---|---|---|---|---|\n",
    );
    for name in family::names() {
        let mine: Vec<&Verdict> = verdicts.iter().filter(|v| v.family == name).collect();
        let touches: usize = mine.iter().map(|v| v.examined.figures.touches).sum();
        let events: usize = mine.iter().map(|v| v.examined.figures.events).sum();
        let failed = mine.iter().filter(|v| v.failed()).count();
        let slowest = mine.iter().map(|v| v.seconds).fold(0.0, f64::max);
        let inside = mine.iter().filter(|v| v.inside).count();
        let _ =
            writeln!(page, "| {name} | {} | {inside} | {failed} | {touches} | {events} | {slowest:.2} |", mine.len());
    }
}

fn checks(page: &mut String, verdicts: &[Verdict]) {
    page.push_str("\n## Checks\n\nOutside the domain: `panic`, `time` and `numbers`.\n\n| check | failed | what is claimed |\n|---|---|---|\n");
    for check in Check::ALL {
        let failed = verdicts.iter().filter(|v| v.complaints().iter().any(|c| c.check == check)).count();
        let _ = writeln!(page, "| {} | {failed} | {} |", check.label(), check.claim());
    }
    let worst = |figure: fn(&Verdict) -> f64| verdicts.iter().map(figure).fold(0.0, f64::max);
    let _ = writeln!(
        page,
        "\nLargest over all seeds: ledger residual {:.1e} of the largest energy, penetration without a contact {:.1e} m, \
         friction beyond its cone {:.1e} of the peak force, shrinking of a loss {:.1e} of the largest energy; \
         given back by friction and its dashpot over a touch (return mapping) {:.1e}.",
        worst(|v| v.examined.figures.residual),
        worst(|v| v.examined.figures.missed),
        worst(|v| v.examined.figures.cone),
        worst(|v| v.examined.figures.creates),
        worst(|v| v.examined.figures.gives_back),
    );
}

fn failures(page: &mut String, verdicts: &[Verdict]) {
    page.push_str("\n## Failures\n");
    let failed: Vec<&Verdict> = verdicts.iter().filter(|v| v.failed()).collect();
    if failed.is_empty() {
        page.push_str("\nNone.\n");
    }
    for verdict in failed {
        let seed = verdict.seed;
        let _ = writeln!(
            page,
            "\n### Seed {seed}, {}\n\n    girderbench study stability --seeds 1 --from {seed} --out seed-{seed}\n    \
             girderbench run seed-{seed}.toml\n",
            verdict.family
        );
        for complaint in verdict.complaints() {
            let _ = writeln!(page, "- {}: {}", complaint.check.label(), complaint.detail);
        }
    }
}

fn slowest(page: &mut String, verdicts: &[Verdict]) {
    let mut order: Vec<&Verdict> = verdicts.iter().collect();
    order.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
    page.push_str("\n## Slowest seeds\n\n| seed | family | time [s] |\n|---|---|---|\n");
    for verdict in order.into_iter().take(SLOWEST) {
        let _ = writeln!(page, "| {} | {} | {:.3} |", verdict.seed, verdict.family, verdict.seconds);
    }
}
