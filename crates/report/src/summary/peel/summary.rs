//! What a run found, as one JSON object: summary.json, and what `--json` prints.

use super::accuracy::AccuracySummary;
use super::branch_point::BranchPoint;
use super::derived::DerivedSummary;
use super::ground::GroundSummary;
use super::limit_point::LimitPoint;
use super::observed::ObservedSummary;
use super::out_of_plane::OutOfPlaneSummary;
use super::sensitivities::SensitivitySummary;
use super::sliding::SlidingSummary;
use super::term_summary::TermDecisionsSummary;
use crate::names::{end_reason, end_word};
use crate::number::Finite;
use crate::summary::{Origin, Parameters, written};
use peelkit::beam::GripState;
use peelkit::model::Step;
use peelkit::solve::Pace;
use peelkit::study::{self, Exponent, Observed, OutOfPlane, OutOfPlaneBranch, Peel};
use peelkit_scene::Scene;

/// Everything of a peel but its curve. Forces in nN, lengths in nm, works in aJ; `None` where a thing does not occur.
#[derive(Debug, serde::Serialize)]
pub struct PeelSummary {
    #[serde(flatten)]
    origin: Origin,
    /// Of a scene in space: whether its solution stays in the plane, where it was computed then.
    solved_in_plane: Option<bool>,
    end: &'static str,
    /// Of the ends `bound` and `failed`.
    reason: Option<String>,
    peak: Option<Peak>,
    /// Where there is no peak: the largest force of the computed curve up to the first jump.
    largest_computed_force: Option<LargestComputedForce>,
    initiation_peak: Option<Peak>,
    plateau: Option<Plateau>,
    limit_points: Vec<LimitPoint>,
    /// Where other branches meet the path.
    branch_points: Vec<BranchPoint>,
    /// Where the model is not to be trusted.
    warnings: Vec<Warning>,
    /// What follows from the model before anything is solved.
    derived: DerivedSummary,
    /// The first jump, under the name that it had before the others.
    snap_off: Option<Fold>,
    /// The first displacement limit point, whatever jumps there.
    first_jump: Option<Fold>,
    /// The one behind which the pad does not adhere any more.
    pad_detachment: Option<Fold>,
    /// The one behind which nothing adheres any more.
    detachment: Option<Fold>,
    accuracy: AccuracySummary,
    /// The relative change of the peak if a term of the model is neglected, to first order.
    terms: Vec<TermEffect>,
    /// What was left out and what not, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    considered: Option<TermDecisionsSummary>,
    path: Effort,
    timing: Timing,
    /// The steps before the pull, as far as they were taken.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    steps: Vec<StepEnd>,
    /// How the beam lies where the path begins, on ground that is not flat.
    #[serde(skip_serializing_if = "Option::is_none")]
    ground: Option<GroundSummary>,
    /// How far the beam has slid at the initiation peak, with friction.
    #[serde(skip_serializing_if = "Option::is_none")]
    sliding: Option<SlidingSummary>,
    /// The stability against leaving the plane, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    out_of_plane: Option<OutOfPlaneSummary>,
    /// The displacement-controlled test, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    observed: Option<ObservedSummary>,
    /// By which power of each parameter the results change, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    sensitivities: Option<Vec<SensitivitySummary>>,
    parameters: Parameters,
}

#[derive(Debug, serde::Serialize)]
struct Peak {
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "end_rotation_rad")]
    end_rotation: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
}

/// Of a point that is not located there is no error bound.
#[derive(Debug, serde::Serialize)]
struct LargestComputedForce {
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    /// Always false: a located one is a peak.
    located: bool,
}

#[derive(Debug, serde::Serialize)]
struct Plateau {
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "error_nN")]
    force_error: Option<Finite>,
    #[serde(rename = "error_nm")]
    displacement_error: Option<Finite>,
    stable: bool,
}

#[derive(Debug, serde::Serialize)]
struct Warning {
    code: &'static str,
    value: Finite,
    limit: Finite,
    meaning: String,
}

#[derive(Debug, serde::Serialize)]
struct Fold {
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "work_aJ")]
    work: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
    #[serde(rename = "error_aJ")]
    work_error: Option<Finite>,
}

#[derive(Debug, serde::Serialize)]
struct Effort {
    points: usize,
    newton_iterations: usize,
    elements: usize,
    order: usize,
    pace: &'static str,
}

/// The grip after a step, relative to where it took hold.
#[derive(Debug, serde::Serialize)]
struct StepEnd {
    step: String,
    /// None where the grip is free along the substrate and nothing looks at it.
    #[serde(rename = "x_nm")]
    x: Option<Finite>,
    #[serde(rename = "y_nm")]
    y: Finite,
    #[serde(rename = "end_rotation_rad")]
    rotation: Finite,
    #[serde(rename = "horizontal_force_nN")]
    horizontal: Finite,
    #[serde(rename = "vertical_force_nN")]
    vertical: Finite,
    #[serde(rename = "moment_nN_nm")]
    moment: Finite,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    in_space: Option<StepInSpace>,
}

/// What the grip behind a step has in space beside one in the plane.
#[derive(Debug, serde::Serialize)]
struct StepInSpace {
    #[serde(rename = "z_nm")]
    z: Finite,
    roll_deg: Finite,
    yaw_deg: Finite,
    #[serde(rename = "lateral_force_nN")]
    lateral: Finite,
    #[serde(rename = "torque_nN_nm")]
    torque: Finite,
    #[serde(rename = "yaw_moment_nN_nm")]
    yaw_moment: Finite,
}

#[derive(Debug, serde::Serialize)]
struct TermEffect {
    left_out: &'static str,
    #[serde(rename = "initiation_peak_change_nN")]
    force: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Timing {
    solve_s: Finite,
}

impl PeelSummary {
    /// The summary of the peel of this scene, which took so many seconds.
    pub fn new(scene: &Scene, peel: &Peel, solve_s: f64) -> Self {
        Self {
            origin: Origin::of(scene),
            solved_in_plane: scene.model.space.map(|_| peel.model.space.is_none()),
            end: end_word(&peel.end),
            reason: end_reason(&peel.end),
            peak: peel.peak.map(Peak::from),
            largest_computed_force: peel.largest_computed_force.map(|at| LargestComputedForce {
                force: Finite(at.force),
                displacement: Finite(at.displacement),
                located: false,
            }),
            initiation_peak: peel.initiation_peak.map(Peak::from),
            plateau: peel.plateau.map(|at| Plateau {
                force: Finite(at.force),
                displacement: Finite(at.displacement),
                force_error: at.force_error.map(Finite),
                displacement_error: at.displacement_error.map(Finite),
                stable: at.stable,
            }),
            limit_points: peel.limit_points.iter().map(LimitPoint::from).collect(),
            branch_points: peel.branch_points.iter().map(BranchPoint::from).collect(),
            warnings: peel.warnings().iter().map(Warning::from).collect(),
            derived: DerivedSummary::of(&scene.model),
            snap_off: peel.snap_off.map(Fold::from),
            first_jump: peel.snap_off.map(Fold::from),
            pad_detachment: peel.pad_detachment.map(Fold::from),
            detachment: peel.detachment.map(Fold::from),
            accuracy: AccuracySummary::of(peel),
            terms: peel.terms().iter().map(TermEffect::from).collect(),
            considered: peel.considered.as_ref().map(TermDecisionsSummary::from),
            path: Effort {
                points: peel.effort.points,
                newton_iterations: peel.effort.newton_iterations,
                elements: peel.effort.elements,
                order: peel.effort.order,
                pace: match peel.effort.pace {
                    Pace::Quick => "quick",
                    Pace::Wary => "wary",
                    Pace::Watchful => "watchful",
                },
            },
            timing: Timing { solve_s: Finite(solve_s) },
            steps: peel.model.steps.iter().zip(&peel.steps).map(StepEnd::from).collect(),
            ground: GroundSummary::of(peel),
            sliding: SlidingSummary::of(peel),
            out_of_plane: None,
            observed: None,
            sensitivities: None,
            parameters: Parameters(scene.clone()),
        }
    }

    /// The same with what a test of this scene would record, which took so many seconds.
    pub fn with_observed(self, test: &Observed, solve_s: f64) -> Self {
        Self { observed: Some(ObservedSummary::new(test, solve_s)), ..self }
    }

    /// The same with the exponents of its results by the parameters with these keys.
    pub fn with_sensitivities(self, exponents: &[Exponent], keys: &[String]) -> Self {
        let one = |exponent| SensitivitySummary::new(exponent, keys);
        Self { sensitivities: Some(exponents.iter().map(one).collect()), ..self }
    }

    /// The same with the stability against leaving the plane, which took so many seconds.
    pub fn with_out_of_plane(self, stability: &OutOfPlane, solve_s: f64) -> Self {
        Self { out_of_plane: Some(OutOfPlaneSummary::new(stability, solve_s)), ..self }
    }

    /// The same with the branch that leaves the plane, where there is one, which took so many seconds; behind the stability against that.
    pub fn with_branch(self, branch: Option<&OutOfPlaneBranch>, solve_s: f64) -> Self {
        Self { out_of_plane: self.out_of_plane.map(|stability| stability.with_branch(branch, solve_s)), ..self }
    }
}

written!(PeelSummary);

impl From<(&Step, &GripState)> for StepEnd {
    fn from((step, grip): (&Step, &GripState)) -> Self {
        Self {
            step: step.to_string(),
            x: grip.x.map(Finite),
            y: Finite(grip.y),
            rotation: Finite(grip.rotation),
            horizontal: Finite(grip.forces.horizontal),
            vertical: Finite(grip.forces.vertical),
            moment: Finite(grip.forces.moment),
            in_space: grip.in_space.zip(grip.forces.in_space).map(|(place, forces)| StepInSpace {
                z: Finite(place.z),
                roll_deg: Finite(place.roll.to_degrees()),
                yaw_deg: Finite(place.yaw.to_degrees()),
                lateral: Finite(forces.lateral),
                torque: Finite(forces.torque),
                yaw_moment: Finite(forces.yaw_moment),
            }),
        }
    }
}

impl From<&study::TermEffect> for TermEffect {
    fn from(effect: &study::TermEffect) -> Self {
        Self { left_out: effect.term.word(), force: Finite(effect.force) }
    }
}

impl From<&study::Warning> for Warning {
    fn from(warning: &study::Warning) -> Self {
        Self {
            code: warning.kind.code(),
            value: Finite(warning.value),
            limit: Finite(warning.limit),
            meaning: warning.to_string(),
        }
    }
}

impl From<study::Peak> for Peak {
    fn from(at: study::Peak) -> Self {
        Self {
            force: Finite(at.force),
            displacement: Finite(at.displacement),
            end_rotation: Finite(at.end_rotation),
            force_error: Finite(at.force_error),
            displacement_error: Finite(at.displacement_error),
        }
    }
}

impl From<study::LimitPoint> for Fold {
    fn from(at: study::LimitPoint) -> Self {
        Self {
            displacement: Finite(at.displacement),
            force: Finite(at.force),
            work: Finite(at.work),
            displacement_error: Finite(at.displacement_error),
            force_error: Finite(at.force_error),
            work_error: at.work_error.map(Finite),
        }
    }
}
