//! A ground motion as figures, tables and charts: acceleration, velocity, displacement, 5 % response spectrum.

use std::fmt::Write as _;

pub use crate::motion::Ground as Shaker;

use crate::language::Text;
use crate::motion::format::Channel;
use crate::motion::integrate::{Peak, StrongMotion, integrate, peaks};
use crate::motion::spectrum::{DESIGN_DAMPING, Response, periods, response, spectrum};
use crate::motion::{Ground as Motion, Samples};
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};

/// Shortest and longest period of the spectrum \[s\].
const PERIODS: [f64; 2] = [0.02, 10.0];
/// Periods of the spectrum, evenly spaced by their logarithm: 150 a decade.
const COUNT: u32 = 406;
/// Longest period of the spectrum's chart \[s\].
const DRAWN: f64 = 4.0;
/// Pieces of a drawn history; of each the least and the largest sample are drawn, which is finer than the picture.
const PIECES: usize = 2000;

/// A channel with what follows from it.
#[derive(Clone, Debug)]
pub struct Ground<'a> {
    channel: &'a Channel,
    velocity: Vec<f64>,
    displacement: Vec<f64>,
}

/// Figures of a ground motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// Largest acceleration \[m/s²\].
    pub acceleration: Peak,
    /// Largest velocity, PGV \[m/s\].
    pub velocity: Peak,
    /// Largest displacement, PGD \[m\].
    pub displacement: Peak,
    /// Strong motion.
    pub strong: StrongMotion,
}

impl<'a> Ground<'a> {
    /// Integrates a channel from rest.
    pub fn of(channel: &'a Channel) -> Self {
        let [velocity, displacement] = integrate(&channel.samples, channel.dt);
        Self { channel, velocity, displacement }
    }

    /// Peaks and duration.
    pub fn figures(&self) -> Figures {
        let (a, dt) = (&self.channel.samples, self.channel.dt);
        let [velocity, displacement] = peaks(a, [&self.velocity, &self.displacement], dt);
        Figures { acceleration: Peak::of(a, dt), velocity, displacement, strong: StrongMotion::of(a, dt) }
    }

    /// The spectrum at 5 % of critical damping.
    pub fn spectrum(&self) -> Vec<Response> {
        spectrum(&self.channel.samples, self.channel.dt, &periods(PERIODS, COUNT), DESIGN_DAMPING)
    }

    /// Every sample: `t_s,a_m_s2,v_m_s,d_m`.
    pub fn csv(&self) -> String {
        let mut table = "t_s,a_m_s2,v_m_s,d_m\n".to_owned();
        for (n, a) in self.channel.samples.iter().enumerate() {
            let (v, d) = (self.velocity[n], self.displacement[n]);
            let _ = writeln!(table, "{},{a},{v},{d}", n as f64 * self.channel.dt);
        }
        table
    }

    /// The three histories over time as an SVG document.
    pub fn histories(&self, title: &str) -> String {
        Chart { title: title.to_owned(), x: "time [s]".to_owned(), panels: self.history_panels() }.to_svg()
    }

    /// Acceleration, velocity and displacement over time.
    pub fn history_panels(&self) -> Vec<Panel> {
        let panel = |(name, unit): (Text, &str), color: usize, values: &[f64]| Panel {
            name: format!("{name} [{unit}]"),
            curves: vec![curve("ground", color, thinned(values, self.channel.dt))],
        };
        vec![
            panel((Text::new("motion-acceleration"), "m/s²"), 0, &self.channel.samples),
            panel((Text::new("motion-velocity"), "m/s"), 1, &self.velocity),
            panel((Text::new("motion-displacement"), "m"), 2, &self.displacement),
        ]
    }
}

/// Pseudo-acceleration at one period \[s\] and 5 % of critical damping, of samples at an interval \[s\] \[m/s²\].
pub fn psa(samples: &[f64], dt: f64, period: f64) -> f64 {
    response(samples, dt, period, DESIGN_DAMPING).pseudo_acceleration()
}

/// The table of a spectrum: `period_s,sd_m,psv_m_s,psa_m_s2`.
pub fn spectrum_csv(spectrum: &[Response]) -> String {
    let mut table = "period_s,sd_m,psv_m_s,psa_m_s2\n".to_owned();
    for r in spectrum {
        let _ = writeln!(table, "{},{},{},{}", r.period, r.displacement, r.pseudo_velocity(), r.pseudo_acceleration());
    }
    table
}

/// A spectrum as an SVG document.
pub fn spectrum_chart(spectrum: &[Response], title: &str) -> String {
    Chart { title: title.to_owned(), x: "natural period [s]".to_owned(), panels: spectrum_panels(spectrum) }.to_svg()
}

/// Pseudo-acceleration, pseudo-velocity and displacement over the period.
fn spectrum_panels(spectrum: &[Response]) -> Vec<Panel> {
    let drawn = || spectrum.iter().filter(|r| r.period <= DRAWN);
    let panel = |(name, unit): (Text, &str), color: usize, value: fn(&Response) -> f64| Panel {
        name: format!("{name} [{unit}]"),
        curves: vec![curve("5 % damping", color, drawn().map(|r| [r.period, value(r)]).collect())],
    };
    vec![
        panel((Text::new("motion-pseudo-acceleration"), "m/s²"), 0, Response::pseudo_acceleration),
        panel((Text::new("motion-pseudo-velocity"), "m/s"), 1, Response::pseudo_velocity),
        panel((Text::new("motion-displacement"), "m"), 2, |r| r.displacement),
    ]
}

/// A component of the ground motion of a run, as it is drawn.
#[derive(Clone, Debug)]
pub struct Component {
    /// `along`, or the world's axis.
    pub name: Text,
    /// Peaks and duration.
    pub figures: Figures,
    /// Acceleration, velocity, displacement over time.
    pub histories: Vec<Panel>,
    /// The spectrum at 5 % of critical damping over the period.
    pub spectrum: Vec<Panel>,
}

impl Component {
    fn of(name: Text, dt: f64, samples: Vec<f64>) -> Self {
        let channel = Channel::plain(dt, samples);
        let ground = Ground::of(&channel);
        let (figures, histories) = (ground.figures(), ground.history_panels());
        Self { name, figures, histories, spectrum: spectrum_panels(&ground.spectrum()) }
    }
}

/// Every component of a ground motion that is not still, up to `end` \[s\]: a record by its own samples as they shake, all of them;
/// anything else by samples a two-hundredth of its period apart.
pub fn components(ground: &Motion, end: f64) -> Vec<Component> {
    match ground {
        Motion::Record { dt, samples: Samples::Along { values, .. }, .. } => {
            vec![Component::of(Text::new("motion-along-angle"), *dt, values.to_vec())]
        }
        Motion::Record { dt, samples: Samples::Components { values, .. }, .. } => {
            axes(*dt, |axis| values.iter().map(|a| a[axis]).collect())
        }
        Motion::Still => Vec::new(),
        Motion::Sine { omega, .. } => {
            let (least, most) = (end / MOST_SAMPLES, end / LEAST_SAMPLES);
            let dt = (std::f64::consts::TAU / omega.abs().max(f64::MIN_POSITIVE) / PER_PERIOD).clamp(least, most);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 40 000")]
            let count = (end / dt).floor() as u32;
            axes(dt, |axis| (0..=count).map(|n| ground.acceleration(f64::from(n) * dt)[axis]).collect())
        }
    }
}

/// Samples a period of a sine, and how many there are in all at the least and at the most.
const PER_PERIOD: f64 = 200.0;
const LEAST_SAMPLES: f64 = 1000.0;
const MOST_SAMPLES: f64 = 40_000.0;

/// The world's axes along which anything moves.
fn axes(dt: f64, samples: impl Fn(usize) -> Vec<f64>) -> Vec<Component> {
    let named =
        [Text::new("motion-along-x"), Text::new("motion-along-y"), Text::new("motion-upwards")].into_iter().enumerate();
    let all = named.map(|(axis, name)| (name, samples(axis)));
    let moving = all.filter(|(_, samples)| samples.len() > 1 && samples.iter().any(|a| *a != 0.0));
    moving.map(|(name, samples)| Component::of(name, dt, samples)).collect()
}

fn curve(name: &str, color: usize, points: Vec<[f64; 2]>) -> Curve {
    Curve { name: name.to_owned(), color: COLORS[color].to_owned(), dashes: "none", points }
}

/// Points to draw: all of them, or of each piece the least and the largest in their order.
fn thinned(values: &[f64], dt: f64) -> Vec<[f64; 2]> {
    let point = |n: usize| [n as f64 * dt, values[n]];
    if values.len() <= 2 * PIECES {
        return (0..values.len()).map(point).collect();
    }
    let size = values.len().div_ceil(PIECES);
    let both = |first: usize| {
        let piece = first..(first + size).min(values.len());
        let by_value = |a: &usize, b: &usize| values[*a].total_cmp(&values[*b]);
        let low = piece.clone().min_by(by_value).unwrap_or(first);
        let high = piece.max_by(by_value).unwrap_or(first);
        [low.min(high), low.max(high)].map(point)
    };
    (0..values.len()).step_by(size).flat_map(both).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_history_is_drawn_with_its_extremes() {
        let mut values = vec![0.0; 1_000_000];
        (values[123_456], values[777_777]) = (5.0, -7.0);
        let points = thinned(&values, 0.01);
        assert!(points.len() <= 2 * PIECES, "{} points", points.len());
        assert!(points.contains(&[123_456.0 * 0.01, 5.0]) && points.contains(&[777_777.0 * 0.01, -7.0]), "both");
        assert!(points.is_sorted_by(|a, b| a[0] <= b[0]), "in their order");
    }

    #[test]
    fn tables_have_a_row_for_every_sample_and_period() {
        let channel = Channel::plain(0.1, vec![0.0, 1.0, -1.0, 0.0]);
        let ground = Ground::of(&channel);
        assert_eq!(ground.csv().lines().count(), 5, "heading and four samples");
        let spectrum = ground.spectrum();
        assert_eq!(spectrum_csv(&spectrum).lines().count(), 407, "heading and 406 periods");
        for svg in [ground.histories("a < b"), spectrum_chart(&spectrum, "a < b")] {
            assert!(svg.ends_with("</svg>\n") && svg.contains("a &lt; b") && !svg.contains("NaN"), "{svg}");
        }
    }
}
