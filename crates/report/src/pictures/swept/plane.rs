//! The picture of a sweep over two keys: maps of the peak force and of the work to snap-off over the plane of both, with contours.

use crate::chart::RGBColor;
use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Note, Panel, Shape};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour, order_shade};
use crate::chart::symbol::Symbol;
use crate::swept::SweepRow;
use crate::swept::{SweptKeys, as_given};
use crate::writing::error::ReportError;
use peelkit::units::PreferredUnits;
use std::path::{Path, PathBuf};

/// Shades of the colour bar.
const SHADES: usize = 64;
/// How far a cell reaches over its right and upper neighbours, which are drawn later, as a share of the axis: no seams between them.
const OVERLAP: f64 = 1.0e-3;
/// What contours are drawn with; every colour of the map is darker.
const WHITE: RGBColor = RGBColor(255, 255, 255);
/// Width of a contour, pixels.
const CONTOUR: f64 = 1.4;
/// Upper edge of the first map, pixels: below the title and the line above the map.
const TOP: f64 = 58.0;
/// About so many contours.
const CONTOURS: usize = 6;
/// Of a map with more pairs the computed ones are not marked.
const MARKED: usize = 400;

/// Draws `sweep.svg` and `sweep.png` into `dir`: maps of the peak force and of the work to snap-off over the values of two keys, on
/// logarithmic axes where `log` is set. A pair without a result is grey.
///
/// Fails where there is no second key, no pair has a peak force, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file
/// cannot be written ([`ReportError::Write`]).
pub fn draw_plane<'h>(
    rows: &[SweepRow],
    keys: SweptKeys,
    heading: impl Into<Heading<'h>>,
    log: [bool; 2],
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let places: Vec<_> = rows.iter().map(|row| (row.value, row.second)).collect();
    let forces = rows.iter().map(|row| row.found.peak.map(|at| at.force)).collect();
    let heading = heading.into();
    let works = rows.iter().map(|row| row.found.snap_off.map(|at| at.work)).collect();
    draw_maps(&places, &[("peak force P (nN)", forces), ("work to snap-off W (aJ)", works)], keys, heading, log, dir)
}

/// Draws `sweep.svg` and `sweep.png` into `dir`: a map of each of these quantities, with its label, over the values of two keys, angles in degrees. The first one has to
/// have a value.
///
/// Fails as [`draw_plane`].
pub(crate) fn draw_maps(
    places: &[(f64, Option<f64>)],
    quantities: &[(&str, Vec<Option<f64>>)],
    keys: SweptKeys,
    Heading { title, units }: Heading,
    log: [bool; 2],
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let refuse = |reason: String| ReportError::Draw { path: dir.join("sweep.svg"), reason };
    let Some(second) = keys.second else { return Err(refuse("a map needs two keys that are varied".into())) };
    let values = [places.iter().map(|at| Some(at.0)).collect::<Vec<_>>(), places.iter().map(|at| at.1).collect()];
    for (values, (key, log)) in values.iter().zip([(keys.first, log[0]), (second, log[1])]) {
        crate::pictures::sweep::check_axis(values.iter().flatten().copied(), &key.path(), log).map_err(refuse)?;
    }
    if quantities.first().is_none_or(|(_, values)| values.iter().all(Option::is_none)) {
        return Err(refuse(format!("none of the {} pairs of {} has a peak force", places.len(), keys.names())));
    }
    // as a user gives them: angles in degrees
    let places: Vec<_> =
        places.iter().map(|at| (as_given(keys.first, at.0), at.1.map(|value| as_given(second, value)))).collect();
    let across = distinct(places.iter().map(|at| at.0));
    let up = distinct(places.iter().filter_map(|at| at.1));
    let axes = [(keys.first, across, log[0]), (second, up, log[1])]
        .map(|(key, values, log)| Grid::new(key.axis_title(), values, log));
    let mut panels = Vec::new();
    for (label, values) in quantities {
        let map = Map::new(&axes, &places, values);
        if map.values.iter().flatten().next().is_some() {
            let top = panels.last().map_or(TOP, |below: &Panel| below.frame.bottom + 74.0);
            panels.extend(map.panels(&axes, label, top, units));
        }
    }
    let height = panels.last().map_or(0.0, |panel| panel.frame.bottom) + 54.0;
    save(&Picture { title: title.into(), height: height as u32, panels }.in_units(units), dir, "sweep")
}

/// Each value once, ascending.
fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// One axis with the values of its key, from the first to the last: cells reach half of the way to the next value.
struct Grid {
    axis: Axis,
    values: Vec<f64>,
    /// Where cells begin and end, 0 to 1 along the axis.
    edges: Vec<f64>,
}

impl Grid {
    fn new(label: String, values: Vec<f64>, log: bool) -> Self {
        let on = |value: f64| if log { value.ln() } else { value };
        let off = |place: f64| if log { place.exp() } else { place };
        let places: Vec<f64> = values.iter().map(|&value| on(value)).collect();
        let half = |a: f64, b: f64| 0.5 * (b - a);
        let lone = if log { 0.1 } else { 0.1 * places[0].abs().max(f64::MIN_POSITIVE) };
        let (first, last) = match places[..] {
            [only] => (only - lone, only + lone),
            _ => (places[0], places[places.len() - 1]),
        };
        let mut ends = vec![first];
        ends.extend(places.windows(2).map(|pair| pair[0] + half(pair[0], pair[1])));
        ends.push(last);
        let axis = Axis { log, ..Axis::linear(&label, off(first), off(last)) };
        let edges = ends.iter().map(|end| (end - first) / (last - first)).collect();
        Self { axis, values, edges }
    }

    fn index(&self, value: f64) -> Option<usize> {
        self.values.iter().position(|&known| known == value)
    }

    /// The value at a place, 0 to 1 along the axis.
    fn at(&self, place: f64) -> f64 {
        let Axis { from, to, log, .. } = self.axis;
        if log { from * (to / from).powf(place) } else { from + place * (to - from) }
    }

    /// Where a cell begins and ends, in the unit of the axis; it reaches a little over its neighbour.
    fn cell(&self, index: usize) -> [f64; 2] {
        [self.at(self.edges[index]), self.at((self.edges[index + 1] + OVERLAP).min(1.0))]
    }
}

/// A quantity over the plane: row by row of the second key, in each the values of the first.
struct Map {
    values: Vec<Option<f64>>,
    columns: usize,
}

impl Map {
    fn new(axes: &[Grid; 2], places: &[(f64, Option<f64>)], of_places: &[Option<f64>]) -> Self {
        let columns = axes[0].values.len();
        let mut values = vec![None; columns * axes[1].values.len()];
        for (&(value, second), of_place) in places.iter().zip(of_places) {
            if let (Some(i), Some(j)) = (axes[0].index(value), second.and_then(|second| axes[1].index(second))) {
                values[j * columns + i] = of_place.filter(|value| value.is_finite());
            }
        }
        Self { values, columns }
    }

    /// The map and its colour bar.
    fn panels(&self, axes: &[Grid; 2], label: &str, top: f64, units: PreferredUnits) -> [Panel; 2] {
        let known = || self.values.iter().flatten().copied();
        let (low, high) = known().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let log = low > 0.0 && high > 8.0 * low;
        let margin = if high > low { 0.0 } else { 0.05 * high.abs().max(f64::MIN_POSITIVE) };
        let scale = Axis { log, units, ..Axis::linear(label, low - margin, high + margin) };
        let bottom = top + 300.0;
        let frame = Frame { left: 88.0, top, right: f64::from(WIDTH) - 170.0, bottom };
        let mut map = Panel::new(frame, axes[0].axis.clone(), axes[1].axis.clone());
        let is_marked = self.values.len() <= MARKED;
        let says = [
            is_marked.then_some("dots: computed"),
            self.values.iter().any(Option::is_none).then_some("grey: does not occur, or was not found"),
        ];
        map.title = says.into_iter().flatten().collect::<Vec<_>>().join("; ");
        for (index, value) in self.values.iter().enumerate() {
            let ([left, right], [lower, upper]) =
                (axes[0].cell(index % self.columns), axes[1].cell(index / self.columns));
            let corners = vec![(left, lower), (right, lower), (right, upper), (left, upper)];
            let colour = value.map_or(colour::PALE, |value| shade(scale.place(value)));
            map.shapes.push(Shape { corners, colour, opacity: 1.0 });
        }
        for tick in scale.ticks(CONTOURS) {
            let Some(text) = tick.text else { continue };
            let pieces = self.contour(axes, scale.place(tick.value), &scale);
            // its number stands near the middle of it
            map.marks.extend(pieces.get(pieces.len() / 2).map(|piece| Mark {
                at: piece.points[0],
                symbol: Symbol::None,
                colour: colour::INK,
                name: None,
                note: Some(Note { badge: None, text: vec![text] }),
            }));
            map.lines.extend(pieces);
        }
        if is_marked {
            map.marks.extend(self.computed(axes));
        }
        [map, colour_bar(scale, top, bottom)]
    }

    /// A dot at each pair that has a result.
    fn computed(&self, axes: &[Grid; 2]) -> impl Iterator<Item = Mark> {
        let at = |k: usize| (axes[0].values[k % self.columns], axes[1].values[k / self.columns]);
        let known = self.values.iter().enumerate().filter(|(_, value)| value.is_some());
        known.map(move |(k, _)| Mark::dot(at(k), WHITE))
    }

    /// The contour of a level, 0 to 1 along the scale: straight in each triangle of four neighbours and their mean.
    fn contour(&self, axes: &[Grid; 2], level: f64, scale: &Axis) -> Vec<Line> {
        let place = |grid: &Grid, k: usize| grid.axis.place(grid.values[k]);
        let corner = |i: usize, j: usize| {
            let value = self.values[j * self.columns + i]?;
            Some(Node { place: [place(&axes[0], i), place(&axes[1], j)], above: scale.place(value) - level })
        };
        let mut lines = Vec::new();
        for j in 0..axes[1].values.len().saturating_sub(1) {
            for i in 0..self.columns.saturating_sub(1) {
                let around = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                let [Some(a), Some(b), Some(c), Some(d)] = around else { continue };
                let middle = Node::mean([a, b, c, d]);
                for (from, to) in [(a, b), (b, c), (c, d), (d, a)] {
                    lines.extend(crossing([from, to, middle]).map(|ends| Line {
                        points: ends.map(|[x, y]| (axes[0].at(x), axes[1].at(y))).to_vec(),
                        stroke: Stroke::solid(WHITE, CONTOUR),
                        name: None,
                    }));
                }
            }
        }
        lines
    }
}

/// What the colours mean.
fn colour_bar(scale: Axis, top: f64, bottom: f64) -> Panel {
    let right = f64::from(WIDTH) - 18.0;
    // an axis without a tick in its range
    let none = Axis::linear("", 0.1, 0.9);
    let at = |share: f64| match scale.log {
        true => scale.from * (scale.to / scale.from).powf(share),
        false => scale.from + share * (scale.to - scale.from),
    };
    let strip = |k: usize| {
        let [from, to] = [k as f64, (k + 1) as f64].map(|k| k / SHADES as f64);
        let corners = [(none.from, from), (none.to, from), (none.to, to + OVERLAP), (none.from, to + OVERLAP)];
        let corners = corners.map(|(x, share)| (x, at(share.min(1.0)))).to_vec();
        Shape { corners, colour: order_shade(k, SHADES), opacity: 1.0 }
    };
    let shapes = (0..SHADES).map(strip).collect();
    Panel { shapes, ..Panel::new(Frame { left: right - 28.0, top, right, bottom }, none.clone(), scale.clone()) }
}

/// The colour at a place of the scale, 0 to 1.
fn shade(place: f64) -> RGBColor {
    order_shade((place.clamp(0.0, 1.0) * (SHADES - 1) as f64).round() as usize, SHADES)
}

// -- A piece of a contour: where a function that is linear on a triangle is zero --

/// A corner: where it is, and how far the function is above the level of the contour there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Node {
    place: [f64; 2],
    above: f64,
}

impl Node {
    /// The middle of four corners.
    fn mean(corners: [Self; 4]) -> Self {
        let mean = |of: fn(&Self) -> f64| 0.25 * corners.iter().map(of).sum::<f64>();
        Self { place: [mean(|node| node.place[0]), mean(|node| node.place[1])], above: mean(|node| node.above) }
    }
}

/// The two ends of the piece in a triangle, if the contour goes through it.
fn crossing(corners: [Node; 3]) -> Option<[[f64; 2]; 2]> {
    let sides = [(0, 1), (1, 2), (2, 0)].into_iter().filter_map(|(p, q)| {
        let (a, b) = (corners[p], corners[q]);
        let t = a.above / (a.above - b.above);
        let between = |k: usize| a.place[k] + t * (b.place[k] - a.place[k]);
        ((a.above < 0.0) != (b.above < 0.0)).then(|| [between(0), between(1)])
    });
    <[[f64; 2]; 2]>::try_from(sides.collect::<Vec<_>>()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_meet_half_way_between_values() {
        let grid = Grid::new("x".into(), vec![1.0, 2.0, 4.0], false);
        assert_eq!((grid.axis.from, grid.axis.to), (1.0, 4.0));
        assert!((grid.at(grid.edges[1]) - 1.5).abs() < 1e-12 && (grid.at(grid.edges[2]) - 3.0).abs() < 1e-12);
        let log = Grid::new("x".into(), vec![1.0, 100.0], true);
        assert!((log.axis.from - 1.0).abs() < 1e-12 && (log.at(log.edges[1]) - 10.0).abs() < 1e-9);
        assert!(Grid::new("x".into(), vec![3.0], false).axis.from < 3.0);
    }

    #[test]
    fn a_triangle_is_crossed_where_the_value_is_zero() {
        let corners = [([0.0, 0.0], -1.0), ([1.0, 0.0], 1.0), ([0.0, 1.0], 3.0)];
        let corners = corners.map(|(place, above)| Node { place, above });
        assert_eq!(crossing(corners), Some([[0.5, 0.0], [0.0, 0.25]]));
        assert_eq!(crossing(corners.map(|node| Node { above: node.above + 2.0, ..node })), None);
    }
}
