//! Seeded random scenes: every one ends, nothing chatters, nothing is created, nothing is missed.

mod support;

use girderbench::scene::Scene;
use girderbench::sim::{History, Session};
use support::scene;

/// Scenes of each kind; `GIRDERBENCH_SEEDS` asks for another number.
const SEEDS: u64 = 150;
/// Events that one touch may need: a corner that sticks and slips at its own frequency a few dozen times.
const PER_TOUCH: usize = 200;

/// A small, fast and well-mixed generator (splitmix64), so that a seed is the same scene everywhere.
struct Dice(u64);

impl Dice {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn log(&mut self, low: f64, high: f64) -> f64 {
        (self.range(low.ln(), high.ln())).exp()
    }

    fn pick<'a>(&mut self, words: &[&'a str]) -> &'a str {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below the length")]
        words[((self.unit() * words.len() as f64) as usize).min(words.len() - 1)]
    }
}

fn random(seed: u64, kind: &str) -> Scene {
    let mut d = Dice(seed);
    let count = 1 + (seed % 3) as usize;
    let length = d.log(0.1, 40.0);
    let width = length * d.range(0.15, 1.2);
    let thickness = width * d.range(0.05, 0.4);
    let skew = d.range(25.0, 155.0);
    let (mass, frequency) = (d.log(0.5, 1e6), d.log(0.3, 5.0));
    let gap = length * d.log(1e-4, 3e-2);
    let mu_k = d.range(0.0, 0.8);
    let mut text = vec![format!("name = \"seed-{seed}\"\nkind = \"{kind}\"\nduration_s = {}\n", 6.0 / frequency)];
    for i in 0..count {
        text.push(format!(
            "[[girder]]\nname = \"g{i}\"\nlength_m = {length}\nwidth_m = {width}\nthickness_m = {thickness}\nskew_deg = {skew}\nmass_kg = {}\n\
             position_m = [{}, 0.0, 0.0]\nbearings = {{ frequency_hz = {}, damping_ratio = {}, vertical_frequency_hz = {}, \
             at_skewed_m = [[{a}, {b}], [{a}, -{b}], [-{a}, {b}], [-{a}, -{b}]] }}\n\
             initial = {{ velocity_m_s = [{}, {}], spin_deg_s = {} }}\n",
            mass * d.range(0.5, 2.0),
            i as f64 * (length + gap),
            frequency * d.range(0.7, 1.5),
            d.range(0.0, 0.4),
            10.0 * frequency,
            frequency * gap * d.range(-3.0, 3.0),
            frequency * gap * d.range(-3.0, 3.0),
            d.range(-20.0, 20.0) * frequency * gap / length,
            a = length * 0.35,
            b = width * 0.35,
        ));
    }
    text.push(format!("[[abutment]]\nname = \"east\"\nfaces = \"g{}\"\nend = \"+x\"\ngap_m = {gap}\n", count - 1));
    text.push(format!("[[abutment]]\nname = \"west\"\nfaces = \"g0\"\nend = \"-x\"\ngap_m = {gap}\n"));
    text.push(format!(
        "[contact]\nstiffness_n_per_m = {}\nrestitution_normal = {}\nrestitution_tangential = {}\nmu_static = {}\nmu_kinetic = {mu_k}\n\
         law = \"{}\"\nsharing = \"{}\"\ntension = \"{}\"\n",
        mass * (frequency * d.log(10.0, 200.0)).powi(2),
        d.range(0.05, 1.0),
        d.range(0.05, 1.0),
        mu_k * d.range(1.0, 1.5),
        d.pick(&["paper", "return-mapping"]),
        d.pick(&["tributary", "per-node"]),
        d.pick(&["keep", "clamp"]),
    ));
    text.push(format!(
        "[motion]\nkind = \"sine\"\namplitude_m_s2 = {}\nfrequency_hz = {}\nangle_deg = {}\n[solver]\ntolerance = 1e-9\n",
        gap * (6.3 * frequency).powi(2) * d.range(0.2, 6.0),
        frequency * d.range(0.5, 2.0),
        d.range(-180.0, 180.0),
    ));
    scene(&text.concat())
}

fn check(seed: u64, kind: &str) -> Result<(usize, usize), String> {
    let scene = random(seed, kind);
    let history = Session::run(&scene).map_err(|errors| format!("seed {seed}, {kind}: {errors}"))?;
    let complain = |what: String| Err(format!("seed {seed}, {kind}: {what}"));
    if let Some(stop) = history.stop() {
        return complain(format!("stopped: {stop:?}"));
    }
    let ledger = history.ledger(history.end());
    if ledger.residual.is_nan() || ledger.residual.abs() > 1e-6 * ledger.scale {
        return complain(format!("residual {:e} of {:e}", ledger.residual, ledger.scale));
    }
    if let Some((per_touch, contact)) = chatter(&history).filter(|(n, _)| *n > PER_TOUCH) {
        return complain(format!("{per_touch} events in one touch of contact {contact}"));
    }
    missed(&history, &scene).map_or(Ok((history.touches().len(), history.events().len())), complain)
}

/// Most events in one touch, and of which contact.
fn chatter(history: &History) -> Option<(usize, usize)> {
    let inside = |touch: &girderbench::sim::Touch| {
        let mine = history.events().iter().filter(|e| e.contact == touch.contact);
        (mine.filter(|e| e.t >= touch.start && e.t <= touch.end).count(), touch.contact)
    };
    history.touches().iter().map(inside).max()
}

/// A node inside a face without a contact, if there is one.
fn missed(history: &History, scene: &Scene) -> Option<String> {
    use girderbench::contact::{Frame, locate};
    let model = history.model();
    let frame = |body: Option<usize>, fixed, t| match body {
        None => Frame::fixed(fixed),
        Some(b) => {
            let m = history.motion(b, t);
            Frame {
                home: model.bodies[b].home,
                shift: m.displacement,
                rotation: glam::DMat3::from_quat(m.attitude),
                velocity: m.velocity,
                spin: m.spin,
            }
        }
    };
    // A node that passed beside a face may come to lie behind it: those that missed are left out.
    let ignored: Vec<usize> = history
        .events()
        .iter()
        .filter(|e| !e.kind.is_touch() && e.kind.label().contains(['m', 'f']))
        .map(|e| e.contact)
        .collect();
    for i in 0..4000 {
        let t = scene.duration * f64::from(i) / 4000.0;
        for (number, site) in model.contacts.iter().enumerate().filter(|(n, _)| !ignored.contains(n)) {
            let here = locate(
                site.point,
                &frame(site.node_body, site.fixed, t),
                &site.face,
                &frame(site.face_body, site.fixed, t),
            );
            let size = site.face.size();
            let inside =
                here.gap < -1e-9 * size && site.face.inset_at(here.at) > 1e-9 * size && -here.gap < site.face.depth;
            if inside && history.contact_at(number, t).is_none() {
                return Some(format!(
                    "{} is {:e} m inside {} at {t} without a contact",
                    site.node, -here.gap, site.face_name
                ));
            }
        }
    }
    None
}

fn all(kind: &str) {
    let seeds = std::env::var("GIRDERBENCH_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(SEEDS);
    let results: Vec<Result<(usize, usize), String>> = (0..seeds).map(|seed| check(seed, kind)).collect();
    let failures: Vec<&String> = results.iter().filter_map(|r| r.as_ref().err()).collect();
    assert!(failures.is_empty(), "{} of {seeds}: {failures:#?}", failures.len());
    let touches: usize = results.iter().flatten().map(|r| r.0).sum();
    assert!(touches > 5 * results.len(), "contacts are in play: {touches} touches");
}

#[test]
fn random_planar_scenes_end_without_chatter() {
    all("planar");
}

#[test]
fn random_spatial_scenes_end_without_chatter() {
    all("spatial");
}
