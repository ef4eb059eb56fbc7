//! A spatula as a solid in space: its volume, its tangent, its forces as slopes of its energy, and what is refused.

use approx::assert_relative_eq;
use peelkit::beam::BeamGeometry;
use peelkit::model::{FineZone, Hold, PeelModel, SolidSpatulaError, SolidSpatulaSettings, Spatula};
use peelkit::number::gauss::gauss_legendre;
use peelkit::solid::spatula::SolidSpatula;
use peelkit::solve::{Coefficients, INTERFACE, State, System, Workspace};
use peelkit::study::SolidPull;
use std::num::NonZeroUsize;
use std::sync::Arc;

const COARSE: SolidSpatulaSettings =
    SolidSpatulaSettings { pad: 12.0, neck: 10.0, shaft: 150.0, fine: None, across: 1 };

fn model() -> PeelModel {
    let mut model = Spatula::default().model();
    model.grip.rotation = Hold::Fixed;
    model.adhesion.far_face = false;
    model
}

fn coarse() -> Arc<SolidSpatula> {
    Arc::new(COARSE.spatula(&model()).unwrap())
}

/// ∫ A dS with the area of the blended section, which has no closed form: b h/2 ∫∫ det ∂(ζ', t')/∂(ζ, t). Three points through the thickness
/// integrate the root in it to 4e-4, twice: the volume is that to 8e-4.
#[test]
fn its_volume_is_that_of_its_outline() {
    let (outline, rule) = (Spatula::default(), gauss_legendre(NonZeroUsize::new(24).unwrap()));
    let area = |place: f64| {
        let section = outline.at(place);
        let q = section.roundness;
        let share = |other: f64| {
            let root = (1.0 - 0.5 * other * other).sqrt();
            (1.0 + q * (root - 1.0), -0.5 * q * other / root)
        };
        let mut sum = 0.0;
        for &(zeta, w) in &rule {
            for &(t, v) in &rule {
                let t = 0.5 * (1.0 + t);
                let ((a, a1), (b, b1)) = (share(t), share(zeta));
                sum += 0.5 * w * v * (a * b - zeta * a1 * t * b1);
            }
        }
        0.5 * section.width * section.height[0] * sum
    };
    let mut expected = 0.0;
    for ends in [0.0, 240.0, 290.0, 390.0, 990.0].windows(2) {
        let half = 0.5 * (ends[1] - ends[0]);
        expected += rule.iter().map(|&(x, w)| half * w * area(ends[0] + half * (1.0 + x))).sum::<f64>();
    }
    let fine = SolidSpatulaSettings { across: 2, ..COARSE }.spatula(&model()).unwrap();
    for spatula in [coarse(), Arc::new(fine)] {
        assert_relative_eq!(spatula.volume(), expected, max_relative = 1e-3);
    }
}

/// K⁻¹ of a difference of residuals along a direction gives the direction back, and P is the slope of the energy.
#[test]
fn the_eliminated_tangent_is_the_slope_of_the_residual() {
    let spatula = coarse();
    let pull = SolidPull::new(spatula.clone(), None).unwrap();
    let (at, n) = (pull.state(), spatula.unknowns());
    let direction: Vec<f64> =
        spatula.per_unit(at).iter().enumerate().map(|(k, unit)| ((k * k) as f64).sin() / (unit + 0.1)).collect();
    let moved = |factor: f64| {
        let mut moved = at.clone();
        spatula.retract(&mut moved, &direction, factor);
        moved
    };
    let d = 1e-5;
    let states = [-2.0 * d, -d, d, 2.0 * d].map(moved);
    let [a, b, c, e] = states.each_ref().map(|state| spatula.residual(state));
    let mut right: Vec<f64> = (0..n).map(|k| (8.0 * (c[k] - b[k]) - (e[k] - a[k])) / (12.0 * d)).collect();
    let mut ws = Workspace::default();
    let root = spatula.factorise(at, Coefficients::STATIC, [0.0; 2], &mut ws).unwrap();
    assert_eq!(root.negative, 0);
    let reduced = spatula.reduce(&ws, &mut right, false);
    let mut interface = [0.0; INTERFACE];
    interface[0] = reduced[0] / root.matrix[0][0];
    spatula.substitute(&ws, &interface, &mut right, false);
    let largest = direction.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let missed = right.iter().zip(&direction).fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()));
    assert!(missed < 1e-5 * largest, "{missed} of {largest}");
    // the energy's slope along the direction is the residual's work
    let energy = |state: &State| spatula.evaluate(state, &direction).0.energy;
    let [a, b, c, e] = states.each_ref().map(energy);
    let work: f64 = spatula.residual(at).iter().zip(&direction).map(|(force, by)| force * by).sum();
    assert_relative_eq!((8.0 * (c - b) - (e - a)) / (12.0 * d), work, epsilon = 1e-5, max_relative = 1e-5);
}

/// P du is the change of energy where nothing jumps, and another mesh of stations begins at the same place.
#[test]
fn work_is_the_change_of_energy() {
    let spatula = coarse();
    let mut pull = SolidPull::new(spatula, None).unwrap();
    let rest = *pull.here();
    assert!(rest.force > 0.0 && rest.jumped);
    let next = *pull.to(0.1, 0.1).unwrap();
    assert!(!next.jumped);
    // Hermite's cubic between the two
    let work = 0.05 * (rest.force + next.force) + 0.01 / 12.0 * (rest.slope - next.slope);
    assert_relative_eq!(next.energy - rest.energy, work, max_relative = 1e-6);
    let finer = SolidSpatulaSettings { fine: Some(FineZone { from: 192.0, to: 240.0, along: 6.0 }), ..COARSE };
    let finer = Arc::new(finer.spatula(&model()).unwrap());
    let on = pull.on(finer).unwrap();
    assert_eq!(on.here().displacement, next.displacement);
    assert!(on.here().energy < next.energy);
}

#[test]
fn what_a_solid_spatula_does_not_have_is_refused() {
    let error = |settings: SolidSpatulaSettings, change: fn(&mut PeelModel)| {
        let mut model = model();
        change(&mut model);
        settings.spatula(&model).unwrap_err()
    };
    let found = error(SolidSpatulaSettings { pad: -1.0, ..COARSE }, |_| {});
    assert_eq!(
        (found.key().as_str(), found.to_string().as_str()),
        ("solid.pad", "`solid.pad` is -1 nm, which is not above zero")
    );
    let zone = FineZone { from: 60.0, to: 300.0, along: 1.0 };
    assert_eq!(error(SolidSpatulaSettings { fine: Some(zone), ..COARSE }, |_| {}).key(), "solid.fine");
    let found = error(COARSE, |model| model.grip.rotation = Hold::Free);
    assert!(matches!(found, SolidSpatulaError::NotOfSolid { key: "grip.rotation", .. }));
    assert_eq!(error(COARSE, |model| model.adhesion.far_face = true).key(), "adhesion.far_face");
    assert!(!found.remedy().is_empty());
}
