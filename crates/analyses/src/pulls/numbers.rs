//! Numbers and curves of scenes that are no peel of a beam in equilibrium: the peel of a solid, the pull-off of a seta, the pull of an array, and a pull at a rate, of a beam or of a seta. Who
//! samples, optimises or fits such scenes asks here, and does not ask which of these they are.

use crate::pulls::rate::pull_at_rate;
use crate::pulls::seta::Setae;
use crate::pulls::solid::peeled;
use crate::session::{Cost, Parts, Progress, Session};
use peelkit::study::uncertainty::{Outcome, Sampled};
use peelkit::study::{
    Bound, PeelQuantity, PulledCurve, SetaEnd, SetaPullOff, SolidPathEnd, SolidPeel, Stage, StopCriteria, StopReason,
};
use peelkit::toe::{ArrayEnd, ArrayPull};
use peelkit_report::{PulledAtRate, RateResult, SolidResult, seta_end_reason, solid_end_reason, timed};
use peelkit_scene::{ArrayTable, Described, Scene, UncertaintyTable};
use std::sync::OnceLock;

/// Of a scene that has no pull.
const A_PEEL: &str = "the scene is the peel of a beam in equilibrium";

/// Pulls of scenes that differ from one another in some keys.
pub struct Pulls {
    setae: Setae,
    what: &'static str,
}

/// The numbers of one pull, and its curve.
pub struct Pulled {
    /// The largest force, its displacement, and how far the force may be off by the mesh; none of a pull that stopped short, whose largest force may
    /// lie ahead
    peak: Option<(f64, f64, Option<f64>)>,
    /// Likewise
    work: Option<f64>,
    /// Force over displacement
    pub curve: PulledCurve,
}

impl Pulls {
    /// Of scenes like this one; none where it is a peel.
    pub fn like(scene: &Scene) -> Option<Self> {
        let what = match scene.describes() {
            Described::Rate(..) => "pulls at a rate",
            Described::Solid(_) => "peels of a solid",
            Described::Array(_) => "pulls of an array of setae",
            Described::Seta(_) => "pull-offs of a seta",
            Described::Peel => return None,
        };
        Some(Self { setae: Setae::like(scene), what })
    }

    /// Computes what all of them have in common, so that it counts for none of them: the law of the tips.
    pub fn prepare(&self, scene: &Scene, stop: &StopCriteria) {
        self.setae.prepare(scene, stop);
    }

    /// The pull of a scene, or why there is none. Called from any thread.
    pub fn pulled(&self, scene: &Scene, stop: &StopCriteria) -> Result<Pulled, String> {
        scene.check_whole().map_err(|error| format!("{}. {}", error.found, error.remedy))?;
        match scene.describes() {
            Described::Rate(table, seta) => {
                let (pulled, failed) = pull_at_rate(scene, (table, seta), &self.setae, stop)?;
                let curve = at_rate(&pulled, failed.clone(), stop);
                let found = RateResult::new(&pulled, failed);
                let whole = curve.short.is_none();
                let peak = whole.then_some((found.largest_force, found.displacement, None));
                Ok(Pulled { peak, work: whole.then_some(found.work), curve })
            }
            Described::Solid(table) => {
                let peel = peeled(scene, table, stop.clone()).map_err(|error| error.to_string())?;
                let found = SolidResult::from(&peel);
                let curve = of_solid(&peel);
                let peak = found.peak.filter(|_| curve.short.is_none());
                Ok(Pulled { peak: peak.map(|at| (at.force, at.displacement, at.error)), work: None, curve })
            }
            Described::Array(table) => {
                let pull = pulled_array(scene, table, stop)?;
                let peak = pull.peak.and_then(|peak| pull.events.get(peak)).map(|at| (at.load, at.lift, None));
                Ok(Pulled { peak, work: Some(pull.work), curve: of_array(&pull) })
            }
            Described::Seta(table) => {
                let (pull_off, found) = self.setae.pulled_off(scene, table, stop)?;
                let whole = !found.end.is_cut_short();
                let peak = found.peak.filter(|_| whole);
                Ok(Pulled {
                    peak: peak.map(|peak| (peak.force, peak.displacement, found.mesh_error)),
                    work: whole.then_some(found.work),
                    curve: of_seta(&pull_off),
                })
            }
            Described::Peel => Err(A_PEEL.to_owned()),
        }
    }

    /// The curve of the pull of a scene alone, or why there is none. Called from any thread.
    pub fn curve(&self, scene: &Scene, stop: &StopCriteria) -> Result<PulledCurve, String> {
        scene.check_whole().map_err(|error| format!("{}. {}", error.found, error.remedy))?;
        match scene.describes() {
            Described::Rate(table, seta) => {
                let (pulled, failed) = pull_at_rate(scene, (table, seta), &self.setae, stop)?;
                Ok(at_rate(&pulled, failed, stop))
            }
            Described::Solid(table) => {
                let peel = peeled(scene, table, stop.clone());
                Ok(of_solid(&peel.map_err(|error| error.to_string())?))
            }
            Described::Array(table) => Ok(of_array(&pulled_array(scene, table, stop)?)),
            Described::Seta(table) => Ok(of_seta(self.setae.followed(scene, table, stop)?.pull_off())),
            Described::Peel => Err(A_PEEL.to_owned()),
        }
    }

    /// Times the first of the computations of a session, and tells what they cost.
    pub fn meter<'s>(&'s self, session: &'s Session<'s>, parts: Parts) -> Meter<'s> {
        Meter { session, what: self.what, parts, told: OnceLock::new() }
    }
}

impl Pulled {
    /// A number with the bound on its error; none that it does not have.
    pub fn value(&self, of: PeelQuantity) -> Option<(f64, Option<f64>)> {
        match of {
            PeelQuantity::PeakForce | PeelQuantity::LargestForce => self.peak.map(|(force, _, error)| (force, error)),
            PeelQuantity::PeakDisplacement | PeelQuantity::LargestForceDisplacement => {
                self.peak.map(|(_, displacement, _)| (displacement, None))
            }
            PeelQuantity::Work => self.work.map(|work| (work, None)),
            _ => None,
        }
    }
}

/// Of the last step of a pull-off.
fn of_seta(pull_off: &SetaPullOff) -> PulledCurve {
    let step = pull_off.points.last().map_or(0, |last| last.step);
    let points = pull_off.points.iter().filter(|point| point.step == step);
    let lost = points.clone().find(|point| point.attached == 0);
    let mut curve = PulledCurve::of(points.map(|point| (point.displacement, point.force_along)));
    curve.detached = lost.map(|point| point.displacement);
    curve.short = seta_end_reason(&pull_off.end);
    curve.interrupted = matches!(pull_off.end, SetaEnd::Bound(Bound::Interrupted));
    curve
}

/// The pull of the array of a scene.
pub fn pulled_array(scene: &Scene, table: &ArrayTable, stop: &StopCriteria) -> Result<ArrayPull, String> {
    let array = scene.seta_array(table).ok_or("its setae stand on nothing, or their law is not made yet")?;
    let stopped = || stop.should_stop.as_ref().is_some_and(|asked| asked(Stage::Path).is_some());
    array.pull(&stopped).map_err(|error| error.to_string())
}

fn of_array(pull: &ArrayPull) -> PulledCurve {
    let jumps = pull.events.iter().filter(|event| event.starts_jump);
    let mut curve = PulledCurve::of(jumps.map(|event| (event.lift, event.load)));
    curve.detached = pull.events.last().filter(|last| last.adhering == 0).map(|last| last.lift);
    curve.short = (pull.end == ArrayEnd::Stopped).then(|| "it was stopped".to_owned());
    curve
}

fn of_solid(peel: &SolidPeel) -> PulledCurve {
    let mut curve = PulledCurve::of(peel.points.iter().map(|at| (at.displacement, at.force)));
    let is_off = peel.end == SolidPathEnd::Detached;
    curve.detached = peel.points.last().filter(|_| is_off).map(|last| last.displacement);
    curve.short = match &peel.end {
        // as far as it was asked for, it is whole
        SolidPathEnd::Bound(Bound::Until(_)) => None,
        end => solid_end_reason(end),
    };
    curve.interrupted = matches!(peel.end, SolidPathEnd::Bound(Bound::Interrupted));
    curve
}

fn at_rate(pulled: &PulledAtRate, failed: Option<String>, stop: &StopCriteria) -> PulledCurve {
    let lost = pulled.contact_lost.and_then(|time| pulled.points.iter().find(|point| point.time >= time));
    let asked = || stop.should_stop.as_ref().and_then(|asked| asked(Stage::Path));
    let mut curve = PulledCurve::of(pulled.points.iter().map(|point| (point.displacement, point.force)));
    curve.detached = lost.map(|point| point.displacement);
    curve.interrupted = failed.is_some() && asked() == Some(StopReason::Interrupted);
    curve.short = failed;
    curve
}

/// Times the first of many computations.
pub struct Meter<'s> {
    session: &'s Session<'s>,
    what: &'static str,
    parts: Parts,
    told: OnceLock<()>,
}

impl Meter<'_> {
    /// Computes one of them.
    pub fn over<T>(&self, one: impl FnOnce() -> T) -> T {
        if self.told.get().is_some() {
            return one();
        }
        let (found, first_s) = timed(one);
        if self.told.set(()).is_ok() {
            self.session.watcher.see(Progress::Cost(Cost { what: self.what, parts: self.parts, first_s }));
        }
        found
    }
}

/// The numbers of a pull with any values of the uncertain keys of a scene.
#[derive(Clone, Copy)]
pub struct SampledPull<'s> {
    pub scene: &'s Scene,
    pub table: &'s UncertaintyTable,
    pub pulls: &'s Pulls,
    pub meter: &'s Meter<'s>,
    /// The stop criteria of one pull, anew for each
    pub stop: &'s (dyn Fn() -> StopCriteria + Sync),
}

impl Sampled for SampledPull<'_> {
    fn numbers(&self) -> usize {
        self.table.quantities.len()
    }

    fn outcome(&self, inputs: &[f64]) -> Outcome {
        let scene = self.table.scene(self.scene, inputs).map_err(|error| format!("{}. {}", error.found, error.remedy));
        let pulled = |scene: &Scene| self.meter.over(|| self.pulls.pulled(scene, &(self.stop)()));
        match scene.and_then(|scene| pulled(&scene)) {
            Ok(found) => {
                let value = |&of: &PeelQuantity| found.value(of).map(|(value, _)| value);
                Outcome { values: self.table.quantities.iter().map(value).collect(), cut_short: found.curve.short }
            }
            Err(why) => Outcome::refused(self.numbers(), why),
        }
    }
}

/// A sample whose outcome at one place is known.
pub struct WithKnown<'s> {
    pub sampled: &'s dyn Sampled,
    pub at: Vec<f64>,
    pub known: Outcome,
}

impl Sampled for WithKnown<'_> {
    fn numbers(&self) -> usize {
        self.sampled.numbers()
    }

    fn outcome(&self, inputs: &[f64]) -> Outcome {
        if inputs == self.at { self.known.clone() } else { self.sampled.outcome(inputs) }
    }
}
