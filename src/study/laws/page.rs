//! The comparison of normal laws as a page, CSV and plots.

use std::fmt::Write as _;

use super::{ASKED, Outcome, SPEED};
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::study::Occasion;

/// Every law: `law,e_hit,depth_hit_m,lasting_hit_s,force_hit_n,hits,force_n,displacement_m,lost_j,residual`.
pub fn csv(outcomes: &[Outcome]) -> String {
    let mut table =
        "law,e_hit,depth_hit_m,lasting_hit_s,force_hit_n,hits,force_n,displacement_m,lost_j,residual\n".to_owned();
    for o in outcomes {
        let name = o.variant.name();
        let _ = writeln!(
            table,
            "\"{name}\",{:.12},{:e},{:e},{:e},{},{:e},{:e},{:e},{:e}",
            o.returned, o.depth, o.lasting, o.force, o.hits, o.greatest, o.displacement, o.lost, o.residual
        );
    }
    table
}

/// The page, in Markdown.
pub fn page(outcomes: &[Outcome], occasion: &Occasion, extension: &str) -> String {
    let Occasion { date, machine, command } = occasion;
    let mut page = format!(
        "# Normal laws compared\n\nComputed {date} on {machine}: `{command}`. The [laws](../physics.md#normal-law), each calibrated exactly \
         for e = {ASKED} unless said otherwise.\n\n\
         ## One hit\n\nThe straight girder of 2 kg, without bearings, hits the wall flush at {SPEED} m/s, the speed of the laws' \
         design, K = 1.55e5 N/m.\n\n\
         | law | e' | penetration [mm] | contact [ms] | force [N] |\n|---|---|---|---|---|\n"
    );
    for o in outcomes {
        let _ = writeln!(
            page,
            "| `{}` | {:.6} | {:.6} | {:.5} | {:.1} |",
            o.variant.name(),
            o.returned,
            o.depth * 1e3,
            o.lasting * 1e3,
            o.force
        );
    }
    let _ = write!(
        page,
        "\n![Force against penetration of one hit, law by law](laws-hit.{extension})\n\n\
         ## Ten seconds\n\nThe preset straight-abutment, 0.40 g at 2.4 Hz head-on: 24 periods.\n\n\
         | law | hits | greatest force [N] | largest displacement [mm] | lost in contacts [J] | ledger residual |\n\
         |---|---|---|---|---|---|\n"
    );
    for o in outcomes {
        let _ = writeln!(
            page,
            "| `{}` | {} | {:.1} | {:.4} | {:.5} | {:.0e} |",
            o.variant.name(),
            o.hits,
            o.greatest,
            o.displacement * 1e3,
            o.lost,
            o.residual
        );
    }
    let spread = |of: fn(&Outcome) -> f64| {
        let [least, most] =
            outcomes.iter().map(of).fold([f64::INFINITY, 0.0], |[a, b]: [f64; 2], x| [a.min(x), b.max(x)]);
        most / least
    };
    let [depth, force, displacement] = [spread(|o| o.depth), spread(|o| o.force), spread(|o| o.displacement)];
    let _ = write!(
        page,
        "\n![Force against penetration of every touch of the ten seconds](laws-run.{extension})\n\n\
         ![Displacement over time](laws-motion.{extension})\n\n\
         All but `hertz`, which has no dashpot, return what is asked for at every speed, `bilinear` at the speed of its design. Of the \
         hit penetration differs by a factor of up to {depth:.1} and force by {force:.1}, the displacement under steady shaking by \
         {displacement:.2}: it is a matter of e'.\n"
    );
    page
}

/// Names and SVG documents.
pub fn pictures(outcomes: &[Outcome]) -> Vec<(&'static str, String)> {
    let loops = |name: &str, of: &dyn Fn(&Outcome) -> &Vec<[f64; 2]>| {
        let panel = |(number, o): (usize, &Outcome)| Panel {
            name: format!("{} [N]", o.variant.name()),
            curves: vec![curve(number, of(o).iter().map(|[depth, force]| [depth * 1e3, *force]).collect())],
        };
        let panels = outcomes.iter().enumerate().map(panel).collect();
        Chart { title: name.to_owned(), x: "penetration [mm]".to_owned(), panels }.to_svg_on_one_scale()
    };
    let motion = |(number, o): (usize, &Outcome)| Panel {
        name: format!("x under {} [mm]", o.variant.name()),
        curves: vec![curve(number, o.motion.iter().map(|[t, x]| [*t, x * 1e3]).collect())],
    };
    let motions = Chart {
        title: "Displacement along x, ten seconds".to_owned(),
        x: "time [s]".to_owned(),
        panels: outcomes.iter().enumerate().map(motion).collect(),
    };
    vec![
        ("laws-hit", loops("Force against penetration, one hit at 0.3 m/s", &|o| &o.hit)),
        ("laws-run", loops("Force against penetration, every touch of ten seconds", &|o| &o.touches)),
        ("laws-motion", motions.to_svg_on_one_scale()),
    ]
}

fn curve(number: usize, points: Vec<[f64; 2]>) -> Curve {
    Curve { name: String::new(), color: COLORS[number % COLORS.len()].to_owned(), dashes: "none", points }
}
