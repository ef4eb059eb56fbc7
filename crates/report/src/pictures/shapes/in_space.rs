//! The deformed strip in space at points of its path, each in a parallel projection of its own, all to one scale.

use crate::chart::axis::{Axis, with_unit};
use crate::chart::canvas::Stroke;
use crate::chart::panel::{Face, Line, Mark, Note, Panel, Rim, Shape};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour, order_shade};
use crate::chart::symbol::Symbol;
use crate::pictures::curve::limit_at;
use crate::pictures::shapes::projection::{View, mixed};
use crate::states::surface::outline;
use peelkit::adhesion::SectionShape;
use peelkit::beam::SpatialSectionPlace;
use peelkit::model::{PeelModel, Space};
use peelkit::study::Peel;
use peelkit::units::{FORCES, LENGTHS, PreferredUnits};
use plotters::style::RGBColor;

/// The strip at one point of the path.
#[derive(Clone, Debug)]
pub(in crate::pictures) struct Posed {
    /// The number that the curve picture gives the same point.
    number: usize,
    /// nm
    displacement: f64,
    /// nN
    force: f64,
    /// Evenly along the strip
    sections: Vec<SpatialSectionPlace>,
}

/// Sections that are drawn.
const SECTIONS: usize = 41;
/// Panels side by side.
const COLUMNS: usize = 3;
/// Free around and between panels, and above each of them for its title, pixels.
const MARGIN: f64 = 14.0;
const TITLE: f64 = 28.0;
/// Upper edge of the first title, pixels.
const TOP: f64 = 34.0;
/// Height of a panel over its width, at least and at most.
const SLENDER: [f64; 2] = [0.6, 1.4];
/// Free around what is drawn, in parts of its size.
const FREE: f64 = 0.06;
/// The ground reaches beyond what stands over it by this part of the strip's length.
const BEYOND: f64 = 0.06;
/// About so long are the axes and the arrow of the pull, in lengths of the strip.
const ARROW: f64 = 0.25;
/// The ground reaches so many of these further on the side of the free end, where the axes stand.
const AXES: f64 = 1.5;
/// Their letters stand beyond their tips by this part of their length.
const LETTER: f64 = 0.4;
/// Lines over the seams between faces leave out this part of their length at either end, where edges are.
const INSET: f64 = 0.04;

/// The strip at the numbered points of a path in space.
pub(in crate::pictures) fn posed(peel: &Peel, numbered: &[usize]) -> Vec<Posed> {
    let largest = peel.points.iter().fold(0.0f64, |r, p| r.max(p.force.abs()));
    let one = |(n, &index): (usize, &usize)| {
        let point = peel.points.get(index)?;
        let at_limit = limit_at(peel, index).and_then(|at| Some((at, peel.places_at_limit_point(at, SECTIONS)?)));
        let (displacement, force, sections) = match at_limit {
            Some((limit, sections)) => (limit.displacement, limit.force, sections),
            None => (point.displacement, point.force, peel.places_in_space(index, SECTIONS)),
        };
        // a force that the path has brought to zero is printed as zero
        let force = if force.abs() > 1e-6 * largest { force } else { 0.0 };
        (sections.len() > 1).then_some(Posed { number: n + 1, displacement, force, sections })
    };
    numbered.iter().enumerate().filter_map(one).collect()
}

/// A panel for each of the poses.
pub(in crate::pictures) fn shapes_picture(
    poses: &[Posed],
    model: &PeelModel,
    space: &Space,
    heading: Heading,
) -> Picture {
    let Heading { title, units } = heading;
    let aside: f64 = poses.iter().flat_map(|posed| posed.sections.last()).map(|grip| grip.place[2]).sum();
    let scene = Scene {
        view: View::beside(if aside < 0.0 { -1.0 } else { 1.0 }),
        outline: space.section,
        rest: model.is_uniform().then(|| [model.length(), model.free_end().0]),
        arrow: round(ARROW * model.length()),
        pull: pull(model, space),
        ground: ground(poses, space.section, model),
    };
    let window = scene.window(poses);
    let (width, height) = (window[1] - window[0], window[3] - window[2]);
    let count = poses.len().clamp(1, COLUMNS);
    let wide = (f64::from(WIDTH) - MARGIN * (count as f64 + 1.0)) / count as f64;
    let wide = wide.min(2.0 * (f64::from(WIDTH) - MARGIN * 4.0) / 3.0);
    let high = wide * (height / width).clamp(SLENDER[0], SLENDER[1]);
    // nm a pixel, and what is then free to both sides
    let scale = (width / wide).max(height / high);
    let [right, up] = [0.5 * (scale * wide - width), 0.5 * (scale * high - height)];
    let panel = |(k, posed): (usize, &Posed)| {
        let (column, row) = ((k % COLUMNS) as f64, (k / COLUMNS) as f64);
        let left = 0.5 * (f64::from(WIDTH) - count as f64 * (wide + MARGIN) + MARGIN) + column * (wide + MARGIN);
        let top = TOP + TITLE + row * (high + MARGIN + TITLE);
        let frame = Frame { left, top, right: left + wide, bottom: top + high };
        let across = Axis::linear("", window[0] - right, window[1] + right);
        let upwards = Axis::linear("", window[2] - up, window[3] + up);
        scene.panel(posed, Panel::new(frame, across, upwards), order_shade(k, poses.len()), units)
    };
    let panels: Vec<Panel> = poses.iter().enumerate().map(panel).collect();
    let height = panels.last().map_or(0.0, |panel| panel.frame.bottom) + MARGIN;
    let (first, others) = title.split_once('\n').map_or((title, String::new()), |(a, b)| (a, format!("\n{b}")));
    let dashed = if scene.rest.is_some() { " Dashed: the strip at rest." } else { "" };
    let about = format!(
        "Parallel projection, all to one scale: the axes x, y and z are {} long.{dashed} Arrow: direction of the pull.",
        with_unit(units.fitting(LENGTHS, scene.arrow), scene.arrow, 2).replace(".0 ", " ")
    );
    Picture { title: format!("{first}\n{about}{others}"), height: height.round() as u32, panels }
}

/// The direction of the pull.
fn pull(model: &PeelModel, space: &Space) -> [f64; 3] {
    let (direction, (sin, cos)) = (model.pull.direction(), space.azimuth.sin_cos());
    [direction.along * cos, direction.up, direction.along * sin]
}

/// 1, 2 or 5 times a power of ten, next to a length.
fn round(length: f64) -> f64 {
    let decade = 10f64.powf(length.log10().floor());
    let off = |step: &f64| (step / length).ln().abs();
    [1.0, 2.0, 5.0, 10.0].map(|m| m * decade).into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(length)
}

/// Least and largest x, least and largest z of the ground that is drawn, nm.
fn ground(poses: &[Posed], outline: SectionShape, model: &PeelModel) -> [f64; 4] {
    let (length, width) = (model.length(), model.free_end().0);
    let mut ground = [0.0, length, -0.5 * width, 0.5 * width];
    for corner in poses.iter().flat_map(|posed| &posed.sections).flat_map(|section| self::outline(outline, section)) {
        ground[0] = ground[0].min(corner[0]);
        ground[1] = ground[1].max(corner[0]);
        ground[2] = ground[2].min(corner[2]);
        ground[3] = ground[3].max(corner[2]);
    }
    let beyond = BEYOND * length;
    [ground[0] - beyond - AXES * round(ARROW * length), ground[1] + beyond, ground[2] - beyond, ground[3] + beyond]
}

/// What all panels share.
struct Scene {
    view: View,
    outline: SectionShape,
    /// Length and width at rest of a beam that is the same all along, nm
    rest: Option<[f64; 2]>,
    /// Length of the axes and of the arrow of the pull, nm
    arrow: f64,
    /// Its direction
    pull: [f64; 3],
    /// Least and largest x, least and largest z, nm
    ground: [f64; 4],
}

impl Scene {
    /// Corners of a rectangle on the ground, projected.
    fn on_ground(&self, [x0, x1, z0, z1]: [f64; 4]) -> Vec<(f64, f64)> {
        [[x0, z0], [x1, z0], [x1, z1], [x0, z1]].map(|[x, z]| self.view.at([x, 0.0, z])).to_vec()
    }

    /// Where the axes stand: on the corner of the ground that is to the left.
    fn origin(&self) -> [f64; 3] {
        let [x0, _, z0, z1] = self.ground;
        [x0, 0.0, if self.view.at([0.0, 0.0, 1.0]).0 > 0.0 { z0 } else { z1 }]
    }

    /// Least and largest abscissa and ordinate of all that is drawn, nm in the projection.
    fn window(&self, poses: &[Posed]) -> [f64; 4] {
        let corners = |section: &SpatialSectionPlace| outline(self.outline, section);
        let mut points: Vec<(f64, f64)> = self.on_ground(self.ground);
        for posed in poses {
            points.extend(posed.sections.iter().flat_map(corners).map(|corner| self.view.at(corner)));
            points.extend(self.pulled(posed).map(|arrow| self.view.at(arrow[1])));
        }
        points.extend(self.axes().map(|(_, tip)| self.view.at(tip)));
        let (mut low, mut high) = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
        for (x, y) in points {
            low = (low.0.min(x), low.1.min(y));
            high = (high.0.max(x), high.1.max(y));
        }
        let free = FREE * (high.0 - low.0).max(high.1 - low.1);
        [low.0 - free, high.0 + free, low.1 - free, high.1 + free]
    }

    /// The arrow of the pull, from the grip on.
    fn pulled(&self, posed: &Posed) -> Option<[[f64; 3]; 2]> {
        let from = posed.sections.last()?.place;
        Some([from, std::array::from_fn(|i| from[i] + self.arrow * self.pull[i])])
    }

    /// Names and tips of the axes.
    fn axes(&self) -> [(char, [f64; 3]); 3] {
        let origin = self.origin();
        [('x', 0), ('y', 1), ('z', 2)].map(|(name, axis)| {
            let mut tip = origin;
            tip[axis] += self.arrow;
            (name, tip)
        })
    }

    fn panel(&self, posed: &Posed, mut panel: Panel, colour: RGBColor, units: PreferredUnits) -> Panel {
        panel.rim = Rim::Plain;
        let u = with_unit(units.fitting(LENGTHS, posed.displacement.abs()), posed.displacement, 4);
        let force = with_unit(units.fitting(FORCES, posed.force.abs()), posed.force, 4);
        panel.title = format!("u = {u}, P = {force}");
        panel.shapes.push(Shape { corners: self.on_ground(self.ground), colour: colour::PALE, opacity: 0.8 });
        if let Some([length, width]) = self.rest {
            let mut rest = self.on_ground([0.0, length, -0.5 * width, 0.5 * width]);
            rest.extend(rest.first().copied());
            panel.lines.push(Line { points: rest, stroke: Stroke::dashed(colour::GREY, 1.0), name: None });
        }
        for (name, tip) in self.axes() {
            let points = self.arrow_to(self.origin(), tip);
            panel.lines.push(Line { points, stroke: Stroke::solid(colour::INK, 1.0), name: None });
            let at = self.view.at(std::array::from_fn(|i| tip[i] + LETTER * (tip[i] - self.origin()[i])));
            let (symbol, colour) = (Symbol::Letter(name), colour::INK);
            panel.marks.push(Mark { at, symbol, colour, name: None, note: None });
        }
        panel.faces = self.faces(posed, colour);
        if let Some([from, to]) = self.pulled(posed) {
            let lines = vec![(self.arrow_to(from, to), Stroke::solid(colour::VERMILLION, 2.0))];
            let nothing = Shape { corners: vec![self.view.at(from); 3], colour, opacity: 0.0 };
            panel.faces.push(Face { shape: nothing, lines });
            let note = Some(Note { badge: Some(posed.number), text: Vec::new() });
            panel.marks.push(Mark { at: self.view.at(from), symbol: Symbol::Dot, colour, name: None, note });
        }
        panel
    }

    /// An arrow with its head, as one line.
    fn arrow_to(&self, from: [f64; 3], to: [f64; 3]) -> Vec<(f64, f64)> {
        let (from, tip) = (self.view.at(from), self.view.at(to));
        let (x, y) = (from.0 - tip.0, from.1 - tip.1);
        let long = x.hypot(y).max(f64::MIN_POSITIVE);
        let size = (0.2 * self.arrow).min(0.4 * long) / long;
        let barb = |side: f64| (tip.0 + size * (x - 0.45 * side * y), tip.1 + size * (y + 0.45 * side * x));
        vec![from, tip, barb(1.0), tip, barb(-1.0)]
    }

    /// The faces of the strip that are seen, from the farthest to the nearest.
    fn faces(&self, posed: &Posed, colour: RGBColor) -> Vec<Face> {
        let rings: Vec<Vec<[f64; 3]>> = posed.sections.iter().map(|at| outline(self.outline, at)).collect();
        let mut faces: Vec<(f64, Face)> = Vec::new();
        let edged = self.outline == SectionShape::Rectangle;
        for (number, pair) in rings.windows(2).enumerate() {
            let mut edges: Vec<[usize; 2]> = if edged { vec![[3, 0], [1, 2]] } else { Vec::new() };
            edges.extend((number == 0).then_some([0, 1]));
            edges.extend((number + 2 == rings.len()).then_some([2, 3]));
            for k in 0..pair[0].len() {
                let next = (k + 1) % pair[0].len();
                let corners = [pair[0][k], pair[0][next], pair[1][next], pair[1][k]];
                faces.extend(self.face(&corners, &edges, colour));
            }
        }
        for (ring, turned) in rings.first().map(|ring| (ring, true)).into_iter().chain(rings.last().map(|r| (r, false)))
        {
            let mut corners = ring.clone();
            if turned {
                corners.reverse();
            }
            let edges: Vec<[usize; 2]> = (0..corners.len()).map(|k| [k, (k + 1) % corners.len()]).collect();
            faces.extend(self.face(&corners, &edges, colour));
        }
        faces.sort_by(|a, b| a.0.total_cmp(&b.0));
        faces.into_iter().map(|(_, face)| face).collect()
    }

    /// A face with its corners anticlockwise from outside, with lines between some of them; nothing of one that is turned away.
    fn face(&self, corners: &[[f64; 3]], edges: &[[usize; 2]], colour: RGBColor) -> Option<(f64, Face)> {
        let light = self.view.light(corners)?;
        let projected: Vec<(f64, f64)> = corners.iter().map(|&corner| self.view.at(corner)).collect();
        let filled = mixed(colour, 0.75 - 0.6 * light);
        let side = |from: usize, to: usize, inset: f64| {
            let ((x0, y0), (x1, y1)) = (projected[from], projected[to]);
            let part = |share: f64| (x0 + share * (x1 - x0), y0 + share * (y1 - y0));
            vec![part(inset), part(1.0 - inset)]
        };
        // over the seams to its neighbours, then the edges
        let count = corners.len();
        let seams = (0..count).map(|k| [k, (k + 1) % count]).filter(|seam| !edges.contains(seam));
        let over = Stroke::solid(filled, 0.7);
        let inset = if edges.is_empty() { 0.0 } else { INSET };
        let mut lines: Vec<_> = seams.map(|[from, to]| (side(from, to, inset), over)).collect();
        lines.extend(edges.iter().map(|&[from, to]| (side(from, to, 0.0), Stroke::solid(colour, 0.9))));
        let depth = corners.iter().map(|&corner| self.view.depth(corner)).sum::<f64>() / corners.len() as f64;
        Some((depth, Face { shape: Shape { corners: projected, colour: filled, opacity: 1.0 }, lines }))
    }
}
