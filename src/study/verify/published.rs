//! Values printed in the paper, from their closed forms.

use super::{Check, Measure, Topic};
use crate::adhesion::HalfSpace;

pub(super) const TOPIC: Topic = Topic { name: "published", about: "values that the paper prints", run };

const HALF_SPACE: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

fn run() -> Vec<Check> {
    let check = |name: &str, source: &str, computed, expected, tolerance| {
        Check::new(TOPIC.name, name, source, Ok(computed), expected, Measure::Absolute, tolerance)
    };
    vec![check("w_adh, J/m²", "Section 6: 0.0307 J/m²", HALF_SPACE.work_of_adhesion(), 0.0307, 5e-5)]
}
