//! A pull at a rate as one JSON object: summary.json, and what `--json` prints.

use super::S_PER_NS;
use crate::number::Finite;
use crate::summary::{Parameters, SCHEMA, VERSION, written};
use peelkit::study::{Peak, Peel, PullInTime};
use peelkit_scene::Scene;

/// Everything of a pull at a rate but its curve.
#[derive(Debug, serde::Serialize)]
pub struct RateSummary {
    version: &'static str,
    schema: u32,
    command: Option<String>,
    scene: String,
    title: String,
    end: &'static str,
    reason: Option<String>,
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
}

/// The first peak of the equilibria.
#[derive(Debug, serde::Serialize)]
struct Slow {
    #[serde(rename = "force_nN")]
    force: Finite,
    displacement_nm: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
}

impl From<&Peak> for Slow {
    fn from(at: &Peak) -> Self {
        Self { force: Finite(at.force), displacement_nm: Finite(at.displacement), force_error: Finite(at.force_error) }
    }
}

/// What became of the work, from rest to the end.
#[derive(Debug, serde::Serialize)]
struct Balance {
    #[serde(rename = "work_aJ")]
    work: Finite,
    #[serde(rename = "stored_aJ")]
    stored: Finite,
    #[serde(rename = "adhesion_aJ")]
    adhesion: Finite,
    #[serde(rename = "spring_aJ")]
    spring: Finite,
    #[serde(rename = "kinetic_aJ")]
    kinetic: Finite,
    #[serde(rename = "dissipated_aJ")]
    dissipated: Finite,
    imbalance: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Effort {
    steps: usize,
    steps_tried: usize,
    newton_iterations: usize,
    elements: usize,
}

/// Seconds of the pull and of the equilibria.
#[derive(Debug, serde::Serialize)]
struct Timing {
    solve_s: Finite,
    equilibria_s: Finite,
}

impl RateSummary {
    /// The summary of the pull of this scene, with the equilibria beside it and why it stopped short, if it did; seconds of both.
    pub fn new(
        scene: &Scene,
        pulled: &PullInTime,
        equilibria: &Peel,
        failed: Option<&str>,
        [solve_s, equilibria_s]: [f64; 2],
    ) -> Self {
        let slow = equilibria.initiation_peak.as_ref();
        let largest = pulled.points.iter().max_by(|a, b| a.force.total_cmp(&b.force)).map(|point| {
            let (time, displacement, force) = pulled
                .peak
                .map_or((point.time, point.displacement, point.force), |at| (at.time, at.displacement, at.force));
            Largest {
                force: Finite(force),
                displacement_nm: Finite(displacement),
                time_s: Finite(S_PER_NS * time),
                kinetic: Finite(point.balance.kinetic),
                dissipated: Finite(point.balance.dissipated),
            }
        });
        let (first, last) = (pulled.points.first().copied().unwrap_or_default().balance, pulled.last().balance);
        Self {
            version: VERSION,
            schema: SCHEMA,
            command: None,
            scene: scene.name.clone(),
            title: scene.title.clone(),
            end: match (failed, pulled.contact_lost) {
                (Some(_), _) => "failed",
                (None, Some(_)) => "detached",
                (None, None) => "still-attached",
            },
            reason: failed.map(str::to_owned),
            largest_force: largest,
            contact_lost_s: pulled.contact_lost.map(|time| Finite(S_PER_NS * time)),
            equilibria_peak: slow.map(Slow::from),
            force_over_equilibria: slow.map(|slow| Finite(pulled.largest_force() / slow.force)),
            balance: Balance {
                work: Finite(last.work),
                stored: Finite(last.stored - first.stored),
                adhesion: Finite(last.adhesion - first.adhesion),
                spring: Finite(last.spring - first.spring),
                kinetic: Finite(last.kinetic - first.kinetic),
                dissipated: Finite(last.dissipated - first.dissipated),
                imbalance: Finite(pulled.balance_error()),
            },
            path: Effort {
                steps: pulled.points.len().saturating_sub(1),
                steps_tried: pulled.tried,
                newton_iterations: pulled.iterations,
                elements: pulled.elements,
            },
            timing: Timing { solve_s: Finite(solve_s), equilibria_s: Finite(equilibria_s) },
            parameters: Parameters(scene.clone()),
        }
    }
}

written!(RateSummary);
