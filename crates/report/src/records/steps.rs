//! What the grip does in the steps before a pull: the ends of the steps in summary.json, and steps.csv.

use crate::writing::error::ReportError;
use crate::writing::record::{Cell, Fields, Record, columns_of, table, write_text};
use crate::writing::reference::Output;
use peelkit::beam::{ForcesInSpace, GripState, PlaceInSpace, StepJump};
use peelkit::model::Step;
use peelkit::study::Peel;
use std::io;
use std::path::{Path, PathBuf};

/// A step, the grip after it, and the jumps on its way.
pub(super) struct StepEnd<'a> {
    pub step: &'a Step,
    pub grip: &'a GripState,
    pub jumps: Vec<StepJump>,
}

impl Record for StepEnd<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("step", "the step as the scene has it", |end| end.step.to_string());
        of.part(|end| InPlane(*end.grip));
        of.sometimes_part(|end| end.grip.in_space.map(|_| InSpace(*end.grip)));
        of.sometimes("jumps", "where the beam has jumped on the way of the step, with the grip where it was; absent where it has not", |end| Some(end.jumps.clone()).filter(|jumps| !jumps.is_empty()));
    }
}

impl Record for StepJump {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("x_nm", "place of the grip, as of the step", |jump| jump.before.x);
        of.field("y_nm", "likewise", |jump| jump.before.y);
        of.field("end_rotation_rad", "likewise", |jump| jump.before.rotation);
        of.field("vertical_force_before_nN", "its force upwards where stability is lost", |jump| jump.before.forces.vertical);
        of.field("vertical_force_after_nN", "the same where the beam has come to rest", |jump| jump.after.forces.vertical);
        of.field("released_aJ", "energy that the jump releases, on the mesh of the step, without a bound", |jump| jump.released);
    }
}

/// The grip in the vertical plane of a beam that lies along x, relative to where it took hold.
#[derive(Clone, Copy)]
struct InPlane(GripState);

impl Record for InPlane {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("x_nm", "how far the grip has moved along the substrate; null where it is free", |grip| grip.0.x);
        of.field("y_nm", "how far it has moved up", |grip| grip.0.y);
        of.field("end_rotation_rad", "how far it has rotated", |grip| grip.0.rotation);
        of.field("horizontal_force_nN", "its force along the substrate", |grip| grip.0.forces.horizontal);
        of.field("vertical_force_nN", "its force upwards", |grip| grip.0.forces.vertical);
        of.field("moment_nN_nm", "its moment", |grip| grip.0.forces.moment);
    }
}

/// The grip out of that plane.
#[derive(Clone, Copy)]
struct InSpace(GripState);

impl InSpace {
    fn place(&self) -> PlaceInSpace {
        self.0.in_space.unwrap_or_default()
    }

    fn forces(&self) -> ForcesInSpace {
        self.0.forces.in_space.unwrap_or_default()
    }
}

impl Record for InSpace {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("z_nm", "in space, like the next five: how far it has moved sideways", |grip| grip.place().z);
        of.field("roll_deg", "its roll", |grip| grip.place().roll.to_degrees());
        of.field("yaw_deg", "its yaw", |grip| grip.place().yaw.to_degrees());
        of.field("lateral_force_nN", "its force sideways", |grip| grip.forces().lateral);
        of.field("torque_nN_nm", "its moment on the roll", |grip| grip.forces().torque);
        of.field("yaw_moment_nN_nm", "its moment on the yaw", |grip| grip.forces().yaw_moment);
    }
}

/// An equilibrium on the way of a step.
#[derive(Clone, Copy)]
struct WayRow {
    /// From 1
    step: usize,
    along: Option<[f64; 2]>,
}

impl Record for WayRow {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("step", "number of the step in `drive.steps`, from 1", |row| row.step);
        of.field("displacement_nm", "how far the grip has come along the direction of the pull; empty where it is free there", |row| row.along.map(|along| along[0]));
        of.field("force_nN", "its force along that direction; empty likewise", |row| row.along.map(|along| along[1]));
    }
}

/// Writes steps.csv: one row an equilibrium of the steps before the pull, in order. Those between the ends of a step are on the mesh of the step.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_steps(dir: &Path, peel: &Peel) -> Result<PathBuf, ReportError> {
    write_text(dir, "steps.csv", text(peel))
}

/// The columns of steps.csv by their names.
pub fn steps_columns(peel: &Peel) -> Vec<(String, Vec<Cell>)> {
    let rows = rows(peel);
    match peel.model.space {
        Some(_) => columns_of(rows.map(|(row, grip)| (row, InSpace(grip)))),
        None => columns_of(rows.map(|(row, _)| row)),
    }
}

fn text(peel: &Peel) -> io::Result<Vec<u8>> {
    let rows = rows(peel);
    match peel.model.space {
        Some(_) => table(rows.map(|(row, grip)| (row, InSpace(grip)))),
        None => table(rows.map(|(row, _)| row)),
    }
}

/// The rows, and the grip of each.
fn rows(peel: &Peel) -> impl Iterator<Item = ((WayRow, InPlane), GripState)> {
    let of_step = |(step, way): (usize, &Vec<GripState>)| {
        let row = |&grip: &GripState| ((WayRow { step, along: peel.model.along_pull(&grip) }, InPlane(grip)), grip);
        way.iter().map(row).collect::<Vec<_>>()
    };
    (1..).zip(&peel.step_ways).flat_map(of_step)
}

/// The table with all columns that it can have.
pub(crate) fn outputs() -> Vec<Output> {
    vec![Output::table("steps.csv", <((WayRow, InPlane), InSpace)>::keys())]
}
