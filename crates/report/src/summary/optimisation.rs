//! What an optimisation found, as one JSON object.

use super::origin::Origin;
use super::parameters::Parameters;
use super::written::written;
use crate::number::Finite;
use peelkit::study::optimisation::{
    ActiveConstraint, Certificate, Design, DesignProblem, Goal, Objective, Optimum, SearchResult, volume,
};
use peelkit_scene::{Key, Scene, find_key};
use serde::Serialize;

/// An optimisation as one object; `None` where a thing does not occur.
#[derive(Debug, Serialize)]
pub struct OptimisationSummary {
    #[serde(flatten)]
    origin: Origin,
    of: &'static str,
    goal: &'static str,
    /// Of both peels of a ratio
    holding_angle_rad: Option<Finite>,
    release_angle_rad: Option<Finite>,
    before: DesignSummary,
    after: DesignSummary,
    gain: Finite,
    gain_error: Option<Finite>,
    variables: Vec<VariableSummary>,
    constraints: usize,
    searches: Vec<SearchSummary>,
    best_search: usize,
    certificate: Option<CertificateSummary>,
    unfinished: bool,
    timing: Timing,
    parameters: Parameters,
}

#[derive(Debug, Serialize)]
struct DesignSummary {
    objective: Finite,
    error: Option<Finite>,
    volume_nm3: Option<Finite>,
}

#[derive(Debug, Serialize)]
struct VariableSummary {
    name: String,
    unit: Option<&'static str>,
    lower: Finite,
    upper: Finite,
    before: Finite,
    after: Finite,
    error: Option<Finite>,
}

#[derive(Debug, Serialize)]
struct SearchSummary {
    evaluations: usize,
    bad: usize,
    objective: Option<Finite>,
    end: &'static str,
}

#[derive(Debug, Serialize)]
struct CertificateSummary {
    gradient: Option<Finite>,
    projected_gradient: Option<Finite>,
    active: Vec<ActiveSummary>,
    neighbours: NeighboursSummary,
    check: Option<CheckSummary>,
}

#[derive(Debug, Serialize)]
struct ActiveSummary {
    name: String,
    multiplier: Finite,
}

#[derive(Debug, Serialize)]
struct NeighboursSummary {
    computed: usize,
    bad: usize,
    better: usize,
    largest_gain: Option<Finite>,
}

#[derive(Debug, Serialize)]
struct CheckSummary {
    gain: Finite,
    evaluations: usize,
}

#[derive(Debug, Serialize)]
struct Timing {
    solve_s: Finite,
}

impl OptimisationSummary {
    /// Of what was found of this problem of the scene, in so many seconds.
    pub fn new(scene: &Scene, problem: &DesignProblem, optimum: &Optimum, solve_s: f64) -> Self {
        let (holding, release) = match problem.objective {
            Objective::Ratio { holding_angle, release_angle, .. } => {
                (Some(Finite(holding_angle)), Some(Finite(release_angle)))
            }
            Objective::Quantity(_) => (None, None),
        };
        Self {
            origin: Origin::of(scene),
            of: problem.objective.quantity().name(),
            goal: match problem.goal {
                Goal::Maximise => "maximise",
                Goal::Minimise => "minimise",
            },
            holding_angle_rad: holding,
            release_angle_rad: release,
            before: design(problem, &optimum.before),
            after: design(problem, &optimum.after),
            gain: Finite(optimum.gain),
            gain_error: optimum.gain_error.map(Finite),
            variables: variables(problem, optimum),
            constraints: problem.constraints.len(),
            searches: optimum.searches.iter().map(search).collect(),
            best_search: optimum.best_search,
            certificate: optimum.certificate.as_ref().map(certificate),
            unfinished: optimum.unfinished,
            timing: Timing { solve_s: Finite(solve_s) },
            parameters: Parameters(scene.clone()),
        }
    }
}

written!(OptimisationSummary);

fn design(problem: &DesignProblem, design: &Design) -> DesignSummary {
    DesignSummary {
        objective: Finite(design.objective),
        error: design.error.map(Finite),
        volume_nm3: (problem.model)(&design.values).map(|model| Finite(volume(&model))),
    }
}

fn variables(problem: &DesignProblem, optimum: &Optimum) -> Vec<VariableSummary> {
    let one = |(k, variable): (usize, &peelkit::study::optimisation::DesignVariable)| {
        let unit = match variable.along {
            Some(_) => "nm",
            None => find_key(&variable.name).map_or("", Key::unit),
        };
        VariableSummary {
            name: variable.name.clone(),
            unit: Some(unit).filter(|unit| !unit.is_empty()),
            lower: Finite(variable.lower),
            upper: Finite(variable.upper),
            before: Finite(optimum.before.values[k]),
            after: Finite(optimum.after.values[k]),
            error: optimum.value_errors.as_ref().map(|errors| Finite(errors[k])),
        }
    };
    problem.variables.iter().enumerate().map(one).collect()
}

fn search(search: &SearchResult) -> SearchSummary {
    let log_value = search.best.and_then(|best| search.evaluations[best].log_value);
    SearchSummary {
        evaluations: search.evaluations.len(),
        bad: search.evaluations.iter().filter(|design| design.log_value.is_none()).count(),
        objective: log_value.map(|value| Finite(value.exp())),
        end: search.end.word(),
    }
}

fn certificate(of: &Certificate) -> CertificateSummary {
    let active =
        |active: &ActiveConstraint| ActiveSummary { name: active.name.clone(), multiplier: Finite(active.multiplier) };
    let neighbours = of.neighbours;
    CertificateSummary {
        gradient: of.gradient.map(Finite),
        projected_gradient: of.projected_gradient.map(Finite),
        active: of.active.iter().map(active).collect(),
        neighbours: NeighboursSummary {
            computed: neighbours.computed,
            bad: neighbours.bad,
            better: neighbours.better,
            largest_gain: (neighbours.computed > 0).then_some(Finite(neighbours.largest_gain)),
        },
        check: of.check.map(|check| CheckSummary { gain: Finite(check.gain), evaluations: check.evaluations }),
    }
}
