//! The pictures of the pull of an array: load against lift with its events, and how the load is shared just before the peak.

use super::tables::curve;
use crate::chart::axis::{Axis, with_unit};
use crate::chart::canvas::Stroke;
use crate::chart::output::save_all;
use crate::chart::panel::{Line, Mark, Panel, Shape};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{colour, signed_shade};
use crate::writing::error::ReportError;
use peelkit::analytic::winkler_number;
use peelkit::toe::ArrayPull;
use peelkit::units::{FORCES, PreferredUnits};
use peelkit_scene::{ArrayTable, BandLoad};
use std::path::{Path, PathBuf};

/// Most events that are drawn: others lie closer than a pixel.
const DRAWN: usize = 3000;
/// Share of the peak below which the tail of a curve is left out.
const SHOWN: f64 = 0.01;
/// Most setae of a map along one side.
const SIDE: usize = 120;

/// Draws `curve` and `sharing` into `dir`, as SVG and PNG.
///
/// Fails where no seta lets go ([`ReportError::Draw`]), or a file cannot be written ([`ReportError::Write`]).
pub fn draw_array<'h>(
    dir: &Path,
    table: &ArrayTable,
    pull: &ArrayPull,
    heading: impl Into<Heading<'h>>,
) -> Result<Vec<PathBuf>, ReportError> {
    let Some(peak) = pull.peak.and_then(|peak| pull.events.get(peak)) else {
        return Err(ReportError::Draw { path: dir.join("curve.svg"), reason: "no seta lets go".to_owned() });
    };
    let Heading { title, units } = heading.into();
    let moment = table.lamella.is_some_and(|lamella| lamella.load != BandLoad::Force);
    // µm and µN; a moment in µN µm over mrad
    let (x_of, y_of) = if moment { (1e3, 1e-6) } else { (1e-3, 1e-3) };
    let [x_label, y_label] =
        if moment { ["rotation (mrad)", "moment (µN µm)"] } else { ["lift (µm)", "load (µN)"] };
    let every = pull.events.len().div_ceil(DRAWN).max(1);
    let scaled = |(lift, load): (f64, f64)| (lift * x_of, load * y_of);
    let events: Vec<(f64, f64)> = pull.events.iter().step_by(every).map(|at| scaled((at.lift, at.load))).collect();
    let all = curve(pull);
    let kept = all.len().div_ceil(2 * DRAWN).max(1);
    let held: Vec<(f64, f64)> = all.into_iter().step_by(kept).map(scaled).collect();
    let end = shown(&held);
    let [held, events] = [held, events].map(|own| own.into_iter().filter(|at| at.0 <= end).collect::<Vec<_>>());
    let x = Axis::around(x_label, held.iter().chain(&events).map(|at| at.0), false);
    let y = Axis::around(y_label, held.iter().chain(&events).map(|at| at.1).chain([0.0]), false).in_units(units);
    let lines = vec![
        Line::plain(events, Stroke::solid(colour::GREY, 1.0)),
        Line::plain(held, Stroke::solid(colour::BLUE, 1.6)),
    ];
    let mut panel = Panel::of_lines(below_title(), x, y, lines);
    let value = panel.y.text_of(peak.load * y_of, 4);
    panel.marks.push(Mark::labelled(scaled((peak.lift, peak.load)), colour::INK, &["peak", &value]));
    panel.title =
        format!("{} events of {} setae; blue: the lift only grows, grey: every event", pull.events.len(), pull.setae);
    let shared = if table.patch.is_some() { map(pull, units) } else { rows(table, pull, peak.load) };
    let curve = Picture::of(title, vec![panel]).in_units(units);
    save_all(&[(curve, "curve"), (Picture::of(title, vec![shared]), "sharing")], dir)
}

/// The panel below two titles.
fn below_title() -> Frame {
    let across = Frame::across();
    Frame { top: across.top + 16.0, ..across }
}

/// How far the curve is shown: to where the load, behind its peak, has fallen for good to a hundredth of it.
fn shown(held: &[(f64, f64)]) -> f64 {
    let peak = held.iter().map(|at| at.1).fold(0.0, f64::max);
    let last = held.iter().rposition(|at| at.1 > SHOWN * peak);
    1.05 * last.and_then(|last| held.get(last + 1).or(held.last())).map_or(0.0, |at| at.0)
}

/// Force of every seta of a patch, or of one in so many, as colour; a detached one is left out.
fn map(pull: &ArrayPull, units: PreferredUnits) -> Panel {
    let columns = pull.columns;
    let rows = pull.forces.len() / columns.max(1);
    let every = rows.max(columns).div_ceil(SIDE).max(1);
    let largest = pull.forces.iter().flatten().map(|force| force.abs()).fold(f64::MIN_POSITIVE, f64::max);
    let x = Axis::linear("column", 0.5, columns as f64 + 0.5);
    let y = Axis::linear("row", 0.5, rows as f64 + 0.5);
    let mut panel = Panel::new(below_title(), x, y);
    let half = 0.5 * every as f64;
    for row in (0..rows).step_by(every) {
        for column in (0..columns).step_by(every) {
            let Some(force) = pull.forces[row * columns + column] else { continue };
            let (x, y) = (column as f64 + 0.5 + half, row as f64 + 0.5 + half);
            let corners = vec![(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)];
            panel.shapes.push(Shape { corners, colour: signed_shade(force / largest), opacity: 1.0 });
        }
    }
    panel.title = format!(
        "normal force of each seta just before the peak, ±{}; white: none or detached",
        with_unit(units.fitting(FORCES, largest), largest, 3)
    );
    panel
}

/// Force of every row of a band, over the load; beside it that of a half-infinite, smeared band.
fn rows(table: &ArrayTable, pull: &ArrayPull, load: f64) -> Panel {
    let points: Vec<(f64, f64)> =
        pull.rows.iter().enumerate().map(|(row, own)| (row as f64 + 1.0, own.force[1] / load)).collect();
    let moment = table.lamella.is_some_and(|lamella| lamella.load != BandLoad::Force);
    let unit =
        if moment { "normal force of a row over the moment (1/nm)" } else { "normal force of a row over the load" };
    let band = table.band().filter(|band| {
        table.toe.is_none() && !moment && band.pulled_at.is_none_or(|row| row == 0) && band.overhang == 0.0
    });
    let first = pull.rows.iter().position(|row| row.adhering > 0).unwrap_or(0);
    let closed: Vec<(f64, f64)> = band.map_or_else(Vec::new, |band| {
        let lambda = winkler_number(band.row_stiffness()[1][1], band.pitch, band.section.bending);
        let share = |row: usize| {
            let x = lambda * row as f64 * band.pitch;
            (row as f64 + 1.0, 2.0 * lambda * band.pitch * (-x).exp() * x.cos())
        };
        if first == 0 { (0..pull.rows.len()).map(share).collect() } else { Vec::new() }
    });
    let x = Axis::around("row", points.iter().map(|at| at.0), false);
    let y = Axis::around(unit, points.iter().chain(&closed).map(|at| at.1).chain([0.0]), false);
    let with_closed = !closed.is_empty();
    let mut lines = vec![Line::plain(points, Stroke::solid(colour::BLUE, 1.6))];
    if with_closed {
        lines.push(Line::plain(closed, Stroke::solid(colour::VERMILLION, 1.2)));
    }
    let mut panel = Panel::of_lines(below_title(), x, y, lines);
    panel.title = if with_closed {
        "just before the peak; red: half-infinite smeared band, nothing detached".to_owned()
    } else {
        "just before the peak".to_owned()
    };
    panel
}
