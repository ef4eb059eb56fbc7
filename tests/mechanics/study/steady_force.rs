//! The steady force of a peel, wherever on its path the front advances under it.
//!
//! Expected: the closed form of a film that slides without friction, P (1 - cos α) + P² sin² α/(2EA) = w b, which follows from the first integral;
//! where a plateau lies between peak and first jump, that one; none of a strip that hangs from its edge. Why: at 45 degrees a tape jumps a few
//! nanometres behind its peak, and the steady force, which is what a peel test measures, lies behind the jump.

use crate::common::paper_strip;
use peelkit::adhesion::{Attraction, CohesiveShape};
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, PeelModel, Pull, Spatula, Strip};
use peelkit::study::{Accuracy, StopCriteria, peel};

/// Relative accuracy that is asked for, and held against the closed form.
const ASKED: f64 = 1e-5;

/// 1 mm by 20 µm by 1 mm of silicone rubber.
pub(super) fn tape() -> PeelModel {
    let strip =
        Strip { length: 1e6, height: 2e4, width: 1e6, material: Material::of(2e-3, 0.49), crack: None, layers: None };
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        work: Some(0.2),
        strength: Some(1e-3),
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap();
    PeelModel::of(Body::Strip(strip), Adhesion { equilibrium_distance, ..law }, Grip::FREE)
}

pub(super) fn at(model: PeelModel, degrees: f64) -> PeelModel {
    PeelModel { pull: Pull { angle: degrees.to_radians(), ..Pull::UP }, ..model }
}

#[test]
fn the_steady_force_is_that_of_a_sliding_film() {
    for (name, model) in [("tape", tape()), ("strip", paper_strip(2000.0, 1.0).into())] {
        for degrees in [30.0, 45.0, 60.0, 90.0, 120.0] {
            let model = at(model.clone(), degrees);
            let expected = model.derived().section.unwrap().sliding_force.unwrap();
            let found = peel(&model, &Accuracy::to(ASKED), &StopCriteria::default());
            let plateau = found.plateau.unwrap_or_else(|| panic!("{name} at {degrees} degrees has none"));
            let off = (plateau.force - expected).abs();
            assert!(off <= ASKED * expected, "{name} at {degrees}: {plateau:?}, {expected}");
            if let Some(bound) = plateau.force_error {
                assert!(off <= bound, "{name} at {degrees}: {plateau:?}, {expected}");
            }
            let around = &found.points[plateau.after..plateau.after + 2];
            assert_eq!(plateau.stable, around.iter().all(|point| point.negative_eigenvalues == 0));
        }
    }
}

/// Numbers of the rule between peak and first jump alone.
#[test]
fn a_plateau_before_the_first_jump_stays_what_it_was() {
    for (length, force) in [(1000.0, 0.03061617263), (2000.0, 0.03061617422)] {
        let found = peel(&paper_strip(length, 1.0), &Accuracy::to(1e-6), &StopCriteria::default());
        let plateau = found.plateau.unwrap();
        assert!((plateau.force - force).abs() < 1e-10 && plateau.stable, "{plateau:?}");
        assert!(plateau.after < found.snap_off.unwrap().after);
    }
}

/// A strip of 46 process zones, which ends hanging from its edge, and a spatula: nowhere does a front go on and on.
#[test]
fn where_no_front_advances_there_is_no_steady_force() {
    let hanging = peel(&paper_strip(100.0, 1.0), &Accuracy::to(1e-6), &StopCriteria::default());
    assert_eq!(hanging.plateau, None);
    let spatula = PeelModel::of(Body::Spatula(Spatula::default()), Adhesion::default(), Grip::FREE);
    assert_eq!(peel(&spatula, &Accuracy::to(1e-4), &StopCriteria::default()).plateau, None);
}
