//! The pull of an array as one JSON object: summary.json, and what `--json` prints.

use crate::records::summary::{Found, Summary};
use crate::writing::record::{Fields, Record};
use crate::writing::reference::Output;
use peelkit::analytic::{dome_pull_off, self_peeling_tension, winkler_force, winkler_moment, winkler_number};
use peelkit::toe::{ArrayEnd, ArrayPull, Lamella};
use peelkit_scene::{ArrayTable, BandLoad, Scene, array_warnings};

/// The pull of an array with the closed forms beside it.
#[derive(Clone, Copy, Debug)]
pub struct ArrayFound<'a> {
    table: &'a ArrayTable,
    angle: f64,
    pull: &'a ArrayPull,
    solve_s: f64,
}

/// Everything of the pull of an array but its events. Forces in nN, moments in nN nm, lengths in nm, works in aJ.
pub type ArraySummary<'a> = Summary<'a, ArrayFound<'a>>;

impl Record for ArrayFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("end", "`detached`; `mechanism`: what adheres is one row, about which the band swings; `no-further-exit`: no seta comes nearer to its exit; `bound`: `bounds.time` has passed", |found| array_end_word(found.pull.end));
        of.field("reason", "why it ended, where it stopped short", |found| array_end_reason(found.pull));
        of.field("load", "what grows: `force`, nN, with its lift in nm; or `moment`, nN nm, with its lift in rad", |found| if found.is_moment() { "moment" } else { "force" });
        of.field("setae", "how many", |found| found.pull.setae);
        of.field("detached", "how many of them detach", |found| found.pull.detached);
        of.field("events", "changes of setae; equal ones in one place are one event", |found| found.pull.events.len());
        of.field("jumps", "lifts at which events come: at a held lift one event may bring others", |found| found.pull.jumps());
        of.group("peak", "the event with the largest load; of a patch with the largest normal force", |of| {
            of.field("load", "the load there", |found| found.peak().map(|event| event.load));
            of.field("lift", "its work-conjugate displacement or rotation there", |found| found.peak().map(|event| event.lift));
            of.field("event", "its number, from 1 on", |found| found.pull.peak.map(|peak| peak + 1));
            of.field("adhering", "setae that adhere before it", |found| found.peak().map(|event| event.adhering + event.setae.len()));
        });
        of.field("largest_load", "largest load, between events as well", |found| found.pull.largest_load);
        of.field("first_load", "load at the first event", |found| found.pull.events.first().map(|event| event.load));
        of.field("work_aJ", "work of the load up to the last event", |found| found.pull.work);
        of.field("released_aJ", "energy that all events release", |found| found.pull.released);
        of.field("imbalance", "largest difference of work and of stored and released energy, over the work; 0 of a patch, whose work is their sum", |found| found.pull.imbalance);
        of.group("closed_forms", "what the computed is held against; null where a form does not apply", |of| {
            of.field("equal_sharing_nN", "strength of all setae together along their exits, k u_c N; of a fitted law where they are lifted straight", |found| found.table.strength().map(|own| own * found.pull.setae as f64));
            of.field("lambda_pitch", "λp of the band on its rows: smeared laws err by about as much", |found| found.lambda().map(|(lambda, band)| lambda * band.pitch));
            of.field("half_infinite", "load at the first loss at the end of a half-infinite, smeared band: a force f/(2λp(1 + λa)), or a moment f/(2λ²p)", |found| found.half_infinite());
            of.field("steady_force_nN", "force of the band as a tape that peels steadily at `drive.angle`, with its tension", |found| found.table.steady_force(found.angle));
            of.field("self_peeling_tension_nN", "tension at which the band peels by itself, √(2 EA Γb)", |found| found.self_peeling());
            of.field("critical_angle_deg", "with `setae.cone_angle`: angle of the load to the ground up to which every row holds; sheared and lifted where it is pulled", |found| found.critical_angle().map(f64::to_degrees));
            of.field("dome_pull_off_nN", "2πRw of a dome on many springs", |found| found.dome());
        });
        of.field("warnings", "what is not to be trusted", |found| array_warnings(found.table));
        of.group("timing", "wall clock", |of| of.field("solve_s", "of all events", |found| found.solve_s));
    }
}

impl ArrayFound<'_> {
    fn peak(&self) -> Option<&peelkit::toe::ArrayEvent> {
        self.pull.events.get(self.pull.peak?)
    }

    fn is_moment(&self) -> bool {
        self.table.lamella.is_some_and(|lamella| lamella.load != BandLoad::Force)
    }

    /// λ of the lamella; none of other arrays.
    fn lambda(&self) -> Option<(f64, Lamella)> {
        let band = self.table.band().filter(|_| self.table.toe.is_none())?;
        Some((winkler_number(band.row_stiffness()[1][1], band.pitch, band.section.bending), band))
    }

    fn half_infinite(&self) -> Option<f64> {
        let (lambda, band) = self.lambda().filter(|_| self.table.fitted.is_none())?;
        let (strength, lamella) = (band.row_stiffness()[1][1] * self.table.reach, self.table.lamella?);
        match lamella.load {
            BandLoad::Force if band.pulled_at.is_none_or(|row| row == 0) => {
                Some(winkler_force(strength, lambda, band.pitch, lamella.overhang))
            }
            BandLoad::Moment => Some(winkler_moment(strength, lambda, band.pitch)),
            BandLoad::Force | BandLoad::Press => None,
        }
    }

    fn self_peeling(&self) -> Option<f64> {
        Some(self_peeling_tension(self.table.peeling_energy()?, self.table.band()?.section.axial))
    }

    fn critical_angle(&self) -> Option<f64> {
        let (_, band) = self.lambda()?;
        band.critical_angle(self.table.cone_angle?, band.pulled_at.unwrap_or(0)).ok()
    }

    fn dome(&self) -> Option<f64> {
        let radius = self.table.patch?.dome_radius?;
        Some(dome_pull_off(radius, self.table.law()?.lifted()?.work / self.table.pitch.powi(2)))
    }
}

impl Found for ArrayFound<'_> {
    const SCHEMA: &'static str = "number of this set of keys and columns, as of a peel";
    const COMMAND: &'static str = "the command line; null where a program of another kind has written the summary";
    const PARAMETERS: &'static str =
        "the scene as it was computed, with its defaults: its tables as objects, units in the names";
}

impl<'a> ArraySummary<'a> {
    /// The summary of the pull of the array of this scene; seconds.
    pub fn new(scene: &'a Scene, table: &'a ArrayTable, pull: &'a ArrayPull, solve_s: f64) -> Self {
        Summary::of(scene, ArrayFound { table, angle: scene.model.pull.angle, pull, solve_s })
    }
}

/// The name of an end in outputs.
pub fn array_end_word(end: ArrayEnd) -> &'static str {
    match end {
        ArrayEnd::Detached => "detached",
        ArrayEnd::Mechanism => "mechanism",
        ArrayEnd::NoFurtherExit => "no-further-exit",
        ArrayEnd::Events | ArrayEnd::Stopped => "bound",
    }
}

/// Why a pull stopped short, in words; nothing where it did not.
pub fn array_end_reason(pull: &ArrayPull) -> Option<String> {
    match pull.end {
        ArrayEnd::NoFurtherExit => {
            Some("no seta comes nearer to its exit as the load grows: change the direction of the load".to_owned())
        }
        ArrayEnd::Events | ArrayEnd::Stopped => {
            Some(format!("bounds.time has passed after {} events: the peak may lie ahead", pull.events.len()))
        }
        ArrayEnd::Detached | ArrayEnd::Mechanism => None,
    }
}

/// The object.
pub(super) fn output() -> Output {
    Output::object("summary.json of an array", ArraySummary::keys())
}
