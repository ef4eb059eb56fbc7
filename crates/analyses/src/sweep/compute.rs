//! The values of a sweep computed on all cores, each kept as soon as it is done, and taken up again by the next run after one that was stopped.

use super::cases::{Case, Cases};
use crate::outcome::Refusal;
use crate::session::{Progress, Session};
use peelkit::study;
use peelkit_report::{Part, PartialSweep, Storable, timed};
use peelkit_scene::Scene;
use std::sync::OnceLock;

/// What was found of a case, in so many seconds.
pub struct Found<'c, F> {
    pub case: &'c Case,
    pub found: F,
    pub solve_s: f64,
}

/// What is found of each case, in their order, and how many of it an earlier run has found; where it was asked to stop some are missing.
pub fn compute<'c, F: Storable + Send + Sync>(
    session: &Session,
    (scene, part): (&Scene, Option<Part>),
    cases: &'c Cases,
    of: &(dyn Fn(&Case) -> F + Sync),
) -> Result<(Vec<Found<'c, F>>, usize), Refusal> {
    let partial = session.open(|dir| PartialSweep::<F>::open(dir, scene, cases.keys, part))?;
    let known = |case: &Case| partial.as_ref()?.found(case.value, case.second);
    session.watcher.see(Progress::Begin(cases.all.len()));
    let missing: Vec<&Case> = cases.all.iter().filter(|case| known(case).is_none()).collect();
    let taken = cases.all.len() - missing.len();
    (0..taken).for_each(|_| session.watcher.see(Progress::Known));
    let trouble = OnceLock::new();
    let run = |&case: &&'c Case| {
        let (found, solve_s) = timed(|| of(case));
        let kept = partial.as_ref().map(|partial| partial.keep_found((case.value, case.second), &found, solve_s));
        if let Some(Err(error)) = kept {
            // only the first one is reported
            let _ = trouble.set(error);
        }
        session.watcher.see(Progress::Done);
        Found { case, found, solve_s }
    };
    let computed = study::sweep(&missing, &|| !session.watcher.asked() && trouble.get().is_none(), &run);
    trouble.into_inner().map_or(Ok(()), Err)?;
    let mut computed = computed.into_iter().peekable();
    let found = |case: &'c Case| match known(case) {
        Some((found, solve_s)) => Some(Found { case, found: found.clone(), solve_s }),
        None => computed.next_if(|next| (next.case.value, next.case.second) == (case.value, case.second)),
    };
    Ok((cases.all.iter().filter_map(found).collect(), taken))
}
