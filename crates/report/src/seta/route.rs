//! How far the root of a seta has come, over all steps of its loading.

use peelkit::study::SetaPoint;

/// How far the root has moved at each point since the beginning, nm: over all steps, each counted forwards.
pub fn travels(points: &[SetaPoint]) -> Vec<f64> {
    let (mut before, mut step, mut last) = (0.0, 0, 0.0);
    let travel = |point: &SetaPoint| {
        if point.step != step {
            (before, step) = (before + last, point.step);
        }
        last = point.displacement;
        before + last
    };
    points.iter().map(travel).collect()
}
