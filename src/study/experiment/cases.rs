//! The cases of the paper's Table 2: a model girder of Table 3, an excitation angle and a motion of the shaking table.

use super::earthquake::Earthquake;
use crate::scene::{Motion, Scene, SceneErrors, SineMotion, presets};

/// Numbers of the model girders that the study needs beside their scenes; a test holds them against the presets.
pub(super) mod girder {
    /// Half the length of every girder \[m\].
    pub(in crate::study::experiment) const HALF_LENGTH: f64 = 0.095;
    /// Half the width of every girder \[m\].
    pub(in crate::study::experiment) const HALF_WIDTH: f64 = 0.035;
    /// Gap, assumed \[m\].
    pub(in crate::study::experiment) const GAP: f64 = 0.003;
    /// Distance of the legs from the middle along and across, assumed \[m\].
    pub(in crate::study::experiment) const LEGS: [f64; 2] = [0.07, 0.025];
    /// \[kg\]
    pub(in crate::study::experiment) const MASS: f64 = 2.0;
    /// K (69a) \[N/m\].
    pub(in crate::study::experiment) const STIFFNESS: f64 = 1.55e5;
    /// `e_n`.
    pub(in crate::study::experiment) const RESTITUTION: f64 = 0.4;
    /// `e_t` of the impact model.
    pub(in crate::study::experiment) const TANGENTIAL: f64 = -0.9;
    /// `μ_s` and `μ_k`.
    pub(in crate::study::experiment) const FRICTION: [f64; 2] = [0.2, 0.15];
}

/// A model girder of Table 3 with what it hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Specimen {
    /// Straight girder 1 against an abutment.
    Straight,
    /// Skewed girder 1, β = 60°, against an abutment.
    Skew60,
    /// Skewed girder 2, β = 45°, against an abutment.
    Skew45,
    /// Straight girders 1 and 2 against each other.
    Pair,
}

impl Specimen {
    /// In the order of Table 2.
    pub const ALL: [Self; 4] = [Self::Straight, Self::Skew60, Self::Skew45, Self::Pair];

    /// First part of the names of its cases.
    pub fn key(self) -> &'static str {
        match self {
            Self::Straight => "straight",
            Self::Skew60 => "skew60",
            Self::Skew45 => "skew45",
            Self::Pair => "pair",
        }
    }

    /// In words.
    pub fn label(self) -> &'static str {
        match self {
            Self::Straight => "straight girder and abutment",
            Self::Skew60 => "60° girder and abutment",
            Self::Skew45 => "45° girder and abutment",
            Self::Pair => "two straight girders",
        }
    }

    /// The preset that holds its numbers.
    fn preset(self) -> &'static str {
        match self {
            Self::Straight => "straight-abutment",
            Self::Skew60 => "skew60-abutment",
            Self::Skew45 => "skew45-abutment",
            Self::Pair => "straight-straight",
        }
    }

    /// Excitation angles of Table 2 \[degrees\].
    pub fn angles(self) -> &'static [f64] {
        match self {
            Self::Straight => &[0.0, 22.5, 45.0, 67.5],
            Self::Skew60 | Self::Skew45 => &[-60.0, -45.0, -30.0, -15.0, 0.0, 15.0, 30.0, 45.0, 60.0],
            Self::Pair => &[22.5],
        }
    }

    /// Motions of Table 2: the pair was not shaken by the earthquake.
    pub fn shakings(self) -> &'static [Shaking] {
        if self == Self::Pair { &Shaking::ALL[..2] } else { &Shaking::ALL }
    }

    /// Frequency of its sine (Table 2) \[Hz\].
    pub fn sine_hz(self) -> f64 {
        if matches!(self, Self::Straight | Self::Pair) { 2.4 } else { 2.6 }
    }
}

/// A motion of the shaking table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shaking {
    /// Sine of 0.23 g.
    Small,
    /// Sine of 0.40 g.
    Large,
    /// The earthquake.
    Record,
}

impl Shaking {
    /// In the order of Table 2.
    pub const ALL: [Self; 3] = [Self::Small, Self::Large, Self::Record];

    /// Last part of the names of its cases.
    pub fn key(self) -> &'static str {
        match self {
            Self::Small => "0.23g",
            Self::Large => "0.40g",
            Self::Record => "record",
        }
    }

    /// Amplitude of the sine \[g\].
    fn amplitude_g(self) -> Option<f64> {
        match self {
            Self::Small => Some(0.23),
            Self::Large => Some(0.40),
            Self::Record => None,
        }
    }
}

/// A case of Table 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// Bodies that collide.
    pub specimen: Specimen,
    /// Excitation angle \[degrees\].
    pub angle_deg: f64,
    /// Motion of the table.
    pub shaking: Shaking,
}

impl Case {
    /// Of these three.
    pub fn new(specimen: Specimen, angle_deg: f64, shaking: Shaking) -> Self {
        Self { specimen, angle_deg, shaking }
    }

    /// Every case of Table 2.
    pub fn all() -> Vec<Self> {
        let of_angle = |specimen: Specimen, angle: f64| {
            specimen.shakings().iter().map(move |&shaking| Self::new(specimen, angle, shaking))
        };
        let of_specimen = |specimen: Specimen| specimen.angles().iter().flat_map(move |&a| of_angle(specimen, a));
        Specimen::ALL.into_iter().flat_map(of_specimen).collect()
    }

    /// `skew60_-15_0.40g`.
    pub fn name(&self) -> String {
        format!("{}_{}_{}", self.specimen.key(), self.angle_deg, self.shaking.key())
    }

    /// `60° girder and abutment, −15°, 0.40 g at 2.6 Hz`.
    pub fn label(&self) -> String {
        let motion = match self.shaking.amplitude_g() {
            Some(g) => format!("{g:.2} g at {} Hz", self.specimen.sine_hz()),
            None => "record".to_owned(),
        };
        format!("{}, {}°, {motion}", self.specimen.label(), self.angle_deg).replace('-', "−")
    }

    /// Its scene: numbers of Table 3, what the paper leaves open as in the presets.
    ///
    /// # Errors
    /// None: the presets are part of the program.
    pub fn scene(&self, earthquake: &Earthquake) -> Result<Scene, SceneErrors> {
        let mut scene = presets::load(self.specimen.preset())?;
        scene.name = self.name();
        let Some(amplitude) = self.shaking.amplitude_g() else {
            (scene.motion, scene.duration) = (earthquake.motion(self.angle_deg), earthquake.duration());
            return Ok(scene);
        };
        scene.motion = Motion::Sine(SineMotion {
            amplitude_g: Some(amplitude),
            amplitude: None,
            frequency_hz: self.specimen.sine_hz(),
            phase_deg: 0.0,
            angle_deg: self.angle_deg,
            vertical_amplitude_g: None,
            vertical_amplitude: None,
            vertical_phase_deg: None,
        });
        Ok(scene)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Bearings;
    use std::collections::BTreeSet;

    #[test]
    fn table_2_has_sixty_eight_cases_of_different_names() {
        let all = Case::all();
        let names: BTreeSet<String> = all.iter().map(Case::name).collect();
        // 4 angles and 9 and 9, three motions each; the pair at one angle by two.
        assert_eq!([all.len(), names.len()], [3 * (4 + 9 + 9) + 2; 2], "all of them");
        assert!(names.contains("skew60_-15_0.40g") && names.contains("straight_22.5_record"), "as they are called");
    }

    #[test]
    fn the_numbers_are_those_of_the_presets() {
        for specimen in Specimen::ALL {
            let scene = presets::load(specimen.preset()).expect("a preset");
            for own in &scene.girders {
                assert_eq!(
                    [own.length, own.width, own.mass],
                    [2.0 * girder::HALF_LENGTH, 2.0 * girder::HALF_WIDTH, girder::MASS]
                );
                let Some(Bearings::Shared(shared)) = &own.bearings else { panic!("{specimen:?}: equal legs") };
                let places = shared.at_skewed.as_ref().expect("places before skewing");
                assert!(places.iter().all(|place| place.map(f64::abs) == girder::LEGS), "{specimen:?}: {places:?}");
            }
            assert!(scene.abutments.iter().all(|abutment| abutment.gap == Some(girder::GAP)), "{specimen:?}");
            let (contact, impact) = (&scene.contact, &scene.impact);
            assert_eq!(contact.stiffness, Some(girder::STIFFNESS), "{specimen:?}");
            assert_eq!(
                [contact.restitution_normal, impact.restitution_normal],
                [girder::RESTITUTION; 2],
                "{specimen:?}"
            );
            assert_eq!(impact.restitution_tangential, girder::TANGENTIAL, "{specimen:?}");
            assert_eq!([contact.mu_static, contact.mu_kinetic], girder::FRICTION, "{specimen:?}");
            assert_eq!([impact.mu_static, impact.mu_kinetic], girder::FRICTION, "{specimen:?}");
        }
    }

    #[test]
    fn the_frequencies_are_those_of_the_presets() {
        for specimen in Specimen::ALL {
            let Motion::Sine(sine) = presets::load(specimen.preset()).expect("a preset").motion else {
                panic!("a sine");
            };
            assert_eq!(sine.frequency_hz, specimen.sine_hz(), "{specimen:?}");
        }
    }
}
