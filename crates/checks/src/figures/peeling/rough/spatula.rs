//! A gecko's spatula on waves and on a cylinder: how it lies, and what it holds.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::Runner;
use peelkit::adhesion::{BodyShape as Body, Round, Sinusoid, Substrate};
use peelkit::model::{Ground, Hold, PeelModel, Spatula, Start};
use peelkit::study::{Accuracy, Peel, StopCriteria};
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Shape, Stroke, Symbol, WIDTH, colour};
use peelkit_report::{ReportError, end_word};
use std::path::Path;

/// Crest to valley, nm, of waves of this length, nm, with a crest below the free end.
const HEIGHTS: [f64; 9] = [0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0];
const WAVELENGTH: f64 = 100.0;
/// Radii of a cylinder, nm, with its top below the middle of the pad.
const RADII: [f64; 7] = [150.0, 200.0, 300.0, 500.0, 1000.0, 2000.0, 5000.0];
/// The waves on which it is drawn.
const DRAWN: f64 = 8.0;
/// How far, how deep and how high is drawn, nm.
const LONG: f64 = 340.0;
const DEEP: f64 = -14.0;
const HIGH: f64 = 60.0;
/// Top of the axes of forces, nN.
const MOST: f64 = 15.0;
const ACCURACY: Accuracy = Accuracy::to(1e-4);
const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);
/// How many peels the figure takes.
pub(in crate::figures) const PEELS: usize = 1 + HEIGHTS.len() + RADII.len();

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let flat = runner.peel_all(&[on(Substrate::Flat)], &ACCURACY, |_| BOUNDS).remove(0);
    let mut table = Table::new(&HEADER);
    table.push(&["flat"], &numbers(0.0, &flat), &[end_word(&flat.end)]);
    let mut peels = |ground: &str, values: &[f64], substrate: fn(f64) -> Substrate| {
        let models: Vec<PeelModel> = values.iter().map(|&value| on(substrate(value))).collect();
        let peels = runner.peel_all(&models, &ACCURACY, |_| BOUNDS);
        for (&value, peel) in values.iter().zip(&peels) {
            table.push(&[ground], &numbers(value, peel), &[end_word(&peel.end)]);
        }
        peels
    };
    let rough = peels("waves", &HEIGHTS, wave);
    let round = peels("cylinder", &RADII, cylinder);
    let last = HEIGHTS[HEIGHTS.len() - 1];
    let x = Axis::linear("crest to valley of the waves (nm)", 0.0, last);
    let mut waves = Panel::new(frame(0.0), x, Axis::linear("force (nN)", 0.0, MOST));
    let of = |pick: fn(&Peel) -> Option<f64>| -> Vec<(f64, f64)> {
        let values = std::iter::once(0.0).chain(HEIGHTS).zip(std::iter::once(&flat).chain(&rough));
        values.filter_map(|(height, peel)| Some((height, pick(peel)?))).collect()
    };
    draw(
        &mut waves,
        of(Peel::largest_force_before_jump),
        Stroke::solid(colour::BLUE, 2.0),
        "largest up to the snap-off",
    );
    let first = of(|peel| Some(peel.initiation_peak?.force));
    draw(&mut waves, first, Stroke::dashed(colour::VERMILLION, 2.0), "first peak");
    let x = Axis::log("radius of the cylinder (nm)", RADII[0], RADII[RADII.len() - 1]);
    let mut cylinders = Panel::new(frame(1.0), x, Axis::linear("", 0.0, MOST));
    let points = RADII.iter().zip(&round).filter_map(|(&radius, peel)| Some((radius, peel.peak?.force))).collect();
    draw(&mut cylinders, points, Stroke::solid(colour::BLUE, 2.0), "the one peak");
    if let Some(peak) = flat.peak {
        let points = vec![(RADII[0], peak.force), (RADII[RADII.len() - 1], peak.force)];
        let stroke = Stroke::dotted(colour::INK, 1.6);
        cylinders.lines.push(Line { points, stroke, name: Some("flat ground".into()) });
    }
    let lying = lying(HEIGHTS.iter().position(|&height| height == DRAWN).map(|k| &rough[k]));
    let title = "A spatula on uneven ground: how it lies, and what it holds".into();
    let picture = Picture { title, height: 590, panels: vec![lying, waves, cylinders] };
    let caption = format!(
        "The spatula of `fig07-spatula` in a grip that is free to rotate, pressed on and pulled straight up. Above: its free equilibrium on waves {DRAWN} nm high and {WAVELENGTH} nm long; \
         heights are drawn larger than lengths. Below: the largest force up to the first snap-off and the first peak on such waves against their height, and the peak on a cylinder, with its top \
         below the middle of the pad, against its radius. Laid on the crests, the pad is pulled down into all of these waves and holds the same force."
    );
    Figure::write(dir, "spatula-rough", caption, &picture, &table)
}

/// The left (0) or the right (1) of the lower panels.
fn frame(side: f64) -> Frame {
    let (left, width, gap) = (78.0, (f64::from(WIDTH) - 96.0) / 2.0, 60.0);
    let from = left + side * (width + 0.5 * gap);
    Frame { left: from, top: 300.0, right: from + width - 0.5 * gap, bottom: 530.0 }
}

fn on(substrate: Substrate) -> PeelModel {
    let mut model = Spatula::default().model();
    model.grip.rotation = Hold::Free;
    PeelModel { ground: Ground { substrate, start: Start::Conformed }, ..model }
}

fn wave(height: f64) -> Substrate {
    Substrate::Sinusoid(Sinusoid { height, wavelength: WAVELENGTH, offset: 0.0 })
}

fn cylinder(radius: f64) -> Substrate {
    Substrate::Round(Round { shape: Body::Cylinder, radius, offset: 0.5 * Spatula::default().pad_length })
}

const HEADER: [&str; 8] = [
    "ground",
    "height_or_radius_nm",
    "adhered_fraction",
    "energy_fraction",
    "initiation_peak_nN",
    "peak_force_nN",
    "error_nN",
    "end",
];

fn numbers(value: f64, peel: &Peel) -> [Option<f64>; 6] {
    let contact = peel.contact(0);
    [
        Some(value),
        contact.map(|c| c.adhered_fraction),
        contact.map(|c| c.energy_fraction),
        peel.initiation_peak.map(|peak| peak.force),
        peel.largest_force_before_jump(),
        peel.peak.map(|peak| peak.force_error),
    ]
}

/// The ground, and a spatula on it.
fn lying(peel: Option<&Peel>) -> Panel {
    let frame = Frame { left: 78.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 235.0 };
    let mut panel = Panel::new(frame, Axis::linear("x (nm)", 0.0, LONG), Axis::linear("y (nm)", DEEP, HIGH));
    let ground = wave(DRAWN);
    let surface: Vec<(f64, f64)> =
        (0..=400).map(|k| LONG * f64::from(k) / 400.0).map(|x| (x, ground.top(x, x))).collect();
    let mut corners = surface.clone();
    corners.extend([(LONG, DEEP), (0.0, DEEP)]);
    panel.shapes.push(Shape { corners, colour: colour::PALE, opacity: 1.0 });
    panel.lines.push(Line { points: surface, stroke: Stroke::solid(colour::INK, 1.4), name: None });
    if let Some(shape) = peel.map(|peel| peel.shape(0)) {
        let axis = shape.x.iter().zip(&shape.y).zip(shape.rotation.iter().zip(&shape.height));
        let edges = axis.map(|((x, y), (turn, height))| {
            [-0.5, 0.5].map(|side| (x - side * height * turn.sin(), y + side * height * turn.cos()))
        });
        // as far as it fits
        let edges: Vec<_> = edges.take_while(|[lower, upper]| lower.0 < LONG && upper.1 < HIGH).collect();
        let edge = |side: usize| edges.iter().map(|both| both[side]).collect::<Vec<_>>();
        let mut corners = edge(0);
        corners.extend(edge(1).into_iter().rev());
        panel.shapes.push(Shape { corners, colour: colour::BLUE, opacity: 0.35 });
        panel.lines.push(Line { points: edge(0), stroke: Stroke::solid(colour::BLUE, 1.8), name: None });
    }
    panel
}

fn draw(panel: &mut Panel, points: Vec<(f64, f64)>, stroke: Stroke, name: &str) {
    let colour = stroke.colour;
    let marks = points.iter().map(|&at| Mark { at, symbol: Symbol::Dot, colour, name: None, note: None });
    panel.marks.extend(marks);
    panel.lines.push(Line { points, stroke, name: Some(name.to_owned()) });
}
