//! A pull at a rate as one JSON object: summary.json, and what `--json` prints.

use crate::pulls::seta::names::TipEvents;
use crate::pulls::seta::summary::{RestOfTip, tip_peak};
use crate::records::passed::PassedAt;
use crate::records::pulled::{Contact, Equilibria, PointAtRate, PulledAtRate, SlowPeak};
use crate::records::summary::{Found, Summary};
use crate::writing::number::S_PER_NS;
use crate::writing::record::{Fields, Record};
use crate::writing::reference::Output;
use peelkit::model::PullCurve;
use peelkit::solve::time::EnergyBalance;
use peelkit::study::{InTimePeak, SetaInTime, TipLoss};
use peelkit_scene::Scene;

/// A pull at a rate and the equilibria beside it.
#[derive(Clone, Copy, Debug)]
pub struct RateFound<'a> {
    scene: &'a Scene,
    pulled: &'a PulledAtRate,
    equilibria: &'a Equilibria,
    failed: Option<&'a str>,
    solve_s: f64,
    equilibria_s: f64,
    seta: Option<OfSeta<'a>>,
}

/// What a pull of a seta has besides.
#[derive(Clone, Copy, Debug)]
struct OfSeta<'a> {
    tips: usize,
    tip: &'a PullCurve,
    pulled: &'a SetaInTime,
    tip_s: f64,
}

/// Everything of a pull at a rate but its curve.
pub type RateSummary<'a> = Summary<'a, RateFound<'a>>;

impl Record for RateFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("end", "`detached`: nothing adheres any more; `still-attached` where the grip came to rest before; `event`: an event that stops; `failed`: the computation stopped short", |found| found.pulled.end(found.failed.is_some()));
        of.field("reason", "why it stopped short, or the event; else null", |found| found.failed.map(str::to_owned).or_else(|| found.pulled.stopped.as_ref().map(ToString::to_string)));
        of.sometimes_part(|found| found.seta.as_ref());
        of.sometimes("stations", "with `output.stations`, `output.events` or options of them: where they lie, in time", |found| Some(PassedAt::of_rate(found.pulled, &found.scene.looked_for())).filter(|found| !found.is_empty()));
        of.field("largest_force", "the largest force of the pull", |found| Some(Largest { at: found.pulled.peak?, next: found.pulled.next_to_peak()? }));
        of.field("mean_force_nN", "mean force from half to nine tenths of the way, work over displacement there: the steady force where the peel is steady by then", |found| found.pulled.mean_force());
        of.field("contact_lost_s", "when nothing adheres any more for the first time; else null", |found| found.pulled.contact_lost.map(|time| S_PER_NS * time));
        of.field("equilibria_peak", "first peak of the equilibria of the same scene, of a seta its peak; null where they have none", |found| found.equilibria.peak);
        of.field("force_over_equilibria", "largest force of the pull over the peak of the equilibria; null without one", |found| Some(found.pulled.peak?.force / found.equilibria.peak?.force));
        of.group("balance", "what became of the work, from rest to the end", |of| {
            of.part(|found| Change(found.pulled.change()));
            of.sometimes("released_aJ", "of a seta: the part of it that was released at events", |found| found.released());
            of.field("imbalance", "largest defect of that balance at any step, over the largest work", |found| found.pulled.imbalance);
        });
        of.group("path", "computational cost", |of| {
            of.field("steps", "steps in time, and points behind events", |found| found.pulled.steps());
            of.field("steps_tried", "the same with those that were refused", |found| found.pulled.tried);
            of.field("newton_iterations", "Newton iterations", |found| found.pulled.iterations);
            of.field("elements", "elements of the mesh, which stays", |found| found.pulled.elements);
        });
        of.group("timing", "wall clock", |of| {
            of.sometimes("tip_s", "of a seta: of the law of the tips", |found| Some(found.seta?.tip_s));
            of.field("solve_s", "of the pull in time", |found| found.solve_s);
            of.field("equilibria_s", "of the equilibria", |found| found.equilibria_s);
        });
    }
}

impl Found for RateFound<'_> {
    const SCHEMA: &'static str = "number of this set of keys and columns, as of a peel";
    const COMMAND: &'static str = "the command line; null where a program of another kind has written the summary";
    const PARAMETERS: &'static str =
        "the scene as it was computed, with its defaults: its tables as objects, units in the names";
}

impl RateFound<'_> {
    /// Energy released at events, of a seta.
    fn released(&self) -> Option<f64> {
        match self.pulled.points.last()?.contact {
            Contact::Tips { released, .. } => Some(released),
            Contact::Front(_) => None,
        }
    }
}

impl Record for OfSeta<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("tips", "of a seta: number of tips", |found| found.tips);
        of.group("events", "of a seta: where tips leave the branch of their law", |of| {
            of.part(|found| TipEvents::of(found.pulled.events.iter().map(|event| &event.tips[..])));
            of.field("unstable", "events that are losses of stability: the tips soften faster than the seta holds them", |found| found.pulled.events.iter().filter(|event| event.loss == TipLoss::Unstable).count());
        });
        of.group("tip", "of a seta: the law of each tip", |of| {
            of.field("law", "what the tips follow: `curve`, the normal pull of their spatula", |_| "curve");
            of.field("peak_force_nN", "largest force of its curve", |found| tip_peak(found.tip));
            of.part(|found| RestOfTip(found.tip));
        });
    }
}

/// Where the force is largest, and the step next to it.
struct Largest<'a> {
    at: InTimePeak,
    next: &'a PointAtRate,
}

impl Record for Largest<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("force_nN", "of a beam by a parabola through the three steps next to it, of a seta that of a step", |found| found.at.force);
        of.field("displacement_nm", "of what moves the grip, or the root", |found| found.at.displacement);
        of.field("time_s", "since the pull began", |found| S_PER_NS * found.at.time);
        of.field("kinetic_aJ", "kinetic energy at the step next to it", |found| found.next.balance.kinetic);
        of.field("dissipated_aJ", "dissipated up to that step", |found| found.next.balance.dissipated);
        of.sometimes("tips_attached", "of a seta: number of tips that adhere there", |found| found.next.attached());
    }
}

impl Record for SlowPeak {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("force_nN", "its force", |peak| peak.force);
        of.field("displacement_nm", "its displacement", |peak| peak.displacement);
        of.field("error_nN", "bound of the error of its force; of a seta the error with which it is located, null where it is not", |peak| peak.error);
    }
}

/// What became of the work, from rest to the end.
struct Change(EnergyBalance);

impl Record for Change {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("work_aJ", "work of the grip, or of the machine behind its spring", |change| change.0.work);
        of.field("stored_aJ", "change of the elastic energy", |change| change.0.stored);
        of.field("adhesion_aJ", "change of the energy of adhesion", |change| change.0.adhesion);
        of.field("spring_aJ", "change of the energy of the machine's spring", |change| change.0.spring);
        of.field("kinetic_aJ", "kinetic energy", |change| change.0.kinetic);
        of.field("dissipated_aJ", "dissipated by the material and the adhesive, and at the events of a seta", |change| change.0.dissipated);
    }
}

impl<'a> RateSummary<'a> {
    /// The summary of the pull of this scene, with the equilibria beside it and why it stopped short, if it did; seconds of both.
    pub fn new(
        scene: &'a Scene,
        pulled: &'a PulledAtRate,
        equilibria: &'a Equilibria,
        failed: Option<&'a str>,
        [solve_s, equilibria_s]: [f64; 2],
    ) -> Self {
        Summary::of(scene, RateFound { scene, pulled, equilibria, failed, solve_s, equilibria_s, seta: None })
    }

    /// With what a seta of so many tips has besides, whose law took so many seconds.
    pub fn with_seta(mut self, tips: usize, tip: &'a PullCurve, pulled: &'a SetaInTime, tip_s: f64) -> Self {
        self.found.seta = Some(OfSeta { tips, tip, pulled, tip_s });
        self
    }
}

/// The object.
pub(super) fn output() -> Output {
    Output::object("summary.json of a rate", RateSummary::keys())
}
