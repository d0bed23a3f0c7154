//! Pictures of a sweep: a heat map over two keys of numbers, a line over one; other keys make panels or lines of their own.

use super::axis::Axis;
use super::dataset::Dataset;
use super::measure::Measure;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::plot::heat_map::{HeatMap, Map, Steps};
use crate::plot::{COLORS, Colors};

/// Most panels of a heat map, and most lines of a chart: as many as there are colours.
const MOST: usize = COLORS.len();

/// An axis of a picture.
struct Drawn<'a> {
    /// Its place among the keys.
    place: usize,
    axis: &'a Axis,
    /// Its values, growing, each with its number on the axis.
    values: Vec<(f64, usize)>,
}

impl Drawn<'_> {
    /// A value as it is drawn on an axis that is even: equal ratios by their logarithm.
    fn scaled(&self, value: f64) -> f64 {
        if self.axis.is_log { value.signum() * value.abs().log10() } else { value }
    }

    /// Place of a value, in steps from the first; `None` outside.
    fn step_of(&self, value: f64) -> Option<f64> {
        if self.axis.is_log && value * self.values[0].0 <= 0.0 {
            return None;
        }
        let at = |i: usize| self.scaled(self.values[i].0);
        let value = self.scaled(value);
        let before = (0..self.values.len()).rfind(|&i| at(i) <= value)?;
        if before + 1 == self.values.len() {
            return (at(before) == value).then_some(before as f64);
        }
        Some(before as f64 + (value - at(before)) / (at(before + 1) - at(before)))
    }
}

impl Dataset<'_> {
    /// Names and SVG documents of its pictures, one a measure that any run has; none where no key is a number.
    ///
    /// # Errors
    ///
    /// The reason why there are none, in words.
    pub fn pictures(&self) -> Result<Vec<(String, String)>, String> {
        let drawn: Vec<Drawn<'_>> = self.plan.axes.iter().enumerate().filter_map(drawn).take(2).collect();
        if drawn.is_empty() {
            return Err("no picture: no key has two numbers".to_owned());
        }
        let others = self.others(&drawn);
        if others.len() > MOST {
            return Err(format!(
                "no picture: {} panels or more, {MOST} at most: the first two keys are its axes, name those of most values first",
                others.len()
            ));
        }
        let any = |place: usize| self.rows.values().any(|row| row.values[place].is_some());
        let measures = self.plan.measures.iter().enumerate().filter(|(place, _)| any(*place));
        let svg = |(place, measure): (usize, &&'static Measure)| {
            let svg = match drawn.as_slice() {
                [x, y] => self.heat_map([x, y], &others, (place, measure)).to_svg(),
                _ => self.chart(&drawn[0], &others, (place, measure)).to_svg(),
            };
            (measure.name.to_owned(), svg)
        };
        Ok(measures.map(svg).collect())
    }

    /// Every choice of values of the keys that are no axis of the picture; 0 of those that are.
    fn others(&self, drawn: &[Drawn<'_>]) -> Vec<Vec<usize>> {
        let is_drawn = |place| drawn.iter().any(|axis| axis.place == place);
        let mut choices = vec![Vec::new()];
        for (place, axis) in self.plan.axes.iter().enumerate() {
            let count = if is_drawn(place) { 1 } else { axis.values.len() };
            // Of more than can be drawn it is enough to see that there are more.
            let more = |choice: Vec<usize>| (0..count).map(move |value| [choice.as_slice(), &[value]].concat());
            choices = choices.into_iter().flat_map(more).take(MOST + 1).collect();
        }
        choices
    }

    /// `key = value` of the keys that are no axis of the picture.
    fn label(&self, choice: &[usize], drawn: &[&Drawn<'_>]) -> String {
        let is_drawn = |place| drawn.iter().any(|axis| axis.place == place);
        let axes = self.plan.axes.iter().enumerate().filter(|(place, _)| !is_drawn(*place));
        let words: Vec<String> =
            axes.map(|(place, axis)| format!("{} = {}", axis.key, axis.values[choice[place]])).collect();
        words.join(", ")
    }

    /// The value of a measure in the unit of pictures.
    fn value(&self, choice: &[usize], (place, measure): (usize, &Measure)) -> Option<f64> {
        Some(self.rows.get(&self.plan.run_of(choice))?.values[place]? * measure.drawn.1)
    }

    fn heat_map(&self, axes: [&Drawn<'_>; 2], others: &[Vec<usize>], measure: (usize, &Measure)) -> HeatMap {
        let [x, y] = axes;
        let steps = |axis: &Drawn<'_>| Steps {
            name: axis.axis.key.clone(),
            values: axis.values.iter().map(|(value, _)| *value).collect(),
            mark: self.plan.own(axis.axis).and_then(|own| axis.step_of(own)),
        };
        let map = |other: &Vec<usize>| {
            let cells = y.values.iter().flat_map(|row| x.values.iter().map(move |column| (column.1, row.1)));
            let value = |(column, row)| {
                let mut choice = other.clone();
                (choice[x.place], choice[y.place]) = (column, row);
                self.value(&choice, measure)
            };
            Map { name: self.label(other, &axes), values: cells.map(value).collect() }
        };
        HeatMap {
            title: title(measure.1),
            subtitle: self.subtitle(),
            x: steps(x),
            y: steps(y),
            bar: measure.1.title(),
            colors: Colors::default(),
            maps: others.iter().map(map).collect(),
        }
    }

    fn chart(&self, x: &Drawn<'_>, others: &[Vec<usize>], measure: (usize, &Measure)) -> Chart {
        let curve = |(number, other): (usize, &Vec<usize>)| {
            let point = |&(value, number): &(f64, usize)| {
                let mut choice = other.clone();
                choice[x.place] = number;
                [x.scaled(value), self.value(&choice, measure).unwrap_or(f64::NAN)]
            };
            let label = self.label(other, &[x]);
            let name = if label.is_empty() { self.plan.scene.name.clone() } else { label };
            Curve {
                name,
                color: COLORS[number % COLORS.len()].to_owned(),
                dashes: "none",
                points: x.values.iter().map(point).collect(),
            }
        };
        let mut curves: Vec<Curve> = others.iter().enumerate().map(curve).collect();
        curves.extend(self.own_line(x, &curves));
        let subtitle = self.subtitle();
        Chart {
            title: format!("{}: {subtitle}", title(measure.1)),
            x: if x.axis.is_log { format!("log10 of {}", x.axis.key) } else { x.axis.key.clone() },
            panels: vec![Panel { name: measure.1.title(), curves }],
        }
    }

    /// A line where the scene itself is, from the lowest to the highest point.
    fn own_line(&self, x: &Drawn<'_>, curves: &[Curve]) -> Option<Curve> {
        let own = self.plan.own(x.axis).filter(|own| x.step_of(*own).is_some())?;
        let heights = || curves.iter().flat_map(|curve| &curve.points).map(|point| point[1]).filter(|y| y.is_finite());
        let (low, high) = (heights().reduce(f64::min)?, heights().reduce(f64::max)?);
        let points = vec![[x.scaled(own), low], [x.scaled(own), high]];
        Some(Curve { name: "the scene".to_owned(), color: "#6b6b6b".to_owned(), dashes: "5 4", points })
    }

    fn subtitle(&self) -> String {
        format!("{}, {} s", self.plan.scene.name, self.plan.scene.duration)
    }
}

/// Meaning of a measure up to the first comma or semicolon.
fn title(measure: &Measure) -> String {
    measure.meaning.split([';', ',']).next().unwrap_or_default().to_owned()
}

/// A key as an axis, where it has two numbers at least.
fn drawn((place, axis): (usize, &Axis)) -> Option<Drawn<'_>> {
    let numbers = axis.numbers().filter(|numbers| numbers.len() > 1)?;
    let mut values: Vec<(f64, usize)> = numbers.into_iter().zip(0..).collect();
    values.sort_by(|a, b| a.0.total_cmp(&b.0));
    Some(Drawn { place, axis, values })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::scene::presets;
    use crate::study::sweep::{Plan, Row, Status};

    /// Runs whose first measure is their own number.
    fn pictures(vary: &[&str]) -> Result<Vec<(String, String)>, String> {
        let texts = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
        let scene = presets::load("skew45-abutment").expect("ships");
        let measures = texts(&["max_force", "max_impulse"]);
        let plan = Plan::new(scene, &texts(vary), &measures, Box::new(|_| Ok(()))).expect("a plan");
        let row = |run: usize| {
            let values = vec![Some(run as f64), None];
            (run, Row { run, status: Status::Complete, values, reason: String::new() })
        };
        let rows: BTreeMap<usize, Row> = (0..plan.runs()).map(row).collect();
        Dataset { plan: &plan, rows: &rows }.pictures()
    }

    /// The one picture that there is.
    fn picture(vary: &[&str]) -> String {
        let all = pictures(vary).expect("drawn");
        assert_eq!(
            all.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(),
            ["max_force"],
            "no run has the other"
        );
        all.into_iter().next().expect("one").1
    }

    #[test]
    fn two_keys_of_numbers_are_a_map_and_others_its_panels() {
        let svg = picture(&["contact.law=paper,return-mapping", "girder.deck.skew_deg=30,60", "motion.angle_deg=0,90"]);
        assert!(svg.contains("contact.law = paper") && svg.contains("contact.law = return-mapping"), "a panel each");
        // Run 0 is the lowest value: 30° and 0°, in the lower left corner; run 7 the highest: 60° and 90° of the second panel.
        let [first, second] = svg.split("</g>").collect::<Vec<_>>()[..2] else { panic!("two panels") };
        assert!(first.contains(r##"fill="#440154" d="M0 0h1v1h-1z""##), "{first}");
        assert!(second.contains(r##"fill="#fde725" d="M1 1h1v1h-1z""##), "{second}");
        assert!(svg.contains("the scene"), "45° and 0° are inside");
    }

    #[test]
    fn one_key_of_numbers_is_a_line_and_others_more_of_them() {
        let svg = picture(&["contact.law=paper,return-mapping", "motion.frequency_hz=1..100:3:log"]);
        assert_eq!(svg.matches("<polyline").count(), 3, "a line a law, and where the scene is");
        assert!(svg.contains("log10 of motion.frequency_hz") && svg.contains("contact.law = paper"), "{svg}");
    }

    #[test]
    fn what_cannot_be_drawn_is_told() {
        let none = pictures(&["contact.law=paper,return-mapping"]).expect_err("words alone");
        assert!(none.contains("no key has two numbers"), "{none}");
        let many = ["girder.deck.skew_deg=30,60", "motion.angle_deg=0,90", "motion.phase_deg=0..90:7"];
        let many = pictures(&many).expect_err("seven panels");
        assert!(many.contains("7 panels or more, 6 at most: the first two keys"), "{many}");
    }

    #[test]
    fn the_scene_is_between_its_neighbours() {
        let axis = Axis::parse("a=10..1000:3:log").expect("an axis");
        let drawn = drawn((0, &axis)).expect("numbers");
        assert_eq!([10.0, 100.0, 1000.0].map(|own| drawn.step_of(own)), [Some(0.0), Some(1.0), Some(2.0)], "on them");
        assert!(drawn.step_of(31.6).is_some_and(|step| (step - 0.5).abs() < 1e-3), "between");
        assert_eq!([9.0, 1001.0, -100.0, 0.0].map(|own| drawn.step_of(own)), [None; 4], "outside");
    }
}
