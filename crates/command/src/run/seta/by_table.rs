//! The pull-off of a seta, once where its tips follow a curve, and again each time the table that they follow has grown.

use super::kept::{ByTable, Followed, KeptSeta, follow};
use super::sampler::Sampler;
use crate::seta::{TipLawOf, model, outside};
use crate::stop::Stop;
use peelkit::model::{PullCurve, SetaError, SetaModel};
use peelkit::study::coarsening::AfterRound;
use peelkit::study::{SetaLoading, SetaOptions, SetaPoint, StopCriteria};
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
    pub model: SetaModel,
    pub law: TipLawOf,
    pub followed: Followed,
    /// That tips are outside of their table
    pub outside: Option<String>,
}

impl Pull<'_> {
    /// The last pull-off.
    pub fn pulled(
        &self,
        law: TipLawOf,
        tip: &PullCurve,
        mut kept: Option<&mut KeptSeta>,
        see: &mut dyn FnMut(&SetaPoint),
    ) -> Result<Pulled, Stop> {
        let Self { scene, table, loading, options, stop, states } = *self;
        let refused = |error: SetaError| Stop::bad_input(error, "`peel keys seta` lists the keys with their ranges.");
        let fingerprint = law.fingerprint();
        let earlier = kept.as_mut().map(|kept| kept.by_table(fingerprint)).unwrap_or_default();
        let mut growing = match law {
            TipLawOf::Curve => {
                let model = model(scene, table, table.law(tip.clone()));
                let sampler = Sampler::new(states);
                let followed = follow((&model, None), (loading, options), stop, sampler, kept, see).map_err(refused)?;
                return Ok(Pulled { model, law: TipLawOf::Curve, followed, outside: None });
            }
            TipLawOf::Table(growing) => growing.behind(earlier).map_err(Stop::cut_short)?,
        };
        loop {
            let visited = kept.as_ref().map(|kept| kept.visited()).unwrap_or_default();
            let law = growing.law(table.sideways()).with_visited(visited);
            let model = model(scene, table, Arc::new(law.clone()));
            let by_table = ByTable { fingerprint, rounds: growing.rounds(), law: &law };
            let (sampler, kept) = (Sampler::new(states), kept.as_deref_mut());
            let followed = follow((&model, Some(&by_table)), (loading, options), stop, sampler, kept, see);
            let followed = followed.map_err(refused)?;
            let outside = match growing.after(&followed.pull_off, law.visited()) {
                AfterRound::Again => continue,
                AfterRound::Done => None,
                after => Some(outside(&after, &growing)),
            };
            return Ok(Pulled { model, law: TipLawOf::Table(Box::new(growing)), followed, outside });
        }
    }
}
