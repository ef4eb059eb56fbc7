//! Force of a tape whose adhesive resists its opening, against the speed at which it is peeled, with steady states computed without finite elements.

use crate::figures::figure::{Figure, Table};
use crate::suite::reference::{self, Row};
use peelkit::adhesion::{Attraction, CohesiveShape, OpeningRate};
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, MovingMaterial, PeelModel, Strip};
use peelkit::study::{PullRate, TimeAccuracy, Until, pull_in_time};
use peelkit_report::ReportError;
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, RGBColor, Stroke, Symbol, WIDTH, colour};
use rayon::prelude::*;
use std::path::Path;

const POINTS: &str = include_str!("../../verification/opening_rate.csv");
/// Exponents, and how they are drawn.
const EXPONENTS: [(f64, RGBColor, &str); 3] =
    [(1.0, colour::VERMILLION, "n = 1"), (0.4, colour::BLUE, "n = 0.4"), (0.2, colour::GREEN, "n = 0.2")];
/// Speeds of a curve, from the least on, m/s: two a decade.
const SPEEDS: usize = 11;
const LEAST: f64 = 1e-6;
/// The steepest curve ends here, where its force is beyond what a tape bears.
const LAST_OF_DASHPOT: usize = 6;
const V0: f64 = 1e-5;
/// Strip, nm, and where it is taken as steady: between these displacements.
const STRIP: [f64; 3] = [6e6, 5e4, 25e6];
const STEADY: [f64; 2] = [2e6, 2.9e6];
const NEWTON: f64 = 1e-9;

fn tape() -> PeelModel {
    let [length, height, width] = STRIP;
    let strip = Strip { length, height, width, material: Material::of(2.0, 0.35), crack: None, layers: None };
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        work: Some(100.0),
        strength: Some(5e-4),
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap_or(law.equilibrium_distance);
    PeelModel::of(Body::Strip(strip), Adhesion { equilibrium_distance, ..law }, Grip::FREE)
}

/// Mean force of the steady part, N; none where the pull was not followed to its end.
fn steady_force(speed: f64, exponent: f64) -> Option<f64> {
    let material =
        MovingMaterial { opening: Some(OpeningRate { reference: V0, exponent }), ..MovingMaterial::default() };
    let pull = PullRate { until: Until::Held(0.0), ..PullRate::new(STEADY[1] + 1e5, speed) };
    let accuracy = TimeAccuracy { tolerance: 1e-5, ..TimeAccuracy::default() };
    let pulled = pull_in_time(&tape(), &material, &pull, &accuracy, None).ok()?;
    let [from, to] = STEADY.map(|place| pulled.points.iter().find(|point| point.displacement >= place));
    let (from, to) = (from?, to?);
    Some(NEWTON * (to.balance.work - from.balance.work) / (to.displacement - from.displacement))
}

/// Exponent, speed (m/s), force.
type Computed = Vec<(f64, f64, Option<f64>)>;

fn computed() -> Computed {
    let speed = |k: usize| LEAST * 10f64.powf(0.5 * k as f64);
    let of = |exponent: f64| 0..if exponent == 1.0 { LAST_OF_DASHPOT } else { SPEEDS };
    let cases: Vec<(f64, f64)> =
        EXPONENTS.iter().flat_map(|&(exponent, ..)| of(exponent).map(move |k| (exponent, speed(k)))).collect();
    cases.into_par_iter().map(|(exponent, speed)| (exponent, speed, steady_force(speed, exponent))).collect()
}

/// The independent steady states of this tape: exponent, speed (m/s), force (N).
fn independent(rows: &[Row]) -> Vec<(f64, f64, f64)> {
    let of = |row: &Row| {
        let number = |column| row.number(column);
        let same = number("height_um")? == 50.0 && number("strength_MPa")? == 0.5;
        let speed = 1e-6 * number("velocity_um_per_s")?;
        (same && speed > 0.0).then_some((number("exponent")?, speed, number("force_N")?))
    };
    rows.iter().filter_map(of).collect()
}

pub(super) fn figure(dir: &Path) -> Result<Figure, ReportError> {
    let (computed, independent) = (computed(), independent(&reference::read(POINTS)));
    let caption = "Steady force of a tape peeled straight up (50 µm, 2 GPa, 25 mm wide, 100 J/m² and 0.5 MPa at rest, exponential law) against the speed of the \
                   grip. Its adhesive resists its opening: the traction is (1 + rate of opening/10 µm/s)ⁿ as large. The mean over u = 2 to 2.9 mm. Black dots: \
                   steady states in the frame of the front, computed by `verification/opening_rate.py` without finite elements. Dotted: at rest.";
    let at_rest = NEWTON * 100.0 * STRIP[2];
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 400.0 };
    let mut panel =
        Panel::new(frame, Axis::log("speed of the grip (m/s)", LEAST, 1e-1), Axis::log("steady force P (N)", 1.0, 1e3));
    for (exponent, colour, name) in EXPONENTS {
        let own = computed.iter().filter(|case| case.0 == exponent);
        let points = own.filter_map(|&(_, speed, force)| Some((speed, force?))).collect();
        panel.lines.push(Line { points, stroke: Stroke::solid(colour, 2.0), name: Some(name.into()) });
    }
    let rest = vec![(LEAST, at_rest), (1e-1, at_rest)];
    panel.lines.push(Line { points: rest, stroke: Stroke::dotted(colour::GREY, 2.0), name: Some("at rest".into()) });
    panel.marks.extend(independent.iter().map(|&(_, speed, force)| Mark {
        at: (speed, force),
        symbol: Symbol::Dot,
        colour: colour::INK,
        name: Some("solve_bvp".into()),
        note: None,
    }));
    let picture =
        Picture { title: "A tape whose adhesive resists its opening".into(), height: 454, panels: vec![panel] };
    let mut table = Table::new(&["exponent", "speed_m_per_s", "force_N", "solve_bvp_N"]);
    for (exponent, speed, force) in &computed {
        let at = |known: &&(f64, f64, f64)| known.0 == *exponent && (known.1 / speed - 1.0).abs() < 1e-9;
        let known = independent.iter().find(at).map(|known| known.2);
        table.push(&[], &[Some(*exponent), Some(*speed), *force, known], &[]);
    }
    Figure::write(dir, "opening-rate", caption.to_owned(), &picture, &table)
}
