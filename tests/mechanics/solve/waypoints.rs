//! A wary path that is left and goes on, across points that it has replaced.
//!
//! ```text
//!    o---o---o---x             a step from x fails: x is solved again
//!    o---o---o---*---o---o     and replaced, and the path goes on from there
//! ```
//!
//! Reference: the same path without an interruption. Parameters: the strip of the paper, 100 nm, bent 1e6 times as easily, on 16 elements that do not
//! resolve its front, with steps that allow errors of 0.012 and of 0.3, so that many are refused. Expected: points are replaced; a path that is given the
//! waypoints up to a replaced point, or up to the next one, which tells of it, has the same points behind to the last digit. Why: a point follows
//! from the points before, and what replaced one of them is kept with the point behind it.

use peelkit::model::{Form, PeelModel, StripModel};
use peelkit::solve::{Pace, Path, PathOptions, Waypoint};
use std::sync::Arc;

/// The first points of a path as they are kept, and those that were replaced behind them.
fn followed(path: &mut Path) -> (Vec<Waypoint>, Vec<usize>) {
    let mut kept: Vec<Waypoint> = Vec::new();
    while kept.len() < 40 && path.advance().is_ok() {
        kept.extend(path.waypoint());
    }
    let stays = |k: usize| Arc::ptr_eq(&kept[k].point, &path.points()[k]);
    let replaced = (0..kept.len() - 1).filter(|&k| !stays(k)).collect();
    (kept, replaced)
}

#[test]
fn a_wary_path_goes_on_across_replaced_points() {
    let model = PeelModel::from(StripModel::of_the_paper(100.0, 1e-6));
    let problem = model.problem(Form::TwoField, 7).unwrap();
    let mut count = 0;
    for step_tolerance in [1.2e-2, 0.3] {
        let options = PathOptions { pace: Pace::Wary, step_tolerance, elements: 16, ..PathOptions::default() };
        let mut whole = Path::new(&problem, options);
        let (kept, replaced) = followed(&mut whole);
        count += replaced.len();
        for known in replaced.iter().flat_map(|k| [k + 1, k + 2]) {
            let mut path = Path::new(&problem, options).knowing(kept[..known].to_vec());
            for _ in 0..kept.len() {
                path.advance().unwrap();
            }
            let same = path.points().iter().zip(whole.points()).all(|(a, b)| a.at.values == b.at.values);
            assert!(same, "{known} of {} points known, steps of {step_tolerance}", kept.len());
        }
    }
    assert!(count > 0, "no point was replaced");
}
