//! Long thin strips whose free end lets go under a force that is nearly zero.
//!
//! Reference: the inextensible strip. Where it is a thousand times as long as it is high, a section that turns by δθ would be stretched by
//! ½ sin θ δθ² if its height changed linearly, with a force far above that with which the edge is held.
//!
//!         grip |
//!              |  6 µm
//!              |             P = 7e-6 nN, a thousandth of that of the plateau
//!              /
//!      edge _-'  83 degrees
//!
//! Parameters: a strip 6011.645 nm long and 2.287254 nm high of 46.25387 GPa, EI × 0.08025405, under the exponential law, its grip kept from
//! turning.
//!
//! Expected: it detaches. Behind the first displacement limit point its edge turns and lifts off; with linear steps Newton's method went to and
//! fro there, between a beam under a force that it does not carry and one that carries none. The force of the plateau obeys
//! P + P²/(2 EA) = w. Why: such strips are what graphene and other thin films are.

use crate::common::{paper_strip, with_grip};
use peelkit::adhesion::CohesiveShape;
use peelkit::model::{Adhesion, Attraction, Hold};
use peelkit::study::{Accuracy, Choice, PathEnd, StopCriteria, peel};

#[test]
fn a_long_thin_strip_lets_go() {
    let mut model = paper_strip(6011.645, 8.025405e-2);
    (model.strip.height, model.strip.youngs_modulus) = (2.287254, 46.25387);
    let attraction = Attraction::Cohesive(CohesiveShape::Exponential);
    model.adhesion = Adhesion { attraction, ..Adhesion::of_half_space(0.3118671, 1.948725) };
    let model = with_grip(model, Hold::Fixed, Hold::Free);
    let accuracy = Accuracy::to(1e-6).with(Choice { elements: Some(108), ..Choice::NOTHING });
    let peel = peel(&model, &accuracy, &StopCriteria::after_points(2000));
    assert_eq!(peel.end, PathEnd::Detached, "{:?}", peel.end);
    let (work, axial) = (-model.line_law().rest_energy(), model.section().axial);
    // half-way: neither the peak nor the end of the strip is near
    let last = peel.points.last().unwrap();
    let half = peel.points.iter().find(|p| p.front < 3000.0).unwrap();
    let expected = work - half.force.powi(2) / (2.0 * axial);
    assert!((half.force / expected - 1.0).abs() < 1e-5, "{} {expected}", half.force);
    assert!(last.force.abs() < 1e-3 * half.force, "{}", last.force);
}
