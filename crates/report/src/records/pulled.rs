//! A pull at a rate as it is reported, of a beam or of a seta, and the equilibria beside it.

use peelkit::solve::time::EnergyBalance;
use peelkit::study::{
    Bound, InTimePeak, InTimePoint, InTimeStation, Peel, PullInTime, SetaInTime, SetaInTimePoint, SetaInTimeStation,
    SetaPullOff,
};

/// What adheres at one time.
#[derive(Clone, Copy, Debug)]
pub enum Contact {
    /// Of a beam the peeling front, nm
    Front(f64),
    /// Of a seta its tips
    Tips {
        /// How many adhere
        attached: usize,
        /// Sum of the forces with which the ground holds them, along the pull, nN
        force: f64,
        /// Energy released at events, aJ: a part of what is dissipated
        released: f64,
    },
}

/// One time.
#[derive(Clone, Copy, Debug)]
pub struct PointAtRate {
    /// ns
    pub time: f64,
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// What adheres
    pub contact: Contact,
    /// aJ
    pub balance: EnergyBalance,
}

impl From<&InTimePoint> for PointAtRate {
    fn from(&InTimePoint { time, displacement, force, front, balance }: &InTimePoint) -> Self {
        Self { time, displacement, force, contact: Contact::Front(front), balance }
    }
}

impl From<&SetaInTimePoint> for PointAtRate {
    fn from(at: &SetaInTimePoint) -> Self {
        let contact = Contact::Tips { attached: at.attached, force: at.tip_force, released: at.released };
        Self { time: at.time, displacement: at.displacement, force: at.force, contact, balance: at.balance }
    }
}

impl PointAtRate {
    /// Of a seta how many tips adhere.
    pub fn attached(&self) -> Option<usize> {
        match self.contact {
            Contact::Tips { attached, .. } => Some(attached),
            Contact::Front(_) => None,
        }
    }
}

/// A station of a pull at a rate, or where an event of the user lies.
#[derive(Clone, Copy, Debug)]
pub struct StationAtRate {
    /// Which one of those that were looked for
    pub event: usize,
    /// There
    pub point: PointAtRate,
    /// Of a beam, nm
    pub free_end_gap: Option<f64>,
    /// Whether the quantity jumps past the value
    pub jumped: bool,
    /// It lies behind this one of the points
    pub after: usize,
}

/// A pull at a rate.
#[derive(Clone, Debug)]
pub struct PulledAtRate {
    /// Every step, from rest on
    pub points: Vec<PointAtRate>,
    /// Stations and events of the user, in time
    pub stations: Vec<StationAtRate>,
    /// The event that stopped it, if one has
    pub stopped: Option<Bound>,
    /// The largest force: of a beam by a parabola through the three steps next to it, of a seta that of a step
    pub peak: Option<InTimePeak>,
    /// When nothing adhered any more for the first time, ns
    pub contact_lost: Option<f64>,
    /// The largest defect of the balance of energies, over the largest work
    pub imbalance: f64,
    /// Steps that were tried, those that were refused among them
    pub tried: usize,
    /// Newton iterations
    pub iterations: usize,
    /// Of the mesh
    pub elements: usize,
}

impl From<&InTimeStation> for StationAtRate {
    fn from(&InTimeStation { event, point, free_end_gap, after }: &InTimeStation) -> Self {
        Self { event, point: (&point).into(), free_end_gap: Some(free_end_gap), jumped: false, after }
    }
}

impl From<&SetaInTimeStation> for StationAtRate {
    fn from(&SetaInTimeStation { event, point, jumped, after }: &SetaInTimeStation) -> Self {
        Self { event, point: (&point).into(), free_end_gap: None, jumped, after }
    }
}

impl From<&PullInTime> for PulledAtRate {
    fn from(pulled: &PullInTime) -> Self {
        let points: Vec<PointAtRate> = pulled.points.iter().map(PointAtRate::from).collect();
        Self {
            peak: pulled.peak.or_else(|| largest(&points)),
            points,
            stations: pulled.stations.iter().map(StationAtRate::from).collect(),
            stopped: pulled.stopped.clone(),
            contact_lost: pulled.contact_lost,
            imbalance: pulled.balance_error(),
            tried: pulled.tried,
            iterations: pulled.iterations,
            elements: pulled.elements,
        }
    }
}

impl From<&SetaInTime> for PulledAtRate {
    fn from(pulled: &SetaInTime) -> Self {
        let points: Vec<PointAtRate> = pulled.points.iter().map(PointAtRate::from).collect();
        let lost = pulled.points.iter().find(|point| point.attached == 0);
        Self {
            peak: largest(&points),
            points,
            stations: pulled.stations.iter().map(StationAtRate::from).collect(),
            stopped: pulled.stopped.clone(),
            contact_lost: lost.map(|point| point.time),
            imbalance: pulled.balance_error(),
            tried: pulled.tried,
            iterations: pulled.iterations,
            elements: pulled.elements,
        }
    }
}

/// The step with the largest force.
fn highest(points: &[PointAtRate]) -> Option<&PointAtRate> {
    points.iter().max_by(|a, b| a.force.total_cmp(&b.force))
}

fn largest(points: &[PointAtRate]) -> Option<InTimePeak> {
    let at = highest(points)?;
    Some(InTimePeak { time: at.time, displacement: at.displacement, force: at.force })
}

impl PulledAtRate {
    /// The step next to the largest force.
    pub fn next_to_peak(&self) -> Option<&PointAtRate> {
        highest(&self.points)
    }

    /// Energies at rest before the pull.
    pub fn at_rest(&self) -> EnergyBalance {
        self.points.first().map(|at| at.balance).unwrap_or_default()
    }

    /// Energies at the end against those at rest before the pull.
    pub fn change(&self) -> EnergyBalance {
        let [first, last] = [self.at_rest(), self.points.last().map(|at| at.balance).unwrap_or_default()];
        EnergyBalance {
            work: last.work - first.work,
            stored: last.stored - first.stored,
            adhesion: last.adhesion - first.adhesion,
            spring: last.spring - first.spring,
            kinetic: last.kinetic - first.kinetic,
            dissipated: last.dissipated - first.dissipated,
        }
    }

    /// Mean force from half to nine tenths of the way, by the work there, nN: the steady force of a body that is long enough. On the last of the way the
    /// grip comes to rest, or the body comes off.
    pub fn mean_force(&self) -> Option<f64> {
        let (first, last) = (self.points.first()?, self.points.last()?);
        let at = |share: f64| {
            let place = first.displacement + share * (last.displacement - first.displacement);
            self.points.iter().find(|point| point.displacement >= place)
        };
        let (from, to) = (at(0.5)?, at(0.9)?);
        let way = to.displacement - from.displacement;
        (way > 0.0).then(|| (to.balance.work - from.balance.work) / way)
    }

    /// How far the pull went, nm.
    pub fn way(&self) -> f64 {
        self.points.iter().map(|point| point.displacement).fold(0.0, f64::max)
    }

    /// Steps in time, and points behind events.
    pub fn steps(&self) -> usize {
        self.points.len().saturating_sub(1)
    }

    /// The name of its end in outputs.
    pub fn end(&self, has_failed: bool) -> &'static str {
        match self.contact_lost {
            _ if has_failed => "failed",
            _ if self.stopped.is_some() => "event",
            Some(_) => "detached",
            None => "still-attached",
        }
    }
}

/// The largest force of equilibria.
#[derive(Clone, Copy, Debug)]
pub struct SlowPeak {
    /// nN
    pub force: f64,
    /// nm
    pub displacement: f64,
    /// Bound of the error of a beam's force; of a seta the error with which the peak is located, where it is. nN
    pub error: Option<f64>,
}

/// The equilibria of the scene of a pull at a rate.
#[derive(Clone, Debug)]
pub struct Equilibria {
    /// Displacement (nm) and force (nN)
    pub points: Vec<(f64, f64)>,
    /// The first peak of a beam, the largest force of a seta
    pub peak: Option<SlowPeak>,
}

impl From<&Peel> for Equilibria {
    fn from(peel: &Peel) -> Self {
        let peak = peel.initiation_peak.as_ref().map(|peak| SlowPeak {
            force: peak.force,
            displacement: peak.displacement,
            error: Some(peak.force_error),
        });
        Self { points: peel.points.iter().map(|at| (at.displacement, at.force)).collect(), peak }
    }
}

impl From<&SetaPullOff> for Equilibria {
    fn from(pull_off: &SetaPullOff) -> Self {
        let peak = pull_off.peak.as_ref().map(|peak| SlowPeak {
            force: peak.point.force_along,
            displacement: peak.point.displacement,
            error: peak.location.map(|location| location.force),
        });
        Self { points: pull_off.points.iter().map(|at| (at.displacement, at.force_along)).collect(), peak }
    }
}
