//! Pairs that `[[contact.pair]]` declares, and what can be wrong with them.

use super::numbers;
use super::side::{Side, front, girder_named, names};
use crate::geometry::End;
use crate::language::{Message, Text, message};
use crate::scene::{PairSettings, Scene};

/// Place below the pair, value and remedy of a complaint.
type Complaint = (&'static str, Message, Message);

/// The pair that an entry of `[[contact.pair]]` adds to those found, if it adds one.
pub(super) fn pair(
    scene: &Scene,
    pair: &PairSettings,
    found: &[(Side, Side)],
) -> Result<Option<(Side, Side)>, Complaint> {
    let [a, b] = &pair.between;
    let complain = |remedy: Message| ("between", format!("[\"{a}\", \"{b}\"]").into(), remedy);
    // Without `ends` any end will do: it is only asked who the bodies are.
    let ends = pair.ends.unwrap_or([End::Plus; 2]);
    let side = |n: usize| side(scene, &pair.between[n], ends[n]).map_err(complain);
    // Girders sort before abutments, and by number: the order in which a pair is kept.
    let (a, b) = (side(0)?, side(1)?);
    let (first, second) = (a.min(b), a.max(b));
    match (first, second) {
        (Side::Abutment(_), _) => Err(complain(Text::new("wrong-two-abutments").into())),
        (Side::Girder(n, _), Side::Girder(m, _)) if n == m => Err(complain(Text::new("wrong-touches-itself").into())),
        _ if found.iter().any(|sides| numbers::is_between(scene, pair, sides)) => Ok(None),
        _ if pair.ends.is_none() => Err(complain(Text::new("wrong-not-facing").into())),
        _ if look_away(scene, first, second) => {
            let value = ends.map(|end| format!("\"{}\"", end.label())).join(", ");
            Err(("ends", format!("[{value}]").into(), Text::new("wrong-ends-away").into()))
        }
        _ => Ok(Some((first, second))),
    }
}

fn side(scene: &Scene, name: &str, end: End) -> Result<Side, Message> {
    let girder = girder_named(scene, name).map(|n| Side::Girder(n, end));
    let abutment = || scene.abutments.iter().position(|a| a.name == name).map(Side::Abutment);
    girder.or_else(abutment).ok_or_else(|| message!("wrong-nobody", "name" => name, "names" => names(scene)))
}

fn look_away(scene: &Scene, first: Side, second: Side) -> bool {
    let (Some((_, here)), Some((_, there))) = (front(scene, first), front(scene, second)) else { return false };
    here.dot(there) >= 0.0
}
