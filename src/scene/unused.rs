//! Texts on values of a scene that its run does not use.

use super::shown::escaped;
use super::{Direction, Girder, GroundId, Motion, Scene};
use crate::language::{Message, Text, message};

impl Scene {
    /// Each value that has no effect: what the run cuts of a motion, a speed in a direction in which the girder is held, a wave or a factor
    /// of a ground that does not move.
    pub fn unused_values(&self) -> Vec<Message> {
        let speeds = self.girders.iter().flat_map(held_speeds);
        self.cut_motions().into_iter().chain(self.idle_motions()).chain(speeds).collect()
    }

    /// A wave while no ground moves, and a support's factor of a ground that does not.
    fn idle_motions(&self) -> Vec<Message> {
        let still = |ground: Option<&str>| {
            let named = |name: &str| self.ground_named(name).map(GroundId::Named);
            let motion = ground.map_or(Some(GroundId::Reference), named).and_then(|id| self.motion_of(id));
            matches!(motion, Some(Motion::None))
        };
        let wave = self.wave.filter(|_| self.motions().all(|(_, motion)| matches!(motion, Motion::None)));
        let abutments = self.abutments.iter().map(|a| (&a.name, a.motion_factor, a.ground.as_deref()));
        let piers = self.piers.iter().map(|p| (&p.name, p.motion_factor, p.ground.as_deref()));
        let idle = abutments.chain(piers).filter(|(_, factor, ground)| factor.is_some() && still(*ground));
        let factors = idle.map(|(name, ..)| message!("unused-factor", "name" => escaped(name).into_owned()));
        wave.map(|_| Message::from(Text::new("unused-wave"))).into_iter().chain(factors).collect()
    }
}

/// Initial speeds of a girder in directions in which it is held.
fn held_speeds(girder: &Girder) -> impl Iterator<Item = Message> + '_ {
    let initial = &girder.initial;
    let [x, y, z] = initial.velocity;
    let (roll, pitch) = (initial.roll_deg_s.unwrap_or(0.0), initial.pitch_deg_s.unwrap_or(0.0));
    let speeds = [
        (Direction::X, x, "x"),
        (Direction::Y, y, "y"),
        (Direction::Z, z, "z"),
        (Direction::Roll, roll, "roll"),
        (Direction::Pitch, pitch, "pitch"),
        (Direction::Yaw, initial.spin_deg_s, "yaw"),
    ];
    let held = |(direction, speed, _): &(Direction, f64, &str)| *speed != 0.0 && girder.held.contains(direction);
    speeds
        .into_iter()
        .filter(held)
        .map(|(.., held)| message!("unused-speed", "name" => escaped(&girder.name).into_owned(), "held" => held))
}

#[cfg(test)]
mod tests {
    use crate::scene::format::read;

    const SCENE: &str = r#"
        name = "idle"
        duration_s = 1.0
        [motion]
        kind = "none"
        [[girder]]
        name = "g"
        length_m = 1.0
        width_m = 0.5
        thickness_m = 0.1
        mass_kg = 2.0
        held = ["x", "yaw"]
        initial = { velocity_m_s = [0.1, 0.2], spin_deg_s = 3.0 }
    "#;

    fn words(text: &str) -> Vec<String> {
        let scene = read(text, "idle.toml").unwrap_or_else(|errors| panic!("{errors}"));
        scene.unused_values().iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_speed_in_a_held_direction_is_told() {
        let told = words(SCENE);
        assert_eq!(told.len(), 2, "{told:?}");
        assert!(told[0].contains("held in x") && told[1].contains("held in yaw"), "{told:?}");
        assert!(words(&SCENE.replace("\"x\", \"yaw\"", "")).is_empty(), "free in all");
    }

    #[test]
    fn a_wave_and_a_factor_of_still_ground_are_told() {
        let wall = "[[abutment]]\nname = \"a\"\nfaces = \"g\"\ngap_m = 0.1\nmotion_factor = 2.0\n";
        let told = words(&format!("{}\n{wall}\n[wave]\nspeed_m_per_s = 500.0\n", SCENE.replace("held", "# held")));
        assert_eq!(told.len(), 2, "{told:?}");
        let sine = "kind = \"sine\"\namplitude_m_s2 = 1.0\nfrequency_hz = 1.0";
        let moving = SCENE.replace("held", "# held").replace("kind = \"none\"", sine);
        assert!(
            words(&format!("{moving}\n{wall}\n[wave]\nspeed_m_per_s = 500.0\n")).is_empty(),
            "what moves uses both"
        );
    }
}
