//! What a model cannot be trusted with is said with numbers, and changes none.
//!
//! Reference: the definitions, by hand.
//!
//! Parameters: the paper's strip, 100 nm long and 10 nm high; shorter, softer in bending, on waves.
//!
//! Expected: each warning where its number is beyond its limit and nowhere else. Why: a number without them looks as good as any other.

use crate::common::paper_strip;
use peelkit::adhesion::{Sinusoid, Substrate};
use peelkit::beam::SpatialSectionState;
use peelkit::model::{Ground, PeelModel, Space, Start};
use peelkit::study::{Accuracy, Peel, StopCriteria, Warning, WarningKind, peel};

fn peeled(model: &PeelModel) -> Peel {
    peel(model, &Accuracy::to(1e-4), &StopCriteria { displacement: Some(20.0), ..StopCriteria::after_points(400) })
}

fn found(peel: &Peel, kind: WarningKind) -> Option<Warning> {
    peel.warnings().into_iter().find(|warning| warning.kind == kind)
}

#[test]
fn a_short_process_zone_and_a_short_beam_are_told() {
    let model = PeelModel::from(paper_strip(100.0, 1.0));
    let peel = peeled(&model);
    let zone = found(&peel, WarningKind::ShortProcessZone).expect("2 nm of 10");
    assert_eq!((zone.value, zone.limit), (model.process_length() / 10.0, 1.0));
    assert!(zone.to_string().contains("rigid"), "{zone}");
    assert!(found(&peel, WarningKind::ShortBeam).is_none() && found(&peel, WarningKind::RelaxedStart).is_none());
    let block = peeled(&paper_strip(40.0, 1.0).into());
    assert_eq!(found(&block, WarningKind::ShortBeam).map(|warning| (warning.value, warning.limit)), Some((4.0, 5.0)));
    // bending and shear alone make it longer than 10 nm
    let mut stiff = paper_strip(1000.0, 1e3);
    stiff.strip.material.youngs_modulus = 200.0;
    assert!(found(&peeled(&stiff.into()), WarningKind::ShortProcessZone).is_none());
}

/// The first integral bounds ½EI κ² by the work of adhesion: κ h/2 grows with EI^(-1/2).
#[test]
fn an_outline_that_folds_and_large_strains_are_told() {
    let stiff = peeled(&paper_strip(1000.0, 1e3).into());
    assert!(found(&stiff, WarningKind::FoldedOutline).is_none() && found(&stiff, WarningKind::LargeStrain).is_none());
    let soft = peeled(&paper_strip(100.0, 1e-4).into());
    let folded = found(&soft, WarningKind::FoldedOutline).expect("|κ| h/2 of a soft strip");
    let largest = (0..soft.points.len()).flat_map(|index| soft.sections(index));
    let largest = largest.map(|node| node.section.curvature.abs() * 5.0).fold(0.0, f64::max);
    // at the point where neighbouring nodes turn most against each other: that is nearly where the curvature is largest
    assert!(folded.value <= largest && folded.value > 0.99 * largest, "{} {largest}", folded.value);
    assert!(found(&soft, WarningKind::LargeStrain).is_some_and(|warning| warning.value >= folded.value));
    assert!(found(&soft.without_solutions(), WarningKind::FoldedOutline).is_none());
}

#[test]
fn ground_higher_than_r0_is_told() {
    let on = |height: f64| {
        let substrate = Substrate::Sinusoid(Sinusoid { height, wavelength: 100.0, offset: 0.0 });
        let ground = Ground { substrate, start: Start::Conformed };
        let model = PeelModel { ground, ..paper_strip(100.0, 10.0).into() };
        peel(&model, &Accuracy::to(1e-3), &StopCriteria::after_points(3))
    };
    assert!(found(&on(0.2), WarningKind::HighGround).is_none());
    let high = found(&on(0.8), WarningKind::HighGround).expect("two r0");
    assert!((high.value - 2.0).abs() < 1e-12 && high.limit == 1.0, "{high}");
}

/// A strip of the same material in space.
fn in_space(width: f64, youngs_modulus: f64, [elevation, azimuth]: [f64; 2]) -> PeelModel {
    let mut strip = paper_strip(100.0, 1.0);
    (strip.strip.width, strip.strip.material.youngs_modulus) = (width, youngs_modulus);
    (strip.strip.material.poissons_ratio, strip.strip.material.shear_correction) = (0.0, 1.0);
    let mut model = PeelModel::from(strip);
    model.pull.angle = elevation.to_radians();
    model.space = Some(Space { azimuth: azimuth.to_radians(), ..Space::default() });
    model
}

/// The largest |κ2| h/2, |κ3| b/2 and strain of the corners at all ends of elements of all points of a path.
fn largest_in_space(peel: &Peel) -> [f64; 3] {
    let sections = (0..peel.points.len()).flat_map(|index| peel.sections_in_space(index));
    let one = |at: SpatialSectionState| {
        let [bent, sideways] =
            [at.curvature[1].abs() * 0.5 * at.section.height, at.curvature[2].abs() * 0.5 * at.section.width];
        [bent, sideways, at.stretch[0].abs() + bent + sideways]
    };
    sections.map(one).fold([0.0; 3], |a, b| std::array::from_fn(|i| f64::max(a[i], b[i])))
}

/// Pulled sideways at 40 degrees, a soft strip bends about its height by more than the width allows.
#[test]
fn what_a_strip_in_space_folds_and_strains_by_is_told() {
    let whole = |model: &PeelModel| peel(model, &Accuracy::to(1e-4), &StopCriteria::after_points(5000));
    let soft = whole(&in_space(5.0, 0.007, [40.0, 90.0]));
    let [_, sideways, strain] = largest_in_space(&soft);
    let folded = found(&soft, WarningKind::FoldedSideways).expect("|κ3| b/2 of a soft strip");
    assert!(folded.value <= sideways && folded.value > 0.99 * sideways, "{} {sideways}", folded.value);
    let strained = found(&soft, WarningKind::LargeStrain).expect("the same bending");
    assert!(strained.value <= strain && strained.value > 0.99 * strain, "{} {strain}", strained.value);
    assert!(found(&soft, WarningKind::FoldedOutline).is_none());
    assert!(found(&soft, WarningKind::ShortProcessZone).is_some() && found(&soft, WarningKind::ShortBeam).is_none());
    assert!(found(&soft.without_solutions(), WarningKind::FoldedSideways).is_none());
}
