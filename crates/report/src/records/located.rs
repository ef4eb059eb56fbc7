//! What was located on a path, as objects of summary.json.

use super::path::grip;
use crate::writing::names::limit_point_kind_word;
use crate::writing::record::{Fields, Record};
use peelkit::model::SpatialGrip;
use peelkit::study::{
    BranchPoint, EventAt, Events, LargestComputedForce, LimitPoint, MissedStation, OutOfPlaneLoss, Peak, Plateau,
    Station, StationAt, Stations,
};

impl Record for Peak {
    fn fields(of: &mut Fields<Self>) {
        of.field("force_nN", "P there", |at| at.force);
        of.field("displacement_nm", "u there", |at| at.displacement);
        of.field("end_rotation_rad", "rotation of the grip there", |at| at.end_rotation);
        of.field("error_nN", "bound of the error of the force", |at| at.force_error);
        of.field("error_nm", "bound of the error of the displacement", |at| at.displacement_error);
    }
}

impl Record for LargestComputedForce {
    fn fields(of: &mut Fields<Self>) {
        of.field("force_nN", "P there", |at| at.force);
        of.field("displacement_nm", "u there", |at| at.displacement);
        of.field("located", "always false: a located one is a peak", |_| false);
    }
}

impl Record for Plateau {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("force_nN", "P there", |at| at.force);
        of.field("displacement_nm", "u there", |at| at.displacement);
        of.field("error_nN", "bound of the error of the force; null beside another place that may be the less steep one with other steps", |at| at.force_error);
        of.field("error_nm", "how far from there the force changes as little; null likewise", |at| at.displacement_error);
        of.field("stable", "whether the beam is stable under displacement control there", |at| at.stable);
    }
}

impl Record for LimitPoint {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("kind", "`displacement` (du = 0) or `load` (dP = 0)", |at| limit_point_kind_word(at.kind));
        of.field("displacement_nm", "u there", |at| at.displacement);
        of.field("force_nN", "P there", |at| at.force);
        of.field("end_rotation_rad", "rotation of the grip there", |at| at.end_rotation);
        of.field("work_aJ", "work of the grip from the beginning of the path to there; the moment of a grip that rotates as it goes included", |at| at.work);
        of.field("error_nm", "bound of the error of the displacement", |at| at.displacement_error);
        of.field("error_nN", "bound of the error of the force", |at| at.force_error);
        of.field("error_aJ", "bound of the error of the work; null with friction and for a load without a potential", |at| at.work_error);
        of.field("flat", "whether the force is so level there that the displacement cannot be determined and does not matter", |at| at.flat);
        of.sometimes_part(|at| at.in_space.map(GripThere));
    }
}

/// The grip at a limit point in space.
struct GripThere(SpatialGrip);

impl Record for GripThere {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        let about = [
            "in space, like the next four: moment of the grip on the roll there; 0 where that is free",
            "roll of the grip there, about its axis",
            "yaw of the grip there, about the normal of the substrate",
            "force of the grip there normal to the pull, in its vertical plane; 0 where it is free",
            "force of the grip there normal to that plane; 0 where it is free",
        ];
        grip(of, about, |at| at.0);
    }
}

/// A displacement limit point without what is the same of all.
pub(super) struct Fold(pub LimitPoint);

impl Record for Fold {
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "u there", |at| at.0.displacement);
        of.field("force_nN", "P there", |at| at.0.force);
        of.field("work_aJ", "work of the grip up to there", |at| at.0.work);
        of.field("error_nm", "bound of the error of the displacement", |at| at.0.displacement_error);
        of.field("error_nN", "bound of the error of the force", |at| at.0.force_error);
        of.field("error_aJ", "bound of the error of the work; null as above", |at| at.0.work_error);
    }
}

/// Displacement and force of a located place, with the bounds of their errors, where such were found.
pub(super) struct Place {
    displacement: f64,
    force: f64,
    displacement_error: f64,
    force_error: f64,
}

impl Record for Place {
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "u there", |at| at.displacement);
        of.field("force_nN", "P there", |at| at.force);
        of.field("error_nm", "bound of the error of the displacement", |at| finite(at.displacement_error));
        of.field("error_nN", "bound of the error of the force", |at| finite(at.force_error));
    }
}

/// A number that there is: the bound of an error that was found, or what follows from an absurd model and has not overflown.
pub(super) fn finite(number: f64) -> Option<f64> {
    Some(number).filter(|number| number.is_finite())
}

impl From<&OutOfPlaneLoss> for Place {
    fn from(at: &OutOfPlaneLoss) -> Self {
        let &OutOfPlaneLoss { displacement, force, displacement_error, force_error, .. } = at;
        Self { displacement, force, displacement_error, force_error }
    }
}

impl From<&BranchPoint> for Place {
    fn from(at: &BranchPoint) -> Self {
        let &BranchPoint { displacement, force, displacement_error, force_error, .. } = at;
        Self { displacement, force, displacement_error, force_error }
    }
}

impl Record for BranchPoint {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.part(Place::from);
        of.field("negative_eigenvalues", "of the displacement-controlled tangent before it and behind it", |at| at.negative_eigenvalues);
    }
}

// -- Stations: equilibria at an exact value of a quantity --

impl Record for StationAt {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("quantity", "`displacement`, `force`, `front`, `end_rotation` or `free_end_gap`; of a pull at a rate `time` as well", |at| at.quantity.name());
        of.field("value", "its value that was asked for: nm, of a force nN, of a rotation rad, of a time ns", |at| at.value);
    }
}

impl Record for Station {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "u there", |at| at.displacement);
        of.field("force_nN", "P there", |at| at.force);
        of.field("end_rotation_rad", "rotation of the grip there", |at| at.end_rotation);
        of.field("front_nm", "length that still adheres there, by its energy", |at| at.front);
        of.field("work_aJ", "work of the grip from the beginning of the path to there", |at| at.work);
        of.field("negative_eigenvalues", "number of unstable directions under displacement control there; 0: stable", |at| at.negative_eigenvalues);
        of.field("negative_eigenvalues_load", "the same under force control", |at| at.negative_eigenvalues_load);
        of.field("error_nm", "bound of the error of the displacement; round-off where that was asked for. Like all bounds null with friction, where a term was left out, and next to a limit point that half as many elements again have elsewhere", |at| at.errors.map(|errors| errors.displacement));
        of.field("error_nN", "bound of the error of the force", |at| at.errors.map(|errors| errors.force));
        of.field("error_rad", "bound of the error of the rotation", |at| at.errors.map(|errors| errors.end_rotation));
        of.field("error_front_nm", "bound of the error of the length that still adheres", |at| at.errors.map(|errors| errors.front));
        of.field("after_point", "it lies behind this row of curve.csv, counted from 0", |at| at.after);
        of.field("free_end_gap_nm", "distance of the nearer edge of the section at the free end, S = 0, from the ground", |at| at.free_end_gap);
        of.field("error_gap_nm", "bound of the error of that distance", |at| at.errors.map(|errors| errors.free_end_gap));
    }
}

impl Record for Stations {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.part(|stations| stations.at);
        of.field("found", "the equilibria, in path order; empty where the path does not pass the value", |stations| stations.found.as_slice());
        of.field("least", "the least value on the path", |stations| finite(stations.range[0]));
        of.field("largest", "the largest value on the path", |stations| finite(stations.range[1]));
        of.field("missed", "why an equilibrium could not be computed where the path passes the value, a text each", |stations| missed(&stations.missed));
    }
}

fn missed(missed: &[MissedStation]) -> Vec<String> {
    missed.iter().map(ToString::to_string).collect()
}

// -- Events of the user: where a quantity passes a value --

impl Record for EventAt {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("name", "what the user calls it; the condition where it has no other name", |at| at.name.clone());
        of.field("quantity", "as of a station; of a seta `attached` as well; `own` of a function in a program", |at| at.quantity.name());
        of.field("value", "the value that it passes, in the unit of a station; tips of `attached`", |at| at.value);
        of.field("passing", "`=` where it counts both ways, `>` where it rises past the value, `<` where it falls", |at| at.passing.sign());
        of.field("action", "`record`, or `stop`: nothing is followed beyond it", |at| at.action.name());
    }
}

impl Record for Events {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.part(|events| events.at.clone());
        of.field("found", "the equilibria, in path order, as those of a station; empty where the path does not pass the value so", |events| events.found.as_slice());
        of.field("least", "the least value on the path", |events| finite(events.range[0]));
        of.field("largest", "the largest value on the path", |events| finite(events.range[1]));
        of.field("missed", "why an equilibrium could not be computed where the path passes the value, a text each", |events| missed(&events.missed));
    }
}
