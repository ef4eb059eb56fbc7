//! Force against displacement, with the limit points and the peak.
//!
//! The peel begins within a nanometre and runs on for a hundred: where that is so, a panel of its own shows the
//! initiation, and the panel of the whole path is cut above what follows.

use crate::chart::axis::{Axis, with_unit};
use crate::chart::canvas::Stroke;
use crate::chart::panel::{Line, Mark, Note, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour, order_shade};
use crate::chart::symbol::Symbol;
use crate::writing::names::first_jump_word;
use peelkit::study::{LimitPoint, LimitPointKind, OutOfPlaneBranch, OutOfPlaneLoss, PathEnd, Peel};
use peelkit::units::{FORCES, PreferredUnits};

const HEIGHT: u32 = 440;
/// About how many points the curve is drawn with.
const DENSE: usize = 1500;
/// The initiation panel reaches to so many times the displacement of the initiation peak.
const INITIATION: f64 = 16.0;
/// Most limit points that are labelled; all are marked.
const LABELLED: usize = 8;
/// A load limit point without a name whose force is less than this share of the largest goes without a label: nearly nothing adheres there.
const FAINT: f64 = 0.01;
/// A limit point nearer than this to a labelled one goes without a label, in parts of the ranges of both axes.
const CROWDED: f64 = 0.02;

/// Displacement (nm), force (nN) and what is known of the equilibria there.
type Curve = Vec<(f64, f64, Branch)>;

/// What is known of an equilibrium under displacement control.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Branch {
    Stable,
    Unstable,
    /// Of a path that stopped short: behind a change of stability that no located limit point explains.
    Unverified,
}

impl Branch {
    /// Of an equilibrium with so many negative eigenvalues.
    fn of(negative: usize) -> Self {
        if negative > 0 { Self::Unstable } else { Self::Stable }
    }

    fn stroke(self) -> Stroke {
        match self {
            Self::Stable => Stroke::solid(colour::BLUE, 2.0),
            Self::Unstable => Stroke::dashed(colour::VERMILLION, 2.0),
            Self::Unverified => Stroke::dotted(colour::GREY, 1.6),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Unstable => "unstable under displacement control",
            Self::Unverified => "stopped short: stability not verified",
        }
    }
}

/// The curve, densely up to where the stability of a path that stopped short is not verified, and its points from there on.
fn curve_of(peel: &Peel) -> Curve {
    let steps = (DENSE / peel.points.len().max(1)).clamp(2, 40);
    let dense = peel.dense_curve(steps);
    let known = |&(u, force, negative): &(f64, f64, usize)| (u, force, Branch::of(negative));
    let Some(last) = last_verified(peel) else { return dense.iter().map(known).collect() };
    // without its solutions a peel has its points alone
    let each = if dense.len() == peel.points.len() { 1 } else { steps };
    let unknown = peel.points[last + 1..].iter().map(|p| (p.displacement, p.force, Branch::Unverified));
    dense.iter().take(each * last + 1).map(known).chain(unknown).collect()
}

/// Of a path that stopped short the last point up to which located limit points explain every change of stability; nothing where they
/// explain all.
fn last_verified(peel: &Peel) -> Option<usize> {
    let PathEnd::Failed(_) = peel.end else { return None };
    let explained = |after: usize| {
        let between = peel.limit_points.iter().filter(|limit| limit.kind == LimitPointKind::Displacement);
        between.filter(|limit| limit.after == after).count()
    };
    let changes = |after: usize| {
        let [from, to] = [after, after + 1].map(|index| peel.points[index].negative_eigenvalues);
        from.abs_diff(to) != explained(after) && from != to
    };
    (0..peel.points.len().saturating_sub(1)).find(|&after| changes(after))
}

/// The curve of a peel with two or more points.
pub(super) fn curve_picture(peel: &Peel, numbered: &[usize], Heading { title, units }: Heading) -> Picture {
    let curve = curve_of(peel);
    let farthest = curve.iter().fold(0.0f64, |r, p| r.max(p.0));
    let zoom = peel.initiation_peak.map(|p| INITIATION * p.displacement).filter(|&u| u > 0.0 && u < 0.4 * farthest);
    let frame = |left, right| Frame {
        left,
        top: if zoom.is_some() { 52.0 } else { 40.0 },
        right,
        bottom: f64::from(HEIGHT) - 56.0,
    };
    let wide = f64::from(WIDTH) - 14.0;
    let mut panels = match zoom {
        Some(to) => {
            let first = panel(frame(74.0, 284.0), &curve, to, highest(&curve), units);
            let first = Panel { title: "initiation".to_owned(), ..first };
            let force = beyond(peel, &curve, to);
            let cut = peel.initiation_peak.map(|peak| peak.force).filter(|&peak| peak > 1.2 * force);
            let title = match cut {
                Some(peak) => {
                    format!("whole path without its peak, {}", with_unit(units.fitting(FORCES, peak), peak, 4))
                }
                None => "whole path".to_owned(),
            };
            let whole = panel(frame(366.0, wide), &curve, 1.04 * farthest, force, units);
            let mut whole = Panel { title, ..whole };
            whole.y.beside = first.y.to;
            vec![whole, first]
        }
        None => vec![panel(frame(84.0, wide), &curve, 1.04 * farthest, highest(&curve), units)],
    };
    name_stability(&mut panels[0], &curve);
    let panel_of = |at: (f64, f64)| {
        let early = zoom.is_some_and(|to| at.0 <= to) || !panels[0].shows(at);
        if early { panels.len() - 1 } else { 0 }
    };
    let marks = marks(peel, numbered, |name, at| values(name, at, &panels[panel_of(at)]));
    let placed: Vec<_> = marks.into_iter().map(|mark| (panel_of(mark.at), mark)).collect();
    placed.into_iter().for_each(|(panel, mark)| panels[panel].marks.push(mark));
    name_symbols(&mut panels[0]);
    Picture { title: title.into(), height: HEIGHT, panels }
}

fn highest(curve: &Curve) -> f64 {
    curve.iter().fold(0.0f64, |r, p| r.max(p.1)).max(f64::MIN_POSITIVE)
}

/// The force up to which the panel of the whole path reaches: from where the curve leaves the panel of the initiation, at
/// `u`, and well above all that follows.
fn beyond(peel: &Peel, curve: &Curve, u: f64) -> f64 {
    let leaving = curve.iter().find(|p| p.0 >= u).map_or(0.0, |p| p.1);
    let limits = peel.limit_points.iter().filter(|p| p.displacement > u).map(|p| p.force);
    let later = limits.chain(peel.plateau.map(|p| p.force)).fold(0.0, f64::max);
    let (reach, high) = (leaving.max(1.8 * later), highest(curve));
    if reach > 0.0 && reach < 0.7 * high { reach } else { high }
}

/// A panel from u = 0 or the smallest u to `to`, its force axis up to a little over `force`.
fn panel(frame: Frame, curve: &Curve, to: f64, force: f64, units: PreferredUnits) -> Panel {
    let shown = || curve.iter().filter(|p| p.0 <= to);
    let (left, low) = shown().fold((0.0f64, 0.0f64), |(u, f), p| (u.min(p.0), f.min(p.1)));
    let bottom = if low < -0.005 * force { low - 0.06 * (force - low) } else { 0.0 };
    let left = if left < -1e-6 * to { left - 0.03 * to } else { 0.0 };
    let x = Axis::linear("displacement u (nm)", left, to).in_units(units);
    let y = Axis::linear("force P (nN)", bottom, force + 0.12 * (force - bottom)).in_units(units);
    let mut panel = Panel::new(frame, x, y);
    if bottom < 0.0 {
        let zero = vec![(left, 0.0), (to, 0.0)];
        panel.lines.push(Line { points: zero, stroke: Stroke::solid(colour::GREY, 0.9), name: None });
    }
    for (branch, points) in runs(curve) {
        panel.lines.push(Line { points, stroke: branch.stroke(), name: None });
    }
    panel
}

/// The curve in segments of one kind; neighbours share their end points.
fn runs(curve: &Curve) -> Vec<(Branch, Vec<(f64, f64)>)> {
    let mut runs: Vec<(Branch, Vec<(f64, f64)>)> = Vec::new();
    for &(u, force, branch) in curve {
        match runs.last_mut() {
            Some((last, points)) if *last == branch => points.push((u, force)),
            Some((_, points)) => {
                let joint = points.last().copied().unwrap_or((u, force));
                runs.push((branch, vec![joint, (u, force)]));
            }
            None => runs.push((branch, vec![(u, force)])),
        }
    }
    runs
}

fn name_stability(panel: &mut Panel, curve: &Curve) {
    if curve.iter().all(|p| p.2 == Branch::Stable) {
        return;
    }
    for branch in [Branch::Stable, Branch::Unstable, Branch::Unverified] {
        let of_branch = panel.lines.iter_mut().filter(|line| line.stroke == branch.stroke());
        of_branch.for_each(|line| line.name = Some(branch.name().into()));
    }
}

fn name_symbols(panel: &mut Panel) {
    let shown: Vec<bool> = panel.marks.iter().map(|m| panel.shows(m.at)).collect();
    for (mark, _) in panel.marks.iter_mut().zip(shown).filter(|(_, shown)| *shown) {
        mark.name = match mark.symbol {
            Symbol::Diamond => Some("displacement limit point".into()),
            Symbol::Triangle => Some("load limit point".into()),
            _ => None,
        };
    }
}

/// Limit points and peak with their values, then the numbered points. `label` is what stands beside a point with a name or none.
fn marks(peel: &Peel, numbered: &[usize], label: impl Fn(Option<&str>, (f64, f64)) -> Note) -> Vec<Mark> {
    // Those with a name choose their places first.
    let mut limits: Vec<(Option<&str>, &LimitPoint)> =
        peel.limit_points.iter().map(|l| (title_of(peel, l), l)).collect();
    limits.sort_by_key(|(name, _)| name.is_none());
    let range = |of: fn(&LimitPoint) -> f64| peel.limit_points.iter().fold(0.0f64, |r, l| r.max(of(l).abs()));
    let (wide, high) = (range(|l| l.displacement), range(|l| l.force));
    let mut marks = Vec::new();
    let mut labelled: Vec<&LimitPoint> = Vec::new();
    for (name, limit) in limits {
        let near = |other: &&LimitPoint| {
            let apart = (limit.displacement - other.displacement).abs() / wide;
            apart + (limit.force - other.force).abs() / high < CROWDED
        };
        let is_faint = limit.kind == LimitPointKind::Load && limit.force.abs() < FAINT * high;
        let wanted = name.is_some() || (labelled.len() < LABELLED && !is_faint && !labelled.iter().any(near));
        labelled.extend(wanted.then_some(limit));
        let at = (limit.displacement, limit.force);
        let note = wanted.then(|| label(name, at));
        let symbol = if limit.kind == LimitPointKind::Displacement { Symbol::Diamond } else { Symbol::Triangle };
        marks.push(Mark { at, symbol, colour: colour::INK, name: None, note });
    }
    for (n, &i) in numbered.iter().enumerate() {
        let (badge, colour) = (Some(n + 1), order_shade(n, numbered.len()));
        let limit = limit_at(peel, i);
        let at = limit.map_or((peel.points[i].displacement, peel.points[i].force), |l| (l.displacement, l.force));
        // a limit point has its number beside its values
        match marks.iter_mut().find(|mark| limit.is_some() && mark.at == at) {
            Some(mark) => {
                mark.note.get_or_insert_default().badge = badge;
                mark.colour = colour;
            }
            None => {
                let note = Some(Note { badge, text: Vec::new() });
                marks.push(Mark { at, symbol: Symbol::Dot, colour, name: None, note });
            }
        }
    }
    marks
}

/// Marks where the path loses its stability out of the plane.
pub(super) fn mark_loss(picture: &mut Picture, loss: &OutOfPlaneLoss) {
    let at = (loss.displacement, loss.force);
    // the panel of the initiation is the last one
    if let Some(panel) = picture.panels.iter_mut().rfind(|panel| panel.shows(at)) {
        let note = Some(values(Some("leaves the plane"), at, panel));
        panel.marks.push(Mark { at, symbol: Symbol::Square, colour: colour::VERMILLION, name: None, note });
    }
}

/// Adds the branch that leaves the plane to a picture of the path that it leaves, dashed where it is unstable, in every panel.
pub(super) fn add_branch(picture: &mut Picture, branch: &OutOfPlaneBranch) {
    let mut curve = curve_of(&branch.peel);
    // it begins on the planar path, and where it ends there, ends on it
    let kind = |point: Option<&(f64, f64, Branch)>| point.map_or(Branch::Stable, |point| point.2);
    let (first, last) = (kind(curve.first()), kind(curve.last()));
    curve.insert(0, (branch.loss.displacement, branch.loss.force, first));
    curve.extend(branch.rejoins.map(|end| (end.displacement, end.force, last)));
    let farthest = curve.iter().fold(0.0f64, |r, p| r.max(p.0));
    if let Some(panel) = picture.panels.first_mut().filter(|panel| panel.x.to < farthest) {
        panel.x.to = 1.04 * farthest;
    }
    for panel in &mut picture.panels {
        for (kind, points) in runs(&curve) {
            let stroke = match kind {
                Branch::Stable => Stroke::solid(colour::GREEN, 2.0),
                Branch::Unstable => Stroke::dashed(colour::GREEN, 2.0),
                Branch::Unverified => kind.stroke(),
            };
            panel.lines.push(Line { points, stroke, name: None });
        }
    }
    if let Some(panel) = picture.panels.first_mut() {
        let is_of_branch = |line: &&mut Line| line.stroke.colour == colour::GREEN;
        let line = panel.lines.iter_mut().find(is_of_branch);
        line.into_iter().for_each(|line| line.name = Some("branch out of the plane, dashed where unstable".into()));
    }
}

/// The displacement limit point, or the initiation peak, of which this path point is the nearest.
pub(super) fn limit_at(peel: &Peel, index: usize) -> Option<&LimitPoint> {
    let is_peak = |limit: &LimitPoint| peel.initiation_peak.is_some_and(|peak| peak.displacement == limit.displacement);
    let shown = |limit: &&LimitPoint| limit.kind == LimitPointKind::Displacement || is_peak(limit);
    peel.limit_points.iter().filter(shown).find(|limit| nearest_to(peel, limit) == Some(index))
}

/// Of the path points on either side of a limit point the nearer one.
pub(super) fn nearest_to(peel: &Peel, limit: &LimitPoint) -> Option<usize> {
    let last = peel.points.len().checked_sub(1)?;
    let off = |i: usize| (peel.points[i].displacement - limit.displacement).abs();
    (limit.after.min(last)..=(limit.after + 1).min(last)).min_by(|&a, &b| off(a).total_cmp(&off(b)))
}

fn title_of(peel: &Peel, limit: &LimitPoint) -> Option<&'static str> {
    // A path that returns passes the place of its peak again: the first one carries the name.
    let is = |u: Option<f64>| {
        let here = |l: &&LimitPoint| l.kind == limit.kind && u.is_some_and(|u| same(u, l.displacement));
        peel.limit_points.iter().find(here) == Some(limit)
    };
    match limit.kind {
        LimitPointKind::Displacement if is(peel.snap_off.map(|s| s.displacement)) => Some(first_jump_word(peel)),
        LimitPointKind::Displacement if is(peel.detachment.map(|s| s.displacement)) => Some("detachment"),
        LimitPointKind::Load if is(peel.initiation_peak.map(|p| p.displacement)) => Some("initiation peak"),
        LimitPointKind::Load if is(peel.peak.map(|p| p.displacement)) => Some("peak force"),
        _ => None,
    }
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * a.abs().max(b.abs())
}

/// Displacement and force of a point in the units of its panel.
fn values(name: Option<&str>, (u, force): (f64, f64), panel: &Panel) -> Note {
    let mut text: Vec<String> = name.map(String::from).into_iter().collect();
    text.push(format!("u = {}", panel.x.text_of(u, 4)));
    text.push(format!("P = {}", panel.y.text_of(force, 4)));
    Note { badge: None, text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_of_one_kind_share_their_end_points() {
        let curve = [(0.0, 0.0, 0), (1.0, 1.0, 0), (0.5, 0.8, 1), (0.2, 0.5, 2), (0.4, 0.0, 0)];
        let curve = curve.map(|(u, force, negative)| (u, force, Branch::of(negative))).to_vec();
        let expected = vec![
            (Branch::Stable, vec![(0.0, 0.0), (1.0, 1.0)]),
            (Branch::Unstable, vec![(1.0, 1.0), (0.5, 0.8), (0.2, 0.5)]),
            (Branch::Stable, vec![(0.2, 0.5), (0.4, 0.0)]),
        ];
        assert_eq!(runs(&curve), expected);
    }
}
