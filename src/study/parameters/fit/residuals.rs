//! All curves of the model at one set of parameters: residuals and their derivatives.
//!
//! The data are in the order of the points of all curves, then their jumps, then the forces behind these.

use super::coordinate::Coordinate;
use super::curve_trial::{Counted, CurveDerivatives, CurveModel, CurveTrial};
use super::curves::machine_curve::Modelled;
use super::curves::measured_curve::{MeasuredCurve, MeasuredPoint};
use super::problem::{DisplacementError, FitOptions, FitProblem, Loss};
use super::result::NoFit;
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::stop_criteria::StopCriteria;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// What computes the model for a set of parameters.
pub(super) struct Evaluator<'a> {
    pub problem: &'a FitProblem<'a>,
    pub coordinates: Vec<Coordinate>,
    pub options: &'a FitOptions,
    pub accuracy: &'a Accuracy,
    pub stop: &'a (dyn Fn() -> StopCriteria + Sync),
    pub counted: Counted,
}

/// The model at one set of parameters.
#[derive(Clone, Debug)]
pub(super) struct Trial {
    /// Coordinates of the parameters
    pub x: DVector<f64>,
    /// In the order of the problem
    pub curves: Vec<CurveTrial>,
}

impl Trial {
    /// What it says of the measured points of all curves.
    pub(crate) fn modelled(&self) -> impl Iterator<Item = &Modelled> {
        self.curves.iter().flat_map(|curve| &curve.modelled)
    }
}

/// How much each datum counts.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Weights {
    /// Standard errors of the points, nN
    pub errors: Vec<f64>,
    /// Of the displacements of the jumps, nm
    pub jump_errors: Vec<f64>,
    /// Of the mean forces behind them, nN
    pub rest_errors: Vec<f64>,
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
    pub(crate) fn between(self, other: Self) -> Self {
        let half = |a: f64, b: f64| (0.5 * (a * a + b * b)).sqrt();
        Self { force: half(self.force, other.force), displacement: half(self.displacement, other.displacement) }
    }
}

impl Evaluator<'_> {
    /// Values of the parameters at coordinates.
    pub(crate) fn values(&self, x: &DVector<f64>) -> Vec<f64> {
        self.coordinates.iter().zip(x.iter()).map(|(coordinate, &x)| coordinate.value(x)).collect()
    }

    /// Its curves.
    pub(crate) fn curves(&self) -> impl Iterator<Item = CurveModel<'_>> {
        (0..self.problem.curves.len()).map(|index| self.curve(index))
    }

    fn curve(&self, index: usize) -> CurveModel<'_> {
        CurveModel {
            curve: &self.problem.curves[index],
            index,
            parameters: &self.problem.parameters,
            coordinates: &self.coordinates,
            options: self.options,
            accuracy: self.accuracy,
            stop: self.stop,
            counted: &self.counted,
        }
    }

    /// What was measured.
    pub(crate) fn measured(&self) -> impl Iterator<Item = &MeasuredCurve> {
        self.problem.curves.iter().map(|curve| &curve.measured)
    }

    /// The measured points of all curves.
    pub(crate) fn points(&self) -> impl Iterator<Item = &MeasuredPoint> {
        self.measured().flat_map(|measured| &measured.points)
    }

    /// Largest measured force by its amount, nN.
    pub(crate) fn largest_force(&self) -> f64 {
        self.measured().map(MeasuredCurve::largest_force).fold(0.0, f64::max)
    }

    /// Measured displacements of the jumps and their standard errors, where they are data.
    pub(crate) fn jumps(&self) -> impl Iterator<Item = (f64, f64)> {
        self.curves().filter_map(|curve| curve.jump())
    }

    /// How many data there are.
    pub(crate) fn data(&self) -> usize {
        self.points().count() + self.jumps().count() + self.curves().filter_map(|curve| curve.rest()).count()
    }

    /// The model at coordinates; else why one of its curves is not known there.
    pub(crate) fn trial(&self, x: &DVector<f64>) -> Result<Trial, NoFit> {
        let curves: Vec<_> =
            (0..self.problem.curves.len()).into_par_iter().map(|index| self.curve(index).trial(x)).collect();
        Ok(Trial { x: x.clone(), curves: curves.into_iter().collect::<Result<_, _>>()? })
    }

    /// Derivatives of the data of a trial by the coordinates, a row a datum.
    pub(crate) fn derivatives(&self, trial: &Trial) -> Result<DMatrix<f64>, NoFit> {
        let of = |(index, curve): (usize, &CurveTrial)| self.curve(index).derivatives(&trial.x, curve);
        let all: Vec<Result<CurveDerivatives, NoFit>> = trial.curves.par_iter().enumerate().map(of).collect();
        let all = all.into_iter().collect::<Result<Vec<_>, _>>()?;
        let forces = all.iter().flat_map(|of| of.force.row_iter().map(|row| row.transpose()));
        let jumps = all.iter().zip(self.curves()).filter(|(_, curve)| curve.jump().is_some());
        let rests = all.iter().zip(self.curves()).filter(|(_, curve)| curve.rest().is_some());
        let rows = forces.chain(jumps.map(|(of, _)| of.jump.clone())).chain(rests.map(|(of, _)| of.rest.clone()));
        let rows: Vec<_> = rows.map(|row| row.transpose()).collect();
        Ok(DMatrix::from_rows(&rows))
    }

    /// Residuals of the points over their standard errors, without the weights of the loss.
    pub(crate) fn standardised(&self, trial: &Trial, weights: &Weights) -> Vec<f64> {
        let points = trial.modelled().zip(self.points()).zip(&weights.errors);
        points.map(|((modelled, measured), error)| (modelled.force - measured.force) / error).collect()
    }

    /// All residuals whose squares are summed.
    pub(crate) fn residuals(&self, trial: &Trial, weights: &Weights) -> DVector<f64> {
        let points = self.standardised(trial, weights);
        let weighted = points.iter().zip(&weights.robust).map(|(residual, weight)| weight.sqrt() * residual);
        let curves = || self.curves().zip(&trial.curves);
        let jumps = curves().filter_map(|(curve, found)| Some((curve.jump()?.0, found.jump.unwrap_or(f64::NAN))));
        let jumps = jumps.zip(&weights.jump_errors).map(|((measured, found), error)| (found - measured) / error);
        let rests = curves().filter_map(|(curve, found)| Some((curve.rest()?, found.force_zero)));
        let rests = rests.zip(&weights.rest_errors).map(|((measured, found), error)| (found - measured) / error);
        DVector::from_iterator(self.data(), weighted.chain(jumps).chain(rests))
    }

    /// Their derivatives by the coordinates.
    pub(crate) fn jacobian(&self, found: &DMatrix<f64>, weights: &Weights) -> DMatrix<f64> {
        let points = weights.robust.iter().zip(&weights.errors).map(|(weight, error)| (weight.sqrt(), *error));
        let others = weights.jump_errors.iter().chain(&weights.rest_errors).map(|&error| (1.0, error));
        let mut scaled = found.clone();
        for (row, (root, error)) in points.chain(others).enumerate() {
            scaled.row_mut(row).apply(|value| *value = root * *value / error);
        }
        scaled
    }

    /// The weights with standard errors of the forces that are known, or these, and without a loss.
    pub(crate) fn weights(&self, errors: Errors) -> Weights {
        let error = |own: Option<f64>| own.or(self.options.force_error).unwrap_or(errors.force);
        let forces = self.points().map(|point| error(point.force_error)).collect::<Vec<_>>();
        let rest = |curve: CurveModel| {
            let behind = curve.curve.measured.behind_jump.len().max(1) as f64;
            curve.rest().map(|_| self.options.force_error.unwrap_or(errors.force) / behind.sqrt())
        };
        Weights {
            robust: vec![1.0; forces.len()],
            jump_errors: self.jumps().map(|(_, error)| error.hypot(errors.displacement)).collect(),
            rest_errors: self.curves().filter_map(rest).collect(),
            errors: forces,
        }
    }

    /// Standard error of a displacement as it is given, nm: 0 where it is none or not known yet.
    pub(crate) fn displacement_error(&self) -> f64 {
        match self.options.displacement_error {
            DisplacementError::Known(error) => error,
            DisplacementError::Estimated | DisplacementError::None => 0.0,
        }
    }

    /// The weights for the next iteration: displacements off by their standard error change the force by its slope, and points count as the
    /// loss says.
    pub(crate) fn reweighted(&self, trial: &Trial, errors: Errors) -> Weights {
        let mut weights = self.weights(errors);
        for (error, point) in weights.errors.iter_mut().zip(trial.modelled()) {
            *error = error.hypot(point.slope * errors.displacement);
        }
        if self.options.loss != Loss::Squares {
            let points = self.standardised(trial, &weights);
            weights.robust = points.iter().map(|&residual| self.options.loss.weight(residual)).collect();
        }
        weights
    }
}
