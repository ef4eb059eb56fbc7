//! The law of a whole seta, from the seta of a scene: pulls of its root in several directions, each until its last tip lets go.

use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::seta::{Setae, options};
use crate::session::{Progress, Session};
use peelkit::solve::SolveError;
use peelkit::study::coarsening::{RootPath, SetaLaw, SetaLawError, SetaLawOptions};
use peelkit::study::{SetaFailure, SetaLoading, StopCriteria};
use peelkit_report::{self as report, ReportError, SetaLawFound, SetaLawSummary, timed};
use peelkit_scene::{Scene, SetaTable, SetaTipLaw};
use rayon::prelude::*;
use std::io;
use std::path::{Path, PathBuf};

/// Directions of the pulls, degrees from the ground.
pub(crate) const DIRECTIONS: [f64; 7] = [15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0];
/// Which the law may have.
const DEGREES: [usize; 3] = [2, 3, 4];
/// No tip holds on so far, nm.
const FAR: f64 = 60_000.0;

/// The law of a seta, as few potentials, from the seta of a scene.
pub struct SetaLawCoarsening<'s> {
    scene: &'s Scene,
    table: &'s SetaTable,
    asked: SetaLawOptions,
}

impl<'s> SetaLawCoarsening<'s> {
    /// Of the seta of a scene.
    ///
    /// Fails where the scene has no seta, its tips follow a table, or it is pulled at a rate, and where there is no such law.
    pub fn of(scene: &'s Scene, asked: SetaLawOptions) -> Result<Self, Refusal> {
        let table = scene.seta.as_ref().ok_or_else(|| Refusal::scene("it has no table [seta]", "Add one."))?;
        if scene.time.is_some() {
            return Err(Refusal::scene(
                "the law of a seta is one of equilibria, and the scene has [time]",
                "Remove [time].",
            ));
        }
        let instead = match table.tip_law {
            SetaTipLaw::Curve => None,
            SetaTipLaw::Table => Some("they follow a table"),
            SetaTipLaw::Beam => Some("their spatulae are beams"),
        };
        if let Some(instead) = instead {
            return Err(Refusal::scene(
                format!("the law of a seta is made of tips that follow the curve of their pull, and here {instead}"),
                "Give seta.tip_law = \"curve\".",
            ));
        }
        asked.check().map_err(|why| {
            Refusal::asked(
                why,
                "Give --degree 2, 3 or 4 (a band takes 2), --sheets 1 to 64 and --tolerance above zero.",
            )
        })?;
        Ok(Self { scene, table, asked })
    }

    fn path(&self, setae: &Setae, angle: f64, stop: &StopCriteria) -> Result<RootPath, Refusal> {
        let model = setae.model(self.scene, self.table).map_err(|why| Refusal::scene(why, "Change the tips."))?;
        let loading = SetaLoading::pull([angle.cos(), angle.sin(), 0.0], FAR);
        RootPath::resolved(&model, &loading, &options(self.scene), stop).map_err(|why| match why {
            SetaLawError::Stopped(_) => Refusal::CutShort(format!("{why}; nothing is written")),
            SetaLawError::Failed(failure) if is_stopped(&failure) => Refusal::CutShort(
                "a pull of the root is stopped by its bounds before the last tip lets go: allow more; nothing is written"
                    .to_owned(),
            ),
            why => {
                let degrees = angle.to_degrees();
                Refusal::scene(
                    format!("pulled at {degrees:.0} deg to the ground, {why}"),
                    "Change the seta as it says.",
                )
            }
        })
    }
}

/// Whether what a path failed of is that it was stopped.
fn is_stopped(failure: &SetaFailure) -> bool {
    use SetaFailure::{Lost, NoStart, Restless};
    let (NoStart { cause } | Lost { cause, .. } | Restless { cause, .. }) = failure else { return false };
    matches!(cause, SolveError::Stopped)
}

/// The law of a seta.
pub struct SetaLawOutcome {
    /// The law, its errors and what it is made of
    pub found: SetaLawFound,
}

impl Analysis for SetaLawCoarsening<'_> {
    type Found = SetaLawOutcome;

    fn run(&self, session: &Session) -> Result<SetaLawOutcome, Refusal> {
        session.stage("pulls of the root of the seta");
        session.watcher.see(Progress::Begin(DIRECTIONS.len()));
        let (setae, stop) = (Setae::like(self.scene), session.stop(self.scene));
        setae.prepare(self.scene, &stop);
        let (paths, seconds) = timed(|| {
            let angles = DIRECTIONS.par_iter().map(|degrees| degrees.to_radians());
            let path = |angle| {
                let path = self.path(&setae, angle, &stop)?;
                session.watcher.see(Progress::Done);
                Ok((angle, path))
            };
            angles.map(path).collect::<Result<Vec<_>, Refusal>>()
        });
        let paths = paths?;
        let alone: Vec<RootPath> = paths.iter().map(|(_, path)| path.clone()).collect();
        let law = SetaLaw::fitted(&alone, &self.asked)
            .map_err(|why| Refusal::scene(why, "Give another --degree to `peel coarsen`."))?;
        let by_degree = DEGREES.map(|degree| {
            let other = SetaLawOptions { degree, ..self.asked };
            if other == self.asked {
                Some(law.errors)
            } else {
                SetaLaw::fitted(&alone, &other).ok().map(|law| law.errors)
            }
        });
        Ok(SetaLawOutcome { found: SetaLawFound { law, asked: self.asked, by_degree, paths, seconds } })
    }
}

impl Outcome for SetaLawOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(SetaLawSummary::new(scene, &self.found), command, SetaLawSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let mut files = vec![SetaLawSummary::new(scene, &self.found).with_command(command).write(dir)?];
        files.extend(report::write_seta_law(dir, scene, &self.found)?);
        files.extend(report::draw_seta_law(&self.found, scene, dir)?);
        Ok(files)
    }

    fn end(&self) -> End {
        if self.found.is_within() {
            return End::Done;
        }
        let SetaLawFound { law, asked, .. } = &self.found;
        End::CutShort(format!(
            "the law of the seta is not as accurate as asked: its peaks are within {:.1e} and its works within {:.1e}, and {:.1e} was asked for",
            law.errors.peak, law.errors.work, asked.tolerance
        ))
    }
}
