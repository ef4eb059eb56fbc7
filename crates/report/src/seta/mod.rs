//! The pull-off of a seta: its tables, its summary, its pictures, its animation and its files for ParaView.

mod animation;
mod curve;
mod load_map;
mod motion;
mod names;
mod picture;
mod pose;
mod route;
mod side_view;
mod summary;
mod sweep;
mod tables;
mod tip_events;
mod vtk;

use crate::record::Record;
use crate::reference::Output;

pub use animation::write_seta_animation;
pub use motion::SetaMotion;
pub use names::{seta_end_reason, seta_end_word};
pub use picture::draw_pull_off;
pub use pose::SetaPose;
pub(crate) use summary::RestOfTip;
pub use summary::{SetaFound, SetaSummary, tip_peak};
pub use sweep::{SetaRow, draw_swept_setae, write_swept_setae};
pub use tables::{
    pull_off_columns, write_seta_curve, write_seta_equilibria, write_seta_events, write_seta_rate_events,
    write_tip_curve, write_tips,
};
pub use tip_events::TipEvents;
pub use vtk::{SETA_STATE_FIELDS, SetaStateField, write_seta_states};

/// What is written of setae.
pub(crate) fn outputs() -> Vec<Output> {
    let of_sweep = Output::table("sweep.csv of setae", SetaRow::keys());
    [vec![of_sweep, summary::output(), vtk::output()], tables::outputs()].concat()
}
