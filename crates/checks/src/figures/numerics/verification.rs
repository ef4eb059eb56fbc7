//! What the verification suite measures of the program itself: orders of convergence, and error bounds against true errors.

use crate::figures::figure::{Figure, Table};
use crate::suite::accuracy::bounds::{Judged, Survey, survey};
use crate::suite::accuracy::orders::{Convergence, Quantity, convergence};
use peelkit_report::ReportError;
use peelkit_report::chart::{
    Axis, Frame, Line, Mark, Note, Panel, Picture, Stroke, WIDTH, colour, order_shade, significant,
};
use std::path::Path;

pub(in crate::figures) fn figures(dir: &Path) -> Result<Vec<Figure>, ReportError> {
    let mut figures = vec![effectivity(&survey(), dir)?];
    // Where a mesh could not be solved there is nothing to draw; `peel verify` says so.
    if let Ok(all) = convergence() {
        figures.push(orders(&all, dir)?);
    }
    Ok(figures)
}

/// Error against number of elements, one panel a quantity, one line an order.
fn orders(all: &[Convergence], dir: &Path) -> Result<Figure, ReportError> {
    let mut table = Table::new(&["quantity", "order", "elements", "relative_error", "rate_at_h_0"]);
    for c in all {
        for &(elements, error) in &c.errors {
            let numbers = [Some(c.order as f64), Some(elements as f64), Some(error), c.extrapolated()];
            table.push(&[c.quantity.name()], &numbers, &[]);
        }
    }
    let caption =
        "Relative error of the energy, of the displacement at a given force, and of the peak force on uniform \
                   meshes of elements of order p = 1 to 8, against 40 elements of order 8 (strip of 12 nm, r0 = 1 nm). \
                   Theory: order 2p. The rates in the data are extrapolated to h = 0, as far as round-off lets them be. Errors below 5e-13 are round-off \
                   and left out. `peel verify --only orders` gates them."
            .to_owned();
    Figure::write(dir, "convergence", caption, &orders_picture(all), &table)
}

fn orders_picture(all: &[Convergence]) -> Picture {
    let (left, gap, right) = (78.0, 58.0, 14.0);
    let width = (f64::from(WIDTH) - left - right - 2.0 * gap) / 3.0;
    let panel = |(index, quantity): (usize, Quantity)| {
        let from = left + index as f64 * (width + gap);
        let frame = Frame { left: from, top: 60.0, right: from + width, bottom: 400.0 };
        let label = if index == 0 { "relative error" } else { "" };
        let mut panel = Panel::new(frame, Axis::log("elements", 0.8, 320.0), Axis::log(label, 1e-13, 1e-2));
        panel.title = quantity.name().into();
        for c in all.iter().filter(|c| c.quantity == quantity) {
            let shade = order_shade(c.order - 1, 8);
            let points: Vec<(f64, f64)> = c.errors.iter().map(|&(elements, error)| (elements as f64, error)).collect();
            panel.marks.extend(points.iter().map(|&at| Mark::dot(at, shade)));
            if let Some(mark) = panel.marks.last_mut().filter(|_| points.len() > 1) {
                mark.note = Some(Note { badge: Some(c.order), text: Vec::new() });
            }
            panel.lines.push(Line { points, stroke: Stroke::solid(shade, 1.8), name: None });
        }
        panel
    };
    let panels = Quantity::ALL.into_iter().enumerate().map(panel).collect();
    Picture { title: "Error against number of elements of order p = 1 to 8 (numbers)".into(), height: 450, panels }
}

/// Below this an error is that of the table.
const LEAST: f64 = 1e-14;

/// Bound against true error of every number that was judged.
fn effectivity(survey: &Survey, dir: &Path) -> Result<Figure, ReportError> {
    let mut table = Table::new(&["quantity", "scene", "relative_bound", "relative_error", "unknown"]);
    for j in &survey.judged {
        table.push(&[j.quantity], &[j.scene as f64, j.bound, j.error, j.unknown].map(Some), &[]);
    }
    let all = survey.effectivities();
    let quantile = |part: f64| all.get((part * all.len() as f64) as usize).copied().unwrap_or(f64::NAN);
    let caption = format!(
        "Reported error bound against true error of {} numbers of {} randomly sampled scenes at `relative = 1e-6`: initiation peak and \
         first two displacement limit points, the truth from a collocation without finite elements \
         (`verification/bound_scenes.csv`). A bound fails where a point lies below the line. {} of the bounds hold; bound \
         over error has the median {}, and nine of ten are above {}. Errors below the precision of the table are plotted at that \
         precision.",
        survey.judged.len(),
        survey.scenes,
        significant(survey.fraction_held(), 4),
        significant(quantile(0.5), 3),
        significant(quantile(0.1), 3),
    );
    Figure::write(dir, "error-bounds", caption, &effectivity_picture(survey), &table)
}

fn effectivity_picture(survey: &Survey) -> Picture {
    let x = Axis::log("true error, relative", LEAST, 1e-5);
    let y = Axis::log("reported bound, relative", 1e-11, 1e-5);
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 440.0 };
    let mut panel = Panel::new(frame, x, y);
    let line = |factor: f64, stroke, name: &str| Line {
        points: vec![(LEAST, factor * LEAST), (1e-5, factor * 1e-5)],
        stroke,
        name: Some(name.into()),
    };
    panel.lines.push(line(1.0, Stroke::solid(colour::INK, 1.6), "bound = error"));
    panel.lines.push(line(20.0, Stroke::dotted(colour::GREY, 1.4), "20 times the error"));
    let mut named = [false; 2];
    for judged in &survey.judged {
        let of_peak = judged.quantity.starts_with("peak");
        let (tone, name) =
            if of_peak { (colour::BLUE, "initiation peak") } else { (colour::VERMILLION, "limit points") };
        let first = !std::mem::replace(&mut named[usize::from(of_peak)], true);
        let mut mark = Mark::dot((error_drawn(judged), judged.bound), tone);
        mark.name = first.then(|| name.to_owned());
        panel.marks.push(mark);
    }
    Picture { title: "Reported error bounds against true errors".into(), height: 490, panels: vec![panel] }
}

fn error_drawn(judged: &Judged) -> f64 {
    judged.error.max(judged.unknown).max(LEAST)
}
