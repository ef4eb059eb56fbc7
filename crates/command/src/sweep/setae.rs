//! `peel sweep` of a scene with a seta: each value pulled off.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::pulls::{self, Pulled, Swept};
use crate::seta::Setae;
use crate::stop::Stop;
use crate::text_summary::{self, WantedUnits};
use peelkit::study::SetaResult;
use peelkit_report::{self as report, ReportError, SweepSummary, seta_end_reason};
use peelkit_scene::Scene;
use std::io;
use std::path::{Path, PathBuf};

/// What of `peel sweep` has no meaning for a seta.
pub fn refuse(args: &Sweep) -> Result<(), Stop> {
    pulls::refuse(
        args,
        [
            "--follow and --peak-only have no meaning for a seta: they follow a limit point of one beam",
            "Omit them: each value is pulled off as a whole.",
            "--part divides sweeps of single beams, and this is one of setae",
        ],
    )
}

/// Pulls the seta of every value off.
pub fn pull_off_each(args: &Sweep, scene: &Scene, cases: &Cases, wanted: WantedUnits) -> Result<(), Stop> {
    let setae = Setae::like(scene);
    pulls::pull_each(args, scene, cases, wanted, &|case: &Case| {
        setae.pull_off(&case.scene, &case.scene.bounds.from_now())
    })
}

impl Pulled for SetaResult {
    fn failure(&self) -> Option<String> {
        if self.end.is_failure() { seta_end_reason(&self.end) } else { None }
    }

    fn is_drawn(&self) -> bool {
        self.peak.is_some()
    }

    fn write(swept: &Swept<Self>, dir: &Path) -> Result<PathBuf, ReportError> {
        report::write_swept_setae(dir, swept.keys, swept.rows)
    }

    fn draw(swept: &Swept<Self>, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
        report::draw_swept_setae(dir, swept.keys, swept.rows, &swept.scene.title, swept.log)
    }

    fn json(swept: &Swept<Self>, remarks: &[String], command: &str) -> io::Result<String> {
        SweepSummary::of_setae(swept.scene, swept.keys, swept.rows, remarks).with_command(command).to_json()
    }

    fn text(swept: &Swept<Self>, remarks: &[String], wanted: WantedUnits) -> String {
        text_summary::swept_setae(swept.scene, swept.keys, swept.rows, remarks, wanted)
    }
}
