//! The table of the events of a pull-off, or of a pull at a rate: events.csv. Units stand in the names of the columns.

use crate::error::ReportError;
use crate::number::{Finite, S_PER_NS};
use crate::tables::write_table;
use peelkit::model::Seta;
use peelkit::study::{EventCause, SetaEvent, SetaInTime, SetaInTimeEvent, SetaPullOff, TipChange, TipLoss};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// An event of a pull-off.
#[derive(Clone, Copy, Default, Serialize)]
struct OfPullOff {
    event: usize,
    step: usize,
    displacement_nm: Finite,
}

/// An event of a pull at a rate.
#[derive(Clone, Copy, Default, Serialize)]
struct AtRate {
    event: usize,
    time_s: Finite,
    displacement_nm: Finite,
    loss: &'static str,
}

/// What changes in it.
#[derive(Clone, Copy, Default, Serialize)]
struct Line {
    tip: Option<usize>,
    tip_x_nm: Option<Finite>,
    tip_z_nm: Option<Finite>,
    change: &'static str,
    #[serde(rename = "tip_load_nN")]
    load: Option<Finite>,
    #[serde(rename = "force_before_nN")]
    before: Finite,
    #[serde(rename = "force_after_nN")]
    after: Finite,
    tips_attached: usize,
    #[serde(rename = "released_aJ")]
    released: Finite,
}

impl Line {
    /// Of a tip of an event.
    fn of_tip(self, seta: &Seta, change: &TipChange) -> Self {
        let [x, _, z] = seta.joint_place(seta.tip_joint(change.tip));
        Self {
            tip: Some(change.tip),
            tip_x_nm: Some(Finite(x)),
            tip_z_nm: Some(Finite(z)),
            change: if change.to.adheres() { "adheres" } else { "detaches" },
            load: Some(Finite(0.0 - change.load[1])),
            ..self
        }
    }
}

/// Writes events.csv: one row a tip that detaches or adheres again, in order; before them one without a tip where an event begins with beams that
/// buckle.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_seta_events(dir: &Path, pull_off: &SetaPullOff, seta: &Seta) -> Result<PathBuf, ReportError> {
    let lines = |(number, event): (usize, &SetaEvent)| {
        let SetaEvent { before, after, cause, released, .. } = *event;
        let place =
            OfPullOff { event: number + 1, step: before.step + 1, displacement_nm: Finite(before.displacement) };
        let own = Line {
            change: "buckles",
            before: Finite(before.force_along),
            after: Finite(after.force_along),
            tips_attached: after.attached,
            released: Finite(released),
            ..Line::default()
        };
        let buckling = (cause == EventCause::Buckling).then_some(own);
        let of_tips = event.tips.iter().map(|change| own.of_tip(seta, change));
        buckling.into_iter().chain(of_tips).map(|line| (place, line)).collect::<Vec<_>>()
    };
    write_table(dir, "events.csv", pull_off.events.iter().enumerate().flat_map(lines))
}

/// Writes events.csv of a pull at a rate: one row a tip that leaves the branch of its law, in order.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_seta_rate_events(dir: &Path, pulled: &SetaInTime, seta: &Seta) -> Result<PathBuf, ReportError> {
    let lines = |(number, event): (usize, &SetaInTimeEvent)| {
        let SetaInTimeEvent { before, after, loss, released, .. } = *event;
        let place = AtRate {
            event: number + 1,
            time_s: Finite(S_PER_NS * before.time),
            displacement_nm: Finite(before.displacement),
            loss: match loss {
                TipLoss::EndOfBranch => "end-of-branch",
                TipLoss::Unstable => "unstable",
            },
        };
        let own = Line {
            before: Finite(before.force),
            after: Finite(after.force),
            tips_attached: after.attached,
            released: Finite(released),
            ..Line::default()
        };
        event.tips.iter().map(|change| (place, own.of_tip(seta, change))).collect::<Vec<_>>()
    };
    write_table(dir, "events.csv", pulled.events.iter().enumerate().flat_map(lines))
}
