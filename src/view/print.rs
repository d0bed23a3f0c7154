//! A draw list as text, for tests: rounded well above the last bits.

use std::fmt::{Display, Formatter, Result};

use glam::{Vec2, Vec3};

use super::list::{Arrow, Cone, DrawList, Ground, Line, Mark, Rgba, Solid};

/// A length to four decimals, without a negative zero.
fn number(v: f32) -> String {
    let text = format!("{v:.4}");
    if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') { "0.0000".to_owned() } else { text }
}

fn point(p: Vec3) -> String {
    format!("({} {} {})", number(p.x), number(p.y), number(p.z))
}

fn pixel(p: Vec2) -> String {
    format!("({:.0} {:.0})", p.x + 0.0, p.y + 0.0)
}

impl Display for Rgba {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let [r, g, b, a] = self.0;
        write!(f, "#{r:02x}{g:02x}{b:02x}")?;
        if a == 0xff { Ok(()) } else { write!(f, "{a:02x}") }
    }
}

impl Display for Ground {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "ground at {} to {}", point(self.centre), number(self.radius))?;
        self.spacing.map_or(Ok(()), |s| write!(f, ", grid {}", number(s)))
    }
}

impl Display for Solid {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let [a, b, c, d] = self.face.map(point);
        write!(f, "solid {}: face {a} {b} {c} {d} sweep {} {}", self.name, point(self.sweep), self.color)
    }
}

impl Display for Cone {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(
            f,
            "cone of contact {}: apex {} axis {} height {} outline {} filled {} {}",
            self.contact,
            point(self.apex),
            point(self.axis),
            number(self.height),
            number(self.mu_static),
            number(self.mu_kinetic),
            self.color
        )
    }
}

impl Display for Arrow {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (from, to) = (point(self.from), point(self.to));
        write!(f, "arrow of contact {}: {:?} {from} to {to} {}", self.contact, self.kind, self.color)
    }
}

impl Display for Mark {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Text { at, text, color, .. } => write!(f, "text {} {text:?} {color}", pixel(*at)),
            Self::Disk { at, color, .. } => write!(f, "disk {} {color}", pixel(*at)),
            Self::Ring { at, color, .. } => write!(f, "ring {} {color}", pixel(*at)),
            Self::Cross { at, color, .. } => write!(f, "cross {} {color}", pixel(*at)),
            Self::Stroke { points, color, .. } => write!(f, "stroke of {} points {color}", points.len()),
            Self::Fill { points, color } => write!(f, "fill of {} corners {color}", points.len()),
            Self::Panel { min, max, color, .. } => write!(f, "panel {} to {} {color}", pixel(*min), pixel(*max)),
        }
    }
}

/// Lines by group: how many, and the box about them.
fn write_lines(f: &mut Formatter<'_>, kind: &str, lines: &[Line]) -> Result {
    let mut rest = lines;
    while let Some(first) = rest.first() {
        let count = rest.iter().take_while(|l| l.group == first.group && l.color == first.color).count();
        let ends = rest[..count].iter().flat_map(|l| [l.from, l.to]);
        let (min, max) = ends.fold((first.from, first.from), |(lo, hi), p| (lo.min(p), hi.max(p)));
        writeln!(f, "{count} {kind} of {}: {} to {} {}", first.group, point(min), point(max), first.color)?;
        rest = &rest[count..];
    }
    Ok(())
}

impl Display for DrawList {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "picture {} x {}", self.size[0], self.size[1])?;
        writeln!(f, "background {} to {}", self.frame.sky, self.frame.floor)?;
        self.ground.iter().try_for_each(|g| writeln!(f, "{g}"))?;
        self.solids.iter().try_for_each(|s| writeln!(f, "{s}"))?;
        self.ghosts.iter().try_for_each(|s| writeln!(f, "ghost of {s}"))?;
        write_lines(f, "lines", &self.lines)?;
        write_lines(f, "lines seen through bodies", &self.xray_lines)?;
        self.cones.iter().try_for_each(|c| writeln!(f, "{c}"))?;
        self.arrows.iter().try_for_each(|a| writeln!(f, "{a}"))?;
        self.marks.iter().try_for_each(|m| writeln!(f, "{m}"))
    }
}
