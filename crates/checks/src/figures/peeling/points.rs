//! Peak force, plateau and work against bending stiffness, with points computed without finite elements drawn on them.

use super::stiffness::{LENGTH, Sweeps};
use crate::figures::figure::{Figure, Table};
use crate::suite::reference;
use crate::suite::reference::Row;
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{Axis, Frame, Line, Mark, Picture, Stroke, Symbol, WIDTH, colour};
use peelkit_report::pictures::sweep::{
    FORCE, STIFFNESS_LABEL, WORK, panel, per_width, plateau_per_width, series, work_per_width,
};
use peelkit_report::{ReportError, SweepRow};
use std::path::Path;

const POINTS: &str = include_str!("../../../verification/strip_points.csv");

/// A line load: its name in the table, its name in the legend, colour and width of its curves, the sweep behind them.
struct Load<'a> {
    name: &'static str,
    label: &'static str,
    colour: RGBColor,
    width: f64,
    rows: &'a [SweepRow],
}

/// A quantity: its column in the table, what the crate says of it, the symbol of the independent points.
struct Quantity {
    column: &'static str,
    value: fn(&SweepRow) -> Option<f64>,
    symbol: Symbol,
}

const PEAK: Quantity = Quantity {
    column: "peak_force_nN",
    value: |row| Some(per_width(row, row.found.initiation_peak?.force)),
    symbol: Symbol::Dot,
};
const PLATEAU: Quantity = Quantity { column: "plateau_force_nN", value: plateau_per_width, symbol: Symbol::Diamond };
const GRIP_WORK: Quantity = Quantity { column: "work_aJ", value: work_per_width, symbol: Symbol::Dot };

/// The figure for the sweeps of Fig. 10, whose curves it draws again.
pub(in crate::figures) fn figure(sweeps: &Sweeps, dir: &Path) -> Result<Figure, ReportError> {
    // where curves coincide the wider one below still shows
    let load = |name, label, colour, width, rows| Load { name, label, colour, width, rows };
    let loads = [
        load("full", "full: force and moment", colour::BLUE, 4.4, &sweeps.full),
        load("force-only", "force-only: without the moment", colour::VERMILLION, 2.8, &sweeps.force_only),
        load("axis-gap", "axis-gap: independent of rotation", colour::GREEN, 1.5, &sweeps.axis_gap),
    ];
    let points = reference::read(POINTS);
    let (data, worst) = compared(&loads, &points);
    let caption = format!(
        "Initiation peak (solid), plateau (dashed) and the work of the grip up to the snap-off of a strip of {LENGTH} nm \
         against its bending stiffness (EI alone varied), per width, for the three line loads, and on them what \
         `verification/strip_points.py` computes without finite elements: dots for peak and work, diamonds for the plateau. \
         The largest relative difference at the points is {worst:.0e}. The curves are those of \
         [fig10-bending-stiffness.csv](fig10-bending-stiffness.csv); the data here are the points. Where the load has a \
         potential (full, axis-gap) the work equals the change of energy; without the moment \
         (force-only) the soft strip comes off for a quarter of it."
    );
    Figure::write(dir, "independent-points", caption, &picture(&loads, &points), &data)
}

fn picture(loads: &[Load<'_>], points: &[Row]) -> Picture {
    let (left, right) = (88.0, f64::from(WIDTH) - 18.0);
    let x = Axis::around(STIFFNESS_LABEL, loads.iter().flat_map(|l| l.rows.iter().map(|r| r.value)), true);
    let lines = |quantity: &Quantity, stroke: fn(RGBColor, f64) -> Stroke, named: bool| {
        let one = |load: &Load<'_>| series(load.rows, quantity.value, stroke(load.colour, load.width), load.label);
        let unnamed = |line: Line| Line { name: line.name.filter(|_| named), ..line };
        loads.iter().flat_map(one).map(unnamed).collect::<Vec<_>>()
    };
    let mut forces = lines(&PEAK, Stroke::solid, true);
    forces.extend(lines(&PLATEAU, Stroke::dashed, false));
    let mut top = panel(Frame { left, top: 40.0, right, bottom: 400.0 }, &x, FORCE, forces);
    top.marks.extend(marks(points, &PEAK, "collocation: peak"));
    top.marks.extend(marks(points, &PLATEAU, "collocation: plateau"));
    let work = lines(&GRIP_WORK, Stroke::solid, false);
    let mut bottom = panel(Frame { left, top: 470.0, right, bottom: 690.0 }, &x, WORK, work);
    bottom.marks.extend(marks(points, &GRIP_WORK, "collocation: work"));
    Picture { title: "The strip with and without finite elements".into(), height: 744, panels: vec![top, bottom] }
}

/// The independent points of one quantity. The strip is 1 nm wide.
fn marks<'a>(points: &'a [Row], quantity: &'a Quantity, name: &'a str) -> impl Iterator<Item = Mark> + 'a {
    points.iter().filter_map(move |row| {
        let at = (row.number("bending_stiffness_factor")?, row.number(quantity.column)?);
        Some(Mark { at, symbol: quantity.symbol, colour: colour::INK, name: Some(name.into()), note: None })
    })
}

/// Each point of the table beside the value of the sweep at its stiffness, and the largest relative difference.
fn compared(loads: &[Load<'_>], points: &[Row]) -> (Table, f64) {
    let header = ["line_load", "quantity", "ei_over_ei0", "collocation", "finite_elements", "relative_difference"];
    let (mut table, mut worst) = (Table::new(&header), 0.0f64);
    for point in points {
        let Some(load) = loads.iter().find(|load| Some(load.name) == point.text("line_load")) else { continue };
        let Some(factor) = point.number("bending_stiffness_factor") else { continue };
        let row = load.rows.iter().find(|row| (row.value / factor - 1.0).abs() < 1e-9);
        for quantity in [&PEAK, &PLATEAU, &GRIP_WORK] {
            let value = row.and_then(quantity.value);
            let (Some(expected), Some(value)) = (point.number(quantity.column), value) else { continue };
            let difference = value / expected - 1.0;
            worst = worst.max(difference.abs());
            let numbers = [Some(factor), Some(expected), Some(value), Some(difference)];
            table.push(&[load.name, quantity.column], &numbers, &[]);
        }
    }
    (table, worst)
}
