//! Newton's iterations allocate nothing.
//!
//! Reference: the allocator, counted by `stats_alloc`.
//!
//! Parameters: the paper's strip of 100 nm on 12 elements of order 7, two-field and three-field; a point of the path near
//! the peak, solved from the point before it, once with a loose and once with a tight tolerance.
//!
//! Expected: the tight solve takes more iterations and not one allocation more. Why: what a solve allocates is its result;
//! memory asked for in the loop would show in every one of the hundreds of iterations of a peel.

#[path = "shared/strip.rs"]
mod strip;

use peelkit::model::Form;
use peelkit::solve::{NewtonOptions, Observables, Pace, Path, PathConstraint, PathOptions, Solution, Workspace, solve};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};
use std::alloc::System;
use strip::paper_strip;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// One test, because the allocator counts for all threads.
#[test]
fn iterations_allocate_nothing() {
    for form in [Form::TwoField, Form::ThreeField] {
        let problem = paper_strip(100.0, 1.0).problem(form, 7).unwrap();
        let options = PathOptions {
            elements: 12,
            step_tolerance: 1e-2,
            stride: 1.0,
            longest: None,
            prediction: 8,
            tolerance: 1e-9,
            first_displacement: 0.008,
            pace: Pace::Quick,
        };
        let points: Vec<_> = Path::new(&problem, options).take(7).collect::<Result<_, _>>().unwrap();
        let (before, after) = (&points[5], &points[6]);
        let weights = Observables::DISPLACEMENT;
        let condition = PathConstraint { weights, target: after.observables.displacement };
        let mut work = Workspace::default();
        let mut counted = |tolerance: f64| -> (Solution, usize) {
            let options = NewtonOptions { tolerance, largest_update: 0.5, most_iterations: 10, exact_slope: false };
            let start = before.at.clone();
            let region = Region::new(ALLOCATOR);
            let solution = solve(&problem, start, &condition, &options, &mut work).unwrap();
            let allocations = region.change().allocations;
            (solution, allocations)
        };
        // room for the fronts
        counted(1e-2);
        let ((loose, few), (tight, many)) = (counted(1e-2), counted(1e-11));
        assert!(tight.iterations > loose.iterations, "{} and {} iterations", loose.iterations, tight.iterations);
        assert_eq!(few, many, "{} and {} iterations", loose.iterations, tight.iterations);
    }
}
