//! The folds of a path behind which the pad, and behind which nothing of the beam, adheres any more.

use super::adhering::Adhering;
use super::equilibrium_path::followed::Followed;
use super::points::LimitPoint;
use super::result::{PathEnd, Peel};
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::points::kind::LimitPointKind;
use crate::study::stop_criteria::{Bound, FollowedUntil};

impl Peel {
    /// Looks for them, on a path that was followed to where it ends by itself, or to where nothing adheres: elsewhere it may come back.
    pub(super) fn find_detachment(&mut self, problem: &BeamProblem, followed: &Followed) {
        let is_off = matches!(self.end, PathEnd::Detached | PathEnd::Bound(Bound::Until(FollowedUntil::Detachment)));
        let comes_off = is_off || self.end == PathEnd::Pivoting;
        if !comes_off || followed.trouble.is_some() || problem.system.has_history() {
            return;
        }
        let near = self.model.line_law().adhering_distance();
        let of = |at| Adhering::of(&problem.beam, at, near);
        let turns_back = |&&index: &&usize| {
            let at = &self.limit_points[index];
            at.kind == LimitPointKind::Displacement && followed.points[at.after].slope.displacement > 0.0
        };
        let indices: Vec<usize> = (0..self.limit_points.len()).collect();
        let mut folds: Vec<usize> = indices.iter().filter(turns_back).copied().collect();
        let place = |index: usize| self.limit_points[index].displacement;
        folds.sort_by(|&a, &b| place(b).total_cmp(&place(a)));
        // what adheres on the path behind a fold where the grip is further away
        let behind = |index: usize| {
            let LimitPoint { after, displacement, .. } = self.limit_points[index];
            let beyond = followed.points[after + 1..].iter();
            beyond.filter(move |s| s.observables.displacement > displacement).map(|s| of(&s.at))
        };
        let pad = folds.iter().copied().find(|&index| of(&followed.turns[index].2.solution.at) == Adhering::Pad);
        let pad = pad.filter(|&index| behind(index).all(|adhering| adhering != Adhering::Pad));
        let last = folds.first().copied().filter(|_| is_off);
        let last = last.filter(|&index| behind(index).all(|adhering| adhering == Adhering::Nothing));
        self.pad_detachment = pad.map(|index| self.limit_points[index]);
        self.detachment = last.map(|index| self.limit_points[index]);
    }
}
