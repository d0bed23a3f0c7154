//! Girders, abutments and bearings as solids with crisp edges, and the ground under them.

use glam::DVec3;

use super::bearings;
use super::block::{Block, abutment_block, moved_girder_block};
use super::hiding::solidity;
use super::list::{Ground, Line, Rgba, Solid};
use super::moment::Moment;
use super::palette::{KEPT, Palette, SELECTED};
use super::scale::round_down;
use super::{Bounds, MOST_KEPT, Target, ViewInput, bent, decoration, exaggerated, piers, seats, walls};
use crate::scene::Scene;
use crate::sim::Motion;

/// Height of a bearing pad, as a share of the girder's thickness, where no abutment says where the ground is.
const PAD_HEIGHT: f64 = 0.8;

/// Dashes of a ghost's edge.
const DASHES: u32 = 12;

/// Share of each dash that is drawn, for every ghost of another run.
const KEPT_DASHES: [f64; MOST_KEPT] = [0.8, 0.6, 0.4, 0.2];

/// Bodies and the lines along their edges.
#[derive(Debug, Default)]
pub(super) struct Bodies {
    pub(super) solids: Vec<Solid>,
    pub(super) ghosts: Vec<Solid>,
    pub(super) lines: Vec<Line>,
    pub(super) outline: Vec<Line>,
}

/// Level of the ground: at the foot of the abutments and of the piers, and below every girder \[m\].
pub(super) fn ground_level(scene: &Scene) -> f64 {
    let walls = scene.abutments.iter().filter_map(|a| abutment_block(scene, a)).flat_map(|b| b.corners());
    let girders = scene.girders.iter().map(|g| g.position[2] - g.thickness * (0.5 + PAD_HEIGHT));
    let piers = (0..scene.piers.len()).map(|number| piers::foot(&scene.pier(number)));
    let lowest = walls.map(|p| p.z).chain(girders).chain(piers).filter(|z| z.is_finite()).fold(f64::INFINITY, f64::min);
    if lowest.is_finite() { lowest } else { 0.0 }
}

/// The ground under a scene; `grid` asks for its lines.
pub(super) fn ground(scene: &Scene, bounds: Bounds, palette: &Palette, grid: bool) -> Ground {
    let centre = bounds.centre().with_z(ground_level(scene));
    let radius = 2.2 * bounds.radius();
    Ground {
        centre: centre.as_vec3(),
        radius: radius as f32,
        spacing: grid.then(|| grid_spacing(bounds) as f32),
        grid: palette.grid,
        shadow: palette.shadow,
    }
}

/// A round spacing that puts eight to twenty lines across the scene \[m\].
pub(super) fn grid_spacing(bounds: Bounds) -> f64 {
    round_down(2.0 * bounds.radius() / 8.0)
}

/// Every body of the scene at a moment.
pub(super) fn bodies(input: &ViewInput<'_>, moment: &Moment, palette: &Palette) -> Bodies {
    let mut out = Bodies::default();
    let level = ground_level(input.scene);
    let girders: Vec<_> =
        input.scene.girders.iter().zip(&moment.motions).map(|(g, m)| moved_girder_block(g, m)).collect();
    for (i, abutment) in input.scene.abutments.iter().enumerate() {
        if let Some(block) = walls::block(input.scene, i, moment.wall(i)) {
            let block = if moment.piers.is_empty() { block } else { piers::to_the_ground(&block, level) };
            let solid = solidity(&block, &girders, input.camera);
            let whole = moment.wall(i).is_none_or(|wall| wall.soil.is_none());
            out.add_abutment(
                input,
                (i, &block, whole),
                [palette.abutment, palette.soil].map(|c| c.fainter(solid)),
                palette,
            );
        }
        if let Some(soil) = moment.wall(i).and_then(|wall| walls::soil(input.scene, i, wall)) {
            let color = palette.soil.fainter(solidity(&soil, &girders, input.camera));
            out.add(input, &soil, &format!("{} soil", abutment.name), color, palette.edge, false);
            out.lines.extend(walls::failure_lines(input, &soil, palette));
        }
    }
    out.add_piers(input, moment, palette);
    for (i, (girder, motion)) in input.scene.girders.iter().zip(&moment.motions).enumerate() {
        for seat in seats::blocks(input.scene, girder, (seats::are_shown(input), level)) {
            out.add(input, &seat, &format!("{} seat", girder.name), palette.abutment, palette.edge, false);
        }
        if input.overlays.bearings {
            let pads = bearings::pads(input, (i, girder), (motion, moment), (level, palette));
            for (k, (pad, color)) in pads.iter().enumerate() {
                out.add(input, pad, &format!("{} bearing {}", girder.name, k + 1), *color, palette.edge, false);
            }
        }
        out.add_girder(input, (i, &girders[i], motion), palette);
    }
    for (girder, motion) in input.scene.girders.iter().zip(&moment.ghosts) {
        out.add_ghost(input, &moved_girder_block(girder, motion), palette.ghost, 0.55);
    }
    for &(history, number) in input.kept {
        let number = number % MOST_KEPT;
        let t = if input.t.is_finite() { input.t.clamp(0.0, history.end()) } else { 0.0 };
        for (i, girder) in history.scene().girders.iter().enumerate() {
            let motion = history.motion(i, t);
            let motion = if input.is_exaggerated() {
                exaggerated::motion(&history.model().bodies[i], &motion, input.exaggeration)
            } else {
                motion
            };
            let block = moved_girder_block(girder, &motion);
            out.add_ghost(input, &block, KEPT[number], KEPT_DASHES[number]);
        }
    }
    out
}

impl Bodies {
    /// Piers: footings, columns, caps.
    fn add_piers(&mut self, input: &ViewInput<'_>, moment: &Moment, palette: &Palette) {
        for (i, (placed, pier)) in input.scene.piers.iter().zip(&moment.piers).enumerate() {
            let selected = input.selected.contains(&Target::Pier(i));
            let name = |part: &str| format!("{} {part}", placed.name);
            for footing in pier.footings() {
                self.add(input, &footing, &name("footing"), palette.abutment, palette.edge, false);
            }
            let (strips, lines) = pier.columns();
            self.solids.extend(strips.iter().map(|strip| solid(strip, &name("column"), palette.abutment)));
            self.add_edges(input, lines, palette.edge);
            self.add(input, &pier.cap(), &placed.name, palette.abutment, palette.edge, selected);
        }
    }

    /// A girder: in slices where its bend is shown, as the bridge deck that it is, or as its block.
    fn add_girder(&mut self, input: &ViewInput<'_>, (i, block, motion): (usize, &Block, &Motion), palette: &Palette) {
        let girder = &input.scene.girders[i];
        let selected = input.selected.contains(&Target::Girder(i));
        if let Some(slices) = bent::slices(input, (i, girder, motion), palette, selected) {
            self.solids.extend(slices.solids);
            self.lines.extend(slices.edges);
            self.outline.extend(slices.outline);
            return;
        }
        if !(input.overlays.decoration && decoration::is_bridge(girder)) {
            self.add(input, block, &girder.name, palette.girder, palette.edge, selected);
            return;
        }
        for part in decoration::deck(girder, motion) {
            self.solids.push(solid(&part.block, &girder.name, palette.girder));
            self.add_edges(input, part.edges, palette.edge);
        }
        for parapet in decoration::parapets(girder, motion) {
            self.add(input, &parapet, &format!("{} parapet", girder.name), palette.girder, palette.edge, false);
        }
        if selected {
            self.select(input, block);
        }
    }

    /// An abutment: its block, or what fills it; one whose wall moves has its soil by itself.
    fn add_abutment(
        &mut self,
        input: &ViewInput<'_>,
        (i, block, whole): (usize, &Block, bool),
        [concrete, soil]: [Rgba; 2],
        palette: &Palette,
    ) {
        let name = &input.scene.abutments[i].name;
        let selected = input.selected.contains(&Target::Abutment(i));
        if !(input.overlays.decoration && whole && decoration::has_bridge(input.scene)) {
            self.add(input, block, name, concrete, palette.edge, selected);
            return;
        }
        let parts = decoration::abutment(block);
        self.add(input, &parts.fill, &format!("{name} embankment"), soil, palette.edge, false);
        for wing in &parts.wings {
            self.add(input, wing, &format!("{name} wing wall"), concrete, palette.edge, false);
        }
        self.add(input, &parts.backwall, name, concrete, palette.edge, false);
        if selected {
            self.select(input, block);
        }
    }

    fn select(&mut self, input: &ViewInput<'_>, block: &Block) {
        let width = 2.6 * input.pixels_per_point;
        let line = |[from, to]: [DVec3; 2]| Line {
            group: "selection",
            from: from.as_vec3(),
            to: to.as_vec3(),
            width,
            color: SELECTED,
        };
        self.outline.extend(block.edges().map(line));
    }

    /// A girder by the other model: dashed edges seen through everything. A fill would fight with the girder's own faces.
    /// `drawn` is the share of each dash that is drawn.
    fn add_ghost(&mut self, input: &ViewInput<'_>, block: &Block, color: Rgba, drawn: f64) {
        let width = 1.8 * input.pixels_per_point;
        for [from, to] in block.edges() {
            for dash in 0..DASHES {
                let at = |part: f64| from.lerp(to, (f64::from(dash) + part) / f64::from(DASHES)).as_vec3();
                self.outline.push(Line { group: "ghost", from: at(0.0), to: at(drawn), width, color });
            }
        }
    }

    fn add(&mut self, input: &ViewInput<'_>, block: &Block, name: &str, color: Rgba, edge: Rgba, selected: bool) {
        let list = if color.0[3] == 0xff { &mut self.solids } else { &mut self.ghosts };
        list.push(solid(block, name, color));
        self.add_edges(input, block.edges(), edge);
        if selected {
            self.select(input, block);
        }
    }

    fn add_edges(&mut self, input: &ViewInput<'_>, edges: impl IntoIterator<Item = [DVec3; 2]>, color: Rgba) {
        let width = 1.3 * input.pixels_per_point;
        let line =
            |[from, to]: [DVec3; 2]| Line { group: "edges", from: from.as_vec3(), to: to.as_vec3(), width, color };
        self.lines.extend(edges.into_iter().map(line));
    }
}

fn solid(block: &Block, name: &str, color: Rgba) -> Solid {
    Solid { name: name.to_owned(), face: block.face.map(DVec3::as_vec3), sweep: block.sweep.as_vec3(), color }
}
