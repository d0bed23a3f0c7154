//! A measured table: two columns of numbers, the second in a unit that the heading or the caller states.
//!
//! Columns are separated by commas, semicolons or tabs; lines that start with `#` are comments. The heading is the first line
//! that is no numbers. The unit of a column stands at the end of its name: `x_mm`, `x [mm]`, `t_s`.

use csv::{ReaderBuilder, StringRecord, Trim};

use crate::language::{Message, Text, message};
use crate::motion::format::{RecordError, decimal};

/// Quantity of the first column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Time, in s.
    Time,
    /// Frequency of a steady sine, in Hz.
    Frequency,
}

impl Quantity {
    /// Names that a first column may have, without a unit.
    fn names(self) -> &'static [&'static str] {
        match self {
            Self::Time => &["t", "time"],
            Self::Frequency => &["f", "frequency", "freq"],
        }
    }

    fn unit(self) -> &'static str {
        match self {
            Self::Time => "s",
            Self::Frequency => "hz",
        }
    }

    /// In words, with its unit.
    pub fn words(self) -> Text {
        match self {
            Self::Time => Text::new("columns-time"),
            Self::Frequency => Text::new("columns-frequency"),
        }
    }
}

/// Columns to read from a table.
#[derive(Clone, Copy, Debug)]
pub struct Columns<'a> {
    /// Quantity of the first column.
    pub first: Quantity,
    /// Name of the column of displacements; where there is but one it needs none.
    pub name: Option<&'a str>,
    /// Length of its unit, for a heading that states none \[m\].
    pub unit: Option<f64>,
}

/// A measured table.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Times \[s\] or frequencies \[Hz\], growing.
    pub at: Vec<f64>,
    /// Displacements or amplitudes \[m\].
    pub x: Vec<f64>,
    /// Name of their column; empty without a heading.
    pub name: String,
    /// Length of the unit in the file \[m\].
    pub unit: f64,
}

/// Words of units of length and their length \[m\].
pub const LENGTHS: [(&str, f64); 5] = [("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("µm", 1e-6)];

/// Most rows that are read: over an hour at 100 Hz, and some seconds to identify.
const MOST_ROWS: usize = 500_000;

/// Text of a file as a complaint shows it.
fn shown(text: &str) -> String {
    /// Characters that are shown.
    const LONGEST: usize = 200;
    text.chars().filter(|c| !c.is_control()).take(LONGEST).collect()
}

fn wrong(line: u64, value: impl Into<Message>, remedy: impl Into<Message>) -> RecordError {
    RecordError { line, value: value.into(), remedy: remedy.into() }
}

/// A column by its name.
fn named(name: &str) -> Message {
    message!("columns-this", "name" => shown(name))
}

/// Name and unit of a column: `x_mm`, `x [mm]` and `x (mm)` are x in mm.
fn parts(heading: &str) -> (String, Option<String>) {
    let heading = heading.trim();
    let bracketed = heading.strip_suffix([']', ')']).and_then(|open| open.rsplit_once(['[', '(']));
    match bracketed.or_else(|| heading.rsplit_once('_')) {
        Some((name, unit)) if !name.trim().is_empty() => {
            (name.trim().to_owned(), Some(unit.trim().to_ascii_lowercase()))
        }
        _ => (heading.to_owned(), None),
    }
}

fn length_of(word: &str) -> Option<f64> {
    LENGTHS.iter().find(|(name, _)| *name == word).map(|(_, length)| *length)
}

impl Columns<'_> {
    /// Reads the bytes of a table.
    ///
    /// # Errors
    /// The first line that is not as it should be: columns that are not there, a unit that nothing states, words for numbers,
    /// times that do not grow.
    pub fn read(&self, bytes: &[u8]) -> Result<Measured, RecordError> {
        let separator = separator(bytes);
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut builder = ReaderBuilder::new();
        builder.delimiter(separator).has_headers(false).flexible(true).comment(Some(b'#')).trim(Trim::All);
        let mut reader = builder.from_reader(text);
        let mut measured = Measured { at: Vec::new(), x: Vec::new(), name: String::new(), unit: 0.0 };
        let mut chosen: Option<[usize; 2]> = None;
        for record in reader.records() {
            let record = record.map_err(|error| {
                wrong(
                    error.position().map_or(0, csv::Position::line),
                    Text::new("record-no-text"),
                    Text::new("columns-save-text"),
                )
            })?;
            if record.iter().all(str::is_empty) {
                continue;
            }
            let line = record.position().map_or(0, csv::Position::line);
            let Some(columns) = chosen else {
                let (columns, name, unit) = self.choose(&record, line)?;
                (chosen, measured.unit) = (Some(columns), unit);
                match name {
                    Some(name) => measured.name = name,
                    None => push(&mut measured, self.first, columns, &record, line)?,
                }
                continue;
            };
            push(&mut measured, self.first, columns, &record, line)?;
        }
        if measured.x.len() < 2 {
            return Err(wrong(
                1,
                Text::new("columns-few-rows"),
                message!("columns-give-rows", "words" => self.words()),
            ));
        }
        Ok(measured)
    }

    fn words(&self) -> Message {
        message!("columns-both", "first" => self.first.words())
    }

    /// Numbers of both columns from the first line, the name of the second where that line is a heading, and its unit.
    fn choose(&self, first: &StringRecord, line: u64) -> Result<([usize; 2], Option<String>, f64), RecordError> {
        if first.iter().all(|field| decimal(field).is_some()) {
            if first.len() != 2 || self.name.is_some() {
                let value = message!("columns-no-heading", "count" => first.len());
                return Err(wrong(line, value, Text::new("columns-write-heading")));
            }
            let unit = self.unit.ok_or_else(|| wrong(line, Text::new("columns-no-unit"), NO_UNIT))?;
            return Ok(([0, 1], None, unit));
        }
        let names: Vec<&str> = first.iter().collect();
        let at = self.first_column(&names, line)?;
        let of = self.column(&names, at, line)?;
        Ok(([at, of], Some(names[of].to_owned()), self.unit_of(&names, of, line)?))
    }

    fn first_column(&self, names: &[&str], line: u64) -> Result<usize, RecordError> {
        let known = |heading: &&str| {
            let (name, _) = parts(heading);
            self.first.names().iter().any(|own| name.eq_ignore_ascii_case(own))
        };
        let Some(at) = names.iter().position(known) else {
            let remedy = message!("columns-name-first", "words" => self.first.words(), "name" => self.first.names()[0]);
            return Err(wrong(line, message!("columns-these", "names" => shown(&names.join(", "))), remedy));
        };
        match parts(names[at]).1 {
            Some(unit) if unit != self.first.unit() => {
                Err(wrong(line, named(names[at]), message!("columns-give", "words" => self.first.words())))
            }
            _ => Ok(at),
        }
    }

    fn column(&self, names: &[&str], at: usize, line: u64) -> Result<usize, RecordError> {
        let others: Vec<usize> = (0..names.len()).filter(|n| *n != at).collect();
        let list = || shown(&others.iter().map(|n| names[*n]).collect::<Vec<_>>().join(", "));
        match (self.name, &others[..]) {
            (Some(name), _) => {
                let found = others.iter().copied().find(|n| names[*n] == name || parts(names[*n]).0 == name);
                found.ok_or_else(|| {
                    wrong(
                        line,
                        message!("columns-none", "name" => shown(name)),
                        message!("columns-one-of", "names" => list()),
                    )
                })
            }
            (None, [only]) => Ok(*only),
            (None, []) => Err(wrong(line, Text::new("columns-one"), message!("columns-two", "words" => self.words()))),
            (None, _) => {
                let value = message!("columns-beside", "count" => others.len(), "name" => shown(names[at]));
                Err(wrong(line, value, message!("columns-choose", "names" => list())))
            }
        }
    }

    /// Length of the unit of a column \[m\]. Columns of `trajectory.csv`, `NAME.x` beside a bare `t`, are in metres.
    fn unit_of(&self, names: &[&str], of: usize, line: u64) -> Result<f64, RecordError> {
        let stated = parts(names[of]).1.as_deref().and_then(length_of);
        let quantity = names[of].rsplit_once('.').map(|(_, quantity)| quantity);
        let of_run = names[0] == "t" && matches!(quantity, Some("x" | "y"));
        match (stated.or(of_run.then_some(1.0)), self.unit) {
            (Some(stated), Some(given)) if stated != given => {
                Err(wrong(line, named(names[of]), Text::new("columns-units-differ")))
            }
            (Some(unit), _) | (None, Some(unit)) => Ok(unit),
            (None, None) => Err(wrong(line, message!("columns-unitless", "name" => shown(names[of])), NO_UNIT)),
        }
    }
}

const NO_UNIT: Text = Text::new("columns-state-unit");

fn push(
    measured: &mut Measured,
    first: Quantity,
    columns: [usize; 2],
    record: &StringRecord,
    line: u64,
) -> Result<(), RecordError> {
    let number = |column: usize| {
        let field = record.get(column).unwrap_or_default();
        let cut: String = shown(field).chars().take(40).collect();
        let nothing = || Text::new("found-nothing").into();
        let value: Message = if field.is_empty() { nothing() } else { format!("`{cut}`").into() };
        decimal(field).ok_or_else(|| wrong(line, value, message!("columns-finite", "number" => column + 1)))
    };
    let [at, x] = [number(columns[0])?, number(columns[1])? * measured.unit];
    let grows = measured.at.last().is_none_or(|last| at > *last);
    if !grows || (first == Quantity::Frequency && at <= 0.0) {
        return Err(wrong(line, format!("{} {at}", first.names()[1]), Text::new("columns-order")));
    }
    if measured.x.len() == MOST_ROWS {
        return Err(wrong(line, message!("columns-many", "most" => MOST_ROWS), Text::new("columns-shorter")));
    }
    measured.at.push(at);
    measured.x.push(x);
    Ok(())
}

/// Separator of the columns, from the first line that is no comment.
fn separator(bytes: &[u8]) -> u8 {
    let line = bytes.split(|b| *b == b'\n').find(|line| !line.starts_with(b"#") && !line.trim_ascii().is_empty());
    let line = line.unwrap_or_default();
    [b';', b'\t'].into_iter().find(|separator| line.contains(separator)).unwrap_or(b',')
}

#[cfg(test)]
mod tests {
    use super::*;

    const HISTORY: Columns<'_> = Columns { first: Quantity::Time, name: None, unit: None };

    fn error(columns: Columns<'_>, text: &str) -> String {
        columns.read(text.as_bytes()).expect_err(text).to_string()
    }

    #[test]
    fn units_stand_in_the_heading_or_beside_the_file() {
        for (text, unit) in [
            ("t_s,x_mm\n0,1\n0.5,2\n", None),
            ("# laser\nTime [s]; x [mm]\n0;1,0\n0,5;2,0\n", None),
            ("t\tdeck\n0\t1\n0.5\t2\n", Some(1e-3)),
            ("0,1\n0.5,2\n", Some(1e-3)),
        ] {
            let measured = Columns { unit, ..HISTORY }.read(text.as_bytes()).expect(text);
            assert_eq!((measured.at, measured.x), (vec![0.0, 0.5], vec![1e-3, 2e-3]), "{text}");
        }
        let own = Columns { name: Some("deck.x"), ..HISTORY }.read(b"t,deck.x,deck.y\n0,1,2\n1,3,4\n").expect("ours");
        assert_eq!((own.unit, own.x), (1.0, vec![1.0, 3.0]), "a table of this program is in metres");
    }

    #[test]
    fn what_is_not_a_table_is_refused_with_line_and_remedy() {
        for (text, words) in [
            ("", ["line 1", "rows of time in s"]),
            ("t_s,x\n0,1\n", ["without a unit", "--unit"]),
            ("0,1\n1,2\n", ["without a unit", "--unit"]),
            ("t_ms,x_mm\n0,1\n", ["t_ms", "time in s"]),
            ("a,x_mm\n0,1\n", ["the columns a, x_mm", "name the column"]),
            ("t_s,x_mm,y_mm\n0,1,1\n", ["2 columns beside t_s", "--column: x_mm, y_mm"]),
            ("t_s,x_mm\n0,1\n1,abc\n", ["line 3", "`abc`"]),
            ("t_s,x_mm\n0,1\n1\n", ["line 3", "nothing"]),
            ("t_s,x_mm\n0,1\n0,2\n", ["line 3", "growing"]),
            ("t_s,x_mm\n0,1\n1,inf\n", ["line 3", "finite"]),
            ("t_s\n0\n1\n", ["one column", "give two"]),
        ] {
            let said = error(HISTORY, text);
            assert!(words.iter().all(|word| said.contains(word)), "{text:?}: {said}");
        }
        let said = error(Columns { name: Some("z"), ..HISTORY }, "t_s,x_mm\n0,1\n");
        assert!(said.contains("no column z") && said.contains("x_mm"), "{said}");
        let said = error(Columns { unit: Some(1.0), ..HISTORY }, "t_s,x_mm\n0,1\n");
        assert!(said.contains("--unit differs"), "{said}");
        let said = error(Columns { first: Quantity::Frequency, ..HISTORY }, "f_hz,x_mm\n0,1\n");
        assert!(said.contains("above 0"), "{said}");
        assert!(HISTORY.read(&[0xff, 0xfe, 0x00, 0x31]).is_err(), "no text");
    }
}
