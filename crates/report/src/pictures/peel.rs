//! The pictures of one peel: force against displacement, and the deformed strip at numbered points of that curve.

use super::curve::curve_picture;
use super::shapes::{Posed, shapes_picture};
use crate::chart::{Picture, save};
use crate::error::ReportError;
use crate::names::end_reason;
use peelkit::study::{LimitPoint, LimitPointKind, Peel, WarningKind};
use std::path::{Path, PathBuf};

/// How many deformed shapes are shown.
const SHAPES: usize = 6;

/// Draws `curve.svg`, `curve.png`, `shapes.svg` and `shapes.png` into `dir`.
///
/// The curve carries its limit points and its peak with their values; what is unstable under displacement control
/// is dashed. The shapes are those of the points with the same numbers on the curve.
///
/// Fails where there is nothing to draw ([`ReportError::Draw`]) or a file cannot be written ([`ReportError::Write`]).
pub fn draw_peel(peel: &Peel, title: &str, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let numbered = numbered_points(peel);
    let mut files = save(&curve(peel, &numbered, title, &dir.join("curve.svg"))?, dir, "curve")?;
    let caption = captioned(peel, title);
    files.extend(save(&shapes(peel, &numbered, &caption, &dir.join("shapes.svg"))?, dir, "shapes")?);
    Ok(files)
}

/// The title of the shapes, with what is not to be trusted in them.
fn captioned(peel: &Peel, title: &str) -> String {
    let folded = peel.warnings().into_iter().find(|warning| warning.kind == WarningKind::FoldedOutline);
    folded.map_or_else(|| title.to_owned(), |at| format!("{title} (outlines fold: |κ| h/2 up to {:.2})", at.value))
}

/// The curve of a peel that has one; `path` is what the message names.
///
/// Fails with [`ReportError::Draw`] where the path has fewer than two points.
pub fn curve(peel: &Peel, numbered: &[usize], title: &str, path: &Path) -> Result<Picture, ReportError> {
    if peel.points.len() < 2 {
        return Err(nothing(path, peel));
    }
    Ok(curve_picture(peel, numbered, title))
}

/// The deformed strip at the numbered points; `path` is what the message names.
///
/// Fails with [`ReportError::Draw`] where none of the points has a shape.
pub fn shapes(peel: &Peel, numbered: &[usize], title: &str, path: &Path) -> Result<Picture, ReportError> {
    // A force that the path has brought to zero is printed as zero.
    let largest = peel.points.iter().fold(0.0f64, |r, p| r.max(p.force.abs()));
    let poses: Vec<Posed> = numbered
        .iter()
        .enumerate()
        .filter_map(|(n, &i)| {
            let point = peel.points.get(i)?;
            let force = if point.force.abs() > 1e-6 * largest { point.force } else { 0.0 };
            Some(Posed { number: n + 1, displacement: point.displacement, force, axis: peel.shape(i) })
        })
        .filter(|posed| posed.axis.x.len() > 1)
        .collect();
    if poses.is_empty() && !numbered.is_empty() {
        let reason = format!("no deformed shape is known at the {} points asked for", numbered.len());
        return Err(ReportError::Draw { path: path.to_path_buf(), reason });
    }
    if poses.is_empty() {
        return Err(nothing(path, peel));
    }
    Ok(shapes_picture(&poses, &peel.model.ground.substrate, title))
}

fn nothing(path: &Path, peel: &Peel) -> ReportError {
    let why = end_reason(&peel.end).map(|why| format!(": the computation ended with '{why}'")).unwrap_or_default();
    let reason = format!("the path has {} points{why}", peel.points.len());
    ReportError::Draw { path: path.to_path_buf(), reason }
}

/// Characteristic path points: at the initiation peak, on the plateau, at the snap-off, at the end of the snap-back
/// and at the end; the longest segments between them and from rest on are halved until there are enough.
pub fn numbered_points(peel: &Peel) -> Vec<usize> {
    let Some(last) = peel.points.len().checked_sub(1) else { return Vec::new() };
    let nearest = |u: f64, from: usize, to: usize| {
        (from..=to.max(from).min(last)).min_by(|&a, &b| {
            let off = |i: usize| (peel.points[i].displacement - u).abs();
            off(a).total_cmp(&off(b))
        })
    };
    let at = |limit: &LimitPoint| nearest(limit.displacement, limit.after.min(last), limit.after + 1);
    let snap_off = peel.snap_off.as_ref().and_then(at);
    let mut chosen: Vec<usize> = vec![last];
    chosen.extend(peel.initiation_peak.and_then(|p| nearest(p.displacement, 0, snap_off.unwrap_or(last))));
    chosen.extend(peel.limit_points.iter().filter(|p| p.kind == LimitPointKind::Displacement).take(2).filter_map(at));
    chosen.sort_unstable();
    chosen.dedup();
    // Lengths along the curve as it is seen, each axis by its own range.
    let seen = seen_lengths(peel);
    while chosen.len() < SHAPES.min(last + 1) {
        let Some(next) = halfway(&chosen, &seen) else { break };
        chosen.push(next);
        chosen.sort_unstable();
    }
    chosen
}

/// The point halfway along the longest segment between chosen ones.
fn halfway(chosen: &[usize], seen: &[f64]) -> Option<usize> {
    // from rest to the first is a segment as well
    let from_rest: Vec<usize> = std::iter::once(0).chain(chosen.iter().copied()).collect();
    let stretches = from_rest.windows(2).filter(|w| w[1] > w[0] + 1);
    let longest = stretches.max_by(|a, b| (seen[a[1]] - seen[a[0]]).total_cmp(&(seen[b[1]] - seen[b[0]])))?;
    let middle = 0.5 * (seen[longest[0]] + seen[longest[1]]);
    (longest[0] + 1..longest[1]).min_by(|&a, &b| (seen[a] - middle).abs().total_cmp(&(seen[b] - middle).abs()))
}

fn seen_lengths(peel: &Peel) -> Vec<f64> {
    let range = peel.points.iter().fold(0.0f64, |r, p| r.max(p.displacement.abs())).max(f64::MIN_POSITIVE);
    let mut length = 0.0;
    let mut lengths = vec![0.0];
    for pair in peel.points.windows(2) {
        length += (pair[1].displacement - pair[0].displacement).abs() / range;
        lengths.push(length);
    }
    lengths
}

#[cfg(test)]
mod tests {
    use super::*;
    use peelkit::model::StripModel;
    use peelkit::study::{Accuracy, PathPoint, Peak, StopCriteria};

    #[test]
    fn the_numbered_points_tell_the_story() {
        let bounds = StopCriteria::default();
        let mut peel = peelkit::study::peel(&StripModel::of_the_paper(100.0, 1.0), &Accuracy::to(1e-6), &bounds);
        let at = |displacement: f64| PathPoint {
            displacement,
            force: 1.0,
            end_rotation: 0.0,
            work: 0.0,
            negative_eigenvalues: 0,
            negative_eigenvalues_load: 0,
            front: 0.0,
            iterations: 0,
        };
        let limit = |displacement: f64, after: usize| LimitPoint {
            kind: LimitPointKind::Displacement,
            displacement,
            force: 1.0,
            end_rotation: 0.0,
            work: 0.0,
            displacement_error: 0.0,
            force_error: 0.0,
            work_error: None,
            flat: false,
            after,
        };
        peel.points = [0.0, 0.1, 0.26, 5.0, 10.0, 24.0, 40.0, 48.1, 30.0, 23.5, 30.0, 70.0].map(at).to_vec();
        peel.limit_points = vec![limit(48.2, 6), limit(23.4, 9)];
        peel.snap_off = Some(limit(48.2, 6));
        let (force, end_rotation, force_error, displacement_error) = (1.0, 0.0, 0.0, 0.0);
        peel.initiation_peak = Some(Peak { displacement: 0.25, force, end_rotation, force_error, displacement_error });
        assert_eq!(numbered_points(&peel), [2, 5, 7, 9, 10, 11]);
        peel.points.clear();
        assert!(numbered_points(&peel).is_empty());
    }
}
