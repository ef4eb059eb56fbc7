//! The largest force of a pull-off of a seta of beams on a finer mesh: from the equilibrium before it, read off on half as many elements again, the root
//! is moved on to where the force is largest there.

use super::progress::{BeamsProgress, BeamsPullOff, BeforePeak, NUDGE, Run};
use crate::model::seta::check::SetaError;
use crate::model::seta::parameters::SetaMesh;
use crate::model::seta::spatulae::SetaOfBeams;
use crate::solve::path::options::PathOptions;
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::seta::converged_peak::ConvergedPeak;
use crate::study::seta::loading::SetaLoading;
use crate::study::seta::result::{SetaMoment, SetaPullOff};
use crate::study::seta::standing::RootDrive;
use crate::study::states::seta_state::LocationError;

/// The finer mesh has so many times as many elements, rounded up.
const FINER: f64 = 1.5;
/// How far behind the peak the finer mesh is followed, over the displacement there and over the way to it.
const BEHIND: f64 = 1e-2;

/// The peak on half as many elements again, and by how much it differs from that of the pull-off. None where there is none, where it is that behind an
/// event, or where the finer mesh does not come to it.
///
/// # Errors
/// What of the seta cannot be computed.
pub fn peak_of_beams_on_finer_mesh(
    model: &SetaOfBeams,
    loading: &SetaLoading,
    options: &PathOptions,
    pulled: &BeamsPullOff,
    stop: &StopCriteria,
) -> Result<Option<ConvergedPeak>, SetaError> {
    let (Some(coarse), Some(before)) = (&pulled.result.peak, &pulled.before_peak) else { return Ok(None) };
    let more = |elements: usize| (FINER * elements as f64).ceil() as usize;
    let mesh = SetaMesh { elements: model.mesh.elements.iter().copied().map(more).collect(), ..model.mesh.clone() };
    let finer = SetaOfBeams { mesh, elements: more(model.elements), ..model.clone() };
    let (at, peak) = (&before.from.observables, &coarse.point);
    let behind = peak.displacement + BEHIND * peak.displacement.abs() + (peak.displacement - at.displacement).abs();
    let stop = StopCriteria { displacement: Some(behind), events: Vec::new(), ..stop.clone() };
    let (tree, BeforePeak { off, step, root, .. }) = (finer.tree()?, before.clone());
    let read = tree.read_from(&model.tree()?, &before.from.at);
    let reached = BeamsProgress {
        result: SetaPullOff::empty(tree.elements()),
        here: None,
        displacement: at.displacement,
        off,
        step,
        from: root,
        losses: 0,
        ahead: NUDGE,
        before_peak: None,
    };
    let mut nobody = |_: &_, _: Option<&_>| {};
    let mut run = Run::new(&finer, loading, options, &stop, Some(reached), &mut nobody)?;
    let drive = RootDrive::new(loading.steps[step].direction, root);
    let Ok(begun) = run.at_rest(&drive, read, at.displacement) else { return Ok(None) };
    run.reached.here = Some(begun);
    // what was located stays, whatever the piece ends with
    let _ = run.follow(&loading.steps[step], &drive);
    let found = run.reached.result.peak.take().filter(|found| found.location.is_some());
    Ok(found.map(|found| ConvergedPeak {
        peak: SetaMoment::from(&found),
        location: found.location,
        order: finer.mesh.order,
        mesh: LocationError {
            force: (found.point.force_along - peak.force_along).abs(),
            displacement: (found.point.displacement - peak.displacement).abs(),
        },
    }))
}
