//! Where a plan samples its inputs, and which plans are refused.
//!
//! Reference: Owen's theorem that a scrambled sequence is spread as evenly as the sequence itself: each of N equal parts of an input's distribution has
//! one of N points of a replicate.
//!
//!     B |  .    .        rows of a point: A, B, and A with one group from B
//!       |     .    .
//!       +-----------
//!            A
//!
//! Parameters: plans of one to four inputs. Expected: as the text of each test says. Why: estimates of indices are of no use where rows are not as said,
//! and a plan that cannot be sampled has to be refused before hours are spent on it.

use super::{correlated, input, plan};
use peelkit::study::uncertainty::{Design, Distribution, Indices, NoDesign, Plan, SamplePlace};
use std::collections::BTreeSet;

fn uniform(name: &str) -> peelkit::study::uncertainty::Input {
    input(name, Distribution::Uniform { from: 0.0, to: 1.0 })
}

#[test]
fn every_part_of_a_distribution_has_one_point_of_a_replicate() {
    let design = Design::new(plan(vec![uniform("x"), uniform("y")], 10_000, 5)).unwrap();
    let points = design.points();
    assert!(points.is_power_of_two() && design.replicates() >= 10 && design.samples() <= 10_000);
    assert_eq!(design.samples(), design.replicates() * points * 4);
    for replicate in [0, design.replicates() - 1] {
        for row in 0..4 {
            for input in 0..2 {
                let part = |point: usize| {
                    let inputs = design.inputs(SamplePlace { replicate, point, row });
                    (inputs[input] * points as f64) as usize
                };
                let parts: BTreeSet<usize> = (0..points).map(part).collect();
                assert_eq!(parts.len(), points, "replicate {replicate}, row {row}, input {input}");
            }
        }
    }
}

#[test]
fn a_row_has_the_inputs_of_its_group_from_b() {
    let inputs = vec![uniform("x"), uniform("y"), uniform("z")];
    let plan = Plan { correlations: vec![correlated([0, 2], 0.5)], ..plan(inputs, 1000, 0) };
    let design = Design::new(plan).unwrap();
    let row = |row: usize| design.inputs(SamplePlace { replicate: 3, point: 2, row });
    let (a, b, both, alone) = (row(0), row(1), row(2), row(3));
    assert_eq!([both[0], both[1], both[2]], [b[0], a[1], b[2]]);
    assert_eq!([alone[0], alone[1], alone[2]], [a[0], b[1], a[2]]);
    assert!(a.iter().zip(&b).all(|(a, b)| a != b));
}

#[test]
fn a_sample_depends_on_seed_and_place_alone() {
    let at = SamplePlace { replicate: 7, point: 3, row: 1 };
    let inputs = |samples, seed| Design::new(plan(vec![uniform("x")], samples, seed)).unwrap().inputs(at);
    assert_eq!(inputs(1000, 0), inputs(50_000, 0));
    assert_ne!(inputs(1000, 0), inputs(1000, 1));
    let design = Design::new(plan(vec![uniform("x")], 1000, 0)).unwrap();
    let places: Vec<SamplePlace> = (0..design.samples()).map(|sample| design.place(sample)).collect();
    assert!(places.is_sorted() && places.windows(2).all(|pair| pair[0] != pair[1]));
}

#[test]
fn without_indices_every_sample_is_a_point() {
    let omitted = Plan { indices: Indices::Omitted, ..plan(vec![uniform("x"), uniform("y")], 10_000, 0) };
    let design = Design::new(omitted).unwrap();
    assert_eq!((design.rows(), design.points(), design.replicates()), (1, 512, 19));
}

#[test]
fn plans_that_cannot_be_sampled_are_refused() {
    let two = || vec![uniform("x"), uniform("y")];
    let refused = |plan: Plan| Design::new(plan).unwrap_err();
    let with = |correlations| Plan { correlations, ..plan(two(), 1000, 0) };
    assert_eq!(refused(plan(Vec::new(), 1000, 0)), NoDesign::NoInputs);
    assert_eq!(refused(plan(vec![uniform("x"), uniform("x")], 1000, 0)), NoDesign::Twice { name: "x".into() });
    assert_eq!(refused(plan(two(), 159, 0)), NoDesign::TooFew { samples: 159, inputs: 2, least: 160 });
    assert!(Design::new(plan(two(), 160, 0)).is_ok());
    assert!(matches!(refused(with(vec![correlated([0, 1], 1.0)])), NoDesign::Coefficient { .. }));
    assert!(matches!(refused(with(vec![correlated([1, 1], 0.5)])), NoDesign::WithItself { .. }));
    assert_eq!(refused(with(vec![correlated([0, 2], 0.5)])), NoDesign::NoSuchInput { input: 2, last: 1 });
    let twice = vec![correlated([0, 1], 0.5), correlated([1, 0], 0.4)];
    assert!(matches!(refused(with(twice)), NoDesign::CorrelatedTwice { .. }));
    let three = vec![uniform("x"), uniform("y"), uniform("z")];
    let contradiction = vec![correlated([0, 1], 0.9), correlated([1, 2], 0.9), correlated([0, 2], -0.9)];
    assert_eq!(refused(Plan { correlations: contradiction, ..plan(three, 1000, 0) }), NoDesign::Contradiction);
    let no = vec![input("x", Distribution::Normal { mean: 1.0, deviation: -1.0 })];
    assert!(matches!(refused(plan(no, 1000, 0)), NoDesign::Distribution { .. }));
}
