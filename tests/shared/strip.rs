//! The strip of the paper, in every load and grip.

// each program takes a part of this
#![allow(dead_code)]

use peelkit::adhesion::LineLoad;
use peelkit::model::{Grip, Hold, StripModel};
use peelkit::study::{Accuracy, Peel, StopCriteria, peel};

/// The text of a scene with the paper's strip of 100 nm, and nothing that has a default.
pub const STRIP_SCENE: &str = r#"
[strip]
length = "100 nm"
height = "10 nm"
youngs_modulus = "2 GPa"
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

/// The paper's strip: h = 10 nm, width 1 nm, E = 2 GPa, nu = 0.2, both of the grip's other motions free.
///
/// `length` in nm; `factor` multiplies EI alone.
pub fn paper_strip(length: f64, factor: f64) -> StripModel {
    StripModel::of_the_paper(length, factor)
}

/// The same strip under another line load.
pub fn with_load(mut model: StripModel, line_load: LineLoad) -> StripModel {
    model.adhesion.line_load = line_load;
    model
}

/// The same strip in another grip.
pub fn with_grip(mut model: StripModel, rotation: Hold, horizontal: Hold) -> StripModel {
    model.grip = Grip { rotation, horizontal, ..model.grip };
    model
}

/// A whole peel without bounds that matter.
pub fn whole_peel(model: &StripModel, relative: f64) -> Peel {
    peel(model, &Accuracy::to(relative), &StopCriteria::after_points(5000))
}
