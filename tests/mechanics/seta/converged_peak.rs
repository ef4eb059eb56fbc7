//! The peak of a seta on finer meshes, from a few equilibria on each.
//!
//! The small seta of `setup.rs`, on elements of order 2, one a branch, with tips that slide and with tips that are held. Reference: the whole
//! pull-off on elements of order 6, three a branch. Expected: the peak on elements of order 3 that begins where the coarse one is has the force of the
//! whole pull-off with that mesh, to the error with which peaks are located; its difference is the true error of the coarse mesh to a third of it.
//! Where the mesh becomes finer until the force changes by a millionth, the true error is below what is said.

use super::setup::{along_normal, model, small};
use approx::assert_relative_eq;
use peelkit::model::{SetaMesh, SetaModel, Sideways};
use peelkit::study::{
    SetaLoading, SetaOptions, SetaPullOff, SetaStart, StepEnd, StopCriteria, converged_peak, pull_off,
};

fn loading() -> SetaLoading {
    SetaLoading { start: SetaStart::Adhering, steps: vec![along_normal(1.0, StepEnd::Detached(5000.0))] }
}

fn whole(model: &SetaModel) -> SetaPullOff {
    pull_off(model, &loading(), &SetaOptions::default(), &StopCriteria::default()).unwrap()
}

fn peak(run: &SetaPullOff) -> f64 {
    run.peak.as_ref().unwrap().point.force_along
}

#[test]
fn the_error_of_the_mesh_is_that_of_whole_pull_offs() {
    for sideways in [Sideways::Free, Sideways::Held(0.5)] {
        let fine = model(small(), sideways);
        let of_order = |order| SetaModel { mesh: SetaMesh { order, elements: vec![1; 3] }, ..fine.clone() };
        let (reference, coarse, next) = (peak(&whole(&fine)), whole(&of_order(2)), peak(&whole(&of_order(3))));
        let converged = |tolerance| {
            let (options, stop) = (SetaOptions::default(), StopCriteria::default());
            converged_peak(&of_order(2), &loading(), &options, &coarse, tolerance, &stop).unwrap().unwrap()
        };
        let finer = converged(1.0).peak.force;
        let (said, true_error) = (peak(&coarse) - finer, peak(&coarse) - reference);
        println!("{sideways:?}: peak {:.8} nN, error {said:.3e}, true {true_error:.3e}", peak(&coarse));
        assert_relative_eq!(finer, next, max_relative = 1e-6);
        assert_relative_eq!(said, true_error, max_relative = 1.0 / 3.0);
        let finest = converged(1e-6);
        let off = (finest.peak.force - reference).abs();
        println!("order {}: error {:.3e}, true {off:.3e}", finest.order, finest.mesh.force);
        assert!(finest.mesh.force <= 1e-6 * finest.peak.force);
        assert!(off <= finest.mesh.force, "{off:.2e} nN");
    }
}

/// Reference: nothing. A pull that is left while the force still rises has its last point as the largest force, and a run that has no peak has none.
#[test]
fn without_a_peak_there_is_no_error() {
    let model = model(small(), Sideways::Free);
    let empty = SetaPullOff { peak: None, ..whole(&model) };
    let finer = converged_peak(&model, &loading(), &SetaOptions::default(), &empty, 1e-6, &StopCriteria::default());
    assert_eq!(finer, Ok(None));
}
