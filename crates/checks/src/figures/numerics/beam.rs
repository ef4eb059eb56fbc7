//! The beam without adhesion, for teaching: a cantilever rolled up, arches snapped through, with independent points.

use crate::figures::figure::{Figure, Table};
use crate::suite::beam::arch::{CURVE, half_arch, rows_of, snapped};
use crate::suite::beam::rods::{DISPLACEMENT, cantilever, nodes, under_control};
use peelkit::model::Drive;
use peelkit::solve::Solution;
use peelkit_report::ReportError;
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Stroke, colour, order_shade};
use std::f64::consts::TAU;
use std::path::Path;

const STEM: &str = "beam-checks";
/// Full circles of the shapes shown.
const CIRCLES: [f64; 5] = [0.125, 0.25, 0.5, 1.0, 2.0];
const ARCHES: [(&str, RGBColor); 2] = [("shallow", colour::BLUE), ("steep", colour::VERMILLION)];
/// The y axes of both panels, pixels.
const TOP: f64 = 56.0;
const BOTTOM: f64 = 396.0;

/// The figure; `dir` is where it is written.
pub(in crate::figures) fn figure(dir: &Path) -> Result<Figure, ReportError> {
    let failed = |reason: String| ReportError::Draw { path: dir.join(format!("{STEM}.svg")), reason };
    let mut table = Table::new(&["curve", "x", "y", "kind"]);
    let panels = vec![rolled(&mut table).map_err(failed)?, arches(&mut table).map_err(failed)?];
    let picture = Picture { title: "The beam without adhesion".into(), height: 450, panels };
    let caption = "Left: a cantilever that an end moment rolls up, from an eighth of a circle to two full ones; dots: the \
                   closed form. Right: circular arches on two hinges, pressed down at the crown, load against lowering, \
                   half an arch being L long; dots: shooting (`verification/arch.py`). The shallow arch opens over 0.8 rad, \
                   the steep one over 1.4 rad; EA L²/EI = 400. The steep arch has four load limit points and two \
                   displacement limit points. In the data, x and y of the left panel are in L, lowering and load of the right \
                   one in L and EI/L².";
    Figure::write(dir, STEM, caption.into(), &picture, &table)
}

/// The rolled-up cantilever, to scale.
fn rolled(table: &mut Table) -> Result<Panel, String> {
    let frame = Frame { left: 76.0, top: TOP, right: 386.0, bottom: BOTTOM };
    let (from, to) = (-0.3, 1.1);
    let high = (to - from) * (BOTTOM - TOP) / frame.width();
    let mut panel = Panel::new(frame, Axis::linear("x / L", from, to), Axis::linear("y / L", -0.1, high - 0.1));
    panel.title = "Rolled up by an end moment".into();
    let turns = CIRCLES.map(|circles| circles * TAU);
    let rod = cantilever(1e4, 4e3, Drive::Rotation);
    let found = under_control(&rod, 7, 16, DISPLACEMENT, &turns)?;
    for (i, (solution, turn)) in found.iter().zip(turns).enumerate() {
        let name = format!("{} circle{}", CIRCLES[i], if CIRCLES[i] > 1.0 { "s" } else { "" });
        let shade = order_shade(i, CIRCLES.len());
        let points = nodes(&rod, 7, solution)?;
        record(table, &name, &points, "computed");
        let circle: Vec<(f64, f64)> = (1..=12)
            .map(|k| turn * f64::from(k) / 12.0)
            .map(|angle| (angle.sin() / turn, (1.0 - angle.cos()) / turn))
            .collect();
        record(table, &name, &circle, "closed form");
        panel.marks.extend(circle.into_iter().map(|at| dot(at, shade, "closed form")));
        panel.lines.push(Line { points, stroke: Stroke::solid(shade, 2.0), name: Some(name) });
    }
    Ok(panel)
}

/// Load against lowering of the arches.
fn arches(table: &mut Table) -> Result<Panel, String> {
    let frame = Frame { left: 468.0, top: TOP, right: 784.0, bottom: BOTTOM };
    let (x, y) =
        (Axis::linear("lowering of the crown / L", 0.0, 0.8), Axis::linear("P L² / EI of half the arch", -4.5, 6.5));
    let mut panel = Panel::new(frame, x, y);
    panel.title = "Arches snapping through".into();
    for (name, colour) in ARCHES {
        let rows = rows_of(CURVE, name);
        let model = rows.first().map(half_arch).ok_or("the table of arches is empty")?;
        let (_, path) = snapped(&model, 7, 6)?;
        let at = |point: &Solution| (-point.observables.displacement, -point.observables.force);
        let points: Vec<(f64, f64)> = path.points.iter().map(|point| at(point)).collect();
        record(table, name, &points, "computed");
        let independent: Vec<(f64, f64)> =
            rows.iter().filter_map(|row| Some((row.number("lowering")?, row.number("load")?))).collect();
        record(table, name, &independent, "shooting");
        panel.marks.extend(independent.into_iter().map(|at| dot(at, colour, "shooting")));
        panel.lines.push(Line { points, stroke: Stroke::solid(colour, 2.0), name: Some(format!("{name} arch")) });
    }
    panel.lines.push(Line {
        points: vec![(0.0, 0.0), (0.8, 0.0)],
        stroke: Stroke::solid(colour::GREY, 0.8),
        name: None,
    });
    Ok(panel)
}

fn dot(at: (f64, f64), colour: RGBColor, name: &str) -> Mark {
    Mark { name: Some(name.to_string()), ..Mark::dot(at, colour) }
}

fn record(table: &mut Table, curve: &str, points: &[(f64, f64)], kind: &str) {
    points.iter().for_each(|&(x, y)| table.push(&[curve], &[Some(x), Some(y)], &[kind]));
}
