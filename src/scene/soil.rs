//! Backfill with everything filled in that abutment and girder say.

use super::concrete::CONCRETE_DENSITY;
use super::{Abutment, Backfill, BackfillLaw, Girder, Scene, placed};

/// Height of the wall that the usual numbers of soil are stated for \[m\].
const STATED_HEIGHT: f64 = 1.7;
/// Stiffness per width at that height, Caltrans SDC 1.x, 50 kip/in/ft \[N/m²\]; also K₅₀ of granular soil.
const STIFFNESS: f64 = 28.7e6;
/// Ultimate pressure at that height, Caltrans SDC 1.x, 5 ksf \[Pa\].
const PRESSURE: f64 = 239e3;
/// First slope per width of the hyperbolic law at that height, of an example of `OpenSees` \[N/m²\].
const FIRST_SLOPE: f64 = 20.3e6;
/// Ultimate force per width of that example \[N/m\].
const ULTIMATE: f64 = 326e3;
/// Angle over which the reduction by the skew falls by a factor e (Rollins and Jessee 2013) \[degrees\].
const SKEW_ANGLE: f64 = 45.0;
/// Thickness of a backwall per height, where none is given \[–\].
const SLENDERNESS: f64 = 0.25;
/// Push at which a granular soil fails, per height of the wall \[–\].
pub const FAILING_PUSH: f64 = 0.05;
/// Failure ratio `R_f`.
const FAILURE_RATIO: f64 = 0.7;
/// Friction between the wall and what it stands on.
const BASE_FRICTION: f64 = 0.6;
/// Displacement at which that friction is fully there \[m\].
const BASE_DISPLACEMENT: f64 = 1e-4;

/// Numbers in force of soil and backwall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResolvedBackfill {
    /// Envelope.
    pub law: BackfillLaw,
    /// K \[N/m\].
    pub stiffness: f64,
    /// `F_ult` \[N\].
    pub ultimate: f64,
    /// `R_f` \[–\].
    pub failure_ratio: f64,
    /// `y_max` \[m\].
    pub limit: f64,
    /// `K_ur` \[N/m\].
    pub unloading: f64,
    /// Mass of the wall \[kg\].
    pub mass: f64,
    /// Thickness of a wall of concrete of that mass, height and length along its face \[m\].
    pub thickness: f64,
    /// Force of the base's friction \[N\] and displacement at which it is reached \[m\]; `None` without friction.
    pub base: Option<[f64; 2]>,
    /// Height of the wall \[m\].
    pub height: f64,
    /// Stiffness \[N/m\] and strength \[N\] of the fuse.
    pub fuse: Option<[f64; 2]>,
    /// `exp(−θ_s/45°)` \[–\].
    pub reduction: f64,
}

impl ResolvedBackfill {
    /// Slope of the envelope at no push \[N/m\].
    pub fn first_slope(&self) -> f64 {
        match self.law {
            BackfillLaw::Hyperbolic | BackfillLaw::Bilinear => self.stiffness,
            BackfillLaw::MeanStiffness => 2.0 * self.stiffness - self.ultimate / self.limit,
        }
    }
}

impl Abutment {
    /// The soil behind it with all its numbers, before the girder that it faces; `None` for a backwall that is fixed
    /// or has no face.
    pub fn soil(&self, scene: &Scene) -> Option<ResolvedBackfill> {
        let (backfill, _) = self.backfill.zip(placed::abutment_face(scene, self))?;
        let girder = scene.girders.iter().find(|girder| girder.name == self.faces)?;
        Some(backfill.resolve(scene, self, girder))
    }
}

impl Backfill {
    /// The numbers in force behind an abutment before the end of this girder.
    fn resolve(&self, scene: &Scene, abutment: &Abutment, girder: &Girder) -> ResolvedBackfill {
        let height = self.height.unwrap_or(girder.thickness);
        let share = height / STATED_HEIGHT;
        let reduction = (-(90.0 - girder.skew_deg).abs() / SKEW_ANGLE).exp();
        let (stiffness, ultimate) = match self.law {
            BackfillLaw::Bilinear | BackfillLaw::MeanStiffness => (STIFFNESS * share, PRESSURE * height * share),
            BackfillLaw::Hyperbolic => (FIRST_SLOPE * share, ULTIMATE * share * share),
        };
        let softer = if self.reduces_stiffness { reduction } else { 1.0 };
        let stiffness = self.stiffness.unwrap_or(stiffness * girder.width * softer);
        let face = placed::abutment_face(scene, abutment).map_or(0.0, |[a, b, ..]| (b - a).length());
        // The part of the face that the girder's end covers, and no more of it than there is.
        let length = girder.prism().end_length().min(face);
        let mass = self.mass.unwrap_or(CONCRETE_DENSITY * length * height * height * SLENDERNESS);
        let friction = self.friction.unwrap_or(BASE_FRICTION) * mass * scene.gravity;
        let base = [friction, self.base_displacement.unwrap_or(BASE_DISPLACEMENT)];
        let resolved = ResolvedBackfill {
            law: self.law,
            stiffness,
            ultimate: self.ultimate.unwrap_or(ultimate * girder.width * reduction),
            failure_ratio: self.failure_ratio.unwrap_or(FAILURE_RATIO),
            limit: self.limit.unwrap_or(FAILING_PUSH * height),
            unloading: 0.0,
            mass,
            thickness: mass / (CONCRETE_DENSITY * length * height),
            base: (friction > 0.0).then_some(base),
            height,
            fuse: self.fuse_stiffness.zip(self.fuse_force).map(|(stiffness, force)| [stiffness, force]),
            reduction,
        };
        ResolvedBackfill { unloading: self.unloading.unwrap_or(resolved.first_slope()), ..resolved }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    /// A deck of 30 × 10 m with skew, and a wall of 1.7 m.
    fn resolved(skew_deg: f64, backfill: Backfill) -> ResolvedBackfill {
        let mut scene = presets::load("deck-30m").expect("a preset");
        let girder = &mut scene.girders[0];
        (girder.length, girder.width, girder.skew_deg) = (30.0, 10.0, skew_deg);
        let (scene, abutment) = (scene.clone(), scene.abutments[0].clone());
        Backfill { height: Some(1.7), ..backfill }.resolve(&scene, &abutment, &scene.girders[0])
    }

    #[test]
    fn the_usual_numbers_are_those_of_the_criteria_for_a_wall_of_their_height() {
        let straight = resolved(90.0, Backfill::default());
        assert!((straight.stiffness - 287.0e6).abs() < 1e-6 * 287.0e6, "{straight:?}");
        assert!((straight.ultimate - 4.063e6).abs() < 1e-6 * 4.063e6, "{straight:?}");
        let skewed = resolved(60.0, Backfill { reduces_stiffness: true, ..Backfill::default() });
        assert!((skewed.reduction - 0.5134).abs() < 5e-5, "30° of skew: {}", skewed.reduction);
        assert!((skewed.stiffness / straight.stiffness - skewed.reduction).abs() < 1e-15);
        assert!((skewed.ultimate / straight.ultimate - skewed.reduction).abs() < 1e-15);
        let kept = resolved(60.0, Backfill::default());
        assert_eq!((kept.stiffness, kept.ultimate), (straight.stiffness, skewed.ultimate), "K as it was");
    }

    #[test]
    fn unloading_begins_with_the_first_slope() {
        for law in BackfillLaw::ALL {
            let soil = resolved(60.0, Backfill { law: *law, ..Backfill::default() });
            assert_eq!(soil.unloading, soil.first_slope(), "{law:?}");
            assert!(soil.first_slope() > 0.0 && soil.stiffness * soil.limit > soil.ultimate, "{soil:?}");
        }
    }
}
