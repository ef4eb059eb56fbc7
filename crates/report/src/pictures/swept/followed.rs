//! The picture of a sweep that followed one point: its force, or its displacement, against the varied value.

use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::Line;
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::pictures::sweep::{axis_of, broken, check_axis, dotted, panel};
use crate::writing::error::ReportError;
use peelkit::study::{FollowedPoint, FollowedRow, FollowedSweep, PointKind};
use std::path::{Path, PathBuf};

/// Draws `sweep.svg` and `sweep.png` into `dir`: the force at the initiation peak, or displacement and work at the
/// snap-off, against the values of `key`, on a logarithmic axis where `log` is set.
///
/// Fails where no value has the point, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be
/// written ([`ReportError::Write`]).
pub fn draw_followed<'h>(
    sweep: &FollowedSweep,
    key: &str,
    heading: impl Into<Heading<'h>>,
    log: bool,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let refuse = |reason: String| ReportError::Draw { path: dir.join("sweep.svg"), reason };
    check_axis(sweep.rows.iter().map(|row| row.value), key, log).map_err(refuse)?;
    if sweep.rows.iter().all(|row| row.point.is_none()) {
        let (count, point) = (sweep.rows.len(), sweep.kind.word());
        return Err(refuse(format!("none of the {count} values of {key} has the {point}")));
    }
    let Heading { title, units } = heading.into();
    save(&picture(sweep, key, title, log).in_units(units), dir, "sweep")
}

fn picture(sweep: &FollowedSweep, key: &str, title: &str, log: bool) -> Picture {
    let (label, scale) = axis_of(key);
    let rows: Vec<FollowedRow> =
        sweep.rows.iter().map(|row| FollowedRow { value: scale * row.value, ..*row }).collect();
    let x = Axis::around(&label, rows.iter().map(|row| row.value), log);
    let (left, right) = (88.0, f64::from(WIDTH) - 18.0);
    let upper = Frame { left, top: 40.0, right, bottom: 330.0 };
    let lower = Frame { left, top: 400.0, right, bottom: 620.0 };
    let mut panels = Vec::new();
    match sweep.kind {
        PointKind::InitiationPeak => {
            let lines = lines(&rows, |at| Some(at.force), Stroke::solid(colour::BLUE, 2.0));
            panels.push(dotted(panel(upper, &x, "initiation peak P (nN)", lines)));
        }
        PointKind::SnapOff => {
            let places = lines(&rows, |at| Some(at.displacement), Stroke::solid(colour::BLUE, 2.0));
            panels.push(dotted(panel(upper, &x, "displacement at snap-off u (nm)", places)));
            let works = lines(&rows, |at| at.work, Stroke::solid(colour::GREEN, 2.0));
            if !works.is_empty() {
                panels.push(dotted(panel(lower, &x, "work to snap-off W (aJ)", works)));
            }
        }
    }
    let height = panels.last().map_or(0.0, |panel| panel.frame.bottom) + 54.0;
    Picture { title: title.into(), height: height as u32, panels }
}

/// The values that exist, as lines that break where one is missing.
fn lines(rows: &[FollowedRow], value: impl Fn(&FollowedPoint) -> Option<f64>, stroke: Stroke) -> Vec<Line> {
    broken(rows.iter().map(|row| Some((row.value, row.point.as_ref().and_then(&value)?))), stroke)
}
