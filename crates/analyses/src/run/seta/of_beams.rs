//! The pull-off of a seta whose spatulae are beams. What was reached behind a loss of stability is kept where it takes long.

use super::by_table::Pull;
use super::follow::{KeptSeta, is_unfinished};
use super::sampler::Sampler;
use crate::outcome::Refusal;
use crate::pulls::seta::{of_beams, path_options};
use peelkit::model::SetaOfBeams;
use peelkit::study::{self, BeamsProgress, BeamsPullOff, SetaPoint, SetaState};
use peelkit_report::JournalKind;
use std::time::Instant;

impl Pull<'_> {
    /// The pull-off, what was pulled off, and the states that were seen.
    pub fn of_beams(
        &self,
        kept: &mut KeptSeta,
        see: &mut dyn FnMut(&SetaPoint),
    ) -> Result<(SetaOfBeams, BeamsPullOff, Sampler), Refusal> {
        let model = of_beams(self.scene, self.table).map_err(|why| {
            Refusal::scene(why, "Give another law of adhesion or another body, or seta.tip_law = \"table\".")
        })?;
        let (reached, mut sampler) = match kept.take_of_beams() {
            Some((progress, sampler)) => (Some(progress), sampler),
            None => (None, Sampler::new(self.states)),
        };
        let (mut last, mut newest) = (Instant::now(), None);
        let mut look = |state: &SetaState, progress: Option<&BeamsProgress>| {
            see(&state.point);
            sampler.see(state);
            let Some(progress) = progress else { return };
            if last.elapsed() >= JournalKind::SETA.interval {
                kept.keep_of_beams(progress, &sampler);
                (last, newest) = (Instant::now(), None);
            } else {
                newest = Some((progress.clone(), sampler.clone()));
            }
        };
        let options = path_options(self.scene);
        let found = study::pull_off_of_beams(&model, self.loading, &options, self.stop, reached, &mut look);
        let found =
            found.map_err(|error| Refusal::asked(error, "`peel keys seta` lists the keys with their ranges."))?;
        if let Some((progress, sampler)) = newest.filter(|_| is_unfinished(&found.result)) {
            kept.keep_of_beams(&progress, &sampler);
        }
        Ok((model, found, sampler))
    }
}
