//! Between which widths a strip's planar path is stable out of the plane.
//!
//! The planar equilibria of a straight strip are, per width, those of any width. So one path serves all of them: at
//! each of its equilibria the roll is stable up to some width, and down to another. The limits of the path are the
//! least and the largest of these, located along the path as well.

use super::result::{NotOutOfPlane, OutOfPlaneError};
use super::roll_elements::{RollReader, RollingBeam};
use super::run::{TwoSteps, Valley};
use crate::model::body::Body;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::newton::on_more_elements;
use crate::solve::state::Observables;
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::{DIFFERENCE_BOUND_FACTOR, ROUND_OFF_PLACE, least};
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;

/// Widths are looked for from the height divided by this to the height times this.
const FARTHEST: f64 = 300.0;
/// How many widths are looked at before anything is located.
const LOOKS: usize = 80;
/// Most looks at a limit along the path, and how little the last one changes, relative.
const MOST_LOOKS: usize = 14;
const SETTLED: f64 = 1e-11;
/// Most halvings of the widths between which a limit lies.
const MOST_HALVINGS: usize = 60;

/// The widths between which the planar path of a strip is stable out of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WidthRange {
    /// A narrower strip leaves its plane; nothing where none that is looked at does
    pub narrowest: Option<WidthLimit>,
    /// A wider strip leaves its plane; nothing where none that is looked at does
    pub widest: Option<WidthLimit>,
}

/// A width up to which, or from which on, a path is stable out of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WidthLimit {
    /// b, nm
    pub width: f64,
    /// Bound on its error, nm
    pub width_error: f64,
    /// u at which a strip of a width just beyond it leaves its plane, nm
    pub displacement: f64,
    /// P there over the width, nN/nm
    pub force_per_width: f64,
}

/// From which side the widths are looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    Narrow,
    Wide,
}

impl Peel {
    /// The widths between which the whole planar path of this strip is stable out of the plane: the widest such range
    /// from 1/300 to 300 times the height; nothing where no width is stable.
    ///
    /// # Errors
    /// As [`Peel::out_of_plane`], and where the body is no strip.
    pub fn planar_widths(&self) -> Result<Option<WidthRange>, OutOfPlaneError> {
        if let Some(refusal) = NotOutOfPlane::of(&self.model) {
            return Err(refusal.into());
        }
        let Body::Strip(strip) = &self.model.body else { return Err(OutOfPlaneError::NoStrip) };
        let history =
            self.trace.as_ref().filter(|trace| !trace.points.is_empty()).ok_or(OutOfPlaneError::NoSolutions)?;
        let beam = history.problem.beam.planar().ok_or(NotOutOfPlane::InSpace)?;
        let reader = RollReader::new(&self.model, beam);
        let beams: Vec<RollingBeam> = history.points.iter().map(|point| reader.rolling(&point.at)).collect();
        let search = WidthSearch { reader: &reader, history, beams: &beams, own: strip.width, relative: self.asked };
        let width = |look: usize| strip.height * FARTHEST.powf(2.0 * look as f64 / (LOOKS - 1) as f64 - 1.0);
        let stable: Vec<bool> = (0..LOOKS).map(|look| search.is_stable(width(look))).collect();
        let Some((from, to)) = longest_run(&stable) else { return Ok(None) };
        let mut ws = Workspace::default();
        let mut limit = |stable: usize, beyond: Option<usize>, side| {
            beyond.map(|beyond| search.limit((width(stable), width(beyond)), side, &mut ws)).transpose()
        };
        let beyond = Some(to + 1).filter(|&beyond| beyond < LOOKS);
        Ok(Some(WidthRange {
            narrowest: limit(from, from.checked_sub(1), Side::Narrow)?,
            widest: limit(to, beyond, Side::Wide)?,
        }))
    }
}

/// The first and the last of the longest run of what holds.
fn longest_run(holds: &[bool]) -> Option<(usize, usize)> {
    let starts = (0..holds.len()).filter(|&k| holds[k] && (k == 0 || !holds[k - 1]));
    let run = |start: usize| (start, start + holds[start..].iter().take_while(|&&holds| holds).count() - 1);
    starts.map(run).max_by_key(|(from, to)| to - from)
}

struct WidthSearch<'s> {
    reader: &'s RollReader<'s>,
    history: &'s SolutionHistory,
    beams: &'s [RollingBeam],
    /// Width of the strip whose path it is, nm
    own: f64,
    relative: f64,
}

impl WidthSearch<'_> {
    fn margin(&self, beam: &RollingBeam, width: f64) -> f64 {
        self.reader.stability_of_width(beam, width).map_or(f64::NEG_INFINITY, |found| found.margin())
    }

    fn is_stable(&self, width: f64) -> bool {
        self.beams.iter().all(|beam| self.margin(beam, width) > 0.0)
    }

    /// The width between a stable one and one beyond at which an equilibrium loses its stability; where it is stable
    /// there, twice as far and farther.
    fn limit_of(&self, beam: &RollingBeam, (mut stable, mut beyond): (f64, f64)) -> Option<f64> {
        let factor = beyond / stable;
        let (low, high) = (self.own.min(stable) / FARTHEST.powi(2), self.own.max(stable) * FARTHEST.powi(2));
        while self.margin(beam, beyond) > 0.0 {
            (stable, beyond) = (beyond, beyond * factor);
            if !(low..high).contains(&beyond) {
                return None;
            }
        }
        let (mut at_stable, mut at_beyond) = (self.margin(beam, stable), self.margin(beam, beyond));
        for look in 1..=MOST_HALVINGS {
            let chord = stable + (beyond - stable) * at_stable / (at_stable - at_beyond);
            let is_chord = look % 3 != 0 && at_beyond.is_finite();
            let at = if is_chord { chord } else { 0.5 * (stable + beyond) };
            let margin = self.margin(beam, at);
            let moved = (at - if margin > 0.0 { stable } else { beyond }).abs();
            if margin > 0.0 {
                (stable, at_stable) = (at, margin);
            } else {
                (beyond, at_beyond) = (at, margin);
            }
            if is_chord && moved <= 1e-14 * at || (beyond - stable).abs() <= 1e-13 * at {
                return Some(at);
            }
        }
        Some(stable)
    }

    /// The limit of the path between a stable width and one beyond that is not.
    fn limit(&self, widths: (f64, f64), side: Side, ws: &mut Workspace) -> Result<WidthLimit, OutOfPlaneError> {
        // what is sought is the least: of the widths themselves, or of their inverses
        let depth = |width: Option<f64>| match (width, side) {
            (Some(width), Side::Wide) => width,
            (Some(width), Side::Narrow) => 1.0 / width,
            (None, _) => f64::MAX,
        };
        let depths: Vec<f64> = self.beams.iter().map(|beam| depth(self.limit_of(beam, widths))).collect();
        let point = (0..depths.len()).min_by(|&a, &b| depths[a].total_cmp(&depths[b])).unwrap_or(0);
        let at_point = (self.history.points[point].clone(), depths[point]);
        let located = match point {
            0 => Ok((at_point, 0.0)),
            last if last + 1 == depths.len() => Ok((at_point, 0.0)),
            _ => self.deepest(point, &depths, |beam| depth(self.limit_of(beam, widths)), ws),
        };
        let u = |point: usize| self.history.points[point.min(depths.len() - 1)].observables.displacement;
        let not_located =
            |cause| OutOfPlaneError::NotLocated { from: u(point.saturating_sub(1)), to: u(point + 1), cause };
        let ((solution, deepest), change) = located.map_err(not_located)?;
        let finer = on_more_elements(&self.history.problem, &solution, Observables::DISPLACEMENT, ws);
        let finer = finer.or_else(|_| on_more_elements(&self.history.problem, &solution, Observables::FORCE, ws));
        let finer = depth(self.limit_of(&self.reader.rolling(&finer.map_err(not_located)?.at), widths));
        let width = if side == Side::Wide { deepest } else { 1.0 / deepest };
        let difference = (finer - deepest).abs() / deepest + change;
        let o = &solution.observables;
        Ok(WidthLimit {
            width,
            width_error: (DIFFERENCE_BOUND_FACTOR * difference + least(self.relative) + ROUND_OFF_PLACE) * width,
            displacement: o.displacement,
            force_per_width: o.force / self.own,
        })
    }

    /// Where a number of the equilibria around a point is least, and how much the last look changed it, relative.
    fn deepest(
        &self,
        point: usize,
        depths: &[f64],
        depth: impl Fn(&RollingBeam) -> f64,
        ws: &mut Workspace,
    ) -> Result<((std::sync::Arc<Solution>, f64), f64), SolveError> {
        let mut around = TwoSteps::around(self.reader, self.history, point);
        let [before, least, behind] = around.ends();
        let mut valley = Valley {
            before: (before, depths[point - 1]),
            least: (least, depths[point]),
            behind: (behind, depths[point + 1]),
        };
        let (mut found, mut change) = (self.history.points[point].clone(), f64::INFINITY);
        for _ in 0..MOST_LOOKS {
            let Some((place, value)) = valley.next() else { break };
            change = ((value - valley.least.1) / valley.least.1).abs();
            if change <= SETTLED {
                break;
            }
            let solution = around.solution(place, ws)?;
            let look = (place, depth(&self.reader.rolling(&solution.at)));
            if look.1 < valley.least.1 {
                found = solution;
            }
            valley = valley.with(look);
        }
        Ok(((found, valley.least.1), if change.is_finite() { change } else { 0.0 }))
    }
}

#[cfg(test)]
mod tests {
    use super::longest_run;

    #[test]
    fn the_longest_run_is_found() {
        assert_eq!(longest_run(&[false, true, false, true, true, false]), Some((3, 4)));
        assert_eq!(longest_run(&[true, true]), Some((0, 1)));
        assert_eq!(longest_run(&[false]), None);
    }
}
