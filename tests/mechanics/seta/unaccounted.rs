//! A seta whose energy changes where nothing works on it.
//!
//! ```text
//!      E |            ____/   of a detached tip: it grows above 3000 nm, and no force belongs to that
//!        |___________/_______ y
//! ```
//!
//! The small seta of `setup.rs`, pulled off along the normal and lifted by 5000 nm more. Above the ground a seta without a tip that adheres carries nothing, so
//! that no step looks at its balance. Expected: all steps are taken, and the end says that work is missing, as much as the tips have gained; without the
//! drift the run is completed. Why: the law of a tip may be a user's own, and a run that goes over to another branch unseen has to be found out.

use super::setup::{along_normal, model, pulled, small};
use peelkit::beam::EndResponse;
use peelkit::beam::rotation::Quaternion;
use peelkit::model::{SetaModel, Sideways, TipBranch, TipLaw};
use peelkit::study::{SetaEnd, SetaFailure, SetaStart, StepEnd};
use std::sync::Arc;

/// Energy of a tip per height above this one, aJ/nm and nm.
const DRIFT: f64 = 1e-3;
const HIGH: f64 = 3000.0;

#[derive(Debug)]
struct Drifting {
    own: Arc<dyn TipLaw>,
}

impl TipLaw for Drifting {
    fn response(&self, on: TipBranch, place: [f64; 3], directors: Quaternion) -> EndResponse {
        let own = self.own.response(on, place, directors);
        EndResponse { energy: own.energy + DRIFT * (place[1] - HIGH).max(0.0), ..own }
    }

    fn branch(&self, before: TipBranch, place: [f64; 3], directors: Quaternion) -> TipBranch {
        self.own.branch(before, place, directors)
    }
}

#[test]
fn work_that_is_nowhere_is_said_at_the_end() {
    let steps = [along_normal(1.0, StepEnd::Detached(5000.0)), along_normal(1.0, StepEnd::Travel(5000.0))];
    let plain = model(small(), Sideways::Free);
    assert_eq!(pulled(&plain, SetaStart::Adhering, &steps).end, SetaEnd::Completed);
    let drifting = SetaModel { law: Arc::new(Drifting { own: plain.law.clone() }), ..plain };
    let run = pulled(&drifting, SetaStart::Adhering, &steps);
    let SetaEnd::Failed(failure @ SetaFailure::Unaccounted { missing, work, .. }) = &run.end else {
        panic!("{:?}", run.end)
    };
    let last = run.points.last().unwrap();
    assert!(last.attached == 0 && last.energy > 1.0, "{last:?}");
    // work and energy of each step agree to 1e-8
    assert!((missing + last.energy).abs() < 1e-7 * work, "{missing} {work} {last:?}");
    let words = format!("all steps are taken, but {missing:.6} aJ of the {work:.6} aJ that the root has worked");
    assert!(failure.to_string().starts_with(&words), "{failure}");
}
