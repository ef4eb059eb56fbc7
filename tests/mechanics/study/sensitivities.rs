//! Derivatives of the results of a peel by its parameters: one transposed solve a limit point against differences of whole runs.
//!
//!      P |    .-p(1+x)       the peak rises by dP, the first jump moves by du
//!        |  /.-.\  \
//!        | //   \ \ \
//!        |//_____)_)_\_ u
//!
//! Reference: central differences of the fourth order of runs at 1e-10, with steps of 2e-3 and 4e-3 in the logarithm of the parameter, whose own
//! error is estimated by what the second order misses. Dimensional analysis: with forces P ~ E^a A^b and lengths to the power c, a + b = 1 and c = 2a - b.
//! Parameters: the paper's strip 50 nm long, pulled up, at 60 degrees with its grip free and held, with a load without a potential, under a bilinear law, by
//! a grip that turns as it goes; sideways in space; the spatula; a beam by a table.
//! Expected: every derivative within its bound and what differences leave of the reference, and but for plateaus within 1e-6 of it; the identities within the bounds.
//! Why: an optimiser, a fit and a statement of uncertainty are as good as these.

use crate::common::{paper_strip, with_grip, with_load};
use peelkit::adhesion::{Attraction, LineLoad};
use peelkit::model::{
    Body, Friction, Hold, PeelModel, Profile, ProfileColumns, ProfileForm, ProfileTable, Pull, Space, Spatula, Strip,
};
use peelkit::study::{
    Accuracy, NoSensitivities, Peel, PeelQuantity, StopCriteria, Variation, force_derivatives, peel, sensitivities,
};

fn peeled(model: &PeelModel, relative: f64) -> Peel {
    peel(model, &Accuracy::to(relative), &StopCriteria::default())
}

fn strip_of(model: &mut PeelModel) -> &mut Strip {
    let Body::Strip(strip) = &mut model.body else { panic!("a strip") };
    strip
}

/// A number of a model.
type Place = fn(&mut PeelModel) -> &mut f64;

const MODULUS: (&str, Place) = ("strip.youngs_modulus", |model| &mut strip_of(model).material.youngs_modulus);
const LENGTH: (&str, Place) = ("strip.length", |model| &mut strip_of(model).length);
const HEIGHT: (&str, Place) = ("strip.height", |model| &mut strip_of(model).height);
const WIDTH: (&str, Place) = ("strip.width", |model| &mut strip_of(model).width);
const HAMAKER: (&str, Place) = ("adhesion.hamaker_constant", |model| &mut model.adhesion.hamaker_constant);
const DISTANCE: (&str, Place) = ("adhesion.equilibrium_distance", |model| &mut model.adhesion.equilibrium_distance);
const ANGLE: (&str, Place) = ("drive.angle", |model| &mut model.pull.angle);
const TURN: (&str, Place) = ("drive.turn", |model| &mut model.pull.turn);

fn variation((key, place): (&str, Place), model: &PeelModel) -> Variation<'static> {
    let model = model.clone();
    Variation::new(key, move |change| {
        let mut model = model.clone();
        *place(&mut model) *= change.exp();
        model
    })
}

/// Derivatives at 1e-7 against differences at 1e-10, over the numbers themselves.
fn check(name: &str, model: &PeelModel, variations: &[Variation]) {
    let own = peeled(model, 1e-7);
    let found = sensitivities(&own, &PeelQuantity::OF_A_PEEL, variations).unwrap();
    assert_eq!(found.refused, [], "{name}");
    let mut compared = 0;
    for (k, variation) in variations.iter().enumerate() {
        let step = 2e-3;
        let beside = [1.0, -1.0, 2.0, -2.0].map(|steps| peeled(&(variation.model)(steps * step), 1e-10));
        for of in PeelQuantity::OF_A_PEEL {
            let Some(derivative) = found.of(of, k) else { continue };
            let values = beside.each_ref().map(|peel| of.value(peel).unwrap());
            let [near, far] = [0, 2].map(|k| (values[k] - values[k + 1]) / ((k + 2) as f64 * step));
            let reference = (4.0 * near - far) / 3.0;
            let number = of.value(&own).unwrap();
            let missed = 1e-2 * (near - far).abs() + 1e-9 * number.abs() / step;
            let difference = (derivative.value - reference).abs();
            let what = format!("{name}, {} by {}", of.name(), variation.key);
            assert!(difference <= derivative.error + missed, "{what}: {derivative:?} against {reference}");
            // where a plateau lies is known so little that its bound is larger
            let enough = of == PeelQuantity::PlateauForce || difference <= 1e-6 * number.abs() + missed;
            assert!(enough, "{what}: {derivative:?} against {reference}");
            compared += 1;
        }
    }
    assert!(compared >= 3 * variations.len(), "{name}: {compared} numbers");
}

fn check_strip(name: &str, model: &PeelModel, numbers: &[(&str, Place)]) {
    let variations: Vec<_> = numbers.iter().map(|&number| variation(number, model)).collect();
    check(name, model, &variations);
}

fn pulled(strip: impl Into<PeelModel>, degrees: f64) -> PeelModel {
    PeelModel { pull: Pull { angle: degrees.to_radians(), ..Pull::UP }, ..strip.into() }
}

#[test]
fn strips_pulled_up_and_at_an_angle() {
    let strip = paper_strip(50.0, 1.0);
    check_strip("up", &(&strip).into(), &[MODULUS, LENGTH, DISTANCE, ANGLE]);
    check_strip("at 60 degrees", &pulled(strip, 60.0), &[HEIGHT, HAMAKER, ANGLE]);
    let held = with_grip(strip, Hold::Fixed, Hold::Fixed);
    check_strip("held at 60 degrees", &pulled(held, 60.0), &[MODULUS, DISTANCE, ANGLE]);
}

#[test]
fn other_laws_and_grips() {
    let strip = paper_strip(50.0, 1.0);
    check_strip("without a potential", &(&with_load(strip, LineLoad::ForceOnly)).into(), &[MODULUS, HEIGHT]);
    let mut bilinear: PeelModel = (&strip).into();
    bilinear.adhesion.attraction = Attraction::named("bilinear").unwrap();
    check_strip("bilinear", &bilinear, &[MODULUS, DISTANCE]);
    let mut turning: PeelModel = (&with_grip(strip, Hold::Fixed, Hold::Free)).into();
    turning.pull.turn = 1f64.to_radians();
    check_strip("turning", &turning, &[MODULUS, TURN]);
}

#[test]
fn spatula_and_table() {
    let mut spatula: PeelModel = (&paper_strip(50.0, 1.0)).into();
    spatula.body = Body::Spatula(Spatula::default());
    let place: Place = |model| {
        let Body::Spatula(spatula) = &mut model.body else { panic!("a spatula") };
        &mut spatula.pad_length
    };
    check_strip("spatula", &spatula, &[("spatula.pad_length", place), HAMAKER]);
    let table = |changes: [f64; 2]| {
        let (places, widths) = (vec![0.0, 20.0, 50.0], vec![1.0, 1.3 * changes[0].exp(), 1.0]);
        let heights = vec![8.0, 10.0, 12.0 * changes[1].exp()];
        let columns = ProfileColumns { places, widths, heights, ..ProfileColumns::default() };
        let form = ProfileForm::Table(ProfileTable::new(columns).unwrap());
        let material = PeelModel::from(&paper_strip(50.0, 1.0)).material();
        PeelModel { body: Body::Profile(Profile { form, material }), ..(&paper_strip(50.0, 1.0)).into() }
    };
    let variations = [
        Variation::new("a width", move |change| table([change, 0.0])),
        Variation::new("a height", move |change| table([0.0, change])),
    ];
    check("table", &table([0.0; 2]), &variations);
}

#[test]
fn sideways_in_space() {
    let mut model = pulled(paper_strip(60.0, 1.0), 60.0);
    model.space = Some(Space { azimuth: 45f64.to_radians(), ..Space::default() });
    strip_of(&mut model).width = 10.0;
    let azimuth: Place = |model| &mut model.space.as_mut().expect("it is in space").azimuth;
    check_strip("sideways", &model, &[("drive.azimuth", azimuth)]);
}

/// P/A_H^b E^a is a function of ratios of lengths alone, and width multiplies every force and work.
#[test]
fn exponents_obey_dimensional_analysis() {
    let model: PeelModel = (&paper_strip(50.0, 1.0)).into();
    let numbers = [MODULUS, HAMAKER, LENGTH, HEIGHT, WIDTH, DISTANCE];
    let variations: Vec<_> = numbers.iter().map(|&number| variation(number, &model)).collect();
    let own = peeled(&model, 1e-7);
    let found = sensitivities(&own, &PeelQuantity::OF_A_PEEL, &variations).unwrap();
    let exponents = found.exponents(&own);
    // dimensions of force and length
    for (of, force, length) in [
        (PeelQuantity::InitiationPeakForce, 1.0, 0.0),
        (PeelQuantity::InitiationPeakDisplacement, 0.0, 1.0),
        (PeelQuantity::FirstJumpForce, 1.0, 0.0),
        (PeelQuantity::FirstJumpDisplacement, 0.0, 1.0),
        (PeelQuantity::FirstJumpWork, 1.0, 1.0),
    ] {
        let by =
            |k: usize| exponents.iter().find(|e| e.of == of && e.variation == k).map(|e| (e.value, e.error)).unwrap();
        let (modulus, hamaker) = (by(0), by(1));
        let lengths = (2..6).map(by).fold((0.0, 0.0), |sum, e| (sum.0 + e.0, sum.1 + e.1));
        let error = modulus.1 + hamaker.1 + lengths.1;
        assert!((modulus.0 + hamaker.0 - force).abs() <= error, "{of:?}: {modulus:?} {hamaker:?}");
        let of_length = lengths.0 - 2.0 * modulus.0 + hamaker.0;
        assert!((of_length - length).abs() <= 3.0 * error, "{of:?}: {of_length} against {length}, {error:e}");
        let width = if force > 0.0 { 1.0 } else { 0.0 };
        assert!((by(4).0 - width).abs() <= by(4).1.max(1e-9), "{of:?}: {:?}", by(4));
    }
}

/// Next to the first jump no displacement can be held to the last digit, and the force changes as the root of how far it is: four times as near it is
/// half as far from that of the jump, and its derivative by a parameter is twice as large.
#[test]
fn the_force_next_to_the_first_jump() {
    let model: PeelModel = (&paper_strip(50.0, 1.0)).into();
    let own = peeled(&model, 1e-9);
    let jump = own.snap_off.unwrap();
    for near in [1e-6, 1e-7, 1e-8] {
        let places = [4.0, 1.0].map(|share: f64| jump.displacement * (1.0 - share * near));
        let found = force_derivatives(&own, &places, &[variation(MODULUS, &model)]).unwrap();
        let [far, close] = [0, 1].map(|k: usize| found[k].0 - jump.force);
        assert!((far / close / 2.0 - 1.0).abs() < 1e-2, "{near}: {far} {close}");
        let [far, close] = [0, 1].map(|k: usize| found[k].1[0]);
        assert!((close / far / 2.0 - 1.0).abs() < 5e-2, "{near}: {far} {close}");
    }
}

/// dP/dx at held displacements, against differences of the curve.
#[test]
fn the_force_along_the_stable_branch() {
    let model: PeelModel = (&paper_strip(50.0, 1.0)).into();
    let variations = [variation(MODULUS, &model), variation(HAMAKER, &model)];
    let places = [0.05, 0.2, 0.3, 0.4, 1.0];
    let own = peeled(&model, 1e-7);
    let found = force_derivatives(&own, &places, &variations).unwrap();
    for (k, variation) in variations.iter().enumerate() {
        let force = |change: f64| {
            let beside = peeled(&(variation.model)(change), 1e-10);
            force_derivatives(&beside, &places, &[]).unwrap().into_iter().map(|row| row.0).collect::<Vec<_>>()
        };
        let step = 1e-3;
        for (place, (low, high)) in force(-step).into_iter().zip(force(step)).enumerate() {
            let difference = (high - low) / (2.0 * step);
            let (own, derivative) = (found[place].0, found[place].1[k]);
            assert!((derivative - difference).abs() < 5e-6 * own.abs(), "{place}: {derivative} against {difference}");
        }
    }
    let beyond = force_derivatives(&own, &[1e3], &variations);
    assert!(matches!(beyond, Err(NoSensitivities::NotOnBranch { .. })), "{beyond:?}");
}

#[test]
fn what_has_no_derivative_says_so() {
    let model: PeelModel = (&paper_strip(50.0, 1.0)).into();
    let own = peeled(&model, 1e-5);
    let edge = Variation::new("strip.poissons_ratio", |change| {
        let mut model: PeelModel = (&paper_strip(50.0, 1.0)).into();
        strip_of(&mut model).material.poissons_ratio = 0.4999 * (1.0 + change);
        model
    });
    let found = sensitivities(&own, &[PeelQuantity::PeakForce], &[edge, variation(MODULUS, &model)]).unwrap();
    assert!(matches!(found.refused[..], [(0, NoSensitivities::AtTheEdge { .. })]), "{:?}", found.refused);
    assert!(found.of(PeelQuantity::PeakForce, 1).is_some());
    let read = own.without_solutions();
    assert_eq!(sensitivities(&read, &[], &[]), Err(NoSensitivities::NoSolutions));
    let sticking = PeelModel { friction: Friction { strength: Some(0.1), ..Friction::NONE }, ..model };
    let found = sensitivities(&peeled(&sticking, 1e-3), &[], &[]);
    assert_eq!(found, Err(NoSensitivities::Friction));
}
