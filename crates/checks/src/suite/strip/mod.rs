//! The strip against collocation of the strong form, exact relations and limits; and topics of their own for strips that differ from the paper's in one
//! thing: the law of adhesion, friction, the direction of the pull, or that they may leave their plane.

mod case;
pub(super) mod films;
pub(super) mod laws;
pub(super) mod out_of_plane;
mod peaks;
pub(super) mod pull;
mod steady;
pub(super) mod turns;
mod values;

use crate::check::{Check, Topic};
use case::Case;

pub(super) const TOPIC: Topic = Topic {
    name: "strip",
    about: "the peeling strip: collocation of the strong form, exact relations, limits",
    checks,
};

const POINTS: &str = include_str!("../../../verification/strip_points.csv");

fn checks() -> Vec<Check> {
    let whole = Case::all(POINTS, |_| None);
    let mut checks = values::checks(&whole);
    checks.extend(steady::checks());
    checks.extend(peaks::checks());
    checks.extend(values::paid(&whole));
    checks.extend(values::of_stations());
    checks
}
