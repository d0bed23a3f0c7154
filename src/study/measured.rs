//! Motion measured from pictures, and its difference from a run: histories, errors in pixels and millimetres, charts.

use std::fmt::Write as _;

use crate::measure::Pose;
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::plot::paper::BEHIND;

/// A body of a film.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Its name.
    pub body: String,
    /// A pose a picture.
    pub poses: Vec<Pose>,
}

/// A film of marks, measured.
#[derive(Clone, Debug)]
pub struct Film {
    /// Time of each picture \[s\].
    pub times: Vec<f64>,
    /// Length of a pixel \[mm\].
    pub mm_per_pixel: f64,
    /// Its bodies.
    pub bodies: Vec<Measured>,
}

/// Differences of one quantity between measurement and run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// Root of their mean square.
    pub rms: f64,
    /// The largest magnitude …
    pub largest: f64,
    /// … and when \[s\].
    pub at: f64,
}

/// Differences of a body's motion from a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Differences {
    /// Along x and y \[mm\].
    pub place: [Difference; 2],
    /// In rotation \[degrees\]; none of a body with one mark.
    pub rotation: Option<Difference>,
}

impl Difference {
    fn of(times: &[f64], differences: impl Iterator<Item = f64>) -> Self {
        let (mut sum, mut all) = (0.0, Self::default());
        for (t, d) in times.iter().zip(differences) {
            sum += d * d;
            if d.abs() > all.largest {
                (all.largest, all.at) = (d.abs(), *t);
            }
        }
        Self { rms: (sum / times.len().max(1) as f64).sqrt(), ..all }
    }
}

/// A measured body against x, y \[m\] and θ \[rad\] of a run at the same times, both since the first picture.
pub fn differences(times: &[f64], poses: &[Pose], run: &[[f64; 3]]) -> Differences {
    let first = run.first().copied().unwrap_or_default();
    let pairs = || poses.iter().zip(run);
    let along = |axis: usize| {
        let of = move |(pose, run): (&Pose, &[f64; 3])| pose.displacement[axis] - 1e3 * (run[axis] - first[axis]);
        Difference::of(times, pairs().map(of))
    };
    let turned = poses.first().is_some_and(|pose| pose.rotation.is_some()).then(|| {
        let of = |(pose, run): (&Pose, &[f64; 3])| pose.rotation.unwrap_or_default() - (run[2] - first[2]);
        Difference::of(times, pairs().map(of).map(f64::to_degrees))
    });
    Differences { place: [0, 1].map(along), rotation: turned }
}

impl Film {
    /// `t_s`, then per body `NAME.x_mm,NAME.y_mm,NAME.theta_deg`; θ is empty of a body with one mark.
    pub fn csv(&self) -> String {
        let mut table = "t_s".to_owned();
        for Measured { body, .. } in &self.bodies {
            let name = body.replace([',', '"', '\n'], "_");
            let _ = write!(table, ",{name}.x_mm,{name}.y_mm,{name}.theta_deg");
        }
        table.push('\n');
        for (n, t) in self.times.iter().enumerate() {
            let _ = write!(table, "{t}");
            for Measured { poses, .. } in &self.bodies {
                let Pose { displacement: [x, y], rotation } = poses[n];
                let rotation = rotation.map_or(String::new(), |angle| angle.to_degrees().to_string());
                let _ = write!(table, ",{x},{y},{rotation}");
            }
            table.push('\n');
        }
        table
    }

    /// x, y and θ of a body over time as an SVG document; beside a run, and how far from it in pixels, where there is one.
    pub fn chart(&self, number: usize, run: Option<&[[f64; 3]]>, title: &str) -> String {
        let poses = &self.bodies[number].poses;
        let measured = |pose: &Pose| {
            let [x, y] = pose.displacement;
            [x, y, pose.rotation.unwrap_or(f64::NAN).to_degrees()]
        };
        let measured: Vec<[f64; 3]> = poses.iter().map(measured).collect();
        let run = run.unwrap_or_default();
        let first = run.first().copied().unwrap_or_default();
        let since =
            |run: &[f64; 3]| [1e3 * (run[0] - first[0]), 1e3 * (run[1] - first[1]), (run[2] - first[2]).to_degrees()];
        let computed: Vec<[f64; 3]> = run.iter().map(since).collect();
        let of_axis = |all: &[[f64; 3]], axis: usize| -> Vec<[f64; 2]> {
            self.times.iter().zip(all).map(|(t, values)| [*t, values[axis]]).collect()
        };
        let panel = |(axis, name): (usize, &str)| {
            let dashes = if run.is_empty() { "none" } else { "7 4" };
            let computed = curve("computed", (BEHIND, "none"), of_axis(&computed, axis));
            let measured = curve("measured", (COLORS[axis], dashes), of_axis(&measured, axis));
            let curves = if run.is_empty() { vec![measured] } else { vec![computed, measured] };
            Panel { name: name.to_owned(), curves }
        };
        let mut panels: Vec<Panel> = ["x [mm]", "y [mm]", "θ [degrees]"].into_iter().enumerate().map(panel).collect();
        if !run.is_empty() {
            let off = |axis: usize| {
                let pairs = self.times.iter().zip(&measured).zip(&computed);
                pairs.map(|((t, m), c)| [*t, (m[axis] - c[axis]) / self.mm_per_pixel]).collect()
            };
            let curves = [(0, "of x"), (1, "of y")].map(|(axis, name)| curve(name, (COLORS[axis], "none"), off(axis)));
            panels.push(Panel { name: "measured − computed [pixels]".to_owned(), curves: curves.to_vec() });
        }
        Chart { title: title.to_owned(), x: "time [s]".to_owned(), panels }.to_svg()
    }
}

fn curve(name: &str, (color, dashes): (&str, &'static str), points: Vec<[f64; 2]>) -> Curve {
    Curve { name: name.to_owned(), color: color.to_owned(), dashes, points }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_those_since_the_first_picture() {
        let pose = |x: f64, turned: f64| Pose { displacement: [x, 0.0], rotation: Some(turned) };
        let poses = [pose(0.0, 0.0), pose(1.0, 0.1), pose(-2.0, 0.0)];
        let run = [[0.005, 0.0, 0.2], [0.006, 0.003, 0.3], [0.003, 0.0, 0.2]];
        let found = differences(&[0.0, 0.1, 0.2], &poses, &run);
        assert!(found.place[0].rms < 1e-12, "{found:?}");
        assert!((found.place[1].largest - 3.0).abs() < 1e-12 && found.place[1].at == 0.1, "{found:?}");
        assert!((found.place[1].rms - 3f64.sqrt()).abs() < 1e-12 && found.rotation.expect("turned").rms < 1e-12, "rms");
    }
}
