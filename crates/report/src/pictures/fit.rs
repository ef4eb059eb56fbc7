//! The picture of a fit: the measured curve with that of the model, the residuals below, and profile likelihoods where there are any.

use crate::chart::RGBColor;
use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save_all;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::Picture;
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour, order_shade};
use crate::chart::symbol::Symbol;
use crate::records::of_many::fit::FitReport;
use crate::writing::error::ReportError;
use peelkit::study::{FittedCurve, FittedParameter, FittedPoint, MeasuredCurve, PointPlace, Profile};
use peelkit_scene::{Key, key_of_parameter};
use std::path::{Path, PathBuf};

const LEFT: f64 = 88.0;
const RIGHT: f64 = WIDTH as f64 - 18.0;

/// Draws `fit.svg` and `fit.png` into `dir`: the measured points with the curve of the model at the beginning and at the end, and the residuals over
/// their standard errors; and `profiles.svg` and `profiles.png` where there are profile likelihoods.
///
/// Fails where a file cannot be written ([`ReportError::Write`]).
pub fn draw_fit(of: &FitReport, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let (fit, units) = (of.fit, of.scene.written_units());
    let mut pictures = vec![(curves(of).in_units(units), "fit")];
    let profiles: Vec<_> =
        fit.parameters.iter().filter_map(|parameter| Some((parameter, parameter.profile.as_ref()?))).collect();
    if !profiles.is_empty() {
        pictures.push((of_profiles(&profiles, &of.scene.title).in_units(units), "profiles"));
    }
    save_all(&pictures, dir)
}

fn curves(of: &FitReport) -> Picture {
    let FitReport { scene, fit, against, .. } = of;
    let scale = against.map_or(1.0, |key| key.per_usual_unit());
    let (mut marks, mut lines) = (Vec::new(), Vec::new());
    let all = shown(of);
    for (index, shown) in all.iter().enumerate() {
        marks.extend(shown.marks(scale));
        lines.extend(shown.lines(scale, index == 0));
    }
    let places = || marks.iter().map(|mark| mark.at);
    let across = against.map_or_else(|| "displacement of the machine (nm)".to_owned(), Key::axis_title);
    let x = Axis::around(&across, places().map(|at| at.0), false);
    let modelled = fit.curves.iter().flat_map(|curve| &curve.curve);
    let fitted = modelled.filter(|at| scale * at.0 <= x.to).map(|at| at.1);
    let y = Axis::around(
        if against.is_some() { "steady force P (nN)" } else { "force P (nN)" },
        places().map(|at| at.1).chain(fitted),
        false,
    );
    let frame = Frame { left: LEFT, top: 40.0, right: RIGHT, bottom: 340.0 };
    let upper = Panel { lines, marks, ..Panel::new(frame, x.clone(), y) };
    Picture { title: scene.title.clone(), height: 614, panels: vec![upper, residuals(&all, x, scale)] }
}

/// A curve as it is drawn: the only one, or one of several with its name and its colour.
struct Shown<'a> {
    measured: &'a MeasuredCurve,
    found: &'a FittedCurve,
    of_several: Option<(String, RGBColor)>,
}

fn shown<'a>(of: &'a FitReport) -> Vec<Shown<'a>> {
    let count = of.measured.len();
    let one = |(index, (found, (file, measured))): (usize, (&'a FittedCurve, &'a (String, MeasuredCurve)))| {
        let name = Path::new(file).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let of_several = (count > 1).then(|| (name, order_shade(index, count)));
        Shown { measured, found, of_several }
    };
    of.fit.curves.iter().zip(of.measured).enumerate().map(one).collect()
}

fn dot(at: (f64, f64), colour: RGBColor, name: &str) -> Mark {
    Mark { at, symbol: Symbol::Dot, colour, name: Some(name.to_owned()), note: None }
}

impl Shown<'_> {
    fn colour(&self, only: RGBColor) -> RGBColor {
        self.of_several.as_ref().map_or(only, |(_, colour)| *colour)
    }

    fn marks(&self, scale: f64) -> Vec<Mark> {
        let name = self.of_several.as_ref().map_or("measured", |(name, _)| name);
        let ink = self.colour(colour::INK);
        let points = self.found.points.iter().map(|p| dot((scale * p.displacement, p.force), ink, name));
        let mut marks: Vec<Mark> = points.collect();
        let behind = self.measured.behind_jump.iter();
        marks.extend(
            behind.map(|p| dot((p.displacement, p.force), colour::GREY, "measured behind the jump, not fitted")),
        );
        if let Some((jump, modelled)) = self.found.jump.and_then(|jump| Some((jump.displacement, jump.modelled?))) {
            let force = self.found.curve.last().map_or(0.0, |at| at.1);
            let mark = |at, name: &str| Mark { symbol: Symbol::Diamond, ..dot((at, force), colour::VERMILLION, name) };
            marks.push(mark(modelled, "jump of the model"));
            marks.push(Mark { symbol: Symbol::Triangle, ..dot((jump, 0.0), colour::GREEN, "measured jump") });
        }
        marks
    }

    /// Those of the model; `named` are the lines of the first curve.
    fn lines(&self, scale: f64, named: bool) -> [Line; 2] {
        let line = |points: &[(f64, f64)], stroke, name: &str| Line {
            points: points.iter().map(|&(x, y)| (scale * x, y)).collect(),
            stroke,
            name: named.then(|| name.to_owned()),
        };
        let fitted = if self.of_several.is_some() { "fitted models" } else { "fitted model" };
        [
            line(&self.found.initial_curve, Stroke::dotted(colour::GREY, 1.8), "model of the scene"),
            line(&self.found.curve, Stroke::solid(self.colour(colour::BLUE), 2.0), fitted),
        ]
    }
}

fn residuals(all: &[Shown], x: Axis, scale: f64) -> Panel {
    let residual = |p: &FittedPoint| (scale * p.displacement, p.residual());
    let name = |place| {
        (place != PointPlace::OnBranch).then(|| "before the start, or behind the jump, of the model".to_owned())
    };
    let of_curve = |shown: &Shown| {
        let ink = shown.colour(colour::INK);
        let shade = |place| if place == PointPlace::OnBranch { ink } else { colour::ORANGE };
        let mark = |p: &FittedPoint| Mark { name: name(p.place), ..Mark::dot(residual(p), shade(p.place)) };
        shown.found.points.iter().map(mark).collect::<Vec<_>>()
    };
    let marks: Vec<Mark> = all.iter().flat_map(of_curve).collect();
    let y = Axis::around("residual / standard error", marks.iter().map(|mark| mark.at.1).chain([-3.0, 3.0]), false);
    let level = |height: f64, stroke| Line { points: vec![(x.from, height), (x.to, height)], stroke, name: None };
    let lines = vec![
        level(0.0, Stroke::solid(colour::INK, 1.0)),
        level(2.0, Stroke::dashed(colour::GREY, 1.0)),
        level(-2.0, Stroke::dashed(colour::GREY, 1.0)),
    ];
    let frame = Frame { left: LEFT, top: 400.0, right: RIGHT, bottom: 560.0 };
    Panel { lines, marks, ..Panel::new(frame, x, y) }
}

/// Height of a panel of a profile, and of the room for it.
const HEIGHT: f64 = 190.0;
const ROOM: f64 = 260.0;

fn of_profiles(profiles: &[(&FittedParameter, &Profile)], title: &str) -> Picture {
    let panel = |(number, (parameter, profile)): (usize, &(&FittedParameter, &Profile))| {
        let top = 40.0 + ROOM * number as f64;
        let name =
            key_of_parameter(&parameter.key).map_or(parameter.key.clone(), |key| key.axis_title_in_library_unit());
        let points = &profile.points;
        let x = Axis::around(&name, points.iter().map(|at| at.0), parameter.logarithmic);
        let y = Axis::linear("excess of the sum", 0.0, 1.3 * profile.level);
        let level = Line {
            points: vec![(x.from, profile.level), (x.to, profile.level)],
            stroke: Stroke::dashed(colour::VERMILLION, 1.4),
            name: Some("95 %".into()),
        };
        let curve = Line {
            points: points.clone(),
            stroke: Stroke::solid(colour::BLUE, 2.0),
            name: Some("profile likelihood".into()),
        };
        let marks = points.iter().map(|&at| Mark::dot(at, colour::BLUE)).collect();
        let frame = Frame { left: LEFT, top, right: RIGHT, bottom: top + HEIGHT };
        Panel { lines: vec![curve, level], marks, ..Panel::new(frame, x, y) }
    };
    let panels: Vec<Panel> = profiles.iter().enumerate().map(panel).collect();
    let height = 40.0 + ROOM * profiles.len() as f64;
    Picture { title: title.into(), height: height as u32, panels }
}
