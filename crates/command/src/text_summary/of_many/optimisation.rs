//! What an optimisation found, as a person reads it.

use crate::text_summary::number::{short, spaced, with_error};
use peelkit::study::optimisation::{Certificate, DesignProblem, DesignVariable, Goal, Objective, Optimum};
use peelkit_report::unknown_error;
use peelkit_scene::{Key, Scene, find_key};
use std::fmt::Write;

/// Most active constraints and bounds that are named.
const NAMED: usize = 8;

/// The objective and the variables before and after, and why that is an optimum.
pub fn optimum(scene: &Scene, problem: &DesignProblem, optimum: &Optimum, solve_s: f64) -> String {
    let quantity = problem.objective.quantity();
    let (of, unit) = match problem.objective {
        Objective::Quantity(_) => (quantity.name().to_owned(), quantity.unit()),
        Objective::Ratio { holding_angle, release_angle, .. } => {
            let [above, below] = [holding_angle, release_angle].map(|angle| short(angle.to_degrees()));
            (format!("{} at {above} deg over that at {below} deg", quantity.name()), "")
        }
    };
    let goal = if problem.goal == Goal::Maximise { "largest" } else { "smallest" };
    let mut text = format!("{}\n{goal} {of}\n\n", scene.title);
    for (name, design) in [("before", &optimum.before), ("after", &optimum.after)] {
        let value = design.error.map_or_else(|| short(design.objective), |error| with_error(design.objective, error));
        let _ = writeln!(text, "{name:<8} {value}{}", spaced(unit));
    }
    let gain = optimum.gain_error.map_or_else(|| short(optimum.gain), |error| with_error(optimum.gain, error));
    let _ = writeln!(text, "{:<8} {gain} times\n", "gain");
    let _ = writeln!(text, "{:<44} {:>12} {:>12} {:>10}", "variable", "before", "after", "±");
    for (k, variable) in problem.variables.iter().enumerate() {
        let error = optimum.value_errors.as_ref().map_or_else(|| "-".to_owned(), |errors| format!("{:.0e}", errors[k]));
        let [before, after] = [&optimum.before, &optimum.after].map(|design| short(design.values[k]));
        let _ = writeln!(text, "{:<44} {before:>12} {after:>12} {error:>10}", named(variable));
    }
    let evaluations: usize = optimum.searches.iter().map(|search| search.evaluations.len()).sum();
    let ends: Vec<&str> = optimum.searches.iter().map(|search| search.end.word()).collect();
    let searches = if ends.len() == 1 { "search" } else { "searches" };
    let _ = writeln!(text, "\n{} {searches} ({}), {evaluations} designs, {solve_s:.2} s", ends.len(), ends.join(", "));
    text += &optimum.certificate.as_ref().map_or_else(String::new, certificate);
    if let Some(unknown) = unknown_error(scene) {
        let _ = writeln!(text, "{unknown}");
    }
    text
}

fn named(variable: &DesignVariable) -> String {
    let unit = if variable.along.is_some() { "" } else { find_key(&variable.name).map_or("", Key::unit) };
    if unit.is_empty() { variable.name.clone() } else { format!("{} ({unit})", variable.name) }
}

fn certificate(of: &Certificate) -> String {
    let mut text = String::new();
    if let (Some(projected), Some(gradient)) = (of.projected_gradient, of.gradient) {
        let _ = writeln!(text, "projected gradient {projected:.1e}, without the constraints {gradient:.1e}");
    }
    let neighbours = of.neighbours;
    if neighbours.computed > 0 {
        let _ = writeln!(
            text,
            "{} of {} random feasible neighbours are better; the best of them by {:.1e}",
            neighbours.better, neighbours.computed, neighbours.largest_gain
        );
    }
    if let Some(check) = of.check {
        let _ = writeln!(text, "a search without gradients gains {:.1e} in {} designs", check.gain, check.evaluations);
    }
    if !of.active.is_empty() {
        let _ = writeln!(text, "active, with what ln of the objective would gain if they gave way:");
        for active in of.active.iter().take(NAMED) {
            let _ = writeln!(text, "  {:<56} {:>10.2e}", active.name, active.multiplier);
        }
        if of.active.len() > NAMED {
            let _ = writeln!(text, "  and {} more: see summary.json", of.active.len() - NAMED);
        }
    }
    text
}
