//! The common part of pulls at a rate: the pull of a beam, or of a seta, as far as it goes.

use crate::pulls::seta::Setae;
use peelkit::model::SetaModel;
use peelkit::study::{
    InTimeFailureKind, PullInTime, SetaInTime, SetaInTimeFailureKind, StopCriteria, pull_in_time_with,
    pull_seta_in_time_with,
};
use peelkit_report::PulledAtRate;
use peelkit_scene::{Scene, SetaTable, TimeTable};

/// A pull, and why it stopped short, if it did.
pub type AsFar<P> = (P, Option<String>);

/// The pull of a scene at the rate of a table, of its beam or of its seta, whose tips have the law that such setae have in common; or why there is none.
pub fn pull_at_rate(
    scene: &Scene,
    (table, seta): (&TimeTable, Option<&SetaTable>),
    setae: &Setae,
    stop: &StopCriteria,
) -> Result<AsFar<PulledAtRate>, String> {
    match seta {
        None => {
            let (pulled, failed) = pull_beam(scene, table, stop).map_err(|why| why.to_string())?;
            Ok((PulledAtRate::from(&pulled), failed))
        }
        Some(seta) => {
            let model = setae.model(scene, seta)?;
            let pulled = pull_seta(scene, (table, seta), &model, stop);
            let (pulled, failed) = pulled.map_err(|why| why.to_string())?;
            Ok((PulledAtRate::from(&pulled), failed))
        }
    }
}

/// The pull of the beam of a scene, or why there is none.
pub fn pull_beam(
    scene: &Scene,
    table: &TimeTable,
    stop: &StopCriteria,
) -> Result<AsFar<PullInTime>, InTimeFailureKind> {
    let (pull, accuracy) = (scene.pull_rate(table), scene.time_accuracy(table));
    match pull_in_time_with(&scene.model, &table.moving_material(), &pull, &accuracy, stop) {
        Ok(pulled) => Ok((pulled, None)),
        Err(failure) => match failure.reached {
            Some(reached) => Ok((*reached, Some(failure.why.to_string()))),
            None => Err(failure.why),
        },
    }
}

/// The pull of the seta of a scene, or why there is none.
pub fn pull_seta(
    scene: &Scene,
    (table, seta): (&TimeTable, &SetaTable),
    model: &SetaModel,
    stop: &StopCriteria,
) -> Result<AsFar<SetaInTime>, SetaInTimeFailureKind> {
    let (pull, accuracy) = (scene.seta_pull_rate(table, seta), scene.seta_time_accuracy(table));
    match pull_seta_in_time_with(model, &table.moving_material(), &pull, &accuracy, stop) {
        Ok(pulled) => Ok((pulled, None)),
        Err(failure) => match failure.reached {
            Some(reached) => Ok((*reached, Some(failure.why.to_string()))),
            None => Err(failure.why),
        },
    }
}
