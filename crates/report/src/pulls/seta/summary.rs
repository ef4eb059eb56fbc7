//! The pull-off of a seta as one JSON object: summary.json, and what `--json` prints.

use super::motion::SetaMotion;
use super::names::{TipEvents, seta_end_reason, seta_end_word};
use crate::records::passed::PassedAt;
use crate::records::summary::{Found, Summary};
use crate::writing::record::{Fields, Record};
use crate::writing::reference::Output;
use peelkit::model::{CurvePoint, PullCurve, Seta};
use peelkit::study::coarsening::{GrowingTable, OutsideTable, TableRound, TipSheet};
use peelkit::study::{ConvergedPeak, EventCause, LocationError, SetaPoint, SetaPullOff, SetaState};
use peelkit_scene::Scene;

/// A pull-off and what was found beside it.
#[derive(Clone, Copy, Debug)]
pub struct SetaFound<'a> {
    scene: &'a Scene,
    seta: &'a Seta,
    tip: &'a PullCurve,
    pull_off: &'a SetaPullOff,
    converged: Option<&'a ConvergedPeak>,
    /// Where the tips follow one
    table: Option<&'a GrowingTable>,
    outside: Option<&'a OutsideTable>,
    tip_s: f64,
    solve_s: f64,
    mesh_error_s: f64,
}

/// Everything of a pull-off but its curve and its events. Forces in nN, lengths in nm, works in aJ.
pub type SetaSummary<'a> = Summary<'a, SetaFound<'a>>;

impl Record for SetaFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("end", "`detached`; `still-attached` where tips adhere when the root has moved as far as the seta is high; `event`: an event that stops; `bound`: a limit of `[bounds]` was reached; `failed`: the computation stopped short", |found| seta_end_word(found.pull_off));
        of.field("reason", "why, with numbers; null where the end says it", |found| seta_end_reason(&found.pull_off.end));
        of.field("tips", "number of tips", |found| found.seta.tips());
        of.field("peak", "the equilibrium of the pull with the largest force along the pull: a maximum, or just before an event or behind it; on the finest mesh that `mesh_error` names; null where the pull was not begun", |found| found.pull_off.peak.as_ref().map(|state| Moment { state, converged: found.converged }));
        of.field("largest_force", "of all steps the equilibrium at which the force on the root is largest, whatever its direction; null without equilibria", |found| Largest::of(&found.pull_off.points));
        of.field("steps", "what each step of the loading came to, in their order; the pull is the last one", |found| SetaMotion::of(&found.pull_off.points));
        of.field("initial_stiffness_N_per_m", "at the beginning of the pull, by how much the force along the pull rises with the displacement, the root held in all other directions; null where the pull was not begun", |found| found.pull_off.initial_stiffness);
        of.field("mesh_error", "of the peak, which is computed again with elements of rising order until its force changes by no more than `accuracy.relative`; where spatulae are beams, once, on half as many elements again; null where no finer mesh came to it: it is then that of the curve, and its error is not known", |found| Some(MeshError { curve: found.pull_off.peak.as_ref()?.point, converged: found.converged? }));
        of.field("first_detachment", "just before the first detachment of a tip in the pull, else null", |found| found.pull_off.first_detachment.as_ref().map(Moment::from));
        of.field("last_detachment", "just before the last one, else null", |found| found.pull_off.last_detachment.as_ref().map(Moment::from));
        of.group("events", "where tips detach or adhere again, or beams buckle, the root held", |of| {
            of.part(|found| TipEvents::of(found.pull_off.events.iter().map(|event| &event.tips[..])));
            of.field("buckled", "events that begin with beams that buckle: a loss of stability in which no tip takes part", |found| found.pull_off.events.iter().filter(|event| event.cause == EventCause::Buckling).count());
        });
        of.sometimes("stations", "with `output.stations`, `output.events` or options of them: where they lie, in the order of the pull-off", |found| Some(PassedAt::of_pull_off(found.pull_off, &found.scene.looked_for())).filter(|found| !found.is_empty()));
        of.group("balance", "what became of the work of the root, over all steps", |of| {
            of.field("work_aJ", "the work", |found| found.pull_off.points.last().map_or(0.0, |last| last.work));
            of.field("released_aJ", "energy released in events", |found| found.pull_off.points.last().map_or(0.0, |last| last.released));
            of.field("energy_change_aJ", "change of the stored energy and of that of adhesion", |found| found.energy_change());
            of.field("imbalance", "the difference, over the largest of the three", |found| found.pull_off.imbalance());
        });
        of.group("tip", "the law of each tip", |of| {
            of.field("law", "what the tips follow: `curve`, the normal pull of their spatula; `table`, see `tip_table`; `beam`: nothing, their spatulae are beams", |found| found.scene.seta.as_ref().map_or("curve", |table| table.tip_law.name()));
            of.field("peak_force_nN", "largest force of the curve of its normal pull", |found| tip_peak(found.tip));
            of.part(|found| RestOfTip(found.tip));
        });
        of.field("tip_table", "the table that the tips follow, as it is in the last pull-off; null where they follow none", |found| found.table.map(TipTableUse::of));
        of.field("warnings", "what is not to be trusted", |found| found.outside.into_iter().collect::<Vec<_>>());
        of.group("path", "computational cost", |of| {
            of.field("points", "equilibria of the pull-off", |found| found.pull_off.points.len());
            of.field("newton_iterations", "Newton iterations", |found| found.pull_off.effort.newton_iterations);
            of.field("elements", "elements of the tree", |found| found.pull_off.effort.elements);
        });
        of.group("timing", "wall clock", |of| {
            of.field("tip_s", "of the law of the tips", |found| found.tip_s);
            of.field("solve_s", "of the pull-off", |found| found.solve_s);
            of.field("mesh_error_s", "of the peak on finer meshes", |found| found.mesh_error_s);
        });
    }
}

impl Found for SetaFound<'_> {
    const SCHEMA: &'static str = "number of this set of keys and columns, as of a peel";
    const COMMAND: &'static str = "the command line; null where a program of another kind has written the summary";
    const PARAMETERS: &'static str =
        "the scene as it was computed, with its defaults: its tables as objects, units in the names";
}

impl SetaFound<'_> {
    /// Of the stored energy and that of adhesion, over all steps.
    fn energy_change(&self) -> f64 {
        let points = &self.pull_off.points;
        points.first().zip(points.last()).map_or(0.0, |(first, last)| last.energy - first.energy)
    }
}

/// A state of the last step; of the peak on the finest mesh, where it was found there. The tips carry what they do on the mesh of the curve.
struct Moment<'a> {
    state: &'a SetaState,
    converged: Option<&'a ConvergedPeak>,
}

impl<'a> From<&'a SetaState> for Moment<'a> {
    fn from(state: &'a SetaState) -> Self {
        Self { state, converged: None }
    }
}

impl Record for Moment<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("force_nN", "force on the root along the pull", |found| found.converged.map_or(found.state.point.force_along, |finest| finest.peak.force));
        of.field("displacement_nm", "how far the root has moved in the pull", |found| found.converged.map_or(found.state.point.displacement, |finest| finest.peak.displacement));
        of.field("location_error_nN", "how far the force of the maximum, or of the event, that was looked for may lie from `force_nN`, with mesh and law of the tips as they are; null where nothing was located, so that the peak is the largest force of the equilibria that were computed", |found| Some(found.location()?.force));
        of.field("location_error_nm", "the same of `displacement_nm`", |found| Some(found.location()?.displacement));
        of.field("tips_attached", "number of tips that adhere", |found| found.state.point.attached);
        of.field("largest_tip_load_nN", "of all tips the largest force away from the ground", |found| found.loads().fold(0.0, f64::max));
        of.field("largest_tip_push_nN", "of all tips the largest force towards the ground; 0 where none is pressed", |found| found.loads().fold(0.0, |most, load| f64::max(most, -load)));
        of.field("tip_loads_sum_nN", "sum of the forces of the tips away from the ground: the force on the root along the normal", |found| found.loads().sum::<f64>());
    }
}

impl Moment<'_> {
    /// Of the tips, away from the ground.
    fn loads(&self) -> impl Iterator<Item = f64> {
        self.state.tips.iter().map(|tip| 0.0 - tip.load[1])
    }

    /// How far the place that was looked for may lie from here; none where none was.
    fn location(&self) -> Option<LocationError> {
        self.converged.map_or(self.state.location, |finest| finest.location)
    }
}

/// The largest force on the root over all steps.
struct Largest<'a>(&'a SetaPoint);

impl<'a> Largest<'a> {
    fn of(points: &'a [SetaPoint]) -> Option<Self> {
        points.iter().max_by(|a, b| size(&a.force).total_cmp(&size(&b.force))).map(Self)
    }
}

fn size(force: &[f64; 3]) -> f64 {
    force.iter().map(|part| part * part).sum::<f64>().sqrt()
}

impl Record for Largest<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("force_nN", "the length of the force", |at| size(&at.0.force));
        of.field("force_x_nN", "its part along x", |at| at.0.force[0]);
        of.field("force_y_nN", "along the normal of the ground, negative where the root is pressed", |at| at.0.force[1]);
        of.field("force_z_nN", "along z", |at| at.0.force[2]);
        of.field("step", "number of the step of the loading, from 1", |at| at.0.step + 1);
        of.field("displacement_nm", "how far the root has moved in the step", |at| at.0.displacement);
        of.field("tips_attached", "number of tips that adhere", |at| at.0.attached);
    }
}

impl Record for SetaMotion {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("step", "number of the step, from 1", |motion| motion.step + 1);
        of.field("motion", "`press`, `drag` or `pull`, by where the root goes", |motion| motion.name);
        of.field("largest_force_nN", "the largest force on the root along this motion by its amount, positive where it is pulled that way", |motion| motion.largest);
        of.field("displacement_nm", "how far the root has moved in the step there", |motion| motion.displacement);
    }
}

/// By how much the peak lies elsewhere on the mesh before the finest.
struct MeshError<'a> {
    curve: SetaPoint,
    converged: &'a ConvergedPeak,
}

impl Record for MeshError<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("force_nN", "by how much the force differs from that on the mesh before", |found| found.converged.mesh.force);
        of.field("displacement_nm", "the same of the displacement", |found| found.converged.mesh.displacement);
        of.field("order", "order of the elements of the peak", |found| found.converged.order);
        of.field("curve_nN", "by how much the largest force of curve.csv, whose elements have order `accuracy.order`, differs from that of the peak", |found| (found.converged.peak.force - found.curve.force_along).abs());
    }
}

/// What of the law of a tip is the same whatever the tips follow.
pub(crate) struct RestOfTip<'a>(pub &'a PullCurve);

impl Record for RestOfTip<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("snap_off_displacement_nm", "displacement at which the tip alone snaps off", |tip| tip.0.snap_off());
        of.field("energy_at_rest_aJ", "energy of the adhering tip at rest against a detached one", |tip| tip.0.energy_at_rest());
    }
}

/// The table that tips follow, and what it came to that they left it.
struct TipTableUse<'a> {
    growing: &'a GrowingTable,
    /// Of the last pull-off, where tips were solved as spatulae in it
    resolved: Option<&'a TableRound>,
}

impl<'a> TipTableUse<'a> {
    fn of(growing: &'a GrowingTable) -> Self {
        Self { growing, resolved: growing.rounds().last().filter(|round| round.within.is_some()) }
    }

    /// Of a force of one tip, on the worse of the two branches.
    fn error(&self, force: usize) -> f64 {
        let own = |on: TipSheet| self.growing.table().errors(on).force[force];
        own(TipSheet::Attached).max(own(TipSheet::Detached))
    }
}

fn outside(round: Option<&TableRound>) -> usize {
    round.map_or(0, |round| round.visited.outside.len())
}

impl Record for TipTableUse<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("rows", "its nodes: equilibria of the spatula on both branches", |found| found.growing.table().rows());
        of.field("press_nm", "how far below the height without a normal force it begins", |found| found.growing.table().options.range.press);
        of.field("rotation_rad", "its range of θ", |found| found.growing.table().options.range.rotation);
        of.field("relative_error", "bound of its error, over the largest force and the largest moment; `seta.tip_tolerance` is what was asked", |found| found.growing.table().relative_error());
        of.field("normal_force_error_nN", "bound of the error of the normal force of one tip", |found| found.error(0));
        of.field("moment_error_nN_nm", "the same for the moment", |found| found.error(2));
        of.field("pull_offs", "how often the seta was pulled off: once, and once more each time the table has grown", |found| found.growing.rounds().len());
        of.field("rows_added", "rows of the last table more than of the first", |found| found.growing.added());
        of.field("tips_outside_first", "tips that were in equilibrium outside of the first table", |found| outside(found.growing.rounds().first()));
        of.field("tips_outside", "tips that were so outside of the last one: above 0 their forces are extrapolated", |found| outside(found.growing.rounds().last()));
        of.field("first_peak_force_nN", "peak force by the first table, null where there was none", |found| found.growing.rounds().first().and_then(|round| round.peak_force));
        of.field("peak_force_change_nN", "by how much the peak force by the last table differs from it", |found| found.growing.changed());
        of.field("resolve_within_nm", "how near to where they snap off tips were solved as spatulae; null where all followed the table", |found| found.resolved.and_then(|round| round.within));
        of.field("tips_resolved", "tips that were solved so in the last pull-off", |found| found.resolved.map_or(0, |round| round.visited.resolved.tips.len()));
        of.field("tips_unresolved", "tips of which no spatula was found in an equilibrium of the seta: they followed the table there", |found| found.resolved.map_or(0, |round| round.visited.resolved.unsolved.len()));
        of.field("resolved_force_change_nN", "largest change of the normal force of a tip against the table, in equilibria of the seta", |found| found.resolved.map(|round| round.visited.resolved.force));
        of.field("resolved_moment_change_nN_nm", "the same for the moment", |found| found.resolved.map(|round| round.visited.resolved.moment));
        of.field("resolved_peak_force_change_nN", "by how much the spatulae change the peak force of the curve against that by the table alone", |found| found.growing.changed_by_resolved());
    }
}

impl Record for OutsideTable {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("code", "a word that stays the same, for programs: `outside-table`, tips were outside of their table before or behind the peak; `peak-outside-table`, at the peak or next to it", |outside| outside.code());
        of.field("text", "what it says, with numbers", |outside| outside.to_string());
    }
}

/// Points of the curve of a tip between two of its own at which its largest force is looked for.
const BETWEEN: usize = 100;

/// The largest force of the curve of a tip, nN.
pub fn tip_peak(tip: &PullCurve) -> f64 {
    let between = |pair: &[CurvePoint]| {
        let (from, to) = (pair[0].displacement, pair[1].displacement);
        let force = |k: usize| tip.force(from + (to - from) * k as f64 / BETWEEN as f64).0;
        (0..=BETWEEN).map(force).fold(0.0, f64::max)
    };
    tip.points().windows(2).map(between).fold(0.0, f64::max)
}

impl<'a> SetaSummary<'a> {
    /// The summary of the pull-off of this scene, whose tips follow this curve, and of its peak on finer meshes: the three took `tip_s`, `solve_s`
    /// and `mesh_error_s` seconds.
    pub fn new(
        scene: &'a Scene,
        seta: &'a Seta,
        tip: &'a PullCurve,
        (pull_off, converged): (&'a SetaPullOff, Option<&'a ConvergedPeak>),
        [tip_s, solve_s, mesh_error_s]: [f64; 3],
    ) -> Self {
        let found = SetaFound {
            scene,
            seta,
            tip,
            pull_off,
            converged,
            table: None,
            outside: None,
            tip_s,
            solve_s,
            mesh_error_s,
        };
        Summary::of(scene, found)
    }

    /// The same where the tips follow a table.
    pub fn with_table(mut self, table: Option<&'a GrowingTable>) -> Self {
        self.found.table = table;
        self
    }

    /// The same where tips were outside of a table that does not grow any more.
    pub fn with_outside(mut self, outside: Option<&'a OutsideTable>) -> Self {
        self.found.outside = outside;
        self
    }
}

/// The object.
pub(super) fn output() -> Output {
    Output::object("summary.json of a seta", SetaSummary::keys())
}
