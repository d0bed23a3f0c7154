//! `girderbench check`: validates a scene and prints what was understood.

mod device;
mod flexible;
mod girder;
mod moving;
mod supports;

use super::args::SceneArgs;
use super::console::Console;
use super::digits::six;
use super::domain;
use super::failure::Failure;
use super::summary::name;
use crate::dynamics::{Model, Pair};
use crate::language::{Text, said};
use crate::report::in_force;
use crate::scene::keys::word_told;
use crate::scene::shown::escaped;
use crate::scene::{
    Between, Calibration, FrictionLaw, Kind, ModelKind, NamedGround, NormalName, Scene, Sharing, SolverMethod, Tension,
    ViewPreset,
};
use crate::sim;
use crate::sim::moving_ground::{MovedSupport, moved_supports};

/// Difference of two coefficients of restitution that is round-off \[–\].
const RETURNED_ROUNDING: f64 = 1e-9;
/// So many pairs that can come near without contact are written out.
const MOST_UNJOINED: usize = 10;

/// Validate a scene and print what was understood
#[derive(Clone, Debug, clap::Args)]
pub(super) struct CheckArgs {
    #[command(flatten)]
    scene: SceneArgs,
}

/// Does it.
///
/// # Errors
/// Every complaint about the scene.
pub(super) fn run(args: &CheckArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    let model = args.scene.of_its_file(Model::compile(&scene))?;
    let moved = moved_supports(&scene, &model);
    console.print(&text(&scene, &model, &moved));
    domain::warn(&scene, console);
    domain::warn_of_drift(&moved, console);
    // Elsewhere bodies are joined where they meet.
    if scene.contact.between == Between::Ends || scene.model.kind == ModelKind::Impact {
        unjoined(&scene, &model, console);
    }
    Ok(())
}

/// Warns of bodies that can come near and that no contact joins.
fn unjoined(scene: &Scene, model: &Model, console: &mut Console) {
    let found = sim::unjoined(scene, model);
    for unjoined in found.iter().take(MOST_UNJOINED) {
        let [one, other] = unjoined.bodies.map(|body| escaped(body.name(scene)));
        console.note(&said!(
            "warning-unjoined",
            "one" => one,
            "other" => other,
            "apart" => six(unjoined.apart * 1e3),
            "reach" => six(unjoined.reach * 1e3)
        ));
    }
    if let Some(more) = found.len().checked_sub(MOST_UNJOINED).filter(|more| *more > 0) {
        console.note(&said!("warning-more-unjoined", "more" => more));
    }
}

fn text(scene: &Scene, model: &Model, moved: &[MovedSupport]) -> String {
    let girders = scene.girders.iter().zip(&model.bodies).map(|(g, body)| girder::text(scene, g, body));
    let pairs = model.pairs.iter().enumerate().map(|(number, pair)| pair_text(scene, pair, &nodes(model, number)));
    let elsewhere = match scene.contact.between {
        Between::All => Text::new("check-touch-anywhere"),
        Between::Ends => Text::new("check-touch-nowhere"),
    };
    let none = model.pairs.is_empty().then(|| format!("{}\n", said!("check-no-pairs", "elsewhere" => elsewhere)));
    let soil = scene.abutments.iter().filter_map(|abutment| in_force::soil(scene, abutment)).map(|two| lines(&two));
    let piers = in_force::piers(scene).map(|all| lines(&all));
    std::iter::once(head(scene))
        .chain(girders)
        .chain(flexible::texts(model))
        .chain(moving::texts(moved))
        .chain(soil)
        .chain(piers)
        .chain(pairs)
        .chain(none)
        .chain(impact(scene))
        .chain(assumed_stiffness(scene))
        .chain(device::texts(scene))
        .chain(assumed(scene))
        .collect()
}

/// Lines of one body, those after the first set in.
fn lines(all: &[String]) -> String {
    let shown: Vec<String> = all.iter().map(|line| escaped(line).to_string()).collect();
    shown.join("\n  ") + "\n"
}

/// The numbers of the impact model where it computes the scene, and that those of the contact model beside it are others.
fn impact(scene: &Scene) -> Option<String> {
    let (own, contact) = (scene.impact, &scene.contact);
    if !scene.model.kind.models().contains(&ModelKind::Impact) {
        return None;
    }
    let [corner_static, corner_kinetic] = own.corner_friction().map(six);
    let numbers = said!(
        "check-impact",
        "en" => six(own.restitution_normal),
        "et" => six(own.restitution_tangential),
        "mus" => six(own.mu_static),
        "muk" => six(own.mu_kinetic),
        "cmus" => corner_static,
        "cmuk" => corner_kinetic
    );
    let differ = scene.model.kind == ModelKind::Both && own.restitution_normal != contact.restitution_normal;
    let beside = differ.then(|| {
        format!("  {}\n", said!("check-impact-differs", "impact" => six(own.restitution_normal), "contact" => six(contact.restitution_normal)))
    });
    Some(format!("{numbers}\n{}", beside.unwrap_or_default()))
}

/// That K is not given, and what it is then.
fn assumed_stiffness(scene: &Scene) -> Option<String> {
    let is_assumed = scene.contact.stiffness.is_none() && scene.model.kind != ModelKind::Impact;
    is_assumed.then(|| format!("{}\n", Text::new("check-assumed-stiffness")))
}

/// Values that were not given.
fn assumed(scene: &Scene) -> impl Iterator<Item = String> {
    scene.assumed_numbers().into_iter().map(|(path, value)| {
        format!("{}\n", said!("check-assumed", "path" => escaped(&path), "value" => escaped(&value)))
    })
}

/// Properties of the scene as a whole.
fn head(scene: &Scene) -> String {
    let kind = match scene.kind {
        Kind::Planar => Text::new("check-planar").into(),
        Kind::Spatial => said!("check-spatial", "gravity" => six(scene.gravity)),
    };
    let mut ground = said!("check-head-b", "motion" => in_force::motion(&scene.motion));
    for NamedGround { name: of, motion } in &scene.grounds {
        let moves = |own: &Option<String>| own.as_ref() == Some(of);
        let is_used = scene.abutments.iter().any(|abutment| moves(&abutment.ground))
            || scene.piers.iter().any(|pier| moves(&pier.ground));
        let [of, motion] = [name(of), in_force::motion(motion)];
        let line = if is_used {
            said!("check-named-ground", "name" => of, "motion" => motion)
        } else {
            said!("check-unused-ground", "name" => of, "motion" => motion)
        };
        ground = format!("{ground}\n{line}");
    }
    format!(
        "{}\n{ground}\n{}\n{}\n",
        said!("check-head", "name" => name(&scene.name), "kind" => kind, "duration" => six(scene.duration)),
        said!(
            "check-head-c",
            "method" => word_told(SolverMethod::WORDS, scene.solver.method.label()),
            "tolerance" => six(scene.solver.tolerance)
        ),
        said!("check-head-d", "camera" => word_told(ViewPreset::WORDS, scene.view.camera.label()))
    )
}

fn pair_text(scene: &Scene, pair: &Pair, nodes: &str) -> String {
    let c = &pair.contact;
    let nodes = said!("check-nodes", "nodes" => nodes);
    // Laws and stiffnesses are those of the contact model.
    if scene.model.kind == ModelKind::Impact {
        let gap = said!("check-pair-gap", "pair" => pair.name.as_str(), "gap" => six(pair.gap * 1e3));
        return format!("{gap}\n  {nodes}\n");
    }
    let rules = said!(
        "check-pair",
        "pair" => pair.name.as_str(),
        "gap" => six(pair.gap * 1e3),
        "law" => word_told(FrictionLaw::WORDS, c.law.label()),
        "sharing" => word_told(Sharing::WORDS, c.sharing.label()),
        "tension" => word_told(Tension::WORDS, c.tension.label())
    );
    let dashpots = pair.law.dashpots();
    let [normal, tangential] = [dashpots.normal, dashpots.tangential].map(|c| short(c + 0.0));
    // Of a law with another dashpot, or with one that is 0 where the touch begins, (65) gives the tangential one alone.
    let dashpots = if pair.is_damped_by_65() {
        format!("C_n = {normal} N·s/m, C_t = {tangential} N·s/m (65)")
    } else if dashpots.normal > 0.0 {
        format!("C_n = {normal} N·s/m, C_t (65) = {tangential} N·s/m")
    } else {
        format!("C_t (65) = {tangential} N·s/m")
    };
    let numbers = format!(
        "K = {} N/m, e_n = {}, e_t = {}, {dashpots}, μ_s = {}, μ_k = {}",
        short(c.stiffness),
        six(c.restitution_normal),
        six(c.restitution_tangential),
        six(c.mu_static),
        six(c.mu_kinetic)
    );
    format!("{rules}\n{}  {numbers}\n  {nodes}\n", normal_law(pair))
}

/// Normal law and the restitution that comes back, where that is not `e_n` by (65).
fn normal_law(pair: &Pair) -> String {
    let (c, returned) = (&pair.contact, pair.returned_restitution());
    if c.normal_law == NormalName::DEFAULT && (returned - c.restitution_normal).abs() < RETURNED_ROUNDING {
        return String::new();
    }
    format!(
        "  {}\n",
        said!(
            "check-normal-law",
            "law" => word_told(NormalName::WORDS, c.normal_law.label()),
            "calibration" => word_told(Calibration::WORDS, c.calibration.label()),
            "speed" => six(c.design_speed),
            "e" => six(returned)
        )
    )
}

/// A number that may be very large, to seven digits.
fn short(value: f64) -> String {
    if value < 1e5 { format!("{value:.4}") } else { format!("{value:.6e}") }
}

/// `deck.corner1 on wall, …`
fn nodes(model: &Model, pair: usize) -> String {
    let sites = &model.sites[model.pairs[pair].sites.clone()];
    sites
        .iter()
        .map(|site| said!("check-node", "node" => site.node.as_str(), "face" => site.face_name.to_string()))
        .collect::<Vec<_>>()
        .join(", ")
}
