//! The picture of a pull at a rate: force against displacement with the equilibria beside it, below it where the work goes, and of a seta how many
//! tips adhere.

use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::marked::{Marked, mark_found};
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::records::passed::PassedAt;
use crate::records::pulled::{Equilibria, PointAtRate, PulledAtRate};
use crate::writing::error::ReportError;
use std::path::{Path, PathBuf};

/// Heights of the panels, where the first one begins, and what is between them, pixels.
const TOP: f64 = 40.0;
const FORCE: f64 = 280.0;
const BETWEEN: f64 = 24.0;
const ENERGIES: f64 = 170.0;
const TIPS: f64 = 110.0;
/// How far the equilibria are shown, over the way of the pull.
const SHOWN: f64 = 1.1;

/// Draws `curve` into `dir`, as SVG and PNG.
///
/// Fails where there are fewer than two points ([`ReportError::Draw`]), or a file cannot be written ([`ReportError::Write`]).
pub fn draw_rate<'h>(
    dir: &Path,
    (pulled, passed): (&PulledAtRate, &[PassedAt]),
    equilibria: &Equilibria,
    heading: impl Into<Heading<'h>>,
) -> Result<Vec<PathBuf>, ReportError> {
    if pulled.points.len() < 2 {
        let reason = format!("the pull at a rate has {} points", pulled.points.len());
        return Err(ReportError::Draw { path: dir.join("curve.svg"), reason });
    }
    let mut picture = picture(pulled, equilibria, heading.into());
    let marked: Vec<Marked> = passed.iter().map(PassedAt::marked).collect();
    mark_found(&mut picture.panels[..1], &marked);
    save(&picture, dir, "curve")
}

fn picture(pulled: &PulledAtRate, equilibria: &Equilibria, Heading { title, units }: Heading) -> Picture {
    let of = |value: &dyn Fn(&PointAtRate) -> f64| -> Vec<(f64, f64)> {
        pulled.points.iter().map(|point| (point.displacement, value(point))).collect()
    };
    let way = pulled.way();
    let slow: Vec<(f64, f64)> = equilibria.points.iter().copied().take_while(|at| at.0 <= SHOWN * way).collect();
    let forces = of(&|point| point.force);
    let (left, right) = (84.0, f64::from(WIDTH) - 18.0);
    let first = Frame { left, top: TOP, right, bottom: TOP + FORCE };
    let below = |above: &Frame, height: f64| {
        let top = above.bottom + BETWEEN;
        Frame { left, top, right, bottom: top + height }
    };
    let second = below(&first, ENERGIES);
    let x = |label: &str| Axis::around(label, forces.iter().chain(&slow).map(|at| at.0), false);
    let y = Axis::around("force P (nN)", forces.iter().chain(&slow).map(|at| at.1).chain([0.0]), false).in_units(units);
    let mut force = Panel::of_lines(
        first,
        x("(nm)"),
        y,
        vec![
            Line::named("equilibria, stable or not", slow.clone(), Stroke::dotted(colour::INK, 1.4)),
            Line::named("at the rate", forces.clone(), Stroke::solid(colour::BLUE, 1.8)),
        ],
    );
    if let Some(peak) = pulled.peak {
        let text = force.y.text_of(peak.force, 4);
        force.marks = vec![Mark::labelled((peak.displacement, peak.force), colour::INK, &["largest force", &text])];
    }
    let start = pulled.at_rest();
    let energies = [
        ("work", colour::INK, of(&|point| point.balance.work)),
        (
            "stored and spring",
            colour::BLUE,
            of(&|point| point.balance.stored + point.balance.spring - start.stored - start.spring),
        ),
        ("adhesion", colour::GREEN, of(&|point| point.balance.adhesion - start.adhesion)),
        ("dissipated", colour::VERMILLION, of(&|point| point.balance.dissipated)),
        ("kinetic", colour::ORANGE, of(&|point| point.balance.kinetic)),
    ];
    let values = energies.iter().flat_map(|(_, _, points)| points).map(|at| at.1).chain([0.0]);
    let y = Axis::around("energy (aJ)", values, false);
    let lines = energies.into_iter().map(|(name, ink, points)| Line::named(name, points, Stroke::solid(ink, 1.6)));
    let attached: Vec<(f64, f64)> =
        pulled.points.iter().filter_map(|point| Some((point.displacement, point.attached()? as f64))).collect();
    let label = "displacement U (nm)";
    let (mut panels, bottom) = (vec![force], if attached.is_empty() { second } else { below(&second, TIPS) });
    panels.push(Panel::of_lines(second, x(if attached.is_empty() { label } else { "(nm)" }), y, lines.collect()));
    if !attached.is_empty() {
        let y = Axis::around("tips attached", attached.iter().map(|at| at.1).chain([0.0]), false);
        panels.push(Panel::of_lines(
            bottom,
            x(label),
            y,
            vec![Line::plain(attached, Stroke::solid(colour::BLUE, 1.8))],
        ));
    }
    Picture { title: title.into(), height: (bottom.bottom + 54.0) as u32, panels }.in_units(units)
}
