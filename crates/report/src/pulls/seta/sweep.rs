//! A sweep of setae: its rows, sweep.csv, the same as one object, and the picture.
use crate::chart::picture::Heading;
use crate::chart::style::colour;
use crate::pulls::seta::locus::draw_locus;
use crate::pulls::seta::names::end_word;
use crate::pulls::swept_pulls::{Quantity, draw_swept_pulls};
use crate::records::of_many::sweep::{SweepSummary, write_swept};
use crate::swept::{PullRow, SweptKeys};
use crate::writing::error::ReportError;
use crate::writing::record::{Fields, Record};
use peelkit::study::{SetaMoment, SetaResult};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

/// One value of a sweep of setae: forces in nN, displacements in nm, works in aJ.
pub type SetaRow = PullRow<SetaResult>;

impl SetaRow {
    /// Its peak, if it was reached.
    pub fn peak(&self) -> Option<SetaMoment> {
        self.found.as_ref().ok()?.peak
    }

    /// The name of its end in outputs.
    pub fn end(&self) -> &'static str {
        self.found.as_ref().map_or("failed", |found| end_word(&found.end, found.attached))
    }

    /// Work of the root, of a pull-off that was computed to its end, aJ.
    pub(super) fn work(&self) -> Option<f64> {
        self.found.as_ref().ok().filter(|found| !found.end.is_cut_short()).map(|found| found.work)
    }
}

// -- The table of a sweep of setae, sweep.csv, and the same as one object --

impl Record for SetaRow {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("value", "the value of the key that was varied", |row| row.value);
        of.sometimes("value_2", "of the second key, where two are varied", |row| row.second);
        of.field("peak_force_nN", "the largest force on the root along the pull", |row| row.of(|found| Some(found.peak?.force)));
        of.field("peak_force_x_nN", "of the force on the root there, along x", |row| row.of(|found| Some(found.peak?.on_root[0])));
        of.field("peak_force_y_nN", "along y, off the ground", |row| row.of(|found| Some(found.peak?.on_root[1])));
        of.field("peak_force_z_nN", "along z", |row| row.of(|found| Some(found.peak?.on_root[2])));
        of.field("peak_displacement_nm", "how far the root has moved there in the pull", |row| row.of(|found| Some(found.peak?.displacement)));
        of.field("peak_tips_attached", "tips that adhere there", |row| row.of(|found| Some(found.peak?.attached)));
        of.field("mesh_error_nN", "by how much the peak force differs from that with elements one order lower; empty where no finer mesh came to it", |row| row.of(|found| found.mesh_error));
        of.field("first_detachment_force_nN", "force just before the first detachment of a tip in the pull", |row| row.of(|found| Some(found.first_detachment?.force)));
        of.field("first_detachment_force_x_nN", "of the force on the root there, along x", |row| row.of(|found| Some(found.first_detachment?.on_root[0])));
        of.field("first_detachment_force_y_nN", "along y, off the ground", |row| row.of(|found| Some(found.first_detachment?.on_root[1])));
        of.field("first_detachment_force_z_nN", "along z", |row| row.of(|found| Some(found.first_detachment?.on_root[2])));
        of.field("first_detachment_displacement_nm", "how far the root has moved there", |row| row.of(|found| Some(found.first_detachment?.displacement)));
        of.field("last_detachment_force_nN", "force just before the last one", |row| row.of(|found| Some(found.last_detachment?.force)));
        of.field("last_detachment_displacement_nm", "how far the root has moved there", |row| row.of(|found| Some(found.last_detachment?.displacement)));
        of.field("events", "events at which tips detach or adhere again, or beams buckle", |row| row.of(|found| Some(found.events)));
        of.field("most_tips_at_once", "changes of tips in the largest event", |row| row.of(|found| Some(found.most_at_once)));
        of.field("work_aJ", "work of the root over all steps, to where the pull-off ended", |row| row.of(|found| Some(found.work)));
        of.field("released_aJ", "energy released in events", |row| row.of(|found| Some(found.released)));
        of.field("imbalance", "work less energy and less what was released, over the largest of the three", |row| row.of(|found| Some(found.imbalance)));
        of.field("end", "as in summary.json of a seta", |row| row.end());
        of.field("solve_s", "wall clock; of the first values with the law of the tips", |row| row.solve_s);
        of.field("points", "equilibria of the pull-off", |row| row.of(|found| Some(found.points)));
        of.field("newton_iterations", "Newton iterations", |row| row.of(|found| Some(found.effort.newton_iterations)));
        of.field("elements", "elements of the tree", |row| row.of(|found| Some(found.effort.elements)));
    }
}

/// Writes sweep.csv of a sweep of setae: one row a value, or a pair of values. Behind `value` the same number stands once more in a column that
/// names its key and unit.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_swept_setae(dir: &Path, keys: SweptKeys, rows: &[SetaRow]) -> Result<PathBuf, ReportError> {
    write_swept(dir, keys, rows.iter())
}

impl<'a> SweepSummary<'a, &'a SetaRow> {
    /// The summary of rows of setae.
    pub fn of_setae(scene: &'a Scene, keys: SweptKeys<'a>, rows: &'a [SetaRow], remarks: &[String]) -> Self {
        Self::of_rows(scene, keys, rows.iter(), remarks)
    }
}

// -- The picture of a sweep of setae: the peak force, the tips that adhere there, and the work, against the varied value; or maps over two --

const QUANTITIES: [Quantity<SetaResult>; 3] = [
    Quantity {
        label: "peak force P (nN)",
        of: |row| row.peak().map(|at| at.force),
        colour: colour::BLUE,
        height: 260.0,
        has_map: true,
    },
    Quantity {
        label: "tips attached at the peak",
        of: |row| row.peak().map(|at| at.attached as f64),
        colour: colour::VERMILLION,
        height: 160.0,
        has_map: false,
    },
    Quantity {
        label: "work of the root W (aJ)",
        of: SetaRow::work,
        colour: colour::GREEN,
        height: 160.0,
        has_map: true,
    },
];

/// Draws `sweep.svg` and `sweep.png` into `dir`: of one key the peak force, the tips that adhere there and the work of the root against its values,
/// of two keys maps of peak force and work, on logarithmic axes where `log` is set. Where a seta pulls along the ground, `locus.svg` and `locus.png`
/// have the force there and off the ground.
///
/// Fails where no value has a peak, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be written
/// ([`ReportError::Write`]).
pub fn draw_swept_setae<'h>(
    dir: &Path,
    keys: SweptKeys,
    rows: &[SetaRow],
    heading: impl Into<Heading<'h>>,
    log: [bool; 2],
) -> Result<Vec<PathBuf>, ReportError> {
    let heading = heading.into();
    let mut files = draw_swept_pulls(dir, keys, rows, (&QUANTITIES, "has a peak force"), heading, log)?;
    files.extend(draw_locus(dir, keys, rows, heading)?);
    Ok(files)
}
