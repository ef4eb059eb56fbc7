//! Digits that the paper's own form of the line load loses as a section comes upright.

use crate::figures::figure::{Figure, Table};
use peelkit::adhesion::{LineLaw, LineLoad};
use peelkit::model::StripModel;
use peelkit_report::ReportError;
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Stroke, WIDTH, colour};
use std::path::Path;

/// Cosines from 1 to 1e-16, so many a decade.
const DECADES: i32 = 16;
const PER_DECADE: i32 = 8;
/// A number of sixteen digits has no more to lose.
const DIGITS: f64 = 16.0;

/// The figure.
pub(in crate::figures) fn figure(dir: &Path) -> Result<Figure, ReportError> {
    let law = StripModel::of_the_paper(100.0, 1.0).line_law();
    let rows: Vec<(f64, [f64; 3])> = (1..=DECADES * PER_DECADE)
        .map(|k| 10f64.powf(-f64::from(k) / f64::from(PER_DECADE)))
        .map(|c| (c, digits(&law, c)))
        .collect();
    let mut table = Table::new(&["cos_theta", "energy_digits", "force_digits", "moment_digits"]);
    rows.iter().for_each(|(cos, digits)| {
        table.push(&[], &[Some(*cos), Some(digits[0]), Some(digits[1]), Some(digits[2])], &[])
    });
    let caption = "Digits on which the paper's form of the line load, eqs. (17) and (20), and its potential \
                   [W(r1) - W(r2)]/cos θ agree with the form without cancellation that the program uses \
                   (`src/adhesion/section/line_load.rs`), both in double precision, as a section comes upright; its lower edge stays at r0, \
                   h = 10 nm. The force is a difference of nearly equal tractions over cos θ and loses a digit a decade, the \
                   moment two. At cos θ = 0 they are 0/0. The form that is used is that of tanh-sinh quadrature to 12 digits at every \
                   tilt (`peel verify --only levels`)."
        .to_owned();
    Figure::write(dir, "round-off", caption, &picture(&rows), &table)
}

/// Digits of energy, force and moment in the paper's form at a cosine.
fn digits(law: &LineLaw, cos: f64) -> [f64; 3] {
    let (half, sin) = (0.5 * law.height, (1.0 - cos * cos).sqrt());
    let gap = law.half_space.equilibrium_distance - half * (1.0 - cos);
    let good = LineLaw { line_load: LineLoad::Full, far_face: true, ..*law }.response(gap, sin, cos);
    let (near, far) = (gap + half - half * cos, gap + half + half * cos);
    let (t1, t2) = (law.half_space.traction(near), law.half_space.traction(far));
    let (w1, w2) = (law.half_space.potential(near), law.half_space.potential(far));
    let paper = [(w1 - w2) / cos, (t1 - t2) / cos, (t1 + t2) * half * sin / cos - (w1 - w2) * sin / (cos * cos)];
    let used = [good.energy, -good.by_gap, -good.by_rotation];
    std::array::from_fn(|i| (-((paper[i] / used[i] - 1.0).abs().log10())).clamp(0.0, DIGITS))
}

fn picture(rows: &[(f64, [f64; 3])]) -> Picture {
    let x = Axis::log("cos θ", 1e-16, 1.0);
    let y = Axis::linear("digits of the paper's form that are right", 0.0, 17.0);
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 380.0 };
    let mut panel = Panel::new(frame, x, y);
    let names = [("energy", colour::GREEN), ("force", colour::BLUE), ("moment", colour::VERMILLION)];
    for (i, (name, colour)) in names.into_iter().enumerate() {
        let points = rows.iter().map(|(cos, digits)| (*cos, digits[i])).collect();
        panel.lines.push(Line { points, stroke: Stroke::solid(colour, 2.0), name: Some(name.into()) });
    }
    Picture {
        title: "Round-off near 90 degrees: the line load in double precision".into(),
        height: 434,
        panels: vec![panel],
    }
}
