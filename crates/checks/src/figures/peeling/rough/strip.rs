//! Fig. 8's question: how deep a pad reaches into the valleys of wavy ground, how much of it adheres, and what it holds.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::Runner;
use peelkit::adhesion::{Sinusoid, Substrate};
use peelkit::model::{Ground, PeelModel, Start, StripModel};
use peelkit::study::{Accuracy, Peel, StopCriteria};
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Shape, Stroke, Symbol, WIDTH, colour};
use peelkit_report::{ReportError, end_word};
use std::path::Path;

/// The paper's ground, crest to valley and crest to crest, and the thickness of the paper's strip, nm.
const PAPER: Case = Case { height: 8.0, wavelength: 100.0, thickness: 10.0 };
/// The strips are two waves long.
const WAVES: f64 = 2.0;
const HEIGHTS: [f64; 7] = [1.0, 4.0, 8.0, 10.0, 12.0, 16.0, 20.0];
const WAVELENGTHS: [f64; 7] = [30.0, 50.0, 60.0, 70.0, 85.0, 100.0, 200.0];
const THICKNESSES: [f64; 7] = [5.0, 10.0, 12.5, 15.0, 20.0, 25.0, 30.0];
/// Thicknesses whose lower edge is drawn.
const DRAWN: [(f64, RGBColor); 4] =
    [(10.0, colour::BLUE), (12.5, colour::GREEN), (15.0, colour::ORANGE), (20.0, colour::VERMILLION)];
/// The first largest force is looked for up to this displacement, nm, as well as this.
const FAR: f64 = 20.0;
const ACCURACY: Accuracy = Accuracy::to(1e-4);
const BOUNDS: StopCriteria = StopCriteria::up_to(FAR);
const STARTS: [(Start, &str, RGBColor); 2] =
    [(Start::Conformed, "pressed on", colour::BLUE), (Start::Crests, "laid on the crests", colour::VERMILLION)];

/// How many peels the figure takes.
pub(in crate::figures) const PEELS: usize =
    STARTS.len() * (HEIGHTS.len() + WAVELENGTHS.len() + THICKNESSES.len()) + DRAWN.len();

#[derive(Clone, Copy)]
struct Case {
    height: f64,
    wavelength: f64,
    thickness: f64,
}

impl Case {
    fn model(self, start: Start) -> PeelModel {
        let mut strip = StripModel::of_the_paper(WAVES * self.wavelength, 1.0);
        strip.strip.height = self.thickness;
        let substrate = Substrate::Sinusoid(Sinusoid { height: self.height, wavelength: self.wavelength, offset: 0.0 });
        PeelModel { ground: Ground { substrate, start }, ..strip.into() }
    }
}

/// What is varied: its name, its column, the cases by their values.
struct Row {
    name: &'static str,
    column: &'static str,
    cases: Vec<(f64, Case)>,
}

fn rows() -> [Row; 3] {
    let cases = |values: [f64; 7], case: fn(f64) -> Case| values.map(|value| (value, case(value))).to_vec();
    [
        Row {
            name: "crest to valley H (nm)",
            column: "height_nm",
            cases: cases(HEIGHTS, |height| Case { height, ..PAPER }),
        },
        Row {
            name: "wavelength (nm)",
            column: "wavelength_nm",
            cases: cases(WAVELENGTHS, |wavelength| Case { wavelength, ..PAPER }),
        },
        Row {
            name: "thickness h (nm)",
            column: "thickness_nm",
            cases: cases(THICKNESSES, |thickness| Case { thickness, ..PAPER }),
        },
    ]
}

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let (rows, mut table) = (rows(), Table::new(&HEADER));
    let models: Vec<PeelModel> =
        DRAWN.iter().map(|&(thickness, _)| Case { thickness, ..PAPER }.model(Start::Crests)).collect();
    let mut panels = vec![lying(&runner.peel_all(&models, &ACCURACY, |_| BOUNDS))];
    for (column, row) in rows.iter().enumerate() {
        let (mut adhered, mut force) = frames(column, row);
        for (start, name, colour) in STARTS {
            let models: Vec<PeelModel> = row.cases.iter().map(|(_, case)| case.model(start)).collect();
            let peels = runner.peel_all(&models, &ACCURACY, |_| BOUNDS);
            for ((value, _), peel) in row.cases.iter().zip(&peels) {
                table.push(&[row.column, name], &numbers(*value, peel), &[end_word(&peel.end)]);
            }
            let values = |pick: &dyn Fn(&Peel) -> Option<f64>| -> Vec<(f64, f64)> {
                row.cases.iter().zip(&peels).filter_map(|((value, _), peel)| Some((*value, pick(peel)?))).collect()
            };
            draw(&mut adhered, values(&|peel| Some(peel.contact(0)?.adhered_fraction)), name, colour, start);
            draw(&mut force, values(&Peel::largest_force_before_jump), name, colour, start);
        }
        panels.extend([adhered, force]);
    }
    let picture = Picture {
        title: "A pad on wavy ground: how much of it adheres, and what it holds".into(),
        height: 770,
        panels,
    };
    let caption = format!(
        "Strips two waves long (E = 2 GPa, EI from h) on y = H/2 (cos(2πx/λ) - 1); but for what is varied H = {} nm and λ = {} nm, the \
         roughness of the paper's Fig. 8, and h = {} nm. Above: lower edges of strips in free equilibrium, laid on the crests and pulled in \
         by adhesion. Below: fraction of the length nearer than 2 r0, and the largest force on the path up to its first snap-off or u = {FAR} nm, \
         pulled straight up at the end, which begins on a crest and is free to rotate. Blue: the strip has been pressed on; red: laid on the \
         crests. Between the two lie the strips that have both equilibria.",
        PAPER.height, PAPER.wavelength, PAPER.thickness
    );
    Figure::write(dir, "fig08-rough", caption, &picture, &table)
}

const HEADER: [&str; 10] = [
    "varied",
    "start",
    "value",
    "adhered_fraction",
    "energy_fraction",
    "reach",
    "largest_gap_nm",
    "peak_force_nN",
    "error_nN",
    "end",
];

fn numbers(value: f64, peel: &Peel) -> [Option<f64>; 7] {
    let contact = peel.contact(0);
    [
        Some(value),
        contact.map(|c| c.adhered_fraction),
        contact.map(|c| c.energy_fraction),
        contact.and_then(|c| c.penetration),
        contact.map(|c| c.largest_gap),
        peel.largest_force_before_jump(),
        peel.peak.map(|peak| peak.force_error),
    ]
}

/// The ground and the lower edges of strips on it.
fn lying(peels: &[Peel]) -> Panel {
    let frame = Frame { left: 78.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 230.0 };
    let (from, to) = (0.0, WAVES * PAPER.wavelength);
    let mut panel = Panel::new(frame, Axis::linear("x (nm)", from, to), Axis::linear("y (nm)", -10.0, 4.0));
    let ground = PAPER.model(Start::Crests).ground.substrate;
    let surface: Vec<(f64, f64)> =
        (0..=400).map(|k| from + (to - from) * f64::from(k) / 400.0).map(|x| (x, ground.top(x, x))).collect();
    let mut corners = surface.clone();
    corners.extend([(to, -10.0), (from, -10.0)]);
    panel.shapes.push(Shape { corners, colour: colour::PALE, opacity: 1.0 });
    panel.lines.push(Line { points: surface, stroke: Stroke::solid(colour::INK, 1.4), name: None });
    for (peel, (thickness, colour)) in peels.iter().zip(DRAWN) {
        let shape = peel.shape(0);
        let edge = shape.x.iter().zip(&shape.y).zip(shape.rotation.iter().zip(&shape.height));
        let points =
            edge.map(|((x, y), (turn, height))| (x + 0.5 * height * turn.sin(), y - 0.5 * height * turn.cos()));
        let name = Some(format!("h = {thickness} nm"));
        panel.lines.push(Line { points: points.collect(), stroke: Stroke::solid(colour, 1.8), name });
    }
    panel
}

/// The two panels of a column.
fn frames(column: usize, row: &Row) -> (Panel, Panel) {
    let (left, width, gap) = (78.0, (f64::from(WIDTH) - 96.0) / 3.0, 56.0);
    let from = left + column as f64 * (width + 0.33 * gap);
    let frame = |top: f64, bottom: f64| Frame { left: from, top, right: from + width - gap, bottom };
    let last = row.cases.last().map_or(1.0, |case| case.0);
    let first = if row.column == "height_nm" { 0.0 } else { row.cases[0].0 };
    let x = || Axis::linear(row.name, first, last);
    let label = |text: &'static str| if column == 0 { text } else { "" };
    (
        Panel::new(frame(290.0, 480.0), x(), Axis::linear(label("adhering fraction"), 0.0, 1.05)),
        Panel::new(frame(540.0, 720.0), x(), Axis::linear(label("peak force (nN)"), 0.0, 1.6)),
    )
}

fn draw(panel: &mut Panel, points: Vec<(f64, f64)>, name: &str, colour: RGBColor, start: Start) {
    let stroke = if start == Start::Conformed { Stroke::solid(colour, 2.0) } else { Stroke::dashed(colour, 2.0) };
    let marks = points.iter().map(|&at| Mark { at, symbol: Symbol::Dot, colour, name: None, note: None });
    panel.marks.extend(marks);
    // above the forces of the first column there is room
    let name = panel.y.label.starts_with("peak").then(|| name.to_owned());
    panel.lines.push(Line { points, stroke, name });
}
