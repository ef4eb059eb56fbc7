//! The summary of a pull at a rate.

use super::layout::in_columns;
use super::units::{Units, WantedUnits};
use peelkit::study::{Peel, PullInTime};
use peelkit_scene::Scene;

/// The summary of a pull with the equilibria beside it, and why it stopped short, if it did; both took so many seconds.
pub fn rate(
    scene: &Scene,
    pulled: &PullInTime,
    equilibria: &Peel,
    (failed, solve_s): (Option<&str>, f64),
    wanted: WantedUnits,
) -> String {
    let last = pulled.last();
    let Units { force, length, work } =
        Units::fitting(wanted, [pulled.largest_force().abs(), last.displacement.abs(), last.balance.work.abs()]);
    let place =
        pulled.peak.map(|at| format!(" at U = {}, t = {:.4e} s", length.short(at.displacement), 1e-9 * at.time));
    let slow = equilibria.initiation_peak.as_ref();
    let ratio =
        slow.map_or(String::new(), |slow| format!(", {:.6} of it at the rate", pulled.largest_force() / slow.force));
    let equilibria = slow.map_or("none".to_owned(), |slow| {
        format!("{} at u = {}", force.short(slow.force), length.short(slow.displacement))
    });
    let start = pulled.points.first().copied().unwrap_or_default().balance;
    let end = &last.balance;
    let energy = format!(
        "work {} = stored {} + adhesion {} + kinetic {} + dissipated {}, to {:.0e}",
        work.short(end.work),
        work.short(end.stored + end.spring - start.stored - start.spring),
        work.short(end.adhesion - start.adhesion),
        work.short(end.kinetic - start.kinetic),
        work.short(end.dissipated),
        pulled.balance_error()
    );
    let how = match (failed, pulled.contact_lost) {
        (Some(why), _) => format!("failed: {why}"),
        (None, Some(time)) => format!("detached at t = {:.4e} s", 1e-9 * time),
        (None, None) => "still-attached".to_owned(),
    };
    let effort = format!(
        "{} steps of {} tried, {} Newton iterations, {} elements, {:.0} ms",
        pulled.points.len().saturating_sub(1),
        pulled.tried,
        pulled.iterations,
        pulled.elements,
        1e3 * solve_s
    );
    let lines = [
        ("largest force", format!("{}{}", force.short(pulled.largest_force()), place.unwrap_or_default())),
        ("equilibria", format!("peak {equilibria}{ratio}")),
        ("energy", energy),
        ("end", how),
        ("computed", effort),
    ];
    in_columns(&scene.title, &lines)
}
