//! The work of peeling up to the snap-off against the bending stiffness, and where it is largest.

use super::stiffness::{LENGTH, spatula, stiffened, table};
use crate::figures::figure::Figure;
use crate::figures::runner::Runner;
use peelkit_report::chart::{Axis, Frame, Mark, Note, Picture, Stroke, Symbol, WIDTH, colour, significant};
use peelkit_report::pictures::sweep::{STIFFNESS_LABEL, WORK, dotted, panel, series, work_per_width};
use peelkit_report::{ReportError, SweepRow};
use std::path::Path;

/// Parabolas laid through three peels each, the last vertex being peeled too.
const PARABOLAS: usize = 3;

/// How many peels the figure takes besides the sweep that it is given.
pub(in crate::figures) const PEELS: usize = 3 * PARABOLAS + 1;

/// The figure for a sweep of EI alone; its largest work is refined by further peels.
pub(in crate::figures) fn figure(runner: &Runner<'_>, rows: &[SweepRow], dir: &Path) -> Result<Figure, ReportError> {
    let refined =
        refine_largest(rows, |cases| runner.sweep(&cases.iter().map(|&f| (f, stiffened(f))).collect::<Vec<_>>()));
    let mut shown = rows.to_vec();
    shown.extend(refined.iter().cloned());
    shown.sort_by(|a, b| a.value.total_cmp(&b.value));
    let mut caption = format!(
        "Work done by the grip on a strip of {LENGTH} nm up to the snap-off, per width, against its bending \
         stiffness (EI alone varied, full line load)."
    );
    let largest = refined.last().and_then(|row| Some((row, work_per_width(row)?)));
    match largest {
        Some((row, work)) => {
            let (at, work) = (significant(row.value, 3), significant(work, 5));
            caption += &format!(" It is largest at EI/EI0 = {at}: {work} aJ/nm");
            caption += &format!(" (refined by {PARABOLAS} parabolas in log EI).");
        }
        None => caption += " It has no largest value inside the range.",
    }
    if let Some(row) = shown.iter().rev().take_while(|row| row.found.snap_off.is_none()).last() {
        let from = significant(row.value, 3);
        caption += &format!(
            " From EI/EI0 = {from} on no work is shown: the strip tilts upright as a whole and has no snap-off."
        );
    }
    caption += " The shaded range of a gecko spatula (h = 5 to 20 nm at E = 2 GPa) is ours.";
    let picture = picture(&shown, largest);
    Figure::write(dir, "peeling-work", caption, &picture, &table(&[("EI alone", colour::GREEN, &shown)]))
}

fn picture(rows: &[SweepRow], largest: Option<(&SweepRow, f64)>) -> Picture {
    let x = Axis::around(STIFFNESS_LABEL, rows.iter().map(|r| r.value), true);
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 380.0 };
    let lines = series(rows, work_per_width, Stroke::solid(colour::GREEN, 2.2), "work to snap-off");
    let mut panel = dotted(panel(frame, &x, WORK, lines));
    panel.bands.push(spatula());
    panel.y.to += 0.1 * (panel.y.to - panel.y.from);
    if let Some((row, work)) = largest {
        let text = vec![
            "largest work".into(),
            format!("EI / EI₀ = {}", significant(row.value, 3)),
            format!("W/b = {} aJ/nm", significant(work, 4)),
        ];
        let note = Some(Note { badge: None, text });
        let at = (row.value, work);
        panel.marks.push(Mark { at, symbol: Symbol::Diamond, colour: colour::INK, name: None, note });
    }
    Picture { title: "Peeling work against bending stiffness".into(), height: 434, panels: vec![panel] }
}

/// Peels around the largest work, the last one at its place: the vertex of parabolas through three works in log EI.
/// None where the largest work lies at the rim of the rows or beside a missing value.
fn refine_largest(rows: &[SweepRow], peel: impl Fn(&[f64]) -> Vec<SweepRow>) -> Vec<SweepRow> {
    let works: Vec<f64> = rows.iter().map(|row| work_per_width(row).unwrap_or(f64::NEG_INFINITY)).collect();
    let top = (0..works.len()).max_by(|&a, &b| works[a].total_cmp(&works[b])).unwrap_or(0);
    let inside = top > 0 && top + 1 < rows.len() && works[top - 1..=top + 1].iter().all(|w| w.is_finite());
    if !inside {
        return Vec::new();
    }
    let mut peeled = Vec::new();
    let mut centre = rows[top].value.log10();
    let mut step = 0.5 * (rows[top + 1].value.log10() - centre);
    for _ in 0..PARABOLAS {
        let three = peel(&[centre - step, centre, centre + step].map(|c| 10f64.powf(c)));
        let works: Vec<f64> = three.iter().filter_map(work_per_width).collect();
        let &[left, middle, right] = works.as_slice() else { return Vec::new() };
        peeled.extend(three);
        let bend = left - 2.0 * middle + right;
        if bend >= 0.0 {
            return Vec::new();
        }
        centre += (0.5 * step * (left - right) / bend).clamp(-step, step);
        // Not too fine: the error of the work would move the vertex.
        step *= 0.5;
    }
    peeled.extend(peel(&[10f64.powf(centre)]));
    peeled
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::runner::{ACCURACY, BOUNDS};
    use peelkit::study::{LimitPoint, LimitPointKind, PeelResult};

    /// Rows that have no path but a work: of a curve that is largest at log EI = 0.37.
    fn rows(values: &[f64]) -> Vec<SweepRow> {
        let work = |value: f64| 3.0 + (-(value.log10() - 0.37).powi(2)).exp() + 0.02 * (value.log10() - 0.37).powi(3);
        let model = stiffened(1.0);
        let found = PeelResult::from(&peelkit::study::peel(&model, &ACCURACY, &BOUNDS));
        let mut row = SweepRow { value: 0.0, second: None, model: model.into(), found, solve_s: 0.0 };
        let snap_off = LimitPoint {
            kind: LimitPointKind::Displacement,
            displacement: 1.0,
            force: 1.0,
            end_rotation: 0.0,
            work: 0.0,
            displacement_error: 0.0,
            force_error: 0.0,
            work_error: None,
            flat: false,
            after: 0,
            in_space: None,
        };
        let filled = |&value: &f64| {
            row.value = value;
            row.found.snap_off = Some(LimitPoint { work: work(value), ..snap_off });
            row.clone()
        };
        values.iter().map(filled).collect()
    }

    #[test]
    fn parabolas_find_the_place_of_the_largest_work() {
        let sweep = rows(&[1e-2, 1e-1, 1.0, 10.0, 100.0]);
        let peeled = refine_largest(&sweep, rows);
        assert_eq!(peeled.len(), PEELS);
        let place = peeled.last().unwrap().value.log10();
        assert!((place - 0.37).abs() < 2e-3, "{place}");
    }

    #[test]
    fn a_largest_work_at_the_rim_is_not_called_a_maximum() {
        assert!(refine_largest(&rows(&[1e-3, 1e-2, 1e-1]), rows).is_empty());
        assert!(refine_largest(&[], rows).is_empty());
    }
}
