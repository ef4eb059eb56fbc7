//! Fig. 5: the strip of 100 nm as a solid, with plain and enriched contact elements of two lengths. The force of each oscillates as its elements come off.

use super::figure::{Figure, Table};
use super::runner::Runner;
use nalgebra::{DMatrix, DVector};
use peelkit::model::{PeelModel, SolidSettings, StripModel};
use peelkit::solid::{Grading, SolidElement, SolidGrip};
use peelkit::study::{SolidOptions, SolidPeel, StopCriteria, peel_solid};
use peelkit_report::ReportError;
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Stroke, colour};
use rayon::prelude::*;
use std::path::Path;

/// Element, its length along the strip (nm), rows, colour.
const CASES: [(SolidElement, f64, usize, RGBColor); 6] = [
    (SolidElement::Enriched { order: 1 }, 4.0, 3, colour::VERMILLION),
    (SolidElement::Enriched { order: 2 }, 4.0, 3, colour::ORANGE),
    (SolidElement::HermiteEdge, 4.0, 3, colour::BLUE),
    (SolidElement::Enriched { order: 1 }, 2.0, 5, colour::VERMILLION),
    (SolidElement::Enriched { order: 2 }, 2.0, 5, colour::ORANGE),
    (SolidElement::HermiteEdge, 2.0, 5, colour::BLUE),
];
/// The mesh to which they are held: order 4 in both directions on 40 columns and 2 rows.
const REFERENCE: (SolidElement, f64, usize) = (SolidElement::Full { along: 4, through: 4 }, 2.5, 2);
/// How far the paths are followed, and over which displacements the oscillation is measured by the length of the elements, nm.
const FAR: f64 = 20.0;
const FROM: f64 = 8.0;
const TO: [(f64, f64); 2] = [(4.0, 18.0), (2.0, 14.0)];
/// Order of the polynomial that is taken out of the difference to the reference.
const SMOOTH: usize = 3;

/// How many paths the figure takes.
pub(super) const PEELS: usize = CASES.len() + 1;

/// What is measured of one case.
struct Measured {
    /// Half of the largest less the least of what is left of P/P_ref - 1, and its root mean square
    oscillation: [f64; 2],
    /// What was taken out, in the middle
    bias: f64,
}

pub(super) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let all: Vec<_> =
        std::iter::once(REFERENCE).chain(CASES.map(|(element, along, rows, _)| (element, along, rows))).collect();
    let peels: Vec<SolidPeel> = all.par_iter().map(|&case| peeled(runner, case)).collect();
    let (reference, peels) = peels.split_first().expect("the reference is among them");
    let mut table = Table::new(&[
        "element",
        "along_nm",
        "rows",
        "unknowns",
        "oscillation",
        "oscillation_rms",
        "bias",
        "peak_nN",
        "peak_relative_error",
        "displacement_limit_points",
    ]);
    let exact = reference.initiation_peak().map(|peak| peak.force);
    let mut panels: Vec<Panel> =
        [4.0, 2.0].iter().enumerate().map(|(index, &along)| panel(index, along, reference)).collect();
    for (peel, (element, along, rows, colour)) in peels.iter().zip(CASES) {
        let name = element.to_string();
        let line = Line::named(&name, within(peel), Stroke::solid(colour, 1.6));
        panels[usize::from(along == 2.0)].lines.push(line);
        let measured = measured(peel, reference, along);
        let peak = peel.initiation_peak().map(|peak| peak.force);
        let turns =
            peel.limit_points.iter().filter(|at| at.kind == peelkit::study::LimitPointKind::Displacement).count();
        let of = |of: fn(&Measured) -> f64| measured.as_ref().map(of);
        table.push(
            &[&name],
            &[
                Some(along),
                Some(rows as f64),
                Some(peel.body.unknowns() as f64),
                of(|found| found.oscillation[0]),
                of(|found| found.oscillation[1]),
                of(|found| found.bias),
                peak,
                peak.zip(exact).map(|(peak, exact)| peak / exact - 1.0),
                Some(turns as f64),
            ],
            &[],
        );
    }
    let caption = "Fig. 5 of the paper: the strip of 100 nm as a solid, plane stress, traction on the reference length, a parabolic shear traction at \
        its end. Bilinear elements (Q1C1) let the force oscillate, each as it comes off; a quadratic contact edge (Q1C2) less, a cubic Hermite edge \
        (Q1CH) least, for one unknown vector more a contact node. Dashed: order 4 in both directions. The data have the oscillation, half of the \
        largest less the least of P/P_ref - 1 behind a smooth cubic, over u from 8 to 18 nm at 4 nm and to 14 nm at 2 nm."
        .to_owned();
    let picture = Picture::of("Peeling of a solid strip of 100 nm with enriched contact elements", panels);
    Figure::write(dir, "fig05-elements", caption, &picture, &table)
}

fn peeled(runner: &Runner<'_>, (element, along, through): (SolidElement, f64, usize)) -> SolidPeel {
    let mut model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
    model.adhesion.far_face = false;
    let grading = if element == REFERENCE.0 { Grading::OF_GRIP } else { Grading::None };
    let settings = SolidSettings {
        element,
        along,
        through,
        grading,
        modes: false,
        grip: SolidGrip::Parabolic,
        ..SolidSettings::default()
    };
    let options = SolidOptions { stop: StopCriteria::up_to(FAR), bounded: 0, ..SolidOptions::default() };
    let peel = peel_solid(&model, &settings, &options).expect("the strip of the paper can be computed as a solid");
    runner.count();
    peel
}

/// The points of a path that are drawn and measured: behind the first peak.
fn within(peel: &SolidPeel) -> Vec<(f64, f64)> {
    peel.points.iter().map(|at| (at.displacement, at.force)).filter(|at| at.0 >= 0.5 * FROM).collect()
}

fn panel(index: usize, along: f64, reference: &SolidPeel) -> Panel {
    let line = Line::named("reference", within(reference), Stroke::dashed(colour::INK, 1.4));
    let x = Axis::linear("displacement u (nm)", 0.5 * FROM, FAR);
    let y = Axis::linear("force P (nN)", 0.04, 0.16);
    // below the title of the picture stands that of the panel
    let column = Frame::column(index, 2);
    let frame = Frame { top: column.top + 18.0, bottom: column.bottom + 18.0, ..column };
    let mut panel = Panel::of_lines(frame, x, y, vec![line]);
    panel.title = format!("elements of {along} nm");
    panel
}

/// None where the path has too few points.
fn measured(peel: &SolidPeel, reference: &SolidPeel, along: f64) -> Option<Measured> {
    let to = TO.iter().find(|(length, _)| *length == along)?.1;
    let exact = within(reference);
    let at: Vec<(f64, f64)> = within(peel)
        .into_iter()
        .filter(|at| (FROM..=to).contains(&at.0))
        .filter_map(|(u, force)| Some((u, force / between(&exact, u)? - 1.0)))
        .collect();
    if at.len() < 2 * SMOOTH {
        return None;
    }
    let middle = 0.5 * (FROM + to);
    let powers =
        DMatrix::from_fn(at.len(), SMOOTH + 1, |row, power| ((at[row].0 - middle) / (to - middle)).powi(power as i32));
    let values = DVector::from_iterator(at.len(), at.iter().map(|at| at.1));
    let smooth = powers.clone().svd(true, true).solve(&values, 1e-12).ok()?;
    let left = values - powers * &smooth;
    let rms = (left.norm_squared() / at.len() as f64).sqrt();
    Some(Measured { oscillation: [0.5 * (left.max() - left.min()), rms], bias: smooth[0] })
}

/// The force of a curve without folds at a displacement, by a cubic through the four points next to it.
fn between(curve: &[(f64, f64)], u: f64) -> Option<f64> {
    let after = curve.windows(2).position(|pair| pair[0].0 <= u && u <= pair[1].0)?;
    let first = after.saturating_sub(1).min(curve.len().saturating_sub(4));
    let next = curve.get(first..first + 4)?;
    let term = |k: usize| {
        let others = (0..4).filter(|&j| j != k);
        next[k].1 * others.map(|j| (u - next[j].0) / (next[k].0 - next[j].0)).product::<f64>()
    };
    Some((0..4).map(term).sum())
}
