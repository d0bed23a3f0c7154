//! Two equal bars head on, one at rest: St. Venant's problem with a contact spring, its force in closed form
//! (`docs/physics.md#flexible-girders`, F11), places of the mass centres as its double integral.

use crate::study::accuracy::line::Line;
use crate::study::accuracy::{Answer, Instants};

/// Nodes and weights of Gauss's rule of order 16 on (0, 1), those of the lower half: the upper half mirrors them.
const GAUSS: [[f64; 2]; 4] = [
    [0.019_855_071_751_231_884, 0.050_614_268_145_188_13],
    [0.101_666_761_293_186_63, 0.111_190_517_226_687_24],
    [0.237_233_795_041_835_5, 0.156_853_322_938_943_64],
    [0.408_282_678_752_175_1, 0.181_341_891_689_181],
];

/// The force between two bars from their touch on.
struct Hit {
    /// a = 2K/Z \[1/s\].
    rate: f64,
    /// F₀ = Z v/2 \[N\].
    force: f64,
    /// T = 2L/c \[s\].
    back: f64,
}

impl Hit {
    /// F, t from the touch; for an end before 2T.
    fn force(&self, t: f64) -> f64 {
        let Self { rate, force, back } = *self;
        if t <= back {
            return force * -(-rate * t).exp_m1();
        }
        let (echo, tau) = ((-rate * back).exp(), rate * (t - back));
        (force * ((2.0 - echo + 2.0 * tau) * (-tau).exp() - 1.0)).max(0.0)
    }

    /// a τ at the end: e^z = 2 − E₀ + 2z.
    fn end(&self) -> f64 {
        let echo = (-self.rate * self.back).exp();
        let mut z = 1.678_f64;
        for _ in 0..60 {
            z = (2.0 - echo + 2.0 * z).ln();
        }
        self.back + z / self.rate
    }

    /// `∫₀ᵗ (t − s) F(s) ds`, on pieces where F is smooth, each a few time constants long.
    fn moved(&self, t: f64) -> f64 {
        let ends = [0.0, self.back, self.end()];
        let mut sum = 0.0;
        for piece in ends.windows(2) {
            let (from, until) = (piece[0], piece[1].min(t));
            if until <= from {
                continue;
            }
            let parts = ((until - from) * self.rate).ceil().max(1.0);
            let width = (until - from) / parts;
            let mut start = from;
            while start < until - 0.5 * width {
                for [x, weight] in GAUSS {
                    for s in [start + x * width, start + (1.0 - x) * width] {
                        sum += weight * width * (t - s) * self.force(s);
                    }
                }
                start += width;
            }
        }
        sum
    }
}

/// The answer of two equal bars without damping.
pub(super) fn answer(line: &Line, instants: Instants) -> Answer {
    let bar = &line.bars[0];
    let (c, speed) = (bar.wave_speed(), bar.speed);
    let impedance = bar.mass * c / bar.length;
    let hit =
        Hit { rate: 2.0 * line.stiffness / impedance, force: 0.5 * impedance * speed, back: 2.0 * bar.length / c };
    let touch = line.gap / speed;
    let places = instants.all().flat_map(|t| {
        let moved = hit.moved((t - touch).max(0.0)) / bar.mass;
        [[speed * t - moved, 0.0, 0.0, 0.0], [moved, 0.0, 0.0, 0.0]]
    });
    let peak_force = hit.force(hit.back) / line.nodes;
    Answer { places: places.collect(), bodies: 2, peak_force, ..Answer::default() }
}
