//! The law of a tip of a seta, from the spatula of a scene.

use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::session::Session;
use peelkit::model::Hold;
use peelkit::study::coarsening::{Coarsening, CoarseningError, CoarseningOptions, PadEnd, TipTable};
use peelkit::study::{StopCriteria, StopReason, Terms};
use peelkit_report::{self as report, ReportError, TipSummary, timed};
use peelkit_scene::Scene;
use std::io;
use std::path::{Path, PathBuf};

/// The law of a tip, as a table, from the spatula of a scene.
pub struct TipCoarsening<'s> {
    scene: &'s Scene,
    options: CoarseningOptions,
}

impl<'s> TipCoarsening<'s> {
    /// What is asked of the table of a scene where nothing else is said: by how its pad is held.
    pub fn usual(scene: &Scene) -> CoarseningOptions {
        let is_held = scene.model.grip.horizontal == Hold::Fixed;
        CoarseningOptions::of(if is_held { PadEnd::Held } else { PadEnd::Sliding })
    }

    /// Of a scene.
    ///
    /// Fails where the options are out of their range, and where terms of the model were to be left out.
    pub fn of(scene: &'s Scene, options: CoarseningOptions) -> Result<Self, Refusal> {
        options.check().map_err(|why| refused(&why.into()))?;
        if scene.accuracy.terms == Terms::Auto {
            return Err(Refusal::asked(
                "the law of a tip takes the model with all of its terms, and the scene has terms = \"auto\"",
                "Give --set terms=all.",
            ));
        }
        // a search that is stopped at once comes to what of the model is refused, and solves nothing
        let at_once = StopCriteria::default().or_when(|_| Some(StopReason::Interrupted));
        match Coarsening::until(&scene.model, &options, &at_once) {
            Ok(_) | Err(CoarseningError::Stopped { .. }) => Ok(Self { scene, options }),
            Err(why) => Err(refused(&why)),
        }
    }
}

/// Why there is no table of a scene.
fn refused(why: &CoarseningError) -> Refusal {
    match why {
        CoarseningError::Stopped { .. } => Refusal::CutShort(format!("{why}; nothing is written")),
        why => Refusal::scene(why, why.remedy()),
    }
}

/// The law of a tip.
pub struct TipOutcome {
    /// The table
    pub table: TipTable,
    /// That it took, from the first equilibrium on
    pub seconds: f64,
}

impl Analysis for TipCoarsening<'_> {
    type Found = TipOutcome;

    fn run(&self, session: &Session) -> Result<TipOutcome, Refusal> {
        let Self { scene, options } = self;
        let coarsening = Coarsening::until(&scene.model, options, &session.stop(scene));
        let mut coarsening = coarsening.map_err(|why| refused(&why))?;
        let (found, seconds) = timed(|| coarsening.table());
        Ok(TipOutcome { table: found.map_err(|why| refused(&why))?, seconds })
    }
}

impl Outcome for TipOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(TipSummary::new(scene, &self.table, self.seconds), command, TipSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let mut files = vec![TipSummary::new(scene, &self.table, self.seconds).with_command(command).write(dir)?];
        files.extend(report::write_tip_law(dir, &self.table)?);
        files.extend(report::draw_tip_law(&self.table, scene, dir)?);
        Ok(files)
    }

    fn end(&self) -> End {
        if self.table.is_met() {
            return End::Done;
        }
        End::CutShort(format!(
            "the table is not as accurate as asked: its relative error is {:.1e}, and {:.1e} was asked for",
            self.table.relative_error(),
            self.table.options.tolerance
        ))
    }
}
