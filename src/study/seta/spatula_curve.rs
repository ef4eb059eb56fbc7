//! The curve of a tip from the peel of its spatula: from where it is pressed to its first displacement limit point, where it snaps off.
//!
//! The points are those of polynomials through solutions on each step of the path. At the limit point u = u_s - s², so that P = P_s + a s + b s²: from the last point of the
//! path on, P follows that with the force and the slope of that point, up to a slope as steep as the branch of a seta never is.

use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::model::seta::normal_pull::{CurvePoint, PullCurve, PullCurveError};
use crate::model::step::Step;
use crate::solve::newton::Solution;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceError, TraceOptions};
use crate::solve::workspace::Workspace;
use crate::study::asked::accuracy::{Accuracy, Resolution};
use crate::study::initial::error::NoEquilibrium;
use crate::study::initial::prepared::prepared;
use crate::study::peel::step_dependence::StepCurve;
use std::sync::Arc;

/// Most points up to the limit point.
const MOST_POINTS: usize = 2000;
/// Points of the curve on a piece of a step of the path.
const INSIDE: usize = 4;
/// s of the points behind the last one of the path, over that.
const SHARES: [f64; 7] = [0.7, 0.5, 0.35, 0.25, 0.18, 0.12, 0.08];

/// Why a spatula has no curve of a tip.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SpatulaCurveError {
    #[error("the spatula of the tips has no equilibrium at the start of its pull: {0}")]
    NoStart(NoEquilibrium),
    #[error("the path of the spatula of the tips cannot be followed: {0}")]
    Path(#[from] TraceError),
    #[error(
        "the spatula of the tips has no displacement limit point within {points} points, up to u = {displacement} nm: it does not snap off"
    )]
    NoSnapOff { points: usize, displacement: f64 },
    #[error("the path of the spatula of the tips: {0}")]
    Curve(#[from] PullCurveError),
}

/// The curve of the tips of a seta from the peel of their spatula, which is pulled along the normal; it begins where the spatula is pressed by
/// so far, nm.
///
/// # Errors
/// A spatula without a path or without a snap-off.
pub fn tip_curve(spatula: &PeelModel, accuracy: &Accuracy, pressed: f64) -> Result<PullCurve, SpatulaCurveError> {
    let steps = if pressed > 0.0 { vec![Step::Press(pressed)] } else { Vec::new() };
    let model = PeelModel { steps, ..spatula.clone() };
    let accuracy = &accuracy.fitted(&model);
    let resolution = Resolution::first(&model, accuracy);
    let how = Discretisation::moving(accuracy.choice.form, resolution.order).on(accuracy.choice.mesh);
    let problem = prepared(&model, how, None).map_err(|failed| SpatulaCurveError::NoStart(failed.why))?.problem;
    let mut options = resolution.path_options(&model, accuracy.relative);
    options.elements = problem.initial(resolution.elements).mesh.elements();
    let trace = TraceOptions {
        kinds: &[LimitPointKind::Displacement],
        branches: false,
        relative: accuracy.relative,
        ..TraceOptions::default()
    };
    let path = Path::new(&problem, options);
    let mut tracer = PathTracer::new(&problem, path, trace);
    let limit = loop {
        if let PathEvent::LimitPoint { after, located, .. } = tracer.advance()? {
            break (after, located.observables);
        }
        let points = tracer.path().points();
        if points.len() > MOST_POINTS {
            let displacement = points[points.len() - 1].observables.displacement - pressed;
            return Err(SpatulaCurveError::NoSnapOff { points: points.len(), displacement });
        }
    };
    let (after, limit) = limit;
    let points = &tracer.path().points()[..=after];
    let mut curve = sampled(&problem, points, pressed);
    close(&mut curve, limit.displacement - pressed, limit.force);
    let works = PullCurve::new(curve.clone(), -1.0)?;
    // the energy of the point that is nearest to rest, less the work from there
    let displacement = |point: &Solution| point.observables.displacement - pressed;
    let nearest = points.iter().min_by(|a, b| displacement(a).abs().total_cmp(&displacement(b).abs()));
    let energy = nearest.map_or(0.0, |at| at.energy - works.energy(displacement(at)) + works.energy(0.0));
    Ok(PullCurve::new(curve, energy)?)
}

/// The path up to its last point: values and slopes of polynomials through solutions on each step, as the slopes of the points belong to the
/// mesh of each.
fn sampled(problem: &BeamProblem, points: &[Arc<Solution>], pressed: f64) -> Vec<CurvePoint> {
    let (mut curve, mut ws) = (Vec::new(), Workspace::default());
    let scale = problem.measure.force * problem.beam.length();
    for index in 0..points.len() - 1 {
        let segment = PathSegment::around(problem, points, index);
        for piece in StepCurve::pieces((problem, scale), &segment, segment.end(), &points[index + 1], &mut ws) {
            for k in usize::from(!curve.is_empty())..=INSIDE {
                let (u, du, force, df) = piece.at(2.0 * k as f64 / INSIDE as f64 - 1.0);
                curve.push(CurvePoint { displacement: u - pressed, force, slope: df / du });
            }
        }
    }
    curve
}

/// From the last point to the limit point.
fn close(curve: &mut Vec<CurvePoint>, displacement: f64, force: f64) {
    let Some(&last) = curve.last() else { return };
    let whole = (displacement - last.displacement).sqrt();
    // P = P_s + a s + b s² with dP/du = -(a + 2 b s)/(2 s)
    let (rise, slope) = (last.force - force, -2.0 * whole * last.slope);
    let (a, b) = (2.0 * rise / whole - slope, (slope - rise / whole) / whole);
    for share in SHARES {
        let s = share * whole;
        let slope = -(a + 2.0 * b * s) / (2.0 * s);
        curve.push(CurvePoint { displacement: displacement - s * s, force: force + s * (a + b * s), slope });
    }
}
