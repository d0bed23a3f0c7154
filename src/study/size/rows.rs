//! Rows of the paper's straight girder, end to end.

use crate::scene::{
    Bearings, ContactSettings, FrictionLaw, Girder, Motion, PerDirection, Scene, SharedBearings, SineMotion,
};

/// Gap between neighbours \[m\].
const GAP: f64 = 0.005;
/// Gap that nobody bridges \[m\].
const FAR: f64 = 0.2;
const LENGTH: f64 = 0.19;

/// A row in which neighbours have different periods and collide all along it.
pub fn colliding(girders: usize) -> Scene {
    row(girders, |_| GAP, |i| 2.4 + 0.7 * ((i % 3) as f64))
}

/// The row with wide gaps everywhere but between three girders in its middle.
pub fn few_touch(girders: usize) -> Scene {
    let middle = girders / 2;
    row(girders, |i| if i + 1 == middle || i == middle { GAP } else { FAR }, |i| 2.4 + 0.7 * ((i % 3) as f64))
}

/// `gap(i)` lies between girders i and i + 1.
fn row(girders: usize, gap: impl Fn(usize) -> f64, frequency: impl Fn(usize) -> f64) -> Scene {
    let mut x = 0.0;
    let girders = (0..girders)
        .map(|i| {
            let girder = girder(i, x, frequency(i));
            x += LENGTH + gap(i);
            girder
        })
        .collect();
    Scene {
        girders,
        contact: ContactSettings {
            stiffness: Some(1.55e5),
            law: FrictionLaw::ReturnMapping,
            ..ContactSettings::default()
        },
        motion: Motion::Sine(SineMotion {
            amplitude_g: None,
            amplitude: Some(3.924),
            frequency_hz: 2.4,
            phase_deg: 0.0,
            angle_deg: 0.0,
            vertical_amplitude_g: None,
            vertical_amplitude: None,
            vertical_phase_deg: None,
        }),
        ..Scene::empty("row", 1.0)
    }
}

fn girder(number: usize, x: f64, frequency: f64) -> Girder {
    Girder {
        position: [x, 0.0, 0.0],
        bearings: Some(Bearings::Shared(SharedBearings {
            frequency_hz: PerDirection::Both(frequency),
            damping_ratio: PerDirection::Both(0.1),
            vertical_frequency_hz: None,
            vertical_damping_ratio: None,
            on_minus_x: None,
            on_plus_x: None,
            at_skewed: Some(vec![[0.07, 0.025], [0.07, -0.025], [-0.07, 0.025], [-0.07, -0.025]]),
            travel: None,
            height: None,
            at: None,
        })),
        ..Girder::straight(format!("g{number}"), [LENGTH, 0.07, 0.02], 2.0)
    }
}
