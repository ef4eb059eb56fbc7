//! One strip: Fig. 9 of the paper, and the whole peel curve with its shapes.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::{Runner, paper_strip};
use peelkit::study::{PathEnd, Peel};
use peelkit_report::ReportError;
use peelkit_report::chart::significant;
use peelkit_report::pictures::peel::{Pose, curve, numbered_points, pose, shapes};
use std::path::Path;

/// How many peels the figures of this file take.
pub(in crate::figures) const PEELS: usize = 2;

/// Shapes in Fig. 9, the one at rest included.
const SHAPES: usize = 7;

pub(in crate::figures) fn figures(runner: &Runner<'_>, dir: &Path) -> Result<Vec<Figure>, ReportError> {
    let long = runner.peel(&paper_strip(200.0));
    let short = runner.peel(&paper_strip(100.0));
    Ok(vec![peeling(&long, dir)?, peel_curve(&short, dir)?, peel_shapes(&short, dir)?])
}

fn peeling(peel: &Peel, dir: &Path) -> Result<Figure, ReportError> {
    let stem = "fig09-peeling";
    let shown = stable_shapes(peel);
    let picture = shapes(peel, &shown, "Peeling of an elastic strip, L = 200 nm", &dir.join(format!("{stem}.svg")))?;
    let caption = format!(
        "The strip of Fig. 9 of the paper (h = 10 nm, E = 2 GPa, A_H = 1e-19 J, r0 = 0.4 nm; the length of 200 nm is \
         ours), drawn to scale: at rest and lifted at its right end, which is free to turn and to move sideways, up \
         to the snap-off{}.",
        peel.snap_off.map(|s| format!(" at u = {} nm", significant(s.displacement, 5))).unwrap_or_default()
    );
    Figure::write(dir, stem, caption, &picture, &shape_table(peel, &shown))
}

/// The path point at rest and those nearest to even steps of u up to the snap-off.
pub(in crate::figures) fn stable_shapes(peel: &Peel) -> Vec<usize> {
    let last = peel.points.len().saturating_sub(1);
    let (to, end) = match peel.snap_off {
        Some(snap) => (snap.displacement, (snap.after + 1).min(last)),
        None => (peel.points.last().map_or(0.0, |p| p.displacement), last),
    };
    let off = |i: usize, u: f64| (peel.points[i].displacement - u).abs();
    let nearest = |n: usize| {
        let u = to * n as f64 / (SHAPES - 1) as f64;
        (0..=end).min_by(|&a, &b| off(a, u).total_cmp(&off(b, u))).unwrap_or(0)
    };
    let mut chosen: Vec<usize> = if peel.points.is_empty() { Vec::new() } else { (0..SHAPES).map(nearest).collect() };
    chosen.dedup();
    chosen
}

fn peel_curve(peel: &Peel, dir: &Path) -> Result<Figure, ReportError> {
    let stem = "peel-curve";
    let title = "Force against displacement, L = 100 nm";
    let picture = curve(peel, &numbered_points(peel), title, &dir.join(format!("{stem}.svg")))?;
    let caption = format!(
        "Force on the grip of a strip of 100 nm against its displacement. Left: initiation. Right: the whole path, \
         which {}. Dashed: equilibria that are unstable under displacement control. The numbers are those of \
         `peel-shapes`.",
        ending(&peel.end)
    );
    let mut figure = Figure::write(dir, stem, caption, &picture, &curve_table(peel))?;
    let mut points = Table::new(&["kind", "displacement_nm", "force_nN", "error_nm", "error_nN", "work_aJ"]);
    for limit in &peel.limit_points {
        let kind = format!("{:?}", limit.kind).to_lowercase();
        let errors = [limit.displacement_error, limit.force_error];
        let numbers = [limit.displacement, limit.force, errors[0], errors[1], limit.work].map(Some);
        points.push(&[&kind], &numbers, &[]);
    }
    figure.add_table(dir, "peel-curve-limit-points", &points)?;
    Ok(figure)
}

fn peel_shapes(peel: &Peel, dir: &Path) -> Result<Figure, ReportError> {
    let stem = "peel-shapes";
    let numbered = numbered_points(peel);
    let picture =
        shapes(peel, &numbered, "The strip at the numbered points of the curve", &dir.join(format!("{stem}.svg")))?;
    let caption = "The strip of `peel-curve`, drawn to scale, at the points numbered there.".to_string();
    Figure::write(dir, stem, caption, &picture, &shape_table(peel, &numbered))
}

pub(in crate::figures) fn curve_table(peel: &Peel) -> Table {
    let mut table = Table::new(&["displacement_nm", "force_nN", "negative_eigenvalues"]);
    for (u, force, negative) in peel.dense_curve(8) {
        table.push(&[], &[Some(u), Some(force)], &[&negative.to_string()]);
    }
    table
}

pub(in crate::figures) fn shape_table(peel: &Peel, shown: &[usize]) -> Table {
    let mut table = Table::new(&["shape", "displacement_nm", "force_nN", "x_nm", "y_nm", "rotation_rad"]);
    for (n, &i) in shown.iter().enumerate() {
        let Some(Pose { displacement, force, axis }) = pose(peel, i) else { continue };
        for ((x, y), turn) in axis.x.iter().zip(&axis.y).zip(&axis.rotation) {
            let numbers = [displacement, force, *x, *y, *turn].map(Some);
            table.push(&[&(n + 1).to_string()], &numbers, &[]);
        }
    }
    table
}

fn ending(end: &PathEnd) -> String {
    match end {
        PathEnd::Detached => "ends with the strip detached".into(),
        PathEnd::Pivoting => "ends where the force has returned to zero, still in edge contact at the left end".into(),
        PathEnd::Pushing => "ends beyond its snap-off, where the grip pushes".into(),
        PathEnd::TurnedBack => "ends with the strip re-adhered: u has returned to 0".into(),
        PathEnd::Sliding => "ends with the whole contact sliding".into(),
        PathEnd::Snapped => "ends with the snap-off".into(),
        PathEnd::BackInPlane => "ends with the strip back in its plane".into(),
        PathEnd::BondedPartUnstable(loss) => format!("ends where {loss}"),
        PathEnd::Upright(upright) => format!("ends where {upright}"),
        PathEnd::Bound(what) => format!("was stopped by a limit ({what})"),
        PathEnd::Failed(why) => format!("stops short ({why})"),
    }
}
