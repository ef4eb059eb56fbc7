//! Models built in a program that cannot be computed.
//!
//! Expected: each is refused before anything is solved, by the key that a scene has for the value, with the value and its unit, and
//! with what would be right; and every number of a model is refused where it is NaN, infinite or out of its range. Why: a program
//! is to hear what a scene hears, and a Newton iteration on NaN says nothing.

use peelkit::adhesion::{BodyShape, CohesiveShape, Heights, LineLoad, Ridge, Round, Sinusoid, Substrate};
use peelkit::model::{
    Attraction, Body, Discretisation, Form, Friction, Grip, Ground, Hold, MODEL_NUMBERS, Measured, ModelError,
    ModelErrorKind, NoSuchOrder, PeelModel, Piece, Profile, ProfileForm, ProfilePieces, Pull, Range, Space, Spatula,
    Start, Step, StepError, StripModel,
};
use peelkit::study::{Accuracy, Choice, prepared};
use std::f64::consts::{FRAC_PI_3, PI};
use std::sync::Arc;

fn strip() -> PeelModel {
    StripModel::of_the_paper(100.0, 1.0).into()
}

fn spatula(change: impl FnOnce(&mut Spatula)) -> PeelModel {
    let mut spatula = Spatula::default();
    change(&mut spatula);
    spatula.model()
}

fn on(substrate: Substrate) -> PeelModel {
    PeelModel { ground: Ground { substrate, start: Start::Conformed }, ..strip() }
}

fn rubbing(friction: Friction) -> PeelModel {
    PeelModel { friction, ..strip() }
}

/// With an initial crack of so many nm.
fn cracked(crack: f64) -> PeelModel {
    let mut model = strip();
    set(&mut model, "strip.crack", crack);
    model
}

fn refused(model: &PeelModel) -> ModelError {
    let error = model.check().expect_err("the model is refused");
    // a NaN is not equal to itself, its text is
    assert_eq!(model.clone().checked().map_err(|error| error.to_string()).err(), Some(error.to_string()));
    assert_eq!(error.to_string(), format!("`{}` {}", error.key(), error.found()));
    assert!(error.remedy().ends_with('.'), "{}", error.remedy());
    error
}

/// The key, the sentence and the number.
fn assert_refused(model: &PeelModel, key: &str, sentence: &str, value: Option<(f64, &'static str)>) {
    let error = refused(model);
    assert_eq!((error.key(), error.to_string().as_str()), (key, sentence));
    assert_eq!(error.value(), value.map(|(value, unit)| Measured { value, unit }));
}

/// Puts a number where the line of the list has it.
fn set(model: &mut PeelModel, key: &str, number: f64) {
    let (table, name) = key.split_once('.').unwrap();
    let material = model.body.material_mut();
    let of_material = match name {
        "youngs_modulus" => Some(&mut material.youngs_modulus),
        "poissons_ratio" => Some(&mut material.poissons_ratio),
        "shear_correction" => Some(&mut material.shear_correction),
        "bending_stiffness_factor" => Some(&mut material.bending_stiffness_factor),
        _ => None,
    };
    if let (Some(place), true) = (of_material, ["strip", "spatula", "profile"].contains(&table)) {
        *place = number;
        return;
    }
    let PeelModel { body, adhesion, grip, pull, ground, friction, space, .. } = model;
    match (table, body) {
        ("strip", Body::Strip(strip)) => {
            *match name {
                "length" => &mut strip.length,
                "height" => &mut strip.height,
                "width" => &mut strip.width,
                "crack" => strip.crack.insert(number),
                "yield_strength" => strip.material.yield_strength.insert(number),
                "tangent_modulus" => strip.material.tangent_modulus.insert(number),
                _ => panic!("{key} is not in this test"),
            } = number;
        }
        ("spatula", Body::Spatula(spatula)) => {
            *match name {
                "pad_length" => &mut spatula.pad_length,
                "neck_length" => &mut spatula.neck_length,
                "shaft_length" => &mut spatula.shaft_length,
                "bend_length" => &mut spatula.bend_length,
                "tip_width" => &mut spatula.tip_width,
                "neck_width" => &mut spatula.neck_width,
                "shaft_diameter" => &mut spatula.shaft_diameter,
                "pad_thickness" => &mut spatula.pad_thickness,
                "shaft_angle" => &mut spatula.shaft_angle,
                "tip_rounding_length" => &mut spatula.tip_rounding_length,
                "tip_rounding_width" => &mut spatula.tip_rounding_width,
                _ => panic!("{key} is not in this test"),
            } = number;
        }
        ("substrate", _) => *ground.substrate.number(name).unwrap() = number,
        _ => match key {
            "adhesion.hamaker_constant" => adhesion.hamaker_constant = number,
            "adhesion.equilibrium_distance" => adhesion.equilibrium_distance = number,
            "adhesion.work" => adhesion.work = Some(number),
            "adhesion.strength" => adhesion.strength = Some(number),
            "adhesion.shear_strength" => adhesion.shear_strength = Some(number),
            "adhesion.shear_work" => {
                adhesion.shear_strength = Some(0.1);
                adhesion.shear_work = Some(number);
            }
            "adhesion.mixing_exponent" => {
                (adhesion.shear_strength, adhesion.shear_work) = (Some(0.1), Some(0.1));
                adhesion.mixing_exponent = Some(number);
            }
            "friction.strength" => friction.strength = Some(number),
            "friction.coefficient" => friction.coefficient = number,
            "friction.presliding" => friction.presliding = Some(number),
            "grip.stiffness" => grip.stiffness = Some(number),
            "grip.pretension" => grip.pretension = Some(number),
            "drive.angle" => pull.angle = number,
            "drive.turn" => pull.turn = number,
            "drive.azimuth" => space.get_or_insert_default().azimuth = number,
            _ => panic!("{key} is not in this test"),
        },
    }
}

/// A model that has the number of this key.
fn having(key: &str) -> PeelModel {
    let ground = |substrate| PeelModel { ground: Ground { substrate, ..Ground::default() }, ..strip() };
    match key.split_once('.').unwrap() {
        ("spatula", _) => spatula(|_| ()),
        ("profile", _) => {
            let pieces = ProfilePieces::new(vec![Piece::straight(100.0, 1.0, 10.0)]).unwrap();
            let material = Spatula::default().material;
            let body = Body::Profile(Profile { form: ProfileForm::Pieces(pieces), material });
            PeelModel { body, ..strip() }
        }
        ("substrate", "radius" | "offset") => ground(Substrate::Ridge(Ridge { radius: 90.0, offset: 0.0 })),
        ("substrate", _) => ground(Substrate::Sinusoid(Sinusoid { height: 1.0, wavelength: 90.0, offset: 0.0 })),
        ("drive", "azimuth") => PeelModel { space: Some(Space::default()), ..strip() },
        ("strip", "crack") => cracked(20.0),
        ("strip", "yield_strength" | "tangent_modulus") => {
            let mut model = strip();
            set(&mut model, "strip.yield_strength", 0.1);
            model.adhesion.attraction = Attraction::Cohesive(CohesiveShape::Bilinear);
            model
        }
        _ => strip(),
    }
}

#[test]
fn every_number_is_looked_at() {
    for number in MODEL_NUMBERS {
        let good = having(number.key);
        assert_eq!(good.check(), Ok(()), "{}", number.key);
        let outside = match number.range {
            Range::Positive => vec![0.0, -0.0, -1.0],
            Range::Between(low, high) => vec![low, high, 2.0 * high],
            Range::From(low, high) => vec![low - 1.0, high * 1.001],
        };
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].into_iter().chain(outside) {
            let mut model = good.clone();
            set(&mut model, number.key, bad);
            let error = refused(&model);
            assert_eq!(error.key(), number.key, "{bad}");
            let found = error.value().unwrap();
            assert_eq!((found.value.to_bits(), found.unit), (bad.to_bits(), number.unit), "{}", number.key);
            let range = number.range;
            let expected = match bad.is_finite() {
                true => matches!(error.kind(), ModelErrorKind::OutOfRange { range: told, .. } if *told == range),
                false => matches!(error.kind(), ModelErrorKind::NotFinite { range: told, .. } if *told == range),
            };
            assert!(expected, "{error:?}");
            assert!(error.remedy().starts_with("Give a number"), "{}", error.remedy());
        }
    }
}

#[test]
fn a_sentence_says_what_is_wrong_and_a_remedy_what_is_right() {
    let mut model = strip();
    set(&mut model, "strip.length", 0.0);
    let sentence = "`strip.length` is 0 nm, which is out of range";
    assert_refused(&model, "strip.length", sentence, Some((0.0, "nm")));
    assert_eq!(refused(&model).remedy(), "Give a number above zero, in nm.");
    set(&mut model, "strip.length", f64::NAN);
    assert_eq!(refused(&model).to_string(), "`strip.length` is NaN nm, which is not a finite number");
    let mut model = strip();
    set(&mut model, "strip.poissons_ratio", 0.5);
    assert_eq!(refused(&model).remedy(), "Give a number between -1 and 0.5, both excluded.");
}

#[test]
fn what_does_not_fit_the_law_or_the_grip() {
    let sentence = "`adhesion.work` belongs to a cohesive law, and the law of this scene is not cohesive";
    let mut model = strip();
    model.adhesion.work = Some(0.03);
    assert_refused(&model, "adhesion.work", sentence, Some((0.03, "J/m2")));
    assert!(refused(&model).remedy().contains("\"bilinear\" or \"exponential\""));
    model.adhesion.attraction = Attraction::Cohesive(CohesiveShape::Bilinear);
    assert_eq!(model.check(), Ok(()));

    let grip = |horizontal| Grip { horizontal, pretension: Some(0.5), ..Grip::FREE };
    let stretched = PeelModel { grip: grip(Hold::Fixed), ..strip() };
    assert_eq!(stretched.check(), Ok(()));
    for model in [
        PeelModel { grip: grip(Hold::Free), ..strip() },
        PeelModel { grip: grip(Hold::Fixed), ..spatula(|_| ()) },
        PeelModel { grip: grip(Hold::Fixed), ..on(Substrate::Ridge(Ridge { radius: 90.0, offset: 0.0 })) },
    ] {
        let error = refused(&model);
        assert_eq!((error.key(), error.value()), ("grip.pretension", Some(Measured { value: 0.5, unit: "nN" })));
        assert!(matches!(error.kind(), ModelErrorKind::NotStretched { .. }), "{error}");
    }
}

/// A crack leaves something that adheres, and is computed in the plane, on flat ground, without friction and pretension.
#[test]
fn what_does_not_fit_a_crack() {
    assert_eq!(cracked(99.9).check(), Ok(()));
    let sentence = "`strip.crack` is 100 nm, and the strip is 100 nm long: nothing adheres";
    assert_refused(&cracked(100.0), "strip.crack", sentence, Some((100.0, "nm")));
    let friction = Friction { strength: Some(0.05), ..Friction::NONE };
    let grip = Grip { horizontal: Hold::Fixed, pretension: Some(0.5), ..Grip::FREE };
    let ridge = Substrate::Ridge(Ridge { radius: 90.0, offset: 0.0 });
    for (beside, what) in [
        (PeelModel { space: Some(Space::default()), ..cracked(20.0) }, "a scene in space"),
        (PeelModel { friction, ..cracked(20.0) }, "friction"),
        (PeelModel { grip, ..cracked(20.0) }, "a pretension"),
        (
            PeelModel { ground: Ground { substrate: ridge, start: Start::Conformed }, ..cracked(20.0) },
            "ground that is not flat",
        ),
    ] {
        let sentence = format!("`strip.crack` is given beside {what}, which is not computed with an initial crack");
        assert_refused(&beside, "strip.crack", &sentence, None);
    }
}

#[test]
fn what_does_not_fit_friction() {
    let strong = Friction { strength: Some(0.05), ..Friction::NONE };
    assert_eq!(rubbing(strong).check(), Ok(()));
    let sentence = |key: &str| format!("`{key}` belongs to a contact with friction, and this one has no strength");
    let weak = rubbing(Friction { coefficient: 0.3, ..Friction::NONE });
    assert_refused(&weak, "friction.coefficient", &sentence("friction.coefficient"), Some((0.3, "")));
    let weak = rubbing(Friction { presliding: Some(0.01), ..Friction::NONE });
    assert_refused(&weak, "friction.presliding", &sentence("friction.presliding"), Some((0.01, "nm")));

    let mut cohesive = rubbing(strong);
    cohesive.adhesion.attraction = Attraction::Cohesive(CohesiveShape::Dugdale);
    assert!(matches!(refused(&cohesive).kind(), ModelErrorKind::FrictionBesideLaw { .. }));
    let ridge = Substrate::Ridge(Ridge { radius: 90.0, offset: 0.0 });
    let rough = PeelModel { friction: strong, ..on(ridge) };
    assert_eq!(refused(&rough).key(), "friction.strength");
    assert!(matches!(refused(&rough).kind(), ModelErrorKind::FrictionOffFlatGround { .. }));
    let mut stretched = rubbing(strong);
    stretched.grip = Grip { horizontal: Hold::Fixed, pretension: Some(0.5), ..Grip::FREE };
    assert_eq!(refused(&stretched).key(), "grip.pretension");
    assert!(matches!(refused(&stretched).kind(), ModelErrorKind::PretensionUnderFriction { .. }));
}

#[test]
fn what_does_not_fit_the_ground() {
    let mut blind = on(Substrate::Ridge(Ridge { radius: 90.0, offset: 0.0 }));
    assert_eq!(blind.check(), Ok(()));
    blind.adhesion.line_load = LineLoad::ForceOnly;
    let error = refused(&blind);
    assert_eq!(error.key(), "adhesion.line_load");
    assert_eq!(error.kind(), &ModelErrorKind::NoPotentialOnGround { load: "force-only" });
    let mut traction = on(Substrate::Ridge(Ridge { radius: 90.0, offset: 0.0 }));
    traction.adhesion.attraction = Attraction::SurfaceTraction;
    assert_eq!((refused(&traction).key(), refused(&traction).value()), ("adhesion.law", None));

    let fine = on(Substrate::Sinusoid(Sinusoid { height: 0.1, wavelength: 0.5, offset: 0.0 }));
    assert_eq!(refused(&fine).kind(), &ModelErrorKind::TooManyDetails { found: 200.0, most: 100.0 });
    let long = PeelModel::from(StripModel::of_the_paper(1e5, 1.0));
    let long = PeelModel { ground: on(Substrate::Ridge(Ridge { radius: 1e4, offset: 0.0 })).ground, ..long };
    assert!(matches!(refused(&long).kind(), ModelErrorKind::TooManyZones { .. }), "{}", refused(&long));
    let beside = on(Substrate::Round(Round { shape: BodyShape::Sphere, radius: 9.0, offset: 9.0 }));
    let sentence = "`substrate.offset` is 9 nm, and the strip begins beside the body, whose radius is 9 nm";
    assert_refused(&beside, "substrate.offset", sentence, None);
    let valley = Heights::new(vec![0.0, 50.0, 100.0], vec![0.0, -1.0, 0.0]).unwrap();
    assert_eq!(on(Substrate::Profile(Arc::new(valley))).check(), Ok(()));
}

/// A length of 1e300 nm took 2 GB and 40 s before it was refused.
#[test]
fn a_beam_of_too_many_process_zones_is_refused_by_the_key_of_its_longest_part() {
    assert_eq!(PeelModel::from(StripModel::of_the_paper(3e6, 1.0)).check(), Ok(()));
    for length in [1e7, 1e12, 1e30] {
        let long = PeelModel::from(StripModel::of_the_paper(length, 1.0));
        assert!(matches!(refused(&long).kind(), ModelErrorKind::TooLong { found, most: 2e6 } if *found > 0.4 * length));
        assert_eq!(refused(&long).key(), "strip.length");
    }
    let beyond = PeelModel::from(StripModel::of_the_paper(1e300, 1.0));
    assert_eq!(
        beyond.check().unwrap_err().to_string(),
        "`strip.length` is 1e300 nm, which is out of range: the largest is 1e30"
    );
}

#[test]
fn what_does_not_fit_the_drive() {
    let turning = |model: PeelModel| PeelModel { pull: Pull { turn: 0.01, ..Pull::UP }, ..model };
    let fixed = PeelModel { grip: Grip { rotation: Hold::Fixed, ..Grip::FREE }, ..strip() };
    assert_eq!(turning(fixed.clone()).check(), Ok(()));
    let sentence = "`drive.turn` is 0.01 rad/nm, and `grip.rotation` is \"free\": such a grip cannot rotate the end";
    assert_refused(&turning(strip()), "drive.turn", sentence, Some((0.01, "rad/nm")));
    let mut forced = turning(fixed.clone());
    forced.adhesion.line_load = LineLoad::ForceOnly;
    assert!(matches!(refused(&forced).kind(), ModelErrorKind::TurnWithoutPotential { .. }));

    let taking = |model: &PeelModel, steps: Vec<Step>| PeelModel { steps, ..model.clone() };
    assert_eq!(taking(&fixed, vec![Step::Turn(-0.1), Step::Hold, Step::Press(0.1)]).check(), Ok(()));
    let error = refused(&taking(&strip(), vec![Step::Hold, Step::Turn(0.1)]));
    assert_eq!(error.kind(), &ModelErrorKind::StepOfFreeGrip { step: Step::Turn(0.1), held: "rotation" });
    for step in [Step::Roll(0.1), Step::Yaw(-0.1), Step::Shift(0.1)] {
        let error = refused(&taking(&fixed, vec![step]));
        assert_eq!((error.key(), error.kind()), ("drive.steps", &ModelErrorKind::StepOutOfPlane { step }));
        let space = Space { roll: Hold::Fixed, yaw: Hold::Fixed, ..Space::default() };
        let there = PeelModel { space: Some(space), ..taking(&fixed, vec![step]) };
        assert_eq!(there.check(), Ok(()));
        assert!(there.in_the_plane().is_none(), "{step} leads out of the plane");
    }
    let free = PeelModel { space: Some(Space::default()), ..taking(&fixed, vec![Step::Roll(0.1)]) };
    let sentence =
        "`drive.steps` has the step \"roll 0.1 rad\", and `grip.roll` is \"free\": such a grip cannot rotate the end";
    assert_refused(&free, "drive.steps", sentence, None);
    for (step, wrong) in [
        (Step::Press(0.0), StepError::NotPositive),
        (Step::Drag(-1.0), StepError::NotPositive),
        (Step::Turn(0.0), StepError::NoTurn),
        (Step::Roll(0.0), StepError::NoTurn),
        (Step::Shift(0.0), StepError::NoShift),
        (Step::Yaw(f64::NAN), StepError::NotFinite),
        (Step::Lift(f64::INFINITY), StepError::NotFinite),
    ] {
        let error = refused(&taking(&fixed, vec![Step::Hold, step]));
        // NaN is not equal to itself
        let (found, wanted) = (format!("{:?}", error.kind()), ModelErrorKind::Step { number: 2, step, wrong });
        assert_eq!((error.key(), found), ("drive.steps", format!("{wanted:?}")));
    }
    let nan = refused(&taking(&fixed, vec![Step::Push(f64::NAN)]));
    assert_eq!(nan.to_string(), "`drive.steps` has as step 1 \"push NaN nm\", whose amount is not a finite number");
    let many = refused(&taking(&fixed, vec![Step::Hold; 1001]));
    assert_eq!(many.found(), "has 1001 steps, more than 1000");

    for angle in [0.0, PI] {
        let along = PeelModel { pull: Pull { angle, ..Pull::UP }, ..strip() };
        let sentence = format!(
            "`drive.angle` is {} degrees, along the strip, which is then only stretched or compressed",
            angle.to_degrees()
        );
        assert_refused(&along, "drive.angle", &sentence, Some((angle.to_degrees(), "deg")));
        let friction = Friction { strength: Some(0.05), ..Friction::NONE };
        assert_eq!(PeelModel { friction, ..along }.check(), Ok(()), "that holds it");
    }
    assert_eq!(PeelModel { pull: Pull { angle: FRAC_PI_3, ..Pull::UP }, ..strip() }.check(), Ok(()));
}

#[test]
fn what_does_not_fit_a_spatula() {
    let rounded = spatula(|s| s.tip_rounding_length = 250.0);
    let sentence = "`spatula.tip_rounding_length` is 250 nm, more than the pad is long (240 nm)";
    assert_refused(&rounded, "spatula.tip_rounding_length", sentence, Some((250.0, "nm")));
    let wide = spatula(|s| (s.tip_rounding_length, s.tip_rounding_width) = (60.0, 300.0));
    assert_eq!(refused(&wide).kind(), &ModelErrorKind::RoundingWiderThanTip { found: 300.0, tip: 200.0 });
    let bent = spatula(|s| s.bend_length = 751.0);
    assert_eq!(refused(&bent).kind(), &ModelErrorKind::BendBeyondShaft { found: 751.0, behind: 750.0 });
}

#[test]
fn orders_and_accuracies_that_there_are() {
    for (order, good) in [(0, false), (1, true), (8, true), (9, false)] {
        let how = Discretisation::moving(Form::TwoField, order);
        let accuracy = Accuracy::default().with(Choice { order: Some(order), ..Choice::NOTHING });
        assert_eq!((how.check().is_ok(), accuracy.check().is_ok()), (good, good), "{order}");
    }
    let how = Discretisation::moving(Form::TwoField, 9);
    assert_eq!(how.check().unwrap_err().to_string(), "`accuracy.order` is 9, which is out of range");
    let strip = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
    for order in [0, 9] {
        assert_eq!(strip.problem(Form::TwoField, order).err(), Some(NoSuchOrder { order }));
        let not_prepared = prepared(&strip, Discretisation { order, ..how }, None).err().unwrap();
        let sentence = format!("elements of order {order} do not exist; the order is 1 to 8");
        assert_eq!(not_prepared.to_string(), sentence);
    }
    for relative in [f64::NAN, 0.0, -1e-6, 1e-12, 0.1] {
        assert_eq!(Accuracy::to(relative).check().unwrap_err().key(), "accuracy.relative", "{relative}");
    }
    let fixing = |choice| Accuracy::default().with(choice).check().map_err(|error| error.key());
    assert_eq!(fixing(Choice { elements: Some(0), ..Choice::NOTHING }), Err("accuracy.elements"));
    assert_eq!(fixing(Choice { step: Some(0.6), ..Choice::NOTHING }), Err("accuracy.step"));
    assert_eq!(fixing(Choice::default()), Ok(()));
}
