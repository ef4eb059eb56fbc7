//! The values of a sweep computed on all cores, each kept as soon as it is done, and taken up again by the next run after one that was stopped.

use super::cases::{Case, Cases};
use crate::outcome::Refusal;
use crate::session::{Progress, Session};
use peelkit::study;
use peelkit_report::{Journal, timed};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// What was found of a case, in so many seconds.
pub struct Found<'c, F> {
    pub case: &'c Case,
    pub found: F,
    pub solve_s: f64,
}

/// What is found of each case, in their order, and how many of it an earlier run has found; where it was asked to stop some are missing.
pub fn compute<'c, F: Serialize + DeserializeOwned + Send>(
    session: &Session,
    journal: &Journal,
    cases: &'c Cases,
    of: &(dyn Fn(&Case) -> F + Sync),
) -> Result<(Vec<Found<'c, F>>, usize), Refusal> {
    session.watcher.see(Progress::Begin(cases.all.len()));
    let known = |case: &Case| journal.known::<(F, f64)>(&(case.value, case.second));
    let mut known: Vec<_> = cases.all.iter().map(known).collect();
    let missing = cases.all.iter().zip(&known).filter(|(_, known)| known.is_none());
    let missing: Vec<&Case> = missing.map(|(case, _)| case).collect();
    let taken = cases.all.len() - missing.len();
    (0..taken).for_each(|_| session.watcher.see(Progress::Known));
    let run = |&case: &&'c Case| {
        let (found, solve_s) = timed(|| of(case));
        journal.keep(&(case.value, case.second), &(&found, solve_s));
        session.watcher.see(Progress::Done);
        Found { case, found, solve_s }
    };
    let computed = study::sweep(&missing, &|| !session.watcher.asked() && journal.works(), &run);
    journal.check()?;
    let mut computed = computed.into_iter().peekable();
    let found = |(case, known): (&'c Case, &mut Option<(F, f64)>)| match known.take() {
        Some((found, solve_s)) => Some(Found { case, found, solve_s }),
        None => computed.next_if(|next| (next.case.value, next.case.second) == (case.value, case.second)),
    };
    Ok((cases.all.iter().zip(&mut known).filter_map(found).collect(), taken))
}
