//! The peel of a solid as one JSON object: summary.json, and what `--json` prints.

use crate::records::passed::PassedAt;
use crate::records::summary::{Found, Summary};
use crate::writing::record::{Fields, Record};
use crate::writing::reference::Output;
use peelkit::model::LongElements;
use peelkit::study::{Bound, EventAt, SolidLeftOut, SolidLimitPoint, SolidPathEnd, SolidPeel};
use peelkit_scene::Scene;

/// The peel of a solid and what was found beside it.
#[derive(Clone, Copy, Debug)]
pub struct SolidFound<'a> {
    scene: &'a Scene,
    peel: &'a SolidPeel,
    long: Option<LongElements>,
    solve_s: f64,
}

/// Everything of the peel of a solid but its curve. Forces in nN, lengths in nm, works in aJ.
pub type SolidSummary<'a> = Summary<'a, SolidFound<'a>>;

impl Record for SolidFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("end", "`detached`; `pivoting`: the force has come back to zero behind the first jump, still in contact; `turned-back`: the displacement has; `bound`: a limit of `[bounds]` was reached; `event`: an event of the user ends it; `failed`: the computation stopped short", |found| solid_end_word(&found.peel.end));
        of.field("reason", "why, with numbers; null where the end says it", |found| solid_end_reason(&found.peel.end));
        of.field("peak", "the load limit point with the largest force up to the first jump; null where there is none", |found| found.peel.peak());
        of.field("initiation_peak", "the first load limit point, else null", |found| found.peel.initiation_peak());
        of.field("first_jump", "the first displacement limit point, else null", |found| found.peel.snap_off());
        of.field("limit_points", "all limit points, in path order", |found| found.peel.limit_points.iter().map(Turn).collect::<Vec<_>>());
        of.sometimes("stations", "with `output.stations`, `output.events` or options of them: where they lie on the path, in its order", |found| Some(PassedAt::of_solid(found.peel, &found.scene.looked_for())).filter(|found| !found.is_empty()));
        of.field("warnings", "what is not to be trusted", |found| solid_warnings(found.peel, found.long.as_ref()));
        of.field("left_out", "limit points, stations and events that were not located, and changes of inertia that none explains, in words", |found| found.peel.left_out.iter().map(|what| left_out(what, &found.scene.looked_for())).collect::<Vec<_>>());
        of.group("mesh", "the mesh of the scene, which stays", |of| {
            of.field("element", "its element", |found| found.peel.body.element());
            of.field("elements", "how many", |found| found.peel.body.elements());
            of.field("unknowns", "unknowns of the body in its grip", |found| found.peel.body.unknowns());
        });
        of.group("path", "computational cost", |of| {
            of.field("points", "points of the path", |found| found.peel.points.len());
            of.field("newton_iterations", "Newton iterations, those to the limit points among them", |found| found.peel.iterations);
        });
        of.group("timing", "wall clock", |of| of.field("solve_s", "of the path and of its limit points on the finer mesh", |found| found.solve_s));
    }
}

/// A limit point among all.
struct Turn<'a>(&'a SolidLimitPoint);

impl Record for Turn<'_> {
    fn fields(of: &mut Fields<Self>) {
        of.part(|turn| turn.0);
    }
}

impl Found for SolidFound<'_> {
    const SCHEMA: &'static str = "number of this set of keys and columns, as of a peel";
    const COMMAND: &'static str = "the command line; null where a program of another kind has written the summary";
    const PARAMETERS: &'static str =
        "the scene as it was computed, with its defaults: its tables as objects, units in the names";
}

impl<'a> SolidSummary<'a> {
    /// The summary of the peel of this scene, whose elements may be too long; seconds.
    pub fn new(scene: &'a Scene, peel: &'a SolidPeel, long: Option<LongElements>, solve_s: f64) -> Self {
        Summary::of(scene, SolidFound { scene, peel, long, solve_s })
    }
}

/// The name of an end in outputs.
pub fn solid_end_word(end: &SolidPathEnd) -> &'static str {
    match end {
        SolidPathEnd::Detached => "detached",
        SolidPathEnd::Pivoting => "pivoting",
        SolidPathEnd::TurnedBack => "turned-back",
        SolidPathEnd::Bound(Bound::Event { .. }) => "event",
        SolidPathEnd::Bound(_) => "bound",
        SolidPathEnd::Failed(_) | SolidPathEnd::NotAtRest(_) => "failed",
    }
}

/// Why a path ended where it did, if that was not by itself.
pub fn solid_end_reason(end: &SolidPathEnd) -> Option<String> {
    match end {
        SolidPathEnd::Bound(bound) => Some(bound.to_string()),
        SolidPathEnd::Failed(error) => Some(error.to_string()),
        SolidPathEnd::NotAtRest(error) => Some(format!("the spatula does not come to rest in its grip: {error}")),
        SolidPathEnd::Detached | SolidPathEnd::Pivoting | SolidPathEnd::TurnedBack => None,
    }
}

/// What is not to be trusted, a sentence each.
pub fn solid_warnings(peel: &SolidPeel, long: Option<&LongElements>) -> Vec<String> {
    let long = long.map(|LongElements { along, process_length }| {
        format!(
            "elements are {along:.3} nm long and the process zone {process_length:.3} nm: each comes off by itself, and the force oscillates. Give `solid.along` at most {process_length:.1} nm"
        )
    });
    let of_mesh = peel.limit_points.iter().filter(|at| at.errors.is_some_and(|errors| !errors.confirmed)).count();
    let of_mesh = (of_mesh > 0).then(|| {
        format!("{of_mesh} limit points are of the mesh: on the finer one the force has none there. Give a smaller `solid.along`")
    });
    let no_energy = peel.points.first().is_some_and(|first| first.negative.is_none()).then(|| {
        "the traction on the current length has no potential: no work and no stability are reported".to_owned()
    });
    long.into_iter().chain(of_mesh).chain(no_energy).collect()
}

fn left_out(what: &SolidLeftOut, looked_for: &[EventAt]) -> String {
    match what {
        SolidLeftOut::NotLocated { kind, after, cause } => {
            format!("the limit point of the {kind} behind point {after} was not located: {cause}")
        }
        SolidLeftOut::NotPassed { event, after, cause } => {
            let at = &looked_for[*event];
            let what = if at.name.is_empty() { "a station" } else { "an event" };
            let (name, value) = (at.quantity.name(), at.value);
            format!("{what} of `{name}`, at {value} in nm, nN or rad, was not located behind point {after}: {cause}")
        }
        SolidLeftOut::Inertia { kind, after, from, to } => {
            format!(
                "with the {kind} held, {from} negative eigenvalues become {to} behind point {after}, which no limit point explains"
            )
        }
    }
}

/// The object.
pub(super) fn output() -> Output {
    Output::object("summary.json of a solid", SolidSummary::keys())
}
