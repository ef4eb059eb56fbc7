//! What a peel takes: against the accuracy, against length and stiffness of the strip, and beside other programs.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::{ACCURACY, BOUNDS, Runner, paper_strip};
use crate::suite::reference;
use crate::work_precision::measure::work_precision;
use crate::work_precision::report::write_work_precision;
use peelkit::model::StripModel;
use peelkit::study::{Peel, peel, power_law};
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Stroke, Symbol, WIDTH, colour, significant};
use peelkit_report::{ReportError, end_word, timed};
use peelkit_scene::BoundsTable;
use std::path::Path;

/// Lengths and stiffnesses of the cost: so many a decade, from and to.
const LENGTHS: (f64, f64, usize) = (30.0, 30_000.0, 4);
const FACTORS: (f64, f64, usize) = (1e-5, 1e2, 2);
/// Length of the strip whose stiffness varies, nm.
const LENGTH: f64 = 100.0;
/// Peels that are counted.
pub(in crate::figures) const PEELS: usize = 13 + 15;
/// A time is the least of so many.
const REPEATS: usize = 7;

const OTHERS: &str = include_str!("../../../verification/solve_bvp.csv");
/// AUTO-07p, the whole path: error and CPU time in s, measured apart on a machine of this kind.
const AUTO: [(f64, f64); 2] = [(7e-8, 0.19), (2e-10, 0.47)];

pub(in crate::figures) fn figures(runner: &Runner<'_>, dir: &Path) -> Result<Vec<Figure>, ReportError> {
    let mut figures = vec![cost(runner, dir)?, others(dir)?];
    figures.extend(accuracy(dir)?);
    Ok(figures)
}

/// Time against error of every discretisation; nothing where the refined run fails, which `peel accuracy` says.
fn accuracy(dir: &Path) -> Result<Option<Figure>, ReportError> {
    let bounds = BoundsTable { points: 20_000, ..BoundsTable::default() };
    let Ok(measured) = work_precision(&paper_strip(LENGTH), &bounds, &|_| ()) else { return Ok(None) };
    let files = write_work_precision(dir, &measured, &format!("strip of {LENGTH} nm"))?;
    let caption = format!(
        "CPU time of the whole peel of a strip of {LENGTH} nm against its error, compared with a refined run: elements of order 1 to 8 on a \
         mesh that moves with the front; at order 7 the three-field form, fixed meshes, and other steps. Above the larger error of \
         initiation peak and snap-off, below that of the curve between the path points. Diamonds: the automatic choice for \
         `relative` = 1e-3 to 1e-10. Times are of the machine that drew the figure. `peel accuracy` does it for any scene."
    );
    Ok(Some(Figure { stem: "accuracy", caption, files }))
}

/// One peel of the cost.
struct Cost {
    value: f64,
    model: StripModel,
    milliseconds: f64,
    peel: Peel,
}

fn measure(runner: &Runner<'_>, (from, to, a_decade): (f64, f64, usize), model: fn(f64) -> StripModel) -> Vec<Cost> {
    let steps = ((to / from).log10() * a_decade as f64).round() as usize;
    let one = |k: usize| {
        let value = from * 10f64.powf(k as f64 / a_decade as f64);
        let model = model(value);
        let (peel, first) = timed(|| runner.peel(&model));
        let again = (1..REPEATS).map(|_| timed(|| self::peel(&model, &ACCURACY, &BOUNDS)).1);
        let seconds = again.fold(first, f64::min);
        Cost { value, model, milliseconds: 1e3 * seconds, peel }
    };
    (0..=steps).map(one).collect()
}

/// Logarithm of the length in process zones.
fn zones(cost: &Cost) -> f64 {
    (cost.model.strip.length / cost.model.process_length()).asinh()
}

/// c and n of c zones^n.
fn fitted(costs: &[Cost], of: fn(&Cost) -> f64) -> (f64, f64) {
    power_law(costs.iter().map(|cost| (zones(cost), of(cost))))
}

fn cost(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let lengths = measure(runner, LENGTHS, paper_strip);
    let factors = measure(runner, FACTORS, |factor| StripModel::of_the_paper(LENGTH, factor));
    let mut table =
        Table::new(&["varied", "value", "solve_ms", "points", "newton_iterations", "elements", "order", "end"]);
    for (varied, costs) in [("length_nm", &lengths), ("ei_over_ei0", &factors)] {
        for cost in costs {
            let effort = cost.peel.effort;
            let counts = [effort.points, effort.newton_iterations, effort.elements, effort.order];
            let numbers: Vec<Option<f64>> =
                [cost.value, cost.milliseconds].into_iter().chain(counts.map(|n| n as f64)).map(Some).collect();
            table.push(&[varied], &numbers, &[end_word(&cost.peel.end)]);
        }
    }
    let exponent = |of: fn(&Cost) -> f64| significant(fitted(&lengths, of).1, 2);
    let caption = format!(
        "Time of a whole peel (path, limit points, error bounds, `relative` = 1e-6) on one core, the best of {REPEATS}. Left against the \
         length of the paper's strip; right against the bending stiffness at {LENGTH} nm. Dotted: c ln(2L/ℓ)^n fitted, ℓ the \
         length of the process zone: the elements grow with n = {}, the points of the path with {}, the time with {}. On the \
         right the soft strips re-adhere beyond the snap-off, a second peel; where the time jumps, a first mesh did not meet the tolerance. Times \
         are of the machine that drew the figure.",
        exponent(|c| c.peel.effort.elements as f64),
        exponent(|c| c.peel.effort.points as f64),
        exponent(|c| c.milliseconds),
    );
    Figure::write(dir, "cost", caption, &cost_picture(&lengths, &factors), &table)
}

fn cost_picture(lengths: &[Cost], factors: &[Cost]) -> Picture {
    let (left, gap, right) = (78.0, 70.0, 18.0);
    let width = (f64::from(WIDTH) - left - gap - right) / 2.0;
    let panel = |index: usize, label: &str, costs: &[Cost]| {
        let from = left + index as f64 * (width + gap);
        let frame = Frame { left: from, top: 40.0, right: from + width, bottom: 380.0 };
        let points: Vec<(f64, f64)> = costs.iter().map(|cost| (cost.value, cost.milliseconds)).collect();
        let y = if index == 0 { "time of a peel (ms)" } else { "" };
        let all = lengths.iter().chain(factors).map(|cost| cost.milliseconds);
        let mut panel =
            Panel::new(frame, Axis::around(label, points.iter().map(|p| p.0), true), Axis::around(y, all, true));
        panel.marks.extend(points.iter().map(|&at| Mark::dot(at, colour::BLUE)));
        panel.lines.push(Line { points, stroke: Stroke::solid(colour::BLUE, 2.0), name: None });
        panel
    };
    let mut against_length = panel(0, "length L (nm)", lengths);
    let (factor, power) = fitted(lengths, |cost| cost.milliseconds);
    against_length.lines.push(Line {
        points: lengths.iter().map(|cost| (cost.value, factor * zones(cost).powf(power))).collect(),
        stroke: Stroke::dotted(colour::INK, 1.6),
        name: Some(format!("c ln(2L/ℓ)^{}", significant(power, 2))),
    });
    let panels = vec![against_length, panel(1, "EI / EI₀", factors)];
    Picture { title: "Time of a whole peel against length and stiffness".into(), height: 430, panels }
}

/// The same strip by other programs.
fn others(dir: &Path) -> Result<Figure, ReportError> {
    let rows = reference::read(OTHERS);
    let points = |program: &str| -> Vec<(f64, f64)> {
        let mine = rows.iter().filter(|row| row.text("program") == Some(program));
        mine.filter_map(|row| Some((row.number("error")?, row.number("seconds")?))).collect()
    };
    let mut table = Table::new(&["program", "error", "seconds"]);
    let all = [("peel", points("peel")), ("scipy solve_bvp", points("scipy solve_bvp")), ("AUTO-07p", AUTO.to_vec())];
    for (program, points) in &all {
        for &(error, seconds) in points {
            table.push(&[program], &[Some(error), Some(seconds)], &[]);
        }
    }
    let caption = "The strip of 100 nm from rest over peak and snap-off to P = 0: time on one core against the largest relative error of \
                   displacement and force at peak and snap-off. scipy's `solve_bvp` with an arc length around it and `peel run` were timed in \
                   one run of `verification/solve_bvp.py`, which wrote [the table](../verification/solve_bvp.csv) that this picture is drawn from; \
                   peel's times include the error bounds. The two points of AUTO-07p were measured separately, on a machine of this kind."
        .to_owned();
    Figure::write(dir, "against-others", caption, &others_picture(&all), &table)
}

fn others_picture(all: &[(&str, Vec<(f64, f64)>)]) -> Picture {
    let each = || all.iter().flat_map(|(_, points)| points);
    let x = Axis::around("largest relative error of peak and snap-off", each().map(|p| p.0), true);
    let y = Axis::around("time (s)", each().map(|p| p.1), true);
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 400.0 };
    let mut panel = Panel::new(frame, x, y);
    for ((program, points), tone) in all.iter().zip([colour::BLUE, colour::VERMILLION, colour::GREY]) {
        let apart = *program == "AUTO-07p";
        panel.marks.extend(points.iter().map(|&at| Mark {
            symbol: if apart { Symbol::Diamond } else { Symbol::Dot },
            name: apart.then(|| "AUTO-07p, measured separately".to_owned()),
            ..Mark::dot(at, tone)
        }));
        if !apart {
            let name = Some((*program).to_owned());
            panel.lines.push(Line { points: points.clone(), stroke: Stroke::solid(tone, 2.0), name });
        }
    }
    Picture { title: "The same peel by other programs".into(), height: 450, panels: vec![panel] }
}
