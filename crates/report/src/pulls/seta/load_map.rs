//! Maps of the load per tip over the grid of tips, one a moment of the pull-off, with one scale.

use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::panel::{Line, Panel, Shape};
use crate::chart::picture::Picture;
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour, signed_shade};

/// Shades of the colour bar.
const SHADES: usize = 64;
/// How far a strip of the colour bar reaches over the next one, as a share of the axis: no seams between them.
const OVERLAP: f64 = 1.0e-3;
/// Upper edge of the maps, pixels: below the title and the lines above the maps.
const TOP: f64 = 62.0;
/// To the left of the first map, between two maps and for the colour bar with its texts, pixels.
const LEFT: f64 = 66.0;
const BETWEEN: f64 = 42.0;
const BAR: f64 = 112.0;
/// Of each side of a cell, the share that a tip fills.
const FILLED: f64 = 0.9;

/// The loads of all tips at one moment of a pull-off.
pub(super) struct Moment {
    /// What stands above its map
    pub title: String,
    /// Force on each tip away from the ground, nN; none of one that is detached
    pub loads: Vec<Option<f64>>,
}

/// Maps of moments over the places of the tips on the ground, µm, whose grid has this pitch, µm.
pub(super) fn picture(places: &[(f64, f64)], pitch: f64, moments: &[Moment], title: &str) -> Picture {
    let [low, high] = [f64::min, f64::max]
        .map(|pick| places.iter().copied().reduce(|a, b| (pick(a.0, b.0), pick(a.1, b.1))).unwrap_or_default());
    let half = 0.5 * pitch;
    let (wide, tall) = (high.0 - low.0 + pitch, high.1 - low.1 + pitch);
    let count = moments.len().max(1) as f64;
    let room = (f64::from(WIDTH) - LEFT - BAR - BETWEEN * (count - 1.0)) / count;
    let bottom = TOP + (room * tall / wide).clamp(120.0, 420.0);
    let scale = scale(moments);
    let mut panels = Vec::new();
    for (k, moment) in moments.iter().enumerate() {
        let left = LEFT + k as f64 * (room + BETWEEN);
        let frame = Frame { left, top: TOP, right: left + room, bottom };
        let x = Axis::linear("x of the tip (µm)", low.0 - half, high.0 + half);
        let label = if k == 0 { "z of the tip (µm)" } else { "(µm)" };
        let mut panel = Panel::new(frame, x, Axis::linear(label, low.1 - half, high.1 + half));
        panel.title = moment.title.clone();
        for (&place, &load) in places.iter().zip(&moment.loads) {
            match load {
                Some(load) => panel.shapes.push(cell(place, FILLED * pitch, load / scale.to.max(-scale.from))),
                None => panel.lines.extend(cross(place, 0.3 * pitch)),
            }
        }
        panels.push(panel);
    }
    panels.push(colour_bar(scale, bottom));
    Picture { title: title.into(), height: (bottom + 54.0).ceil() as u32, panels }
}

/// Of the loads, from the largest push to the largest pull.
fn scale(moments: &[Moment]) -> Axis {
    let loads = moments.iter().flat_map(|moment| moment.loads.iter().flatten());
    let (low, high) = loads.fold((0.0f64, 0.0f64), |(low, high), &load| (low.min(load), high.max(load)));
    let least = 1e-6 * low.abs().max(high).max(f64::MIN_POSITIVE);
    Axis::linear("load of the tip (nN)", low.min(-least), high.max(least))
}

/// A square around a place.
fn cell((x, z): (f64, f64), side: f64, share: f64) -> Shape {
    let half = 0.5 * side;
    let corners = vec![(x - half, z - half), (x + half, z - half), (x + half, z + half), (x - half, z + half)];
    Shape { corners, colour: signed_shade(share), opacity: 1.0 }
}

/// A cross, where a tip is detached.
fn cross((x, z): (f64, f64), half: f64) -> [Line; 2] {
    [1.0, -1.0].map(|up| {
        let points = vec![(x - half, z - up * half), (x + half, z + up * half)];
        Line::plain(points, Stroke::solid(colour::GREY, 1.0))
    })
}

/// What the colours mean.
fn colour_bar(scale: Axis, bottom: f64) -> Panel {
    let right = f64::from(WIDTH) - 18.0;
    // an axis without a tick in its range
    let none = Axis::linear("", 0.1, 0.9);
    let at = |share: f64| scale.from + share * (scale.to - scale.from);
    let largest = scale.to.max(-scale.from);
    let strip = |k: usize| {
        let [from, middle, to] = [0.0, 0.5, 1.0 + OVERLAP].map(|part| at(((k as f64 + part) / SHADES as f64).min(1.0)));
        let corners = vec![(none.from, from), (none.to, from), (none.to, to), (none.from, to)];
        Shape { corners, colour: signed_shade(middle / largest), opacity: 1.0 }
    };
    let shapes = (0..SHADES).map(strip).collect();
    let frame = Frame { left: right - 24.0, top: TOP, right, bottom };
    Panel { shapes, ..Panel::new(frame, none.clone(), scale.clone()) }
}
