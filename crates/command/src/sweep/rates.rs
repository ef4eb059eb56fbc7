//! `peel sweep` of a scene with a table `[time]`: each value pulled at its rate.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::pulls::{self, Pulled, Swept};
use crate::rate::{pull_beam, pull_seta};
use crate::seta::Setae;
use crate::stop::Stop;
use crate::text_summary::{self, WantedUnits};
use peelkit_report::{self as report, PulledAtRate, RateResult, ReportError, SweepSummary};
use peelkit_scene::Scene;
use std::io;
use std::path::{Path, PathBuf};

/// What of `peel sweep` has no meaning for a pull at a rate.
pub fn refuse(args: &Sweep) -> Result<(), Stop> {
    pulls::refuse(
        args,
        [
            "--follow and --peak-only have no meaning for a pull at a rate: they follow a limit point of equilibria",
            "Omit them: each value is pulled as a whole.",
            "--part divides sweeps of equilibria, and this is one of pulls at a rate",
        ],
    )
}

/// Pulls at the rate of every value.
pub fn pull_each(args: &Sweep, scene: &Scene, cases: &Cases, wanted: WantedUnits) -> Result<(), Stop> {
    let setae = Setae::like(scene);
    pulls::pull_each(args, scene, cases, wanted, &|case: &Case| pull(&case.scene, &setae))
}

/// The pull of a scene, or why there is none.
fn pull(scene: &Scene, setae: &Setae) -> Result<RateResult, String> {
    let Some(table) = &scene.time else { return Err("the scene has no [time]".to_owned()) };
    let stop = scene.bounds.from_now();
    let (pulled, failed) = match &scene.seta {
        None => {
            let (pulled, failed) = pull_beam(scene, table, &stop).map_err(|why| why.to_string())?;
            (PulledAtRate::from(&pulled), failed)
        }
        Some(seta) => {
            let model = setae.model(scene, seta)?;
            let pulled = pull_seta(scene, (table, seta), &model, &stop);
            let (pulled, failed) = pulled.map_err(|why| why.to_string())?;
            (PulledAtRate::from(&pulled), failed)
        }
    };
    Ok(RateResult::new(&pulled, failed))
}

impl Pulled for RateResult {
    fn failure(&self) -> Option<String> {
        self.failed.clone()
    }

    fn is_drawn(&self) -> bool {
        self.failed.is_none()
    }

    fn write(swept: &Swept<Self>, dir: &Path) -> Result<PathBuf, ReportError> {
        report::write_swept_rates(dir, swept.keys, swept.rows)
    }

    fn draw(swept: &Swept<Self>, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
        report::draw_swept_rates(dir, swept.keys, swept.rows, &swept.scene.title, swept.log)
    }

    fn json(swept: &Swept<Self>, remarks: &[String], command: &str) -> io::Result<String> {
        SweepSummary::of_rates(swept.scene, swept.keys, swept.rows, remarks).with_command(command).to_json()
    }

    fn text(swept: &Swept<Self>, remarks: &[String], wanted: WantedUnits) -> String {
        text_summary::swept_rates(swept.scene, swept.keys, swept.rows, remarks, wanted)
    }
}
