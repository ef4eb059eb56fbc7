//! By which power of each parameter the results of a peel change, as bars.

use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::{Line, Panel, Shape};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::writing::error::ReportError;
use peelkit::study::{Exponent, PeelQuantity};
use std::path::{Path, PathBuf};

/// Most bars of a panel: the largest.
const MOST: usize = 10;
/// Height of a bar and of the room for it, pixels.
const ROW: f64 = 21.0;
/// Half of a bar, over the room for it.
const HALF: f64 = 0.32;
/// Above and below the bars of a panel, pixels.
const ABOVE: f64 = 46.0;
const BELOW: f64 = 52.0;
/// Room for the names on the left, pixels.
const NAMES: f64 = 260.0;

/// What has a panel, with its title, where the path has it; one that agrees with the one before it in every bar says nothing new.
const SHOWN: [(PeelQuantity, &str); 5] = [
    (PeelQuantity::InitiationPeakForce, "force of the initiation peak"),
    (PeelQuantity::PeakForce, "peak force"),
    (PeelQuantity::FirstJumpDisplacement, "displacement of the first jump"),
    (PeelQuantity::FirstJumpWork, "work up to the first jump"),
    (PeelQuantity::DetachmentWork, "work up to detachment"),
];

/// Draws `sensitivities.svg` and `sensitivities.png` into `dir`: d ln Q/d ln p of the peak forces and of first jump and detachment, by the parameters with
/// these keys, largest first.
///
/// Fails with [`ReportError::Draw`] where there is none of them, and where a file cannot be written.
pub fn draw_sensitivities<'h>(
    exponents: &[Exponent],
    keys: &[String],
    heading: impl Into<Heading<'h>>,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let mut panels: Vec<Panel> = Vec::new();
    let mut known: Vec<Vec<(&str, f64)>> = Vec::new();
    let mut top = 12.0;
    for (of, name) in SHOWN {
        let rows = exponents.iter().filter(|exponent| exponent.of == of).take(MOST);
        let rows: Vec<(&str, f64)> = rows.map(|exponent| (keys[exponent.variation].as_str(), exponent.value)).collect();
        if rows.is_empty() || known.contains(&rows) {
            continue;
        }
        let bottom = top + ABOVE + ROW * rows.len() as f64;
        let frame = Frame { left: NAMES, top: top + ABOVE, right: f64::from(WIDTH) - 18.0, bottom };
        panels.push(Panel { title: name.to_owned(), ..bars(frame, "d ln Q / d ln p", &rows) });
        known.push(rows);
        top = bottom + BELOW;
    }
    if panels.is_empty() {
        let reason = "the path has no result that can be differentiated".to_owned();
        return Err(ReportError::Draw { path: dir.join("sensitivities.svg"), reason });
    }
    save(&Picture { title: heading.into().title.into(), height: top as u32, panels }, dir, "sensitivities")
}

/// Named bars from zero, the first at the top: those to the right in blue, those to the left in vermillion.
pub fn bars(frame: Frame, label: &str, rows: &[(&str, f64)]) -> Panel {
    let (low, high) = rows.iter().fold((0.0f64, 0.0f64), |(low, high), row| (low.min(row.1), high.max(row.1)));
    let margin = 0.05 * (high - low).max(f64::MIN_POSITIVE);
    let ends = (if low < 0.0 { low - margin } else { 0.0 }, if high > 0.0 { high + margin } else { 0.0 });
    let x = Axis::linear(label, ends.0, if ends.1 > ends.0 { ends.1 } else { 1.0 });
    let y = Axis::of_names(rows.iter().rev().map(|row| row.0.to_owned()).collect());
    let bar = |(k, row): (usize, &(&str, f64))| {
        let (low, high) = (k as f64 - HALF, k as f64 + HALF);
        Shape {
            corners: vec![(0.0, low), (row.1, low), (row.1, high), (0.0, high)],
            colour: if row.1 < 0.0 { colour::VERMILLION } else { colour::BLUE },
            opacity: 0.85,
        }
    };
    let zero = vec![(0.0, -0.5), (0.0, rows.len() as f64 - 0.5)];
    let zero = Line { points: zero, stroke: Stroke::solid(colour::INK, 1.0), name: None };
    Panel { shapes: rows.iter().rev().enumerate().map(bar).collect(), lines: vec![zero], ..Panel::new(frame, x, y) }
}
