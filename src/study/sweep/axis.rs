//! `--vary KEY=VALUES`: a key of the scene file and the values that it takes.
//!
//! Values are separated by commas; each is a value as `--set` takes it, or a grid: `LO..HI:N` of N numbers evenly spaced,
//! `LO..HI:N:log` of N numbers in equal ratios, both ends included.

use crate::scene::{SceneError, SceneErrors};

/// Decimal digits to which the numbers of a grid are rounded, so that 0..1:11 has 0.3 and not 0.30000000000000004: every
/// decimal number of so many digits is one double (IEEE 754, `f64::DIGITS`).
const DIGITS: usize = f64::DIGITS as usize;
/// Most numbers of one grid.
const MOST: usize = 1_000_000;

/// A key of the scene file and the values that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The path of the key, as `--set` takes it.
    pub key: String,
    /// Its values as text, as `--set` takes them; one at least, none twice.
    pub values: Vec<String>,
    /// Whether its numbers grow in equal ratios.
    pub is_log: bool,
}

impl Axis {
    /// Reads `KEY=VALUES`.
    ///
    /// # Errors
    /// Not of this form, a grid that is none, a value given twice.
    pub fn parse(text: &str) -> Result<Self, SceneErrors> {
        let complain = |value: String, remedy: &str| complaint(text, value, remedy);
        let Some((key, list)) = text.split_once('=') else {
            return Err(complain("no `=`".into(), "write KEY=VALUES, as in motion.angle_deg=-90..90:61"));
        };
        let (mut values, mut grids, mut parts) = (Vec::new(), 0, 0);
        for part in split(list) {
            parts += 1;
            match grid(part).map_err(|remedy| complain(format!("`{part}`"), &remedy))? {
                Some(grid) => {
                    grids += usize::from(grid.is_log);
                    values.extend(grid.values());
                }
                None => values.push(part.to_owned()),
            }
        }
        if values.iter().any(String::is_empty) {
            return Err(complain("an empty value".into(), "give values separated by single commas, as in 30,45,60"));
        }
        let axis = Self { key: key.trim().to_owned(), values, is_log: grids == parts };
        match axis.twice() {
            Some(value) => Err(complain(format!("`{value}` twice"), "give each value once")),
            None => Ok(axis),
        }
    }

    /// A value that comes twice.
    fn twice(&self) -> Option<&str> {
        let mut sorted: Vec<&str> = self.values.iter().map(String::as_str).collect();
        sorted.sort_unstable();
        sorted.windows(2).find(|two| two[0] == two[1]).map(|two| two[0])
    }

    /// Its values as numbers, where all of them are.
    pub fn numbers(&self) -> Option<Vec<f64>> {
        self.values.iter().map(|value| number(value)).collect()
    }

    /// `KEY=VALUE`, as `--set` takes it.
    pub fn setting(&self, value: usize) -> String {
        format!("{}={}", self.key, self.values[value])
    }
}

/// A complaint about `--vary`.
fn complaint(text: &str, value: String, remedy: &str) -> SceneErrors {
    SceneError {
        file: "sweep".into(),
        place: format!("--vary {text}").into(),
        value: value.into(),
        remedy: remedy.into(),
    }
    .into()
}

/// A finite number.
pub(super) fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Parts between commas; commas in brackets and quotes belong to a value.
fn split(list: &str) -> impl Iterator<Item = &str> {
    let (mut depth, mut quote) = (0_usize, None);
    let parts = list.split(move |c| {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (None, '"' | '\'') => quote = Some(c),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth = depth.saturating_sub(1),
            (None, ',') => return depth == 0,
            _ => {}
        }
        false
    });
    parts.map(str::trim)
}

/// `LO..HI:N` or `LO..HI:N:log`.
#[derive(Clone, Copy, Debug)]
struct Grid {
    ends: [f64; 2],
    count: usize,
    is_log: bool,
    /// Whether its numbers are written without a point: those of a grid of whole numbers between whole ends.
    is_whole: bool,
}

/// A part as a grid; none where no two numbers stand about `..`, as in a path.
///
/// # Errors
///
/// The spelling of a grid that was meant.
fn grid(part: &str) -> Result<Option<Grid>, String> {
    let Some((low, rest)) = part.split_once("..") else { return Ok(None) };
    let mut rest = rest.split(':');
    let high = rest.next().unwrap_or_default();
    let (Some(from), Some(to)) = (number(low.trim()), number(high.trim())) else { return Ok(None) };
    let count = rest.next().and_then(|count| count.trim().parse().ok()).filter(|n| (2..=MOST).contains(n));
    let count = count.ok_or_else(|| format!("write LO..HI:N with N, how many values, from 2 to {MOST}"))?;
    let is_log = match (rest.next().map(str::trim), rest.next()) {
        (None, _) => false,
        (Some("log"), None) => true,
        _ => return Err("write LO..HI:N, or LO..HI:N:log for equal ratios".into()),
    };
    if from == to {
        return Err("give two ends that differ".into());
    }
    if is_log && (from == 0.0 || to == 0.0 || from.signum() != to.signum()) {
        return Err("equal ratios need two ends of one sign, neither of them 0".into());
    }
    let grid = Grid { ends: [from, to], count, is_log, is_whole: false };
    let whole_ends = [low, high].iter().all(|end| end.trim().parse::<i64>().is_ok());
    let is_whole = whole_ends && (0..count).all(|i| grid.at(i).fract() == 0.0);
    Ok(Some(Grid { is_whole, ..grid }))
}

impl Grid {
    /// Its number of this index: the ends as given, between them rounded to [`DIGITS`].
    fn at(self, index: usize) -> f64 {
        let ([from, to], part) = (self.ends, index as f64 / (self.count - 1) as f64);
        match index {
            0 => from,
            last if last + 1 == self.count => to,
            _ if self.is_log => rounded(from * (to / from).powf(part), from.abs().min(to.abs())),
            _ => rounded(from + (to - from) * part, from.abs().max(to.abs())),
        }
    }

    fn values(self) -> impl Iterator<Item = String> {
        (0..self.count).map(move |index| {
            let number = self.at(index);
            if self.is_whole { format!("{number:.0}") } else { format!("{number:?}") }
        })
    }
}

/// A number rounded to [`DIGITS`] digits of the larger of itself and `scale`; −0 is 0.
fn rounded(number: f64, scale: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "the decimal exponent of a double")]
    let exponent = number.abs().max(scale).log10().floor() as i32;
    #[expect(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "15")]
    let places = DIGITS as i32 - 1 - exponent;
    match usize::try_from(places) {
        Ok(places) => format!("{number:.places$}").parse().unwrap_or(number) + 0.0,
        Err(_) => number,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Vec<String> {
        Axis::parse(&format!("a.b={text}")).unwrap_or_else(|errors| panic!("{errors}")).values
    }

    #[test]
    fn lists_and_grids_mix() {
        let cases: [(&str, &[&str]); 10] = [
            ("30..90:3", &["30", "60", "90"]),
            ("-90..90:3", &["-90", "0", "90"]),
            ("1..2:3", &["1.0", "1.5", "2.0"]),
            ("0..1:11", &["0.0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.0"]),
            ("1e-3..1e1:5:log", &["0.001", "0.01", "0.1", "1.0", "10.0"]),
            ("90..30:2,7", &["90", "30", "7"]),
            ("paper, return-mapping", &["paper", "return-mapping"]),
            ("[0.07, 0.025],\"a,b\"", &["[0.07, 0.025]", "\"a,b\""]),
            ("../a.AT2,../b.AT2", &["../a.AT2", "../b.AT2"]),
            ("0.1", &["0.1"]),
        ];
        for (text, wanted) in cases {
            assert_eq!(values(text), wanted, "{text}");
        }
    }

    #[test]
    fn a_grid_keeps_its_ends_and_its_order() {
        for text in
            ["0.1..0.7:1000", "1e-9..3e7:1000:log", "-3..-1e-5:77:log", "1e9..1000000001:61", "7e-300..3:50:log"]
        {
            let axis = Axis::parse(&format!("a={text}")).unwrap_or_else(|errors| panic!("{errors}"));
            let numbers = axis.numbers().expect("numbers");
            let ends: Vec<f64> =
                text.split("..").map(|end| end.split(':').next().expect("it").parse().expect("it")).collect();
            assert_eq!([numbers[0], numbers[numbers.len() - 1]], ends[..], "{text}");
            assert!(numbers.windows(2).all(|two| two[0] < two[1]), "{text} grows");
        }
        assert!(Axis::parse("a=1..9:3:log").is_ok_and(|axis| axis.is_log), "known as such");
        assert!(!Axis::parse("a=1..9:3:log,5").is_ok_and(|axis| axis.is_log), "not in equal ratios");
    }

    #[test]
    fn what_is_no_axis_is_told() {
        let cases = [
            ("a", "write KEY=VALUES"),
            ("a=", "single commas"),
            ("a=1,,2", "single commas"),
            ("a=1,2,1", "`1` twice: give each value once"),
            ("a=1..2", "how many values"),
            ("a=1..2:1", "how many values"),
            ("a=1..2:9999999999", "how many values"),
            ("a=1..2:3:ln", "LO..HI:N:log"),
            ("a=1..1:3", "two ends that differ"),
            ("a=-1..1:3:log", "one sign"),
            ("a=0..1:3:log", "one sign"),
        ];
        for (text, remedy) in cases {
            let said = Axis::parse(text).expect_err(text).to_string().replace("; ", ": ");
            assert!(said.contains(remedy) && said.contains(text), "{text}: {said}");
        }
    }
}
