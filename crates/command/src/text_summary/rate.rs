//! The summary of a pull at a rate.

use super::found::passed_lines;
use super::number::in_columns;
use super::units::Units;
use peelkit::model::PullCurve;
use peelkit::study::{SetaInTimeEvent, TipLoss};
use peelkit::units::PreferredUnits;
use peelkit_report::{Equilibria, PassedAt, PulledAtRate, TipEvents, tip_peak};
use peelkit_scene::Scene;

/// The law of a seta's tips, which took so many seconds, and how they leave it.
#[derive(Clone, Copy)]
pub struct LawOfTips<'s> {
    /// How many there are
    pub tips: usize,
    pub curve: &'s PullCurve,
    pub events: &'s [SetaInTimeEvent],
    pub seconds: f64,
}

/// The summary of a pull with the equilibria beside it, of a seta with the law of its tips, and why it stopped short, if it did; all of it took so
/// many seconds.
pub fn rate(
    scene: &Scene,
    (pulled, equilibria): (&PulledAtRate, &Equilibria),
    law: Option<LawOfTips>,
    (failed, solve_s): (Option<&str>, f64),
    wanted: PreferredUnits,
) -> String {
    let change = pulled.change();
    let largest = pulled.peak.map_or(0.0, |at| at.force);
    let units = Units::fitting(wanted, [largest.abs(), pulled.way(), change.work.abs()]);
    let Units { force, length, work } = units;
    let attached = pulled.next_to_peak().and_then(|at| at.attached()).zip(law);
    let attached =
        attached.map_or(String::new(), |(attached, law)| format!(", {attached} of {} tips attached", law.tips));
    let peak = pulled.peak.map_or("none".to_owned(), |at| {
        let place = format!("at U = {}, t = {:.4e} s", length.short(at.displacement), 1e-9 * at.time);
        format!("{} {place}{attached}", force.short(at.force))
    });
    let slow = equilibria.peak.as_ref();
    let ratio = slow.map_or(String::new(), |slow| format!(", {:.6} of it at the rate", largest / slow.force));
    let equilibria = slow.map_or("none".to_owned(), |slow| {
        format!("{} at u = {}", force.short(slow.force), length.short(slow.displacement))
    });
    let energy = format!(
        "work {} = stored {} + adhesion {} + kinetic {} + dissipated {}, to {:.0e}",
        work.short(change.work),
        work.short(change.stored + change.spring),
        work.short(change.adhesion),
        work.short(change.kinetic),
        work.short(change.dissipated),
        pulled.imbalance
    );
    let how = match (failed, pulled.contact_lost) {
        (Some(why), _) => format!("failed: {why}"),
        _ if pulled.stopped.is_some() => {
            let event = pulled.stopped.as_ref().map(ToString::to_string).unwrap_or_default();
            format!("event: the pull is followed no further: {event}")
        }
        (None, Some(time)) => format!("detached at t = {:.4e} s", 1e-9 * time),
        (None, None) => "still-attached".to_owned(),
    };
    let effort = format!(
        "{} steps of {} tried, {} Newton iterations, {} elements, {:.0} ms",
        pulled.steps(),
        pulled.tried,
        pulled.iterations,
        pulled.elements,
        1e3 * solve_s
    );
    let mut lines = vec![("largest force", peak), ("equilibria", format!("peak {equilibria}{ratio}"))];
    let mean = pulled.mean_force().filter(|_| failed.is_none());
    lines.extend(mean.map(|mean| ("mean force", format!("{} from half to nine tenths of the way", force.short(mean)))));
    if let Some(LawOfTips { curve, events, .. }) = law {
        let (of_tip, off) = (tip_peak(curve), curve.snap_off());
        lines.insert(0, ("law of a tip", format!("peak {of_tip:.6} nN, snaps off at {off:.4} nm")));
        let of_tips = TipEvents::of(events.iter().map(|event| &event.tips[..]));
        let unstable = events.iter().filter(|event| event.loss == TipLoss::Unstable).count();
        let text = format!(
            "{}: {} tips leave their branch, at most {} at once; {unstable} are losses of stability",
            of_tips.count,
            of_tips.tips_detached + of_tips.tips_adhered,
            of_tips.most_tips_at_once
        );
        lines.push(("events", text));
    }
    let looked_for = scene.looked_for();
    lines.extend(passed_lines(&PassedAt::of_rate(pulled, &looked_for), &looked_for, &units));
    lines.extend([("energy", energy), ("end", how), ("computed", effort)]);
    in_columns(&scene.title, &lines)
}
