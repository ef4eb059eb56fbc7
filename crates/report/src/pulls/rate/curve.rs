//! The table of a pull at a rate, curve.csv. Units stand in the names of the columns.

use crate::records::pulled::{Contact, PointAtRate, PulledAtRate};
use crate::writing::error::ReportError;
use crate::writing::number::S_PER_NS;
use crate::writing::record::write_table;
use crate::writing::record::{Cell, Fields, Record, columns_of};
use crate::writing::reference::{Output, merged};
use peelkit::solve::time::EnergyBalance;
use std::path::{Path, PathBuf};

impl Record for PointAtRate {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("time_s", "since the pull began", |at| S_PER_NS * at.time);
        of.field("displacement_nm", "of what moves the grip, or the root: of the machine where the scene has `grip.stiffness`", |at| at.displacement);
        of.field("force_nN", "force of the grip, or on the root, along the pull", |at| at.force);
    }
}

/// Of a beam.
struct Front(f64);

impl Record for Front {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("front_nm", "of a beam the peeling front: how long the free end's adhesion would have to go on", |front| front.0);
    }
}

/// Of a seta.
struct Tips {
    attached: usize,
    force: f64,
    released: f64,
}

impl Record for Tips {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("tips_attached", "of a seta the number of tips that adhere", |tips| tips.attached);
        of.field("tip_forces_nN", "of a seta the sum of the forces with which the ground holds the tips, along the pull: the force on the root, but for the error of Newton's method", |tips| tips.force);
        of.field("released_aJ", "of a seta energy released at events since the pull began: a part of what is dissipated", |tips| tips.released);
    }
}

impl Record for EnergyBalance {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("work_aJ", "work since the pull began", |balance| balance.work);
        of.field("stored_aJ", "elastic energy, with that of springs in series with dashpots", |balance| balance.stored);
        of.field("adhesion_aJ", "energy of adhesion, negative", |balance| balance.adhesion);
        of.field("spring_aJ", "energy of the machine's spring", |balance| balance.spring);
        of.field("kinetic_aJ", "kinetic energy", |balance| balance.kinetic);
        of.field("dissipated_aJ", "dissipated by the material, and at events, since the pull began", |balance| balance.dissipated);
    }
}

/// A time, with what adheres then.
type Row<'a, C> = ((&'a PointAtRate, C), EnergyBalance);

fn fronts(points: &[PointAtRate]) -> impl Iterator<Item = Row<'_, Front>> {
    points.iter().filter_map(|point| match point.contact {
        Contact::Front(front) => Some(((point, Front(front)), point.balance)),
        Contact::Tips { .. } => None,
    })
}

fn tips(points: &[PointAtRate]) -> impl Iterator<Item = Row<'_, Tips>> {
    points.iter().filter_map(|point| match point.contact {
        Contact::Front(_) => None,
        Contact::Tips { attached, force, released } => {
            Some(((point, Tips { attached, force, released }), point.balance))
        }
    })
}

fn are_of_a_seta(points: &[PointAtRate]) -> bool {
    points.first().is_some_and(|point| matches!(point.contact, Contact::Tips { .. }))
}

/// Writes curve.csv: one row a step in time, from rest on; of a seta another one behind each event.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_rate_curve(dir: &Path, pulled: &PulledAtRate) -> Result<PathBuf, ReportError> {
    let points = &pulled.points;
    if are_of_a_seta(points) {
        write_table(dir, "curve.csv", tips(points))
    } else {
        write_table(dir, "curve.csv", fronts(points))
    }
}

/// The columns of curve.csv by their names.
pub fn rate_columns(points: &[PointAtRate]) -> Vec<(String, Vec<Cell>)> {
    if are_of_a_seta(points) { columns_of(tips(points)) } else { columns_of(fronts(points)) }
}

/// The table with all columns that it can have.
pub(super) fn output() -> Output {
    Output::table("curve.csv of a rate", merged(Row::<Front>::keys(), Row::<Tips>::keys()))
}
