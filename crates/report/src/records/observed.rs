//! The displacement-controlled test: observed.csv, and an object of summary.json. Units stand in the names.

use super::located::finite;
use super::passed::PassedAt;
use crate::writing::error::ReportError;
use crate::writing::names::{jump_word, test_end_reason, test_end_word};
use crate::writing::record::write_table;
use crate::writing::record::{Bounded, Fields, Record};
use crate::writing::reference::Output;
use peelkit::study::{Balance, Jump, JumpEnd, Observed, PullOff, TestPoint, UnknownJumpError};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

impl Record for TestPoint {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("branch", "whether the machine retreats or returns", |at| at.way.word());
        of.field("machine_displacement_nm", "U of the machine", |at| at.machine);
        of.field("displacement_nm", "u of the grip", |at| at.displacement);
        of.field("force_nN", "P", |at| at.force);
        of.field("work_aJ", "∫ P dU", |at| at.work);
        of.field("front_nm", "length that adheres, by its energy", |at| at.front);
        of.field("jump", "whether the beam has jumped to this point", |at| at.jumped);
        of.field("adheres", "what adheres: `pad`, `edge`, `end face` or `nothing`", |at| at.adheres.word());
    }
}

/// The table.
pub(crate) fn outputs() -> Vec<Output> {
    vec![Output::table("observed.csv", TestPoint::keys())]
}

/// Writes observed.csv: one row a point of the test, in its order.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_observed(dir: &Path, test: &Observed) -> Result<PathBuf, ReportError> {
    write_table(dir, "observed.csv", &test.points)
}

/// The object `observed` of summary.json.
#[derive(Clone, Copy, Debug)]
pub struct ObservedSummary<'a> {
    test: &'a Observed,
    solve_s: f64,
    scene: Option<&'a Scene>,
}

impl<'a> ObservedSummary<'a> {
    /// Of a test that took so many seconds.
    pub fn new(test: &'a Observed, solve_s: f64) -> Self {
        Self { test, solve_s, scene: None }
    }

    /// The same with the stations and events of its scene.
    pub fn of_scene(self, scene: &'a Scene) -> Self {
        Self { scene: Some(scene), ..self }
    }
}

impl Record for ObservedSummary<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("end", "`closed`, `returned`, `bonded-part-unstable`, `collapsed`, `event`, `bound` or `failed`", |found| test_end_word(&found.test.end));
        of.field("reason", "why, where it is not `closed`", |found| test_end_reason(&found.test.end));
        of.bounded(["pull_off_force_nN", "pull_off_error_nN"], "the largest force on the stable retreat", |found| found.test.pull_off.map(|peak| Bounded::new(peak.force, peak.force_error)));
        of.field("pull_off_adheres", "what adheres at that force: `pad`, `edge` or `end face`", |found| found.test.pull_off.map(|peak| peak.adheres.word()));
        of.field("before_upright", "the largest force before the beam first stood on its end face; null where it never does", |found| found.test.before_upright);
        of.field("hysteresis_aJ", "∮ P dU", |found| found.test.hysteresis);
        of.field("jumps", "all jumps, in order", |found| found.test.jumps.as_slice());
        of.sometimes("stations", "with `output.stations`, `output.events` or options of them: where they lie in the test, in its order", |found| Some(PassedAt::of_test(found.test, &found.scene?.looked_for())).filter(|found| !found.is_empty()));
        of.group("work_balance", "work of the machine against energy", |of| {
            of.field("retreat", "from rest to detachment", |found| found.test.retreat);
            of.field("cycle", "there and back", |found| found.test.cycle);
        });
        of.field("accuracy_reached", "largest relative bound of the test", |found| finite(found.test.reached));
        of.group("effort", "computational cost of the test", |of| {
            of.field("points", "points", |found| found.test.effort.points);
            of.field("newton_iterations", "Newton iterations", |found| found.test.effort.newton_iterations);
            of.field("relaxation_steps", "steps of the gradient flow", |found| found.test.effort.relaxation_steps);
            of.field("elements", "elements", |found| found.test.effort.elements);
            of.field("order", "their order", |found| found.test.effort.order);
            of.field("solve_s", "time", |found| found.solve_s);
        });
    }
}

impl Record for PullOff {
    fn fields(of: &mut Fields<Self>) {
        of.bounded(["force_nN", "error_nN"], "P there", |peak| Some(Bounded::new(peak.force, peak.force_error)));
        of.field("machine_displacement_nm", "U of the machine there", |peak| peak.machine);
        of.field("adheres", "what adheres there", |peak| peak.adheres.word());
    }
}

impl Record for Jump {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("kind", "`snap-off` where less adheres behind the jump, `jump into contact` where more does", |jump| jump_word(jump.kind));
        of.field("way", "whether the machine retreats or returns", |jump| jump.way.word());
        of.bounded(["machine_displacement_nm", "error_nm"], "U of the machine", |jump| Some(Bounded::new(jump.machine, jump.machine_error)));
        of.field("before", "the beam before the jump", |jump| jump.before);
        of.field("after", "the beam where it comes to rest", |jump| jump.after);
        of.field("released_aJ", "energy that the jump releases", |jump| jump.released);
        of.field("released_error_aJ", "its bound; null where none was found", |jump| finite(jump.released_error));
        of.field("landed", "`adhered` or `detached`", |jump| if jump.detached { "detached" } else { "adhered" });
        of.field("warning", "`jump-error-unknown` where no bound was found; else null", |jump| (!jump.released_error.is_finite()).then_some(UnknownJumpError::CODE));
        of.field("relaxation_steps", "steps of the gradient flow", |jump| jump.steps);
    }
}

impl Record for JumpEnd {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "u of the grip", |end| end.displacement);
        of.field("force_nN", "P", |end| end.force);
        of.field("error_nm", "bound of the error of the displacement; null where none was found", |end| finite(end.displacement_error));
        of.field("error_nN", "bound of the error of the force; null where none was found", |end| finite(end.force_error));
        of.field("energy_aJ", "energy of beam, adhesion and spring", |end| end.energy);
        of.field("front_nm", "length that adheres, by its energy", |end| end.front);
        of.field("adheres", "what adheres: `pad`, `edge`, `end face` or `nothing`", |end| end.adheres.word());
    }
}

impl Record for Balance {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("work_aJ", "∫ P dU", |balance| balance.work);
        of.field("energy_change_aJ", "change of energy of beam, adhesion and spring", |balance| balance.energy_change);
        of.field("released_aJ", "energy released in jumps", |balance| balance.released);
        of.field("relative_error", "what is not accounted for, over the largest of the three", |balance| balance.error());
    }
}
