//! What is uncertain of one result: how it is distributed, where its variance comes from, and what each input does alone.

use crate::chart::RGBColor;
use crate::chart::axis::Axis;
use crate::chart::canvas::{Dash, Stroke};
use crate::chart::output::save_all;
use crate::chart::panel::{Band, Line, Panel, Shape};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::writing::error::ReportError;
use crate::writing::names::quantity_title;
use peelkit::study::uncertainty::{ALONE_AT, Analysis, NumberAnalysis, Order, Statistics};
use peelkit_scene::find_key;
use std::path::{Path, PathBuf};

/// Most inputs of a picture: those of the largest total index, or of the largest effect.
const MOST: usize = 12;
/// Most bars of a histogram.
const MOST_BARS: usize = 60;
/// Height of the room for a bar, pixels.
const ROW: f64 = 24.0;
/// Half of a bar, over the room for it; two bars share one room.
const HALF: f64 = 0.34;
/// Room for the names of inputs on the left, pixels.
const NAMES: f64 = 260.0;
/// Height of a histogram, pixels.
const HISTOGRAM: f64 = 250.0;
/// From one panel to the next: its axis, and the title of the next, pixels.
const BETWEEN: f64 = 86.0;

/// Draws a picture for each result that has statistics into `dir`, `initiation_peak-force.svg` and `.png` for example: a histogram with the normal
/// distribution of linear propagation, the sensitivity indices with their errors, and what each input does alone.
///
/// Fails where a file cannot be written ([`ReportError::Write`]) or drawn ([`ReportError::Draw`]).
pub fn draw_uncertainty<'h>(
    analysis: &Analysis,
    heading: impl Into<Heading<'h>>,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let Heading { title, units } = heading.into();
    let mut pictures = Vec::new();
    for number in &analysis.numbers {
        let Some(statistics) = number.statistics.as_ref().filter(|of| of.largest > of.smallest) else { continue };
        let stem = number.of.name().replace('.', "-");
        let stem = stem.rsplit_once('_').map_or(stem.as_str(), |(name, _)| name).to_owned();
        pictures.push((picture(analysis, number, statistics, title).in_units(units), stem));
    }
    save_all(&pictures, dir)
}

fn picture(analysis: &Analysis, number: &NumberAnalysis, statistics: &Statistics, title: &str) -> Picture {
    let (right, mut top) = (f64::from(WIDTH) - 18.0, 40.0);
    let mut panels = vec![histogram(number, statistics, Frame { left: 88.0, top, right, bottom: top + HISTOGRAM })];
    top += HISTOGRAM + BETWEEN;
    let framed = |top: f64, rows: usize| Frame { left: NAMES, top, right, bottom: top + ROW * rows as f64 };
    let indices = index_rows(analysis, number);
    if !indices.is_empty() {
        let frame = framed(top, indices.len());
        top = frame.bottom + BETWEEN;
        panels.push(indices_panel(&indices, frame));
    }
    let alone = alone_rows(analysis, number);
    if let Some(taylor) = number.taylor.as_ref().filter(|_| !alone.is_empty()) {
        let frame = framed(top, alone.len());
        top = frame.bottom + BETWEEN;
        panels.push(tornado(&alone, taylor.value, number, frame));
    }
    Picture { title: title.into(), height: (top - 30.0) as u32, panels }
}

/// By the rule of Freedman and Diaconis: bars of twice the distance of the quartiles over the cube root of the number of samples.
fn histogram(number: &NumberAnalysis, statistics: &Statistics, frame: Frame) -> Panel {
    let quantile = |p: f64| statistics.quantiles.iter().find(|of| of.probability == p).map(|of| of.value);
    let values: Vec<f64> = number.values.iter().copied().flatten().collect();
    let (from, to) = (statistics.smallest, statistics.largest);
    let quartiles = quantile(0.75).zip(quantile(0.25)).map_or(0.0, |(upper, lower)| upper - lower);
    let width = 2.0 * quartiles / (values.len() as f64).cbrt();
    let bars = if width > 0.0 { (((to - from) / width).ceil() as usize).clamp(5, MOST_BARS) } else { MOST_BARS };
    let width = (to - from) / bars as f64;
    let mut counts = vec![0usize; bars];
    values.iter().for_each(|value| counts[(((value - from) / width) as usize).min(bars - 1)] += 1);
    let density = |count: usize| count as f64 / (values.len() as f64 * width);
    let bar = |(k, &count): (usize, &usize)| {
        let (left, right) = (from + k as f64 * width, from + (k + 1) as f64 * width);
        let top = density(count);
        Shape {
            corners: vec![(left, 0.0), (right, 0.0), (right, top), (left, top)],
            colour: colour::BLUE,
            opacity: 0.7,
        }
    };
    let highest = counts.iter().copied().map(density).fold(0.0, f64::max);
    let normal = number.propagations.iter().find(|of| of.order == Order::First && of.deviation > 0.0);
    let lines: Vec<Line> = normal
        .map(|of| {
            let at = |x: f64| {
                let z = (x - of.mean) / of.deviation;
                (-0.5 * z * z).exp() / (of.deviation * std::f64::consts::TAU.sqrt())
            };
            let places = (0..=200).map(|k| from + (to - from) * f64::from(k) / 200.0);
            let stroke = Stroke::dashed(colour::VERMILLION, 2.0);
            Line { points: places.map(|x| (x, at(x))).collect(), stroke, name: Some("linear propagation".into()) }
        })
        .into_iter()
        .collect();
    let top = lines.iter().flat_map(|line| &line.points).map(|point| point.1).fold(highest, f64::max);
    let band = quantile(0.05).zip(quantile(0.95)).map(|(from, to)| Band {
        from,
        to,
        colour: colour::GREEN,
        name: Some("90 % of the samples".into()),
    });
    let x = Axis::linear(&quantity_title(number.of), from - 0.02 * (to - from), to + 0.02 * (to - from));
    let y = Axis::linear(&format!("density (1/{})", number.of.unit()), 0.0, 1.08 * top);
    let bands = band.into_iter().collect();
    Panel { shapes: counts.iter().enumerate().map(bar).collect(), lines, bands, ..Panel::new(frame, x, y) }
}

/// Name, first-order and total index, each with its error, the largest total index first.
type IndexRow = (String, [f64; 2], [f64; 2]);

fn index_rows(analysis: &Analysis, number: &NumberAnalysis) -> Vec<IndexRow> {
    let name = |&input: &usize| analysis.design.plan().inputs[input].name.as_str();
    let mut rows: Vec<IndexRow> = number
        .indices
        .iter()
        .map(|of| {
            let names = of.inputs.iter().map(name).collect::<Vec<_>>().join(" + ");
            (names, [of.first.value, of.first.error], [of.total.value, of.total.error])
        })
        .collect();
    rows.sort_by(|a, b| b.2[0].total_cmp(&a.2[0]));
    rows.truncate(MOST);
    rows
}

/// A bar from `from` to `to` in the upper (1) or lower (-1) half of a row, or in both (0).
fn bar(row: usize, half: f64, from: f64, to: f64, colour: RGBColor) -> Shape {
    let (low, high) = match half {
        h if h > 0.0 => (0.0, HALF),
        h if h < 0.0 => (-HALF, 0.0),
        _ => (-HALF, HALF),
    };
    let (low, high) = (row as f64 + low, row as f64 + high);
    Shape { corners: vec![(from, low), (to, low), (to, high), (from, high)], colour, opacity: 0.85 }
}

fn indices_panel(rows: &[IndexRow], frame: Frame) -> Panel {
    let largest = rows.iter().map(|row| (row.1[0] + row.1[1]).max(row.2[0] + row.2[1])).fold(1.0, f64::max);
    let least = rows.iter().map(|row| (row.1[0] - row.1[1]).min(row.2[0] - row.2[1])).fold(0.0, f64::min);
    let x = Axis::linear("share of the variance", least, 1.03 * largest);
    let y = Axis::of_names(rows.iter().rev().map(|row| row.0.clone()).collect());
    let mut shapes = Vec::new();
    let mut lines = vec![
        named(colour::BLUE, "first-order index"),
        named(colour::ORANGE, "total index"),
        upright(0.0, rows.len(), Dash::Solid),
    ];
    for (place, (_, first, total)) in rows.iter().rev().enumerate() {
        for (half, [value, error], colour) in [(1.0, first, colour::BLUE), (-1.0, total, colour::ORANGE)] {
            shapes.push(bar(place, half, 0.0, *value, colour));
            let y = place as f64 + 0.5 * half * HALF;
            let points = vec![(value - error, y), (value + error, y)];
            lines.push(Line { points, stroke: Stroke::solid(colour::INK, 1.2), name: None });
        }
    }
    Panel {
        title: "sensitivity indices of Sobol, with errors of 95 %".into(),
        shapes,
        lines,
        ..Panel::new(frame, x, y)
    }
}

/// A line that stands in the legend alone.
fn named(colour: RGBColor, name: &str) -> Line {
    Line { points: Vec::new(), stroke: Stroke::solid(colour, 6.0), name: Some(name.into()) }
}

fn upright(x: f64, rows: usize, dash: Dash) -> Line {
    let stroke = Stroke { dash, ..Stroke::solid(colour::INK, 1.0) };
    Line { points: vec![(x, -0.5), (x, rows as f64 - 0.5)], stroke, name: None }
}

/// Name, and the number at the lower and the upper quantile of the input, the largest change first.
fn alone_rows(analysis: &Analysis, number: &NumberAnalysis) -> Vec<(String, [f64; 2])> {
    let inputs = analysis.design.plan().inputs.iter();
    let mut rows: Vec<(String, [f64; 2])> =
        inputs.zip(&number.alone).filter_map(|(input, at)| Some((input.name.clone(), [at[0]?, at[1]?]))).collect();
    rows.sort_by(|a, b| (b.1[1] - b.1[0]).abs().total_cmp(&(a.1[1] - a.1[0]).abs()));
    rows.truncate(MOST);
    rows
}

fn tornado(rows: &[(String, [f64; 2])], center: f64, number: &NumberAnalysis, frame: Frame) -> Panel {
    let values = || rows.iter().flat_map(|row| row.1).chain([center]);
    let (low, high) = values().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    let margin = 0.05 * (high - low).max(1e-12 * center.abs());
    let x = Axis::linear(&quantity_title(number.of), low - margin, high + margin);
    let name = |path: &str| find_key(path).map_or_else(|_| path.to_owned(), peelkit_scene::Key::path);
    let y = Axis::of_names(rows.iter().rev().map(|row| name(&row.0)).collect());
    let mut shapes = Vec::new();
    for (place, (_, [at_low, at_high])) in rows.iter().rev().enumerate() {
        shapes.push(bar(place, 0.0, center, *at_low, colour::ORANGE));
        shapes.push(bar(place, 0.0, center, *at_high, colour::BLUE));
    }
    let (lower, upper) = (100.0 * ALONE_AT, 100.0 * (1.0 - ALONE_AT));
    let title =
        format!("one input at its quantile of {lower:.0} % (orange) and {upper:.0} % (blue), others at their means");
    let lines = vec![upright(center, rows.len(), Dash::Dashed)];
    Panel { title, shapes, lines, ..Panel::new(frame, x, y) }
}
