//! Bearings of a girder.
//!
//! `bearings` is a table (equal bearings, given by frequency and damping) or a list (one by one), and some numbers may
//! be one or two; both are read by hand, because serde's untagged enums forget what was wrong and where.

use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{DeserializeSeed, IntoDeserializer as _, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::DeckBearings;
use super::bearing_law::{BearingSlide, BearingYield, SLIDER_DISPLACEMENT};
use super::keys::{Editable, Fallback, Keyed as _, Range, Stands, Stated, table};

/// One number for both horizontal directions, or `[x, y]` along and across the girder as placed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum PerDirection {
    /// One number for both x and y.
    Both(f64),
    /// `[x, y]`.
    Each([f64; 2]),
}

impl PerDirection {
    /// `[x, y]`.
    pub fn xy(self) -> [f64; 2] {
        match self {
            Self::Both(v) => [v, v],
            Self::Each(xy) => xy,
        }
    }
}

impl Stands for PerDirection {
    fn by_default(_: Fallback) -> Self {
        Self::Both(f64::NAN)
    }

    fn stated(&self) -> Stated<'_> {
        match self {
            Self::Both(number) => Stated::Number(*number),
            Self::Each(numbers) => Stated::Numbers(numbers),
        }
    }

    fn carry(&mut self, old: &Self, new: &Self) {
        if old == new {
            return;
        }
        let mut own = self.xy();
        Stands::carry(&mut own, &old.xy(), &new.xy());
        *self = match new {
            Self::Both(_) if own[0] == own[1] => Self::Both(own[0]),
            _ => Self::Each(own),
        };
    }
}

table! {
    /// Equal bearings, given by the frequency and damping of the whole girder on them (paper equation (5)).
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct SharedBearings, BEARINGS {
        frequency_hz: PerDirection = "frequency_hz", Range::NotNegative, Fallback::Needed("must be given"),
            "f, Hz: one number, or [x, y] along and across the girder";
        damping_ratio: PerDirection = "damping_ratio", Range::NotNegative, Fallback::Needed("must be given"),
            "h, of critical: one number, or [x, y]";
        vertical_frequency_hz: Option<f64> = "vertical_frequency_hz", Range::Positive,
            Fallback::Needed("must be given in a spatial scene (unless z is held)"),
            "f_z, Hz; not used in a planar scene";
        vertical_damping_ratio: Option<f64> = "vertical_damping_ratio", Range::NotNegative,
            Fallback::Words("as damping_ratio along x"), "h_z";
        at: Option<Vec<[f64; 2]>> = "at_m", Range::Like("one or more [x, y]"), Fallback::Needed("this or the next"),
            "places in the girder's frame, m";
        at_skewed: Option<Vec<[f64; 2]>> = "at_skewed_m", Range::Like("one or more [x, y]"),
            Fallback::Needed("this or the last"),
            "places before skewing, m: y cot β is added to x, so that they follow the skew";
        travel: Option<f64> = "travel_m" as "field-free-travel", Range::Positive, Fallback::Words("no end"),
            "displacement square to the front edge of its seat, either way, at which a bearing loses its support, m";
        height: Option<f64> = "height_m" as "field-height", Range::Any, Fallback::Words("the underside, -thickness_m / 2"),
            "height above G in the girder's frame, m", in in_space;
        on_minus_x: Option<String> = "on_minus_x", Range::Like("a pier or an abutment"), Fallback::Words("the ground"),
            "the pier or abutment under the bearings of the -x half";
        on_plus_x: Option<String> = "on_plus_x", Range::Like("a pier or an abutment"), Fallback::Words("the ground"),
            "the pier or abutment under the bearings of the +x half";
    }
}

table! {
    /// One bearing with its own springs and dashpots, along and across the girder as placed, and vertical.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct Bearing, BEARING {
        at: [f64; 2] = "at_m", Range::Like("[x, y]"), Fallback::Needed("must be given"),
            "place in the girder's frame, m";
        #[serde(with = "super::two_or_three")]
        stiffness: [f64; 3] = "stiffness_n_per_m", Range::NotNegative, Fallback::Needed("must be given"),
            "[k_x, k_y] or [k_x, k_y, k_z] along, across and up, N/m; a spatial girder needs some k_z";
        #[serde(with = "super::two_or_three")]
        damping: [f64; 3] = "damping_n_s_per_m", Range::NotNegative, Fallback::Needed("must be given"),
            "[c_x, c_y] or [c_x, c_y, c_z], N·s/m";
        yield_force: Option<f64> = "yield_force_n" as "field-yield", Range::Positive, Fallback::Words("none: linear"),
            "Q, force without displacement on the upper line of the loop (lead rubber; μN of a slider), N; stiffness_n_per_m is then that after yield";
        yield_displacement: Option<f64> = "yield_displacement_m" as "field-yields-at", Range::Positive,
            Fallback::Needed("must be given with yield_force_n"), "u_y = Q/(k₁ − k₂), m";
        per_axis: Option<bool> = "yields_per_axis", Range::Switch, Fallback::Words("false"),
            "whether it yields along x and y each for itself; otherwise on one circle";
        friction: Option<f64> = "friction" as "field-friction", Range::Positive, Fallback::Words("none"),
            "μ of a slider or a friction pendulum, in place of yield_force_n";
        radius: Option<f64> = "radius_m" as "field-radius", Range::NotNegative, Fallback::Words("0.0: flat"),
            "R of a friction pendulum, which has the stiffness N/R beside its own, m";
        slider_displacement: Option<f64> = "slider_displacement_m" as "field-slides-at", Range::Positive, Fallback::Words("0.0005"),
            "displacement at which the friction is fully there, a regularisation; full scale, m";
        load: Option<f64> = "load_n" as "field-load", Range::Positive, Fallback::Words("an equal share of the weight"),
            "N at rest that friction goes by; of all bearings or of none, in a planar scene, N";
        travel: Option<f64> = "travel_m" as "field-free-travel", Range::Positive, Fallback::Words("no end"),
            "displacement square to the front edge of its seat, either way, at which a bearing loses its support, m";
        height: Option<f64> = "height_m" as "field-height", Range::Any, Fallback::Words("the underside, -thickness_m / 2"),
            "height above G in the girder's frame, m", in in_space;
        on: Option<String> = "on", Range::Like("a pier or an abutment"), Fallback::Words("the ground"), "the pier or abutment that it stands on";
    }
}

impl Bearing {
    /// A linear bearing at a place in the girder's frame \[m\], at the underside \[N/m, N·s/m\].
    pub fn linear(at: [f64; 2], stiffness: [f64; 3], damping: [f64; 3]) -> Self {
        Self { at, stiffness, damping, ..Self::by_default() }
    }

    /// Its friction, where it has one: a slider with its share of the weight \[N\].
    pub(super) fn sliding(&self, share: f64) -> Option<BearingSlide> {
        Some(BearingSlide {
            friction: self.friction?,
            curvature: self.radius.filter(|radius| *radius > 0.0).map_or(0.0, f64::recip),
            displacement: self.slider_displacement.unwrap_or(SLIDER_DISPLACEMENT),
            load: self.load.unwrap_or(share),
        })
    }

    /// Its yield, where it has both numbers of one.
    pub fn yielding(&self) -> Option<BearingYield> {
        let (force, displacement) = (self.yield_force?, self.yield_displacement?);
        Some(BearingYield { force, displacement, per_axis: self.per_axis == Some(true) })
    }
}

/// The bearings of a girder.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Bearings {
    /// `bearings = { frequency_hz = …, … }`.
    Shared(SharedBearings),
    /// `bearings = { kind = …, … }`.
    Deck(DeckBearings),
    /// `bearings = [{ at_m = …, stiffness_n_per_m = …, … }, …]`.
    Each(Vec<Bearing>),
}

impl Stands for Bearings {
    /// No bearing; a girder without any has no such value.
    fn by_default(_: Fallback) -> Self {
        Self::Each(Vec::new())
    }

    /// Numbers go to bearings of the same form alone; those of another form are put on other ones where they stand.
    fn carry(&mut self, old: &Self, new: &Self) {
        match (self, old, new) {
            (Self::Shared(own), Self::Shared(old), Self::Shared(new)) => Editable::carry(own, old, new),
            (Self::Deck(own), Self::Deck(old), Self::Deck(new)) => Editable::carry(own, old, new),
            (Self::Each(own), Self::Each(old), Self::Each(new)) => Stands::carry(own, old, new),
            (own, Self::Shared(_), Self::Deck(new)) => *own = Self::Deck(new.clone()).where_stand(own),
            (own, Self::Deck(_), Self::Shared(new)) => *own = Self::Shared(new.clone()).where_stand(own),
            _ => {}
        }
    }
}

impl Bearings {
    /// These bearings at the places and on the supports of others, of which each place has one, as stiff and as damped straight up and down
    /// as those; single ones have numbers of their own at each place and stay.
    #[must_use]
    pub fn where_stand(mut self, others: &Self) -> Self {
        let upright = others.upright();
        macro_rules! stand {
            ($own:ident, $theirs:ident) => {{
                ($own.at, $own.at_skewed) = ($theirs.at.clone(), $theirs.at_skewed.clone());
                ($own.on_minus_x, $own.on_plus_x) = ($theirs.on_minus_x.clone(), $theirs.on_plus_x.clone());
                ($own.height, $own.travel) = ($theirs.height, $theirs.travel);
                ($own.vertical_frequency_hz, $own.vertical_damping_ratio) = upright;
            }};
        }
        match (&mut self, others) {
            (Self::Shared(own), Self::Shared(theirs)) => stand!(own, theirs),
            (Self::Shared(own), Self::Deck(theirs)) => stand!(own, theirs),
            (Self::Deck(own), Self::Shared(theirs)) => stand!(own, theirs),
            (Self::Deck(own), Self::Deck(theirs)) => stand!(own, theirs),
            (Self::Each(_), _) | (_, Self::Each(_)) => return others.clone(),
        }
        self
    }

    /// Vertical frequency \[Hz\] and damping ratio of equal bearings, the latter with what it is where it is left out; none of a scene in
    /// plan, and of single ones.
    fn upright(&self) -> (Option<f64>, Option<f64>) {
        let (frequency, damping, otherwise) = match self {
            Self::Shared(s) => (s.vertical_frequency_hz, s.vertical_damping_ratio, s.damping_ratio.xy()[0]),
            Self::Deck(d) => (d.vertical_frequency_hz, d.vertical_damping_ratio, 0.0),
            Self::Each(_) => (None, None, 0.0),
        };
        (frequency, damping.or(frequency.map(|_| otherwise)))
    }
}

impl<'de> Deserialize<'de> for PerDirection {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PerDirectionVisitor)
    }
}

struct PerDirectionVisitor;

impl<'de> Visitor<'de> for PerDirectionVisitor {
    type Value = PerDirection;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a number, or a list of two numbers [x, y]")
    }

    fn visit_f64<E>(self, v: f64) -> Result<PerDirection, E> {
        Ok(PerDirection::Both(v))
    }

    fn visit_i64<E>(self, v: i64) -> Result<PerDirection, E> {
        Ok(PerDirection::Both(v as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<PerDirection, A::Error> {
        match (seq.next_element()?, seq.next_element()?) {
            (Some(x), Some(y)) => Ok(PerDirection::Each([x, y])),
            _ => Err(serde::de::Error::invalid_length(0, &self)),
        }
    }
}

impl<'de> Deserialize<'de> for Bearings {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(BearingsVisitor)
    }
}

struct BearingsVisitor;

impl<'de> Visitor<'de> for BearingsVisitor {
    type Value = Bearings;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a table { frequency_hz = …, damping_ratio = …, at_m = … } or { kind = …, at_m = … }, or a list of single bearings")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Bearings, A::Error> {
        let first: Option<String> = map.next_key()?;
        let of_kind = first.as_deref() == Some("kind");
        let whole = MapAccessDeserializer::new(Begun { first, rest: map });
        if of_kind {
            DeckBearings::deserialize(whole).map(Bearings::Deck)
        } else {
            SharedBearings::deserialize(whole).map(Bearings::Shared)
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Bearings, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(seq)).map(Bearings::Each)
    }
}

/// A table whose first key has been read. The reader hands out `kind` first.
struct Begun<A> {
    first: Option<String>,
    rest: A,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for Begun<A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        match self.first.take() {
            Some(key) => seed.deserialize(key.into_deserializer()).map(Some),
            None => self.rest.next_key_seed(seed),
        }
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.rest.next_value_seed(seed)
    }
}
