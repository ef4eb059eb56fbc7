//! The picture of a sweep of pulls at a rate: the largest force and what is dissipated up to it, against the varied value; or maps over two.

use super::sweep_row::RateRow;
use crate::chart::{Axis, Frame, Line, Panel, Picture, Stroke, WIDTH, colour, save};
use crate::error::ReportError;
use crate::pictures::{axis_of, check_axis, dotted, draw_maps, panel};
use crate::swept_keys::SweptKeys;
use std::path::{Path, PathBuf};

/// What is drawn, with its label.
type Quantity = (&'static str, fn(&RateRow) -> Option<f64>);

const FORCE: Quantity = ("largest force P (nN)", |row| row.finished().map(|found| found.largest_force));
const DISSIPATED: Quantity = ("dissipated up to it (aJ)", |row| row.finished().map(|found| found.dissipated));

/// Draws `sweep.svg` and `sweep.png` into `dir`: of one key the largest force and what is dissipated up to it against its values, of two keys maps of
/// both, on logarithmic axes where `log` is set.
///
/// Fails where no pull was followed to its end, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be written
/// ([`ReportError::Write`]).
pub fn draw_swept_rates(
    dir: &Path,
    keys: SweptKeys,
    rows: &[RateRow],
    title: &str,
    log: [bool; 2],
) -> Result<Vec<PathBuf>, ReportError> {
    if keys.second.is_some() {
        let places: Vec<_> = rows.iter().map(|row| (row.value, row.second)).collect();
        let quantities = [FORCE, DISSIPATED].map(|(label, of)| (label, rows.iter().map(of).collect()));
        return draw_maps(&places, &quantities, keys, title, log, dir);
    }
    let key = keys.first.path();
    let refuse = |reason: String| ReportError::Draw { path: dir.join("sweep.svg"), reason };
    check_axis(rows.iter().map(|row| row.value), &key, log[0]).map_err(refuse)?;
    if rows.iter().all(|row| row.finished().is_none()) {
        return Err(refuse(format!("none of the {} values of {key} was pulled to its end", rows.len())));
    }
    save(&picture(rows, &key, title, log[0]), dir, "sweep")
}

fn picture(rows: &[RateRow], key: &str, title: &str, log: bool) -> Picture {
    let (label, scale) = axis_of(key);
    let x = Axis::around(&label, rows.iter().map(|row| scale * row.value), log);
    let mut panels: Vec<Panel> = Vec::new();
    for ((label, of), colour, height) in [(FORCE, colour::BLUE, 280.0), (DISSIPATED, colour::VERMILLION, 180.0)] {
        let top = panels.last().map_or(40.0, |above| above.frame.bottom + 66.0);
        let frame = Frame { left: 88.0, top, right: f64::from(WIDTH) - 18.0, bottom: top + height };
        panels.push(dotted(panel(frame, &x, label, lines(rows, scale, of, Stroke::solid(colour, 2.0)))));
    }
    let height = panels.last().map_or(0.0, |panel| panel.frame.bottom) + 54.0;
    Picture { title: title.into(), height: height as u32, panels }
}

/// The values that exist, as lines that break where one is missing.
fn lines(rows: &[RateRow], scale: f64, of: fn(&RateRow) -> Option<f64>, stroke: Stroke) -> Vec<Line> {
    let points: Vec<Option<(f64, f64)>> = rows
        .iter()
        .map(|row| of(row).filter(|value| value.is_finite()).map(|value| (scale * row.value, value)))
        .collect();
    let pieces = points.split(Option::is_none).filter(|piece| !piece.is_empty());
    pieces.map(|piece| Line::plain(piece.iter().flatten().copied().collect(), stroke)).collect()
}
