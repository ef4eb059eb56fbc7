//! A profile as a solid in space: beside a spatula of the same outline, and beside the beam of the same profile.
//!
//! Reference: the solid of a spatula, whose outline has formulas of its own; the same profile as a beam.
//!
//! ```text
//!                                  ||  shaft
//!        pad            neck    _-'|   end face: moved up, does not turn
//!   ====================----''''
//!   -----------------------------
//! ```
//!
//! Parameters: pad, neck and shaft of 60 nm each, in a bend of 45 degrees along all of the neck; a pad of 5 to 10 nm in place of one of 10 nm.
//!
//! Expected: the forces of the profile are those of the spatula to 1e-6. Why: the body is the same, and so are the stations; the slopes of width and
//! roundness are formulas of the one and differences of the other. The first peak of the wedge is within 2 % of that of the beam, whose
//! sections stay plane. Pieces whose widths do not meet are refused: no body has such an outline.

use approx::assert_relative_eq;
use peelkit::beam::Material;
use peelkit::model::{
    Adhesion, Body, Grip, Hold, PeelModel, Piece, Profile, ProfileForm, ProfilePieces, SolidSettings, Spatula,
    Transition,
};
use peelkit::study::{Accuracy, SolidOptions, SolidPeel, StationAt, StationQuantity, StopCriteria, peel, peel_solid};

const LENGTH: f64 = 60.0;

fn model(body: Body) -> PeelModel {
    let adhesion = Adhesion { far_face: false, ..Adhesion::of_half_space(0.1, 0.4) };
    PeelModel::of(body, adhesion, Grip { rotation: Hold::Fixed, ..Grip::FREE })
}

/// A pad of these heights at its ends, which narrows from one width to the other; a neck that gets round and turns up; a round shaft.
fn profile(heights: [f64; 2], widths: [f64; 2]) -> PeelModel {
    let pieces = vec![
        Piece { width: widths, height: heights, ..Piece::straight(LENGTH, 40.0, 10.0) },
        Piece {
            height: [10.0, 20.0],
            roundness: [0.0, 1.0],
            bend: 45_f64.to_radians(),
            course: Transition::Smooth,
            ..Piece::straight(LENGTH, 20.0, 10.0)
        },
        Piece { roundness: [1.0; 2], ..Piece::straight(LENGTH, 20.0, 20.0) },
    ];
    let form = ProfileForm::Pieces(ProfilePieces::new(pieces).unwrap());
    model(Body::Profile(Profile { form, material: Material::of(2.0, 0.2) }))
}

fn settings(along: f64) -> SolidSettings {
    SolidSettings { along, across: 1, ..SolidSettings::default() }
}

fn up_to(model: &PeelModel, settings: &SolidSettings, displacement: f64) -> SolidPeel {
    let events = [2.0, 4.0].map(|value| StationAt { quantity: StationQuantity::Displacement, value }.into()).to_vec();
    let stop = StopCriteria { events, ..StopCriteria::up_to(displacement) };
    let options = SolidOptions { stop, bounded: 0, ..SolidOptions::default() };
    peel_solid(model, settings, &options).unwrap()
}

#[test]
fn the_outline_of_a_spatula_gives_its_forces() {
    let spatula = Spatula {
        pad_length: LENGTH,
        neck_length: LENGTH,
        bend_length: LENGTH,
        shaft_length: LENGTH,
        tip_width: 40.0,
        neck_width: 20.0,
        shaft_diameter: 20.0,
        ..Spatula::default()
    };
    let models = [profile([10.0; 2], [40.0, 20.0]), model(Body::Spatula(spatula))];
    let [own, expected] = models.map(|model| up_to(&model, &settings(4.0), 4.5));
    assert_eq!(own.body.mesh_lines(), expected.body.mesh_lines());
    assert_eq!((own.stations.len(), expected.stations.len()), (2, 2));
    for (own, expected) in own.stations.iter().zip(&expected.stations) {
        assert_relative_eq!(own.point.force, expected.point.force, max_relative = 1e-6);
    }
}

#[test]
fn the_first_peak_of_a_wedge_is_that_of_a_beam() {
    let mut model = profile([5.0, 10.0], [40.0, 20.0]);
    let peak = up_to(&model, &settings(2.0), 23.0).peak().unwrap().clone();
    model.adhesion.far_face = true;
    let beam = peel(&model, &Accuracy::to(1e-6), &StopCriteria::up_to(24.0)).initiation_peak.unwrap();
    assert_relative_eq!(peak.force, beam.force, max_relative = 2e-2);
}

#[test]
fn what_is_no_outline_of_a_solid_is_refused() {
    let error = settings(2.0).check(&profile([10.0; 2], [40.0, 30.0])).unwrap_err();
    assert_eq!(
        (error.key(), error.to_string().as_str()),
        (
            "profile.pieces",
            "`profile.pieces` is given, and a solid in space has no jump of its width or of its roundness"
        )
    );
    let mut stiff = profile([10.0; 2], [40.0, 20.0]);
    stiff.body.material_mut().bending_stiffness_factor = 2.0;
    assert_eq!(settings(2.0).check(&stiff).unwrap_err().key(), "profile.bending_stiffness_factor");
}
