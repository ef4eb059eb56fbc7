//! The deformed strip with its thickness over the substrate, drawn to scale.

use crate::chart::axis::{Axis, with_unit};
use crate::chart::canvas::Stroke;
use crate::chart::panel::{Line, Mark, Note, Panel, Shape};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour, order_shade};
use crate::chart::symbol::Symbol;
use peelkit::adhesion::Substrate;
use peelkit::study;
use peelkit::units::{FORCES, LENGTHS};
use plotters::style::RGBColor;

/// The strip at one point of the path.
#[derive(Clone, Debug)]
pub(crate) struct Posed {
    /// The number that the curve picture gives the same point.
    pub number: usize,
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    pub axis: study::DeformedShape,
    /// Thickness of the beam over twice the distance of its lower face from its axis
    pub thickness: f64,
}

/// Most pixels that the panel may be high.
const HIGHEST: f64 = 560.0;

/// The least height of the panel, in lengths of the strip: the legend stands above what still lies flat.
const LOWEST: f64 = 0.4;

/// The beam at all those points, the axes of equal scale.
pub(crate) fn shapes_picture(poses: &[Posed], ground: &Substrate, heading: Heading) -> Picture {
    let Heading { title, units } = heading;
    let outlines: Vec<Vec<(f64, f64)>> = poses.iter().map(|p| outline(&p.axis, p.thickness)).collect();
    let all = || outlines.iter().flatten().filter(|p| p.0.is_finite() && p.1.is_finite());
    let (low, high) = all().fold((0.0f64, 0.0f64), |(a, b), p| (a.min(p.0), b.max(p.0)));
    let (bottom, top) = all().fold((0.0f64, 0.0f64), |(a, b), p| (a.min(p.1), b.max(p.1)));
    let bottom = if low < high { bottom.min(deepest(ground, low, high)) } else { bottom };
    let span = (high - low).max(1.2 * (top - bottom)).max(f64::MIN_POSITIVE);
    let depth = 0.045 * span;
    let (mut from, mut to) = (low - 0.05 * span, high + 0.08 * span);
    let (y_from, y_to) = (bottom - depth, (top + 0.07 * span).max(LOWEST * span));
    let (left, right, upper) = (78.0, f64::from(WIDTH) - 16.0, 40.0);
    // As wide as the sheet; where that would be too high, the range of x grows instead.
    let shortage = (y_to - y_from) * (right - left) / HIGHEST - (to - from);
    if shortage > 0.0 {
        (from, to) = (from - 0.5 * shortage, to + 0.5 * shortage);
    }
    let lower = upper + (right - left) * (y_to - y_from) / (to - from);
    let frame = Frame { left, top: upper, right, bottom: lower };
    let mut panel = Panel::new(frame, Axis::linear("x (nm)", from, to), Axis::linear("y (nm)", y_from, y_to));
    substrate(&mut panel, ground, depth);
    let most = |of: fn(&Posed) -> f64| poses.iter().map(|posed| of(posed).abs()).fold(0.0, f64::max);
    let largest = [most(|posed| posed.displacement), most(|posed| posed.force)];
    let written = [units.fitting(LENGTHS, largest[0]), units.fitting(FORCES, largest[1])];
    let seen = |value: f64, largest: f64| if value.abs() < ROUND_OFF * largest { 0.0 } else { value };
    for (i, (posed, outline)) in poses.iter().zip(outlines).enumerate() {
        let [u, p] = [seen(posed.displacement, largest[0]), seen(posed.force, largest[1])];
        let name = format!("u = {}, P = {}", with_unit(written[0], u, 3), with_unit(written[1], p, 3));
        strip(&mut panel, posed, outline, order_shade(i, poses.len()), name);
    }
    Picture { title: title.into(), height: (lower + 52.0).round() as u32, panels: vec![panel] }.in_units(units)
}

/// The rim of the beam: its axis moved along the normal of the section, by half the height down and by the rest of the thickness up.
fn outline(axis: &study::DeformedShape, thickness: f64) -> Vec<(f64, f64)> {
    let side = |part: f64| {
        let sections = axis.x.iter().zip(&axis.y).zip(axis.rotation.iter().zip(&axis.height));
        let edge = move |((x, y), (turn, height)): ((&f64, &f64), (&f64, &f64))| {
            (x - part * height * turn.sin(), y + part * height * turn.cos())
        };
        sections.map(edge).collect::<Vec<_>>()
    };
    let mut rim = side(-0.5);
    rim.extend(side(thickness - 0.5).into_iter().rev());
    rim.extend(rim.first().copied());
    rim
}

/// A number that is less of the largest one is zero.
const ROUND_OFF: f64 = 1e-9;

fn strip(panel: &mut Panel, posed: &Posed, outline: Vec<(f64, f64)>, colour: RGBColor, name: String) {
    panel.shapes.push(Shape { corners: outline.clone(), colour, opacity: 0.30 });
    panel.lines.push(Line { points: outline, stroke: Stroke::solid(colour, 1.3), name: None });
    if let (Some(&x), Some(&y)) = (posed.axis.x.last(), posed.axis.y.last()) {
        let note = Some(Note { badge: Some(posed.number), text: Vec::new() });
        panel.marks.push(Mark { at: (x, y), symbol: Symbol::Dot, colour, name: Some(name), note });
    }
}

/// Points of the surface that are drawn.
const DRAWN: usize = 600;

/// The surface between two places.
fn surface(ground: &Substrate, from: f64, to: f64) -> Vec<(f64, f64)> {
    let points = if ground.is_flat() { 1 } else { DRAWN };
    let place = |k: usize| from + (to - from) * k as f64 / points as f64;
    (0..=points).map(place).map(|x| (x, ground.top(x, x))).collect()
}

fn deepest(ground: &Substrate, from: f64, to: f64) -> f64 {
    surface(ground, from, to).iter().map(|point| point.1).fold(f64::INFINITY, f64::min)
}

/// The surface with hatching below.
fn substrate(panel: &mut Panel, ground: &Substrate, depth: f64) {
    let (from, to, floor) = (panel.x.from, panel.x.to, panel.y.from);
    let surface: Vec<(f64, f64)> = surface(ground, from, to).into_iter().map(|(x, y)| (x, y.max(floor))).collect();
    let mut below = surface.clone();
    below.extend([(to, floor), (from, floor)]);
    panel.shapes.push(Shape { corners: below, colour: colour::PALE, opacity: 1.0 });
    let step = 0.55 * depth;
    let strokes = ((to - from + depth) / step).ceil() as usize;
    for i in 0..=strokes {
        let x = from + i as f64 * step;
        let y = ground.top(x, x).max(floor + depth);
        let points = vec![(x, y), (x - depth, y - depth)];
        panel.lines.push(Line { points, stroke: Stroke::solid(colour::GREY, 0.8), name: None });
    }
    panel.lines.push(Line { points: surface, stroke: Stroke::solid(colour::INK, 1.4), name: None });
}
