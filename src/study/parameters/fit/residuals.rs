//! The model at one set of parameters: residuals and their derivatives.

use super::coordinate::Coordinate;
use super::machine_curve::{Change, MachineCurve, Modelled, jump_derivatives};
use super::measured_curve::MeasuredCurve;
use super::problem::{CurveBy, CurveOf, DisplacementError, FitOptions, FitProblem, Loss, ParameterOf};
use super::pulled_curve::PulledCurve;
use super::result::NoFit;
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::parameters::sensitivity::force::forces_on_branch;
use crate::study::parameters::sensitivity::quantity::Variation;
use crate::study::peel::result::{PathEnd, Peel};
use crate::study::terms::term_selection::{checked, peel};
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Step of the coordinate by which the compliance is differentiated.
const STEP: f64 = 1e-4;
/// The same of all coordinates where there are no derivatives: curves are interpolated, and differences divide their errors by this.
const BESIDE: f64 = 1e-2;
/// A path that has no jump to find is followed this much farther than the points go, over their range.
const BEYOND: f64 = 0.1;

/// What computes the model for a set of parameters.
pub(super) struct Evaluator<'a> {
    pub problem: &'a FitProblem<'a>,
    pub coordinates: Vec<Coordinate>,
    pub measured: &'a MeasuredCurve,
    pub options: &'a FitOptions,
    pub accuracy: &'a Accuracy,
    pub stop: &'a (dyn Fn() -> StopCriteria + Sync),
    /// How many paths were computed
    pub paths: AtomicUsize,
    /// Whether the caller has interrupted one
    pub interrupted: AtomicBool,
}

/// The model at one set of parameters.
#[derive(Clone, Debug)]
pub(super) struct Trial {
    /// Coordinates of the parameters
    pub x: DVector<f64>,
    /// What was computed
    pub found: Found,
    /// One a measured point
    pub modelled: Vec<Modelled>,
    /// Displacement of the first jump as the machine records it, where one was measured, nm
    pub jump: Option<f64>,
    /// f, nN
    pub force_zero: f64,
}

/// The curve of the model.
#[derive(Clone, Debug)]
pub(super) enum Found {
    /// A peel, and its first stable branch
    Peel(Box<Peel>, MachineCurve),
    /// Something else
    Pull(PulledCurve),
}

/// Places of each step of a path at which its curve is given.
const PER_STEP: usize = 8;

impl Found {
    /// (U, P) up to the jump, to be drawn.
    pub fn points(&self) -> Vec<(f64, f64)> {
        match self {
            Self::Peel(_, curve) => curve.points(PER_STEP),
            Self::Pull(curve) => curve.points(),
        }
    }

    /// Where the machine is at the jump; none where there is none, as far as the curve was computed.
    pub fn jump(&self) -> Option<f64> {
        match self {
            Self::Peel(_, curve) => curve.end.jumps.then_some(curve.end.machine),
            Self::Pull(curve) => curve.detached,
        }
    }

    /// Where the machine is at the end of the curve.
    pub fn end(&self) -> f64 {
        match self {
            Self::Peel(_, curve) => curve.end.machine,
            Self::Pull(curve) => curve.range().map_or(0.0, |(_, end)| end),
        }
    }
}

/// How much each datum counts.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Weights {
    /// Standard errors of the points, nN
    pub errors: Vec<f64>,
    /// Of the displacement of the jump, nm
    pub jump_error: f64,
    /// Of the mean force behind it, nN
    pub rest_error: f64,
    /// Of the loss, one a point
    pub robust: Vec<f64>,
}

/// Standard errors that are the same at all points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Errors {
    /// Of a force that has none of its own, nN
    pub force: f64,
    /// Of a displacement, nm
    pub displacement: f64,
}

impl Errors {
    /// Half of the way, of the variances, to others.
    pub fn between(self, other: Self) -> Self {
        let half = |a: f64, b: f64| (0.5 * (a * a + b * b)).sqrt();
        Self { force: half(self.force, other.force), displacement: half(self.displacement, other.displacement) }
    }
}

/// The derivative of a number from its values with a coordinate changed by these steps: of both sides, of one, or zero where none is known.
fn difference(here: f64, beside: impl Iterator<Item = (f64, f64)>) -> f64 {
    match beside.collect::<Vec<_>>()[..] {
        [(above, step), (below, back)] => (above - below) / (step - back),
        [(value, step)] => (value - here) / step,
        _ => 0.0,
    }
}

/// Derivatives by all coordinates: a row a point, one for the jump, and one for the force behind it.
#[derive(Clone, Debug)]
pub(super) struct Derivatives {
    pub force: DMatrix<f64>,
    pub jump: DVector<f64>,
    /// Of the force behind the detachment
    pub rest: DVector<f64>,
}

impl Derivatives {
    fn zeros(points: usize, coordinates: usize) -> Self {
        let none = || DVector::zeros(coordinates);
        Self { force: DMatrix::zeros(points, coordinates), jump: none(), rest: none() }
    }
}

impl Evaluator<'_> {
    /// Values of the parameters at coordinates.
    pub fn values(&self, x: &DVector<f64>) -> Vec<f64> {
        self.coordinates.iter().zip(x.iter()).map(|(coordinate, &x)| coordinate.value(x)).collect()
    }

    /// d at values, nm.
    pub fn displacement_zero(&self, values: &[f64]) -> f64 {
        self.place_of(ParameterOf::DisplacementZero).map_or(self.options.displacement_zero, |index| values[index])
    }

    /// f at values, nN.
    fn force_zero(&self, values: &[f64]) -> f64 {
        self.place_of(ParameterOf::ForceZero).map_or(self.options.force_zero, |index| values[index])
    }

    fn place_of(&self, of: ParameterOf) -> Option<usize> {
        self.problem.parameters.iter().position(|parameter| parameter.of == of)
    }

    /// The mean force behind the detachment, which is a datum where f is free, nN.
    fn rest(&self) -> Option<f64> {
        self.measured.rest.filter(|_| self.place_of(ParameterOf::ForceZero).is_some())
    }

    /// How many data there are.
    pub fn data(&self) -> usize {
        self.measured.points.len() + usize::from(self.jump().is_some()) + usize::from(self.rest().is_some())
    }

    /// The curve of the model at coordinates, and what it says of the measured points; else why not.
    pub fn trial(&self, x: &DVector<f64>) -> Result<Trial, NoFit> {
        match &self.problem.curve {
            CurveBy::Peel => self.trial_of_peel(x),
            CurveBy::Values(curve) => self.trial_of_pull(x, curve),
        }
    }

    fn trial_of_pull(&self, x: &DVector<f64>, curve: &CurveOf) -> Result<Trial, NoFit> {
        let values = self.values(x);
        let zero = self.displacement_zero(&values);
        self.paths.fetch_add(1, Ordering::Relaxed);
        let curve = curve(&values, &(self.stop)()).map_err(NoFit::NoStart)?;
        if curve.interrupted {
            self.interrupted.store(true, Ordering::Relaxed);
        }
        let why = || curve.short.clone().unwrap_or_else(|| "the pull ends there".to_owned());
        let ends = curve.range().ok_or_else(|| NoFit::NoStart(why()))?;
        let last = self.measured.range().1 - zero;
        if curve.detached.is_none() && ends.1 < last {
            let end = ends.1;
            return Err(NoFit::NoStart(format!(
                "it goes to {end:.4} nm, and the measured points to {last:.4} nm: {}",
                why()
            )));
        }
        let force_zero = self.force_zero(&values);
        let at = |displacement: f64| Modelled::of_pull(&curve, ends, displacement - zero).above(force_zero);
        let modelled = self.measured.points.iter().map(|point| at(point.displacement)).collect();
        let jump = self.jump().map(|_| curve.detached.unwrap_or(ends.1) + zero);
        Ok(Trial { x: x.clone(), modelled, jump, force_zero, found: Found::Pull(curve) })
    }

    fn trial_of_peel(&self, x: &DVector<f64>) -> Result<Trial, NoFit> {
        let values = self.values(x);
        let model = (self.problem.model)(&values);
        checked(&model, self.accuracy)?;
        let zero = self.displacement_zero(&values);
        self.paths.fetch_add(1, Ordering::Relaxed);
        let peel = peel(&model, self.accuracy, &self.stop_criteria(zero));
        if peel.end == PathEnd::Bound(Bound::Interrupted) {
            self.interrupted.store(true, Ordering::Relaxed);
        }
        let short = |why: &str| {
            NoFit::NoStart(match &peel.end {
                PathEnd::Failed(failure) => format!("{why}: {failure}"),
                PathEnd::Bound(bound) => format!("{why}: {bound}"),
                _ => why.to_owned(),
            })
        };
        let curve = MachineCurve::of(&peel).ok_or_else(|| short("it has one point"))?;
        let last = self.measured.range().1 - zero;
        let goes_on = matches!(peel.end, PathEnd::Bound(_) | PathEnd::Failed(_));
        if goes_on && !curve.end.jumps && curve.end.machine < last {
            let end = curve.end.machine;
            return Err(short(&format!("it goes to {end:.4} nm, and the measured points to {last:.4} nm")));
        }
        let force_zero = self.force_zero(&values);
        let at = |displacement: f64| Modelled::at(&curve, displacement - zero).above(force_zero);
        let modelled = self.measured.points.iter().map(|point| at(point.displacement)).collect();
        let jump = self.jump().map(|_| curve.end.machine + zero);
        Ok(Trial { x: x.clone(), modelled, jump, force_zero, found: Found::Peel(Box::new(peel), curve) })
    }

    /// Those of the caller, and the end of the points where no jump behind it is asked for.
    fn stop_criteria(&self, zero: f64) -> StopCriteria {
        let stop = (self.stop)();
        if self.jump().is_some() {
            return stop;
        }
        let (first, last) = self.measured.range();
        let far = last - zero + BEYOND * (last - first);
        StopCriteria { displacement: Some(stop.displacement.map_or(far, |most| most.min(far))), ..stop }
    }

    /// Measured displacement of the jump and its standard error, where it is a datum.
    pub fn jump(&self) -> Option<(f64, f64)> {
        let jump = self.measured.jump.filter(|_| self.options.use_jump)?;
        Some((jump.displacement, jump.error))
    }

    /// Derivatives of a trial.
    pub fn derivatives(&self, trial: &Trial) -> Result<Derivatives, NoFit> {
        let values = self.values(&trial.x);
        let mut found = match &trial.found {
            Found::Peel(peel, curve) => self.of_adjoint(trial, peel, curve)?,
            Found::Pull(_) => self.of_differences(trial)?,
        };
        for index in (0..values.len()).filter(|&index| !self.is_of_model(index)) {
            let rate = self.coordinates[index].rate(trial.x[index]);
            let shifts = self.problem.parameters[index].of == ParameterOf::DisplacementZero;
            for (row, point) in trial.modelled.iter().enumerate() {
                found.force[(row, index)] = if shifts { -point.slope * rate } else { rate };
            }
            found.jump[index] = if shifts { rate } else { 0.0 };
            found.rest[index] = if shifts { 0.0 } else { rate };
        }
        Ok(found)
    }

    fn is_of_model(&self, index: usize) -> bool {
        self.problem.parameters[index].of == ParameterOf::Model
    }

    /// By differences of curves with one coordinate a little larger and a little smaller.
    fn of_differences(&self, trial: &Trial) -> Result<Derivatives, NoFit> {
        let of_model: Vec<usize> = (0..trial.x.len()).filter(|&index| self.is_of_model(index)).collect();
        let beside: Vec<(usize, f64)> =
            of_model.iter().flat_map(|&index| [BESIDE, -BESIDE].map(|step| (index, step))).collect();
        let one = |&(index, step): &(usize, f64)| {
            let mut x = trial.x.clone();
            x[index] += step;
            self.trial(&x)
        };
        let beside: Vec<Result<Trial, NoFit>> = beside.par_iter().map(one).collect();
        let mut found = Derivatives::zeros(trial.modelled.len(), trial.x.len());
        for (&index, sides) in of_model.iter().zip(beside.chunks(2)) {
            let known =
                || sides.iter().zip([BESIDE, -BESIDE]).filter_map(|(side, step)| Some((side.as_ref().ok()?, step)));
            if known().next().is_none() {
                return Err(sides[0].as_ref().err().cloned().unwrap_or(NoFit::NoParameters));
            }
            for (row, here) in trial.modelled.iter().enumerate() {
                let alike = |(side, _): &(&Trial, f64)| {
                    (side.modelled[row].branch, side.modelled[row].place) == (here.branch, here.place)
                };
                let forces = known().filter(alike).map(|(side, step)| (side.modelled[row].force, step));
                found.force[(row, index)] = difference(here.force, forces);
            }
            let jumps = known().filter_map(|(side, step)| Some((side.jump?, step)));
            found.jump[index] = trial.jump.map_or(0.0, |here| difference(here, jumps));
        }
        Ok(found)
    }

    /// By the derivatives of a peel.
    fn of_adjoint(&self, trial: &Trial, peel: &Peel, curve: &MachineCurve) -> Result<Derivatives, NoFit> {
        let values = self.values(&trial.x);
        let beside = |index: usize, change: f64| {
            let mut values = values.clone();
            values[index] = self.coordinates[index].value(trial.x[index] + change);
            (self.problem.model)(&values)
        };
        let of_model: Vec<usize> = (0..values.len()).filter(|&index| self.is_of_model(index)).collect();
        let variation = |&index: &usize| {
            let beside = &beside;
            Variation::new(self.problem.parameters[index].key.clone(), move |change| beside(index, change))
        };
        let variations: Vec<Variation> = of_model.iter().map(variation).collect();
        let compliance = |&index: &usize| {
            let of = |change: f64| beside(index, change).grip.stiffness.map_or(0.0, f64::recip);
            (of(STEP) - of(-STEP)) / (2.0 * STEP)
        };
        let compliance: Vec<f64> = of_model.iter().map(compliance).collect();
        let jumps = jump_derivatives(peel, curve, &variations, &compliance)?;
        let grips: Vec<f64> = trial.modelled.iter().map(Modelled::grip).collect();
        let rows = forces_on_branch(peel, &grips, &variations)?;
        let at_start = match curve.start.1 {
            0.0 => vec![0.0; variations.len()],
            _ => forces_on_branch(peel, &[0.0], &variations)?.swap_remove(0).derivatives,
        };
        let mut found = Derivatives::zeros(trial.modelled.len(), values.len());
        for (column, &index) in of_model.iter().enumerate() {
            for (row, point) in trial.modelled.iter().enumerate() {
                let change = Change {
                    force: rows[row].derivatives[column],
                    slope: rows[row].slope,
                    force_at_start: at_start[column],
                    compliance: compliance[column],
                    jump: jumps[column],
                };
                found.force[(row, index)] = point.derivative(curve, &change);
            }
            found.jump[index] = jumps[column];
        }
        Ok(found)
    }

    /// Residuals over their standard errors, without the weights of the loss: one a point, and that of the jump.
    pub fn standardised(&self, trial: &Trial, weights: &Weights) -> (Vec<f64>, Option<f64>) {
        let points = trial.modelled.iter().zip(&self.measured.points).zip(&weights.errors);
        let points = points.map(|((modelled, measured), error)| (modelled.force - measured.force) / error).collect();
        let jump = trial.jump.zip(self.jump()).map(|(found, (measured, _))| (found - measured) / weights.jump_error);
        (points, jump)
    }

    /// All residuals whose squares are summed.
    pub fn residuals(&self, trial: &Trial, weights: &Weights) -> DVector<f64> {
        let (points, jump) = self.standardised(trial, weights);
        let weighted = points.iter().zip(&weights.robust).map(|(residual, weight)| weight.sqrt() * residual);
        let rest = self.rest().map(|measured| (trial.force_zero - measured) / weights.rest_error);
        DVector::from_iterator(self.data(), weighted.chain(jump).chain(rest))
    }

    /// Their derivatives by the coordinates.
    pub fn jacobian(&self, found: &Derivatives, weights: &Weights) -> DMatrix<f64> {
        let points = found.force.nrows();
        let jumps = self.jump().is_some();
        DMatrix::from_fn(self.data(), found.force.ncols(), |row, column| match row {
            row if row < points => weights.robust[row].sqrt() * found.force[(row, column)] / weights.errors[row],
            row if row == points && jumps => found.jump[column] / weights.jump_error,
            _ => found.rest[column] / weights.rest_error,
        })
    }

    /// The weights with standard errors of the forces that are known, or these, and without a loss.
    pub fn weights(&self, errors: Errors) -> Weights {
        let error = |own: Option<f64>| own.or(self.options.force_error).unwrap_or(errors.force);
        let forces = self.measured.points.iter().map(|point| error(point.force_error)).collect::<Vec<_>>();
        let behind = self.measured.behind_jump.len().max(1) as f64;
        Weights {
            robust: vec![1.0; forces.len()],
            jump_error: self.jump().map_or(1.0, |(_, error)| error.hypot(errors.displacement)),
            rest_error: self.options.force_error.unwrap_or(errors.force) / behind.sqrt(),
            errors: forces,
        }
    }

    /// Standard error of a displacement as it is given, nm: 0 where it is none or not known yet.
    pub fn displacement_error(&self) -> f64 {
        match self.options.displacement_error {
            DisplacementError::Known(error) => error,
            DisplacementError::Estimated | DisplacementError::None => 0.0,
        }
    }

    /// The weights for the next iteration: displacements off by their standard error change the force by its slope, and points count as the
    /// loss says.
    pub fn reweighted(&self, trial: &Trial, errors: Errors) -> Weights {
        let mut weights = self.weights(errors);
        for (error, point) in weights.errors.iter_mut().zip(&trial.modelled) {
            *error = error.hypot(point.slope * errors.displacement);
        }
        if self.options.loss != Loss::Squares {
            let (points, _) = self.standardised(trial, &weights);
            weights.robust = points.iter().map(|&residual| self.options.loss.weight(residual)).collect();
        }
        weights
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Body, PeelModel, Range, StripModel};
    use crate::study::parameters::fit::measured_curve::{MeasuredJump, MeasuredPoint};
    use crate::study::parameters::fit::problem::FitParameter;
    use crate::study::parameters::fit::result::PointPlace;

    /// Stiffness, length and hold of the strip, its law, and its machine: A_H, E, k and d.
    fn model(values: &[f64]) -> PeelModel {
        let mut model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
        if let Body::Strip(strip) = &mut model.body {
            strip.material.youngs_modulus = values[1];
        }
        model.adhesion.hamaker_constant = values[0];
        model.grip.stiffness = values.get(2).copied();
        model
    }

    fn parameter(initial: f64, of: ParameterOf) -> FitParameter {
        let range = if of == ParameterOf::Model { Range::Positive } else { Range::OFFSET };
        FitParameter { key: "k".into(), initial, range, from: None, to: None, of }
    }

    /// Derivatives against central differences of whole runs: before the start, on the branch, behind the jump, of the jump; with the
    /// machine's spring and without.
    #[test]
    fn derivatives_are_those_of_differences_of_runs() {
        let model_numbers = [0.1, 2.0, 0.5];
        for (numbers, last) in [(&model_numbers[..], 49.5), (&model_numbers[..2], 60.0)] {
            let mut parameters: Vec<FitParameter> =
                numbers.iter().map(|&number| parameter(number, ParameterOf::Model)).collect();
            parameters.push(parameter(0.7, ParameterOf::DisplacementZero));
            let count = numbers.len();
            let model = Box::new(move |values: &[f64]| model(&values[..count]));
            let problem = FitProblem { parameters, model, curve: CurveBy::Peel };
            let places = [0.6, 0.75, 1.0, 2.0, 6.0, 30.0, last];
            let point = |&displacement: &f64| MeasuredPoint { displacement, force: displacement, force_error: None };
            let mut measured = MeasuredCurve::new(places.iter().map(point).collect(), None, Some(0.0)).unwrap();
            measured.jump = Some(MeasuredJump { displacement: last, error: 0.1 });
            let (options, accuracy) = (FitOptions::default(), Accuracy::to(1e-8));
            let coordinates =
                problem.parameters.iter().map(|parameter| Coordinate::new(parameter, 25.0).unwrap()).collect();
            let evaluator = Evaluator {
                problem: &problem,
                coordinates,
                measured: &measured,
                options: &options,
                accuracy: &accuracy,
                stop: &StopCriteria::default,
                paths: AtomicUsize::new(0),
                interrupted: AtomicBool::new(false),
            };
            let x = DVector::zeros(count + 1);
            let trial = evaluator.trial(&x).unwrap();
            assert_eq!(trial.modelled[0].place, PointPlace::BeforeStart);
            let behind = trial.modelled[6].place == PointPlace::BehindJump;
            assert!(behind, "the last point is behind the jump at {:?}", trial.jump);
            let found = evaluator.derivatives(&trial).unwrap();
            for k in 0..=count {
                let step = 1e-5;
                let beside = [1.0, -1.0].map(|sign| {
                    let mut x = x.clone();
                    x[k] = sign * step;
                    evaluator.trial(&x).unwrap()
                });
                let [up, down] = &beside;
                let difference = |a: f64, b: f64| (a - b) / (2.0 * step);
                for row in 0..places.len() {
                    let expected = difference(up.modelled[row].force, down.modelled[row].force);
                    let force = found.force[(row, k)];
                    // behind the jump the branch is so steep that differences are good to few digits
                    let tolerance = if row == 6 { 5e-3 } else { 1e-4 };
                    let scale = expected.abs().max(1e-3);
                    assert!((force - expected).abs() < tolerance * scale, "point {row} by {k}: {force} {expected}");
                }
                let expected = difference(up.jump.unwrap(), down.jump.unwrap());
                let jump = found.jump[k];
                // where U turns next to a limit point of u is interpolated
                assert!((jump - expected).abs() < 1e-3 * expected.abs().max(1.0), "jump by {k}: {jump} {expected}");
            }
        }
    }
}
