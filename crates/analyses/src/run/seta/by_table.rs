//! The pull-off of a seta, once where its tips follow a curve, and again each time the table that they follow has grown.

use super::follow::{ByTable, KeptSeta, follow};
use super::sampler::Sampler;
use crate::outcome::Refusal;
use crate::pulls::seta::{NoTable, PulledSeta, TipLawOf, model};
use peelkit::model::{PullCurve, SetaError};
use peelkit::study::coarsening::{AfterRound, CoarseningError, OutsideTable};
use peelkit::study::{SetaEnd, SetaLoading, SetaOptions, SetaPoint, StopCriteria};
use peelkit_scene::{Scene, SetaTable};
use std::sync::Arc;

/// What is pulled off.
pub struct Pull<'p> {
    pub scene: &'p Scene,
    pub table: &'p SetaTable,
    pub loading: &'p SetaLoading,
    pub options: &'p SetaOptions,
    pub stop: &'p StopCriteria,
    /// How many states are looked at
    pub states: usize,
}

/// The last pull-off, and the law of the tips in it.
pub struct Pulled {
    pub of: PulledSeta,
    pub law: TipLawOf,
    /// The states that were seen
    pub sampler: Sampler,
    /// Tips that are outside of their table, which does not grow any more
    pub outside: Option<OutsideTable>,
}

impl Pull<'_> {
    /// The last pull-off.
    pub fn pulled(
        &self,
        law: TipLawOf,
        tip: &PullCurve,
        kept: &mut KeptSeta,
        see: &mut dyn FnMut(&SetaPoint),
    ) -> Result<Pulled, Refusal> {
        let Self { scene, table, loading, options, stop, states } = *self;
        let refused = |error: SetaError| Refusal::asked(error, "`peel keys seta` lists the keys with their ranges.");
        let fingerprint = law.fingerprint();
        let earlier = kept.by_table(fingerprint);
        let mut growing = match law {
            TipLawOf::Beam => {
                let (model, found, sampler) = self.of_beams(kept, see)?;
                return Ok(Pulled { of: PulledSeta::OfBeams(model, found), law, sampler, outside: None });
            }
            TipLawOf::Curve => {
                let model = model(scene, table, table.law(tip.clone()));
                let sampler = Sampler::new(states);
                let followed = follow((&model, None), (loading, options), stop, sampler, kept, see);
                let (pull_off, sampler) = followed.map_err(refused)?;
                return Ok(Pulled { of: PulledSeta::ByLaw(model, pull_off), law, sampler, outside: None });
            }
            TipLawOf::Table(growing) => {
                growing.behind(earlier).map_err(|why: CoarseningError| Refusal::from(NoTable::from(why)))?
            }
        };
        loop {
            let visited = kept.visited();
            let law = growing.law(table.sideways()).with_visited(visited);
            let model = model(scene, table, Arc::new(law.clone()));
            let by_table = ByTable { fingerprint, rounds: growing.rounds(), law: &law };
            let sampler = Sampler::new(states);
            let followed = follow((&model, Some(&by_table)), (loading, options), stop, sampler, kept, see);
            let (mut pull_off, sampler) = followed.map_err(refused)?;
            let outside = match growing.after(&pull_off, law.visited()) {
                AfterRound::Again => continue,
                AfterRound::Done => None,
                AfterRound::Outside(outside) => Some(outside),
                // the same command finds the whole pull-off, and lets the table grow
                AfterRound::Stopped(bound) => {
                    pull_off.end = SetaEnd::Bound(bound);
                    None
                }
            };
            let of = PulledSeta::ByLaw(model, pull_off);
            return Ok(Pulled { of, law: TipLawOf::Table(Box::new(growing)), sampler, outside });
        }
    }
}
