//! A peel and what was asked for beside it, as one JSON object.

use super::located::Fold;
use super::model::Ground;
use super::observed::ObservedSummary;
use super::out_of_plane::{BranchFound, OutOfPlaneFound};
use super::steps::StepEnd;
use super::summary::{Found, Summary};
use crate::writing::names::{end_reason, end_word, form_word};
use crate::writing::record::{Fields, Record};
use crate::writing::reference::Output;
use peelkit::model::Form;
use peelkit::solve::Pace;
use peelkit::study::{Events, Exponent, Observed, OutOfPlane, OutOfPlaneBranch, Peel, Stations};
use peelkit_scene::Scene;

/// A peel with what was asked for beside it.
#[derive(Clone, Debug)]
pub struct PeelFound<'a> {
    scene: &'a Scene,
    peel: &'a Peel,
    solve_s: f64,
    out_of_plane: Option<OutOfPlaneFound<'a>>,
    observed: Option<ObservedSummary<'a>>,
    stations: &'a [Stations],
    events: &'a [Events],
    sensitivities: Option<Vec<Sensitivity<'a>>>,
}

/// Everything of a peel but its curve. Forces in nN, lengths in nm, works in aJ.
pub type PeelSummary<'a> = Summary<'a, PeelFound<'a>>;

impl Record for PeelFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("solved_in_plane", "of a scene in space: whether its solution stays in the plane, where it was computed then; null of a scene in the plane", |found| found.scene.model.space.map(|_| found.peel.model.space.is_none()));
        of.field("end", "how the path ended: a word of the list of ends", |found| end_word(&found.peel.end));
        of.field("reason", "why, with numbers; null where the end says it", |found| end_reason(&found.peel.end));
        of.field("peak", "the limit point with the largest force up to the first jump, or as far as the limits of `[bounds]` or the model let the path go. Null where the computed curve goes higher at an end, and where the computation stopped short before the first jump", |found| found.peel.peak);
        of.field("largest_computed_force", "where there is no `peak`: the largest force of the computed curve up to the first jump. It has no bound, because how far the force goes up from there is not known", |found| found.peel.largest_computed_force);
        of.field("initiation_peak", "the first local maximum of the force, else null", |found| found.peel.initiation_peak);
        of.field("plateau", "the steady force, at which the front advances and nothing else changes: where the force changes least with the displacement between the initiation peak and the first jump, else on the level segment of the path on which the front advances furthest, by at least 5 lengths of the process zone; null if d ln P / d ln u is below 0.01 on neither", |found| found.peel.plateau);
        of.field("limit_points", "all limit points, in path order", |found| found.peel.limit_points.as_slice());
        of.field("branch_points", "where other branches of equilibria meet the path although the displacement does not turn, in path order; the path goes on along the branch that it is on", |found| found.peel.branch_points.as_slice());
        of.field("warnings", "where the model is not to be trusted", |found| found.peel.warnings());
        of.field("derived", "what follows from the scene alone; null where a body has no single value, as of a section that varies or is an ellipse, or the law has none", |found| found.scene.model.derived());
        of.field("snap_off", "the first jump, under its older name", |found| found.peel.snap_off.map(Fold));
        of.field("first_jump", "the first displacement limit point, whatever jumps there; else null", |found| found.peel.snap_off.map(Fold));
        of.field("pad_detachment", "the displacement limit point behind which the pad does not adhere any more; null where there is none, and where the path was not followed to an end `detached` or `pivoting`", |found| found.peel.pad_detachment.map(Fold));
        of.field("detachment", "the one behind which nothing adheres; null likewise", |found| found.peel.detachment.map(Fold));
        of.group("accuracy", "how accurate the numbers are", |of| {
            of.field("asked", "`accuracy.relative` of the scene", |found| found.peel.asked);
            of.field("reached", "the largest relative bound of the numbers above; null where nothing has one", |found| found.peel.reached_accuracy());
            of.field("met", "whether `reached` is at most `asked`", |found| found.peel.reached_accuracy().map(|reached| reached <= found.peel.asked));
            of.field("load_limit_points_left_out", "number of load limit points between which the force changes by less than the tolerance", |found| found.peel.ripple);
            of.field("left_out", "what they are, in words", |found| left_out(found.peel));
            of.field("form", "`two-field`: y and θ at every node, x eliminated; `three-field`: ξ = x - S, y and θ", |found| form_word(found.peel.choice.form));
            of.field("form_note", "whether that leaves anything out", |found| form_note(found.peel.choice.form));
        });
        of.field("terms", "what leaving out a term of the model would change, to first order; empty with friction and for a load without a potential; without the far face where a section is nearly upright", |found| found.peel.terms());
        of.sometimes("considered", "with `terms = \"auto\"`: what was neglected and what was kept", |found| found.peel.considered.as_ref());
        of.group("path", "computational cost", |of| {
            of.field("points", "points of the path, on the final mesh", |found| found.peel.effort.points);
            of.field("newton_iterations", "Newton iterations, on all meshes", |found| found.peel.effort.newton_iterations);
            of.field("elements", "elements of the final mesh", |found| found.peel.effort.elements);
            of.field("order", "their order", |found| found.peel.effort.order);
            of.field("pace", "`quick`; `wary` where every mesh had lost the path and it was followed once more, in the plane `watchful` where every mesh had lost that too", |found| pace_word(found.peel.effort.pace));
        });
        of.group("timing", "time", |of| of.field("solve_s", "time of path, limit points and error bounds, without pictures", |found| found.solve_s));
        of.sometimes("steps", "with `drive.steps`: the grip after each step before the pull, relative to where it took hold", |found| Some(found.steps()).filter(|steps| !steps.is_empty()));
        of.sometimes("ground", "on ground that is not flat: how the beam lies where the path begins", |found| Some(Ground { contact: found.peel.contact(0)?, largest_force: found.peel.largest_force() }));
        of.sometimes("yielding", "of a film that yields: how far it has yielded where its force is steady, or else where the path ends", |found| found.peel.yielded());
        of.sometimes("sliding", "with friction: how far the beam has slid at the initiation peak", |found| found.peel.sliding_at_peak());
        of.sometimes("closing_nm", "with `adhesion.healing = false`: displacement from which what has opened or slipped comes back; 0 where it did so before the pull, absent where nothing does", |found| found.peel.closing());
        of.sometimes("stations", "with `output.stations` or `--at`: the equilibria at the values that were asked for, a value each", |found| Some(found.stations).filter(|stations| !stations.is_empty()));
        of.sometimes("events", "with `output.events`, `--event` or `--stop-at`: where the events of the user lie, an event each", |found| Some(found.events).filter(|events| !events.is_empty()));
        of.sometimes("out_of_plane", "with `--out-of-plane`: the stability of the path against leaving its plane, grip free to roll", |found| found.out_of_plane);
        of.sometimes("observed", "with `--observed`: the displacement-controlled test", |found| found.observed);
        of.sometimes("sensitivities", "with `--sensitivities`: by which power of each parameter the results change; those of one result together, largest first", |found| found.sensitivities.as_deref());
    }
}

impl Found for PeelFound<'_> {
    const SCHEMA: &'static str = "number of this set of keys and columns. Keys may be added within a number; where one is renamed, removed or means something else the number grows by one";
    const COMMAND: &'static str = "the command line; null where a program of another kind has written the summary";
    const PARAMETERS: &'static str = "the scene as it was computed, defaults and `--set` included: a table of it is an object, the unit of a number stands in its name (`length_nm`)";
}

/// What the list of limit points leaves out, in words.
pub fn left_out(peel: &Peel) -> Option<&'static str> {
    (peel.ripple > 0).then_some("load limit points between which the force changes by less than the accuracy asked for")
}

fn form_note(form: Form) -> &'static str {
    match form {
        Form::TwoField => "left out: x is minimised out exactly (no effect)",
        Form::ThreeField => "nothing left out: ξ = x - S, y and θ at every node",
    }
}

fn pace_word(pace: Pace) -> &'static str {
    match pace {
        Pace::Quick => "quick",
        Pace::Wary => "wary",
        Pace::Watchful => "watchful",
    }
}

/// By which power of a parameter a result changes.
#[derive(Clone, Copy, Debug)]
struct Sensitivity<'a> {
    exponent: &'a Exponent,
    keys: &'a [String],
}

impl Record for Sensitivity<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("of", "the result Q: where it stands in this object, as `initiation_peak.force_nN`", |found| found.exponent.of.name());
        of.field("key", "the parameter p: a key of the scene, or a cell of the table of a profile", |found| found.keys[found.exponent.variation].as_str());
        of.field("d_ln_d_ln", "d ln Q/d ln p", |found| found.exponent.value);
        of.field("error", "bound of its error", |found| found.exponent.error);
    }
}

impl<'a> PeelFound<'a> {
    /// The steps before the pull, as far as they were taken.
    fn steps(&self) -> Vec<StepEnd<'a>> {
        let jumps_of = |number: usize| self.peel.step_jumps.iter().filter(move |jump| jump.step == number).copied();
        let end = |((number, step), grip)| StepEnd { step, grip, jumps: jumps_of(number).collect() };
        (1..).zip(&self.peel.model.steps).zip(&self.peel.steps).map(end).collect()
    }
}

impl<'a> PeelSummary<'a> {
    /// The summary of the peel of this scene, which took so many seconds.
    pub fn new(scene: &'a Scene, peel: &'a Peel, solve_s: f64) -> Self {
        let found = PeelFound {
            scene,
            peel,
            solve_s,
            out_of_plane: None,
            observed: None,
            stations: &[],
            events: &[],
            sensitivities: None,
        };
        Summary::of(scene, found)
    }

    /// The same with what a test of this scene would record, which took so many seconds.
    pub fn with_observed(mut self, test: &'a Observed, solve_s: f64) -> Self {
        self.found.observed = Some(ObservedSummary::new(test, solve_s).of_scene(self.found.scene));
        self
    }

    /// The same with where the events of its scene lie.
    pub fn with_events(mut self, events: &'a [Events]) -> Self {
        self.found.events = events;
        self
    }

    /// The same with the equilibria at values that were asked for.
    pub fn with_stations(mut self, stations: &'a [Stations]) -> Self {
        self.found.stations = stations;
        self
    }

    /// The same with the exponents of its results by the parameters with these keys.
    pub fn with_sensitivities(mut self, exponents: &'a [Exponent], keys: &'a [String]) -> Self {
        self.found.sensitivities = Some(exponents.iter().map(|exponent| Sensitivity { exponent, keys }).collect());
        self
    }

    /// The same with the stability against leaving the plane, which took so many seconds.
    pub fn with_out_of_plane(mut self, stability: &'a OutOfPlane, solve_s: f64) -> Self {
        self.found.out_of_plane = Some(OutOfPlaneFound { stability, solve_s, branch: None });
        self
    }

    /// The same with the branch that leaves the plane, where there is one, which took so many seconds; behind the stability against that.
    pub fn with_branch(mut self, branch: Option<&'a OutOfPlaneBranch>, solve_s: f64) -> Self {
        if let Some(found) = &mut self.found.out_of_plane {
            found.branch = Some(branch.map(|branch| BranchFound { branch, solve_s }));
        }
        self
    }
}

/// The object.
pub(crate) fn outputs() -> Vec<Output> {
    vec![Output::object("summary.json", PeelSummary::keys())]
}
