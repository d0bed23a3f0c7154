//! Numbers of an elastic girder.

use super::complaints::At;
use crate::scene::keys;
use crate::scene::{Girder, Kind};

pub(super) fn check(girder: &Girder, kind: Kind, at: &mut At<'_>) {
    let Some(elastic) = &girder.elastic else { return };
    let mut at = at.below("elastic", keys::ELASTIC);
    at.all(elastic);
    at.fits(elastic, kind);
    for (key, value, remedy) in elastic.faults(girder) {
        at.add(key, value, remedy);
    }
    if let Some(rayleigh) = &elastic.rayleigh {
        at.below("rayleigh", keys::RAYLEIGH).all(rayleigh);
    }
}
