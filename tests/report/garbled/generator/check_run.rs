//! What holds for the run of any scene.

use peelkit::study::{PathEnd, Peak, Peel, peel};
use peelkit_report::{PeelSummary, end_reason};
use peelkit_scene::Scene;

/// Whether a scene is computed, and not refused because its beam is too many process zones long.
pub fn is_computed(text: &str) -> bool {
    !Scene::parse("absurd.toml", text, &[]).is_err_and(|error| error.to_string().contains("process zones long"))
}

/// Peels a scene and says what is wrong with what came out: a number that is not finite, a peak without an error bound, a
/// failure without a reason.
pub fn check_run(text: &str) -> Result<(Scene, Peel), String> {
    let scene = Scene::parse("absurd.toml", text, &[]).map_err(|error| format!("refused: {error}"))?;
    let peel = peel(&scene.model, &scene.accuracy, &scene.bounds.from_now());
    PeelSummary::new(&scene, &peel, 0.0).to_json().map_err(|error| format!("summary.json: {error}"))?;
    for (index, point) in peel.points.iter().enumerate() {
        let numbers = [point.displacement, point.force, point.end_rotation, point.work, point.front];
        if numbers.iter().any(|number| !number.is_finite()) {
            return Err(format!("point {index} of the path is {point:?}"));
        }
    }
    let bounded =
        |peak: &Peak| [peak.force_error, peak.displacement_error].iter().all(|&error| error.is_finite() && error > 0.0);
    for (name, peak) in [("peak", &peel.peak), ("initiation peak", &peel.initiation_peak)] {
        if let Some(peak) = peak.as_ref().filter(|peak| !bounded(peak)) {
            return Err(format!("{name} without a bound: {peak:?}"));
        }
    }
    if let Some(point) = peel.limit_points.iter().find(|at| !(at.force_error > 0.0 && at.displacement_error > 0.0)) {
        return Err(format!("limit point without a bound: {point:?}"));
    }
    match &peel.end {
        end @ (PathEnd::Failed(_) | PathEnd::Bound(_))
            if end_reason(end).is_none_or(|reason| reason.trim().is_empty()) =>
        {
            Err(format!("{:?}", peel.end))
        }
        PathEnd::Failed(failure) if !failure.to_string().contains("Try ") => {
            Err(format!("says not what to try: {failure}"))
        }
        _ => Ok((scene, peel)),
    }
}
