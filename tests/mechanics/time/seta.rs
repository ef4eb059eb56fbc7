//! A seta with four tips whose root is pulled at a rate: the seta of `tests/mechanics/seta/setup.rs`, of viscous material.
//!
//! References: the pull-off through equilibria, which is checked against shooting; its forces with the stiffness of slow and of fast loading bound those of
//! a standard linear solid. Expected: the limit of a slow pull; the force depends on rate times time alone; work = stored + adhesion + dissipated
//! to 1e-4; a force that does not depend on the steps.

use crate::seta::setup::{along_normal, curve, model, pulled, small};
use approx::assert_relative_eq;
use peelkit::beam::Viscosity;
use peelkit::model::{MovingMaterial, Seta, SetaMesh, SetaModel, Sideways};
use peelkit::study::{SetaInTime, SetaPullRate, SetaStart, SetaTimeAccuracy, StepEnd, TipLoss, pull_seta_in_time};

const MOST: f64 = 5000.0;

/// On fewer elements than where it is held against shooting: equilibria and motion have the same.
fn seta_of(seta: Seta) -> SetaModel {
    let mesh = SetaMesh { order: 3, elements: vec![2; seta.forks + 1] };
    SetaModel { mesh, ..model(seta, Sideways::Free) }
}

fn in_time(viscosity: Viscosity, rate: f64, accuracy: &SetaTimeAccuracy) -> SetaInTime {
    let found = with_mass(0.0, viscosity, rate, accuracy);
    for point in &found.points {
        assert!((point.force - point.tip_force).abs() < 1e-4 * found.peak().force, "{point:?}");
    }
    found
}

/// Of a density in kg/m³.
fn with_mass(density: f64, viscosity: Viscosity, rate: f64, accuracy: &SetaTimeAccuracy) -> SetaInTime {
    let material = MovingMaterial { density, viscosity, opening: None };
    let model = seta_of(small());
    let found = pull_seta_in_time(&model, &material, &SetaPullRate::normal(MOST, rate), accuracy, None);
    let found = found.unwrap_or_else(|failed| panic!("{}", failed.why));
    assert_eq!(found.last().attached, 0);
    assert!(found.balance_error() < 1e-4, "{viscosity:?}: {:.2e} of the work", found.balance_error());
    found
}

/// Little mass changes the force little, more mass holds the root back, and what is dissipated, stored and in motion is the work.
#[test]
fn mass_adds_to_the_force_of_the_root() {
    let usual = SetaTimeAccuracy::default();
    let rate = 3.0;
    let found = [0.0, 1.0, 1300.0].map(|density| with_mass(density, kelvin_voigt(1e2), rate, &usual));
    let forces = found.each_ref().map(|found| found.peak().force);
    let kinetic = found[2].points.iter().map(|point| point.balance.kinetic).fold(0.0, f64::max);
    println!("{forces:?} nN, {kinetic} aJ in motion, {:?} points", found.each_ref().map(|found| found.points.len()));
    assert_relative_eq!(forces[1], forces[0], max_relative = 1e-3);
    assert!(forces[2] > forces[0] && kinetic > 0.0);
    assert_eq!(found[2].events.len(), found[0].events.len());
}

fn kelvin_voigt(retardation_time: f64) -> Viscosity {
    Viscosity::KelvinVoigt { retardation_time }
}

/// The largest force of the equilibria, with a modulus times so much.
fn equilibria(factor: f64) -> f64 {
    let mut seta: Seta = small();
    seta.material.youngs_modulus *= factor;
    let whole = pulled(&seta_of(seta), SetaStart::Adhering, &[along_normal(1.0, StepEnd::Detached(MOST))]);
    whole.peak.unwrap().point.force_along
}

#[test]
fn a_slow_pull_goes_through_equilibria() {
    let slow = equilibria(1.0);
    let usual = SetaTimeAccuracy::default();
    let elastic = in_time(Viscosity::Elastic, 1.0, &usual);
    assert_relative_eq!(elastic.peak().force, slow, max_relative = 1e-4);
    assert!(elastic.events.iter().any(|event| event.loss == TipLoss::Unstable));
    // what viscosity adds goes with the rate
    let added = |way: f64| in_time(kelvin_voigt(1e3), way / 1e3, &usual).peak().force / slow - 1.0;
    let [a, b] = [0.3, 0.03].map(added);
    assert!(a > 0.0 && b > 0.0 && b < 0.5 * a && b < 2e-3, "{a:e}, {b:e}");
}

#[test]
fn the_force_depends_on_rate_times_time() {
    let usual = SetaTimeAccuracy::default();
    for length in [30.0, 1000.0] {
        let [a, b] = [1e3, 1e5].map(|time| in_time(kelvin_voigt(time), length / time, &usual));
        assert_relative_eq!(a.peak().force, b.peak().force, max_relative = 1e-8);
        assert_eq!(a.events.len(), b.events.len());
    }
}

/// A tree that has no time to yield: each tip goes up by the displacement from where it is at rest.
#[test]
fn a_fast_pull_moves_the_seta_as_a_rigid_body() {
    let seta = seta_of(small());
    let rest = pulled(&seta, SetaStart::Adhering, &[along_normal(1.0, StepEnd::Travel(1e-6))]).last.unwrap();
    let heights: Vec<f64> = (0..4).map(|tip| rest.joints[seta.seta.tip_joint(tip)].place[1]).collect();
    let curve = curve();
    let of = |u: f64| {
        let force = |height: &f64| if u + height < curve.snap_off() { curve.force(u + height).0 } else { 0.0 };
        heights.iter().map(force).sum::<f64>()
    };
    let wanted = (0..8000).map(|k| of(0.05 * f64::from(k))).fold(0.0, f64::max);
    let found = in_time(kelvin_voigt(1e3), 1e4, &SetaTimeAccuracy::default());
    assert_relative_eq!(found.peak().force, wanted, max_relative = 1e-3);
}

#[test]
fn a_standard_linear_solid_lies_between_slow_and_fast_loading() {
    let [slow, fast] = [1.0, 2.0].map(equilibria);
    let solid = Viscosity::StandardLinearSolid { relaxation_time: 1e3, stiffness_ratio: 2.0 };
    let usual = SetaTimeAccuracy::default();
    let forces = [1e-5, 3e-2, 1e2].map(|rate| in_time(solid, rate, &usual).peak().force);
    assert_relative_eq!(forces[0], slow, max_relative = 1e-4);
    // but for the tips' heights, which the seta at rest has yielded to at the modulus of slow loading
    assert_relative_eq!(forces[2], fast, max_relative = 5e-3);
    assert!(forces[0] <= forces[1] * (1.0 + 1e-6) && forces[1] <= forces[2] * (1.0 + 1e-6), "{forces:?}");
}

#[test]
fn the_force_does_not_depend_on_the_steps() {
    let force = |tolerance: f64| {
        let accuracy = SetaTimeAccuracy { tolerance, ..SetaTimeAccuracy::default() };
        let found = in_time(kelvin_voigt(1e3), 0.1, &accuracy);
        (found.peak().force, found.points.len())
    };
    let [(coarse, few), (usual, _), (fine, many)] = [3e-5, 1e-5, 1e-6].map(force);
    assert!(many > few);
    assert_relative_eq!(usual, fine, max_relative = 1e-4);
    assert_relative_eq!(coarse, fine, max_relative = 3e-4);
}

#[test]
fn what_is_not_followed_is_refused_by_name() {
    let model = seta_of(small());
    let refused = |density: f64, pull: SetaPullRate| {
        let material = MovingMaterial { density, viscosity: kelvin_voigt(1e3), opening: None };
        pull_seta_in_time(&model, &material, &pull, &SetaTimeAccuracy::default(), None).unwrap_err().why.to_string()
    };
    let pull = SetaPullRate::normal(MOST, 1.0);
    assert!(refused(-1.0, pull).contains("the density in kg/m³ is -1"));
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(refused(0.0, SetaPullRate { rate: wrong, ..pull }).contains("the rate of the pull in nm/ns is"));
        assert!(
            refused(0.0, SetaPullRate { direction: [0.0, wrong.min(0.0) * 0.0, 0.0], ..pull }).contains("direction")
        );
    }
}
