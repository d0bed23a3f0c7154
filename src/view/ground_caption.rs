//! The caption of the ground motion: its kind, and every component with its size and direction.

use super::scale;
use crate::language::{Text, values};
use crate::scene::{Component, Heading, Motion, RecordMotion, STANDARD_GRAVITY, Scene};

/// Caption of the ground motion, in a line: every component with its direction, the wave, the grounds of single supports.
pub(super) fn ground_caption(scene: &Scene) -> String {
    let caption = motion_caption(&scene.motion);
    let caption = match &scene.wave {
        Some(wave) if scene.motion != Motion::None => {
            let (speed, direction) = (scale::plain(wave.speed), degrees(wave.angle_deg));
            Text::new("ground-wave").with(&values!["ground" => caption, "speed" => speed, "direction" => direction])
        }
        _ => caption,
    };
    let named = scene.grounds.iter().map(|ground| &ground.name).filter(|name| scene.stands_on_ground(name));
    let named: Vec<String> = named.map(|name| format!("\u{201c}{name}\u{201d}")).collect();
    if named.is_empty() {
        return caption;
    }
    Text::new("ground-own").with(&values!["ground" => caption, "names" => named.join(", ")])
}

fn motion_caption(motion: &Motion) -> String {
    let plain = scale::plain;
    let (kind, parts) = match motion {
        Motion::None => return Text::new("ground-none").into(),
        Motion::Sine(s) => {
            let short = |a: f64| if a < 1e4 { format!("{a:.2}") } else { plain(a) };
            let (level, up) = (short(s.amplitude_si() / STANDARD_GRAVITY), s.vertical_si() / STANDARD_GRAVITY);
            let (frequency, direction) = (plain(s.frequency_hz), degrees(s.angle_deg));
            let values = values!["level" => level, "frequency" => frequency, "direction" => direction];
            let level = Text::new("ground-sine-level").with(&values);
            let up = (up != 0.0).then(|| format!("{} g {UPWARDS}", short(up)));
            (Text::new("ground-sine"), std::iter::once(level).chain(up).collect())
        }
        Motion::Synthetic(s) => {
            // The spectrum that is matched replaces the peak.
            let size = |factor: f64| match s.target {
                Some(_) => format!("× {}", plain(factor)),
                None if factor == 1.0 => format!("{} g", plain(s.peak_g)),
                None => format!("{} g", plain(three_digits(s.peak_g * factor))),
            };
            let directions = [degrees(s.angle_deg), degrees(s.angle_deg + 90.0), UPWARDS.into()];
            let parts = s.factors().into_iter().zip(directions).filter(|(factor, _)| *factor != 0.0);
            let kind = Text::new(if s.target.is_some() { "ground-matched" } else { "ground-synthetic" });
            (kind, parts.map(|(factor, direction)| format!("{} {direction}", size(factor))).collect())
        }
        Motion::Record(r) => (Text::new("ground-record"), record_parts(r)),
        Motion::Sweep(s) => {
            let [amplitude, from, to] = [s.amplitude_g, s.from_hz, s.to_hz].map(plain);
            let direction = degrees(s.angle_deg);
            let values = values!["level" => amplitude, "from" => from, "to" => to, "direction" => direction];
            (Text::new("ground-sweep"), vec![Text::new("ground-sweep-level").with(&values)])
        }
    };
    Text::new("ground-of").with(&values!["motion" => kind.with(&values!["parts" => listed(parts)])])
}

const UPWARDS: Text = Text::new("ground-upwards");
/// At most this many components are named in the caption.
const MOST_COMPONENTS: usize = 3;

/// Components of a record, each with its scale and direction.
fn record_parts(record: &RecordMotion) -> Vec<String> {
    let part = |factor: f64, direction: &str| format!("× {} {direction}", scale::plain(factor));
    if record.components.is_empty() {
        let up = (record.vertical_scale != 0.0).then(|| part(record.vertical_scale, &UPWARDS));
        return std::iter::once(part(record.scale, &degrees(record.angle_deg))).chain(up).collect();
    }
    let component = |(n, own): (usize, &Component)| match record.heading(n) {
        Some(Heading::Up) => part(record.scale * own.scale, &UPWARDS),
        Some(Heading::InPlan(angle)) => part(record.scale * own.scale, &degrees(angle)),
        None => part(record.scale * own.scale, &Text::new("ground-unknown")),
    };
    record.components.iter().enumerate().map(component).collect()
}

/// A product, rounded to three significant digits.
fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

/// A direction in plan, from world x, between −180° and 180°: `at 22.5°`.
fn degrees(angle: f64) -> String {
    let turned = angle.rem_euclid(360.0);
    let turned = if (-180.0..=180.0).contains(&angle) || !turned.is_finite() {
        angle
    } else if turned > 180.0 {
        turned - 360.0
    } else {
        turned
    };
    Text::new("ground-at").with(&values!["angle" => scale::plain(turned)])
}

/// Parts in a line, the first few of many.
fn listed(mut parts: Vec<String>) -> String {
    let more = parts.len().saturating_sub(MOST_COMPONENTS);
    parts.truncate(MOST_COMPONENTS);
    if more > 0 {
        parts.push(Text::new("ground-more").with(&values!["count" => more]));
    }
    parts.join(" + ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{NamedGround, SineMotion, SyntheticMotion};

    #[test]
    fn every_component_is_named_with_its_direction() {
        let plain = SyntheticMotion { peak_g: 0.411, angle_deg: 120.0, ..SyntheticMotion::default() };
        let across = SyntheticMotion { across: 0.5, vertical: 0.25, ..plain.clone() };
        let matched = SyntheticMotion { target: Some(vec![[0.1, 0.5], [1.0, 0.2]]), ..across.clone() };
        assert_eq!(motion_caption(&Motion::Synthetic(plain)), "ground: synthetic, 0.411 g at 120°");
        let three = "ground: synthetic, 0.411 g at 120° + 0.205 g at -150° + 0.103 g upwards";
        assert_eq!(motion_caption(&Motion::Synthetic(across)), three);
        let of_spectrum = "ground: synthetic of a given spectrum, × 1 at 120° + × 0.5 at -150° + × 0.25 upwards";
        assert_eq!(motion_caption(&Motion::Synthetic(matched)), of_spectrum);
    }

    #[test]
    fn components_of_a_record_have_their_azimuths() {
        let component = |azimuth: Option<f64>, vertical: Option<bool>| Component {
            azimuth_deg: azimuth,
            vertical,
            scale: 2.0,
            ..Component::default()
        };
        let components = vec![
            component(Some(270.0), None),
            component(None, Some(true)),
            component(Some(0.0), None),
            component(None, None),
        ];
        let record = RecordMotion { x_azimuth_deg: Some(90.0), components, scale: 0.5, ..RecordMotion::default() };
        let caption = "ground: record × 1 at -180° + × 1 upwards + × 1 at 90° + 1 more";
        assert_eq!(motion_caption(&Motion::Record(record)), caption);
    }

    #[test]
    fn a_vertical_sine_has_its_own_amplitude() {
        let sine = SineMotion {
            amplitude_g: Some(0.4),
            amplitude: None,
            frequency_hz: 2.6,
            phase_deg: 0.0,
            angle_deg: 22.5,
            vertical_amplitude_g: Some(0.1),
            vertical_amplitude: None,
            vertical_phase_deg: None,
        };
        assert_eq!(motion_caption(&Motion::Sine(sine)), "ground: sine 0.40 g, 2.6 Hz at 22.5° + 0.10 g upwards");
    }

    #[test]
    fn grounds_that_supports_stand_on_are_named() {
        let mut scene = crate::scene::presets::load("skew45-abutment").unwrap_or_else(|errors| panic!("{errors}"));
        let alone = ground_caption(&scene);
        scene.grounds.push(NamedGround { name: "bank".into(), motion: Motion::None });
        assert_eq!(ground_caption(&scene), alone, "nothing stands on it");
        scene.abutments[0].ground = Some("bank".into());
        assert_eq!(ground_caption(&scene), format!("{alone}; supports on \u{201c}bank\u{201d}"));
    }
}
