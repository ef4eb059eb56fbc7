//! One number of a scene varied, or two: each value peeled from rest to its end, pulled off, or pulled at its rate, or one point of the peel followed.

mod cases;
mod compute;
mod failed;
mod follow;
mod no_effect;
mod outcome;

pub use cases::{Axis, Case, Cases};
pub use failed::place;
pub use outcome::{Rows, SweepOutcome};

use crate::outcome::{Analysis, Refusal};
use crate::pulls::numbers::pulled_array;
use crate::pulls::rate::pull_at_rate;
use crate::pulls::seta::Setae;
use crate::pulls::solid::peeled;
use crate::session::Session;
use compute::{Found, compute};
use peelkit::study::{self, PeelResult, PointKind, SetaResult};
use peelkit_report::{
    ArrayResult, Journal, JournalKind, PartHeader, PullRow, RateResult, Record, SolidResult, SweepLine, SweepRow, timed,
};
use peelkit_scene::{Described, Scene};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::io;

/// A scene in which keys are varied.
pub struct Sweep<'s> {
    scene: &'s Scene,
    cases: Cases,
    /// The point that is followed, where no whole paths are computed
    follow: Option<PointKind>,
    /// What this is a part of, where the sweep is divided
    part: Option<PartHeader>,
}

impl<'s> Sweep<'s> {
    /// Refuses what has no meaning for what a scene describes: to follow a point, and to divide the sweep.
    ///
    /// Fails with the reason.
    pub fn allows(scene: &Scene, follows: bool, divided: bool) -> Result<(), Refusal> {
        let [followed, whole, divides] = match scene.describes() {
            Described::Array(_) => [
                "--follow and --peak-only have no meaning for an array of setae: they follow a limit point of a beam",
                "Omit them: each value is pulled as a whole.",
                "--part divides sweeps of beams, and this is one of arrays of setae",
            ],
            Described::Rate(..) => [
                "--follow and --peak-only have no meaning for a pull at a rate: they follow a limit point of equilibria",
                "Omit them: each value is pulled as a whole.",
                "--part divides sweeps of equilibria, and this is one of pulls at a rate",
            ],
            Described::Solid(_) => [
                "--follow and --peak-only have no meaning for a solid: they follow a limit point of a beam",
                "Omit them: each value is peeled as a whole.",
                "--part divides sweeps of beams, and this is one of solids",
            ],
            Described::Seta(_) => [
                "--follow and --peak-only have no meaning for a seta: they follow a limit point of one beam",
                "Omit them: each value is pulled off as a whole.",
                "--part divides sweeps of single beams, and this is one of setae",
            ],
            Described::Peel => return Ok(()),
        };
        if follows {
            return Err(Refusal::asked(followed, whole));
        }
        if divided {
            return Err(Refusal::asked(
                divides,
                "Omit it, and give each machine values of its own with --from and --to, or --values.",
            ));
        }
        Ok(())
    }

    /// Of these cases of a scene, as whole paths and pulls, or one point of the peel followed over them; of a divided sweep one part.
    ///
    /// Fails where that has no meaning for the scene, and where it would change nothing.
    pub fn of(
        scene: &'s Scene,
        cases: Cases,
        follow: Option<PointKind>,
        part: Option<PartHeader>,
    ) -> Result<Self, Refusal> {
        Self::allows(scene, follow.is_some(), part.is_some())?;
        no_effect::refuse(scene, &cases)?;
        if let Some(why) = follow.and_then(|_| follow::not_followed(&cases)) {
            return Err(Refusal::asked(
                format!("--follow computes a limit point {why}"),
                "Omit --follow and --peak-only: the sweep then computes whole paths.",
            ));
        }
        Ok(Self { scene, cases, follow, part })
    }

    /// What is found of every case: the rows, and what an earlier run has found of them.
    fn rows<F: Serialize + DeserializeOwned + Send, R>(
        &self,
        session: &Session,
        journal: &Journal,
        of: &(dyn Fn(&Case) -> F + Sync),
        row: impl Fn(Found<F>) -> R,
    ) -> Result<(Vec<R>, usize), Refusal> {
        let (found, taken) = compute(session, journal, &self.cases, of)?;
        Ok((found.into_iter().map(row).collect(), taken))
    }
}

impl Analysis for Sweep<'_> {
    type Found = SweepOutcome;

    fn journal(&self) -> Option<JournalKind> {
        self.follow.is_none().then_some(JournalKind::SWEEP)
    }

    fn run(&self, session: &Session) -> Result<SweepOutcome, Refusal> {
        let Self { scene, cases, .. } = self;
        let setae = Setae::like(scene);
        let (keys, part) = (cases.keys.names(), self.part.as_ref().map(|header| header.part.to_string()));
        let settings = [Some(("key", keys.as_str())), part.as_deref().map(|part| ("part", part))];
        let settings: Vec<_> = settings.into_iter().flatten().collect();
        let journal = match self.journal() {
            Some(kind) => session.open(kind, scene, &settings)?,
            None => Journal::nowhere(),
        };
        let (rows, taken) = if let Some(kind) = self.follow {
            let (sweep, seconds) = follow::follow(kind, cases, session);
            (Rows::Followed(sweep, seconds), 0)
        } else {
            match scene.describes() {
                Described::Rate(..) => {
                    let of = |case: &Case| pull(&case.scene, &setae, session);
                    let (rows, taken) = self.rows(session, &journal, &of, pull_row)?;
                    (Rows::Rates(rows), taken)
                }
                Described::Solid(_) => {
                    let of = |case: &Case| solid(&case.scene, session);
                    let (rows, taken) = self.rows(session, &journal, &of, pull_row)?;
                    (Rows::Solids(rows), taken)
                }
                Described::Array(_) => {
                    let of = |case: &Case| of_array(&case.scene, session);
                    let (rows, taken) = self.rows(session, &journal, &of, pull_row)?;
                    (Rows::Arrays(rows), taken)
                }
                Described::Seta(_) => {
                    let of = |case: &Case| pull_off(&case.scene, &setae, session);
                    let (rows, taken) = self.rows(session, &journal, &of, pull_row)?;
                    (Rows::Setae(rows), taken)
                }
                Described::Peel => {
                    let of = |case: &Case| peel(&case.scene, session);
                    let (rows, taken) = self.rows(session, &journal, &of, peel_row)?;
                    (Rows::Peels(rows), taken)
                }
            }
        };
        let taken = (taken > 0)
            .then(|| format!("{taken} of {} values taken from an earlier, interrupted run", cases.all.len()));
        Ok(SweepOutcome {
            journal: Some(journal),
            part: self.part.clone(),
            ..SweepOutcome::of(cases, rows, taken.into_iter().collect())
        })
    }
}

/// Rows of sweep.csv of scenes that differ in some keys, one by one: for those who divide a sweep by themselves.
pub struct SceneRows {
    setae: Setae,
}

impl SceneRows {
    /// Of scenes like this one: the law of the tips of their setae is computed once where its keys do not vary.
    pub fn like(scene: &Scene) -> Self {
        Self { setae: Setae::like(scene) }
    }

    /// The row of a scene as one JSON object: of its peel, as a beam or as a solid, of the pull-off of its seta, of the pull of its array, or of its pull at a rate. Its value is
    /// 0, because nothing says what is varied. Called from any thread.
    ///
    /// Fails where a number is not finite.
    pub fn row(&self, scene: &Scene, session: &Session) -> io::Result<String> {
        match scene.describes() {
            Described::Rate(..) => {
                let (found, solve_s) = timed(|| pull(scene, &self.setae, session));
                PullRow { value: 0.0, second: None, found, solve_s }.to_json()
            }
            Described::Solid(_) => {
                let (found, solve_s) = timed(|| solid(scene, session));
                PullRow { value: 0.0, second: None, found, solve_s }.to_json()
            }
            Described::Array(_) => {
                let (found, solve_s) = timed(|| of_array(scene, session));
                PullRow { value: 0.0, second: None, found, solve_s }.to_json()
            }
            Described::Seta(_) => {
                let (found, solve_s) = timed(|| pull_off(scene, &self.setae, session));
                PullRow { value: 0.0, second: None, found, solve_s }.to_json()
            }
            Described::Peel => {
                let (found, solve_s) = timed(|| peel(scene, session));
                SweepLine::new(0.0, None, &found, solve_s).to_json()
            }
        }
    }
}

/// Of a scene that is of another kind than those beside it.
const OTHER_KIND: &str = "the value makes another kind of scene";

fn peel(scene: &Scene, session: &Session) -> PeelResult {
    PeelResult::from(&study::peel(&scene.model, &scene.accuracy, &session.stop_of_one(scene)))
}

fn peel_row(Found { case, found, solve_s }: Found<PeelResult>) -> SweepRow {
    let Case { value, second, scene } = case;
    SweepRow { value: *value, second: *second, model: scene.model.clone(), found, solve_s }
}

/// The pull of a scene at its rate, or why there is none.
fn pull(scene: &Scene, setae: &Setae, session: &Session) -> Result<RateResult, String> {
    let Described::Rate(table, seta) = scene.describes() else { return Err(OTHER_KIND.to_owned()) };
    let (pulled, failed) = pull_at_rate(scene, (table, seta), setae, &session.stop_of_one(scene))?;
    Ok(RateResult::new(&pulled, failed))
}

/// The pull-off of the seta of a scene, or why there is none.
fn pull_off(scene: &Scene, setae: &Setae, session: &Session) -> Result<SetaResult, String> {
    let Described::Seta(table) = scene.describes() else { return Err(OTHER_KIND.to_owned()) };
    setae.pull_off(scene, table, &session.stop_of_one(scene))
}

/// The peel of the solid of a scene, or why there is none.
fn solid(scene: &Scene, session: &Session) -> Result<SolidResult, String> {
    let Described::Solid(table) = scene.describes() else { return Err(OTHER_KIND.to_owned()) };
    let peel = peeled(scene, table, session.stop_of_one(scene));
    peel.map(|peel| SolidResult::from(&peel)).map_err(|error| error.to_string())
}

/// The pull of the array of a scene, or why there is none.
fn of_array(scene: &Scene, session: &Session) -> Result<ArrayResult, String> {
    let Described::Array(table) = scene.describes() else { return Err(OTHER_KIND.to_owned()) };
    let pull = pulled_array(scene, table, &session.stop_of_one(scene))?;
    Ok(ArrayResult::new(table, &pull))
}

fn pull_row<F>(Found { case, found, solve_s }: Found<Result<F, String>>) -> PullRow<F> {
    PullRow { value: case.value, second: case.second, found, solve_s }
}
