//! `peel sweep` of whole peels: each value peeled from rest to its end.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::conclusion::Conclusion;
use super::failed::failed_rows;
use super::kept::{Found, compute};
use super::{files, no_effect};
use crate::command_line::command_line;
use crate::stop::Stop;
use crate::text_summary::{self, WantedUnits};
use peelkit::study::{self, PeelResult};
use peelkit_report::{PartHeader, SweepRow, SweepSummary};
use peelkit_scene::Scene;
use std::path::Path;

/// Peels every value; of a divided sweep those of the part.
pub fn peel_each(
    args: &Sweep,
    scene: &Scene,
    cases: &Cases,
    part: Option<&PartHeader>,
    wanted: WantedUnits,
) -> Result<(), Stop> {
    let keys = cases.keys;
    let command = command_line();
    let computed = compute(args, scene, cases, &peel)?;
    let rows: Vec<SweepRow> = computed.all.iter().map(row).collect();
    let write = |dir: &Path| match part {
        None => files::write_all(dir, scene, &command, cases, &rows),
        Some(header) => files::write_part(dir, scene, &command, cases, &rows, header),
    };
    computed.conclude(
        args,
        Conclusion {
            done: [rows.len(), cases.all.len()],
            write: &write,
            remark: no_effect::seen(keys, &rows),
            json: &|remarks| SweepSummary::new(scene, keys, &rows, remarks).with_command(&command).to_json(),
            text: &|remarks| text_summary::sweep(scene, keys, &rows, remarks, wanted),
            failed: failed_rows(keys, &rows),
        },
    )
}

fn peel(Case { scene, .. }: &Case) -> PeelResult {
    PeelResult::from(&study::peel(&scene.model, &scene.accuracy, &scene.bounds.from_now()))
}

fn row(Found { case, found, solve_s }: &Found<PeelResult>) -> SweepRow {
    let Case { value, second, scene } = case;
    SweepRow { value: *value, second: *second, model: scene.model.clone(), found: found.clone(), solve_s: *solve_s }
}
