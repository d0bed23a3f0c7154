//! The scene in plan as SVG, as placed with its dimensions or at a time with the forces of its contacts.

use std::fmt::Write as _;

use glam::DVec2;

use super::units::{force, forces};
use crate::geometry::{End, Prism};
use crate::language::{Text, said};
use crate::plot::draw::{escape, line, text};
use crate::plot::paper::{DECK, EDGE, GREY, INK, PLACED, WHITE};
use crate::scene::facing::Side;
use crate::scene::placed::{abutment_depth, abutment_face};
use crate::scene::{Abutment, Scene};
use crate::sim::{ContactNow, ContactState, History, Touch};

const WIDTH: f64 = 900.0;
const MARGIN: f64 = 46.0;
const FORCE: &str = "#D55E00";
const DEVICE: &str = "#882255";
/// Longest arrow of a force \[pixels\].
const ARROW: f64 = 90.0;
/// Width of a digit of the size of a force, of a sans-serif face \[pixels\].
const WIDTH_OF_DIGIT: f64 = 6.4;
/// Length of the edge between two corners that their numbers take \[pixels\].
const NUMBERS: f64 = 40.0;
/// Distance of two lines of dimensions \[pixels\].
const LINE: f64 = 13.0;
/// Half height of the plan around a hit that is drawn large, in widths of the girder; half its width is twice that (chosen).
const CLOSE: f64 = 0.02;

/// A plan to be drawn.
pub(super) struct Plan<'a> {
    history: &'a History,
    /// The time, with the forces in play; none as placed.
    at: Option<(f64, Vec<ContactNow>)>,
    /// The part that is drawn: lower left and upper right corner \[m\].
    window: [DVec2; 2],
    /// Whether dimensions are written.
    dimensions: bool,
}

/// Caption of the plan as placed.
pub(super) fn caption(history: &History) -> String {
    let model = history.model();
    let facing = model.pairs.iter().any(|pair| !pair.met);
    let parts = [
        (true, "report-plan-placed"),
        (facing, "report-plan-gaps"),
        (!model.piers.is_empty(), "report-plan-piers"),
        (
            model.devices.iter().any(|device| history.connections().link(device.links.start, 0.0).is_some()),
            "report-plan-devices",
        ),
    ];
    parts.into_iter().filter(|(shown, _)| *shown).map(|(_, name)| Text::new(name).as_str().to_owned()).collect()
}

/// Hardest hit: what it is, and pictures with their captions.
pub(super) fn hardest(history: &History) -> Option<(String, Vec<(String, String)>)> {
    let touch = history.hits().hardest()?;
    let (t, now) = (touch.peak_time, history.contacts().contact_at(touch.contact, touch.peak_time));
    let site = history.model().sites.get(touch.contact)?;
    let force = if touch.peak_force > 0.0 {
        force(touch.peak_force)
    } else {
        said!("report-impulse", "impulse" => format!("{:.3e}", touch.impulse))
    };
    // An edge node is named by its edge: where on it the hit is, the nearest corner tells.
    let edge = site.edge.as_ref().and(site.node_body).zip(now.as_ref());
    let corner = edge.and_then(|(body, now)| nearest_corner(history, body, now.point.truncate(), t));
    let near = corner.map_or(String::new(), |number| said!("report-at-corner", "number" => number));
    let words = said!(
        "report-hit",
        "node" => site.node_in_words(),
        "near" => near,
        "face" => site.face_name.to_string(),
        "force" => force,
        "t" => format!("{t:.4}")
    );
    let words = [Some(words), now.as_ref().map(|now| in_contact(now, touch)), most_of_two(history)];
    let words = words.into_iter().flatten().collect::<Vec<_>>().join(" ");
    let mut pictures = vec![(said!("report-plan-at", "t" => format!("{t:.4}")), Plan::at(history, t).svg())];
    if let Some(now) = now {
        let width = site.node_body.map_or(1.0, |body| history.model().bodies[body].prism.width);
        let caption = said!("report-plan-close", "width" => format!("{:.3}", 4.0 * CLOSE * width));
        pictures.push((caption, Plan::close(history, t, now.point.truncate(), CLOSE * width).svg()));
    }
    Some((words, pictures))
}

/// Whether a contact sticks or slips, its forces without dashpots, how much of the friction is used, and how its touch went.
fn in_contact(now: &ContactNow, touch: &Touch) -> String {
    let state = match now.state {
        ContactState::Slip => Text::new("state-slip"),
        ContactState::Open | ContactState::Stick => Text::new("state-stick"),
    };
    let milliseconds = |seconds: f64| format!("{:.2}", 1e3 * seconds);
    let [normal, tangential] = forces([now.normal_force, now.tangential_force.length()]);
    said!(
        "report-hit-state",
        "state" => state.as_str(),
        "normal" => normal,
        "tangential" => tangential,
        "share" => format!("{:.0}", 100.0 * now.cone_use()),
        "stick" => milliseconds(touch.stick),
        "slip" => milliseconds(touch.slip)
    )
}

/// The largest force between two bodies, which another hit may have.
fn most_of_two(history: &History) -> Option<String> {
    let (of, most) = history.hits().hardest_pounding()?;
    let pair = history.model().pairs[of.pair].name.as_str();
    let t = format!("{:.4}", most.t);
    Some(said!("report-hit-total", "pair" => pair, "force" => force(most.value), "t" => t))
}

impl<'a> Plan<'a> {
    pub(super) fn as_placed(history: &'a History) -> Self {
        Self { history, at: None, window: window(history), dimensions: true }
    }

    fn at(history: &'a History, t: f64) -> Self {
        Self { at: Some((t, history.contacts().at(t))), dimensions: false, ..Self::as_placed(history) }
    }

    /// A rectangle about a point: this half height \[m\], twice as wide as high.
    fn close(history: &'a History, t: f64, centre: DVec2, half: f64) -> Self {
        Self {
            window: [centre - DVec2::new(2.0 * half, half), centre + DVec2::new(2.0 * half, half)],
            ..Self::at(history, t)
        }
    }

    /// Pixels a metre.
    fn scale(&self) -> f64 {
        (WIDTH - 2.0 * MARGIN) / (self.window[1].x - self.window[0].x).max(1e-9)
    }

    fn place(&self, p: DVec2) -> (f64, f64) {
        let scale = self.scale();
        (MARGIN + scale * (p.x - self.window[0].x), MARGIN + scale * (self.window[1].y - p.y))
    }

    fn polygon(&self, svg: &mut String, corners: &[DVec2], style: &str) {
        let points: Vec<String> = corners
            .iter()
            .map(|corner| {
                let (x, y) = self.place(*corner);
                format!("{x:.2},{y:.2}")
            })
            .collect();
        let _ = writeln!(svg, r#"<polygon points="{}" {style}/>"#, points.join(" "));
    }

    /// The document.
    pub(super) fn svg(&self) -> String {
        let height = 2.0 * MARGIN + self.scale() * (self.window[1].y - self.window[0].y);
        let mut svg = String::new();
        let _ = writeln!(
            svg,
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:.1}" width="{WIDTH}" height="{height:.1}" font-family="sans-serif"><rect width="{WIDTH}" height="{height:.1}" fill="{WHITE}"/>"#
        );
        let scene = self.history.scene();
        for abutment in &scene.abutments {
            if let Some(corners) = abutment_plan(scene, abutment) {
                self.polygon(&mut svg, &corners, &format!(r##"fill="#d9dce0" stroke="{GREY}""##));
            }
        }
        let girders = 0..self.history.model().girders().len();
        girders.clone().for_each(|girder| self.girder(&mut svg, girder));
        for pier in &self.history.model().piers {
            let cap = self.corners(pier.body);
            self.polygon(
                &mut svg,
                &cap,
                &format!(r#"fill="none" stroke="{INK}" stroke-width="1.3" stroke-dasharray="1.5 3""#),
            );
        }
        self.devices(&mut svg);
        let sizes = self.forces(&mut svg, height);
        // Texts lie above all that is drawn, with a rim in the colour of the paper.
        let _ =
            writeln!(svg, r#"<g paint-order="stroke" stroke="{WHITE}" stroke-width="2.5" stroke-linejoin="round">"#);
        if self.dimensions {
            girders.for_each(|girder| self.dimensions(&mut svg, girder));
            self.label_joints(&mut svg);
        }
        svg.push_str(&sizes);
        svg.push_str("</g>\n");
        self.scale_bar(&mut svg, height);
        svg.push_str("</svg>\n");
        svg
    }

    /// Corners of a body at the time of the plan.
    fn corners(&self, number: usize) -> [DVec2; 4] {
        self.at.as_ref().map_or_else(|| placed(self.history, number), |(t, _)| corners_at(self.history, number, *t))
    }

    fn girder(&self, svg: &mut String, number: usize) {
        let body = &self.history.model().bodies[number];
        let placed = placed(self.history, number);
        let solid = format!(r#"fill="{DECK}" fill-opacity="0.9" stroke="{INK}" stroke-width="1.3""#);
        self.polygon(svg, &self.corners(number), &solid);
        if self.at.is_some() {
            self.polygon(svg, &placed, &format!(r#"fill="none" stroke="{PLACED}" stroke-dasharray="4 3""#));
        } else {
            let home = self.history.motion(number, 0.0);
            for bearing in &body.bearings {
                let (x, y) = self.place((home.place - home.displacement + body.axes * bearing.place).truncate());
                let _ = writeln!(svg, r##"<circle cx="{x:.1}" cy="{y:.1}" r="3.2" fill="#0072B2"/>"##);
            }
        }
        for end in End::BOTH {
            self.front_edge(svg, number, end, &placed);
        }
    }

    /// Devices: a line from point to point, a square at each.
    fn devices(&self, svg: &mut String) {
        let t = self.at.as_ref().map_or(0.0, |(t, _)| *t);
        for link in self.history.model().devices.iter().flat_map(|device| device.links.clone()) {
            let Some(now) = self.history.connections().link(link, t) else { continue };
            let points: Vec<(f64, f64)> = now.line.iter().map(|point| self.place(point.truncate())).collect();
            for pair in points.windows(2) {
                line(svg, pair[0], pair[1], &format!(r#"stroke="{DEVICE}" stroke-width="2.2""#));
            }
            for (x, y) in now.ends.map(|end| self.place(end.truncate())) {
                let (left, top) = (x - 2.5, y - 2.5);
                let _ = writeln!(svg, r#"<rect x="{left:.1}" y="{top:.1}" width="5" height="5" fill="{DEVICE}"/>"#);
            }
        }
    }

    /// The front edge of the seat under an end, where there is one.
    fn front_edge(&self, svg: &mut String, number: usize, end: End, placed: &[DVec2; 4]) {
        let Some(ledge) = self.history.seats().ledge(number, end) else { return };
        let back = -ledge.normal.truncate() * ledge.placed();
        let [from, to] = Prism::end_corners(end).map(|corner| self.place(placed[corner] + back));
        line(svg, from, to, &format!(r#"stroke="{EDGE}" stroke-width="1.3" stroke-dasharray="6 3""#));
    }

    /// Name, length, width and skew of a girder as placed.
    fn dimensions(&self, svg: &mut String, number: usize) {
        let corners = placed(self.history, number);
        let girder = &self.history.scene().girders[number];
        let middle = |a: DVec2, b: DVec2| self.place(0.5 * (a + b));
        let (x, y) = middle(corners[0], corners[2]);
        text(svg, (x, y + 5.0), 15.0, "middle", INK, &escape(&girder.name));
        // Between the numbers of the corners, or beyond them where the edge is too short for both.
        let edge = self.scale() * corners[0].distance(corners[1]);
        let beyond =
            |words: &str| if WIDTH_OF_DIGIT * words.chars().count() as f64 + NUMBERS > edge { LINE } else { 0.0 };
        let (x, y) = middle(corners[0], corners[1]);
        let length = format!("a₀ = {} m", trimmed(girder.length));
        text(svg, (x, y + 17.0 + beyond(&length)), 12.0, "middle", INK, &length);
        let (x, y) = middle(corners[3], corners[2]);
        let width = format!("b₀ = {} m, β = {}°", trimmed(girder.width), trimmed(girder.skew_deg));
        text(svg, (x, y - 7.0 - beyond(&width)), 12.0, "middle", INK, &width);
        // Beside the girder and towards its middle: beyond its end is the neighbour.
        let along = (corners[1] - corners[0]).normalize_or_zero();
        let across = along.perp();
        for (number, corner) in corners.iter().enumerate() {
            let inward = if matches!(number, 0 | 3) { along } else { -along };
            let outward = if number < 2 { -across } else { across };
            let (x, y) = self.place(*corner + (9.0 / self.scale()) * (inward + outward));
            text(svg, (x, y + 4.0), 10.0, "middle", GREY, &(number + 1).to_string());
        }
    }

    /// Names of abutments and piers, and the gap at every joint.
    fn label_joints(&self, svg: &mut String) {
        let (scene, model) = (self.history.scene(), self.history.model());
        let gap = |gap: f64| format!("{} mm", trimmed(1e3 * gap));
        let facing = || model.pairs.iter().filter(|pair| !pair.met);
        for (number, abutment) in scene.abutments.iter().enumerate() {
            let Some(corners) = abutment_plan(scene, abutment) else { continue };
            let (x, y) = self.place(0.25 * (corners[0] + corners[1] + corners[2] + corners[3]));
            text(svg, (x.clamp(30.0, WIDTH - 30.0), y), 12.0, "middle", INK, &escape(&abutment.name));
            if let Some(pair) = facing().find(|pair| pair.second == Side::Abutment(number)) {
                text(svg, (x.clamp(30.0, WIDTH - 30.0), y + 15.0), 11.0, "middle", GREY, &gap(pair.gap));
            }
        }
        for pair in facing() {
            let (Side::Girder(first, end), Side::Girder(..)) = (pair.first, pair.second) else { continue };
            let corners = Prism::end_corners(end).map(|corner| placed(self.history, first)[corner]);
            let top = corners.into_iter().map(|corner| self.place(corner)).min_by(|a, b| a.1.total_cmp(&b.1));
            let (x, y) = top.unwrap_or_default();
            text(svg, (x, y - 22.0), 11.0, "middle", GREY, &gap(pair.gap));
        }
        for (pier, body) in scene.piers.iter().zip(&model.piers) {
            let corners = placed(self.history, body.body).map(|corner| self.place(corner));
            let low = corners.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
            let (x, y) = low.unwrap_or_default();
            text(svg, (x, y + 17.0), 12.0, "middle", INK, &escape(&pier.name));
        }
    }

    /// Draws the forces in play, and gives their sizes as texts, beside the tips and within the picture.
    fn forces(&self, svg: &mut String, height: f64) -> String {
        let (mut sizes, mut written) = (String::new(), Vec::<DVec2>::new());
        let Some((_, contacts)) = &self.at else { return sizes };
        let largest = contacts.iter().map(|now| now.force.truncate().length()).fold(0.0, f64::max);
        for now in contacts.iter().filter(|_| largest > 0.0) {
            let (x, y) = self.place(now.point.truncate());
            if !((0.0..=WIDTH).contains(&x) && (0.0..=height).contains(&y)) {
                continue;
            }
            let way = now.force.truncate() * (ARROW / largest);
            let style = format!(r#"stroke="{FORCE}" stroke-width="2.2""#);
            let (tip, unit) = ((x + way.x, y - way.y), way.normalize_or_zero());
            line(svg, (x, y), tip, &style);
            let barb = |side: f64| {
                let back = DVec2::from_angle(side).rotate(-unit) * 10.0;
                format!("{:.1},{:.1}", tip.0 + back.x, tip.1 - back.y)
            };
            let (left, right) = (barb(0.45), barb(-0.45));
            let _ = writeln!(svg, r#"<polygon points="{:.1},{:.1} {left} {right}" fill="{FORCE}"/>"#, tip.0, tip.1);
            let words = force(now.force.length());
            let wide = WIDTH_OF_DIGIT * words.chars().count() as f64;
            // Ahead of the tip, or before it where the picture ends.
            let ahead = if way.x < 0.0 { tip.0 - 7.0 - wide } else { tip.0 + 7.0 };
            let left = ahead.clamp(4.0, (WIDTH - 4.0 - wide).max(4.0));
            // Nodes of one corner, one above the other, have forces nearly alike.
            let mut y = (tip.1 - 5.0).clamp(12.0, height - 22.0);
            while let Some(line) = written.iter().copied().find(|at| at.distance(DVec2::new(left, y)) < 0.9 * LINE) {
                y = line.y + LINE;
            }
            written.push(DVec2::new(left, y));
            text(&mut sizes, (left, y), 11.0, "start", FORCE, &words);
        }
        sizes
    }

    /// A bar of a round length.
    fn scale_bar(&self, svg: &mut String, height: f64) {
        let span = 0.2 * (self.window[1].x - self.window[0].x);
        let power = 10f64.powf(span.log10().floor());
        let length = [5.0, 2.0, 1.0].into_iter().map(|m| m * power).find(|l| *l <= span).unwrap_or(power);
        let (left, y) = (MARGIN, height - 12.0);
        line(svg, (left, y), (left + length * self.scale(), y), &format!(r#"stroke="{INK}" stroke-width="2""#));
        text(svg, (left + length * self.scale() + 6.0, y + 4.0), 11.0, "start", INK, &format!("{} m", trimmed(length)));
    }
}

/// Corners of a girder in plan at a time.
fn corners_at(history: &History, number: usize, t: f64) -> [DVec2; 4] {
    let motion = history.motion(number, t);
    let corners = history.model().bodies[number].prism.plan_corners();
    corners.map(|c| (motion.place + motion.attitude * c.extend(0.0)).truncate())
}

/// Number in plan, from 1, of the corner of a girder that is nearest to a point.
fn nearest_corner(history: &History, number: usize, point: DVec2, t: f64) -> Option<usize> {
    let corners = corners_at(history, number, t);
    let distance = |corner: &(usize, DVec2)| corner.1.distance_squared(point);
    corners.into_iter().enumerate().min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|(corner, _)| corner + 1)
}

/// Corners of a girder in plan as placed.
fn placed(history: &History, number: usize) -> [DVec2; 4] {
    let body = &history.model().bodies[number];
    let home = history.motion(number, 0.0);
    let prism: &Prism = &body.prism;
    prism.plan_corners().map(|c| (home.place - home.displacement + body.axes * c.extend(0.0)).truncate())
}

/// An abutment in plan: its face, then the edge behind it.
fn abutment_plan(scene: &Scene, abutment: &Abutment) -> Option<[DVec2; 4]> {
    let [a, b, ..] = abutment_face(scene, abutment)?.map(glam::DVec3::truncate);
    let girder = scene.girders.iter().find(|girder| girder.name == abutment.faces)?;
    let from = DVec2::new(girder.position[0], girder.position[1]);
    let square = (b - a).perp().normalize_or_zero();
    let away = if square.dot(0.5 * (a + b) - from) < 0.0 { -square } else { square };
    // No farther than the girder is wide: what is drawn behind the face bears no load.
    let back = away * abutment_depth(scene, abutment).min(0.5 * girder.width);
    Some([a, b, b + back, a + back])
}

/// Box around every girder as placed and every abutment, with a margin \[m\].
fn window(history: &History) -> [DVec2; 2] {
    let scene = history.scene();
    let girders: Vec<DVec2> = (0..history.model().girders().len()).flat_map(|number| placed(history, number)).collect();
    let around = girders.iter().fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[a, b], p| [a.min(*p), b.max(*p)]);
    let air = 0.12 * (around[1].y - around[0].y);
    let walls = scene.abutments.iter().filter_map(|abutment| abutment_plan(scene, abutment)).flatten();
    // Walls may be far wider than the bridge: they are cut off beside it.
    let cut = |p: DVec2| DVec2::new(p.x, p.y.clamp(around[0].y - 2.0 * air, around[1].y + 2.0 * air));
    walls.map(cut).fold([around[0] - air, around[1] + air], |[a, b], p| [a.min(p), b.max(p)])
}

/// A number without needless zeros, six digits behind the point.
pub(super) fn trimmed(value: f64) -> String {
    let words = format!("{value:.6}");
    words.trim_end_matches('0').trim_end_matches('.').to_owned()
}
