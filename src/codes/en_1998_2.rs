//! EN 1998-2, 6.6.4: minimum overlap length of a support.

use super::demand::{Case, Code, Demand, Input};
use crate::language::Text;
use crate::scene::{EuropeanGround, STANDARD_GRAVITY};

/// The code.
pub(super) struct En1998Part2;

/// Parameters of a ground type.
pub(super) struct Ground {
    /// Soil factor, type 1 spectrum.
    pub(super) soil: f64,
    /// `T_C` and `T_D` \[s\].
    pub(super) periods: [f64; 2],
    /// Distance beyond which ground motions are uncorrelated, `L_g` \[m\].
    pub(super) distance: f64,
}

impl Ground {
    pub(super) const fn of(ground: EuropeanGround) -> Self {
        let (soil, corner, distance) = match ground {
            EuropeanGround::A => (1.0, 0.4, 600.0),
            EuropeanGround::B => (1.2, 0.5, 500.0),
            EuropeanGround::C => (1.15, 0.6, 400.0),
            EuropeanGround::D => (1.35, 0.8, 300.0),
            EuropeanGround::E => (1.4, 0.5, 500.0),
        };
        Self { soil, periods: [corner, 2.0], distance }
    }
}

/// Design ground displacement `d_g` = 0.025 `a_g` S `T_C` `T_D`, `a_g` \[m/s²\], to \[m\].
pub(super) fn ground_displacement(acceleration: f64, soil: f64, [corner, displacement]: [f64; 2]) -> f64 {
    0.025 * acceleration * soil * corner * displacement
}

/// Displacement of two points of the ground apart: `d_eg` = 2 `d_g` `L_eff`/`L_g`, at most 2 `d_g` \[m\].
pub(super) fn apart(ground: f64, effective_length: f64, distance: f64) -> f64 {
    (2.0 * ground / distance * effective_length).min(2.0 * ground)
}

/// `a_g` that is assumed \[g\].
pub(super) const ACCELERATION_G: f64 = 0.25;
/// The least length of support \[m\].
pub(super) const LEAST_SUPPORT: f64 = 0.4;

impl Code for En1998Part2 {
    fn demands(&self, case: &Case<'_>) -> Vec<Demand> {
        let codes = case.codes;
        let ground = Ground::of(codes.european_ground.unwrap_or_default());
        let length = case.deck_length("L_eff");
        let acceleration = Input::given_or("a_g", "g", codes.ground_acceleration_g, ACCELERATION_G);
        // The ground type gives S, T_C, T_D and L_g where the scene does not give each by itself.
        let by_type = |value: f64| codes.european_ground.map(|_| value);
        let soil = Input::given_or("S", "", codes.soil_factor.or(by_type(ground.soil)), ground.soil);
        let [own_corner, own_displacement] = ground.periods;
        let corner = Input::given_or("T_C", "s", codes.corner_period.or(by_type(own_corner)), own_corner);
        let displacement =
            Input::given_or("T_D", "s", codes.displacement_period.or(by_type(own_displacement)), own_displacement);
        let distance = Input::given_or("L_g", "m", by_type(ground.distance), ground.distance);
        let support = Input::given_or("l_m", "m", codes.bearing_length, LEAST_SUPPORT);
        let long_term = Input::given_or("d_G", "m", codes.long_term, 0.0);
        let temperature = Input::given_or("d_T", "m", codes.temperature, 0.0);
        let seismic = Input::of_run("d_E", "m", case.seat.used().max(0.0));
        let d_g =
            ground_displacement(STANDARD_GRAVITY * acceleration.value, soil.value, [corner.value, displacement.value]);
        let d_es = seismic.value + long_term.value + 0.5 * temperature.value;
        vec![Demand {
            rule: Text::new("code-en-1998-2"),
            edition: Text::new("code-edition-en-1998-2"),
            formula: "l_ov = max(l_m, 0.4 m) + d_eg + d_es; d_eg = 2 d_g L_eff/L_g ≤ 2 d_g, d_g = 0.025 a_g S T_C T_D; d_es = d_E + d_G + d_T/2",
            confirmed: false,
            note: Text::new("code-note-en-1998-2"),
            inputs: vec![
                length,
                acceleration,
                soil,
                corner,
                displacement,
                distance,
                support,
                long_term,
                temperature,
                seismic,
            ],
            required: support.value.max(LEAST_SUPPORT) + apart(d_g, length.value, distance.value) + d_es,
            provided: case.seat.ledge.placed(),
            used: case.seat.used(),
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_of_g_is_the_worked_example_s() {
        for (ground, d_g, overlap) in [(EuropeanGround::A, 0.049, 0.405), (EuropeanGround::C, 0.0846, 0.413)] {
            let of = Ground::of(ground);
            let displacement = ground_displacement(0.25 * STANDARD_GRAVITY, of.soil, of.periods);
            assert!((displacement - d_g).abs() < 5e-5, "{ground:?}: {displacement} m, not {d_g}");
            let length = LEAST_SUPPORT + apart(displacement, 30.0, of.distance);
            assert!((length - overlap).abs() < 5e-4, "{ground:?}: {length} m, not {overlap}");
        }
        assert!((apart(0.05, 1e4, 400.0) - 0.1).abs() < 1e-15, "at most 2 d_g");
    }
}
