//! The small seta that several tests share, and the curve of its tips.
//!
//! ```text
//!                ● root, moved, never turned
//!               /     shaft, 4000 nm, at 30 degrees from the normal, 250 nm thick
//!              ●      1500 nm above the tips
//!             / \
//!            ●   ●
//!           / \ / \   tips 600 nm apart, 97.7 nm thick, scattered by ±20 nm
//!          ============
//! ```

use peelkit::model::{CurvePoint, NormalPull, PullCurve, Seta, SetaMesh, SetaModel, Sideways};
use peelkit::study::{SetaLoading, SetaOptions, SetaPullOff, SetaStart, SetaStep, StepEnd, StopCriteria, pull_off};
use std::sync::Arc;

/// u (nm), P (nN) and dP/du (nN/nm)
const CURVE: [(f64, f64, f64); 7] = [
    (-50.0, -0.4, 0.009),
    (0.0, 0.1, 0.012),
    (100.0, 2.1, 0.035),
    (200.0, 4.7, 0.007),
    (300.0, 5.8, 0.013),
    (361.0, 6.67, 0.0),
    (364.0, 6.5, -0.2),
];

/// The curve of its tips: like that of a spatula, of few points.
pub fn curve() -> PullCurve {
    let point = |&(displacement, force, slope): &(f64, f64, f64)| CurvePoint { displacement, force, slope };
    PullCurve::new(CURVE.iter().map(point).collect(), -900.0).unwrap()
}

/// With four tips.
pub fn small() -> Seta {
    Seta {
        forks: 2,
        tip_pitch: 600.0,
        shaft_length: 4000.0,
        shaft_angle: 30f64.to_radians(),
        brush_height: 1500.0,
        brush_angle: 20f64.to_radians(),
        shaft_diameter: 250.0,
        height_scatter: 20.0,
        ..Seta::default()
    }
}

/// On elements of order 6, three a branch.
pub fn model(seta: Seta, sideways: Sideways) -> SetaModel {
    let law = NormalPull { curve: curve(), sideways, contact_height: 0.0 };
    let mesh = SetaMesh { order: 6, elements: vec![3; seta.levels() + 1] };
    SetaModel { mesh, ..SetaModel::new(seta, Arc::new(law)) }
}

/// A motion of the root along the normal.
pub fn along_normal(sign: f64, until: StepEnd) -> SetaStep {
    SetaStep { direction: [0.0, sign, 0.0], until }
}

/// With the default options.
pub fn pulled(model: &SetaModel, start: SetaStart, steps: &[SetaStep]) -> SetaPullOff {
    let loading = SetaLoading { start, steps: steps.to_vec() };
    pull_off(model, &loading, &SetaOptions::default(), &StopCriteria::default()).unwrap()
}
