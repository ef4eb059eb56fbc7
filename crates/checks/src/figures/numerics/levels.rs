//! What each step of coarse-graining buys: time against error of one force, from atoms to the line load.

use crate::figures::figure::{Figure, Table};
use crate::suite::reference;
use peelkit::adhesion::{Faces, HalfSpace, Level, Rule, TiltedBlock};
use peelkit_report::ReportError;
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{Axis, Frame, Line, Mark, Note, Picture, Stroke, Symbol, WIDTH, colour, significant};
use std::hint::black_box;
use std::num::NonZeroUsize;
use std::path::Path;
use std::time::{Duration, Instant};

/// A piece of strip of 10 nm by 10 nm at 20 degrees, its lowest corner 0.4 nm above the substrate.
const DEGREES: f64 = 20.0;
const PIECE: TiltedBlock = TiltedBlock {
    half_space: HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 },
    length: 10.0,
    height: 10.0,
    tilt: DEGREES * std::f64::consts::PI / 180.0,
    gap: 0.4,
};

/// Atoms beyond this distance count as a continuum, nm.
const CUTOFF: f64 = 4.0;
/// Errors below this are those of the reference and are not drawn.
const FLOOR: f64 = 3e-13;

/// One level at several resolutions.
struct Series {
    name: &'static str,
    stroke: Stroke,
    points: Vec<Measured>,
}

/// A resolution (Gauss points along an edge, or spacing in nm), its time and its relative errors.
struct Measured {
    resolution: f64,
    nanoseconds: f64,
    force_error: f64,
    moment_error: f64,
}

pub(in crate::figures) fn figure(dir: &Path) -> Result<Figure, ReportError> {
    let series = measure();
    let mut table = Table::new(&["level", "resolution", "time_ns", "force_error", "moment_error"]);
    for Series { name, points, .. } in &series {
        for p in points {
            let numbers = [p.resolution, p.nanoseconds.round(), p.force_error, p.moment_error];
            table.push(&[name], &numbers.map(Some), &[]);
        }
    }
    let caption = format!(
        "Force on a piece of strip (10 nm by 10 nm, tilted by {DEGREES} degrees, its lowest corner {} nm above a flat \
         half space, A_H = 1e-19 J, r0 = 0.4 nm) at every level of coarse-graining: time of one evaluation on one core \
         against the error relative to `verification/pieces.csv`. A mark is a resolution: the spacing of the atoms (1 to \
         0.1 nm; A_H is kept), or the Gauss points along an edge (2 to 48). Volumes: eq. (7) by 6³ points for every \
         point of the piece, in coordinates in which that is exact. Dashed: as the paper proposes it, without the faces \
         that look away; the remaining error is that of the model. Atoms beyond {CUTOFF} nm count as a continuum. \
         Times are of the machine that drew the figure.",
        PIECE.gap
    );
    Figure::write(dir, "cost-against-error", caption, &picture(&series), &table)
}

fn measure() -> Vec<Series> {
    let many = [2, 3, 4, 6, 8, 12, 16, 24, 32, 48];
    let by_points = |name, stroke, counts: &[usize], level: &dyn Fn(Rule) -> Level| Series {
        name,
        stroke,
        points: counts.iter().map(|&n| measured(n as f64, &level(rule(n)))).collect(),
    };
    let rays = rule(6);
    let atoms = [1.0, 0.5, 0.4, 0.2, 0.1].map(|spacing| measured(spacing, &Level::Atoms { spacing, cutoff: CUTOFF }));
    vec![
        Series { name: "atoms, eq. (2)", stroke: line(colour::INK), points: atoms.into() },
        by_points("volumes, eq. (7)", line(colour::ORANGE), &many, &|rule| Level::Volumes { rule, rays: rays.clone() }),
        by_points("body force, eq. (9)", line(colour::GREEN), &many, &|rule| Level::BodyForce { rule }),
        by_points("surface traction, eq. (10)", line(colour::VERMILLION), &many, &|rule| Level::SurfaceTraction {
            rule,
            faces: Faces::All,
        }),
        by_points("near faces only", dashed(colour::VERMILLION), &many, &|rule| Level::SurfaceTraction {
            rule,
            faces: Faces::Near,
        }),
        by_points("line load, eqs. (17)-(22)", line(colour::BLUE), &many, &|rule| Level::LineLoad {
            rule,
            far_face: true,
        }),
        by_points("near face only", dashed(colour::BLUE), &many, &|rule| Level::LineLoad { rule, far_face: false }),
    ]
}

fn rule(points: usize) -> Rule {
    Rule::new(NonZeroUsize::new(points).unwrap_or(NonZeroUsize::MIN))
}

fn line(colour: RGBColor) -> Stroke {
    Stroke::solid(colour, 2.0)
}

fn dashed(colour: RGBColor) -> Stroke {
    Stroke::dashed(colour, 1.6)
}

fn measured(resolution: f64, level: &Level) -> Measured {
    let at = PIECE.resultant(level);
    let (force, moment) = truth();
    Measured {
        resolution,
        nanoseconds: time(level),
        force_error: (at.force / force - 1.0).abs(),
        moment_error: (at.moment / moment - 1.0).abs(),
    }
}

/// Force and moment of the independent table; NaN where it has no such row.
fn truth() -> (f64, f64) {
    let rows = reference::read(include_str!("../../../verification/pieces.csv"));
    let row = rows
        .iter()
        .find(|row| row.number("tilt_deg") == Some(DEGREES) && row.number("corner_gap_nm") == Some(PIECE.gap));
    let number = |column| row.and_then(|row| row.number(column)).unwrap_or(f64::NAN);
    (number("force"), number("moment"))
}

/// Time of one evaluation, ns: the best of five batches of at least a millisecond each, of three where a single evaluation takes
/// a tenth of a second.
fn time(level: &Level) -> f64 {
    let once = |count: u32| {
        let start = Instant::now();
        (0..count).for_each(|_| {
            black_box(black_box(&PIECE).resultant(black_box(level)));
        });
        start.elapsed()
    };
    let first = once(1);
    let batches = if first > Duration::from_millis(100) { 3 } else { 5 };
    let count = (1_000_000 / first.as_nanos().max(10) + 1) as u32;
    (0..batches).map(|_| once(count).as_nanos() as f64 / f64::from(count)).fold(f64::INFINITY, f64::min)
}

fn picture(series: &[Series]) -> Picture {
    let times = series.iter().flat_map(|s| s.points.iter().map(|p| p.nanoseconds));
    let x = Axis::around("time of one evaluation, ns", times, true);
    let y = Axis::log("relative error of the force", 1e-13, 3.0);
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 500.0 };
    let mut panel = peelkit_report::chart::Panel::new(frame, x, y);
    for Series { name, stroke, points } in series {
        let end = points.iter().position(|p| p.force_error < FLOOR).map_or(points.len(), |first| first + 1);
        let places = points[..end].iter().map(|p| (p.nanoseconds, p.force_error.max(FLOOR)));
        let points: Vec<_> = places.collect();
        panel.marks.extend(points.iter().map(|&at| Mark::dot(at, stroke.colour)));
        panel.lines.push(Line { points, stroke: *stroke, name: Some((*name).into()) });
    }
    let atoms = series.first().into_iter().flat_map(|s| &s.points);
    panel.marks.extend(atoms.filter(|p| [0.4, 0.1].contains(&p.resolution)).map(|p| Mark {
        at: (p.nanoseconds, p.force_error),
        symbol: Symbol::None,
        colour: colour::INK,
        name: None,
        note: Some(Note { badge: None, text: vec![format!("{} nm apart", significant(p.resolution, 1))] }),
    }));
    Picture { title: "Cost against error, from atoms to the line load".into(), height: 554, panels: vec![panel] }
}
