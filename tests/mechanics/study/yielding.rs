//! Films that yield, peeled steadily.
//!
//! ```text
//!        P                M |      __--B      a section is bent up to B at the front, beyond where its surfaces
//!        |                  |   _-´   /       yield, and back in the arm: what it is bent by does not come back,
//!     ___|  arm             |  /     /        and the grip pays for it besides the work of adhesion
//!    /                      | /     /
//! ==B====  front            |/_____/____ κ
//! ```
//!
//! The strip of the paper, 10 nm high, E = 2 GPa, under an exponential law of the work and strength of the half space, slides on the ground and is pulled
//! straight up. Expected: `verification/yielding.csv`, an infinite film that is marched through its front fibre by fibre, good to 2e-4: the steady force
//! within its bound, the work that yielding leaves in a unit of area within 3 %, as it is the change over one process zone, and the stretch that stays
//! within 5 %, as it is the largest of all sections. A film that does not yield has the force of an elastic one. One that does not harden and whose axial
//! force would be more than it bears is said to flow. The effort is pinned.

use peelkit::adhesion::{Attraction, CohesiveShape};
use peelkit::beam::{Material, StretchLaw};
use peelkit::model::{Adhesion, Body, Grip, PeelModel, Pull, Strip};
use peelkit::study::{
    Accuracy, NoSensitivities, NoTest, NotOutOfPlane, Peel, StopCriteria, WarningKind, no_test, peel,
};

const TABLE: &str = include_str!("../../../verification/yielding.csv");

/// Of a yield strength and a tangent modulus, GPa.
fn film(yield_strength: f64, tangent_modulus: Option<f64>) -> PeelModel {
    let material = Material { yield_strength: Some(yield_strength), tangent_modulus, ..Material::of(2.0, 0.2) };
    let strip = Strip { length: 300.0, height: 10.0, width: 1.0, material, crack: None, layers: None };
    let law = Adhesion { attraction: Attraction::Cohesive(CohesiveShape::Exponential), ..Adhesion::default() };
    PeelModel::of(Body::Strip(strip), law, Grip::FREE)
}

/// Steady force (nN), work left in a unit of area (J/m²) and stretch that stays, of the table.
fn expected(yield_strength: f64, tangent_modulus: f64) -> [f64; 3] {
    let rows = TABLE.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
    let mut numbers = rows.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect::<Vec<f64>>());
    let row = numbers.find(|row| row[..2] == [yield_strength, tangent_modulus]).unwrap();
    [row[2], row[3], row[4]]
}

fn until(displacement: f64) -> StopCriteria {
    StopCriteria { displacement: Some(displacement), ..StopCriteria::default() }
}

fn peeled(model: &PeelModel, to: f64) -> Peel {
    peel(model, &Accuracy::to(1e-2), &until(to))
}

#[test]
fn the_steady_force_is_that_of_an_infinite_film() {
    for (yield_strength, tangent_modulus) in [(0.1, None), (0.06, Some(0.2))] {
        let [force, left, stretch] = expected(yield_strength, tangent_modulus.unwrap_or(0.0));
        let found = peeled(&film(yield_strength, tangent_modulus), 220.0);
        let plateau = found.plateau.unwrap();
        let off = (plateau.force - force).abs();
        assert!(off <= plateau.force_error.unwrap() && off < 1e-2 * force, "{plateau:?} {force}");
        let yielded = found.yielded_at(found.points.len() - 1).unwrap();
        assert!((yielded.work_per_area.unwrap() / left - 1.0).abs() < 3e-2, "{yielded:?} {left}");
        assert!((yielded.permanent_stretch / stretch - 1.0).abs() < 5e-2, "{yielded:?} {stretch}");
        assert!(yielded.axial_share < 0.2 && yielded.largest_curvature > 3.0);
        assert!(found.effort.points < 900 && found.effort.newton_iterations < 5000, "{:?}", found.effort);
    }
}

#[test]
fn a_film_that_does_not_yield_is_elastic() {
    let model = film(2.0, None);
    let found = peeled(&model, 120.0);
    let yielded = found.yielded().unwrap();
    assert!(yielded.work.abs() < 1e-9 && yielded.largest_curvature < 1.0 && yielded.length == 0.0, "{yielded:?}");
    let mut elastic = model;
    if let Body::Strip(strip) = &mut elastic.body {
        strip.material.yield_strength = None;
    }
    let expected = peel(&elastic, &Accuracy::to(1e-6), &until(120.0));
    assert_eq!(expected.yielded(), None);
    let [one, other] = [&found, &expected].map(|peel| peel.initiation_peak.unwrap());
    assert!((one.force - other.force).abs() <= one.force_error + other.force_error);
}

/// At 30 degrees Kendall's force is 0.23 nN, and the film bears 0.15 nN.
#[test]
fn a_film_that_does_not_harden_flows() {
    let mut model = film(0.015, None);
    model.pull = Pull { angle: 30f64.to_radians(), ..Pull::UP };
    let found = peel(&model, &Accuracy::to(1e-2), &until(30.0));
    let flowing = found.warnings().into_iter().find(|warning| warning.kind == WarningKind::FlowingFilm);
    assert!(flowing.is_some_and(|warning| warning.value < 1.01), "{flowing:?} {:?}", found.end);
}

#[test]
fn what_depends_on_the_past_is_refused() {
    let model = film(0.1, None);
    assert_eq!(NoSensitivities::of(&model), Some(NoSensitivities::Yielding));
    assert_eq!(no_test(&model, &Accuracy::to(1e-2)), Some(NoTest::Yielding));
    assert_eq!(NotOutOfPlane::of(&model), Some(NotOutOfPlane::Yielding));
    let refused = |change: fn(&mut PeelModel)| {
        let mut model = film(0.1, None);
        change(&mut model);
        model.check().unwrap_err().key()
    };
    assert_eq!(refused(|model| model.adhesion.attraction = Attraction::BodyForce), "strip.yield_strength");
    assert_eq!(refused(|model| model.grip.pretension = Some(0.1)), "grip.pretension");
    let material = |change: fn(&mut Material)| {
        let mut model = film(0.1, None);
        if let Body::Strip(strip) = &mut model.body {
            change(&mut strip.material);
        }
        model.check().unwrap_err().key()
    };
    assert_eq!(material(|material| material.tangent_modulus = Some(2.0)), "strip.tangent_modulus");
    let hard = |material: &mut Material| (material.yield_strength, material.tangent_modulus) = (None, Some(0.1));
    assert_eq!(material(hard), "strip.tangent_modulus");
    assert_eq!(material(|material| material.stretch = StretchLaw::NeoHookean), "strip.yield_strength");
}
