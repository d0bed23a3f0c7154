//! Units of acceleration in files of records, and the words that headers use for them.

/// Standard gravity \[m/s²\]: one g of a record.
pub const STANDARD_GRAVITY: f64 = 9.806_65;

/// A unit of acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Unit {
    /// Multiples of 9.80665 m/s².
    #[serde(rename = "g")]
    G,
    /// 1 gal = 1 cm/s².
    #[serde(rename = "gal")]
    Gal,
    /// m/s².
    #[serde(rename = "m/s2")]
    MetrePerSecond2,
}

impl Unit {
    /// Every unit.
    pub const ALL: &'static [Self] = &[Self::G, Self::Gal, Self::MetrePerSecond2];
    /// Their words in a scene and in a flag.
    pub const WORDS: &'static [&'static str] = &["g", "gal", "m/s2"];

    /// One of it \[m/s²\].
    pub const fn in_si(self) -> f64 {
        match self {
            Self::G => STANDARD_GRAVITY,
            Self::Gal => 0.01,
            Self::MetrePerSecond2 => 1.0,
        }
    }

    /// Its sign.
    pub const fn label(self) -> &'static str {
        match self {
            Self::G => "g",
            Self::Gal => "gal",
            Self::MetrePerSecond2 => "m/s²",
        }
    }

    /// The unit that a word means, in either case: `g`, `gal`, `cm/s2`, `cm/sec/sec`, `m/s²`, …
    pub fn of_word(word: &str) -> Option<Self> {
        let word = word.trim().trim_end_matches(['.', ',', ';']).to_ascii_lowercase();
        let word =
            word.replace("sec", "s").replace('²', "2").replace("^2", "2").replace("**2", "2").replace("s/s", "s2");
        match word.as_str() {
            "g" | "g's" => Some(Self::G),
            "gal" | "gals" | "cm/s2" => Some(Self::Gal),
            "m/s2" => Some(Self::MetrePerSecond2),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_write_units_in_many_ways() {
        for word in ["cm/sec2", "cm/sec/sec", "CM/S/S", "cm/s^2", "cm/s²", "gal", "Gal."] {
            assert_eq!(Unit::of_word(word), Some(Unit::Gal), "{word}");
        }
        assert_eq!(Unit::of_word("G."), Some(Unit::G), "at the end of a sentence");
        assert_eq!(Unit::of_word("m/s/s"), Some(Unit::MetrePerSecond2), "twice divided");
        for other in ["counts", "cm/s", "cm/sec", "", "mg", "in/s2"] {
            assert_eq!(Unit::of_word(other), None, "{other}");
        }
    }
}
