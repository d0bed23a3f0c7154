//! Marks and their places in the first picture: a TOML file beside the pictures.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use crate::language::{Text, said};

/// The body that every other is measured against: marks that stand still with the table.
pub const TABLE: &str = "table";

/// Name of the layout beside the pictures.
pub const LAYOUT: &str = "marks.toml";

/// Most marks that are followed.
pub const MOST_MARKS: usize = 1000;

/// A film of marks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Layout {
    /// Pictures a second \[Hz\].
    pub fps: f64,
    /// Time of the first picture \[s\].
    #[serde(default)]
    pub from_s: f64,
    /// Number of pictures that belong to it, in the order of their names; all when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pictures: Option<usize>,
    /// Length of a pixel; from the places of marks on one body when left out \[mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mm_per_pixel: Option<f64>,
    /// The marks.
    #[serde(default)]
    pub mark: Vec<MarkPlace>,
}

/// A mark.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkPlace {
    /// Body that it is on; `table` for the reference.
    pub body: String,
    /// Place in the first picture, to a few pixels: to the right and down from its top left.
    pub pixel: [f64; 2],
    /// Its place on the body, x along it and y to the left, from the point whose motion is wanted \[mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_mm: Option<[f64; 2]>,
}

/// Whether a body may be called so.
fn is_name(body: &str) -> bool {
    (1..=60).contains(&body.chars().count()) && !body.contains(char::is_control)
}

impl Layout {
    /// Reads the text of a layout.
    ///
    /// # Errors
    ///
    /// The fault, with its line.
    pub fn parse(text: &str) -> Result<Self, String> {
        let layout: Self = toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start.min(text.len())].matches('\n').count());
            let told: String = error.message().chars().filter(|c| !c.is_control()).take(200).collect();
            said!("layout-line", "line" => line, "what" => told)
        })?;
        layout.fault().map_or(Ok(()), Err)?;
        Ok(layout)
    }

    /// Fault by which nothing can be measured.
    fn fault(&self) -> Option<String> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        let places = self.mark.iter().flat_map(|mark| mark.pixel.into_iter().chain(mark.at_mm.into_iter().flatten()));
        match () {
            () if !positive(self.fps) => Some(said!("layout-fps", "fps" => self.fps.to_string())),
            () if !self.from_s.is_finite() => Some(said!("layout-from", "from" => self.from_s.to_string())),
            () if self.mm_per_pixel.is_some_and(|scale| !positive(scale)) => Some(Text::new("layout-scale").into()),
            () if self.mark.len() > MOST_MARKS => {
                Some(said!("layout-many", "count" => self.mark.len(), "most" => MOST_MARKS))
            }
            () if self.mark.iter().any(|mark| !is_name(&mark.body)) => Some(Text::new("layout-body").into()),
            () if self.mark.is_empty() => Some(Text::new("layout-none").into()),
            () if places.into_iter().any(|value| !value.is_finite()) => Some(Text::new("layout-finite").into()),
            () if self.bodies().is_empty() => Some(said!("layout-table", "table" => TABLE)),
            () => None,
        }
    }

    /// Bodies but the table, in the order of the file.
    pub fn bodies(&self) -> Vec<&str> {
        let mut seen = BTreeSet::new();
        let names = self.mark.iter().map(|mark| mark.body.as_str());
        names.filter(|name| *name != TABLE && seen.insert(*name)).collect()
    }

    /// Numbers of the marks of a body.
    pub fn of(&self, body: &str) -> Vec<usize> {
        (0..self.mark.len()).filter(|n| self.mark[*n].body == body).collect()
    }

    /// A layout of one body with every mark of a picture, where nothing is known of them.
    pub fn unknown(fps: f64, mm_per_pixel: Option<f64>, marks: impl Iterator<Item = [f64; 2]>) -> Self {
        let mark = marks.map(|pixel| MarkPlace { body: "marks".to_owned(), pixel, at_mm: None }).collect();
        Self { fps, from_s: 0.0, pictures: None, mm_per_pixel, mark }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"
fps = 30.0
[[mark]]
body = "table"
pixel = [100.0, 400.0]
at_mm = [-76.0, -60.0]
[[mark]]
body = "deck"
pixel = [300.0, 200.0]
"#;

    #[test]
    fn a_layout_is_read_as_it_is_written() {
        let layout = Layout::parse(TEXT).expect("sound");
        assert_eq!((layout.bodies(), layout.of(TABLE), layout.of("deck")), (vec!["deck"], vec![0], vec![1]), "bodies");
        let again = toml::to_string(&layout).expect("written");
        assert_eq!(Layout::parse(&again).as_ref(), Ok(&layout), "{again}");
    }

    #[test]
    fn what_cannot_be_measured_is_told() {
        for (change, words) in [
            (("fps = 30.0", "fps = 0.0"), "pictures a second"),
            (("fps = 30.0", "fps = 30.0\nmm = 2"), "line 3: unknown field `mm`"),
            (("\"deck\"", "\"table\""), "every mark is on the table"),
            (("[300.0, 200.0]", "[nan, 200.0]"), "finite"),
            (("[300.0, 200.0]", "[300.0]"), "line 9"),
            (("fps = 30.0", "fps = 30.0\nmm_per_pixel = -1.0"), "above 0"),
        ] {
            let error = Layout::parse(&TEXT.replace(change.0, change.1)).expect_err(words);
            assert!(error.contains(words), "{error}");
        }
        assert!(Layout::parse("fps = 30.0").expect_err("none").contains("no marks"), "no marks");
    }
}
