//! One point of the peel followed over the values, without whole paths.

use super::cases::{Case, Cases};
use crate::session::{Progress, Session};
use peelkit::study::{self, FollowedSweep, PointKind, Spacing};
use std::cell::{Cell, RefCell};
use std::time::Instant;

/// Why no point of these peels can be followed, if none can.
pub fn not_followed(cases: &Cases) -> Option<&'static str> {
    let why = |case: &Case| match &case.scene.model {
        model if model.friction_law().is_some() => Some("without friction only, and friction.strength is given"),
        model if !model.adhesion.healing => Some("of an adhesion that heals only, and adhesion.healing is false"),
        model if model.yields() => Some("of films that are elastic only, and strip.yield_strength is given"),
        model if !model.ground.substrate.is_flat() => Some("on a flat substrate only, and substrate.shape is another"),
        model if !model.steps.is_empty() => Some("from rest only, and drive.steps has steps before the pull"),
        _ => None,
    };
    let plane = cases.keys.second.map(|_| "over the values of one key only, and two are varied");
    plane.or_else(|| cases.all.iter().find_map(why))
}

/// The point at each value, and the seconds that it took.
pub fn follow(kind: PointKind, cases: &Cases, session: &Session) -> (FollowedSweep, Vec<f64>) {
    let (key, log, cases) = (cases.keys.first, cases.log[0], cases.all.as_slice());
    let spacing = if log { Spacing::Logarithmic } else { Spacing::Linear };
    session.watcher.see(Progress::Begin(cases.len()));
    let mut sweep = FollowedSweep { kind, rows: Vec::with_capacity(cases.len()), remarks: Vec::new() };
    let mut solve_s = Vec::with_capacity(cases.len());
    for alike in alike(cases) {
        let values: Vec<f64> = alike.iter().map(|case| case.value).collect();
        let model = |value| {
            let mut scene = alike[0].scene.clone();
            // a key of whole numbers takes nothing in between, and is no part of the model
            let _ = key.store_number(&mut scene, value);
            scene.model
        };
        let scene = &alike[0].scene;
        let laps = Laps::of(values.len());
        let solved = |index: usize| {
            laps.end(index);
            session.watcher.see(Progress::Done);
        };
        let stop = || session.stop_of_one(scene);
        let part = study::follow_point(kind, &values, spacing, &model, &scene.accuracy, &stop, &solved);
        solve_s.extend(laps.seconds.into_inner());
        sweep.rows.extend(part.rows);
        sweep.remarks.extend(part.remarks);
    }
    (sweep, solve_s)
}

/// Wall clock from value to value, s.
struct Laps {
    started: Cell<Instant>,
    seconds: RefCell<Vec<f64>>,
}

impl Laps {
    fn of(values: usize) -> Self {
        Self { started: Cell::new(Instant::now()), seconds: RefCell::new(vec![0.0; values]) }
    }

    /// The value is solved for, and the next one begins.
    fn end(&self, index: usize) {
        let seconds = self.started.replace(Instant::now()).elapsed().as_secs_f64();
        self.seconds.borrow_mut()[index] = seconds;
    }
}

/// Cases that differ in the model alone: what is not part of it, the accuracy say, is one for all cases of a call.
fn alike(cases: &[Case]) -> impl Iterator<Item = &[Case]> {
    cases.chunk_by(|a, b| a.scene.accuracy == b.scene.accuracy && a.scene.bounds == b.scene.bounds)
}
