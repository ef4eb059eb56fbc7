//! Models and results as JSON.
//!
//! Expected: what is written is read again the same to the last bit, whatever the body, the law, the ground and the grip; what no
//! model may be is refused when it is read. Why: a result is to be computed again from what was kept of it.

use peelkit::adhesion::{
    BodyShape, CohesiveShape, Heights, LineLoad, LineResponse, OwnLaw, Ridge, Round, SectionLaw, SelfAffine, Sinusoid,
    Substrate, TiltedSection,
};
use peelkit::beam::{MeshKind, ReferenceCurve, Section};
use peelkit::model::{
    Adhesion, Attraction, Body, Discretisation, Drive, Form, Friction, Grip, Ground, Hold, PeelModel, Piece, Profile,
    ProfileColumns, ProfileForm, ProfilePieces, ProfileTable, Pull, RodModel, Spatula, Start, Step, StripModel,
    Support, Transition,
};
use peelkit::study::{Accuracy, Choice, Peel, StopCriteria, Terms, peel};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;
use std::sync::Arc;

/// Writes and reads; the same to the last bit, which is what `Debug` shows of a number.
fn round_trip<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) -> String {
    let text = serde_json::to_string(value).unwrap();
    let read: T = serde_json::from_str(&text).unwrap();
    assert_eq!(&read, value);
    assert_eq!(format!("{read:?}"), format!("{value:?}"));
    text
}

fn refused<T: DeserializeOwned + Debug>(text: &str) -> String {
    serde_json::from_str::<T>(text).unwrap_err().to_string()
}

fn strip() -> PeelModel {
    StripModel::of_the_paper(100.0 / 3.0, 0.1).into()
}

fn profile(form: ProfileForm) -> PeelModel {
    PeelModel { body: Body::Profile(Profile { form, material: Spatula::default().material }), ..strip() }
}

#[test]
fn every_body_is_read_as_it_was_written() {
    round_trip(&strip());
    round_trip(&StripModel::of_the_paper(0.1 + 0.2, 1e-4));
    round_trip(&Spatula { shaft_angle: 0.1f64.sin(), ..Spatula::default() }.model());
    let bent = Piece {
        width: [20.0, 7.0 / 3.0],
        roundness: [0.0, 1.0],
        bend: -1.0 / 7.0,
        course: Transition::Smooth,
        ..Piece::straight(1e2 / 3.0, 20.0, 5.0)
    };
    let pieces = ProfilePieces::new(vec![Piece::straight(40.0, 20.0, 5.0), bent]).unwrap();
    round_trip(&profile(ProfileForm::Pieces(pieces)));
    for turned in [0.0, 0.1, 29.9, 180.0, -180.0] {
        let table = ProfileTable::new(ProfileColumns {
            places: vec![0.0, 40.0 / 3.0, 100.0, 110.0],
            widths: vec![20.0, 20.0, 1.0 / 3.0, 1.0],
            heights: vec![5.0, 5.1, 0.7, 10.0],
            angles: vec![0.0, 0.0, turned, turned],
            roundness: vec![0.0, 0.1, 0.3, 1.0],
        });
        round_trip(&profile(ProfileForm::Table(table.unwrap())));
    }
    let table =
        ProfileColumns { places: vec![0.0, 9.0], widths: vec![1.0; 2], heights: vec![2.0; 2], ..Default::default() };
    round_trip(&profile(ProfileForm::Table(ProfileTable::new(table).unwrap())));
}

#[test]
fn every_ground_and_every_law_is_read_as_it_was_written() {
    let rough = SelfAffine { hurst: 0.8, roughness: 2.0, longest: 200.0, shortest: 20.0, length: 400.0, seed: 7 };
    round_trip(&rough);
    let offset = -0.1 * 3.0;
    for substrate in [
        Substrate::Flat,
        Substrate::Round(Round { shape: BodyShape::Sphere, radius: 1e13 / 3.0, offset }),
        Substrate::Round(Round { shape: BodyShape::Cylinder, radius: 200.0, offset }),
        Substrate::Sinusoid(Sinusoid { height: 8.0, wavelength: 1e2 / 3.0, offset }),
        Substrate::Ridge(Ridge { radius: 90.0, offset }),
        Substrate::Profile(Arc::new(rough.heights().unwrap())),
        Substrate::Profile(Arc::new(Heights::level())),
    ] {
        for start in [Start::Conformed, Start::Crests] {
            round_trip(&PeelModel { ground: Ground { substrate: substrate.clone(), start }, ..strip() });
        }
    }
    for attraction in Attraction::all() {
        let text = round_trip(&Adhesion { attraction, ..Adhesion::default() });
        assert!(text.contains(&format!("\"{}\"", attraction.name())), "{text}");
    }
    let cohesive = Attraction::Cohesive(CohesiveShape::Bilinear);
    for line_load in [LineLoad::Full, LineLoad::ForceOnly, LineLoad::AxisGap] {
        let (work, strength) = (Some(0.02 / 3.0), Some(0.1));
        round_trip(&Adhesion {
            attraction: cohesive,
            work,
            strength,
            line_load,
            far_face: false,
            ..Adhesion::default()
        });
    }
}

#[test]
fn grips_drives_and_choices_are_read_as_they_were_written() {
    let grip =
        Grip { rotation: Hold::Fixed, horizontal: Hold::Fixed, stiffness: Some(0.1 / 3.0), pretension: Some(0.3) };
    let steps = vec![Step::Press(0.1), Step::Lift(0.2), Step::Drag(0.3), Step::Push(0.7), Step::Turn(-0.1), Step::Hold];
    let out = [Step::Shift(-0.3), Step::Roll(0.1), Step::Yaw(0.2), Step::Release];
    let steps = [steps, out.to_vec()].concat();
    let friction = Friction { strength: Some(0.05), coefficient: 0.1 * 3.0, presliding: Some(1e-3) };
    round_trip(&PeelModel { grip, steps, friction, pull: Pull { angle: 1.0 / 3.0, turn: 1e-17 }, ..strip() });
    round_trip(&Accuracy::default());
    let choice = Choice {
        order: Some(5),
        elements: Some(30),
        step: Some(0.05),
        mesh: MeshKind::Uniform,
        form: Form::ThreeField,
    };
    round_trip(&Accuracy { terms: Terms::Auto, ..Accuracy::to(1e-9 / 3.0).with(choice) });
    round_trip(&Discretisation::moving(Form::TwoField, 7).on(MeshKind::Graded));
    round_trip(&RodModel {
        length: 10.0 / 3.0,
        section: Section { axial: 1e3, shear: 1e3, bending: 0.1 },
        rest: ReferenceCurve { start: [0.1, 0.2, 0.3], curvature: [1e-3, 1e-5, 1e-7] },
        left: Support::CLAMPED,
        right: Support::FREE,
        drive: Drive::Rotation,
    });
}

/// A law that nobody can look up.
#[derive(Debug)]
struct Mine;

impl SectionLaw for Mine {
    fn name(&self) -> &'static str {
        "mine"
    }

    fn response(&self, section: &TiltedSection) -> LineResponse<f64> {
        section.face_load(|r| [-(-r).exp(), -(-r).exp(), (-r).exp()])
    }

    fn cutoff_distance(&self) -> f64 {
        10.0
    }

    fn rest_gap(&self, _height: f64) -> f64 {
        0.3
    }
}

#[test]
fn a_law_of_the_users_own_is_refused() {
    let mut model = strip();
    model.adhesion.attraction = Attraction::Own(OwnLaw::of(&Mine));
    let error = serde_json::to_string(&model).unwrap_err().to_string();
    assert!(error.contains("\"mine\" is the user's own, which cannot be written"), "{error}");
    let error = refused::<Attraction>("\"mine\"");
    assert!(error.contains("there is no law of adhesion \"mine\"; it is \"body-force\" or"), "{error}");
}

/// What a table or a list cannot be when it is built it cannot be when it is read.
#[test]
fn what_no_model_may_be_is_refused_when_it_is_read() {
    let table = |places: &str, angle: &str| {
        format!(r#"{{"places":{places},"widths":[1,1],"heights":[1,1],"angles_rad":[0,{angle}],"roundness":[0,0]}}"#)
    };
    assert!(serde_json::from_str::<ProfileTable>(&table("[0,5]", "3.14")).is_ok());
    assert!(refused::<ProfileTable>(&table("[0,0]", "0")).contains("has in row 2 `s_nm` = 0, which does not ascend"));
    assert!(refused::<ProfileTable>(&table("[0,5]", "3.2")).contains("`angle_deg` = 183."));
    assert!(refused::<ProfilePieces>("[]").contains("has 0 pieces; it takes 1 to 200"));
    assert!(refused::<Heights>(r#"{"places":[0,1],"heights":[0,0]}"#).contains("has 2 rows; it takes 3 to 20000"));
    // NaN, as JSON has it
    let unknown = serde_json::to_string(&PeelModel::from(StripModel::of_the_paper(f64::NAN, 1.0))).unwrap();
    assert!(refused::<PeelModel>(&unknown).contains("invalid type: null"));
}

/// A whole result but for the solutions behind its points, and the model in it.
#[test]
fn a_result_is_read_as_it_was_written() {
    for (model, terms, points) in [
        (strip(), Terms::Auto, 5000),
        (Spatula::default().model(), Terms::All, 6),
        (PeelModel { steps: vec![Step::Lift(0.1)], ..strip() }, Terms::All, 5),
    ] {
        let bounds = StopCriteria::after_points(points);
        let found = peel(&model, &Accuracy { terms, ..Accuracy::to(1e-4) }, &bounds).without_solutions();
        let text = serde_json::to_string(&found).unwrap();
        let read: Peel = serde_json::from_str(&text).unwrap();
        assert_eq!(format!("{read:?}"), format!("{found:?}"));
        assert_eq!(read.model, found.model);
        assert!(!read.points.is_empty());
    }
}
