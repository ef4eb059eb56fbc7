//! The pictures of the peel of a solid: force against displacement, and its front at two points of its path, with its stress as colour and the
//! traction of the ground below it.

use super::fields::{chosen, shown};
use super::shapes::shapes;
use crate::chart::axis::{Axis, significant, with_unit};
use crate::chart::canvas::Stroke;
use crate::chart::marked::{Marked, mark_found};
use crate::chart::output::save_all;
use crate::chart::panel::{Line, Mark, Panel, Shape};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{colour, signed_shade};
use crate::records::passed::PassedAt;
use crate::writing::error::ReportError;
use peelkit::adhesion::HalfSpace;
use peelkit::solid::SolidBody;
use peelkit::study::{SolidLimitPoint, SolidPeel, SolidPoint};
use peelkit::units::{LENGTHS, PreferredUnits};
use std::path::{Path, PathBuf};

/// What is shown of a strip, over its height, and of a spatula, over the thickness of its pad.
const WINDOW: f64 = 4.0;
const WINDOW_OF_SPATULA: f64 = 12.0;
/// Points of the surface of the ground, less one.
const SURFACE: usize = 200;
/// Height of the panel of the strip over its width: lengths are alike along both axes.
const ASPECT: f64 = 0.55;
/// Height of the panel of the traction, and what is between, pixels.
const TRACTION: f64 = 130.0;
const BETWEEN: f64 = 40.0;

/// Draws `curve`, `shapes` and `solid` into `dir`, as SVG and PNG; the latter of its front by the ground.
///
/// Fails where there are fewer than two points ([`ReportError::Draw`]), or a file cannot be written ([`ReportError::Write`]).
pub fn draw_solid<'h>(
    dir: &Path,
    (peel, passed): (&SolidPeel, &[PassedAt]),
    ground: &HalfSpace,
    heading: impl Into<Heading<'h>>,
) -> Result<Vec<PathBuf>, ReportError> {
    if peel.points.len() < 2 {
        let reason = format!("the path has {} points", peel.points.len());
        return Err(ReportError::Draw { path: dir.join("curve.svg"), reason });
    }
    let heading = heading.into();
    let pictures = [
        (curve(peel, passed, heading), "curve"),
        (shapes(peel, heading), "shapes"),
        (front(peel, ground, heading), "solid"),
    ];
    save_all(&pictures, dir)
}

fn curve(peel: &SolidPeel, passed: &[PassedAt], Heading { title, units }: Heading) -> Picture {
    let points: Vec<(f64, f64)> = peel.points.iter().map(|at| (at.displacement, at.force)).collect();
    let x = Axis::around("displacement u (nm)", points.iter().map(|at| at.0).chain([0.0]), false);
    let y = Axis::around("force P (nN)", points.iter().map(|at| at.1).chain([0.0]), false).in_units(units);
    let line = Line::plain(points, Stroke::solid(colour::BLUE, 1.6));
    let mut panel = Panel::of_lines(Frame::across(), x, y.clone(), vec![line]);
    let mark = |at: &SolidLimitPoint, what: &str| {
        let error = at.errors.map_or(String::new(), |errors| format!(" ± {}", y.text_of(errors.force, 2)));
        let text = format!("{}{error}", y.text_of(at.force, 4));
        Mark::labelled((at.displacement, at.force), colour::INK, &[what, &text])
    };
    panel.marks.extend(peel.peak().map(|at| mark(at, "peak")));
    panel.marks.extend(peel.snap_off().map(|at| mark(at, "first jump")));
    let mut panels = vec![panel];
    mark_found(&mut panels, &passed.iter().map(PassedAt::marked).collect::<Vec<Marked>>());
    Picture::of(title, panels).in_units(units)
}

fn front(peel: &SolidPeel, ground: &HalfSpace, Heading { title, units }: Heading) -> Picture {
    let [places, heights] = shown(peel);
    let window = match peel.body {
        SolidBody::Strip(_) => WINDOW,
        SolidBody::Spatula(_) => WINDOW_OF_SPATULA,
    };
    let width = window * peel.body.thickness();
    let chosen = chosen(peel);
    let mut panels = Vec::new();
    for (column, (what, at)) in chosen.iter().enumerate() {
        let of_column = Frame::column(column, 2);
        let frame =
            Frame { top: of_column.top + 18.0, bottom: of_column.top + 18.0 + ASPECT * of_column.width(), ..of_column };
        let below = Frame { top: frame.bottom + BETWEEN, bottom: frame.bottom + BETWEEN + TRACTION, ..of_column };
        panels.extend(state(peel, ground, (what, at), [&places, &heights], [frame, below], (width, units)));
    }
    Picture::of(title, panels).in_units(units)
}

/// The strip at one point, in a window of this width, and the traction below it.
fn state(
    peel: &SolidPeel,
    ground: &HalfSpace,
    (what, at): (&str, &SolidPoint),
    [places, heights]: [&[f64]; 2],
    [frame, below]: [Frame; 2],
    (width, units): (f64, PreferredUnits),
) -> [Panel; 2] {
    let of = |s: f64, height: f64| peel.body.place_at(at.values(), [s, height]).into();
    let [underside, _] = peel.body.faces();
    let substrate = peel.body.substrate();
    let face: Vec<(f64, f64)> = places.iter().map(|&s| of(s, underside)).collect();
    let traction: Vec<(f64, f64)> =
        face.iter().map(|&(x, y)| (x, 1e3 * ground.traction(substrate.project(x, y).distance))).collect();
    // downwards on the strip: where the ground holds it most beside its front
    let front = peel.body.adhering_length() - at.front;
    let beside = places.iter().zip(&traction).filter(|(s, _)| (**s - front).abs() <= 0.5 * width);
    let strongest = beside.min_by(|a, b| a.1.1.total_cmp(&b.1.1)).map_or(0.0, |(_, at)| at.0);
    let right = face.last().map_or(width, |last| last.0);
    let from = (strongest - 0.5 * width).min(right - 0.9 * width);
    let at_ground = |k: usize| from + width * k as f64 / SURFACE as f64;
    let surface: Vec<(f64, f64)> = (0..=SURFACE).map(at_ground).map(|x| (x, substrate.top(x, x))).collect();
    let bottom = surface.iter().fold(0.0, |low: f64, at| low.min(at.1)) - 0.05 * width;
    let top = bottom + ASPECT * width;
    let [x, y] = [Axis::linear("(nm)", from, from + width), Axis::linear("y (nm)", bottom, top)];
    let inside = |&(x, y): &(f64, f64)| x >= from && x <= from + width && y >= bottom && y <= top;
    let mut shapes = Vec::new();
    let mut largest: f64 = 0.0;
    for pair in places.windows(2) {
        for row in heights.windows(2) {
            let stress = peel.body.stress_at(at.values(), [0.5 * (pair[0] + pair[1]), 0.5 * (row[0] + row[1])])[1];
            let corners = vec![of(pair[0], row[0]), of(pair[1], row[0]), of(pair[1], row[1]), of(pair[0], row[1])];
            if corners.iter().all(inside) {
                largest = largest.max(stress.abs());
                shapes.push((corners, stress));
            }
        }
    }
    let shapes = shapes.into_iter().map(|(corners, stress)| Shape {
        corners,
        colour: signed_shade(stress / largest.max(f64::MIN_POSITIVE)),
        opacity: 1.0,
    });
    let mut body = Panel::new(frame, x, y);
    body.shapes = shapes.collect();
    let u = with_unit(units.fitting(LENGTHS, at.displacement.abs()), at.displacement, 3);
    body.title = format!("{what}: u = {u}; σyy ±{} GPa", significant(largest, 2));
    let (across, along) = peel.body.mesh_lines();
    let thin = || Stroke::solid(colour::GREY, 0.5);
    let lines_across = across.iter().map(|&s| heights.iter().map(|&height| of(s, height)).collect::<Vec<_>>());
    let lines_along = along.iter().map(|&height| places.iter().map(|&s| of(s, height)).filter(inside).collect());
    let lines = lines_across.filter(|points| points.iter().all(inside)).chain(lines_along);
    body.lines = lines.map(|points| Line::plain(points, thin())).collect();
    body.lines.push(Line::plain(surface, Stroke::solid(colour::INK, 2.0)));
    let shown = traction.iter().filter(|at| at.0 >= from && at.0 <= from + width).map(|at| at.1);
    let y = Axis::around("T (MPa)", shown.chain([0.0]), false);
    let line = Line::plain(traction, Stroke::solid(colour::VERMILLION, 1.6));
    let force = Panel::of_lines(below, Axis::linear("x (nm)", from, from + width), y, vec![line]);
    [body, force]
}
