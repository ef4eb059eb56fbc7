//! The pull-off of a seta: its tables, its summary, its pictures, its animation and its files for ParaView.

pub(crate) mod animation;
mod curve;
mod load_map;
mod locus;
pub(crate) mod motion;
pub(crate) mod names;
pub(crate) mod picture;
mod side_view;
pub(crate) mod summary;
pub(crate) mod sweep;
pub(crate) mod tables;
pub(crate) mod vtk;

use crate::writing::record::Record;
use crate::writing::reference::Output;

use sweep::SetaRow;

/// What is written of setae.
pub(crate) fn outputs() -> Vec<Output> {
    let of_sweep = Output::table("sweep.csv of setae", SetaRow::keys());
    [vec![of_sweep, summary::output(), vtk::output()], tables::outputs()].concat()
}
