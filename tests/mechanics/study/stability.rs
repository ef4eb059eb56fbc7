//! Models without a stable state, and paths that come to where theirs ends.
//!
//! Reference: the closed forms of `BondedBeam` against the negative eigenvalues of the whole tangent at rest, which knows nothing of
//! them; EI × 7.5e-7 of the paper's strip, below which its free end turns up, as `verification/README.md` finds it.
//!
//!     tilting  / / / / /    wrinkling  /\/\/\/\/    free end  \______
//!     ---------------       ------------            -----------------
//!
//! Parameters: strips from 2 to 20 nm high of 1 MPa to 3 GPa, EI × 1e-7 to 1e3, with one face and both.
//!
//! Expected: a model is refused, or its start is relaxed, where the criterion says so and nowhere else; a path under a horizontal
//! force ends where the criterion is met. Why: the path of an unstable state has numbers that no experiment has.

use crate::common::{paper_strip, with_grip};
use peelkit::beam::{BondedMode, PoleInReach};
use peelkit::model::{Adhesion, Body, Form, Grip, Hold, PeelModel, Spatula, StripModel};
use peelkit::solve::{Path, PathOptions};
use peelkit::study::{Accuracy, Failure, NoEquilibrium, PathEnd, Peel, StopCriteria, UnstableRest, peel};

fn peeled(model: &PeelModel, relative: f64) -> Peel {
    peel(model, &Accuracy::to(relative), &StopCriteria::after_points(2000))
}

/// A strip 100 nm long of this height (nm), modulus (GPa) and factor of EI.
fn strip(height: f64, modulus: f64, factor: f64) -> StripModel {
    let mut model = paper_strip(100.0, factor);
    (model.strip.height, model.strip.material.youngs_modulus) = (height, modulus);
    model
}

/// Negative eigenvalues of the flat strip at rest on this many elements.
fn negative_at_rest(model: &PeelModel, elements: usize) -> usize {
    let problem = model.problem(Form::TwoField, 7).unwrap();
    let options = PathOptions { elements, ..PathOptions::default() };
    Path::new(&problem, options).advance().unwrap().negative
}

#[track_caller]
fn refused(peel: &Peel) -> UnstableRest {
    match &peel.end {
        PathEnd::Failed(failure @ Failure::NoStart(NoEquilibrium::Unstable { why })) => {
            assert!(failure.is_refusal() && peel.points.is_empty());
            why.clone()
        }
        other => panic!("not refused: {other:?}"),
    }
}

#[test]
fn the_criterion_and_the_negative_eigenvalues_agree() {
    let mut unstable = [0; 3];
    for height in [2.0, 6.0, 20.0] {
        for modulus in [1e-3, 5e-3, 2e-2, 0.1, 3.0] {
            for factor in [1e-7, 1e-6, 1e-5, 1e-3, 1.0, 1e3] {
                for far_face in [true, false] {
                    let mut strip = strip(height, modulus, factor);
                    strip.adhesion.far_face = far_face;
                    let model = PeelModel::from(strip);
                    let beam = model.bonded_beam(0.0);
                    let modes = [BondedMode::Tilting, BondedMode::Wrinkling, BondedMode::FreeEnd];
                    let ratios = modes.map(|mode| beam.ratio(mode, 0.0));
                    if (ratios[2] - 1.0).abs() < 1e-3 {
                        continue;
                    }
                    let negative = negative_at_rest(&model, 200);
                    assert_eq!(
                        negative > 0,
                        ratios[2] > 1.0,
                        "{height} {modulus} {factor} {far_face}: {negative}, {ratios:?}"
                    );
                    (0..3).for_each(|mode| unstable[mode] += usize::from(ratios[mode] > 1.0));
                }
            }
        }
    }
    // each comes before the one before it
    assert!(unstable[0] > 10 && unstable[1] > unstable[0] && unstable[2] > unstable[1], "{unstable:?}");
}

#[test]
fn soft_strips_are_refused_with_the_ratio() {
    for (modulus, ratio) in [(1e-3, 8.81), (2e-3, 4.405), (5e-3, 1.762), (8e-3, 1.101)] {
        let peel = peeled(&strip(10.0, modulus, 1.0).into(), 1e-6);
        match refused(&peel) {
            UnstableRest::Tilting { ratio: found, shear, resistance, .. } => {
                assert!((found / ratio - 1.0).abs() < 1e-3, "{modulus}: {found}");
                assert_eq!(shear, resistance);
            }
            other => panic!("{other}"),
        }
        assert!(negative_at_rest(&strip(10.0, modulus, 1.0).into(), 20) > 0);
    }
    assert_eq!(peeled(&strip(10.0, 9e-3, 1.0).into(), 1e-6).end, PathEnd::TurnedBack);
}

/// A grip that does not turn keeps a short stiff strip from tilting: EI (π/2L)² adds to GA_s.
#[test]
fn a_stiff_strip_in_a_fixed_grip_does_not_tilt() {
    let model = |bending| PeelModel::from(with_grip(strip(10.0, 5e-3, bending), Hold::Fixed, Hold::Free));
    let beam = model(1.0).bonded_beam(0.0);
    let missing = beam.softening - beam.section.shear;
    let enough = missing / (beam.section.bending * (std::f64::consts::FRAC_PI_2 / 100.0).powi(2));
    // where y moves as well a little more is needed than y = 0 says
    assert!(negative_at_rest(&model(0.99 * enough), 40) > 0);
    assert_eq!(negative_at_rest(&model(1.01 * enough), 40), 0);
    assert!(matches!(refused(&peeled(&model(0.99 * enough), 1e-4)), UnstableRest::Tilting { .. }));
    assert!(!matches!(peeled(&model(1.01 * enough), 1e-4).end, PathEnd::Failed(Failure::NoStart(_))));
}

#[test]
fn a_strip_that_wrinkles_is_refused() {
    let peel = peeled(&paper_strip(100.0, 1e-8).into(), 1e-6);
    match refused(&peel) {
        UnstableRest::Wrinkling { ratio, wavelength, negative, .. } => {
            assert!(ratio > 4.0 && wavelength < 0.1 && negative > 10, "{ratio} {wavelength} {negative}");
        }
        other => panic!("{other}"),
    }
}

/// Just beyond the criterion the free end turns up a little, and the path starts there.
#[test]
fn a_strip_whose_free_end_turns_up_starts_where_it_comes_to_rest() {
    let factor = 7e-7;
    assert_eq!(negative_at_rest(&paper_strip(100.0, 7.6e-7).into(), 60), 0);
    assert_eq!(negative_at_rest(&paper_strip(100.0, factor).into(), 60), 1);
    let stop = StopCriteria { displacement: Some(0.05), ..StopCriteria::after_points(200) };
    let peel = peel(&paper_strip(100.0, factor), &Accuracy::to(1e-4), &stop);
    assert!(matches!(peel.end, PathEnd::Bound(_)), "{:?}", peel.end);
    let start = peel.relaxed_start.unwrap();
    assert!(start.negative == 1 && start.released > 0.0, "{start:?}");
    assert!(peel.points.iter().take(3).all(|point| point.negative_eigenvalues == 0));
    assert_eq!(peel.points[0].displacement, 0.0);
    assert!(peel.shape(0).rotation[0].abs() > 1e-3, "the free end has turned");
    assert!(peeled(&paper_strip(100.0, 1.0).into(), 1e-4).relaxed_start.is_none());
}

/// Pulled backwards without friction, what is bonded carries P cos α < 0 and buckles at its free end; the criterion and the
/// count of negative eigenvalues come together.
#[test]
fn what_is_bonded_buckles_under_a_pull_backwards() {
    let mut model = PeelModel::from(with_grip(strip(2.572185, 78.57923, 0.2089531), Hold::Fixed, Hold::Fixed));
    if let Body::Strip(strip) = &mut model.body {
        strip.length = 659.3364;
    }
    model.adhesion = Adhesion::of_half_space(0.2856547, 1.260646);
    model.pull.angle = 161.347f64.to_radians();
    let peel = peeled(&model, 1e-4);
    let PathEnd::BondedPartUnstable(loss) = peel.end else { panic!("{:?}", peel.end) };
    assert_eq!(loss.mode, BondedMode::FreeEnd);
    assert!(loss.force < loss.critical && loss.critical < 0.0, "{loss}");
    let beam = model.bonded_beam(0.0);
    assert!((beam.ratio(loss.mode, loss.critical) - 1.0).abs() < 1e-9, "{loss}");
    assert!(peel.points.iter().all(|point| point.negative_eigenvalues == 0), "the last point is before the end");
}

/// The two ways in which a bonded part loses its stability, by the closed forms: H = (1 - m/GA_s) GA_s of a strip that hardly
/// stretches; twice the compression of its free end.
#[test]
fn critical_forces_are_found_on_either_side() {
    let model = PeelModel::from(with_grip(strip(5.0, 0.03, 1.0), Hold::Free, Hold::Fixed));
    let problem = model.problem(Form::TwoField, 7).unwrap();
    let limits = &problem.beam.planar().unwrap().limits;
    let tension = model.bonded_beam(0.0).critical_tension().unwrap();
    assert!(limits.bonded_loss(0.9 * tension).is_none() && limits.bonded_loss(0.0).is_none());
    let loss = limits.bonded_loss(1.1 * tension).unwrap();
    assert_eq!(loss.mode, BondedMode::Tilting);
    assert!((loss.critical / tension - 1.0).abs() < 1e-9, "{loss} {tension}");
    let near = limits.near_bonded_loss(0.999 * tension).unwrap();
    assert!((near.critical / tension - 1.0).abs() < 1e-9, "{near} {tension}");
    assert!(
        PeelModel::from(strip(5.0, 0.03, 1.0))
            .problem(Form::TwoField, 7)
            .unwrap()
            .beam
            .planar()
            .unwrap()
            .limits
            .bonded
            .is_none()
    );
}

/// A shaft of 86 degrees that the near face alone draws on to 90 degrees; both faces leave it where it is.
#[test]
fn a_steep_shaft_without_its_far_face_is_refused() {
    let adhesion = Adhesion { far_face: false, ..Adhesion::of_half_space(0.1273216, 0.2851417) };
    let mut spatula = Spatula { shaft_angle: 86.323f64.to_radians(), pad_thickness: 7.281386, ..Spatula::default() };
    spatula.pad_length = 266.4632;
    spatula.material.youngs_modulus = 0.1360027;
    let model = PeelModel::of(Body::Spatula(spatula), adhesion, Grip { rotation: Hold::Fixed, ..Grip::FREE });
    match refused(&peeled(&model, 1e-4)) {
        UnstableRest::NearFaceAlone { steepest } => assert!(steepest > 80.0, "{steepest}"),
        UnstableRest::Upright(section) => {
            assert!(matches!(section.pole, PoleInReach::Crossed { strength } if strength > 0.0), "{section}")
        }
        other => panic!("{other}"),
    }
}
