//! The tables of a pull-off: curve.csv, events.csv, tips.csv, tip.csv. Units stand in the names of the columns.

use super::motion::travels;
use super::names::tip_branch_word;
use crate::writing::error::ReportError;
use crate::writing::number::S_PER_NS;
use crate::writing::record::write_table;
use crate::writing::record::{Cell, Fields, Record, columns_of};
use crate::writing::reference::{Output, merged};
use peelkit::model::{CurvePoint, PullCurve, Seta};
use peelkit::study::{
    EventCause, SetaEvent, SetaInTime, SetaInTimeEvent, SetaPoint, SetaPullOff, SetaState, TipChange, TipLoss, TipState,
};
use std::path::{Path, PathBuf};

/// An equilibrium, and how far the root has moved in all steps.
struct PointRow<'a> {
    point: &'a SetaPoint,
    travel: f64,
}

impl Record for PointRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("step", "number of the step of the loading, from 1; the pull is the last one", |row| row.point.step + 1);
        of.field("displacement_nm", "how far the root has moved in the step", |row| row.point.displacement);
        of.field("travel_nm", "how far it has moved in all steps", |row| row.travel);
        of.field("force_nN", "force on the root along the direction of the step, positive where it is pulled", |row| row.point.force_along);
        of.field("tips_attached", "number of tips that adhere", |row| row.point.attached);
        of.field("root_x_nm", "place of the root from where it is when the plane of the tips is the ground", |row| row.point.root[0]);
        of.field("root_y_nm", "the same along the normal of the ground", |row| row.point.root[1]);
        of.field("root_z_nm", "the same along z", |row| row.point.root[2]);
        of.field("force_x_nN", "force on the root along x", |row| row.point.force[0]);
        of.field("force_y_nN", "along the normal of the ground", |row| row.point.force[1]);
        of.field("force_z_nN", "along z", |row| row.point.force[2]);
        of.field("moment_x_nN_nm", "moment on the root about x", |row| row.point.moment[0]);
        of.field("moment_y_nN_nm", "about the normal of the ground", |row| row.point.moment[1]);
        of.field("moment_z_nN_nm", "about z", |row| row.point.moment[2]);
        of.field("energy_aJ", "stored energy and that of adhesion, against a detached stress-free seta", |row| row.point.energy);
        of.field("work_aJ", "work of the root from the start", |row| row.point.work);
        of.field("released_aJ", "energy released in events from the start", |row| row.point.released);
    }
}

/// Writes curve.csv: one row a stable equilibrium, in order; those at both sides of an event are among them.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_seta_curve(dir: &Path, pull_off: &SetaPullOff) -> Result<PathBuf, ReportError> {
    write_points(dir, "curve.csv", pull_off)
}

/// Writes equilibria.csv beside a pull at a rate: with the rows and columns of curve.csv.
///
/// Fails as [`write_seta_curve`] does.
pub fn write_seta_equilibria(dir: &Path, pull_off: &SetaPullOff) -> Result<PathBuf, ReportError> {
    write_points(dir, "equilibria.csv", pull_off)
}

fn write_points(dir: &Path, name: &str, pull_off: &SetaPullOff) -> Result<PathBuf, ReportError> {
    write_table(dir, name, rows(&pull_off.points))
}

fn rows(points: &[SetaPoint]) -> impl Iterator<Item = PointRow<'_>> {
    points.iter().zip(travels(points)).map(|(point, travel)| PointRow { point, travel })
}

/// The columns of curve.csv by their names.
pub fn pull_off_columns(points: &[SetaPoint]) -> Vec<(String, Vec<Cell>)> {
    columns_of(rows(points))
}

const EVENT: &str = "number of the event, from 1: the tips that change while the root is held. One that begins with beams that buckle has a row of its own before those of its tips";
const DISPLACEMENT: &str = "how far the root has moved in the step";

/// An event of a pull-off.
#[derive(Clone, Copy)]
struct OfPullOff {
    event: usize,
    step: usize,
    displacement: f64,
}

impl Record for OfPullOff {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("event", EVENT, |at| at.event);
        of.field("step", "number of the step of the loading, from 1; not of a pull at a rate", |at| at.step);
        of.field("displacement_nm", DISPLACEMENT, |at| at.displacement);
    }
}

/// An event of a pull at a rate.
#[derive(Clone, Copy)]
struct AtRate {
    event: usize,
    time: f64,
    displacement: f64,
    loss: TipLoss,
}

impl Record for AtRate {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("event", EVENT, |at| at.event);
        of.field("time_s", "of a pull at a rate: since it began", |at| S_PER_NS * at.time);
        of.field("displacement_nm", DISPLACEMENT, |at| at.displacement);
        of.field("loss", "of a pull at a rate: `end-of-branch` where tips come to the end of the branch of their law, `unstable` where they soften faster than the seta holds them", |at| loss_word(at.loss));
    }
}

fn loss_word(loss: TipLoss) -> &'static str {
    match loss {
        TipLoss::EndOfBranch => "end-of-branch",
        TipLoss::Unstable => "unstable",
    }
}

/// What changes in an event: a tip, or none where beams buckle.
#[derive(Clone, Copy)]
struct ChangeRow<'a> {
    seta: &'a Seta,
    tip: Option<&'a TipChange>,
    /// Force on the root before the event, and behind it
    force: [f64; 2],
    attached: usize,
    released: f64,
}

impl Record for ChangeRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("tip", "number of the tip, from 0; like all columns of a tip empty where beams buckle", |row| Some(row.tip?.tip));
        of.field("tip_x_nm", "place of the tip in the stress-free configuration, along x", |row| Some(row.place()?[0]));
        of.field("tip_z_nm", "the same along z", |row| Some(row.place()?[2]));
        of.field("change", "`detaches` or `adheres`; `buckles` in the row of beams that buckle", |row| row.word());
        of.field("tip_load_nN", "force of the tip away from the ground before the event", |row| Some(0.0 - row.tip?.load[1]));
        of.field("force_before_nN", "force on the root along the direction of the step before the event", |row| row.force[0]);
        of.field("force_after_nN", "the same behind it", |row| row.force[1]);
        of.field("tips_attached", "number of tips that adhere behind the event", |row| row.attached);
        of.field("released_aJ", "energy released in the event, with all of its tips", |row| row.released);
    }
}

impl ChangeRow<'_> {
    fn place(&self) -> Option<[f64; 3]> {
        Some(self.seta.joint_place(self.seta.tip_joint(self.tip?.tip)))
    }

    fn word(&self) -> &'static str {
        match self.tip {
            Some(change) if change.to.adheres() => "adheres",
            Some(_) => "detaches",
            None => "buckles",
        }
    }
}

/// Writes events.csv: one row a tip that detaches or adheres again, in order; before them one without a tip where an event begins with beams that
/// buckle.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_seta_events(dir: &Path, pull_off: &SetaPullOff, seta: &Seta) -> Result<PathBuf, ReportError> {
    let rows = pull_off.events.iter().enumerate().flat_map(|(number, event)| {
        let SetaEvent { before, after, cause, released, tips, .. } = event;
        let at = OfPullOff { event: number + 1, step: before.step + 1, displacement: before.displacement };
        let force = [before.force_along, after.force_along];
        let row = |tip| (at, ChangeRow { seta, tip, force, attached: after.attached, released: *released });
        let buckling = (*cause == EventCause::Buckling).then(|| row(None));
        buckling.into_iter().chain(tips.iter().map(|change| row(Some(change)))).collect::<Vec<_>>()
    });
    write_table(dir, "events.csv", rows)
}

/// Writes events.csv of a pull at a rate: one row a tip that leaves the branch of its law, in order.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_seta_rate_events(dir: &Path, pulled: &SetaInTime, seta: &Seta) -> Result<PathBuf, ReportError> {
    let rows = pulled.events.iter().enumerate().flat_map(|(number, event)| {
        let SetaInTimeEvent { before, after, loss, released, tips, .. } = event;
        let at = AtRate { event: number + 1, time: before.time, displacement: before.displacement, loss: *loss };
        let force = [before.force, after.force];
        let row = |tip| (at, ChangeRow { seta, tip: Some(tip), force, attached: after.attached, released: *released });
        tips.iter().map(row).collect::<Vec<_>>()
    });
    write_table(dir, "events.csv", rows)
}

/// A point of the curve that each tip follows.
struct TipPointRow<'a> {
    curve: &'a PullCurve,
    at: &'a CurvePoint,
}

impl Record for TipPointRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "height of the tip above its place of adhesion; below zero where it is pressed", |row| row.at.displacement);
        of.field("force_nN", "force along the normal", |row| row.at.force);
        of.field("slope_nN_per_nm", "its derivative by the displacement", |row| row.at.slope);
        of.field("energy_aJ", "energy of the tip against a detached one", |row| row.curve.energy(row.at.displacement));
    }
}

/// Writes tip.csv: the curve that each tip follows, from where it is pressed to where it snaps off.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_tip_curve(dir: &Path, curve: &PullCurve) -> Result<PathBuf, ReportError> {
    write_table(dir, "tip.csv", curve.points().iter().map(|at| TipPointRow { curve, at }))
}

/// A tip at a moment of the pull.
struct TipRow<'a> {
    moment: &'static str,
    seta: &'a Seta,
    state: &'a SetaState,
    tip: usize,
    at: &'a TipState,
}

impl Record for TipRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("moment", "`first-detachment`, `peak` or `last-detachment` of the pull, or `end`", |row| row.moment);
        of.field("tip", "number of the tip, from 0", |row| row.tip);
        of.field("tip_x_nm", "place of the tip in the stress-free configuration, along x", |row| row.seta.joint_place(row.joint())[0]);
        of.field("tip_z_nm", "the same along z", |row| row.seta.joint_place(row.joint())[2]);
        of.field("state", "`attached`: its force grows as it is pulled; `detaching`: it falls; `detached`", |row| tip_branch_word(row.at.on));
        of.field("height_nm", "height of the tip above its place of adhesion", |row| row.state.joints[row.joint()].place[1] - row.at.foot[1]);
        of.field("load_x_nN", "force that the tip exerts on the ground along x", |row| row.on_ground(0));
        of.field("load_y_nN", "along the normal: positive where it pulls the ground upwards", |row| row.on_ground(1));
        of.field("load_z_nN", "along z", |row| row.on_ground(2));
    }
}

impl TipRow<'_> {
    fn joint(&self) -> usize {
        self.seta.tip_joint(self.tip)
    }

    /// What the tip exerts on the ground: upwards where it is pulled.
    fn on_ground(&self, axis: usize) -> f64 {
        0.0 - self.at.load[axis]
    }
}

/// Writes tips.csv: one row a tip at each of these moments, which have names.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_tips(dir: &Path, seta: &Seta, moments: &[(&'static str, &SetaState)]) -> Result<PathBuf, ReportError> {
    let rows = moments.iter().flat_map(|&(moment, state)| {
        state.tips.iter().enumerate().map(move |(tip, at)| TipRow { moment, seta, state, tip, at })
    });
    write_table(dir, "tips.csv", rows)
}

/// The tables with all columns that they can have.
pub(super) fn outputs() -> Vec<Output> {
    let events = merged(<(OfPullOff, ChangeRow)>::keys(), <(AtRate, ChangeRow)>::keys());
    vec![
        Output::table("curve.csv of a seta", PointRow::keys()),
        Output::table("events.csv", events),
        Output::table("tips.csv", TipRow::keys()),
        Output::table("tip.csv", TipPointRow::keys()),
    ]
}
