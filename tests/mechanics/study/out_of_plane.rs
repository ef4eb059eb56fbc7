//! Where a planar path loses its stability against leaving its plane, and the widths at which it does not.
//!
//!     y |                    grip, free to roll
//!       |              .--(o)              narrow: buckles sideways       wide: rolls
//!       |         .--'                        ____                      \
//!       |====--'                             |    |  <-- z               \\_____ -->
//!       +------------------- x                                             \
//!
//! References: the spatial Simo-Reissner equations linearised at the planar path and shot from end to end
//! (`verification/out_of_plane.csv`, looked at in tests/checks/out_of_plane.rs; the numbers here are its first rows),
//! the same beam described in another way, and the beam in space, pulled 1e-8 degrees beside its plane, whose path meets a
//! branch point. Parameters: the paper's strip of 100 nm from 0.3 to 100 nm wide, pulled straight up, and 40 nm wide at elevations of 30 and
//! 60 degrees, away from it and backwards, and held along itself; the same as a profile and in the other form; models that are refused. Expected: the digits of the table; bounds that
//! hold; between two path points as well. Why: from there on a strip that is free to leave its plane is not on the
//! planar path any more, whatever the planar computation says.

use crate::common::{paper_strip, whole_peel};
use peelkit::adhesion::{LineLoad, Sinusoid, Substrate};
use peelkit::model::{
    Body, Form, Friction, Ground, Hold, PeelModel, Profile, ProfileColumns, ProfileForm, ProfileTable, Pull, Space,
    Step, StripModel,
};
use peelkit::study::{Accuracy, NotOutOfPlane, OutOfPlane, OutOfPlaneError, OutOfPlaneLoss, Peel, StopCriteria, peel};

fn wide(width: f64) -> StripModel {
    let mut model = paper_strip(100.0, 1.0);
    model.strip.width = width;
    model
}

fn stability(width: f64, relative: f64) -> OutOfPlane {
    whole_peel(&wide(width), relative).out_of_plane().unwrap()
}

fn assert_holds(found: OutOfPlaneLoss, displacement: f64, force: f64, what: &str) {
    let off = [(found.displacement - displacement).abs(), (found.force - force).abs()];
    assert!(off[0] <= found.displacement_error && off[1] <= found.force_error, "{what}: {found:?}, off by {off:?}");
}

/// u and P of the first loss, from shooting.
const SHOT: [(f64, f64, f64); 2] = [(1.0, 0.489743875867, 0.312661701292), (40.0, 0.152134725598, 12.9596243898)];

#[test]
fn the_first_loss_is_that_of_the_spatial_equations() {
    for (width, displacement, force) in SHOT {
        for relative in [1e-4, 1e-6, 1e-9] {
            let found = stability(width, relative).first_loss.unwrap();
            assert_holds(found, displacement, force, &format!("b = {width}, {relative:e}"));
            let reached = found.displacement_error / displacement;
            assert!(reached <= relative.max(2e-9), "b = {width}: {reached:e} where {relative:e} was asked for");
        }
    }
}

/// With a force along the strip the roll and the turn about the normal are coupled. The place of a branch point of a path in space is known to
/// 5e-7 nm.
#[test]
fn a_strip_with_a_force_along_it_loses_its_plane_where_the_beam_in_space_does() {
    let stop = StopCriteria { displacement: Some(4.0), ..StopCriteria::default() };
    for (elevation, azimuth, horizontal) in
        [(30.0f64, 0.0f64, Hold::Free), (60.0, 0.0, Hold::Free), (60.0, 180.0, Hold::Free), (90.0, 0.0, Hold::Fixed)]
    {
        let beside = if azimuth == 0.0 { 1e-8f64 } else { azimuth - 1e-8 };
        let pulled = |azimuth: f64| {
            let mut model = PeelModel {
                pull: Pull { angle: elevation.to_radians(), ..Pull::UP },
                space: Some(Space { azimuth: azimuth.to_radians(), ..Space::default() }),
                ..wide(40.0).into()
            };
            model.grip.horizontal = horizontal;
            model
        };
        let planar = peel(&pulled(azimuth), &Accuracy::to(1e-6), &stop);
        let found = planar.out_of_plane().unwrap();
        assert_eq!(found.most(), 1);
        let found = found.first_loss.unwrap();
        let in_space = peel(&pulled(beside), &Accuracy::to(1e-6), &stop);
        let at = &in_space.branch_points[0];
        assert!(found.displacement_error < 1e-2 * at.displacement_error);
        assert_holds(
            OutOfPlaneLoss { displacement_error: at.displacement_error, force_error: at.force_error, ..found },
            at.displacement,
            at.force,
            &format!("{elevation} degrees, azimuth {azimuth}"),
        );
    }
}

/// The count is that of the zeros of a shot: 19 before the first displacement limit point, and 18 there.
#[test]
fn a_narrow_strip_has_many_modes() {
    let peel = whole_peel(&wide(1.0), 1e-6);
    let found = peel.out_of_plane().unwrap();
    let snap_off = peel.snap_off.unwrap().after;
    assert_eq!((found.most(), found.negative_eigenvalues[snap_off + 1]), (19, 18));
    assert_eq!(found.negative_eigenvalues.len(), peel.points.len());
    assert_eq!((found.negative_eigenvalues[0], found.negative_eigenvalues.last()), (0, Some(&0)));
}

#[test]
fn between_two_widths_the_planar_path_is_stable() {
    let range = whole_peel(&wide(1.0), 1e-6).planar_widths().unwrap().unwrap();
    let (narrowest, widest) = (range.narrowest.unwrap(), range.widest.unwrap());
    assert!((narrowest.width - 4.92922354).abs() < 1e-7, "{narrowest:?}");
    assert!((widest.width - 25.2371810).abs() < widest.width_error, "{widest:?}");
    for (limit, sign) in [(narrowest, 1.0), (widest, -1.0)] {
        let inside = stability(limit.width + sign * 1e-4, 1e-6);
        assert_eq!((inside.first_loss, inside.most()), (None, 0));
        let beyond = stability(limit.width - sign * 1e-4, 1e-6).first_loss.unwrap();
        assert!((beyond.displacement / limit.displacement - 1.0).abs() < 0.02, "{beyond:?} {limit:?}");
    }
}

/// Just beyond its limit a strip is unstable on a part of the path so short that no point of it is.
#[test]
fn a_loss_between_two_stable_points_is_found() {
    let peel = whole_peel(&wide(4.929223), 1e-9);
    let found = peel.out_of_plane().unwrap();
    assert_eq!(found.unstable_points(), 0);
    let loss = found.first_loss.unwrap();
    assert!((47.3..47.6).contains(&loss.displacement) && found.most() == 1, "{loss:?}");
    let (before, behind) = (peel.points[loss.after.unwrap()], peel.points[loss.after.unwrap() + 1]);
    assert!((before.displacement..behind.displacement).contains(&loss.displacement));
}

#[test]
fn bounds_hold_from_one_accuracy_to_the_next() {
    for width in [0.5, 2.0, 4.0, 4.8, 25.3, 30.0, 100.0] {
        let fine = stability(width, 1e-9).first_loss.unwrap();
        for relative in [1e-4, 1e-5, 1e-7] {
            let coarse = stability(width, relative).first_loss.unwrap();
            let bounds = [coarse.displacement_error + fine.displacement_error, coarse.force_error + fine.force_error];
            let off = [(coarse.displacement - fine.displacement).abs(), (coarse.force - fine.force).abs()];
            assert!(off[0] <= bounds[0] && off[1] <= bounds[1], "b = {width}, {relative:e}: {off:?} {bounds:?}");
        }
    }
}

/// b²Ψ_yy/12 is less than the work of adhesion: standing on its edge it holds less than lying on its side.
#[test]
fn a_strip_may_be_unstable_from_the_beginning() {
    let loss = stability(0.15, 1e-6).first_loss.unwrap();
    assert_eq!((loss.after, loss.displacement), (None, 0.0));
    assert!(loss.force.abs() < 1e-12, "{loss:?}");
}

/// A table of one width and one height, and three unknowns a node.
#[test]
fn the_same_beam_described_in_another_way_is_the_same() {
    let strip: PeelModel = wide(2.0).into();
    let loss = |model: &PeelModel, accuracy: &Accuracy| {
        let peel: Peel = peel(model, accuracy, &StopCriteria::after_points(5000));
        peel.out_of_plane().unwrap().first_loss.unwrap()
    };
    let own = loss(&strip, &Accuracy::to(1e-7));
    let columns = ProfileColumns {
        places: vec![0.0, 100.0],
        widths: vec![2.0; 2],
        heights: vec![10.0; 2],
        angles: vec![0.0; 2],
        roundness: Vec::new(),
    };
    let form = ProfileForm::Table(ProfileTable::new(columns).unwrap());
    let profile = Body::Profile(Profile { form, material: strip.material() });
    let mut three = Accuracy::to(1e-7);
    three.choice.form = Form::ThreeField;
    for other in [loss(&PeelModel { body: profile, ..strip.clone() }, &Accuracy::to(1e-7)), loss(&strip, &three)] {
        assert!((other.displacement - own.displacement).abs() <= own.displacement_error + other.displacement_error);
        assert!((other.force - own.force).abs() <= own.force_error + other.force_error);
    }
}

#[test]
fn what_it_does_not_cover_is_refused() {
    let strip: PeelModel = wide(2.0).into();
    let refused = |change: fn(&mut PeelModel), why: NotOutOfPlane| {
        let mut model = strip.clone();
        change(&mut model);
        assert_eq!(NotOutOfPlane::of(&model), Some(why));
        let peel = peel(&model, &Accuracy::to(1e-3), &StopCriteria::after_points(3));
        assert_eq!(peel.out_of_plane(), Err(OutOfPlaneError::Refused(why)));
        assert_eq!(peel.planar_widths(), Err(OutOfPlaneError::Refused(why)));
        assert!(why.remedy().starts_with("Omit --out-of-plane, or "));
    };
    assert_eq!(NotOutOfPlane::of(&strip), None);
    refused(|model| model.grip.rotation = Hold::Fixed, NotOutOfPlane::Rotation);
    refused(|model| model.steps = vec![Step::Press(0.01)], NotOutOfPlane::Steps);
    refused(|model| model.friction = Friction { strength: Some(0.01), ..Friction::NONE }, NotOutOfPlane::Friction);
    refused(|model| model.adhesion.line_load = LineLoad::ForceOnly, NotOutOfPlane::NoPotential);
    let wave = Sinusoid { height: 0.1, wavelength: 50.0, offset: 0.0 };
    let wavy = Ground { substrate: Substrate::Sinusoid(wave), ..Ground::default() };
    let peel = peel(&PeelModel { ground: wavy, ..strip.clone() }, &Accuracy::to(1e-3), &StopCriteria::after_points(3));
    assert_eq!(peel.out_of_plane(), Err(OutOfPlaneError::Refused(NotOutOfPlane::Ground)));
    assert_eq!(peel.without_solutions().out_of_plane(), Err(OutOfPlaneError::Refused(NotOutOfPlane::Ground)));
    let dropped = whole_peel(&wide(2.0), 1e-3).without_solutions();
    assert_eq!(dropped.out_of_plane(), Err(OutOfPlaneError::NoSolutions));
}
