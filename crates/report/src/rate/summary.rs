//! A pull at a rate as one JSON object: summary.json, and what `--json` prints.

use super::energies::Energies;
use super::pulled::{Contact, Equilibria, PulledAtRate, SlowPeak};
use crate::number::{Finite, S_PER_NS};
use crate::seta::{LawOfTips, TipEvents};
use crate::summary::{Origin, Parameters, written};
use peelkit::model::PullCurve;
use peelkit::study::{SetaInTime, TipLoss};
use peelkit_scene::Scene;

/// Everything of a pull at a rate but its curve.
#[derive(Debug, serde::Serialize)]
pub struct RateSummary {
    #[serde(flatten)]
    origin: Origin,
    end: &'static str,
    reason: Option<String>,
    #[serde(flatten)]
    seta: Option<OfSeta>,
    largest_force: Option<Largest>,
    contact_lost_s: Option<Finite>,
    equilibria_peak: Option<Slow>,
    force_over_equilibria: Option<Finite>,
    balance: Balance,
    path: Effort,
    timing: Timing,
    parameters: Parameters,
}

/// Where the force is largest.
#[derive(Debug, serde::Serialize)]
struct Largest {
    #[serde(rename = "force_nN")]
    force: Finite,
    displacement_nm: Finite,
    time_s: Finite,
    #[serde(rename = "kinetic_aJ")]
    kinetic: Finite,
    #[serde(rename = "dissipated_aJ")]
    dissipated: Finite,
    /// Of a seta
    #[serde(skip_serializing_if = "Option::is_none")]
    tips_attached: Option<usize>,
}

/// What a pull of a seta has besides.
#[derive(Debug, serde::Serialize)]
struct OfSeta {
    tips: usize,
    events: Events,
    tip: LawOfTips,
}

/// Where tips leave the branch of their law.
#[derive(Debug, serde::Serialize)]
struct Events {
    #[serde(flatten)]
    tips: TipEvents,
    unstable: usize,
}

impl From<&SetaInTime> for Events {
    fn from(SetaInTime { events, .. }: &SetaInTime) -> Self {
        Self {
            tips: TipEvents::of(events.iter().map(|event| &event.tips[..])),
            unstable: events.iter().filter(|event| event.loss == TipLoss::Unstable).count(),
        }
    }
}

/// The peak of the equilibria.
#[derive(Debug, serde::Serialize)]
struct Slow {
    #[serde(rename = "force_nN")]
    force: Finite,
    displacement_nm: Finite,
    #[serde(rename = "error_nN")]
    error: Option<Finite>,
}

impl From<&SlowPeak> for Slow {
    fn from(at: &SlowPeak) -> Self {
        Self { force: Finite(at.force), displacement_nm: Finite(at.displacement), error: at.error.map(Finite) }
    }
}

/// What became of the work, from rest to the end.
#[derive(Debug, serde::Serialize)]
struct Balance {
    #[serde(flatten)]
    energies: Energies,
    /// The part of it at events, of a seta
    #[serde(rename = "released_aJ", skip_serializing_if = "Option::is_none")]
    released: Option<Finite>,
    imbalance: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Effort {
    steps: usize,
    steps_tried: usize,
    newton_iterations: usize,
    elements: usize,
}

/// Seconds of the law of a seta's tips, of the pull and of the equilibria.
#[derive(Debug, serde::Serialize)]
struct Timing {
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_s: Option<Finite>,
    solve_s: Finite,
    equilibria_s: Finite,
}

impl RateSummary {
    /// The summary of the pull of this scene, with the equilibria beside it and why it stopped short, if it did; seconds of both.
    pub fn new(
        scene: &Scene,
        pulled: &PulledAtRate,
        equilibria: &Equilibria,
        failed: Option<&str>,
        [solve_s, equilibria_s]: [f64; 2],
    ) -> Self {
        let slow = equilibria.peak.as_ref();
        let largest = pulled.peak.zip(pulled.next_to_peak()).map(|(at, next)| Largest {
            force: Finite(at.force),
            displacement_nm: Finite(at.displacement),
            time_s: Finite(S_PER_NS * at.time),
            kinetic: Finite(next.balance.kinetic),
            dissipated: Finite(next.balance.dissipated),
            tips_attached: next.attached(),
        });
        let released = pulled.points.last().and_then(|last| match last.contact {
            Contact::Tips { released, .. } => Some(Finite(released)),
            Contact::Front(_) => None,
        });
        Self {
            origin: Origin::of(scene),
            end: pulled.end(failed.is_some()),
            reason: failed.map(str::to_owned),
            seta: None,
            largest_force: largest,
            contact_lost_s: pulled.contact_lost.map(|time| Finite(S_PER_NS * time)),
            equilibria_peak: slow.map(Slow::from),
            force_over_equilibria: slow.zip(pulled.peak).map(|(slow, at)| Finite(at.force / slow.force)),
            balance: Balance {
                energies: Energies::from(pulled.change()),
                released,
                imbalance: Finite(pulled.imbalance),
            },
            path: Effort {
                steps: pulled.steps(),
                steps_tried: pulled.tried,
                newton_iterations: pulled.iterations,
                elements: pulled.elements,
            },
            timing: Timing { tip_s: None, solve_s: Finite(solve_s), equilibria_s: Finite(equilibria_s) },
            parameters: Parameters(scene.clone()),
        }
    }

    /// With what a seta of so many tips has besides, whose law took so many seconds.
    pub fn with_seta(self, tips: usize, tip: &PullCurve, pulled: &SetaInTime, tip_s: f64) -> Self {
        let seta = OfSeta { tips, events: Events::from(pulled), tip: LawOfTips::from(tip) };
        Self { seta: Some(seta), timing: Timing { tip_s: Some(Finite(tip_s)), ..self.timing }, ..self }
    }
}

written!(RateSummary);
