//! What the backing of a tape is made of: rubber that is stretched by tens of percent, and layers of several materials.
//!
//! ```text
//!            / P, λ = 1 + Γ1(P)      upper face ______
//!   ________/ α                      layer 2     E2   |
//!  =========                         layer 1 _ _ E1 _ | _ axis, at e above the adhering face
//! ```
//!
//! The film is 5 mm by 100 µm by 20 mm, 2 MPa, under an exponential law of 10 J/m² and 50 kPa. Expected from energy alone: a film that does not slip peels at
//! P (λ - cos α) - w(λ) = Γb, one that slides at P λ - w less the same of P cos α, and what is taken off whole took Γ b L. Paths against a collocation:
//! `peel verify --only laws`. Layers of one material are a strip of that; the steady force of layers is that of their EA. The effort is pinned.

use super::steady_force::at;
use peelkit::adhesion::{Attraction, CohesiveShape};
use peelkit::analytic::{kendall_force, stretched_force};
use peelkit::beam::{Material, StretchLaw};
use peelkit::model::{
    Adhesion, Body, Grip, Laminate, Layer, ModelErrorKind, MovingMaterial, PeelModel, SolidSettings, Space, Strip,
};
use peelkit::study::{Accuracy, NotOutOfPlane, PathEnd, Peel, StopCriteria, WarningKind, peel};

const WORK: f64 = 10.0;
const WIDTH: f64 = 2e7;
const LENGTH: f64 = 5e6;
const FILM: Strip =
    Strip { length: LENGTH, height: 1e5, width: WIDTH, material: Material::of(2e-3, 0.49), crack: None, layers: None };

fn peeling(strip: Strip, work: f64, strength: f64, shear_strength: Option<f64>) -> PeelModel {
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        work: Some(work),
        strength: Some(strength),
        shear_strength,
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap();
    PeelModel::of(Body::Strip(strip), Adhesion { equilibrium_distance, ..law }, Grip::FREE)
}

fn rubber(stretch: StretchLaw, shear_strength: Option<f64>) -> PeelModel {
    let strip = Strip { material: Material { stretch, ..FILM.material }, ..FILM };
    peeling(strip, WORK, 5e-5, shear_strength)
}

fn peeled(model: &PeelModel) -> Peel {
    peel(model, &Accuracy::to(1e-6), &StopCriteria::default())
}

#[test]
fn rubber_peels_steadily_at_the_force_of_its_energy() {
    for (stretch, degrees, held) in [
        (StretchLaw::NeoHookean, 45.0, true),
        (StretchLaw::NeoHookean, 60.0, true),
        (StretchLaw::NeoHookeanWide, 45.0, true),
        (StretchLaw::NeoHookean, 90.0, false),
        (StretchLaw::NeoHookeanWide, 60.0, false),
    ] {
        let model = at(rubber(stretch, held.then_some(5e-5)), degrees);
        let expected = stretched_force(stretch, WORK * WIDTH, model.section().axial, f64::to_radians(degrees), !held);
        let derived = model.derived().section.unwrap();
        let own = if held { derived.kendall_force } else { derived.sliding_force.unwrap() };
        assert_eq!(own, expected);
        let found = peeled(&model);
        let plateau = found.plateau.unwrap();
        assert!((plateau.force / expected - 1.0).abs() < 1e-6, "{stretch:?} {degrees}: {plateau:?}, {expected}");
        // of the strains where it bends alone, which are the larger the steeper it peels
        let strains = found.warnings().into_iter().any(|warning| warning.kind == WarningKind::LargeStrain);
        assert_eq!(strains, degrees > 45.0, "{stretch:?} {degrees}");
    }
    // a linear film of the same stiffness is warned of
    let linear = peeled(&at(rubber(StretchLaw::Linear, Some(5e-5)), 45.0));
    assert!(linear.warnings().into_iter().any(|warning| warning.kind == WarningKind::LargeStrain));
}

#[test]
fn all_work_goes_into_the_interface() {
    let found = peeled(&at(rubber(StretchLaw::NeoHookean, Some(5e-5)), 45.0));
    assert_eq!(found.end, PathEnd::Detached);
    let (work, expected) = (found.points.last().unwrap().work, WORK * WIDTH * LENGTH);
    assert!((work / expected - 1.0).abs() < 1e-5, "{work:e}, {expected:e}");
    let effort = (found.effort.points, found.effort.newton_iterations, found.effort.elements);
    assert_eq!(effort, (75, 343, 44));
}

fn laminate(layers: &[Layer]) -> PeelModel {
    let strip = FILM.of_layers(Laminate::new(layers).unwrap());
    peeling(strip, 100.0, 1e-3, None)
}

#[test]
fn layers_of_one_material_are_a_strip_of_it() {
    let layer = |height| Layer { height, youngs_modulus: 2.0, poissons_ratio: 0.35 };
    let found = peeled(&laminate(&[layer(2e4), layer(3e4)]));
    let strip = Strip { height: 5e4, material: Material::of(2.0, 0.35), ..FILM };
    let expected = peeled(&peeling(strip, 100.0, 1e-3, None));
    let force = |peel: &Peel| peel.initiation_peak.as_ref().unwrap().force;
    assert!((force(&found) / force(&expected) - 1.0).abs() < 1e-11);
    assert_eq!(found.effort.points, expected.effort.points);
}

/// Polyimide on a soft adhesive, pulled straight up. Upside down it is as stiff, and its face is nearer to its axis: the attraction has a shorter arm, and
/// the peak is lower.
#[test]
fn layers_peel_by_their_stiffness_and_their_axis() {
    let layers = [
        Layer { height: 2.5e4, youngs_modulus: 2e-3, poissons_ratio: 0.49 },
        Layer { height: 2.5e4, youngs_modulus: 3.0, poissons_ratio: 0.34 },
    ];
    let up = peeled(&laminate(&layers));
    let [soft, stiff] = layers;
    let down = peeled(&laminate(&[stiff, soft]));
    let axial = layers.iter().map(|layer| layer.youngs_modulus * layer.height).sum::<f64>();
    let expected = kendall_force(100.0, axial, 1.0, WIDTH, std::f64::consts::FRAC_PI_2);
    for found in [&up, &down] {
        let plateau = found.plateau.as_ref().unwrap();
        assert!((plateau.force / expected - 1.0).abs() < 1e-5, "{plateau:?}, {expected}");
    }
    let force = |peel: &Peel| peel.initiation_peak.as_ref().unwrap().force;
    let ratio = force(&up) / force(&down);
    assert!((1.037..1.039).contains(&ratio), "{ratio}");
    let [one, other] = [&up, &down].map(|peel| peel.model.section().bending);
    assert!((one / other - 1.0).abs() < 1e-13);
}

#[test]
fn what_is_not_computed_with_them_is_refused() {
    let soft = rubber(StretchLaw::NeoHookean, None);
    let layered = laminate(&[Layer { height: 5e4, youngs_modulus: 2.0, poissons_ratio: 0.3 }]);
    for (model, key, reason) in
        [(&soft, "strip.stretch", NotOutOfPlane::Stretch), (&layered, "strip.layers", NotOutOfPlane::Layers)]
    {
        assert_eq!(NotOutOfPlane::of(model), Some(reason));
        let spatial = PeelModel { space: Some(Space::default()), ..model.clone() };
        assert_eq!(spatial.check().unwrap_err().key(), key);
        let material = MovingMaterial { density: 1300.0, ..MovingMaterial::default() };
        assert!(model.in_time(&material, 7).is_err());
        let settings = SolidSettings { along: 1e5, ..SolidSettings::default() };
        let solid = PeelModel { adhesion: Adhesion::default(), ..model.clone() };
        assert_eq!(settings.strip(&solid).err().unwrap().key(), key);
    }
    let bare = PeelModel { adhesion: Adhesion::default(), ..layered.clone() };
    assert_eq!(bare.check().unwrap_err().key(), "strip.layers");
    let mut thicker = layered;
    let Body::Strip(strip) = &mut thicker.body else { unreachable!() };
    strip.height *= 2.0;
    assert_eq!(thicker.check().unwrap_err().kind(), &ModelErrorKind::NotOfLayers);
}
