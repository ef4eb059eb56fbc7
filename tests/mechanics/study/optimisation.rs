//! The best design: of one number against a scan, of a profile against its conditions, by three methods.
//!
//!      W |      .-o-.          o  the optimum, from derivatives at a few designs
//!        |   .-'     '-.       .  a scan of 200 peels
//!        | .'           '.
//!        |/_______________\_ ln EI
//!
//! Reference: a scan of 200 peels, of which a polynomial of the fourth degree through the highest 41 has its maximum at the place and with the value that are
//! expected; COBYLA, which knows no derivative; the conditions of Karush, Kuhn and Tucker.
//! Parameters: the strip of the paper 100 nm long, whose EI alone is free, from a thousandth to a thousand times that of its section: beyond 40 times it has
//! no first jump. Strips 10 nm wide and 5 nm high, whose width is free between 5 and 20 nm at equal volume, pulled at several angles.
//! Expected: peeling work is largest at an intermediate stiffness, place and value as in the scan to 1e-4; all methods find it, and designs without a jump do not
//! stop them. The best profile beats the uniform strip at 30, 60, 90 and 120 degrees, has its volume, keeps its bounds and slopes, and what the constraints leave
//! of the gradient is zero. One thread or several, at once or resumed, the result is the same to the last bit.
//! Why: an optimum that only its own search confirms is none.

use crate::common::paper_strip;
use peelkit::model::{Body, PeelModel};
use peelkit::study::optimisation::{
    ConstraintKind, DesignConstraint, DesignFound, DesignNumber, DesignProblem, DesignVariable, Evaluation, Goal,
    NoOptimum, NumberBy, Objective, OptimisationOptions, Optimum, ProfileColumn, ProfileDesign, SearchEnd,
    SearchMethod, optimise, volume,
};
use peelkit::study::{Accuracy, PeelQuantity, StopCriteria, peel, sweep};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

const WORK: Objective = Objective::Quantity(PeelQuantity::FirstJumpWork);
const PEAK: Objective = Objective::Quantity(PeelQuantity::InitiationPeakForce);

fn stiffened(factor: f64) -> PeelModel {
    paper_strip(100.0, factor).into()
}

/// Work up to the first jump over EI.
fn stiffness(lower: f64, upper: f64) -> DesignProblem<'static> {
    DesignProblem {
        objective: WORK,
        goal: Goal::Maximise,
        variables: vec![DesignVariable::new("strip.bending_stiffness_factor", lower, upper)],
        constraints: Vec::new(),
        model: Box::new(|values| Some(stiffened(values[0]))),
        number: NumberBy::Peel,
        start: vec![1.0],
    }
}

/// A strip 10 nm wide and 5 nm high.
fn strip(angle: f64) -> PeelModel {
    let mut model: PeelModel = paper_strip(100.0, 1.0).into();
    if let Body::Strip(strip) = &mut model.body {
        (strip.width, strip.height) = (10.0, 5.0);
    }
    model.pull.angle = angle.to_radians();
    model
}

/// The width along that strip, from 5 to 20 nm, at equal volume and with no slope above 0.2.
fn width(values: usize, angle: f64) -> DesignProblem<'static> {
    let model = strip(angle);
    let design = ProfileDesign::of(&model, values).unwrap();
    let (given, start) = (volume(&model), design.values(ProfileColumn::Width).to_vec());
    let variables = design.variables(ProfileColumn::Width, 5.0, 20.0);
    let mut constraints = design.smoothness(ProfileColumn::Width, 0, 0.2, 10.0);
    let shaped = move |values: &[f64]| design.shaped(&model, &[(ProfileColumn::Width, values)]);
    let of_volume = shaped.clone();
    constraints.push(DesignConstraint {
        name: "volume".into(),
        kind: ConstraintKind::Equal,
        function: Box::new(move |values| of_volume(values).map_or(f64::NAN, |model| (volume(&model) / given).ln())),
    });
    let model = Box::new(shaped);
    DesignProblem {
        objective: PEAK,
        goal: Goal::Maximise,
        variables,
        constraints,
        model,
        number: NumberBy::Peel,
        start,
    }
}

fn options<'o>() -> OptimisationOptions<'o> {
    OptimisationOptions { starts: 1, neighbours: 10, ..OptimisationOptions::to(Accuracy::to(1e-6)) }
}

/// Place and value of the maximum of the scan, in ln EI.
fn of_scan() -> (f64, f64) {
    let [from, to] = [0.1f64.ln(), 5.0f64.ln()];
    let places: Vec<f64> = (0..200).map(|k| from + (to - from) * f64::from(k) / 199.0).collect();
    let work = |&place: &f64| {
        let peel = peel(&stiffened(place.exp()), &Accuracy::to(1e-8), &StopCriteria::default());
        peel.snap_off.map_or(f64::NAN, |jump| jump.work)
    };
    let works = sweep(&places, &|| true, &work);
    let top = (0..works.len()).max_by(|&a, &b| works[a].total_cmp(&works[b])).unwrap();
    let near = top - 20..=top + 20;
    // least squares in a coordinate around the top, by the normal equations
    let scale = 20.0 * (places[1] - places[0]);
    let rows: Vec<[f64; 5]> = near
        .clone()
        .map(|k| {
            let x = (places[k] - places[top]) / scale;
            [1.0, x, x * x, x.powi(3), x.powi(4)]
        })
        .collect();
    let matrix = nalgebra::DMatrix::from_fn(rows.len(), 5, |row, column| rows[row][column]);
    let right = nalgebra::DVector::from_iterator(rows.len(), near.map(|k| works[k]));
    let c = matrix.svd(true, true).solve(&right, 1e-14).unwrap();
    let mut x = 0.0f64;
    for _ in 0..20 {
        let slope = c[1] + x * (2.0 * c[2] + x * (3.0 * c[3] + x * 4.0 * c[4]));
        x -= slope / (2.0 * c[2] + x * (6.0 * c[3] + x * 12.0 * c[4]));
    }
    (places[top] + scale * x, c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4]))))
}

#[test]
fn peeling_work_is_largest_at_an_intermediate_stiffness() {
    let (place, value) = of_scan();
    for method in [SearchMethod::QuasiNewton, SearchMethod::SequentialQuadratic, SearchMethod::DerivativeFree] {
        let problem = stiffness(1e-3, 1e3);
        let found = optimise(&problem, &OptimisationOptions { method: Some(method), ..options() }).unwrap();
        let at = found.after.values[0];
        assert!((at.ln() - place).abs() < 1e-4, "{method:?}: {at} against {}", place.exp());
        assert!((found.after.objective / value - 1.0).abs() < 1e-4, "{method:?}");
        // the bound holds what is left of the way to the optimum: all methods end at one place
        let bound = found.value_errors.as_ref().unwrap()[0];
        assert!(bound > 0.0 && bound < 1e-5 * at, "{method:?}: {bound:e}");
        assert!((at - 0.674_499_6).abs() < 1e-6, "{method:?}: {at}");
        let certificate = found.certificate.unwrap();
        assert!(certificate.projected_gradient.unwrap() < 1e-6, "{method:?}");
        assert_eq!((certificate.neighbours.better, certificate.active.len()), (0, 0), "{method:?}");
        assert!(found.gain > 1.003 && found.gain_error.unwrap() < 1e-5, "{method:?}");
    }
}

#[test]
fn a_design_without_a_jump_is_a_bad_point_and_not_the_end() {
    // from 20 times EI on the first step leads to strips that tilt upright as a whole
    let problem = DesignProblem { start: vec![20.0], ..stiffness(1e-3, 1e4) };
    let found = optimise(&problem, &options()).unwrap();
    assert!((found.after.values[0] - 0.6745).abs() < 1e-3, "{:?}", found.after.values);
    let random = OptimisationOptions { starts: 3, ..options() };
    let found = optimise(&problem, &random).unwrap();
    let bad = |evaluation: &Evaluation| evaluation.log_value.is_none();
    assert!(found.searches.iter().any(|search| search.evaluations.iter().any(bad)));
}

/// What holds of every optimum of a profile.
fn assert_optimal(problem: &DesignProblem, found: &Optimum, name: &str) {
    let certificate = found.certificate.as_ref().unwrap();
    let projected = certificate.projected_gradient.unwrap();
    assert!(projected < 1e-5 * certificate.gradient.unwrap(), "{name}: {projected:e}");
    assert_eq!(certificate.neighbours.better, 0, "{name}");
    assert!(certificate.neighbours.computed >= 8, "{name}: {:?}", certificate.neighbours);
    assert!(certificate.active.iter().any(|active| active.name == "volume"), "{name}");
    assert!(problem.violation(&found.after.coordinates) < 1e-7, "{name}");
    let [before, after] = [&found.before, &found.after].map(|design| volume(&(problem.model)(&design.values).unwrap()));
    assert!((after / before - 1.0).abs() < 1e-7, "{name}: {after} against {before}");
    assert!(found.after.values.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 0.2 * 100.0 / 7.0 + 1e-5), "{name}");
}

#[test]
fn the_best_width_beats_the_uniform_strip_in_every_direction() {
    for (angle, least) in [(30.0, 1.5), (60.0, 1.5), (90.0, 1.5), (120.0, 1.5)] {
        let problem = width(8, angle);
        let found = optimise(&problem, &options()).unwrap();
        let name = format!("{angle} degrees");
        assert!(found.gain > least, "{name}: {}", found.gain);
        assert_optimal(&problem, &found, &name);
    }
}

/// Which numbers a search is made of.
fn bits(found: &Optimum) -> Vec<u64> {
    let of_design =
        |design: &Evaluation| [&design.coordinates[..], design.log_value.as_slice(), &design.gradient].concat();
    let of_searches = found.searches.iter().flat_map(|search| &search.evaluations).flat_map(of_design);
    found.after.values.iter().copied().chain(of_searches).map(f64::to_bits).collect()
}

#[test]
fn the_result_does_not_depend_on_threads_or_interruptions() {
    let problem = width(5, 90.0);
    let two = OptimisationOptions { starts: 2, evaluations: 12, neighbours: 0, ..options() };
    let in_pool = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| optimise(&problem, &two).unwrap())
    };
    let reference = in_pool(1);
    assert_eq!(bits(&reference), bits(&in_pool(3)));
    // interrupted after four designs, and resumed with what was kept
    let kept: Mutex<Vec<Evaluation>> = Mutex::new(Vec::new());
    let keep = |_: usize, design: &Evaluation| kept.lock().unwrap().push(design.clone());
    let goes_on = || kept.lock().unwrap().len() < 4;
    let cut = optimise(&problem, &OptimisationOptions { keep: &keep, go_on: &goes_on, ..two }).unwrap();
    assert!(cut.unfinished && cut.certificate.is_none());
    assert!(cut.searches.iter().any(|search| search.end == SearchEnd::Interrupted));
    let kept = kept.into_inner().unwrap();
    let known = |coordinates: &[f64], with_gradient: bool| {
        let is_it = |design: &&Evaluation| design.coordinates == coordinates && design.with_gradient == with_gradient;
        kept.iter().find(is_it).cloned()
    };
    let anew = AtomicUsize::new(0);
    let count = |_: usize, _: &Evaluation| {
        anew.fetch_add(1, Ordering::Relaxed);
    };
    let two = OptimisationOptions { starts: 2, evaluations: 12, neighbours: 0, ..options() };
    let resumed = optimise(&problem, &OptimisationOptions { known: &known, keep: &count, ..two }).unwrap();
    assert_eq!(bits(&reference), bits(&resumed));
    let all: usize = resumed.searches.iter().map(|search| search.evaluations.len()).sum();
    assert_eq!(anew.into_inner() + kept.len(), all);
}

#[test]
fn a_ratio_is_that_of_two_peels() {
    let objective = Objective::Ratio {
        of: PeelQuantity::InitiationPeakForce,
        holding_angle: 40f64.to_radians(),
        release_angle: 120f64.to_radians(),
    };
    let problem = DesignProblem { objective, ..stiffness(0.1, 10.0) };
    let found = optimise(&problem, &OptimisationOptions { evaluations: 30, ..options() }).unwrap();
    let peak = |angle: f64, factor: f64| {
        let mut model = stiffened(factor);
        model.pull.angle = angle.to_radians();
        peel(&model, &Accuracy::to(1e-6), &StopCriteria::default()).initiation_peak.unwrap().force
    };
    for design in [&found.before, &found.after] {
        let expected = peak(40.0, design.values[0]) / peak(120.0, design.values[0]);
        assert!((design.objective / expected - 1.0).abs() < 1e-12, "{} against {expected}", design.objective);
    }
    assert!(found.gain >= 1.0);
    assert!(found.certificate.unwrap().projected_gradient.unwrap() < 1e-5);
}

#[test]
fn problems_without_a_meaning_are_refused() {
    let refused = |problem: &DesignProblem| optimise(problem, &options()).unwrap_err();
    let nothing = DesignProblem { variables: Vec::new(), start: Vec::new(), ..stiffness(0.1, 10.0) };
    assert_eq!(refused(&nothing), NoOptimum::NothingFree);
    assert!(matches!(refused(&stiffness(10.0, 0.1)), NoOptimum::Bounds { lower: 10.0, upper: 0.1, .. }));
    let outside = DesignProblem { variables: vec![DesignVariable::new("EI", -1.0, 1.0)], ..stiffness(0.1, 10.0) };
    let error = refused(&outside);
    assert!(matches!(error, NoOptimum::OutsideRange { .. }), "{error}");
    assert!(error.to_string().contains("strip.bending_stiffness_factor"), "{error}");
    // the plateau of so short a path is none
    let missing =
        DesignProblem { objective: Objective::Quantity(PeelQuantity::DetachmentWork), ..stiffness(0.1, 10.0) };
    let error = refused(&missing);
    assert!(matches!(error, NoOptimum::NoObjective { name: "detachment.work_aJ", .. }), "{error}");
    // nowhere so wide on the average
    let mut contradictory = width(5, 90.0);
    contradictory.variables.iter_mut().for_each(|variable| variable.lower = 12.0);
    let error = refused(&contradictory);
    assert!(matches!(&error, NoOptimum::Contradictory { name, .. } if name == "volume"), "{error}");
}

/// Something else than a peel, whose number is largest in the middle of its range: the search without derivatives finds it, carries its bound and its
/// curve, and no other search is taken.
#[test]
fn a_number_without_derivatives_has_its_optimum() {
    let number = |values: &[f64], angle: Option<f64>, _: &StopCriteria| {
        assert_eq!(angle, None);
        match values[0] {
            // a design that cannot be computed does not end the search
            above if above > 6.0 => Err("too large".to_owned()),
            value => Ok(DesignNumber {
                value: (-(value / 2.0).ln().powi(2)).exp(),
                error: Some(1e-3),
                curve: vec![(0.0, 0.0), (1.0, value)],
            }),
        }
    };
    let problem =
        |objective| DesignProblem { objective, number: NumberBy::Values(Box::new(number)), ..stiffness(0.1, 10.0) };
    let options = OptimisationOptions { starts: 1, neighbours: 5, ..options() };
    let objective = Objective::Quantity(PeelQuantity::Work);
    let found = optimise(&problem(objective), &options).unwrap();
    assert!((found.after.values[0] / 2.0 - 1.0).abs() < 1e-3, "{:?}", found.after.values);
    assert_eq!((found.after.error.is_some(), found.value_errors.is_some()), (true, false));
    assert!(matches!(&found.after.of, DesignFound::Curves(curves) if curves[0].len() == 2));
    let certificate = found.certificate.unwrap();
    assert_eq!((certificate.projected_gradient, certificate.neighbours.better), (None, 0));
    let with = OptimisationOptions { method: Some(SearchMethod::QuasiNewton), ..options };
    assert!(matches!(optimise(&problem(objective), &with), Err(NoOptimum::NoGradient { .. })));
    let bad = DesignProblem { start: vec![7.0], ..problem(objective) };
    assert!(matches!(optimise(&bad, &with), Err(NoOptimum::NoNumber { why, .. }) if why == "too large"));
}
