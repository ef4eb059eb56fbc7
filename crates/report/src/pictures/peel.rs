//! The pictures of one peel: force against displacement, and the deformed strip at numbered points of that curve.

use super::curve::{add_branch, curve_picture, limit_at, mark_loss, nearest_to};
use super::shapes::posed::{Posed, shapes_picture};
use crate::chart::marked::{Marked, mark_found};
use crate::chart::output::save_all;
use crate::chart::picture::{Heading, Picture};
use crate::pictures::shapes::in_space;
use crate::writing::error::ReportError;
use crate::writing::names::end_reason;
use peelkit::study::{
    DeformedShape, LimitPoint, LimitPointKind, OutOfPlane, OutOfPlaneBranch, PathEnd, Peel, WarningKind,
};
use std::path::{Path, PathBuf};

/// How many deformed shapes are shown.
const SHAPES: usize = 6;

/// Draws `curve.svg`, `curve.png`, `shapes.svg` and `shapes.png` into `dir`.
///
/// The curve carries its limit points and its peak with their values; what is unstable under displacement control
/// is dashed. Where its stability out of the plane is known, its first loss is marked. The shapes are those of the points with the same
/// numbers on the curve.
///
/// Fails where there is nothing to draw ([`ReportError::Draw`]) or a file cannot be written ([`ReportError::Write`]).
pub fn draw_peel<'h>(
    peel: &Peel,
    out_of_plane: Option<&OutOfPlane>,
    heading: impl Into<Heading<'h>>,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    draw_peel_with_branch(peel, out_of_plane, None, &[], heading, dir)
}

/// The same with the branch that leaves the plane at the first loss, and with what is `marked` on the path, in the same pictures.
///
/// Fails as [`draw_peel`].
pub fn draw_peel_with_branch<'h>(
    peel: &Peel,
    out_of_plane: Option<&OutOfPlane>,
    branch: Option<&OutOfPlaneBranch>,
    marked: &[Marked],
    heading: impl Into<Heading<'h>>,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let numbered = numbered_points(peel);
    let heading = heading.into();
    let title = captioned(peel, heading.title);
    let heading = heading.titled(&title);
    let mut picture = curve(peel, &numbered, heading, &dir.join("curve.svg"))?;
    if let Some(loss) = out_of_plane.and_then(|stability| stability.first_loss) {
        mark_loss(&mut picture, &loss);
    }
    if let Some(branch) = branch {
        add_branch(&mut picture, branch);
    }
    mark_found(&mut picture.panels, marked);
    let shapes = shapes(peel, &numbered, heading, &dir.join("shapes.svg"))?;
    save_all(&[(picture, "curve"), (shapes, "shapes")], dir)
}

/// The text of curve.svg, without the numbers of deformed shapes and without a stability out of the plane.
///
/// Fails where there is nothing to draw ([`ReportError::Draw`]).
pub fn curve_svg<'h>(peel: &Peel, heading: impl Into<Heading<'h>>) -> Result<String, ReportError> {
    let (path, heading) = (Path::new("curve.svg"), heading.into());
    let picture = curve(peel, &[], heading.titled(&captioned(peel, heading.title)), path)?;
    picture.svg().map_err(|error| ReportError::Draw { path: path.to_path_buf(), reason: error.to_string() })
}

/// The title with a caption: how the computation ended where it stopped short, and what of the model is not to be trusted in what the
/// picture shows.
pub fn captioned(peel: &Peel, title: &str) -> String {
    let mut lines = vec![title.lines().collect::<Vec<_>>().join(" ")];
    if let PathEnd::Failed(why) = &peel.end {
        let why = why.to_string();
        let first = why.split(". ").next().unwrap_or_default().trim_end_matches('.');
        lines.push(format!("The computation stopped short: {first}."));
    }
    let shown = |kind| {
        use WarningKind::{FoldedOutline, FoldedSideways, LargeStrain, ShortBeam, ShortProcessZone};
        matches!(kind, ShortProcessZone | FoldedOutline | FoldedSideways | ShortBeam | LargeStrain)
    };
    let warnings = peel.warnings().into_iter().filter(|warning| shown(warning.kind));
    lines.extend(warnings.map(|warning| format!("Warning: {warning}.")));
    lines.join("\n")
}

/// The beam at a numbered point: at the limit point that is next to it, or else at the point itself.
#[derive(Clone, Debug)]
pub struct Pose {
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// Its axis
    pub axis: DeformedShape,
}

/// The pose of `points[index]`; nothing where there is no such point.
pub fn pose(peel: &Peel, index: usize) -> Option<Pose> {
    let point = peel.points.get(index)?;
    let at_limit = limit_at(peel, index).and_then(|limit| Some((limit, peel.shape_at_limit_point(limit)?)));
    Some(match at_limit {
        Some((limit, axis)) => Pose { displacement: limit.displacement, force: limit.force, axis },
        None => Pose { displacement: point.displacement, force: point.force, axis: peel.smooth_shape(index) },
    })
}

/// The curve of a peel that has one; `path` is what the message names.
///
/// Fails with [`ReportError::Draw`] where the path has fewer than two points.
pub fn curve<'h>(
    peel: &Peel,
    numbered: &[usize],
    heading: impl Into<Heading<'h>>,
    path: &Path,
) -> Result<Picture, ReportError> {
    if peel.points.len() < 2 {
        return Err(nothing(path, peel));
    }
    Ok(curve_picture(peel, numbered, heading.into()))
}

/// The deformed strip at the numbered points; `path` is what the message names.
///
/// Fails with [`ReportError::Draw`] where none of the points has a shape.
pub fn shapes<'h>(
    peel: &Peel,
    numbered: &[usize],
    heading: impl Into<Heading<'h>>,
    path: &Path,
) -> Result<Picture, ReportError> {
    if let Some(space) = &peel.model.space {
        let posed = in_space::posed(peel, numbered);
        if posed.is_empty() {
            return Err(nothing(path, peel));
        }
        return Ok(in_space::shapes_picture(&posed, &peel.model, space, heading.into()));
    }
    // A force that the path has brought to zero is printed as zero.
    let largest = peel.points.iter().fold(0.0f64, |r, p| r.max(p.force.abs()));
    let poses: Vec<Posed> = numbered
        .iter()
        .enumerate()
        .filter_map(|(n, &i)| {
            let Pose { displacement, force, axis } = pose(peel, i)?;
            let force = if force.abs() > 1e-6 * largest { force } else { 0.0 };
            Some(Posed { number: n + 1, displacement, force, axis, thickness: peel.model.thickness_over_height() })
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
    Ok(shapes_picture(&poses, &peel.model.ground.substrate, heading.into()))
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
    let at = |limit: &LimitPoint| nearest_to(peel, limit);
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
            in_space: None,
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
            in_space: None,
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
