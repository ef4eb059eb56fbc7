//! One curve of the model at one set of parameters: what it says of the measured points, and the derivatives of that.

use super::coordinate::Coordinate;
use super::curves::machine_curve::{Change, MachineCurve, Modelled, jump_derivatives};
use super::curves::pulled_curve::PulledCurve;
use super::problem::{CurveBy, CurveOf, FitCurve, FitOptions, FitParameter, ParameterOf};
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

/// What all curves of a fit count together.
#[derive(Debug, Default)]
pub(super) struct Counted {
    /// How many paths were computed
    pub paths: AtomicUsize,
    /// Whether the caller has interrupted one
    pub interrupted: AtomicBool,
}

/// What computes one curve of the model for a set of parameters.
pub(super) struct CurveModel<'a> {
    pub curve: &'a FitCurve<'a>,
    /// Its place among the curves
    pub index: usize,
    pub parameters: &'a [FitParameter],
    pub coordinates: &'a [Coordinate],
    pub options: &'a FitOptions,
    pub accuracy: &'a Accuracy,
    pub stop: &'a (dyn Fn() -> StopCriteria + Sync),
    pub counted: &'a Counted,
}

/// One curve at one set of parameters.
#[derive(Clone, Debug)]
pub(super) struct CurveTrial {
    /// What was computed
    pub found: Found,
    /// One a measured point
    pub modelled: Vec<Modelled>,
    /// Displacement of the first jump as the machine records it, where one was measured, nm
    pub jump: Option<f64>,
    /// d, nm
    pub displacement_zero: f64,
    /// f, nN
    pub force_zero: f64,
}

impl CurveTrial {
    /// (U + d, P + f) up to the jump, to be drawn.
    pub(crate) fn recorded(&self) -> Vec<(f64, f64)> {
        let shifted = |(u, force)| (u + self.displacement_zero, force + self.force_zero);
        self.found.points().into_iter().map(shifted).collect()
    }
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
    pub(crate) fn points(&self) -> Vec<(f64, f64)> {
        match self {
            Self::Peel(_, curve) => curve.points(PER_STEP),
            Self::Pull(curve) => curve.points(),
        }
    }

    /// Where the machine is at the jump; none where there is none, as far as the curve was computed.
    pub(crate) fn jump(&self) -> Option<f64> {
        match self {
            Self::Peel(_, curve) => curve.end.jumps.then_some(curve.end.machine),
            Self::Pull(curve) => curve.detached,
        }
    }

    /// Where the machine is at the end of the curve.
    pub(crate) fn end(&self) -> f64 {
        match self {
            Self::Peel(_, curve) => curve.end.machine,
            Self::Pull(curve) => curve.range().map_or(0.0, |(_, end)| end),
        }
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

/// Derivatives of one curve by all coordinates: a row a point, one for the jump, and one for the force behind it.
#[derive(Clone, Debug)]
pub(super) struct CurveDerivatives {
    pub force: DMatrix<f64>,
    pub jump: DVector<f64>,
    /// Of the force behind the detachment
    pub rest: DVector<f64>,
}

impl CurveDerivatives {
    fn zeros(points: usize, coordinates: usize) -> Self {
        let none = || DVector::zeros(coordinates);
        Self { force: DMatrix::zeros(points, coordinates), jump: none(), rest: none() }
    }
}

impl CurveModel<'_> {
    /// Values of the parameters at coordinates.
    fn values(&self, x: &DVector<f64>) -> Vec<f64> {
        self.coordinates.iter().zip(x.iter()).map(|(coordinate, &x)| coordinate.value(x)).collect()
    }

    /// The place of a parameter that is of this curve alone, such as its d.
    fn place_of(&self, of: ParameterOf) -> Option<usize> {
        self.parameters.iter().position(|parameter| parameter.of == of)
    }

    /// d and f at values, nm and nN.
    fn zeros(&self, values: &[f64]) -> [f64; 2] {
        let (curve, own) = (self.index, self.curve);
        let at = |of, given: f64| self.place_of(of).map_or(given, |place| values[place]);
        [
            at(ParameterOf::DisplacementZero { curve }, own.displacement_zero),
            at(ParameterOf::ForceZero { curve }, own.force_zero),
        ]
    }

    /// The mean force behind the detachment, which is a datum where f is free, nN.
    pub(crate) fn rest(&self) -> Option<f64> {
        let is_free = self.place_of(ParameterOf::ForceZero { curve: self.index }).is_some();
        self.curve.measured.rest.filter(|_| is_free)
    }

    /// Measured displacement of the jump and its standard error, where it is a datum.
    pub(crate) fn jump(&self) -> Option<(f64, f64)> {
        let jump = self.curve.measured.jump.filter(|_| self.options.use_jump)?;
        Some((jump.displacement, jump.error))
    }

    /// The curve of the model at coordinates, and what it says of the measured points; else why not.
    pub(crate) fn trial(&self, x: &DVector<f64>) -> Result<CurveTrial, NoFit> {
        match &self.curve.by {
            CurveBy::Peel => self.trial_of_peel(x),
            CurveBy::Values(curve) => self.trial_of_pull(x, curve),
        }
    }

    fn trial_of_pull(&self, x: &DVector<f64>, curve: &CurveOf) -> Result<CurveTrial, NoFit> {
        let values = self.values(x);
        let [zero, force_zero] = self.zeros(&values);
        self.counted.paths.fetch_add(1, Ordering::Relaxed);
        let curve = curve(&values, &(self.stop)()).map_err(NoFit::NoStart)?;
        if curve.interrupted {
            self.counted.interrupted.store(true, Ordering::Relaxed);
        }
        let why = || curve.short.clone().unwrap_or_else(|| "the pull ends there".to_owned());
        let ends = curve.range().ok_or_else(|| NoFit::NoStart(why()))?;
        let last = self.curve.measured.range().1 - zero;
        if curve.detached.is_none() && ends.1 < last {
            let end = ends.1;
            return Err(NoFit::NoStart(format!(
                "it goes to {end:.4} nm, and the measured points to {last:.4} nm: {}",
                why()
            )));
        }
        let at = |displacement: f64| Modelled::of_pull(&curve, ends, displacement - zero).above(force_zero);
        let modelled = self.curve.measured.points.iter().map(|point| at(point.displacement)).collect();
        let jump = self.jump().map(|_| curve.detached.unwrap_or(ends.1) + zero);
        Ok(CurveTrial { modelled, jump, displacement_zero: zero, force_zero, found: Found::Pull(curve) })
    }

    fn trial_of_peel(&self, x: &DVector<f64>) -> Result<CurveTrial, NoFit> {
        let values = self.values(x);
        let model = (self.curve.model)(&values);
        checked(&model, self.accuracy)?;
        let [zero, force_zero] = self.zeros(&values);
        self.counted.paths.fetch_add(1, Ordering::Relaxed);
        let peel = peel(&model, self.accuracy, &self.stop_criteria(zero));
        if peel.end == PathEnd::Bound(Bound::Interrupted) {
            self.counted.interrupted.store(true, Ordering::Relaxed);
        }
        let short = |why: &str| {
            NoFit::NoStart(match &peel.end {
                PathEnd::Failed(failure) => format!("{why}: {failure}"),
                PathEnd::Bound(bound) => format!("{why}: {bound}"),
                _ => why.to_owned(),
            })
        };
        let curve = MachineCurve::of(&peel).ok_or_else(|| short("it has one point"))?;
        let last = self.curve.measured.range().1 - zero;
        let goes_on = matches!(peel.end, PathEnd::Bound(_) | PathEnd::Failed(_));
        if goes_on && !curve.end.jumps && curve.end.machine < last {
            let end = curve.end.machine;
            return Err(short(&format!("it goes to {end:.4} nm, and the measured points to {last:.4} nm")));
        }
        let at = |displacement: f64| Modelled::at(&curve, displacement - zero).above(force_zero);
        let modelled = self.curve.measured.points.iter().map(|point| at(point.displacement)).collect();
        let jump = self.jump().map(|_| curve.end.machine + zero);
        let found = Found::Peel(Box::new(peel), curve);
        Ok(CurveTrial { modelled, jump, displacement_zero: zero, force_zero, found })
    }

    /// Those of the caller, and the end of the points where no jump behind it is asked for.
    fn stop_criteria(&self, zero: f64) -> StopCriteria {
        let stop = (self.stop)();
        if self.jump().is_some() {
            return stop;
        }
        let (first, last) = self.curve.measured.range();
        let far = last - zero + BEYOND * (last - first);
        StopCriteria { displacement: Some(stop.displacement.map_or(far, |most| most.min(far))), ..stop }
    }

    /// Derivatives of a trial at these coordinates.
    pub(crate) fn derivatives(&self, x: &DVector<f64>, trial: &CurveTrial) -> Result<CurveDerivatives, NoFit> {
        let mut found = match &trial.found {
            Found::Peel(peel, curve) => self.of_adjoint(x, trial, peel, curve)?,
            Found::Pull(_) => self.of_differences(x, trial)?,
        };
        for (index, parameter) in self.parameters.iter().enumerate() {
            let (rate, curve) = (self.coordinates[index].rate(x[index]), self.index);
            let shifts = parameter.of == ParameterOf::DisplacementZero { curve };
            if !shifts && parameter.of != (ParameterOf::ForceZero { curve }) {
                continue;
            }
            for (row, point) in trial.modelled.iter().enumerate() {
                found.force[(row, index)] = if shifts { -point.slope * rate } else { rate };
            }
            found.jump[index] = if shifts { rate } else { 0.0 };
            found.rest[index] = if shifts { 0.0 } else { rate };
        }
        Ok(found)
    }

    fn is_of_model(&self, index: usize) -> bool {
        self.parameters[index].of == ParameterOf::Model
    }

    /// By differences of curves with one coordinate a little larger and a little smaller.
    fn of_differences(&self, x: &DVector<f64>, trial: &CurveTrial) -> Result<CurveDerivatives, NoFit> {
        let of_model: Vec<usize> = (0..x.len()).filter(|&index| self.is_of_model(index)).collect();
        let beside: Vec<(usize, f64)> =
            of_model.iter().flat_map(|&index| [BESIDE, -BESIDE].map(|step| (index, step))).collect();
        let one = |&(index, step): &(usize, f64)| {
            let mut x = x.clone();
            x[index] += step;
            self.trial(&x)
        };
        let beside: Vec<Result<CurveTrial, NoFit>> = beside.par_iter().map(one).collect();
        let mut found = CurveDerivatives::zeros(trial.modelled.len(), x.len());
        for (&index, sides) in of_model.iter().zip(beside.chunks(2)) {
            let known =
                || sides.iter().zip([BESIDE, -BESIDE]).filter_map(|(side, step)| Some((side.as_ref().ok()?, step)));
            if known().next().is_none() {
                return Err(sides[0].as_ref().err().cloned().unwrap_or(NoFit::NoParameters));
            }
            for (row, here) in trial.modelled.iter().enumerate() {
                let alike = |(side, _): &(&CurveTrial, f64)| {
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
    fn of_adjoint(
        &self,
        x: &DVector<f64>,
        trial: &CurveTrial,
        peel: &Peel,
        curve: &MachineCurve,
    ) -> Result<CurveDerivatives, NoFit> {
        let values = self.values(x);
        let beside = |index: usize, change: f64| {
            let mut values = values.clone();
            values[index] = self.coordinates[index].value(x[index] + change);
            (self.curve.model)(&values)
        };
        let of_model: Vec<usize> = (0..values.len()).filter(|&index| self.is_of_model(index)).collect();
        let variation = |&index: &usize| {
            let beside = &beside;
            Variation::new(self.parameters[index].key.clone(), move |change| beside(index, change))
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
        let mut found = CurveDerivatives::zeros(trial.modelled.len(), values.len());
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Body, PeelModel, Range, StripModel};
    use crate::study::parameters::fit::curves::measured_curve::{MeasuredCurve, MeasuredJump, MeasuredPoint};
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
            parameters.push(parameter(0.7, ParameterOf::DisplacementZero { curve: 0 }));
            let count = numbers.len();
            let model = Box::new(move |values: &[f64]| model(&values[..count]));
            let places = [0.6, 0.75, 1.0, 2.0, 6.0, 30.0, last];
            let point = |&displacement: &f64| MeasuredPoint { displacement, force: displacement, force_error: None };
            let mut measured = MeasuredCurve::new(places.iter().map(point).collect(), None, Some(0.0)).unwrap();
            measured.jump = Some(MeasuredJump { displacement: last, error: 0.1 });
            let (options, accuracy) = (FitOptions::default(), Accuracy::to(1e-8));
            let coordinates: Vec<Coordinate> =
                parameters.iter().map(|parameter| Coordinate::new(parameter, 25.0).unwrap()).collect();
            let of_curve = CurveModel {
                curve: &FitCurve::of_peel(measured, model),
                index: 0,
                parameters: &parameters,
                coordinates: &coordinates,
                options: &options,
                accuracy: &accuracy,
                stop: &StopCriteria::default,
                counted: &Counted::default(),
            };
            let x = DVector::zeros(count + 1);
            let trial = of_curve.trial(&x).unwrap();
            assert_eq!(trial.modelled[0].place, PointPlace::BeforeStart);
            let behind = trial.modelled[6].place == PointPlace::BehindJump;
            assert!(behind, "the last point is behind the jump at {:?}", trial.jump);
            let found = of_curve.derivatives(&x, &trial).unwrap();
            for k in 0..=count {
                let step = 1e-5;
                let beside = [1.0, -1.0].map(|sign| {
                    let mut x = x.clone();
                    x[k] = sign * step;
                    of_curve.trial(&x).unwrap()
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
