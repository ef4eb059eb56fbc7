//! The picture of a sweep of pulls: one panel a quantity, against the varied value; or maps over two.

use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::Panel;
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::WIDTH;
use crate::pictures::sweep::{axis_of, broken, check_axis, dotted, panel};
use crate::pictures::swept::plane::draw_maps;
use crate::swept::PullRow;
use crate::swept::SweptKeys;
use crate::writing::error::ReportError;
use plotters::style::RGBColor;
use std::path::{Path, PathBuf};

/// A quantity of a pull.
pub(crate) struct Quantity<F> {
    /// The title of its axis.
    pub label: &'static str,
    /// Of a row; `None` where it has none.
    pub of: fn(&PullRow<F>) -> Option<f64>,
    pub colour: RGBColor,
    /// Of its panel.
    pub height: f64,
    /// Whether it has a map where two keys are varied.
    pub has_map: bool,
}

/// Draws `sweep.svg` and `sweep.png` into `dir`: of one key these quantities against its values, of two keys maps, on logarithmic axes where `log` is
/// set.
///
/// Fails where no row has the first quantity, as `none` says, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be
/// written ([`ReportError::Write`]).
pub(crate) fn draw_swept_pulls<F>(
    dir: &Path,
    keys: SweptKeys,
    rows: &[PullRow<F>],
    (quantities, none): (&[Quantity<F>], &str),
    heading: Heading,
    log: [bool; 2],
) -> Result<Vec<PathBuf>, ReportError> {
    if keys.second.is_some() {
        let places: Vec<_> = rows.iter().map(|row| (row.value, row.second)).collect();
        let mapped = quantities.iter().filter(|own| own.has_map);
        let maps: Vec<_> = mapped.map(|own| (own.label, rows.iter().map(own.of).collect())).collect();
        return draw_maps(&places, &maps, keys, heading, log, dir);
    }
    let key = keys.first.path();
    let refuse = |reason: String| ReportError::Draw { path: dir.join("sweep.svg"), reason };
    check_axis(rows.iter().map(|row| row.value), &key, log[0]).map_err(refuse)?;
    if quantities.first().is_none_or(|first| rows.iter().all(|row| (first.of)(row).is_none())) {
        return Err(refuse(format!("none of the {} values of {key} {none}", rows.len())));
    }
    save(&picture(rows, quantities, &key, heading.title, log[0]).in_units(heading.units), dir, "sweep")
}

fn picture<F>(rows: &[PullRow<F>], quantities: &[Quantity<F>], key: &str, title: &str, log: bool) -> Picture {
    let (label, scale) = axis_of(key);
    let x = Axis::around(&label, rows.iter().map(|row| scale * row.value), log);
    let mut panels: Vec<Panel> = Vec::new();
    for &Quantity { label, of, colour, height, .. } in quantities {
        let point = |row| of(row).filter(|value| value.is_finite()).map(|value| (scale * row.value, value));
        let lines = broken(rows.iter().map(point), Stroke::solid(colour, 2.0));
        if lines.is_empty() {
            continue;
        }
        let top = panels.last().map_or(40.0, |above| above.frame.bottom + 66.0);
        let frame = Frame { left: 88.0, top, right: f64::from(WIDTH) - 18.0, bottom: top + height };
        panels.push(dotted(panel(frame, &x, label, lines)));
    }
    let height = panels.last().map_or(0.0, |panel| panel.frame.bottom) + 54.0;
    Picture { title: title.into(), height: height as u32, panels }
}
