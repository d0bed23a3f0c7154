//! Bodies on piers: bearings one by one, and the ends of girders.

use glam::{DVec2, DVec3};

use super::{Bearings, Girder, Scene, placed};
use crate::geometry::End;

impl Bearings {
    /// The name of the pier or abutment under each bearing of a girder, in the order of [`Bearings::resolve`]; `None` on the ground.
    pub fn named_supports(&self, girder: &Girder) -> Vec<Option<&str>> {
        match self {
            Self::Shared(shared) => {
                let shear = girder.prism().shear();
                let places = shared.places(girder);
                let under = |&[x, y]: &[f64; 2]| match end_of([x, y], shear)? {
                    End::Plus => shared.on_plus_x.as_deref(),
                    End::Minus => shared.on_minus_x.as_deref(),
                };
                places.iter().map(under).collect()
            }
            Self::Deck(deck) => {
                let shear = girder.prism().shear();
                let under = |&[x, y]: &[f64; 2]| match end_of([x, y], shear)? {
                    End::Plus => deck.on_plus_x.as_deref(),
                    End::Minus => deck.on_minus_x.as_deref(),
                };
                deck.places(girder).iter().map(under).collect()
            }
            Self::Each(each) => each.iter().map(|bearing| bearing.on.as_deref()).collect(),
        }
    }

    /// The names of piers and abutments that it mentions, to be changed.
    pub(super) fn support_names(&mut self) -> Vec<&mut Option<String>> {
        match self {
            Self::Shared(shared) => vec![&mut shared.on_minus_x, &mut shared.on_plus_x],
            Self::Deck(deck) => vec![&mut deck.on_minus_x, &mut deck.on_plus_x],
            Self::Each(each) => each.iter_mut().map(|bearing| &mut bearing.on).collect(),
        }
    }
}

impl Girder {
    /// Puts all bearings on the ground.
    pub fn stand_on_ground(&mut self) {
        for on in self.bearings.iter_mut().flat_map(Bearings::support_names) {
            *on = None;
        }
    }

    /// Puts the bearings nearer to an end on the pier of this name, or on the ground; whether there are any.
    pub fn stand_on(&mut self, end: End, pier: Option<&str>) -> bool {
        let shear = self.prism().shear();
        let on = || pier.map(str::to_owned);
        match &mut self.bearings {
            None => false,
            Some(Bearings::Shared(shared)) => {
                let under = if end == End::Plus { &mut shared.on_plus_x } else { &mut shared.on_minus_x };
                *under = on();
                true
            }
            Some(Bearings::Deck(deck)) => {
                let under = if end == End::Plus { &mut deck.on_plus_x } else { &mut deck.on_minus_x };
                *under = on();
                true
            }
            Some(Bearings::Each(each)) => {
                let near = each.iter_mut().filter(|bearing| end_of(bearing.at, shear) == Some(end));
                near.map(|bearing| bearing.on = on()).count() > 0
            }
        }
    }
}

/// Support under a bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StandsOn {
    /// The ground.
    Ground,
    /// The pier of this number.
    Pier(usize),
    /// The abutment of this number.
    Abutment(usize),
}

/// The end that a place in a girder's frame is nearer to, before skewing; `None` in the middle.
fn end_of([x, y]: [f64; 2], shear: f64) -> Option<End> {
    let before = x - y * shear;
    match before {
        _ if before > 0.0 => Some(End::Plus),
        _ if before < 0.0 => Some(End::Minus),
        _ => None,
    }
}

impl Scene {
    /// The names of piers and abutments that bearings mention, to be changed.
    pub(super) fn support_names(&mut self) -> impl Iterator<Item = &mut Option<String>> {
        self.girders.iter_mut().filter_map(|girder| girder.bearings.as_mut()).flat_map(Bearings::support_names)
    }

    /// Number of the pier of this name.
    pub fn pier_named(&self, name: &str) -> Option<usize> {
        self.piers.iter().position(|pier| pier.name == name)
    }

    /// Number of the pier under each bearing of a girder, in the order of [`Bearings::resolve`]; `None` on the ground.
    pub fn supports(&self, girder: &Girder) -> Vec<Option<usize>> {
        let Some(bearings) = &girder.bearings else { return Vec::new() };
        if self.piers.is_empty() {
            return vec![None; bearings.resolve(girder, self.setting()).len()];
        }
        bearings.named_supports(girder).into_iter().map(|name| self.pier_named(name?)).collect()
    }

    /// Support under each bearing of a girder, in the order of [`Bearings::resolve`].
    pub fn standing(&self, girder: &Girder) -> Vec<StandsOn> {
        let Some(bearings) = &girder.bearings else { return Vec::new() };
        let named = |name: &str| {
            let abutment = || self.abutments.iter().position(|abutment| abutment.name == name);
            self.pier_named(name).map(StandsOn::Pier).or_else(|| abutment().map(StandsOn::Abutment))
        };
        bearings
            .named_supports(girder)
            .into_iter()
            .map(|name| name.and_then(named).unwrap_or(StandsOn::Ground))
            .collect()
    }

    /// Common support of all bearings nearer to an end of a girder than to the other; `None` where they have several.
    pub fn standing_under(&self, girder: &Girder, end: End) -> Option<StandsOn> {
        let shear = girder.prism().shear();
        let resolved = girder.bearings.as_ref()?.resolve(girder, self.setting());
        let near = resolved.iter().zip(self.standing(girder));
        let mut near = near.filter(|(b, _)| end_of([b.place.x, b.place.y], shear) == Some(end)).map(|(_, on)| on);
        let first = near.next()?;
        near.all(|on| on == first).then_some(first)
    }

    /// The pier that an end of a girder stands on: that of all bearings nearer to this end than to the other.
    pub fn pier_under(&self, girder: &Girder, end: End) -> Option<usize> {
        match self.standing_under(girder, end)? {
            StandsOn::Pier(number) => Some(number),
            StandsOn::Ground | StandsOn::Abutment(_) => None,
        }
    }

    /// Bearings that stand on a pier: number of the girder, and the bearing's place in the world \[m\].
    pub(super) fn standing_on(&self, pier: usize) -> Vec<(usize, DVec3)> {
        let of_girder = |(number, girder): (usize, &Girder)| {
            let resolved = girder.supports(self.setting());
            let axes = placed::axes(girder);
            let on = resolved.into_iter().zip(self.supports(girder)).filter(move |(_, under)| *under == Some(pier));
            let place = move |place: DVec3| DVec3::from(girder.position) + axes * place;
            on.map(move |(bearing, _)| (number, place(bearing.place))).collect::<Vec<_>>()
        };
        let mentions = |girder: &&Girder| {
            let name = self.piers[pier].name.as_str();
            girder.bearings.as_ref().is_some_and(|b| match b {
                Bearings::Shared(b) => [&b.on_minus_x, &b.on_plus_x].into_iter().flatten().any(|on| on == name),
                Bearings::Deck(b) => [&b.on_minus_x, &b.on_plus_x].into_iter().flatten().any(|on| on == name),
                Bearings::Each(each) => each.iter().any(|b| b.on.as_deref() == Some(name)),
            })
        };
        self.girders.iter().enumerate().filter(|(_, girder)| mentions(girder)).flat_map(of_girder).collect()
    }
}

/// Least and largest coordinate of points along a direction in plan \[m\].
pub(super) fn extent(points: &[(usize, DVec3)], along: DVec2) -> [f64; 2] {
    let ways = points.iter().map(|(_, place)| place.truncate().dot(along));
    ways.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], way| [low.min(way), high.max(way)])
}

/// Underside of a girder, where its bearings are \[m\]; in a planar scene as drawn.
pub(super) fn underside(girder: &Girder) -> f64 {
    girder.position[2] - girder.thickness / 2.0
}
