//! A fit: fit.csv, profiles.csv where there are profiles, and the object summary.json. Units stand in the names.

use crate::records::summary::{Found, Summary, parameters};
use crate::writing::error::ReportError;
use crate::writing::names::unknown_error;
use crate::writing::record::{Fields, Object, Record, write_table};
use crate::writing::reference::Output;
use peelkit::study::{
    Combination, Fit, FitEnd, FitWarning, FittedCurve, FittedJump, FittedParameter, FittedPoint, MeasuredCurve,
    PairDetermined, PointPlace,
};
use peelkit_scene::{Key, Scene, key_of_parameter};
use std::path::{Path, PathBuf};

/// A point of a curve.
struct PointRow<'a> {
    curve: usize,
    point: &'a FittedPoint,
}

impl Record for PointRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("curve", "which of `fit.curves` it is of, from 1; 1 where there is one curve", |row| row.curve);
        of.field("displacement_nm", "as measured", |row| row.point.displacement);
        of.field("force_nN", "as measured", |row| row.point.force);
        of.field("modelled_nN", "force of the fitted model", |row| row.point.modelled);
        of.field("standard_error_nN", "of the measured force, with what that of its displacement adds", |row| row.point.error);
        of.field("residual", "modelled less measured force, over that", |row| row.point.residual());
        of.field("weight", "how much the point counts: 1 with `loss = \"squares\"`, less for one far from the curve with another", |row| row.point.weight);
        of.field("place", "`branch`; `before start`: before the path of the model begins; `behind jump`: behind its first jump", |row| place_word(row.point.place));
    }
}

/// A steady force.
struct SteadyRow<'a> {
    key: &'a Key,
    point: &'a FittedPoint,
}

impl Record for SteadyRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("key", "the key against which steady forces were measured", |row| row.key.path());
        of.field("value", "of the key, in the unit of the library, an angle in rad", |row| row.point.displacement);
        of.field("force_nN", "as measured", |row| row.point.force);
        of.field("modelled_nN", "plateau of the fitted model", |row| row.point.modelled);
        of.field("standard_error_nN", "of the measured force", |row| row.point.error);
        of.field("residual", "modelled less measured force, over that", |row| row.point.residual());
        of.field("weight", "how much the force counts, as in fit.csv of a curve", |row| row.point.weight);
    }
}

fn place_word(place: PointPlace) -> &'static str {
    match place {
        PointPlace::BeforeStart => "before start",
        PointPlace::OnBranch => "branch",
        PointPlace::BehindJump => "behind jump",
    }
}

/// A point of a profile likelihood.
struct ProfileRow<'a> {
    key: &'a str,
    value: f64,
    excess: f64,
}

impl Record for ProfileRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("key", "the parameter that is held", |row| row.key);
        of.field("value", "at which it is held", |row| row.value);
        of.field("excess", "by how much the least sum of squares with it held is larger than the least of all", |row| row.excess);
    }
}

/// Writes fit.csv, one row a measured point or a steady force against a key, and profiles.csv, one row a point of a profile likelihood, where there is one.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_fit(dir: &Path, fit: &Fit, against: Option<&Key>) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![match against {
        None => {
            let curves = fit.curves.iter().enumerate();
            let rows: Vec<_> = curves
                .flat_map(|(index, curve)| curve.points.iter().map(move |point| PointRow { curve: index + 1, point }))
                .collect();
            write_table(dir, "fit.csv", rows)?
        }
        Some(key) => {
            let rows: Vec<_> = fit.points().map(|point| SteadyRow { key, point }).collect();
            write_table(dir, "fit.csv", rows)?
        }
    }];
    let profiles = fit.parameters.iter().filter_map(|parameter| Some((&parameter.key, parameter.profile.as_ref()?)));
    let rows: Vec<_> = profiles
        .flat_map(|(key, profile)| profile.points.iter().map(|&(value, excess)| ProfileRow { key, value, excess }))
        .collect();
    if !rows.is_empty() {
        files.push(write_table(dir, "profiles.csv", rows)?);
    }
    Ok(files)
}

/// A fit as one object. Parameters in the units of their keys, forces in nN, lengths in nm.
pub type FitSummary<'a> = Summary<'a, FitReport<'a>>;

impl<'a> FitSummary<'a> {
    /// The summary of a fit.
    pub fn new(report: &FitReport<'a>) -> Self {
        Summary::of(report.scene, *report)
    }
}

impl Record for FitReport<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("end", "`converged`; `stopped`: before the least sum of squares; `interrupted`: by Ctrl-C. The parameters are the best so far", |found| end(&found.fit.end).0);
        of.field("reason", "why the search stopped; else null", |found| end(&found.fit.end).1);
        of.field("fitted", "the parameters, in the order of the scene", |found| found.fitted());
        of.field("correlations", "of the parameters, or of their logarithms where they are above zero: a row a parameter; null at a bound", |found| found.fit.correlations.clone());
        of.field("condition", "largest over least singular value of the derivatives of the residuals by the parameters; null where the least is zero", |found| found.fit.condition);
        of.field("combinations", "products of powers of the parameters above zero whose errors are independent, the largest first", |found| found.fit.combinations.as_slice());
        of.field("pairs", "two parameters that the curve hardly tells apart, one of them poorly determined", |found| found.fit.pairs.iter().map(|pair| Pair { fit: found.fit, pair }).collect::<Vec<_>>());
        of.group("data", "what was measured", |of| {
            of.field("file", "the file as it was named on the command line; null of several curves, which `curves` has", |found| found.only().map(|of| of.file));
            of.field("against", "the key against which steady forces were measured; null of a curve", |found| found.against.map(Key::path));
            of.field("points", "points that were fitted", |found| found.fit.points().count());
            of.field("behind_jump", "points behind the measured jump, which were not", |found| found.total(|of| of.behind_jump()));
            of.field("estimated_error_nN", "standard error of a force, estimated from the residuals; null where it was given", |found| found.fit.estimated_error);
            of.field("estimated_displacement_error_nm", "standard error of a displacement, likewise; null where `fit.displacement_error` gives it", |found| found.fit.estimated_displacement_error);
            of.field("before_start_of_model", "points before the path of the model begins", |found| found.total(|of| of.curve.count(PointPlace::BeforeStart)));
            of.field("behind_jump_of_model", "points behind the first jump of the model", |found| found.total(|of| of.curve.count(PointPlace::BehindJump)));
        });
        of.field("curves", "each of the curves of `fit.curves`; empty where the scene has none", |found| found.curves());
        of.field("jump", "the first jump; null where none was measured, and of several curves", |found| found.only().and_then(|of| of.curve.jump));
        of.field("sum_of_squares", "of the residuals over their standard errors", |found| found.fit.sum_of_squares);
        of.field("degrees_of_freedom", "data less parameters", |found| found.fit.degrees_of_freedom);
        of.field("displacement_zero_nm", "the measured displacement at which the displacement of the model is zero; null of several curves", |found| found.only().map(|of| of.curve.displacement_zero));
        of.field("force_zero_nN", "the measured force at which the force of the model is zero; likewise", |found| found.only().map(|of| of.curve.force_zero));
        of.field("warnings", "what is not to be trusted", |found| found.fit.warnings());
        of.field("unknown_error", "of a seta and of a pull at a rate: which part of the errors of the curve has no bound; else null", |found| unknown_error(found.scene));
        of.field("paths", "how many paths were computed", |found| found.fit.paths);
        of.field("weightings", "how often residuals were weighted anew", |found| found.fit.weightings);
        of.field("solve_s", "time of the fit", |found| found.solve_s);
    }
}

impl Found for FitReport<'_> {
    const PARAMETERS: &'static str = "the scene with the parameters that were found";

    fn parameters(&self, _: &Scene) -> Object {
        parameters(&self.fitted_scene())
    }
}

impl FitReport<'_> {
    /// Each curve, with what was read.
    fn all(&self) -> impl Iterator<Item = CurveFound<'_>> {
        self.fit.curves.iter().zip(self.measured).map(|(curve, (file, measured))| CurveFound { file, measured, curve })
    }

    /// The only one.
    fn only(&self) -> Option<CurveFound<'_>> {
        self.all().next().filter(|_| self.measured.len() == 1)
    }

    fn curves(&self) -> Vec<CurveFound<'_>> {
        let named = self.scene.fit.as_ref().is_some_and(|table| !table.curves.is_empty());
        if named { self.all().collect() } else { Vec::new() }
    }

    fn total(&self, of: impl Fn(&CurveFound) -> usize) -> usize {
        self.all().map(|found| of(&found)).sum()
    }

    fn fitted(&self) -> Vec<Fitted<'_>> {
        let fitted = |(index, parameter)| Fitted { unit: self.unit(index), parameter };
        self.fit.parameters.iter().enumerate().map(fitted).collect()
    }
}

/// The name of an end, and the reason of one that has one.
fn end(end: &FitEnd) -> (&'static str, Option<&str>) {
    match end {
        FitEnd::Converged => ("converged", None),
        FitEnd::Stopped(why) => ("stopped", Some(why)),
        FitEnd::Interrupted => ("interrupted", None),
    }
}

/// A measured curve with its file and what the model says of it.
struct CurveFound<'a> {
    file: &'a str,
    measured: &'a MeasuredCurve,
    curve: &'a FittedCurve,
}

impl CurveFound<'_> {
    fn behind_jump(&self) -> usize {
        self.measured.behind_jump.len()
    }
}

impl Record for CurveFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("file", "its file, beside the scene", |found| found.file);
        of.field("points", "points that were fitted", |found| found.curve.points.len());
        of.field("behind_jump", "points behind its measured jump, which were not", |found| found.behind_jump());
        of.field("before_start_of_model", "points before the path of the model begins", |found| found.curve.count(PointPlace::BeforeStart));
        of.field("behind_jump_of_model", "points behind the first jump of the model", |found| found.curve.count(PointPlace::BehindJump));
        of.field("jump", "its first jump; null where none was measured", |found| found.curve.jump);
        of.field("displacement_zero_nm", "its displacement at which that of the model is zero", |found| found.curve.displacement_zero);
        of.field("force_zero_nN", "its force at which that of the model is zero", |found| found.curve.force_zero);
    }
}

/// A parameter and its unit.
struct Fitted<'a> {
    unit: &'static str,
    parameter: &'a FittedParameter,
}

impl Record for Fitted<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("key", "the key of the scene", |found| found.parameter.key.as_str());
        of.field("unit", "of its numbers here; null where it is a plain number", |found| Some(found.unit).filter(|unit| !unit.is_empty()));
        of.field("initial", "where the search began: the value of the scene", |found| found.parameter.initial);
        of.field("value", "where it ended", |found| found.parameter.value);
        of.field("standard_error", "standard error of the value; null at a bound", |found| found.parameter.standard_error);
        of.field("interval", "95 % confidence interval from the standard error, cut at the bounds of the search; null at a bound", |found| found.parameter.interval);
        of.field("profile_interval", "95 % interval of the profile likelihood, an end null where it is not bounded; null where there is no profile", |found| found.parameter.profile.as_ref().map(|profile| profile.interval));
        of.field("bounds", "between which it was searched for", |found| found.parameter.bounds);
        of.field("at_bound", "whether the search ended at one of them", |found| found.parameter.at_bound.is_some());
        of.field("poorly_determined", "whether half its interval is more than 10 % of its value", |found| found.parameter.poorly_determined);
    }
}

impl Record for Combination {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("exponents", "of the parameters, in their order; their squares add up to 1", |found| found.exponents.clone());
        of.field("relative_error", "standard error of the logarithm of the product", |found| found.relative_error);
    }
}

/// Two parameters that the curve hardly tells apart.
struct Pair<'a> {
    fit: &'a Fit,
    pair: &'a PairDetermined,
}

impl Record for Pair<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("keys", "their keys", |found| found.pair.parameters.map(|index| found.fit.parameters[index].key.as_str()));
        of.field("correlation", "of the two", |found| found.pair.correlation);
        of.field("exponent", "e: what is determined is the first times the second to the power e; null where one may be zero", |found| found.pair.exponent);
        of.field("relative_error", "standard error of the logarithm of that; null likewise", |found| found.pair.relative_error);
    }
}

impl Record for FittedJump {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "measured displacement of the machine there, half-way between the points around it", |jump| jump.displacement);
        of.field("standard_error_nm", "its standard error", |jump| jump.error);
        of.field("modelled_nm", "of the fitted model; null where its branch has no end", |jump| jump.modelled);
        of.field("used", "whether it is a datum", |jump| jump.used);
    }
}

impl Record for FitWarning {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("code", "a word that stays the same, for programs", |warning| warning.code());
        of.field("text", "what it says, with numbers and what to try", |warning| warning.to_string());
    }
}

/// The tables and the object.
pub(crate) fn outputs() -> Vec<Output> {
    vec![
        Output::object("peel fit", FitSummary::keys()),
        Output::table("fit.csv", PointRow::keys()),
        Output::table("fit.csv of steady forces", SteadyRow::keys()),
        Output::table("profiles.csv", ProfileRow::keys()),
    ]
}

// -- What a fit is reported with besides its result: its scene, its file and how long it took --

/// A fit with where it comes from.
#[derive(Clone, Copy, Debug)]
pub struct FitReport<'a> {
    /// The scene with the parameters at which the search began
    pub scene: &'a Scene,
    /// The files of the measured curves, as they were named, and what was read from them
    pub measured: &'a [(String, MeasuredCurve)],
    /// What was found
    pub fit: &'a Fit,
    /// Seconds that it took
    pub solve_s: f64,
    /// The key against which steady forces were measured; none of a curve
    pub against: Option<&'a Key>,
}

impl FitReport<'_> {
    /// The scene with the parameters that were found.
    pub fn fitted_scene(&self) -> Scene {
        let numbers = self.fit.parameters.iter().map(|parameter| (parameter.key.as_str(), parameter.value));
        self.scene.with_numbers(numbers)
    }

    /// The unit of a parameter; empty where it has none.
    pub fn unit(&self, index: usize) -> &'static str {
        key_of_parameter(&self.fit.parameters[index].key).map_or("", Key::unit)
    }
}
