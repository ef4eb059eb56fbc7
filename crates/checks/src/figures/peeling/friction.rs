//! What friction adds to a strip that is pulled at an angle, and where it slides.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::Runner;
use peelkit::analytic::kendall_force;
use peelkit::model::{Friction, PeelModel, Pull, StripModel};
use peelkit::study::{Accuracy, Choice, PathEnd, Peel, Sliding, StopCriteria};
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Stroke, WIDTH, colour};
use peelkit_report::pictures::sweep::FORCE;
use peelkit_report::{ReportError, end_word};
use std::path::Path;

/// L, nm
const LENGTH: f64 = 100.0;
/// Shear strength of the contact (GPa), and how it is drawn.
const STRENGTHS: [(f64, RGBColor, &str); 3] =
    [(0.01, colour::GREEN, "10 MPa"), (0.05, colour::BLUE, "50 MPa"), (0.2, colour::VERMILLION, "200 MPa")];
/// The strength whose sliding is shown, and the angles in degrees at which it is.
const SHOWN: usize = 1;
const SLIDING: [(f64, RGBColor, &str); 4] = [
    (10.0, colour::BLUE, "10 degrees"),
    (30.0, colour::GREEN, "30 degrees"),
    (60.0, colour::INK, "60 degrees"),
    (120.0, colour::VERMILLION, "120 degrees"),
];
/// Degrees; closer together where the force falls steeply.
const ANGLES: [f64; 20] = [
    5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 100.0, 110.0, 120.0, 130.0, 140.0, 150.0,
    160.0, 170.0,
];
/// The first peak comes before the grip has gone so far from the substrate, nm.
const FAR: f64 = 3.0;
const ACCURACY: Accuracy = Accuracy::to(1e-4);
/// Those of the first mesh, on which the paths are that come through; of those that are lost behind their peak finer ones cure none.
const ELEMENTS: usize = 52;

/// How many peels the figure takes.
pub(in crate::figures) const PEELS: usize = (STRENGTHS.len() + 1) * ANGLES.len();

fn up_to_the_first_peak(model: &PeelModel) -> StopCriteria {
    StopCriteria::up_to(FAR / model.pull.angle.sin())
}

fn strip(degrees: f64, strength: Option<f64>) -> PeelModel {
    let friction = Friction { strength, ..Friction::NONE };
    PeelModel {
        pull: Pull { angle: degrees.to_radians(), ..Pull::UP },
        friction,
        ..StripModel::of_the_paper(LENGTH, 1.0).into()
    }
}

/// The first largest force, or where there is none because all slides before it, that. A force that still rises at the end is neither.
fn first_peak(peel: &Peel) -> Option<f64> {
    let slides = || peel.largest_force_before_jump().filter(|_| !matches!(peel.end, PathEnd::Bound(_)));
    peel.initiation_peak.map(|peak| peak.force).or_else(slides)
}

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let strengths = [None].into_iter().chain(STRENGTHS.map(|(strength, ..)| Some(strength)));
    let models: Vec<PeelModel> = strengths.flat_map(|strength| ANGLES.map(|angle| strip(angle, strength))).collect();
    // all at once: some take as long as all others of their strength
    let accuracy = ACCURACY.with(Choice { elements: Some(ELEMENTS), ..ACCURACY.choice });
    let mut peels = runner.peel_all(&models, &accuracy, up_to_the_first_peak).into_iter();
    let mut next = || peels.by_ref().take(ANGLES.len()).collect::<Vec<Peel>>();
    let free = next();
    let held = STRENGTHS.map(|_| next());
    let picture = picture(&free, &held);
    let caption = format!(
        "Above: the initiation peak of a strip of {LENGTH} nm (h = 10 nm, E = 2 GPa) against the angle at which it is pulled, the force along \
         the pull: with friction of three shear strengths, which alone holds the strip along the substrate, and without friction, its free \
         end held at x = 0. At the smallest angles the strip slides as a whole before it peels, and the force is the one that it slides at. Dotted: Kendall's force. Below: \
         traction over shear strength along the strip at the peak, for a shear strength of 50 MPa; the grip is at S = {LENGTH} nm. It is ±1 where the face \
         slides, forwards or backwards."
    );
    Figure::write(dir, "friction", caption, &picture, &table(&free, &held))
}

fn picture(free: &[Peel], held: &[Vec<Peel>; STRENGTHS.len()]) -> Picture {
    let frame = |top: f64, bottom: f64| Frame { left: 88.0, top, right: f64::from(WIDTH) - 18.0, bottom };
    let line = |points: Vec<(f64, f64)>, stroke, name: &str| Line { points, stroke, name: Some(name.into()) };
    let curve = |peels: &[Peel]| {
        ANGLES.into_iter().zip(peels).filter_map(|(angle, peel)| Some((angle, first_peak(peel)?))).collect::<Vec<_>>()
    };
    let mut above = Panel::new(
        frame(40.0, 330.0),
        Axis::linear("angle of the pull (degrees)", 0.0, 180.0),
        Axis::log(FORCE, 1e-2, 1e1),
    );
    for ((_, colour, name), peels) in STRENGTHS.iter().zip(held).rev() {
        above.lines.push(line(curve(peels), Stroke::solid(*colour, 2.0), &format!("initiation peak, {name}")));
    }
    above.lines.push(line(curve(free), Stroke::dashed(colour::INK, 1.6), "without friction"));
    above.lines.push(line(
        ANGLES.map(|angle| (angle, kendall(angle))).into(),
        Stroke::dotted(colour::GREY, 2.0),
        "Kendall",
    ));
    let mut below = Panel::new(
        frame(400.0, 620.0),
        Axis::linear("position along the strip S (nm)", 0.0, LENGTH),
        Axis::linear("traction over shear strength", -1.05, 1.05),
    );
    for (degrees, colour, name) in SLIDING {
        let at = ANGLES.iter().position(|&angle| angle == degrees).and_then(|k| held[SHOWN].get(k));
        let Some(Sliding { along, .. }) = at.and_then(Peel::sliding_at_peak) else { continue };
        let limit = |tau: f64| tau > TOUCHING * STRENGTHS[SHOWN].0;
        let points = along.iter().filter(|(.., tau)| limit(*tau)).map(|&(s, share, _)| (s, share)).collect();
        below.lines.push(line(points, Stroke::solid(colour, 1.8), name));
    }
    Picture { title: "Peeling with friction".into(), height: 674, panels: vec![above, below] }
}

/// Where the limit is above this fraction of the strength, the face is drawn.
const TOUCHING: f64 = 0.05;

/// Kendall's force at an angle in degrees, nN.
fn kendall(degrees: f64) -> f64 {
    let strip = StripModel::of_the_paper(LENGTH, 1.0);
    let work = -PeelModel::from(strip).line_law().rest_energy();
    kendall_force(
        work,
        strip.strip.material.youngs_modulus,
        strip.strip.height,
        strip.strip.width,
        degrees.to_radians(),
    )
}

fn table(free: &[Peel], held: &[Vec<Peel>; STRENGTHS.len()]) -> Table {
    let mut table = Table::new(&[
        "series",
        "angle_deg",
        "strength_GPa",
        "force_nN",
        "error_nN",
        "displacement_nm",
        "free_end_nm",
        "sliding_length_nm",
        "kendall_nN",
        "end",
    ]);
    let mut push = |series: &str, strength: Option<f64>, peels: &[Peel]| {
        for (angle, peel) in ANGLES.into_iter().zip(peels) {
            let peak = peel.initiation_peak;
            let sliding = peel.sliding_at_peak();
            let numbers = [
                Some(angle),
                strength,
                first_peak(peel),
                peak.map(|p| p.force_error),
                peak.map(|p| p.displacement).or_else(|| Some(peel.largest_computed_force?.displacement)),
                sliding.as_ref().map(|s| s.free_end),
                sliding.as_ref().map(|s| s.sliding),
                Some(kendall(angle)),
            ];
            table.push(&[series], &numbers, &[end_word(&peel.end)]);
        }
    };
    push("without friction", None, free);
    for ((strength, ..), peels) in STRENGTHS.iter().zip(held) {
        push("with friction", Some(*strength), peels);
    }
    table
}
