//! Peak force against the angle of the pull, of a strip and of a spatula, beside Kendall's law.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::{Runner, paper_strip};
use peelkit::analytic::{kendall_force, sliding_force};
use peelkit::model::{PeelModel, Pull, Spatula, StripModel};
use peelkit::study::Peel;
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Stroke, Symbol, WIDTH, colour};
use peelkit_report::pictures::sweep::FORCE;
use peelkit_report::{ReportError, SweepRow, end_word};
use std::path::Path;

/// Length of the strips whose peaks are shown, and of those that peel steadily, nm.
const LENGTH: f64 = 200.0;
const LONG: f64 = 1000.0;
/// EI/EI0 of the strips, and their colours.
const STRIPS: [(f64, peelkit_report::chart::RGBColor); 2] = [(1.0, colour::BLUE), (1e-2, colour::GREEN)];

/// How many peels the figures of this file take.
pub(in crate::figures) const PEELS: usize = STRIPS.len() * 35 + 11 + 37;

/// Angles in degrees, both ends included.
fn angles(from: f64, to: f64, step: f64) -> impl Iterator<Item = f64> {
    (0..=((to - from) / step).round() as usize).map(move |k| from + step * k as f64)
}

fn pulled<M: Into<PeelModel>>(model: M, degrees: f64) -> (f64, PeelModel) {
    (degrees, PeelModel { pull: Pull { angle: degrees.to_radians(), ..Pull::UP }, ..model.into() })
}

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let strips = STRIPS.map(|(factor, _)| {
        let strip = StripModel::of_the_paper(LENGTH, factor);
        runner.sweep(&angles(5.0, 175.0, 5.0).map(|angle| pulled(strip, angle)).collect::<Vec<_>>())
    });
    let long = angles(15.0, 165.0, 15.0).map(|angle| pulled(paper_strip(LONG), angle));
    let steady: Vec<(f64, f64)> =
        long.filter_map(|(angle, model)| Some((angle, half_way(&runner.peel(&model))?))).collect();
    let spatulae = runner.sweep(
        &angles(0.0, 45.0, 2.5)
            .chain(angles(52.5, 180.0, 7.5))
            .map(|angle| pulled(Spatula::default().model(), angle))
            .collect::<Vec<_>>(),
    );
    let picture = picture(&strips, &steady, &spatulae);
    let caption = format!(
        "Above: strips of {LENGTH} nm (h = 10 nm, E = 2 GPa) whose grip is pulled at an angle to the substrate, 0 along it and away from \
         the strip, 180 degrees backwards; the force points along the pull, and the free end is held at x = 0. Solid: the initiation peak, for \
         EI and for EI/100. Dots: the force of a strip of {LONG} nm with the front half-way. Dotted: Kendall's force. Dashed: what it \
         becomes where the adhering part slides without friction, P (1 - cos α) + P² sin² α/(2EA) = w, on which the dots lie. Below: the spatula of scenes/spatula.toml, \
         which is bent up by 45 degrees in its stress-free configuration: the largest force up to the snap-off. It is largest where the line of the pull \
         runs through the pad, which then comes off at once and not from one end; at smaller angles the high end of the shaft rotates the pad off the substrate."
    );
    Figure::write(dir, "pull-angle", caption, &picture, &table(&strips, &steady, &spatulae))
}

/// The force per width where the front is nearest to the middle.
fn half_way(peel: &Peel) -> Option<f64> {
    let point = &peel.points[peel.nearest_front(0.5 * LONG)?];
    ((point.front - 0.5 * LONG).abs() < 0.2 * LONG).then_some(point.force)
}

/// Kendall's force, and that of a strip that slides, per width at an angle in degrees.
fn laws(degrees: f64) -> (f64, f64) {
    let model = paper_strip(LENGTH);
    let (work, section, angle) = (-model.line_law().rest_energy(), model.section(), degrees.to_radians());
    let kendall = kendall_force(work, model.strip.material.youngs_modulus, model.strip.height, 1.0, angle);
    (kendall, sliding_force(-work, section.axial, angle))
}

fn picture(strips: &[Vec<SweepRow>], steady: &[(f64, f64)], spatulae: &[SweepRow]) -> Picture {
    let frame = |top: f64, bottom: f64| Frame { left: 88.0, top, right: f64::from(WIDTH) - 18.0, bottom };
    let axis = || Axis::linear("angle of the pull (degrees)", 0.0, 180.0);
    let line = |points: Vec<(f64, f64)>, stroke, name: &str| Line { points, stroke, name: Some(name.into()) };
    let mut above = Panel::new(frame(40.0, 330.0), axis(), Axis::log(FORCE, 1e-2, 1e1));
    for ((factor, colour), rows) in STRIPS.iter().zip(strips) {
        let name = if *factor == 1.0 { "initiation peak" } else { "initiation peak, EI/100" };
        above.lines.push(line(peaks(rows, true), Stroke::solid(*colour, 2.0), name));
    }
    let law = |pick: fn((f64, f64)) -> f64| angles(2.0, 180.0, 2.0).map(|a| (a, pick(laws(a)))).collect::<Vec<_>>();
    above.lines.push(line(law(|l| l.0), Stroke::dotted(colour::GREY, 2.0), "Kendall"));
    above.lines.push(line(law(|l| l.1), Stroke::dashed(colour::INK, 1.6), "Kendall, sliding"));
    above.marks.extend(steady.iter().enumerate().map(|(n, &at)| {
        let name = (n == 0).then(|| "steady peeling".to_owned());
        Mark { at, symbol: Symbol::Dot, colour: colour::VERMILLION, name, note: None }
    }));
    let mut below = Panel::new(frame(400.0, 620.0), axis(), Axis::log("force P (nN)", 1.0, 200.0));
    below.lines.push(line(peaks(spatulae, false), Stroke::solid(colour::BLUE, 2.0), "spatula, peak force"));
    Picture { title: "Peak force against the angle of the pull".into(), height: 674, panels: vec![above, below] }
}

/// Angle and peak: the initiation peak, or the largest up to the snap-off.
fn peaks(rows: &[SweepRow], initiation: bool) -> Vec<(f64, f64)> {
    let peak = |row: &SweepRow| if initiation { row.found.initiation_peak } else { row.found.peak };
    rows.iter().filter_map(|row| Some((row.value, peak(row)?.force))).collect()
}

fn table(strips: &[Vec<SweepRow>], steady: &[(f64, f64)], spatulae: &[SweepRow]) -> Table {
    let mut table =
        Table::new(&["series", "angle_deg", "force_nN", "error_nN", "kendall_nN", "kendall_sliding_nN", "end"]);
    for ((factor, _), rows) in STRIPS.iter().zip(strips) {
        let name = format!("initiation peak EI/EI0 = {factor}");
        for row in rows {
            let (peak, (kendall, sliding)) = (row.found.initiation_peak, laws(row.value));
            let numbers =
                [Some(row.value), peak.map(|p| p.force), peak.map(|p| p.force_error), Some(kendall), Some(sliding)];
            table.push(&[&name], &numbers, &[end_word(&row.found.end)]);
        }
    }
    for &(angle, force) in steady {
        let (kendall, sliding) = laws(angle);
        table.push(&["steady"], &[Some(angle), Some(force), None, Some(kendall), Some(sliding)], &[""]);
    }
    for row in spatulae {
        let peak = row.found.peak;
        let numbers = [Some(row.value), peak.map(|p| p.force), peak.map(|p| p.force_error), None, None];
        table.push(&["spatula peak"], &numbers, &[end_word(&row.found.end)]);
    }
    table
}
