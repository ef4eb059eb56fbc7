//! The picture of a fit: the measured curve with that of the model, the residuals below, and profile likelihoods where there are any.

use crate::chart::RGBColor;
use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save_all;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::Picture;
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::chart::symbol::Symbol;
use crate::records::of_many::fit::FitReport;
use crate::writing::error::ReportError;
use peelkit::study::{Fit, FittedParameter, PointPlace, Profile};
use peelkit_scene::{Key, find_key};
use std::path::{Path, PathBuf};

const LEFT: f64 = 88.0;
const RIGHT: f64 = WIDTH as f64 - 18.0;

/// Draws `fit.svg` and `fit.png` into `dir`: the measured points with the curve of the model at the beginning and at the end, and the residuals over
/// their standard errors; and `profiles.svg` and `profiles.png` where there are profile likelihoods.
///
/// Fails where a file cannot be written ([`ReportError::Write`]).
pub fn draw_fit(of: &FitReport, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let (fit, units) = (of.fit, of.scene.units);
    let mut pictures = vec![(curves(of).in_units(units), "fit")];
    let profiles: Vec<_> =
        fit.parameters.iter().filter_map(|parameter| Some((parameter, parameter.profile.as_ref()?))).collect();
    if !profiles.is_empty() {
        pictures.push((of_profiles(&profiles, &of.scene.title).in_units(units), "profiles"));
    }
    save_all(&pictures, dir)
}

fn curves(of: &FitReport) -> Picture {
    let FitReport { scene, measured, fit, against, .. } = of;
    let scale = against.map_or(1.0, |key| key.per_usual_unit());
    let dot = |at: (f64, f64), colour: RGBColor, name: &str| Mark {
        at,
        symbol: Symbol::Dot,
        colour,
        name: Some(name.to_owned()),
        note: None,
    };
    let mut marks: Vec<Mark> =
        fit.points.iter().map(|p| dot((scale * p.displacement, p.force), colour::INK, "measured")).collect();
    let behind = measured.behind_jump.iter();
    marks.extend(behind.map(|p| dot((p.displacement, p.force), colour::GREY, "measured behind the jump, not fitted")));
    if let Some((jump, modelled)) = fit.jump.and_then(|jump| Some((jump.displacement, jump.modelled?))) {
        let force = fit.curve.last().map_or(0.0, |at| at.1);
        let mark = |at, name: &str| Mark { symbol: Symbol::Diamond, ..dot((at, force), colour::VERMILLION, name) };
        marks.push(mark(modelled, "jump of the model"));
        marks.push(Mark { symbol: Symbol::Triangle, ..dot((jump, 0.0), colour::GREEN, "measured jump") });
    }
    let line = |points: &[(f64, f64)], stroke, name: &str| Line {
        points: points.iter().map(|&(x, y)| (scale * x, y)).collect(),
        stroke,
        name: Some(name.to_owned()),
    };
    let lines = vec![
        line(&fit.initial_curve, Stroke::dotted(colour::GREY, 1.8), "model of the scene"),
        line(&fit.curve, Stroke::solid(colour::BLUE, 2.0), "fitted model"),
    ];
    let places = || marks.iter().map(|mark| mark.at);
    let across = against.map_or_else(|| "displacement of the machine (nm)".to_owned(), Key::axis_title);
    let x = Axis::around(&across, places().map(|at| at.0), false);
    let fitted = fit.curve.iter().filter(|at| scale * at.0 <= x.to).map(|at| at.1);
    let y = Axis::around(
        if against.is_some() { "steady force P (nN)" } else { "force P (nN)" },
        places().map(|at| at.1).chain(fitted),
        false,
    );
    let frame = Frame { left: LEFT, top: 40.0, right: RIGHT, bottom: 340.0 };
    let upper = Panel { lines, marks, ..Panel::new(frame, x.clone(), y) };
    Picture { title: scene.title.clone(), height: 614, panels: vec![upper, residuals(fit, x, scale)] }
}

fn residuals(fit: &Fit, x: Axis, scale: f64) -> Panel {
    let residual = |p: &peelkit::study::FittedPoint| (scale * p.displacement, (p.modelled - p.force) / p.error);
    let shade = |place| if place == PointPlace::OnBranch { colour::INK } else { colour::ORANGE };
    let name = |place| {
        (place != PointPlace::OnBranch).then(|| "before the start, or behind the jump, of the model".to_owned())
    };
    let mark = |p: &peelkit::study::FittedPoint| Mark { name: name(p.place), ..Mark::dot(residual(p), shade(p.place)) };
    let marks: Vec<Mark> = fit.points.iter().map(mark).collect();
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
        let name = find_key(&parameter.key).map_or(parameter.key.clone(), |key| key.axis_title_in_library_unit());
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
