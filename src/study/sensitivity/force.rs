//! How the force at a held displacement changes with parameters, on the first stable branch of a path.

use super::carried::Beside;
use super::point::{Adjoint, Held, solved};
use super::residual_change::Stencil;
use super::run::{discretisation, solutions};
use super::{NoSensitivities, Variation};
use crate::solve::Workspace;
use crate::study::{LimitPointKind, Peel};
use rayon::prelude::*;

/// The force P (nN) at displacements (nm) on the first stable branch of the path, from its beginning to its first displacement limit point, and
/// dP/dx there with the displacement held: one row a displacement, one column a variation.
///
/// # Errors
/// As of [`super::sensitivities`], and for a displacement that is not on that branch.
pub fn force_derivatives(
    peel: &Peel,
    displacements: &[f64],
    variations: &[Variation],
) -> Result<Vec<(f64, Vec<f64>)>, NoSensitivities> {
    let history = solutions(peel)?;
    let problem = &history.problem;
    let turn = peel.limit_points.iter().find(|point| point.kind == LimitPointKind::Displacement);
    let last = turn.map_or(history.points.len(), |turn| turn.after + 1);
    let branch = &history.points[..last];
    let most = turn.map(|turn| turn.displacement);
    let most = most.or_else(|| branch.last().map(|point| point.observables.displacement)).unwrap_or(0.0);
    let adjoint = |&displacement: &f64| {
        let missing = NoSensitivities::NotOnBranch { displacement, most };
        if displacement.is_nan() || displacement > most {
            return Err(missing);
        }
        let next = branch.partition_point(|point| point.observables.displacement <= displacement);
        let near = branch.get(next.saturating_sub(1)).ok_or(missing)?;
        let ahead = (displacement - near.observables.displacement) / near.slope.displacement;
        let mut ws = Workspace::default();
        let not_solved = |cause| NoSensitivities::NotSolved { of: "the force", cause };
        let start = near.moved(problem, ahead);
        let found = solved(problem, start, Held::Displacement, displacement, &mut ws).map_err(not_solved)?;
        let adjoint = Adjoint::new(problem, &found.at, Held::Displacement, &mut ws).map_err(not_solved)?;
        Ok((found.observables.force, adjoint))
    };
    let points: Vec<(f64, Adjoint)> = displacements.par_iter().map(adjoint).collect::<Result<_, _>>()?;
    let (base, how) = (Beside::base(problem, &peel.model), discretisation(peel));
    let column = |variation: &Variation| -> Result<Vec<f64>, NoSensitivities> {
        let beside = Stencil::beside(variation, &base, how)?;
        let stencil = Stencil::new(&base, &beside);
        if points.iter().any(|(_, point)| !stencil.has_unknowns_of(&point.at)) {
            return Err(NoSensitivities::AnotherKind { key: variation.key.clone() });
        }
        let one = |(_, point): &(f64, Adjoint)| {
            let value = stencil.force(point).estimate().value;
            let not_finite = || NoSensitivities::NotFinite { key: variation.key.clone(), of: "the force" };
            if value.is_finite() { Ok(value) } else { Err(not_finite()) }
        };
        points.iter().map(one).collect()
    };
    let columns: Vec<Vec<f64>> = variations.par_iter().map(column).collect::<Result<_, _>>()?;
    Ok(points.iter().enumerate().map(|(k, (force, _))| (*force, columns.iter().map(|c| c[k]).collect())).collect())
}
