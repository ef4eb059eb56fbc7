//! The laws of adhesion side by side: traction against opening, and peak forces against the stiffness of the material.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::{ACCURACY, Runner, paper_strip};
use peelkit::adhesion::CohesiveShape;
use peelkit::model::{Attraction, PeelModel, Spatula};
use peelkit::study::Accuracy;
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Stroke, WIDTH, colour};
use peelkit_report::pictures::sweep::{FORCE, plateau_per_width, series};
use peelkit_report::{ReportError, SweepRow, end_word};
use std::path::Path;

/// Length of the strips, nm.
const LENGTH: f64 = 200.0;
const LAWS: [(Attraction, &str, RGBColor); 5] = [
    (Attraction::BodyForce, "body force", colour::INK),
    (Attraction::SurfaceTraction, "surface traction", colour::VERMILLION),
    (Attraction::Cohesive(CohesiveShape::Bilinear), "bilinear", colour::BLUE),
    (Attraction::Cohesive(CohesiveShape::Exponential), "exponential", colour::GREEN),
    (Attraction::Cohesive(CohesiveShape::Dugdale), "Dugdale", colour::ORANGE),
];
/// Young's moduli in decades from 2 GPa. A spatula of a softer material does not keep its shape.
const STRIPS: std::ops::RangeInclusive<i32> = -2..=2;
const SPATULAE: std::ops::RangeInclusive<i32> = -1..=2;

/// Accuracy for laws with corners, which take many elements.
const CORNERED: Accuracy = Accuracy::to(1e-4);

/// How many peels the figures of this file take: spatulae under the laws without corners alone.
pub(in crate::figures) const PEELS: usize = LAWS.len() * 5 + 3 * 4;

/// One law: strips and spatulae of rising modulus.
struct Series {
    name: &'static str,
    colour: RGBColor,
    strips: Vec<SweepRow>,
    spatulae: Vec<SweepRow>,
}

pub(in crate::figures) fn figures(runner: &Runner<'_>, dir: &Path) -> Result<Vec<Figure>, ReportError> {
    let all = LAWS.map(|(attraction, name, colour)| {
        let cornered = attraction.corners() > 1.0;
        let rows = |moduli: std::ops::RangeInclusive<i32>, model: PeelModel| {
            let cases = moduli.map(|decade| {
                let modulus = 2.0 * 10f64.powi(decade);
                let mut model = model.clone();
                model.adhesion.attraction = attraction;
                model.body.material_mut().youngs_modulus = modulus;
                (modulus, model)
            });
            runner.sweep_to(if cornered { CORNERED } else { ACCURACY }, &cases.collect::<Vec<_>>())
        };
        let strips = rows(STRIPS, (&paper_strip(LENGTH)).into());
        let spatulae = if cornered { Vec::new() } else { rows(SPATULAE, Spatula::default().model()) };
        Series { name, colour, strips, spatulae }
    });
    Ok(vec![tractions(dir)?, against_modulus(&all, dir)?])
}

/// Traction against the opening of a flat face.
fn tractions(dir: &Path) -> Result<Figure, ReportError> {
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 330.0 };
    let x = Axis::linear("opening of the face (nm)", -0.05, 1.0);
    let mut panel = Panel::new(frame, x, Axis::linear("attraction (GPa)", -0.15, 0.15));
    let mut table = Table::new(&["law", "opening_nm", "attraction_GPa"]);
    for (attraction, name, colour) in LAWS.iter().filter(|law| law.0 != Attraction::SurfaceTraction) {
        let mut model = paper_strip(LENGTH);
        model.adhesion.attraction = *attraction;
        model.adhesion.far_face = false;
        let (law, closed) = (model.line_law(), model.adhesion.half_space().equilibrium_gap());
        let openings = (0..=420).map(|k| -0.05 + 0.0025 * f64::from(k));
        let points: Vec<(f64, f64)> =
            openings.map(|delta| (delta, law.response(closed + delta, 0.0, 1.0).by_gap)).collect();
        points.iter().for_each(|&(delta, attraction)| table.push(&[name], &[Some(delta), Some(attraction)], &[]));
        let shown = points.into_iter().filter(|point| point.1 > -0.15).collect();
        panel.lines.push(Line { points: shown, stroke: Stroke::solid(*colour, 2.0), name: Some((*name).into()) });
    }
    let title = "Traction of the laws of adhesion";
    let picture = Picture { title: title.into(), height: 384, panels: vec![panel] };
    let caption = "Attraction of a flat face against how far it is open from its equilibrium, for A_H = 1e-19 J and r0 = 0.4 nm. All have the \
         strength 0.124 GPa and the work of adhesion 0.0307 J/m². Surface traction and body force are equal for a face that is not tilted. The \
         corners of the bilinear law and of Dugdale's are rounded, its flanks take a tenth of the range each.";
    Figure::write(dir, "law-tractions", caption.into(), &picture, &table)
}

fn against_modulus(all: &[Series], dir: &Path) -> Result<Figure, ReportError> {
    let frame = |top: f64, bottom: f64| Frame { left: 88.0, top, right: f64::from(WIDTH) - 18.0, bottom };
    let axis = || Axis::around("Young's modulus E (GPa)", all[0].strips.iter().map(|row| row.value), true);
    let mut above = Panel::new(frame(40.0, 330.0), axis(), Axis::log(FORCE, 1e-2, 1e1));
    let mut below = Panel::new(frame(400.0, 690.0), axis(), Axis::log("difference of the peak (%)", 1e-3, 1e2));
    for one in all {
        let solid = Stroke::solid(one.colour, 2.0);
        above.lines.extend(series(&one.strips, initiation, solid, one.name));
        let plateau = series(&one.strips, plateau_per_width, Stroke::dashed(one.colour, 2.0), "");
        above.lines.extend(plateau.into_iter().map(|line| Line { name: None, ..line }));
    }
    let body = &all[0];
    for one in &all[1..] {
        let line = |points: Vec<(f64, f64)>, stroke, name: &str| Line {
            points: points.into_iter().map(|(modulus, percent)| (modulus, percent.abs())).collect(),
            stroke,
            name: (!name.is_empty()).then(|| name.into()),
        };
        below.lines.push(line(apart(&one.strips, &body.strips, initiation), Stroke::solid(one.colour, 2.0), one.name));
        below.lines.push(line(apart(&one.spatulae, &body.spatulae, largest), Stroke::dashed(one.colour, 2.0), ""));
    }
    let title = "Peak force of every law against the stiffness of the material";
    let picture = Picture { title: title.into(), height: 744, panels: vec![above, below] };
    let listed = |points: Vec<(f64, f64)>| {
        points.iter().map(|(e, percent)| format!("{percent:+.2} % at {e} GPa")).collect::<Vec<_>>().join(", ")
    };
    let surface = &all[1];
    let caption = format!(
        "Above: strips of {LENGTH} nm (h = 10 nm) of a softer and of a stiffer material than the 2 GPa of keratin. Solid: the initiation peak. \
         Dashed: the plateau. Below: how much the peak differs from that of the body force, of strips (solid, the initiation peak) and of the \
         spatula of scenes/spatula.toml (dashed, the largest force up to the snap-off). The surface traction differs by {} in strips, by {} in \
         spatulae. The strip's initiation peak depends on how the traction falls; the spatula's peak hardly.",
        listed(apart(&surface.strips, &body.strips, initiation)),
        listed(apart(&surface.spatulae, &body.spatulae, largest)),
    );
    Figure::write(dir, "law-stiffness", caption, &picture, &table(all))
}

fn initiation(row: &SweepRow) -> Option<f64> {
    Some(row.found.initiation_peak?.force)
}

fn largest(row: &SweepRow) -> Option<f64> {
    Some(row.found.peak?.force)
}

/// How much a force differs, in per cent.
fn apart(rows: &[SweepRow], from: &[SweepRow], force: fn(&SweepRow) -> Option<f64>) -> Vec<(f64, f64)> {
    let pairs = rows.iter().zip(from);
    pairs.filter_map(|(row, base)| Some((row.value, 100.0 * (force(row)? / force(base)? - 1.0)))).collect()
}

fn table(all: &[Series]) -> Table {
    let mut table = Table::new(&[
        "body",
        "law",
        "youngs_modulus_GPa",
        "initiation_peak_nN",
        "initiation_peak_error_nN",
        "peak_nN",
        "peak_error_nN",
        "plateau_nN",
        "snap_off_displacement_nm",
        "end",
    ]);
    for one in all {
        for (body, rows) in [("strip", &one.strips), ("spatula", &one.spatulae)] {
            for row in rows {
                let found = &row.found;
                let (initiation, peak) = (found.initiation_peak, found.peak);
                let numbers = [
                    Some(row.value),
                    initiation.map(|p| p.force),
                    initiation.map(|p| p.force_error),
                    peak.map(|p| p.force),
                    peak.map(|p| p.force_error),
                    found.plateau.map(|p| p.force),
                    found.snap_off.map(|s| s.displacement),
                ];
                table.push(&[body, one.name], &numbers, &[end_word(&found.end)]);
            }
        }
    }
    table
}
