//! What is read off an equilibrium of a seta of beams, and what is kept of it.

use super::progress::{BeforePeak, Run};
use crate::beam::spatial::rotation::matrix;
use crate::beam::spatial::tree::read::BranchSection;
use crate::model::seta::tip_law::TipBranch;
use crate::solve::newton::Solution;
use crate::solve::problem::Problem;
use crate::solve::state::State;
use crate::study::seta::standing::RootDrive;
use crate::study::states::seta_state::{JointPlace, LocationError, SetaPoint, SetaState, SpatulaState, TipState};
use std::sync::Arc;

/// Sine of the angle by which the free end of a spatula has turned up where it stands on its face.
const UPRIGHT: f64 = std::f64::consts::FRAC_1_SQRT_2;

impl Run<'_> {
    /// The spatulae that stand on the face of their end.
    pub(crate) fn upright<'s>(&'s self, at: &'s State) -> impl Iterator<Item = usize> + 's {
        let ends = self.model.seta.joints();
        let rises = move |tip: usize| matrix(self.tree.joint(at, ends + tip).1)[1][0] > UPRIGHT;
        (0..self.reached.off.len()).filter(move |&tip| rises(tip) && self.branch(at, tip).adheres())
    }

    /// Whether a spatula adheres.
    pub(crate) fn branch(&self, at: &State, tip: usize) -> TipBranch {
        let nearest = || self.tree.nearest(at, self.model.spatula_of(tip));
        let adheres = !self.reached.off[tip] && nearest() < self.model.reach();
        if adheres { TipBranch::Attached } else { TipBranch::Detached }
    }

    fn attached(&self, at: &State) -> usize {
        (0..self.reached.off.len()).filter(|&tip| self.branch(at, tip).adheres()).count()
    }

    pub(crate) fn is_off(&self, at: &State) -> bool {
        self.attached(at) == 0
    }

    pub(crate) fn last(&self) -> SetaPoint {
        self.reached.result.points.last().copied().unwrap_or_default()
    }

    /// Whether the step under way has a point.
    pub(crate) fn has_begun_step(&self) -> bool {
        self.reached.result.points.last().is_some_and(|last| last.step == self.reached.step)
    }

    /// The numbers of an equilibrium, with work and energy released as before.
    pub(crate) fn point(&self, drive: &RootDrive, solution: &Solution, before: SetaPoint) -> SetaPoint {
        let numbers = [solution.observables.displacement, solution.observables.force, solution.energy];
        self.with_numbers(drive, &solution.at, numbers, before)
    }

    /// The same of any state on a stable piece, with the work that its energy says.
    pub(crate) fn point_of(&self, problem: &Problem, drive: &RootDrive, at: &State, before: SetaPoint) -> SetaPoint {
        let [x, y, z] = self.tree.joint(at, 0).0;
        let root = [x, y - self.model.foot(), z];
        let displacement =
            drive.direction().iter().zip(root).zip(drive.from).map(|((d, at), from)| d * (at - from)).sum();
        let energy = problem.system.evaluate(at, &vec![0.0; problem.system.unknowns(at)]).0.energy;
        let point = self.with_numbers(drive, at, [displacement, at.force, energy], before);
        SetaPoint { work: before.work + (energy - before.energy), ..point }
    }

    fn with_numbers(
        &self,
        drive: &RootDrive,
        at: &State,
        [displacement, force_along, energy]: [f64; 3],
        before: SetaPoint,
    ) -> SetaPoint {
        let (root, rest) = (drive.root(displacement), self.model.seta.joint_place(0));
        let section = self.tree.section(at, 0, 0);
        SetaPoint {
            step: self.reached.step,
            displacement,
            root: std::array::from_fn(|i| root[i] - rest[i]),
            force: section.force.map(|force| -force),
            force_along,
            moment: section.moment.map(|moment| -moment),
            attached: self.attached(at),
            outside: 0,
            energy,
            ..before
        }
    }

    /// Joints, branches, tips and spatulae in a state.
    pub(crate) fn state(&self, at: &State, point: SetaPoint, location: Option<LocationError>) -> SetaState {
        let seta = &self.model.seta;
        let section = |tip: usize, boundary: usize| self.tree.section(at, self.model.spatula_of(tip), boundary);
        let tip = |tip: usize| {
            let [x, _, z] = seta.joint_place(seta.tip_joint(tip));
            // what the shaft holds it with is what the ground pulls with
            let held = section(tip, self.model.elements).force;
            TipState { on: self.branch(at, tip), foot: [x, 0.0, z], load: held.map(|force| -force) }
        };
        let spatula = |tip: usize| SpatulaState {
            radius: self.model.half_height(),
            sections: (0..=self.model.elements)
                .rev()
                .map(|boundary| {
                    let BranchSection { place, directors, force, moment } = section(tip, boundary);
                    // as those of the seta: of the ground on what is behind it
                    let [force, moment] = [force, moment].map(|of| of.map(|part| -part));
                    BranchSection { place, directors, force, moment }
                })
                .collect(),
        };
        SetaState {
            point,
            location,
            joints: (0..seta.joints()).map(|joint| self.tree.joint(at, joint).into()).collect(),
            between: (1..seta.joints())
                .map(|joint| self.tree.between_joints(at, joint - 1).into_iter().map(JointPlace::from).collect())
                .collect(),
            tips: (0..seta.tips()).map(tip).collect(),
            spatulae: (0..seta.tips()).map(spatula).collect(),
            raised: self.model.foot(),
        }
    }

    /// Goes on to an equilibrium with these numbers; its state.
    pub(crate) fn push(
        &mut self,
        solution: &Arc<Solution>,
        point: SetaPoint,
        location: Option<LocationError>,
    ) -> SetaState {
        self.reached.here = Some(solution.clone());
        self.reached.displacement = point.displacement;
        self.reached.result.points.push(point);
        self.state(&solution.at, point, location)
    }

    /// Keeps a state of the pull whose force is the largest so far.
    pub(crate) fn keep_peak(&mut self, state: &SetaState, before: Option<BeforePeak>) {
        let known = self.reached.result.peak.as_ref().map(|peak| peak.point);
        if self.is_last() && known.is_none_or(|known| state.point.force_along > known.force_along) {
            self.reached.result.peak = Some(state.clone());
            self.reached.before_peak = before;
        }
    }
}
