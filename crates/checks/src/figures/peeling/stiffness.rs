//! Peak force against bending stiffness: Fig. 10 of the paper for the three line loads, and EI varied in three ways.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::{Runner, paper_strip};
use peelkit::adhesion::LineLoad;
use peelkit::model::StripModel;
use peelkit::study::PathEnd;
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{Axis, Band, Frame, Line, Mark, Picture, Stroke, Symbol, WIDTH, colour, significant};
use peelkit_report::pictures::sweep::{
    FORCE, STIFFNESS_LABEL, kendall_per_width, panel, per_width, plateau_per_width, series, work_per_width,
};
use peelkit_report::{ReportError, SweepRow, end_word};
use std::path::Path;

/// The length of the strips in these figures, nm.
pub(in crate::figures) const LENGTH: f64 = 200.0;

const VALUES: usize = 41;
const MODULI: usize = 31;
const HEIGHTS: usize = 33;

/// How many peels the figures of this file take.
pub(in crate::figures) const PEELS: usize = 3 * VALUES + MODULI + HEIGHTS;

/// A spatula's EI/EI0: heights of 5 to 20 nm at 2 GPa. The paper gives its range in the figure only; this one is ours.
const SPATULA: (f64, f64) = (0.125, 8.0);

const SPATULA_CAPTION: &str = "The shaded range of a gecko spatula is h = 5 to 20 nm at E = 2 GPa, that is EI/EI0 = \
    (h / 10 nm)^3 = 0.125 to 8. This range is ours: the paper shows its range in the figure only, without numbers.";

/// The sweeps behind these figures, each against EI/EI0.
pub(in crate::figures) struct Sweeps {
    pub full: Vec<SweepRow>,
    pub force_only: Vec<SweepRow>,
    pub axis_gap: Vec<SweepRow>,
    through_modulus: Vec<SweepRow>,
    through_height: Vec<SweepRow>,
}

impl Sweeps {
    pub fn compute(runner: &Runner<'_>) -> Self {
        let alone = |line_load: LineLoad| {
            let case = |f| {
                let mut model = stiffened(f);
                model.adhesion.line_load = line_load;
                (f, model)
            };
            runner.sweep(&spaced(1e-4, 1e4, VALUES).map(case).collect::<Vec<_>>())
        };
        let modulus = spaced(1e-2, 1e4, MODULI).map(|f| {
            let mut model = paper_strip(LENGTH);
            model.strip.material.youngs_modulus *= f;
            (f, model)
        });
        let height = spaced(1e-3, 1e3, HEIGHTS).map(|f| {
            let mut model = paper_strip(LENGTH);
            model.strip.height *= f.cbrt();
            (f, model)
        });
        Sweeps {
            full: alone(LineLoad::Full),
            force_only: alone(LineLoad::ForceOnly),
            axis_gap: alone(LineLoad::AxisGap),
            through_modulus: runner.sweep(&modulus.collect::<Vec<_>>()),
            through_height: runner.sweep(&height.collect::<Vec<_>>()),
        }
    }
}

/// The paper's strip with EI alone multiplied.
pub(in crate::figures) fn stiffened(factor: f64) -> StripModel {
    let mut model = paper_strip(LENGTH);
    model.strip.material.bending_stiffness_factor = factor;
    model
}

/// Values of even ratio, both ends included.
fn spaced(from: f64, to: f64, count: usize) -> impl Iterator<Item = f64> {
    let ratio = (to / from).log10() / (count - 1) as f64;
    (0..count).map(move |i| 10f64.powf(from.log10() + ratio * i as f64))
}

pub(in crate::figures) fn figures(sweeps: &Sweeps, dir: &Path) -> Result<Vec<Figure>, ReportError> {
    let loads = [
        ("full: force and moment", colour::BLUE, &sweeps.full),
        ("force-only: without the moment", colour::VERMILLION, &sweeps.force_only),
        ("axis-gap: independent of rotation", colour::GREEN, &sweeps.axis_gap),
    ];
    let caption = format!(
        "Force per width of a strip of {LENGTH} nm against its bending stiffness, EI0 = E h³/12 with E = 2 GPa and h \
         = 10 nm, as in Fig. 10 of the paper. EI alone is varied. Colours: the three line loads. Solid: the \
         initiation peak. Dashed: the plateau; it ends where the force has no plateau with more than a hundredth of the strip adhering. \
         Dotted: Kendall's force at 90 degrees with the work of adhesion of this strip. {}{SPATULA_CAPTION}{}",
        softest(&loads),
        unfinished(&loads.map(|l| l.2))
    );
    let title = "Peak force and plateau against bending stiffness";
    let fig10 = Figure::write(dir, "fig10-bending-stiffness", caption, &picture(title, &loads), &table(&loads))?;

    let ways = [
        ("EI alone", colour::BLUE, &sweeps.full),
        ("through E", colour::VERMILLION, &sweeps.through_modulus),
        ("through h", colour::GREEN, &sweeps.through_height),
    ];
    let caption = format!(
        "The same for the full line load, with EI varied in three ways: EI alone by a factor; through E, so that EA \
         and GA_s follow (E from 0.02 GPa: Kendall's force stretches a softer strip by more than 0.14 of its length); \
         through h, so that they follow with h and the lever of the adhesion with it (h from 1 to 100 nm: thinner or \
         thicker is no strip of {LENGTH} nm). Dotted: Kendall's force of the strip of that colour; it falls where the \
         strip stretches and where it is too thin to be attracted as a half space. {SPATULA_CAPTION}{}",
        unfinished(&ways.map(|w| w.2))
    );
    let title = "EI varied alone, through E, through h";
    Ok(vec![fig10, Figure::write(dir, "fig10-three-ways", caption, &picture(title, &ways), &table(&ways))?])
}

type Series<'a> = (&'a str, RGBColor, &'a Vec<SweepRow>);

fn picture(title: &str, all: &[Series<'_>]) -> Picture {
    let x = Axis::around(STIFFNESS_LABEL, all.iter().flat_map(|s| s.2.iter().map(|r| r.value)), true);
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 480.0 };
    let mut lines = Vec::new();
    // Where curves coincide the wider one below still shows.
    for (&(name, colour, rows), width) in all.iter().zip([4.4, 2.8, 1.5]) {
        let initiation = |r: &SweepRow| Some(per_width(r, r.found.initiation_peak?.force));
        lines.extend(series(rows, initiation, Stroke::solid(colour, width), name));
        let plateau = series(rows, plateau_per_width, Stroke::dashed(colour, width), "");
        lines.extend(plateau.into_iter().map(|line| Line { name: None, ..line }));
    }
    lines.extend(kendall_lines(&x, all));
    let key = |stroke, name: &str| Line { points: Vec::new(), stroke, name: Some(name.into()) };
    lines.push(key(Stroke::solid(colour::INK, 2.2), "initiation peak"));
    lines.push(key(Stroke::dashed(colour::INK, 2.2), "plateau"));
    lines.push(key(kendall(colour::INK), "Kendall"));
    let mut panel = panel(frame, &x, FORCE, lines);
    panel.bands.push(spatula());
    for &(_, _, rows) in all {
        panel.marks.extend(rows.iter().filter(|row| stopped_short(row)).filter_map(|row| {
            let at = (row.value, per_width(row, row.found.initiation_peak?.force));
            let name = Some("path stops short".into());
            Some(Mark { at, symbol: Symbol::Dot, colour: colour::INK, name, note: None })
        }));
    }
    Picture { title: title.into(), height: 534, panels: vec![panel] }
}

/// Kendall's force: one line where it is the same for all, else a line a series.
fn kendall_lines(x: &Axis, all: &[Series<'_>]) -> Vec<Line> {
    let forces = || all.iter().flat_map(|s| s.2.iter().map(kendall_per_width));
    let (low, high) = forces().fold((f64::INFINITY, 0.0f64), |(a, b), force| (a.min(force), b.max(force)));
    if high - low < 1e-6 * high {
        return vec![Line { points: vec![(x.from, low), (x.to, low)], stroke: kendall(colour::INK), name: None }];
    }
    let each = all.iter().flat_map(|s| series(s.2, |r| Some(kendall_per_width(r)), kendall(s.1), ""));
    each.map(|line| Line { name: None, ..line }).collect()
}

fn kendall(colour: RGBColor) -> Stroke {
    Stroke::dotted(colour, 1.6)
}

/// The shaded range of the gecko spatula.
pub(in crate::figures) fn spatula() -> Band {
    let name = Some("spatula, h = 5 to 20 nm".into());
    Band { from: SPATULA.0, to: SPATULA.1, colour: colour::ORANGE, name }
}

/// One table for all series.
pub(in crate::figures) fn table(all: &[Series<'_>]) -> Table {
    let mut table = Table::new(&[
        "series",
        "ei_over_ei0",
        "youngs_modulus_GPa",
        "height_nm",
        "initiation_peak_nN_per_nm",
        "initiation_peak_error_nN_per_nm",
        "plateau_nN_per_nm",
        "kendall_nN_per_nm",
        "snap_off_displacement_nm",
        "work_to_snap_off_aJ_per_nm",
        "end",
    ]);
    for &(name, _, rows) in all {
        let name = name.split(':').next().unwrap_or(name);
        for row in rows {
            let found = &row.found;
            let numbers = [
                Some(row.value),
                Some(row.model.material().youngs_modulus),
                Some(row.model.free_end().1),
                found.initiation_peak.map(|p| per_width(row, p.force)),
                found.initiation_peak.map(|p| per_width(row, p.force_error)),
                plateau_per_width(row),
                Some(kendall_per_width(row)),
                found.snap_off.map(|s| s.displacement),
                work_per_width(row),
            ];
            table.push(&[name], &numbers, &[end_word(&found.end)]);
        }
    }
    table
}

/// A sentence on peels that stopped short, empty where none did.
fn unfinished(all: &[&Vec<SweepRow>]) -> String {
    let count = all.iter().flat_map(|rows| rows.iter()).filter(|row| stopped_short(row)).count();
    let total: usize = all.iter().map(|rows| rows.len()).sum();
    match count {
        0 => String::new(),
        _ => format!(
            " Of {total} peels {count} stopped short of the end of the path (dots, and `failed` in the data): what \
             was computed before that is shown."
        ),
    }
}

fn stopped_short(row: &SweepRow) -> bool {
    matches!(row.found.end, PathEnd::Failed(_) | PathEnd::Bound(_))
}

/// What the softest strip of each series bears, in units of Kendall's force.
fn softest(all: &[Series<'_>]) -> String {
    let mut text = String::new();
    for (name, _, rows) in all {
        let Some(row) = rows.first() else { continue };
        let Some(peak) = row.found.initiation_peak else { continue };
        let times = |force: f64| significant(force / kendall_per_width(row), 3);
        let name = name.split(':').next().unwrap_or(name);
        let plateau = plateau_per_width(row).map(|p| format!(" and a plateau of {}", times(p)));
        let peak = times(per_width(row, peak.force));
        text += &format!("{name} has a peak of {peak}{}; ", plateau.unwrap_or_default());
    }
    match all.first().and_then(|series| series.2.first()) {
        Some(row) => format!(
            "In units of Kendall's force, at EI/EI0 = {}: {}. ",
            significant(row.value, 1),
            text.trim_end_matches("; ")
        ),
        None => text,
    }
}
