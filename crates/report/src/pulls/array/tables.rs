//! The tables of the pull of an array: curve.csv, events.csv and rows.csv.

use crate::writing::error::ReportError;
use crate::writing::record::{Cell, Fields, Record, columns_of, write_table};
use crate::writing::reference::Output;
use peelkit::toe::{ArrayEvent, ArrayPull, ArrayRow};
use std::path::{Path, PathBuf};

/// A point of the curve under a lift that only grows.
struct CurvePoint {
    lift: f64,
    load: f64,
}

/// An event with its number, from 1 on.
struct Numbered<'a>(usize, &'a ArrayEvent);

/// A row with its number, from 1 on.
struct RowAtPeak<'a>(usize, &'a ArrayRow);

impl Record for CurvePoint {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("lift", "nm, of a moment rad: it only grows, and each jump has two rows, before and behind it", |at| at.lift);
        of.field("load", "nN, of a moment nN nm", |at| at.load);
    }
}

impl Record for Numbered<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("event", "its number, from 1 on", |at| at.0);
        of.field("row", "row of the first seta, from 1 on", |at| at.1.row + 1);
        of.field("setae", "how many change their sheet", |at| at.1.setae.len());
        of.field("first_seta", "number of the first of them, from 1 on: in its row, of a patch in the whole patch", |at| at.1.setae.first().map(|seta| seta + 1));
        of.field("from_sheet", "sheet that they leave; 0 while all of a seta adheres", |at| at.1.sheets[0]);
        of.field("to_sheet", "sheet that they reach; the last one is the detached one", |at| at.1.sheets[1]);
        of.field("lift", "nm, of a moment rad", |at| at.1.lift);
        of.field("load", "before it; nN, of a moment nN nm", |at| at.1.load);
        of.field("load_after", "after it at the same lift", |at| at.1.load_after);
        of.field("released_aJ", "energy that it releases", |at| at.1.released);
        of.field("work_aJ", "work of the load up to it", |at| at.1.work);
        of.field("adhering", "setae that adhere after it", |at| at.1.adhering);
        of.field("starts_jump", "whether it comes at a lift above all before", |at| at.1.starts_jump);
    }
}

impl Record for RowAtPeak<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("row", "its number, from 1 on", |at| at.0);
        of.field("adhering", "setae of it that adhere just before the peak", |at| at.1.adhering);
        of.field("shear_nN", "force of the row along the ground; 0 of a patch", |at| at.1.force[0]);
        of.field("normal_nN", "force of the row off the ground", |at| at.1.force[1]);
    }
}

/// The curve under a lift that only grows, each jump with its two ends.
pub(super) fn curve(pull: &ArrayPull) -> Vec<(f64, f64)> {
    let mut out = vec![(0.0, 0.0)];
    let mut behind = 0.0;
    for event in &pull.events {
        if event.starts_jump {
            if out.len() > 1 {
                let last = out[out.len() - 1].0;
                out.push((last, behind));
            } else if event.load < 0.0 {
                // a patch that is pressed first starts below the ground
                out.clear();
            }
            out.push((event.lift, event.load));
        }
        behind = event.load_after;
    }
    if let Some(&(last, _)) = out.last().filter(|_| !pull.events.is_empty()) {
        out.push((last, behind));
    }
    out
}

/// Writes curve.csv, events.csv, and rows.csv, the rows at the peak.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_array_tables(dir: &Path, pull: &ArrayPull) -> Result<Vec<PathBuf>, ReportError> {
    let points: Vec<CurvePoint> = curve(pull).into_iter().map(|(lift, load)| CurvePoint { lift, load }).collect();
    let events: Vec<Numbered> = pull.events.iter().enumerate().map(|(k, event)| Numbered(k + 1, event)).collect();
    let rows: Vec<RowAtPeak> = pull.rows.iter().enumerate().map(|(k, row)| RowAtPeak(k + 1, row)).collect();
    Ok(vec![
        write_table(dir, "curve.csv", points.iter())?,
        write_table(dir, "events.csv", events.iter())?,
        write_table(dir, "rows.csv", rows.iter())?,
    ])
}

/// The columns of curve.csv, events.csv and rows.csv, each with its cells.
pub fn array_columns(pull: &ArrayPull) -> [Vec<(String, Vec<Cell>)>; 3] {
    let points: Vec<CurvePoint> = curve(pull).into_iter().map(|(lift, load)| CurvePoint { lift, load }).collect();
    let events: Vec<Numbered> = pull.events.iter().enumerate().map(|(k, event)| Numbered(k + 1, event)).collect();
    let rows: Vec<RowAtPeak> = pull.rows.iter().enumerate().map(|(k, row)| RowAtPeak(k + 1, row)).collect();
    [columns_of(points.iter()), columns_of(events.iter()), columns_of(rows.iter())]
}

pub(super) fn outputs() -> Vec<Output> {
    vec![
        Output::table("curve.csv of an array", CurvePoint::keys()),
        Output::table("events.csv of an array", Numbered::keys()),
        Output::table("rows.csv of an array", RowAtPeak::keys()),
    ]
}
