//! Snap-through of circular arches on two hinges: every limit point, and points of the path in between.

use super::rods::{DISPLACEMENT, LEFT_ROTATION, TOLERANCE, cantilever, problem};
use crate::check::{Check, Measure};
use crate::suite::reference;
use crate::suite::reference::Row;
use peelkit::beam::{ReferenceCurve, TIP_ROTATION};
use peelkit::model::{BeamProblem, Drive, Hold, RodModel, Support};
use peelkit::solve::{LimitPointKind, Pace, PathOptions, Solution, controlled};
use peelkit::study::{RodLimitPoint, RodPath, follow_rod};

/// Limit points, and points of the paths.
const TURNS: &str = include_str!("../../../verification/arch_turns.csv");
pub(crate) const CURVE: &str = include_str!("../../../verification/arch_curve.csv");

/// Where a path ends: beyond the last point of the table.
const FAR: f64 = 2.3;

const SOURCE: &str = "verification/arch.py: shooting";

pub(super) fn checks() -> Vec<Check> {
    ["shallow", "steep"].iter().flat_map(|name| checks_of(name)).collect()
}

/// Half an arch, its crown on the line of symmetry, driven down.
pub(crate) fn half_arch(row: &Row) -> RodModel {
    let number = |column| row.number(column).unwrap_or(f64::NAN);
    let opening = number("opening");
    RodModel {
        rest: ReferenceCurve::arc(opening, -opening),
        left: Support::HINGED,
        right: Support { x: Hold::Fixed, y: Hold::Free, rotation: Hold::Fixed },
        ..cantilever(number("axial"), number("shear"), Drive::Y)
    }
}

/// Rows of a table that belong to one arch.
pub(crate) fn rows_of(table: &str, arch: &str) -> Vec<Row> {
    reference::read(table).into_iter().filter(|row| row.text("arch") == Some(arch)).collect()
}

fn checks_of(name: &str) -> Vec<Check> {
    let (turns, curve) = (rows_of(TURNS, name), rows_of(CURVE, name));
    let Some(model) = turns.first().map(half_arch) else { return Vec::new() };
    let (fine, coarse) = (snapped(&model, 7, 6), snapped(&model, 4, 4));
    let mut checks = vec![Check::new(
        format!("limit points of load and displacement, {name} arch pressed to {FAR} times its rise"),
        SOURCE,
        fine.as_ref().map(|(_, path)| path.turns.len() as f64).map_err(String::clone),
        turns.len() as f64,
        Measure::Absolute,
        0.0,
    )];
    for (k, row) in turns.iter().enumerate() {
        let kind = row.text("kind").unwrap_or("?");
        let label = format!("limit point {} ({kind}) of the {name} arch", k + 1);
        for (what, column) in [("lowering of the crown, L", "lowering"), ("load of half the arch, EI/L²", "load")] {
            let expected = row.number(column).unwrap_or(f64::NAN);
            let value =
                |(_, path): &(BeamProblem, RodPath)| Ok(of_turn(path, k, kind)?.0[usize::from(column == "load")]);
            checks.push(Check::new(
                format!("{what}, {label}"),
                SOURCE,
                fine.as_ref().map_err(String::clone).and_then(value),
                expected,
                Measure::Absolute,
                1e-10,
            ));
        }
        let expected = row.number("load").unwrap_or(f64::NAN);
        let share = |(_, path): &(BeamProblem, RodPath)| {
            let ([_, load], [_, difference]) = of_turn(path, k, kind)?;
            Ok((load - expected).abs() / (2.0 * difference))
        };
        checks.push(Check::new(
            format!("true error of the load over its bound, 4 elements of order 4, {label}"),
            "at most 1: the bound is twice the difference to half as many elements again",
            coarse.as_ref().map_err(String::clone).and_then(share),
            1.0,
            Measure::AtMost,
            0.0,
        ));
    }
    checks.push(Check::new(
        format!("largest difference of load (EI/L²), lowering (L) or hinge rotation on the {name} arch's path"),
        SOURCE,
        fine.and_then(|(problem, path)| largest_difference(&problem, &path, &curve)),
        0.0,
        Measure::AtMost,
        1e-10,
    ));
    checks
}

/// The path from rest to a lowering of [`FAR`] times the rise.
pub(crate) fn snapped(model: &RodModel, order: usize, elements: usize) -> Result<(BeamProblem, RodPath), String> {
    let problem = problem(model, order)?;
    let rise = model.rest.at(1.0)[1];
    let options = PathOptions {
        elements,
        step_tolerance: 1e-4,
        stride: 1.0,
        longest: None,
        prediction: 8,
        tolerance: TOLERANCE,
        first_displacement: -0.01 * rise,
        pace: Pace::Quick,
    };
    let path = follow_rod(&problem, options, 2000, |point| -point.observables.displacement > FAR * rise);
    path.map(|path| (problem, path)).map_err(|error| error.to_string())
}

/// Lowering and load at a limit point of the expected kind, and their differences to more elements.
fn of_turn(path: &RodPath, k: usize, kind: &str) -> Result<([f64; 2], [f64; 2]), String> {
    let expected = if kind == "load" { LimitPointKind::Load } else { LimitPointKind::Displacement };
    let RodLimitPoint { located, .. } =
        path.turns.get(k).filter(|t| t.kind == expected).ok_or("no such limit point")?;
    let (o, d) = (&located.observables, &located.difference);
    Ok(([-o.displacement, -o.force], [d.displacement.abs(), d.force.abs()]))
}

/// The largest difference between the path and points of the table. Each is approached from the nearest path point with the
/// lowering or the hinge's rotation held, whichever changes faster along the path.
fn largest_difference(problem: &BeamProblem, path: &RodPath, table: &[Row]) -> Result<f64, String> {
    let mut largest = 0.0f64;
    for row in table {
        let number = |column| row.number(column).ok_or(format!("the table has no {column}"));
        let wanted = [-number("lowering")?, number("hinge_rotation")?, -number("load")?];
        let off = |s: &Solution| distance(observed(s), wanted);
        let near = path.points.iter().min_by(|a, b| off(a).total_cmp(&off(b))).ok_or("the path has no points")?;
        let by_rotation = near.slope.monitors[TIP_ROTATION].abs() > near.slope.displacement.abs();
        let (weights, target) = if by_rotation { (LEFT_ROTATION, wanted[1]) } else { (DISPLACEMENT, wanted[0]) };
        let found = controlled(problem, near.at.clone(), weights, &[target], TOLERANCE).map_err(|e| e.to_string())?;
        let computed = observed(&found[0]);
        largest = (0..3).map(|i| (computed[i] - wanted[i]).abs()).fold(largest, f64::max);
    }
    Ok(largest)
}

/// Displacement of the crown, rotation of the hinge, load.
fn observed(solution: &Solution) -> [f64; 3] {
    let o = &solution.observables;
    [o.displacement, o.monitors[TIP_ROTATION], o.force]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(0.1 * (a[2] - b[2]))
}
